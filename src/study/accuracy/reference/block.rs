//! The stick–slip block: a damped oscillator while it sticks, a parabola plus a sine while it slips, switched at roots.
//!
//! `m ÿ = −m A sin Ωt + T`; stick `T = −K (y − p) − C_t ẏ` until `|y − p| = μ_s δ`, slip `T = −μ_k K δ sgn` until the
//! velocity returns to 0, then stick again with the spring still stretched by `μ_k δ` (return mapping).

use crate::study::accuracy::{Answer, Instants};

const MASS: f64 = 2.0;
const K: f64 = 1.55e5;
const PRESSED: f64 = 10.0 / K;
const MU_S: f64 = 0.2;
const MU_K: f64 = 0.15;
const RESTITUTION: (f64, f64) = (0.4, 0.9);
const AMPLITUDE: f64 = 1.4715;
const DRIVE: f64 = std::f64::consts::TAU * 2.0;
/// Two nodes share the force.
const NODES: f64 = 2.0;
/// Interval of looks at the end of a phase \[s\].
const LOOK: f64 = 2e-5;

#[derive(Clone, Copy)]
enum Phase {
    Stick { anchor: f64 },
    Slip { direction: f64 },
}

#[derive(Clone, Copy)]
struct Piece {
    from: f64,
    y: f64,
    v: f64,
    phase: Phase,
}

fn tangential_dashpot() -> f64 {
    let log = RESTITUTION.1.ln();
    -log / std::f64::consts::PI.hypot(log) * 2.0 * (K * MASS).sqrt()
}

impl Piece {
    /// `(y, ẏ)` at `t`.
    fn at(&self, t: f64) -> (f64, f64) {
        match self.phase {
            Phase::Stick { anchor } => self.sticking(anchor, t),
            Phase::Slip { direction } => {
                let tau = t - self.from;
                let friction = -direction * MU_K * 10.0 / MASS;
                let wave =
                    |t: f64| (AMPLITUDE / (DRIVE * DRIVE) * (DRIVE * t).sin(), AMPLITUDE / DRIVE * (DRIVE * t).cos());
                let ((p0, v0), (p, v)) = (wave(self.from), wave(t));
                (self.y + (self.v - v0) * tau + 0.5 * friction * tau * tau + p - p0, self.v + friction * tau + v - v0)
            }
        }
    }

    fn sticking(&self, anchor: f64, t: f64) -> (f64, f64) {
        let (gamma, omega2) = (tangential_dashpot() / (2.0 * MASS), K / MASS);
        let (re, im) = (omega2 - DRIVE * DRIVE, 2.0 * gamma * DRIVE);
        let (size, lag) = (-AMPLITUDE / re.hypot(im), im.atan2(re));
        let steady = |t: f64| (size * (DRIVE * t - lag).sin(), size * DRIVE * (DRIVE * t - lag).cos());
        let (s0, s1) = steady(self.from);
        let (q, u) = (self.y - anchor - s0, self.v - s1);
        let w = (omega2 - gamma * gamma).sqrt();
        let tau = t - self.from;
        let (sin, cos) = (w * tau).sin_cos();
        let e = (-gamma * tau).exp();
        let (free, rate) =
            (e * (q * cos + (u + gamma * q) / w * sin), e * (u * cos - (gamma * u + omega2 * q) / w * sin));
        (anchor + free + steady(t).0, rate + steady(t).1)
    }

    /// Negative while the phase lasts.
    fn ends(&self, t: f64) -> f64 {
        let (y, v) = self.at(t);
        match self.phase {
            Phase::Stick { anchor } => (y - anchor).abs() - MU_S * PRESSED,
            Phase::Slip { direction } => -v * direction,
        }
    }

    /// Force of one node on the block at `t`, dashpot included.
    fn force(&self, t: f64) -> f64 {
        let (y, v) = self.at(t);
        let tangential = match self.phase {
            Phase::Stick { anchor } => K * (y - anchor) + tangential_dashpot() * v,
            Phase::Slip { .. } => MU_K * 10.0,
        };
        tangential.hypot(10.0) / NODES
    }
}

/// Phase after one that ends at `t`.
fn next(piece: &Piece, t: f64) -> Piece {
    let (y, v) = piece.at(t);
    let phase = match piece.phase {
        Phase::Stick { anchor } => Phase::Slip { direction: (y - anchor).signum() },
        Phase::Slip { direction } => Phase::Stick { anchor: y - direction * MU_K * PRESSED },
    };
    Piece { from: t, y, v, phase }
}

/// The answer, from rest with the spring slack.
pub(super) fn answer(instants: Instants) -> Answer {
    let mut piece = Piece { from: 0.0, y: 0.0, v: 0.0, phase: Phase::Stick { anchor: 0.0 } };
    let (mut places, mut peak) = (Vec::new(), 0.0_f64);
    let mut samples = instants.all().peekable();
    while samples.peek().is_some() {
        let mut end = piece.from + LOOK;
        while end < instants.until && piece.ends(end) <= 0.0 {
            peak = peak.max(piece.force(end));
            end += LOOK;
        }
        if end < instants.until {
            let (mut a, mut b) = (end - LOOK, end);
            for _ in 0..80 {
                let middle = f64::midpoint(a, b);
                if piece.ends(middle) > 0.0 { b = middle } else { a = middle }
            }
            end = b;
        } else {
            end = f64::INFINITY;
        }
        peak = peak.max(piece.force(end.min(instants.until)));
        while let Some(t) = samples.next_if(|t| *t <= end) {
            places.push([PRESSED + 0.005, piece.at(t).0, 0.0, 0.0]);
        }
        if end.is_finite() {
            piece = next(&piece, end);
        }
    }
    Answer { places, bodies: 1, peak_force: peak, ..Answer::default() }
}
