//! A body that moves along one horizontal direction of ground that moves as it is given, and does not turn: displacement u along the
//! direction against that ground, the ground's displacement, and their rates.

use std::ops::Range;

use glam::{DQuat, DVec3};

use crate::contact::Frame;
use crate::dynamics::model::body::{Body, BodyEnergies, BodyPowers, Coordinates, Counted, Point};
use crate::dynamics::model::coordinates::given_motion::GivenMotion;
use crate::dynamics::model::coordinates::guided::Guided;
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::wrench::Wrench;

const PLACE: usize = 0;

/// The degree of freedom u, on ground of given motion.
#[derive(Clone, Debug)]
pub(in crate::dynamics) struct GuidedOnGround {
    /// Its motion on still ground.
    pub own: Guided,
    /// Motion of the ground below.
    pub ground: GivenMotion,
}

impl GuidedOnGround {
    /// Number of places, and of rates.
    fn places(&self) -> usize {
        1 + self.ground.axes
    }

    /// Displacement or velocity, of the half of a state.
    fn whole(&self, half: &[f64]) -> DVec3 {
        self.own.along * half[PLACE] + self.ground.vector(&half[1..])
    }

    fn relative_acceleration(&self, ground: GroundNow) -> DVec3 {
        self.ground.motion.acceleration(ground.since, ground.t)
    }
}

impl Coordinates for GuidedOnGround {
    fn width(&self) -> usize {
        2 * self.places()
    }

    fn positions(&self) -> usize {
        self.places()
    }

    fn displacements(&self) -> Option<Range<usize>> {
        None
    }

    fn initial(&self, body: &Body) -> Vec<f64> {
        let given = self.ground.initial(body);
        let (places, rates) = given.split_at(self.ground.axes);
        [&[0.0], places, &[0.0], rates].concat()
    }

    fn frame(&self, body: &Body, _: usize, state: &[f64]) -> Frame {
        let (place, rate) = state.split_at(self.places());
        Frame { shift: self.whole(place), velocity: self.whole(rate), ..Frame::fixed(body.home) }
    }

    fn frame_since(&self, body: &Body, section: usize, state: &[f64]) -> Frame {
        self.frame(body, section, state)
    }

    fn attitude(&self, body: &Body, state: &[f64]) -> (f64, DQuat) {
        self.own.attitude(body, state)
    }

    // The ground's displacement is never summed over a run: counted from where it was placed.
    fn reference(&self, body: &Body, numbers: &[f64]) -> ReferencePose {
        self.own.reference(body, numbers)
    }

    fn rebase(&self, body: &Body, state: &mut [f64]) -> ReferencePose {
        self.own.rebase(body, state)
    }

    fn restore(&self, numbers: &[f64], state: &mut [f64]) {
        self.own.restore(numbers, state);
    }

    fn slope(&self, body: &Body, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        let (places, rates) = out.split_at_mut(self.places());
        places.copy_from_slice(&now.state[self.places()..]);
        let given = self.relative_acceleration(ground);
        rates[PLACE] = (contact[0].force / body.mass - ground.acceleration - given).dot(self.own.along);
        (0..self.ground.axes).for_each(|axis| rates[1 + axis] = given[axis]);
    }

    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        let gains = &slope[self.places()..];
        state.iter_mut().zip(gains).for_each(|(place, gain)| *place += 0.5 * dt * dt * gain);
    }

    fn size2(&self, _: &Body, difference: &[f64]) -> [f64; 2] {
        let (place, rate) = difference.split_at(self.places());
        [place, rate].map(|half| half.iter().map(|d| d * d).sum())
    }

    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        if i < self.places() { place } else { omega * place }
    }

    fn excursion(&self, _: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        way(PLACE..1) + way(1..self.places())
    }

    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        let ([own, own_gain], [given, given_gain]) = (rates(PLACE..1), rates(1..self.places()));
        MotionBounds { speed: own + given, acceleration: own_gain + given_gain, ..MotionBounds::still(f64::INFINITY) }
    }

    fn acceleration(&self, body: &Body, point: Point<'_>, force: DVec3) -> DVec3 {
        self.own.acceleration(body, point, force)
    }

    fn port(&self, body: &Body, _: Point<'_>, force: DVec3, [response, load]: [&mut [f64]; 2]) {
        let force = force.dot(self.own.along);
        let rate = self.places() + PLACE;
        (response[rate], load[rate]) = (force / body.mass, force);
    }

    fn next_kink(&self, t: f64) -> f64 {
        self.ground.next_kink(t)
    }

    fn given_velocity(&self, state: &[f64]) -> DVec3 {
        self.ground.vector(&state[self.places() + 1..])
    }

    fn fastest(&self, _: &Body) -> f64 {
        0.0
    }

    // Against its own ground, as the works are.
    fn energies(&self, body: &Body, state: &[f64], _: f64) -> BodyEnergies {
        let rate = state[self.places() + PLACE];
        BodyEnergies { kinetic: 0.5 * body.mass * rate * rate, ..BodyEnergies::default() }
    }

    fn powers(&self, body: &Body, state: &[f64], ground: GroundNow) -> BodyPowers {
        let felt = (ground.acceleration + self.relative_acceleration(ground)).dot(self.own.along);
        BodyPowers { ground: -body.mass * felt * state[self.places() + PLACE], ..BodyPowers::default() }
    }
}
