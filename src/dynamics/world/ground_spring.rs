//! The connections between the ground and a body, where force and displacement are linear in their present phases: of a body of one
//! coordinate a spring with a constant force, of a rigid girder in plan springs, dashpots and constant forces.

use glam::{DMat3, DVec3};

use crate::contact::Frame;
use crate::dynamics::connection::{Kinematics, Linearity, Link};
use crate::dynamics::free_flight::body_flight::BodyFlight;
use crate::dynamics::free_flight::ground_springs::{GroundSprings, PlanarSprings};
use crate::dynamics::model::body::{Body, BodyCoordinates, Point};
use crate::dynamics::model::closed_form::GroundSpring;
use crate::dynamics::model::coordinates::planar::{POSITIONS, PlanarState, WIDTH};
use crate::dynamics::world::World;
use crate::dynamics::world::constants::FORCE_ROUNDING;
use crate::dynamics::world::tracks::{LinkTrack, Trajectory};

impl World {
    /// Resultant of all connections that act on a body, as springs to the ground; `None` where one acts on another body as well, where a
    /// force is not linear in its phase (of a body of one coordinate: a switching function either), or where the motion has no closed form.
    pub(in crate::dynamics) fn ground_springs(&self, slot: usize) -> Option<GroundSprings> {
        let track = &self.bodies[slot];
        let body = &self.model.bodies[track.body];
        if track.pairs.iter().any(|&pair| self.pair_acts(pair)) {
            return None;
        }
        let is_planar = matches!(body.coordinates, BodyCoordinates::Planar);
        let linear = |&number: &usize| {
            let own = &self.links[number];
            let link = &self.model.links[own.link];
            let needed = if is_planar { Linearity::Force } else { Linearity::Whole };
            (link.device.linearity(&own.phase) >= needed && own.slots == [Some(slot), None]).then_some((own, link))
        };
        let acting: Option<Vec<(&LinkTrack, &Link)>> =
            track.links.iter().filter(|&&number| self.link_acts(number)).map(linear).collect();
        match body.coordinates {
            // Where they couple x, y and θ, a matrix exponential for every look costs more than steps do (docs/cost.md).
            BodyCoordinates::Planar => {
                in_plan(body, &acting?).filter(|springs| !springs.couple(body)).map(GroundSprings::InPlan)
            }
            _ if body.positions() == 1 => of_one_coordinate(body, &acting?).map(GroundSprings::OneCoordinate),
            _ => None,
        }
    }

    /// Begins a flight of a body in this state at `t` on its own bearings.
    pub(in crate::dynamics) fn fly(&self, slot: usize, state: &[f64], t: f64) -> Option<BodyFlight> {
        self.bodies[slot].free_motion.as_ref()?.fly(t, state)
    }

    /// Flight of the body in a slot on its springs to the ground; `None` without a closed form.
    pub(in crate::dynamics) fn fly_on(
        &self,
        slot: usize,
        state: &[f64],
        t: f64,
        springs: &GroundSprings,
    ) -> Option<BodyFlight> {
        let track = &self.bodies[slot];
        let body = &self.model.bodies[track.body];
        track.free_motion.as_ref()?.fly_on((body, self.model.duration), springs, t, state)
    }

    /// Links on a girder in flight in plan whose phases can end, ascending.
    pub(in crate::dynamics) fn phases_in_flight(&self, slot: usize) -> impl Iterator<Item = usize> {
        let track = &self.bodies[slot];
        let flies = track.flight().is_some_and(BodyFlight::is_on_springs);
        let ends = move |&link: &usize| flies && self.link_acts(link) && !self.is_linear_link(link);
        track.links.iter().copied().filter(ends)
    }

    /// Links of a girder in flight in plan, of which the given one is the first: the ends of their phases are searched together.
    pub(in crate::dynamics) fn phases_led_by(&self, link: usize) -> Option<Vec<usize>> {
        let led: Vec<usize> = self.phases_in_flight(self.links[link].slots[0]?).collect();
        (led.first() == Some(&link)).then_some(led)
    }

    /// Whether the end of a link's phase is searched with that of another.
    pub(in crate::dynamics) fn is_led(&self, link: usize) -> bool {
        let slot = self.links[link].slots[0];
        slot.is_some_and(|slot| self.phases_in_flight(slot).skip(1).any(|other| other == link))
    }

    /// Whether a link acts on a body in flight.
    pub(in crate::dynamics) fn acts_in_flight(&self, link: usize) -> bool {
        let flies = |slot: usize| matches!(self.bodies[slot].now, Trajectory::Flight(_));
        self.links[link].slots[0].is_some_and(flies) && self.link_acts(link)
    }
}

/// On a body of one coordinate; `None` where one has a dashpot.
fn of_one_coordinate(body: &Body, acting: &[(&LinkTrack, &Link)]) -> Option<GroundSpring> {
    let along = body.frame(0, &[1.0, 0.0]).shift;
    let mut spring = GroundSpring::default();
    for (own, link) in acting {
        let ground = Frame::fixed(link.homes[1]);
        let gain = |state: [f64; 2]| {
            let frame = body.frame(0, &state);
            let (motion, arms) = link.motion([&frame, &ground]);
            let force = link.force(&own.phase, &motion, &ground);
            body.acceleration(Point { section: 0, frame: &frame, arm: arms[0] }, force).dot(along)
        };
        let [placed, moved, rate] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(gain);
        if rate != placed {
            return None;
        }
        spring.load += placed;
        // A force that does not follow the displacement, as of a yielding base, differs by its rounding alone.
        let change = placed - moved;
        spring.stiffness += if change.abs() > FORCE_ROUNDING * placed.abs() { change } else { 0.0 };
    }
    Some(spring)
}

/// On a rigid girder in plan; `None` where the displacement of one is not linear in the rotation.
fn in_plan(body: &Body, acting: &[(&LinkTrack, &Link)]) -> Option<PlanarSprings> {
    let mut springs = PlanarSprings::NONE;
    for (own, link) in acting {
        if link.kinematics != Kinematics::Linear {
            return None;
        }
        let ground = Frame::fixed(link.homes[1]);
        let force = |state: PlanarState| {
            let (motion, arms) = link.motion([&body.planar_frame(&state), &ground]);
            let force = link.force(&own.phase, &motion, &ground);
            DVec3::new(force.x, force.y, arms[0].cross(force).z)
        };
        let placed = force([0.0; WIDTH]);
        let by = |i: usize| {
            let moved = force(std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
            let change = placed - moved;
            if change.length() > FORCE_ROUNDING * placed.length() { change } else { DVec3::ZERO }
        };
        springs.load += placed;
        springs.stiffness += DMat3::from_cols(by(0), by(1), by(2));
        springs.damping += DMat3::from_cols(by(POSITIONS), by(POSITIONS + 1), by(POSITIONS + 2));
    }
    Some(springs)
}
