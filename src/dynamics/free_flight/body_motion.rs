//! The free motion of a body of any degrees of freedom, where it has a closed form.

use std::sync::Arc;

use crate::dynamics::free_flight::body_flight::{BodyFlight, CustomFlight, FlightInPlan};
use crate::dynamics::free_flight::flight::FreeMotion;
use crate::dynamics::free_flight::ground_springs::GroundSprings;
use crate::dynamics::model::body::{Body, BodyCoordinates};
use crate::dynamics::model::closed_form::ClosedForm;
use crate::dynamics::model::coordinates::planar::{PlanarState, in_a_row};
use crate::motion::Ground;

/// A body's free equation of motion, prepared once.
#[derive(Clone, Debug)]
pub enum BodyMotion {
    /// Of a rigid girder in plan.
    InPlan(Arc<FreeMotion>),
    /// Of a body of other coordinates.
    Custom(Arc<dyn ClosedForm>),
}

impl BodyMotion {
    /// Free motion of a body under a ground motion that lasts `duration` \[s\]; `None` without a closed form.
    pub fn of(body: &Body, ground: &Ground, duration: f64) -> Option<Self> {
        match &body.coordinates {
            BodyCoordinates::Planar => Some(Self::InPlan(Arc::new(FreeMotion::new(body, ground, duration)))),
            BodyCoordinates::Spatial => None,
            BodyCoordinates::Custom(coordinates) => coordinates.free_motion(ground, duration).map(Self::Custom),
        }
    }

    /// Begins a flight of a body that moves alone; `None` where the state is not one of its.
    pub fn fly(&self, start: f64, state: &[f64]) -> Option<BodyFlight> {
        self.fly_among(start, &[state], 0)
    }

    /// Begins the flight of one of several bodies that move together, by its number among them and the states of all; `None` where its state
    /// is not one of its.
    pub fn fly_among(&self, start: f64, states: &[&[f64]], own: usize) -> Option<BodyFlight> {
        let state = *states.get(own)?;
        Some(match self {
            Self::InPlan(system) => {
                let [state] = in_a_row(state) else { return None };
                let flight = system.fly(start, *state);
                BodyFlight::InPlan(FlightInPlan::on_bearings(Arc::clone(system), flight))
            }
            Self::Custom(form) => {
                let flight = CustomFlight::new(form, start, state, form.begin(start, states));
                BodyFlight::Custom(Box::new(flight))
            }
        })
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
                let numbers = form.begin_on(state, *spring)?;
                Some(BodyFlight::Custom(Box::new(CustomFlight::new(form, start, state, numbers))))
            }
            (Self::InPlan(own), GroundSprings::InPlan(springs)) => {
                let [state] = in_a_row(state) else { return None };
                let system = Arc::new(FreeMotion::on_springs(body, springs, &own.ground, duration));
                let flight = system.fly(start, *state);
                Some(BodyFlight::InPlan(FlightInPlan::on_springs(system, flight)))
            }
            _ => None,
        }
    }

    /// State at `t` of a girder in plan that was in state `from` at `start`; `None` of another body.
    pub fn girder_state(&self, start: f64, from: PlanarState, t: f64) -> Option<PlanarState> {
        let Self::InPlan(system) = self else { return None };
        Some(system.state(&system.fly(start, from), t))
    }

    /// [`ClosedForm::has_works`]; a rigid girder in plan has none.
    pub fn has_works(&self) -> bool {
        matches!(self, Self::Custom(form) if form.has_works())
    }

    /// [`ClosedForm::shapes`]; none of a rigid girder in plan.
    pub fn shapes(&self) -> Vec<[Vec<f64>; 2]> {
        let Self::Custom(form) = self else { return Vec::new() };
        form.shapes()
    }

    /// [`ClosedForm::fastest`]; 0 for a rigid girder in plan, whose fastest frequency is that of its body alone \[rad/s\].
    pub fn fastest(&self) -> f64 {
        match self {
            Self::InPlan(_) => 0.0,
            Self::Custom(form) => form.fastest(),
        }
    }
}
