//! Bounds on the motion of a body on the trajectory that a run left, segment by segment.

use std::f64::consts::PI;

use crate::contact::Frame;
use crate::dynamics::Body;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;
use crate::dynamics::trajectory::stored_path::StoredMotion;
use crate::sim::History;

/// Looks per shortest interval in which a sliding face turns round: the closed form of a slide has no bound on its speed.
const LOOKS_PER_REVERSAL: f64 = 16.0;

/// Bound on a body's motion over an interval from a given time on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bound {
    /// Time up to which the bound holds \[s\].
    pub until: f64,
    /// Speed of any corner \[m/s\].
    pub speed: f64,
    /// Acceleration of any corner \[m/s²\]; infinite where it is not known.
    pub acceleration: f64,
}

/// Bound on the speed of girder `body` from `t` on, as far as its segment reaches; `radius` is the distance of its farthest
/// corner from G \[m\].
pub(super) fn bound(history: &History, body: usize, radius: f64, t: f64) -> Bound {
    let path = history.trajectories.path(body);
    let Some(number) = path.number_at(t) else { return Bound { until: f64::INFINITY, speed: 0.0, acceleration: 0.0 } };
    let end = end_of(history, body, number);
    let own = &history.model().bodies[body];
    let step = |piece: &StepPolynomial| own.bounds(&|range| piece.derivative_bounds(range));
    let bounds = match path.motion_of(number).1 {
        StoredMotion::Step(piece) => step(piece),
        StoredMotion::Recomputed(recipe) => {
            history.trajectories.stepped(body, (recipe, path.motion_of(number).0), step)
        }
        StoredMotion::Slide(slide) => {
            let until = end.min(t + slide.sight / LOOKS_PER_REVERSAL);
            let [here, there] = [t, until].map(|t| history.frame(body, t).shift);
            let speed = (there - here).length() / (until - t).max(f64::MIN_POSITIVE);
            return Bound { until, speed, acceleration: f64::INFINITY };
        }
        StoredMotion::Start(_) | StoredMotion::Flight(_) => in_flight(history, body, number, t),
    };
    // The motion of sections of a girder that bends is not that of its G.
    let acceleration = if history.sections().flexible(body).is_some() {
        f64::INFINITY
    } else {
        bounds.acceleration + radius * bounds.acceleration_per_arm()
    };
    Bound { until: end.min(t + bounds.window), speed: bounds.speed + bounds.spin * radius, acceleration }
}

/// Speed of any corner of a rigid body at `t` \[m/s\].
pub(super) fn speed(history: &History, body: usize, radius: f64, t: f64) -> f64 {
    let frame = history.frame(body, t);
    frame.velocity.length() + frame.spin.length() * radius
}

/// Greatest displacements of a body from where it was placed, over the whole answer \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reach {
    /// Its G.
    pub place: f64,
    /// Any of its corners; infinite where no bound on its rotation is known, or where it bends.
    pub corner: f64,
}

impl Reach {
    /// From a displacement `way` of G \[m\], and the displacement by the rotation of a point at `radius` \[m\] from G, `chord` times that.
    fn of(way: f64, chord: f64, radius: f64) -> Self {
        Self { place: way, corner: way + chord * radius }
    }

    fn most(self, other: Self) -> Self {
        Self { place: self.place.max(other.place), corner: self.corner.max(other.corner) }
    }
}

/// Whether a body turns at all; one that is guided along a line does not.
pub(super) fn turns(own: &Body) -> bool {
    own.excursion(1.0, &|_| 1.0) > own.excursion(0.0, &|_| 1.0)
}

/// Greatest displacements of girder `body`, whose farthest corner is at `radius` \[m\] from G.
pub(super) fn reach(history: &History, body: usize, radius: f64) -> Reach {
    let (path, own) = (history.trajectories.path(body), &history.model().bodies[body]);
    let of_frame = |frame: &Frame| Reach::of(frame.shift.length(), frame.chord(), radius);
    let at = |t: f64| of_frame(&history.frame(body, t));
    let turns = turns(own);
    let within = |number: usize| match path.motion_of(number) {
        (from, StoredMotion::Step(piece)) => {
            let (start, way) = (at(from), |range| piece.displacement_bound(range));
            let [place, corner] = [0.0, radius].map(|arm| own.excursion(arm, &way));
            Reach { place: start.place + place, corner: start.corner + corner }
        }
        // Their ways together, below; of their rotation what is known is that at their beginnings.
        (_, StoredMotion::Recomputed(_)) if turns => Reach { place: 0.0, corner: f64::INFINITY },
        (_, StoredMotion::Recomputed(_)) => Reach::of(0.0, 0.0, radius),
        (from, StoredMotion::Slide(slide)) => {
            let (end, step) = (end_of(history, body, number), slide.sight / LOOKS_PER_REVERSAL);
            let looks = std::iter::successors(Some(from), |t| (*t < end).then(|| (t + step).max(t.next_up())));
            looks.map(|t| at(t.min(end))).fold(Reach::of(0.0, 0.0, radius), Reach::most)
        }
        (from, motion @ (StoredMotion::Start(_) | StoredMotion::Flight(_))) => {
            let end = end_of(history, body, number);
            if let StoredMotion::Flight(flight) = motion
                && !turns
                && let Some(way) = flight.displacement_bound(end)
            {
                return Reach::of(way, 0.0, radius);
            }
            let (mut t, mut reach) = (from, Reach::of(0.0, 0.0, radius));
            while t < end {
                let bounds = in_flight(history, body, number, t);
                let chord = 2.0 * (0.5 * bounds.turn.min(PI)).sin();
                reach = reach.most(Reach::of(bounds.reach, chord, radius));
                // A window may be shorter than the spacing of times.
                t = (t + bounds.window).max(t.next_up());
            }
            reach
        }
    };
    let swept = path.swept();
    let start = of_frame(&own.frame(0, &own.initial())).most(Reach::of(swept.reach, swept.chord, radius));
    let reach = (0..path.len()).map(within).fold(start, Reach::most);
    if history.sections().flexible(body).is_none() { reach } else { Reach { corner: f64::INFINITY, ..reach } }
}

/// End of segment `number` of a body's path \[s\].
fn end_of(history: &History, body: usize, number: usize) -> f64 {
    let path = history.trajectories.path(body);
    let until = path.until(number);
    if number + 1 == path.len() { history.end().max(until) } else { until }
}

/// Bounds on segment `number`, a flight, from `t` on.
fn in_flight(history: &History, body: usize, number: usize, t: f64) -> MotionBounds {
    let horizon = end_of(history, body, number) - t;
    let bounds = match history.trajectories.path(body).motion_of(number) {
        (_, StoredMotion::Flight(flight)) => Some(flight.bounds(t, horizon)),
        (from, StoredMotion::Start(start)) => {
            let flight = history.trajectories.free_motion(body).and_then(|system| system.fly(from, &start));
            flight.map(|flight| flight.bounds(t, horizon))
        }
        // Not in flight.
        _ => None,
    };
    bounds.unwrap_or(MotionBounds::still(horizon))
}
