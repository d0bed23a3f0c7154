//! Required length of a seat by a code, and its inputs.

use crate::geometry::Prism;
use crate::language::Text;
use crate::scene::Codes;
use crate::sim::seats::Seat;

/// A design code with a requirement for seat lengths.
pub(super) trait Code: Sync {
    /// Required lengths of a seat.
    fn demands(&self, case: &Case<'_>) -> Vec<Demand>;
}

/// A seat that a code is applied to.
#[derive(Clone, Copy, Debug)]
pub struct Case<'a> {
    /// The girder's shape.
    pub prism: &'a Prism,
    /// Inputs of design codes: the scene's table `[codes]`.
    pub codes: &'a Codes,
    /// Readings of the seat in the run.
    pub seat: &'a Seat,
    /// Average height of the columns: of the pier under this end, of an end on an abutment of the pier under the other end \[m\], and where
    /// that is from; `None` of a girder on no pier.
    pub columns: Option<(f64, Source)>,
}

/// Source of an input's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Source {
    /// The scene gives it.
    Scene,
    /// The scene does not give it: a default.
    Assumed,
    /// The run.
    Run,
}

impl Source {
    /// The word used in tables.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Assumed => "assumed",
            Self::Run => "run",
        }
    }
}

/// A number that a requirement depends on.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Input {
    /// Its symbol in the code.
    pub symbol: &'static str,
    /// Its value, in the unit.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
    /// Source of the value.
    pub source: Source,
}

impl Input {
    /// A number of the scene, or what is assumed where it gives none.
    pub(super) fn given_or(symbol: &'static str, unit: &'static str, given: Option<f64>, assumed: f64) -> Self {
        let source = if given.is_some() { Source::Scene } else { Source::Assumed };
        Self { symbol, value: given.unwrap_or(assumed), unit, source }
    }

    /// A number of the scene.
    pub(super) const fn of_scene(symbol: &'static str, unit: &'static str, value: f64) -> Self {
        Self { symbol, value, unit, source: Source::Scene }
    }

    /// A number of the run.
    pub(super) const fn of_run(symbol: &'static str, unit: &'static str, value: f64) -> Self {
        Self { symbol, value, unit, source: Source::Run }
    }
}

/// A length of seat that a code requires, square to the front edge of the seat.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Demand {
    /// Code and symbol.
    pub rule: Text,
    /// Edition that the formula is quoted from.
    pub edition: Text,
    /// The formula in a line.
    pub formula: &'static str,
    /// Whether the formula was read in that edition; otherwise it is quoted from memory.
    pub confirmed: bool,
    /// Note on how direction and numbers follow from the scene, where it is not evident.
    pub note: Text,
    /// Inputs.
    pub inputs: Vec<Input>,
    /// The length required \[m\].
    pub required: f64,
    /// The length provided: the seat as placed \[m\].
    pub provided: f64,
    /// Length used in the run: placed less least \[m\].
    pub used: f64,
}

impl Demand {
    /// Length used in the run over the length required \[–\].
    pub fn ratio(&self) -> f64 {
        self.used / self.required
    }

    /// Whether the seat is as long as the code requires.
    pub fn is_met(&self) -> bool {
        self.provided >= self.required
    }

    /// Whether it is, and the run did not use it up: a code's number is no more than a demand.
    pub fn holds(&self) -> bool {
        self.is_met() && self.used < self.provided
    }

    /// The verdict in a word.
    pub fn verdict(&self) -> Text {
        match (self.is_met(), self.holds()) {
            (false, _) => Text::new("too-short"),
            (true, false) => Text::new("used-up"),
            (true, true) => Text::new("long-enough"),
        }
    }
}

impl Case<'_> {
    /// Skew from the square, `|90° − β|` \[degrees\].
    pub(super) fn skew_deg(&self) -> f64 {
        (90.0 - self.prism.skew.to_degrees()).abs()
    }

    /// Average height of the columns: what `[codes]` gives, else that of the piers that carry the girder; assumed to be 0, as of a single
    /// span, without either.
    pub(super) fn column_height(&self, symbol: &'static str) -> Input {
        match (self.codes.column_height, self.columns) {
            (None, Some((value, source))) => Input { symbol, value, unit: "m", source },
            (given, _) => Input::given_or(symbol, "m", given, 0.0),
        }
    }

    /// Deck to the next joint.
    pub(super) fn deck_length(&self, symbol: &'static str) -> Input {
        Input::given_or(symbol, "m", self.codes.deck_length, self.prism.length)
    }
}
