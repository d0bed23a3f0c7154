//! State of a contact (`docs/physics.md#contact-events`), and the forces of a closed one.

use crate::contact::{Forces, Law, Local, Mode, SlipDirection};
use crate::dynamics::model::edge_node::node_place::NodePlace;

/// State of a contact with all quantities that its forces depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "copied with every contact of a step; in a box each copy would be an allocation"
)]
pub enum Contact {
    /// No contact. A disarmed contact (its node is behind the face and did not enter through it) does not close until
    /// its gap is positive again.
    Open {
        /// Whether the next crossing of the gap through zero is a closing.
        armed: bool,
    },
    /// In contact, in stick or slip.
    Closed(ClosedContact),
}

/// State of a closed contact: law, mode, and state of the numerical method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosedContact {
    /// Law with the pair's stiffness and dashpots as shared.
    pub law: Law,
    /// Stick or slip; an anchor is relative to the reference poses of the bodies.
    pub mode: Mode,
    /// Law with `clamp` while the damping force exceeds the elastic one: the normal force is held at 0.
    pub held_at_zero: bool,
    /// Node and normal of the contact.
    pub place: NodePlace,
    /// State of the numerical method.
    pub solver: SolverState,
}

/// State of a closed contact that belongs to the numerical method, not to the law.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolverState {
    /// Regularisation length `ℓ` of a slip direction that turns (`docs/physics.md#law-return-mapping`), added to the
    /// stretch in the denominator of the angle's rate; 0 for none \[m\].
    pub regularisation: f64,
    /// Sliding has stopped and stick cannot hold: the next stop is located only after `V_t` has exceeded `v_stick`
    /// again.
    pub passing_stop: bool,
    /// In slip, the number of changes of the contact at the instant at which the slip began; 0 in stick.
    pub retries: u32,
    /// Distance beyond the edges of its face up to which the contact is kept, where it alone carries an overlap of two bodies
    /// that have met \[m\].
    pub kept_beyond_edge: f64,
    /// Distance beyond its face's edge at which a corner of bodies that have met hands its vertex on to the next face \[m\]; `None` after the
    /// handover, and of a corner that closed beyond the edge: the planes of the faces around bound its contact.
    pub handover_distance: Option<f64>,
    /// Greatest distance of a corner beside its face at which it took over a vertex from another node \[m\].
    pub beside: f64,
}

impl ClosedContact {
    /// State of a contact at its closing.
    pub fn new(law: Law, mode: Mode, regularisation: f64) -> Self {
        let solver = SolverState { regularisation, ..SolverState::default() };
        Self { law, mode, held_at_zero: false, place: NodePlace::default(), solver }
    }

    /// Forces on the node in the face's axes \[N\].
    #[inline]
    pub fn forces(&self, here: &Local) -> Forces {
        self.forces_in(&self.mode, here)
    }

    /// Forces on the node in the face's axes \[N\], in the mode `mode`.
    #[inline]
    pub fn forces_in(&self, mode: &Mode, here: &Local) -> Forces {
        let mut forces = self.law.forces_turning(mode, here, self.solver.regularisation);
        if self.held_at_zero {
            forces.normal_damping = -forces.normal;
        }
        forces
    }

    /// Slip angle of a contact whose slip direction is a state of the integrator \[rad\]; `None` for others.
    pub fn slip_angle(&self) -> Option<f64> {
        match self.mode {
            Mode::Slip { direction }
                if self.solver.regularisation > 0.0 && self.law.slip_direction() == SlipDirection::State =>
            {
                Some(direction.to_angle())
            }
            Mode::Stick { .. } | Mode::Slip { .. } => None,
        }
    }

    /// Switching function of the next kink of the normal force, negative before it: end of the phase of the normal law, in the unit of
    /// that function, or beginning or end of a force held at 0 \[N\].
    pub fn kink(&self, here: &Local) -> f64 {
        let forces = self.law.forces(&self.mode, here);
        if self.law.normal.has_phases() {
            return self.law.normal.phase_end(here.penetration(), forces.normal_velocity);
        }
        // Excess of the damping force over the elastic one, a pull.
        let pull = -forces.normal_total();
        if self.held_at_zero { -pull } else { pull }
    }

    /// State after the kink.
    #[must_use]
    pub fn after_kink(mut self, here: &Local) -> Self {
        if self.law.normal.has_phases() {
            self.law.normal = self.law.normal.next_phase(here.penetration());
        } else {
            self.held_at_zero = !self.held_at_zero;
        }
        self
    }
}

