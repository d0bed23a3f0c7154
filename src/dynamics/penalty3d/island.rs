//! An island: bodies joined by closed contacts or acting devices, integrated as one system of equations.

use crate::contact::{Frame, Mode};
use crate::dynamics::Model;
use crate::dynamics::connection::Phase;
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::integrator::step_control::{ControllerState, StepLimits};
use crate::dynamics::penalty3d::active_contact::direction;
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::penalty3d::constants::{FIRST_PHASE, SMALLEST_PHASE};
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::penalty3d::coupled_system::{CoupledSystem, Members};
use crate::dynamics::penalty3d::island_kind::IslandKind;
use crate::dynamics::penalty3d::planned_step::{Allowed, PlannedStep};
use crate::dynamics::penalty3d::step_budget::{StepBudget, StepStart};
use crate::dynamics::penalty3d::stepper::{Integrated, Stepper};
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;

/// Bodies in one integrator, with a step that is planned and not yet committed.
#[derive(Debug)]
pub(in crate::dynamics) struct Island {
    /// Slots of its bodies, ascending.
    pub slots: Vec<usize>,
    /// Its bodies and the connections that act on them.
    pub(in crate::dynamics) system: CoupledSystem,
    /// Its equations of motion, and which of its contacts have one motion.
    pub(super) kind: IslandKind,
    /// Numbers of its closed contacts in the group.
    pub contacts: Vec<usize>,
    /// The step that is planned.
    pub step: PlannedStep,
    /// Number of its sequence among the recomputed steps; `None` while no step is stored by its initial state.
    pub sequence: Option<u32>,
    /// Its integrator.
    pub(in crate::dynamics) stepper: Stepper,
    /// What its planned step may err by.
    pub(in crate::dynamics) budget: StepBudget,
    /// Number of segments in the longest path of its bodies, with the planned step.
    pub steps_taken: usize,
}

/// A step shorter than the smallest that is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct StepTooSmall {
    /// Length of the step \[s\].
    pub step: f64,
}

impl Island {
    /// An island of bodies at `t` \[s\] with states `y` relative to reference poses, whose closed contacts have these numbers in the group;
    /// `controller` is the method and length of its first step.
    pub(in crate::dynamics) fn new(
        model: &Model,
        slots: Vec<usize>,
        members: Members,
        contacts: Vec<usize>,
        mut y: Vec<f64>,
        t: f64,
        controller: ControllerState,
    ) -> Self {
        let system = CoupledSystem::of(model, members, &mut y);
        let kind = IslandKind::of(model, &system, &y);
        let stepper =
            Stepper::new(Integrated { model, system: &system, kind: &kind, auxiliary_errors: &[] }, y, t, controller);
        Self {
            budget: StepBudget::none_yet(system.bodies.len()),
            slots,
            system,
            kind,
            contacts,
            step: PlannedStep::none_yet(t),
            sequence: None,
            stepper,
            steps_taken: 0,
        }
    }

    /// Evaluates the slope at the start of the next step after a kink of the ground motion.
    pub(in crate::dynamics) fn rewind(&mut self, model: &Model, t: f64) {
        let Self { system, kind, budget, .. } = self;
        self.stepper.rewind(Integrated { model, system, kind, auxiliary_errors: &budget.auxiliary_errors }, t);
    }

    /// Its bodies and connections at the start of the next step.
    fn start<'a>(&'a self, model: &'a Model) -> StepStart<'a> {
        StepStart {
            model,
            system: &self.system,
            kind: &self.kind,
            y: &self.stepper.y,
            slope: self.stepper.slope(),
            pace: self.stepper.controller_state(),
            steps_taken: self.steps_taken,
        }
    }

    /// Poses of the sections of its bodies relative to their reference poses, `dt` after the start of the next step, with constant
    /// acceleration.
    pub(in crate::dynamics) fn frames_after(&self, model: &Model, dt: f64) -> Vec<Frame> {
        self.start(model).frames_after(dt)
    }

