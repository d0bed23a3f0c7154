//! Computing a run, in portions where someone wants to see progress or cancel.

use std::sync::Arc;

use rayon::prelude::*;

use super::History;
use crate::dynamics::Model;
use crate::dynamics::engine::Engine;
use crate::scene::{Scene, SceneErrors};

/// Portions in which a run reports how far it is.
const PORTIONS: u32 = 200;

/// A run that advances in portions.
#[derive(Debug)]
pub struct Session {
    scene: Scene,
    model: Arc<Model>,
    engines: Vec<Engine>,
}

impl Session {
    /// Compiles a scene and sets its bodies up at t = 0.
    ///
    /// # Errors
    /// Every complaint about the scene, each naming place, value and remedy.
    pub fn new(scene: &Scene) -> Result<Self, SceneErrors> {
        crate::scene::validate::validate(scene)?;
        let model = Arc::new(Model::compile(scene)?);
        let engines = (0..model.groups.len()).into_par_iter().map(|group| Engine::new(&model, group)).collect();
        Ok(Self { scene: scene.clone(), model, engines })
    }

    /// Computes on to `until` or the scene's duration; `go_on` is asked now and then with the time reached \[s\] and
    /// stops the work by answering `false`. What is computed is kept. Portions do not change the answer.
    pub fn advance(&mut self, until: f64, go_on: &mut dyn FnMut(f64) -> bool) {
        let (from, until) = (self.reached(), until.min(self.model.duration));
        for portion in 1..=PORTIONS {
            let t = if portion == PORTIONS {
                until
            } else {
                from + (until - from) * f64::from(portion) / f64::from(PORTIONS)
            };
            self.work(t);
            if !go_on(t) {
                return;
            }
        }
    }

    /// Groups that no pair joins advance on as many threads as there are; each is the same whoever computes it.
    fn work(&mut self, until: f64) {
        if self.engines.len() == 1 {
            self.engines[0].advance(until);
        } else {
            self.engines.par_iter_mut().for_each(|engine| engine.advance(until));
        }
    }

    /// How far every group has come \[s\].
    fn reached(&self) -> f64 {
        self.engines.iter().map(Engine::now).fold(self.model.duration, f64::min)
    }

    /// What is computed so far.
    pub fn finish(self) -> History {
        History::gather(self.scene, self.model, self.engines.into_iter().map(Engine::finish).collect())
    }

    /// Runs a scene to the end of its duration, without asking anybody.
    ///
    /// # Errors
    /// Every complaint about the scene.
    pub fn run(scene: &Scene) -> Result<History, SceneErrors> {
        let mut session = Self::new(scene)?;
        session.work(scene.duration);
        Ok(session.finish())
    }
}
