//! Scales and bounds of a contact law, for error scales, tolerances of switching functions and lengths of steps.

use super::law::{Law, Mode};
use super::node_face::Local;
use super::normal::NormalLaw;

impl Law {
    /// Scale of the switching function of stick at penetrations of this size, its limit `μ_s ℓ` \[m\].
    pub fn stick_scale(&self, depth: f64) -> f64 {
        self.mu_s * self.normal.length(depth, self.k_t)
    }

    /// Stretch `μ_k ℓ` of the tangential spring in slip at penetrations of this size \[m\].
    pub fn slip_scale(&self, depth: f64) -> f64 {
        self.mu_k * self.normal.length(depth, self.k_t)
    }

    /// That stretch with a coefficient of kinetic friction of at least `least` \[m\].
    pub fn slip_scale_of_at_least(&self, least: f64, depth: f64) -> f64 {
        self.mu_k.max(least) * self.normal.length(depth, self.k_t)
    }

    /// Largest stiffness of normal and tangential spring at penetrations up to `deepest` \[N/m\].
    pub fn stiffness_bound(&self, deepest: f64) -> f64 {
        self.normal.stiffness_bound(deepest).max(self.k_t)
    }

    /// Largest constant of normal and tangential dashpot at penetrations up to `deepest` \[N·s/m\].
    pub fn damping_bound(&self, deepest: f64) -> f64 {
        self.normal.damping_bound(deepest).max(self.c_t)
    }

    /// Constant of the tangential dashpot that acts in a mode; 0 for none \[N·s/m\].
    pub fn tangential_damping(&self, mode: &Mode) -> f64 {
        if matches!(mode, Mode::Stick { .. }) || self.friction.rule().is_damped_in_slip() { self.c_t } else { 0.0 }
    }

    /// Scale of the switching function of a kink at penetrations and speeds of these sizes, in the function's unit.
    pub fn kink_scale(&self, depth: f64, speed: f64) -> f64 {
        if self.normal.has_phases() {
            self.normal.phase_end_scale(depth, speed)
        } else {
            self.normal.force_scale(depth, speed)
        }
    }

    /// Scale of the change of the switching function of a kink by a change of the penetration of this size at this circular
    /// frequency, in the function's unit.
    pub fn kink_change(&self, here: &Local, change: f64, frequency: f64) -> f64 {
        if self.normal.has_phases() {
            self.normal.phase_end_change(change, frequency)
        } else {
            self.normal.change_scale(here.penetration(), change, frequency)
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::contact::FrictionLaw;
    use crate::contact::friction::example::{agree, law};

    #[test]
    fn lengths_are_those_of_the_tangential_spring_under_the_normal_force() {
        // ℓ = 2 δ, μ_s = 0.5, μ_k = 0.4.
        let law = law(FrictionLaw::Paper);
        agree("limit of stick", law.stick_scale(1e-3), 1e-3);
        agree("stretch in slip", law.slip_scale(1e-3), 0.8e-3);
        agree("of less friction", law.slip_scale_of_at_least(0.3, 1e-3), 0.8e-3);
        agree("of more", law.slip_scale_of_at_least(0.5, 1e-3), 1e-3);
    }

    #[test]
    fn bounds_are_those_of_the_stiffer_spring_and_of_the_dashpots_that_act() {
        let [paper, mapped] = [FrictionLaw::Paper, FrictionLaw::ReturnMapping].map(law);
        assert_eq!([paper.stiffness_bound(1e-3), paper.damping_bound(1e-3)], [2e5, 30.0], "normal spring, C_t");
        let slip = Mode::Slip { direction: DVec2::X };
        assert_eq!([&paper, &mapped].map(|law| law.tangential_damping(&slip)), [0.0, 30.0], "in slip");
        let stick = Mode::Stick { anchor: DVec2::ZERO };
        assert_eq!([&paper, &mapped].map(|law| law.tangential_damping(&stick)), [30.0; 2], "in stick");
    }
}
