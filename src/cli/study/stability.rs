//! `girderbench study stability`: seeded random scenes, every answer checked, failures shrunk to small scenes.

use std::path::PathBuf;
use std::sync::Mutex;

use crate::cli::args::positive;
use crate::cli::console::Console;
use crate::cli::failure::Failure;
use crate::cli::output::write_files;
use crate::cli::progress::{Progress, Timer};
use crate::language::{Text, said};
use crate::scene::format;
use crate::study::clock::thread_seconds;
use crate::study::stability::{self, Asked, Limits, Verdict};

/// Random scenes over wide ranges: does every run end, balance, miss nothing and converge?
#[derive(Clone, Debug, clap::Args)]
pub(super) struct StabilityArgs {
    /// How many seeds
    #[arg(long, value_name = "N", default_value_t = 500, value_parser = clap::value_parser!(u64).range(1..=100_000_000), allow_negative_numbers = true)]
    seeds: u64,
    /// The first seed
    #[arg(long, value_name = "SEED", default_value_t = 0, allow_negative_numbers = true)]
    from: u64,
    /// Take only seeds whose scenes lie inside the domain of the program
    #[arg(long)]
    inside: bool,
    /// Write seeds.csv, stability.md and the failing scenes, shrunk, into this folder
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Seeds at once [default: as many as there are processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=4096), allow_negative_numbers = true)]
    threads: Option<u32>,
    /// Events after which a scene is long enough (not for those that shake for an hour)
    #[arg(long, value_name = "N", default_value_t = 20_000, value_parser = clap::value_parser!(u32).range(1..), allow_negative_numbers = true)]
    events: u32,
    /// Most processor time that the runs of one seed may take [s]
    #[arg(long, value_name = "S", default_value_t = 60.0, value_parser = positive, allow_negative_numbers = true)]
    patience: f64,
}

/// Does it.
///
/// # Errors
/// A folder that cannot be written; seeds that failed, after they have been written.
pub(super) fn run(args: &StabilityArgs, console: &mut Console) -> Result<(), Failure> {
    let timer = Timer::start();
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let threads = args.threads.map_or(cores, |n| n as usize);
    let limits = Limits { patience: args.patience, events: args.events as usize, ..Limits::NONE };
    let asked = Asked { from: args.from, seeds: args.seeds, inside: args.inside, threads, limits };
    let progress = Mutex::new((Progress::over(args.seeds as f64, Text::new("progress-seeds")), 0.0));
    let verdicts = stability::run(&asked, &thread_seconds, &|_| {
        if let Ok(mut shown) = progress.lock() {
            shown.1 += 1.0;
            let done = shown.1;
            shown.0.show(done);
        }
    });
    if let Ok((progress, _)) = progress.into_inner() {
        progress.done();
    }
    write(args, &asked, &verdicts, timer.seconds())?;
    say(args, &verdicts, console)
}

fn write(args: &StabilityArgs, asked: &Asked, verdicts: &[Verdict], wall: f64) -> Result<(), Failure> {
    let mut all = vec![
        ("seeds.csv".to_owned(), stability::csv(verdicts).into_bytes()),
        ("stability.md".to_owned(), stability::markdown(asked, verdicts, wall).into_bytes()),
    ];
    for verdict in verdicts {
        if let Some(mut scene) = verdict.small.clone() {
            let said: Vec<&str> = verdict.complaints().iter().map(|c| c.detail.as_str()).collect();
            scene.description = format!("Shrunk from seed {}: {}", verdict.seed, said.join("; "));
            all.push((format!("seed-{}.toml", verdict.seed), format::write(&scene).into_bytes()));
        }
    }
    write_files(&args.out, &all).map(|_| ())
}

fn say(args: &StabilityArgs, verdicts: &[Verdict], console: &mut Console) -> Result<(), Failure> {
    let failed: Vec<&Verdict> = verdicts.iter().filter(|v| v.failed()).collect();
    for verdict in &failed {
        for complaint in verdict.complaints() {
            let (seed, family, check) = (verdict.seed, verdict.family, complaint.check.label());
            let detail = complaint.detail.as_str();
            let line = said!("study-seed", "seed" => seed, "family" => family, "check" => check, "detail" => detail);
            console.print(&format!("{line}\n"));
        }
    }
    let (seeds, out) = (verdicts.len(), &args.out);
    let inside = verdicts.iter().filter(|v| v.inside).count();
    let failed_inside = failed.iter().filter(|v| v.inside).count();
    let line = said!(
        "study-seeds",
        "seeds" => seeds,
        "inside" => inside,
        "failedinside" => failed_inside,
        "outside" => seeds - inside,
        "failedoutside" => failed.len() - failed_inside,
        "folder" => out.display().to_string()
    );
    console.print(&format!("{line}\n"));
    if failed.is_empty() {
        return Ok(());
    }
    let page = out.join("stability.md").display().to_string();
    Err(Failure::Study(said!("study-failed", "failed" => failed.len(), "seeds" => seeds, "page" => page)))
}
