//! Flights of a small block against integration, their bounds, and their work.

use glam::DVec3;
use nalgebra::{DMatrix, DVector};

use super::{FlightParameters, LineOrSine, LinearMotion, PowerForm, Spectrum};
use crate::motion::Ground;

const SIZE: usize = 4;
const LOAD: [f64; SIZE] = [0.3, -0.2, 0.1, 0.05];
const BY_X: [f64; SIZE] = [-1.0, 0.0, 0.0, 0.0];
const BY_Y: [f64; SIZE] = [0.0, -1.0, 0.0, 0.0];
const PLACES: [f64; SIZE] = [0.02, -0.01, 0.03, 0.004];
const SPEEDS: [f64; SIZE] = [0.1, 0.2, -0.15, 0.6];

/// Three coupled coordinates with a fast one, or, with `free`, the first without bearing.
fn matrices(free: bool) -> [DMatrix<f64>; 2] {
    let rows = DMatrix::from_row_slice(
        SIZE,
        SIZE,
        &[1.0, 0.1, 0.2, 0.3, 0.0, 1.2, -0.3, 0.1, 0.0, 0.0, 2.0, 0.5, 0.0, 0.0, 0.0, 40.0],
    );
    let mut both = [
        rows.transpose() * &rows * 9.0,
        rows.transpose() * DMatrix::from_diagonal(&DVector::from_vec(vec![0.4, 0.7, 0.1, 0.02])) * &rows,
    ];
    if free {
        for matrix in &mut both {
            matrix.row_mut(0).fill(0.0);
            matrix.column_mut(0).fill(0.0);
        }
    }
    both
}

#[test]
fn second_derivatives_of_coefficients_are_not_above_their_bounds() {
    let [stiffness, damping] = matrices(false);
    for ground in grounds() {
        let spectrum = Spectrum::of(&stiffness, &damping).expect("a spectrum");
        let motion = LinearMotion::of(spectrum, &LOAD, [&BY_X, &BY_Y], (&ground, 4.0)).expect("a closed form");
        let numbers = motion.begin(0.013, &PLACES, &SPEEDS);
        let flight = FlightParameters { start: 0.013, numbers: &numbers };
        let at = |t: f64| motion.at(flight, t).all;
        // Stretches that hold a kink of the record, and none.
        for (from, width) in [(0.013, 0.03), (0.02, 0.2), (0.4, 0.012), (1.3, 0.07)] {
            let bounds = motion.second_derivatives(flight, [from, from + width]);
            let mut most = vec![0.0f64; bounds.len()];
            let step = 1e-4;
            for i in 1..200 {
                let t = from + step + (width - 2.0 * step) * f64::from(i) / 200.0;
                let [before, here, after] = [t - step, t, t + step].map(at);
                for (k, most) in most.iter_mut().enumerate() {
                    *most = most.max((before[k] - here[k] * 2.0 + after[k]).norm() / (step * step));
                }
            }
            for (most, bound) in most.iter().zip(&bounds) {
                assert!(*most <= bound * (1.0 + 1e-4) + 1e-7, "{most} of {bound} under {ground:?} from {from}");
                // A kink adds all that it could.
                let kinked = matches!(ground, Ground::Record { .. }) && width > 0.05;
                assert!(kinked || *most > 0.2 * bound, "{most} of {bound} under {ground:?} from {from}: a tight bound");
            }
        }
    }
}

#[test]
fn a_motion_that_only_rounding_holds_is_told_by_what_its_exponentials_leave_at_the_start() {
    let [stiffness, damping] = matrices(false);
    let sound = Spectrum::of(&stiffness, &damping).expect("a spectrum").start_error(2.0);
    // A coordinate that moves with two others only, which are a million times as stiff.
    let row = DMatrix::<f64>::from_row_slice(1, 3, &[1.0, 0.3, -0.2]);
    let mut held = row.transpose() * row;
    (held[(1, 1)], held[(2, 2)]) = (held[(1, 1)] + 1e6, held[(2, 2)] + 2e6);
    let with = |spring: f64| {
        let mut stiffness = held.clone();
        // With the others at rest there is no spring but this one.
        stiffness[(0, 0)] = held[(0, 1)].powi(2) / held[(1, 1)] + held[(0, 2)].powi(2) / held[(2, 2)] + spring;
        Spectrum::of(&stiffness, &DMatrix::zeros(3, 3)).map_or(f64::INFINITY, |spectrum| spectrum.start_error(2.0))
    };
    assert!(sound < 1e-13 && with(1.0) < 1e-12, "{sound} and {}", with(1.0));
    assert!(with(1e-14) > 1e-6, "{}", with(1e-14));
}

