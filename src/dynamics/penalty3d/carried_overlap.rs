//! The least overlap of two bodies that have met, against the penetrations of the contacts between them
//! (`docs/physics.md#contact-wherever-bodies-meet`).
//!
//! A contact keeps its normal as long as it lasts, while the shortest way by which the bodies part can turn to another face or to two other
//! edges. When the least overlap exceeds the penetration of the deepest contact, the contact along the shortest way takes over. The two
//! penetrations are equal at that time, so that the energy in the springs does not change.

use glam::DVec3;

use crate::contact::{Frame, locate};
use crate::dynamics::Model;
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::meeting::{SectionPoses, Solid};
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::constants::UNCARRIED;

/// The contacts of an island between two bodies that have met.
#[derive(Clone, Debug)]
pub(in crate::dynamics) struct MetContacts {
    /// Number in the model of the meeting of the two.
    meeting: usize,
    /// Of each of the two, its index in the island and its pose where it has none.
    sides: [(Option<usize>, Frame); 2],
    /// Numbers of the contacts in the island.
    contacts: Vec<usize>,
    /// Overlap beyond the deepest penetration that is tolerated \[m\].
    tolerated: f64,
}

/// The bodies of an island at an instant.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct BodiesAt<'a> {
    /// Positions of the sections of each body in `frames`.
    pub layout: &'a StateLayout,
    /// Reference poses.
    pub bases: &'a [ReferencePose],
    /// Closed contacts of the island.
    pub active: &'a [ActiveContact],
    /// Poses of the sections relative to the reference poses.
    pub frames: &'a [Frame],
}

impl BodiesAt<'_> {
    /// Pose of a section of a body relative to its placed pose; that of an abutment, which is no body of the island, is `stand`.
    fn whole(&self, index: Option<usize>, section: usize, stand: Frame) -> Frame {
        index.map_or(stand, |i| self.bases[i].whole(&self.frames[self.layout.sections(i).start + section]))
    }

    /// Depth behind its face of the corner of a contact that took over with a displacement \[m\]: that contact carries this overlap,
    /// whatever its spring's deformation. `None` of a contact without displacement, or of an edge node.
    fn corner_depth(&self, model: &Model, contact: &ActiveContact) -> Option<f64> {
        let site = &model.sites[contact.site];
        if site.edge.is_some() || contact.closed.place.shift == DVec3::ZERO {
            return None;
        }
        let sections = model.sections(contact.site);
        let node = self.whole(contact.ends[0], sections[0], site.stand);
        let face = self.whole(contact.ends[1], sections[1], site.stand);
        Some(locate(&site.geometry, &node, &face).penetration())
    }
}

/// Overlap that no contact force acts against.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct Excess {
    /// Least overlap less the deepest penetration and what is tolerated \[m\].
    pub value: f64,
    /// Number in the island of the deepest contact.
    pub deepest: usize,
}

impl MetContacts {
    /// The contacts between bodies that have met, by their two bodies.
    pub(in crate::dynamics) fn of(model: &Model, bodies: &[usize], active: &[ActiveContact]) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        if model.meetings.is_empty() {
            return all;
        }
        for (number, contact) in active.iter().enumerate() {
            let site = &model.sites[contact.site];
            let pair = &model.pairs[site.pair];
            let Some(meeting) = model.meeting_of(pair) else { continue };
            let own = contact.tolerated.max(UNCARRIED * model.meetings[meeting].least_side);
            if let Some(known) = all.iter_mut().find(|known| known.meeting == meeting) {
                known.contacts.push(number);
                known.tolerated = known.tolerated.max(own);
                continue;
            }
            let side = |body: Option<usize>| {
                (body.and_then(|body| bodies.iter().position(|&other| other == body)), site.stand)
            };
            all.push(Self { meeting, sides: pair.bodies.map(side), contacts: vec![number], tolerated: own });
        }
        all
    }

    /// Overlap that no contact carries.
    pub(in crate::dynamics) fn excess(&self, model: &Model, bodies: BodiesAt<'_>) -> Excess {
        let (deepest, penetration) = self.deepest(model, bodies);
        let overlap = model.meetings[self.meeting].least_overlap(&self.poses(model, bodies));
        Excess { value: overlap - penetration - self.tolerated, deepest }
    }

    /// Whether the deepest contact carries the overlap along its own normal, which is not less than the least.
    pub(in crate::dynamics) fn is_carried(&self, model: &Model, bodies: BodiesAt<'_>) -> bool {
        let (deepest, penetration) = self.deepest(model, bodies);
        let contact = &bodies.active[deepest];
        let out = usize::from(contact.ends[1] != self.sides[0].0);
        let normal = contact.normal(model, bodies.frames);
        let along = model.meetings[self.meeting].overlap_along(normal, out, &self.poses(model, bodies));
        along - penetration - self.tolerated < 0.0
    }

    /// Number of the deepest contact, and what it carries \[m\].
    fn deepest(&self, model: &Model, bodies: BodiesAt<'_>) -> (usize, f64) {
        let depth = |&number: &usize| {
            let contact = &bodies.active[number];
            let penetration = contact.look(model, bodies.frames).penetration();
            (number, penetration.max(bodies.corner_depth(model, contact).unwrap_or(f64::NEG_INFINITY)))
        };
        let deeper = |a: (usize, f64), b: (usize, f64)| if b.1 > a.1 { b } else { a };
        self.contacts.iter().map(depth).fold((self.contacts[0], f64::NEG_INFINITY), deeper)
    }

    /// Poses of the sections of both relative to their placed poses.
    fn poses(&self, model: &Model, bodies: BodiesAt<'_>) -> [SectionPoses; 2] {
        [0, 1].map(|side| {
            let (index, stand) = self.sides[side];
            model.meetings[self.meeting].solids[side].poses(|section| bodies.whole(index, section, stand))
        })
    }

    /// Sections of the two, each with the index of its body in the island.
    pub(in crate::dynamics) fn sections<'a>(&'a self, model: &'a Model) -> impl Iterator<Item = [usize; 2]> + 'a {
        let bodies = self.sides.iter().map(|(index, _)| *index).zip(&model.meetings[self.meeting].solids);
        let of_body = |(index, solid): (usize, &'a Solid)| solid.sections().iter().map(move |&own| [index, own]);
        bodies.filter_map(|(index, solid)| Some((index?, solid))).flat_map(of_body)
    }
}
