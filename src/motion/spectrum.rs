//! Response spectra in closed form between samples (Nigam & Jennings 1969).
//!
//! `q̈ + 2 ζ ω q̇ + ω² q = −a(t)` from rest, `a` linear between samples, so that a step from one time to the next is exact,
//! however long. Steps are no longer than a fortieth of the period. The cubic through `q, q̇` at the ends of a step is off by less than
//! `(π/20)⁴/384` of the amplitude (1.6e-6); where its largest may exceed all before it, the motion there is computed
//! exactly. One period of free motion follows the last sample.

use std::f64::consts::TAU;

use super::oscillator::Step;

/// Bound of what the cubic of a step is off by, in parts of the largest |q| so far and of its own \[–\]: `(π/20)⁴/384`, rounded up.
const CUBIC: f64 = 2e-6;
/// Damping of design spectra, of critical \[–\].
pub const DESIGN_DAMPING: f64 = 0.05;
/// Steps per period at least.
const STEPS: f64 = 40.0;
/// Periods, times the damping, after which free motion has decayed below the last bit: `e^(−2π·5.9) = 1e-16`. From there to the next sample
/// the answer follows the straight line of the acceleration, and its largest |q| is at an end.
const SETTLED: f64 = 5.9;

/// One oscillator's answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Undamped natural period \[s\].
    pub period: f64,
    /// Largest |q|, the spectral displacement \[m\].
    pub displacement: f64,
}

impl Response {
    /// `ω S_d`, the pseudo-velocity \[m/s\].
    pub fn pseudo_velocity(&self) -> f64 {
        TAU / self.period * self.displacement
    }

    /// `ω² S_d`, the pseudo-acceleration \[m/s²\].
    pub fn pseudo_acceleration(&self) -> f64 {
        TAU / self.period * self.pseudo_velocity()
    }
}

/// Response of one oscillator to an acceleration \[m/s²\] at an interval \[s\]: natural period \[s\] and damping of critical,
/// below 1.
pub fn response(samples: &[f64], dt: f64, period: f64, damping: f64) -> Response {
    let omega = TAU / period;
    let parts = (STEPS * dt / period).ceil().max(1.0);
    let walked = parts.min((STEPS * SETTLED / damping).ceil());
    let step = Step::new(omega, damping, dt / parts);
    let leap = (walked < parts).then(|| Step::new(omega, damping, (parts - walked) * step.tau()));
    let (mut state, mut most) = ([0.0; 2], 0.0_f64);
    let mut walk = |force: f64, rate: f64, steps: f64, (step, leap): (&Step, Option<&Step>)| {
        let mut done = 0.0;
        while done < steps {
            let here = force + rate * done * step.tau();
            let next = step.advance(state, here, rate);
            let [about, x] = step.largest(state, next);
            if about > most * (1.0 - CUBIC) {
                let inner = x > 0.0 && x < 1.0;
                most =
                    most.max(if inner { peak([omega, damping], state, [here, rate], x * step.tau()) } else { about });
            }
            (state, done) = (next, done + 1.0);
        }
        if let Some(leap) = leap {
            state = leap.advance(state, force + rate * done * step.tau(), rate);
            most = most.max(state[0].abs());
        }
    };
    for pair in samples.windows(2) {
        walk(-pair[0], -(pair[1] - pair[0]) / dt, walked, (&step, leap.as_ref()));
    }
    walk(0.0, 0.0, STEPS, (&Step::new(omega, damping, period / STEPS), None));
    Response { period, displacement: most }
}

/// |q| at the zero of `q̇` near τ \[s\] after a state under `−a` and `−ȧ`: the exact motion at τ, and of the parabola there its vertex. With
/// τ off by ε of the period the vertex is off by the order of ε³.
fn peak([omega, damping]: [f64; 2], state: [f64; 2], [force, rate]: [f64; 2], tau: f64) -> f64 {
    let [q, v] = Step::new(omega, damping, tau).advance(state, force, rate);
    let acceleration = force + rate * tau - 2.0 * damping * omega * v - omega * omega * q;
    let vertex = if acceleration == 0.0 { 0.0 } else { 0.5 * v * v / acceleration };
    (q - vertex).abs()
}

/// The spectrum at these periods \[s\].
pub fn spectrum(samples: &[f64], dt: f64, periods: &[f64], damping: f64) -> Vec<Response> {
    periods.iter().map(|period| response(samples, dt, *period, damping)).collect()
}

