//! The first end of a phase of the devices that act on a rigid girder in flight in plan: the first rise of a switching function through 0.
//!
//! All devices of a girder follow its one motion and are searched together. Bounds on the girder's speed and acceleration give a time for
//! which every function stays below 0; where one may rise sooner than can be sampled, the flight is sampled, as a step is.

use glam::DVec3;
use smallvec::SmallVec;

use crate::contact::Frame;
use crate::dynamics::closing::constants::STEP_SAMPLES;
use crate::dynamics::closing::flight_view::{FlightSample, horizon, remember};
use crate::dynamics::closing::found::NextClosing;
use crate::dynamics::connection::{Excursion, Separation, Switch};
use crate::dynamics::free_flight::body_flight::BodyFlight;
use crate::dynamics::locate::advancement::FirstZero;
use crate::dynamics::locate::first_rise::{EarliestRise, Resolution, first_rise};
use crate::dynamics::locate::sample_times::sample_times;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::penalty3d::link_events::{SwitchRoundoff, switch_roundoff};
use crate::dynamics::world::World;

/// A switching function: link in the group, number of the function.
type Function = (usize, usize);

/// Searches from `t` on the first end of a phase of the devices on a girder and enters it in the track of its link; `leader` is the first of
/// them, whose next search this sets.
pub(super) fn search(world: &mut World, leader: usize, t: f64) -> NextClosing {
    let (duration, slots) = (world.model.duration, world.links[leader].slots);
    let Some(slot) = slots[0] else { return NextClosing::at(f64::INFINITY) };
    let links: SmallVec<[usize; 8]> = world.phases_in_flight(slot).collect();
    for &link in &links {
        world.links[link].ends = None;
    }
    let until = horizon(world, slots, t);
    remember(world, slots, until);
    let (mut from, mut evaluations) = (t, 0);
    while from < until {
        evaluations += 1;
        let (to, likely) = stretch(world, slot, &links, [from, until]);
        if let Some((at, (link, number))) = first_in(world, slot, &likely, [from, to]) {
            world.links[link].ends = Some((at, Switch::Function(number)));
            return NextClosing { due: if link == leader { at } else { f64::INFINITY }, evaluations };
        }
        from = to;
    }
    NextClosing::of(FirstZero::NoneUntil(until), duration, evaluations)
}

/// Motion of a link's point of the girder against the ground.
fn motion(world: &World, number: usize, girder: &Frame) -> Separation {
    let link = world.model_link(number);
    link.motion([girder, &Frame::fixed(link.homes[1])]).0
}

/// The end of a stretch of the flight from `from` on in which no switching function can rise through 0; where that is shorter than what can
/// be sampled, of a stretch for that, and the functions that may rise in it.
fn stretch(world: &World, slot: usize, links: &[usize], [from, until]: [f64; 2]) -> (f64, SmallVec<[Function; 8]>) {
    let sample = FlightSample::of(world, [Some(slot), None], [0; 2], from, until);
    let (here, bounds) = (&sample.frames[0], &sample.bounds[0]);
    let motions: SmallVec<[Separation; 8]> = links.iter().map(|&link| motion(world, link, here)).collect();
    let likely = |span: f64| {
        let mut likely = SmallVec::new();
        for (&number, motion) in links.iter().zip(&motions) {
            let track = &world.links[number];
            let link = &world.model.links[track.link];
            let within = excursion(bounds, link.arms[0].length(), motion.rate, span);
            let rises = |function: &usize| !link.device.stays_below(*function, &track.phase, motion, within);
            let functions = 0..link.device.switches(&track.phase);
            likely.extend(functions.filter(rises).map(|function| (number, function)));
        }
        likely
    };
    let longest = bounds.window.min(until - from);
    let sampled = longest.min(world.model.ground.next_kink(from) - from).min(swing(world, slot));
    let mut span = longest;
    while span > sampled {
        if likely(span).is_empty() {
            return ((from + span).min(until), SmallVec::new());
        }
        span *= 0.5;
    }
    ((from + sampled).min(until), likely(sampled))
}

/// Bounds on the change, over a time `span` \[s\], of displacement and rate of a point at distance `arm` from G \[m\] that has this rate
/// now \[m/s\].
fn excursion(bounds: &MotionBounds, arm: f64, rate: DVec3, span: f64) -> Excursion {
    let change = span * (bounds.acceleration + arm * bounds.acceleration_per_arm());
    let speed = (bounds.speed + arm * bounds.spin).min(rate.length() + 0.5 * change);
    Excursion { way: span * speed, rate: change }
}

/// Time in which a girder in flight on springs swings by a radian at most \[s\].
fn swing(world: &World, slot: usize) -> f64 {
    let in_plan = world.bodies[slot].flight().and_then(BodyFlight::in_plan);
    in_plan.map_or(f64::INFINITY, |(system, _)| system.fastest().recip())
}

/// The first rise of one of these functions within a stretch.
fn first_in(world: &World, slot: usize, functions: &[Function], [from, to]: [f64; 2]) -> Option<(f64, Function)> {
    if functions.is_empty() {
        return None;
    }
    let times = sample_times::<STEP_SAMPLES>([from, to]);
    let frames = times.map(|t| world.frame(slot, 0, t));
    let mut earliest = EarliestRise::none();
    for &(number, function) in functions {
        let track = &world.links[number];
        let link = &world.model.links[track.link];
        let motions = frames.each_ref().map(|frame| motion(world, number, frame));
        let SwitchRoundoff { zero, band, noise } =
            switch_roundoff(link, (function, &track.phase), &motions, track.omega);
        let value = |motion: &Separation| link.device.switch(function, &track.phase, motion) - band;
        let values = motions.map(|motion| value(&motion));
        let value_at = |t: f64| value(&motion(world, number, &world.frame(slot, 0, t)));
        let resolution = Resolution { zero, rise: 0.0, noise };
        let rise = first_rise([&times[..], &values[..]], resolution, false, earliest.known(), value_at);
        earliest.offer(rise, (number, function));
    }
    earliest.found()
}
