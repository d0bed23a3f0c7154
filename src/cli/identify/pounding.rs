//! `girderbench identify --fit`: values of a scene's keys from the measured history of a girder that pounds.

use std::path::{Path, PathBuf};

use serde_json::json;

use crate::cli::columns::left;
use crate::cli::console::Console;
use crate::cli::digits::six;
use crate::cli::failure::Failure;
use crate::cli::output::write_files;
use crate::cli::plot_files::plot_files;
use crate::files;
use crate::identify::{Columns, Measured, Quantity};
use crate::language::{Text, said};
use crate::motion::format::RecordError;
use crate::scene::Scene;
use crate::scene::shown::escaped;
use crate::study::calibration::{self, Calibration, Fitted, calibrate};

/// Keys of the scene that are found from a girder that pounds
#[derive(Clone, Debug, clap::Args)]
pub(super) struct PoundingArgs {
    /// Find the value of this key of the scene, beginning at START, from columns `GIRDER.x` and, where it is there, `GIRDER.y`, by
    /// running the scene: `--fit contact.restitution_normal=0.5 --fit abutment.wall.gap_m=0.004`
    #[arg(long = "fit", value_name = "KEY=START", value_parser = key, requires = "scene",
        conflicts_with_all = ["response", "frequency", "scaled", "column", "along"])]
    fit: Vec<(String, f64)>,
    /// The girder that was measured; may be left out where the scene has but one
    #[arg(long, value_name = "NAME", requires = "fit")]
    girder: Option<String>,
}

fn key(text: &str) -> Result<(String, f64), String> {
    let (key, start) = text.split_once('=').ok_or_else(|| Text::new("fit-key"))?;
    let start: f64 = start.parse().map_err(|_| Text::new("fit-number"))?;
    let sound = start.is_finite() && start != 0.0 && !key.trim().is_empty();
    sound.then(|| (key.trim().to_owned(), start)).ok_or_else(|| Text::new("fit-not-zero").into())
}

/// Request of a measurement by a scene.
pub(super) struct Request<'a> {
    pub(super) file: &'a Path,
    pub(super) scene: &'a PathBuf,
    pub(super) sets: &'a [String],
    /// Length of the unit of displacements \[m\].
    pub(super) unit: Option<f64>,
    /// Times that count \[s\].
    pub(super) within: [f64; 2],
    pub(super) out: Option<&'a Path>,
}

impl PoundingArgs {
    pub(super) fn given(&self) -> bool {
        !self.fit.is_empty()
    }

    /// Finds and prints the values; writes JSON and plot.
    ///
    /// # Errors
    /// A table without such columns, a scene that does not run with the starts, keys that do not show.
    pub(super) fn run(&self, request: &Request<'_>, console: &mut Console) -> Result<(), Failure> {
        let scene = files::load_scene(request.scene, request.sets)?;
        let girder = self.number(&scene)?;
        let measured = measured(request, &scene, girder)?;
        let found = calibrate(&scene, &self.fit, &measured)
            .map_err(|error| Failure::Input(format!("{}: {error}", request.file.display())))?;
        console.print(&text(request, &scene, &measured, &found));
        let Some(out) = request.out else { return Ok(()) };
        let files = written(request, &scene, &measured, &found)?;
        console.print(&write_files(out, &files)?);
        Ok(())
    }

    /// Number of the girder that was measured.
    fn number(&self, scene: &Scene) -> Result<usize, Failure> {
        let names: Vec<&str> = scene.girders.iter().map(|girder| girder.name.as_str()).collect();
        let found = match &self.girder {
            Some(name) => names.iter().position(|own| own == name),
            None => (names.len() == 1).then_some(0),
        };
        found.ok_or_else(|| Failure::Input(said!("wrong-no-girder-flag", "names" => names.join(", "))))
    }
}