fn grounds() -> [Ground; 3] {
    let samples = [0.0, 1.5, -2.0, 0.7, 3.0, -1.0, 0.4, 0.0, -0.8, 2.2, 0.3, 0.0];
    let many = (0..40).map(|n| DVec3::new(samples[n % 12], 0.7 * samples[(n + 5) % 12], 0.0));
    [
        Ground::Still,
        Ground::Sine { amplitude: DVec3::new(2.0, 1.0, 0.0), quadrature: DVec3::ZERO, omega: 9.0, phase: 0.4 },
        Ground::components(0.05, many, []),
    ]
}

fn motion(free: bool, ground: &Ground) -> LinearMotion {
    let [k, c] = matrices(free);
    let spectrum = Spectrum::of(&k, &c).expect("well-conditioned");
    LinearMotion::of(spectrum, &LOAD, [&BY_X, &BY_Y], (ground, 10.0)).expect("no resonance")
}

/// Places, speeds, and the work of the ground on coordinate 0 and 1 and the loss, after `end` \[s\] from `from`.
fn integrated(free: bool, ground: &Ground, [from, end]: [f64; 2]) -> Vec<f64> {
    // Errors of the method of order 4 are then below 1e-10.
    const STEPS: u32 = 8000;
    let [k, c] = matrices(free);
    let slope = |t: f64, y: &DVector<f64>| {
        let (q, v) = (y.rows(0, SIZE), y.rows(SIZE, SIZE));
        let a = ground.acceleration(t);
        let force = DVector::from_fn(SIZE, |i, _| LOAD[i] + BY_X[i] * a.x + BY_Y[i] * a.y);
        let mut out = DVector::zeros(2 * SIZE + 2);
        out.rows_mut(0, SIZE).copy_from(&v);
        out.rows_mut(SIZE, SIZE).copy_from(&(force - &k * q - &c * v));
        out[2 * SIZE] = BY_X[0] * a.x * v[0] + BY_Y[1] * a.y * v[1];
        out[2 * SIZE + 1] = (v.transpose() * &c * v)[(0, 0)];
        out
    };
    let mut y = DVector::from_iterator(2 * SIZE + 2, PLACES.into_iter().chain(SPEEDS).chain([0.0; 2]));
    let mut t = from;
    while t < end {
        let until = end.min(ground.next_kink(t));
        let (h, begin) = ((until - t) / f64::from(STEPS), t);
        for n in 0..STEPS {
            let at = begin + h * f64::from(n);
            // Just inside: at a kink the next piece begins.
            let last = (at + h).min(until.next_down());
            let k1 = slope(at, &y);
            let k2 = slope(at + 0.5 * h, &(&y + &k1 * (0.5 * h)));
            let k3 = slope(at + 0.5 * h, &(&y + &k2 * (0.5 * h)));
            let k4 = slope(last, &(&y + &k3 * h));
            y += (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0);
        }
        t = until;
    }
    y.iter().copied().collect()
}

#[test]
fn flights_agree_with_integration() {
    for free in [false, true] {
        for ground in grounds() {
            let (motion, start) = (motion(free, &ground), 0.13);
            let numbers = motion.begin(start, &PLACES, &SPEEDS);
            for end in [0.13, 0.31, 1.7] {
                let parts = motion.at(FlightParameters { start, numbers: &numbers }, end);
                let (mut places, mut speeds) = ([0.0; SIZE], [0.0; SIZE]);
                motion.read(&parts, 0, &mut places, &mut speeds);
                let (mut place, mut speed) = ([0.0; 2], [0.0; 2]);
                motion.read(&parts, 1, &mut place, &mut speed);
                assert_eq!([&place[..], &speed[..]], [&places[1..3], &speeds[1..3]], "some of them");
                let wanted = integrated(free, &ground, [start, end]);
                for (i, (a, b)) in places.iter().chain(&speeds).zip(&wanted).enumerate() {
                    assert!((a - b).abs() < 2e-9, "free {free}, {ground:?} at {end}: component {i}, {a} against {b}");
                }
            }
        }
    }
}

