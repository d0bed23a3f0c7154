//! Computing a run, in portions where someone wants to see progress or cancel.

use std::sync::Arc;

use rayon::prelude::*;

use super::{History, Motion, Stop};
use crate::dynamics::Model;
use crate::dynamics::run::{self, Run};
use crate::scene::facing::{self, SolidId};
use crate::scene::{Between, ModelKind, Scene, SceneErrors};

/// Portions in which a run reports how far it is.
const PORTIONS: u32 = 200;

/// A run that advances in portions; where a scene asks for both models, the one that leads with the other beside it.
#[derive(Debug)]
pub struct Session {
    scene: Scene,
    model: Arc<Model>,
    /// One run a group of bodies.
    groups: Vec<Box<dyn Run>>,
    /// Time up to which a computation was last requested \[s\].
    asked: f64,
    /// Bodies that met without facing each other as placed, so far: between them every face can touch.
    met: Vec<[SolidId; 2]>,
    /// The answer, once the scene's duration is computed.
    answer: Option<History>,
    /// The other model's run, where a scene asks for both.
    beside: Option<Box<Self>>,
}

/// Progress of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// Until when everything is computed \[s\].
    pub t: f64,
    /// Number of events.
    pub events: usize,
    /// Number of steps of the integrators.
    pub steps: u64,
    /// Number of times that two bodies have met that no contact joined: after each the run began anew, with contact between them.
    pub met: usize,
}

impl Session {
    /// Compiles a scene and sets its bodies up at t = 0.
    ///
    /// # Errors
    /// Every complaint about the scene, each naming place, value and remedy.
    pub fn new(scene: &Scene) -> Result<Self, SceneErrors> {
        let mut session = Self::of_model(scene, model(scene, &[])?);
        session.beside = beside(scene).map(|scene| Self::new(&scene)).transpose()?.map(Box::new);
        Ok(session)
    }

    /// A run that another one of like scenes is compared with: contact between all faces of the bodies that met in that from the beginning,
    /// and steps that end midway between the samples of a record, too.
    ///
    /// # Errors
    /// Every complaint about the scene.
    pub(super) fn for_comparison(scene: &Scene, met: Vec<[SolidId; 2]>) -> Result<Self, SceneErrors> {
        let model = Model { halves_intervals: true, ..model(scene, &met)? };
        Ok(Self { met, ..Self::of_model(scene, model) })
    }

    /// Sets the bodies of a model up at t = 0 that was compiled from `scene`, with other laws of its pairs, say; without the
    /// other model's run beside it.
    pub fn of_model(scene: &Scene, model: Model) -> Self {
        let model = Arc::new(model);
        let groups = (0..model.groups.len()).into_par_iter();
        let groups = groups.map(|group| run::start(&model, group, scene.model.kind)).collect();
        Self { scene: scene.clone(), model, groups, asked: 0.0, met: Vec::new(), answer: None, beside: None }
    }

    /// The scene that is run.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Computes on to `until` or the scene's duration; `go_on` is called now and then and ends the work by returning `false`. Results so
    /// far are kept. Portions do not change them.
    ///
    /// Once the scene's duration is reached, bodies that met where no contact joins them are joined and the run begins anew
    /// (`docs/physics.md#contact-wherever-bodies-meet`).
    pub fn advance(&mut self, until: f64, go_on: &mut dyn FnMut(Reached) -> bool) {
        while self.advance_as_joined(until, go_on) && self.join_met() {}
    }

    /// Computes on with the pairs that there are; `false` where the work was stopped.
    fn advance_as_joined(&mut self, until: f64, go_on: &mut dyn FnMut(Reached) -> bool) -> bool {
        let until = until.min(self.model.duration);
        let from = self.asked.min(until);
        for portion in 1..=PORTIONS {
            let t = if portion == PORTIONS {
                until
            } else {
                from + (until - from) * f64::from(portion) / f64::from(PORTIONS)
            };
            self.work(t);
            if !go_on(Reached { t, events: self.events(), steps: self.steps(), met: self.met.len() }) {
                return false;
            }
        }
        true
    }

