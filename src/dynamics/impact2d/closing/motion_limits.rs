//! Bounds on displacement, speed, acceleration and jerk of a body in free flight, and of one body against another.
//!
//! Without a record every direction is an oscillator in closed form. Each time derivative `w` of its free part obeys the same
//! homogeneous equation, so `½(ẇ² + ω²w²)` never grows and bounds that derivative at all later times; the steady response to a
//! sine has the amplitudes `A, ΩA, Ω²A, Ω³A`.

use crate::dynamics::free_flight::flight::StateInFlight;
use crate::dynamics::free_flight::flight::{FreeMotion, FreeMotionForm};
use crate::dynamics::free_flight::uncoupled_axis::UncoupledAxis;
use crate::dynamics::impact2d::tracks::Trajectory;
use crate::dynamics::impact2d::world::World;
use crate::dynamics::model::coordinates::planar::{POSITIONS, PlanarState, part};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::motion::Ground;

/// Bounds `[displacement, speed, acceleration, jerk]` of a side.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::dynamics::impact2d) struct MotionLimits {
    /// Of G \[m\], \[m/s\], \[m/s²\], \[m/s³\].
    pub translation: [f64; 4],
    /// Of the rotation \[rad\], \[rad/s\], \[rad/s²\], \[rad/s³\].
    pub rotation: [f64; 4],
}

impl MotionLimits {
    /// Of a motion whose jerk has no bound.
    pub(in crate::dynamics::impact2d) fn of(bound: &MotionBounds) -> Self {
        Self {
            translation: [bound.reach, bound.speed, bound.acceleration, f64::INFINITY],
            rotation: [bound.turn, bound.spin, bound.spin_rate, f64::INFINITY],
        }
    }
}

/// A side in free flight at an instant.
pub(in crate::dynamics::impact2d) struct FlyingBody<'a> {
    pub free_motion: &'a FreeMotion,
    pub state: PlanarState,
    /// State less the steady response to a sine; none where the directions are coupled.
    pub free: Option<PlanarState>,
    horizon: f64,
}

impl<'a> FlyingBody<'a> {
    /// The body in a slot at `t`, for bounds over the next `horizon` \[s\]; none in lasting contact.
    pub(in crate::dynamics::impact2d) fn of(world: &'a World, slot: usize, t: f64, horizon: f64) -> Option<Self> {
        let track = &world.bodies[slot];
        let Trajectory::Flight(flight) = &track.motion else { return None };
        let StateInFlight { state, free } = track.free_motion.parts(flight, t);
        Some(Self { free_motion: &track.free_motion, state, free, horizon })
    }

    /// Oscillators and free part, where the directions are uncoupled.
    pub(in crate::dynamics::impact2d) fn uncoupled(&self) -> Option<(&'a [UncoupledAxis; 3], &PlanarState)> {
        match (&self.free_motion.form, &self.free) {
            (FreeMotionForm::Split { dof, .. }, Some(free)) => Some((dof, free)),
            _ => None,
        }
    }

    /// Whether bearings act in every direction in which the body is free.
    pub(in crate::dynamics::impact2d) fn is_bound(&self) -> bool {
        self.uncoupled().is_some_and(|(dof, _)| dof.iter().all(|dof| !dof.free || dof.oscillator.omega2 > 0.0))
    }

    fn drive(&self) -> f64 {
        if let Ground::Sine { omega, .. } = self.free_motion.ground { omega } else { 0.0 }
    }

    /// `(ẍ, ÿ, θ̈)`, where the directions are uncoupled \[m/s²\], \[rad/s²\].
    pub(in crate::dynamics::impact2d) fn acceleration(&self) -> Option<[f64; 3]> {
        let (dof, free) = self.uncoupled()?;
        let drive = self.drive();
        Some(std::array::from_fn(|i| {
            let steady = -drive * drive * (self.state[i] - free[i]);
            let o = &dof[i].oscillator;
            if dof[i].free {
                steady + self.free_motion.push[i] - 2.0 * o.gamma * free[POSITIONS + i] - o.omega2 * free[i]
            } else {
                0.0
            }
        }))
    }

    /// Bounds that hold for a while, whatever the directions.
    pub(in crate::dynamics::impact2d) fn bound(&self, t: f64) -> MotionBounds {
        self.free_motion.bound_from(t, &self.state, self.free.as_ref(), self.horizon)
    }

    /// Bounds from here on, where the directions are uncoupled.
    pub(in crate::dynamics::impact2d) fn limits(&self) -> Option<MotionLimits> {
        let (dof, free) = self.uncoupled()?;
        let drive = self.drive();
        let limits =
            |i: usize| limits(&dof[i], dof[i].amplitude, part(free, i), drive, self.free_motion.push[i], self.horizon);
        let (x, y, rotation) = (limits(0), limits(1), limits(2));
        Some(MotionLimits { translation: std::array::from_fn(|k| norm(x[k], y[k])), rotation })
    }
}

