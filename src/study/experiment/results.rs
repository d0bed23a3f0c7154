//! Results of the study: of cases, of the series over restitution, of scans; by name.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::cases::Case;
use super::observe::Observed;
use crate::scene::ModelKind;

/// Both models of the paper, the contact model first.
pub const MODELS: [ModelKind; 2] = [ModelKind::Contact, ModelKind::Impact];

/// A case under both models, in the order of [`MODELS`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaseResult {
    /// Under each.
    pub models: [Observed; 2],
}

/// Largest |x|, |y| \[m\], |θ| \[rad\] over restitution: per model, per case, per `e_n`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SeriesResult {
    /// `e_n` of the runs.
    pub restitution: Vec<f64>,
    /// Under each model.
    pub models: [Vec<Vec<[f64; 3]>>; 2],
}

/// The values of a scan, the rows of its level axis one upon the other, in the order of its maps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ScanResult {
    /// Per map; none where the run has no such value.
    pub maps: Vec<Vec<Option<f64>>>,
}

/// Results so far.
#[derive(Clone, Debug, Default)]
pub struct Results {
    /// By name.
    pub cases: BTreeMap<String, CaseResult>,
    /// Over restitution.
    pub series: Option<SeriesResult>,
    /// By name.
    pub scans: BTreeMap<String, ScanResult>,
}

impl Results {
    /// Observations on a case under a model, by its place in [`MODELS`].
    pub fn of(&self, case: &Case, model: usize) -> Option<&Observed> {
        self.cases.get(&case.name())?.models.get(model)
    }
}
