//! Time of the next impact of a pair: the first zero of any of its open gaps.
//!
//! In free flight by conservative advancement, all points of the pair together; where a side is in a planned step of lasting
//! contact by subdivision of the step, point by point. Both rest on bounds of the gaps' derivatives ([`PairMotion`]).

use smallvec::SmallVec;

use crate::dynamics::impact2d::closing::gap_derivatives::{PairMotion, poses};
use crate::dynamics::impact2d::closing::planar_gap::gap;
use crate::dynamics::impact2d::constants::SEARCHED_PERIODS;
use crate::dynamics::impact2d::tracks::Trajectory;
use crate::dynamics::impact2d::world::World;
use crate::dynamics::locate::advancement::{AdvanceOutcome, Advancement, BoundedGap, FirstZero, polish};
use crate::dynamics::locate::constants::{MAX_ADVANCES, RESOLUTION, SAMPLES_PER_SEARCH};
use crate::dynamics::locate::cubic_bound::CubicBound;
use crate::dynamics::locate::horizon::Horizon;
use crate::dynamics::locate::positive_again::is_positive_again;
use crate::dynamics::locate::root::root;
use crate::dynamics::locate::subdivision::{GapClosing, GapSample, Subdivision};
use crate::motion::Ground;

/// Result of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics::impact2d) struct NextImpact {
    /// Time of the impact, or from which to search on; infinite when neither is needed \[s\].
    pub due: f64,
    /// Whether there is an impact then.
    pub impact: bool,
    /// Evaluations of the gaps in flight.
    pub looks: u64,
}

/// An open point under search.
struct OpenPoint {
    site: usize,
    /// Added to the gap: a point that has lifted off without speed hits again this deep behind the face \[m\].
    depth: f64,
    resolution: f64,
    advancement: Advancement,
    /// Lower bound of the gap from the last evaluation on, where its third derivative is bounded.
    bound: Option<CubicBound>,
    /// Time at which a point that has lifted off was first in front of the face \[s\].
    in_front_at: Option<f64>,
}

fn bounded_gap(world: &World, site: usize, depth: f64, motion: &PairMotion) -> (BoundedGap, Option<CubicBound>) {
    let track = &world.sites[site];
    motion.bounded_gap(&track.geometry, &track.spot, track.sides, depth)
}

/// `[g + depth, ġ]` of a site at `t`.
fn gap_at(world: &World, pair: usize, site: usize, depth: f64, t: f64) -> [f64; 2] {
    let track = &world.sites[site];
    let [gap, rate] = gap(&track.geometry, track.sides, &poses(world, world.pairs[pair].slots, t));
    [gap + depth, rate]
}

/// Searches a pair from `t` on.
pub(in crate::dynamics::impact2d) fn next_impact(world: &mut World, pair: usize, t: f64) -> NextImpact {
    let slots = world.pairs[pair].slots;
    let planned = slots.into_iter().flatten().filter_map(|slot| world.planned_end(slot)).fold(f64::INFINITY, f64::min);
    let horizon = Horizon { periods: SEARCHED_PERIODS, samples: SAMPLES_PER_SEARCH };
    let mut until = horizon.end(&world.model.ground, t, world.model.duration).min(planned);
    if planned.is_finite() {
        // The step of a body at rest may span many periods of one that flies, and bounds over all of them are wide.
        until = until.min(t + half_period(world, slots));
    }
    for slot in slots.into_iter().flatten() {
        world.remember(slot, until);
    }
    if planned.is_finite() { in_steps(world, pair, t, until, planned) } else { in_flight(world, pair, t, until) }
}

/// Half of the shortest period of the flying sides \[s\]: within it a gap turns once or twice, and its subdivision is short.
fn half_period(world: &World, slots: [Option<usize>; 2]) -> f64 {
    let ground = if let Ground::Sine { omega, .. } = world.model.ground { omega } else { 0.0 };
    let shortest = |slot: usize| match world.bodies[slot].motion {
        Trajectory::Flight(_) => {
            let [omega, damping] = world.bodies[slot].free_motion.rates;
            std::f64::consts::PI / omega.max(damping).max(ground)
        }
        Trajectory::Lasting(..) => f64::INFINITY,
    };
    slots.into_iter().flatten().map(shortest).fold(f64::INFINITY, f64::min)
}

