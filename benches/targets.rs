//! The run times that are asked for, as medians on one core, each with how far its answer is from one at a far tighter
//! tolerance. `cargo bench --no-default-features --bench targets [PROBLEM]`; pin it to a core (`taskset -c 0`).
//!
//! Processor time of the one thread that computes, where the system tells it (Linux); wall-clock time elsewhere. The
//! set-up of the scene (validation, compiling) is in it.

#![expect(clippy::print_stdout, reason = "a bench prints its figures")]
#![expect(clippy::disallowed_methods, reason = "a bench is what clocks are for")]

#[path = "../tests/support/rows.rs"]
mod rows;

use std::time::Instant;

use girderbench::scene::{Component, Degree, ModelKind, Motion, RecordMotion, Scene, presets};
use girderbench::sim::{Comparison, History};
use girderbench::study::accuracy::problem;
use rows::Row;

/// A problem: what it is called, how often it is run for one figure, what time and what distance are asked for, a
/// coarse tolerance that reaches the distance with room (`TOLERANCE=1e-9` sets another for all), and the scene at a tolerance.
struct Problem {
    name: &'static str,
    repeats: u32,
    asked_ms: f64,
    asked_m: f64,
    tolerance: f64,
    scene: fn(f64) -> Scene,
}

/// Figures of which the median is taken.
const FIGURES: usize = 7;

const PROBLEMS: &[Problem] = &[
    Problem { name: "P1", repeats: 60, asked_ms: 1.0, asked_m: 1e-9, tolerance: 5e-7, scene: rows::p1 },
    Problem { name: "P3", repeats: 200, asked_ms: 0.2, asked_m: 1e-9, tolerance: 1e-9, scene: p3 },
    Problem { name: "P2", repeats: 60, asked_ms: 2.0, asked_m: 1e-8, tolerance: 4e-6, scene: rows::p2 },
    Problem { name: "skew45", repeats: 60, asked_ms: 2.0, asked_m: 1e-8, tolerance: 2e-6, scene: skew45 },
    Problem {
        name: "record-4000",
        repeats: 20,
        asked_ms: 5.0,
        asked_m: 1e-8,
        tolerance: 4e-6,
        scene: |e| rows::record(4000, e),
    },
    Problem {
        name: "record-8000",
        repeats: 20,
        asked_ms: 5.0,
        asked_m: 1e-8,
        tolerance: 4e-6,
        scene: |e| rows::record(8000, e),
    },
    Problem { name: "record-turned", repeats: 20, asked_ms: 6.0, asked_m: 1e-8, tolerance: 4e-6, scene: turned },
    // The same ground as two components: at most one and a half times the time.
    Problem { name: "record-two", repeats: 20, asked_ms: 9.0, asked_m: 1e-8, tolerance: 4e-6, scene: two },
    // A millionth of its peak displacement, 0.299 m.
    Problem { name: "deck-30m", repeats: 1, asked_ms: 20.0, asked_m: 2.99e-7, tolerance: 2e-4, scene: deck },
    // A thousand times faster than it happens, at a millionth of its peak displacement, 74.9 mm.
    Problem { name: "span-as-built", repeats: 1, asked_ms: 40.0, asked_m: 7.5e-8, tolerance: 2.5e-7, scene: as_built },
    Problem { name: "row-1", repeats: 40, asked_ms: 100.0, asked_m: 1e-8, tolerance: 1.5e-6, scene: |e| many(1, e) },
    Problem { name: "row-10", repeats: 40, asked_ms: 100.0, asked_m: 1e-8, tolerance: 1.5e-6, scene: |e| many(10, e) },
    Problem { name: "row-100", repeats: 4, asked_ms: 100.0, asked_m: 1e-8, tolerance: 1.5e-6, scene: |e| many(100, e) },
    Problem {
        name: "row-1000",
        repeats: 1,
        asked_ms: 100.0,
        asked_m: 1e-8,
        tolerance: 1.5e-6,
        scene: |e| many(1000, e),
    },
    Problem { name: "few-3", repeats: 40, asked_ms: 100.0, asked_m: 1e-8, tolerance: 1.5e-6, scene: |e| few(3, e) },
    Problem {
        name: "few-1000",
        repeats: 1,
        asked_ms: 100.0,
        asked_m: 1e-8,
        tolerance: 1.5e-6,
        scene: |e| few(1000, e),
    },
    // Girders that bend, as many polynomials as their contacts need, and the same rigid: below ten times as much, each at a
    // millionth of its peak displacement, 18 and 211 mm.
    Problem { name: "F1", repeats: 20, asked_ms: 10.0, asked_m: 1.8e-8, tolerance: 1e-5, scene: |e| bars("F1", e) },
    Problem {
        name: "F1-rigid",
        repeats: 200,
        asked_ms: 1.0,
        asked_m: 1.8e-8,
        tolerance: 1e-5,
        scene: |e| rigid("F1", e),
    },
    Problem { name: "F2", repeats: 4, asked_ms: 10.0, asked_m: 2.1e-7, tolerance: 1e-4, scene: |e| bars("F2", e) },
    Problem {
        name: "F2-rigid",
        repeats: 100,
        asked_ms: 1.0,
        asked_m: 2.1e-7,
        tolerance: 1e-4,
        scene: |e| rigid("F2", e),
    },
    // The same deck at 60°, where it slips and turns.
    Problem { name: "F4", repeats: 4, asked_ms: 10.0, asked_m: 2.1e-7, tolerance: 1e-4, scene: skewed },
    Problem { name: "F4-rigid", repeats: 100, asked_ms: 1.0, asked_m: 2.1e-7, tolerance: 1e-4, scene: skewed_rigid },
];

