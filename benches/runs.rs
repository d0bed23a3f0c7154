//! What a run costs, and what is saved by not doing what a scene does not need. `cargo bench --no-default-features`;
//! compare figures of one run with each other.

use divan::{Bencher, black_box};
use girderbench::scene::{Scene, presets};
use girderbench::sim::{ErrorEstimate, History};

fn main() {
    divan::main();
}

fn preset(name: &str) -> Scene {
    presets::load(name).unwrap_or_else(|errors| panic!("{errors}"))
}

/// Whole runs, scene to history.
#[divan::bench(args = presets::all().iter().map(|p| p.name))]
fn run(bencher: Bencher<'_, '_>, name: &str) {
    let scene = preset(name);
    bencher.bench(|| History::of(black_box(&scene)));
}

/// The same run at several tolerances; `tests/core/physics/reference.rs` shows what they are worth.
#[divan::bench(args = [1e-6, 1e-8, 1e-10, 1e-12])]
fn tolerance(bencher: Bencher<'_, '_>, tolerance: f64) {
    let mut scene = preset("skew45-abutment");
    scene.solver.tolerance = tolerance;
    bencher.bench(|| History::of(black_box(&scene)));
}

/// Ten seconds in which nothing can touch: flight in closed form, one look ahead.
#[divan::bench]
fn out_of_reach(bencher: Bencher<'_, '_>) {
    let mut scene = preset("skew45-abutment");
    scene.abutments[0].gap = Some(1.0);
    bencher.bench(|| History::of(black_box(&scene)));
}

/// The energy ledger, which a run does not keep unless it is asked.
#[divan::bench]
fn ledger_on_request(bencher: Bencher<'_, '_>) {
    let scene = preset("skew45-abutment");
    bencher
        .with_inputs(|| History::of(&scene).unwrap_or_else(|errors| panic!("{errors}")))
        .bench_refs(|history| history.energy().ledger(10.0));
}

/// The same, and the ledger kept with every run whether anybody asks or not.
#[divan::bench]
fn run_with_ledger_always(bencher: Bencher<'_, '_>) {
    let scene = preset("skew45-abutment");
    bencher.bench(|| History::of(&scene).map(|history| history.energy().ledger(10.0)));
}

/// Touches and their peak forces, which a run does not look for unless it is asked.
#[divan::bench]
fn touches_on_request(bencher: Bencher<'_, '_>) {
    let scene = preset("skew45-abutment");
    bencher
        .with_inputs(|| History::of(&scene).unwrap_or_else(|errors| panic!("{errors}")))
        .bench_refs(|history| history.hits().touches().len());
}

/// The estimate of a run's error, which is another run.
#[divan::bench]
fn error_estimate_on_request(bencher: Bencher<'_, '_>) {
    let scene = preset("skew45-abutment");
    bencher
        .with_inputs(|| History::of(&scene).unwrap_or_else(|errors| panic!("{errors}")))
        .bench_refs(|history| ErrorEstimate::of(history));
}

/// One hit: a free girder against a wall.
#[divan::bench]
fn one_hit(bencher: Bencher<'_, '_>) {
    let scene = preset("flush-free-hit");
    bencher.bench(|| History::of(black_box(&scene)));
}
