//! Remaining seat lengths of a girder: at each corner of an end the distance to the front edge of its seat, the least of it, when and where
//! a corner comes off, and when the whole end does (`docs/seats.md`).
//!
//! Values are read off the continuous history. Extremes and zeros are searched between looks that neither bearings nor ground
//! can outrun, and every low point that may reach 0 between two looks is closed in on.

use glam::{DMat3, DVec3};

use crate::dynamics::locate::root::root;
use crate::geometry::{End, Prism};
use crate::sim::report::Extreme;
use crate::sim::seats::seat_on::SeatOn;
use crate::sim::seats::view::Seats;
use crate::sim::{History, Motion, looks, peaks};

/// Part of the range of a quantity within which a low point between looks is closed in on: between looks, 24 a period of the
/// fastest motion, a peak rises by less than a hundredth of the range.
const MINIMUM_BAND: f64 = 0.1;

/// The seat of an end as placed, fixed to the ground or to the pier under the end: a strip behind the front edge, which is parallel to the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ledge {
    /// End of the girder.
    pub end: End,
    /// Length of the seat along the axis \[m\].
    pub length: f64,
    /// sin β, 1 for a straight girder.
    pub sine: f64,
    /// Square to the front edge, from the span to the support: ν, world.
    pub normal: DVec3,
    /// Along the front edge, from the corner at −y of the girder to that at +y, world.
    pub along: DVec3,
    /// Half the length of the end along the edge \[m\].
    pub half_end: f64,
    /// By how much the seat is wider than the end at either side, along the edge; `None` where the scene does not give it \[m\].
    pub side: Option<f64>,
    /// Ground or pier that it is fixed to.
    pub on: SeatOn,
}

impl Ledge {
    /// Seat as placed, square to the edge: `seat · sin β` \[m\].
    pub fn placed(&self) -> f64 {
        self.length * self.sine
    }

    /// Remaining seat at a corner, square to the edge: `r_c = (X_c − E)·ν`; negative off it \[m\].
    pub fn remaining(&self, shift: DVec3) -> f64 {
        // By the displacement of the corner, not by its place: far from the origin the difference would round away.
        self.placed() + shift.dot(self.normal)
    }

    /// Place of a corner of the end along the edge, from the middle of the end as placed: of `Prism::end_corners` the first is at
    /// −`half_end` as placed \[m\].
    pub fn place_along(&self, which: usize, shift: DVec3) -> f64 {
        let placed = if which == 0 { -self.half_end } else { self.half_end };
        placed + shift.dot(self.along)
    }
}

/// Time and place at which a corner comes off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// Time \[s\].
    pub t: f64,
    /// Place along the edge, from the middle of the end as placed, towards the corner at +y \[m\].
    pub along: f64,
}

/// Remaining seat at a corner of an end, the least and when it was 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeatCorner {
    /// Its number in plan.
    pub corner: usize,
    /// The least that remained, square to the edge; negative where it came off \[m\].
    pub least: Extreme,
    /// Departure over the front edge.
    pub off: Option<Departure>,
    /// The least distance from the seat's sides, along the edge, where the scene gives its width \[m\].
    pub side: Option<Extreme>,
    /// Departure over a side of the seat.
    pub off_side: Option<Departure>,
}

impl SeatCorner {
    /// Time at which it came off, over the front edge or over a side \[s\].
    fn off_at(&self) -> Option<f64> {
        [self.off, self.off_side].into_iter().flatten().map(|off| off.t).reduce(f64::min)
    }
}

/// Remaining seat of an end over a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seat {
    /// The seat.
    pub ledge: Ledge,
    /// Its corners, in the order of [`Prism::end_corners`].
    pub corners: [SeatCorner; 2],
    /// The least share of the end that stood on its seat, along the edge, 0 to 1.
    pub least_share: Extreme,
    /// Time at which both corners were first off the front edge: the end is lost \[s\].
    pub lost_at: Option<f64>,
}

impl Seat {
    /// The least that remained at either corner, square to the edge \[m\].
    pub fn least(&self) -> Extreme {
        let [one, other] = self.corners.map(|corner| corner.least);
        if other.value < one.value { other } else { one }
    }

    /// Used seat, square to the edge: placed less least \[m\].
    pub fn used(&self) -> f64 {
        self.ledge.placed() - self.least().value
    }

