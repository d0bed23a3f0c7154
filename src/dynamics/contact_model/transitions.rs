//! Transitions of a closed contact at an event: breakaway, stop, opening, leaving its face (`docs/physics.md#contact-events`).

use crate::contact::Mode;
use crate::dynamics::contact_model::contact_closing::ContactClosing;
use crate::dynamics::contact_model::contact_states::ContactStates;
use crate::dynamics::contact_model::least_overlap::ShortestWay;
use crate::dynamics::contact_model::vertices::VertexNodes;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::penalty3d::due::Reason;
use crate::dynamics::record::event::EventKind;
use crate::dynamics::world::contact_points;
use crate::dynamics::world::tracks::ChangeCount;

/// Changes closed contacts.
pub(in crate::dynamics) struct Transitions<'s, 'a> {
    /// The contacts of the group.
    pub states: &'s mut ContactStates<'a>,
}

impl<'a> Transitions<'_, 'a> {
    fn closing(&mut self) -> ContactClosing<'_, 'a> {
        ContactClosing { states: self.states }
    }

    fn vertices(&mut self) -> VertexNodes<'_, 'a> {
        VertexNodes { states: self.states }
    }

    /// Breakaway, stop, opening and edge of a closed contact (`docs/physics.md#contact-events`).
    pub(in crate::dynamics) fn change(&mut self, contact: usize, reason: Reason) {
        let Some(closed) = self.states.closed(contact) else { return };
        match reason {
            Reason::Opening => {
                self.open(contact, &closed, EventKind::Opened);
            }
            Reason::Edge if self.vertices().follow(contact, closed) => {}
            Reason::Edge if closed.solver.handover_distance.is_some() => self.pass_edge(contact, closed),
            Reason::Edge => self.leave(contact, closed),
            Reason::Overlap => self.hand_over(contact, &closed),
            Reason::Switching => self.switch(contact, closed),
            Reason::Kink => {
                let here = self.states.here(contact);
                self.states.enter_without_event(contact, Contact::Closed(closed.after_kink(&here)));
            }
        }
    }

    /// Handles a corner whose projection leaves the polygon of its face, of bodies that have met: the other nodes at its vertex take the
    /// contact over; if there are none, it stays closed until the corner comes out of the body.
    fn pass_edge(&mut self, contact: usize, mut closed: ClosedContact) {
        if self.vertices().has_successors(contact, &closed) {
            self.open(contact, &closed, EventKind::LeftFace);
            return;
        }
        closed.solver.handover_distance = None;
        let site = self.states.site(contact);
        if site.beyond(&closed.place, &self.states.poses().local(contact)) < closed.solver.kept_beyond_edge {
            self.states.enter_without_event(contact, Contact::Closed(closed));
        } else {
            self.leave(contact, closed);
        }
    }

    /// A node leaves its face over an edge. Where the two bodies have met, still overlap, and no other contact carries the overlap, the
    /// contact of their least overlap takes over: another one, or this one beyond the edge, up to the same distance again.
    fn leave(&mut self, contact: usize, mut closed: ClosedContact) {
        let Some(least) = self.states.poses().contact_taking_over(contact) else {
            self.open(contact, &closed, EventKind::LeftFace);
            return;
        };
        if least.contact == contact {
            let site = self.states.site(contact);
            closed.solver.kept_beyond_edge =
                2.0 * site.beyond(&closed.place, &self.states.poses().local(contact)).max(least.depth);
            self.states.enter_without_event(contact, Contact::Closed(closed));
            return;
        }
        let passed_on = self.open(contact, &closed, EventKind::LeftFace);
        let open = !self.states.world.is_closed(least.contact);
        let carried = passed_on || self.states.poses().is_carried_beside(contact, least.depth);
        if open && !carried && !self.states.poses().touches_elsewhere(least.contact) {
            self.closing().close_in_place_of(&[(contact, closed)], least.contact, 2.0 * least.depth);
        }
    }

    /// The overlap of two bodies exceeds the penetration of their deepest contact: the contact of the least overlap takes over, at the same
    /// depth. Where there is none, or it is closed already, the tolerated overlap is doubled.
    fn hand_over(&mut self, contact: usize, closed: &ClosedContact) {
        let here = self.states.poses().local(contact).penetration();
        let Some(ShortestWay { overlap, tolerated, contact: to }) = self.states.poses().shortest_way(contact) else {
            self.states.world.contacts[contact].tolerated = f64::INFINITY;
            return;
        };
        let Some(to) = to.filter(|&to| !self.states.world.is_closed(to)) else {
            self.states.world.contacts[contact].tolerated = 2.0 * (overlap - here).max(tolerated);
            return;
        };
        // The nodes at its vertex have the same penetration and are passed over. Of a crossing of two edges both nodes open together.
        let mut left = vec![(contact, *closed)];
        let other = contact_points::other_of_crossing(self.states.world, contact).filter(|&other| other != to);
        left.extend(other.and_then(|other| Some((other, self.states.closed(other)?))));
        for (leaving, closed) in &left {
            self.states.open(*leaving, closed, EventKind::LeftFace);
        }
        self.states.forget_sharers_of_open(contact);
        for other in self.states.world.contacts[to].other_faces.clone() {
            if let Some(state) = self.states.closed(other) {
                self.open(other, &state, EventKind::LeftFace);
            }
        }
        if !self.states.world.is_closed(to) {
            self.closing().close_in_place_of(&left, to, 2.0 * overlap);
        }
    }

    /// Opens a contact. Where it left its face over an edge, its part of K and C is passed to the other nodes at its vertex; returns
    /// whether there was such a node.
    fn open(&mut self, contact: usize, closed: &ClosedContact, kind: EventKind) -> bool {
        self.states.open(contact, closed, kind);
        let passed_on = kind == EventKind::LeftFace && self.vertices().pass_on(contact, closed);
        self.states.forget_sharers_of_open(contact);
        passed_on
    }

    /// From stick to slip, or back.
    fn switch(&mut self, contact: usize, mut closed: ClosedContact) {
        let here = self.states.here(contact);
        match closed.mode {
            Mode::Stick { anchor } => {
                let breakaway = closed.law.on_breakaway(anchor, &here);
                closed.mode = breakaway.mode;
                let ChangeCount { t, at_instant, .. } = self.states.world.contacts[contact].changes;
                closed.solver.retries =
                    if t == self.states.now.poses.t { u32::try_from(at_instant).unwrap_or(u32::MAX) } else { 0 };
                self.states.log(contact, Contact::Closed(closed), EventKind::StickToSlip, breakaway.released);
            }
            Mode::Slip { direction } => {
                if closed.law.may_pass_stop() && !self.states.at().can_hold(contact, &closed) {
                    closed.solver.passing_stop = true;
                    self.states.enter_without_event(contact, Contact::Closed(closed));
                    return;
                }
                closed.solver.passing_stop = false;
                closed.mode = closed.law.on_stopping(direction, &here);
                closed.solver.retries = 0;
                self.states.log(contact, Contact::Closed(closed), EventKind::SlipToStick, 0.0);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::contact::{FrictionLaw, Local};
    use crate::dynamics::contact_model::example::{AtEvent, TIME};
    use crate::dynamics::penalty3d::example::{STIFFNESS, closed, stick, wall};
    use crate::scene::{Direction, Kind};

    /// Penetration \[m\].
    const DEPTH: f64 = 1e-3;
    /// Displacement along the wall, at the cone of `μ_s` = 0.5 under a tangential spring as stiff as the normal one \[m\].
    const WAY: f64 = 0.5e-3;
    /// Part of the pair's stiffness of each of the two corners \[N/m\].
    const NODE: f64 = 0.5 * STIFFNESS;
    const SLIP: Mode = Mode::Slip { direction: DVec2::X };

    fn slip(_: &Local) -> Mode {
        SLIP
    }

    /// A girder pressed into its wall by `depth` and displaced along it by [`WAY`] since its two corners have closed in this mode.
    fn pressed(mode: fn(&Local) -> Mode, friction: FrictionLaw, depth: f64) -> AtEvent {
        let (model, mut active) = closed(&wall(), mode);
        assert_eq!(active.len(), 2, "two corners");
        for contact in &mut active {
            let law = &mut contact.closed.law;
            (law.friction, law.mu_s, law.mu_k) = (friction.into(), 0.5, 0.4);
        }
        AtEvent::of(model, &active, &[[depth, WAY, 0.0, 0.0, 0.0, 0.0]])
    }

    /// The same in space, with four corners that slide along the wall under law `paper` in two directions of sliding, pushed along the
    /// wall by a part of the force that their stick could hold.
    fn stopped(part: f64) -> AtEvent {
        let mut scene = wall();
        (scene.kind, scene.gravity) = (Kind::Spatial, 0.0);
        scene.girders[0].held = vec![Direction::Roll, Direction::Pitch, Direction::Yaw];
        let (mut model, mut active) = closed(&scene, slip);
        assert_eq!(active.len(), 4, "four corners");
        model.bodies[0].push.y = part * 0.5 * STIFFNESS * DEPTH;
        for contact in &mut active {
            let law = &mut contact.closed.law;
            (law.friction, law.mu_s, law.mu_k, law.v_stick) = (FrictionLaw::Paper.into(), 0.5, 0.4, 1e-6);
        }
        AtEvent::of(model, &active, &[[DEPTH, 0.0, 0.0, 0.0, 0.0, 0.0]])
    }

    fn change(event: &mut AtEvent, contact: usize, reason: Reason) {
        Transitions { states: &mut event.states() }.change(contact, reason);
    }

    fn close(got: f64, expected: f64, what: &str) {
        assert!((got - expected).abs() <= 1e-9 * expected.abs().max(1e-9), "{what}: {got} is not {expected}");
    }

    #[test]
    fn a_breakaway_begins_a_slip_along_the_stretch_and_releases_what_its_law_gives_up() {
        // The whole spring, or its part beyond μ_k N/k_t = 0.4 mm.
        let released = [(FrictionLaw::Paper, WAY * WAY), (FrictionLaw::ReturnMapping, WAY * WAY - 0.4e-3 * 0.4e-3)];
        for (friction, squares) in released {
            let mut event = pressed(stick, friction, DEPTH);
            change(&mut event, 0, Reason::Switching);
            assert_eq!(event.kinds(), [(0, EventKind::StickToSlip)], "{friction:?}");
            close(event.released(), 0.5 * NODE * squares, "released");
            let Some(Mode::Slip { direction }) = event.closed(0).map(|closed| closed.mode) else { panic!("a slip") };
            let along = event.world.site(0).geometry.axes.x_axis * direction.x;
            close(along.y, 1.0, "the girder has moved along +y");
        }
    }

    #[test]
    fn a_slip_counts_as_retries_the_changes_of_its_contact_at_that_instant() {
        for (t, retries) in [(TIME, 3), (0.9 * TIME, 0)] {
            let mut event = pressed(stick, FrictionLaw::Paper, DEPTH);
            event.world.contacts[0].changes = ChangeCount { of_touch: 5, t, at_instant: 3 };
            change(&mut event, 0, Reason::Switching);
            assert_eq!(event.closed(0).expect("a slip").solver.retries, retries, "last changed at {t} s");
        }
    }

    #[test]
    fn a_stop_in_one_direction_of_sliding_sticks_with_the_force_of_its_law() {
        for (friction, force) in [(FrictionLaw::Paper, 0.0), (FrictionLaw::ReturnMapping, 0.4 * NODE * DEPTH)] {
            let mut event = pressed(slip, friction, DEPTH);
            change(&mut event, 0, Reason::Switching);
            assert_eq!(event.kinds(), [(0, EventKind::SlipToStick)], "{friction:?}");
            assert_eq!(event.released(), 0.0, "{friction:?}");
            let closed = event.closed(0).expect("in stick");
            let here = event.states().here(0);
            close(closed.forces(&here).tangential.length(), force, "tangential force");
            assert_eq!((closed.solver.passing_stop, closed.solver.retries), (false, 0));
        }
    }

    #[test]
    fn a_stop_in_two_directions_sticks_where_friction_can_hold_the_push_and_is_passed_where_it_cannot() {
        for part in [-0.999, 0.0, 0.999] {
            let mut event = stopped(part);
            change(&mut event, 0, Reason::Switching);
            assert_eq!(event.kinds(), [(0, EventKind::SlipToStick)], "{part} of the limit");
        }
        for part in [-1.001, 1.001] {
            let mut event = stopped(part);
            change(&mut event, 0, Reason::Switching);
            assert!(event.events.is_empty(), "no event at {part} of the limit");
            let closed = event.closed(0).expect("in slip");
            assert_eq!((closed.mode, closed.solver.passing_stop), (SLIP, true), "it goes on");
            assert_eq!(event.world.contacts[0].changes.at_instant, 1, "and is counted");
        }
    }

    #[test]
    fn an_opening_releases_the_stretch_and_is_armed_and_a_face_left_releases_the_penetration_too_and_is_not() {
        for (reason, kind, depth) in
            [(Reason::Opening, EventKind::Opened, 0.0), (Reason::Edge, EventKind::LeftFace, DEPTH)]
        {
            let mut event = pressed(stick, FrictionLaw::Paper, depth);
            change(&mut event, 0, reason);
            assert_eq!(event.kinds(), [(0, kind)], "alone");
            close(event.released(), 0.5 * NODE * (depth * depth + WAY * WAY), "released");
            assert_eq!(event.world.contacts[0].state, Contact::Open { armed: kind == EventKind::Opened });
            assert!(event.world.is_closed(1), "the other corner stays");
        }
    }

    #[test]
    fn the_shares_of_stiffness_last_until_the_last_contact_opens() {
        let mut event = pressed(stick, FrictionLaw::Paper, 0.0);
        event.world.pairs[0].sharers = 2;
        change(&mut event, 0, Reason::Opening);
        assert_eq!(event.world.pairs[0].sharers, 2);
        change(&mut event, 1, Reason::Opening);
        assert_eq!(event.world.pairs[0].sharers, 0);
    }

    #[test]
    fn a_kink_changes_the_force_without_an_event_and_an_open_contact_not_at_all() {
        let mut event = pressed(stick, FrictionLaw::Paper, DEPTH);
        change(&mut event, 0, Reason::Kink);
        assert!(event.closed(0).expect("closed").held_at_zero && event.events.is_empty());
        event.world.contacts[1].state = Contact::Open { armed: false };
        for reason in [Reason::Opening, Reason::Edge, Reason::Overlap, Reason::Switching, Reason::Kink] {
            change(&mut event, 1, reason);
        }
        assert_eq!((event.events.len(), event.world.contacts[1].changes.of_touch), (0, 0));
        assert_eq!(event.world.contacts[1].state, Contact::Open { armed: false });
    }
}
