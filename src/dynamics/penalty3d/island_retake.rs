//! A planned step retaken to end at an event: the dense output is an order less exact inside a step than at its ends,
//! and the motion after the event starts from its end.

use crate::dynamics::Model;
use crate::dynamics::penalty3d::constants::{OVERSHOOT_EXPLICIT, OVERSHOOT_IMPLICIT, RETAKE_MARGIN, RETAKE_TOLERANCE};
use crate::dynamics::penalty3d::due::{Due, Reason};
use crate::dynamics::penalty3d::equations_of_motion::ErrorScale;
use crate::dynamics::penalty3d::island::{Island, normalise};

impl Island {
    /// Retakes the planned step to end just beyond `t`, if that is well inside it: the dense output is an order less
    /// exact inside a step than at its ends, and the motion after the event starts from its end. Whether the step was
    /// retaken.
    pub(in crate::dynamics) fn end_beyond(&mut self, model: &Model, t: f64, due: &[Due]) -> bool {
        let Some(dense) = self.dense.as_ref().filter(|dense| dense.from == self.from) else { return false };
        let part = (t - self.from) / dense.step;
        if !(RETAKE_MARGIN..1.0 - RETAKE_MARGIN).contains(&part) {
            return false;
        }
        let y: Vec<f64> = dense.coefficients().iter().map(|c| c[0]).collect();
        if !self.explicit {
            let turns = |due: &Due| match due.reason {
                Reason::Opening => self.system.active[due.number].angle.is_some(),
                Reason::Switching => self.system.active[due.number].turns_at_once(),
                Reason::Edge | Reason::Kink => false,
            };
            return model.tolerance < RETAKE_TOLERANCE && due.iter().any(turns) && self.end_turning_beyond(model, t, y);
        }
        let (from, h, mut y) = (self.from, (t - self.from) * (1.0 + OVERSHOOT_EXPLICIT), y);
        let number = model.ground.piece_number(from);
        let piece = model.ground.piece(number);
        let mut stepper = std::mem::take(&mut self.stepper);
        self.note_raw(&y);
        std::mem::swap(&mut self.raw, &mut self.next_raw);
        let dense = stepper.repeat_explicit(&mut self.field(model, piece, ErrorScale::default()), from, &mut y, h);
        self.note_raw(&y);
        normalise(model, &self.system.bodies, &self.system.layout, &mut y);
        self.sloped = (from + dense.step, number);
        (self.stepper, self.y, self.until, self.dense) = (stepper, y, from + dense.step, Some(dense));
        true
    }

    /// Retakes an implicit step from `y` in which the touch of a contact with a slip angle ends, or a slip stops
    /// whose direction follows `V_t`: the direction bends sharply there, and the dense output of a step across the
    /// bend is exact on neither side.
    fn end_turning_beyond(&mut self, model: &Model, t: f64, mut y: Vec<f64>) -> bool {
        let (from, h) = (self.from, (t - self.from) * (1.0 + OVERSHOOT_IMPLICIT));
        let number = model.ground.piece_number(from);
        let piece = model.ground.piece(number);
        let mut stepper = std::mem::take(&mut self.stepper);
        let measure = self.measure;
        let dense = stepper.repeat_implicit(&mut self.field(model, piece, measure), from, &mut y, h);
        let ended = dense.is_some();
        if let Some(dense) = dense {
            normalise(model, &self.system.bodies, &self.system.layout, &mut y);
            (self.y, self.until, self.dense) = (y, from + dense.step, Some(dense));
        }
        self.stepper = stepper;
        self.rewind(model, self.until);
        ended
    }
}
