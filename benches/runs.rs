//! What a run costs, and what is saved by not doing what a scene does not need. `cargo bench --no-default-features`;
//! compare figures of one run with each other.

use divan::{Bencher, black_box};
use girderbench::dynamics::Model;
use girderbench::dynamics::body_state::{Wrench, planar_slope};
use girderbench::dynamics::dop853::{Dop853, System, next_factor};
use girderbench::dynamics::flight;
use girderbench::scene::{Scene, presets};
use girderbench::sim::History;

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

/// The same run at several tolerances; `tests/reference.rs` shows what they are worth.
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
        .bench_refs(|history| history.ledger(10.0));
}

/// (1) for an integrator.
struct Equation(Model);

impl System for Equation {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        planar_slope(&self.0.bodies[0], y, &Wrench::default(), self.0.ground.acceleration(t), out);
    }

    fn size2(&self, d: &[f64]) -> f64 {
        d.iter().map(|x| x * x).sum::<f64>() / (1e-11f64 * 1e-11)
    }
}

fn model() -> Model {
    Model::compile(&preset("skew45-abutment")).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A girder's free motion at 1000 instants in 10 s, in closed form.
#[divan::bench]
fn flight_in_closed_form(bencher: Bencher<'_, '_>) {
    let model = model();
    let system = flight::System::new(&model.bodies[0], &model.ground, 10.0);
    let flight = system.fly(0.0, [0.0; 6]);
    bencher.bench(|| (0..1000).map(|i| black_box(system.state(&flight, f64::from(i) * 0.01))[0]).fold(0.0, f64::max));
}

/// The same by an eighth-order integrator with a continuous answer, at 1e-11 m a step.
#[divan::bench]
fn flight_in_steps(bencher: Bencher<'_, '_>) {
    let model = model();
    bencher.bench(|| {
        let (mut equation, mut rk) = (Equation(model.clone()), Dop853::default());
        let (mut y, mut t, mut h, mut next, mut most) = (vec![0.0; 6], 0.0, 1e-3, 0u32, 0.0f64);
        rk.resize(6);
        rk.start(&mut equation, t, &y);
        while t < 10.0 {
            let error = rk.attempt(&mut equation, t, &y, h);
            if error <= 1.0 {
                let dense = rk.accept(&mut equation, t, &mut y, h);
                t += h;
                while f64::from(next) * 0.01 <= t && next < 1000 {
                    let mut state = [0.0; 6];
                    dense.read(0..6, f64::from(next) * 0.01, &mut state);
                    most = most.max(black_box(state)[0]);
                    next += 1;
                }
            }
            h *= next_factor(error);
        }
        most
    });
}
