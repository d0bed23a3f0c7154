//! An island: bodies joined by closed contacts or acting devices, integrated as one system of equations.

use crate::contact::Mode;
use crate::dynamics::Model;
use crate::dynamics::connection::Phase;
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::integrator::radau_iia::Radau;
use crate::dynamics::integrator::step_control::{ControllerState, StepController, StepLimits};
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::penalty3d::active_contact::direction;
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::penalty3d::constants::{FIRST_PHASE, SMALLEST_PHASE};
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::penalty3d::coupled_system::{CoupledSystem, Members};
use crate::dynamics::penalty3d::equations_of_motion::{EquationsOfMotion, ErrorScale};
use crate::dynamics::penalty3d::island_kind::IslandKind;
use crate::dynamics::penalty3d::planned_step::{Allowed, PlannedStep};
use crate::dynamics::penalty3d::workspace::Workspace;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;
use crate::motion::LinearPiece;

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
    /// Beginning of the island, or the last kink of the ground's motion that ended a step \[s\].
    since: f64,
    /// Time \[s\] and interval of the ground motion at which the slope at the start of the next step was evaluated.
    pub(super) slope_at: (f64, usize),
    /// For bodies with quaternions: the states before normalisation at which the slopes at the start of the planned
    /// step and of the next step were evaluated.
    pub(super) unnormalised: Vec<f64>,
    pub(super) next_unnormalised: Vec<f64>,
    pub(in crate::dynamics) y: Vec<f64>,
    /// Number of segments in the longest path of its bodies, with the planned step.
    pub steps_taken: usize,
    pub(in crate::dynamics) controller: StepController,
    /// Bound of the displacement of a corner since placed at the start of the step, per body \[m\].
    pub(in crate::dynamics) moved: Vec<f64>,
    pub(super) workspace: Workspace,
    /// Allowed errors in a step of the auxiliary states, in their order: slip angles \[rad\], memories of devices (units of the device).
    pub(in crate::dynamics) auxiliary_errors: Vec<f64>,
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
        // A slip angle follows the velocity over a length of the spring's stretch, faster than all other motions:
        // implicit steps.
        let turns = system.active.iter().any(|a| a.angle.is_some());
        let controller = ControllerState { stiff: controller.stiff && !system.is_free(model) || turns, ..controller };
        let mut island = Self {
            moved: vec![0.0; system.bodies.len()],
            workspace: Workspace::of(&system.active),
            slots,
            system,
            kind,
            contacts,
            step: PlannedStep::none_yet(t),
            sequence: None,
            since: t,
            slope_at: (t, 0),
            unnormalised: Vec::new(),
            next_unnormalised: Vec::new(),
            steps_taken: 0,
            controller: StepController::new(y.len(), controller),
            y,
            auxiliary_errors: Vec::new(),
        };
        if island.system.is_free(model) {
            island.controller.expect_no_noise();
        }
        island.rewind(model, t);
        island
    }

    /// Evaluates the slope at the start of the next step, for a first step and after a kink of the ground motion.
    pub(in crate::dynamics) fn rewind(&mut self, model: &Model, t: f64) {
        (self.since, self.slope_at) = (t, (t, model.ground.piece_number(t)));
        let piece = model.ground.piece(self.slope_at.1);
        let (mut controller, y) = (std::mem::take(&mut self.controller), std::mem::take(&mut self.y));
        controller.start(&mut self.equations(model, (piece, t), ErrorScale::default()), t, &y);
        self.note_unnormalised(&y);
        (self.controller, self.y) = (controller, y);
    }

    /// Stores the state at which the slope at the start of the next step was evaluated.
    pub(super) fn note_unnormalised(&mut self, y: &[f64]) {
        if self.system.layout.has_unit_parts() {
            self.next_unnormalised.clear();
            self.next_unnormalised.extend_from_slice(y);
        }
    }

    pub(super) fn equations<'a>(
        &'a mut self,
        model: &'a Model,
        (piece, since): (LinearPiece, f64),
        scale: ErrorScale,
    ) -> EquationsOfMotion<'a> {
        EquationsOfMotion {
            model,
            system: &self.system,
            kind: &self.kind,
            piece,
            since,
            scale,
            auxiliary_errors: &self.auxiliary_errors,
            workspace: &mut self.workspace,
        }
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
        let (scale, bounds) = self.scale(model);
        self.step.allowed = Allowed { displacement: scale.speed / scale.omega, speed: scale.speed };
        let number = model.ground.piece_number(t);
        let piece = model.ground.piece(number);
        let known = self.workspace.sliding.sliders.is_empty() && self.slope_at == (t, number);
        self.step.explicit = !self.controller.state().stiff;
        self.step.repeats = known && self.step.explicit && self.system.links.is_empty();
        // Connections in parallel are faster than the fastest of them alone: factor √(2/n) for n connections, n from 2 to 4. Before the
        // first step no length is known, and its error estimate is unreliable beyond the limit of stability: the length of the first step
        // follows from the largest rate |λ|, the frequency of an oscillation or the decay rate of a dashpot.
        let together = (2.0 / (self.system.active.len() + self.system.links.len()).clamp(2, 4) as f64).sqrt();
        let largest_decay_rate = if self.controller.state().step > 0.0 { 0.0 } else { self.system.largest_decay_rate };
        let first =
            FIRST_PHASE * together / scale.omega.max(largest_decay_rate) * (model.tolerance / 1e-10).powf(0.125);
        let longest = self.longest(model, &bounds);
        let kink = self.limiting_kink(model, t);
        let cap = self.drive_cap(model, cap);
        let limits = StepLimits { cap, kink, first, longest, soon, smallest: SMALLEST_PHASE / scale.omega };
        let (mut controller, mut y) = (std::mem::take(&mut self.controller), std::mem::take(&mut self.y));
        let outcome = controller.step(&mut self.equations(model, (piece, t), scale), t, &mut y, limits);
        std::mem::swap(&mut self.unnormalised, &mut self.next_unnormalised);
        self.note_unnormalised(&y);
        normalise(model, &self.system.bodies, &self.system.layout, &mut y);
        (self.controller, self.y) = (controller, y);
        let (dense, end) = outcome.map_err(|step| StepTooSmall { step })?;
        // The slope is evaluated at the sum, from which `end` can differ by the last bit.
        self.slope_at = (t + dense.step, number);
        (self.step.dense, self.step.until) = (Some(dense), end);
        Ok(())
    }

    /// Latest end of the next step by the kinks of the ground's motion: the next of them or, in a run that halves their intervals, the
    /// middle before it \[s\].
    pub(in crate::dynamics) fn latest_end(&self, model: &Model) -> f64 {
        let (from, kink) = (self.step.until, model.next_kink(self.step.until));
        let middle = self.since.midpoint(kink);
        if model.halves_intervals && from < middle { middle } else { kink }
    }

    /// Next kink of the ground that limits steps rather than a method \[s\]: between bodies joined by devices that change their law, whose
    /// forces are smooth in between, and where every support has kinks of its own.
    fn limiting_kink(&self, model: &Model, t: f64) -> f64 {
        let changes = |link: &ActiveLink| !link.link(model).device.is_linear();
        let limits = model.moving.is_some() || self.system.links.iter().any(changes);
        if limits { model.next_kink(t) } else { f64::INFINITY }
    }

    /// State of a contact with its slip direction at `t`.
    pub(in crate::dynamics) fn closed_at(&self, number: usize, t: f64) -> ClosedContact {
        let active = &self.system.active[number];
        let mut closed = active.closed;
        if let Some(at) = active.angle {
            let mut angle = [self.y[at]];
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
        let mut phase = link.phase_in(&self.y);
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
        let mut start = dense.coefficients().iter().map(|c| c[0]);
        if !self.system.layout.has_unit_parts() {
            return Some((dense.step, start.collect()));
        }
        // Normalising a normalised quaternion can change its last bit.
        let mut normal = self.unnormalised.clone();
        normalise(model, &self.system.bodies, &self.system.layout, &mut normal);
        let same = normal.iter().all(|x| start.next().is_some_and(|y| x.to_bits() == y.to_bits()));
        same.then(|| (dense.step, self.unnormalised.clone()))
    }

    /// Dense output of the planned step for the slip angle of one contact; `None` where the angle is no state.
    pub(in crate::dynamics) fn angle_path(&self, number: usize) -> Option<DenseOutput> {
        let at = self.system.active[number].angle?;
        self.step.dense.as_ref().map(|dense| dense.slice(at..at + 1))
    }

    /// Method and length of its integrator's next step.
    pub(in crate::dynamics) fn controller_state(&self) -> ControllerState {
        self.controller.state()
    }

    /// Takes over the memory of an implicit integrator of an ended island.
    pub(in crate::dynamics) fn borrow(&mut self, spare: Option<Box<Radau>>) {
        self.controller.borrow(spare);
    }

    /// Hands over the memory of its implicit integrator, if it has one.
    pub(in crate::dynamics) fn give_back(&mut self) -> Option<Box<Radau>> {
        self.controller.give_back()
    }

    /// Circular frequency of its fastest contact, device or bearing \[rad/s\].
    pub(in crate::dynamics) fn omega(&self) -> f64 {
        self.system.omega
    }
}

/// Normalises the quaternions of states in succession.
pub(in crate::dynamics) fn normalise(model: &Model, bodies: &[usize], layout: &StateLayout, y: &mut [f64]) {
    if layout.has_unit_parts() {
        (bodies.iter().enumerate()).for_each(|(i, &body)| model.bodies[body].normalise(&mut y[layout.range(i)]));
    }
}

#[cfg(test)]
mod tests;
