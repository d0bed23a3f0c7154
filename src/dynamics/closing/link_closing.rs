//! The next beginning of a link's force: the first zero of its gap on the present trajectories of the bodies at its ends; of a link that acts
//! on a body in flight the end of its phase.

use glam::DVec3;

use crate::contact::Frame;
use crate::dynamics::closing::constants::{CLOSING_INTERVAL, SPEED_ROUNDING, STEP_SAMPLES};
use crate::dynamics::closing::flight_view::{FlightSample, farthest, horizon, remember};
use crate::dynamics::closing::found::{NextClosing, first_step_end};
use crate::dynamics::closing::gap_curvature::GapCurvature;
use crate::dynamics::closing::link_motion::{frames, motion};
use crate::dynamics::closing::{phase_end, phase_end_in_plan};
use crate::dynamics::connection::{Activity, Kinematics, Link, SeparationBounds, Switch};
use crate::dynamics::locate::advancement::{BoundedGap, FirstZero, first_crossing_from};
use crate::dynamics::locate::constants::RESOLUTION;
use crate::dynamics::locate::sample_times::sample_times;
use crate::dynamics::locate::subdivision::{GapSample, Subdivision};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::LinkTrack;

/// Searches the beginning of the force of a link from `t` on, or the end of its phase where it acts on a body in flight (of all links on
/// a girder together), and enters it in the link's track.
pub(in crate::dynamics) fn search(world: &mut World, link: usize, t: f64) -> NextClosing {
    if world.phases_led_by(link).is_some() {
        return phase_end_in_plan::search(world, link, t);
    }
    world.links[link].ends = None;
    if world.link_acts(link) {
        return phase_end::search(world, link, t);
    }
    if world.model_link(link).device.activity(&world.links[link].phase) == Activity::Ended {
        return NextClosing::at(f64::INFINITY);
    }
    let slots = world.links[link].slots;
    match first_step_end(world, slots) {
        Some(until) => {
            let begins = in_steps(world, link, t, until);
            world.links[link].ends = begins.map(|at| (at, Switch::Closing));
            NextClosing::at(begins.unwrap_or(f64::INFINITY))
        }
        None => phase_end::beginning(world, link, t).unwrap_or_else(|| in_flight(world, link, t)),
    }
}

/// Conservative advancement where neither end is in a planned step.
fn in_flight(world: &mut World, link: usize, t: f64) -> NextClosing {
    let (duration, slots) = (world.model.duration, world.links[link].slots);
    let until = horizon(world, slots, t);
    remember(world, slots, until);
    let present = &*world;
    let (mut evaluations, size) = (1, resolution(present, link, t));
    let here = bounded_gap(present, link, t, farthest(present, [t, until]));
    let sample = |at: f64| {
        evaluations += 1;
        bounded_gap(present, link, at, until)
    };
    let found = if here.out_of_reach && here.window >= duration - t {
        FirstZero::NoneUntil(duration)
    } else {
        first_crossing_from(here, sample, [t, until], true, size)
    };
    if let FirstZero::Crossing(at) = found {
        world.links[link].ends = Some((at, Switch::Closing));
    }
    NextClosing::of(found, duration, evaluations)
}

/// Gap of a device in flight at `t` with a bound on its second derivative, valid up to `until` at most.
fn bounded_gap(world: &World, link: usize, t: f64, until: f64) -> BoundedGap {
    let LinkTrack { link, slots, phase, .. } = &world.links[link];
    let link = &world.model.links[*link];
    let sample = FlightSample::of(world, *slots, link.sections, t, until);
    let frames = link.frames(|end, _| slots[end].map(|_| sample.frames[end]));
    let (motion, _) = link.motion([&frames[0], &frames[1]]);
    let arms = link.arms.map(DVec3::length);
    let sum =
        |of: fn(&MotionBounds) -> f64| sample.bounds.iter().zip(arms).map(|(bound, arm)| of(bound) * arm).sum::<f64>();
    let between = &sample.between;
    let bounds = SeparationBounds {
        distance: motion.placed.length() + between.reach + sum(|bound| bound.turn),
        speed: between.speed + sum(|bound| bound.spin),
        acceleration: between.acceleration + sum(MotionBounds::acceleration_per_arm),
    };
    let bounds = match link.kinematics {
        Kinematics::Carried => bounds.carried(sample.bounds[1].spin, sample.bounds[1].spin_rate),
        Kinematics::Points | Kinematics::Linear => bounds,
    };
    let [gap, rate] = link.device.gap(phase, &motion);
    let curvature = link.device.gap_curvature(phase, &bounds);
    BoundedGap { gap, rate, curvature, window: between.window, out_of_reach: link.device.stays_idle(phase, &bounds) }
}

