//! States of the bodies that an event concerns, and what of their contacts at that time follows from states and forces: relative
//! acceleration, regularisation length, the stick condition after a stop.

use glam::{DMat2, DVec2, DVec3};

use crate::contact::{ContactGeometry, Frame, Law, Local, Mode, SlipDirection, locate};
use crate::dynamics::closing::constants::CLOSING_INTERVAL;
use crate::dynamics::contact_model::constants::{REGULARISATION_CLOCK, REGULARISATION_FRICTION, REGULARISATION_LEAST};
use crate::dynamics::contact_model::event_poses::{ContactPoses, EventPoses};
use crate::dynamics::contact_model::islands::assemble;
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::model::body::Point;
use crate::dynamics::model::reference_pose::{self, ReferencePose};
use crate::dynamics::penalty3d::constants::{POSITION_ROUNDING, SIMULTANEOUS_PER_RADIAN};
use crate::dynamics::penalty3d::contact_force;
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::world::World;

/// States and poses of bodies at the time of an event.
#[derive(Debug)]
pub(in crate::dynamics) struct EventBodies {
    /// Their poses and the time.
    pub poses: EventPoses,
    /// Reference poses of the states; of a body that was in flight, its pose at `t`.
    pub bases: Vec<ReferencePose>,
    /// States relative to the reference poses.
    pub states: Vec<Vec<f64>>,
    /// Poses of all sections relative to the reference poses.
    pub since: Vec<Frame>,
}

impl EventBodies {
    /// From slots, reference poses and states at `t`.
    pub(in crate::dynamics) fn of(
        world: &World,
        slots: Vec<usize>,
        bases: Vec<ReferencePose>,
        states: Vec<Vec<f64>>,
        t: f64,
    ) -> Self {
        let layout = world.layout_of(&slots);
        let (mut since, mut frames) = (Vec::with_capacity(layout.section_count()), Vec::new());
        frames.reserve_exact(layout.section_count());
        for (i, &slot) in slots.iter().enumerate() {
            world.model_body(slot).push_frames(&states[i], &mut since);
            frames.extend(since[layout.sections(i)].iter().map(|since| bases[i].whole(since)));
        }
        Self { poses: EventPoses { t, slots, layout, frames }, bases, states, since }
    }

    /// Reference pose of a body; `None` for an abutment.
    pub(in crate::dynamics) fn base(&self, slot: Option<usize>) -> Option<&ReferencePose> {
        self.bases.get(self.poses.index_of(slot?)?)
    }
}

/// A contact counted from the reference poses of its bodies: the formulation of a closed contact.
pub(in crate::dynamics) struct RelativeContact {
    /// Geometry at the reference poses.
    pub geometry: ContactGeometry,
    /// Poses of the node's and the face's body relative to the reference poses.
    pub poses: [Frame; 2],
    /// The node relative to its face.
    pub local: Local,
}

/// Contacts of a group of bodies at the time of an event.
#[derive(Clone, Copy)]
pub(in crate::dynamics) struct EventContacts<'a> {
    /// Constant data and present states of the group.
    pub world: &'a World,
    /// States of the bodies that the event concerns.
    pub now: &'a EventBodies,
}

