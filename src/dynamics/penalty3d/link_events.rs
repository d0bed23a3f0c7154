//! Ends of phases of devices within a planned step: zeros of their switching functions on the dense output.

use smallvec::SmallVec;

use crate::dynamics::Model;
use crate::dynamics::connection::{Excursion, Kinematics, Link, Phase, Separation, SwitchUnit};
use crate::dynamics::locate::first_rise::{EarliestRise, Resolution, first_rise};
use crate::dynamics::locate::sample_times::sample_time;
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::penalty3d::constants::{POSITION_ROUNDING, ZERO_BAND};
use crate::dynamics::penalty3d::due::LinkDue;
use crate::dynamics::penalty3d::event_location::sample_count;
use crate::dynamics::penalty3d::island::Island;

/// The first end of a phase of the island's devices within its planned step, and its time \[s\]; `None` without one.
pub(in crate::dynamics) fn first_phase_end(model: &Model, island: &Island) -> Option<(f64, LinkDue)> {
    if island.system.links.iter().all(|active| active.link(model).device.switches(&active.phase) == 0) {
        return None;
    }
    let sections = island.system.layout.section_count();
    // The start; further samples once a phase may end.
    let mut times: SmallVec<[f64; 8]> = SmallVec::from_slice(&[island.step.from]);
    let mut frames = island.frames_since(model, &times);
    let mut earliest = EarliestRise::none();
    for (index, active) in island.system.links.iter().enumerate() {
        let link = active.link(model);
        let begins = active.motion(model, &island.system.bases, &frames).0;
        let within = excursion(model, island, active);
        let phase = island.phase_at(index, island.step.from);
        let likely = |number: &usize| !link.device.stays_below(*number, &phase, &begins, within);
        let likely: SmallVec<[usize; 4]> = (0..link.device.switches(&active.phase)).filter(likely).collect();
        if likely.is_empty() {
            continue;
        }
        if times.len() == 1 {
            let (interval, count) = ([island.step.from, island.step.until], sample_count(island));
            times.extend((1..count).map(|i| sample_time(interval, i, count)));
            frames.extend(island.frames_since(model, &times[1..]));
        }
        let motions: Vec<_> =
            frames.chunks_exact(sections).map(|f| active.motion(model, &island.system.bases, f).0).collect();
        for number in likely {
            let SwitchRoundoff { zero, band, noise } =
                switch_roundoff(link, (number, &active.phase), &motions, island.omega());
            let switch =
                |motion: &Separation, t: f64| link.device.switch(number, &island.phase_at(index, t), motion) - band;
            let values: Vec<f64> = motions.iter().zip(&times).map(|(motion, &t)| switch(motion, t)).collect();
            let value_at = |t: f64| {
                let frames = island.frames_since(model, &[t]);
                switch(&active.motion(model, &island.system.bases, &frames).0, t)
            };
            let rise = match link.device.switch_unit(number, &active.phase) {
                SwitchUnit::Length => island.step.allowed.displacement,
                SwitchUnit::Speed => island.step.allowed.speed,
            };
            let resolution = Resolution { zero, rise, noise };
            let rise = first_rise([&times, &values], resolution, false, earliest.known(), value_at);
            earliest.offer(rise, LinkDue { index, switch: number });
        }
    }
    earliest.found()
}

/// Bounds on the change, within the planned step, of displacement and rate of a link's first point relative to the second, in the link's
/// axes; infinite where these turn.
fn excursion(model: &Model, island: &Island, active: &ActiveLink) -> Excursion {
    let link = active.link(model);
    if link.kinematics == Kinematics::Carried && active.ends[1].is_some() {
        return Excursion { way: f64::INFINITY, rate: f64::INFINITY };
    }
    let mut within = Excursion { way: 0.0, rate: 0.0 };
    for (end, arm) in active.ends.into_iter().zip(link.arms) {
        let (Some(body), arm) = (end, arm.length()) else { continue };
        let bounds = island.bound(model, body);
        within.way += island.excursion(model, body, arm, island.step.from);
        // Of a point at this arm: G's, tangential, towards the axis.
        let acceleration = bounds.acceleration + arm * bounds.acceleration_per_arm();
        within.rate += acceleration * (island.step.until - island.step.from);
    }
    within
}

/// Round-off of a switching function, in its unit \[m or m/s\].
pub(in crate::dynamics) struct SwitchRoundoff {
    /// Value up to which the function is at 0 at the start of a stretch.
    pub zero: f64,
    /// Value that is taken off the function: a phase that begins at a zero of the next one's function, with its rate 0 as well, is
    /// not ended by round-off.
    pub band: f64,
    /// Value that round-off alone may give.
    pub noise: f64,
}

/// Round-off of a switching function of a phase over a stretch with these motions. `omega` is the fastest circular frequency \[rad/s\].
pub(in crate::dynamics) fn switch_roundoff(
    link: &Link,
    (number, phase): (usize, &Phase),
    motions: &[Separation],
    omega: f64,
) -> SwitchRoundoff {
    let size = |of: &dyn Fn(&Separation) -> f64| motions.iter().map(of).fold(0.0, f64::max);
    // Places round with what has moved, too.
    let moved = size(&|m| m.moved.length());
    match link.device.switch_unit(number, phase) {
        SwitchUnit::Length => length_roundoff(link, moved, size(&|m| link.device.gap(phase, m)[0].abs())),
        SwitchUnit::Speed => speed_roundoff(link, moved, size(&|m| m.rate.length()), omega),
    }
}

/// Of a length, where the link's points are displaced by up to `moved` and its gap is up to `length` \[m\].
pub(in crate::dynamics) fn length_roundoff(link: &Link, moved: f64, length: f64) -> SwitchRoundoff {
    let band = POSITION_ROUNDING * (link.size() + moved + length);
    SwitchRoundoff { zero: ZERO_BAND * length + band, band, noise: band }
}

/// Of a speed, where they are displaced by up to `moved` \[m\] at up to `speed` \[m/s\].
pub(in crate::dynamics) fn speed_roundoff(link: &Link, moved: f64, speed: f64, omega: f64) -> SwitchRoundoff {
    let rounding = POSITION_ROUNDING * (link.size() + moved) * omega;
    SwitchRoundoff { zero: ZERO_BAND * speed + rounding, band: 0.0, noise: rounding }
}
