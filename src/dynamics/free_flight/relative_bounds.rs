//! Upper bounds of the relative displacement, speed and acceleration of two girders: sharper than the sum of both.
//!
//! Under one ground motion the steady responses of like girders cancel, and the difference of two free motions of like
//! oscillators is a free motion itself, whose energy never grows. In a row that moves in phase no gap can close, and none is
//! evaluated until a girder of it is hit.

use crate::dynamics::free_flight::constants::OSCILLATOR_ROUNDING;
use crate::dynamics::free_flight::flight::{FreeMotion, FreeMotionForm};
use crate::dynamics::free_flight::oscillator::Phasor;
use crate::dynamics::free_flight::uncoupled_axis::UncoupledAxis;
use crate::dynamics::model::coordinates::planar::{PlanarState, part};
use crate::dynamics::model::motion_bounds::MotionBounds;

/// A body in flight: bounds on its motion, and more where it is a rigid girder in plan.
pub(in crate::dynamics) struct BodyInFlight<'a> {
    pub bound: MotionBounds,
    pub girder: Option<GirderInFlight<'a>>,
}

/// A girder in flight: its system, its state, and the free part of it where that is split off.
pub(in crate::dynamics) struct GirderInFlight<'a> {
    pub free_motion: &'a FreeMotion,
    pub state: PlanarState,
    pub free: Option<PlanarState>,
}

/// Bounds on the difference of two motions of G over `[t, t + window]`. Rotations have bounds of their own, which hold as
/// long where nothing couples them.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct RelativeBounds {
    /// Displacement \[m\].
    pub reach: f64,
    /// Speed \[m/s\].
    pub speed: f64,
    /// Acceleration \[m/s²\].
    pub acceleration: f64,
    /// Time for which they hold \[s\].
    pub window: f64,
}

impl RelativeBounds {
    /// Of two sides, one of which may stand.
    pub(in crate::dynamics) fn of(sides: &[Option<BodyInFlight<'_>>; 2], horizon: f64) -> Self {
        match sides {
            [Some(a), Some(b)] => Self::between(a, b, horizon).unwrap_or_else(|| Self::sum(&a.bound, &b.bound)),
            [Some(a), None] | [None, Some(a)] => Self::sum(&a.bound, &MotionBounds::still(horizon)),
            [None, None] => Self::sum(&MotionBounds::still(horizon), &MotionBounds::still(horizon)),
        }
    }

    fn sum(a: &MotionBounds, b: &MotionBounds) -> Self {
        Self {
            reach: a.reach + b.reach,
            speed: a.speed + b.speed,
            acceleration: a.acceleration + b.acceleration,
            window: a.window.min(b.window),
        }
    }

    /// Bounds on the relative motion of two girders in flight; `None` where no bound is tighter than the sum of both.
    fn between(one: &BodyInFlight<'_>, other: &BodyInFlight<'_>, horizon: f64) -> Option<Self> {
        let (a, b) = (one.girder.as_ref()?, other.girder.as_ref()?);
        let (first, second) = (a.dofs()?, b.dofs()?);
        let (mut limits, mut window) = ([[0.0; 3]; 2], horizon);
        for (i, limit) in limits.iter_mut().enumerate() {
            let dofs = [&first[i], &second[i]];
            let pushes = [a.free_motion.push[i], b.free_motion.push[i]];
            let free = dofs[0].free && dofs[1].free;
            let like = dofs[0].oscillator == dofs[1].oscillator && free;
            *limit = match (&a.free, &b.free) {
                (Some(p), Some(q)) if like => {
                    difference(dofs, [part(p, i), part(q, i)], pushes, drive(a.free_motion), horizon)
                }
                // Under one ground motion its force itself cancels.
                _ if like => {
                    let plain = [
                        &UncoupledAxis { steady: Phasor::default(), ..*dofs[0] },
                        &UncoupledAxis { steady: Phasor::default(), ..*dofs[1] },
                    ];
                    difference(plain, [part(&a.state, i), part(&b.state, i)], pushes, 0.0, horizon)
                }
                _ if free && alike(dofs) => {
                    window = window.min(other.bound.window);
                    nearly(dofs, [&a.state, &b.state], i, pushes, &other.bound, window)
                }
                (Some(p), Some(q)) => both(dofs, [part(p, i), part(q, i)], pushes, drive(a.free_motion), horizon),
                _ => return None,
            };
        }
        let plan = |k: usize| (limits[0][k] * limits[0][k] + limits[1][k] * limits[1][k]).sqrt();
        Some(Self { reach: plan(0), speed: plan(1), acceleration: plan(2), window })
    }
}

impl GirderInFlight<'_> {
    /// Its directions, where nothing couples them.
    fn dofs(&self) -> Option<&[UncoupledAxis; 3]> {
        match &self.free_motion.form {
            FreeMotionForm::Split { dof, .. } => Some(dof),
            FreeMotionForm::Coupled(..) => self.free_motion.plain.as_ref(),
        }
    }
}

