//! A damped oscillator on shaking ground: `q̈ + 2 ζ ω q̇ + ω² q = −a(t)`, `ζ < 1`, exact at any time.
//!
//! Under an acceleration that is linear between samples by steps of Nigam and Jennings (1969), under a sine by its steady response.

use glam::DVec3;
use num_complex::Complex64;

use super::{Ground, Samples};

/// Two times closer than this part of a sample's interval are one.
const SAME: f64 = 1e-9;

/// One component of a ground motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Shaking {
    /// None.
    Still,
    /// `A sin(Ωt + φ) + B cos(Ωt + φ)`.
    Sine {
        /// `A` \[m/s²\].
        amplitude: f64,
        /// `B` \[m/s²\].
        quadrature: f64,
        /// `Ω` \[rad/s\].
        omega: f64,
        /// `φ` \[rad\].
        phase: f64,
    },
    /// Samples from t = 0 on, straight lines between them; none before and after.
    Samples {
        /// Interval \[s\].
        dt: f64,
        /// \[m/s²\]
        values: Vec<f64>,
    },
}

impl Shaking {
    /// The component of a ground motion along a unit direction.
    pub fn along(ground: &Ground, direction: DVec3) -> Self {
        match ground {
            Ground::Still => Self::Still,
            Ground::Sine { amplitude, quadrature, omega, phase } => Self::Sine {
                amplitude: amplitude.dot(direction),
                quadrature: quadrature.dot(direction),
                omega: *omega,
                phase: *phase,
            },
            Ground::Record { dt, samples: Samples::Along { direction: own, values }, .. } => {
                let share = own.dot(direction);
                Self::Samples { dt: *dt, values: values.iter().map(|a| a * share).collect() }
            }
            Ground::Record { dt, samples: Samples::Components { values, .. }, .. } => {
                Self::Samples { dt: *dt, values: values.iter().map(|a| a.dot(direction)).collect() }
            }
        }
    }

    /// Largest magnitude \[m/s²\].
    pub fn peak(&self) -> f64 {
        match self {
            Self::Still => 0.0,
            Self::Sine { amplitude, quadrature, .. } => amplitude.hypot(*quadrature),
            Self::Samples { values, .. } => values.iter().fold(0.0, |most, a| most.max(a.abs())),
        }
    }
}

/// Displacement at growing times from rest at the first of them \[m\]; ω in rad/s, ζ of critical, below 1.
pub fn forced(shaking: &Shaking, [omega, zeta]: [f64; 2], times: &[f64]) -> Vec<f64> {
    match shaking {
        Shaking::Still => vec![0.0; times.len()],
        Shaking::Sine { amplitude, quadrature, omega: drive, phase } => {
            let gain = Complex64::new(omega * omega - drive * drive, 2.0 * zeta * omega * drive).inv();
            let size = -Complex64::new(*quadrature, -*amplitude) * gain;
            let steady = |t: f64| size * Complex64::from_polar(1.0, drive * t + phase);
            let begin = times.first().map_or(Complex64::ZERO, |t| steady(*t));
            let speed = (begin * Complex64::new(0.0, *drive)).re;
            let [placed, pushed] = free([omega, zeta], times);
            let at = |(n, t): (usize, &f64)| steady(*t).re - begin.re * placed[n] - speed * pushed[n];
            times.iter().enumerate().map(at).collect()
        }
        Shaking::Samples { dt, values } => walked(*dt, values, [omega, zeta], times),
    }
}

/// Displacement at times of free motion, after `q = 1` and after `q̇ = 1` at the first of them \[m\].
pub fn free([omega, zeta]: [f64; 2], times: &[f64]) -> [Vec<f64>; 2] {
    let (gamma, damped) = (zeta * omega, omega * (1.0 - zeta * zeta).sqrt());
    let begin = times.first().copied().unwrap_or_default();
    let at = |t: &f64| {
        let (sin, cos) = (damped * (t - begin)).sin_cos();
        let decay = (-gamma * (t - begin)).exp();
        [decay * (cos + gamma / damped * sin), decay * sin / damped]
    };
    [0, 1].map(|way| times.iter().map(|t| at(t)[way]).collect())
}

/// From kink to kink and from time to time.
fn walked(dt: f64, values: &[f64], [omega, zeta]: [f64; 2], times: &[f64]) -> Vec<f64> {
    let Some((&begin, rest)) = times.split_first() else { return Vec::new() };
    let whole = Step::new(omega, zeta, dt);
    let (mut t, mut state, mut all) = (begin, [0.0; 2], vec![0.0]);
    for &time in rest {
        while time - t > SAME * dt {
            let piece = Piece::at(t + SAME * dt, dt, values);
            let tau = (piece.until - t).min(time - t);
            let step = if (tau - dt).abs() <= SAME * dt { whole } else { Step::new(omega, zeta, tau) };
            let force = -(piece.start + piece.slope * (t - piece.from));
            state = step.advance(state, force, -piece.slope);
            t = if piece.until - time <= SAME * dt { piece.until } else { time };
        }
        all.push(state[0]);
    }
    all
}

/// A stretch of samples without a kink.
struct Piece {
    from: f64,
    until: f64,
    start: f64,
    slope: f64,
}

impl Piece {
    fn at(t: f64, dt: f64, values: &[f64]) -> Self {
        let still = |until: f64| Self { from: t, until, start: 0.0, slope: 0.0 };
        if t < 0.0 {
            return still(0.0);
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "not negative; beyond a usize the last"
        )]
        let number = (t / dt) as usize;
        match values.get(number..).unwrap_or_default() {
            [start, next, ..] => {
                let from = number as f64 * dt;
                Self { from, until: (number as f64 + 1.0) * dt, start: *start, slope: (next - start) / dt }
            }
            _ => still(f64::INFINITY),
        }
    }
}

