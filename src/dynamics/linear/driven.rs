//! The motion that a constant load and the ground drive, in the coefficients of the exponentials: a particular solution.

use super::exponentials::exponential_and_integrals;
use super::{Complex, Spectrum};
use crate::motion::support::GroundPath;
use crate::motion::{Ground, LinearPiece};
use glam::{DVec2, DVec3};
use nalgebra::DVector;

/// Samples of a record between two at which the driven motion is kept: a compromise of memory and of what a look costs.
const SAMPLES_PER_ENTRY: usize = 4;
/// Distance of an exponent from the ground's frequency below which there is no steady motion to speak of, in parts of it.
const RESONANT: f64 = 1e-6;
/// Angle that an exponent, or its difference from the ground's frequency, takes a coefficient through in a run below which constant and
/// steady parts are not parted from the rest: they are by its inverse larger than the motion, which would lose as many digits \[rad\].
const TOO_SLOW: f64 = 1e-3;

/// A particular solution: coefficients of the exponentials, and place and speed of what drifts.
#[derive(Clone, Debug)]
pub struct Driven {
    /// Constant part of the coefficients, from a constant load.
    constant: Vec<Complex>,
    /// Coefficients' rates by an acceleration of the ground along x and y.
    by_ground: [Vec<Complex>; 2],
    /// Rates of the drifts' speeds by the constant load, and by the ground along x and y.
    drifts: Vec<[f64; 3]>,
    ground: GroundResponse,
}

/// Response of the coefficients to the ground.
#[derive(Clone, Debug)]
enum GroundResponse {
    Still,
    /// To a sine: coefficients of `e^{iψ}` and `e^{−iψ}`, ψ the ground's phase.
    Steady {
        gains: Vec<[Complex; 2]>,
        omega: f64,
        phase: f64,
        path: GroundPath,
    },
    /// To a record: coefficients at every [`SAMPLES_PER_ENTRY`]-th sample, one after the other, and the factors that carry them over one
    /// interval.
    Record {
        ground: Ground,
        kept: Vec<Complex>,
        integrals: Vec<[DVec2; 2]>,
        factors: Vec<[Complex; 3]>,
    },
}

impl Driven {
    /// Of a constant load and of the loads by a unit acceleration of the ground along x and y, all per unit mass, in a run of `duration`
    /// \[s\]; `None` at resonance without damping, and where an exponent or its difference from the ground's frequency is too small for
    /// that time.
    pub fn of(
        spectrum: &Spectrum,
        load: &[f64],
        by_ground: [&[f64]; 2],
        (ground, duration): (&Ground, f64),
    ) -> Option<Self> {
        let rates = |load: &[f64]| coefficients(spectrum, load);
        let constant = |(rate, exponent): (Complex, &Complex)| {
            (rate == Complex::from(0.0)).then_some(rate).or((!is_slow(*exponent, duration)).then(|| -rate / exponent))
        };
        let constant = rates(load).into_iter().zip(&spectrum.exponents).map(constant).collect::<Option<Vec<_>>>()?;
        let drifts = spectrum.drifts.iter().map(|&i| [load[i], by_ground[0][i], by_ground[1][i]]).collect();
        let mut driven = Self { constant, by_ground: by_ground.map(rates), drifts, ground: GroundResponse::Still };
        driven.ground = driven.response(spectrum, (ground, duration))?;
        Some(driven)
    }

    fn response(&self, spectrum: &Spectrum, (ground, duration): (&Ground, f64)) -> Option<GroundResponse> {
        match ground {
            Ground::Still => Some(GroundResponse::Still),
            Ground::Sine { amplitude, omega, phase, .. } => {
                let (amplitude, drive) = (amplitude.truncate(), Complex::new(0.0, *omega));
                let gain = |k: usize| {
                    let (rate, exponent) = (self.rate(k, amplitude), spectrum.exponents[k]);
                    if rate == Complex::from(0.0) {
                        return Some([rate; 2]);
                    }
                    let apart = [drive - exponent, -drive - exponent];
                    let near =
                        apart[0].norm() < RESONANT * omega || apart.iter().any(|&apart| is_slow(apart, duration));
                    let share = rate / Complex::new(0.0, 2.0);
                    (!near).then(|| [share / apart[0], -share / apart[1]])
                };
                let gains = (0..self.constant.len()).map(gain).collect::<Option<Vec<_>>>()?;
                Some(GroundResponse::Steady {
                    gains,
                    omega: *omega,
                    phase: *phase,
                    path: GroundPath::of(ground.clone()),
                })
            }
            Ground::Record { dt, .. } => {
                let moved = |k: usize| self.by_ground.iter().any(|by| by[k] != Complex::from(0.0));
                let slow = (0..self.constant.len()).any(|k| moved(k) && is_slow(spectrum.exponents[k], duration));
                (!slow).then(|| self.record(spectrum, ground, *dt))
            }
        }
    }

