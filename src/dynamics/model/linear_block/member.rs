//! One body of a linear block, as a body whose free motion has a closed form.

use std::sync::Arc;

use super::block::LinearBlock;
use crate::dynamics::linear::{FlightParameters, ModalCoordinates};
use crate::dynamics::model::closed_form::ClosedForm;
use crate::dynamics::model::motion_bounds::MotionBounds;

/// The free motion of one body of a block; states of all its bodies begin a flight, in their order.
#[derive(Debug)]
pub struct BlockMember {
    /// The block.
    pub block: Arc<LinearBlock>,
    /// Number of the body in it.
    pub member: usize,
}

impl ClosedForm for BlockMember {
    fn begin(&self, start: f64, states: &[&[f64]]) -> Vec<f64> {
        self.block.begin_all(start, states)
    }

    fn state(&self, flight: FlightParameters<'_>, t: f64, out: &mut [f64]) {
        self.block.write(self.member, &self.block.motion.at(flight, t), out);
    }

    fn bounds(&self, flight: FlightParameters<'_>, t: f64, horizon: f64) -> MotionBounds {
        self.block.member_bounds(self.member, &self.block.motion.at(flight, t), horizon)
    }

    fn parts(&self, flight: FlightParameters<'_>, t: f64) -> ModalCoordinates {
        self.block.motion.at(flight, t)
    }

    fn look(
        &self,
        _: FlightParameters<'_>,
        parts: &ModalCoordinates,
        [_, horizon]: [f64; 2],
        out: &mut [f64],
    ) -> MotionBounds {
        self.block.write(self.member, parts, out);
        self.block.member_bounds(self.member, parts, horizon)
    }

    fn shapes(&self) -> Vec<[Vec<f64>; 2]> {
        self.block.shapes(self.member)
    }

    fn second_derivatives(&self, flight: FlightParameters<'_>, span: [f64; 2]) -> Vec<f64> {
        self.block.motion.second_derivatives(flight, span)
    }

    fn fastest(&self) -> f64 {
        self.block.fastest
    }

    fn has_works(&self) -> bool {
        true
    }

    /// Those of the block are the first body's.
    fn works(&self, flight: FlightParameters<'_>, span: [f64; 2]) -> Option<[f64; 4]> {
        Some(if self.member > 0 { [0.0; 4] } else { self.block.works_of_all(flight, span) })
    }
}
