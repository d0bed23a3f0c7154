//! Work and losses over a stretch of a flight in closed form: integrals of products of exponentials.

use nalgebra::DMatrix;

use super::driven::Forced;
use super::exponentials::moments;
use super::{Complex, FlightParameters, LinearMotion};

/// A quadratic form of the speeds, `ξ̇ᵀ D ξ̇`: the power that dashpots take \[W\], in the exponentials.
#[derive(Clone, Debug)]
pub struct PowerForm {
    /// `Vᵀ D V` and `Vᵀ D V̄` with the columns `λ_k v_k` of V, counted twice for a conjugate pair, and the dashpots D.
    plain: DMatrix<Complex>,
    mixed: DMatrix<Complex>,
}

/// One exponential of a stretch, and the coefficients that go with it: number, amplitude, and amplitude of τ times it.
struct Term {
    exponent: Complex,
    of: Vec<(usize, [Complex; 2])>,
}

impl PowerForm {
    /// Of dashpots over the coordinates, a symmetric matrix; what drifts has none. Nothing where all are 0.
    pub fn of(motion: &LinearMotion, damping: &DMatrix<f64>) -> Option<Self> {
        if damping.iter().all(|dashpot| *dashpot == 0.0) {
            return None;
        }
        let spectrum = &motion.spectrum;
        let mut speeds = spectrum.shapes.clone();
        for (k, mut column) in speeds.column_iter_mut().enumerate() {
            column *= spectrum.exponents[k] * spectrum.share(k);
        }
        let resisted = damping.map(Complex::from) * &speeds;
        Some(Self { plain: speeds.transpose() * &resisted, mixed: resisted.transpose() * speeds.conjugate() })
    }

    /// Its integral from `from` to `until`, within one piece of the ground's motion \[J\].
    pub fn work(&self, motion: &LinearMotion, flight: FlightParameters<'_>, [from, until]: [f64; 2]) -> f64 {
        let terms = terms(motion, flight, from);
        let mut sum = 0.0;
        for (n, a) in terms.iter().enumerate() {
            for b in &terms[..=n] {
                let twice = if std::ptr::eq(a, b) { 1.0 } else { 2.0 };
                let both = moments(a.exponent + b.exponent, until - from);
                let apart = moments(a.exponent + b.exponent.conj(), until - from);
                sum += twice * self.product(a, b, &both, &apart);
            }
        }
        sum
    }

    /// `½ Re Σ (X_k X_l plain I(σ_k + σ_l) + X_k X̄_l mixed I(σ_k + σ̄_l))`.
    fn product(&self, a: &Term, b: &Term, both: &[Complex; 3], apart: &[Complex; 3]) -> f64 {
        let mut sum = Complex::from(0.0);
        for (k, x) in &a.of {
            for (l, y) in &b.of {
                let convolved = |y: [Complex; 2], m: &[Complex; 3]| {
                    x[0] * y[0] * m[0] + (x[0] * y[1] + x[1] * y[0]) * m[1] + x[1] * y[1] * m[2]
                };
                sum += self.plain[(*k, *l)] * convolved(*y, both);
                sum += self.mixed[(*k, *l)] * convolved(y.map(|y| y.conj()), apart);
            }
        }
        0.5 * sum.re
    }
}

/// `λ_k row·v_k`, counted twice for a conjugate pair.
fn speed(motion: &LinearMotion, row: &[f64], k: usize) -> Complex {
    let spectrum = &motion.spectrum;
    let along: Complex = row.iter().zip(spectrum.shapes.column(k).iter()).map(|(x, v)| v * *x).sum();
    along * spectrum.exponents[k] * spectrum.share(k)
}

/// The coefficients over a stretch from `from`; their constant part, which has no speed, is left out.
fn terms(motion: &LinearMotion, flight: FlightParameters<'_>, from: f64) -> Vec<Term> {
    let spectrum = &motion.spectrum;
    let (parts, forced, none) = (motion.at(flight, from), motion.driven.forced(spectrum, from), Complex::from(0.0));
    let free = |k: usize| match &forced {
        Forced::None | Forced::Steady { .. } => parts.free[k],
        Forced::Line(lines) => parts.all[k] - motion.driven.constant(k) - lines[k][0],
    };
    let of_free = |(k, exponent): (usize, &Complex)| Term { exponent: *exponent, of: vec![(k, [free(k), none])] };
    let mut terms: Vec<Term> = spectrum.exponents.iter().enumerate().map(of_free).collect();
    match &forced {
        Forced::None => {}
        Forced::Steady { omega, parts } => {
            for (which, sign) in [1.0, -1.0].into_iter().enumerate() {
                let of = parts.iter().enumerate().map(|(k, part)| (k, [part[which], none])).collect();
                terms.push(Term { exponent: Complex::new(0.0, sign * omega), of });
            }
        }
        Forced::Line(lines) => {
            terms.push(Term { exponent: none, of: lines.iter().copied().enumerate().collect() });
        }
    }
    terms
}

impl LinearMotion {
    /// `∫ a(t) row·ξ̇ dt` from `from` to `until`, within one piece of the ground's motion; the row is on no drift.
    pub fn moved_by(
        &self,
        flight: FlightParameters<'_>,
        row: &[f64],
        [from, until]: [f64; 2],
        ground: &LineOrSine,
    ) -> f64 {
        let h = until - from;
        let mut sum = Complex::from(0.0);
        for term in terms(self, flight, from) {
            let [plain, growing] = ground.moments(term.exponent, h);
            for (k, [x, y]) in &term.of {
                sum += speed(self, row, *k) * (*x * plain + *y * growing);
            }
        }
        sum.re
    }
}

/// The ground's acceleration along one axis over a stretch, τ from its start \[m/s²\].
#[derive(Clone, Copy, Debug)]
pub enum LineOrSine {
    /// `a + b τ`.
    Line(f64, f64),
    /// `a sin(Ωτ + φ)`: a, Ω, φ.
    Sine(f64, f64, f64),
}

impl LineOrSine {
    /// `∫₀^h a(τ) τ^p e^{στ} dτ` for p = 0, 1.
    fn moments(&self, sigma: Complex, h: f64) -> [Complex; 2] {
        match *self {
            Self::Line(a, b) => {
                let [zeroth, first, second] = moments(sigma, h);
                [zeroth * a + first * b, first * a + second * b]
            }
            Self::Sine(a, omega, phase) => {
                let turn = Complex::from_polar(1.0, phase);
                let part = |sign: f64| moments(sigma + Complex::new(0.0, sign * omega), h);
                let (up, down) = (part(1.0), part(-1.0));
                [0, 1].map(|p| (turn * up[p] - turn.conj() * down[p]) * Complex::new(0.0, -0.5) * a)
            }
        }
    }
}