/// A problem of the accuracy study with as many polynomials as its contacts need.
fn bars(name: &str, tolerance: f64) -> Scene {
    let problem = problem::get(name).expect("a problem");
    let mut scene = problem.scene().unwrap_or_else(|errors| panic!("{errors}"));
    scene.solver.tolerance = tolerance;
    for elastic in scene.girders.iter_mut().filter_map(|girder| girder.elastic.as_mut()) {
        elastic.modes = Degree(None);
    }
    scene
}

fn without_elastic(mut scene: Scene) -> Scene {
    scene.girders.iter_mut().for_each(|girder| girder.elastic = None);
    scene
}

fn rigid(name: &str, tolerance: f64) -> Scene {
    without_elastic(bars(name, tolerance))
}

fn skewed(tolerance: f64) -> Scene {
    preset("deck-30m-elastic", tolerance)
}

fn skewed_rigid(tolerance: f64) -> Scene {
    without_elastic(skewed(tolerance))
}

/// A record along −atan(0.6 / 0.8), where the girder hits its wall.
fn turned(tolerance: f64) -> Scene {
    let mut scene = rows::record(4000, tolerance);
    if let Motion::Record(record) = &mut scene.motion {
        record.angle_deg = -0.6_f64.atan2(0.8).to_degrees();
    }
    scene
}

/// The same ground as two components, 0.8 and 0.6 of the record.
fn two(tolerance: f64) -> Scene {
    let mut scene = rows::record(4000, tolerance);
    if let Motion::Record(record) = &mut scene.motion {
        let part = |azimuth: f64, scale: f64| Component {
            samples: record.samples.clone(),
            dt: record.dt,
            azimuth_deg: Some(azimuth),
            scale,
            ..Component::default()
        };
        let components = vec![part(90.0, 0.8), part(180.0, 0.6)];
        *record = RecordMotion { components, x_azimuth_deg: Some(90.0), ..RecordMotion::default() };
    }
    scene
}

fn many(count: usize, tolerance: f64) -> Scene {
    Row { tolerance, ..Row::many(count) }.scene()
}

fn few(count: usize, tolerance: f64) -> Scene {
    Row { tolerance, ..Row::few(count) }.scene()
}

/// P1 with an instantaneous restitution of 0.4: the impact model.
fn p3(tolerance: f64) -> Scene {
    let mut scene = rows::p1(tolerance);
    scene.model.kind = ModelKind::Impact;
    scene
}

fn preset(name: &str, tolerance: f64) -> Scene {
    let mut scene = presets::load(name).unwrap_or_else(|errors| panic!("{errors}"));
    scene.solver.tolerance = tolerance;
    scene
}

fn skew45(tolerance: f64) -> Scene {
    preset("skew45-abutment", tolerance)
}

/// On lead rubber, with restrainers, backfill and seats, under two components.
fn as_built(tolerance: f64) -> Scene {
    preset("span-as-built", tolerance)
}

fn deck(tolerance: f64) -> Scene {
    preset("deck-30m", tolerance)
}

/// Processor time of this thread \[s\], or the time of day.
fn clock(start: Instant) -> f64 {
    let own = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = own.and_then(|text| text.split(' ').next().and_then(|n| n.parse::<f64>().ok()));
    nanoseconds.map_or(start.elapsed().as_secs_f64(), |n| n * 1e-9)
}

fn run(scene: &Scene) -> History {
    History::of(scene).unwrap_or_else(|errors| panic!("{errors}"))
}

fn main() {
    // One thread, whatever the machine has.
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let _ = one.map(|pool| pool.install(all));
}

fn all() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    println!(
        "{:<12} {:>10} {:>12} {:>10} {:>12} {:>10} {:>8} {:>8} {:>9} {:>8}",
        "problem", "tolerance", "median ms", "asked", "distance m", "asked", "events", "searches", "looks", "steps"
    );
    for problem in PROBLEMS {
        if wanted.is_empty() || wanted.iter().any(|w| w == problem.name) {
            measure(problem);
        }
    }
}

fn measure(problem: &Problem) {
    let tolerance = std::env::var("TOLERANCE").ok().and_then(|t| t.parse().ok()).unwrap_or(problem.tolerance);
    let scene = (problem.scene)(tolerance);
    // The system counts processor time in ticks of some milliseconds: several runs for one figure.
    let (mut times, zero) = (Vec::new(), Instant::now());
    for _ in 0..FIGURES {
        let start = clock(zero);
        for _ in 0..problem.repeats {
            std::hint::black_box(run(&scene));
        }
        times.push((clock(zero) - start) * 1e3 / f64::from(problem.repeats));
    }
    times.sort_by(f64::total_cmp);
    let history = run(&scene);
    let finer = run(&(problem.scene)(1e-13));
    let (median, apart) = (times[times.len() / 2], Comparison::of(&history, &finer).of_all().place);
    let effort = history.effort();
    println!(
        "{:<12} {tolerance:>10.1e} {median:>12.3} {:>10} {apart:>12.2e} {:>10.2e} {:>8} {:>8} {:>9} {:>8}",
        problem.name,
        problem.asked_ms,
        problem.asked_m,
        history.events().len(),
        effort.searches,
        effort.looks,
        effort.steps
    );
}
