//! The connections between the ground and a body of one coordinate, where they are a spring with a constant force in their
//! present phases.

use crate::contact::Frame;
use crate::dynamics::model::body::Point;
use crate::dynamics::model::closed_form::GroundSpring;
use crate::dynamics::world::World;
use crate::dynamics::world::constants::FORCE_ROUNDING;
use crate::dynamics::world::tracks::Trajectory;

impl World {
    /// The spring that all connections which act on a body are together; `None` where one is not linear in its phase, has a
    /// dashpot or acts on another body, or where the body has several coordinates.
    pub(in crate::dynamics) fn ground_spring(&self, slot: usize) -> Option<GroundSpring> {
        let track = &self.bodies[slot];
        let body = &self.model.bodies[track.body];
        if body.positions() != 1 || track.pairs.iter().any(|&pair| self.pair_acts(pair)) {
            return None;
        }
        let along = body.frame(0, &[1.0, 0.0]).shift;
        let mut spring = GroundSpring::default();
        for &number in track.links.iter().filter(|&&number| self.link_acts(number)) {
            let own = &self.links[number];
            let link = &self.model.links[own.link];
            if own.slots != [Some(slot), None] || !link.device.is_linear_in(&own.phase) {
                return None;
            }
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

    /// Whether a link acts on a body in flight, which then is that of one coordinate.
    pub(in crate::dynamics) fn acts_in_flight(&self, link: usize) -> bool {
        let flies = |slot: usize| matches!(self.bodies[slot].now, Trajectory::Flight(_));
        self.links[link].slots[0].is_some_and(flies) && self.link_acts(link)
    }
}
