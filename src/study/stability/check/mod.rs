//! Checks of every result, of any scene, each with its own stated bound.

mod converge;
mod energy;
mod finding;
mod forces;
mod looks;
mod missed;
mod numbers;

use crate::sim::History;
use looks::looks;

pub use converge::convergence;
pub use finding::{Check, Complaint, Figures};

impl Check {
    /// Claim, with the bound.
    pub fn claim(self) -> &'static str {
        match self {
            Self::Panic => "nothing panics",
            Self::Time => "the runs of a seed end within the patience asked for",
            Self::Finishes => "the run reaches its duration: no work bound, no step too small to follow",
            Self::Numbers => numbers::CLAIM,
            Self::Ledger => energy::LEDGER,
            Self::Missed => missed::CLAIM,
            Self::Creates => energy::CREATES,
            Self::Cone => forces::CLAIM,
            Self::Converges => converge::CLAIM,
        }
    }
}

/// Puts every check of one answer.
pub fn answer(history: &History, figures: &mut Figures, complaints: &mut Vec<Complaint>) {
    let times = numbers(history, figures, complaints);
    if !complaints.is_empty() {
        return;
    }
    missed::check(history, &times, figures, complaints);
    forces::check(history, &times, figures, complaints);
    energy::check(history, &times, figures, complaints);
}

/// Puts the check of numbers, and counts; the times at which the answer was looked at.
pub fn numbers(history: &History, figures: &mut Figures, complaints: &mut Vec<Complaint>) -> Vec<f64> {
    let times = looks(history);
    numbers::check(history, &times, complaints);
    figures.events = history.events().len();
    figures.touches = history.events().iter().filter(|e| e.kind.is_touch()).count();
    times
}
