//! Events of a device on a body of one coordinate u in flight: the end of its phase, which is the first rise of one of its switching
//! functions through 0, and the beginning of its force, which is that of its gap with the opposite sign.
//!
//! Gap and switching functions that are lengths are linear in u, those that are speeds in u̇. The range of u in an interval of the record
//! shows whether a length can reach 0 at all; where it can, the flight is sampled stretch by stretch, as a step is.

use smallvec::SmallVec;

use crate::dynamics::closing::constants::{PHASE_END_SAMPLES, STEP_SAMPLES};
use crate::dynamics::closing::flight_view::remember;
use crate::dynamics::closing::found::NextClosing;
use crate::dynamics::connection::{Linearity, Separation, Switch, SwitchUnit};
use crate::dynamics::locate::advancement::FirstZero;
use crate::dynamics::locate::first_rise::{EarliestRise, Resolution, first_rise};
use crate::dynamics::locate::horizon::Horizon;
use crate::dynamics::locate::sample_times::sample_times;
use crate::dynamics::penalty3d::link_events::{SwitchRoundoff, length_roundoff, speed_roundoff};
use crate::dynamics::world::World;

/// A link in the group that acts between the ground and a body of one coordinate, in this slot.
#[derive(Clone, Copy, Debug)]
struct LinkOnBody {
    link: usize,
    slot: usize,
}

/// Searches the end of the phase of a link that acts on a body in flight, from `t` on, and enters it in the link's track.
pub(super) fn search(world: &mut World, link: usize, t: f64) -> NextClosing {
    let Some(slot) = world.links[link].slots[0].filter(|_| !world.is_linear_link(link)) else {
        return NextClosing::at(f64::INFINITY);
    };
    let at = LinkOnBody { link, slot };
    let functions = switching_functions(world, at, state(world, slot, t));
    first_of(world, at, &functions, t)
}

/// For a device that does not act, linear in the one coordinate of a body in flight: searches the beginning of its force and enters it in
/// the link's track; `None` for others.
pub(super) fn beginning(world: &mut World, link: usize, t: f64) -> Option<NextClosing> {
    let track = &world.links[link];
    let &[Some(slot), None] = &track.slots else { return None };
    let device = &world.model.links[track.link].device;
    let body = world.model_body(slot);
    if body.positions() != 1 || device.linearity(&track.phase) != Linearity::Whole {
        return None;
    }
    let of = (state(world, slot, t), SwitchUnit::Length);
    let at = LinkOnBody { link, slot };
    let gap = LinearSwitch::of(world, at, of, |motion| -device.gap(&track.phase, motion)[0]);
    Some(first_of(world, at, &[(Switch::Closing, gap)], t))
}

/// Searches the first rise of these functions from `t` on and enters it in the link's track.
fn first_of(world: &mut World, at: LinkOnBody, functions: &[(Switch, LinearSwitch)], t: f64) -> NextClosing {
    let LinkOnBody { link, slot } = at;
    let duration = world.model.duration;
    let until = Horizon { periods: 1.0, samples: PHASE_END_SAMPLES }.end(&world.model.ground, t, duration);
    remember(world, world.links[link].slots, until);
    let (mut from, mut evaluations) = (t, 0);
    while from < until {
        let kink = world.model.ground.next_kink(from).min(until);
        if may_rise(world, slot, functions, [from, kink]).is_empty() {
            from = kink;
            continue;
        }
        let to = world.window_end(slot, from).min(until);
        let likely = may_rise(world, slot, functions, [from, to]);
        evaluations += 1;
        if let Some((end, event)) = within(world, at, &likely, [from, to]) {
            world.links[link].ends = Some((end, event));
            return NextClosing::of(FirstZero::Crossing(end), duration, evaluations);
        }
        from = to;
    }
    NextClosing::of(FirstZero::NoneUntil(until), duration, evaluations)
}

/// A function of the one coordinate u of a body, or of its rate, from where that is at the beginning of a search: `start + slope (u − u₀)` \[m\]
/// or `start + slope (u̇ − u̇₀)` \[m/s\]. It rounds with the way from there, not with the distance of the body from where it was placed.
#[derive(Clone, Copy, Debug)]
struct LinearSwitch {
    unit: SwitchUnit,
    from: f64,
    start: f64,
    slope: f64,
}