/// So many periods from the first to the second \[s\], evenly spaced by their logarithm.
pub fn periods([from, to]: [f64; 2], count: u32) -> Vec<f64> {
    let last = f64::from(count.max(2) - 1);
    (0..count.max(2)).map(|n| from * (to / from).powf(f64::from(n) / last)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_overshoots_by_its_damping() {
        // q = −A/ω² (1 − …): the largest is A/ω² (1 + exp(−πζ/√(1−ζ²))) at half a damped period.
        for (period, zeta) in [(0.05, 0.05), (0.5, 0.05), (0.73, 0.2), (2.0, 0.02)] {
            let found = response(&[3.0; 1001], 0.01, period, zeta).displacement;
            let omega: f64 = TAU / period;
            let overshoot = (-std::f64::consts::PI * zeta / (1.0 - zeta * zeta).sqrt()).exp();
            let exact = 3.0 / (omega * omega) * (1.0 + overshoot);
            assert!((found / exact - 1.0).abs() < 1e-11, "T = {period}, ζ = {zeta}: {found}, not {exact}");
        }
    }

    #[test]
    fn a_sine_is_answered_as_in_closed_form() {
        // From rest: the steady response and the free one that cancels it at t = 0; samples fine enough for the sine.
        let (amplitude, drive, dt, count) = (2.0, 7.0, 1e-4, 60_001_u32);
        let samples: Vec<f64> = (0..count).map(|n| amplitude * (drive * f64::from(n) * dt).sin()).collect();
        for (period, zeta) in [(0.3, 0.05), (TAU / 7.0, 0.05), (2.0, 0.1)] {
            let found = response(&samples, dt, period, zeta).displacement;
            let omega: f64 = TAU / period;
            let (gamma, damped) = (zeta * omega, omega * (1.0_f64 - zeta * zeta).sqrt());
            let (re, im) = (omega * omega - drive * drive, 2.0 * gamma * drive);
            let size = re * re + im * im;
            // q = P sin + Q cos + e^(−γt) (B cos + D sin).
            let (p, q) = (-amplitude * re / size, amplitude * im / size);
            let (b, d) = (-q, (-drive * p - gamma * q) / damped);
            let at = |t: f64| {
                let (s, c) = (drive * t).sin_cos();
                let (fs, fc) = (damped * t).sin_cos();
                p * s + q * c + (-gamma * t).exp() * (b * fc + d * fs)
            };
            let exact = (0..count).map(|n| at(f64::from(n) * dt).abs()).fold(0.0, f64::max);
            assert!((found / exact - 1.0).abs() < 3e-6, "T = {period}, ζ = {zeta}: {found}, not {exact}");
        }
    }

    /// A ramp is followed by `−a/ω²`, once its start has decayed, and takes no longer for being longer.
    #[test]
    fn what_is_far_slower_than_the_oscillator_is_followed_at_rest() {
        // The kink at the peak swings it beyond: an integration by other means (an explicit Runge–Kutta method at 1e-11) has 4.728e-4 of the
        // peak at 200 s.
        for (dt, beyond) in [(200.0, 4.728e-4), (1e6, 0.0), (1e300, 0.0)] {
            let found = response(&[0.0, 3.0, 0.0], dt, 1.0, 0.05).displacement;
            let exact = 3.0 / (TAU * TAU) * (1.0 + beyond);
            assert!((found / exact - 1.0).abs() < 2e-6, "{found}, not {exact} m at {dt} s");
        }
    }

    #[test]
    fn the_free_motion_after_a_short_pulse_counts() {
        // An impulse J: |q| = J/(m ω) e^(−γt) sin; its largest comes long after the pulse.
        let (dt, period) = (1e-4, 1.0);
        let found = response(&[0.0, 1.0, 0.0], dt, period, 0.05).displacement;
        let (zeta, omega): (f64, f64) = (0.05, TAU);
        let root = (1.0 - zeta * zeta).sqrt();
        let exact = dt / omega * (-zeta / root * (root / zeta).atan()).exp();
        assert!((found / exact - 1.0).abs() < 1e-5, "{found}, not {exact}");
    }

    #[test]
    fn a_stiff_oscillator_feels_the_peak_of_the_ground() {
        let found = response(&[0.0, 1.0, 2.0, 1.0, 0.0], 0.5, 0.01, 0.05).pseudo_acceleration();
        assert!((found - 2.0).abs() < 0.02, "{found}");
    }
}
