//! Flights of a linear block: what they begin with, where they are, how far they go.

use super::driven::Forced;
use super::{Complex, Driven, Spectrum};
use crate::motion::Ground;

/// A linear block under a ground motion, prepared once.
#[derive(Clone, Debug)]
pub struct LinearMotion {
    /// Its exponentials.
    pub spectrum: Spectrum,
    /// Excitation: constant load and ground.
    pub driven: Driven,
    /// Greatest acceleration of the ground \[m/s²\].
    pub peak: f64,
    /// Of each exponent: its modulus \[1/s\], and the greatest rate of its coefficient by the ground.
    sizes: Vec<[f64; 2]>,
    /// The least of these moduli \[1/s\].
    slowest: f64,
}

/// Start and parameters of a flight: place and speed of each drift at the start, then the free part of each coefficient.
#[derive(Clone, Copy, Debug)]
pub struct FlightParameters<'a> {
    /// Beginning \[s\].
    pub start: f64,
    /// Numbers of [`LinearMotion::begin`].
    pub numbers: &'a [f64],
}

/// Coordinates of a flight at one time, in the drifts and exponentials of the block.
#[derive(Clone, Debug, Default)]
pub struct ModalCoordinates {
    /// Place and speed of each drift.
    pub drifts: Vec<[f64; 2]>,
    /// Free part of each coefficient.
    pub free: Vec<Complex>,
    /// Each coefficient, with what is driven.
    pub all: Vec<Complex>,
}

impl LinearMotion {
    /// Of loads per unit mass: constant, and by a unit acceleration of the ground along x and y, in a run of this duration \[s\]. `None`
    /// where there is no closed form to rely on.
    pub fn of(
        spectrum: Spectrum,
        load: &[f64],
        by_ground: [&[f64]; 2],
        (ground, duration): (&Ground, f64),
    ) -> Option<Self> {
        let driven = Driven::of(&spectrum, load, by_ground, (ground, duration))?;
        let peak = ground.peak();
        let size = |(k, exponent): (usize, &Complex)| [exponent.norm(), driven.fastest_gain(k, peak)];
        let sizes: Vec<[f64; 2]> = spectrum.exponents.iter().enumerate().map(size).collect();
        let slowest = sizes.iter().map(|[fast, _]| *fast).fold(f64::INFINITY, f64::min);
        Some(Self { spectrum, driven, peak, sizes, slowest })
    }

    /// Numbers of a flight that begins at `start` with these places and speeds.
    pub fn begin(&self, start: f64, places: &[f64], speeds: &[f64]) -> Vec<f64> {
        let (left, count) = (&self.spectrum.left, self.spectrum.exponents.len());
        let mut driven = vec![Complex::from(0.0); count];
        self.driven.coefficients(&self.spectrum, start, &mut driven);
        let mut numbers: Vec<f64> = self.spectrum.drifts.iter().flat_map(|&i| [places[i], speeds[i]]).collect();
        for (k, driven) in driven.into_iter().enumerate() {
            let state = places.iter().chain(speeds).enumerate();
            let free = state.map(|(i, x)| left[(k, i)] * *x).sum::<Complex>() - driven;
            numbers.extend([free.re, free.im]);
        }
        numbers
    }

    /// A flight at `t`.
    pub fn at(&self, flight: FlightParameters<'_>, t: f64) -> ModalCoordinates {
        let (exponents, tau) = (&self.spectrum.exponents, t - flight.start);
        let (drifts, free) = flight.numbers.split_at(2 * self.spectrum.drifts.len());
        let drift = |(i, start): (usize, &[f64; 2])| {
            let [place, speed] = self.driven.drift(i, flight.start, t);
            [start[0] + start[1] * tau + place, start[1] + speed]
        };
        let free = free.as_chunks::<2>().0.iter().zip(exponents);
        let at_rest = Complex::from(0.0);
        let free = free.map(|([re, im], exponent)| (Complex::new(*re, *im), exponent));
        // A mode that nothing has moved costs nothing.
        let free: Vec<Complex> =
            free.map(|(c, exponent)| if c == at_rest { c } else { c * (exponent * tau).exp() }).collect();
        let mut all = vec![Complex::from(0.0); exponents.len()];
        self.driven.coefficients(&self.spectrum, t, &mut all);
        all.iter_mut().zip(&free).for_each(|(all, free)| *all += free);
        ModalCoordinates { drifts: drifts.as_chunks().0.iter().enumerate().map(drift).collect(), free, all }
    }

