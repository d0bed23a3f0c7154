//! What must hold for every answer, whatever the scene: each check with its own stated bound.

mod converge;
mod energy;
mod forces;
mod missed;
mod numbers;

use crate::sim::History;

pub use converge::convergence;

/// A property that every answer has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Check {
    /// Nothing panics.
    Panic,
    /// The run ends within the study's patience.
    Time,
    /// The run reaches its duration: no work bound, no step too small.
    Finishes,
    /// Every number is finite; held directions stay at 0, attitudes are rotations.
    Numbers,
    /// The energy ledger balances.
    Ledger,
    /// No node is behind a face, inside its polygon, without a closed contact.
    Missed,
    /// No contact gives energy back that it has lost: every loss only grows.
    Creates,
    /// Friction lies in its cone, in stick and in slip.
    Cone,
    /// The error at a hundredth of the tolerance is below the error at it.
    Converges,
}

impl Check {
    /// All of them, in the order of the report.
    pub const ALL: [Self; 9] = [
        Self::Panic,
        Self::Time,
        Self::Finishes,
        Self::Numbers,
        Self::Ledger,
        Self::Missed,
        Self::Creates,
        Self::Cone,
        Self::Converges,
    ];

    /// The word used in tables.
    pub fn label(self) -> &'static str {
        match self {
            Self::Panic => "panic",
            Self::Time => "time",
            Self::Finishes => "finishes",
            Self::Numbers => "numbers",
            Self::Ledger => "ledger",
            Self::Missed => "missed",
            Self::Creates => "creates",
            Self::Cone => "cone",
            Self::Converges => "converges",
        }
    }

    /// What is claimed, with the bound.
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

/// A check that failed, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Complaint {
    /// Which.
    pub check: Check,
    /// When, who, by how much.
    pub detail: String,
}

/// What was measured on the way; 0 where a check was not reached.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Figures {
    /// Touches of single contacts.
    pub touches: usize,
    /// Events of single contacts.
    pub events: usize,
    /// |residual| of the ledger, of the largest energy in play.
    pub residual: f64,
    /// Deepest penetration without a closed contact \[m\].
    pub missed: f64,
    /// Friction beyond its cone, of the peak normal force.
    pub cone: f64,
    /// Largest shrinking of a loss, of the largest energy in play.
    pub creates: f64,
    /// The same of all that contacts lost between two instants without contact; return mapping may give back.
    pub gives_back: f64,
    /// Error at the scene's tolerance \[m\].
    pub error: f64,
    /// Error at a hundredth of it \[m\].
    pub finer_error: f64,
    /// How far the comparison of the two means anything \[s\].
    pub trusted: f64,
}

/// Puts every check of one answer.
pub fn answer(history: &History, figures: &mut Figures, complaints: &mut Vec<Complaint>) {
    let times = looks(history);
    numbers::check(history, &times, complaints);
    if !complaints.is_empty() {
        return;
    }
    figures.events = history.events().len();
    figures.touches = history.events().iter().filter(|e| e.kind.is_touch()).count();
    missed::check(history, &times, figures, complaints);
    forces::check(history, &times, figures, complaints);
    energy::check(history, &times, figures, complaints);
}

/// Looks at even distances over a run.
const EVEN: usize = 500;
/// Events around which it is looked, spread over all of them where there are more.
const EVENTS: usize = 400;

/// Times at which an answer is looked at: even ones, and just before, at and half-way to the next of its events.
fn looks(history: &History) -> Vec<f64> {
    let end = history.end();
    let mut times: Vec<f64> = (0..=EVEN).map(|i| end * i as f64 / EVEN as f64).collect();
    let events = history.events();
    let stride = events.len().div_ceil(EVENTS).max(1);
    for (i, event) in events.iter().enumerate().step_by(stride) {
        let next = events.get(i + 1).map_or(end, |e| e.t);
        times.extend([event.t * (1.0 - 1e-12), event.t, f64::midpoint(event.t, next)]);
    }
    times.retain(|t| (0.0..=end).contains(t));
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// Length of the largest girder \[m\].
fn size(history: &History) -> f64 {
    history.model().bodies.iter().map(|body| body.radius).fold(0.0, f64::max)
}
