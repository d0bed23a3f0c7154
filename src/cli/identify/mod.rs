//! `girderbench identify`: natural frequency and damping ratio from a measured displacement.

mod pounding;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::args::{at_least_one, finite, positive, record_unit};
use super::columns::left;
use super::console::Console;
use super::digits::six;
use super::failure::Failure;
use super::output::write_files;
use super::plot_files::plot_files;
use crate::dynamics::Model;
use crate::files::{self, Supplement, read_record};
use crate::identify::columns::LENGTHS;
use crate::identify::{
    Columns, Estimate, Given, History, Identified, Measured, Quantity, SteadyResponse, from_history, from_response,
};
use crate::language::{Language, Message, Text, message, said};
use crate::motion::Ground;
use crate::motion::format::{STANDARD_GRAVITY, Unit};
use crate::motion::oscillator::Shaking;
use crate::scene::shown::escaped;
use crate::sim::History as Run;
use crate::study::identified;

/// Find natural frequency and damping ratio from a measured displacement (free decay, known ground motion, sweep), or, with --fit, gap, restitution and friction of a girder that pounds
#[derive(Clone, Debug, clap::Args)]
pub(super) struct IdentifyArgs {
    /// A table of time and displacement relative to the ground, as CSV; with --response of frequency and amplitude
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Name of the column of displacements; may be left out where there is but one
    #[arg(long, value_name = "NAME")]
    column: Option<String>,
    /// Unit of the displacements, where the heading does not state it (as `x_mm` does): m, cm, mm, um
    #[arg(long, value_name = "UNIT", value_parser = length)]
    unit: Option<f64>,
    /// Only from this time on; in a free decay from when it is free [s]
    #[arg(long, value_name = "S", value_parser = finite, allow_negative_numbers = true)]
    from: Option<f64>,
    /// Only up to this time [s]
    #[arg(long, value_name = "S", value_parser = finite, allow_negative_numbers = true)]
    to: Option<f64>,
    #[command(flatten)]
    ground: GroundArgs,
    /// The table holds amplitudes of the steady displacement under sines of constant acceleration, over frequency
    #[arg(long, conflicts_with_all = ["scene", "record", "scaled", "from", "to"])]
    response: bool,
    /// Amplitude of these sines, where it is known [g]
    #[arg(long, value_name = "G", value_parser = positive, requires = "response", allow_negative_numbers = true)]
    amplitude_g: Option<f64>,
    #[command(flatten)]
    pounding: pounding::PoundingArgs,
    /// The natural frequency is known: find the damping ratio alone, as the paper does at resonance [Hz]
    #[arg(long, value_name = "HZ", value_parser = positive, allow_negative_numbers = true)]
    frequency: Option<f64>,
    /// Write plot, table and JSON into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// What shook the girder; nothing in a free decay
#[derive(Clone, Debug, clap::Args)]
struct GroundArgs {
    /// Shaken by the ground motion of this scene or preset, with t = 0 at its start
    #[arg(long, value_name = "SCENE", conflicts_with = "record")]
    scene: Option<PathBuf>,
    /// Override a value of that scene, e.g. `--set motion.kind=sweep`
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "scene")]
    sets: Vec<String>,
    /// Direction of the displacements in that scene, from world x [degrees]
    #[arg(long, value_name = "DEG", value_parser = finite, requires = "scene", allow_negative_numbers = true)]
    along: Option<f64>,
    /// Shaken by this record along the displacements, a file as of `girderbench motion`
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Which channel of the record, from 1
    #[arg(long, value_name = "N", value_parser = at_least_one, requires = "record", allow_negative_numbers = true)]
    channel: Option<usize>,
    /// Interval between its samples, where it does not state it [s]
    #[arg(long, value_name = "S", value_parser = positive, requires = "record", allow_negative_numbers = true)]
    dt: Option<f64>,
    /// Unit of its numbers, where it does not state it: g, gal (cm/s2), m/s2
    #[arg(long, value_name = "UNIT", value_parser = record_unit, requires = "record")]
    record_unit: Option<Unit>,
    /// The ground motion is known but for a factor, which is found too
    #[arg(long)]
    scaled: bool,
}

fn length(text: &str) -> Result<f64, String> {
    let found = LENGTHS.iter().find(|(word, _)| *word == text).map(|(_, length)| *length);
    found.ok_or_else(|| said!("wrong-one-of", "words" => LENGTHS.map(|(word, _)| word).join(", ")))
}

