//! The answer: a dense, continuous history that can be asked for any quantity at any time.

use std::sync::{Arc, OnceLock};

use rayon::prelude::*;

use super::books::Books;
use super::impact::events;
use super::recent_steps::RecentSteps;
use super::report::{Overlap, Pounding};
use super::{Event, Motion, Stop, Touch, Upright};
use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::event_loop::effort::Effort;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::impact2d::Record;
use crate::dynamics::model::coordinates::BodyState;
use crate::dynamics::record::contact_log::ContactLog;
use crate::dynamics::record::event::Cause;
use crate::dynamics::record::link_log::LinkLog;
use crate::dynamics::record::recomputed_steps::{Past, Replay};
use crate::dynamics::run::Finished;
use crate::dynamics::trajectory::heading::StepHeading;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;
use crate::dynamics::trajectory::stored_path::{StoredMotion, StoredPath};
use crate::geometry::End;
use crate::language::Text;
use crate::scene::{Between, Scene};

/// Instants at which two runs are compared.
const COMPARED: u32 = 2000;
/// Bodies that are compared side by side at all instants before the next ones are. Neighbours of an island share the steps that
/// are recomputed; paths and caches of so few stay in the processor's own memory.
const COMPARED_TOGETHER: usize = 16;

/// A run of a scene, from t = 0 to [`History::end`].
///
/// What is found when it is first asked for is searched on all processors. No part of such a search asks for what another search finds:
/// a thread that waits for the parts of one takes up parts of others, and would wait for itself.
#[derive(Clone, Debug)]
pub struct History {
    scene: Scene,
    model: Arc<Model>,
    end: f64,
    stop: Option<Stop>,
    pub(super) paths: Vec<StoredPath>,
    /// Steps kept by their starts, group by group.
    pub(super) replays: Vec<Replay>,
    /// Of each body.
    recent: Vec<RecentSteps>,
    /// The group of each body.
    group_of: Vec<usize>,
    systems: Vec<Option<BodyMotion>>,
    pub(super) logs: Vec<ContactLog>,
    pub(super) link_logs: Vec<LinkLog>,
    events: Vec<Event>,
    record: Option<Record>,
    /// The same scene by the other model.
    beside: Option<Arc<Self>>,
    effort: Effort,
    /// Found when they are first asked for.
    pub(super) touches: OnceLock<Vec<Touch>>,
    /// Kept when they are first asked for.
    pub(super) books: OnceLock<Books>,
    /// Found when they are first asked for.
    pub(super) overlaps: OnceLock<Vec<Overlap>>,
    /// Found when they are first asked for.
    pub(super) poundings: OnceLock<Vec<Pounding>>,
    /// Found when they are first asked for.
    pub(super) uprights: OnceLock<Vec<Upright>>,
}

impl History {
    /// Puts the groups of a run together; the impact model has a record of each.
    pub(super) fn gather(scene: Scene, model: Arc<Model>, groups: Vec<Finished>) -> Self {
        let end = groups.iter().map(|g| g.end).fold(model.duration, f64::min);
        let stop = groups.iter().filter_map(|g| g.stop.clone()).min_by(|a, b| a.t.total_cmp(&b.t));
        let mut paths = vec![StoredPath::default(); model.bodies.len()];
        let mut systems: Vec<Option<BodyMotion>> = model.bodies.iter().map(|_| None).collect();
        let mut logs = vec![ContactLog::default(); model.contacts.len()];
        let mut link_logs = vec![LinkLog::default(); model.links.len()];
        let mut events = Vec::new();
        let mut effort = Effort::default();
        let mut group_of = vec![0; model.bodies.len()];
        let (mut replays, mut records) = (Vec::with_capacity(groups.len()), Vec::new());
        for (number, group) in groups.into_iter().enumerate() {
            replays.push(group.replay);
            effort += group.effort;
            records.extend(group.record);
            for (body, path, system) in group.bodies {
                (paths[body], systems[body], group_of[body]) = (path, system, number);
            }
            for (contact, log) in group.contacts {
                logs[contact] = log;
            }
            for (link, log) in group.links {
                link_logs[link] = log;
            }
            // The first group's stay where they are.
            if events.is_empty() {
                events = group.events;
            } else {
                events.extend(group.events);
            }
        }
        events.retain(|event| event.t <= end);
        let record = (!records.is_empty()).then(|| Record::together(records, end));
        if let Some(record) = &record {
            events = events::of(record, &model);
        }
        events.sort_by(|a, b| a.t.total_cmp(&b.t));
        let recent = paths.iter().map(|_| RecentSteps::default()).collect();
        let (touches, books, overlaps) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Self {
            scene,
            model,
            end,
            stop,
            paths,
            replays,
            recent,
            group_of,
            systems,
            logs,
            link_logs,
            events,
            record,
            beside: None,
            effort,
            touches,
            books,
            overlaps,
            poundings: OnceLock::new(),
            uprights: OnceLock::new(),
        }
    }

