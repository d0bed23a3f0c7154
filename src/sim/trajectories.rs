//! Trajectories of a run: states of its bodies and contacts at any time, from the segments, steps and logs that it stored.

use std::sync::Arc;

use super::Motion;
use super::recent_steps::RecentSteps;
use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::model::coordinates::BodyState;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::record::contact_log::ContactLog;
use crate::dynamics::record::link_log::LinkLog;
use crate::dynamics::record::recomputed_steps::{Past, RecomputedSteps};
use crate::dynamics::run::{Finished, FinishedBody};
use crate::dynamics::trajectory::heading::StepHeading;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;
use crate::dynamics::trajectory::stored_path::{StoredMotion, StoredPath};
use crate::geometry::End;

/// Stored motion of bodies, contacts and links of a run, from t = 0 to [`Trajectories::end`].
#[derive(Clone, Debug)]
pub(super) struct Trajectories {
    model: Arc<Model>,
    end: f64,
    /// Of each body.
    paths: Vec<StoredPath>,
    /// Steps kept by their starts, group by group.
    recomputed: Vec<RecomputedSteps>,
    /// Of each body.
    recent: Vec<RecentSteps>,
    /// The group of each body.
    group_of: Vec<usize>,
    /// Of each body, where it has a closed form.
    free_motions: Vec<Option<BodyMotion>>,
    /// Of each contact.
    logs: Vec<ContactLog>,
    /// Of each link.
    link_logs: Vec<LinkLog>,
}

impl Trajectories {
    /// Of a run whose groups are still to be taken in, as far as `end` \[s\].
    pub(super) fn new(model: Arc<Model>, end: f64) -> Self {
        let bodies = model.bodies.len();
        Self {
            end,
            paths: vec![StoredPath::default(); bodies],
            recomputed: Vec::new(),
            recent: vec![RecentSteps::default(); bodies],
            group_of: vec![0; bodies],
            free_motions: vec![None; bodies],
            logs: vec![ContactLog::default(); model.sites.len()],
            link_logs: vec![LinkLog::default(); model.links.len()],
            model,
        }
    }

    /// Takes in what a group stored; groups come in the order of their numbers.
    pub(super) fn take_in(&mut self, group: &mut Finished) {
        let number = self.recomputed.len();
        self.recomputed.push(std::mem::take(&mut group.recomputed));
        for FinishedBody { body, path, free_motion } in group.bodies.drain(..) {
            (self.paths[body], self.free_motions[body], self.group_of[body]) = (path, free_motion, number);
        }
        for (contact, log) in group.contacts.drain(..) {
            self.logs[contact] = log;
        }
        for (link, log) in group.links.drain(..) {
            self.link_logs[link] = log;
        }
    }

    /// Ends the trajectories at `t` at the latest \[s\].
    pub(super) fn shorten(&mut self, t: f64) {
        self.end = self.end.min(t);
    }

    /// Bodies, pairs and contacts as compiled from the scene.
    pub(super) fn model(&self) -> &Model {
        &self.model
    }

    /// Time that they reach \[s\].
    pub(super) fn end(&self) -> f64 {
        self.end
    }

    /// Stretches of a body.
    pub(super) fn path(&self, body: usize) -> &StoredPath {
        &self.paths[body]
    }

    /// States of a contact.
    pub(super) fn log(&self, contact: usize) -> &ContactLog {
        &self.logs[contact]
    }

    /// Phases of a link; `None` of one that is not there.
    pub(super) fn link_log(&self, link: usize) -> Option<&LinkLog> {
        self.link_logs.get(link)
    }

    /// Steps of all groups that are kept by their starts.
    #[cfg(test)]
    pub(super) fn recomputed_steps(&self) -> &[RecomputedSteps] {
        &self.recomputed
    }

    /// The free motion of a body, where it has a closed form.
    pub(super) fn free_motion(&self, body: usize) -> Option<&BodyMotion> {
        self.free_motions[body].as_ref()
    }

    /// State of a body as its integrator holds it, at `t` clamped to what was computed.
    pub(super) fn state(&self, body: usize, t: f64) -> BodyState {
        let t = t.clamp(0.0, self.end);
        let own = &self.model.bodies[body];
        let mut state = BodyState::from_elem(0.0, own.width());
        // Nothing was computed where the run gave up at its start.
        let Some((from, motion)) = self.paths[body].at(t) else { return own.initial().into() };
        match motion {
            StoredMotion::Start(start) => {
                let there = self.free_motion(body).and_then(|system| system.girder_state(from, start, t));
                state.copy_from_slice(&there.unwrap_or(start));
            }
            StoredMotion::Flight(flight) => return flight.state(t),
            StoredMotion::Slide(slide) => state.copy_from_slice(&slide.state(t)),
            StoredMotion::Step(piece) => own.restore(piece.read(t, &mut state), &mut state),
            StoredMotion::Recomputed(number) => {
                self.stepped(body, (number, from), |piece| own.restore(piece.read(t, &mut state), &mut state));
            }
        }
        state
    }

