//! `girderbench motion`: what records of ground motion hold, as figures, plots and tables.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::args::{at_least_one, positive, record_unit};
use super::console::Console;
use super::digits::six;
use super::failure::Failure;
use super::motion_processing::ProcessingArgs;
use super::output::write_files;
use super::plot_files::plot_files;
use crate::files::{Supplement, read_record};
use crate::language::{Text, said};
use crate::motion::format::{Channel, Orientation, Record, STANDARD_GRAVITY, Unit};
use crate::scene::shown::escaped;
use crate::study::ground::{Figures, Ground, spectrum_chart, spectrum_csv};

/// Show what records of ground motion hold: format, unit, peaks, duration; plots and response spectrum
#[derive(Clone, Debug, clap::Args)]
pub(super) struct MotionArgs {
    /// Record files: PEER AT2, K-NET, COSMOS, CSMIP Volume 2, one column, CSV
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// Only this channel of each file, from 1
    #[arg(long, value_name = "N", value_parser = at_least_one, allow_negative_numbers = true)]
    channel: Option<usize>,
    /// Interval between samples, for files that do not state it [s]
    #[arg(long, value_name = "S", value_parser = positive, allow_negative_numbers = true)]
    dt: Option<f64>,
    /// Unit of the numbers, for files that do not state it: g, gal (cm/s2), m/s2
    #[arg(long, value_name = "UNIT", value_parser = record_unit)]
    unit: Option<Unit>,
    /// Write histories and 5 % response spectrum of each channel into this folder, as plots and as CSV
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    processing: ProcessingArgs,
}

/// Does it.
///
/// # Errors
/// A file that is no record, a channel that it does not have; files that cannot be written.
pub(super) fn run(args: &MotionArgs, console: &mut Console) -> Result<(), Failure> {
    let beside = Supplement { dt: args.dt, unit: args.unit };
    let (mut files, mut names) = (Vec::new(), BTreeSet::new());
    for path in &args.files {
        let record = read_record(path, &beside)?;
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        console.print(&heading(path, &record));
        for (number, channel) in chosen(&record, args.channel, path)? {
            let channel = args.processing.apply(channel, path)?;
            let ground = Ground::of(&channel);
            console.print(&text(number, &channel, &ground.figures()));
            if args.out.is_some() {
                let stem = if record.channels.len() > 1 { format!("{name}-{number}") } else { name.clone() };
                if !names.insert(stem.clone()) {
                    return Err(Failure::Input(said!("wrong-record-twice", "name" => stem)));
                }
                files.extend(drawn(&ground, &stem)?);
            }
        }
    }
    if let Some(out) = &args.out {
        console.print(&write_files(out, &files)?);
    }
    Ok(())
}

/// Channels with their numbers: all, or the one.
fn chosen<'r>(record: &'r Record, number: Option<usize>, path: &Path) -> Result<Vec<(usize, &'r Channel)>, Failure> {
    let Some(number) = number else { return Ok((1..).zip(&record.channels).collect()) };
    let channel = record.channel(Some(number));
    let channel =
        channel.map_err(|remedy| Failure::Input(format!("{}: --channel {number}: {remedy}", path.display())))?;
    Ok(vec![(number, channel)])
}

fn heading(path: &Path, record: &Record) -> String {
    let count = record.channels.len();
    let file = escaped(&path.display().to_string()).into_owned();
    let format = record.format.to_string();
    format!("{}\n", said!("motion-file", "file" => file, "format" => format, "count" => count))
}

/// A channel's figures, a line each.
fn text(number: usize, channel: &Channel, figures: &Figures) -> String {
    let Figures { acceleration: a, velocity: v, displacement: d, strong } = figures;
    let direction = match channel.orientation {
        Orientation::Unstated => Text::new("motion-unstated").into(),
        Orientation::Azimuth(azimuth) => said!("motion-azimuth", "azimuth" => six(azimuth)),
        Orientation::Up => Text::new("motion-up").into(),
    };
    let no_name = Text::new("motion-no-name").as_str();
    let name = if channel.name.is_empty() { no_name.into() } else { escaped(&channel.name) };
    let count = channel.samples.len();
    let length = (count - 1) as f64 * channel.dt;
    let done = if channel.done.is_empty() {
        Text::new("motion-nothing").into()
    } else {
        channel.done.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    };
    let lines = [
        said!("motion-channel", "number" => number, "name" => name, "direction" => direction),
        said!(
            "motion-samples",
            "unit" => channel.unit.label(),
            "count" => count,
            "dt" => six(channel.dt),
            "length" => six(length)
        ),
        said!(
            "motion-peak",
            "g" => six(a.value / STANDARD_GRAVITY),
            "gal" => six(a.value * 100.0),
            "t" => six(a.at)
        ),
        said!(
            "motion-ground",
            "velocity" => six(v.value.abs()),
            "tv" => six(v.at),
            "displacement" => six(d.value.abs()),
            "td" => six(d.at)
        ),
        said!(
            "motion-strong",
            "duration" => six(strong.duration()),
            "from" => six(strong.from),
            "until" => six(strong.until),
            "arias" => six(strong.arias)
        ),
        said!("motion-done", "done" => done),
    ];
    lines.join("\n  ") + "\n"
}

/// Plots and tables of a channel.
fn drawn(ground: &Ground<'_>, stem: &str) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let spectrum = ground.spectrum();
    let mut files = vec![
        (format!("{stem}-history.csv"), ground.csv().into_bytes()),
        (format!("{stem}-spectrum.csv"), spectrum_csv(&spectrum).into_bytes()),
    ];
    files.extend(plot_files(&format!("{stem}-history"), ground.histories(stem))?);
    let title = said!("motion-spectrum-title", "record" => stem);
    files.extend(plot_files(&format!("{stem}-spectrum"), spectrum_chart(&spectrum, &title))?);
    Ok(files)
}
