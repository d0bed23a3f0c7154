//! `girderbench plot`: quantities of a run against time or against each other, as CSV, SVG and PNG: histories, hysteresis loops.

use std::path::PathBuf;

use super::args::{SceneArgs, Threads, positive};
use super::compute::compute_as_asked;
use super::console::Console;
use super::domain;
use super::failure::Failure;
use super::limits;
use super::output::write_files;
use super::plot_files::plot_files;
use crate::files::check_folder;
use crate::language::{Text, said};
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::sim::{History, Quantity, Unit};
use crate::tables::{DEFAULT_SAMPLE_HZ, quantities};

/// Plot quantities of a run against time or each other, e.g. a hysteresis loop; without `--y`, list their names
#[derive(Clone, Debug, clap::Args)]
pub(super) struct PlotArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// A quantity of the upright axis, e.g. `deck.bearing1.force-x`; may be given several times
    #[arg(long, value_name = "NAME")]
    y: Vec<String>,
    /// The quantity of the level axis, e.g. `deck.bearing1.x`; the time when left out
    #[arg(long, value_name = "NAME", requires = "y")]
    x: Option<String>,
    /// Points per second [Hz]
    #[arg(long, value_name = "HZ", default_value_t = DEFAULT_SAMPLE_HZ, value_parser = positive, allow_negative_numbers = true)]
    sample: f64,
    #[command(flatten)]
    threads: Threads,
    /// Write plot.csv, plot.svg and plot.png into this folder
    #[arg(long, value_name = "DIR", default_value = "out", requires = "y")]
    out: PathBuf,
    /// Print the names of all quantities of the run and nothing else
    #[arg(long)]
    list: bool,
}

/// Does it.
///
/// # Errors
/// Bad input; names that the run does not have; files that cannot be written; a run that gave up, after its plot has been written.
pub(super) fn run(args: &PlotArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.scene.load()?;
    args.threads.start()?;
    let lists = args.list || args.y.is_empty();
    if !lists {
        check_folder(&args.out)?;
        limits::check_plot(args.sample, &scene, 1 + args.x.iter().len() + args.y.len())?;
    }
    domain::warn(&scene, console);
    let timed = args.scene.of_its_file(compute_as_asked(&scene))?;
    let history = &timed.history;
    if lists {
        let names: String = Quantity::all(history).into_iter().map(|(name, _)| name + "\n").collect();
        console.print(&names);
    } else {
        write(history, args, console)?;
    }
    match history.stop() {
        Some(stop) => Err(Failure::GaveUp { scene: scene.name, stop: stop.clone() }),
        None => Ok(()),
    }
}

/// Writes table and picture of the quantities that are asked for.
fn write(history: &History, args: &PlotArgs, console: &mut Console) -> Result<(), Failure> {
    let x = args.x.as_ref().map(|name| found(history, name)).transpose()?;
    let y = args.y.iter().map(|name| found(history, name)).collect::<Result<Vec<_>, _>>()?;
    let columns: Vec<(String, Quantity)> = x.iter().chain(&y).cloned().collect();
    let mut csv = Vec::new();
    quantities(history, &columns, args.sample, &mut csv)
        .map_err(|error| Failure::Input(format!("plot.csv: {error}")))?;
    let mut files = vec![("plot.csv".to_owned(), csv)];
    files.extend(plot_files("plot", chart(history, x.as_ref(), &y, args.sample).to_svg())?);
    console.print(&write_files(&args.out, &files)?);
    Ok(())
}

/// A quantity with its name.
fn found(history: &History, name: &str) -> Result<(String, Quantity), Failure> {
    let all = Quantity::all(history);
    let known = all.iter().find(|(known, _)| known == name).cloned();
    known.ok_or_else(|| {
        let near: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
        let hint = crate::scene::format::did_you_mean(name, &near);
        Failure::Input(said!("wrong-no-quantity", "name" => name, "meant" => hint.to_string()))
    })
}

/// The number of a curve, and its values.
type Column = (usize, Vec<f64>);

fn chart(history: &History, x: Option<&(String, Quantity)>, y: &[(String, Quantity)], hz: f64) -> Chart {
    let times: Vec<f64> = crate::tables::sample_times(history.end(), hz).collect();
    let values = |quantity: &Quantity| -> Vec<f64> { times.iter().map(|&t| quantity.at(history, t)).collect() };
    let (level, name) = match x {
        None => (times.clone(), Text::new("report-time").as_str().to_owned()),
        Some((name, quantity)) => {
            let mut level = values(quantity);
            let unit = scaled([&mut level].into_iter(), quantity.unit());
            (level, format!("{name} {unit}"))
        }
    };
    // Quantities of one unit share a field.
    let mut fields: Vec<(Unit, Vec<Column>)> = Vec::new();
    for (number, (_, quantity)) in y.iter().enumerate() {
        let curve = (number, values(quantity));
        match fields.iter_mut().find(|(unit, _)| *unit == quantity.unit()) {
            Some((_, curves)) => curves.push(curve),
            None => fields.push((quantity.unit(), vec![curve])),
        }
    }
    let panel = |(unit, mut curves): (Unit, Vec<Column>)| {
        let unit = scaled(curves.iter_mut().map(|(_, values)| values), unit);
        let named: Vec<&str> = curves.iter().take(MOST_NAMED).map(|&(number, _)| y[number].0.as_str()).collect();
        let more = if curves.len() > MOST_NAMED { ", …" } else { "" };
        let alone = curves.len() == 1;
        let curve = |(number, values): Column| Curve {
            // The only curve of a panel has the panel's name.
            name: if alone { String::new() } else { y[number].0.clone() },
            color: COLORS[number % COLORS.len()].to_owned(),
            dashes: "none",
            points: level.iter().zip(values).map(|(&x, y)| [x, y]).collect(),
        };
        Panel { name: format!("{}{more} {unit}", named.join(", ")), curves: curves.into_iter().map(curve).collect() }
    };
    Chart { title: history.scene().name.clone(), x: name, panels: fields.into_iter().map(panel).collect() }
}

/// Curves that the name of a field names.
const MOST_NAMED: usize = 3;

/// Takes the values of an axis into the unit that gives them few digits; its name, in brackets.
fn scaled<'a>(columns: impl Iterator<Item = &'a mut Vec<f64>>, unit: Unit) -> String {
    let mut columns: Vec<&mut Vec<f64>> = columns.collect();
    let sizes = columns.iter().flat_map(|values| values.iter()).map(|value| value.abs());
    let (factor, name) = unit.shown_up_to(sizes.fold(0.0, f64::max));
    columns.iter_mut().flat_map(|values| values.iter_mut()).for_each(|value| *value *= factor);
    format!("[{}]", if name.is_empty() { "–" } else { name })
}
