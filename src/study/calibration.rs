//! Values of a scene's keys, such as gap, restitution and friction, from a measured history of a girder that pounds.
//!
//! The program's run of the scene is the model: each evaluation is a run. Keys are first moved one after another over a few
//! multiples of their starts, since a history of hits has many local minima, then all together by least squares, with intervals as
//! those of [`identify`](crate::identify). A run depends smoothly on a key as long as its events keep their order.

use rayon::prelude::*;

use super::identified::crossed;
use crate::identify::least_squares::{self, Model, dot};
use crate::identify::noise::{Noise, student_95};
use crate::language::{said, six};
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::plot::paper::INK;
use crate::scene::validate::validate;
use crate::scene::{Scene, overrides};
use crate::sim::History;

/// Multiples of a start that are tried, key by key.
const MULTIPLES: [f64; 10] = [0.5, 0.6, 0.7, 0.8, 0.9, 1.1, 1.2, 1.35, 1.5, 2.0];
/// Number of passes over the keys: the second with the others as the first left them.
const PASSES: u32 = 2;
/// Share of a value by which it is moved for a derivative: large beside the error of a run (1e-12), small beside what moves an event
/// past another.
const MOVED: f64 = 1e-5;

/// A measured history of a girder.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Number of the girder in the scene.
    pub girder: usize,
    /// Times, growing \[s\].
    pub times: Vec<f64>,
    /// Axes, 0 for x and 1 for y, each with a displacement at each time \[m\].
    pub along: Vec<(usize, Vec<f64>)>,
}

/// A key of the scene with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitted {
    /// The key, as of `--set`.
    pub key: String,
    /// Its value of least squares, in the unit of the key.
    pub value: f64,
    /// Half of its interval of 95 %.
    pub half_width: f64,
}

/// Parameters by least squares.
#[derive(Clone, Debug)]
pub struct Calibration {
    /// The keys.
    pub keys: Vec<Fitted>,
    /// Root mean square of the residuals \[m\].
    pub rms: f64,
    /// That as a share of the root mean square of the measured, less its mean \[–\].
    pub unexplained: f64,
    /// Order of the autoregression of the residuals.
    pub order: usize,
    /// Displacements of the run with these values, as they were measured: axis by axis \[m\].
    pub fitted: Vec<Vec<f64>>,
}

impl Calibration {
    /// Measured and computed displacements and their differences over time, as an SVG document.
    pub fn chart(&self, measured: &Measured, title: &str) -> String {
        let over_time = |values: &mut dyn Iterator<Item = f64>| -> Vec<[f64; 2]> {
            measured.times.iter().zip(values).map(|(t, x)| [*t, 1e3 * x]).collect()
        };
        let curve = |name: &str, (color, dashes): (&str, &'static str), points| Curve {
            name: name.to_owned(),
            color: color.to_owned(),
            dashes,
            points,
        };
        let names = ["x", "y"];
        let panel = |((axis, x), fitted): (&(usize, Vec<f64>), &Vec<f64>)| {
            let points = curve("measured", (INK, "none"), crossed(over_time(&mut x.iter().copied())));
            let line = curve("least squares", (COLORS[*axis], "none"), over_time(&mut fitted.iter().copied()));
            Panel { name: format!("{} [mm]", names[*axis]), curves: vec![line, points] }
        };
        let left = |((axis, x), fitted): (&(usize, Vec<f64>), &Vec<f64>)| {
            let off = over_time(&mut x.iter().zip(fitted).map(|(x, fitted)| x - fitted));
            curve(&format!("of {}", names[*axis]), (COLORS[*axis], "none"), off)
        };
        let both = || measured.along.iter().zip(&self.fitted);
        let mut panels: Vec<Panel> = both().map(panel).collect();
        panels.push(Panel { name: "measured − least squares [mm]".to_owned(), curves: both().map(left).collect() });
        Chart { title: title.to_owned(), x: "time [s]".to_owned(), panels }.to_svg()
    }
}

/// Reasons of a failed calibration, with remedies.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotCalibrated {
    /// The scene cannot be run with the starts.
    #[error("{}", said!("fit-start", "values" => .0.as_str(), "why" => .1.as_str()))]
    Start(String, String),
    /// The keys change nothing that was measured, or alike.
    #[error("{}", said!("fit-undetermined", "keys" => .0.as_str()))]
    Undetermined(String),
}

struct Runs<'a> {
    scene: &'a Scene,
    keys: Vec<&'a str>,
    measured: &'a Measured,
}

