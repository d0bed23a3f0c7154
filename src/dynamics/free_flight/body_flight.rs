//! One stretch of free motion of a body, in the closed form that it follows.

use std::sync::Arc;

use crate::contact::Frame;
use crate::dynamics::free_flight::flight::{Flight, FreeMotion};
use crate::dynamics::free_flight::uncoupled_axis::UncoupledAxis;
use crate::dynamics::linear::{self, ModalCoordinates};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::closed_form::ClosedForm;
use crate::dynamics::model::coordinates::BodyState;
use crate::dynamics::model::coordinates::planar::{PlanarState, is_along};
use crate::dynamics::model::motion_bounds::MotionBounds;

/// One stretch of free motion of a body.
#[derive(Clone, Debug)]
pub enum BodyFlight {
    /// Of a rigid girder in plan.
    InPlan(FlightInPlan),
    /// Of a body of other coordinates.
    Custom(Box<CustomFlight>),
}

/// A flight of a rigid girder in plan with its equation of motion.
#[derive(Clone, Debug)]
pub struct FlightInPlan {
    system: Arc<FreeMotion>,
    flight: Flight,
    /// Whether other springs to the ground than the girder's bearings act in it.
    on_springs: bool,
}

impl FlightInPlan {
    /// On the girder's own bearings.
    pub(in crate::dynamics) fn on_bearings(system: Arc<FreeMotion>, flight: Flight) -> Self {
        Self { system, flight, on_springs: false }
    }

    /// On springs to the ground beside them.
    pub(in crate::dynamics) fn on_springs(system: Arc<FreeMotion>, flight: Flight) -> Self {
        Self { system, flight, on_springs: true }
    }
}

/// A flight in a closed form that a body brings.
#[derive(Clone, Debug)]
pub struct CustomFlight {
    form: Arc<dyn ClosedForm>,
    /// Beginning \[s\].
    start: f64,
    /// State at its beginning.
    state: BodyState,
    /// Parameters of the closed form ([`linear::FlightParameters::numbers`]).
    numbers: Vec<f64>,
}

impl CustomFlight {
    /// From this state and these numbers on.
    pub(in crate::dynamics) fn new(form: &Arc<dyn ClosedForm>, start: f64, state: &[f64], numbers: Vec<f64>) -> Self {
        Self { form: Arc::clone(form), start, state: state.into(), numbers }
    }

    /// Start and parameters of the closed form.
    fn flight(&self) -> linear::FlightParameters<'_> {
        linear::FlightParameters { start: self.start, numbers: &self.numbers }
    }

    fn state(&self, t: f64) -> BodyState {
        // As it was, to the last bit.
        if t == self.start {
            return self.state.clone();
        }
        let mut out = BodyState::from_elem(0.0, self.state.len());
        self.form.state(self.flight(), t, &mut out);
        out
    }
}

/// Motion along one axis of a flight.
pub(in crate::dynamics) struct FlightAlong<'a> {
    /// Oscillator and steady response.
    pub dof: &'a UncoupledAxis,
    /// Free part at the start of the flight: displacement and velocity \[m, m/s\].
    pub part: [f64; 2],
    /// Constant force per unit mass \[m/s²\].
    pub push: f64,
}

impl BodyFlight {
    /// Beginning \[s\].
    #[inline]
    pub fn start(&self) -> f64 {
        match self {
            Self::InPlan(own) => own.flight.start,
            Self::Custom(own) => own.start,
        }
    }

    /// State at its beginning.
    #[inline]
    pub fn initial(&self) -> &[f64] {
        match self {
            Self::InPlan(own) => &own.flight.state,
            Self::Custom(own) => &own.state,
        }
    }

    /// Equation of motion and flight of a rigid girder in plan; `None` of another body.
    pub(in crate::dynamics) fn in_plan(&self) -> Option<(&FreeMotion, &Flight)> {
        let Self::InPlan(own) = self else { return None };
        Some((&own.system, &own.flight))
    }

    /// State at `t`.
    pub fn state(&self, t: f64) -> BodyState {
        match self {
            Self::InPlan(own) => own.system.state(&own.flight, t).as_slice().into(),
            Self::Custom(own) => own.state(t),
        }
    }

    /// Displacement and rate at `t` of a body of one coordinate; `None` of another.
    pub(in crate::dynamics) fn coordinate(&self, t: f64) -> Option<[f64; 2]> {
        let Self::Custom(own) = self else { return None };
        let mut out: [f64; 2] = own.state.as_slice().try_into().ok()?;
        // As it was, to the last bit.
        if t != own.start {
            own.form.state(own.flight(), t, &mut out);
        }
        Some(out)
    }

    /// Pose and twist of a section of its body at `t`.
    pub(in crate::dynamics) fn frame(&self, body: &Body, section: usize, t: f64) -> Frame {
        match self {
            Self::InPlan(own) => body.planar_frame(&own.system.state(&own.flight, t)),
            Self::Custom(own) => body.frame(section, &own.state(t)),
        }
    }

    /// Bounds on the motion from `t` on for at most `horizon` \[s\].
    pub fn bounds(&self, t: f64, horizon: f64) -> MotionBounds {
        match self {
            Self::InPlan(own) => own.system.state_and_bounds(&own.flight, t, horizon).1,
            Self::Custom(own) => own.form.bounds(own.flight(), t, horizon),
        }
    }

