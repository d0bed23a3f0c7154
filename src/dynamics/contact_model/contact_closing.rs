//! Closing of contacts at an event (`docs/physics.md#closing`): at the face, inside it, at t = 0.

use glam::DVec2;

use crate::contact::{Mode, NormalLaw};
use crate::dynamics::contact_model::contact_states::ContactStates;
use crate::dynamics::contact_model::vertices::VertexNodes;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::record::event::EventKind;
use crate::dynamics::world::contact_points;
use crate::dynamics::world::tracks::ContactTrack;

/// Closes contacts.
pub(in crate::dynamics) struct ContactClosing<'s, 'a> {
    /// The contacts of the group.
    pub states: &'s mut ContactStates<'a>,
}

impl ContactClosing<'_, '_> {
    /// Closing of a contact in stick or slip (`docs/physics.md#closing`); of bodies that have met, by the face of their least
    /// overlap.
    pub(in crate::dynamics) fn close(&mut self, contact: usize) {
        let by = self.states.poses().contact_to_close(contact);
        if by == Some(contact) {
            self.close_at_face(contact);
            return;
        }
        self.states.world.contacts[contact].found.closing = None;
        self.states.enter_state(contact, Contact::Open { armed: false });
        if let Some(by) = by
            && !self.states.world.is_closed(by)
            && !self.states.poses().touches_elsewhere(by)
            && !(VertexNodes { states: self.states }).is_held(by)
        {
            self.close_inside(by, 0.0);
        }
    }

    /// Closing of a contact whose node is at its face.
    fn close_at_face(&mut self, contact: usize) {
        self.states.set_place(contact, 0.0);
        let here = self.states.here(contact);
        let law = self.states.law_at_closing(contact);
        let (mut tangential, mut normal) = here.relative_velocity(DVec2::ZERO);
        if normal == 0.0 && tangential == DVec2::ZERO {
            (tangential, normal) = self.states.at().relative_acceleration(contact, &here);
        }
        let law = law.begun(&here);
        let mode = law.on_closing(&here, tangential, normal);
        let regularisation = self.states.at().regularisation_length(contact, &law, &here);
        let place = self.states.world.contacts[contact].place;
        let closed = ClosedContact { place, ..ClosedContact::new(law, mode, regularisation) };
        let kind = EventKind::of_closing(&mode);
        self.states.world.contacts[contact].found.closing = None;
        self.states.world.contacts[contact].changes.of_touch = 0;
        // Round-off leaves an overlap at the crossing; its strain energy enters the ledger as a negative release.
        let appeared = -law.entry_energy(&here);
        self.states.log(contact, Contact::Closed(closed), kind, appeared);
    }

    /// Closing of a contact whose node is inside already, kept up to `kept_beyond_edge` beyond the edges of its face \[m\]: the energy of
    /// its spring enters the ledger as a negative release.
    pub(super) fn close_inside(&mut self, contact: usize, kept_beyond_edge: f64) {
        let mut closed = self.closed_inside(contact);
        closed.solver.kept_beyond_edge = kept_beyond_edge;
        let here = self.states.here(contact);
        let kind = EventKind::of_closing(&closed.mode);
        let track = &mut self.states.world.contacts[contact];
        (track.found.closing, track.changes.of_touch) = (None, 0);
        self.states.log(contact, Contact::Closed(closed), kind, -closed.law.entry_energy(&here));
    }

