//! `girderbench study experiment`: every case of the paper's Tables 2 and 3, as one page; a result that is there is not computed again.

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use rayon::prelude::*;

use super::page::OccasionArgs;
use crate::cli::args::{Threads, at_least_one, positive, record_unit};
use crate::cli::console::Console;
use crate::cli::failure::Failure;
use crate::cli::output::write_files;
use crate::cli::progress::Progress;
use crate::files::{Supplement, check_folder, read_record};
use crate::language::{Text, said};
use crate::motion::format::Unit as RecordUnit;
use crate::study::experiment::{Earthquake, Results, Unit, findings, report};

/// Where results are kept, inside of the folder.
const KEPT: &str = "results";
/// Where the maps are written, inside of the folder.
const MAPS: &str = "maps";

/// Run the paper's experiment: all cases of its Table 2 under both models, its figures and findings, as one page
#[derive(Clone, Debug, clap::Args)]
pub(super) struct ExperimentArgs {
    /// Write report.html, findings.md, maps/ and results/ into this folder; results that are there already are not computed again
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Only these, separated by commas: cases (`skew60_-15_0.40g`), all of straight, skew60, skew45 or pair, or the maps
    #[arg(long, value_name = "CASE,…", value_delimiter = ',', allow_hyphen_values = true)]
    only: Vec<String>,
    /// The earthquake, a record file as of `girderbench motion`; without it a synthetic one
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Which channel of the file, from 1
    #[arg(long, value_name = "N", value_parser = at_least_one, requires = "record", allow_negative_numbers = true)]
    channel: Option<usize>,
    /// Interval between samples, for a file that does not state it [s]
    #[arg(long, value_name = "S", value_parser = positive, requires = "record", allow_negative_numbers = true)]
    dt: Option<f64>,
    /// Unit of the numbers, for a file that does not state it: g, gal (cm/s2), m/s2
    #[arg(long, value_name = "UNIT", value_parser = record_unit, requires = "record")]
    unit: Option<RecordUnit>,
    /// Multiply the earthquake; the paper does not state its scale
    #[arg(long, value_name = "X", value_parser = positive, default_value_t = 1.0, allow_negative_numbers = true)]
    record_scale: f64,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    occasion: OccasionArgs,
}

/// Does it.
///
/// # Errors
/// A case that is not there, a record that cannot be read, a folder that cannot be written.
pub(super) fn run(args: &ExperimentArgs, console: &mut Console) -> Result<(), Failure> {
    let asked = asked(&args.only)?;
    let earthquake = earthquake(args)?;
    args.threads.start()?;
    check_folder(&args.out)?;
    let kept = args.out.join(KEPT);
    let mut due = Vec::new();
    for unit in &asked {
        if !is_kept(unit, &earthquake, &kept)? {
            due.push(unit);
        }
    }
    compute(&due, &earthquake, &kept)?;
    let results = results(&earthquake, &kept)?;
    let page = report::html(&results, &earthquake, &args.occasion.with(command(args)));
    let table = report::markdown(&results);
    let files = [("report.html".to_owned(), page.into_bytes()), ("findings.md".to_owned(), table.into_bytes())];
    write_files(&args.out, &files)?;
    let maps = report::maps(&results).into_iter().map(|(name, svg)| (format!("{name}.svg"), svg.into_bytes()));
    write_files(&args.out.join(MAPS), &maps.collect::<Vec<_>>())?;
    say(&results, console);
    let (run, there) = (due.len(), asked.len() - due.len());
    let page = args.out.join("report.html").display().to_string();
    console.print(&format!("{}\n", said!("study-computed", "run" => run, "there" => there, "page" => page)));
    Ok(())
}

