//! Stress by seeded random scenes: every answer is put to checks that hold whatever the scene (each in [`check`]).
//!
//! A seed is a scene of a family that looks for trouble in one place. A failure keeps its seed, which repeats it, and is
//! shrunk to a small scene that fails in the same check.

pub mod check;
pub mod dice;
mod examine;
pub mod family;
mod parts;
mod report;
mod shrink;
mod watch;

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

pub use check::{Check, Complaint, Figures};
pub use examine::{Examined, Outcome, examine};
pub use report::{csv, markdown};
pub use watch::Clock;

use crate::scene::{Kind, Scene};

/// What to examine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked {
    /// First seed.
    pub from: u64,
    /// How many.
    pub seeds: u64,
    /// How many at once.
    pub threads: usize,
    /// Longest that the runs of one seed may take \[s\].
    pub patience: f64,
}

/// What came out for a seed.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The seed.
    pub seed: u64,
    /// Its family.
    pub family: &'static str,
    /// Planar or spatial.
    pub kind: Kind,
    /// How many girders.
    pub girders: usize,
    /// How long its scene lasts \[s\].
    pub duration: f64,
    /// Its tolerance.
    pub tolerance: f64,
    /// Outcome and figures.
    pub examined: Examined,
    /// Where it failed: a small scene that fails in the same check.
    pub small: Option<Scene>,
    /// What its runs and checks took, shrinking apart \[s\].
    pub seconds: f64,
}

/// Examines one seed, and shrinks its scene where it fails.
pub fn seed(seed: u64, clock: Clock<'_>, patience: f64) -> Verdict {
    let (family, scene) = family::scene(seed);
    let started = clock();
    let examined = examine(&scene, clock, patience);
    let seconds = clock() - started;
    let small = match &examined.outcome {
        Outcome::Failed(complaints) => complaints.first().map(|complaint| {
            let mut failing = scene.clone();
            failing.solver.tolerance = complaint.tolerance.unwrap_or(scene.solver.tolerance);
            shrink::shrink(&failing, complaint.check, clock, patience)
        }),
        _ => None,
    };
    Verdict {
        seed,
        family,
        kind: scene.kind,
        girders: scene.girders.len(),
        duration: scene.duration,
        tolerance: scene.solver.tolerance,
        examined,
        small,
        seconds,
    }
}

/// Examines what was asked for, in the order of the seeds whoever does them; `told` hears of each.
pub fn run(asked: &Asked, clock: Clock<'_>, told: &(dyn Fn(&Verdict) + Sync)) -> Vec<Verdict> {
    let seeds: Vec<u64> = (0..asked.seeds).map(|number| asked.from.wrapping_add(number)).collect();
    run_seeds(&seeds, asked.threads, asked.patience, clock, told)
}

/// The same for any seeds.
pub fn run_seeds(
    seeds: &[u64],
    threads: usize,
    patience: f64,
    clock: Clock<'_>,
    told: &(dyn Fn(&Verdict) + Sync),
) -> Vec<Verdict> {
    let next = AtomicUsize::new(0);
    let verdicts = Mutex::new(Vec::new());
    // Threads of their own: one of a pool that waits for a part of its run would take up another seed meanwhile, and
    // that seed's time would count as its own.
    std::thread::scope(|scope| {
        for _ in 0..threads.max(1) {
            scope.spawn(|| {
                loop {
                    let Some(&number) = seeds.get(next.fetch_add(1, Ordering::Relaxed)) else { return };
                    let verdict = seed(number, clock, patience);
                    told(&verdict);
                    if let Ok(mut all) = verdicts.lock() {
                        all.push(verdict);
                    }
                }
            });
        }
    });
    let mut verdicts = verdicts.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    verdicts.sort_by_key(|verdict| verdict.seed);
    verdicts
}

impl Verdict {
    /// Whether a check failed.
    pub fn failed(&self) -> bool {
        matches!(self.examined.outcome, Outcome::Failed(_))
    }

    /// Complaints, if there are any.
    pub fn complaints(&self) -> &[Complaint] {
        match &self.examined.outcome {
            Outcome::Failed(complaints) => complaints,
            _ => &[],
        }
    }
}
