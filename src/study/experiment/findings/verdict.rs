//! Whether a finding comes out: a list of checks, each with its number and the rule that decides it.

/// Agreement of a finding with a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Every check holds.
    ComesOut,
    /// Some hold.
    InPart,
    /// None holds.
    DoesNot,
    /// Runs that it needs were not made.
    Open,
}

impl Outcome {
    /// In words.
    pub fn label(self) -> &'static str {
        match self {
            Self::ComesOut => "comes out",
            Self::InPart => "in part",
            Self::DoesNot => "does not",
            Self::Open => "not run",
        }
    }
}

/// A statement about runs that can be decided.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Claim, with the limit that decides it.
    pub claim: String,
    /// Value found, with unit.
    pub found: String,
    /// Whether it holds.
    pub holds: bool,
}

impl Check {
    /// Of these three.
    pub fn new(claim: impl Into<String>, found: impl Into<String>, holds: bool) -> Self {
        Self { claim: claim.into(), found: found.into(), holds }
    }
}

/// The checks of a finding under one model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// In the order of the finding's words; none where runs are missing.
    pub checks: Vec<Check>,
}

impl Verdict {
    /// Outcome of all checks.
    pub fn outcome(&self) -> Outcome {
        let held = self.checks.iter().filter(|check| check.holds).count();
        match held {
            _ if self.checks.is_empty() => Outcome::Open,
            0 => Outcome::DoesNot,
            all if all == self.checks.len() => Outcome::ComesOut,
            _ => Outcome::InPart,
        }
    }
}
