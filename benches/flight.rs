//! Free flight: in closed form against steps, and the search for the next touch by leaps that cannot miss one against
//! looks at fixed intervals.

use divan::{Bencher, black_box};
use girderbench::contact::locate;
use girderbench::dynamics::Model;
use girderbench::dynamics::free_flight::flight;
use girderbench::dynamics::free_flight::flight::Flight;
use girderbench::dynamics::integrator::dop853::{Dop853, next_factor};
use girderbench::dynamics::integrator::system::System;
use girderbench::dynamics::locate::advancement::{BoundedGap, FirstZero, first_crossing};
use girderbench::dynamics::locate::root::root;
use girderbench::dynamics::model::coordinates::planar;
use girderbench::dynamics::model::wrench::Wrench;
use girderbench::scene::presets;

#[path = "../tests/support/rows.rs"]
mod rows;

fn main() {
    divan::main();
}

/// (1) for an integrator.
struct Equation(Model);

impl System for Equation {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        planar::slope(&self.0.bodies[0], y, &Wrench::default(), self.0.ground.acceleration(t), out);
    }

    fn size2(&self, d: &[f64]) -> f64 {
        d.iter().map(|x| x * x).sum::<f64>() / (1e-11f64 * 1e-11)
    }
}

fn model() -> Model {
    let scene = presets::load("skew45-abutment").unwrap_or_else(|errors| panic!("{errors}"));
    Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A girder's free motion at 1000 instants in 10 s, in closed form.
#[divan::bench]
fn in_closed_form(bencher: Bencher<'_, '_>) {
    let model = model();
    let system = flight::FreeMotion::new(&model.bodies[0], &model.ground, 10.0);
    let flight = system.fly(0.0, [0.0; 6]);
    bencher.bench(|| (0..1000).map(|i| black_box(system.state(&flight, f64::from(i) * 0.01))[0]).fold(0.0, f64::max));
}

/// The same by an eighth-order integrator with a continuous answer, at 1e-11 m a step.
#[divan::bench]
fn in_steps(bencher: Bencher<'_, '_>) {
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

/// A flight of the skewed girder before its wall from rest, and the gap of its first contact.
struct Case {
    model: Model,
    system: flight::FreeMotion,
    flight: Flight,
}

impl Case {
    fn new(model: Model) -> Self {
        let system = flight::FreeMotion::new(&model.bodies[0], &model.ground, model.duration);
        let mut flight = system.fly(0.0, [0.0; 6]);
        system.remember(&mut flight, model.duration);
        Self { model, system, flight }
    }

    fn sine() -> Self {
        Self::new(model())
    }

    fn record() -> Self {
        Self::new(Model::compile(&rows::record(8000, 1e-9)).unwrap_or_else(|errors| panic!("{errors}")))
    }

    /// The gap and its rate, and what the motion can do from there.
    fn look(&self, t: f64) -> BoundedGap {
        let (state, bound) = self.system.state_and_bounds(&self.flight, t, 1.0);
        let (site, body) = (&self.model.sites[0], &self.model.bodies[0]);
        let wall = girderbench::contact::Frame::fixed(site.fixed);
        let here = locate(&site.geometry, &body.planar_frame(&state), &wall);
        let curvature = bound.acceleration + (bound.spin_rate + bound.spin * bound.spin) * body.radius;
        BoundedGap { gap: here.gap, rate: here.gap_rate, curvature, window: bound.window, out_of_reach: false }
    }
}

/// The first touch by leaps.
#[divan::bench(args = ["sine", "record"])]
fn touch_by_leaps(bencher: Bencher<'_, '_>, ground: &str) {
    let case = if ground == "sine" { Case::sine() } else { Case::record() };
    bencher.bench(|| {
        let found = first_crossing(|t| case.look(t), 0.0, 20.0, true, 1e-16);
        assert!(matches!(found, FirstZero::Crossing(_)), "it touches: {found:?}");
        found
    });
}

/// The first touch by a look every millisecond (or every sample of the record), closed in on where the sign changes; a
/// shorter dip would go unseen.
#[divan::bench(args = ["sine", "record"])]
fn touch_by_looks_at_fixed_intervals(bencher: Bencher<'_, '_>, ground: &str) {
    let (case, dt) = if ground == "sine" { (Case::sine(), 1e-3) } else { (Case::record(), 5e-3) };
    bencher.bench(|| {
        let mut number = 0u32;
        while case.look(f64::from(number + 1) * dt).gap > 0.0 {
            number += 1;
        }
        root(|t| -case.look(t).gap, f64::from(number) * dt, f64::from(number + 1) * dt)
    });
}

/// One root to the last bit.
#[divan::bench]
fn one_root(bencher: Bencher<'_, '_>) {
    bencher.bench(|| root(|t| black_box(t).sin() - 0.5, 0.0, 1.0));
}
