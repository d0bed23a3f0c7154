//! A stretch of a body's trajectory: its interval of time and the representation of its motion.

use crate::dynamics::free_flight::body_motion::BodyFlight;
use crate::dynamics::free_flight::sliding_face::SlidingFace;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;

/// One stretch of a body's path.
#[derive(Clone, Debug)]
pub struct Segment {
    /// From \[s\].
    pub from: f64,
    /// Until; a step may have been meant to go further \[s\].
    pub until: f64,
    /// The motion in between.
    pub path: SegmentMotion,
}

/// How a stretch was computed.
#[derive(Clone, Debug)]
pub enum SegmentMotion {
    /// Closed form.
    Flight(Box<BodyFlight>),
    /// Closed form of a face that slides along a wall (impact model).
    Slide(Box<SlidingFace>),
    /// Continuous answer of an integrator's step.
    Step(StepPolynomial),
    /// The same, to be taken again by its number among the group's.
    Again(u32),
}
