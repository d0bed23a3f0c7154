//! A face that slides along a wall, in closed form (state e, (17)–(20)).
//!
//! The girder cannot turn and stays on the wall, so one coordinate is left, the displacement `u` along `s`. With `f` all forces per mass
//! but the wall's, `N/m = −n·f` and `T = −μ_k σ N`, so `ü = d·f` with `d = s + μ_k σ n`. Forces of bearings and dashpots are
//! linear in `u` and `u̇`: friction only tilts the direction along which they are felt, and what is left is one oscillator
//! `ü + (d·C s/m) u̇ + (d·K s/m) u = d·(f(0) − a_g)`. Bearings that are so unlike along x and y that the tilt makes a negative
//! stiffness or damping of them, and an undamped resonance, go through the matrix exponential.

use glam::{DVec2, DVec3};

use crate::dynamics::free_flight::matrix_exponential;
use crate::dynamics::free_flight::matrix_exponential::CoupledPropagator;
use crate::dynamics::free_flight::oscillator::{Oscillator, Phasor};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::coordinates::planar::{self, POSITIONS, PlanarState};
use crate::motion::{Ground, Line, LinearPiece, Samples};

/// One stretch of sliding, within one piece of a record.
#[derive(Clone, Debug)]
pub struct SlidingFace {
    /// Beginning \[s\].
    pub from: f64,
    /// Longest sampling interval that resolves every reversal \[s\].
    pub sight: f64,
    place: DVec3,
    along: DVec2,
    law: SlidingForm,
}

#[derive(Clone, Debug)]
enum SlidingForm {
    /// Free part at the start, constant force and its rate, steady response to the sine.
    Oscillator { oscillator: Oscillator, part: [f64; 2], force: [f64; 2], steady: SteadyResponse },
    /// Propagator as a matrix; its coefficients are stored for hashing.
    Matrix { system: Box<CoupledPropagator>, start: Box<matrix_exponential::AugmentedState>, felt: ProjectedForces },
}

/// Displacement along the face in step with the ground \[m\].
#[derive(Clone, Copy, Debug, Default)]
struct SteadyResponse {
    phasor: Phasor,
    /// Ω \[rad/s\].
    drive: f64,
    /// φ \[rad\].
    phase: f64,
}

impl SteadyResponse {
    fn at(&self, t: f64) -> [f64; 2] {
        self.phasor.at((self.drive * t + self.phase).sin_cos().into(), self.drive)
    }
}

/// Coefficients of `ü + damping u̇ + omega2 u = force + …` along the face, projected on `d` and divided by the mass \[1/s, 1/s², m/s²\].
#[derive(Clone, Copy, Debug)]
struct ProjectedForces {
    omega2: f64,
    damping: f64,
    /// Constant part of the force at the start, without the ground's.
    force: f64,
    /// Per unit of the ground's acceleration: along the sine's amplitude, or the record's direction; of a record of several
    /// components 1, as [`line_along`] projects them.
    ground: f64,
}

impl ProjectedForces {
    fn of(body: &Body, q: DVec3, s: DVec2, d: DVec2, ground: &Ground) -> Self {
        let felt = |force: DVec3| d.dot(force.truncate()) / body.mass;
        let per_ground = match ground {
            Ground::Still => 0.0,
            Ground::Sine { amplitude, .. } => -d.dot(amplitude.truncate()),
            Ground::Record { samples: Samples::Along { direction, .. }, .. } => -d.dot(direction.truncate()),
            Ground::Record { samples: Samples::Components { .. }, .. } => 1.0,
        };
        Self {
            omega2: felt(body.planar.stiffness * s.extend(0.0)),
            damping: felt(body.planar.damping * s.extend(0.0)),
            force: felt(body.push.truncate().extend(0.0) - body.planar.stiffness * q),
            ground: per_ground,
        }
    }
}

/// Value at `t` and rate of a record's line, of which [`ProjectedForces::ground`] is felt along `d`.
fn line_along(d: DVec2, piece: &LinearPiece, t: f64) -> [f64; 2] {
    match piece.line {
        Line::Along { start, slope, .. } => [start + slope * (t - piece.from), slope],
        Line::Components { .. } => [piece.acceleration(t), piece.rate()].map(|a| -d.dot(a.truncate())),
    }
}

impl SlidingFace {
    /// The slide of `girder` along `s` from `state` at `t` on, within `piece` of the ground motion and for at most `longest` \[s\].
    /// `d = s + μ_k σ n` is the direction along which forces are felt.
    pub(in crate::dynamics) fn new(
        (girder, ground): (&Body, &Ground),
        [s, d]: [DVec2; 2],
        piece: &LinearPiece,
        (t, state): (f64, &PlanarState),
        longest: f64,
    ) -> Self {
        let place = planar::positions(state);
        let felt = ProjectedForces::of(girder, place, s, d, ground);
        let speed = planar::rates(state).truncate().dot(s);
        let fastest = felt.omega2.abs().sqrt().max(felt.damping.abs());
        let law = SlidingForm::of(&felt, ground, line_along(d, piece, t), t, speed, longest);
        Self { from: t, sight: std::f64::consts::FRAC_PI_2 / fastest, place, along: s, law }
    }

    /// State at `t`.
    pub fn state(&self, t: f64) -> PlanarState {
        let [u, v] = self.law.at(self.from, t);
        let [q, rate] = [self.along * u, self.along * v];
        [self.place.x + q.x, self.place.y + q.y, self.place.z, rate.x, rate.y, 0.0]
    }

