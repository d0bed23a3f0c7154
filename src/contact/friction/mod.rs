//! Friction laws: tangential force, anchor and switching functions of a contact in stick or slip
//! (`docs/physics.md#friction-laws`).
//!
//! The normal force enters as a length, `ℓ(δ) = N(δ)/k_t`, the stretch of the tangential spring that carries it: the
//! cone `|F_t| ≤ μ_s N` is `|s| ≤ μ_s ℓ`. With `N = K δ` and `k_t = K`, as in the paper, ℓ = δ.
//!
//! A law is an implementation of [`FrictionRule`]: one file here, a variant of [`FrictionLaw`] and its arm in [`FrictionLaw::rule`]; from
//! outside of the package [`Friction::Custom`].

mod paper;
mod return_mapping;

use glam::DVec2;

use super::law::{Breakaway, Forces, Friction, FrictionLaw, FrictionRule, Law, Mode, SlidingDerivative, SlipDirection};
use super::node_face::Local;
use paper::Paper;
use return_mapping::ReturnMapping;

impl FrictionLaw {
    /// The law of this name.
    pub fn rule(self) -> &'static dyn FrictionRule {
        match self {
            Self::Paper => &Paper,
            Self::ReturnMapping => &ReturnMapping,
        }
    }
}

impl Friction {
    /// The law.
    pub fn rule(&self) -> &'static dyn FrictionRule {
        match self {
            Self::Named(law) => law.rule(),
            Self::Custom(rule) => *rule,
        }
    }
}

impl Law {
    /// Direction of friction in slip, in the directions of sliding that the contact has.
    #[inline]
    pub fn slip_direction(&self) -> SlipDirection {
        // At μ_k = 0 friction vanishes and has no direction.
        if self.v_stick > 0.0 && self.mu_k > 0.0 { self.friction.rule().direction() } else { SlipDirection::Constant }
    }

    /// Whether a stop of sliding in two directions can be passed, since stick, whose force differs from that of slip, could not hold.
    pub fn may_pass_stop(&self) -> bool {
        self.v_stick > 0.0 && !self.friction.rule().is_continuous_at_stop()
    }

    /// Whether a contact in slip that does not move along its face has no tangential force, in one direction of sliding. Asked of laws
    /// that are damped in slip alone: a row of contacts of others is computed with all its coordinates.
    pub fn is_forceless_at_rest(&self) -> bool {
        self.mu_k == 0.0 && self.friction.rule().is_damped_in_slip() && self.v_stick == 0.0
    }

    /// Direction against which friction acts in slip at the tangential velocity `sliding` \[m/s\]: of one direction of sliding
    /// `direction`, of two `V_t / max(|V_t|, v_stick)`.
    #[inline]
    pub fn along_velocity(&self, sliding: DVec2, direction: DVec2) -> DVec2 {
        if self.v_stick > 0.0 { sliding / sliding.length().max(self.v_stick) } else { direction }
    }

    /// The law with friction along the direction of the mode, whatever `V_t` is, as in one direction of sliding.
    #[must_use]
    pub fn with_direction_held(self) -> Self {
        Self { v_stick: 0.0, ..self }
    }

    /// Derivative of friction by `V_t`, for [`SlipDirection::OfVelocity`].
    pub fn sliding_derivative(&self, forces: &Forces) -> SlidingDerivative {
        self.friction.rule().sliding_derivative(self, forces)
    }

    /// Forces on the node of a closed contact \[N\].
    #[inline]
    pub fn forces(&self, mode: &Mode, here: &Local) -> Forces {
        match mode {
            Mode::Stick { anchor } => stick(self, *anchor, here),
            Mode::Slip { direction } => self.friction.rule().slip(self, *direction, here),
        }
    }

    /// Forces on the node of a closed contact whose direction of slip is a state with this regularisation length \[m\]; 0 where it is none
    /// \[N\].
    #[inline]
    pub fn forces_turning(&self, mode: &Mode, here: &Local, regularisation: f64) -> Forces {
        match mode {
            Mode::Slip { direction } if regularisation > 0.0 => {
                self.friction.rule().slip_turning(self, *direction, here, regularisation)
            }
            Mode::Stick { .. } | Mode::Slip { .. } => self.forces(mode, here),
        }
    }

    /// Switching function, negative while the state lasts: breakaway in stick \[m\], stop in slip \[m/s\].
    #[inline]
    pub fn switch(&self, mode: &Mode, here: &Local) -> f64 {
        match mode {
            Mode::Stick { anchor } => (here.way - *anchor).length() - self.mu_s * self.length(here),
            Mode::Slip { direction } => self.friction.rule().stopping(self, *direction, here),
        }
    }

    /// Slip after breakaway, and the energy released (`docs/physics.md#breakaway`).
    pub fn on_breakaway(&self, anchor: DVec2, here: &Local) -> Breakaway {
        self.friction.rule().breakaway(self, anchor, here)
    }

