//! A block pressed on the wall and shaken along it, against its exact solution: a damped oscillator while it sticks, a
//! parabola plus a sine while it slips, switched at roots. Written out here, sharing nothing with the program.

use crate::support::{free_hit, run, within};
use girderbench::scene::{Direction, FrictionLaw, Motion, Scene, SineMotion};
use girderbench::sim::EventKind;

const MASS: f64 = 2.0;
const K: f64 = 1.55e5;
const PRESSED: f64 = 10.0 / K;
const MU_S: f64 = 0.2;
const MU_K: f64 = 0.15;
const AMPLITUDE: f64 = 1.4715;
const DRIVE: f64 = std::f64::consts::TAU * 2.0;

fn block(law: FrictionLaw) -> Scene {
    let mut scene = free_hit();
    scene.girders[0].initial.velocity = [0.0; 3];
    scene.girders[0].initial.displacement = [0.005 + PRESSED, 0.0, 0.0];
    scene.girders[0].held = vec![Direction::X, Direction::Yaw];
    scene.contact.law = law;
    scene.duration = 4.0;
    scene.motion = Motion::Sine(SineMotion {
        amplitude_g: None,
        amplitude: Some(AMPLITUDE),
        frequency_hz: 2.0,
        phase_deg: 0.0,
        angle_deg: 90.0,
        vertical_amplitude_g: None,
        vertical_amplitude: None,
        vertical_phase_deg: None,
    });
    scene
}

/// Where the block is and what holds it.
#[derive(Clone, Copy, Debug)]
enum Phase {
    Stick { anchor: f64 },
    Slip { direction: f64 },
}

#[derive(Clone, Copy, Debug)]
struct Piece {
    from: f64,
    y: f64,
    v: f64,
    phase: Phase,
}

impl Piece {
    /// `(y, ẏ)` at `t`, exact.
    fn at(&self, t: f64, c_t: f64) -> (f64, f64) {
        match self.phase {
            Phase::Stick { anchor } => {
                let (gamma, omega2) = (c_t / (2.0 * MASS), K / MASS);
                let (re, im) = (omega2 - DRIVE * DRIVE, 2.0 * gamma * DRIVE);
                let (size, lag) = (-AMPLITUDE / re.hypot(im), im.atan2(re));
                let steady = |t: f64| (size * (DRIVE * t - lag).sin(), size * DRIVE * (DRIVE * t - lag).cos());
                let (s0, s1) = steady(self.from);
                let (q, u) = (self.y - anchor - s0, self.v - s1);
                let w = (omega2 - gamma * gamma).sqrt();
                let tau = t - self.from;
                let (sin, cos) = (w * tau).sin_cos();
                let e = (-gamma * tau).exp();
                let free = e * (q * cos + (u + gamma * q) / w * sin);
                let free_rate = e * (u * cos - (gamma * u + omega2 * q) / w * sin);
                (anchor + free + steady(t).0, free_rate + steady(t).1)
            }
            Phase::Slip { direction } => {
                let tau = t - self.from;
                let friction = -direction * MU_K * 10.0 / MASS;
                let wave =
                    |t: f64| (AMPLITUDE / (DRIVE * DRIVE) * (DRIVE * t).sin(), AMPLITUDE / DRIVE * (DRIVE * t).cos());
                let ((p0, v0), (p, v)) = (wave(self.from), wave(t));
                let velocity = self.v + friction * tau + v - v0;
                (self.y + (self.v - v0) * tau + 0.5 * friction * tau * tau + p - p0, velocity)
            }
        }
    }

    /// Negative while the phase lasts.
    fn ends(&self, t: f64, c_t: f64) -> f64 {
        let (y, v) = self.at(t, c_t);
        match self.phase {
            Phase::Stick { anchor } => (y - anchor).abs() - MU_S * PRESSED,
            Phase::Slip { direction } => -v * direction,
        }
    }
}

/// The exact history: pieces in order of time.
fn exact(law: FrictionLaw, until: f64, c_t: f64) -> Vec<Piece> {
    let mut pieces = vec![Piece { from: 0.0, y: 0.0, v: 0.0, phase: Phase::Stick { anchor: 0.0 } }];
    while let Some(piece) = pieces.last().copied() {
        let h = 2e-5;
        let mut t = piece.from + h;
        while t < until && piece.ends(t, c_t) <= 0.0 {
            t += h;
        }
        if t >= until {
            break;
        }
        let (mut a, mut b) = (t - h, t);
        for _ in 0..80 {
            let middle = f64::midpoint(a, b);
            if piece.ends(middle, c_t) > 0.0 { b = middle } else { a = middle }
        }
        let (y, v) = piece.at(b, c_t);
        let phase = match (piece.phase, law) {
            (Phase::Stick { anchor }, FrictionLaw::ReturnMapping) => Phase::Slip { direction: (y - anchor).signum() },
            (Phase::Stick { .. }, FrictionLaw::Paper) => Phase::Slip { direction: v.signum() },
            (Phase::Slip { direction }, FrictionLaw::ReturnMapping) => {
                Phase::Stick { anchor: y - direction * MU_K * PRESSED }
            }
            (Phase::Slip { .. }, FrictionLaw::Paper) => Phase::Stick { anchor: y },
        };
        pieces.push(Piece { from: b, y, v, phase });
    }
    pieces
}

#[test]
fn a_shaken_block_follows_its_exact_solution() {
    for law in [FrictionLaw::ReturnMapping, FrictionLaw::Paper] {
        let history = run(&block(law));
        let c_t = history.model().pairs[0].law.c_t;
        let pieces = exact(law, 4.0, c_t);
        assert!(pieces.len() > 20, "{law:?}: it sticks and slips often, {} phases", pieces.len());
        let (mut worst, mut largest) = (0.0f64, 0.0f64);
        for i in 0..=4000 {
            let t = 4.0 * f64::from(i) / 4000.0;
            let piece = pieces[pieces.partition_point(|p| p.from <= t).max(1) - 1];
            let y = piece.at(t, c_t).0;
            worst = worst.max((history.motion(0, t).displacement.y - y).abs());
            largest = largest.max(y.abs());
        }
        within(&format!("{law:?}: places"), worst / largest, 1e-9);
        let switches: Vec<f64> = history
            .events()
            .iter()
            .filter(|e| e.site() == 0 && matches!(e.kind, EventKind::StickToSlip | EventKind::SlipToStick))
            .map(|e| e.t)
            .collect();
        assert_eq!(switches.len(), pieces.len() - 1, "{law:?}: as many changes");
        let late = switches.iter().zip(&pieces[1..]).map(|(t, piece)| (t - piece.from).abs());
        within(&format!("{law:?}: instants"), late.fold(0.0, f64::max), 1e-9);
    }
}
