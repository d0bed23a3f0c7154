//! Flags that several commands share.

use crate::files;
use crate::scene::{Scene, SceneErrors};

/// A scene and what to change in it before it is used.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct SceneArgs {
    /// A scene file, or the name of a preset (`girderbench presets` lists them)
    #[arg(value_name = "SCENE|PRESET")]
    pub(super) scene: String,
    /// What to change in it.
    #[command(flatten)]
    pub(super) changes: Changes,
}

/// Changes to a scene from the command line.
#[derive(Clone, Debug, Default, clap::Args)]
pub(super) struct Changes {
    /// Override a value of the scene, e.g. `--set motion.angle_deg=45 --set girder.deck.skew_deg=60`
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) sets: Vec<String>,
    /// Run to this time, whatever the scene's `duration_s` [s]
    #[arg(long, value_name = "S", value_parser = positive, allow_negative_numbers = true)]
    pub(super) until: Option<f64>,
    /// Local error per step, whatever the scene's `solver.tolerance`
    #[arg(long, value_name = "T", value_parser = positive, allow_negative_numbers = true)]
    pub(super) tolerance: Option<f64>,
}

impl SceneArgs {
    /// Reads the scene with its changes.
    ///
    /// # Errors
    /// Every complaint about the scene or a change to it.
    pub(super) fn load(&self) -> Result<Scene, SceneErrors> {
        self.changes.load(&self.scene)
    }
}

impl Changes {
    /// Reads a scene with these changes.
    ///
    /// # Errors
    /// Every complaint about the scene or a change to it.
    pub(super) fn load(&self, name_or_path: &str) -> Result<Scene, SceneErrors> {
        let flag = |key: &str, value: Option<f64>| value.map(|value| format!("{key}={value:?}"));
        let flags = [flag("duration_s", self.until), flag("solver.tolerance", self.tolerance)];
        let sets: Vec<String> = self.sets.iter().cloned().chain(flags.into_iter().flatten()).collect();
        files::load_scene(name_or_path, &sets)
    }
}

/// A finite number above zero.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
        _ => Err("give a number above 0".into()),
    }
}
