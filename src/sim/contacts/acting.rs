//! Closed contacts at any instant: their forces, as exactly as the run has them.
//!
//! A stiff contact is pressed by less than the last digit of the positions of its bodies. Node and face are therefore measured as during
//! the run: from the reference poses of the bodies.

use super::view::Contacts;
use crate::contact::{ContactGeometry, Frame, Mode};
use crate::dynamics::model::reference_pose::seen_from;
use crate::dynamics::penalty3d::contact_force::{Action, act_in, to_world};
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::sim::{ContactNow, ContactState, impact};

/// A closed contact at one instant.
struct Seen {
    /// State, with its anchor relative to the reference poses.
    closed: ClosedContact,
    /// Contact geometry at the reference poses.
    geometry: ContactGeometry,
    /// Poses of node's and face's body relative to the reference poses.
    since: [Frame; 2],
    /// Poses relative to the placed poses.
    sides: [Frame; 2],
}

impl Contacts<'_> {
    /// A closed contact at `t` with its sides, measured from the reference poses of its bodies as during the run.
    fn closed(self, contact: usize, t: f64) -> Option<Seen> {
        let site = &self.history.model().sites[contact];
        let log = self.history.trajectories.log(contact);
        let closed = log.since(t)?;
        // At the end of a run that gave up, the state of a contact may be relative to the reference pose of a step that was not kept:
        // there the state relative to the placed poses is taken.
        let step_is_kept = self.history.stop().is_none() || t < self.history.end();
        let sections = self.history.model().sections(contact);
        let side = |body: Option<usize>, which: usize| match body {
            Some(_) if !step_is_kept => None,
            Some(body) => {
                self.history.trajectories.since(body, sections[which], t).map(|(base, frame)| (Some(base), frame))
            }
            None => Some((None, site.stand)),
        };
        if let (Some((node, at_node)), Some((face, at_face))) = (side(site.node_body, 0), side(site.face_body, 1)) {
            let geometry = seen_from(site, &closed.place, [node.as_ref(), face.as_ref()]);
            let whole = [(node, at_node), (face, at_face)].map(|(base, at)| base.map_or(at, |base| base.whole(&at)));
            return Some(Seen { closed, geometry, since: [at_node, at_face], sides: whole });
        }
        let (closed, sides) = (*log.at(t).closed()?, self.history.trajectories.sides(contact, t));
        Some(Seen { closed, geometry: site.geometry_at(&closed.place), since: sides, sides })
    }

    /// Forces of a contact that is closed at `t`, and its state; nothing when it is open.
    pub(in crate::sim) fn acting(self, contact: usize, t: f64) -> Option<(ClosedContact, Action)> {
        let Seen { closed, geometry, since: [node, face], .. } = self.closed(contact, t)?;
        Some((closed, act_in(&geometry, &closed, &closed.mode, &node, &face)))
    }

    /// Contacts closed at `t`, in the order of their numbers.
    pub fn at(self, t: f64) -> Vec<ContactNow> {
        let t = t.clamp(0.0, self.history.end());
        if let Some(record) = self.history.impact() {
            return impact::forces::contacts(self.history, record, t);
        }
        (0..self.history.model().sites.len()).filter_map(|contact| self.contact(contact, t)).collect()
    }

    /// One contact at `t`; nothing when it is open.
    pub fn contact_at(self, contact: usize, t: f64) -> Option<ContactNow> {
        let t = t.clamp(0.0, self.history.end());
        if let Some(record) = self.history.impact() {
            return impact::forces::contacts(self.history, record, t).into_iter().find(|now| now.contact == contact);
        }
        (contact < self.history.model().sites.len()).then(|| self.contact(contact, t))?
    }

    /// One contact of the contact model at `t` within the run; nothing when it is open.
    pub(in crate::sim) fn contact(self, contact: usize, t: f64) -> Option<ContactNow> {
        let site = &self.history.model().sites[contact];
        let Seen { closed, geometry, since, sides: [node, face] } = self.closed(contact, t)?;
        let action = act_in(&geometry, &closed, &closed.mode, &since[0], &since[1]);
        let forces = &action.forces;
        let point = node.origin() + action.node_arm;
        let placed = site.geometry_at(&closed.place);
        let world = |v: glam::DVec2| {
            let along = action.crossed.in_axes(v.extend(0.0));
            to_world(&placed, &face, along.truncate(), along.z)
        };
        Some(ContactNow {
            contact,
            pair: site.pair,
            state: match closed.mode {
                Mode::Stick { .. } => ContactState::Stick,
                Mode::Slip { .. } => ContactState::Slip,
            },
            point,
            anchor: face.origin() + action.face_arm,
            normal: placed.normal(&node, &face),
            penetration: action.here.penetration(),
            normal_velocity: forces.normal_velocity,
            sliding: world(forces.sliding),
            normal_force: forces.normal,
            tangential_force: world(forces.tangential),
            normal_damping: forces.normal_damping,
            tangential_damping: world(forces.tangential_damping),
            force: action.force,
            couple: action.couple,
            mu_static: closed.law.mu_s,
            mu_kinetic: closed.law.mu_k,
        })
    }
}