    /// A step that is kept by its start, taken again: `read` gets the body's part.
    pub(super) fn stepped<T>(&self, body: usize, step: (u32, f64), read: impl FnOnce(&StepPolynomial) -> T) -> T {
        let own = self.recent[body].take(step.0).unwrap_or_else(|| self.recomputed(body, step));
        let answer = read(&own);
        self.recent[body].keep(step.0, own);
        answer
    }

    /// The body's part of a step; those of the step's other bodies go into their caches.
    fn recomputed(&self, body: usize, (number, from): (u32, f64)) -> StepPolynomial {
        let past = Past { model: &self.model, paths: &self.paths, free_motions: &self.free_motions, logs: &self.logs };
        let steps_of_group = &self.recomputed[self.group_of[body]];
        let mut steps = steps_of_group.step(number, from, &past);
        let place = steps_of_group.bodies(number).position(|of| of == body).unwrap_or(0);
        let own = steps.remove(place);
        for (of, step) in steps_of_group.bodies(number).filter(|of| *of != body).zip(steps) {
            self.recent[of].keep(number, step);
        }
        own
    }

    /// A section of a body within a step, counted from its base; nothing where it is in no step.
    pub(super) fn since(&self, body: usize, section: usize, t: f64) -> Option<(ReferencePose, Frame)> {
        let own = &self.model.bodies[body];
        let mut state = BodyState::from_elem(0.0, own.width());
        let base = match self.paths[body].at(t)? {
            (_, StoredMotion::Step(piece)) => own.reference(piece.read(t, &mut state)),
            (from, StoredMotion::Recomputed(number)) => {
                self.stepped(body, (number, from), |piece| own.reference(piece.read(t, &mut state)))
            }
            _ => return None,
        };
        Some((base, own.frame_since(section, &state)))
    }

    /// Memory \[bytes\]: paths and contact states.
    pub(super) fn bytes(&self) -> usize {
        let paths: usize = self.paths.iter().map(StoredPath::bytes).sum();
        let recomputed: usize = self.recomputed.iter().map(RecomputedSteps::bytes).sum();
        let logs: usize = self.logs.iter().map(ContactLog::bytes).sum();
        paths + recomputed + logs
    }

    /// Pose and twist of a section of a body.
    pub(super) fn section_frame(&self, body: usize, section: usize, t: f64) -> Frame {
        self.model.bodies[body].frame(section, &self.state(body, t))
    }

    /// Motion of a girder at `t`, clamped to what was computed.
    pub(super) fn motion(&self, girder: usize, t: f64) -> Motion {
        let motion = Motion::of(&self.model, girder, &self.state(girder, t));
        Motion { theta: self.counted_angle(girder, t).unwrap_or(motion.theta), ..motion }
    }

    /// Motion of an end of a girder at `t`, clamped to what was computed, as of a rigid girder that has this end: place and displacement are
    /// those of its G. The same for both ends of a rigid girder.
    pub(super) fn end_motion(&self, girder: usize, end: End, t: f64) -> Motion {
        match self.model.bodies[girder].section(end) {
            0 => self.motion(girder, t),
            section => Motion::of_section(&self.model, girder, section, &self.state(girder, t)),
        }
    }

    /// Rotation about the vertical with its half turns \[rad\]; `None` where the state of a body has it.
    fn counted_angle(&self, body: usize, t: f64) -> Option<f64> {
        let (own, path, t) = (&self.model.bodies[body], &self.paths[body], t.clamp(0.0, self.end));
        let number = path.number_at(t).filter(|_| own.has_heading())?;
        let span = |from: f64| [from, path.until(number)];
        let angle = |from, piece: &StepPolynomial| {
            StepHeading::of(own, piece, span(from)).map(|heading| heading.angle(path.half_turns(number), t))
        };
        match path.motion_of(number) {
            (from, StoredMotion::Step(piece)) => angle(from, piece),
            (from, StoredMotion::Recomputed(step)) => self.stepped(body, (step, from), |piece| angle(from, piece)),
            _ => None,
        }
    }

    /// The two sides of a contact at `t`: node's body, face's body.
    pub(super) fn sides(&self, contact: usize, t: f64) -> [Frame; 2] {
        let site = &self.model.sites[contact];
        let [node, face] = self.model.sections(contact);
        [(site.node_body, node), (site.face_body, face)].map(|(body, section)| match body {
            Some(body) => self.section_frame(body, section, t),
            None => Frame::fixed(site.fixed),
        })
    }
}
