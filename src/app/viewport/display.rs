//! How the 3D view is looked at: layers, force scale, sight, and what a click does.

use crate::app::command::{Sight, Tool};
use crate::app::run::answer::Answer;
use crate::scene::{Overlays, Scene};
use crate::view::auto_force_scale;

/// Least automatic force scale \[N per m\]: a run without forces has none, and an arrow's length is divided by it.
const LEAST_SCALE: f64 = 1e-6;

/// Layers, force scale, sight and tool.
#[derive(Clone, Debug)]
pub struct Display {
    /// Which layers are shown.
    pub(in crate::app) overlays: Overlays,
    /// How the view is looked at.
    pub sight: Sight,
    /// Tool of a click in the view.
    pub tool: Tool,
    force_scale: Option<f64>,
    /// Number of the answer, and its force scale \[N per m\].
    automatic: (u64, f64),
}

impl Display {
    /// As a scene wants to be looked at.
    pub(in crate::app) fn of(scene: &Scene) -> Self {
        Self {
            overlays: scene.view.overlays,
            sight: Sight::default(),
            tool: Tool::default(),
            force_scale: scene.view.force_scale,
            automatic: (0, 1.0),
        }
    }

    /// Takes over layers and force scale of another scene.
    pub(in crate::app) fn take_from(&mut self, scene: &Scene) {
        self.overlays = scene.view.overlays;
        self.force_scale = scene.view.force_scale;
    }

    /// The scene with the view as it is seen, as it would be saved.
    pub(in crate::app) fn scene_as_seen(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        scene.view.overlays = self.overlays;
        scene.view.force_scale = self.force_scale;
        scene
    }

    /// Everything of it that commands can change and a frame shows.
    pub(in crate::app) fn seen(&self) -> impl PartialEq + use<> {
        (self.overlays, self.sight, self.tool, self.force_scale)
    }

    /// Force scale, unless it follows the run's peak \[N per m\].
    pub(in crate::app) fn force_scale(&self) -> Option<f64> {
        self.force_scale
    }

    /// Sets the force scale \[N per m\]; one that is not a positive number lets it follow the run's peak.
    pub(in crate::app) fn set_force_scale(&mut self, scale: Option<f64>) {
        self.force_scale = scale.filter(|s| s.is_finite() && *s > 0.0);
    }

    /// Force scale from the run's peak \[N per m\].
    pub(in crate::app) fn automatic_force_scale(&self) -> f64 {
        self.automatic.1
    }

    /// Computes the automatic scale anew when the answer is another one.
    pub(in crate::app) fn rescale(&mut self, answer: &Answer) {
        if self.automatic.0 != answer.number {
            self.automatic = (answer.number, auto_force_scale(&answer.history).max(LEAST_SCALE));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    #[test]
    fn a_scene_is_saved_with_the_view_as_it_is_seen() {
        let scene = presets::load(presets::OPENING).expect("ships");
        let mut display = Display::of(&scene);
        display.overlays.grid = !display.overlays.grid;
        display.set_force_scale(Some(5.0));
        let saved = display.scene_as_seen(&scene);
        assert_eq!((saved.view.overlays, saved.view.force_scale), (display.overlays, Some(5.0)), "as it is seen");
        display.take_from(&scene);
        assert_eq!(display.scene_as_seen(&scene), scene, "as it was");
    }

    #[test]
    fn a_force_scale_that_is_no_length_follows_the_peak() {
        let mut display = Display::of(&presets::load(presets::OPENING).expect("ships"));
        for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            display.set_force_scale(Some(scale));
            assert_eq!(display.force_scale(), None, "{scale} N per m");
        }
    }
}