    /// The driven motion of a record from rest at t = 0.
    fn record(&self, spectrum: &Spectrum, ground: &Ground, dt: f64) -> GroundResponse {
        let factors: Vec<[Complex; 3]> = spectrum.exponents.iter().map(|exponent| interval(*exponent, dt)).collect();
        let (mut now, mut integrals) = (vec![Complex::from(0.0); factors.len()], vec![[DVec2::ZERO; 2]]);
        let (mut kept, mut sums) = (now.clone(), [DVec2::ZERO; 2]);
        let mut number = 0;
        loop {
            let piece = ground.piece(number);
            if piece.until.is_infinite() {
                break;
            }
            self.carry(&mut now, &factors, &piece, piece.from);
            sums = integrated(sums, &piece, dt);
            number += 1;
            if number.is_multiple_of(SAMPLES_PER_ENTRY) {
                kept.extend_from_slice(&now);
                integrals.push(sums);
            }
        }
        GroundResponse::Record { ground: ground.clone(), kept, integrals, factors }
    }

    /// Rate of a coefficient by an acceleration of the ground.
    fn rate(&self, k: usize, ground: DVec2) -> Complex {
        self.by_ground[0][k] * ground.x + self.by_ground[1][k] * ground.y
    }

    fn carry(&self, now: &mut [Complex], factors: &[[Complex; 3]], piece: &LinearPiece, at: f64) {
        let (value, slope) = (piece.acceleration(at).truncate(), piece.rate().truncate());
        for (k, (c, factors)) in now.iter_mut().zip(factors).enumerate() {
            *c = carried(*c, factors, [self.rate(k, value), self.rate(k, slope)]);
        }
    }

    /// Coefficients at `t`.
    pub fn coefficients(&self, spectrum: &Spectrum, t: f64, out: &mut [Complex]) {
        match &self.ground {
            GroundResponse::Still => out.fill(0.0.into()),
            GroundResponse::Steady { gains, omega, phase, .. } => {
                let turn = Complex::from_polar(1.0, omega * t + phase);
                out.iter_mut().zip(gains).for_each(|(c, [up, down])| *c = *up * turn + *down * turn.conj());
            }
            GroundResponse::Record { ground, kept, factors, .. } => {
                let RecordEntry { interval: number, entry: nearest } = RecordEntry::before(ground, t);
                let count = out.len();
                out.copy_from_slice(&kept[nearest * count..][..count]);
                for before in nearest * SAMPLES_PER_ENTRY..number {
                    let piece = ground.piece(before);
                    self.carry(out, factors, &piece, piece.from);
                }
                let piece = ground.piece(number);
                let (value, slope) = (piece.acceleration(piece.from).truncate(), piece.rate().truncate());
                for (k, (c, exponent)) in out.iter_mut().zip(&spectrum.exponents).enumerate() {
                    let factors = interval(*exponent, t - piece.from);
                    *c = carried(*c, &factors, [self.rate(k, value), self.rate(k, slope)]);
                }
            }
        }
        out.iter_mut().zip(&self.constant).for_each(|(c, constant)| *c += *constant);
    }

    /// Change of place and speed of drift `i` by constant load and ground between two times.
    pub fn drift(&self, i: usize, from: f64, until: f64) -> [f64; 2] {
        let ([load, x, y], tau) = (self.drifts[i], until - from);
        let (along, [[v, d], [w, e]]) = (DVec2::new(x, y), [from, until].map(|t| self.integrals(t)));
        let moved = e - d - v * tau;
        [0.5 * load * tau * tau + along.dot(moved), load * tau + along.dot(w - v)]
    }

    /// First and second integral of the ground's acceleration from t = 0.
    fn integrals(&self, t: f64) -> [DVec2; 2] {
        match &self.ground {
            GroundResponse::Still => [DVec2::ZERO; 2],
            GroundResponse::Steady { path, .. } => path.at(t).map(DVec3::truncate),
            GroundResponse::Record { ground, integrals, .. } => {
                let RecordEntry { interval: number, entry: nearest } = RecordEntry::before(ground, t);
                let mut sums = integrals[nearest];
                for before in nearest * SAMPLES_PER_ENTRY..number {
                    let piece = ground.piece(before);
                    sums = integrated(sums, &piece, piece.until - piece.from);
                }
                let piece = ground.piece(number);
                integrated(sums, &piece, t - piece.from)
            }
        }
    }

    /// Amplitude of the ground's part of a coefficient and its frequency, where it is steady.
    pub fn steady(&self, k: usize) -> Option<[f64; 2]> {
        match &self.ground {
            GroundResponse::Still => Some([0.0; 2]),
            GroundResponse::Steady { gains, omega, .. } => Some([gains[k][0].norm() + gains[k][1].norm(), *omega]),
            GroundResponse::Record { .. } => None,
        }
    }

    /// Whether the driven motion is steady, or none.
    pub fn is_steady(&self) -> bool {
        !matches!(self.ground, GroundResponse::Record { .. })
    }

