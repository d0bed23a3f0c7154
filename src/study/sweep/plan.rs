//! Plan of a sweep: a scene, the keys that vary, the measures that are kept; its runs by number.

use std::collections::BTreeSet;

use rayon::prelude::*;
use xxhash_rust::xxh3::Xxh3;

use super::axis::{Axis, number};
use super::measure::Measure;
use crate::motion::format::Record;
use crate::scene::overrides::Laid;
use crate::scene::{ModelKind, Motion, Scene, SceneError, SceneErrors, format, keys, validate::validate};

/// Most runs of a sweep: what is kept of each is held in memory until the dataset is written, some hundred bytes a run.
const MOST: usize = 10_000_000;

/// Reads the records that a changed scene names and that are not loaded yet.
pub type ReadRecords = dyn Fn(&mut Scene) -> Result<(), SceneErrors> + Send + Sync;

/// A sweep: every combination of the values of its axes, the last axis varying first.
pub struct Plan {
    /// The scene that the values are set in.
    pub scene: Scene,
    /// The keys that vary, in the order given.
    pub axes: Vec<Axis>,
    /// Measures kept of each run.
    pub measures: Vec<&'static Measure>,
    laid: Laid,
    read: Box<ReadRecords>,
}

impl std::fmt::Debug for Plan {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Plan").field("axes", &self.axes).field("measures", &self.measures).finish_non_exhaustive()
    }
}

impl Plan {
    /// Of a scene, `KEY=VALUES` each, and names of measures.
    ///
    /// # Errors
    ///
    /// A file that cannot be read; a key or measure given twice; a value with which every run is refused.
    pub fn new(
        scene: Scene,
        vary: &[String],
        measures: &[String],
        read: Box<ReadRecords>,
    ) -> Result<Self, SceneErrors> {
        let axes: Vec<Axis> = vary.iter().map(|text| Axis::parse(text)).collect::<Result<_, _>>()?;
        let measures: Vec<_> = measures.iter().map(|name| Measure::named(name)).collect::<Result<_, _>>()?;
        once("--vary", axes.iter().map(|axis| axis.key.as_str()))?;
        once("--measure", measures.iter().map(|measure| measure.name))?;
        let runs = axes.iter().try_fold(1_usize, |runs, axis| runs.checked_mul(axis.values.len()));
        if runs.is_none_or(|runs| runs > MOST) {
            return Err(complaint("--vary", "too many runs", format!("give values that make {MOST} at most")));
        }
        let plan = Self { laid: Laid::out(&scene)?, scene, axes, measures, read };
        plan.check()?;
        Ok(plan)
    }

    /// Number of runs.
    pub fn runs(&self) -> usize {
        self.axes.iter().map(|axis| axis.values.len()).product()
    }

    /// Number of a run's value on each axis.
    pub fn choice(&self, run: usize) -> Vec<usize> {
        let mut rest = run;
        let mut choice: Vec<usize> = self
            .axes
            .iter()
            .rev()
            .map(|axis| {
                let value = rest % axis.values.len();
                rest /= axis.values.len();
                value
            })
            .collect();
        choice.reverse();
        choice
    }

    /// The run that has these values of the axes.
    pub fn run_of(&self, choice: &[usize]) -> usize {
        self.axes.iter().zip(choice).fold(0, |run, (axis, value)| run * axis.values.len() + value)
    }

    /// The scene of a run, checked.
    ///
    /// # Errors
    /// Values that are refused, alone or together.
    pub fn scene_of(&self, run: usize) -> Result<Scene, SceneErrors> {
        let settings: Vec<String> =
            self.axes.iter().zip(self.choice(run)).map(|(axis, value)| axis.setting(value)).collect();
        self.with(&settings)
    }

    fn with(&self, settings: &[String]) -> Result<Scene, SceneErrors> {
        let changed = || {
            let mut scene = self.laid.with(settings)?;
            (self.read)(&mut scene)?;
            validate(&scene)?;
            if scene.model.kind == ModelKind::Both {
                let remedy = "a run has one model: set model.kind=contact or impact, or vary model.kind=contact,impact";
                return Err(complaint("model.kind", "\"both\"", remedy.to_owned()));
            }
            Ok(scene)
        };
        changed().map_err(of_sweep)
    }

