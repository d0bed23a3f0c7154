//! Rank-one terms of implicit steps: friction of contacts that slide in two directions, whose direction turns, and memories of devices
//! that evolve. Difference quotients hold the directions of sliding, which are then those of all other terms.

use glam::DVec2;

use crate::contact::{Forces, Mode, SlidingDerivative};
use crate::dynamics::connection::Evolution;
use crate::dynamics::integrator::system::RankOneTerm;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::constants::ANGLE_DIFFERENCE;
use crate::dynamics::penalty3d::contact_force::Action;
use crate::dynamics::penalty3d::contact_state::ClosedContact;

/// Rank-one terms at the linearisation of an implicit step.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct Sliding {
    /// Indices of those contacts among the closed ones.
    pub sliders: Vec<usize>,
    /// Derivatives of their friction by `V_t`, and of forces of devices by their memories.
    terms: Vec<RankOneTerm>,
    /// Directions of friction along `V_t` at the linearisation.
    against: Vec<DVec2>,
    /// Whether directions are held at those of the linearisation.
    frozen: bool,
}

impl Sliding {
    /// Contacts of `active` that slide in two directions.
    pub(in crate::dynamics) fn of(active: &[ActiveContact]) -> Self {
        let slides = |a: &ActiveContact| a.angle.is_some() || a.slides_along_velocity();
        let sliders: Vec<usize> = (0..active.len()).filter(|&i| slides(&active[i])).collect();
        Self { against: vec![DVec2::X; sliders.len()], sliders, ..Self::default() }
    }

    /// Removes the terms of the last evaluation.
    pub(in crate::dynamics) fn clear(&mut self) {
        self.terms.clear();
    }

    /// The rank-one terms of the last evaluation, contact by contact.
    pub(in crate::dynamics) fn terms(&self) -> &[RankOneTerm] {
        &self.terms
    }

    /// Keeps directions at those of the last evaluation, or follows the state again.
    pub(in crate::dynamics) fn freeze(&mut self, frozen: bool) {
        self.frozen = frozen;
    }

    /// A contact as it is frozen while difference quotients are formed; `None` while it follows the state. `slider` is
    /// its number among those that slide in two directions, if it is one.
    #[inline]
    pub(in crate::dynamics) fn frozen_contact(&self, slider: usize, active: &ActiveContact) -> Option<ClosedContact> {
        self.frozen.then(|| {
            let mut frozen = active.closed;
            if active.slides_along_velocity() {
                frozen.mode = Mode::Slip { direction: self.against[slider] };
                frozen.law = frozen.law.with_direction_held();
            }
            frozen
        })
    }

    /// Rank-one term of a slip whose angle is component `follower` of the auxiliary states: `V_t` turns the angle,
    /// the angle turns the force.
    pub(in crate::dynamics) fn add_slip_angle_term(
        &mut self,
        [slider, follower]: [usize; 2],
        closed: &ClosedContact,
        direction: DVec2,
        action: &Action,
        length: f64,
    ) {
        let turned = Mode::Slip {
            direction: (direction + direction.perp() * ANGLE_DIFFERENCE)
                / (1.0 + ANGLE_DIFFERENCE * ANGLE_DIFFERENCE).sqrt(),
        };
        let turned = closed.forces_in(&turned, &action.here);
        let force = (turned.tangential_total() - action.forces.tangential_total()) / ANGLE_DIFFERENCE;
        self.terms.push(RankOneTerm {
            port: slider,
            input: force,
            output: direction.perp() / length,
            auxiliary: Some(follower),
        });
    }

    /// Rank-one term of a device whose memory is component `follower` of the auxiliary states: the relative velocity along the
    /// port's second axis changes the memory, the memory the force along the first.
    pub(in crate::dynamics) fn add_memory_term(&mut self, [port, follower]: [usize; 2], evolution: &Evolution) {
        let (force, drive) = (evolution.force.length(), evolution.drive.length());
        let (input, output) = (DVec2::new(force, 0.0), DVec2::new(0.0, drive));
        self.terms.push(RankOneTerm { port, input, output, auxiliary: Some(follower) });
    }

