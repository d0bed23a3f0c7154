//! Transitions of contact states at an event (`docs/physics.md#contact-events`): open, stick, slip.

use glam::DVec2;

use crate::contact::parameters::is_over;
use crate::contact::{FrictionLaw, Mode};
use crate::dynamics::contact_model::at_instant::{AtInstant, EventInstant};
use crate::dynamics::contact_model::contact_law;
use crate::dynamics::event_loop::schedule::Schedule;
use crate::dynamics::model::reference_pose::{self, ReferencePose};
use crate::dynamics::penalty3d::constants::FREE_RETRIES;
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::penalty3d::due::Reason;
use crate::dynamics::record::event::{Event, EventKind};
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::ContactTrack;

/// Events of one contact at one instant before the run gives up there.
const SAME_INSTANT: usize = 64;
/// Events of one contact during one touch before the run gives up there.
const PER_TOUCH: usize = 1_000_000;
/// After so many changes in one touch a stick breaks away by more than rounding, twice as much after every so many more.
const WORN: usize = 100;

/// Contacts of a group of bodies while an event changes them.
pub(in crate::dynamics) struct Transitions<'a> {
    /// The group.
    pub world: &'a mut World,
    /// Events so far, to which those of this instant are added.
    pub events: &'a mut Vec<Event>,
    /// Progress of the run, which stops where one contact changes without end.
    pub schedule: &'a mut Schedule,
    /// Bodies at the instant of the event.
    pub now: &'a EventInstant,
}

/// Enters a contact's state from `t` on, with where its anchor is counted from.
pub(in crate::dynamics) fn enter(
    world: &mut World,
    contact: usize,
    state: Contact,
    bases: [Option<&ReferencePose>; 2],
    t: f64,
) {
    let track = &mut world.contacts[contact];
    let way = match state {
        // Where it is counted from is the same as long as it is closed and not counted anew.
        Contact::Closed(now)
            if track.state.closed().is_some_and(|before| before.solver.rebased_node == now.solver.rebased_node) =>
        {
            track.log.way()
        }
        // Only a spring along the face remembers where it began.
        Contact::Closed(now) if now.law.has_friction() => {
            reference_pose::way_to(&world.model.contacts[track.site], bases)
        }
        _ => DVec2::ZERO,
    };
    (track.state, track.out) = (state, None);
    track.log.push(t, state, way);
}

