//! What an event makes of a contact (`docs/physics.md#contact-events`).

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{DMat2, DMat3, DVec2};

use crate::contact::{Frame, Home, Law, Local, Mode, law::Friction, locate};
use crate::dynamics::closing::next_closing::INSTANT;
use crate::dynamics::event_loop::contact_engine::{ContactTrack, Engine};
use crate::dynamics::integrator::step_control::Pace;
use crate::dynamics::model::reference_pose::Base;
use crate::dynamics::model::{reference_pose, rigid_body};
use crate::dynamics::penalty3d::contact_force;
use crate::dynamics::penalty3d::contact_state::{Closed, Contact};
use crate::dynamics::penalty3d::event_location::{EDGE, PATIENCE, ROUNDING, Reason};
use crate::dynamics::record::event::{Event, EventKind};
use crate::scene::{FrictionLaw, Kind, Sharing, Tension};

/// Sliding in two directions below this speed counts as stopped (`docs/physics.md#stop`) \[m/s\].
pub(in crate::dynamics) const V_STICK: f64 = 1e-6;
/// After so many changes in one touch a stick breaks away by more than rounding, twice as much after every so many more.
const WORN: usize = 100;
/// Where a slip's direction turns on its own, it is eased below this part of the entry's depth.
const EASE: f64 = 1e-3;
/// With less friction than this the direction matters less than it costs to follow.
const LEAST_EASED: f64 = 0.05;

/// Bodies at the instant of an event.
#[derive(Debug)]
pub(in crate::dynamics) struct Juncture {
    /// When \[s\].
    pub(in crate::dynamics) t: f64,
    /// Who, by slot, rising.
    pub(in crate::dynamics) slots: Vec<usize>,
    /// What their states are counted from; of a body that was free, where it is.
    pub(in crate::dynamics) bases: Vec<Base>,
    /// Their states.
    pub(in crate::dynamics) states: Vec<Vec<f64>>,
    /// Their poses.
    pub(in crate::dynamics) frames: Vec<Frame>,
    /// The same, counted from their bases.
    pub(in crate::dynamics) since: Vec<Frame>,
}

impl Juncture {
    fn place(&self, slot: usize) -> Option<usize> {
        self.slots.binary_search(&slot).ok()
    }

    fn base(&self, slot: Option<usize>) -> Option<&Base> {
        self.bases.get(self.place(slot?)?)
    }
}

/// Pose of one side of a contact, of those in `frames`.
fn side(engine: &Engine, contact: usize, which: usize, now: &Juncture, frames: &[Frame]) -> Frame {
    let track = &engine.contacts[contact];
    let stand = engine.model.contacts[track.site].stand;
    track.slots[which].map_or(stand, |slot| now.place(slot).and_then(|i| frames.get(i)).copied().unwrap_or(stand))
}

impl Engine {
    fn local(&self, contact: usize, now: &Juncture) -> Local {
        let site = &self.model.contacts[self.contacts[contact].site];
        locate(&site.home, &side(self, contact, 0, now, &now.frames), &side(self, contact, 1, now, &now.frames))
    }

    /// The same, counted from the bases of its bodies, where it was home: as a contact is while it is closed.
    fn since(&self, contact: usize, now: &Juncture, frames: &[Frame]) -> (Home, [Frame; 2], Local) {
        let track = &self.contacts[contact];
        let at = track.state.closed().and_then(|closed| closed.at);
        let home =
            reference_pose::seen_from(&self.model.contacts[track.site], track.slots.map(|slot| now.base(slot)), at);
        let sides = [0, 1].map(|which| side(self, contact, which, now, frames));
        (home, sides, locate(&home, &sides[0], &sides[1]))
    }

    fn log(&mut self, contact: usize, now: &Juncture, state: Contact, kind: EventKind, released: f64) {
        self.note(contact, state, now);
        self.events.push(Event::new(now.t, self.contacts[contact].site, kind, released));
        self.counted(contact, now.t);
    }

    /// A change within a state: kept, but no event.
    fn remember(&mut self, contact: usize, closed: Closed, now: &Juncture) {
        self.note(contact, Contact::Closed(closed), now);
        self.counted(contact, now.t);
    }

    /// Enters a contact's state, with where its anchor is counted from.
    fn note(&mut self, contact: usize, state: Contact, now: &Juncture) {
        let bases = self.contacts[contact].slots.map(|slot| now.base(slot));
        self.enter(contact, state, bases, now.t);
    }

