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
