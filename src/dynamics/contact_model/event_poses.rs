//! Poses of the bodies that an event concerns, and the geometry of their contacts at that time: places of nodes relative to their
//! faces, whether a node is over its face, round-off of a gap.

use glam::{DMat3, DVec2, DVec3};

use crate::contact::parameters::is_over;
use crate::contact::{Frame, Local, locate};
use crate::dynamics::closing::step_samples::resolution_of;
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::edge_node::Edge;
use crate::dynamics::world::{World, contact_points};
use crate::scene::Kind;

/// Poses of bodies at the time of an event.
#[derive(Debug)]
pub(in crate::dynamics) struct EventPoses {
    /// Time \[s\].
    pub t: f64,
    /// Slots of the bodies, ascending.
    pub slots: Vec<usize>,
    /// Layout of the states and sections.
    pub layout: StateLayout,
    /// Poses of all sections relative to the placed poses.
    pub frames: Vec<Frame>,
}

impl EventPoses {
    /// Poses on the present trajectories.
    pub(in crate::dynamics) fn of(world: &World, slots: Vec<usize>, t: f64) -> Self {
        let layout = world.layout_of(&slots);
        let sections = |(i, &slot): (usize, &usize)| layout.sections(i).enumerate().map(move |(own, _)| (slot, own));
        let sections = slots.iter().enumerate().flat_map(sections);
        let frames = sections.map(|(slot, section)| world.frame(slot, section, t)).collect();
        Self { t, slots, layout, frames }
    }

    /// Place of a body among those that the event concerns.
    pub(super) fn index_of(&self, slot: usize) -> Option<usize> {
        self.slots.binary_search(&slot).ok()
    }

    /// Pose of a body's section relative to its placed pose; `None` for a body that the event does not concern.
    pub(in crate::dynamics) fn pose(&self, slot: usize, section: usize) -> Option<Frame> {
        self.frames.get(self.section(slot, section)?).copied()
    }

    /// Place of a body's section in the lists of poses.
    pub(in crate::dynamics) fn section(&self, slot: usize, own: usize) -> Option<usize> {
        Some(self.layout.sections(self.index_of(slot)?).start + own)
    }
}

/// Contacts of a group of bodies in the poses at the time of an event.
#[derive(Clone, Copy)]
pub(in crate::dynamics) struct ContactPoses<'a> {
    /// Constant data and present states of the group.
    pub world: &'a World,
    /// Poses of the bodies that the event concerns.
    pub now: &'a EventPoses,
}

impl<'a> ContactPoses<'a> {
    /// The edge of an edge node.
    pub(in crate::dynamics) fn edge(&self, contact: usize) -> Option<&'a Edge> {
        self.world.edge(contact)
    }
}