    /// The same with the bases of its bodies.
    pub(in crate::dynamics) fn enter(&mut self, contact: usize, state: Contact, bases: [Option<&Base>; 2], t: f64) {
        let track = &mut self.contacts[contact];
        let way = match state {
            // Where it is counted from is the same as long as it is closed and not counted anew.
            Contact::Closed(now) if track.state.closed().is_some_and(|before| before.at == now.at) => track.log.way(),
            // Only a spring along the face remembers where it began.
            Contact::Closed(now) if now.law.has_friction() => {
                reference_pose::way_to(&self.model.contacts[track.site], bases)
            }
            _ => DVec2::ZERO,
        };
        (track.state, track.out) = (state, None);
        track.log.push(t, state, way);
    }

    /// Whether a node that has come through the plane of a face is inside its polygon; one that is not is logged as a
    /// miss and ignored until it is in front again.
    pub(in crate::dynamics) fn enters(&mut self, contact: usize, now: &Juncture) -> bool {
        if self.is_over(contact, now) {
            return true;
        }
        self.contacts[contact].closing = None;
        self.log(contact, now, Contact::Open { armed: false }, EventKind::Missed, 0.0);
        self.contacts[contact].counted.0 = 0;
        false
    }

    /// Whether a node is over its face's polygon and touches nothing else.
    pub(in crate::dynamics) fn is_over(&self, contact: usize, now: &Juncture) -> bool {
        let here = self.local(contact, now);
        let face = &self.model.contacts[self.contacts[contact].site].face;
        face.inset_at(here.at) >= -EDGE * face.size() && !self.touches_elsewhere(contact)
    }

    /// Tells the contacts of each node of one another, where a side is in more than one pair.
    pub(in crate::dynamics) fn find_rivals(&mut self, pairs: &[usize]) {
        let model = Arc::clone(&self.model);
        let mut sides: Vec<_> = pairs.iter().flat_map(|&n| [model.pairs[n].first, model.pairs[n].second]).collect();
        sides.sort_unstable();
        if sides.windows(2).all(|two| two[0] != two[1]) {
            return;
        }
        let mut nodes: BTreeMap<(Option<usize>, &str), Vec<usize>> = BTreeMap::new();
        for (contact, track) in self.contacts.iter().enumerate() {
            nodes.entry((track.slots[0], &model.contacts[track.site].node)).or_default().push(contact);
        }
        for same in nodes.values().filter(|same| same.len() > 1) {
            for &contact in same {
                self.contacts[contact].rivals = same.iter().copied().filter(|&other| other != contact).collect();
            }
        }
    }

    /// Whether the same node is in another face already: it touches one at a time.
    fn touches_elsewhere(&self, contact: usize) -> bool {
        self.contacts[contact].rivals.iter().any(|&other| self.contacts[other].state.closed().is_some())
    }

    /// Closing: a node enters a face (`docs/physics.md#closing`).
    pub(in crate::dynamics) fn close(&mut self, contact: usize, now: &Juncture) {
        let (.., here) = self.since(contact, now, &now.since);
        let law = self.law(contact, now);
        let (mut tangential, mut normal) = here.relative_velocity(DVec2::ZERO);
        if normal == 0.0 && tangential == DVec2::ZERO {
            (tangential, normal) = self.relative_acceleration(contact, &here, now);
        }
        let mode = law.on_closing(&here, tangential, normal);
        let ease = self.ease(contact, &law, &here, now);
        let closed = Closed { law, mode, at: None, ease, passing: false, again: 0, slack: false, at_face: false };
        let kind = match mode {
            Mode::Stick { .. } => EventKind::OpenToStick,
            Mode::Slip { .. } => EventKind::OpenToSlip,
        };
        self.contacts[contact].closing = None;
        self.contacts[contact].counted.0 = 0;
        // Rounding leaves a hair of overlap at the crossing; its strain appears from nowhere and is booked.
        let appeared = -0.5 * law.k * here.gap * here.gap;
        self.log(contact, now, Contact::Closed(closed), kind, appeared);
    }

