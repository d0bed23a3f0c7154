//! Location of the first event of closed contacts within a planned step: zeros of their switching functions on the
//! dense output.
//!
//! Five samples show every sign change within an explicit step, which is short against all motions in it, and nine or seventeen within
//! an implicit one, except a short excursion; three samples whose second difference points to 0 show that.

use crate::contact::{Frame, Local, Mode, locate};
use crate::dynamics::Model;
use crate::dynamics::locate::first_rise::{EarliestEvent, Resolution, first_rise};
use crate::dynamics::locate::root::root;
use crate::dynamics::locate::sample_times::sample_times;
use crate::dynamics::penalty3d::carried_overlap::MetContacts;
use crate::dynamics::penalty3d::constants::{
    CLOCK_ROUNDING, ENTRY_ROUNDING, FREE_RETRIES, PARTING_BAND, POSITION_ROUNDING, RETRY_DOUBLINGS, SAMPLES_EXPLICIT,
    SAMPLES_IMPLICIT, SAMPLES_MEDIUM, SHORT_PHASES, SPEED_ROUNDING_PHASE, ZERO_BAND,
};
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::penalty3d::due::{Due, Reason};
use crate::dynamics::penalty3d::island::Island;

/// Position and velocity of a node relative to its face at `t` within an island's planned step.
pub(in crate::dynamics) fn local_at(model: &Model, island: &Island, number: usize, t: f64) -> Local {
    let active = &island.system.active[number];
    let site = &model.sites[active.site];
    let own = model.sections(active.site);
    let frame =
        |side: Option<usize>, section: usize| side.map_or(site.stand, |i| island.frame_since(model, i, section, t));
    locate(&active.geometry, &frame(active.ends[0], own[0]), &frame(active.ends[1], own[1]))
}

/// Switching function of a closed contact at `t`, negative while the state lasts (`docs/physics.md#contact-events`).
pub(in crate::dynamics) fn switching_function(
    model: &Model,
    island: &Island,
    number: usize,
    reason: Reason,
    here: &Local,
    t: f64,
) -> f64 {
    let active = &island.system.active[number];
    match reason {
        Reason::Opening => here.gap,
        Reason::Edge => {
            let (site, solver) = (&model.sites[active.site], &active.closed.solver);
            match solver.handover_distance {
                Some(beyond) => site.over_edge(here) - beyond,
                None => site.beyond(&active.closed.place, here) - solver.kept_beyond_edge,
            }
        }
        Reason::Switching | Reason::Kink => {
            // A slip direction that turns is taken at `t`.
            let turned = active.angle.map(|_| island.closed_at(number, t));
            let closed = turned.as_ref().unwrap_or(&active.closed);
            if reason == Reason::Switching {
                return closed.law.switch(&closed.mode, here) - regularisation_creep(closed, here);
            }
            closed.kink(here)
        }
        // Of all contacts between the two bodies, not of one.
        Reason::Overlap => f64::NEG_INFINITY,
    }
}

pub(in crate::dynamics) fn reasons(island: &Island, number: usize) -> impl Iterator<Item = Reason> {
    let closed = &island.system.active[number].closed;
    let switches = closed.law.has_friction() && island.kind.can_slide();
    let kinks = closed.law.has_kinks();
    [(Reason::Opening, true), (Reason::Switching, switches), (Reason::Edge, true), (Reason::Kink, kinks)]
        .into_iter()
        .filter_map(|(reason, wanted)| wanted.then_some(reason))
}

/// The first events within the planned step and their time \[s\]. Contacts whose event lies within `simultaneity`
/// \[s\] of the first change state with it.
pub(in crate::dynamics) fn first_contact_events(
    model: &Model,
    island: &Island,
    simultaneity: f64,
) -> Option<(f64, Vec<Due>)> {
    match sample_count(island) {
        SAMPLES_EXPLICIT => first_among::<SAMPLES_EXPLICIT>(model, island, simultaneity),
        SAMPLES_MEDIUM => first_among::<SAMPLES_MEDIUM>(model, island, simultaneity),
        _ => first_among::<SAMPLES_IMPLICIT>(model, island, simultaneity),
    }
}