    /// The scene that was run.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Bodies, pairs and contacts as compiled from the scene.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// How far the answer reaches \[s\].
    pub fn end(&self) -> f64 {
        self.end
    }

    /// What the impact model did; nothing where the contact model computed the run.
    pub fn impact(&self) -> Option<&Record> {
        self.record.as_ref()
    }

    /// The same scene by the model that does not lead, where it asks for both.
    pub fn beside(&self) -> Option<&Self> {
        self.beside.as_deref()
    }

    /// The same answer with another model's beside it.
    #[must_use]
    pub fn with_beside(mut self, beside: Self) -> Self {
        self.beside = Some(Arc::new(beside));
        self
    }

    /// What the run did, counted.
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// The same answer as far as `t`, as of a scene that ends then \[s\].
    #[must_use]
    pub fn cut(mut self, t: f64) -> Self {
        self.end = self.end.min(t);
        self.scene.duration = self.scene.duration.min(t);
        self.stop = self.stop.filter(|stop| stop.t <= t);
        self.events.retain(|event| event.t <= t);
        self.record = self.record.map(|record| Record::together(vec![record], t));
        self.forget();
        self.beside = self.beside.map(|beside| Arc::new(Arc::unwrap_or_clone(beside).cut(t)));
        self
    }

    /// The answer of the impact model as far as two bodies meet between which it has no contact, and the reason for that end,
    /// where the scene asks for contact between all faces.
    #[must_use]
    pub(super) fn until_met(mut self) -> Self {
        if self.impact().is_none() || self.scene.contact.between == Between::Ends {
            return self;
        }
        let Some(met) = self.overlaps().first() else { return self };
        let (t, [one, other]) = (met.first(), met.bodies.map(|body| body.name(&self.scene)));
        // A run that has ended by then says why.
        if self.stop.as_ref().is_some_and(|stop| stop.t <= t) {
            return self;
        }
        let place = format!("{one}, {other}");
        let reason = Text::new("stop-no-contact").into();
        self.stop = Some(Stop { cause: Cause::NoContact, t, place, reason });
        self.end = t;
        self.record = self.record.map(|record| Record::together(vec![record], t));
        self.forget();
        self
    }

    /// Lets go of what was found of another answer.
    fn forget(&mut self) {
        (self.touches, self.books, self.overlaps) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        (self.poundings, self.uprights) = (OnceLock::new(), OnceLock::new());
    }

    /// Why it stops before the scene's duration, if it does.
    pub fn stop(&self) -> Option<&Stop> {
        self.stop.as_ref()
    }

    /// Numbers of the pairs that are listed, in order: those that face each other or are declared, and of those between other
    /// faces of bodies that met the ones that touched.
    pub fn listed_pairs(&self) -> Vec<usize> {
        let pairs = &self.model.pairs;
        let mut touched = vec![false; pairs.len()];
        if pairs.iter().any(|pair| pair.met) {
            self.touches().iter().for_each(|touch| touched[touch.pair] = true);
        }
        (0..pairs.len()).filter(|&number| !pairs[number].met || touched[number]).collect()
    }

    /// The free motion of a body, where it has a closed form.
    pub(super) fn free_motion(&self, body: usize) -> Option<&BodyMotion> {
        self.systems[body].as_ref()
    }

