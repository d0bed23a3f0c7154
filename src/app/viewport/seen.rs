//! Everything that the 3D view shows, read-only.

use std::sync::Arc;

use wgpu::TextureFormat;

use crate::app::run::answer::Answer;
use crate::app::run::comparison::Pin;
use crate::app::run::runner::Runner;
use crate::app::time::playback::Playback;
use crate::app::viewport::display::Display;
use crate::scene::Scene;
use crate::sim::History;
use crate::view::Target;

/// Subject of the 3D view.
#[derive(Clone, Copy)]
pub(in crate::app) struct Seen<'a> {
    /// The scene as it is edited.
    pub(in crate::app) scene: &'a Scene,
    /// Counts the changes of the scene.
    pub(in crate::app) revision: u64,
    /// Its answer, or what became of it.
    pub(in crate::app) runner: &'a Runner,
    /// The time shown.
    pub(in crate::app) playback: &'a Playback,
    /// Selection, the leading one last.
    pub(in crate::app) selection: &'a [Target],
    /// Layers, tool, and how the view is looked at.
    pub(in crate::app) display: &'a Display,
    /// Runs kept to compare with.
    pub(in crate::app) pins: &'a [Pin],
    /// Format of egui's own target.
    pub(in crate::app) format: TextureFormat,
    /// Whether a processor draws: what moves is then drawn coarser.
    pub(in crate::app) is_drawn_by_processor: bool,
}

impl<'a> Seen<'a> {
    /// The last good answer.
    pub(in crate::app) fn answer(&self) -> Option<&'a Arc<Answer>> {
        self.runner.answer()
    }

    /// Whether the answer belongs to an older scene.
    pub(in crate::app) fn is_stale(&self) -> bool {
        self.runner.is_stale()
    }

    /// Time shown \[s\].
    pub(in crate::app) fn t(&self) -> f64 {
        self.playback.clock.t
    }

    /// An old answer is shown with its own scene, so that the two belong together.
    pub(in crate::app) fn shown(&self) -> (&'a Scene, Option<&'a History>) {
        self.runner.shown(self.scene)
    }
}
