//! An explicit planned step retaken to end at an event: its end is of order 8, its dense output inside of order 7
//! (`docs/solver.md`), and the motion after the event starts from its end. An implicit step is not retaken: its error
//! estimate is of the order of its dense output, the number of stages, so that the tolerance bounds the error inside too.

use crate::dynamics::Model;
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::penalty3d::constants::{RETAKE_ERROR, RETAKE_MARGIN, RETAKE_OVERSHOOT};
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::penalty3d::stepper::Integrated;

impl Island {
    /// Whether the inside of the planned step is as exact as its end has to be, as of a step that a kink ends.
    pub(in crate::dynamics) fn is_exact_inside(&self) -> bool {
        self.stepper.error() <= RETAKE_ERROR
    }

    /// Retakes an explicit planned step to end just beyond `t`, if that is well inside it; whether it was retaken.
    pub(in crate::dynamics) fn end_beyond(&mut self, model: &Model, t: f64) -> bool {
        let retakable = |dense: &&DenseOutput| self.step.explicit && dense.from == self.step.from;
        let Some(dense) = self.step.dense.as_ref().filter(retakable) else { return false };
        let part = (t - self.step.from) / dense.step;
        if !(RETAKE_MARGIN..1.0 - RETAKE_MARGIN).contains(&part) {
            return false;
        }
        let (from, h) = (self.step.from, (t - self.step.from) * (1.0 + RETAKE_OVERSHOOT));
        let of = Integrated {
            model,
            system: &self.system,
            kind: &self.kind,
            auxiliary_errors: &self.budget.auxiliary_errors,
        };
        let dense = self.stepper.retake(of, dense, [from, h]);
        (self.step.until, self.step.dense) = (from + dense.step, Some(dense));
        true
    }
}
