//! Bodies at the instant of an event, and what a contact is there: pose of node against face, accelerations, whether stick
//! can hold.

use glam::{DMat2, DMat3, DVec2, DVec3};

use crate::contact::parameters::is_over;
use crate::contact::{Frame, FrictionLaw, Home, Law, Local, Mode, NormalLaw, locate};
use crate::dynamics::closing::constants::INSTANT;
use crate::dynamics::contact_model::event_forecast::frames_after;
use crate::dynamics::contact_model::islands::assemble;
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::model::reference_pose::{self, ReferencePose};
use crate::dynamics::penalty3d::constants::POSITION_ROUNDING;
use crate::dynamics::penalty3d::contact_force;
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::world::World;
use crate::scene::Kind;

/// Regularisation length of a turning slip direction, in parts of the depth of the entry (tuned; no derivation known).
const EASE: f64 = 1e-3;
/// Friction coefficient below which the regularisation length falls no further (tuned; no derivation known).
const LEAST_EASED: f64 = 0.05;

/// Bodies at the instant of an event.
#[derive(Debug)]
pub(in crate::dynamics) struct EventInstant {
    /// Time \[s\].
    pub t: f64,
    /// Slots of the bodies, rising.
    pub slots: Vec<usize>,
    /// Reference poses that the states are counted from; of a body that was free, its present pose.
    pub bases: Vec<ReferencePose>,
    /// States.
    pub states: Vec<Vec<f64>>,
    /// Poses in the world.
    pub frames: Vec<Frame>,
    /// Poses counted from the reference poses.
    pub since: Vec<Frame>,
}

impl EventInstant {
    /// Of bodies with their reference poses and states.
    pub(in crate::dynamics) fn of(
        world: &World,
        slots: Vec<usize>,
        bases: Vec<ReferencePose>,
        states: Vec<Vec<f64>>,
        t: f64,
    ) -> Self {
        let body = |slot: usize| &world.model.bodies[world.bodies[slot].body];
        let since = slots.iter().zip(&states).map(|(&slot, state)| body(slot).frame_since(state));
        let since: Vec<Frame> = since.collect();
        let frames = bases.iter().zip(&since).map(|(base, since)| base.whole(since)).collect();
        Self { t, slots, bases, states, frames, since }
    }

    /// Poses alone, on the trajectories in force.
    pub(in crate::dynamics) fn poses(world: &World, slots: Vec<usize>, t: f64) -> Self {
        let frames = slots.iter().map(|&slot| world.frame(slot, t)).collect();
        Self { t, slots, bases: Vec::new(), states: Vec::new(), frames, since: Vec::new() }
    }

    fn place(&self, slot: usize) -> Option<usize> {
        self.slots.binary_search(&slot).ok()
    }

    /// Pose of a body in the world.
    pub(in crate::dynamics) fn pose(&self, slot: usize) -> Option<Frame> {
        self.frames.get(self.place(slot)?).copied()
    }

    /// Reference pose of a body; nothing for an abutment.
    pub(in crate::dynamics) fn base(&self, slot: Option<usize>) -> Option<&ReferencePose> {
        self.bases.get(self.place(slot?)?)
    }
}

/// Contacts of a group of bodies at an instant.
#[derive(Clone, Copy)]
pub(in crate::dynamics) struct AtInstant<'a> {
    /// The group.
    pub world: &'a World,
    /// Its bodies.
    pub now: &'a EventInstant,
}