    /// Every number that the answer depends on, for hashing.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let of_law = match &self.law {
            SlidingForm::Oscillator { oscillator, part, force, steady } => {
                let own = [
                    oscillator.gamma,
                    oscillator.omega2,
                    steady.phasor.re,
                    steady.phasor.im,
                    steady.drive,
                    steady.phase,
                ];
                [&own[..], &part[..], &force[..]].concat()
            }
            SlidingForm::Matrix { start, felt, .. } => {
                [&start[..], &[felt.omega2, felt.damping, felt.force, felt.ground]].concat()
            }
        };
        [self.from, self.place.x, self.place.y, self.place.z, self.along.x, self.along.y].into_iter().chain(of_law)
    }
}

impl SlidingForm {
    fn of(felt: &ProjectedForces, ground: &Ground, [value, rate]: [f64; 2], t: f64, speed: f64, longest: f64) -> Self {
        let oscillator = Oscillator { gamma: felt.damping / 2.0, omega2: felt.omega2 };
        let (gain, drive, phase) = match ground {
            Ground::Sine { omega, phase, .. } => (oscillator.gain(*omega, longest), *omega, *phase),
            _ => (Some(Phasor::default()), 0.0, 0.0),
        };
        match gain {
            Some(Phasor { re, im }) if felt.omega2 >= 0.0 && felt.damping >= 0.0 => {
                let phasor = Phasor { re: felt.ground * re, im: felt.ground * im };
                let steady = SteadyResponse { phasor, drive, phase };
                let [q, v] = steady.at(t);
                let force = [felt.force + felt.ground * value, felt.ground * rate];
                Self::Oscillator { oscillator, part: [-q, speed - v], force, steady }
            }
            _ => {
                let along = |x: f64| DVec3::new(x, 0.0, 0.0);
                let (k, c) = (glam::DMat3::from_diagonal(along(felt.omega2)), along(felt.damping));
                let c = glam::DMat3::from_diagonal(c);
                let system = CoupledPropagator::new(k, c, along(felt.force), along(felt.ground), drive, longest);
                let mut start = Box::new([0.0; matrix_exponential::SIZE]);
                (start[POSITIONS], start[matrix_exponential::ONE]) = (speed, 1.0);
                (start[matrix_exponential::VALUE], start[matrix_exponential::VALUE + 1]) = (value, rate);
                if matches!(ground, Ground::Sine { .. }) {
                    (start[matrix_exponential::SIN], start[matrix_exponential::SIN + 1]) =
                        (drive * t + phase).sin_cos();
                }
                Self::Matrix { system: Box::new(system), start, felt: *felt }
            }
        }
    }

    /// `[u, u̇]` at `t` of what began at `from`.
    fn at(&self, from: f64, t: f64) -> [f64; 2] {
        let tau = t - from;
        match self {
            Self::Oscillator { oscillator, part, force, steady } => {
                let ([q, v], [u, rate]) = (steady.at(t), oscillator.advance(*part, *force, tau));
                [u + q, rate + v]
            }
            Self::Matrix { system, start, .. } => {
                let z = system.advance(start, tau.max(0.0));
                [z[0], z[POSITIONS]]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::model::compiled_model::Model;

    /// `u`, `u̇` after `end` \[s\] by the classical method of Runge and Kutta.
    fn integrated(slope: impl Fn(f64, [f64; 2]) -> [f64; 2], speed: f64, end: f64) -> [f64; 2] {
        let (steps, mut y) = (2000, [0.0, speed]);
        let h = end / f64::from(steps);
        let add = |y: [f64; 2], k: [f64; 2], part: f64| [y[0] + part * h * k[0], y[1] + part * h * k[1]];
        for i in 0..steps {
            let t = h * f64::from(i);
            let k1 = slope(t, y);
            let k2 = slope(t + 0.5 * h, add(y, k1, 0.5));
            let k3 = slope(t + 0.5 * h, add(y, k2, 0.5));
            let k4 = slope(t + h, add(y, k3, 1.0));
            y = [0, 1].map(|j| y[j] + h / 6.0 * (k1[j] + 2.0 * (k2[j] + k3[j]) + k4[j]));
        }
        y
    }

    #[test]
    fn the_closed_form_solves_its_equation() {
        let mut scene = crate::scene::presets::load("skew60-abutment").expect("a preset");
        scene.girders[0].push.force = [5.0, 3.0, 0.0];
        let model = Model::compile(&scene).expect("a sound scene");
        let girder = &model.bodies[0];
        let normal = DVec2::from_angle(2.5);
        let piece = model.ground.piece(0);
        for friction in [-0.15, 0.0, 0.15, 2.0] {
            let s = normal.perp();
            let d = s + normal * friction;
            let start = [0.01, -0.02, 0.0, 0.3 * s.x, 0.3 * s.y, 0.0];
            let slide = SlidingFace::new((girder, &model.ground), [s, d], &piece, (0.0, &start), 0.2);
            let q = DVec3::new(start[0], start[1], 0.0);
            let slope = |t: f64, [u, v]: [f64; 2]| {
                let along = s.extend(0.0);
                let force =
                    girder.push - girder.planar.stiffness * (q + along * u) - girder.planar.damping * (along * v);
                let a = force.truncate() / girder.mass - model.ground.acceleration(t).truncate();
                [v, d.dot(a)]
            };
            let [u, v] = integrated(slope, 0.3, 0.2);
            let state = slide.state(0.2);
            let place = DVec2::new(state[0] - start[0], state[1] - start[1]);
            let velocity = DVec2::new(state[3], state[4]);
            assert!((place - s * u).length() < 1e-11, "μ_k σ = {friction}: {place} against {}", s * u);
            assert!((velocity - s * v).length() < 1e-10, "μ_k σ = {friction}: {velocity} against {}", s * v);
        }
    }
}
