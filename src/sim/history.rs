//! The answer: a dense, continuous history that can be asked for any quantity at any time.

use std::sync::{Arc, OnceLock};

use super::ledger::Books;
use super::replayed::Replayed;
use super::{Event, Ledger, Motion, Session, Stop, Touch, digest, impact, touches};
use crate::contact::Frame;
use crate::dynamics::Model;
use crate::dynamics::event_loop::effort::Effort;
use crate::dynamics::free_flight::flight::FreeMotion;
use crate::dynamics::impact2d::Record;
use crate::dynamics::model::rigid_body;
use crate::dynamics::record::contact_log::ContactLog;
use crate::dynamics::record::recomputed_steps::Past;
use crate::dynamics::run::Finished;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;
use crate::dynamics::trajectory::stored_path::{StoredMotion, StoredPath};
use crate::scene::{ModelKind, Scene, SceneErrors};

/// Instants at which two runs are compared for the error estimate.
const COMPARED: u32 = 2000;

/// The headline numbers of a run.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Summary {
    /// Largest displacement of any girder's G from where it was placed \[m\].
    pub max_displacement: f64,
    /// Largest |θ| of any girder \[rad\].
    pub max_rotation: f64,
    /// Largest |`R_k`| of any contact \[N\].
    pub peak_force: f64,
    /// Largest impulse of a hit; nothing under the contact model \[N·s\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_impulse: Option<f64>,
    /// When, of the impulse where there is one \[s\].
    pub peak_time: Option<f64>,
    /// Touches of single contacts.
    pub touches: usize,
    /// Hits: touches of a pair, from its first contact closing to its last opening.
    pub hits: usize,
    /// Contact time in stick, summed over contacts \[s\].
    pub stick_time: f64,
    /// Contact time in slip, summed over contacts \[s\].
    pub slip_time: f64,
}

/// A run of a scene, from t = 0 to [`History::end`].
#[derive(Clone, Debug)]
pub struct History {
    scene: Scene,
    model: Arc<Model>,
    end: f64,
    stop: Option<Stop>,
    pub(super) paths: Vec<StoredPath>,
    /// Steps kept by their starts, group by group.
    pub(super) replayed: Vec<Replayed>,
    /// The group of each body.
    group_of: Vec<usize>,
    systems: Vec<Option<FreeMotion>>,
    pub(super) logs: Vec<ContactLog>,
    events: Vec<Event>,
    record: Option<Record>,
    /// The same scene by the other model.
    beside: Option<Arc<Self>>,
    effort: Effort,
    touches: OnceLock<Vec<Touch>>,
    books: OnceLock<Books>,
}

impl History {
    /// Runs a scene to the end of its duration.
    ///
    /// # Errors
    /// Every complaint about the scene, each naming field, value and remedy.
    pub fn of(scene: &Scene) -> Result<Self, SceneErrors> {
        Session::run(scene)
    }

