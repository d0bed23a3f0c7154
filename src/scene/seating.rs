//! Loss of a bearing's support: beyond a free travel, or over the front edge of its seat (`docs/physics.md#loss-of-support`).

use super::{Girder, ResolvedBearing, Scene};
use crate::geometry::End;

/// Displacements of a bearing's point that keep its support: along the direction square to the front edges of both seats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room {
    /// Unit vector square to the end edges, in the girder's axes as placed, outwards at its `+x` end.
    pub normal: [f64; 2],
    /// From where, not positive; minus infinity without an edge on that side \[m\].
    pub from: f64,
    /// To where \[m\].
    pub to: f64,
}

impl Room {
    /// Displacement `w` along the normal beyond the room, by a smooth function that is 0 at both of its ends with the slope of a length
    /// there \[m\].
    pub fn excess(&self, w: f64) -> f64 {
        let (before, beyond) = (w - self.from, self.to - w);
        // By the room's own ends: a displacement that is bounded by nothing is beyond it.
        match (self.from.is_finite(), self.to.is_finite()) {
            (true, true) => -before * beyond / (self.to - self.from),
            (true, false) => -before,
            (false, true) => -beyond,
            (false, false) => -1.0,
        }
    }

    /// Its rate where `w` changes with `rate` \[m/s\].
    pub fn excess_rate(&self, w: f64, rate: f64) -> f64 {
        match (self.from.is_finite(), self.to.is_finite()) {
            (true, true) => rate * (2.0 * w - self.from - self.to) / (self.to - self.from),
            (true, false) => -rate,
            (false, true) => rate,
            (false, false) => 0.0,
        }
    }

    /// Upper bound of its second derivative, of displacements up to `reach` \[m\], at most this speed \[m/s\] and acceleration \[m/s²\].
    pub fn excess_curvature(&self, reach: f64, speed: f64, acceleration: f64) -> f64 {
        match (self.from.is_finite(), self.to.is_finite()) {
            (true, true) => {
                let arms = 2.0 * reach + (self.from + self.to).abs();
                (2.0 * speed * speed + acceleration * arms) / (self.to - self.from)
            }
            _ => acceleration,
        }
    }
}

/// The room of a bearing of a girder; `None` where its support cannot be lost.
pub fn room(girder: &Girder, bearing: &ResolvedBearing) -> Option<Room> {
    let (sine, cosine) = girder.skew_deg.to_radians().sin_cos();
    // A straight girder's edges are square to its axis to the last bit.
    let normal = if girder.skew_deg == 90.0 { [1.0, 0.0] } else { [sine, -cosine] };
    let travel = bearing.travel.unwrap_or(f64::INFINITY);
    let mut room = Room { normal, from: -travel, to: travel };
    let along = bearing.place.x - bearing.place.y * girder.prism().shear();
    if let Some((end, seat)) = seat(girder, along) {
        let on_it = (seat - (0.5 * girder.length - along.abs())) * normal[0];
        match end {
            End::Plus => room.from = room.from.max(-on_it),
            End::Minus => room.to = room.to.min(on_it),
        }
    }
    (room.from.is_finite() || room.to.is_finite()).then_some(room)
}

/// Whether a bearing stands beyond the front edge of its seat as placed, watched or not; `None` where no seat is given.
pub fn stands_off(girder: &Girder, bearing: &ResolvedBearing) -> Option<bool> {
    let along = bearing.place.x - bearing.place.y * girder.prism().shear();
    let (_, seat) = seat_below(girder, along)?;
    Some(0.5 * girder.length - along.abs() >= seat)
}

/// Girders with bearings that stand beyond the front edge of their seats as placed, and the numbers of these bearings from 1.
pub fn all_off(scene: &Scene) -> Vec<(&str, Vec<usize>)> {
    let all = scene.girders.iter().map(|girder| (girder.name.as_str(), bearings_off(scene, girder)));
    all.filter(|(_, off)| !off.is_empty()).collect()
}

/// Numbers from 1 of the bearings of a girder that stand beyond the front edge of their seats as placed.
pub fn bearings_off(scene: &Scene, girder: &Girder) -> Vec<usize> {
    let bearings = girder.supports(scene.setting()).into_iter().enumerate();
    bearings.filter(|(_, bearing)| stands_off(girder, bearing) == Some(true)).map(|(number, _)| number + 1).collect()
}

/// Seats of the ends on a pier that are together longer than the cap.
#[derive(Clone, Debug, PartialEq)]
pub struct BeyondCap<'a> {
    /// The pier.
    pub pier: &'a str,
    /// The ends, `g1+x`.
    pub ends: Vec<String>,
    /// Their seats together, square to the ends \[m\].
    pub length: f64,
    /// The cap's side along \[m\].
    pub cap: f64,
}