/// Number of samples of the switching functions within the planned step.
pub(in crate::dynamics) fn sample_count(island: &Island) -> usize {
    let phase = (island.step.until - island.step.from) * island.omega();
    if !island.stepper.controller_state().stiff || phase <= SHORT_PHASES[0] {
        SAMPLES_EXPLICIT
    } else if phase <= SHORT_PHASES[1] {
        SAMPLES_MEDIUM
    } else {
        SAMPLES_IMPLICIT
    }
}

fn first_among<const N: usize>(model: &Model, island: &Island, simultaneity: f64) -> Option<(f64, Vec<Due>)> {
    let (mut found, mut earliest): (Vec<(f64, Due)>, f64) = (Vec::new(), f64::INFINITY);
    let times = sample_times::<N>([island.step.from, island.step.until]);
    let (frames, sections) = (island.frames_since(model, &times), island.system.layout.section_count());
    for number in island.kind.distinct(island.system.active.len()) {
        let samples: [Local; N] =
            std::array::from_fn(|i| island.system.active[number].look(model, &frames[i * sections..]));
        for reason in reasons(island, number) {
            let first = EarliestEvent { at: earliest, together: simultaneity };
            let due = Due { index: number, reason };
            if let Some(t) = contact_event(model, island, due, (&times, &samples), first) {
                found.push((t, due));
                earliest = earliest.min(t);
            }
        }
    }
    for met in &island.system.met {
        let first = EarliestEvent { at: earliest, together: simultaneity };
        if let Some((t, due)) = uncarried_overlap(model, island, met, (&times, &frames), first) {
            found.push((t, due));
            earliest = earliest.min(t);
        }
    }
    if found.is_empty() {
        return None;
    }
    let mut due: Vec<Due> = found.iter().filter(|(t, _)| *t <= earliest + simultaneity).map(|(_, due)| *due).collect();
    let like = |d: &Due| {
        let Due { index: number, reason } = *d;
        island.kind.represented_by(number, island.system.active.len()).map(move |number| Due { index: number, reason })
    };
    due.extend(due.iter().flat_map(like).collect::<Vec<_>>());
    also_due(model, island, earliest + simultaneity, &mut due);
    due.dedup_by_key(|d| d.index);
    Some((earliest, due))
}

/// Time of the first event of this kind of a contact, from its samples \[s\]; of those later than the first of all events only what is due
/// with it.
fn contact_event<const N: usize>(
    model: &Model,
    island: &Island,
    Due { index: number, reason }: Due,
    (times, samples): (&[f64; N], &[Local; N]),
    first: EarliestEvent,
) -> Option<f64> {
    if reason == Reason::Edge && is_inside(model, island, number, &samples[0]) {
        return None;
    }
    let band = dead_band(model, island, number, reason, &samples[0]) + retry_band(island, number, reason, samples);
    let values: [f64; N] =
        std::array::from_fn(|i| switching_function(model, island, number, reason, &samples[i], times[i]) - band);
    let value_at =
        |t: f64| switching_function(model, island, number, reason, &local_at(model, island, number, t), t) - band;
    let passing = reason == Reason::Switching && island.system.active[number].closed.solver.passing_stop;
    let entering = is_entering(model, island, number, &samples[0]);
    let zero = match reason {
        _ if entering => f64::INFINITY,
        Reason::Switching if is_sticking(island, number) => {
            let rounding = POSITION_ROUNDING * island.budget.reach(model, &island.system.active[number]);
            ZERO_BAND * switching_scale(island, number, reason, samples) + rounding
        }
        _ => ZERO_BAND * switching_scale(island, number, reason, samples),
    };
    let first = if entering { EarliestEvent::UNKNOWN } else { first };
    let t = first_rise([times, &values], Resolution::at_start(zero), passing, first, value_at)?;
    Some(if entering && reason == Reason::Opening { reversal(model, island, number, t) } else { t })
}

