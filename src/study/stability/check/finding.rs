//! The checks by name, a check that failed, and what was measured on the way.

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
}

/// A check that failed, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Complaint {
    /// Which.
    pub check: Check,
    /// When, who, by how much.
    pub detail: String,
    /// The tolerance of the run that failed, where it was not the scene's.
    pub tolerance: Option<f64>,
}

impl Complaint {
    /// Of a run at the scene's own tolerance.
    pub fn new(check: Check, detail: String) -> Self {
        Self { check, detail, tolerance: None }
    }
}

/// Measured values; 0 where a check was not reached.
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
    /// Largest decrease of a sum of all contact losses between two instants without contact, of the largest energy in play \[–\]; return
    /// mapping may give back.
    pub gives_back: f64,
    /// Error at the scene's tolerance \[m\].
    pub error: f64,
    /// Error at a hundredth of it \[m\].
    pub finer_error: f64,
    /// Time up to which the two runs are comparable \[s\].
    pub trusted: f64,
}
