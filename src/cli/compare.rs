//! `girderbench compare`: runs or reads two answers and prints where they part.

use std::path::{Path, PathBuf};

use super::args::{Changes, positive};
use super::compute::compute;
use super::console::Console;
use super::domain;
use super::failure::Failure;
use super::limits;
use crate::files;
use crate::language::said;
use crate::tables::compare::{Comparison, Difference, EventDifference, compare, compare_events};
use crate::tables::read::{self, EventRow, TableError, Trajectory};
use crate::tables::{self, DEFAULT_SAMPLE_HZ};

/// Run or read two answers and print where they part
#[derive(Clone, Debug, clap::Args)]
pub(super) struct CompareArgs {
    /// A scene file, a preset, or a folder that `run --out` wrote
    #[arg(value_name = "A")]
    a: PathBuf,
    /// The same
    #[arg(value_name = "B")]
    b: PathBuf,
    /// What to change in the scenes that are run
    #[command(flatten)]
    changes: Changes,
    /// Rows per second of what is run [Hz]; 100 when left out
    #[arg(long, value_name = "HZ", value_parser = positive, allow_negative_numbers = true)]
    sample: Option<f64>,
    /// When two quantities count as parted, relative to their largest value
    #[arg(long, value_name = "R", default_value_t = 1e-6, value_parser = positive, allow_negative_numbers = true)]
    within: f64,
}

/// One side of the comparison.
struct Answer {
    trajectory: Trajectory,
    events: Vec<EventRow>,
}

/// Does it.
///
/// # Errors
/// Bad input; changes to a scene where none is run; two answers that share no instant or no quantity.
pub(super) fn run(args: &CompareArgs, console: &mut Console) -> Result<(), Failure> {
    args.refuse_changes_to_nothing()?;
    let a = answer(&args.a, args, console)?;
    let b = answer(&args.b, args, console)?;
    let comparison = compare(&a.trajectory, &b.trajectory, args.within);
    if comparison.instants == 0 || comparison.differences.is_empty() {
        return Err(Failure::Input(said!(
            "wrong-nothing-common",
            "a" => args.a.display().to_string(),
            "b" => args.b.display().to_string(),
            "instants" => comparison.instants,
            "quantities" => comparison.differences.len()
        )));
    }
    console.print(&motion_text(&comparison, args.within));
    let events = compare_events(&a.events, &b.events);
    console.print(&events_text([a.events.len(), b.events.len()], &events));
    console.print(&verdict(&comparison, &events, args.within));
    Ok(())
}

impl CompareArgs {
    /// Refuses flags that would do nothing, because both answers come from folders.
    fn refuse_changes_to_nothing(&self) -> Result<(), Failure> {
        let flags: Vec<_> = self.changes.given().into_iter().chain(self.sample.map(|_| "--sample")).collect();
        if flags.is_empty() || [&self.a, &self.b].iter().any(|source| !source.is_dir()) {
            return Ok(());
        }
        Err(Failure::Input(said!(
            "wrong-both-read",
            "flags" => flags.join(", "),
            "a" => self.a.display().to_string(),
            "b" => self.b.display().to_string()
        )))
    }
}

fn answer(source: &Path, args: &CompareArgs, console: &mut Console) -> Result<Answer, Failure> {
    if source.is_dir() { read_answer(source) } else { run_answer(source, args, console) }
}

fn read_answer(folder: &Path) -> Result<Answer, Failure> {
    Ok(Answer {
        trajectory: read_table(&folder.join("trajectory.csv"), read::trajectory)?,
        events: read_table(&folder.join("events.csv"), read::events)?,
    })
}

fn read_table<T>(path: &Path, parse: fn(&[u8]) -> Result<T, TableError>) -> Result<T, Failure> {
    let bytes = files::read_table(path)?;
    parse(&bytes).map_err(|error| Failure::Input(format!("{}: {error}", path.display())))
}

