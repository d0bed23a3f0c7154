//! The free motion of a body of any degrees of freedom, where it has a closed form.

use std::sync::Arc;

use crate::contact::Frame;
use crate::dynamics::free_flight::flight::{Flight, FreeMotion};
use crate::dynamics::free_flight::ground_springs::GroundSprings;
use crate::dynamics::free_flight::uncoupled_axis::UncoupledAxis;
use crate::dynamics::linear::{self, Parts};
use crate::dynamics::model::body::{Body, BodyCoordinates};
use crate::dynamics::model::closed_form::ClosedForm;
use crate::dynamics::model::coordinates::BodyState;
use crate::dynamics::model::coordinates::planar::{PlanarState, in_a_row, is_along};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::motion::Ground;

/// A body's free equation of motion, prepared once.
#[derive(Clone, Debug)]
pub enum BodyMotion {
    /// Of a rigid girder in plan.
    RigidInPlan(Box<FreeMotion>),
    /// Of a body of other coordinates.
    Custom(Arc<dyn ClosedForm>),
}

/// One stretch of free motion of a body.
#[derive(Clone, Debug)]
pub enum BodyFlight {
    /// Of a rigid girder in plan.
    RigidInPlan(Flight),
    /// Of a body of other coordinates.
    Custom(Box<CustomFlight>),
}

/// A flight in a closed form that a body brings.
#[derive(Clone, Debug)]
pub struct CustomFlight {
    /// When it begins \[s\].
    start: f64,
    /// State at its beginning.
    state: BodyState,
    /// What the closed form computes from.
    numbers: Vec<f64>,
}

impl CustomFlight {
    /// What the closed form computes from, with when it begins.
    fn flight(&self) -> linear::Flight<'_> {
        linear::Flight { start: self.start, numbers: &self.numbers }
    }
}

impl BodyMotion {
    /// Of a body under a ground motion that lasts `duration` \[s\]; nothing where there is no closed form.
    pub fn of(body: &Body, ground: &Ground, duration: f64) -> Option<Self> {
        match &body.coordinates {
            BodyCoordinates::Planar => Some(Self::RigidInPlan(Box::new(FreeMotion::new(body, ground, duration)))),
            BodyCoordinates::Spatial => None,
            BodyCoordinates::Custom(coordinates) => coordinates.free_motion(ground, duration).map(Self::Custom),
        }
    }

    /// Begins a flight of a body that moves alone.
    pub fn fly(&self, start: f64, state: &[f64]) -> BodyFlight {
        self.fly_among(start, &[state], 0)
    }

    /// Begins the flight of one of several bodies that move together, by its number among them and the states of all.
    pub fn fly_among(&self, start: f64, states: &[&[f64]], own: usize) -> BodyFlight {
        let state = states[own];
        match (self, in_a_row(state)) {
            (Self::RigidInPlan(motion), [state]) => BodyFlight::RigidInPlan(motion.fly(start, *state)),
            (Self::Custom(form), _) => {
                let (state, numbers) = (state.into(), form.begin(start, states));
                BodyFlight::Custom(Box::new(CustomFlight { start, state, numbers }))
            }
            // A state of other width is of no girder.
            (Self::RigidInPlan(_), _) => {
                BodyFlight::Custom(Box::new(CustomFlight { start, state: state.into(), numbers: Vec::new() }))
            }
        }
    }

    /// Begins a flight of a body on springs to the ground, in a run of this duration \[s\]; `None` where that has no closed form.
    pub(in crate::dynamics) fn fly_on(
        &self,
        (body, duration): (&Body, f64),
        springs: &GroundSprings,
        start: f64,
        state: &[f64],
    ) -> Option<BodyFlight> {
        match (self, springs) {
            (Self::Custom(form), GroundSprings::OneCoordinate(spring)) => {
                let (numbers, state) = (form.begin_on(state, *spring)?, state.into());
                Some(BodyFlight::Custom(Box::new(CustomFlight { start, state, numbers })))
            }
            (Self::RigidInPlan(motion), GroundSprings::InPlan(springs)) => {
                let [state] = in_a_row(state) else { return None };
                let system = Arc::new(FreeMotion::on_springs(body, springs, &motion.ground, duration));
                let mut flight = system.fly(start, *state);
                flight.springs = Some(system);
                Some(BodyFlight::RigidInPlan(flight))
            }
            _ => None,
        }
    }

