//! Friction law `paper`: (55)–(59) in continuous time (`docs/physics.md#law-paper`).
//!
//! In slip the anchor is the projection of the node: tangential spring and dashpot are zero, and friction `μ_k |F_n|`
//! opposes the sliding velocity. On return to stick the tangential force restarts from 0, so that a static load
//! creeps; `return_mapping` holds one.

use glam::DVec2;

use crate::contact::constants::SLIDING_ROUNDING;
use crate::contact::{Breakaway, Forces, FrictionRule, Law, Local, Mode, SlipDirection};

/// Friction law `paper`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paper;

impl FrictionRule for Paper {
    /// (57b), (59). With one direction of sliding, friction opposes `direction` until `V_t` stops; with two, it opposes
    /// `V_t / max(|V_t|, v_stick)`.
    fn slip(&self, law: &Law, direction: DVec2, here: &Local) -> Forces {
        let pressed = law.pressed(here, DVec2::ZERO);
        let sliding = pressed.sliding;
        let along = law.along_velocity(sliding, direction);
        Forces { tangential: along * (-law.mu_k * pressed.normal), anchor_rate: sliding, ..pressed }
    }

    /// Through 0 when `V_t` stops (`docs/physics.md#stop`). With two directions of sliding it is quadratic in `V_t` and positive
    /// for a short time only, which its second difference shows on either side; `|V_t|` itself has a kink there.
    fn stopping(&self, law: &Law, direction: DVec2, here: &Local) -> f64 {
        let (sliding, _) = law.velocity(here, DVec2::ZERO);
        if law.v_stick > 0.0 {
            0.5 * (law.v_stick - sliding.length_squared() / law.v_stick)
        } else {
            -sliding.dot(direction)
        }
    }

    /// Friction opposes `V_t`, whatever its direction; for zero `V_t` it points along the spring's pull.
    fn breakaway(&self, law: &Law, anchor: DVec2, here: &Local) -> Breakaway {
        let stretch = here.way - anchor;
        let (sliding, normal) = law.velocity(here, DVec2::ZERO);
        let speed = sliding.length();
        let still = SLIDING_ROUNDING * (speed + normal.abs());
        let direction = if speed > still { sliding / speed } else { stretch.try_normalize().unwrap_or(DVec2::X) };
        Breakaway { mode: Mode::Slip { direction }, released: 0.5 * law.k_t * stretch.length_squared() }
    }

    /// The anchor is the projection.
    fn on_stopping(&self, _: &Law, _: DVec2, here: &Local) -> Mode {
        Mode::Stick { anchor: here.way }
    }

    fn direction(&self) -> SlipDirection {
        SlipDirection::OfVelocity
    }

    /// The tangential force restarts at 0.
    fn is_continuous_at_stop(&self) -> bool {
        false
    }

    fn is_damped_in_slip(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::FrictionLaw;
    use crate::contact::friction::example::{agree, law, node};

    #[test]
    fn friction_of_a_slip_is_mu_k_n_against_the_sliding_without_a_spring() {
        let law = law(FrictionLaw::Paper);
        let forces = law.forces(&Mode::Slip { direction: DVec2::X }, &node(5e-4, 0.1));
        agree("friction", forces.tangential_total().x, -law.mu_k * forces.normal);
        assert_eq!(forces.stretch, DVec2::ZERO, "the anchor is the projection");
    }

    #[test]
    fn below_the_regularising_speed_friction_is_in_proportion_to_the_speed() {
        let law = Law { v_stick: 0.01, ..law(FrictionLaw::Paper) };
        let at = |rate: f64| Paper.slip(&law, DVec2::X, &node(0.0, rate)).tangential.x;
        agree("half the speed, half the force", at(0.005), 0.5 * at(0.01));
        agree("above it all of it", at(0.02), at(0.01));
    }

    #[test]
    fn a_slip_stops_where_its_velocity_does_and_its_force_restarts_at_zero() {
        let law = law(FrictionLaw::Paper);
        assert!(Paper.stopping(&law, DVec2::X, &node(0.0, 1e-9)) < 0.0, "it slides");
        assert!(Paper.stopping(&law, DVec2::X, &node(0.0, -1e-9)) > 0.0, "it has stopped");
        let stopped = law.on_stopping(DVec2::X, &node(5e-4, 0.0));
        assert_eq!(law.forces(&stopped, &node(5e-4, 0.0)).tangential, DVec2::ZERO, "a new anchor");
    }

    #[test]
    fn breakaway_releases_the_whole_spring() {
        let law = law(FrictionLaw::Paper);
        let out = Paper.breakaway(&law, DVec2::ZERO, &node(1e-3, 0.0));
        agree("½ k_t s²", out.released, 0.05);
        assert_eq!(out.mode, Mode::Slip { direction: DVec2::X }, "at rest, along the stretch");
        let back = Paper.breakaway(&law, DVec2::ZERO, &node(1e-3, -0.1));
        assert_eq!(back.mode, Mode::Slip { direction: DVec2::NEG_X }, "moving, along the velocity");
    }
}