    /// Greatest rate of a coefficient by the ground \[1/s\].
    pub fn fastest_gain(&self, k: usize, peak: f64) -> f64 {
        self.by_ground[0][k].norm().hypot(self.by_ground[1][k].norm()) * peak
    }

    /// By how much the slope of the ground's acceleration jumps within a stretch, in all \[m/s³\].
    pub(super) fn kinks(&self, [from, until]: [f64; 2]) -> f64 {
        let GroundResponse::Record { ground, .. } = &self.ground else { return 0.0 };
        let slope = |number: usize| ground.piece(number).rate().truncate();
        let numbers = ground.piece_number(from)..=ground.piece_number(until);
        numbers.clone().skip(1).map(|number| (slope(number) - slope(number - 1)).length()).sum()
    }

    /// Modulus of the constant part of a coefficient.
    pub fn constant_size(&self, k: usize) -> f64 {
        let constant = self.constant[k];
        if constant == Complex::from(0.0) { 0.0 } else { constant.norm() }
    }

    /// The constant part of a coefficient.
    pub fn constant(&self, k: usize) -> Complex {
        self.constant[k]
    }

    /// Rate of a drift's speed by the constant load, and at most by the ground \[per unit mass\].
    pub fn drift_rate(&self, i: usize, peak: f64) -> f64 {
        let [load, x, y] = self.drifts[i];
        load.abs() + x.hypot(y) * peak
    }

    /// Exponents and coefficients of the ground's part over a stretch without a kink that begins at `t`: of a sine two exponentials for
    /// each coefficient, of a record a constant and a part that grows with time.
    pub(super) fn forced(&self, spectrum: &Spectrum, t: f64) -> Forced {
        match &self.ground {
            GroundResponse::Still => Forced::None,
            GroundResponse::Steady { gains, omega, phase, .. } => {
                let turn = Complex::from_polar(1.0, omega * t + phase);
                let at = |[up, down]: &[Complex; 2]| [*up * turn, *down * turn.conj()];
                Forced::Steady { omega: *omega, parts: gains.iter().map(at).collect() }
            }
            GroundResponse::Record { ground, .. } => {
                let piece = ground.piece(ground.piece_number(t));
                let (value, slope) = (piece.acceleration(t).truncate(), piece.rate().truncate());
                let line = |k: usize| {
                    let exponent = spectrum.exponents[k];
                    let growing = -self.rate(k, slope) / exponent;
                    [(growing - self.rate(k, value)) / exponent, growing]
                };
                Forced::Line((0..self.constant.len()).map(line).collect())
            }
        }
    }
}

/// The ground's part of the coefficients over a stretch, τ from its start.
pub(super) enum Forced {
    None,
    /// `a e^{iΩτ} + b e^{−iΩτ}`.
    Steady {
        omega: f64,
        parts: Vec<[Complex; 2]>,
    },
    /// `a + b τ`.
    Line(Vec<[Complex; 2]>),
}

/// Rates of the coefficients by a load per unit mass.
fn coefficients(spectrum: &Spectrum, load: &[f64]) -> Vec<Complex> {
    let load = DVector::from_iterator(load.len(), load.iter().map(|&x| Complex::from(x)));
    let rates = spectrum.left.columns(spectrum.size, spectrum.size) * load;
    rates.iter().copied().collect()
}

/// A coefficient carried over an interval by its factors, under a rate and the slope of that.
fn carried(c: Complex, [exp, first, second]: &[Complex; 3], [rate, slope]: [Complex; 2]) -> Complex {
    *exp * c + *first * rate + *second * slope
}

/// `e^{λτ}`, `∫ e^{λ(τ−s)} ds`, `∫ s e^{λ(τ−s)} ds` over τ.
fn interval(exponent: Complex, tau: f64) -> [Complex; 3] {
    let [exp, first, second] = exponential_and_integrals(exponent * tau);
    [exp, first * tau, second * (tau * tau)]
}

/// Whether a coefficient with this exponent, or difference of exponents, does not get far enough in a run to be parted from what is constant.
fn is_slow(exponent: Complex, duration: f64) -> bool {
    exponent.norm() * duration < TOO_SLOW
}

/// Stored entry from which a time of a record is computed.
struct RecordEntry {
    /// Number of the record's interval that holds the time.
    interval: usize,
    /// Number of the last entry before it.
    entry: usize,
}

impl RecordEntry {
    fn before(ground: &Ground, t: f64) -> Self {
        let interval = ground.piece_number(t);
        Self { interval, entry: interval / SAMPLES_PER_ENTRY }
    }
}

/// First and second integral after τ of a piece, in plan.
fn integrated(sums: [DVec2; 2], piece: &LinearPiece, tau: f64) -> [DVec2; 2] {
    piece.carried(sums.map(|sum| sum.extend(0.0)), piece.from, tau).map(DVec3::truncate)
}