impl Transitions<'_> {
    /// The contacts as they are now.
    fn at(&self) -> AtInstant<'_> {
        AtInstant { world: self.world, now: self.now }
    }

    fn log(&mut self, contact: usize, state: Contact, kind: EventKind, released: f64) {
        self.note(contact, state);
        self.events.push(Event::new(self.now.t, self.world.contacts[contact].site, kind, released));
        self.count(contact);
    }

    /// A change within a state: kept, but no event.
    fn remember(&mut self, contact: usize, closed: ClosedContact) {
        self.note(contact, Contact::Closed(closed));
        self.count(contact);
    }

    /// Enters a contact's state, with where its anchor is counted from.
    fn note(&mut self, contact: usize, state: Contact) {
        let bases = self.world.contacts[contact].slots.map(|slot| self.now.base(slot));
        enter(self.world, contact, state, bases, self.now.t);
    }

    /// Counts an event; a contact that has had too many ends the run.
    fn count(&mut self, contact: usize) {
        let t = self.now.t;
        let track = &mut self.world.contacts[contact];
        let (touch, at, same) = &mut track.counted;
        *touch += 1;
        *same = if *at == t { *same + 1 } else { 1 };
        *at = t;
        if *same > SAME_INSTANT || *touch > PER_TOUCH {
            let (touch, same) = (*touch, *same);
            let place = self.world.model.contacts[track.site].node.clone();
            self.schedule.give_up(
                t,
                place,
                format!(
                    "{touch} changes of state in one touch, {same} of them at this instant: stick and slip alternate without \
                     end; another law, a lower stiffness or a larger tolerance may end it"
                ),
            );
        }
    }

    /// Whether a node that has come through the plane of a face is inside its polygon; one that is not is logged as a
    /// miss and ignored until it is in front again.
    pub(in crate::dynamics) fn enters(&mut self, contact: usize) -> bool {
        if self.at().is_over(contact) {
            return true;
        }
        self.world.contacts[contact].closing = None;
        self.log(contact, Contact::Open { armed: false }, EventKind::Missed, 0.0);
        self.world.contacts[contact].counted.0 = 0;
        false
    }

    /// Closing: a node enters a face (`docs/physics.md#closing`).
    pub(in crate::dynamics) fn close(&mut self, contact: usize) {
        let (.., here) = self.at().since(contact, &self.now.since);
        let law = contact_law::of(self.world, contact, self.now);
        let (mut tangential, mut normal) = here.relative_velocity(DVec2::ZERO);
        if normal == 0.0 && tangential == DVec2::ZERO {
            (tangential, normal) = self.at().relative_acceleration(contact, &here);
        }
        let mode = law.on_closing(&here, tangential, normal);
        let ease = self.at().ease(contact, &law, &here);
        let closed = ClosedContact::new(law, mode, ease);
        let kind = match mode {
            Mode::Stick { .. } => EventKind::OpenToStick,
            Mode::Slip { .. } => EventKind::OpenToSlip,
        };
        self.world.contacts[contact].closing = None;
        self.world.contacts[contact].counted.0 = 0;
        // Rounding leaves a hair of overlap at the crossing; its strain appears from nowhere and is booked.
        let appeared = -law.entry_energy(&here);
        self.log(contact, Contact::Closed(closed), kind, appeared);
    }

    /// Nodes that overlap at t = 0 start in stick with p at their projection; nodes behind a face but beside it are
    /// ignored.
    pub(in crate::dynamics) fn close_overlapping(&mut self) {
        let at_home: Vec<bool> = self.now.frames.iter().map(|frame| self.at().stands(frame)).collect();
        for contact in 0..self.world.contacts.len() {
            let ContactTrack { slots, spot, .. } = &self.world.contacts[contact];
            // The slots are all there are, so their numbers are their places.
            if spot.home_gap >= 0.0 && slots.iter().flatten().all(|&slot| at_home[slot]) {
                continue;
            }
            let here = self.at().local(contact);
            let face = &self.world.model.contacts[self.world.contacts[contact].site].face;
            if here.gap >= 0.0 {
                continue;
            }
            let inside = is_over(face, here.at) && here.penetration() < face.depth;
            let inside = inside && !self.at().touches_elsewhere(contact);
            let state = if inside {
                let (.., here) = self.at().since(contact, &self.now.since);
                let law = contact_law::of(self.world, contact, self.now);
                let ease = self.at().ease(contact, &law, &here);
                let mode = if law.has_friction() {
                    Mode::Stick { anchor: here.way }
                } else {
                    let (sliding, _) = here.relative_velocity(DVec2::ZERO);
                    Mode::Slip { direction: sliding.try_normalize().unwrap_or(DVec2::X) }
                };
                let mut closed = ClosedContact::new(law, mode, ease);
                closed.held_at_zero = law.clamp && closed.pull(&here) > 0.0;
                Contact::Closed(closed)
            } else {
                Contact::Open { armed: false }
            };
            self.note(contact, state);
        }
    }

    /// Breakaway, stop, opening and edge of a closed contact (`docs/physics.md#contact-events`).
    pub(in crate::dynamics) fn change(&mut self, contact: usize, reason: Reason) {
        let Some(closed) = self.world.contacts[contact].state.closed().copied() else { return };
        match reason {
            Reason::Opening => self.part(contact, &closed, EventKind::Opened),
            Reason::Edge => self.part(contact, &closed, EventKind::LeftFace),
            Reason::Switching => self.switch(contact, closed),
            Reason::Kink => self.remember(contact, ClosedContact { held_at_zero: !closed.held_at_zero, ..closed }),
        }
    }

    fn part(&mut self, contact: usize, closed: &ClosedContact, kind: EventKind) {
        let (.., here) = self.at().since(contact, &self.now.since);
        let released = closed.law.strain(&here, &closed.forces(&here));
        self.log(contact, Contact::Open { armed: kind == EventKind::Opened }, kind, released);
        let pair = self.world.contacts[contact].pair;
        let touching = self.world.pairs[pair].contacts.clone().any(|c| self.world.contacts[c].state.closed().is_some());
        if !touching {
            self.world.pairs[pair].sharers = 0;
        }
    }

    fn switch(&mut self, contact: usize, mut closed: ClosedContact) {
        let (.., here) = self.at().since(contact, &self.now.since);
        match closed.mode {
            Mode::Stick { anchor } => {
                let breakaway = closed.law.on_breakaway(anchor, &here);
                closed.mode = breakaway.mode;
                let (_, at, same) = self.world.contacts[contact].counted;
                closed.solver.retries = if at == self.now.t { u32::try_from(same).unwrap_or(u32::MAX) } else { 0 };
                self.log(contact, Contact::Closed(closed), EventKind::StickToSlip, breakaway.released);
            }
            Mode::Slip { direction } => {
                if closed.law.v_stick > 0.0
                    && closed.law.friction == FrictionLaw::Paper
                    && !self.at().can_hold(contact, &closed)
                {
                    closed.solver.passing_stop = true;
                    self.remember(contact, closed);
                    return;
                }
                closed.solver.passing_stop = false;
                closed.mode = closed.law.on_stopping(direction, &here);
                let worn = u32::try_from(self.world.contacts[contact].counted.0 / WORN).unwrap_or(u32::MAX);
                closed.solver.retries = if worn > 0 { FREE_RETRIES.saturating_add(worn) } else { 0 };
                self.log(contact, Contact::Closed(closed), EventKind::SlipToStick, 0.0);
            }
        }
    }
}
