//! What is due within a planned step: zeros of the contacts' switching functions on the continuous answer.
//!
//! A step is short against everything that moves in it, so five looks see every sign change but a short excursion; that
//! is caught where three looks bend towards 0.

use crate::contact::parameters::outside;
use crate::contact::{Local, Mode, NormalLaw, locate};
use crate::dynamics::locate::first_rise::{EarliestEvent, first_rise};
use crate::dynamics::locate::root::root;
use crate::dynamics::penalty3d::constants::{
    CLOCK_ROUNDING, ENTRY_ROUNDING, FREE_RETRIES, PARTING_BAND, POSITION_ROUNDING, RETRY_DOUBLINGS, SAMPLES_EXPLICIT,
    SAMPLES_IMPLICIT, SHORT_PHASES, SPEED_ROUNDING_PHASE, WIDEST_STICK_BAND, ZERO_BAND,
};
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::penalty3d::due::{Due, Reason};
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::{ContactSite, Model};

/// A node against a face within an island's planned step.
pub(in crate::dynamics) fn look(model: &Model, island: &Island, number: usize, t: f64) -> Local {
    let active = &island.active[number];
    let site = &model.contacts[active.site];
    let own = model.sections(active.site);
    let frame =
        |side: Option<usize>, section: usize| side.map_or(site.stand, |i| island.frame_since(model, i, section, t));
    locate(&active.home, &frame(active.node, own[0]), &frame(active.face, own[1]))
}

/// The switching functions of a closed contact: each is negative while the state lasts.
pub(in crate::dynamics) fn function(
    model: &Model,
    island: &Island,
    number: usize,
    reason: Reason,
    here: &Local,
    t: f64,
) -> f64 {
    let active = &island.active[number];
    match reason {
        Reason::Opening => here.gap,
        Reason::Edge => {
            let site: &ContactSite = &model.contacts[active.site];
            outside(&site.face, here.at).max(here.penetration() - site.face.depth)
        }
        Reason::Switching | Reason::Kink => {
            // A copy only where the slip's direction has moved on.
            let turned = active.angle.map(|_| island.closed_at(number, t));
            let closed = turned.as_ref().unwrap_or(&active.closed);
            if reason == Reason::Switching {
                return closed.law.switch(&closed.mode, here) - eased(closed, here);
            }
            let pull = closed.pull(here);
            if closed.held_at_zero { -pull } else { pull }
        }
    }
}

pub(in crate::dynamics) fn reasons(island: &Island, number: usize) -> impl Iterator<Item = Reason> {
    let closed = &island.active[number].closed;
    // In line a spring along the face is never stretched: breakaway comes with the opening.
    let switches = closed.law.has_friction() && !island.is_in_line();
    let kinks = closed.law.has_kinks();
    [(Reason::Opening, true), (Reason::Switching, switches), (Reason::Edge, true), (Reason::Kink, kinks)]
        .into_iter()
        .filter_map(|(reason, wanted)| wanted.then_some(reason))
}

/// The first events within the planned step and when; contacts whose event comes within `together` of the first change
/// with it.
pub(in crate::dynamics) fn first_due(model: &Model, island: &Island, together: f64) -> Option<(f64, Vec<Due>)> {
    match sample_count(island) {
        SAMPLES_EXPLICIT => first_of::<SAMPLES_EXPLICIT>(model, island, together),
        SAMPLES_MEDIUM => first_of::<SAMPLES_MEDIUM>(model, island, together),
        _ => first_of::<SAMPLES_IMPLICIT>(model, island, together),
    }
}

/// Samples of an implicit step of middling length.
const SAMPLES_MEDIUM: usize = 2 * SAMPLES_EXPLICIT - 1;

/// Samples of switching functions within the planned step.
pub(in crate::dynamics) fn sample_count(island: &Island) -> usize {
    let phase = (island.until - island.from) * island.omega();
    if !island.pace().stiff || phase <= SHORT_PHASES[0] {
        SAMPLES_EXPLICIT
    } else if phase <= SHORT_PHASES[1] {
        SAMPLES_MEDIUM
    } else {
        SAMPLES_IMPLICIT
    }
}

