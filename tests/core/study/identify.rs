//! Identification recovers known oscillators from noisy histories, and its intervals hold the truth as often as they state.

use std::f64::consts::TAU;

use girderbench::identify::{Given, History, Identified, SteadyResponse, from_history, from_response};
use girderbench::motion::oscillator::{Shaking, forced, free};
use girderbench::motion::sweep::{Rate, Sweep};
use girderbench::motion::synthetic::Earthquake;
use girderbench::scene::{Motion, SweepMotion, presets};

use crate::support::run;

/// Histories of each kind.
const SEEDS: u64 = 200;
/// How many of 200 intervals of 95 % hold the truth but for one time in a thousand on either side: of the binomial
/// distribution, P(179 or fewer) = 0.0011 and P(199 or more) = 0.0004 (200 of 200: 3.5e-5).
const HELD: std::ops::RangeInclusive<usize> = 180..=198;

/// Numbers of a seed: Knuth's linear congruence.
struct Numbers(u64);

impl Numbers {
    fn of(seed: u64) -> Self {
        let mut numbers = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        let _first_ones = [0; 8].map(|_| numbers.uniform());
        numbers
    }

    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// Of mean 0 and deviation 1 (Box and Muller).
    fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.uniform(), self.uniform());
        (-2.0 * u.ln()).sqrt() * (TAU * v).cos()
    }

    /// Noise of deviation `s`, correlated by `rho` from sample to sample.
    fn noise(&mut self, s: f64, rho: f64, count: usize) -> Vec<f64> {
        let mut e = s * self.normal();
        let mut next = || {
            e = rho * e + s * (1.0 - rho * rho).sqrt() * self.normal();
            e
        };
        (0..count).map(|_| next()).collect()
    }
}

fn times(count: u32, interval: f64) -> Vec<f64> {
    (0..count).map(|n| interval * f64::from(n)).collect()
}

fn earthquake(seed: u64) -> Shaking {
    let quake = Earthquake {
        seed,
        duration: 12.0,
        dt: 0.01,
        peak: 3.0,
        ground: TAU * 2.5,
        damping: 0.6,
        rise: 1.0,
        until: 6.0,
        decay: 0.3,
    };
    Shaking::Samples { dt: quake.dt, values: quake.samples() }
}

/// Whether the intervals of f and h hold the truth.
fn holds(found: &Identified, [f, h]: [f64; 2]) -> [bool; 2] {
    [(&found.frequency, f), (&found.damping, h)].map(|(e, truth)| (e.value - truth).abs() <= e.half_width)
}

/// Of 200 seeds, how many intervals of f and of h hold the truth.
#[expect(clippy::print_stdout, reason = "shown when a test fails, or with --nocapture")]
fn held(what: &str, one: impl Fn(u64, &mut Numbers) -> [bool; 2]) {
    let mut count = [0; 2];
    for seed in 1..=SEEDS {
        let held = one(seed, &mut Numbers::of(seed));
        (0..2).for_each(|i| count[i] += usize::from(held[i]));
    }
    println!("{what}: of {SEEDS} intervals {count:?} hold f and h");
    assert!(count.iter().all(|count| HELD.contains(count)), "{what}: {count:?}, not within {HELD:?}");
}

#[test]
fn intervals_of_free_decays_hold_the_truth_19_times_in_20() {
    decays("decay, independent noise", 0.0);
}

#[test]
fn intervals_under_correlated_noise_hold_the_truth_19_times_in_20() {
    decays("decay, correlated noise", 0.8);
}

fn decays(what: &str, rho: f64) {
    held(what, |_, numbers| {
        let truth = [numbers.between(1.5, 4.0), numbers.between(0.02, 0.3)];
        let times = times(300, 0.01);
        let [placed, _] = free([TAU * truth[0], truth[1]], &times);
        let noise = numbers.noise(2e-4, rho, times.len());
        let x: Vec<f64> = placed.iter().zip(noise).map(|(x, e)| 0.01 * x + 0.003 + e).collect();
        let history = History { times: &times, x: &x, shaking: &Shaking::Still, scaled: false };
        holds(&from_history(&history, Given::default()).expect("identified"), truth)
    });
}