/// The open points of a pair; those in front of their face are armed.
fn open_points(world: &mut World, pair: usize, t: f64, motion: &PairMotion) -> SmallVec<[OpenPoint; 4]> {
    let moved = motion.displacement();
    let mut all = SmallVec::new();
    for site in world.pairs[pair].sites.clone() {
        if world.sites[site].kept {
            continue;
        }
        let resolution = RESOLUTION * (world.sites[site].spot.size + moved);
        let (mut here, mut bound) = bounded_gap(world, site, 0.0, motion);
        let track = &mut world.sites[site];
        if !track.armed && is_positive_again(here.gap, here.rate, t, resolution) {
            track.arm(t);
        }
        let (depth, armed) = (if track.lifted { track.depth } else { 0.0 }, track.armed || track.lifted);
        if depth > 0.0 {
            (here, bound) = bounded_gap(world, site, depth, motion);
        }
        let advancement = Advancement::begin(here, armed, resolution);
        all.push(OpenPoint { site, depth, resolution, advancement, bound, in_front_at: None });
    }
    all
}

fn in_flight(world: &mut World, pair: usize, t: f64, until: f64) -> NextImpact {
    let (duration, slots) = (world.model.duration, world.pairs[pair].slots);
    let mut motion = PairMotion::of(world, slots, t, duration);
    let mut points = open_points(world, pair, t, &motion);
    let reachable = |p: &OpenPoint| !(p.advancement.out_of_reach() && motion.window >= duration - t);
    if !points.iter().any(reachable) {
        return NextImpact { due: f64::INFINITY, impact: false, looks: 0 };
    }
    if motion.is_translation() {
        keep_nearest(world, &mut points);
    }
    let (mut at, mut looks) = (t, 1);
    let mut found = points.iter().any(|p| p.advancement.crosses_now()).then_some(t);
    for _ in 0..MAX_ADVANCES {
        if at >= until || found.is_some() {
            break;
        }
        let next = (at + safe_step(&mut points)).min(until);
        if next <= at {
            found = Some(at);
            break;
        }
        let there = motion.next(world, slots, next, until);
        looks += 1;
        for point in &mut points {
            found = evaluate(world, pair, point, &there, [at, next], found).or(found);
        }
        (at, motion) = (next, there);
    }
    for point in &points {
        world.sites[point.site].in_front_at = point.in_front_at.or(point.advancement.rearmed_at());
    }
    let due = found.map_or(FirstZero::NoneUntil(at), FirstZero::Crossing).due(duration);
    NextImpact { due, impact: found.is_some(), looks }
}

/// Drops points that are never nearer than another of the same face: without rotation their distances stay. Points that
/// arrive together with the nearest are found at the impact.
fn keep_nearest(world: &World, points: &mut SmallVec<[OpenPoint; 4]>) {
    let is_behind = |far: &OpenPoint, near: &OpenPoint| {
        let (a, b) = (&world.sites[far.site], &world.sites[near.site]);
        let alike = far.advancement.armed() && near.advancement.armed() && (far.depth > 0.0) == (near.depth > 0.0);
        let clear = |point: &OpenPoint| point.advancement.gap() - point.depth;
        alike && a.sides == b.sides && a.geometry.shares_face(&b.geometry) && clear(far) >= clear(near)
    };
    let mut i = 0;
    while i < points.len() {
        if (0..points.len()).any(|j| j != i && is_behind(&points[i], &points[j])) {
            points.remove(i);
        } else {
            i += 1;
        }
    }
}

/// Time within which no gap can close \[s\].
fn safe_step(points: &mut [OpenPoint]) -> f64 {
    let mut shortest = f64::INFINITY;
    let mut last: Option<(CubicBound, f64)> = None;
    for point in points {
        let open = match (point.bound.filter(|_| point.advancement.armed()), last) {
            (None, _) => 0.0,
            (Some(bound), Some((other, step))) if bound.is_above(&other) => step,
            (Some(bound), _) => bound.safe_step(),
        };
        last = point.bound.map(|bound| (bound, open)).or(last);
        shortest = shortest.min(point.advancement.step_past(open));
    }
    shortest
}

