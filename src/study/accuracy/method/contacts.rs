//! Contacts as a user of other tools keeps them: the gap is tested wherever forces are evaluated, the friction state is
//! brought up to date at the end of every step. No event is looked for.

use glam::DVec2;

use crate::contact::parameters::is_over;
use crate::contact::{Frame, Law, Local, Mode, SlipDirection, locate};
use crate::dynamics::model::wrench::Wrench;
use crate::dynamics::penalty3d::contact_force::{Action, act};
use crate::dynamics::penalty3d::contact_state::{ClosedContact, Contact};
use crate::dynamics::{ContactSite, Model};
use crate::scene::Sharing;

/// The states of all contacts.
#[derive(Debug)]
pub(super) struct Contacts {
    states: Vec<Contact>,
    /// Anchors of slipping nodes at the end of the last step, in the face's axes \[m\].
    anchors: Vec<DVec2>,
    /// Nodes that share the numbers of a pair while it is closed; 0 while it is open.
    sharers: Vec<usize>,
    /// Largest |`R_k`| so far \[N\].
    pub(super) peak: f64,
}

/// The two sides of a contact.
fn sides(site: &ContactSite, frames: &[Frame]) -> [Frame; 2] {
    [site.node_body, site.face_body].map(|body| body.map_or_else(|| Frame::fixed(site.fixed), |b| frames[b]))
}

fn inside(site: &ContactSite, here: &Local) -> bool {
    is_over(&site.face, here.at)
}

impl Contacts {
    pub(super) fn new(model: &Model) -> Self {
        let count = model.sites.len();
        Self {
            states: vec![Contact::Open { armed: true }; count],
            anchors: vec![DVec2::ZERO; count],
            sharers: vec![0; model.pairs.len()],
            peak: 0.0,
        }
    }

    /// Nodes that are behind a face at the start stick where they are.
    pub(super) fn overlap(&mut self, model: &Model, frames: &[Frame]) {
        for (number, site) in model.sites.iter().enumerate() {
            let [node, face] = sides(site, frames);
            let here = locate(&site.geometry, &node, &face);
            if here.gap < 0.0 {
                let held = inside(site, &here);
                self.states[number] = if held {
                    let law = self.law(model, number, frames);
                    self.sharers[site.pair] = Self::count(model, site.pair, frames);
                    Contact::Closed(closed(law, Mode::Stick { anchor: here.way }))
                } else {
                    Contact::Open { armed: false }
                };
            }
        }
    }

    /// Adds the forces of what touches.
    pub(super) fn push(&self, model: &Model, frames: &[Frame], wrenches: &mut [Wrench]) {
        for (number, site) in model.sites.iter().enumerate() {
            let Some(action) = self.action(model, number, frames) else { continue };
            if let Some(body) = site.node_body {
                wrenches[body].push_with(action.force, action.node_arm, action.couple);
            }
            if let Some(body) = site.face_body {
                wrenches[body].push_with(-action.force, action.face_arm, -action.couple);
            }
        }
    }

    /// Force of one contact; a node that came in since the last step ended is closed for the moment.
    fn action(&self, model: &Model, number: usize, frames: &[Frame]) -> Option<Action> {
        let site = &model.sites[number];
        let [node, face] = sides(site, frames);
        match &self.states[number] {
            Contact::Closed(closed) => {
                let action = act(site, closed, &node, &face);
                (action.here.gap < 0.0).then_some(action)
            }
            Contact::Open { armed: false } => None,
            Contact::Open { armed: true } => {
                let here = locate(&site.geometry, &node, &face);
                let enters = here.gap < 0.0 && inside(site, &here);
                enters.then(|| act(site, &entered(self.law(model, number, frames), &here), &node, &face))
            }
        }
    }