    /// The system and the flight of a rigid girder in plan: its own, or that on the springs of the flight.
    pub(in crate::dynamics) fn in_plan<'a>(&'a self, flight: &'a BodyFlight) -> Option<(&'a FreeMotion, &'a Flight)> {
        let (Self::RigidInPlan(motion), BodyFlight::RigidInPlan(flight)) = (self, flight) else { return None };
        Some((flight.springs.as_deref().unwrap_or(motion), flight))
    }

    /// Displacement and rate at `t` in `flight` of a body of one coordinate.
    pub(in crate::dynamics) fn coordinate(&self, flight: &BodyFlight, t: f64) -> Option<[f64; 2]> {
        let (Self::Custom(form), BodyFlight::Custom(own)) = (self, flight) else { return None };
        let mut out: [f64; 2] = own.state.as_slice().try_into().ok()?;
        // As it was, to the last bit.
        if t != own.start {
            form.state(own.flight(), t, &mut out);
        }
        Some(out)
    }

    /// [`ClosedForm::window_end`]; infinite for a girder.
    pub(in crate::dynamics) fn window_end(&self, flight: &BodyFlight, t: f64) -> f64 {
        let (Self::Custom(form), BodyFlight::Custom(own)) = (self, flight) else { return f64::INFINITY };
        form.window_end(own.flight(), t)
    }

    /// [`ClosedForm::range`]; nothing of a girder.
    pub(in crate::dynamics) fn range(&self, flight: &BodyFlight, span: [f64; 2]) -> Option<[f64; 2]> {
        let (Self::Custom(form), BodyFlight::Custom(own)) = (self, flight) else { return None };
        form.range(own.flight(), span)
    }

    /// The rest of a flight from `t` on.
    pub(in crate::dynamics) fn resume(&self, flight: &BodyFlight, t: f64) -> BodyFlight {
        let (Self::Custom(form), BodyFlight::Custom(own)) = (self, flight) else { return flight.clone() };
        let state = custom_state(&**form, own, t);
        let numbers = form.resume(own.flight(), &state);
        BodyFlight::Custom(Box::new(CustomFlight { start: t, state, numbers }))
    }

    /// State at `t` in `flight`.
    pub fn state(&self, flight: &BodyFlight, t: f64) -> BodyState {
        if let Some((motion, flight)) = self.in_plan(flight) {
            return motion.state(flight, t).as_slice().into();
        }
        match (self, flight) {
            (Self::Custom(form), BodyFlight::Custom(flight)) => custom_state(&**form, flight, t),
            // A flight is begun by its own motion.
            _ => flight.state().into(),
        }
    }

    /// Pose and twist of a section of the body at `t` in `flight`.
    pub(in crate::dynamics) fn frame(&self, body: &Body, section: usize, flight: &BodyFlight, t: f64) -> Frame {
        match self.in_plan(flight) {
            Some((motion, flight)) => body.planar_frame(&motion.state(flight, t)),
            None => body.frame(section, &self.state(flight, t)),
        }
    }

    /// State at `t` of a girder that was in this state at `start`; nothing of another body.
    pub(in crate::dynamics) fn girder_state(&self, start: f64, from: PlanarState, t: f64) -> Option<PlanarState> {
        let Self::RigidInPlan(motion) = self else { return None };
        Some(motion.state(&motion.fly(start, from), t))
    }

    /// Bounds on the motion from `t` on for at most `horizon` \[s\].
    pub fn bounds(&self, flight: &BodyFlight, t: f64, horizon: f64) -> MotionBounds {
        if let Some((motion, flight)) = self.in_plan(flight) {
            return motion.state_and_bounds(flight, t, horizon).1;
        }
        match (self, flight) {
            (Self::Custom(form), BodyFlight::Custom(own)) => form.bounds(own.flight(), t, horizon),
            // A flight is begun by its own motion.
            _ => MotionBounds::still(horizon),
        }
    }

    /// [`ClosedForm::parts`] of a flight; nothing of a girder.
    pub(in crate::dynamics) fn parts(&self, flight: &BodyFlight, t: f64) -> Parts {
        match (self, flight) {
            (Self::Custom(form), BodyFlight::Custom(own)) => form.parts(own.flight(), t),
            _ => Parts::default(),
        }
    }

    /// Pose and twist of a section of the body at `t` in `flight`, with bounds on the motion from then on for at most `horizon` \[s\];
    /// from the parts of the flight.
    pub(in crate::dynamics) fn look(
        &self,
        (body, section): (&Body, usize),
        (flight, parts): (&BodyFlight, &Parts),
        [t, horizon]: [f64; 2],
    ) -> (Frame, MotionBounds) {
        match (self, flight) {
            (Self::Custom(form), BodyFlight::Custom(own)) => {
                let mut state = BodyState::from_elem(0.0, own.state.len());
                let bounds = form.look(own.flight(), parts, [t, horizon], &mut state);
                // As it was, to the last bit.
                let state = if t == own.start { &own.state } else { &state };
                (body.frame(section, state), bounds)
            }
            _ => (self.frame(body, section, flight, t), self.bounds(flight, t, horizon)),
        }
    }

    /// [`ClosedForm::works`] of a flight.
    pub fn works(&self, flight: &BodyFlight, span: [f64; 2]) -> Option<[f64; 4]> {
        let (Self::Custom(form), BodyFlight::Custom(own)) = (self, flight) else { return None };
        form.works(own.flight(), span)
    }

    /// [`ClosedForm::has_works`]; a girder has none.
    pub fn has_works(&self) -> bool {
        matches!(self, Self::Custom(form) if form.has_works())
    }

    /// [`ClosedForm::shapes`]; none of a rigid girder in plan.
    pub fn shapes(&self) -> Vec<[Vec<f64>; 2]> {
        let Self::Custom(form) = self else { return Vec::new() };
        form.shapes()
    }

    /// [`ClosedForm::second_derivatives`] of a flight.
    pub fn second_derivatives(&self, flight: &BodyFlight, span: [f64; 2]) -> Vec<f64> {
        let (Self::Custom(form), BodyFlight::Custom(own)) = (self, flight) else { return Vec::new() };
        form.second_derivatives(own.flight(), span)
    }

    /// [`ClosedForm::fastest`]; 0 for a rigid girder in plan, whose fastest frequency is that of its body alone \[rad/s\].
    pub fn fastest(&self) -> f64 {
        match self {
            Self::RigidInPlan(_) => 0.0,
            Self::Custom(form) => form.fastest(),
        }
    }

    /// Stores the states from which evaluations up to `t` start.
    pub(in crate::dynamics) fn remember(&self, flight: &mut BodyFlight, t: f64) {
        match (self, flight) {
            (Self::RigidInPlan(motion), BodyFlight::RigidInPlan(flight)) => {
                let springs = flight.springs.clone();
                springs.as_deref().unwrap_or(motion).remember(flight, t);
            }
            (Self::Custom(form), BodyFlight::Custom(own)) => form.remember(own.start, &mut own.numbers, t),
            // A flight is begun by its own motion.
            _ => {}
        }
    }

    /// One direction of a flight that moves along that world axis alone: its oscillator, the free part at the start, the push per unit mass;
    /// nothing where there is no such part.
    pub(in crate::dynamics) fn along<'a>(
        &'a self,
        flight: &'a BodyFlight,
        axis: usize,
    ) -> Option<(&'a UncoupledAxis, [f64; 2], f64)> {
        let (motion, flight) = self.in_plan(flight)?;
        let (dof, part) = is_along(&flight.state, axis).then(|| motion.along(flight, axis)).flatten()?;
        Some((dof, part, motion.push[axis]))
    }
}

