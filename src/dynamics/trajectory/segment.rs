//! A segment of a body's trajectory: its interval of time and the representation of its motion.

use crate::dynamics::free_flight::body_motion::BodyFlight;
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
