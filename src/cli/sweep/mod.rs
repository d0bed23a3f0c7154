//! `girderbench sweep`: one scene at many values of its keys, as a dataset and pictures.

mod folder;
mod shard;

use std::path::PathBuf;

use serde_json::Value;

use super::args::{SceneArgs, Threads};
use super::console::Console;
use super::domain;
use super::failure::Failure;
use super::output::write_files;
use super::plot_files::plot_files;
use super::progress::Progress;
use crate::files::{Records, check_folder};
use crate::language::{self, Text, said};
use crate::study::sweep::{Dataset, MEASURES, Measure, Plan, Status, about, compute, identity};
use folder::{Folder, JOURNAL};
use shard::Shard;

/// Run a scene at many values of its keys: a dataset, and maps of it
///
/// Every run that has come out is kept in the folder at once: the same command goes on where an earlier one ended, however
/// it ended. docs/sweep.md has the measures, and how to divide a sweep over machines.
#[derive(Clone, Debug, clap::Args)]
#[command(after_long_help = measures())]
pub(super) struct SweepArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// A key, as --set takes it, and its values: a list `a,b,c`, a grid `LO..HI:N`, equal ratios `LO..HI:N:log`, or a mixture;
    /// given again, every combination is run
    #[arg(long, value_name = "KEY=VALUES", required = true)]
    vary: Vec<String>,
    /// What to keep of each run, separated by commas; below is what there is
    #[arg(long, value_name = "MEASURE,…", required = true, value_delimiter = ',')]
    measure: Vec<String>,
    /// The folder of the sweep: sweep.csv, sweep.parquet, pictures, and what it goes on with
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Compute the I-th of N parts only; without it the same command puts together what all parts have left in the folder
    #[arg(long, value_name = "I/N", value_parser = Shard::parse)]
    shard: Option<Shard>,
    #[command(flatten)]
    threads: Threads,
}

/// Does it.
///
/// # Errors
/// Bad input, before anything runs; a folder that holds another sweep or cannot be written.
pub(super) fn run(args: &SweepArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.scene.load()?;
    args.threads.start()?;
    let records = Records::beside(&args.scene.scene);
    let plan = Plan::new(scene, &args.vary, &args.measure, Box::new(move |scene| records.complete(scene)))?;
    if args.scene.changes.until.is_some() && plan.axes.iter().any(|axis| axis.key == "duration_s") {
        return Err(Failure::Input(Text::new("wrong-until-varied").into()));
    }
    check_folder(&args.out)?;
    domain::warn(&plan.scene, console);
    domain::warn_of_runs(&plan, console);
    let about = about(&plan);
    let mut folder = Folder::open(&args.out, &about, identity(&about))?;
    if let Some(shard) = args.shard {
        folder.read(&shard.journal(), &plan, console)?;
    } else {
        folder.read(JOURNAL, &plan, console)?;
        folder.read_others(JOURNAL, &plan, console)?;
    }
    let wanted = |run: &usize| args.shard.is_none_or(|shard| shard.has(*run)) && !folder.rows.contains_key(run);
    let missing: Vec<usize> = (0..plan.runs()).filter(wanted).collect();
    console.print(&format!("{}\n", said!("sweep-runs", "runs" => plan.runs(), "missing" => missing.len())));
    compute_missing(&plan, &missing, &mut folder)?;
    if args.shard.is_some() {
        console.print(&format!("{}\n", Text::new("sweep-part")));
        return Ok(());
    }
    write(args, &Dataset { plan: &plan, rows: &folder.rows }, &about, console)
}

/// Name and bytes of the dataset as Parquet, where this build writes it.
#[cfg(feature = "parquet")]
fn parquet(dataset: &Dataset<'_>, about: &Value) -> Result<Option<(String, Vec<u8>)>, Failure> {
    let bytes = dataset.parquet(about).map_err(|error| unwritten("sweep.parquet", &error))?;
    Ok(Some(("sweep.parquet".to_owned(), bytes)))
}

/// No Parquet: this build writes none.
#[cfg(not(feature = "parquet"))]
#[expect(clippy::unnecessary_wraps, reason = "the same call as in a build with Parquet")]
fn parquet(_: &Dataset<'_>, _: &Value) -> Result<Option<(String, Vec<u8>)>, Failure> {
    Ok(None)
}

/// A table that could not be made.
fn unwritten(path: &str, error: &dyn std::fmt::Display) -> Failure {
    let remedy = Text::new("unwritten-try-again").as_str();
    Failure::Output(said!("unwritten", "path" => path, "reason" => error.to_string(), "remedy" => remedy))
}

/// The measures, a line each, in the language in use: English as it stands with them.
fn measures() -> String {
    let line = |measure: &Measure| {
        let meaning = language::own(&measure_key(measure)).unwrap_or(measure.meaning);
        format!("  {:<17} {:<4} {meaning}\n", measure.name, measure.unit)
    };
    MEASURES.iter().map(line).fold(format!("{}\n", Text::new("sweep-measures")), |all, line| all + &line)
}

/// Key of a measure's meaning in another language.
fn measure_key(measure: &Measure) -> String {
    format!("measure-{}", measure.name)
}

/// All of these keys.
#[cfg(test)]
pub(super) fn measure_keys() -> impl Iterator<Item = String> {
    MEASURES.iter().map(measure_key)
}

fn compute_missing(plan: &Plan, missing: &[usize], folder: &mut Folder) -> Result<(), Failure> {
    let mut progress = Progress::over(missing.len() as f64, Text::new("progress-runs"));
    let mut done = 0.0;
    compute(plan, missing, rayon::current_num_threads(), &mut |row| {
        done += 1.0;
        progress.show(done);
        folder.append(row)
    })?;
    progress.done();
    Ok(())
}

/// Writes the dataset and its pictures, and says how the runs ended.
fn write(args: &SweepArgs, dataset: &Dataset<'_>, about: &Value, console: &mut Console) -> Result<(), Failure> {
    let of_csv = |error: csv::Error| unwritten("sweep.csv", &error);
    let mut files = vec![("sweep.csv".to_owned(), dataset.csv().map_err(of_csv)?)];
    let digest = xxhash_rust::xxh3::xxh3_64(&files[0].1);
    files.extend(parquet(dataset, about)?);
    match dataset.pictures() {
        Ok(pictures) => {
            for (name, svg) in pictures {
                files.extend(plot_files(&name, svg)?);
            }
        }
        Err(why) => console.note(&why),
    }
    let written = write_files(&args.out, &files)?;
    for (status, how) in
        [(Status::Ended, "stop-ended"), (Status::GaveUp, "stop-gave-up"), (Status::Refused, "sweep-refused")]
    {
        let how = Text::new(how);
        let rows = || dataset.rows.values().filter(|row| row.status == status);
        if let Some(first) = rows().next() {
            let count = rows().count();
            let (run, reason) = (first.run, first.reason.as_str());
            console.note(&said!("sweep-ended", "count" => count, "how" => how, "run" => run, "reason" => reason));
        }
    }
    console.print(&written);
    console.print(&format!("{}\n", said!("sweep-digest", "digest" => format!("{digest:016x}"))));
    Ok(())
}