/// Exact step of a damped oscillator under a force that is linear in time.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// `[q, q̇]` after it from `[q, q̇, −a, −ȧ]` before it.
    matrix: [[f64; 4]; 2],
    tau: f64,
}

impl Step {
    /// Of length τ \[s\], ζ below 1.
    pub fn new(omega: f64, zeta: f64, tau: f64) -> Self {
        let (gamma, damped) = (zeta * omega, omega * (1.0 - zeta * zeta).sqrt());
        let (s, c) = (damped * tau).sin_cos();
        let decay = (-gamma * tau).exp();
        // Free response to q = 1 and to q̇ = 1.
        let place = [decay * (c + gamma / damped * s), -decay * omega * omega / damped * s];
        let speed = [decay * s / damped, decay * (c - gamma / damped * s)];
        // Particular solution of f + g t: (f + g t)/ω² − 2γ g/ω⁴, less its free response.
        let (w2, w4) = (omega * omega, omega.powi(4));
        let constant = [0, 1].map(|i| (if i == 0 { 1.0 } else { 0.0 } - place[i]) / w2);
        let offset = 2.0 * gamma / w4;
        let slope =
            [tau / w2 - offset + offset * place[0] - speed[0] / w2, 1.0 / w2 + offset * place[1] - speed[1] / w2];
        Self { matrix: [0, 1].map(|i| [place[i], speed[i], constant[i], slope[i]]), tau }
    }

    /// `[q, q̇]` after it, from `[q, q̇]`, `−a` \[m/s²\] and `−ȧ` \[m/s³\] before it.
    pub fn advance(&self, [q, v]: [f64; 2], force: f64, rate: f64) -> [f64; 2] {
        self.matrix.map(|row| row[0] * q + row[1] * v + row[2] * force + row[3] * rate)
    }

    /// Its length \[s\].
    pub fn tau(&self) -> f64 {
        self.tau
    }

    /// Largest |q| of the cubic through both ends, and where it lies, in parts of the step.
    pub fn largest(&self, [q0, v0]: [f64; 2], [q1, v1]: [f64; 2]) -> [f64; 2] {
        let ends = if q0.abs() > q1.abs() { [q0.abs(), 0.0] } else { [q1.abs(), 1.0] };
        if v0 * v1 >= 0.0 {
            return ends;
        }
        // q(x) = q0 + m0 x + (3Δ − 2 m0 − m1) x² + (m0 + m1 − 2Δ) x³ on 0 ≤ x ≤ 1; its slope has one zero in there.
        let (m0, m1, delta) = (v0 * self.tau, v1 * self.tau, q1 - q0);
        let (b, a) = (3.0 * delta - 2.0 * m0 - m1, m0 + m1 - 2.0 * delta);
        let root = (b * b - 3.0 * a * m0).max(0.0).sqrt();
        let sum = if b >= 0.0 { -b - root } else { -b + root };
        let inside = |x: f64| (0.0..=1.0).contains(&x).then_some([f64::abs(q0 + x * (m0 + x * (b + x * a))), x]);
        let inner = [m0 / sum, sum / (3.0 * a)].into_iter().filter_map(inside);
        inner.fold(ends, |most, other| if other[0] > most[0] { other } else { most })
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    const OMEGA: f64 = TAU * 2.4;
    const ZETA: f64 = 0.05;

    #[test]
    fn samples_of_a_sine_are_answered_as_the_sine() {
        let (drive, dt) = (11.0, 1e-3);
        let values: Vec<f64> = (0..8001).map(|n| 2.0 * (drive * f64::from(n) * dt).sin()).collect();
        let sine = Shaking::Sine { amplitude: 2.0, quadrature: 0.0, omega: drive, phase: 0.0 };
        // Times between samples, on them, and uneven.
        let times: Vec<f64> = (0..500).map(|n| 0.3 + 0.0137 * f64::from(n) + 1e-3 * f64::from(n % 7)).collect();
        let [exact, found] =
            [sine, Shaking::Samples { dt, values }].map(|shaking| forced(&shaking, [OMEGA, ZETA], &times));
        let largest = exact.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let off = exact.iter().zip(&found).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        // Straight lines lower a sine by (Ω dt)²/12.
        assert!(off < (drive * dt).powi(2) / 12.0 * 1.1 * largest, "{off} of {largest}");
    }

    #[test]
    fn a_constant_push_settles_at_its_static_displacement() {
        let shaking = Shaking::Samples { dt: 0.1, values: vec![3.0; 1001] };
        let q = forced(&shaking, [OMEGA, ZETA], &[-1.0, 50.0, 99.0]);
        assert!((q[1] + 3.0 / (OMEGA * OMEGA)).abs() < 1e-12 && (q[2] - q[1]).abs() < 1e-12, "{q:?}");
    }

    #[test]
    fn free_motion_solves_the_equation() {
        let times: Vec<f64> = (0..3).map(|n| 0.4 + 1e-4 * f64::from(n)).collect();
        for (way, start) in [(0, [1.0, 0.0]), (1, [0.0, 1.0])] {
            let q = &free([OMEGA, ZETA], &[&[0.0], times.as_slice()].concat())[way];
            let (speed, bend) = ((q[3] - q[1]) / 2e-4, (q[3] - 2.0 * q[2] + q[1]) / 1e-8);
            let residual = bend + 2.0 * ZETA * OMEGA * speed + OMEGA * OMEGA * q[2];
            assert!(residual.abs() < 1e-4 * OMEGA * OMEGA, "{residual}");
            assert_eq!([q[0], free([OMEGA, ZETA], &[0.0])[way][0]], [start[0]; 2], "its start");
        }
    }
}