impl LinearSwitch {
    /// A function of a link's motion that is linear in the coordinate of its body, or in its rate; a search begins in `state`.
    fn of(
        world: &World,
        LinkOnBody { link: number, slot }: LinkOnBody,
        ([u, rate], unit): ([f64; 2], SwitchUnit),
        value: impl Fn(&Separation) -> f64,
    ) -> Self {
        let link = world.model_link(number);
        let body = world.model_body(slot);
        let [_, ground] = link.frames(|_, _| None);
        let at = |state: [f64; 2]| value(&link.motion([&body.frame(0, &state), &ground]).0);
        let start = at([u, rate]);
        let (from, moved) = match unit {
            SwitchUnit::Length => (u, at([u + 1.0, rate])),
            SwitchUnit::Speed => (rate, at([u, rate + 1.0])),
        };
        Self { unit, from, start, slope: moved - start }
    }

    fn at(self, [u, rate]: [f64; 2]) -> f64 {
        let of = if self.unit == SwitchUnit::Length { u } else { rate };
        self.start + self.slope * (of - self.from)
    }

    /// Whether it may be 0 or more in a range of u.
    fn may_rise(self, [least, greatest]: [f64; 2]) -> bool {
        let farthest = if self.slope > 0.0 { greatest } else { least };
        self.unit == SwitchUnit::Speed || self.at([farthest, 0.0]) >= 0.0
    }
}

/// Displacement and rate of a body of one coordinate in flight.
fn state(world: &World, slot: usize, t: f64) -> [f64; 2] {
    world.coordinate(slot, t).unwrap_or([f64::NAN; 2])
}

/// Switching functions of a link's phase, in a search that begins in `state`.
fn switching_functions(world: &World, at: LinkOnBody, state: [f64; 2]) -> SmallVec<[(Switch, LinearSwitch); 4]> {
    let track = &world.links[at.link];
    let (device, phase) = (&world.model.links[track.link].device, &track.phase);
    let function = |switch: usize| {
        let value = |motion: &Separation| device.switch(switch, phase, motion);
        (Switch::Function(switch), LinearSwitch::of(world, at, (state, device.switch_unit(switch, phase)), value))
    };
    (0..device.switches(phase)).map(function).collect()
}

/// The functions that may rise through 0 in an interval without a kink.
fn may_rise(
    world: &World,
    slot: usize,
    functions: &[(Switch, LinearSwitch)],
    span: [f64; 2],
) -> SmallVec<[(Switch, LinearSwitch); 4]> {
    let range = world.flight_range(slot, span);
    functions.iter().filter(|(_, function)| function.may_rise(range)).copied().collect()
}

/// The first rise of one of these functions within a stretch, and its event.
fn within(
    world: &World,
    LinkOnBody { link: number, slot }: LinkOnBody,
    functions: &[(Switch, LinearSwitch)],
    [from, to]: [f64; 2],
) -> Option<(f64, Switch)> {
    if functions.is_empty() {
        return None;
    }
    let track = &world.links[number];
    let link = &world.model.links[track.link];
    let times = sample_times::<STEP_SAMPLES>([from, to]);
    let state_at = |t: f64| state(world, slot, t);
    let states = times.map(state_at);
    let most = |which: usize| states.iter().map(|state| state[which].abs()).fold(0.0, f64::max);
    let (moved, speed) = (most(0), most(1));
    let mut earliest = EarliestRise::none();
    for &(event, function) in functions {
        let length = |state: &[f64; 2]| function.at(*state).abs();
        let SwitchRoundoff { zero, band, noise } = match function.unit {
            SwitchUnit::Length => length_roundoff(link, moved, states.iter().map(length).fold(0.0, f64::max)),
            SwitchUnit::Speed => speed_roundoff(link, moved, speed, track.omega),
        };
        let values = states.map(|state| function.at(state) - band);
        let value_at = |t: f64| function.at(state_at(t)) - band;
        let resolution = Resolution { zero, rise: 0.0, noise };
        let rise = first_rise([&times[..], &values[..]], resolution, false, earliest.known(), value_at);
        earliest.offer(rise, event);
    }
    earliest.found()
}
