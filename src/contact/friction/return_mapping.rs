//! Friction law `return-mapping`: elastic-plastic Coulomb friction after Cundall and Strack (1979), the default
//! (`docs/physics.md#law-return-mapping`).
//!
//! In slip the anchor is dragged so that the spring carries exactly `μ_k |F_n|`: the stretch is `s = μ_k ℓ d` with
//! `ℓ = N/k_t`, which is δ of a linear law with one stiffness. The tangential dashpot acts on the rate of the spring's
//! own stretch, `−C_t (V_t − q̇)`, with q̇ the rate of the anchor along the face, so that the force is continuous on
//! return to stick. Breakaway at `μ_s` reduces the stretch to `μ_k`.

use glam::DVec2;

use crate::contact::{Breakaway, Forces, FrictionRule, Law, Local, Mode, SlipDirection};

/// Friction law `return-mapping`.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReturnMapping;

impl FrictionRule for ReturnMapping {
    /// In the direction `d` of the stretch. A `d` that turns (two directions of sliding) is a state of the integrator.
    fn slip(&self, law: &Law, direction: DVec2, here: &Local) -> Forces {
        let stretch = direction * (law.mu_k * law.length(here));
        let pressed = law.pressed(here, stretch);
        let anchor_rate = here.rate + direction * (law.mu_k * law.length_slope(here) * here.gap_rate);
        Forces {
            tangential: stretch * -law.k_t,
            tangential_damping: (pressed.sliding - anchor_rate) * -law.c_t,
            anchor_rate,
            ..pressed
        }
    }

    /// Besides its length, the direction of the stretch changes: rate of the anchor across it, reduced by the regularisation.
    fn slip_turning(&self, law: &Law, direction: DVec2, here: &Local, regularisation: f64) -> Forces {
        let mut forces = self.slip(law, direction, here);
        let length = law.slip_stretch(here);
        let across = direction.perp();
        forces.anchor_rate -= across * (across.dot(here.rate) * length / (length + regularisation));
        forces.tangential_damping = (forces.sliding - forces.anchor_rate) * -law.c_t;
        forces
    }

    /// Through 0 when the plastic rate `λ = q̇·d` returns to 0 (`docs/physics.md#stop`).
    ///
    /// With `μ_k = 0` there is no stretch to define d: d is the direction of sliding, and in two directions of sliding
    /// there is no return to stick.
    fn stopping(&self, law: &Law, direction: DVec2, here: &Local) -> f64 {
        if law.mu_k == 0.0 && law.v_stick > 0.0 {
            return -here.rate.length();
        }
        -(here.rate.dot(direction) + law.mu_k * law.length_slope(here) * here.gap_rate)
    }

    /// The stretch is reduced along itself from `μ_s ℓ` to `μ_k ℓ`.
    fn breakaway(&self, law: &Law, anchor: DVec2, here: &Local) -> Breakaway {
        let stretch = here.way - anchor;
        // Without a stretch the direction of slip is that of the velocity.
        let (sliding, _) = law.velocity(here, stretch);
        let direction = stretch.try_normalize().or(sliding.try_normalize()).unwrap_or(DVec2::X);
        let kept = law.mu_k * law.length(here);
        Breakaway { mode: Mode::Slip { direction }, released: 0.5 * law.k_t * (stretch.length_squared() - kept * kept) }
    }

    /// The anchor stays, at `μ_k ℓ d` behind the projection.
    fn on_stopping(&self, law: &Law, direction: DVec2, here: &Local) -> Mode {
        Mode::Stick { anchor: here.way - direction * (law.mu_k * law.length(here)) }
    }

    fn direction(&self) -> SlipDirection {
        SlipDirection::State
    }

    fn is_continuous_at_stop(&self) -> bool {
        true
    }

    fn is_damped_in_slip(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::FrictionLaw;
    use crate::contact::friction::example::{agree, law, node};

    #[test]
    fn the_spring_of_a_slip_carries_mu_k_n() {
        let law = law(FrictionLaw::ReturnMapping);
        let forces = law.forces(&Mode::Slip { direction: DVec2::X }, &node(5e-4, 0.1));
        agree("friction", forces.tangential.x, -law.mu_k * forces.normal);
        agree("its stretch", forces.stretch.x, 8e-4);
        // At constant penetration the anchor moves with the node: the stretch has no rate and the dashpot no force.
        assert_eq!(forces.tangential_damping, DVec2::ZERO, "nothing is stretched further");
    }

    #[test]
    fn a_slip_stops_where_its_anchor_does() {
        let law = law(FrictionLaw::ReturnMapping);
        let pressed = |rate: f64| Local { gap_rate: -0.05, ..node(0.0, rate) };
        // λ = V − μ_k ℓ̇ with ℓ̇ = 2 · 0.05 m/s: 0 at V = 0.04 m/s.
        assert!(ReturnMapping.stopping(&law, DVec2::X, &pressed(0.041)) < 0.0, "the anchor is dragged");
        assert!(ReturnMapping.stopping(&law, DVec2::X, &pressed(0.039)) > 0.0, "the cone grows faster");
    }

    #[test]
    fn the_force_is_continuous_on_re_stick() {
        let (law, here) = (law(FrictionLaw::ReturnMapping), node(5e-4, 0.0));
        let slipping = law.forces(&Mode::Slip { direction: DVec2::X }, &here);
        let sticking = law.forces(&law.on_stopping(DVec2::X, &here), &here);
        agree("the same force", sticking.tangential.x, slipping.tangential.x);
    }

    #[test]
    fn breakaway_lets_the_spring_drop_to_the_kinetic_cone() {
        let law = law(FrictionLaw::ReturnMapping);
        let out = ReturnMapping.breakaway(&law, DVec2::ZERO, &node(1e-3, 0.0));
        agree("½ k_t (s² − (μ_k ℓ)²)", out.released, 0.05 * (1.0 - 0.64));
        assert_eq!(out.mode, Mode::Slip { direction: DVec2::X }, "along the stretch");
    }
}
