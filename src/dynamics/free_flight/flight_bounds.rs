//! Upper bounds of displacement, speed and acceleration in flight, for conservative advancement.

use glam::DVec3;

use crate::dynamics::free_flight::constants::BOUND_PHASE;
use crate::dynamics::free_flight::flight::{Flight, FreeMotion, FreeMotionForm, StateInFlight};
use crate::dynamics::free_flight::uncoupled_axis::UncoupledAxis;
use crate::dynamics::model::coordinates::planar::{self, PlanarState};
use crate::dynamics::model::motion_bounds::MotionBounds;

/// The constant push on a girder, by its springs.
struct ConstantPush {
    /// Static displacement by it \[m, rad\].
    rest: DVec3,
    /// Part along directions without a spring, per unit mass; all of it where directions are coupled \[m/s², rad/s²\].
    unheld: DVec3,
}

impl FreeMotion {
    /// Bound of its circular frequencies, of bearings, dashpots and a sine of the ground \[rad/s\].
    pub(in crate::dynamics) fn fastest(&self) -> f64 {
        let [omega, damping] = self.rates;
        omega.max(damping).max(self.ground.drive())
    }

    /// State at `t` in `flight`, and bounds on the motion from there for at most `horizon` \[s\].
    pub fn state_and_bounds(&self, flight: &Flight, t: f64, horizon: f64) -> (PlanarState, MotionBounds) {
        let StateInFlight { state, free } = self.parts(flight, t);
        (state, self.bound_from(t, &state, free.as_ref(), horizon))
    }

    /// Bounds on the motion from `t`, where it is at `state`, for at most `horizon` \[s\].
    ///
    /// The energy per mass of a free part never grows, which bounds it for ever after; where the force is not split off,
    /// its work bounds it over a short window.
    pub fn bound(&self, t: f64, state: &PlanarState, horizon: f64) -> MotionBounds {
        self.bound_from(t, state, None, horizon)
    }

    /// Bounds from `t`, given the free part if it has been computed.
    pub(in crate::dynamics) fn bound_from(
        &self,
        t: f64,
        state: &PlanarState,
        free: Option<&PlanarState>,
        horizon: f64,
    ) -> MotionBounds {
        match (&self.form, free) {
            (FreeMotionForm::Split { dof, .. }, Some(free)) => self.bound_split(dof, free, horizon),
            (FreeMotionForm::Split { dof, .. }, None) if !self.has_kinks() => {
                let steady = self.steady(dof, t);
                self.bound_split(dof, &std::array::from_fn(|i| state[i] - steady[i]), horizon)
            }
            _ => {
                let whole = self.bound_whole(state, horizon);
                let Some(dof) = &self.plain else { return whole };
                // The ground drives G, never the rotation.
                let [turn, spin, spin_rate] = dof[2].limits(planar::part(state, 2), 0.0, self.push[2], horizon);
                MotionBounds { turn, spin, spin_rate, ..whole }
            }
        }
    }

    /// From the free parts, three displacements and their rates.
    fn bound_split(&self, dof: &[UncoupledAxis; 3], free: &PlanarState, horizon: f64) -> MotionBounds {
        let drive = self.ground.drive();
        let limits: [[f64; 3]; 3] =
            std::array::from_fn(|i| dof[i].limits(planar::part(free, i), drive, self.push[i], horizon));
        let plan = |k: usize| length(limits[0][k], limits[1][k]);
        MotionBounds {
            window: horizon,
            reach: plan(0),
            turn: limits[2][0],
            speed: plan(1),
            spin: limits[2][1],
            acceleration: plan(2),
            spin_rate: limits[2][2],
        }
    }

    fn bound_whole(&self, state: &PlanarState, horizon: f64) -> MotionBounds {
        let [omega, damping] = self.rates;
        let window = horizon.min(BOUND_PHASE / omega.max(damping).max(f64::MIN_POSITIVE));
        let i = self.gyration;
        let in_lengths = |v: DVec3| v * DVec3::new(1.0, 1.0, i);
        // A push on a spring moves the place of rest and does no work about that.
        let ConstantPush { rest, unheld } = self.constant_push();
        let force = self.ground.peak() + in_lengths(unheld).length();
        let speed0 = in_lengths(planar::rates(state)).length();
        let place = planar::positions(state);
        let speed = speed0.hypot(omega * in_lengths(place - rest).length()) + force * window;
        let acceleration = (damping + omega) * speed + force;
        let reach = in_lengths(place).length() + speed * window;
        MotionBounds {
            window,
            reach,
            turn: reach / i,
            speed,
            spin: speed / i,
            acceleration,
            spin_rate: acceleration / i,
        }
    }

    fn constant_push(&self) -> ConstantPush {
        let (mut rest, mut unheld) = (DVec3::ZERO, DVec3::from(self.push));
        for (i, axis) in self.plain.iter().flatten().enumerate() {
            if axis.free && axis.oscillator.omega2 > 0.0 {
                rest[i] = unheld[i] / axis.oscillator.omega2;
                unheld[i] = 0.0;
            }
        }
        ConstantPush { rest, unheld }
    }
}

impl UncoupledAxis {
    /// `[displacement, speed, acceleration]` that free part, steady response and push never exceed.
    pub(in crate::dynamics) fn limits(&self, [q, v]: [f64; 2], drive: f64, push: f64, horizon: f64) -> [f64; 3] {
        if !self.free {
            return [q.abs(), 0.0, 0.0];
        }
        let (omega, gamma) = (self.oscillator.omega(), self.oscillator.gamma);
        let amplitude = self.amplitude;
        let resting = if omega > 0.0 { push / self.oscillator.omega2 } else { 0.0 };
        let driven = if omega > 0.0 { 0.0 } else { push.abs() };
        let speed = length(v, omega * (q - resting)) + driven * horizon;
        let free_reach = if omega > 0.0 { resting.abs() + speed / omega } else { q.abs() + speed * horizon };
        [
            free_reach + amplitude,
            speed + drive * amplitude,
            (2.0 * gamma + omega) * speed + driven + drive * drive * amplitude,
        ]
    }
}

/// `√(a² + b²)` without protection against overflow.
fn length(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}