/// Subdivision up to the end of the first planned step of the ends.
fn in_steps(world: &World, number: usize, t: f64, until: f64) -> Option<f64> {
    if until <= t {
        return None;
    }
    let LinkTrack { link, slots, phase, simultaneity, .. } = &world.links[number];
    let link = &world.model.links[*link];
    let gap = |at: f64| {
        let [gap, rate] = link.device.gap(phase, &motion(world, number, at));
        GapSample { t: at, gap, rate }
    };
    let rate_error = |at: f64| {
        let frames = frames(world, number, at);
        let speed = |i: usize| frames[i].velocity.length() + frames[i].spin.length() * link.arms[i].length();
        world.model.tolerance.max(SPEED_ROUNDING) * (speed(0) + speed(1))
    };
    // Bounds on the relative motion of the link's points from `from` to `to`; `distance` is their distance at `from` \[m\].
    let bounds = |distance: f64, from: f64, to: f64| {
        let curvature = GapCurvature::of(world, *slots, from, to);
        let bounds = curvature.separation(link.arms.map(DVec3::length), distance, to - from);
        curvature.holds(to - from).then(|| match link.kinematics {
            Kinematics::Carried => curvature.carried(bounds),
            Kinematics::Points | Kinematics::Linear => bounds,
        })
    };
    let curvature_bound = |from: &GapSample, to: f64| {
        let distance = motion(world, number, from.t).vector().length();
        bounds(distance, from.t, to).map_or(f64::INFINITY, |bounds| link.device.gap_curvature(phase, &bounds))
    };
    let here = frames(world, number, t);
    let motion_here = link.motion([&here[0], &here[1]]).0;
    let [gap_here, rate_here] = link.device.gap(phase, &motion_here);
    let first = GapSample { t, gap: gap_here, rate: rate_here };
    let resolution = resolution_of(link, &here);
    let span = until - t;
    if let Some(bounds) = bounds(motion_here.vector().length(), t, until) {
        // No closing within the step where the gap less the largest relative displacement of the points, or the parabola that bounds the
        // gap from below, stays positive.
        let less_way = first.gap - bounds.speed * span;
        let lowest = || {
            let curvature = link.device.gap_curvature(phase, &bounds);
            first.gap + first.rate.min(0.0) * span - 0.5 * curvature * span * span
        };
        if first.gap > resolution && (less_way > 0.0 || lowest() > 0.0) {
            return None;
        }
    }
    if first.gap <= resolution && first.rate < -rate_error(t) {
        return Some(t);
    }
    let samples: [GapSample; STEP_SAMPLES] = sample_times([t, until]).map(gap);
    Subdivision::new((gap, curvature_bound, rate_error), true, resolution, CLOSING_INTERVAL * simultaneity)
        .search(&samples)
        .closing
}

/// Depth of an excursion of the gap below zero that is round-off at `t` \[m\].
fn resolution(world: &World, number: usize, t: f64) -> f64 {
    resolution_of(world.model_link(number), &frames(world, number, t))
}