    /// Plans the next step from `until`, at most to `cap` \[s\]; `soon` is the forecast time from its start to the next event \[s\].
    ///
    /// # Errors
    ///
    /// If the step that the tolerance asks for is shorter than [`SMALLEST_PHASE`] of a radian.
    pub(in crate::dynamics) fn plan(&mut self, model: &Model, cap: f64, soon: f64) -> Result<(), StepTooSmall> {
        let t = self.step.until;
        self.step.from = t;
        self.steps_taken += 1;
        let memory = std::mem::take(&mut self.budget);
        let start = self.start(model);
        let (budget, cap) = (start.budget(memory), start.drive_cap(t, cap));
        let (scale, longest, pace) = (budget.scale, budget.longest, start.pace);
        self.budget = budget;
        self.step.allowed = Allowed { displacement: scale.speed / scale.omega, speed: scale.speed };
        let number = model.ground.piece_number(t);
        self.step.explicit = !pace.stiff;
        self.step.repeats = self.stepper.knows_slope(t, number) && self.step.explicit && self.system.links.is_empty();
        // Connections in parallel are faster than the fastest of them alone: factor √(2/n) for n connections, n from 2 to 4. Before the
        // first step no length is known, and its error estimate is unreliable beyond the limit of stability: the length of the first step
        // follows from the largest rate |λ|, the frequency of an oscillation or the decay rate of a dashpot.
        let together = (2.0 / (self.system.active.len() + self.system.links.len()).clamp(2, 4) as f64).sqrt();
        let largest_decay_rate = if pace.step > 0.0 { 0.0 } else { self.system.largest_decay_rate };
        let first =
            FIRST_PHASE * together / scale.omega.max(largest_decay_rate) * (model.tolerance / 1e-10).powf(0.125);
        let kink = self.limiting_kink(model, t);
        let limits = StepLimits { cap, kink, first, longest, soon, smallest: SMALLEST_PHASE / scale.omega };
        let Self { system, kind, budget, .. } = self;
        let of = Integrated { model, system, kind, auxiliary_errors: &budget.auxiliary_errors };
        let (dense, end) = self.stepper.step(of, (number, t), scale, limits).map_err(|step| StepTooSmall { step })?;
        (self.step.dense, self.step.until) = (Some(dense), end);
        Ok(())
    }

    /// Next kink of the ground that limits steps rather than a method \[s\]: between bodies joined by devices that change their law, whose
    /// forces are smooth in between, and where every support has kinks of its own.
    fn limiting_kink(&self, model: &Model, t: f64) -> f64 {
        let changes = |link: &ActiveLink| !link.link(model).device.is_linear();
        let limits = model.moving.is_some() || self.system.links.iter().any(changes);
        if limits { self.stepper.latest_end(model, t) } else { f64::INFINITY }
    }

    /// State of a contact with its slip direction at `t`.
    pub(in crate::dynamics) fn closed_at(&self, number: usize, t: f64) -> ClosedContact {
        let active = &self.system.active[number];
        let mut closed = active.closed;
        if let Some(at) = active.angle {
            let mut angle = [self.stepper.y[at]];
            if let Some(dense) = &self.step.dense {
                dense.read(at..at + 1, t, &mut angle);
            }
            closed.mode = Mode::Slip { direction: direction(angle[0]) };
        }
        closed
    }

    /// Phase of a device with its memory at `t`.
    pub(in crate::dynamics) fn phase_at(&self, index: usize, t: f64) -> Phase {
        let link = &self.system.links[index];
        let mut phase = link.phase_in(&self.stepper.y);
        if let (Some(at), Some(dense)) = (link.evolving, &self.step.dense) {
            dense.read(at..at + 1, t, &mut phase.memory[..1]);
        }
        phase
    }

    /// Dense output of a device's memory in the planned step; `None` where the memory is constant.
    pub(in crate::dynamics) fn memory_path(&self, index: usize) -> Option<DenseOutput> {
        let at = self.system.links[index].evolving?;
        self.step.dense.as_ref().map(|dense| dense.slice(at..at + 1))
    }

    /// Dense output of the planned step for one body.
    pub(in crate::dynamics) fn path(&self, index: usize) -> Option<StepPolynomial> {
        let (part, base) = (self.system.layout.range(index), Some(&self.system.bases[index]));
        self.step.dense.as_ref().map(|dense| StepPolynomial::of(dense, part, base))
    }

    /// Length of the planned step \[s\] and initial states of its bodies relative to their reference poses; `None`
    /// where a step recomputed from these would not be equal to the last bit.
    pub(in crate::dynamics) fn repeated(&self, model: &Model) -> Option<(f64, Vec<f64>)> {
        let dense = self.step.dense.as_ref().filter(|dense| self.step.repeats && dense.from == self.step.from)?;
        self.stepper.start_of(model, &self.system, dense).map(|start| (dense.step, start))
    }

    /// Dense output of the planned step for the slip angle of one contact; `None` where the angle is no state.
    pub(in crate::dynamics) fn angle_path(&self, number: usize) -> Option<DenseOutput> {
        let at = self.system.active[number].angle?;
        self.step.dense.as_ref().map(|dense| dense.slice(at..at + 1))
    }

    /// Circular frequency of its fastest contact, device or bearing \[rad/s\].
    pub(in crate::dynamics) fn omega(&self) -> f64 {
        self.system.omega
    }
}

#[cfg(test)]
mod tests;