    /// Stick after a stop (`docs/physics.md#stop`).
    pub fn on_stopping(&self, direction: DVec2, here: &Local) -> Mode {
        self.friction.rule().on_stopping(self, direction, here)
    }
}

/// Forces in stick (57a), equal in both laws: tangential spring to the anchor and both dashpots.
fn stick(law: &Law, anchor: DVec2, here: &Local) -> Forces {
    let stretch = here.way - anchor;
    let pressed = law.pressed(here, stretch);
    Forces { tangential: stretch * -law.k_t, tangential_damping: pressed.sliding * -law.c_t, ..pressed }
}

#[cfg(test)]
pub(in crate::contact) mod example {
    use glam::{DVec2, DVec3};

    use crate::contact::normal::Linear;
    use crate::contact::{FrictionLaw, Law, Local, Normal};

    /// A contact whose tangential spring has half the stiffness of its normal one, so that ℓ = 2 δ.
    pub(in crate::contact) fn law(friction: FrictionLaw) -> Law {
        let normal = Normal::Linear(Linear { k: 2e5, c: 0.0 });
        let friction = friction.into();
        Law { normal, k_t: 1e5, c_t: 30.0, mu_s: 0.5, mu_k: 0.4, friction, clamp: false, v_stick: 0.0 }
    }

    /// A node at a penetration of 1 mm, at this position and rate along the first tangent.
    pub(in crate::contact) fn node(way: f64, rate: f64) -> Local {
        let (at, rate) = (DVec2::new(way, 0.0), DVec2::new(rate, 0.0));
        Local { gap: -1e-3, gap_rate: 0.0, at, way: at, rate, spin: DVec3::ZERO }
    }

    /// Whether two numbers agree to round-off.
    pub(in crate::contact) fn agree(what: &str, got: f64, expected: f64) {
        assert!((got - expected).abs() <= 1e-12 * expected.abs().max(1e-12), "{what}: {got} is not {expected}");
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::example::{agree, law, node};
    use super::*;

    #[test]
    fn stick_is_a_spring_and_a_dashpot_to_the_anchor() {
        for friction in [FrictionLaw::Paper, FrictionLaw::ReturnMapping] {
            let forces = law(friction).forces(&Mode::Stick { anchor: DVec2::ZERO }, &node(2e-4, 0.1));
            agree("normal", forces.normal, 200.0);
            agree("spring", forces.tangential.x, -20.0);
            agree("dashpot", forces.tangential_damping.x, -3.0);
            assert_eq!(forces.anchor_rate, DVec2::ZERO, "the anchor stays");
        }
    }

    #[test]
    fn a_stick_ends_on_the_cone_of_the_normal_force() {
        for friction in [FrictionLaw::Paper, FrictionLaw::ReturnMapping] {
            let (law, mode) = (law(friction), Mode::Stick { anchor: DVec2::ZERO });
            // k_t s = μ_s N at s = 1 mm.
            assert!(law.switch(&mode, &node(0.999e-3, 0.0)) < 0.0, "inside the cone");
            assert!(law.switch(&mode, &node(1.001e-3, 0.0)) > 0.0, "outside");
            let forces = law.forces(&mode, &node(1e-3, 0.0));
            agree("on the cone", forces.tangential.length(), law.mu_s * forces.normal);
        }
    }

    #[test]
    fn the_direction_of_slip_follows_only_where_sliding_has_two_directions_and_friction() {
        for (friction, expected) in
            [(FrictionLaw::Paper, SlipDirection::OfVelocity), (FrictionLaw::ReturnMapping, SlipDirection::State)]
        {
            let [one, two] = [0.0, 1e-6].map(|v_stick| Law { v_stick, ..law(friction) });
            assert_eq!(
                [one.slip_direction(), two.slip_direction()],
                [SlipDirection::Constant, expected],
                "{friction:?}"
            );
            assert_eq!(two.with_direction_held().slip_direction(), SlipDirection::Constant, "held");
            assert_eq!(Law { mu_k: 0.0, ..two }.slip_direction(), SlipDirection::Constant, "without friction");
        }
    }

    #[test]
    fn a_contact_closes_in_stick_where_the_tangential_force_grows_more_slowly_than_its_limit() {
        let (law, here) = (law(FrictionLaw::ReturnMapping), node(0.0, 0.0));
        // k_t V_t against μ_s K V_n: equal at V_t = V_n.
        let closes = |tangential: f64| law.on_closing(&here, DVec2::new(tangential, 0.0), -1.0);
        assert!(matches!(closes(0.99), Mode::Stick { .. }), "below");
        assert_eq!(closes(1.01), Mode::Slip { direction: DVec2::X }, "above");
    }
}
