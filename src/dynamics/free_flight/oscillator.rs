//! One degree of freedom in closed form: `q̈ + 2γ q̇ + ω² q = f(t)` (paper equations (1), (3)).
//!
//! Everything comes from the impulse response `S0` and its integrals `S1 = ∫S0`, `S2 = ∫S1`: for a start `(q, v)` and a
//! force `f = c0 + c1 τ`, `q(τ) = q C + v S0 + c0 S1 + c1 S2` with `C = 1 − ω² S1`. No case is singular: without
//! stiffness and damping the three are `τ, τ²/2, τ³/6`.

use crate::dynamics::free_flight::constants::{NEAR_CRITICAL, NEGLIGIBLE, SERIES_LIMIT, SOFT};

/// An oscillator per unit mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillator {
    /// `γ = h ω`, half the dashpot over the mass \[1/s\].
    pub gamma: f64,
    /// `ω²`, stiffness over mass \[1/s²\].
    pub omega2: f64,
}

/// Free response factors over a time τ.
#[derive(Clone, Copy, Debug)]
pub struct FreeResponse {
    /// Displacement per initial displacement.
    pub c: f64,
    /// Displacement per initial velocity \[s\].
    pub s: f64,
    /// Velocity per initial velocity.
    pub s_rate: f64,
}

/// Forced response factors over a time τ, from rest.
#[derive(Clone, Copy, Debug, Default)]
pub struct ForcedResponse {
    /// `S1`: displacement per constant force per unit mass \[s²\].
    pub s1: f64,
    /// `S2`: displacement per rate of a force per unit mass that begins at 0 \[s³\].
    pub s2: f64,
}

/// Complex amplitude of an oscillation in step with the ground, `re sin(Ωt + φ) + im cos(Ωt + φ)`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Phasor {
    /// Part in phase.
    pub re: f64,
    /// Part in quadrature.
    pub im: f64,
}

impl Phasor {
    /// Its value and its rate \[1/s\], from sine and cosine of the phase at circular frequency `drive` \[rad/s\].
    #[inline]
    pub fn at(self, [s, c]: [f64; 2], drive: f64) -> [f64; 2] {
        [self.re * s + self.im * c, drive * (self.re * c - self.im * s)]
    }
}

impl Oscillator {
    /// Undamped circular frequency \[rad/s\].
    pub fn omega(&self) -> f64 {
        self.omega2.sqrt()
    }

    /// Free response factors.
    #[inline]
    pub fn free(&self, tau: f64) -> FreeResponse {
        let d = self.gamma * self.gamma - self.omega2;
        let (s, mean) = if d.abs().sqrt() * tau < NEAR_CRITICAL {
            near_critical(self.gamma, d, tau)
        } else if d < 0.0 {
            let (sin, cos) = ((-d).sqrt() * tau).sin_cos();
            let e = (-self.gamma * tau).exp();
            (e * sin / (-d).sqrt(), e * cos)
        } else {
            let root = d.sqrt();
            let slow = (-self.omega2 / (self.gamma + root) * tau).exp();
            let fast = (-(self.gamma + root) * tau).exp();
            ((slow - fast) / (2.0 * root), f64::midpoint(slow, fast))
        };
        FreeResponse { c: mean + self.gamma * s, s, s_rate: mean - self.gamma * s }
    }

    /// Forced response factors.
    pub fn forced(&self, tau: f64, free: &FreeResponse) -> ForcedResponse {
        if self.gamma.max(self.omega()) * tau < SERIES_LIMIT {
            return self.forced_series(tau);
        }
        if self.omega2 == 0.0 {
            // Dashpot alone: S0 = (1 − e^{−2γτ})/(2γ).
            let s1 = (tau - free.s) / (2.0 * self.gamma);
            return ForcedResponse { s1, s2: (tau * tau / 2.0 - s1) / (2.0 * self.gamma) };
        }
        if self.omega2 < SOFT * self.gamma * self.gamma {
            // S0 is the difference of two decays, e^{−aτ} and e^{−bτ}, over 2r; so are its integrals.
            let root = (self.gamma * self.gamma - self.omega2).sqrt();
            let [slow, fast] =
                [self.omega2 / (self.gamma + root), self.gamma + root].map(|rate| decay_integrals(rate * tau));
            let apart = 2.0 * root;
            return ForcedResponse {
                s1: (slow[0] - fast[0]) * tau / apart,
                s2: (slow[1] - fast[1]) * tau * tau / apart,
            };
        }
        let s1 = (1.0 - free.c) / self.omega2;
        ForcedResponse { s1, s2: (tau - 2.0 * self.gamma * s1 - free.s) / self.omega2 }
    }

    fn forced_series(&self, tau: f64) -> ForcedResponse {
        // Coefficients of S0 = Σ s_k τ^k from its own differential equation; each integral divides by the next power.
        let (mut before, mut here) = (0.0, 1.0);
        let (mut s1, mut s2, mut power, mut last) = (0.0, 0.0, tau, f64::INFINITY);
        for k in 1..20 {
            let n = f64::from(k);
            let term = here * power * tau / (n + 1.0);
            s1 += term;
            s2 += term * tau / (n + 2.0);
            // Two terms below the round-off of their sum: all that follow are smaller.
            if term.abs().max(last.abs()) < NEGLIGIBLE * s1.abs() {
                break;
            }
            last = term;
            let next = (-2.0 * self.gamma * n * here - self.omega2 * before) / (n * (n + 1.0));
            (before, here) = (here, next);
            power *= tau;
        }
        ForcedResponse { s1, s2 }
    }

    /// `(q, v)` after τ from `(q, v)` under `c0 + c1 τ`.
    #[inline]
    pub fn advance(&self, start: [f64; 2], force: [f64; 2], tau: f64) -> [f64; 2] {
        self.carry(&self.free(tau), start, force, tau)
    }