    /// Rank-one terms of friction along `V_t`: its turning with the direction, and its change with the speed.
    pub(in crate::dynamics) fn add_direction_terms(&mut self, slider: usize, closed: &ClosedContact, forces: &Forces) {
        let SlidingDerivative { direction, along, across } = closed.law.sliding_derivative(forces);
        let perpendicular = direction.perp();
        self.against[slider] = closed.law.along_velocity(forces.sliding, direction);
        self.terms.push(RankOneTerm {
            port: slider,
            input: perpendicular * across,
            output: perpendicular,
            auxiliary: None,
        });
        self.terms.push(RankOneTerm { port: slider, input: direction * along, output: direction, auxiliary: None });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    use crate::contact::normal::Linear;
    use crate::contact::{Crossed, FrictionLaw, Law, Local, Normal};
    use crate::dynamics::penalty3d::active_contact::direction;
    use crate::dynamics::penalty3d::example::{closed, wall};

    fn slider(friction: FrictionLaw, direction: DVec2) -> ClosedContact {
        let normal = Normal::Linear(Linear { k: 1e5, c: 20.0 });
        let law = Law {
            normal,
            k_t: 1e5,
            c_t: 5.0,
            mu_s: 0.3,
            mu_k: 0.2,
            friction: friction.into(),
            clamp: false,
            v_stick: 1e-2,
        };
        let regularisation = if friction == FrictionLaw::Paper { 0.0 } else { 1e-6 };
        ClosedContact::new(law, Mode::Slip { direction }, regularisation)
    }

    fn pressed(rate: DVec2) -> Local {
        Local { gap: -1e-3, gap_rate: 0.0, at: DVec2::ZERO, way: DVec2::ZERO, rate, spin: DVec3::ZERO }
    }

    #[test]
    fn the_papers_friction_has_the_derivative_of_its_rank_one_terms() {
        let closed = slider(FrictionLaw::Paper, DVec2::X);
        for rate in [DVec2::new(0.03, 0.04), DVec2::new(0.003, -0.002)] {
            let here = pressed(rate);
            let mut sliding = Sliding { against: vec![DVec2::X], ..Sliding::default() };
            sliding.add_direction_terms(0, &closed, &closed.forces(&here));
            let h = 1e-7;
            for change in [DVec2::X, DVec2::Y] {
                let force = |h: f64| closed.forces(&pressed(rate + change * h)).tangential_total();
                let difference = (force(h) - force(-h)) / (2.0 * h);
                let terms: DVec2 = sliding.terms.iter().map(|term| term.input * term.output.dot(change)).sum();
                assert!((difference - terms).length() < 1e-6 * (1.0 + terms.length()), "{difference} is not {terms}");
            }
        }
    }

    #[test]
    fn a_slip_angle_has_the_derivative_of_its_rank_one_term() {
        let (angle, rate) = (0.3, DVec2::new(0.05, 0.02));
        let (closed, here) = (slider(FrictionLaw::ReturnMapping, direction(angle)), pressed(rate));
        let forces = closed.forces(&here);
        let zero = DVec3::ZERO;
        let action = Action {
            here,
            forces,
            force: zero,
            node_arm: zero,
            face_arm: zero,
            couple: zero,
            crossed: Crossed::SQUARE,
        };
        let length = closed.law.slip_stretch(&here) + closed.solver.regularisation;
        let mut sliding = Sliding::default();
        sliding.add_slip_angle_term([0, 0], &closed, direction(angle), &action, length);
        let term = sliding.terms[0];
        let force =
            |angle: f64| closed.forces_in(&Mode::Slip { direction: direction(angle) }, &here).tangential_total();
        let difference = (force(angle + 1e-4) - force(angle - 1e-4)) / 2e-4;
        assert!((difference - term.input).length() < 1e-5 * term.input.length(), "{difference} is not {}", term.input);
        let turning = |rate: DVec2| direction(angle).perp_dot(rate) / length;
        let by_rate = DVec2::new(turning(DVec2::X), turning(DVec2::Y));
        assert!((by_rate - term.output).length() < 1e-12 * by_rate.length(), "{by_rate} is not {}", term.output);
    }

    #[test]
    fn what_difference_quotients_hold_is_the_direction_of_the_linearisation() {
        let sliding_along_x = slider(FrictionLaw::Paper, DVec2::X);
        let (_, mut active) = closed(&wall(), |_| sliding_along_x.mode);
        for contact in &mut active {
            contact.closed = sliding_along_x;
        }
        let mut sliding = Sliding::of(&active);
        assert_eq!(sliding.sliders, [0, 1], "both nodes slide in two directions");
        assert_eq!(sliding.frozen_contact(0, &active[0]), None, "it follows the state");
        let rate = DVec2::new(0.0, 0.05);
        let here = pressed(rate);
        sliding.add_direction_terms(0, &active[0].closed, &active[0].closed.forces(&here));
        sliding.freeze(true);
        // Other velocity, same friction: that along Y at the linearisation.
        let elsewhere = pressed(DVec2::new(0.05, 0.0));
        let held = sliding.frozen_contact(0, &active[0]).expect("held");
        let friction = held.forces(&elsewhere).tangential;
        assert!(friction.y < 0.0 && friction.x.abs() < 1e-12 * friction.y.abs(), "against Y: {friction} N");
        sliding.freeze(false);
        assert_eq!(sliding.frozen_contact(0, &active[0]), None, "it follows the state again");
    }
}
