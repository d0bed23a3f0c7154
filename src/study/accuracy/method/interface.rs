//! What every method is: a name, a setting, and the work that is timed.

use crate::scene::{ModelKind, Scene};
use crate::sim::History;
use crate::study::accuracy::{Answer, Instants};

/// What the setting of a method is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettingKind {
    /// Steps to one interval of comparison, so that every instant ends a step.
    StepsPerInterval,
    /// A tolerance.
    Tolerance,
}

/// What a method was given to do.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// When it is asked.
    pub instants: Instants,
    /// The setting: steps to an interval, or a tolerance.
    pub setting: f64,
}

/// What a method leaves behind.
#[derive(Debug)]
pub enum Work {
    /// A history that can be asked for any time.
    History(Box<History>),
    /// Samples taken on the way.
    Sampled(Answer),
}

impl Work {
    /// The answer at the instants.
    pub fn answer(self, instants: Instants) -> Answer {
        match self {
            Self::History(history) => Answer::of(&history, instants),
            Self::Sampled(answer) => answer,
        }
    }
}

/// A way to answer a scene.
pub trait Method: Sync {
    /// What the command line and the tables call it.
    fn name(&self) -> &'static str;

    /// What it is turned by.
    fn setting_kind(&self) -> SettingKind;

    /// Whether it computes such a scene: here the contact model with rigid girders.
    fn knows(&self, scene: &Scene) -> bool {
        scene.model.kind == ModelKind::Contact && scene.girders.iter().all(|girder| girder.elastic.is_none())
    }

    /// The work that is timed: from the scene to what can be asked for its motion.
    ///
    /// # Errors
    /// Why there is no answer, in words for the table.
    fn work(&self, job: &Job<'_>) -> Result<Work, String>;
}
