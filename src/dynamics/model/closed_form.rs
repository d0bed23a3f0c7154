//! The interface of a body's free motion in closed form.

use std::fmt::Debug;

use crate::dynamics::linear::{FlightParameters, ModalCoordinates};
use crate::dynamics::model::motion_bounds::MotionBounds;

/// Force of connections between the ground and a body of one coordinate u, per unit mass: `load − stiffness u`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GroundSpring {
    /// \[1/s²\].
    pub stiffness: f64,
    /// \[m/s²\].
    pub load: f64,
}

/// The free motion of a body: bearings, given pushes and ground, without contact.
///
/// A [`FlightParameters`] is computed from when it began and from the numbers that [`begin`](Self::begin) makes of the state then; states are those
/// since the body was placed.
pub trait ClosedForm: Debug + Send + Sync {
    /// Parameters of a flight that begins at `start`, from the states of the bodies that move together, in their order.
    fn begin(&self, _start: f64, states: &[&[f64]]) -> Vec<f64> {
        states.concat()
    }

    /// Parameters of a flight from this state on springs to the ground; `None` without a closed form.
    fn begin_on(&self, _state: &[f64], _spring: GroundSpring) -> Option<Vec<f64>> {
        None
    }

    /// Adds the states that evaluations up to `t` start from.
    fn remember(&self, _start: f64, _numbers: &mut Vec<f64>, _t: f64) {}

    /// End of the stretch from `t` on within which the motion is smooth and swings by about a radian at most \[s\].
    fn window_end(&self, _flight: FlightParameters<'_>, _t: f64) -> f64 {
        f64::INFINITY
    }

    /// Least and greatest value of the only coordinate over an interval without a kink \[m\]; `None` with several coordinates.
    fn range(&self, _flight: FlightParameters<'_>, _span: [f64; 2]) -> Option<[f64; 2]> {
        None
    }

    /// Bound of the displacement from where the body was placed, up to `until`, at less cost than [`bounds`](Self::bounds) and less
    /// sharp \[m\]; `None` without one.
    fn displacement_bound(&self, _flight: FlightParameters<'_>, _until: f64) -> Option<f64> {
        None
    }

    /// Numbers of the rest of a flight, from `t` on with this state.
    fn resume(&self, flight: FlightParameters<'_>, _state: &[f64]) -> Vec<f64> {
        flight.numbers.to_vec()
    }

    /// State at `t` of a flight, written to `out`.
    fn state(&self, flight: FlightParameters<'_>, t: f64, out: &mut [f64]);

    /// Bounds on the motion of any section in a flight from `t` on for at most `horizon` \[s\].
    fn bounds(&self, flight: FlightParameters<'_>, t: f64, horizon: f64) -> MotionBounds;

    /// States of the body by a unit coefficient of each exponential of its motion, 1 and i, beside that at rest; none of a motion that is
    /// no sum of exponentials.
    fn shapes(&self) -> Vec<[Vec<f64>; 2]> {
        Vec::new()
    }

    /// Bounds of the second derivatives of their coefficients in a flight over a stretch, in the same order.
    fn second_derivatives(&self, _flight: FlightParameters<'_>, _span: [f64; 2]) -> Vec<f64> {
        Vec::new()
    }

    /// Fastest circular frequency of the motion of the bodies that move together, as rigid ones; 0 where that is the body's own \[rad/s\].
    fn fastest(&self) -> f64 {
        0.0
    }

    /// Common part of the states and bounds at `t` of all bodies that move together.
    fn parts(&self, _flight: FlightParameters<'_>, _t: f64) -> ModalCoordinates {
        ModalCoordinates::default()
    }

    /// State and bounds at `t` together, from these parts.
    fn look(
        &self,
        flight: FlightParameters<'_>,
        _parts: &ModalCoordinates,
        t: [f64; 2],
        out: &mut [f64],
    ) -> MotionBounds {
        let [t, horizon] = t;
        self.state(flight, t, out);
        self.bounds(flight, t, horizon)
    }

    /// Work of the ground's inertia forces and of pushes, losses in bearings and in the body, over a stretch without a kink of the
    /// ground's motion \[J\], with those of bodies that move together at the first of them; `None` where they are left to quadrature.
    fn works(&self, _flight: FlightParameters<'_>, _span: [f64; 2]) -> Option<[f64; 4]> {
        None
    }

    /// Whether it says what [`works`](Self::works) asks for.
    fn has_works(&self) -> bool {
        false
    }
}