impl<'a> EventContacts<'a> {
    /// The contacts in the poses of their bodies.
    pub(in crate::dynamics) fn poses(&self) -> ContactPoses<'a> {
        ContactPoses { world: self.world, now: &self.now.poses }
    }

    /// A contact from the reference poses of its bodies, with all sections at `frames` relative to them.
    pub(in crate::dynamics) fn relative(&self, contact: usize, frames: &[Frame]) -> RelativeContact {
        let track = &self.world.contacts[contact];
        let bases = track.slots.map(|slot| self.now.base(slot));
        let geometry = reference_pose::seen_from(self.world.site(contact), &track.place, bases);
        let poses = [0, 1].map(|which| self.poses().side(contact, which, frames));
        RelativeContact { geometry, poses, local: locate(&geometry, &poses[0], &poses[1]) }
    }

    /// Whether a contact whose sliding in two directions has stopped can stick: the tangential force that keeps `V_t`
    /// at zero is at most `μ_s |F_n|` (`docs/physics.md#stop`).
    pub(in crate::dynamics) fn can_hold(&self, contact: usize, closed: &ClosedContact) -> bool {
        let track = &self.world.contacts[contact];
        let RelativeContact { geometry, poses, .. } = self.relative(contact, &self.now.since);
        let action = contact_force::act_in(&geometry, closed, &closed.mode, &poses[0], &poses[1]);
        let (acceleration, _) = self.relative_acceleration(contact, &action.here);
        let mut mobility = DMat2::ZERO;
        for (which, arm) in [action.node_arm, action.face_arm].into_iter().enumerate() {
            if let Some(slot) = track.slots[which] {
                let body = self.world.model_body(slot);
                let axes = action.tangents(&geometry, &poses[1]);
                let here = self.poses().side(contact, which, &self.now.poses.frames);
                let along = |axis: DVec3| {
                    let there = body.acceleration(Point { section: track.sections[which], frame: &here, arm }, axis);
                    DVec2::new(there.dot(axes[0]), there.dot(axes[1]))
                };
                mobility += DMat2::from_cols(along(axes[0]), along(axes[1]));
            }
        }
        // Present friction less M_t a_t / N, with M_t the effective mass and N the number of sliding contacts of the
        // pair.
        let sliding = |c: &usize| {
            matches!(self.world.contacts[*c].state.closed(), Some(ClosedContact { mode: Mode::Slip { .. }, .. }))
        };
        let sharing = self.world.pairs[track.pair].contacts.clone().filter(sliding).count().max(1);
        let needed = action.forces.tangential - mobility.inverse() * acceleration / sharing as f64;
        // The force is NaN where the mobility is 0: without tangential motion the contact sticks.
        needed.is_nan() || needed.length() <= closed.law.mu_s * action.forces.normal
    }

    /// Tangential and normal acceleration of a node relative to its face under the present forces \[m/s²\], by a
    /// forward difference of the relative velocity over 1e-7 rad of the pair's contact oscillation.
    pub(in crate::dynamics) fn relative_acceleration(&self, contact: usize, here: &Local) -> (DVec2, f64) {
        let dt = CLOSING_INTERVAL * self.world.pair_of(contact).simultaneity;
        let island = assemble(
            self.world,
            &self.now.poses.slots,
            self.now.bases.clone(),
            self.now.states.concat(),
            self.now.poses.t,
            ControllerState::default(),
        );
        let next = self.relative(contact, &island.frames_after(&self.world.model, dt)).local;
        ((next.rate - here.rate) / dt, (next.gap_rate - here.gap_rate) / dt)
    }

    /// Regularisation length `ℓ` of a slip direction that turns \[m\], `docs/physics.md#law-return-mapping`:
    /// proportional to the tolerance and to the largest of the penetration and the depths `|V_n|/ω` and `|a_n|/ω²`,
    /// with ω the contact frequency of the pair; 0 for a law whose slip direction is no state.
    pub(in crate::dynamics) fn regularisation_length(&self, contact: usize, law: &Law, here: &Local) -> f64 {
        if law.slip_direction() != SlipDirection::State {
            return 0.0;
        }
        let radian = self.world.pair_of(contact).simultaneity * SIMULTANEOUS_PER_RADIAN;
        let (sliding, speed) = here.relative_velocity(DVec2::ZERO);
        let (_, acceleration) = self.relative_acceleration(contact, here);
        let depth = (speed.abs() * radian).max(acceleration.abs() * radian * radian).max(here.penetration());
        let size = self.world.site(contact).reach();
        let eased = law.slip_scale_of_at_least(REGULARISATION_FRICTION, depth);
        // At least the round-off of a stretch, below which its direction is undefined, and the way that is travelled
        // within the round-off of the time.
        let rounding =
            POSITION_ROUNDING * size + REGULARISATION_CLOCK * self.now.poses.t * (speed.abs() + sliding.length());
        (self.world.model.tolerance.max(REGULARISATION_LEAST) * eased).max(rounding)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::FrictionLaw;
    use std::sync::Arc;

    use crate::dynamics::penalty3d::contact_state::Contact;
    use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, closed, wall};
    use crate::scene::{Direction, Kind};

    const DEPTH: f64 = 1e-3;
    const TOLERANCE: f64 = 1e-6;

    /// A girder at a wall at this displacement and velocity along x, under a constant push along y, all nodes in slip
    /// under a law that stops at 1e-6 m/s in two directions.
    fn pressed(kind: Kind, [x, u]: [f64; 2], push: f64) -> (World, EventBodies) {
        let mut scene = wall();
        (scene.kind, scene.gravity) = (kind, 0.0);
        scene.girders[0].held = vec![Direction::Roll, Direction::Pitch, Direction::Yaw];
        let slip = |_: &Local| Mode::Slip { direction: DVec2::X };
        let (mut model, active) = closed(&scene, slip);
        model.bodies[0].push.y = push;
        model.tolerance = TOLERANCE;
        let mut world = World::of(&Arc::new(model), 0);
        for mut contact in active {
            contact.closed.law.v_stick = 1e-6;
            let track = world.contacts.iter_mut().find(|track| track.site == contact.site).expect("a contact");
            track.state = Contact::Closed(contact.closed);
        }
        let body = &world.model.bodies[0];
        let (mut state, base) = (body.initial(), body.placed());
        (state[0], state[body.positions()]) = (x, u);
        let now = EventBodies::of(&world, vec![0], vec![base], vec![state], 0.0);
        (world, now)
    }

    fn state(world: &World, contact: usize) -> ClosedContact {
        *world.contacts[contact].state.closed().expect("closed")
    }

    #[test]
    fn accelerations_are_those_of_the_springs_and_the_push() {
        let push = 3.0;
        let (world, now) = pressed(Kind::Planar, [DEPTH, 0.0], push);
        let at = EventContacts { world: &world, now: &now };
        let here = at.relative(0, &now.since).local;
        assert!((here.penetration() - DEPTH).abs() < 1e-15, "{} m in", here.penetration());
        let (tangential, normal) = at.relative_acceleration(0, &here);
        let out = STIFFNESS * DEPTH / MASS;
        assert!((normal / out - 1.0).abs() < 1e-6, "{normal} m/s² is not K δ/m = {out}");
        assert!((tangential.length() / (push / MASS) - 1.0).abs() < 1e-6, "{tangential} m/s² is not F/m");
    }

    #[test]
    fn a_stop_holds_up_to_static_friction() {
        // Four nodes of K/4 each take a quarter of the push: stick for F ≤ μ_s K δ.
        let (world, _) = pressed(Kind::Spatial, [DEPTH, 0.0], 0.0);
        let limit = state(&world, 0).law.mu_s * STIFFNESS * DEPTH;
        for (part, holds) in [(0.0, true), (0.999, true), (-0.999, true), (1.001, false), (-1.001, false)] {
            let (world, now) = pressed(Kind::Spatial, [DEPTH, 0.0], part * limit);
            let at = EventContacts { world: &world, now: &now };
            assert_eq!(at.can_hold(0, &state(&world, 0)), holds, "{part} of the limit");
        }
    }

    #[test]
    fn the_regularisation_length_follows_the_deepest_of_overlap_speed_and_push() {
        let omega = (STIFFNESS / MASS).sqrt();
        let length = |at: [f64; 2], law: fn(&mut Law)| {
            let (world, now) = pressed(Kind::Planar, at, 0.0);
            let at = EventContacts { world: &world, now: &now };
            let here = at.relative(0, &now.since).local;
            let mut chosen = Law { friction: FrictionLaw::ReturnMapping.into(), mu_k: 0.4, ..state(&world, 0).law };
            law(&mut chosen);
            at.regularisation_length(0, &chosen, &here)
        };
        let near = |value: f64, expected: f64| (value / expected - 1.0).abs() < 1e-6;
        let pressed_in = length([DEPTH, 0.0], |_| {});
        assert!(near(pressed_in, TOLERANCE * 0.4 * DEPTH), "overlap: {pressed_in} m");
        let hit = length([0.0, SPEED], |_| {});
        assert!(near(hit, TOLERANCE * 0.4 * SPEED / omega), "v/ω: {hit} m");
        let smooth = length([0.0, SPEED], |law| law.mu_k = 0.01);
        assert!(near(smooth, TOLERANCE * 0.05 * SPEED / omega), "least friction: {smooth} m");
        assert_eq!(length([0.0, SPEED], |law| law.mu_k = 0.0), 0.0, "no friction, no direction");
        assert_eq!(length([0.0, SPEED], |law| law.v_stick = 0.0), 0.0, "one direction of sliding");
        assert_eq!(length([0.0, SPEED], |law| law.friction = FrictionLaw::Paper.into()), 0.0, "law paper");
        let touching = length([0.0; 2], |_| {});
        assert!(touching > 0.0 && touching < 1e-14, "round-off of a place: {touching} m");
    }
}
