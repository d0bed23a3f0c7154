//! Stress by seeded random scenes: every answer is put to checks that hold whatever the scene (each in [`check`]).
//!
//! A seed is a scene of a family that looks for trouble in one place. Outside the domain of the program
//! ([`crate::scene::domain`]) a scene is only to end well. A failure keeps its seed, which repeats it, and is
//! shrunk to a small scene that fails in the same check.

pub mod check;
mod examine;
pub mod family;
mod parts;
pub mod random;
mod report;
mod shrink;
mod watch;

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

pub use check::{Check, Complaint, Figures};
pub use examine::{Examined, Outcome, examine};
pub use report::{csv, markdown};
pub use watch::{Clock, Limits};

use crate::scene::domain::is_inside;
use crate::scene::{Kind, Scene};

/// Seeds to examine, and limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked {
    /// First seed.
    pub from: u64,
    /// Number of seeds.
    pub seeds: u64,
    /// Whether to pass over seeds whose scenes lie outside the domain.
    pub inside: bool,
    /// Number of threads.
    pub threads: usize,
    /// Limits of the runs of one seed.
    pub limits: Limits,
}

/// Outcome for a seed.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The seed.
    pub seed: u64,
    /// Its family.
    pub family: &'static str,
    /// Planar or spatial.
    pub kind: Kind,
    /// Number of girders.
    pub girders: usize,
    /// Duration of its scene \[s\]; the examined part is shorter where very many events occur.
    pub duration: f64,
    /// Its tolerance.
    pub tolerance: f64,
    /// Whether its scene lies inside the domain; if not, it is only to end well.
    pub inside: bool,
    /// Outcome and figures.
    pub examined: Examined,
    /// A small scene that fails in the same check, of a seed that failed.
    pub small: Option<Scene>,
    /// Time of its runs and checks, without shrinking \[s\].
    pub seconds: f64,
}

/// Examines one seed, and shrinks its scene where it fails. A run of the family of hours lasts an hour, whatever the number of its events.
pub fn seed(seed: u64, clock: Clock<'_>, limits: Limits) -> Verdict {
    let (family, scene) = family::scene(seed);
    let events = if family == family::HOURS { usize::MAX } else { limits.events };
    let limits = Limits { events, ..limits };
    let started = clock();
    let examined = examine(&scene, clock, limits);
    let seconds = clock() - started;
    let small = match &examined.outcome {
        Outcome::Failed(complaints) => complaints.first().map(|complaint| {
            let mut failing = scene.clone();
            failing.solver.tolerance = complaint.tolerance.unwrap_or(scene.solver.tolerance);
            shrink::shrink(&failing, complaint.check, clock, limits)
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
        inside: is_inside(&scene),
        examined,
        small,
        seconds,
    }
}

/// Examines what was asked for, in the order of the seeds whoever does them; `told` hears of each.
pub fn run(asked: &Asked, clock: Clock<'_>, told: &(dyn Fn(&Verdict) + Sync)) -> Vec<Verdict> {
    let seeds: Vec<u64> = seeds(asked);
    run_seeds(&seeds, asked.threads, asked.limits, clock, told)
}

/// The seeds that are asked for, from the first one on.
pub fn seeds(asked: &Asked) -> Vec<u64> {
    // None comes up twice, and there is an end where a domain has no seed at all.
    let all = (0..=u64::from(u32::MAX)).map(|number| asked.from.wrapping_add(number));
    let wanted = usize::try_from(asked.seeds).unwrap_or(usize::MAX);
    all.filter(|&seed| !asked.inside || is_inside(&family::scene(seed).1)).take(wanted).collect()
}

/// Examines any seeds.
pub fn run_seeds(
    seeds: &[u64],
    threads: usize,
    limits: Limits,
    clock: Clock<'_>,
    told: &(dyn Fn(&Verdict) + Sync),
) -> Vec<Verdict> {
    let next = AtomicUsize::new(0);
    let verdicts = Mutex::new(Vec::new());
    // Each thread is a pool of its own, so that the clock of a thread sees all that its seed does and nothing else.
    let alone = || rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let work = || {
        while let Some(&number) = seeds.get(next.fetch_add(1, Ordering::Relaxed)) {
            let verdict = seed(number, clock, limits);
            told(&verdict);
            if let Ok(mut all) = verdicts.lock() {
                all.push(verdict);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..threads.max(1) {
            scope.spawn(|| match alone() {
                Ok(pool) => pool.install(work),
                // No thread is left: this one does it, and groups of bodies ask the common pool.
                Err(_) => work(),
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

    /// Whether only the beginning of its scene was examined, for its many events.
    pub fn cut(&self) -> bool {
        self.examined.until < self.duration
    }

    /// Complaints, if there are any.
    pub fn complaints(&self) -> &[Complaint] {
        match &self.examined.outcome {
            Outcome::Failed(complaints) => complaints,
            _ => &[],
        }
    }
}