    /// Puts the groups of a run together; the impact model has a record of each.
    pub(super) fn gather(scene: Scene, model: Arc<Model>, groups: Vec<Finished>) -> Self {
        let end = groups.iter().map(|g| g.end).fold(model.duration, f64::min);
        let stop = groups.iter().filter_map(|g| g.stop.clone()).min_by(|a, b| a.t.total_cmp(&b.t));
        let mut paths = vec![StoredPath::default(); model.bodies.len()];
        let mut systems: Vec<Option<FreeMotion>> = model.bodies.iter().map(|_| None).collect();
        let mut logs = vec![ContactLog::default(); model.contacts.len()];
        let mut events = Vec::new();
        let mut effort = Effort::default();
        let mut group_of = vec![0; model.bodies.len()];
        let (mut replayed, mut records) = (Vec::with_capacity(groups.len()), Vec::new());
        for (number, group) in groups.into_iter().enumerate() {
            replayed.push(Replayed::of(group.replay));
            effort += group.effort;
            records.extend(group.record);
            for (body, path, system) in group.bodies {
                (paths[body], systems[body], group_of[body]) = (path, system, number);
            }
            for (contact, log) in group.contacts {
                logs[contact] = log;
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
            events = impact::events(record, &model);
        }
        events.sort_by(|a, b| a.t.total_cmp(&b.t));
        let (touches, books) = (OnceLock::new(), OnceLock::new());
        Self {
            scene,
            model,
            end,
            stop,
            paths,
            replayed,
            group_of,
            systems,
            logs,
            events,
            record,
            beside: None,
            effort,
            touches,
            books,
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
        (self.touches, self.books) = (OnceLock::new(), OnceLock::new());
        self.beside = self.beside.map(|beside| Arc::new(Arc::unwrap_or_clone(beside).cut(t)));
        self
    }

    /// Why it stops before the scene's duration, if it does.
    pub fn stop(&self) -> Option<&Stop> {
        self.stop.as_ref()
    }

    /// State of a body as its integrator holds it, at `t` clamped to what was computed.
    pub(super) fn state(&self, body: usize, t: f64) -> [f64; rigid_body::SPATIAL] {
        let t = t.clamp(0.0, self.end);
        let mut state = [0.0; rigid_body::SPATIAL];
        let width = rigid_body::width(self.model.kind);
        match (self.paths[body].at(t), &self.systems[body]) {
            (Some((from, StoredMotion::Start(start))), Some(system)) => {
                state[..6].copy_from_slice(&system.state(&system.fly(from, start), t));
            }
            (Some((_, StoredMotion::Flight(flight))), Some(system)) => {
                state[..6].copy_from_slice(&system.state(flight, t));
            }
            (Some((_, StoredMotion::Start(_) | StoredMotion::Flight(_))), None) => {}
            (Some((_, StoredMotion::Slide(slide))), _) => state[..6].copy_from_slice(&slide.state(t)),
            (Some((_, StoredMotion::Step(piece))), _) => piece.read(t, &mut state[..width]),
            (Some((from, StoredMotion::Again(number))), _) => {
                self.stepped(body, (number, from), |piece| piece.read(t, &mut state[..width]));
            }
            // Nothing was computed: the run gave up at its start.
            (None, _) => {
                let initial = rigid_body::initial(self.model.kind, &self.model.bodies[body]);
                state[..initial.len()].copy_from_slice(&initial);
            }
        }
        state
    }

    /// A step that is kept by its start, taken again: `read` gets the body's part.
    pub(super) fn stepped<T>(&self, body: usize, step: (u32, f64), read: impl FnOnce(&StepPolynomial) -> T) -> T {
        let past = Past { model: &self.model, paths: &self.paths, systems: &self.systems, logs: &self.logs };
        self.replayed[self.group_of[body]].with(step, body, &past, read)
    }

    /// What the answer takes, without the scene \[bytes\]: paths, contact states, events.
    pub fn bytes(&self) -> usize {
        let paths: usize = self.paths.iter().map(StoredPath::bytes).sum();
        let replayed: usize = self.replayed.iter().map(Replayed::bytes).sum();
        let logs: usize = self.logs.iter().map(ContactLog::bytes).sum();
        paths + replayed + logs + self.events.len() * size_of::<Event>()
    }

    /// Pose and twist of a body.
    pub fn frame(&self, body: usize, t: f64) -> Frame {
        rigid_body::frame(self.model.kind, &self.model.bodies[body], &self.state(body, t))
    }

    /// Motion of a girder at `t`, clamped to what was computed.
    pub fn motion(&self, girder: usize, t: f64) -> Motion {
        Motion::of(&self.model, girder, &self.state(girder, t))
    }

    /// The two sides of a contact at `t`: node's body, face's body.
    pub(super) fn sides(&self, contact: usize, t: f64) -> [Frame; 2] {
        let site = &self.model.contacts[contact];
        [site.node_body, site.face_body].map(|body| match body {
            Some(body) => self.frame(body, t),
            None => Frame::fixed(site.fixed),
        })
    }

    /// All events in order of time.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// All touches, ordered by their start.
    pub fn touches(&self) -> &[Touch] {
        self.touches.get_or_init(|| match &self.record {
            Some(record) => impact::touches(self, record),
            None => touches::find(self),
        })
    }

    /// The touch with the largest force.
    pub fn hardest(&self) -> Option<&Touch> {
        // Of equals the first; an impulse outweighs every force that takes its time.
        let size = |touch: &Touch| (touch.impulse, touch.peak_force);
        let heavier = |a: &&Touch, b: &&Touch| {
            let (a, b) = (size(a), size(b));
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
        };
        self.touches().iter().rev().max_by(heavier)
    }

    /// The energy ledger at `t`.
    pub fn ledger(&self, t: f64) -> Ledger {
        let books = self.books.get_or_init(|| Books::open(self));
        books.at(self, t.clamp(0.0, self.end))
    }

    /// Headline numbers.
    pub fn summary(&self) -> Summary {
        let touches = self.touches();
        let hardest = self.hardest();
        let (displacement, rotation) = self.extremes();
        Summary {
            max_displacement: displacement,
            max_rotation: rotation,
            peak_force: touches.iter().map(|touch| touch.peak_force).fold(0.0, f64::max),
            peak_impulse: self.record.is_some().then(|| hardest.map_or(0.0, |touch| touch.impulse)),
            peak_time: hardest.map(|touch| touch.peak_time),
            touches: touches.len(),
            hits: touches::hits(touches),
            stick_time: touches.iter().fold(0.0, |sum, touch| sum + touch.stick),
            slip_time: touches.iter().fold(0.0, |sum, touch| sum + touch.slip),
        }
    }

    /// Largest displacement and |θ| of any girder, looked for at a rate that the fastest bearing cannot outrun.
    fn extremes(&self) -> (f64, f64) {
        let (mut displacement, mut rotation) = (0.0f64, 0.0f64);
        for body in 0..self.model.bodies.len() {
            let times = touches::looks(self, body);
            displacement = displacement.max(touches::largest(&times, |t| self.motion(body, t).displacement.length()));
            rotation = rotation.max(touches::largest(&times, |t| self.motion(body, t).theta.abs()));
        }
        (displacement, rotation)
    }

    /// Hash of the whole answer, bit for bit.
    pub fn digest(&self) -> u64 {
        digest::of(self)
    }

    /// Largest displacement difference from a run at a hundredth of the tolerance \[m\].
    pub fn estimate_error(&self) -> f64 {
        let mut finer = self.scene.clone();
        finer.model.kind = if self.record.is_some() { ModelKind::Impact } else { ModelKind::Contact };
        finer.solver.tolerance = (self.scene.solver.tolerance / 100.0).max(1e-13);
        if self.scene.solver.tolerance <= 1e-13 {
            // Nothing finer is left: from a coarser run, which errs the other way.
            finer.solver.tolerance = 1e-12;
        }
        match Self::of(&finer) {
            Ok(other) => self.difference(&other),
            // The scene has been run before.
            Err(_) => f64::NAN,
        }
    }

    /// Largest difference in displacement from another run of the same bodies \[m\].
    pub fn difference(&self, other: &Self) -> f64 {
        let end = self.end.min(other.end);
        let mut largest: f64 = 0.0;
        for i in 0..=COMPARED {
            let t = end * f64::from(i) / f64::from(COMPARED);
            for body in 0..self.model.bodies.len().min(other.model.bodies.len()) {
                let apart = self.motion(body, t).displacement - other.motion(body, t).displacement;
                largest = largest.max(apart.length());
            }
        }
        largest
    }
}
