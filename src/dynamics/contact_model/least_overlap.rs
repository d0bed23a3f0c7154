//! The face through which two bodies that have met are the least inside each other, and the node deepest behind it.
//!
//! Behind a face of one body lie nodes of the other; the overlap along the face's normal is the depth of the deepest. Of two
//! convex bodies that overlap, the face of the least overlap is the shortest way out (separating axes, of the faces' normals).
//! Along the normal of any other face the overlap is larger.

use glam::DVec3;

use crate::dynamics::ContactSite;
use crate::dynamics::contact_model::constants::{COSINE_ROUNDING, DEPTH_RATIO};
use crate::dynamics::contact_model::event_poses::ContactPoses;
use crate::dynamics::model::edge_node::Edge;
use crate::dynamics::model::edge_node::node_place::NodePlace;
use crate::dynamics::model::meeting::{Meeting, SectionPoses};
use crate::dynamics::penalty3d::constants::UNCARRIED;
use crate::dynamics::world::contact_points;
use crate::scene::facing::Side;

/// A face and the node deepest behind it.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct LeastOverlap {
    /// The contact of the two.
    pub contact: usize,
    /// Depth of the node behind the face's plane, negative before it \[m\].
    pub depth: f64,
}

/// The shortest way by which two bodies part.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct ShortestWay {
    /// Overlap along it \[m\].
    pub overlap: f64,
    /// Overlap that need not be carried \[m\].
    pub tolerated: f64,
    /// The contact along whose normal it is, where there is one that is as deep.
    pub contact: Option<usize>,
}