#[test]
fn work_and_loss_are_the_integrals_of_powers() {
    for ground in grounds() {
        let (motion, start) = (motion(false, &ground), 0.13);
        let numbers = motion.begin(start, &PLACES, &SPEEDS);
        let flight = FlightParameters { start, numbers: &numbers };
        let [_, c] = matrices(false);
        let form = PowerForm::of(&motion, &c).expect("dashpots");
        let (mut t, end, mut work, mut loss) = (start, 0.9, 0.0, 0.0);
        while t < end {
            let until = end.min(ground.next_kink(t));
            let line = |axis: usize| match &ground {
                Ground::Still => LineOrSine::Line(0.0, 0.0),
                Ground::Sine { amplitude, omega, phase, .. } => {
                    LineOrSine::Sine(amplitude[axis], *omega, omega * t + phase)
                }
                Ground::Record { .. } => {
                    let piece = ground.piece(ground.piece_number(t));
                    LineOrSine::Line(piece.acceleration(t)[axis], piece.rate()[axis])
                }
            };
            work += motion.moved_by(flight, &BY_X, [t, until], &line(0))
                + motion.moved_by(flight, &BY_Y, [t, until], &line(1));
            loss += form.work(&motion, flight, [t, until]);
            t = until;
        }
        let wanted = integrated(false, &ground, [start, end]);
        assert!((work - wanted[2 * SIZE]).abs() < 1e-8, "{ground:?}: work {work} against {}", wanted[2 * SIZE]);
        assert!((loss - wanted[2 * SIZE + 1]).abs() < 1e-8, "{ground:?}: loss {loss} against {}", wanted[2 * SIZE + 1]);
    }
}

#[test]
fn coefficients_stay_within_their_bounds() {
    for ground in grounds() {
        let motion = motion(true, &ground);
        let numbers = motion.begin(0.0, &PLACES, &SPEEDS);
        let flight = FlightParameters { start: 0.0, numbers: &numbers };
        for from in [0.0, 0.4] {
            let here = motion.at(flight, from);
            let window = motion.window(0.3);
            for n in 0..=200 {
                let there = motion.at(flight, from + window * f64::from(n) / 200.0);
                for k in 0..there.all.len() {
                    let [most, ..] = motion.largest(&here, k, window);
                    assert!(there.all[k].norm() <= most * (1.0 + 1e-12), "{ground:?}: coefficient {k}");
                }
                let [place, speed, _] = motion.drift_bounds(&here, 0, window);
                let [x, v] = there.drifts[0];
                assert!(x.abs() <= place * (1.0 + 1e-12) && v.abs() <= speed * (1.0 + 1e-12), "{ground:?}: drift");
            }
        }
    }
}

#[test]
fn a_pair_at_critical_damping_and_a_motion_without_a_spring_have_no_sum_of_exponentials() {
    let of = |k: &[f64], c: &[f64]| Spectrum::of(&DMatrix::from_row_slice(2, 2, k), &DMatrix::from_row_slice(2, 2, c));
    assert_eq!(of(&[4.0, 0.0, 0.0, 1.0], &[4.0, 0.0, 0.0, 0.1]), None, "critical");
    assert_eq!(of(&[1.0, 1.0, 1.0, 1.0], &[0.0; 4]), None, "both together move without a spring");
    assert_eq!(of(&[0.0, 0.0, 0.0, 1.0], &[3.0, 0.0, 0.0, 0.1]), None, "a dashpot without a spring");
    let over = of(&[4.0, 0.0, 0.0, 1.0], &[5.0, 0.0, 0.0, 0.1]).expect("overdamped");
    let slow: Vec<f64> = over.exponents.iter().take(2).map(|e| e.re).collect();
    assert!((slow[0] + 1.0).abs() < 1e-15 && (slow[1] + 4.0).abs() < 1e-15, "{slow:?}");
    let free = of(&[0.0, 0.0, 0.0, 1.0], &[0.0; 4]).expect("free");
    assert_eq!((free.drifts, free.exponents.len()), (vec![0], 1), "one drifts, one swings");
}