/// Runs a scene and takes its answer by way of the tables, which lose nothing.
fn run_answer(source: &Path, args: &CompareArgs, console: &mut Console) -> Result<Answer, Failure> {
    let scene = args.changes.load(source)?;
    let sample = args.sample.unwrap_or(DEFAULT_SAMPLE_HZ);
    limits::check_in_memory(sample, &scene)?;
    domain::warn(&scene, console);
    let history = compute(&scene)?.swap_remove(0).history;
    if let Some(stop) = history.stop() {
        console.note(&Failure::GaveUp { scene: scene.name.clone(), stop: stop.clone() }.to_string());
    }
    domain::warn_of_balance(&history, console);
    let of_table = |error: TableError| Failure::Input(format!("{}: {error}", source.display()));
    Ok(Answer {
        trajectory: read::trajectory(&tables::in_memory(|out| tables::trajectory(&history, sample, out)))
            .map_err(of_table)?,
        events: read::events(&tables::in_memory(|out| tables::events(&history, out))).map_err(of_table)?,
    })
}

fn motion_text(comparison: &Comparison, within: f64) -> String {
    let matched = match comparison.unmatched {
        0 => format!("{} instants in both\n", comparison.instants),
        others => format!("{} instants in both, {others} in one only\n", comparison.instants),
    };
    let head = format!(
        "{:<20} {:>12} {:>10} {:>12}  parts by more than {within:e} of the largest at\n",
        "quantity", "difference", "at t [s]", "largest"
    );
    let only =
        [(&comparison.only_a, "A"), (&comparison.only_b, "B")].into_iter().filter(|(names, _)| !names.is_empty());
    let only = only.map(|(names, which)| format!("only in {which}: {}\n", names.join(", ")));
    [matched, head].into_iter().chain(comparison.differences.iter().map(difference_line)).chain(only).collect()
}

fn difference_line(d: &Difference) -> String {
    let parts = d.parts_at.map_or("never".to_owned(), |t| format!("{t} s"));
    format!("{:<20} {:>12} {:>10} {:>12}  {parts}\n", d.name, short(d.largest), d.at, short(d.scale))
}

fn events_text([in_a, in_b]: [usize; 2], differences: &[(String, EventDifference)]) -> String {
    let same = |d: &EventDifference| if let EventDifference::Same(apart) = d { Some(*apart) } else { None };
    let agreeing = differences.iter().filter_map(|(_, d)| same(d));
    let (count, apart) = agreeing.fold((0, 0.0_f64), |(n, apart), more| (n + 1, apart.max(more)));
    let head = format!("events: {in_a} in A, {in_b} in B\n");
    let agree = match count {
        0 => String::new(),
        count => format!("  same events in the same order at {count} contacts, times within {} s\n", short(apart)),
    };
    let differ = differences.iter().filter_map(|(contact, difference)| match difference {
        EventDifference::Same(_) => None,
        EventDifference::From(a, b) => {
            Some(format!("  {contact}: A {}, B {}\n", event_words(a.as_ref()), event_words(b.as_ref())))
        }
    });
    [head, agree].into_iter().chain(differ).collect()
}

/// The last line: how far the two agree, or when they first part and in what.
fn verdict(comparison: &Comparison, events: &[(String, EventDifference)], within: f64) -> String {
    let of_motion = |d: &Difference| Some((d.parts_at?, format!("{}, by more than {within:e} of its largest", d.name)));
    let of_events = |(contact, d): &(String, EventDifference)| match d {
        EventDifference::Same(_) => None,
        EventDifference::From(a, b) => {
            let first = a.iter().chain(b).map(|event| event.t).fold(f64::INFINITY, f64::min);
            Some((first, format!("the events of {contact}")))
        }
    };
    let parts = comparison.differences.iter().filter_map(of_motion).chain(events.iter().filter_map(of_events));
    if let Some((t, what)) = parts.min_by(|a, b| a.0.total_cmp(&b.0)) {
        return format!("part at t = {t} s: {what}\n");
    }
    let share = |d: &Difference| if d.largest > 0.0 { d.largest / d.scale } else { 0.0 };
    let apart = comparison.differences.iter().map(share).fold(0.0, f64::max);
    format!("agree to {} of the largest of each quantity\n", short(apart))
}

fn event_words(event: Option<&EventRow>) -> String {
    event.map_or("has no more".to_owned(), |event| format!("{} at {} s", event.kind, event.t))
}

fn short(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.4e}") }
}