/// x and, where it is there, y of a girder.
fn measured(request: &Request<'_>, scene: &Scene, girder: usize) -> Result<calibration::Measured, Failure> {
    let bytes = files::read_input(request.file)?;
    let in_file = |error: RecordError| Failure::Input(format!("{}: {error}", request.file.display()));
    let read = |axis: &str| {
        let name = format!("{}.{axis}", scene.girders[girder].name);
        Columns { first: Quantity::Time, name: Some(&name), unit: request.unit }.read(&bytes)
    };
    let [from, to] = request.within;
    let cut = |table: &Measured| -> (Vec<f64>, Vec<f64>) {
        let rows = table.at.iter().zip(&table.x).filter(|(t, _)| (from..=to).contains(*t));
        rows.map(|(t, x)| (*t, *x)).unzip()
    };
    let (times, x) = cut(&read("x").map_err(in_file)?);
    let mut along = vec![(0, x)];
    match read("y") {
        Ok(y) => along.push((1, cut(&y).1)),
        Err(error) if error.value.is(Text::new("columns-none")) => {}
        Err(error) => return Err(in_file(error)),
    }
    let last = times.last().copied().unwrap_or_default();
    if times.len() < LEAST_ROWS || times[0] < 0.0 || last > scene.duration {
        return Err(Failure::Input(said!(
            "fit-outside",
            "file" => request.file.display().to_string(),
            "have" => times.len(),
            "last" => six(last),
            "least" => LEAST_ROWS,
            "end" => six(scene.duration)
        )));
    }
    Ok(calibration::Measured { girder, times, along })
}

/// Rows at least: a few more than keys.
const LEAST_ROWS: usize = 20;

/// A value with its interval, in the unit of its key.
fn with_interval(Fitted { value, half_width, .. }: &Fitted) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 12")]
    let digits = (1.0 - half_width.max(1e-12).log10().floor()).clamp(0.0, 12.0) as usize;
    format!("{value:.digits$} ± {half_width:.digits$}")
}

fn text(request: &Request<'_>, scene: &Scene, measured: &calibration::Measured, found: &Calibration) -> String {
    let name = &scene.girders[measured.girder].name;
    let axes = if measured.along.len() > 1 { Text::new("fit-both").as_str() } else { "x" };
    let file = escaped(&request.file.display().to_string()).into_owned();
    let (rows, model) = (measured.times.len(), scene.model.kind.label());
    let line = |label: &str, value: &str| format!("  {} {value}\n", left(label, 34));
    let head = said!("fit-rows", "file" => file, "rows" => rows, "axes" => axes, "girder" => escaped(name));
    let model = said!("fit-model", "scene" => scene.name.as_str(), "model" => model);
    let mut text = format!("{head}\n{}", line(&Text::new("fit-runs"), &model));
    for fitted in &found.keys {
        text += &line(&fitted.key, &with_interval(fitted));
    }
    let [rms, share] = [format!("{:.4}", 1e3 * found.rms), format!("{:.2}", 100.0 * found.unexplained)];
    let noise = match found.order {
        0 => Text::new("identify-independent").into(),
        order => said!("fit-correlated", "order" => order),
    };
    let residual = said!("fit-residual", "rms" => rms, "share" => share, "noise" => noise);
    text + &line(&Text::new("identify-residual"), &residual)
}

fn written(
    request: &Request<'_>,
    scene: &Scene,
    measured: &calibration::Measured,
    found: &Calibration,
) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let stem = request.file.file_stem().unwrap_or(request.file.as_os_str()).to_string_lossy().into_owned();
    let keys: serde_json::Map<String, serde_json::Value> = found
        .keys
        .iter()
        .map(|fitted| (fitted.key.clone(), json!({ "value": fitted.value, "half_width_95": fitted.half_width })))
        .collect();
    let report = json!({
        "file": request.file.to_string_lossy(),
        "scene": scene.name,
        "keys": keys,
        "residual_m": found.rms,
        "residual_share": found.unexplained,
        "residual_autoregression_order": found.order,
        "version": env!("CARGO_PKG_VERSION"),
    });
    let json = serde_json::to_string_pretty(&report).unwrap_or_default() + "\n";
    let mut files = vec![(format!("{stem}-fitted.json"), json.into_bytes())];
    // As many as fit into a line; the rest is in the JSON.
    let short = |fitted: &Fitted| {
        let key = fitted.key.rsplit('.').next().unwrap_or_default();
        let value = with_interval(fitted);
        format!("{key} {}", value.split(' ').next().unwrap_or_default())
    };
    let title = format!("{stem}: {}", found.keys.iter().take(3).map(short).collect::<Vec<_>>().join(", "));
    files.extend(plot_files(&format!("{stem}-fitted"), found.chart(measured, &title))?);
    Ok(files)
}
