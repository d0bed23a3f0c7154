//! A segment of a body's trajectory: its interval of time and the representation of its motion.

use crate::dynamics::free_flight::body_flight::BodyFlight;
use crate::dynamics::free_flight::sliding_face::SlidingFace;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;

/// One segment of a body's trajectory.
#[derive(Clone, Debug)]
pub struct Segment {
    /// Beginning \[s\].
    pub from: f64,
    /// End, before that of an integrator's step where an event ends it \[s\].
    pub until: f64,
    /// Motion between beginning and end.
    pub path: SegmentMotion,
}

/// Representation of a motion.
#[derive(Clone, Debug)]
pub enum SegmentMotion {
    /// Closed form.
    Flight(Box<BodyFlight>),
    /// Closed form of a face that slides along a wall (impact model).
    Slide(Box<SlidingFace>),
    /// Dense output of an integrator's step.
    Step(StepPolynomial),
    /// An integrator's step that is recomputed when read: its number in the group.
    Recomputed(u32),
}

impl Segment {
    /// Memory of the segment \[bytes\]; of a recomputed step without its initial state, which the group keeps.
    pub fn bytes(&self) -> usize {
        let path = match &self.path {
            SegmentMotion::Flight(flight) => flight.bytes(),
            SegmentMotion::Slide(_) => size_of::<SlidingFace>(),
            SegmentMotion::Step(piece) => piece.bytes() - size_of::<StepPolynomial>(),
            SegmentMotion::Recomputed(_) => 0,
        };
        size_of::<Self>() + path
    }
}