    /// State of a body as its integrator holds it, at `t` clamped to what was computed.
    pub(super) fn state(&self, body: usize, t: f64) -> BodyState {
        let t = t.clamp(0.0, self.end);
        let own = &self.model.bodies[body];
        let mut state = BodyState::from_elem(0.0, own.width());
        match (self.paths[body].at(t), &self.systems[body]) {
            (Some((from, StoredMotion::Start(start))), Some(system)) => {
                return system.state(&system.fly(from, &start), t);
            }
            (Some((_, StoredMotion::Flight(flight))), Some(system)) => return system.state(flight, t),
            (Some((_, StoredMotion::Start(_) | StoredMotion::Flight(_))), None) => {}
            (Some((_, StoredMotion::Slide(slide))), _) => state.copy_from_slice(&slide.state(t)),
            (Some((_, StoredMotion::Step(piece))), _) => own.restore(piece.read(t, &mut state), &mut state),
            (Some((from, StoredMotion::Recomputed(number))), _) => {
                self.stepped(body, (number, from), |piece| own.restore(piece.read(t, &mut state), &mut state));
            }
            // Nothing was computed: the run gave up at its start.
            (None, _) => {
                state.copy_from_slice(&own.initial());
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
        let past = Past { model: &self.model, paths: &self.paths, systems: &self.systems, logs: &self.logs };
        let replay = &self.replays[self.group_of[body]];
        let mut steps = replay.step(number, from, &past);
        let place = replay.bodies(number).position(|of| of == body).unwrap_or(0);
        let own = steps.remove(place);
        for (of, step) in replay.bodies(number).filter(|of| *of != body).zip(steps) {
            self.recent[of].keep(number, step);
        }
        own
    }

    /// What the answer takes, without the scene \[bytes\]: paths, contact states, events.
    pub fn bytes(&self) -> usize {
        let paths: usize = self.paths.iter().map(StoredPath::bytes).sum();
        let replays: usize = self.replays.iter().map(Replay::bytes).sum();
        let logs: usize = self.logs.iter().map(ContactLog::bytes).sum();
        paths + replays + logs + self.events.len() * size_of::<Event>()
    }

    /// Pose and twist of a body at G.
    pub fn frame(&self, body: usize, t: f64) -> Frame {
        self.section_frame(body, 0, t)
    }

    /// Pose and twist of a section of a body.
    pub(super) fn section_frame(&self, body: usize, section: usize, t: f64) -> Frame {
        self.model.bodies[body].frame(section, &self.state(body, t))
    }

    /// Motion of a girder at `t`, clamped to what was computed.
    pub fn motion(&self, girder: usize, t: f64) -> Motion {
        let motion = Motion::of(&self.model, girder, &self.state(girder, t));
        Motion { theta: self.counted_angle(girder, t).unwrap_or(motion.theta), ..motion }
    }

    /// Motion at `t` of a rigid girder that an end of this one would be the end of: of a rigid girder its own.
    pub fn end_motion(&self, girder: usize, end: End, t: f64) -> Motion {
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
        match path.kept(number) {
            (from, StoredMotion::Step(piece)) => angle(from, piece),
            (from, StoredMotion::Recomputed(step)) => self.stepped(body, (step, from), |piece| angle(from, piece)),
            _ => None,
        }
    }

    /// The two sides of a contact at `t`: node's body, face's body.
    pub(super) fn sides(&self, contact: usize, t: f64) -> [Frame; 2] {
        let site = &self.model.contacts[contact];
        let [node, face] = self.model.sections(contact);
        [(site.node_body, node), (site.face_body, face)].map(|(body, section)| match body {
            Some(body) => self.section_frame(body, section, t),
            None => Frame::fixed(site.fixed),
        })
    }

    /// All events in order of time.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Largest difference in displacement of G from another run of the same bodies \[m\].
    pub fn difference(&self, other: &Self) -> f64 {
        self.differences(other)[0]
    }

    /// Largest differences in displacement of G \[m\] and in attitude \[rad\] from another run of the same bodies.
    pub fn differences(&self, other: &Self) -> [f64; 2] {
        let end = self.end.min(other.end);
        let bodies = self.model.bodies.len().min(other.model.bodies.len());
        let difference = |body: usize, t| {
            let [one, two] = [self, other].map(|run| Motion::of(&run.model, body, &run.state(body, t)));
            // |q₁ − q₂| = 2 sin(α/4) for a rotation by α between them; q and −q are one attitude.
            let apart = (one.attitude - two.attitude).length().min((one.attitude + two.attitude).length());
            [(one.displacement - two.displacement).length(), 4.0 * (0.5 * apart).min(1.0).asin()]
        };
        let larger = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].max(b[1])];
        let of_some = |some: usize| {
            let first = some * COMPARED_TOGETHER;
            let instants = (0..=COMPARED).map(|i| end * f64::from(i) / f64::from(COMPARED));
            let own = |t| (first..bodies.min(first + COMPARED_TOGETHER)).map(move |body| difference(body, t));
            instants.flat_map(own).fold([0.0; 2], larger)
        };
        (0..bodies.div_ceil(COMPARED_TOGETHER)).into_par_iter().map(of_some).reduce(|| [0.0; 2], larger)
    }
}