    /// [`advance`](Self::advance) from the free response factors over τ.
    #[inline]
    pub(in crate::dynamics) fn carry(
        &self,
        f: &FreeResponse,
        [q, v]: [f64; 2],
        [c0, c1]: [f64; 2],
        tau: f64,
    ) -> [f64; 2] {
        let forced = if c0 != 0.0 || c1 != 0.0 { self.forced(tau, f) } else { ForcedResponse::default() };
        self.carry_forced(f, forced, [q, v], [c0, c1])
    }

    /// [`advance`](Self::advance) from the free and the forced response factors over τ; the latter are not read without force.
    #[inline]
    pub(in crate::dynamics) fn carry_forced(
        &self,
        f: &FreeResponse,
        ForcedResponse { s1, s2 }: ForcedResponse,
        [q, v]: [f64; 2],
        [c0, c1]: [f64; 2],
    ) -> [f64; 2] {
        let mut displacement = q * f.c + v * f.s;
        let mut velocity = -self.omega2 * f.s * q + f.s_rate * v;
        if c0 != 0.0 || c1 != 0.0 {
            displacement += c0 * s1 + c1 * s2;
            velocity += c0 * f.s + c1 * s1;
        }
        [displacement, velocity]
    }

    /// Complex gain `1/(ω² − Ω² + 2iγΩ)` of the steady response to a sine \[s²\]; `None` within a thousandth of an undamped
    /// resonance, or where the response is a thousand times the displacement that a force of its size can reach in a run of `duration`
    /// \[s\]: steady and free response would cancel to the last digits.
    pub fn gain(&self, drive: f64, duration: f64) -> Option<Phasor> {
        let (re, im) = (self.omega2 - drive * drive, 2.0 * self.gamma * drive);
        let size2 = re * re + im * im;
        let scale = self.omega2.max(drive * drive);
        let resonant = size2 <= (1e-3 * scale).powi(2);
        // Under a constant unit force, from rest: at most τ²/2, the static displacement twice, or what the dashpot lets pass.
        let reach = (0.5 * duration * duration).min(2.0 / self.omega2).min(duration / (2.0 * self.gamma));
        let slow = 1e-3 > reach * size2.sqrt();
        (!resonant && !slow).then(|| Phasor { re: re / size2, im: -im / size2 })
    }
}

/// `(1 − e^{−z})/z` and `(z − 1 + e^{−z})/z²` for z ≥ 0: `∫₀¹ e^{−zs} ds` and `∫₀¹ (1 − s) e^{−zs} ds`.
fn decay_integrals(z: f64) -> [f64; 2] {
    if z < SERIES_LIMIT {
        // Σ (−z)^k/(k + 1)! and Σ (−z)^k/(k + 2)!.
        let (mut first, mut second, mut term) = (0.0, 0.0, 1.0);
        for k in 1..20 {
            first += term;
            second += term / f64::from(k + 1);
            term *= -z / f64::from(k + 1);
        }
        return [first, second];
    }
    let first = -(-z).exp_m1() / z;
    [first, (1.0 - first) / z]
}

/// `e^{−γτ} sinh(√d τ)/√d` \[s\] and `e^{−γτ} cosh(√d τ)` about d = 0, either sign.
fn near_critical(gamma: f64, d: f64, tau: f64) -> (f64, f64) {
    let e = (-gamma * tau).exp();
    let u = d * tau * tau;
    let sinhc = 1.0 + u / 6.0 * (1.0 + u / 20.0 * (1.0 + u / 42.0));
    let cosh = 1.0 + u / 2.0 * (1.0 + u / 12.0 * (1.0 + u / 30.0));
    (e * tau * sinhc, e * cosh)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The differential equation itself, by fourth-order differences of the closed form.
    fn residual(o: Oscillator, start: [f64; 2], force: [f64; 2], tau: f64) -> f64 {
        let h = 1e-3 / o.omega().max(o.gamma).max(1.0);
        let v = |k: f64| o.advance(start, force, tau + k * h)[1];
        let q = o.advance(start, force, tau)[0];
        let acceleration = (v(-2.0) - 8.0 * v(-1.0) + 8.0 * v(1.0) - v(2.0)) / (12.0 * h);
        acceleration + 2.0 * o.gamma * v(0.0) + o.omega2 * q - force[0] - force[1] * tau
    }

    #[test]
    fn the_closed_form_solves_the_equation_for_every_kind_of_damping() {
        for (gamma, omega2) in
            [(0.0, 0.0), (0.5, 0.0), (0.0, 9.0), (0.9, 9.0), (3.0, 9.0), (3.0 + 1e-9, 9.0), (8.0, 9.0), (1e-6, 1e-8)]
        {
            for tau in [1e-4, 0.03, 0.7, 4.0] {
                let r = residual(Oscillator { gamma, omega2 }, [0.3, -0.2], [0.7, 0.4], tau);
                // Fourth-order differences of step 1e-3 over values of order 1: 1e-12 truncation, 1e-12 rounding.
                assert!(r.abs() < 2e-10, "γ = {gamma}, ω² = {omega2}, τ = {tau}: residual {r:e}");
            }
        }
    }

    #[test]
    fn two_half_times_are_one_whole_time() {
        let o = Oscillator { gamma: 4.5, omega2: 266.9 };
        let whole = o.advance([1e-2, 0.3], [2.0, 50.0], 0.4);
        let half = o.advance([1e-2, 0.3], [2.0, 50.0], 0.2);
        let again = o.advance(half, [2.0 + 50.0 * 0.2, 50.0], 0.2);
        for (a, b) in whole.iter().zip(again) {
            assert!((a - b).abs() < 1e-14, "{a} against {b}");
        }
    }
}
