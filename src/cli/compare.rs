//! `girderbench compare`: runs or reads two answers and prints where they part.

use std::path::{Path, PathBuf};

use super::args::{Changes, positive};
use super::columns::{left, right};
use super::compute::compute;
use super::console::Console;
use super::digits::six;
use super::domain;
use super::failure::Failure;
use super::limits;
use crate::files;
use crate::language::{Text, said};
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

impl Answer {
    /// Its last instant \[s\].
    fn end(&self) -> f64 {
        self.trajectory.t.last().copied().unwrap_or(0.0)
    }
}

/// Does it.
///
/// # Errors
/// Bad input; changes to a scene where none is run; two answers that share no instant or no quantity.
pub(super) fn run(args: &CompareArgs, console: &mut Console) -> Result<(), Failure> {
    args.refuse_changes_to_nothing()?;
    let mut a = answer(&args.a, args, console)?;
    let mut b = answer(&args.b, args, console)?;
    // What one has beyond the end of the other is no difference.
    let [end_a, end_b] = [&a, &b].map(Answer::end);
    let until = end_a.min(end_b);
    for answer in [&mut a, &mut b] {
        answer.events.retain(|event| event.t <= until);
    }
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
    if end_a != end_b {
        let shorter = if end_a < end_b { "A" } else { "B" };
        console.print(&format!("{}\n", said!("compare-until", "which" => shorter, "t" => six(until))));
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
    let mut computed = compute(&scene).map_err(|errors| errors.in_file(&source.to_string_lossy()))?;
    let history = computed.swap_remove(0).history;
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
        0 => said!("compare-instants", "count" => comparison.instants),
        others => said!("compare-instants-only", "count" => comparison.instants, "others" => others),
    };
    let parts = said!("compare-parts", "within" => format!("{within:e}"));
    let [quantity, difference, at, largest] =
        ["compare-quantity", "compare-difference", "compare-at", "compare-largest"].map(Text::new);
    let head = row(&quantity, [&difference, &at, &largest], &parts);
    let only =
        [(&comparison.only_a, "A"), (&comparison.only_b, "B")].into_iter().filter(|(names, _)| !names.is_empty());
    let only = only
        .map(|(names, which)| format!("{}\n", said!("compare-only", "which" => which, "names" => names.join(", "))));
    [matched + "\n", head].into_iter().chain(comparison.differences.iter().map(difference_line)).chain(only).collect()
}

fn difference_line(d: &Difference) -> String {
    let parts = d.parts_at.map_or_else(|| Text::new("compare-never").into(), |t| format!("{} s", six(t)));
    row(&d.name, [&short(d.largest), &six(d.at), &short(d.scale)], &parts)
}

/// A line of the table of quantities.
fn row(name: &str, [difference, at, largest]: [&str; 3], parts: &str) -> String {
    format!("{} {} {} {}  {parts}\n", left(name, 20), right(difference, 12), right(at, 10), right(largest, 12))
}

fn events_text([in_a, in_b]: [usize; 2], differences: &[(String, EventDifference)]) -> String {
    let same = |d: &EventDifference| if let EventDifference::Same(apart) = d { Some(*apart) } else { None };
    let agreeing = differences.iter().filter_map(|(_, d)| same(d));
    let (count, apart) = agreeing.fold((0, 0.0_f64), |(n, apart), more| (n + 1, apart.max(more)));
    let head = format!("{}\n", said!("compare-events", "a" => in_a, "b" => in_b));
    let agree = match count {
        0 => String::new(),
        count => format!("  {}\n", said!("compare-same-events", "count" => count, "apart" => short(apart))),
    };
    let differ = differences.iter().filter_map(|(contact, difference)| match difference {
        EventDifference::Same(_) => None,
        EventDifference::From(a, b) => {
            let [a, b] = [a, b].map(|event| event_words(event.as_ref()));
            Some(format!("  {}\n", said!("compare-event", "contact" => contact.as_str(), "a" => a, "b" => b)))
        }
    });
    [head, agree].into_iter().chain(differ).collect()
}

/// The last line: how far the two agree, or when they first part and in what.
fn verdict(comparison: &Comparison, events: &[(String, EventDifference)], within: f64) -> String {
    let of_motion = |d: &Difference| {
        let (name, within) = (d.name.as_str(), format!("{within:e}"));
        Some((d.parts_at?, said!("compare-part-motion", "name" => name, "within" => within)))
    };
    let of_events = |(contact, d): &(String, EventDifference)| match d {
        EventDifference::Same(_) => None,
        EventDifference::From(a, b) => {
            let first = a.iter().chain(b).map(|event| event.t).fold(f64::INFINITY, f64::min);
            Some((first, said!("compare-part-events", "contact" => contact.as_str())))
        }
    };
    let parts = comparison.differences.iter().filter_map(of_motion).chain(events.iter().filter_map(of_events));
    if let Some((t, what)) = parts.min_by(|a, b| a.0.total_cmp(&b.0)) {
        return format!("{}\n", said!("compare-part", "t" => six(t), "what" => what));
    }
    let share = |d: &Difference| if d.largest > 0.0 { d.largest / d.scale } else { 0.0 };
    let apart = comparison.differences.iter().map(share).fold(0.0, f64::max);
    format!("{}\n", said!("compare-agree", "apart" => short(apart)))
}

fn event_words(event: Option<&EventRow>) -> String {
    let at = |event: &EventRow| said!("compare-event-at", "kind" => event.kind.as_str(), "t" => six(event.t));
    event.map_or_else(|| Text::new("compare-no-more").into(), at)
}

fn short(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.4e}") }
}