    /// [`ClosedForm::parts`]; empty of a rigid girder in plan.
    pub(in crate::dynamics) fn parts(&self, t: f64) -> ModalCoordinates {
        match self {
            Self::InPlan(_) => ModalCoordinates::default(),
            Self::Custom(own) => own.form.parts(own.flight(), t),
        }
    }

    /// Pose and twist of a section of its body at `t`, with bounds on the motion from then on for at most `horizon` \[s\]; from the parts of
    /// the flight.
    pub(in crate::dynamics) fn look(
        &self,
        (body, section): (&Body, usize),
        parts: &ModalCoordinates,
        [t, horizon]: [f64; 2],
    ) -> (Frame, MotionBounds) {
        match self {
            Self::InPlan(_) => (self.frame(body, section, t), self.bounds(t, horizon)),
            Self::Custom(own) => {
                let mut state = BodyState::from_elem(0.0, own.state.len());
                let bounds = own.form.look(own.flight(), parts, [t, horizon], &mut state);
                // As it was, to the last bit.
                let state = if t == own.start { &own.state } else { &state };
                (body.frame(section, state), bounds)
            }
        }
    }

    /// [`ClosedForm::window_end`]; infinite for a rigid girder in plan \[s\].
    pub(in crate::dynamics) fn window_end(&self, t: f64) -> f64 {
        match self {
            Self::InPlan(_) => f64::INFINITY,
            Self::Custom(own) => own.form.window_end(own.flight(), t),
        }
    }

    /// [`ClosedForm::range`]; `None` of a rigid girder in plan.
    pub(in crate::dynamics) fn range(&self, span: [f64; 2]) -> Option<[f64; 2]> {
        let Self::Custom(own) = self else { return None };
        own.form.range(own.flight(), span)
    }

    /// [`ClosedForm::displacement_bound`]; nothing of a rigid girder in plan \[m\].
    pub fn displacement_bound(&self, until: f64) -> Option<f64> {
        let Self::Custom(own) = self else { return None };
        own.form.displacement_bound(own.flight(), until)
    }

    /// [`ClosedForm::works`]; `None` of a rigid girder in plan.
    pub fn works(&self, span: [f64; 2]) -> Option<[f64; 4]> {
        let Self::Custom(own) = self else { return None };
        own.form.works(own.flight(), span)
    }

    /// [`ClosedForm::second_derivatives`]; none of a rigid girder in plan.
    pub fn second_derivatives(&self, span: [f64; 2]) -> Vec<f64> {
        let Self::Custom(own) = self else { return Vec::new() };
        own.form.second_derivatives(own.flight(), span)
    }

    /// The motion along a world axis of a flight that has no other.
    pub(in crate::dynamics) fn along(&self, axis: usize) -> Option<FlightAlong<'_>> {
        let (system, flight) = self.in_plan()?;
        let (dof, part) = is_along(&flight.state, axis).then(|| system.along(flight, axis)).flatten()?;
        Some(FlightAlong { dof, part, push: system.push[axis] })
    }

    /// Stores the states from which evaluations up to `t` start.
    pub(in crate::dynamics) fn remember(&mut self, t: f64) {
        match self {
            Self::InPlan(own) => own.system.remember(&mut own.flight, t),
            Self::Custom(own) => own.form.remember(own.start, &mut own.numbers, t),
        }
    }

    /// The rest of it from `t` on.
    pub(in crate::dynamics) fn resume(&self, t: f64) -> Self {
        let Self::Custom(own) = self else { return self.clone() };
        let state = own.state(t);
        let numbers = own.form.resume(own.flight(), &state);
        Self::Custom(Box::new(CustomFlight::new(&own.form, t, &state, numbers)))
    }

    /// Bound of the circular frequencies of a flight on other springs than the girder's bearings; `None` of others \[rad/s\].
    pub fn fastest_on_springs(&self) -> Option<f64> {
        match self {
            Self::InPlan(own) if own.on_springs => Some(own.system.fastest()),
            _ => None,
        }
    }

    /// Whether it is of a rigid girder in plan on other springs to the ground than its bearings.
    pub fn is_on_springs(&self) -> bool {
        matches!(self, Self::InPlan(own) if own.on_springs)
    }

    /// State at its beginning of a girder in plan where that determines the whole flight.
    pub(in crate::dynamics) fn as_girder_start(&self) -> Option<&PlanarState> {
        match self {
            Self::InPlan(own) if !own.flight.has_anchors() && !own.on_springs => Some(&own.flight.state),
            _ => None,
        }
    }

    /// Memory \[bytes\]; of the equation of motion where it is of this flight alone.
    pub fn bytes(&self) -> usize {
        let more = match self {
            Self::InPlan(own) => {
                own.flight.bytes() - size_of::<Flight>() + if own.on_springs { size_of::<FreeMotion>() } else { 0 }
            }
            Self::Custom(own) => {
                let state = if own.state.spilled() { size_of_val(own.state.as_slice()) } else { 0 };
                size_of::<CustomFlight>() + state + size_of_val(own.numbers.as_slice())
            }
        };
        size_of::<Self>() + more
    }

    /// Every number that the flight's answer depends on, for hashing.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        std::iter::once(self.start()).chain(self.initial().iter().copied())
    }
}