fn custom_state(form: &dyn ClosedForm, flight: &CustomFlight, t: f64) -> BodyState {
    // As it was, to the last bit.
    if t == flight.start {
        return flight.state.clone();
    }
    let mut out = BodyState::from_elem(0.0, flight.state.len());
    form.state(flight.flight(), t, &mut out);
    out
}

impl BodyFlight {
    /// When it begins \[s\].
    #[inline]
    pub fn start(&self) -> f64 {
        match self {
            Self::RigidInPlan(flight) => flight.start,
            Self::Custom(flight) => flight.start,
        }
    }

    /// State at its beginning.
    #[inline]
    pub fn state(&self) -> &[f64] {
        match self {
            Self::RigidInPlan(flight) => &flight.state,
            Self::Custom(flight) => &flight.state,
        }
    }

    /// Bound of the circular frequencies of a flight on other springs than the girder's bearings; `None` of others \[rad/s\].
    pub fn fastest_on_springs(&self) -> Option<f64> {
        let Self::RigidInPlan(Flight { springs: Some(system), .. }) = self else { return None };
        Some(system.fastest())
    }

    /// Whether it is of a rigid girder in plan on other springs to the ground than its bearings.
    pub fn is_on_springs(&self) -> bool {
        matches!(self, Self::RigidInPlan(flight) if flight.springs.is_some())
    }

    /// The flight of a girder that its state at the start says all of.
    pub(in crate::dynamics) fn as_girder_start(&self) -> Option<&PlanarState> {
        match self {
            Self::RigidInPlan(flight) if !flight.has_anchors() && flight.springs.is_none() => Some(&flight.state),
            _ => None,
        }
    }

    /// What it takes \[bytes\].
    pub fn bytes(&self) -> usize {
        let more = match self {
            Self::RigidInPlan(flight) => flight.bytes() - size_of::<Flight>(),
            Self::Custom(flight) => {
                let state = if flight.state.spilled() { size_of_val(flight.state.as_slice()) } else { 0 };
                size_of::<CustomFlight>() + state + size_of_val(flight.numbers.as_slice())
            }
        };
        size_of::<Self>() + more
    }

    /// Every number that the flight's answer depends on, for hashing.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        std::iter::once(self.start()).chain(self.state().iter().copied())
    }
}