/// Does it.
///
/// # Errors
/// A file that is no such table, a ground motion that cannot be read, a history that shows neither f nor h; files that cannot
/// be written.
pub(super) fn run(args: &IdentifyArgs, console: &mut Console) -> Result<(), Failure> {
    if let Some(out) = &args.out {
        files::check_folder(out)?;
    }
    if let Some(scene) = args.ground.scene.as_ref().filter(|_| args.pounding.given()) {
        let within = [args.from.unwrap_or(f64::NEG_INFINITY), args.to.unwrap_or(f64::INFINITY)];
        let (file, sets, unit, out) = (&args.file, &args.ground.sets, args.unit, args.out.as_deref());
        let request = pounding::Request { file, scene, sets, unit, within, out };
        return args.pounding.run(&request, console);
    }
    let first = if args.response { Quantity::Frequency } else { Quantity::Time };
    let columns = Columns { first, name: args.column.as_deref(), unit: args.unit };
    let in_file = |error: &dyn std::fmt::Display| Failure::Input(format!("{}: {error}", args.file.display()));
    let measured = columns.read(&files::read_input(&args.file)?).map_err(|error| in_file(&error))?;
    let measured = args.cut(measured);
    let (shaking, ground) = args.ground.shaking(console)?;
    let given = Given { frequency: args.frequency };
    let found = if args.response {
        let ground = args.amplitude_g.map(|g| g * STANDARD_GRAVITY);
        from_response(&SteadyResponse { frequencies: &measured.at, amplitudes: &measured.x, ground }, given)
    } else {
        let scaled = args.ground.scaled;
        from_history(&History { times: &measured.at, x: &measured.x, shaking: &shaking, scaled }, given)
    };
    let found = found.map_err(|error| in_file(&error))?;
    let ground = if args.response { Text::new("identify-sines").into() } else { ground };
    console.print(&text(args, &measured, &found, &ground));
    args.ground.warn_of_hits(&measured.at, console)?;
    let Some(out) = &args.out else { return Ok(()) };
    let files = written(args, &measured, &found, (first, &ground))?;
    console.print(&write_files(out, &files)?);
    Ok(())
}

impl IdentifyArgs {
    /// The rows within the times asked for.
    fn cut(&self, measured: Measured) -> Measured {
        let [from, to] = [self.from.unwrap_or(f64::NEG_INFINITY), self.to.unwrap_or(f64::INFINITY)];
        let rows = measured.at.iter().zip(&measured.x).filter(|(t, _)| (from..=to).contains(*t));
        let (at, x) = rows.map(|(t, x)| (*t, *x)).unzip();
        Measured { at, x, ..measured }
    }
}

impl GroundArgs {
    /// Warns where the scene's own run touches within the times that were measured: an oscillator hits nothing.
    fn warn_of_hits(&self, times: &[f64], console: &mut Console) -> Result<(), Failure> {
        let (Some(path), Some(last)) = (&self.scene, times.last()) else { return Ok(()) };
        let mut scene = files::load_scene(path, &self.sets)?;
        if scene.abutments.is_empty() && scene.girders.len() < 2 {
            return Ok(());
        }
        scene.duration = scene.duration.min(*last);
        let history = Run::of(&scene)?;
        let first = times.first().copied().unwrap_or_default();
        if let Some(touch) = history.hits().touches().iter().find(|touch| touch.end >= first) {
            console.note(&said!(
                "identify-touches",
                "scene" => path.display().to_string(),
                "pair" => escaped(&history.model().pairs[touch.pair].name),
                "t" => format!("{:.4}", touch.start)
            ));
        }
        Ok(())
    }

    /// The ground motion along the displacements, and what it is in words.
    fn shaking(&self, console: &mut Console) -> Result<(Shaking, Message), Failure> {
        if let Some(path) = &self.record {
            let record = read_record(path, &Supplement { dt: self.dt, unit: self.record_unit })?;
            let channel = record.channel(self.channel);
            let wrong = |remedy| Failure::Input(format!("{}: --channel: {remedy}", path.display()));
            let channel = channel.map_err(wrong)?;
            let shaking = Shaking::Samples { dt: channel.dt, values: channel.samples.clone() };
            return Ok((shaking, format!("{}, {}", escaped(&path.display().to_string()), record.format).into()));
        }
        let Some(path) = &self.scene else {
            if self.scaled {
                return Err(Failure::Input(Text::new("wrong-scaled").into()));
            }
            return Ok((Shaking::Still, Text::new("identify-still").into()));
        };
        let scene = files::load_scene(path, &self.sets)?;
        let model = Model::compile(&scene).map_err(|errors| errors.in_file(&path.to_string_lossy()))?;
        let angle = self.along.unwrap_or(0.0);
        let shaking = Shaking::along(&model.ground, Ground::direction(angle));
        if shaking.peak() == 0.0 {
            let scene = path.display().to_string();
            console.note(&said!("identify-no-shaking", "scene" => scene, "angle" => six(angle)));
        }
        let peak = six(shaking.peak() / STANDARD_GRAVITY);
        let scene = escaped(&path.display().to_string()).into_owned();
        Ok((shaking, message!("identify-shaken", "scene" => scene, "peak" => peak, "angle" => six(angle))))
    }
}

