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