impl AtInstant<'_> {
    /// Pose of one side of a contact, of those in `frames`.
    fn side(&self, contact: usize, which: usize, frames: &[Frame]) -> Frame {
        let track = &self.world.contacts[contact];
        let stand = self.world.model.contacts[track.site].stand;
        let frame = |slot: usize| self.now.place(slot).and_then(|i| frames.get(i)).copied().unwrap_or(stand);
        track.slots[which].map_or(stand, frame)
    }

    /// A node against its face.
    pub(in crate::dynamics) fn local(&self, contact: usize) -> Local {
        let site = &self.world.model.contacts[self.world.contacts[contact].site];
        let sides = [0, 1].map(|which| self.side(contact, which, &self.now.frames));
        locate(&site.home, &sides[0], &sides[1])
    }

    /// A node against its face counted from the reference poses of the bodies, as it is while it is closed: the reference
    /// configuration, both poses in `frames`, and the node.
    pub(in crate::dynamics) fn since(&self, contact: usize, frames: &[Frame]) -> (Home, [Frame; 2], Local) {
        let track = &self.world.contacts[contact];
        let at = track.state.closed().and_then(|closed| closed.solver.rebased_node);
        let bases = track.slots.map(|slot| self.now.base(slot));
        let home = reference_pose::seen_from(&self.world.model.contacts[track.site], bases, at);
        let sides = [0, 1].map(|which| self.side(contact, which, frames));
        (home, sides, locate(&home, &sides[0], &sides[1]))
    }

    /// Whether a node is over its face's polygon and touches nothing else.
    pub(in crate::dynamics) fn is_over(&self, contact: usize) -> bool {
        let here = self.local(contact);
        let face = &self.world.model.contacts[self.world.contacts[contact].site].face;
        is_over(face, here.at) && !self.touches_elsewhere(contact)
    }

    /// Whether the same node is in another face already: it touches one at a time.
    pub(in crate::dynamics) fn touches_elsewhere(&self, contact: usize) -> bool {
        self.world.contacts[contact].rivals.iter().any(|&other| self.world.contacts[other].state.closed().is_some())
    }

    /// Whether a body stands in plan as it was placed.
    pub(in crate::dynamics) fn stands(&self, frame: &Frame) -> bool {
        self.world.model.kind == Kind::Planar && frame.shift.truncate() == DVec2::ZERO && frame.turned == DMat3::ZERO
    }

    /// Whether a contact that has stopped sliding in two directions can hold: the tangential force that keeps `V_t` at
    /// rest is within `μ_s |F_n|` (`docs/physics.md#stop`).
    pub(in crate::dynamics) fn can_hold(&self, contact: usize, closed: &ClosedContact) -> bool {
        let track = &self.world.contacts[contact];
        let (home, sides, _) = self.since(contact, &self.now.since);
        let action = contact_force::act_in(&home, closed, &closed.mode, &sides[0], &sides[1]);
        let (acceleration, _) = self.relative_acceleration(contact, &action.here);
        let mut mobility = DMat2::ZERO;
        for (which, arm) in [action.node_arm, action.face_arm].into_iter().enumerate() {
            if let Some(slot) = track.slots[which] {
                let body = &self.world.model.bodies[self.world.bodies[slot].body];
                let axes = [home.axes.x_axis, home.axes.y_axis].map(|axis| sides[1].turn(axis));
                let here = self.side(contact, which, &self.now.frames);
                let along = |axis: DVec3| {
                    let there = body.acceleration(&here, axis, arm);
                    DVec2::new(there.dot(axes[0]), there.dot(axes[1]))
                };
                mobility += DMat2::from_cols(along(axes[0]), along(axes[1]));
            }
        }
        // What friction gives now, less this contact's part of what stops the acceleration that is left: those of the pair
        // that slide with it share.
        let sliding = |c: &usize| {
            matches!(self.world.contacts[*c].state.closed(), Some(ClosedContact { mode: Mode::Slip { .. }, .. }))
        };
        let sharing = self.world.pairs[track.pair].contacts.clone().filter(sliding).count().max(1);
        let needed = action.forces.tangential - mobility.inverse() * acceleration / sharing as f64;
        // A NaN, where nothing can move tangentially, holds.
        needed.is_nan() || needed.length() <= closed.law.mu_s * action.forces.normal
    }

    /// Tangential and normal acceleration of a node against a face under the forces of the contacts as they are
    /// \[m/s²\].
    pub(in crate::dynamics) fn relative_acceleration(&self, contact: usize, here: &Local) -> (DVec2, f64) {
        let dt = INSTANT * self.world.pairs[self.world.contacts[contact].pair].together;
        let together = assemble(
            self.world,
            &self.now.slots,
            self.now.bases.clone(),
            self.now.states.concat(),
            self.now.t,
            ControllerState::default(),
        );
        let (.., next) = self.since(contact, &frames_after(&together, &self.world.model, dt));
        ((next.rate - here.rate) / dt, (next.gap_rate - here.gap_rate) / dt)
    }

    /// Length below which a turning direction of slip is eased: a part of the depth that the speed and the push at the
    /// entry lead to, or of the overlap, whichever is deepest \[m\].
    pub(in crate::dynamics) fn ease(&self, contact: usize, law: &Law, here: &Local) -> f64 {
        // Without sliding friction there is no force whose direction could turn.
        if law.v_stick == 0.0 || law.friction == FrictionLaw::Paper || law.mu_k == 0.0 {
            return 0.0;
        }
        let radian = self.world.pairs[self.world.contacts[contact].pair].together * 1e9;
        let (_, speed) = here.relative_velocity(DVec2::ZERO);
        let (_, push) = self.relative_acceleration(contact, here);
        let depth = (speed.abs() * radian).max(push.abs() * radian * radian).max(here.penetration());
        let size = self.world.model.contacts[self.world.contacts[contact].site].reach();
        // Never less than a stretch's rounding: a direction within that is none.
        (EASE * law.mu_k.max(LEAST_EASED) * law.normal.length(depth, law.k_t)).max(POSITION_ROUNDING * size)
    }
}