impl Contact {
    /// State of a closed contact; `None` for an open one.
    pub fn closed(&self) -> Option<&ClosedContact> {
        match self {
            Self::Closed(closed) => Some(closed),
            Self::Open { .. } => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use super::*;
    use crate::contact::normal::{Bilinear, Branch, Linear};
    use crate::contact::{FrictionLaw, Normal};

    /// N = 200 kN/m δ − 100 N s/m `V_n`, with a tangential spring of half that stiffness.
    fn law() -> Law {
        let normal = Normal::Linear(Linear { k: 2e5, c: 100.0 });
        let friction = FrictionLaw::ReturnMapping;
        Law { normal, k_t: 1e5, c_t: 30.0, mu_s: 0.5, mu_k: 0.4, friction: friction.into(), clamp: true, v_stick: 1e-6 }
    }

    /// A node 1 mm behind its face that moves out at this speed, and along the face at this rate.
    fn node(out: f64, rate: DVec2) -> Local {
        Local { gap: -1e-3, gap_rate: out, at: DVec2::ZERO, way: DVec2::ZERO, rate, spin: DVec3::ZERO }
    }

    const STICK: Mode = Mode::Stick { anchor: DVec2::ZERO };
    const SLIP: Mode = Mode::Slip { direction: DVec2::X };

    fn close(got: f64, expected: f64, what: &str) {
        assert!((got - expected).abs() <= 1e-12 * expected.abs().max(1e-3), "{what}: {got} is not {expected}");
    }

    #[test]
    fn a_clamped_force_is_held_at_zero_while_the_dashpot_would_pull() {
        let free = ClosedContact::new(law(), STICK, 0.0);
        // 200 N of the spring against 100 N s/m: equal at 2 m/s.
        for (out, pull) in [(1.0, -100.0), (3.0, 100.0)] {
            let here = node(out, DVec2::ZERO);
            close(free.forces(&here).normal_total(), -pull, "the law's force");
            close(free.kink(&here), pull, "it ends where the pull begins");
            let held = free.after_kink(&here);
            assert!(held.held_at_zero, "the kink begins the hold");
            assert_eq!(held.forces(&here).normal_total(), 0.0, "at {out} m/s");
            close(held.kink(&here), -pull, "and ends with the pull");
            assert_eq!(held.after_kink(&here), free, "the hold ends at the next one");
        }
    }

    #[test]
    fn a_law_with_phases_goes_to_its_next_phase_with_the_same_force() {
        let bilinear = Bilinear { k1: 2e5, k2: 1e5, yielding: 1e-3, branch: Branch::Elastic(0.0) };
        let normal = Normal::Bilinear(bilinear);
        let elastic = ClosedContact::new(Law { normal, ..law() }, STICK, 0.0);
        let deeper = |depth: f64| Local { gap: -depth, ..node(0.0, DVec2::ZERO) };
        close(elastic.kink(&deeper(0.8e-3)), -0.2e-3, "0.2 mm before yield");
        let yielding = elastic.after_kink(&deeper(1e-3));
        assert_eq!(yielding.law.normal, Normal::Bilinear(Bilinear { branch: Branch::Upper, ..bilinear }));
        assert!(!yielding.held_at_zero, "a law with phases is not held");
        close(yielding.forces(&deeper(1e-3)).normal, elastic.forces(&deeper(1e-3)).normal, "at the kink");
        close(yielding.forces(&deeper(1e-3)).normal, 200.0, "K₁ δ_y");
        close(yielding.forces(&deeper(2e-3)).normal, 300.0, "and K₂ beyond");
    }

    #[test]
    fn the_direction_of_slip_is_a_state_of_two_directions_of_sliding_under_return_mapping_alone() {
        let turned = Mode::Slip { direction: DVec2::from_angle(0.7) };
        let of = |law: Law, mode, regularisation| ClosedContact::new(law, mode, regularisation).slip_angle();
        assert!((of(law(), turned, 1e-9).expect("a state") - 0.7).abs() < 1e-15);
        assert_eq!(of(law(), STICK, 1e-9), None, "in stick");
        assert_eq!(of(law(), turned, 0.0), None, "without regularisation it is constant");
        assert_eq!(of(Law { friction: FrictionLaw::Paper.into(), ..law() }, turned, 1e-9), None);
        assert_eq!(of(Law { v_stick: 0.0, ..law() }, turned, 1e-9), None, "one direction of sliding");
    }

    #[test]
    fn a_slip_across_its_stretch_turns_the_anchor_by_the_part_that_the_regularisation_leaves() {
        let here = node(0.0, DVec2::new(0.1, 0.2));
        // The stretch is μ_k N/k_t = 0.8 mm: of the 0.2 m/s across it 0.8/(0.8 + 0.2) are of its turn.
        let forces = ClosedContact::new(law(), SLIP, 0.2e-3).forces(&here);
        close(forces.anchor_rate.x, 0.1, "along the stretch the anchor is dragged");
        close(forces.anchor_rate.y, 0.2 - 0.8 * 0.2, "across it");
        close(forces.tangential_damping.x, 0.0, "no change of length");
        close(forces.tangential_damping.y, -30.0 * 0.8 * 0.2, "the dashpot on the turn of the stretch");
        let rigid = ClosedContact::new(law(), SLIP, 0.0).forces(&here);
        assert_eq!((rigid.anchor_rate, rigid.tangential_damping), (here.rate, DVec2::ZERO), "without regularisation");
    }

    #[test]
    fn an_open_contact_has_no_closed_state() {
        let closed = ClosedContact::new(law(), STICK, 0.0);
        assert_eq!(Contact::Closed(closed).closed(), Some(&closed));
        assert_eq!([true, false].map(|armed| Contact::Open { armed }.closed().copied()), [None, None]);
    }
}