/// Resolution of a gap of a link whose ends have these poses \[m\].
fn resolution_of(link: &Link, frames: &[Frame; 2]) -> f64 {
    let moved: f64 = frames.iter().map(|frame| frame.shift.length()).sum();
    RESOLUTION * (link.size() + moved)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DMat3;

    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::connection::{Anchor, Device, Phase};
    use crate::dynamics::devices::{Failure, Restrainer, Stopper};
    use crate::dynamics::model::coordinates::planar::PlanarState;
    use crate::dynamics::penalty3d::example::wall;
    use crate::dynamics::world::example::flying;

    /// A girder in flight from this state, with a device between its G and a point of the ground.
    fn linked(device: Arc<dyn Device>, kinematics: Kinematics, ground: DVec3, state: PlanarState) -> World {
        let mut model = Model::compile(&wall()).unwrap_or_else(|errors| panic!("{errors}"));
        let ends = [Anchor::Body { body: 0, point: DVec3::ZERO }, Anchor::Ground(ground)];
        model.link_by("device", ends, (DMat3::IDENTITY, kinematics), device).expect("a link in the plane");
        flying(model, &[state])
    }

    fn stopper() -> Arc<dyn Device> {
        Arc::new(Stopper { gap: 1e-3, stiffness: 1e5, failure: Failure::Never })
    }

    /// A cable of 1 m with 0.25 m of slack.
    fn cable() -> Arc<dyn Device> {
        let (slack, break_elongation) = (0.25, f64::INFINITY);
        Arc::new(Restrainer { length: 1.0, slack, stiffness: 1e3, yielding: None, break_elongation })
    }

    fn near(got: f64, expected: f64) {
        assert!((got - expected).abs() <= 1e-11 * expected, "{got} s is not {expected} s");
    }

    #[test]
    fn a_stopper_touches_after_its_gap_over_the_speed() {
        for kinematics in [Kinematics::Points, Kinematics::Linear, Kinematics::Carried] {
            let mut world = linked(stopper(), kinematics, DVec3::ZERO, [0.0, 0.0, 0.0, -0.5, 0.3, 0.0]);
            assert_eq!(search(&mut world, 0, 0.0).due, f64::INFINITY, "it moves away");
            assert_eq!(world.links[0].ends, None);
            let mut world = linked(stopper(), kinematics, DVec3::ZERO, [-2e-3, 0.0, 0.0, 0.5, 0.3, 0.0]);
            near(search(&mut world, 0, 0.0).due, 3e-3 / 0.5);
            assert_eq!(world.links[0].ends.map(|(_, event)| event), Some(Switch::Closing));
        }
    }

    #[test]
    fn a_cable_is_taut_where_a_girder_that_flies_past_its_anchor_is_at_its_length() {
        // Across the cable at 2 m/s: (1² + 4 t²) = 1.25².
        let mut world = linked(cable(), Kinematics::Points, DVec3::NEG_X, [0.0, 0.0, 0.0, 0.0, 2.0, 0.0]);
        near(search(&mut world, 0, 0.0).due, 0.375);
        // Towards the anchor, past it and on: 1 m and 1.25 m at 4 m/s.
        let mut world = linked(cable(), Kinematics::Points, DVec3::NEG_X, [0.0, 0.0, 0.0, -4.0, 0.0, 0.0]);
        near(search(&mut world, 0, 0.0).due, 2.25 / 4.0);
        // At 0.2 m/s it is not used up within 1 s.
        let mut world = linked(cable(), Kinematics::Points, DVec3::NEG_X, [0.0, 0.0, 0.0, 0.2, 0.0, 0.0]);
        assert_eq!(search(&mut world, 0, 0.0).due, f64::INFINITY);
    }

    #[test]
    fn a_device_that_has_broken_begins_no_more() {
        let brittle = Stopper { gap: 1e-3, stiffness: 1e5, failure: Failure::Brittle { force: 1.0 } };
        let mut world = linked(Arc::new(brittle), Kinematics::Points, DVec3::ZERO, [0.0, 0.0, 0.0, 0.5, 0.0, 0.0]);
        let broken = Phase { branch: 3, ..Phase::default() };
        assert_eq!(world.model_link(0).device.activity(&broken), Activity::Ended);
        (world.links[0].phase, world.links[0].ends) = (broken, Some((0.1, Switch::Closing)));
        assert_eq!(search(&mut world, 0, 0.0).due, f64::INFINITY);
        assert_eq!(world.links[0].ends, None);
    }
}