/// Bounds `[displacement, speed, acceleration, jerk]` of one direction: free part `(q, v)`, steady response of this amplitude
/// to a sine of frequency `drive` \[rad/s\], constant push \[m/s²\]. Over `horizon` \[s\] where no bearing acts.
fn limits(dof: &UncoupledAxis, amplitude: f64, [q, v]: [f64; 2], drive: f64, push: f64, horizon: f64) -> [f64; 4] {
    if !dof.free {
        return [q.abs(), 0.0, 0.0, 0.0];
    }
    let mut all = [amplitude, drive * amplitude, drive * drive * amplitude, drive * drive * drive * amplitude];
    if q == 0.0 && v == 0.0 && push == 0.0 {
        return all;
    }
    let (omega2, damping) = (dof.oscillator.omega2, 2.0 * dof.oscillator.gamma);
    let omega = dof.oscillator.omega();
    let rest = if omega > 0.0 { push / omega2 } else { 0.0 };
    let a = push - damping * v - omega2 * q;
    let j = -damping * a - omega2 * v;
    let loose = if omega > 0.0 { 0.0 } else { push.abs() * horizon };
    let speed = norm(v, omega * (q - rest)) + loose;
    all[0] += if omega > 0.0 { rest.abs() + speed / omega } else { q.abs() + speed * horizon };
    all[1] += speed;
    all[2] += norm(a, omega * v);
    all[3] += norm(j, omega * a);
    all
}

/// Bounds on the motion of G of one flight relative to another's; steady responses of like girders to one ground cancel.
pub(in crate::dynamics::impact2d) fn relative_limits(a: &FlyingBody<'_>, b: &FlyingBody<'_>) -> Option<[f64; 4]> {
    let ((first, p), (second, q)) = (a.uncoupled()?, b.uncoupled()?);
    let drive = a.drive();
    let mut all = [[0.0; 4]; 2];
    for (i, limit) in all.iter_mut().enumerate() {
        let (one, other) = (&first[i], &second[i]);
        let steady = norm(one.steady.re - other.steady.re, one.steady.im - other.steady.im);
        let [push, pull] = [a.free_motion.push[i], b.free_motion.push[i]];
        if one.oscillator == other.oscillator && one.free && other.free {
            let difference = [p[i] - q[i], p[POSITIONS + i] - q[POSITIONS + i]];
            *limit = limits(one, steady, difference, drive, push - pull, a.horizon);
        } else {
            let x = limits(one, 0.0, part(p, i), drive, push, a.horizon);
            let y = limits(other, 0.0, part(q, i), drive, pull, a.horizon);
            let driven = [steady, drive * steady, drive * drive * steady, drive * drive * drive * steady];
            *limit = std::array::from_fn(|k| x[k] + y[k] + driven[k]);
        }
    }
    Some(std::array::from_fn(|k| norm(all[0][k], all[1][k])))
}

/// `√(a² + b²)`, without the guards of `hypot` against overflow: lengths and speeds are far from it.
fn norm(a: f64, b: f64) -> f64 {
    if b == 0.0 { a.abs() } else { (a * a + b * b).sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;

    /// A preset's group after a free start with this velocity \[m/s\].
    fn world(preset: &str) -> World {
        example::world(example::preset(preset, |scene| {
            for girder in &mut scene.girders {
                girder.initial.velocity = [0.2, -0.1, 0.0];
                girder.initial.spin_deg_s = 30.0;
            }
        }))
    }

    #[test]
    fn no_later_state_exceeds_the_limits() {
        let world = world("straight-abutment");
        let flying = FlyingBody::of(&world, 0, 0.0, 10.0).expect("in flight");
        let limits = flying.limits().expect("uncoupled");
        for k in 0..2000 {
            let now = FlyingBody::of(&world, 0, 1e-3 * f64::from(k), 10.0).expect("in flight");
            let a = now.acceleration().expect("uncoupled");
            let (s, slack) = (now.state, 1.0 + 1e-12);
            let translation = [s[0].hypot(s[1]), s[3].hypot(s[4]), a[0].hypot(a[1])];
            let rotation = [s[2].abs(), s[5].abs(), a[2].abs()];
            for i in 0..3 {
                assert!(translation[i] <= slack * limits.translation[i], "derivative {i} of the place at {k} ms");
                assert!(rotation[i] <= slack * limits.rotation[i], "derivative {i} of the angle at {k} ms");
            }
        }
    }

    #[test]
    fn the_acceleration_is_the_derivative_of_the_velocity() {
        let world = world("straight-abutment");
        let at = |t: f64| FlyingBody::of(&world, 0, t, 1.0).expect("in flight");
        let (t, h) = (0.123, 1e-5);
        for (i, a) in at(t).acceleration().expect("uncoupled").into_iter().enumerate() {
            let difference = (at(t + h).state[POSITIONS + i] - at(t - h).state[POSITIONS + i]) / (2.0 * h);
            assert!((a - difference).abs() < 1e-6 * (1.0 + a.abs()), "component {i}: {a} against {difference}");
        }
    }

    #[test]
    fn a_held_direction_has_its_place_and_no_rates() {
        let world = world("straight-abutment");
        let flying = FlyingBody::of(&world, 0, 0.0, 1.0).expect("in flight");
        let (dof, _) = flying.uncoupled().expect("uncoupled");
        let held = UncoupledAxis { free: false, ..dof[0] };
        assert_eq!(limits(&held, 1.0, [-0.3, 2.0], 5.0, 1.0, 1.0), [0.3, 0.0, 0.0, 0.0], "whatever acts");
    }
}
