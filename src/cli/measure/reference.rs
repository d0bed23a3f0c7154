//! The run that a film is compared with.

use std::path::PathBuf;

use crate::cli::compute::compute_as_asked;
use crate::cli::digits::six;
use crate::cli::failure::Failure;
use crate::files;
use crate::language::said;
use crate::sim::History;
use crate::tables::read::{self, Trajectory};

/// The run that the film shows
#[derive(Clone, Debug, clap::Args)]
pub(super) struct ReferenceArgs {
    /// Compare with the run of this scene or preset
    #[arg(long, value_name = "SCENE", conflicts_with = "run")]
    scene: Option<PathBuf>,
    /// Override a value of that scene
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "scene")]
    sets: Vec<String>,
    /// Compare with a run that `girderbench run --out` wrote into this folder
    #[arg(long, value_name = "DIR")]
    run: Option<PathBuf>,
}

/// A run, by its scene or its table.
pub(super) enum Reference {
    Computed(Box<History>),
    Table(PathBuf, Trajectory),
}

impl ReferenceArgs {
    /// Runs or reads it.
    ///
    /// # Errors
    /// A scene that cannot be run, a table that cannot be read.
    pub(super) fn read(&self) -> Result<Option<Reference>, Failure> {
        if let Some(scene) = &self.scene {
            let scene = files::load_scene(scene, &self.sets)?;
            return Ok(Some(Reference::Computed(Box::new(compute_as_asked(&scene)?.history))));
        }
        let Some(folder) = &self.run else { return Ok(None) };
        let path = folder.join("trajectory.csv");
        let table = read::trajectory(&files::read_table(&path)?);
        let table = table.map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
        Ok(Some(Reference::Table(path, table)))
    }
}

impl Reference {
    pub(super) fn name(&self) -> String {
        match self {
            Self::Computed(history) => history.scene().name.clone(),
            Self::Table(path, _) => path.display().to_string(),
        }
    }

    /// x, y \[m\] and θ \[rad\] of a body at growing times.
    ///
    /// # Errors
    /// No such body; a run that ends before the film.
    pub(super) fn of(&self, body: &str, times: &[f64]) -> Result<Vec<[f64; 3]>, Failure> {
        let no_body = |have: String| {
            let what = said!("measure-no-body", "body" => body, "names" => have);
            Failure::Input(format!("{}: {what}", self.name()))
        };
        let last = times.last().copied().unwrap_or_default();
        let too_short = |end: f64| {
            let what = said!("measure-short", "end" => six(end), "last" => six(last));
            Failure::Input(format!("{}: {what}", self.name()))
        };
        match self {
            Self::Computed(history) => {
                let names: Vec<&str> = history.scene().girders.iter().map(|girder| girder.name.as_str()).collect();
                let number = names.iter().position(|name| *name == body).ok_or_else(|| no_body(names.join(", ")))?;
                // The last picture's time is a product that may round to just after the end.
                if last > history.end() * (1.0 + 1e-12) {
                    return Err(too_short(history.end()));
                }
                let at = |t: &f64| {
                    let motion = history.motion(number, t.min(history.end()));
                    [motion.displacement.x, motion.displacement.y, motion.theta]
                };
                Ok(times.iter().map(at).collect())
            }
            Self::Table(_, table) => {
                let column = |name: String| table.columns.iter().find(|(own, _)| *own == name).map(|(_, v)| &v[..]);
                let pair = |[place, rate]: [&str; 2]| {
                    Some([column(format!("{body}.{place}"))?, column(format!("{body}.{rate}"))?])
                };
                let all = [["x", "vx"], ["y", "vy"], ["theta", "omega"]].map(pair);
                let [Some(x), Some(y), Some(theta)] = all else {
                    let names = table.columns.iter().filter_map(|(name, _)| name.strip_suffix(".theta"));
                    return Err(no_body(names.collect::<Vec<_>>().join(", ")));
                };
                let end = table.t.last().copied().unwrap_or_default();
                if last > end * (1.0 + 1e-12) || table.t.len() < 2 {
                    return Err(too_short(end));
                }
                Ok(times.iter().map(|t| [x, y, theta].map(|both| between(&table.t, both, *t))).collect())
            }
        }
    }
}

/// A value at a time by the cubic through values and rates at the rows before and after it (Hermite).
fn between(t: &[f64], [value, rate]: [&[f64]; 2], at: f64) -> f64 {
    let after = t.partition_point(|row| *row <= at).clamp(1, t.len() - 1);
    let (before, step) = (after - 1, t[after] - t[after - 1]);
    let s = ((at - t[before]) / step).clamp(0.0, 1.0);
    let (s2, s3) = (s * s, s * s * s);
    value[before] * (2.0 * s3 - 3.0 * s2 + 1.0)
        + value[after] * (3.0 * s2 - 2.0 * s3)
        + step * (rate[before] * (s3 - 2.0 * s2 + s) + rate[after] * (s3 - s2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_read_between_rows_as_it_is() {
        let t: Vec<f64> = (0..5).map(|n| 0.5 * f64::from(n)).collect();
        let value: Vec<f64> = t.iter().map(|t| t * t * t - t).collect();
        let rate: Vec<f64> = t.iter().map(|t| 3.0 * t * t - 1.0).collect();
        for at in [0.0_f64, 0.2, 0.5, 1.9, 2.0] {
            assert!((between(&t, [&value, &rate], at) - (at * at * at - at)).abs() < 1e-14, "{at}");
        }
    }
}