    /// Places and speeds of coordinates in a row, from `first` on.
    pub fn read(&self, parts: &ModalCoordinates, first: usize, places: &mut [f64], speeds: &mut [f64]) {
        let spectrum = &self.spectrum;
        places.fill(0.0);
        speeds.fill(0.0);
        for (&i, [place, speed]) in spectrum.drifts.iter().zip(&parts.drifts) {
            if (first..first + places.len()).contains(&i) {
                (places[i - first], speeds[i - first]) = (*place, *speed);
            }
        }
        let moves = |(_, (c, _)): &(usize, (&Complex, &Complex))| **c != Complex::from(0.0);
        for (k, (c, exponent)) in parts.all.iter().zip(&spectrum.exponents).enumerate().filter(moves) {
            let (c, shape) = (*c * spectrum.share(k), spectrum.shapes.column(k));
            let (shape, rate) = (shape.rows(first, places.len()), c * exponent);
            for ((v, place), speed) in shape.iter().zip(places.iter_mut()).zip(speeds.iter_mut()) {
                *place += v.re * c.re - v.im * c.im;
                *speed += v.re * rate.re - v.im * rate.im;
            }
        }
    }

    /// Time for which bounds from an evaluation hold, at most `horizon`: under a record half the time constant of the slowest exponential
    /// \[s\].
    pub fn window(&self, horizon: f64) -> f64 {
        if self.driven.is_steady() { horizon } else { horizon.min(0.5 / self.slowest) }
    }

    /// Bounds of a coefficient from a look on for a window \[s\]: its modulus; what its motion does to speeds; to accelerations, those by
    /// the ground itself under a record apart.
    pub fn largest(&self, parts: &ModalCoordinates, k: usize, window: f64) -> [f64; 3] {
        let (constant, [fast, gain]) = (self.driven.constant(k), self.sizes[k]);
        // A free part only falls.
        if let Some([steady, drive]) = self.driven.steady(k) {
            let free = parts.free[k].norm();
            return [
                free + steady + self.driven.constant_size(k),
                fast * (free + steady),
                fast * (fast * free + drive * steady),
            ];
        }
        let swinging = (parts.all[k] - constant).norm() + gain * window;
        [swinging + self.driven.constant_size(k), fast * swinging, fast * fast * swinging]
    }

    /// Greatest acceleration by the ground itself where coefficients are bounded with what drives them; 0 where the driven motion is
    /// steady \[m/s²\].
    pub fn unsteady_peak(&self) -> f64 {
        if self.driven.is_steady() { 0.0 } else { self.peak }
    }

    /// Bounds of the second derivative of each coefficient over a stretch from `from` to `until` \[s\]. Under a record it is that of the
    /// part that swings about the line that the ground's line would hold it at, and grows by what a kink adds.
    pub fn second_derivatives(&self, flight: FlightParameters<'_>, [from, until]: [f64; 2]) -> Vec<f64> {
        let parts = self.at(flight, from);
        let free = || parts.free.iter().zip(&self.sizes).map(|(c, [fast, _])| fast * fast * c.norm());
        match self.driven.forced(&self.spectrum, from) {
            Forced::None => free().collect(),
            Forced::Steady { omega, parts } => {
                let steady = parts.iter().map(|[up, down]| omega * omega * (up.norm() + down.norm()));
                free().zip(steady).map(|(free, steady)| free + steady).collect()
            }
            Forced::Line(lines) => {
                let kinks = self.driven.kinks([from, until]);
                let swinging = |(k, ([on_line, _], [fast, _])): (usize, (&[Complex; 2], &[f64; 2]))| {
                    let off = parts.all[k] - self.driven.constant(k) - *on_line;
                    fast * fast * off.norm() + self.driven.fastest_gain(k, kinks)
                };
                lines.iter().zip(&self.sizes).enumerate().map(swinging).collect()
            }
        }
    }

    /// Bounds of a drift from a look on for a window: place, speed, acceleration.
    pub fn drift_bounds(&self, parts: &ModalCoordinates, i: usize, window: f64) -> [f64; 3] {
        let ([place, speed], acceleration) = (parts.drifts[i], self.driven.drift_rate(i, self.peak));
        let speed = speed.abs() + acceleration * window;
        [place.abs() + speed * window, speed, acceleration]
    }
}