    /// Nodes that overlap at t = 0 start in stick with p at their projection; nodes behind a face but beside it are
    /// ignored.
    pub(in crate::dynamics) fn close_overlapping(&mut self, now: &Juncture) {
        let at_home: Vec<bool> = now.frames.iter().map(|frame| self.stands(frame)).collect();
        for contact in 0..self.contacts.len() {
            let ContactTrack { slots, spot, .. } = &self.contacts[contact];
            // The slots are all there are, so their numbers are their places.
            if spot.home_gap >= 0.0 && slots.iter().flatten().all(|&slot| at_home[slot]) {
                continue;
            }
            let here = self.local(contact, now);
            let face = &self.model.contacts[self.contacts[contact].site].face;
            if here.gap >= 0.0 {
                continue;
            }
            let inside = face.inset_at(here.at) >= -EDGE * face.size() && here.penetration() < face.depth;
            let inside = inside && !self.touches_elsewhere(contact);
            let state = if inside {
                let (.., here) = self.since(contact, now, &now.since);
                let law = self.law(contact, now);
                let ease = self.ease(contact, &law, &here, now);
                let mode = if law.has_friction() {
                    Mode::Stick { anchor: here.way }
                } else {
                    let (sliding, _) = here.relative_velocity(DVec2::ZERO);
                    Mode::Slip { direction: sliding.try_normalize().unwrap_or(DVec2::X) }
                };
                let mut closed =
                    Closed { law, mode, at: None, ease, passing: false, again: 0, slack: false, at_face: false };
                closed.slack = law.clamp && closed.pull(&here) > 0.0;
                Contact::Closed(closed)
            } else {
                Contact::Open { armed: false }
            };
            self.note(contact, state, now);
        }
    }

    /// Whether a body stands in plan as it was placed.
    fn stands(&self, frame: &Frame) -> bool {
        self.model.kind == Kind::Planar && frame.shift.truncate() == DVec2::ZERO && frame.turned == DMat3::ZERO
    }

    /// Breakaway, stop, opening and edge of a closed contact (`docs/physics.md#contact-events`).
    pub(in crate::dynamics) fn change(&mut self, contact: usize, reason: Reason, now: &Juncture) {
        let Some(closed) = self.contacts[contact].state.closed().copied() else { return };
        match reason {
            Reason::Opening => self.part(contact, &closed, now, EventKind::Opened),
            Reason::Edge => self.part(contact, &closed, now, EventKind::LeftFace),
            Reason::Switching => self.switch(contact, closed, now),
            Reason::Kink => self.remember(contact, Closed { slack: !closed.slack, ..closed }, now),
        }
    }

    fn part(&mut self, contact: usize, closed: &Closed, now: &Juncture, kind: EventKind) {
        let (.., here) = self.since(contact, now, &now.since);
        let released = closed.law.strain(&closed.forces(&here));
        self.log(contact, now, Contact::Open { armed: kind == EventKind::Opened }, kind, released);
        let pair = self.contacts[contact].pair;
        let touching = self.pairs[pair].contacts.clone().any(|c| self.contacts[c].state.closed().is_some());
        if !touching {
            self.pairs[pair].sharers = 0;
        }
    }

    fn switch(&mut self, contact: usize, mut closed: Closed, now: &Juncture) {
        let (.., here) = self.since(contact, now, &now.since);
        match closed.mode {
            Mode::Stick { anchor } => {
                let breakaway = closed.law.on_breakaway(anchor, &here);
                closed.mode = breakaway.mode;
                let (_, at, same) = self.contacts[contact].counted;
                closed.again = if at == now.t { u32::try_from(same).unwrap_or(u32::MAX) } else { 0 };
                self.log(contact, now, Contact::Closed(closed), EventKind::StickToSlip, breakaway.released);
            }
            Mode::Slip { direction } => {
                if closed.law.v_stick > 0.0
                    && closed.law.friction == Friction::Paper
                    && !self.can_hold(contact, &closed, now)
                {
                    self.remember(contact, Closed { passing: true, ..closed }, now);
                    return;
                }
                closed.passing = false;
                closed.mode = closed.law.on_stopping(direction, &here);
                let worn = u32::try_from(self.contacts[contact].counted.0 / WORN).unwrap_or(u32::MAX);
                closed.again = if worn > 0 { PATIENCE.saturating_add(worn) } else { 0 };
                self.log(contact, now, Contact::Closed(closed), EventKind::SlipToStick, 0.0);
            }
        }
    }