fn first_of<const N: usize>(model: &Model, island: &Island, together: f64) -> Option<(f64, Vec<Due>)> {
    let (mut found, mut earliest): (Vec<(f64, Due)>, f64) = (Vec::new(), f64::INFINITY);
    let part = |i: usize| (island.until - island.from) * i as f64 / (N - 1) as f64;
    let times: [f64; N] = std::array::from_fn(|i| if i == N - 1 { island.until } else { island.from + part(i) });
    let (frames, sections) = (island.frames_since(model, &times), island.layout.section_count());
    for number in (0..island.active.len()).filter(|&number| island.first_like(number) == number) {
        let looks: [Local; N] = std::array::from_fn(|i| island.active[number].look(model, &frames[i * sections..]));
        for reason in reasons(island, number) {
            if reason == Reason::Edge && is_inside(model, island, number, &looks[0]) {
                continue;
            }
            let first = EarliestEvent { at: earliest, together };
            let hair = hair(model, island, number, reason, &looks[0]) + reluctance(island, number, reason, &looks);
            let values: [f64; N] =
                std::array::from_fn(|i| function(model, island, number, reason, &looks[i], times[i]) - hair);
            let ask = |t: f64| function(model, island, number, reason, &look(model, island, number, t), t) - hair;
            let passing = reason == Reason::Switching && island.active[number].closed.solver.passing_stop;
            let entering = is_entering(model, island, number, &looks[0]);
            let rounding = POSITION_ROUNDING * island.reach(model, number);
            let zero = match reason {
                _ if entering => f64::INFINITY,
                Reason::Switching if is_sticking(island, number) => {
                    ZERO_BAND * scale(island, number, reason, &looks) + rounding
                }
                _ => ZERO_BAND * scale(island, number, reason, &looks),
            };
            let first = if entering { EarliestEvent::UNKNOWN } else { first };
            if let Some(t) = first_rise([&times, &values], zero, passing, first, ask) {
                let t = if entering && reason == Reason::Opening { turned(model, island, number, t) } else { t };
                found.push((t, Due { number, reason }));
                earliest = earliest.min(t);
            }
        }
    }
    if found.is_empty() {
        return None;
    }
    let mut due: Vec<Due> = found.iter().filter(|(t, _)| *t <= earliest + together).map(|(_, due)| *due).collect();
    let like = |d: &Due| {
        let Due { number, reason } = *d;
        let others = (number + 1..island.active.len()).filter(move |&other| island.first_like(other) == number);
        others.map(move |number| Due { number, reason })
    };
    due.extend(due.iter().flat_map(like).collect::<Vec<_>>());
    also_due(model, island, earliest + together, &mut due);
    due.dedup_by_key(|d| d.number);
    Some((earliest, due))
}

/// Whether a node stays on its face for the whole step, however it moves.
fn is_inside(model: &Model, island: &Island, number: usize, here: &Local) -> bool {
    let active = &island.active[number];
    let arms = model.contacts[active.site].levers(here);
    let far = [active.node, active.face].into_iter().zip(arms);
    let far = far.map(|(side, arm)| side.map_or(0.0, |i| island.excursion(model, i, arm, island.from)));
    function(model, island, number, Reason::Edge, here, island.from) < -far.sum::<f64>()
}

/// How far sliding that began again and again at one instant may go back along itself: as fast as its anchor, eased, moves
/// across, where stick would have turned its stretch faster and broken away at once \[m/s\].
fn eased(closed: &ClosedContact, here: &Local) -> f64 {
    match closed.mode {
        Mode::Slip { direction } if closed.solver.regularisation > 0.0 && closed.solver.retries >= FREE_RETRIES => {
            let length = closed.law.slip_stretch(here);
            direction.perp_dot(here.rate).abs() * closed.solver.regularisation / (length + closed.solver.regularisation)
        }
        _ => 0.0,
    }
}

/// What sliding must be past its end by to end once more at the instant at which it began again and again: neither state
/// lasts there (the two differ by an eased direction, or by rounding), and each time it takes more.
fn reluctance(island: &Island, number: usize, reason: Reason, looks: &[Local]) -> f64 {
    let again = island.active[number].closed.solver.retries;
    if again < FREE_RETRIES || reason != Reason::Switching || is_sticking(island, number) {
        return 0.0;
    }
    ZERO_BAND * scale(island, number, reason, looks) * f64::from((again - FREE_RETRIES).min(RETRY_DOUBLINGS)).exp2()
}

/// A node that comes in by less than its rounding goes out where it turns round: not before, or it would come in again.
fn turned(model: &Model, island: &Island, number: usize, t: f64) -> f64 {
    let rate = |t: f64| look(model, island, number, t).gap_rate;
    if rate(t) < 0.0 && rate(island.until) > 0.0 { root(rate, t, island.until) } else { t }
}

