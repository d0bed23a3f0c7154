//! Interface of every method: a name, a setting, and the work that is timed.

use crate::scene::{ModelKind, Scene};
use crate::sim::History;
use crate::study::accuracy::{Answer, Instants};

/// Kind of a method's setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettingKind {
    /// Steps to one interval of comparison, so that every instant ends a step.
    StepsPerInterval,
    /// A tolerance.
    Tolerance,
}

/// Task of a method.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Instants of comparison.
    pub instants: Instants,
    /// The setting: steps to an interval, or a tolerance.
    pub setting: f64,
}

/// Result of a method's work.
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
    /// Name in the command line and the tables.
    fn name(&self) -> &'static str;

    /// Kind of the setting.
    fn setting_kind(&self) -> SettingKind;

    /// Whether it computes such a scene: here the contact model with rigid girders.
    fn knows(&self, scene: &Scene) -> bool {
        scene.model.kind == ModelKind::Contact && scene.girders.iter().all(|girder| girder.elastic.is_none())
    }

    /// The work that is timed: from the scene to what can be asked for its motion.
    ///
    /// # Errors
    ///
    /// The reason of a missing answer, in words for the table.
    fn work(&self, job: &Job<'_>) -> Result<Work, String>;
}