/// Time at which the overlap of two bodies that have met first exceeds what their deepest contact carries \[s\], and that contact.
fn uncarried_overlap<const N: usize>(
    model: &Model,
    island: &Island,
    met: &MetContacts,
    (times, frames): (&[f64; N], &[Frame]),
    first: EarliestEvent,
) -> Option<(f64, Due)> {
    let sections = island.system.layout.section_count();
    let at = |i: usize| island.system.at(&frames[i * sections..]);
    if (0..N).all(|i| met.is_carried(model, at(i))) {
        return None;
    }
    let excess_at = |t: f64| met.excess(model, island.system.at(&island.frames_since(model, &[t])));
    let values: [f64; N] = std::array::from_fn(|i| met.excess(model, at(i)).value);
    let t = first_rise([times, &values], Resolution::at_start(0.0), false, first, |t| excess_at(t).value)?;
    Some((t, Due { index: excess_at(t).deepest, reason: Reason::Overlap }))
}

/// Whether a node stays inside its polygon for the whole step, by bounds on the excursions of both bodies.
fn is_inside(model: &Model, island: &Island, number: usize, here: &Local) -> bool {
    let active = &island.system.active[number];
    let arms = model.sites[active.site].levers(here);
    let excursions = active.ends.into_iter().zip(arms);
    let excursions =
        excursions.map(|(side, arm)| side.map_or(0.0, |i| island.excursion(model, i, arm, island.step.from)));
    switching_function(model, island, number, Reason::Edge, here, island.step.from) < -excursions.sum::<f64>()
}

/// Correction of the switching function of a slip that has begun [`FREE_RETRIES`] times at one instant \[m/s\]: the
/// regularised anchor lags behind the turning direction by this rate. In stick the stretch would turn without lag and
/// break away at once, so that the slip ends only where its switching function exceeds this rate.
fn regularisation_creep(closed: &ClosedContact, here: &Local) -> f64 {
    match closed.mode {
        Mode::Slip { direction } if closed.solver.regularisation > 0.0 && closed.solver.retries >= FREE_RETRIES => {
            let length = closed.law.slip_stretch(here);
            direction.perp_dot(here.rate).abs() * closed.solver.regularisation / (length + closed.solver.regularisation)
        }
        _ => 0.0,
    }
}

/// Dead band added to a stop that has followed a breakaway [`FREE_RETRIES`] times at one instant, in units of the
/// switching function: [`ZERO_BAND`] of its scale, doubled with each retry. Stick and slip then exclude each other by
/// less than the regularisation or round-off.
fn retry_band(island: &Island, number: usize, reason: Reason, samples: &[Local]) -> f64 {
    let retries = island.system.active[number].closed.solver.retries;
    if retries < FREE_RETRIES || reason != Reason::Switching || is_sticking(island, number) {
        return 0.0;
    }
    ZERO_BAND
        * switching_scale(island, number, reason, samples)
        * f64::from((retries - FREE_RETRIES).min(RETRY_DOUBLINGS)).exp2()
}

/// Opening of a node that enters by less than round-off, from its crossing at `t`: at the reversal of its gap's rate,
/// since an earlier opening would be followed by a closing at once.
fn reversal(model: &Model, island: &Island, number: usize, t: f64) -> f64 {
    let rate = |t: f64| local_at(model, island, number, t).gap_rate;
    if rate(t) < 0.0 && rate(island.step.until) > 0.0 { root(rate, t, island.step.until) } else { t }
}

fn is_sticking(island: &Island, number: usize) -> bool {
    matches!(island.system.active[number].closed.mode, Mode::Stick { .. })
}

