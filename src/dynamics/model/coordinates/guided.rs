//! A body that moves along one horizontal direction and does not turn: displacement u along it, and u̇. Free of bearings.

use std::ops::Range;
use std::sync::Arc;

use glam::{DMat3, DQuat, DVec3};

use crate::contact::Frame;
use crate::dynamics::model::body::{Body, BodyEnergies, BodyPowers, Coordinates, Counted, Point};
use crate::dynamics::model::closed_form::ClosedForm;
use crate::dynamics::model::coordinates::guided_flight::GuidedFlight;
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::wrench::Wrench;
use crate::motion::Ground;

const PLACE: usize = 0;
const RATE: usize = 1;
const WIDTH: usize = 2;

/// The degree of freedom u.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Guided {
    /// Unit vector along which it moves, world axes.
    pub along: DVec3,
}

impl Guided {
    fn base(self, place: f64) -> ReferencePose {
        ReferencePose::level(self.along * place, 0.0, DMat3::ZERO)
    }
}

impl Coordinates for Guided {
    fn width(&self) -> usize {
        WIDTH
    }

    fn positions(&self) -> usize {
        RATE
    }

    fn displacements(&self) -> Option<Range<usize>> {
        None
    }

    fn initial(&self, _: &Body) -> Vec<f64> {
        vec![0.0; WIDTH]
    }

    fn frame(&self, body: &Body, _: usize, state: &[f64]) -> Frame {
        Frame { shift: self.along * state[PLACE], velocity: self.along * state[RATE], ..Frame::fixed(body.home) }
    }

    fn frame_since(&self, body: &Body, section: usize, state: &[f64]) -> Frame {
        self.frame(body, section, state)
    }

    fn attitude(&self, _: &Body, _: &[f64]) -> (f64, DQuat) {
        (0.0, DQuat::IDENTITY)
    }

    fn reference(&self, _: &Body, numbers: &[f64]) -> ReferencePose {
        let at = numbers.get(..2).map_or(DVec3::ZERO, |at| DVec3::new(at[0], at[1], 0.0));
        ReferencePose::level(at, 0.0, DMat3::ZERO)
    }

    fn rebase(&self, _: &Body, state: &mut [f64]) -> ReferencePose {
        let base = self.base(state[PLACE]);
        state[PLACE] = 0.0;
        base
    }

    fn restore(&self, numbers: &[f64], state: &mut [f64]) {
        if let [x, y, ..] = *numbers {
            state[PLACE] += self.along.x * x + self.along.y * y;
        }
    }

    fn slope(&self, body: &Body, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        out[PLACE] = now.state[RATE];
        out[RATE] = (contact[0].force / body.mass - ground.acceleration).dot(self.along);
    }

    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        state[PLACE] += 0.5 * dt * dt * slope[RATE];
    }

    fn size2(&self, _: &Body, difference: &[f64]) -> [f64; 2] {
        [difference[PLACE] * difference[PLACE], difference[RATE] * difference[RATE]]
    }

    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        if i == PLACE { place } else { omega * place }
    }

    fn excursion(&self, _: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        way(PLACE..RATE)
    }

    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        let [speed, acceleration] = rates(PLACE..RATE);
        MotionBounds { speed, acceleration, ..MotionBounds::still(f64::INFINITY) }
    }

    fn acceleration(&self, body: &Body, _: Point<'_>, force: DVec3) -> DVec3 {
        self.along * (force.dot(self.along) / body.mass)
    }

    fn port(&self, body: &Body, _: Point<'_>, force: DVec3, [response, load]: [&mut [f64]; 2]) {
        let force = force.dot(self.along);
        (response[RATE], load[RATE]) = (force / body.mass, force);
    }

    fn free_motion(&self, ground: &Ground, _: f64) -> Option<Arc<dyn ClosedForm>> {
        Some(Arc::new(GuidedFlight::under(ground, self.along)?))
    }

    fn fastest(&self, _: &Body) -> f64 {
        0.0
    }

    fn energies(&self, body: &Body, state: &[f64], _: f64) -> BodyEnergies {
        BodyEnergies { kinetic: 0.5 * body.mass * state[RATE] * state[RATE], ..BodyEnergies::default() }
    }

    fn powers(&self, body: &Body, state: &[f64], ground: GroundNow) -> BodyPowers {
        BodyPowers { ground: -body.mass * ground.acceleration.dot(self.along) * state[RATE], ..BodyPowers::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::penalty3d::example::wall;

    #[test]
    fn a_state_counted_from_a_reference_pose_is_the_same_place() {
        let guided = Guided { along: DVec3::new(0.6, 0.8, 0.0) };
        let mut state = [0.02, 0.3];
        let model = Model::compile(&wall()).expect("a scene");
        let base = guided.rebase(&model.bodies[0], &mut state);
        assert_eq!(state, [0.0, 0.3]);
        guided.restore(&base.numbers(), &mut state);
        assert!((state[PLACE] - 0.02).abs() < 1e-17, "{state:?}");
    }
}