    /// Joins bodies that met without contact and sets the run up at t = 0 again; `false` where there are none, and the answer
    /// stands.
    fn join_met(&mut self) -> bool {
        let looks = self.scene.contact.between == Between::All && self.scene.model.kind != ModelKind::Impact;
        if !looks || self.answer.is_some() || self.asked < self.model.duration {
            return false;
        }
        let groups = std::mem::take(&mut self.groups).into_iter().map(Run::finish).collect();
        let history = History::gather(self.scene.clone(), Arc::clone(&self.model), groups);
        let known = self.met.len();
        for overlap in history.overlaps() {
            if overlap.has_met(&history) && !self.met.contains(&overlap.bodies) {
                self.met.push(overlap.bodies);
            }
        }
        // The scene has been compiled before.
        if let Some(Ok(model)) = (self.met.len() > known).then(|| model(&self.scene, &self.met)) {
            let halves_intervals = self.model.halves_intervals;
            let again = Self::of_model(&self.scene, Model { halves_intervals, ..model });
            (self.model, self.groups, self.asked) = (again.model, again.groups, 0.0);
            true
        } else {
            self.answer = Some(history);
            false
        }
    }

    /// Groups that no pair and no link joins advance in parallel; the result of a group does not depend on the thread.
    fn work(&mut self, until: f64) {
        self.asked = self.asked.max(until);
        if let [only] = self.groups.as_mut_slice() {
            only.advance(until);
        } else {
            self.groups.par_iter_mut().for_each(|group| group.advance(until));
        }
        if let Some(beside) = &mut self.beside {
            beside.work(until);
        }
    }

    /// Bodies, pairs and contacts as compiled from the scene.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Number of events in [`History::events`] so far; the impact model keeps a record instead.
    fn events(&self) -> usize {
        self.groups.iter().map(|group| group.events()).sum()
    }

    /// Number of steps of the integrators of all groups.
    fn steps(&self) -> u64 {
        self.groups.iter().map(|group| group.schedule().effort.steps).sum()
    }

    /// Reason of the first early stop of a group of bodies, if there was one.
    fn stop(&self) -> Option<&Stop> {
        self.groups.iter().filter_map(|group| group.schedule().stop()).min_by(|a, b| a.t.total_cmp(&b.t))
    }

    /// Motion of every girder at the time that was last asked for: what [`History::motion`] will say of it, to within
    /// rounding, unless bodies meet until the end that no contact joins yet. Until the scene's duration is computed the θ
    /// of a spatial girder is without its half turns, between −π and π.
    ///
    /// # Errors
    ///
    /// The stop of a group of bodies.
    pub fn motions(&self) -> Result<Vec<Motion>, &Stop> {
        let at = self.asked.min(self.model.duration);
        if let Some(history) = &self.answer {
            let motions = || (0..self.model.bodies.len()).map(|girder| history.motion(girder, at)).collect();
            return history.stop().map_or_else(|| Ok(motions()), Err);
        }
        if let Some(stop) = self.stop() {
            return Err(stop);
        }
        Ok(self.motions_at(at))
    }

    /// Motion of every girder at a time between the last event and the next \[s\], of a run that was stopped too.
    pub(crate) fn motions_at(&self, t: f64) -> Vec<Motion> {
        let mut states: Vec<(usize, Vec<f64>)> = self.groups.iter().flat_map(|group| group.states(t)).collect();
        states.sort_by_key(|(body, _)| *body);
        states.into_iter().map(|(body, state)| Motion::of(&self.model, body, &state)).collect()
    }

    /// The results so far.
    pub fn finish(self) -> History {
        let beside = self.beside.map(|beside| beside.finish());
        let (scene, model, groups) = (self.scene, self.model, self.groups);
        let gather = || History::gather(scene, model, groups.into_iter().map(Run::finish).collect());
        let history = self.answer.unwrap_or_else(gather).until_met();
        match beside {
            Some(beside) => history.with_beside(beside),
            None => history,
        }
    }

    /// Computes to the end of the duration.
    pub(super) fn complete(mut self) -> History {
        self.work(self.scene.duration);
        while self.join_met() {
            self.work(self.scene.duration);
        }
        self.finish()
    }
}

impl History {
    /// Runs a scene to the end of its duration.
    ///
    /// # Errors
    /// Every complaint about the scene, each naming field, value and remedy.
    pub fn of(scene: &Scene) -> Result<Self, SceneErrors> {
        Ok(Session::new(scene)?.complete())
    }
}

/// A scene compiled with contact between facing ends, and between all faces of bodies that met.
fn model(scene: &Scene, met: &[[SolidId; 2]]) -> Result<Model, SceneErrors> {
    let mut facings = crate::scene::validate::facings(scene)?;
    let new = facing::between(scene, met, &facings);
    facings.extend(new);
    Model::of(scene, facings)
}

/// The scene of the model that does not lead, where both are asked for.
fn beside(scene: &Scene) -> Option<Scene> {
    let [_, second] = scene.model.kind.models() else { return None };
    let mut other = scene.clone();
    other.model.kind = *second;
    Some(other)
}