fn is_sticking(island: &Island, number: usize) -> bool {
    matches!(island.active[number].closed.mode, Mode::Stick { .. })
}

/// How deep a node that has only just touched may be \[m\].
fn entry(model: &Model, island: &Island, number: usize, here: &Local) -> f64 {
    ENTRY_ROUNDING * island.reach(model, number) + CLOCK_ROUNDING * island.from * here.gap_rate.abs()
}

/// Whether a node is within rounding of its face and, at its speed, stays there for a radian.
pub(in crate::dynamics) fn is_at_face(model: &Model, island: &Island, number: usize, here: &Local) -> bool {
    let entry = entry(model, island, number, here);
    here.gap > -entry && here.gap_rate > -entry * island.omega()
}

/// Whether a node has just come through the face: its gap is rounding of either sign, and so are its forces.
fn is_entering(model: &Model, island: &Island, number: usize, here: &Local) -> bool {
    here.gap_rate < 0.0 && here.gap > -entry(model, island, number, here)
}

/// What a switching function must exceed: a stretch that breaks away again and again its rounding; all of them, where the
/// node is hardly in and at rest, what its gap, its stretch and their rates come to, which is rounding of either sign.
fn hair(model: &Model, island: &Island, number: usize, reason: Reason, here: &Local) -> f64 {
    let closed = &island.active[number].closed;
    let entry = entry(model, island, number, here);
    if here.gap <= -entry {
        let rounding = POSITION_ROUNDING * island.reach(model, number);
        return match reason {
            // A stretch that goes along the edge of its cone, as where both decay at one rate, crosses it with every bit.
            Reason::Switching if is_sticking(island, number) && closed.solver.retries >= FREE_RETRIES => {
                let times = f64::from((closed.solver.retries - FREE_RETRIES).min(RETRY_DOUBLINGS)).exp2();
                (times * rounding).min(rounding.max(WIDEST_STICK_BAND * closed.law.mu_s * closed.law.length(here)))
            }
            // And a force that stays near 0 crosses that; it is continuous there.
            Reason::Kink => closed.law.normal.change_scale(here.penetration(), rounding, 0.0),
            _ => 0.0,
        };
    }
    // A node that comes out slowly must not be held by more than its rounding.
    // One that goes in has crossed within rounding, be it before the face still.
    let length = if here.gap_rate < 0.0 { entry.max(2.0 * here.gap) } else { PARTING_BAND * entry };
    match (reason, &closed.mode) {
        (Reason::Edge, _) => 0.0,
        (Reason::Opening, _) | (Reason::Switching, Mode::Stick { .. }) => length,
        // Over a long implicit step a speed is as good as its places over that.
        (Reason::Switching, Mode::Slip { .. }) => {
            length * island.omega().min(SPEED_ROUNDING_PHASE / (island.until - island.from))
        }
        (Reason::Kink, _) => closed.law.normal.change_scale(here.penetration(), length, island.omega()),
    }
}

/// Contacts in the same state whose same event lies within rounding of the first, just beyond the end of the step.
fn also_due(model: &Model, island: &Island, t: f64, due: &mut Vec<Due>) {
    if t <= island.until {
        due.sort_by_key(|d| (d.number, d.reason));
        return;
    }
    let reasons_due: Vec<Reason> = due.iter().map(|d| d.reason).collect();
    for number in 0..island.active.len() {
        for &reason in &reasons_due {
            let known = due.iter().any(|d| d.number == number);
            if !known && function(model, island, number, reason, &look(model, island, number, t), t) > 0.0 {
                due.push(Due { number, reason });
            }
        }
    }
    due.sort_by_key(|d| (d.number, d.reason));
}

/// Size of a switching function's values, to tell the zero that an event left from a value.
fn scale(island: &Island, number: usize, reason: Reason, looks: &[Local]) -> f64 {
    let closed = &island.active[number].closed;
    let largest = |f: fn(&Local) -> f64| looks.iter().map(f).fold(0.0, f64::max);
    let depth = largest(|l| l.gap.abs());
    let speed = largest(|l| l.gap_rate.abs() + l.rate.length());
    match (reason, &closed.mode) {
        (Reason::Opening, _) => depth,
        (Reason::Switching, Mode::Stick { .. }) => closed.law.mu_s * closed.law.normal.length(depth, closed.law.k_t),
        (Reason::Switching, Mode::Slip { .. }) => speed,
        (Reason::Edge, _) => 0.0,
        (Reason::Kink, _) => closed.law.normal.force_scale(depth, speed),
    }
}

#[cfg(test)]
mod tests;