/// Whether two oscillators are equal within round-off: girders of one frequency and different masses.
pub(in crate::dynamics) fn alike([a, b]: [&UncoupledAxis; 2]) -> bool {
    let near = |x: f64, y: f64| (x - y).abs() <= OSCILLATOR_ROUNDING * x.abs().max(y.abs());
    near(a.oscillator.omega2, b.oscillator.omega2) && near(a.oscillator.gamma, b.oscillator.gamma)
}

/// The difference of two motions of oscillators that are nearly one: the first's free motion, driven by what the second's
/// differs from it. The root of its energy, `√(v² + ω²q²)`, grows by no more than that force.
fn nearly(
    dofs: [&UncoupledAxis; 2],
    [p, q]: [&PlanarState; 2],
    i: usize,
    push: [f64; 2],
    second: &MotionBounds,
    horizon: f64,
) -> [f64; 3] {
    let dof = UncoupledAxis { steady: Phasor::default(), amplitude: 0.0, ..*dofs[0] };
    let [one, other] = dofs.map(|dof| dof.oscillator);
    let force = (one.omega2 - other.omega2).abs() * second.reach + 2.0 * (one.gamma - other.gamma).abs() * second.speed;
    let ([p, u], [q, v]) = (part(p, i), part(q, i));
    let [reach, speed, acceleration] = dof.limits([p - q, u - v], 0.0, push[0] - push[1], horizon);
    let (omega, more) = (one.omega(), force * horizon);
    let further = if omega > 0.0 { (more / omega).min(more * horizon) } else { more * horizon };
    [reach + further, speed + more, acceleration + (2.0 * one.gamma + omega) * more + force]
}

fn drive(free_motion: &FreeMotion) -> f64 {
    free_motion.ground.drive()
}

/// The phasors' difference as an amplitude \[m\].
fn amplitude([a, b]: [&UncoupledAxis; 2]) -> f64 {
    (a.steady.re - b.steady.re).hypot(a.steady.im - b.steady.im)
}

/// Bounds on the difference of two flights along one direction, from the free parts of both: displacement, speed,
/// acceleration.
pub(in crate::dynamics) fn limits(
    dofs: [&UncoupledAxis; 2],
    free: [[f64; 2]; 2],
    push: [f64; 2],
    drive: f64,
    horizon: f64,
) -> [f64; 3] {
    let like = dofs[0].oscillator == dofs[1].oscillator && dofs[0].free && dofs[1].free;
    if like { difference(dofs, free, push, drive, horizon) } else { both(dofs, free, push, drive, horizon) }
}

fn difference(dofs: [&UncoupledAxis; 2], [p, q]: [[f64; 2]; 2], push: [f64; 2], drive: f64, horizon: f64) -> [f64; 3] {
    let dof = UncoupledAxis { amplitude: amplitude(dofs), ..*dofs[0] };
    dof.limits([p[0] - q[0], p[1] - q[1]], drive, push[0] - push[1], horizon)
}

fn both(dofs: [&UncoupledAxis; 2], free: [[f64; 2]; 2], push: [f64; 2], drive: f64, horizon: f64) -> [f64; 3] {
    let steady = amplitude(dofs);
    let mut sum = [steady, drive * steady, drive * drive * steady];
    for ((dof, part), push) in dofs.into_iter().zip(free).zip(push) {
        let free = UncoupledAxis { amplitude: 0.0, ..*dof }.limits(part, drive, push, horizon);
        (0..3).for_each(|k| sum[k] += free[k]);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::free_flight::oscillator::Oscillator;

    #[test]
    fn oscillators_that_differ_by_rounding_stay_together_as_long_as_said() {
        let dof = |omega2: f64| {
            let oscillator = Oscillator { gamma: 0.01, omega2 };
            UncoupledAxis { oscillator, free: true, steady: Phasor::default(), amplitude: 0.0 }
        };
        let (a, b) = (dof(9.0), dof(9.0 * (1.0 + 5e-13)));
        assert!(alike([&a, &b]) && !alike([&a, &dof(9.001)]), "rounding, and more than it");
        let (start, horizon) = ([1.0, 0.0, 0.0, 0.5, 0.0, 0.0], 40.0);
        let second = MotionBounds { reach: 1.1, speed: 3.1, ..MotionBounds::still(horizon) };
        let [reach, speed, _] = nearly([&a, &b], [&start, &start], 0, [0.0; 2], &second, horizon);
        let mut worst = [0.0f64; 2];
        for k in 0..400 {
            let t = horizon * f64::from(k) / 400.0;
            let [p, q] = [a, b].map(|dof| dof.oscillator.advance([1.0, 0.5], [0.0; 2], t));
            worst = [worst[0].max((p[0] - q[0]).abs()), worst[1].max((p[1] - q[1]).abs())];
        }
        assert!(worst[0] <= reach && worst[1] <= speed, "{worst:?} against {reach}, {speed}");
        assert!(reach < 1e-9, "far less than each by itself: {reach}");
    }
}