    /// Refuses a value with which no run can be computed, before any is.
    fn check(&self) -> Result<(), SceneErrors> {
        if self.axes.is_empty() {
            return self.with(&[]).map(|_| ());
        }
        for (number, axis) in self.axes.iter().enumerate() {
            let values = (0..axis.values.len()).into_par_iter();
            if let Some(error) = values.find_map_first(|value| self.first_with(number, value).err()) {
                return Err(error);
            }
        }
        Ok(())
    }

    /// The first run with this value that can be computed.
    ///
    /// # Errors
    /// There is none: why the first of them cannot.
    fn first_with(&self, axis: usize, value: usize) -> Result<usize, SceneErrors> {
        let own = self.axes[axis].values.len();
        let inner: usize = self.axes[axis + 1..].iter().map(|axis| axis.values.len()).product();
        let run = |other: usize| (other / inner * own + value) * inner + other % inner;
        // Mostly the first one does.
        let Err(error) = self.scene_of(run(0)) else { return Ok(run(0)) };
        let others = 1..self.runs() / own;
        others.into_par_iter().map(run).find_any(|&run| self.scene_of(run).is_ok()).ok_or(error)
    }

    /// The value of an axis in the scene as it stands, where it is a number.
    pub fn own(&self, axis: &Axis) -> Option<f64> {
        own_value(&self.laid, &axis.key)
    }

    /// The scene as it stands, as the text of a file.
    pub fn scene_text(&self) -> String {
        format::write(&self.scene)
    }

    /// Hash of the samples of every record that the runs are shaken by.
    pub fn records_hash(&self) -> u64 {
        let mut hashes = BTreeSet::from([hash_records(&self.scene)]);
        let moving = self.axes.iter().enumerate().filter(|(_, axis)| axis.key.starts_with("motion"));
        for (number, axis) in moving {
            let values = (0..axis.values.len()).into_par_iter();
            let runs = values.filter_map(|value| self.first_with(number, value).ok());
            hashes.par_extend(runs.filter_map(|run| self.scene_of(run).ok()).map(|scene| hash_records(&scene)));
        }
        let mut hash = Xxh3::new();
        for record in hashes {
            hash.update(&record.to_le_bytes());
        }
        hash.digest()
    }
}

/// Value of a key of a scene, stated or by default, where it is a number.
pub fn own_value(laid: &Laid, key: &str) -> Option<f64> {
    let stated = laid.value(key).and_then(|value| number(&value.to_string()));
    stated.or_else(|| keys::of_place(key)?.1.number())
}

/// Hash of what was read from the files of a scene's records, in the order of its motions.
fn hash_records(scene: &Scene) -> u64 {
    let mut hash = Xxh3::new();
    for (_, motion) in scene.motions() {
        let Motion::Record(motion) = motion else { continue };
        let loaded = motion.loaded.iter().chain(motion.loaded_components.iter().flatten());
        for channel in loaded.flat_map(|record: &std::sync::Arc<Record>| &record.channels) {
            std::iter::once(&channel.dt).chain(&channel.samples).for_each(|number| hash.update(&number.to_le_bytes()));
        }
    }
    hash.digest()
}

/// Refuses a name that is given twice.
fn once<'a>(flag: &str, names: impl Iterator<Item = &'a str>) -> Result<(), SceneErrors> {
    let mut seen = BTreeSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(complaint(flag, &format!("{name} twice"), "give each once".to_owned()));
        }
    }
    Ok(())
}

fn complaint(place: &str, value: &str, remedy: String) -> SceneErrors {
    SceneError { file: "sweep".into(), place: place.into(), value: value.into(), remedy: remedy.into() }.into()
}

/// Complaints about values that `--vary` has set.
fn of_sweep(errors: SceneErrors) -> SceneErrors {
    let about = |error: SceneError| {
        let place = match error.place.plain().strip_prefix("--set ") {
            Some(setting) => format!("--vary {setting}").into(),
            None => error.place.clone(),
        };
        SceneError { place, ..error }
    };
    SceneErrors(errors.0.into_iter().map(about).collect()).in_file("sweep")
}
