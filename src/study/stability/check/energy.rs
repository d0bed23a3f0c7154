//! The energy ledger balances, and no contact makes energy.

use super::finding::{Check, Complaint, Figures};
use crate::scene::FrictionLaw;
use crate::sim::{History, Ledger};

pub(super) const LEDGER: &str = "the ledger's residual is below 100 tolerances, 1e-11 and 256 ε (of places over the \
                                 deepest penetration, and of weights lifted by a girder's size), of the largest energy \
                                 in play";
pub(super) const CREATES: &str = "what bearings, normal and tangential dashpots and jumps have lost never shrinks, nor, \
                                  under the paper's law, what contacts have lost altogether from one instant without \
                                  contact to a later one, by more than the ledger's bound";

/// Instants at which the ledger is read, evenly, and as many between touches.
const READINGS: usize = 40;

pub(super) fn check(history: &History, times: &[f64], figures: &mut Figures, complaints: &mut Vec<Complaint>) {
    let readings: Vec<(f64, Ledger)> = instants(history).into_iter().map(|t| (t, history.energy().ledger(t))).collect();
    let scale = readings.iter().map(|(_, l)| l.scale).fold(f64::MIN_POSITIVE, f64::max);
    let bound = history.energy().residual_bound(scale, times.iter().flat_map(|&t| history.contacts().at(t)));
    balance(&readings, scale, bound, figures, complaints);
    let open: Vec<(f64, Ledger)> =
        readings.iter().filter(|(t, _)| history.contacts().at(*t).is_empty()).copied().collect();
    let paper = history.model().pairs.iter().all(|pair| pair.contact.law == FrictionLaw::Paper);
    if let Some((shrunk, detail)) = shrinks(&readings, always, scale) {
        figures.creates = shrunk.max(0.0);
        if shrunk > bound {
            return complaints.push(Complaint::new(Check::Creates, detail));
        }
    }
    if let Some((shrunk, detail)) = shrinks(&open, between_touches, scale) {
        figures.gives_back = shrunk.max(0.0);
        if shrunk > bound && paper {
            complaints.push(Complaint::new(Check::Creates, detail));
        }
    }
}

/// Even instants, and instants between touches.
fn instants(history: &History) -> Vec<f64> {
    let end = history.end();
    let mut times: Vec<f64> = (0..=READINGS).map(|i| end * i as f64 / READINGS as f64).collect();
    let events = history.events();
    let partings: Vec<usize> = (0..events.len()).filter(|&i| events[i].kind.is_parting()).collect();
    for &i in partings.iter().step_by(partings.len().div_ceil(READINGS).max(1)) {
        times.push(f64::midpoint(events[i].t, events.get(i + 1).map_or(end, |e| e.t)));
    }
    times.sort_by(f64::total_cmp);
    times
}

fn balance(readings: &[(f64, Ledger)], scale: f64, bound: f64, figures: &mut Figures, complaints: &mut Vec<Complaint>) {
    for (t, ledger) in readings {
        let residual = ledger.residual.abs() / scale;
        figures.residual = figures.residual.max(residual);
        // A NaN is beyond every bound.
        if residual.is_nan() || residual > bound {
            let detail = format!("residual {residual:e} of the largest energy at t = {t} s, {bound:e} allowed");
            return complaints.push(Complaint::new(Check::Ledger, detail));
        }
    }
}

type Losses = Vec<(&'static str, f64)>;

/// Losses that only grow.
fn always(ledger: &Ledger) -> Losses {
    vec![
        ("the loss in bearings", ledger.loss_bearing),
        ("the loss in normal dashpots", ledger.loss_normal),
        ("the loss in tangential dashpots", ledger.loss_tangential),
        ("what breakaway released", ledger.jump_slip),
        ("what opening released", ledger.jump_open),
        ("what edges released", ledger.jump_edge),
    ]
}

/// Losses that only grow from one instant without contact to the next under the paper's law. Return mapping lets its anchor slide by the
/// spring's force alone, so where the tangential dashpot out-pulls the spring, towards the end of a touch, the anchor gives back, and with
/// little restitution it may give back more than friction took.
fn between_touches(ledger: &Ledger) -> Losses {
    let contacts = [
        ledger.loss_normal,
        ledger.loss_tangential,
        ledger.loss_friction,
        ledger.jump_slip,
        ledger.jump_open,
        ledger.jump_edge,
        ledger.jump_entry,
    ];
    vec![("what contacts have lost", contacts.iter().sum())]
}

/// The largest shrinking of a loss between two readings, in parts of the largest energy, and how to say it.
fn shrinks(readings: &[(f64, Ledger)], losses: fn(&Ledger) -> Losses, scale: f64) -> Option<(f64, String)> {
    let mut worst: Option<(f64, String)> = None;
    for pair in readings.windows(2) {
        for ((name, before), (_, after)) in losses(&pair[0].1).into_iter().zip(losses(&pair[1].1)) {
            let shrunk = (before - after) / scale;
            if worst.as_ref().is_none_or(|(most, _)| shrunk > *most) {
                let (from, to) = (pair[0].0, pair[1].0);
                let detail =
                    format!("{name} shrinks by {shrunk:e} of the largest energy between t = {from} s and {to} s");
                worst = Some((shrunk, detail));
            }
        }
    }
    worst
}
