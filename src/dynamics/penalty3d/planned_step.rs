//! The step of an island that is planned and not yet committed: its interval, its dense output, the events that end it.

use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::penalty3d::due::{Due, LinkDue};

/// Allowed error of a step.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::dynamics) struct Allowed {
    /// In place \[m\].
    pub displacement: f64,
    /// In velocity \[m/s\].
    pub speed: f64,
}

/// A planned step.
#[derive(Debug)]
pub(in crate::dynamics) struct PlannedStep {
    /// Beginning \[s\].
    pub from: f64,
    /// End \[s\].
    pub until: f64,
    /// Dense output; `None` before the first step.
    pub dense: Option<DenseOutput>,
    /// Whether the method is explicit.
    pub explicit: bool,
    /// Allowed error, by the run's tolerance.
    pub allowed: Allowed,
    /// Whether the step, recomputed from its initial state, is equal to the last bit.
    pub repeats: bool,
    /// Events of contacts that end it.
    pub due: Vec<Due>,
    /// End of a device's phase that ends it.
    pub link_due: Option<LinkDue>,
}

impl PlannedStep {
    /// Before the first step, at `t` \[s\].
    pub(in crate::dynamics) fn none_yet(t: f64) -> Self {
        let (due, link_due) = (Vec::new(), None);
        let allowed = Allowed::default();
        Self { from: t, until: t, dense: None, explicit: false, allowed, repeats: false, due, link_due }
    }
}
