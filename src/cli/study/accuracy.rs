//! `girderbench study accuracy`: work against error, as CSV, plots and a page.

use std::path::PathBuf;

use super::page::{OccasionArgs, picture_extension, written};
use crate::cli::args::at_least_one;
use crate::cli::console::Console;
use crate::cli::failure::Failure;
use crate::cli::output::write_files;
use crate::cli::plot_files::plot_files;
use crate::language::said;
use crate::study::accuracy::{Options, Problem, method, problem, study};

/// Measure work against error: every method on every problem
#[derive(Clone, Debug, clap::Args)]
pub(super) struct AccuracyArgs {
    /// Problems, all of them when none is named
    #[arg(value_name = "PROBLEM")]
    problems: Vec<String>,
    /// Write README.md, results.csv and the plots into this folder
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Methods, separated by commas; all of them when none is named
    #[arg(long, value_name = "METHOD,…", value_delimiter = ',')]
    methods: Vec<String>,
    /// Runs that are timed, after a warm-up; the least counts
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = at_least_one, allow_negative_numbers = true)]
    repeat: usize,
    /// Fewer settings and shorter sweeps: a minute instead of many
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    occasion: OccasionArgs,
}

/// Does it.
///
/// # Errors
/// A problem or method that is not there; files that cannot be written.
pub(super) fn run(args: &AccuracyArgs, console: &mut Console) -> Result<(), Failure> {
    let problems = named(&args.problems, "PROBLEM", problem::all(), |p| p.name)?;
    let methods = named(&args.methods, "--methods", method::all(), |m| m.name())?;
    let problems: Vec<&'static Problem> = problems.into_iter().collect();
    let methods: Vec<&'static dyn method::Method> = methods.into_iter().copied().collect();
    let options = Options { repeat: args.repeat, quick: args.quick };
    let study = study(&problems, &methods, options, &mut |what| console.note(what))?;
    let occasion = args.occasion.with(command(args));
    let mut all = vec![
        ("results.csv".to_owned(), study.csv().into_bytes()),
        ("README.md".to_owned(), study.page(&occasion, picture_extension()).into_bytes()),
    ];
    for (name, plot) in study.plots() {
        all.extend(plot_files(&name, plot.svg())?);
    }
    write_files(&args.out, &all)?;
    console.print(&written(&args.out, all.len()));
    Ok(())
}

/// Command that repeats the study.
fn command(args: &AccuracyArgs) -> String {
    let mut words = vec!["girderbench study accuracy".to_owned()];
    words.extend(args.problems.iter().cloned());
    if !args.methods.is_empty() {
        words.push(format!("--methods {}", args.methods.join(",")));
    }
    words.push(format!("--repeat {}", args.repeat));
    if args.quick {
        words.push("--quick".to_owned());
    }
    words.push(format!("--out {}", args.out.display()));
    words.join(" ")
}

/// The things of these names, all of them when there is none.
fn named<T>(
    names: &[String],
    flag: &str,
    all: &'static [T],
    name_of: impl Fn(&T) -> &'static str,
) -> Result<Vec<&'static T>, Failure> {
    if names.is_empty() {
        return Ok(all.iter().collect());
    }
    let find = |name: &String| {
        all.iter().find(|thing| name_of(thing) == name).ok_or_else(|| {
            let known: Vec<&str> = all.iter().map(&name_of).collect();
            let known = known.join(", ");
            Failure::Input(said!("study-none-of", "flag" => flag, "name" => name.as_str(), "known" => known))
        })
    };
    names.iter().map(find).collect()
}