impl ContactPoses<'_> {
    /// The overlaps of a contact's two bodies, which have met, by the faces of both, the least first.
    fn overlaps(&self, contact: usize) -> Vec<LeastOverlap> {
        let mut faces: Vec<(Side, LeastOverlap)> = Vec::new();
        for contact in self.contacts_of_both_bodies(contact).filter(|&c| self.site(c).edge.is_none()) {
            let face = self.face_of(contact);
            let here = LeastOverlap { contact, depth: self.local(contact).penetration() };
            match faces.iter_mut().find(|(known, _)| *known == face) {
                None => faces.push((face, here)),
                // A node is in a pair for each of its own faces: the most opposed counts.
                Some((_, deepest))
                    if here.depth > deepest.depth || (here.depth == deepest.depth && self.is_opposed_most(contact)) =>
                {
                    *deepest = here;
                }
                Some(_) => {}
            }
        }
        faces.sort_by(|(_, a), (_, b)| a.depth.total_cmp(&b.depth));
        faces.into_iter().map(|(_, deepest)| deepest).collect()
    }

    /// Depth of the least overlap of a contact's two bodies: of that by their faces \[m\] and those along the normals of edge nodes in
    /// contact between them.
    fn least_depth(&self, contact: usize, by_faces: f64) -> f64 {
        let edges =
            self.contacts_of_both_bodies(contact).filter(|&c| self.site(c).edge.is_some() && self.world.is_closed(c));
        edges.filter_map(|c| self.overlap_along_normal(c)).fold(by_faces, f64::min)
    }

    /// Overlap of the two bodies of a contact along its normal \[m\]; `None` where they have not met in space.
    fn overlap_along_normal(&self, contact: usize) -> Option<f64> {
        self.overlap_along(contact, self.normal(contact))
    }

    /// Overlap of the two bodies of a contact along a unit vector outward of its face's body \[m\].
    fn overlap_along(&self, contact: usize, normal: DVec3) -> Option<f64> {
        let track = &self.world.contacts[contact];
        let pair = &self.world.pairs[track.pair];
        let meeting = &self.world.model.meetings[pair.meeting?];
        let out = usize::from(track.slots[0] == pair.slots[0]);
        Some(meeting.overlap_along(normal, out, &self.poses(contact, meeting)))
    }

    /// Poses of the sections of the two bodies of a contact, which have met.
    fn poses(&self, contact: usize, meeting: &Meeting) -> [SectionPoses; 2] {
        let stand = self.site(contact).stand;
        let slots = self.world.pair_of(contact).slots;
        [0, 1].map(|side| {
            let pose = |section: usize| slots[side].and_then(|slot| self.now.pose(slot, section)).unwrap_or(stand);
            meeting.solids[side].poses(pose)
        })
    }

    /// Whether two edges that are `depth` \[m\] across each other at a place are where the bodies part along their normal: they overlap
    /// along it by at most [`DEPTH_RATIO`] times that.
    pub(in crate::dynamics) fn parts_along(&self, contact: usize, place: &NodePlace, depth: f64) -> bool {
        let rounding = self.edge(contact).map_or(0.0, |edge| edge.tolerance);
        let overlap = self.overlap_along(contact, self.sides(contact)[1].turn(place.normal));
        overlap.is_none_or(|overlap| overlap <= DEPTH_RATIO * depth + rounding)
    }

    /// The least overlap of a contact's two bodies along the common perpendicular of two edges that are across each other without a
    /// contact.
    fn least_across_edges(&self, contact: usize) -> Option<LeastOverlap> {
        let across = |c: usize| {
            let edge = self.edge(c)?;
            let is_open = !self.world.is_closed(c);
            let crossing = is_open.then(|| contact_points::crossing_of_met(self.world, c, &|c| self.sides(c)))??;
            let place = edge.place(&crossing);
            let [node, face] = self.sides(c);
            let penetration = -edge.distance(&node, &face)?;
            let depth = self.overlap_along(c, face.turn(place.normal))?;
            let least_side = self.world.model.meetings[self.world.pair_of(c).meeting?].least_side;
            // Elsewhere the bodies are deeper along that normal than the edges: they do not part there.
            (depth <= penetration + UNCARRIED * least_side).then_some(LeastOverlap { contact: c, depth })
        };
        let all = self.contacts_of_both_bodies(contact).filter_map(across).filter(|across| across.depth > 0.0);
        all.min_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// The shortest way by which a contact's two bodies part; `None` where they have not met.
    pub(in crate::dynamics) fn shortest_way(&self, contact: usize) -> Option<ShortestWay> {
        let model = &self.world.model;
        // The contact may be of ends that face each other as placed.
        let meeting = &model.meetings[model.meeting_of(self.world.model_pair(self.world.contacts[contact].pair))?];
        let overlap = meeting.least_overlap(&self.poses(contact, meeting));
        let tolerated = UNCARRIED * meeting.least_side;
        let by_face = self.overlaps(contact).first().copied();
        let all = by_face.into_iter().chain(self.least_across_edges(contact));
        let way = all.filter(|way| way.depth <= overlap + tolerated).min_by(|a, b| a.depth.total_cmp(&b.depth));
        Some(ShortestWay { overlap, tolerated, contact: way.map(|way| way.contact) })
    }

    /// Contact in which a node that crosses a plane of another body closes; `None` where other contacts carry the overlap of the bodies.
    ///
    /// The contact with the crossed face, where of the faces of the entered body this one is the nearest to the way of the least overlap,
    /// or where the bodies did not overlap. Otherwise, unless another contact carries the overlap, which this node takes over when that one
    /// leaves, the contact of the same node with that nearest face, where the penetration there is at most [`DEPTH_RATIO`] times the least
    /// depth; without one, the contact with the crossed face.
    pub(in crate::dynamics) fn contact_to_close(&self, contact: usize) -> Option<usize> {
        if self.site(contact).around.is_none() {
            return Some(contact);
        }
        let (overlaps, crossed) = (self.overlaps(contact), self.face_of(contact));
        let Some(least) = overlaps.first().filter(|least| least.depth > 0.0) else { return Some(contact) };
        let entered = crossed.solid();
        let normal = self.normal(least.contact);
        // Outward of the entered body.
        let way = if self.face_of(least.contact).solid() == entered { normal } else { -normal };
        let cosine = |contact: usize| self.normal(contact).dot(way);
        let of_entered = overlaps.iter().filter(|o| self.face_of(o.contact).solid() == entered);
        let nearest = of_entered.max_by(|a, b| cosine(a.contact).total_cmp(&cosine(b.contact)));
        let Some(nearest) = nearest.filter(|o| cosine(o.contact) > cosine(contact) + COSINE_ROUNDING) else {
            return Some(contact);
        };
        let from_beside = self.same_node_on_face_of(contact, nearest.contact);
        let depth = |other: &usize| self.local(*other).penetration();
        let least = self.least_depth(contact, least.depth);
        let is_alike = |other: &usize| depth(other) > 0.0 && depth(other) <= DEPTH_RATIO * least;
        let by = from_beside.filter(is_alike).unwrap_or(contact);
        (!self.is_carried_beside(by, least)).then_some(by)
    }

    /// Whether a node inside another body at t = 0, which came through no face, is in it by this contact: of bodies whose faces all
    /// touch, by a face along that of the least overlap, and not by the one behind it.
    pub(in crate::dynamics) fn begins_inside_by(&self, contact: usize) -> bool {
        let is_edge = self.edge(contact).is_some_and(Edge::is_of_met);
        if self.site(contact).around.is_none() && !is_edge {
            return true;
        }
        let least = self.overlaps(contact).first().map_or(0.0, |least| least.depth);
        let alike = self.local(contact).penetration() <= DEPTH_RATIO * least;
        alike && (is_edge || self.contact_to_close(contact) == Some(contact))
    }

    /// The contact that takes over where a node leaves its face over an edge while the two bodies overlap and no other contact
    /// carries that: of the least overlap, the node's own one included, or of one of at most [`DEPTH_RATIO`] times that depth whose node
    /// is inside its face. In space that can be along the common perpendicular of two edges.
    pub(in crate::dynamics) fn contact_taking_over(&self, contact: usize) -> Option<LeastOverlap> {
        if self.site(contact).around.is_none() && !self.edge(contact).is_some_and(Edge::is_of_met) {
            return None;
        }
        let overlaps = self.overlaps(contact);
        let least = *overlaps.first().filter(|least| least.depth > 0.0)?;
        if self.is_carried_beside(contact, self.least_depth(contact, least.depth)) {
            return None;
        }
        if let Some(across) = self.least_across_edges(contact).filter(|across| across.depth < least.depth) {
            return (!self.is_carried_beside(contact, across.depth)).then_some(across);
        }
        let inside = |other: &&LeastOverlap| {
            let is_before = self.site(other.contact).beyond(&NodePlace::default(), &self.local(other.contact)) < 0.0;
            other.contact != contact && other.depth <= DEPTH_RATIO * least.depth && is_before
        };
        Some(overlaps.iter().find(inside).copied().unwrap_or(least))
    }

    /// The contact of the same node with the face of `other`, by that face of the node's body which is the most opposed.
    fn same_node_on_face_of(&self, contact: usize, other: usize) -> Option<usize> {
        let (node, face) = (&self.site(contact).node, self.face_of(other));
        self.contacts_of_both_bodies(contact)
            .find(|&c| self.site(c).node == *node && self.face_of(c) == face && self.is_opposed_most(c))
    }

    /// Whether another closed contact of the same two bodies carries `depth` \[m\]: [`DEPTH_RATIO`] times its penetration is not less.
    pub(in crate::dynamics) fn is_carried_beside(&self, contact: usize, depth: f64) -> bool {
        let carries = |c: usize| self.world.is_closed(c) && DEPTH_RATIO * self.local(c).penetration() >= depth;
        self.contacts_of_both_bodies(contact).any(|c| c != contact && carries(c))
    }

    /// All contacts between the two bodies of a contact.
    fn contacts_of_both_bodies(&self, contact: usize) -> impl Iterator<Item = usize> + '_ {
        let own = self.world.model_pair(self.world.contacts[contact].pair).solids();
        // At least one of the two is a girder, and is in the group.
        let slot = self.world.contacts[contact].slots.into_iter().flatten().next();
        let pairs = slot.map_or(&[][..], |slot| &self.world.bodies[slot].pairs);
        let between = pairs.iter().filter(move |&&pair| self.world.model_pair(pair).solids() == own);
        between.flat_map(|&pair| self.world.pairs[pair].contacts.clone())
    }

    fn site(&self, contact: usize) -> &ContactSite {
        self.world.site(contact)
    }

    /// The face of a contact.
    fn face_of(&self, contact: usize) -> Side {
        let pair = self.world.model_pair(self.world.contacts[contact].pair);
        if pair.bodies[0] == self.site(contact).face_body { pair.first } else { pair.second }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::contact_model::example::AtEvent;
    use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
    use crate::dynamics::penalty3d::example::{closed, met, row, stick, wall};

    /// Overlap of the two girders along x and along y \[m\].
    const OVERLAP: [f64; 2] = [0.05, 0.01];

    /// Two girders of 0.19 m by 0.07 m that have met, the second beside the first: they overlap by 50 mm along and by 10 mm across.
    fn beside() -> AtEvent {
        let second = [-OVERLAP[0], 0.07 - OVERLAP[1], 0.0, 0.0, 0.0, 0.0];
        AtEvent::of(met(&row()), &[], &[[0.0; 6], second])
    }

    /// Contacts of the group whose node is this deep behind their face.
    fn as_deep(event: &AtEvent, depth: f64) -> Vec<usize> {
        let at = event.poses();
        (0..event.world.contacts.len()).filter(|&c| (at.local(c).penetration() - depth).abs() < 1e-12).collect()
    }

    /// The contact with the face whose normal is along an axis that is the deepest, of a node inside the polygon.
    fn inside(event: &AtEvent, axis: usize, depth: f64) -> usize {
        let at = event.poses();
        let is_inside = |&c: &usize| {
            let site = event.world.site(c);
            at.normal(c)[axis].abs() > 0.9 && site.over_edge(&at.local(c)) < 0.0
        };
        as_deep(event, depth).into_iter().find(is_inside).expect("a node behind a face, inside its edges")
    }

    /// Closes a contact as another one of the pair would be.
    fn close(event: &mut AtEvent, contact: usize) {
        let law = event.world.model_pair(event.world.contacts[contact].pair).law;
        let here = event.poses().local(contact);
        event.world.contacts[contact].state = Contact::Closed(ClosedContact::new(law, stick(&here), 0.0));
    }

    #[test]
    fn girders_that_overlap_less_across_than_along_part_across() {
        let event = beside();
        let way = event.poses().shortest_way(0).expect("they have met");
        assert!((way.overlap - OVERLAP[1]).abs() < 1e-15, "{} m", way.overlap);
        // Of the smallest side, the thickness of 20 mm or in plan the width of 70 mm.
        let side = event.world.model.meetings[0].least_side;
        assert!((side == 0.02 || side == 0.07) && way.tolerated == UNCARRIED * side, "{way:?}");
        let contact = way.contact.expect("a contact along that way");
        let at = event.poses();
        assert!((at.normal(contact).y.abs() - 1.0).abs() < 1e-15, "across: {}", at.normal(contact));
        assert!((at.local(contact).penetration() - OVERLAP[1]).abs() < 1e-15, "as deep as the overlap");
    }

    #[test]
    fn the_faces_of_two_bodies_are_ordered_by_the_overlap_along_their_normals() {
        let event = beside();
        let depths: Vec<f64> = event.poses().overlaps(0).iter().map(|least| least.depth).collect();
        assert_eq!(depths.len(), 8, "four faces of each of the two");
        // Out over the faces that look at the other girder, and over those behind: the rest of both lengths or widths.
        let [along, across] = [2.0 * 0.19 - OVERLAP[0], 2.0 * 0.07 - OVERLAP[1]];
        for (depth, expected) in
            depths.iter().zip([OVERLAP[1], OVERLAP[1], OVERLAP[0], OVERLAP[0], across, across, along, along])
        {
            assert!((depth - expected).abs() < 1e-15, "{depths:?}");
        }
    }

    #[test]
    fn a_node_that_crosses_an_end_of_girders_that_part_across_closes_with_the_side() {
        let event = beside();
        let crossed = inside(&event, 0, OVERLAP[0]);
        let by = event.poses().contact_to_close(crossed).expect("nothing carries the overlap");
        assert_eq!(event.world.site(by).node, event.world.site(crossed).node, "the same node");
        assert!(event.poses().normal(by).y.abs() > 0.9, "with the face along which they part");
        let side = inside(&event, 1, OVERLAP[1]);
        assert_eq!(event.poses().contact_to_close(side), Some(side), "which a node that crosses it closes with");
    }

    #[test]
    fn a_contact_of_half_the_overlap_carries_it_and_a_shallower_one_does_not() {
        let mut event = beside();
        let [side, end] = [inside(&event, 1, OVERLAP[1]), inside(&event, 0, OVERLAP[0])];
        assert!(!event.poses().is_carried_beside(end, 1e-9), "nothing is closed");
        close(&mut event, side);
        let carried = |depth: f64| event.poses().is_carried_beside(end, depth);
        assert!(carried(2.0 * OVERLAP[1] * (1.0 - 1e-9)) && !carried(2.0 * OVERLAP[1] * (1.0 + 1e-9)));
        assert!(!event.poses().is_carried_beside(side, 1e-9), "not beside itself");
        assert_eq!(event.poses().contact_to_close(end), None, "the closed one carries the overlap");
        assert!(event.poses().contact_taking_over(end).is_none());
    }

    #[test]
    fn where_nothing_carries_the_overlap_a_node_inside_the_side_takes_over() {
        let event = beside();
        let end = inside(&event, 0, OVERLAP[0]);
        let over = event.poses().contact_taking_over(end).expect("the bodies overlap");
        assert!((over.depth - OVERLAP[1]).abs() < 1e-15, "{} m", over.depth);
        assert!(event.poses().normal(over.contact).y.abs() > 0.9, "along the least overlap");
    }

    #[test]
    fn girders_apart_part_by_no_way_and_close_with_the_face_that_is_crossed() {
        let event = AtEvent::of(met(&row()), &[], &[[0.0; 6], [-0.05, 0.08, 0.0, 0.0, 0.0, 0.0]]);
        let way = event.poses().shortest_way(0).expect("they have met");
        assert!((way.overlap + 0.01).abs() < 1e-15, "10 mm apart: {}", way.overlap);
        for contact in 0..event.world.contacts.len() {
            assert_eq!(event.poses().contact_to_close(contact), Some(contact));
            assert!(event.poses().contact_taking_over(contact).is_none(), "nothing to take over");
        }
    }

    #[test]
    fn a_declared_pair_is_closed_by_the_face_that_is_crossed_and_taken_over_by_none() {
        let (model, _) = closed(&wall(), stick);
        let event = AtEvent::of(model, &[], &[[1e-3, 0.0, 0.0, 0.0, 0.0, 0.0]]);
        let at = event.poses();
        assert!(at.shortest_way(0).is_none(), "the girder and its wall have not met");
        assert_eq!((at.contact_to_close(0), at.begins_inside_by(0)), (Some(0), true));
        assert!(at.contact_taking_over(0).is_none());
    }
}