    /// Time at which the first corner came off, over the front edge or over a side \[s\].
    pub fn off_at(&self) -> Option<f64> {
        self.first_off().map(|(_, t)| t)
    }

    /// The corner that came off first, by its number in plan, and when \[s\].
    pub fn first_off(&self) -> Option<(usize, f64)> {
        let off = self.corners.into_iter().filter_map(|corner| Some((corner.corner, corner.off_at()?)));
        off.reduce(|first, next| if next.1 < first.1 { next } else { first })
    }
}

impl Seats<'_> {
    /// Seat under an end of a girder; `None` where the scene gives none.
    pub fn ledge(self, girder: usize, end: End) -> Option<Ledge> {
        let length = self.length(girder, end)?;
        let side = self.history.scene().girders[girder].seat.side;
        Some(Ledge { length, side, ..self.front_edge(girder, end) })
    }

    /// Front edge as of a seat of length 0: what remains of it is how far a corner has moved onto it.
    fn front_edge(self, girder: usize, end: End) -> Ledge {
        let body = &self.history.model().bodies[girder];
        let [from, to] = Prism::end_corners(end).map(|corner| body.prism.plan_corners()[corner]);
        let way = (to - from) / body.prism.end_length();
        let normal = way.perp() * -end.sign();
        Ledge {
            end,
            length: 0.0,
            sine: way.y,
            normal: body.axes * normal.extend(0.0),
            along: body.axes * way.extend(0.0),
            half_end: 0.5 * body.prism.end_length(),
            side: None,
            on: SeatOn::of(self.history, girder, end),
        }
    }

    /// Length of the seat under an end along the axis \[m\]; `None` where the scene gives none.
    pub(in crate::sim) fn length(self, girder: usize, end: End) -> Option<f64> {
        self.history.scene().girders.get(girder)?.seat.length(end)
    }

    /// Remaining seat at the worse corner of an end, square to its edge \[m\]; of a seat without length how far the end has moved off,
    /// negative.
    pub(in crate::sim) fn remaining(self, girder: usize, end: End, t: f64) -> f64 {
        let ledge = self.ledge(girder, end).unwrap_or_else(|| self.front_edge(girder, end));
        let over = Over::at(self.history, girder, &ledge, t);
        let remaining = Prism::end_corners(end).map(|corner| ledge.remaining(over.shift(self.history, corner)));
        remaining[0].min(remaining[1])
    }

    /// Place along the edge of both corners of an end, and what remains there square to the edge, at a time \[m\].
    pub fn corners_at(self, girder: usize, ledge: &Ledge, t: f64) -> [[f64; 2]; 2] {
        let over = Over::at(self.history, girder, ledge, t);
        let corners = Prism::end_corners(ledge.end).map(|corner| over.shift(self.history, corner));
        [0, 1].map(|which| [ledge.place_along(which, corners[which]), ledge.remaining(corners[which])])
    }

    /// Way of both corners of an end over their seat: `count` intervals of equal time, and the instants where least remains and
    /// where a corner comes off.
    pub fn orbit(self, girder: usize, seat: &Seat, count: u32) -> Vec<OrbitPoint> {
        let end = self.history.end();
        let even = (0..=count).map(|i| end * f64::from(i) / f64::from(count.max(1)));
        let marked = seat.corners.into_iter().flat_map(|corner| [Some(corner.least.t), corner.off.map(|off| off.t)]);
        let mut times: Vec<f64> = even.chain(marked.flatten()).collect();
        times.sort_by(f64::total_cmp);
        times.into_iter().map(|t| OrbitPoint { t, corners: self.corners_at(girder, &seat.ledge, t) }).collect()
    }

    /// Seats of a girder, that of the `+x` end first.
    pub fn of_girder(self, girder: usize) -> Vec<Seat> {
        let ledges: Vec<Ledge> = End::BOTH.into_iter().filter_map(|end| self.ledge(girder, end)).collect();
        if ledges.is_empty() {
            return Vec::new();
        }
        let history = self.history;
        let times = looks::of_body(history, girder);
        let looks = |end: End| {
            let motions = times.iter().map(|&t| history.end_motion(girder, end, t)).collect();
            Looks { history, girder, end, times: times.clone(), motions }
        };
        // The ends of a rigid girder move as one.
        let rigid = history.model().bodies[girder].sections() == 1;
        let mut seen: Option<Looks<'_>> = None;
        let mut seats = Vec::with_capacity(ledges.len());
        for ledge in ledges {
            let known = seen.take().filter(|looks| rigid || looks.end == ledge.end);
            seats.push(seen.insert(known.unwrap_or_else(|| looks(ledge.end))).seat(ledge));
        }
        seats
    }
}