impl Runs<'_> {
    fn sets(&self, values: &[f64]) -> Vec<String> {
        self.keys.iter().zip(values).map(|(key, value)| format!("{key}={value:?}")).collect()
    }

    /// The run at these values, where there is one that reaches the last time.
    fn run(&self, values: &[f64]) -> Option<History> {
        self.run_or_why(values).ok()
    }

    /// As [`run`](Self::run), or why there is none, with a remedy.
    fn run_or_why(&self, values: &[f64]) -> Result<History, String> {
        let scene = overrides::apply_all(self.scene, &self.sets(values)).map_err(|errors| errors.to_string())?;
        validate(&scene).map_err(|errors| errors.to_string())?;
        let history = History::of(&scene).map_err(|errors| errors.to_string())?;
        let (last, end) = (self.measured.times.last().copied().unwrap_or_default(), history.end());
        match history.stop() {
            Some(stop) => Err(said!("fit-ended", "t" => six(stop.t), "reason" => stop.reason.to_string())),
            None if last > end => Err(said!("fit-too-short", "end" => six(end), "last" => six(last))),
            None => Ok(history),
        }
    }

    fn cost(&self, wanted: &[f64], values: &[f64]) -> f64 {
        self.values(values).map_or(f64::INFINITY, |found| {
            let off: Vec<f64> = wanted.iter().zip(found).map(|(a, b)| a - b).collect();
            dot(&off, &off)
        })
    }

    /// The starts, each key moved to the best of its multiples.
    fn moved(&self, wanted: &[f64], starts: &[f64]) -> Vec<f64> {
        let mut best = starts.to_vec();
        let mut least = self.cost(wanted, &best);
        for _ in 0..PASSES {
            for key in 0..best.len() {
                let tried = |multiple: &f64| {
                    let mut values = best.clone();
                    values[key] *= multiple;
                    (self.cost(wanted, &values), values[key])
                };
                let all: Vec<(f64, f64)> = MULTIPLES.par_iter().map(tried).collect();
                let closest = all.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
                if let Some((cost, value)) = closest.filter(|(cost, _)| *cost < least) {
                    (best[key], least) = (value, cost);
                }
            }
        }
        best
    }
}

impl Model for Runs<'_> {
    fn values(&self, parameters: &[f64]) -> Option<Vec<f64>> {
        let history = self.run(parameters)?;
        let Measured { girder, times, along } = self.measured;
        let at = |axis: usize| times.iter().map(|t| history.motion(*girder, *t).displacement[axis]).collect::<Vec<_>>();
        Some(along.iter().flat_map(|(axis, _)| at(*axis)).collect())
    }

    fn slopes(&self, parameters: &[f64]) -> Option<Vec<Vec<f64>>> {
        let at = |key: usize, step: f64| {
            let mut values = parameters.to_vec();
            values[key] += step;
            self.values(&values)
        };
        let slope = |key: usize| {
            let step = MOVED * parameters[key].abs();
            // At the end of a key's range the run exists on one side of it.
            let (above, over) = at(key, step).map_or_else(|| Some((at(key, 0.0)?, 0.0)), |run| Some((run, step)))?;
            let (below, under) = at(key, -step).map_or_else(|| Some((at(key, 0.0)?, 0.0)), |run| Some((run, step)))?;
            Some(above.iter().zip(&below).map(|(a, b)| (a - b) / (over + under)).collect::<Vec<f64>>())
        };
        (0..parameters.len()).into_par_iter().map(slope).collect()
    }
}

/// Measured less residuals, in pieces of one axis each.
fn split(wanted: &[f64], residuals: &[f64], count: usize) -> Vec<Vec<f64>> {
    let fitted: Vec<f64> = wanted.iter().zip(residuals).map(|(x, r)| x - r).collect();
    fitted.chunks(count.max(1)).map(<[f64]>::to_vec).collect()
}

/// Finds values of keys from a measured history, from starts.
///
/// # Errors
/// Starts that cannot be run; keys that do not show.
pub fn calibrate(scene: &Scene, keys: &[(String, f64)], measured: &Measured) -> Result<Calibration, NotCalibrated> {
    let runs = Runs { scene, keys: keys.iter().map(|(key, _)| key.as_str()).collect(), measured };
    let starts: Vec<f64> = keys.iter().map(|(_, start)| *start).collect();
    let wanted: Vec<f64> = measured.along.iter().flat_map(|(_, x)| x.iter().copied()).collect();
    runs.run_or_why(&starts).map_err(|why| NotCalibrated::Start(runs.sets(&starts).join(", "), why))?;
    let undetermined = || NotCalibrated::Undetermined(runs.keys.join(", "));
    let start = runs.moved(&wanted, &starts);
    let solution = least_squares::fit(&runs, &wanted, &start).ok_or_else(undetermined)?;
    let noise = Noise::of(&solution.residuals, keys.len(), true);
    let covariance = noise.covariance(&solution).ok_or_else(undetermined)?;
    let factor = student_95(wanted.len().saturating_sub(keys.len()));
    let fitted = keys.iter().enumerate().map(|(n, (key, _))| Fitted {
        key: key.clone(),
        value: solution.parameters[n],
        half_width: factor * covariance[n][n].max(0.0).sqrt(),
    });
    let mean = wanted.iter().sum::<f64>() / wanted.len() as f64;
    let moved: f64 = wanted.iter().map(|x| (x - mean) * (x - mean)).sum();
    Ok(Calibration {
        keys: fitted.collect(),
        rms: (solution.cost / wanted.len() as f64).sqrt(),
        unexplained: (solution.cost / moved).sqrt(),
        order: noise.order,
        fitted: split(&wanted, &solution.residuals, measured.times.len()),
    })
}
