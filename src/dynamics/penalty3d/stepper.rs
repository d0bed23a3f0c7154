//! The integrator of an island: the state at the start of the next step, the control of the steps, and where its slope is known.

use crate::dynamics::Model;
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::integrator::radau_iia::Radau;
use crate::dynamics::integrator::step_control::{ControllerState, StepController, StepLimits};
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::penalty3d::coupled_system::CoupledSystem;
use crate::dynamics::penalty3d::equations_of_motion::{EquationsOfMotion, ErrorScale};
use crate::dynamics::penalty3d::island_kind::IslandKind;
use crate::dynamics::penalty3d::workspace::Workspace;

/// Bodies and connections whose motion is integrated.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Integrated<'a> {
    /// Constant data of the scene.
    pub model: &'a Model,
    /// Bodies and the connections that act on them.
    pub system: &'a CoupledSystem,
    /// Kind of the island that they form.
    pub kind: &'a IslandKind,
    /// Allowed errors in a step of the auxiliary states: slip angles \[rad\], memories of devices (units of the device).
    pub auxiliary_errors: &'a [f64],
}

impl<'a> Integrated<'a> {
    /// The equations of motion in a step from `since` \[s\] in this interval of the ground motion.
    fn equations(
        self,
        (number, since): (usize, f64),
        scale: ErrorScale,
        workspace: &'a mut Workspace,
    ) -> EquationsOfMotion<'a> {
        let Self { model, system, kind, auxiliary_errors } = self;
        let piece = model.ground.piece(number);
        EquationsOfMotion { model, system, kind, piece, since, scale, auxiliary_errors, workspace }
    }

    fn normalise(self, y: &mut [f64]) {
        normalise(self.model, &self.system.bodies, &self.system.layout, y);
    }
}

/// State of an island's integrator.
#[derive(Debug)]
pub(in crate::dynamics) struct Stepper {
    /// State at the start of the next step, relative to the reference poses.
    pub(in crate::dynamics) y: Vec<f64>,
    controller: StepController,
    /// Beginning of the island, or the last kink of the ground's motion that ended a step \[s\].
    since: f64,
    /// Time \[s\] and interval of the ground motion at which the slope at the start of the next step was evaluated.
    slope_at: (f64, usize),
    /// For bodies with quaternions: the states before normalisation at which the slopes at the start of the planned
    /// step and of the next step were evaluated.
    unnormalised: Vec<f64>,
    next_unnormalised: Vec<f64>,
    workspace: Workspace,
}

impl Stepper {
    /// An integrator at `t` \[s\] in the state `y`; `controller` is the method and length of its first step.
    pub(in crate::dynamics) fn new(of: Integrated<'_>, y: Vec<f64>, t: f64, controller: ControllerState) -> Self {
        // A slip angle follows the velocity over a length of the spring's stretch, faster than all other motions:
        // implicit steps.
        let (free, turns) = (of.system.is_free(of.model), of.system.active.iter().any(|a| a.angle.is_some()));
        let controller = ControllerState { stiff: controller.stiff && !free || turns, ..controller };
        let mut stepper = Self {
            controller: StepController::new(y.len(), controller),
            y,
            since: t,
            slope_at: (t, 0),
            unnormalised: Vec::new(),
            next_unnormalised: Vec::new(),
            workspace: Workspace::of(&of.system.active),
        };
        if free {
            stepper.controller.expect_no_noise();
        }
        stepper.rewind(of, t);
        stepper
    }

    /// Evaluates the slope at the start of the next step, for a first step and after a kink of the ground motion.
    pub(in crate::dynamics) fn rewind(&mut self, of: Integrated<'_>, t: f64) {
        (self.since, self.slope_at) = (t, (t, of.model.ground.piece_number(t)));
        let mut equations = of.equations((self.slope_at.1, t), ErrorScale::default(), &mut self.workspace);
        self.controller.start(&mut equations, t, &self.y);
        self.note_unnormalised(&of.system.layout);
    }

    /// Stores the state at which the slope at the start of the next step was evaluated.
    fn note_unnormalised(&mut self, layout: &StateLayout) {
        if layout.has_unit_parts() {
            self.next_unnormalised.clear();
            self.next_unnormalised.extend_from_slice(&self.y);
        }
    }

    /// Takes a step from `t` \[s\] in this interval of the ground motion: its dense output and its end \[s\].
    ///
    /// # Errors
    ///
    /// The length of a step that has to be shorter than the smallest.
    pub(in crate::dynamics) fn step(
        &mut self,
        of: Integrated<'_>,
        (number, t): (usize, f64),
        scale: ErrorScale,
        limits: StepLimits,
    ) -> Result<(DenseOutput, f64), f64> {
        let mut equations = of.equations((number, t), scale, &mut self.workspace);
        let outcome = self.controller.step(&mut equations, t, &mut self.y, limits);
        std::mem::swap(&mut self.unnormalised, &mut self.next_unnormalised);
        self.note_unnormalised(&of.system.layout);
        of.normalise(&mut self.y);
        let (dense, end) = outcome?;
        // The slope is evaluated at the sum, from which `end` can differ by the last bit.
        self.slope_at = (t + dense.step, number);
        Ok((dense, end))
    }

