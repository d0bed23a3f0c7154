//! The energy ledger balances, and no contact makes energy.

use super::{Check, Complaint, Figures};
use crate::sim::{History, Ledger};

pub(super) const LEDGER: &str = "the ledger's residual is below 100 tolerances and 1e-11 of the largest energy in play";
pub(super) const CREATES: &str = "what contacts and bearings have lost (dashpots, friction, jumps) never shrinks by more \
                                  than the ledger's bound";

/// Residual per tolerance.
const PER_TOLERANCE: f64 = 1e2;
/// Residual that rounding may leave.
const ROUNDING: f64 = 1e-11;
/// Instants at which the ledger is read.
const READINGS: usize = 40;

pub(super) fn check(history: &History, figures: &mut Figures, complaints: &mut Vec<Complaint>) {
    let bound = PER_TOLERANCE * history.model().tolerance + ROUNDING;
    let end = history.end();
    let readings: Vec<(f64, Ledger)> =
        (0..=READINGS).map(|i| end * i as f64 / READINGS as f64).map(|t| (t, history.ledger(t))).collect();
    let scale = readings.iter().map(|(_, l)| l.scale).fold(f64::MIN_POSITIVE, f64::max);
    for (t, ledger) in &readings {
        let residual = ledger.residual.abs() / scale;
        figures.residual = figures.residual.max(residual);
        // A NaN is beyond every bound.
        if residual.is_nan() || residual > bound {
            let detail = format!("residual {residual:e} of the largest energy at t = {t} s, {bound:e} allowed");
            return complaints.push(Complaint { check: Check::Ledger, detail });
        }
    }
    for pair in readings.windows(2) {
        for ((name, before), (_, after)) in losses(&pair[0].1).into_iter().zip(losses(&pair[1].1)) {
            let shrunk = (before - after) / scale;
            figures.creates = figures.creates.max(shrunk);
            if shrunk > bound {
                let (from, to) = (pair[0].0, pair[1].0);
                let detail =
                    format!("{name} shrinks by {shrunk:e} of the largest energy between t = {from} s and {to} s");
                return complaints.push(Complaint { check: Check::Creates, detail });
            }
        }
    }
}

/// Everything that only grows.
fn losses(ledger: &Ledger) -> [(&'static str, f64); 7] {
    [
        ("the loss in bearings", ledger.loss_bearing),
        ("the loss in normal dashpots", ledger.loss_normal),
        ("the loss in tangential dashpots", ledger.loss_tangential),
        ("the loss in friction", ledger.loss_friction),
        ("what breakaway released", ledger.jump_slip),
        ("what opening released", ledger.jump_open),
        ("what edges released", ledger.jump_edge),
    ]
}