/// Largest penetration of a node that counts as being at its face \[m\], from round-off of position and of the time
/// of entry.
fn entry_depth(model: &Model, island: &Island, number: usize, here: &Local) -> f64 {
    ENTRY_ROUNDING * island.budget.reach(model, &island.system.active[number])
        + CLOCK_ROUNDING * island.step.from * here.gap_rate.abs()
}

/// Whether a node has just entered: gap and forces are round-off of either sign.
fn is_entering(model: &Model, island: &Island, number: usize, here: &Local) -> bool {
    here.gap_rate < 0.0 && here.gap > -entry_depth(model, island, number, here)
}

/// Dead band of a switching function, in its unit: behind the face that of the kink of the normal force; at the face the round-off of
/// gap, stretch and their rates, whose signs are undetermined.
fn dead_band(model: &Model, island: &Island, number: usize, reason: Reason, here: &Local) -> f64 {
    let closed = &island.system.active[number].closed;
    let entry = entry_depth(model, island, number, here);
    if here.gap <= -entry {
        let rounding = POSITION_ROUNDING * island.budget.reach(model, &island.system.active[number]);
        return match reason {
            // A normal force that stays near 0 crosses 0 with each round-off of position. The force is continuous there: a change of
            // state that is late by the dead band changes the force by its round-off alone.
            Reason::Kink if closed.law.normal.has_phases() => closed.law.kink_change(here, rounding, island.omega()),
            Reason::Kink => closed.law.kink_change(here, rounding, 0.0),
            _ => 0.0,
        };
    }
    // An entering node has crossed within round-off, in front of the face or behind. One that moves out opens within
    // a tenth of it.
    let length = if here.gap_rate < 0.0 { entry.max(2.0 * here.gap) } else { PARTING_BAND * entry };
    match (reason, &closed.mode) {
        (Reason::Edge | Reason::Overlap, _) => 0.0,
        (Reason::Opening, _) | (Reason::Switching, Mode::Stick { .. }) => length,
        // Over a long implicit step the round-off of a speed is that of positions over the length of the step.
        (Reason::Switching, Mode::Slip { .. }) => {
            length * island.omega().min(SPEED_ROUNDING_PHASE / (island.step.until - island.step.from))
        }
        (Reason::Kink, _) => closed.law.kink_change(here, length, island.omega()),
    }
}

/// Adds events of the kinds that are due, of other contacts up to `t`, where that is beyond the end of the step.
fn also_due(model: &Model, island: &Island, t: f64, due: &mut Vec<Due>) {
    if t <= island.step.until {
        due.sort_by_key(|d| (d.index, d.reason));
        return;
    }
    let reasons_due: Vec<Reason> = due.iter().map(|d| d.reason).collect();
    for number in 0..island.system.active.len() {
        for &reason in &reasons_due {
            let known = due.iter().any(|d| d.index == number);
            if !known && switching_function(model, island, number, reason, &local_at(model, island, number, t), t) > 0.0
            {
                due.push(Due { index: number, reason });
            }
        }
    }
    due.sort_by_key(|d| (d.index, d.reason));
}

/// Scale of a switching function over its samples, in its unit: rounding of it is the zero that the last event left, and no value.
fn switching_scale(island: &Island, number: usize, reason: Reason, samples: &[Local]) -> f64 {
    let closed = &island.system.active[number].closed;
    let largest = |f: fn(&Local) -> f64| samples.iter().map(f).fold(0.0, f64::max);
    let depth = largest(|l| l.gap.abs());
    let speed = largest(|l| l.gap_rate.abs() + l.rate.length());
    match (reason, &closed.mode) {
        (Reason::Opening, _) => depth,
        (Reason::Switching, Mode::Stick { .. }) => closed.law.stick_scale(depth),
        (Reason::Switching, Mode::Slip { .. }) => speed,
        (Reason::Edge | Reason::Overlap, _) => 0.0,
        (Reason::Kink, _) => closed.law.kink_scale(depth, speed),
    }
}

#[cfg(test)]
mod tests;
