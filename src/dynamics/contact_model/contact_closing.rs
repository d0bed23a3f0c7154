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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::normal::Linear;
    use crate::contact::{FrictionLaw, Normal};
    use crate::dynamics::Model;
    use crate::dynamics::contact_model::example::AtEvent;
    use crate::dynamics::model::coordinates::planar::PlanarState;
    use crate::dynamics::penalty3d::active_contact::ActiveContact;
    use crate::dynamics::penalty3d::example::{SPEED, STIFFNESS, closed, free_to_turn, stick, wall};

    /// Part of the pair's stiffness of each of the two corners \[N/m\].
    const NODE: f64 = 0.5 * STIFFNESS;

    /// A girder that may turn before its wall, with friction of 0.5, in this state; both corners open, and closed for a test that asks.
    fn at_wall(state: PlanarState, change: impl FnOnce(&mut Model)) -> (AtEvent, Vec<ActiveContact>) {
        let (mut model, active) = closed(&free_to_turn(wall()), stick);
        let law = &mut model.pairs[0].law;
        (law.friction, law.mu_s, law.mu_k) = (FrictionLaw::Paper.into(), 0.5, 0.4);
        change(&mut model);
        (AtEvent::of(model, &[], &[state]), active)
    }

    fn close(event: &mut AtEvent, contact: usize) {
        ContactClosing { states: &mut event.states() }.close(contact);
    }

    fn near(got: f64, expected: f64, what: &str) {
        assert!((got - expected).abs() <= 1e-9 * expected.abs(), "{what}: {got} is not {expected}");
    }

    #[test]
    fn an_impact_within_the_cone_sticks_and_an_oblique_one_slips_along_its_velocity() {
        // K|V_t| against μ_s K|V_n|: equal at half of the normal speed.
        for (along, kind) in [(0.49, EventKind::OpenToStick), (-0.51, EventKind::OpenToSlip)] {
            let (mut event, _) = at_wall([0.0, 0.0, 0.0, SPEED, along * SPEED, 0.0], |_| ());
            event.world.contacts[0].found.closing = Some(0.5);
            close(&mut event, 0);
            assert_eq!(event.kinds(), [(0, kind)], "{along} of the normal speed");
            let state = event.closed(0).expect("closed");
            near(state.law.k_t, NODE, "two corners share K");
            if let Mode::Slip { direction } = state.mode {
                let along = event.world.site(0).geometry.axes.x_axis * direction.x;
                near(along.y, -1.0, "towards −y");
            }
            let track = &event.world.contacts[0];
            assert_eq!((track.found.closing, track.changes.of_touch), (None, 1), "a touch begins");
        }
    }

    #[test]
    fn a_girder_at_rest_at_its_wall_closes_by_its_accelerations() {
        for (push, kind) in [(0.49, EventKind::OpenToStick), (0.51, EventKind::OpenToSlip)] {
            let pushed = |model: &mut Model| (model.bodies[0].push.x, model.bodies[0].push.y) = (8.0, push * 8.0);
            let (mut event, _) = at_wall([0.0; 6], pushed);
            close(&mut event, 0);
            assert_eq!(event.kinds(), [(0, kind)], "pushed along by {push} of the push in");
        }
    }

    #[test]
    fn an_overlap_by_round_off_enters_the_ledger_as_energy_that_appeared() {
        let (mut event, _) = at_wall([1e-9, 0.0, 0.0, SPEED, 0.0, 0.0], |_| ());
        close(&mut event, 0);
        near(event.released(), -0.5 * NODE * 1e-18, "half of K δ²");
    }

    #[test]
    fn a_contact_in_place_of_another_has_at_most_the_energy_of_that_ones_spring() {
        let (angle, half) = (0.01, 0.095);
        // The middle of the end is 1 mm behind the wall, its corners at ±35 mm of it are not equally deep.
        let x = 1e-3 + half * (1.0 - f64::cos(angle));
        for (left, entering) in [(0, 1), (1, 0)] {
            let (mut event, active) = at_wall([x, 0.0, angle, 0.0, 0.0, 0.0], |_| ());
            for contact in [0, 1] {
                let depth = 1e-3 - event.world.site(contact).point.y * f64::sin(angle);
                near(event.poses().local(contact).penetration(), depth, "depth of a corner");
            }
            let before = active[left].closed;
            ContactClosing { states: &mut event.states() }.close_in_place_of(&[(left, before)], entering, 3e-3);
            let least = 1e-3 - 0.035 * f64::sin(angle);
            near(event.released(), -0.5 * NODE * least * least, "the smaller of both energies");
            assert_eq!(event.closed(entering).expect("closed").solver.kept_beyond_edge, 3e-3);
            assert_eq!([left, entering].map(|contact| event.world.contacts[contact].has_part), [false, true]);
        }
    }

    #[test]
    fn at_the_start_a_node_in_the_wall_sticks_without_a_tangential_force() {
        let (mut event, _) = at_wall([1e-3, 2e-3, 0.0, 0.1, 0.2, 0.0], |_| ());
        ContactClosing { states: &mut event.states() }.close_overlapping();
        assert!(event.events.is_empty(), "the start is no event");
        for contact in [0, 1] {
            let (state, here) = (event.closed(contact).expect("closed"), event.states().here(contact));
            let forces = state.forces(&here);
            near(forces.normal, NODE * 1e-3, "its spring is pressed");
            assert_eq!(forces.tangential, DVec2::ZERO, "the anchor is at the projection");
        }
    }

    #[test]
    fn at_the_start_a_node_without_friction_slips_and_one_that_a_dashpot_would_pull_is_held_at_zero() {
        let smooth = |model: &mut Model| {
            let law = &mut model.pairs[0].law;
            (law.mu_s, law.mu_k, law.clamp) = (0.0, 0.0, true);
            law.normal = Normal::Linear(Linear { k: STIFFNESS, c: STIFFNESS * 2e-3 });
        };
        // K δ = C V at half a metre per second.
        for (out, held) in [(0.49, false), (0.51, true)] {
            let (mut event, _) = at_wall([1e-3, 0.0, 0.0, -out, -0.2, 0.0], smooth);
            ContactClosing { states: &mut event.states() }.close_overlapping();
            let state = event.closed(0).expect("closed");
            let Mode::Slip { direction } = state.mode else { panic!("{:?}", state.mode) };
            near((event.world.site(0).geometry.axes.x_axis * direction.x).y, -1.0, "along its velocity");
            assert_eq!(state.held_at_zero, held, "out at {out} m/s");
        }
    }

    #[test]
    fn at_the_start_a_node_beside_its_face_is_disarmed_and_one_as_placed_or_before_it_is_armed() {
        for (state, armed) in [
            ([0.0; 6], true),
            ([-1e-3, 0.0, 0.0, 0.0, 0.0, 0.0], true),
            // The wall ends at 1 m.
            ([1e-3, 1.2, 0.0, 0.0, 0.0, 0.0], false),
        ] {
            let (mut event, _) = at_wall(state, |_| ());
            ContactClosing { states: &mut event.states() }.close_overlapping();
            let states = [0, 1].map(|contact| event.world.contacts[contact].state);
            assert_eq!(states, [Contact::Open { armed }; 2], "{state:?}");
        }
    }
}