/// The units that were asked for, all of them where none was named.
fn asked(only: &[String]) -> Result<Vec<Unit>, Failure> {
    let all = Unit::all();
    for word in only {
        if !all.iter().any(|unit| unit.answers_to(word)) {
            let names: Vec<String> = all.iter().map(Unit::name).collect();
            let known = format!("{}, {}", Unit::KINDS.join(", "), names.join(", "));
            let said = said!("study-none-of", "flag" => "--only", "name" => word.as_str(), "known" => known);
            return Err(Failure::Input(said));
        }
    }
    Ok(all.into_iter().filter(|unit| only.is_empty() || only.iter().any(|word| unit.answers_to(word))).collect())
}

fn earthquake(args: &ExperimentArgs) -> Result<Earthquake, Failure> {
    let Some(path) = &args.record else { return Ok(Earthquake::synthetic(args.record_scale)) };
    let record = read_record(path, &Supplement { dt: args.dt, unit: args.unit })?;
    let channel = record.channel(args.channel);
    let channel = channel.map_err(|remedy| Failure::Input(format!("{}: --channel: {remedy}", path.display())))?;
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    Ok(Earthquake::of(channel, &name, args.record_scale))
}

fn file_of(unit: &Unit, folder: &Path) -> PathBuf {
    folder.join(format!("{}.json", unit.name()))
}

/// Takes the result of a unit where there is one of the same scenes.
fn take(unit: &Unit, earthquake: &Earthquake, folder: &Path, results: &mut Results) -> Result<bool, Failure> {
    let Ok(text) = std::fs::read_to_string(file_of(unit, folder)) else { return Ok(false) };
    Ok(unit.take(&text, &unit.fingerprint(earthquake)?, results))
}

fn is_kept(unit: &Unit, earthquake: &Earthquake, folder: &Path) -> Result<bool, Failure> {
    take(unit, earthquake, folder, &mut Results::default())
}

/// Computes what is due on all threads; each result is written as soon as it is there.
fn compute(due: &[&Unit], earthquake: &Earthquake, folder: &Path) -> Result<(), Failure> {
    let progress = Mutex::new((Progress::over(due.len() as f64, Text::new("progress-results")), 0.0));
    let done = due.par_iter().try_for_each(|unit| {
        let text = unit.run(earthquake)?;
        write_files(folder, &[(format!("{}.json", unit.name()), text.into_bytes())])?;
        if let Ok(mut shown) = progress.lock() {
            shown.1 += 1.0;
            let done = shown.1;
            shown.0.show(done);
        }
        Ok::<(), Failure>(())
    });
    if let Ok((progress, _)) = progress.into_inner() {
        progress.done();
    }
    done
}

/// Results of all units, of this call and of earlier ones.
fn results(earthquake: &Earthquake, folder: &Path) -> Result<Results, Failure> {
    let mut results = Results::default();
    for unit in Unit::all() {
        take(&unit, earthquake, folder, &mut results)?;
    }
    Ok(results)
}

/// The findings with their outcomes, a line each.
fn say(results: &Results, console: &mut Console) {
    for finding in findings::findings(results) {
        let outcomes: Vec<&str> = finding.verdicts.iter().map(|verdict| verdict.outcome().label()).collect();
        console.print(&format!("{:2} {}: {}\n", finding.number, finding.title, outcomes.join(" / ")));
    }
}

/// Command that repeats the study.
fn command(args: &ExperimentArgs) -> String {
    let mut words = vec!["girderbench study experiment".to_owned()];
    if !args.only.is_empty() {
        words.push(format!("--only {}", args.only.join(",")));
    }
    if let Some(path) = &args.record {
        words.push(format!("--record {}", path.display()));
    }
    words.extend(args.channel.map(|n| format!("--channel {n}")));
    words.extend(args.dt.map(|dt| format!("--dt {dt}")));
    words.extend(args.unit.map(|unit| format!("--unit {}", unit.label())));
    if args.record_scale != 1.0 {
        words.push(format!("--record-scale {}", args.record_scale));
    }
    words.push(format!("--out {}", args.out.display()));
    words.join(" ")
}