#[test]
fn intervals_under_earthquakes_hold_the_truth_19_times_in_20() {
    held("earthquake, of a ground known but for a factor", |seed, numbers| {
        let truth = [numbers.between(1.5, 4.0), numbers.between(0.02, 0.3)];
        let (shaking, times) = (earthquake(seed), times(360, 1.0 / 30.0));
        let answer = forced(&shaking, [TAU * truth[0], truth[1]], &times);
        let noise = numbers.noise(5e-4, 0.5, times.len());
        let x: Vec<f64> = answer.iter().zip(noise).map(|(x, e)| 1.1 * x + e).collect();
        let history = History { times: &times, x: &x, shaking: &shaking, scaled: true };
        let found = from_history(&history, Given::default()).expect("identified");
        assert!((found.others[3].value - 1.1).abs() < 0.1, "the factor: {:?}", found.others[3]);
        holds(&found, truth)
    });
}

#[test]
fn intervals_of_steady_responses_hold_the_truth_19_times_in_20() {
    held("steady response", |_, numbers| {
        let truth = [numbers.between(2.0, 4.0), numbers.between(0.03, 0.3)];
        let omega = TAU * truth[0];
        let frequencies: Vec<f64> = (0..71).map(|n| 1.0 + 0.1 * f64::from(n)).collect();
        let gain = |f: &f64| {
            let drive = TAU * f;
            0.5 / (omega * omega - drive * drive).hypot(2.0 * truth[1] * omega * drive)
        };
        let amplitudes: Vec<f64> = frequencies.iter().map(|f| gain(f) + 1e-5 * numbers.normal()).collect();
        let ground = Some(0.5).filter(|_| numbers.uniform() < 0.5);
        let response = SteadyResponse { frequencies: &frequencies, amplitudes: &amplitudes, ground };
        holds(&from_response(&response, Given::default()).expect("identified"), truth)
    });
}

#[test]
fn exact_histories_are_recovered_to_rounding() {
    let times = times(900, 0.01);
    let sweep = Sweep { amplitude: 0.5, from: 1.0, to: 8.0, length: 10.0, rate: Rate::Linear };
    let sweep = Shaking::Samples { dt: sweep.interval(), values: sweep.samples(100_000) };
    let sine = Shaking::Sine { amplitude: 2.0, quadrature: 0.0, omega: TAU * 2.4, phase: 0.3 };
    for truth in [[2.4, 0.29], [3.8, 0.25], [0.7, 0.01], [9.0, 0.05]] {
        for (shaking, given) in [(&sweep, None), (&sine, None), (&sine, Some(truth[0])), (&earthquake(3), None)] {
            let answer = forced(shaking, [TAU * truth[0], truth[1]], &times);
            let history = History { times: &times, x: &answer, shaking, scaled: false };
            let found = from_history(&history, Given { frequency: given }).expect("identified");
            let off = [found.frequency.value / truth[0] - 1.0, found.damping.value / truth[1] - 1.0];
            assert!(off.iter().all(|off| off.abs() < 1e-8), "{truth:?}: off by {off:?}");
            assert!(found.frequency.half_width < 1e-7, "{truth:?}: {:?}", found.frequency);
        }
    }
}

#[test]
fn the_programs_own_noisy_runs_are_recovered() {
    for (seed, preset) in (1..).zip(["straight-abutment", "skew60-abutment", "skew45-abutment"]) {
        let mut scene = presets::load(preset).expect("a preset");
        scene.abutments[0].gap = Some(0.2);
        (scene.duration, scene.motion) = (20.0, Motion::Sweep(SweepMotion { length: 20.0, ..SweepMotion::default() }));
        let history = run(&scene);
        let mut numbers = Numbers::of(seed);
        let times = times(600, 1.0 / 30.0);
        let x: Vec<f64> =
            times.iter().map(|t| history.motion(0, *t).displacement.x + 1e-5 * numbers.normal()).collect();
        let shaking = Shaking::along(&history.model().ground, glam::DVec3::X);
        let measured = History { times: &times, x: &x, shaking: &shaking, scaled: false };
        let found = from_history(&measured, Given::default()).expect("identified");
        let truth = if preset == "straight-abutment" { [2.4, 0.29] } else { [2.6, 0.28] };
        let off = [found.frequency.value - truth[0], found.damping.value - truth[1]];
        // 3.5 standard deviations: five intervals in ten thousand miss by more.
        let wide = 3.5 / 1.96;
        let within =
            off[0].abs() <= wide * found.frequency.half_width && off[1].abs() <= wide * found.damping.half_width;
        assert!(within, "{preset}: {:?} {:?}", found.frequency, found.damping);
        assert!(found.frequency.half_width < 0.02 && found.unexplained < 0.05, "{preset}: it is sharp");
    }
}
