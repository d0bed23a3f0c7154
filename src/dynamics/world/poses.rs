//! States and poses of the bodies of a group on their present trajectories.

use crate::contact::{Frame, Local, locate};
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::Trajectory;

impl World {
    /// State of a body at `t` on its trajectory, relative to its placed pose.
    pub(in crate::dynamics) fn state(&self, slot: usize, t: f64) -> Vec<f64> {
        let track = &self.bodies[slot];
        match &track.now {
            Trajectory::Placed => self.model.bodies[track.body].initial(),
            Trajectory::Flight(flight) => flight.state(t).into_vec(),
            Trajectory::Island { island, index } => match &self.islands[*island] {
                Some(island) => {
                    let mut state = island.state_at(&self.model, *index, t);
                    self.model.bodies[track.body].restore(&island.system.bases[*index].numbers(), &mut state);
                    state
                }
                None => Vec::new(),
            },
        }
    }

    /// Reference pose of a body at `t` and its state relative to that pose: those of its island, or the pose at `t`
    /// for a body in flight or integrated alone.
    pub(in crate::dynamics) fn state_from_reference(&self, slot: usize, t: f64) -> (ReferencePose, Vec<f64>) {
        let track = &self.bodies[slot];
        if let Trajectory::Island { island, index } = track.now
            && let Some(island) = &self.islands[island]
            && !island.system.is_free(&self.model)
        {
            return (island.system.bases[index], island.state_at(&self.model, index, t));
        }
        let mut state = self.state(slot, t);
        (self.model.bodies[track.body].rebase(&mut state), state)
    }

    /// Pose of a section of a body at `t` on its trajectory, relative to its placed pose.
    pub(in crate::dynamics) fn frame(&self, slot: usize, section: usize, t: f64) -> Frame {
        let track = &self.bodies[slot];
        let body = &self.model.bodies[track.body];
        match &track.now {
            Trajectory::Placed => Frame::fixed(body.home),
            Trajectory::Flight(flight) => flight.frame(body, section, t),
            Trajectory::Island { island, index } => match &self.islands[*island] {
                Some(island) => island.frame(&self.model, *index, section, t),
                None => Frame::fixed(body.home),
            },
        }
    }

    /// Position and velocity of a corner relative to its face at `t`.
    pub(in crate::dynamics) fn local(&self, contact: usize, t: f64) -> Local {
        let site = self.site(contact);
        locate(&site.geometry, &self.side(contact, 0, t), &self.side(contact, 1, t))
    }

    /// Pose of the node's (`side` 0) or the face's (1) body of a contact; the fixed pose of an abutment.
    pub(in crate::dynamics) fn side(&self, contact: usize, side: usize, t: f64) -> Frame {
        let track = &self.contacts[contact];
        match track.slots[side] {
            Some(slot) => self.frame(slot, track.sections[side], t),
            None => self.model.sites[track.site].stand,
        }
    }

    /// Displacement and rate at `t` of a body of one coordinate in flight.
    pub(in crate::dynamics) fn coordinate(&self, slot: usize, t: f64) -> Option<[f64; 2]> {
        self.bodies[slot].flight()?.coordinate(t)
    }

    /// End of the stretch of a body's flight from `t` on within which it swings by about a radian at most \[s\].
    pub(in crate::dynamics) fn window_end(&self, slot: usize, t: f64) -> f64 {
        self.bodies[slot].flight().map_or(f64::INFINITY, |flight| flight.window_end(t))
    }

    /// Least and greatest value of the one coordinate of a body in flight over an interval without a kink \[m\]; all values where
    /// that is not known.
    pub(in crate::dynamics) fn flight_range(&self, slot: usize, span: [f64; 2]) -> [f64; 2] {
        let range = self.bodies[slot].flight().and_then(|flight| flight.range(span));
        range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY])
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec3;

    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, wall};
    use crate::dynamics::world::example::{in_flight, planned};

    #[test]
    fn before_the_start_a_body_is_as_placed() {
        let mut scene = wall();
        scene.girders[0].initial.velocity = [SPEED, 0.1, 0.0];
        let model = Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}"));
        let world = World::of(&Arc::new(model), 0);
        assert_eq!(world.state(0, 0.0), [0.0, 0.0, 0.0, SPEED, 0.1, 0.0], "with its initial velocity");
        assert_eq!(world.frame(0, 0, 0.0), Frame::fixed(world.model.bodies[0].home));
        assert_eq!((world.window_end(0, 0.0), world.coordinate(0, 0.0)), (f64::INFINITY, None));
        assert_eq!(world.flight_range(0, [0.0, 1.0]), [f64::NEG_INFINITY, f64::INFINITY], "nothing is known");
    }

    #[test]
    fn a_body_in_flight_moves_at_its_velocity_and_is_its_own_reference() {
        let world = in_flight(&wall(), &[[-0.01, 0.0, 0.0, SPEED, 0.1, 0.0]]);
        let (t, moved) = (0.2, DVec3::new(-0.01 + 0.2 * SPEED, 0.02, 0.0));
        let frame = world.frame(0, 0, t);
        assert!((frame.shift - moved).length() < 1e-16, "{}", frame.shift);
        assert!((frame.velocity - DVec3::new(SPEED, 0.1, 0.0)).length() < 1e-16, "{}", frame.velocity);
        let (base, state) = world.state_from_reference(0, t);
        assert!((base.planar() - moved).length() < 1e-16, "the pose at that time: {}", base.planar());
        assert_eq!(state[..3], [0.0; 3], "from which nothing has moved yet");
        let gap = world.local(0, t).gap;
        assert!((gap + moved.x).abs() < 1e-16, "behind a wall at its end: {gap} m");
    }

    #[test]
    fn a_body_in_a_step_moves_on_its_oscillation_from_its_reference() {
        let world = planned(&wall(), &[[0.0, 0.0, 0.0, SPEED, 0.0, 0.0]]);
        let island = world.islands[0].as_ref().expect("an island");
        let t = 0.5 * island.step.until;
        let omega = (STIFFNESS / MASS).sqrt();
        let [x, u] = [SPEED / omega * (omega * t).sin(), SPEED * (omega * t).cos()];
        let frame = world.frame(0, 0, t);
        assert!((frame.shift.x - x).abs() < 1e-9 * SPEED / omega, "{} m is not {x} m", frame.shift.x);
        assert!((frame.velocity.x - u).abs() < 1e-9 * SPEED, "{} m/s is not {u} m/s", frame.velocity.x);
        assert_eq!(world.state(0, t)[0], frame.shift.x);
        let (base, state) = world.state_from_reference(0, t);
        assert_eq!((base.planar(), state[0]), (DVec3::ZERO, frame.shift.x), "where its touch began");
    }

    #[test]
    fn an_abutment_stands_where_its_site_has_it() {
        let world = in_flight(&wall(), &[[0.0, 0.0, 0.0, 0.0, 0.3, 0.0]]);
        let [node, face] = [world.side(0, 0, 0.5), world.side(0, 1, 0.5)];
        assert!((node.shift.y - 0.15).abs() < 1e-16, "the girder has moved: {}", node.shift);
        assert_eq!(face, world.site(0).stand);
        assert_eq!(face.shift, DVec3::ZERO);
    }
}
