//! A body whose displacement is given as a function of time: displacement along the axes of the world, then its rate. Forces do not
//! move it.

use std::ops::Range;
use std::sync::Arc;

use glam::{DMat3, DQuat, DVec3};

use crate::contact::Frame;
use crate::dynamics::linear::FlightParameters;
use crate::dynamics::model::body::{Body, BodyEnergies, BodyPowers, Coordinates, Counted, Point};
use crate::dynamics::model::closed_form::ClosedForm;
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::wrench::Wrench;
use crate::motion::Ground;
use crate::motion::support::RelativeMotion;

/// Times [`RelativeMotion::pace`] over which a bound looks ahead: as far as one of a body under a record.
const AHEAD: f64 = 8.0;

/// Displacement against the ground of reference, along x, y and, in space, z.
#[derive(Clone, Debug)]
pub(in crate::dynamics) struct GivenMotion {
    /// The displacement.
    pub motion: RelativeMotion,
    /// Number of the world's axes that it moves along.
    pub axes: usize,
}

impl GivenMotion {
    pub(super) fn vector(&self, part: &[f64]) -> DVec3 {
        let mut vector = DVec3::ZERO;
        (0..self.axes).for_each(|axis| vector[axis] = part[axis]);
        vector
    }

    fn write(&self, [velocity, displacement]: [DVec3; 2], out: &mut [f64]) {
        for axis in 0..self.axes {
            (out[axis], out[self.axes + axis]) = (displacement[axis], velocity[axis]);
        }
    }
}

impl Coordinates for GivenMotion {
    fn width(&self) -> usize {
        2 * self.axes
    }

    fn positions(&self) -> usize {
        self.axes
    }

    fn displacements(&self) -> Option<Range<usize>> {
        None
    }

    fn initial(&self, _: &Body) -> Vec<f64> {
        let mut state = vec![0.0; self.width()];
        self.write(self.motion.at(0.0), &mut state);
        state
    }

    fn frame(&self, body: &Body, _: usize, state: &[f64]) -> Frame {
        let (place, rate) = state.split_at(self.axes);
        Frame { shift: self.vector(place), velocity: self.vector(rate), ..Frame::fixed(body.home) }
    }

    fn frame_since(&self, body: &Body, section: usize, state: &[f64]) -> Frame {
        self.frame(body, section, state)
    }

    fn attitude(&self, _: &Body, _: &[f64]) -> (f64, DQuat) {
        (0.0, DQuat::IDENTITY)
    }

    fn reference(&self, _: &Body, numbers: &[f64]) -> ReferencePose {
        let at = numbers.get(..3).map_or(DVec3::ZERO, |at| DVec3::new(at[0], at[1], at[2]));
        ReferencePose::level(at, 0.0, DMat3::ZERO)
    }

    fn rebase(&self, _: &Body, _: &mut [f64]) -> ReferencePose {
        // Its displacement is never summed over a run, so that its rounding is that of one number: counted from where it was placed.
        ReferencePose::level(DVec3::ZERO, 0.0, DMat3::ZERO)
    }

    fn restore(&self, _: &[f64], _: &mut [f64]) {}

    fn slope(&self, _: &Body, now: Counted<'_>, _: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        let acceleration = self.motion.acceleration(ground.since, ground.t);
        for axis in 0..self.axes {
            (out[axis], out[self.axes + axis]) = (now.state[self.axes + axis], acceleration[axis]);
        }
    }

    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        (0..self.axes).for_each(|axis| state[axis] += 0.5 * dt * dt * slope[self.axes + axis]);
    }

    fn size2(&self, _: &Body, difference: &[f64]) -> [f64; 2] {
        let (place, rate) = difference.split_at(self.axes);
        [self.vector(place).length_squared(), self.vector(rate).length_squared()]
    }

    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        if i < self.axes { place } else { omega * place }
    }

    fn excursion(&self, _: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        way(0..self.axes)
    }

    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        let [speed, acceleration] = rates(0..self.axes);
        MotionBounds { speed, acceleration, ..MotionBounds::still(f64::INFINITY) }
    }

    fn acceleration(&self, _: &Body, _: Point<'_>, _: DVec3) -> DVec3 {
        DVec3::ZERO
    }

    fn port(&self, _: &Body, _: Point<'_>, _: DVec3, _: [&mut [f64]; 2]) {}

    fn free_motion(&self, _: &Ground, _: f64) -> Option<Arc<dyn ClosedForm>> {
        Some(Arc::new(self.clone()))
    }

    fn next_kink(&self, t: f64) -> f64 {
        self.motion.next_kink(t)
    }

    fn given_velocity(&self, state: &[f64]) -> DVec3 {
        self.vector(&state[self.axes..])
    }

    fn fastest(&self, _: &Body) -> f64 {
        0.0
    }

    fn energies(&self, _: &Body, _: &[f64], _: f64) -> BodyEnergies {
        BodyEnergies::default()
    }

    fn powers(&self, _: &Body, _: &[f64], _: GroundNow) -> BodyPowers {
        BodyPowers::default()
    }
}

impl ClosedForm for GivenMotion {
    fn begin(&self, _: f64, _: &[&[f64]]) -> Vec<f64> {
        Vec::new()
    }

    fn window_end(&self, _: FlightParameters<'_>, t: f64) -> f64 {
        self.motion.next_kink(t).min(t + self.motion.pace())
    }

    fn state(&self, _: FlightParameters<'_>, t: f64, out: &mut [f64]) {
        self.write(self.motion.at(t), out);
    }

    fn bounds(&self, _: FlightParameters<'_>, t: f64, horizon: f64) -> MotionBounds {
        let window = horizon.min(AHEAD * self.motion.pace());
        let ([velocity, displacement], acceleration) = (self.motion.at(t), self.motion.peak());
        let speed = velocity.length() + acceleration * window;
        MotionBounds {
            reach: displacement.length() + speed * window,
            speed,
            acceleration,
            ..MotionBounds::still(window)
        }
    }

    fn works(&self, _: FlightParameters<'_>, _: [f64; 2]) -> Option<[f64; 4]> {
        Some([0.0; 4])
    }

    fn has_works(&self) -> bool {
        true
    }
}