/// Both corners of an end over their seat at a time: along the edge from the middle of the end as placed, and what remains square
/// to it \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitPoint {
    /// Time \[s\].
    pub t: f64,
    /// `[along, remaining]` of either corner, in the order of [`Prism::end_corners`].
    pub corners: [[f64; 2]; 2],
}

/// Share of an end that stands on its seat where this remains at its corners, 0 to 1: what remains is linear along the edge.
pub fn seated_share([one, other]: [f64; 2]) -> f64 {
    match (one > 0.0, other > 0.0) {
        (true, true) => 1.0,
        (true, false) => one / (one - other),
        (false, true) => other / (other - one),
        (false, false) => 0.0,
    }
}

/// A girder over what its end stands on, at one instant.
#[derive(Clone, Copy, Debug)]
struct Over {
    girder: usize,
    motion: Motion,
    /// Displacement and rotation of what the seat is fixed to, and where the axis of that is; `None` on the ground of reference.
    under: Option<(DVec3, f64, DVec3)>,
}

impl Over {
    fn at(history: &History, girder: usize, ledge: &Ledge, t: f64) -> Self {
        Self::of((girder, history.end_motion(girder, ledge.end, t)), history, ledge, t)
    }

    fn of((girder, motion): (usize, Motion), history: &History, ledge: &Ledge, t: f64) -> Self {
        Self { girder, motion, under: ledge.on.at(history, t) }
    }

    /// Displacement of a corner at the underside from where it was placed, seen from the seat \[m\]: on a pier with cap at
    /// displacement u and rotation R, `Rᵀ (l + s − u) − l` with the corner's displacement s and place l from the pier's axis.
    fn shift(&self, history: &History, corner: usize) -> DVec3 {
        let body = &history.model().bodies[self.girder];
        let here = body.prism.corners()[corner];
        let shift = self.motion.displacement + self.motion.attitude * here - body.axes * here;
        let Some((moved, theta, axis)) = self.under else { return shift };
        let lever = body.home + body.axes * here - axis;
        let (apart, half) = (shift - moved, (0.5 * theta).sin());
        // Rᵀ l − l without loss at small rotations.
        let turned_back = DVec3::new(lever.y, -lever.x, 0.0) * theta.sin() - lever.with_z(0.0) * (2.0 * half * half);
        DMat3::from_rotation_z(-theta) * apart + turned_back
    }
}

/// An end of a girder at every look of a run.
struct Looks<'a> {
    history: &'a History,
    girder: usize,
    end: End,
    times: Vec<f64>,
    motions: Vec<Motion>,
}

impl Looks<'_> {
    fn seat(&self, ledge: Ledge) -> Seat {
        let numbers = Prism::end_corners(ledge.end);
        let looks = self.times.iter().zip(&self.motions);
        let over: Vec<Over> =
            looks.map(|(&t, motion)| Over::of((self.girder, *motion), self.history, &ledge, t)).collect();
        let scan = |quantity: &dyn Fn(&Over) -> f64| self.scan(&ledge, &over, quantity);
        let shift = |which: usize, over: &Over| over.shift(self.history, numbers[which]);
        let remaining = |which: usize, over: &Over| ledge.remaining(shift(which, over));
        let both = |over: &Over| [remaining(0, over), remaining(1, over)];
        let corner = |which: usize| {
            let front = scan(&|over| remaining(which, over));
            let departure = |t: f64| {
                let along = ledge.place_along(which, shift(which, &Over::at(self.history, self.girder, &ledge, t)));
                Departure { t, along }
            };
            let beside = ledge
                .side
                .map(|side| scan(&|over| ledge.half_end + side - ledge.place_along(which, shift(which, over)).abs()));
            SeatCorner {
                corner: numbers[which],
                least: front.least,
                off: front.zero.map(departure),
                side: beside.map(|beside| beside.least),
                off_side: beside.and_then(|beside| beside.zero).map(departure),
            }
        };
        Seat {
            ledge,
            corners: [corner(0), corner(1)],
            least_share: scan(&|over| seated_share(both(over))).least,
            lost_at: scan(&|over| both(over).into_iter().fold(f64::NEG_INFINITY, f64::max)).zero,
        }
    }

    /// The least value of a quantity and its first zero from above.
    fn scan(&self, ledge: &Ledge, over: &[Over], quantity: &dyn Fn(&Over) -> f64) -> Scanned {
        let values: Vec<f64> = over.iter().map(quantity).collect();
        let at = |t: f64| quantity(&Over::at(self.history, self.girder, ledge, t));
        scan(&self.times, &values, &at)
    }
}