    /// Takes the explicit step with this dense output again, from `t` \[s\] over a length of `h` \[s\] that is less than its own.
    pub(in crate::dynamics) fn retake(
        &mut self,
        of: Integrated<'_>,
        step: &DenseOutput,
        [t, h]: [f64; 2],
    ) -> DenseOutput {
        let number = of.model.ground.piece_number(t);
        self.y.clear();
        self.y.extend(step.coefficients().iter().map(|c| c[0]));
        self.note_unnormalised(&of.system.layout);
        std::mem::swap(&mut self.unnormalised, &mut self.next_unnormalised);
        let mut equations = of.equations((number, t), ErrorScale::default(), &mut self.workspace);
        let dense = self.controller.repeat_explicit(&mut equations, t, &mut self.y, h);
        self.note_unnormalised(&of.system.layout);
        of.normalise(&mut self.y);
        self.slope_at = (t + dense.step, number);
        dense
    }

    /// Error of the last accepted step, in units of the tolerance.
    pub(in crate::dynamics) fn error(&self) -> f64 {
        self.controller.error()
    }

    /// Latest end of the step from `t` by the kinks of the ground's motion \[s\].
    pub(in crate::dynamics) fn latest_end(&self, model: &Model, t: f64) -> f64 {
        model.latest_end(t, [self.since, model.next_kink(t)])
    }

    /// Whether the slope at `t` in this interval of the ground motion follows from the state alone, and is known.
    pub(in crate::dynamics) fn knows_slope(&self, t: f64, number: usize) -> bool {
        self.workspace.sliding.sliders.is_empty() && self.slope_at == (t, number)
    }

    /// The state at which the slope at the start of the step with this dense output was evaluated; `None` where its normalised state
    /// is not that of the step to the last bit.
    pub(in crate::dynamics) fn start_of(
        &self,
        model: &Model,
        system: &CoupledSystem,
        step: &DenseOutput,
    ) -> Option<Vec<f64>> {
        let mut start = step.coefficients().iter().map(|c| c[0]);
        if !system.layout.has_unit_parts() {
            return Some(start.collect());
        }
        // Normalising a normalised quaternion can change its last bit.
        let mut normal = self.unnormalised.clone();
        normalise(model, &system.bodies, &system.layout, &mut normal);
        let same = normal.iter().all(|x| start.next().is_some_and(|y| x.to_bits() == y.to_bits()));
        same.then(|| self.unnormalised.clone())
    }

    /// Slope at the start of the next step.
    pub(in crate::dynamics) fn slope(&self) -> &[f64] {
        self.controller.slope()
    }

    /// Method and length of the next step.
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
}

/// Normalises the quaternions of states in succession.
pub(in crate::dynamics) fn normalise(model: &Model, bodies: &[usize], layout: &StateLayout, y: &mut [f64]) {
    if layout.has_unit_parts() {
        (bodies.iter().enumerate()).for_each(|(i, &body)| model.bodies[body].normalise(&mut y[layout.range(i)]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::penalty3d::coupled_system::Members;
    use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, closed, stick, wall};

    const LIMITS: StepLimits = StepLimits {
        cap: 1.0,
        kink: f64::INFINITY,
        first: 1e-4,
        longest: f64::INFINITY,
        soon: f64::INFINITY,
        smallest: 1e-12,
    };

    /// A girder that enters a wall, without an island around it.
    fn hit() -> (Model, CoupledSystem, IslandKind, Vec<f64>) {
        let (model, active) = closed(&wall(), stick);
        let mut y = vec![0.0, 0.0, 0.0, SPEED, 0.0, 0.0];
        let members = Members { bodies: vec![0], bases: vec![model.bodies[0].placed()], active, links: Vec::new() };
        let system = CoupledSystem::of(&model, members, &mut y);
        let kind = IslandKind::of(&model, &system, &y);
        (model, system, kind, y)
    }

    #[test]
    fn a_step_ends_in_the_closed_form_and_leaves_its_slope_known() {
        let (model, system, kind, y) = hit();
        let of = Integrated { model: &model, system: &system, kind: &kind, auxiliary_errors: &[] };
        let omega = (STIFFNESS / MASS).sqrt();
        let scale = ErrorScale { speed: 1e-12 * SPEED, omega, size: 0.1 };
        let mut stepper = Stepper::new(of, y, 0.0, ControllerState::default());
        assert!(stepper.knows_slope(0.0, model.ground.piece_number(0.0)), "evaluated at the start");
        let (dense, end) = stepper.step(of, (0, 0.0), scale, LIMITS).expect("a step that can be made");
        let off = |stepper: &Stepper, t: f64| (stepper.y[0] - SPEED / omega * (omega * t).sin()).abs();
        assert!(off(&stepper, end) < 1e-12, "{} m off at {end} s", off(&stepper, end));
        assert!(stepper.knows_slope(dense.from + dense.step, 0) && !stepper.knows_slope(0.5 * end, 0));
        assert_eq!(stepper.start_of(&model, &system, &dense).expect("no unit parts")[3], SPEED);
        let half = stepper.retake(of, &dense, [0.0, 0.5 * end]);
        assert!(half.step == 0.5 * end && off(&stepper, 0.5 * end) < 1e-12, "{} m off", off(&stepper, 0.5 * end));
    }

    #[test]
    fn a_step_below_the_smallest_fails_with_its_length() {
        let (model, system, kind, y) = hit();
        let of = Integrated { model: &model, system: &system, kind: &kind, auxiliary_errors: &[] };
        let mut stepper = Stepper::new(of, y, 0.0, ControllerState::default());
        let scale = ErrorScale { speed: 1e-40, omega: 1.0, size: 0.1 };
        let limits = StepLimits { smallest: 1e-3, first: 1.0, ..LIMITS };
        let failed = stepper.step(of, (0, 0.0), scale, limits);
        assert!(failed.is_err_and(|length| length < 1e-3), "no step is that exact");
    }
}
