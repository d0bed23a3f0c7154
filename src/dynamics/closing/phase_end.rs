//! The end of the phase of a device that acts on a body in flight: the first rise of one of its switching functions through 0.
//!
//! Such a body has one coordinate u, and the device is linear: gap and switching functions that are lengths are linear in u. The
//! range of u in an interval of the record tells whether they can reach 0 at all; where they can, the flight is sampled stretch by
//! stretch, as a step is.

use smallvec::SmallVec;

use crate::dynamics::closing::constants::{PHASE_END_SAMPLES, STEP_SAMPLES};
use crate::dynamics::closing::flight_view::remember;
use crate::dynamics::closing::found::NextClosing;
use crate::dynamics::closing::link_motion::motion;
use crate::dynamics::connection::{Separation, Switch, SwitchUnit};
use crate::dynamics::locate::first_rise::{EarliestEvent, Resolution, first_rise};
use crate::dynamics::locate::sample_times::sample_times;
use crate::dynamics::penalty3d::link_events::zero_and_band;
use crate::dynamics::world::World;
use crate::motion::Ground;

/// Searches the end of the phase of a link that acts on a body in flight, from `t` on, and enters it in the link's track.
pub(super) fn search(world: &mut World, link: usize, t: f64) -> NextClosing {
    if world.is_linear_link(link) {
        return NextClosing::at(f64::INFINITY);
    }
    let (duration, until) = (world.model.duration, horizon(world, t));
    let Some(slot) = world.links[link].slots[0] else { return NextClosing::at(f64::INFINITY) };
    remember(world, world.links[link].slots, until);
    let functions = functions(world, (link, slot));
    let mut from = t;
    while from < until {
        let kink = world.model.ground.next_kink(from).min(until);
        if may_rise(world, slot, &functions, [from, kink]).is_empty() {
            from = kink;
            continue;
        }
        let to = world.window_end(slot, from).min(until);
        let likely = may_rise(world, slot, &functions, [from, to]);
        if let Some((at, number)) = within(world, link, &likely, [from, to]) {
            world.links[link].ends = Some((at, Switch::Function(number)));
            return NextClosing::at(at);
        }
        from = to;
    }
    NextClosing::at(if until < duration { until } else { f64::INFINITY })
}

/// End of one search \[s\].
fn horizon(world: &World, t: f64) -> f64 {
    match world.model.ground {
        Ground::Record { dt, .. } => (t + PHASE_END_SAMPLES * dt).min(world.model.duration),
        Ground::Still | Ground::Sine { .. } => world.model.duration,
    }
}

/// For a device that does not act, linear in the one coordinate of a body in flight: the time up to which its gap stays open from `t`
/// on for certain, and the end of the search; `None` for others.
pub(super) fn open_until(world: &mut World, link: usize, t: f64) -> Option<[f64; 2]> {
    let track = &world.links[link];
    let &[Some(slot), None] = &track.slots else { return None };
    let device = &world.model.links[track.link].device;
    let body = &world.model.bodies[world.bodies[slot].body];
    if body.positions() != 1 || !device.is_linear_in(&track.phase) {
        return None;
    }
    let gap = linear(world, (link, slot), |motion| -device.gap(&track.phase, motion)[0]);
    let (slots, until) = (track.slots, horizon(world, t));
    remember(world, slots, until);
    let mut from = t;
    while from < until {
        let kink = world.model.ground.next_kink(from).min(until);
        if gap.most(world.flight_range(slot, [from, kink])) >= 0.0 {
            break;
        }
        from = kink;
    }
    Some([from, until])
}

/// A function of the one coordinate u of a body: `placed + slope u`.
#[derive(Clone, Copy, Debug)]
struct Linear {
    placed: f64,
    slope: f64,
}

impl Linear {
    /// Its greatest value in a range of u.
    fn most(self, [least, greatest]: [f64; 2]) -> f64 {
        self.placed + self.slope * if self.slope > 0.0 { greatest } else { least }
    }
}

/// A function of a link's motion that is linear in the coordinate of its body.
fn linear(world: &World, (number, slot): (usize, usize), value: impl Fn(&Separation) -> f64) -> Linear {
    let link = &world.model.links[world.links[number].link];
    let body = &world.model.bodies[world.bodies[slot].body];
    let at = |u: f64| {
        let frame = body.frame(0, &[u, 0.0]);
        let [_, ground] = link.frames(|_, _| None);
        value(&link.motion([&frame, &ground]).0)
    };
    let [placed, moved] = [0.0, 1.0].map(at);
    Linear { placed, slope: moved - placed }
}

/// Switching functions of a link's phase: linear in u where they are lengths; `None` for a speed.
fn functions(world: &World, (number, slot): (usize, usize)) -> SmallVec<[Option<Linear>; 4]> {
    let track = &world.links[number];
    let (device, phase) = (&world.model.links[track.link].device, &track.phase);
    let function = |switch: usize| {
        let length = device.switch_unit(switch, phase) == SwitchUnit::Length;
        length.then(|| linear(world, (number, slot), |motion| device.switch(switch, phase, motion)))
    };
    (0..device.switches(phase)).map(function).collect()
}

/// Numbers of the functions that may rise through 0 in an interval without a kink.
fn may_rise(world: &World, slot: usize, functions: &[Option<Linear>], span: [f64; 2]) -> SmallVec<[usize; 4]> {
    let range = world.flight_range(slot, span);
    let rises = |function: &Option<Linear>| function.is_none_or(|linear| linear.most(range) >= 0.0);
    functions.iter().enumerate().filter_map(|(number, function)| rises(function).then_some(number)).collect()
}

/// The first rise of one of these switching functions within a stretch, and its number.
fn within(world: &World, number: usize, switches: &[usize], [from, to]: [f64; 2]) -> Option<(f64, usize)> {
    if switches.is_empty() {
        return None;
    }
    let track = &world.links[number];
    let link = &world.model.links[track.link];
    let times = sample_times::<STEP_SAMPLES>([from, to]);
    let motions = times.map(|t| motion(world, number, t));
    let mut found: Option<(f64, usize)> = None;
    for &switch in switches {
        let (zero, band) = zero_and_band(link, (switch, &track.phase), &motions, track.omega);
        let value = |motion: &Separation| link.device.switch(switch, &track.phase, motion) - band;
        let values: [f64; STEP_SAMPLES] = std::array::from_fn(|i| value(&motions[i]));
        let value_at = |t: f64| value(&motion(world, number, t));
        let rise = first_rise(
            [&times[..], &values[..]],
            Resolution { zero, rise: 0.0 },
            false,
            EarliestEvent::UNKNOWN,
            value_at,
        );
        if let Some(t) = rise.filter(|t| found.is_none_or(|(first, _)| *t < first)) {
            found = Some((t, switch));
        }
    }
    found
}