/// The least of a quantity, and when it first falls to 0.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Scanned {
    least: Extreme,
    zero: Option<f64>,
}

/// Searches a quantity that is known at times in rising order.
fn scan(times: &[f64], values: &[f64], at: &dyn Fn(f64) -> f64) -> Scanned {
    let [low, high] = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(*v), b.max(*v)]);
    let near = MINIMUM_BAND * (high - low);
    let first = values.iter().position(|v| *v <= low).unwrap_or(0);
    let mut least = Extreme { value: low, t: times.get(first).copied().unwrap_or(0.0) };
    let mut zero = None;
    for i in 0..values.len() {
        let before = i.checked_sub(1);
        if zero.is_none() && values[i] <= 0.0 {
            zero = Some(before.map_or(times[i], |b| root(|t| -at(t), times[b], times[i])));
        }
        let around = [before.unwrap_or(i), (i + 1).min(values.len() - 1)];
        let bottom = around.iter().all(|&n| values[i] <= values[n]) && values[i] < low + near;
        let matters = bottom || (zero.is_none() && around.iter().all(|&n| values[i] <= values[n]) && values[i] < near);
        if !matters || around[0] == around[1] {
            continue;
        }
        let top = peaks::golden(&|t| -at(t), times[around[0]], times[around[1]]);
        if -top.value < least.value {
            least = Extreme { value: -top.value, ..top };
        }
        if zero.is_none() && top.value >= 0.0 {
            zero = Some(root(|t| -at(t), times[around[0]], top.t));
        }
    }
    Scanned { least, zero }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A function looked at 101 times.
    fn scanned(step: f64, f: &dyn Fn(f64) -> f64) -> Scanned {
        let times: Vec<f64> = (0..=100).map(|i| f64::from(i) * step).collect();
        let values: Vec<f64> = times.iter().map(|t| f(*t)).collect();
        scan(&times, &values, f)
    }

    #[test]
    fn a_dip_between_two_looks_is_found() {
        // Lowest at 3.05, between the looks at 3.0 and 3.1, where it is still above 0.
        let dip = |t: f64| (t - 3.05).powi(2) - 1e-3;
        let found = scanned(0.1, &dip);
        assert!(dip(3.0) > 0.0 && dip(3.1) > 0.0, "above 0 at every look");
        assert!((found.zero.expect("below 0 between") - (3.05 - 1e-3f64.sqrt())).abs() < 1e-14, "{found:?}");
        assert!((found.least.value + 1e-3).abs() < 1e-14 && (found.least.t - 3.05).abs() < 1e-7, "{found:?}");
    }

    #[test]
    fn a_zero_is_the_first_of_several_and_exact() {
        let found = scanned(0.1, &|t| 0.5 + t.cos());
        assert!((found.zero.expect("falls") - std::f64::consts::TAU / 3.0).abs() < 1e-15, "{found:?}");
        assert_eq!(scanned(0.1, &|t| 1.5 + t.cos()).zero, None, "never");
        assert_eq!(scanned(0.1, &|_| -1.0).zero, Some(0.0), "off from the beginning");
    }

    #[test]
    fn the_share_is_that_of_a_line_between_the_corners() {
        let all = [[0.3, 0.1], [0.3, -0.1], [-0.1, 0.3], [-0.1, -0.3]].map(seated_share);
        for (got, wanted) in all.into_iter().zip([1.0, 0.75, 0.75, 0.0]) {
            assert!((got - wanted).abs() < 1e-15, "{got}, not {wanted}");
        }
    }
}