/// Piers with a given cap that is shorter than the seats on it.
pub fn beyond_caps(scene: &Scene) -> Vec<BeyondCap<'_>> {
    let of = |number: usize| {
        let pier = &scene.piers[number];
        let [cap, ..] = pier.cap?;
        let ends = scene.girders.iter().flat_map(|girder| End::BOTH.map(|end| (girder, end)));
        let on = ends.filter(|(girder, end)| scene.pier_under(girder, *end) == Some(number));
        let (ends, lengths): (Vec<String>, Vec<f64>) = on
            .filter_map(|(girder, end)| {
                let square = girder.seat.length(end)? * girder.skew_deg.to_radians().sin();
                Some((format!("{}{}", girder.name, end.label()), square))
            })
            .unzip();
        let length = lengths.into_iter().sum();
        (length > cap).then_some(BeyondCap { pier: &pier.name, ends, length, cap })
    };
    (0..scene.piers.len()).filter_map(of).collect()
}

/// The seat that carries a bearing at this place along the axis from the middle, before skewing, and its length along the axis
/// \[m\]; `None` where it is not watched.
fn seat(girder: &Girder, along: f64) -> Option<(End, f64)> {
    girder.after_unseating?;
    seat_below(girder, along)
}

fn seat_below(girder: &Girder, along: f64) -> Option<(End, f64)> {
    let end = match along {
        along if along > 0.0 => End::Plus,
        along if along < 0.0 => End::Minus,
        _ => return None,
    };
    Some((end, girder.seat.length(end)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{AfterUnseating, Bearing, Bearings, Kind, STANDARD_GRAVITY, Seat, Setting};

    /// A girder of 30 m and 60° on seats of 0.85 m, on bearings 0.3 m from its ends along the axis.
    fn girder(travel: Option<f64>) -> Girder {
        let at = |x: f64, y: f64| Bearing { travel, ..Bearing::linear([x + y / 3f64.sqrt(), y], [1e6; 3], [0.0; 3]) };
        Girder {
            skew_deg: 60.0,
            seat: Seat { plus: Some(0.85), minus: Some(0.85), side: None },
            after_unseating: Some(AfterUnseating::Stop),
            bearings: Some(Bearings::Each(vec![at(14.7, 4.0), at(-14.7, 4.0), at(0.0, 0.0)])),
            ..Girder::straight("deck", [30.0, 10.0, 1.5], 6e5)
        }
    }

    fn rooms(travel: Option<f64>) -> Vec<Option<Room>> {
        let girder = girder(travel);
        let setting = Setting { kind: Kind::Planar, gravity: STANDARD_GRAVITY };
        girder.supports(setting).iter().map(|bearing| room(&girder, bearing)).collect()
    }

    #[test]
    fn a_bearing_comes_off_its_own_seat_only_or_beyond_its_travel() {
        let [plus, minus, middle] = rooms(None)[..] else { panic!("three") };
        let (plus, minus) = (plus.expect("a seat"), minus.expect("a seat"));
        let on_it = 0.55 * 60f64.to_radians().sin();
        assert!((plus.from + on_it).abs() < 1e-12 && plus.to == f64::INFINITY, "{plus:?}");
        assert!((minus.to - on_it).abs() < 1e-12 && minus.from == f64::NEG_INFINITY, "{minus:?}");
        assert_eq!(middle, None, "neither end's");
        let [plus, _, middle] = rooms(Some(0.2))[..] else { panic!("three") };
        let both = Some([-0.2, 0.2]);
        assert_eq!([plus, middle].map(|room| room.map(|room| [room.from, room.to])), [both; 2], "sooner than the seat");
    }

    #[test]
    fn the_excess_is_that_of_its_derivatives() {
        for room in [
            Room { normal: [1.0, 0.0], from: -0.3, to: 0.2 },
            Room { normal: [1.0, 0.0], from: -0.3, to: f64::INFINITY },
            Room { normal: [1.0, 0.0], from: f64::NEG_INFINITY, to: 0.2 },
        ] {
            let (step, speed, acceleration) = (1e-5, 0.7, 0.4);
            let at = |w: f64, t: f64| room.excess(w + speed * t + 0.5 * acceleration * t * t);
            for w in [-0.29, 0.0, 0.15] {
                let rate = (at(w, step) - at(w, -step)) / (2.0 * step);
                assert!((rate - room.excess_rate(w, speed)).abs() < 1e-8, "{room:?} at {w}");
                let second = (at(w, step) - 2.0 * at(w, 0.0) + at(w, -step)) / (step * step);
                assert!(second.abs() <= room.excess_curvature(w.abs(), speed, acceleration) + 1e-4, "{room:?} at {w}");
            }
            let beyond = [(room.from, f64::NEG_INFINITY), (room.to, f64::INFINITY)];
            for (_, far) in beyond.into_iter().filter(|(end, _)| end.is_finite()) {
                assert_eq!(room.excess(far), f64::INFINITY, "{room:?} is not endless");
            }
            let ends = [room.from, room.to].into_iter().filter(|end| end.is_finite());
            ends.for_each(|end| assert!(room.excess(end).abs() < 1e-15 && room.excess(0.0) < 0.0, "{room:?}"));
        }
    }
}
