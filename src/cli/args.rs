//! Flags that several commands share.

use std::path::{Path, PathBuf};

use super::failure::Failure;
use crate::files;
use crate::language::{Message, Text, said};
use crate::motion::format::Unit;
use crate::scene::validate::validate;
use crate::scene::{Scene, SceneError, SceneErrors};

/// A scene and what to change in it before it is used.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct SceneArgs {
    /// A scene file, or the name of a preset (`girderbench presets` lists them)
    #[arg(value_name = "SCENE|PRESET")]
    pub(super) scene: PathBuf,
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

/// How many threads runs share.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(super) struct Threads {
    /// Compute on so many threads (runs of a sweep, bodies that no pair joins); `RAYON_NUM_THREADS` when left out, else one a processor
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), allow_negative_numbers = true)]
    threads: Option<u16>,
}

impl Threads {
    /// Sets the number for the program; to be called before anything is computed.
    ///
    /// # Errors
    /// More threads than the system starts.
    pub(super) fn start(self) -> Result<(), Failure> {
        let Some(count) = self.threads else { return Ok(()) };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count.into()).build_global();
        pool.map_err(|error| Failure::Input(said!("failed-threads", "count" => count, "error" => error.to_string())))
    }
}

impl SceneArgs {
    /// Reads the scene with its changes.
    ///
    /// # Errors
    /// Every complaint about the scene or a change to it.
    pub(super) fn load(&self) -> Result<Scene, SceneErrors> {
        self.changes.load(&self.scene)
    }

    /// Result, with complaints under the name of the scene's file, which compilation and run do not know.
    ///
    /// # Errors
    /// Those of the result.
    pub(super) fn of_its_file<T>(&self, result: Result<T, SceneErrors>) -> Result<T, SceneErrors> {
        result.map_err(|errors| errors.in_file(&self.scene.to_string_lossy()))
    }
}

impl Changes {
    /// Reads a scene with these changes.
    ///
    /// `--until` and `--tolerance` come after the check of the scene as it stands, so that they hide no fault of its own.
    ///
    /// # Errors
    /// Every complaint about the scene or a change to it.
    pub(super) fn load(&self, name_or_path: &Path) -> Result<Scene, SceneErrors> {
        let mut scene = files::load_scene(name_or_path, &self.sets)?;
        scene.duration = self.until.unwrap_or(scene.duration);
        scene.solver.tolerance = self.tolerance.unwrap_or(scene.solver.tolerance);
        if self.until.or(self.tolerance).is_some() {
            validate(&scene).map_err(|errors| errors_of_flags(errors).in_file(&name_or_path.to_string_lossy()))?;
        }
        Ok(scene)
    }

    /// The flags that were given, as they are typed.
    pub(super) fn given(&self) -> Vec<&'static str> {
        let all = [
            ("--set", !self.sets.is_empty()),
            ("--until", self.until.is_some()),
            ("--tolerance", self.tolerance.is_some()),
        ];
        all.into_iter().filter(|(_, given)| *given).map(|(flag, _)| flag).collect()
    }
}

/// Complaints about what a flag has set, under the flag's name.
fn errors_of_flags(errors: SceneErrors) -> SceneErrors {
    let flag = |place: Message| match place.plain() {
        "duration_s" => "--until".into(),
        "solver.tolerance" => "--tolerance".into(),
        _ => place,
    };
    SceneErrors(errors.0.into_iter().map(|error| SceneError { place: flag(error.place), ..error }).collect())
}

/// A unit of acceleration in a record file.
pub(super) fn record_unit(text: &str) -> Result<Unit, String> {
    Unit::of_word(text).ok_or_else(|| said!("wrong-one-of", "words" => Unit::WORDS.join(", ")))
}

/// A finite number.
pub(super) fn finite(text: &str) -> Result<f64, String> {
    text.parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(|| Text::new("wrong-no-number").into())
}

/// A count of at least one.
pub(super) fn at_least_one(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(n) if n > 0 => Ok(n),
        _ => Err(Text::new("wrong-no-count").into()),
    }
}

/// A finite number above zero.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
        _ => Err(Text::new("wrong-not-above").into()),
    }
}

/// A finite number from zero up.
pub(super) fn not_negative(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value >= 0.0 => Ok(value),
        _ => Err(Text::new("wrong-below").into()),
    }
}