    /// Whether a contact that has stopped sliding in two directions can hold: the tangential force that keeps `V_t` at
    /// rest is within `μ_s |F_n|` (`docs/physics.md#stop`).
    fn can_hold(&self, contact: usize, closed: &Closed, now: &Juncture) -> bool {
        let track = &self.contacts[contact];
        let (home, sides, _) = self.since(contact, now, &now.since);
        let action = contact_force::act_in(&home, closed, &closed.mode, &sides[0], &sides[1]);
        let (acceleration, _) = self.relative_acceleration(contact, &action.here, now);
        let mut mobility = DMat2::ZERO;
        for (which, arm) in [action.node_arm, action.face_arm].into_iter().enumerate() {
            if let Some(slot) = track.slots[which] {
                let body = &self.model.bodies[self.bodies[slot].body];
                let axes = [home.axes.x_axis, home.axes.y_axis].map(|axis| sides[1].turn(axis));
                let rotation = side(self, contact, which, now, &now.frames).rotation(&body.axes);
                mobility += rigid_body::mobility(body, &rotation, arm, axes);
            }
        }
        // What friction gives now, less this contact's part of what stops the acceleration that is left: those of the pair
        // that slide with it share.
        let sliding =
            |c: &usize| matches!(self.contacts[*c].state.closed(), Some(Closed { mode: Mode::Slip { .. }, .. }));
        let sharing = self.pairs[track.pair].contacts.clone().filter(sliding).count().max(1);
        let needed = action.forces.tangential - mobility.inverse() * acceleration / sharing as f64;
        // A NaN, where nothing can move tangentially, holds.
        needed.is_nan() || needed.length() <= closed.law.mu_s * action.forces.normal
    }

    /// Tangential and normal acceleration of a node against a face under the forces of the contacts as they are
    /// \[m/s²\].
    fn relative_acceleration(&self, contact: usize, here: &Local, now: &Juncture) -> (DVec2, f64) {
        let dt = INSTANT * self.pairs[self.contacts[contact].pair].together;
        let together = self.assemble(&now.slots, now.bases.clone(), now.states.concat(), now.t, Pace::default());
        let (.., next) = self.since(contact, now, &together.frames_after(&self.model, dt));
        ((next.rate - here.rate) / dt, (next.gap_rate - here.gap_rate) / dt)
    }

    /// Length below which a turning direction of slip is eased: a part of the depth that the speed and the push at the
    /// entry lead to, or of the overlap, whichever is deepest \[m\].
    fn ease(&self, contact: usize, law: &Law, here: &Local, now: &Juncture) -> f64 {
        // Without sliding friction there is no force whose direction could turn.
        if law.v_stick == 0.0 || law.friction == Friction::Paper || law.mu_k == 0.0 {
            return 0.0;
        }
        let radian = self.pairs[self.contacts[contact].pair].together * 1e9;
        let (_, speed) = here.relative_velocity(DVec2::ZERO);
        let (_, push) = self.relative_acceleration(contact, here, now);
        let depth = (speed.abs() * radian).max(push.abs() * radian * radian).max(here.penetration());
        let size = self.model.contacts[self.contacts[contact].site].reach();
        // Never less than a stretch's rounding: a direction within that is none.
        (EASE * law.mu_k.max(LEAST_EASED) * depth).max(ROUNDING * size)
    }

    /// The pair's numbers as this contact has them, shared when the pair first closes.
    fn law(&mut self, contact: usize, now: &Juncture) -> Law {
        let number = self.contacts[contact].pair;
        if self.pairs[number].sharers == 0 {
            self.pairs[number].sharers = self.sharers(number, now);
        }
        let pair = &self.model.pairs[self.pairs[number].pair];
        let (numbers, share) = (&pair.contact, self.pairs[number].sharers as f64);
        Law {
            k: numbers.stiffness / share,
            c_n: pair.c_n / share,
            c_t: pair.c_t / share,
            mu_s: numbers.mu_static,
            mu_k: numbers.mu_kinetic,
            friction: match numbers.law {
                FrictionLaw::Paper => Friction::Paper,
                FrictionLaw::ReturnMapping => Friction::ReturnMapping,
            },
            clamp: numbers.tension == Tension::Clamp,
            v_stick: if pair.one_way { 0.0 } else { V_STICK },
        }
    }

    /// Declared nodes of a pair whose projection lies inside the facing polygon, edges included; at least one.
    fn sharers(&self, pair: usize, now: &Juncture) -> usize {
        let track = &self.pairs[pair];
        if self.model.pairs[track.pair].contact.sharing == Sharing::PerNode {
            return 1;
        }
        let inside = |contact: &usize| {
            let face = &self.model.contacts[self.contacts[*contact].site].face;
            face.inset_at(self.local(*contact, now).at) >= -EDGE * face.size()
        };
        track.contacts.clone().filter(inside).count().max(1)
    }
}