/// The value and half its interval with the digits that the interval leaves: `2.4003 ± 0.0021 Hz`.
fn with_interval(estimate: &Estimate) -> String {
    let (factor, unit) = match estimate.unit {
        "m" => (1e3, "mm"),
        "m/s" => (1e3, "mm/s"),
        other => (1.0, other),
    };
    let [value, half] = [factor * estimate.value, factor * estimate.half_width];
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    // Below a billionth an interval is rounding, not noise.
    if half <= 1e-9 * value.abs() || !half.is_finite() {
        return format!("{}{unit}", six(value));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 12")]
    let digits = (1.0 - half.log10().floor()).clamp(0.0, 12.0) as usize;
    format!("{value:.digits$} ± {half:.digits$}{unit}")
}

/// Results, a line each.
fn text(args: &IdentifyArgs, measured: &Measured, found: &Identified, ground: &Message) -> String {
    let [first, last] = [measured.at.first(), measured.at.last()].map(|at| six(at.copied().unwrap_or_default()));
    let unit = if args.response { "Hz" } else { "s" };
    let name = Some(&measured.name).filter(|name| !name.is_empty());
    let name = name.map_or_else(String::new, |name| said!("identify-of", "name" => escaped(name)));
    let in_file = LENGTHS.iter().find(|(_, length)| *length == measured.unit).map_or("m", |(word, _)| word);
    let file = args.file.display().to_string();
    let mut text = said!(
        "identify-rows",
        "file" => escaped(&file),
        "count" => measured.x.len(),
        "name" => name,
        "from" => first,
        "to" => last,
        "unit" => unit,
        "in" => in_file
    ) + "\n";
    let mut line = |label: &str, value: &str| {
        let _ = writeln!(text, "  {} {value}", left(label, 26));
    };
    line(&Text::new("identify-ground"), &ground.to_string());
    let resonance = format!("{:.4}", found.resonance);
    line(&Text::new("identify-resonance"), &said!("identify-resonance-of", "frequency" => resonance));
    let is_given = found.frequency.half_width == 0.0 && args.frequency.is_some();
    let given = if is_given { Text::new("identify-as-given").as_str() } else { "" };
    line(&found.frequency.name, &format!("{}{given}", with_interval(&found.frequency)));
    for estimate in std::iter::once(&found.damping).chain(&found.others) {
        line(&estimate.name, &with_interval(estimate));
    }
    let rms = six(1e3 * (found.residuals.iter().map(|r| r * r).sum::<f64>() / found.residuals.len() as f64).sqrt());
    let share = format!("{:.2}", 100.0 * found.unexplained);
    line(&Text::new("identify-residual"), &said!("identify-residual-of", "rms" => rms, "share" => share));
    line("", &noise_words(found));
    line("", &Text::new("identify-interval"));
    if found.is_at_the_bound() {
        line("", &Text::new("identify-at-bound"));
    }
    if found.unexplained > POOR {
        line("", &Text::new("identify-poor"));
    }
    text
}

/// Share of the motion left over above which no oscillator explains it: more than any camera or laser adds to what it measures.
const POOR: f64 = 0.3;

fn noise_words(found: &Identified) -> String {
    match found.noise.order {
        0 => Text::new("identify-independent").into(),
        order => {
            let next = found.noise.correlations.get(1).copied().unwrap_or_default();
            said!("identify-correlated", "next" => format!("{next:.2}"), "order" => order)
        }
    }
}

/// Plot, table and JSON.
fn written(
    args: &IdentifyArgs,
    measured: &Measured,
    found: &Identified,
    (first, ground): (Quantity, &Message),
) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let stem = args.file.file_stem().unwrap_or(args.file.as_os_str()).to_string_lossy().into_owned();
    let title = format!("{stem}: f = {}, h = {}", with_interval(&found.frequency), with_interval(&found.damping));
    let name = format!("{stem}-identified");
    let json = serde_json::to_string_pretty(&report(&args.file, measured, found, ground)).unwrap_or_default() + "\n";
    let mut files = vec![
        (format!("{name}.json"), json.into_bytes()),
        (format!("{name}.csv"), identified::csv(measured, found, first).into_bytes()),
    ];
    files.extend(plot_files(&name, identified::chart(measured, found, first, &title))?);
    Ok(files)
}

/// A text of a file that other programs read.
fn in_english(text: Text) -> &'static str {
    Language::English.within(|| text.as_str())
}

/// All of it as JSON, in SI.
fn report(file: &Path, measured: &Measured, found: &Identified, ground: &Message) -> serde_json::Value {
    let estimate = |e: &Estimate| json!({ "value": e.value, "half_width_95": e.half_width, "unit": e.unit });
    let others: serde_json::Map<String, serde_json::Value> =
        found.others.iter().map(|e| (in_english(e.name).replace(' ', "_"), estimate(e))).collect();
    json!({
        "file": file.to_string_lossy(),
        "rows": measured.x.len(),
        "ground": ground,
        "natural_frequency": estimate(&found.frequency),
        "damping_ratio": estimate(&found.damping),
        "damping_at_bound": found.is_at_the_bound(),
        "others": others,
        "resonance_hz": found.resonance,
        "residual_deviation_m": found.noise.deviation,
        "residual_share": found.unexplained,
        "residual_autoregression_order": found.noise.order,
        "version": env!("CARGO_PKG_VERSION"),
    })
}