impl ContactPoses<'_> {
    /// Pose from `frames` of the node's body (`which` 0) or the face's (1); the fixed pose of an abutment.
    pub(super) fn side(&self, contact: usize, which: usize, frames: &[Frame]) -> Frame {
        let track = &self.world.contacts[contact];
        let stand = self.world.model.sites[track.site].stand;
        let section = |slot: usize| self.now.section(slot, track.sections[which]);
        let frame = |slot: usize| section(slot).and_then(|i| frames.get(i)).copied().unwrap_or(stand);
        track.slots[which].map_or(stand, frame)
    }

    /// Poses of the node's and the face's body relative to the placed poses.
    pub(in crate::dynamics) fn sides(&self, contact: usize) -> [Frame; 2] {
        [0, 1].map(|which| self.side(contact, which, &self.now.frames))
    }

    /// Position and velocity of a node relative to its face, poses relative to the placed poses.
    pub(in crate::dynamics) fn local(&self, contact: usize) -> Local {
        let track = &self.world.contacts[contact];
        let geometry = self.world.model.sites[track.site].geometry_at(&track.place);
        let [node, face] = self.sides(contact);
        locate(&geometry, &node, &face)
    }

    /// Whether the projection of a node is inside its face's polygon, the face by which it is in the pair is the most opposed
    /// of its corner's, and the node touches no other face; of an edge node, whether the crossing is a contact point of its own.
    pub(in crate::dynamics) fn is_over(&self, contact: usize) -> bool {
        if self.edge(contact).is_some() {
            return contact_points::crossing(self.world, contact, &|contact| self.sides(contact)).is_some();
        }
        let here = self.local(contact);
        let face = &self.world.site(contact).face;
        is_over(face, here.at) && self.is_opposed_most(contact) && !self.touches_elsewhere(contact)
    }

    /// Whether of the faces that meet in the node that of its pair is the most opposed to the face before it.
    pub(in crate::dynamics) fn is_opposed_most(&self, contact: usize) -> bool {
        let Some(corner) = &self.world.site(contact).corner else { return true };
        let node = self.side(contact, 0, &self.now.frames);
        corner.is_opposed_most(|own| node.turn(own), self.normal(contact))
    }

    /// Outward unit normal of a contact's face.
    pub(in crate::dynamics) fn normal(&self, contact: usize) -> DVec3 {
        let track = &self.world.contacts[contact];
        let geometry = self.world.model.sites[track.site].geometry_at(&track.place);
        let [node, face] = self.sides(contact);
        geometry.normal(&node, &face)
    }

    /// Gap that is round-off of the positions \[m\].
    pub(super) fn resolution(&self, contact: usize) -> f64 {
        let [node, face] = self.sides(contact);
        let by_edge = self.edge(contact).map_or(1.0, |edge| edge.amplification(&edge.ends(&node, &face)).max(1.0));
        resolution_of(self.world, contact, node.shift.length() + face.shift.length()) * by_edge
    }

    /// Whether the node is in contact with another face of the same body, of which it touches one at a time.
    pub(in crate::dynamics) fn touches_elsewhere(&self, contact: usize) -> bool {
        self.world.contacts[contact].other_faces.iter().any(|&other| self.world.is_closed(other))
    }

    /// Whether a pose of a planar scene is the placed pose, exactly.
    pub(in crate::dynamics) fn is_as_placed(&self, frame: &Frame) -> bool {
        self.world.model.kind == Kind::Planar && frame.shift.truncate() == DVec2::ZERO && frame.turned == DMat3::ZERO
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::penalty3d::example::{SPEED, wall};
    use crate::dynamics::world::example::in_flight;

    /// The girder flush at its wall of 2 m in flight from this place and velocity \[m, m/s\], at 0.1 s.
    fn after(state: [f64; 6]) -> (World, EventPoses) {
        let world = in_flight(&wall(), &[state]);
        let now = EventPoses::of(&world, vec![0], 0.1);
        (world, now)
    }

    #[test]
    fn poses_are_those_of_the_trajectories_at_the_time_of_the_event() {
        let (_, now) = after([1e-3, 0.0, 0.0, -SPEED, 0.0, 0.0]);
        let frame = now.pose(0, 0).expect("the girder");
        assert!((frame.shift.x - (1e-3 - 0.1 * SPEED)).abs() < 1e-17, "{} m", frame.shift.x);
        assert_eq!(now.section(0, 0), Some(0));
        assert!(now.pose(1, 0).is_none(), "a body that the event does not concern");
    }

    #[test]
    fn a_node_is_over_its_face_within_the_width_of_the_wall() {
        for (way, over) in [(0.9, true), (1.1, false)] {
            let (world, now) = after([0.0, 0.0, 0.0, 0.0, 10.0 * way, 0.0]);
            let at = ContactPoses { world: &world, now: &now };
            assert_eq!([at.is_over(0), at.is_over(1)], [over; 2], "{way} m along a wall that ends at 1 m");
            assert!(at.local(0).gap.abs() <= at.resolution(0), "along the face: {} m", at.local(0).gap);
            assert!((at.normal(0) + DVec3::X).length() < 1e-15, "{}", at.normal(0));
        }
    }

    #[test]
    fn the_placed_pose_is_told_from_any_other() {
        for (x, placed) in [(0.0, true), (1e-300, false)] {
            let (world, now) = after([x, 0.0, 0.0, 0.0, 0.0, 0.0]);
            assert_eq!(ContactPoses { world: &world, now: &now }.is_as_placed(&now.frames[0]), placed, "{x} m");
        }
    }
}