/// Time at which a point hits before `sooner`, if its gap at `next` shows that it does.
fn evaluate(
    world: &World,
    pair: usize,
    point: &mut OpenPoint,
    there: &PairMotion,
    [t, next]: [f64; 2],
    sooner: Option<f64>,
) -> Option<f64> {
    let site = point.site;
    let mut from = t;
    if point.depth > 0.0
        && let Some(front) = front_time(world, pair, point, there, [t, next])
    {
        // In front of the face it hits at the face itself.
        (point.depth, point.in_front_at, from) = (0.0, Some(front), front.min(next));
    }
    let depth = point.depth;
    let (here, bound) = bounded_gap(world, site, depth, there);
    point.bound = bound;
    let gap = |at: f64| gap_at(world, pair, site, depth, at);
    match point.advancement.advance(here, next) {
        AdvanceOutcome::Open => None,
        AdvanceOutcome::Closed if sooner.is_some_and(|at| gap(at)[0] > -point.resolution) => None,
        AdvanceOutcome::Closed => Some(root(|at| -gap(at)[0], point.advancement.last_open(from, next), next)),
        AdvanceOutcome::Closing => {
            let mut sample = |at: f64| {
                let [gap, rate] = gap(at);
                BoundedGap { gap, rate, ..here }
            };
            let at = polish(&mut sample, next, &here, f64::INFINITY);
            sooner.is_none_or(|sooner| at < sooner).then_some(at)
        }
    }
}

/// Time at which a point that has lifted off is in front of the face \[s\]: `next` or, where one step spans the whole hop, halfway.
fn front_time(world: &World, pair: usize, point: &OpenPoint, there: &PairMotion, [t, next]: [f64; 2]) -> Option<f64> {
    let track = &world.sites[point.site];
    let [clear, rate] = gap(&track.geometry, track.sides, &there.poses);
    if is_positive_again(clear, rate, next, point.resolution) {
        return Some(next);
    }
    let middle = f64::midpoint(t, next);
    let [clear, middle_rate] = gap_at(world, pair, point.site, 0.0, middle);
    (rate < 0.0 && is_positive_again(clear, middle_rate, middle, point.resolution)).then_some(middle)
}

/// Search where a side is in a planned step, which ends at `planned`, by subdivision.
fn in_steps(world: &mut World, pair: usize, t: f64, until: f64, planned: f64) -> NextImpact {
    let motion = PairMotion::of(world, world.pairs[pair].slots, t, until);
    let until = until.min(t + motion.window);
    let mut first: Option<f64> = None;
    for point in open_points(world, pair, t, &motion) {
        let found = in_step(world, pair, &point, &motion, [t, until]);
        world.sites[point.site].in_front_at = found.rearmed_at;
        first = found.closing.into_iter().chain(first).reduce(f64::min);
    }
    // At the end of the step the pair is searched again.
    let next = if until < planned.min(world.model.duration) { until } else { f64::INFINITY };
    NextImpact { due: first.unwrap_or(next), impact: first.is_some(), looks: 0 }
}