    /// Brings every contact up to date; answers whether any changed its state.
    pub(super) fn settle(&mut self, model: &Model, frames: &[Frame]) -> bool {
        let mut changed = false;
        for (number, site) in model.sites.iter().enumerate() {
            if let Some(action) = self.action(model, number, frames) {
                self.peak = self.peak.max(action.force.length());
            }
            let [node, face] = sides(site, frames);
            let here = locate(&site.geometry, &node, &face);
            let before = self.states[number];
            let after = match before {
                Contact::Closed(closed) => self.hold(number, closed, &here, inside(site, &here)),
                Contact::Open { .. } if here.gap >= 0.0 => Contact::Open { armed: true },
                Contact::Open { armed: true } if inside(site, &here) => {
                    let law = self.law(model, number, frames);
                    if self.sharers[site.pair] == 0 {
                        self.sharers[site.pair] = Self::count(model, site.pair, frames);
                    }
                    self.anchors[number] = here.way;
                    Contact::Closed(entered(law, &here))
                }
                Contact::Open { .. } => Contact::Open { armed: false },
            };
            changed |= kind(&before) != kind(&after);
            self.states[number] = after;
        }
        self.part(model);
        changed
    }

    /// A closed contact at the end of a step.
    fn hold(&mut self, number: usize, closed: ClosedContact, here: &Local, inside: bool) -> Contact {
        if here.gap >= 0.0 || !inside {
            return Contact::Open { armed: inside };
        }
        let switching = closed.law.switch(&closed.mode, here) > 0.0;
        let mode = match closed.mode {
            Mode::Stick { anchor } if switching => closed.law.on_breakaway(anchor, here).mode,
            Mode::Slip { direction } if switching => closed.law.on_stopping(direction, here),
            Mode::Slip { direction } if closed.law.v_stick > 0.0 => self.turned(number, &closed.law, direction, here),
            same => same,
        };
        if let Mode::Slip { direction } = mode {
            self.anchors[number] = here.way - direction * (closed.law.mu_k * closed.law.length(here));
        }
        Contact::Closed(ClosedContact { mode, ..closed })
    }

    /// Discrete return mapping where sliding has two directions: the stretch from the last anchor, cut back.
    fn turned(&self, number: usize, law: &Law, direction: DVec2, here: &Local) -> Mode {
        let trial = here.way - self.anchors[number];
        let direction = match law.friction.rule().direction() {
            SlipDirection::State => trial.try_normalize().unwrap_or(direction),
            SlipDirection::OfVelocity | SlipDirection::Constant => direction,
        };
        Mode::Slip { direction }
    }

    /// Pairs whose last contact has opened share anew next time.
    fn part(&mut self, model: &Model) {
        for (number, pair) in model.pairs.iter().enumerate() {
            if pair.sites.clone().all(|c| self.states[c].closed().is_none()) {
                self.sharers[number] = 0;
            }
        }
    }

    /// The pair's numbers as a contact has them.
    fn law(&self, model: &Model, number: usize, frames: &[Frame]) -> Law {
        let at = model.sites[number].pair;
        let pair = &model.pairs[at];
        let share = match self.sharers[at] {
            0 => Self::count(model, at, frames),
            known => known,
        };
        pair.law.shared(share as f64)
    }

    /// Declared nodes of a pair that are inside the facing polygon.
    fn count(model: &Model, pair: usize, frames: &[Frame]) -> usize {
        let pair = &model.pairs[pair];
        if pair.contact.sharing == Sharing::PerNode {
            return 1;
        }
        let is_inside = |&number: &usize| {
            let site = &model.sites[number];
            let [node, face] = sides(site, frames);
            inside(site, &locate(&site.geometry, &node, &face))
        };
        pair.sites.clone().filter(is_inside).count().max(1)
    }
}

fn closed(law: Law, mode: Mode) -> ClosedContact {
    ClosedContact::new(law, mode, 0.0)
}

fn entered(law: Law, here: &Local) -> ClosedContact {
    let (tangential, normal) = here.relative_velocity(DVec2::ZERO);
    closed(law, law.on_closing(here, tangential, normal))
}

/// Open, stick or slip.
fn kind(state: &Contact) -> u8 {
    match state {
        Contact::Open { .. } => 0,
        Contact::Closed(ClosedContact { mode: Mode::Stick { .. }, .. }) => 1,
        Contact::Closed(ClosedContact { mode: Mode::Slip { .. }, .. }) => 2,
    }
}