    /// Closing of a contact whose node is inside already, and of the other node of its crossing, in place of contacts `left` of the same two
    /// bodies, which were in these states. The energy of the normal springs is at most that of those before: where it would be more, the
    /// parts of K and C are the smaller. They are kept up to `kept_beyond_edge` beyond the edges of their faces \[m\].
    pub(super) fn close_in_place_of(&mut self, left: &[(usize, ClosedContact)], contact: usize, kept_beyond_edge: f64) {
        let other = contact_points::other_of_crossing(self.states.world, contact).filter(|&other| {
            let poses = |c: usize| self.states.poses().sides(c);
            !self.states.world.is_closed(other)
                && left.iter().all(|(left, _)| *left != other)
                && contact_points::crossing_of_met(self.states.world, other, &poses).is_some()
        });
        let entering: Vec<usize> = std::iter::once(contact).chain(other).collect();
        for &node in &entering {
            self.states.set_place(node, 0.0);
        }
        let energy = |(left, before): &(usize, ClosedContact)| {
            before.law.normal.stored_energy(self.states.here(*left).penetration())
        };
        let energy: f64 = left.iter().map(energy).sum();
        let whole = |&node: &usize| self.states.law_at_closing(node).entry_energy(&self.states.here(node));
        let whole: f64 = entering.iter().map(whole).sum();
        for (left, _) in left {
            self.states.world.contacts[*left].has_part = false;
        }
        for node in entering {
            let track = &mut self.states.world.contacts[node];
            track.has_part = true;
            if energy > 0.0 && whole > energy {
                track.divisor *= whole / energy;
            }
            self.close_inside(node, kept_beyond_edge);
        }
    }

    /// State of a contact whose node is inside already: stick with the anchor at the projection, slip where `μ_s = 0`.
    fn closed_inside(&mut self, contact: usize) -> ClosedContact {
        let here = self.states.here(contact);
        let law = self.states.law_at_closing(contact).begun(&here);
        let regularisation = self.states.at().regularisation_length(contact, &law, &here);
        let mode = if law.has_friction() {
            Mode::Stick { anchor: here.way }
        } else {
            let (sliding, _) = here.relative_velocity(DVec2::ZERO);
            Mode::Slip { direction: sliding.try_normalize().unwrap_or(DVec2::X) }
        };
        let place = self.states.world.contacts[contact].place;
        let mut closed = ClosedContact { place, ..ClosedContact::new(law, mode, regularisation) };
        closed.held_at_zero = law.clamp && law.normal.can_pull() && closed.kink(&here) > 0.0;
        closed
    }

    /// States at t = 0 of nodes behind the plane of their face: stick with the anchor at the projection where that is
    /// inside the polygon (slip where `μ_s = 0`), disarmed otherwise (`docs/physics.md#closing`).
    pub(in crate::dynamics) fn close_overlapping(&mut self) {
        let now = &self.states.now.poses;
        let as_placed: Vec<bool> = now.frames.iter().map(|frame| self.states.poses().is_as_placed(frame)).collect();
        for contact in 0..self.states.world.contacts.len() {
            let ContactTrack { slots, sections, geometry, .. } = &self.states.world.contacts[contact];
            let mut sides = slots.iter().zip(sections).filter_map(|(slot, &own)| Some(((*slot)?, own)));
            if geometry.placed_gap >= 0.0
                && sides.all(|(slot, own)| now.section(slot, own).is_some_and(|section| as_placed[section]))
            {
                continue;
            }
            if self.states.poses().edge(contact).is_some() {
                if !self.states.poses().is_over(contact) {
                    continue;
                }
                self.states.set_place(contact, 0.0);
            }
            let here = self.states.poses().local(contact);
            let site = self.states.site(contact);
            // What touches as placed is behind by round-off at the most: it closes as the bodies press on each other.
            if here.gap >= -self.states.poses().resolution(contact) {
                continue;
            }
            // An edge node is at its crossing.
            let inside = site.beyond(&self.states.world.contacts[contact].place, &here) < 0.0;
            let inside = inside
                && self.states.poses().is_opposed_most(contact)
                && !self.states.poses().touches_elsewhere(contact);
            let state = if inside && self.states.poses().begins_inside_by(contact) {
                Contact::Closed(self.closed_inside(contact))
            } else {
                Contact::Open { armed: false }
            };
            self.states.enter_state(contact, state);
        }
    }
}