/// First crossing of a point in `[t, until]`, and when a point that was not armed is first in front of its face; `motion` is
/// the pair's at `t` and bounds `|g̈|` up to `until`.
fn in_step(world: &World, pair: usize, point: &OpenPoint, motion: &PairMotion, [t, until]: [f64; 2]) -> GapClosing {
    let sample = |at: f64| {
        let [gap, rate] = gap_at(world, pair, point.site, point.depth, at);
        GapSample { t: at, gap, rate }
    };
    let (here, armed) = (sample(t), point.advancement.armed());
    if armed && here.gap <= point.resolution && here.rate < 0.0 {
        return GapClosing::at(t);
    }
    let curvature = bounded_gap(world, point.site, point.depth, motion).0.curvature;
    // An impact is the crossing itself: neither how the rate may err nor a time to see it is needed.
    let functions = (sample, |_: &GapSample, _| curvature, |_| 0.0);
    Subdivision::new(functions, armed, point.resolution, 0.0).search(&[here, sample(until)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;
    use crate::dynamics::impact2d::lasting::lasting_contact::LastingContact;
    use crate::dynamics::impact2d::run::ImpactRun;

    /// A girder of 2 kg before a wall, free to slide along x, at this gap \[m\] with this initial velocity \[m/s\].
    fn world(bearings: &str, gap: f64, speed: f64) -> World {
        example::world(example::block(&format!("initial = {{ velocity_m_s = [{speed:?}, 0.0] }}\n{bearings}"), gap))
    }

    #[test]
    fn a_free_girder_hits_after_gap_over_speed() {
        let next = next_impact(&mut world("", 0.003, 0.25), 0, 0.0);
        assert!(next.impact && (next.due - 0.012).abs() < 1e-15, "{next:?}");
    }

    #[test]
    fn a_girder_that_goes_away_never_hits() {
        let next = next_impact(&mut world("", 0.003, -0.25), 0, 0.0);
        assert_eq!((next.due, next.impact), (f64::INFINITY, false), "no force brings it back");
    }

    #[test]
    fn an_undamped_girder_hits_where_its_sine_reaches_the_gap() {
        let legs = "[[0.07, 0.025], [0.07, -0.025], [-0.07, 0.025], [-0.07, -0.025]]";
        let bearings = &format!("bearings = {{ frequency_hz = 2.0, damping_ratio = 0.0, at_m = {legs} }}");
        let omega = 4.0 * std::f64::consts::PI;
        let speed = 0.1;
        // x = (v/ω) sin ωt, away from the wall first.
        let next = next_impact(&mut world(bearings, 0.005, -speed), 0, 0.0);
        let expected = (std::f64::consts::PI + (0.005 * omega / speed).asin()) / omega;
        assert!(next.impact && (next.due - expected).abs() < 1e-14, "{next:?} against {expected}");
        let far = next_impact(&mut world(bearings, 1.001 * speed / omega, speed), 0, 0.0);
        assert_eq!((far.due, far.impact), (f64::INFINITY, false), "the amplitude is below the gap");
    }

    #[test]
    fn a_dip_within_a_planned_step_is_an_impact() {
        let legs = "[[0.07, 0.025], [0.07, -0.025], [-0.07, 0.025], [-0.07, -0.025]]";
        let bearings = &format!("bearings = {{ frequency_hz = 2.0, damping_ratio = 0.0, at_m = {legs} }}");
        let omega = 4.0 * std::f64::consts::PI;
        // x = (v/ω) sin ωt is beyond the gap for 0.25 ms of its half period of 250 ms.
        let (speed, amplitude) = (0.1, 0.1 / omega);
        let gap = amplitude - 1e-8;
        let state = [0.0, 0.0, 0.0, speed, 0.0, 0.0];
        let mut run = ImpactRun::before_start(world(bearings, gap, speed));
        run.world.update_peaks(0, &state);
        // Without a contact mode the integrator follows the bearings alone.
        run.world.lasting.push(Some(LastingContact::new(vec![0], Vec::new(), &[state], 0.0)));
        run.world.bodies[0].motion = Trajectory::Lasting(0, 0);
        let found = (0..1000).find_map(|_| {
            run.plan(0);
            let (from, until) = run.world.lasting[0].as_ref().map(|contact| (contact.from, contact.until))?;
            let next = next_impact(&mut run.world, 0, from);
            let after = gap_at(&run.world, 0, 0, 0.0, until)[0];
            run.world.lasting[0].as_mut()?.commit();
            next.impact.then_some((next.due, after))
        });
        let (due, after) = found.expect("an impact");
        let expected = (gap / amplitude).asin() / omega;
        assert!((due - expected).abs() < 1e-6, "{due} against {expected}");
        assert!(after > 0.0, "the gap is open again at the end of the step: {after} m");
    }
}
