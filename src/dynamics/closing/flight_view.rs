//! Poses of two bodies in flight at one time, with bounds on their later motion.

use glam::DVec3;

use crate::contact::Frame;
use crate::dynamics::closing::constants::RECORD_SAMPLES_PER_SEARCH;
use crate::dynamics::free_flight::body_motion::{BodyFlight, BodyMotion};
use crate::dynamics::free_flight::relative_bounds::{BodyInFlight, GirderInFlight, RelativeBounds};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::{PairTrack, Trajectory};
use crate::motion::Ground;

/// Two bodies in flight at one time, or one and the ground, with bounds on their motion from then on.
#[derive(Clone, Copy)]
pub(in crate::dynamics) struct FlightSample {
    /// Poses; the fixed pose for the ground.
    pub frames: [Frame; 2],
    /// Bounds on the motion of each.
    pub bounds: [MotionBounds; 2],
    /// Bounds on the relative motion.
    pub between: RelativeBounds,
}

impl FlightSample {
    /// Sample of a pair's bodies at `t`; its bounds hold up to `until` at most.
    pub(in crate::dynamics) fn of_pair(world: &World, pair: usize, t: f64, until: f64) -> Self {
        let PairTrack { slots, sections, .. } = world.pairs[pair];
        Self::of(world, slots, sections, t, until)
    }

    /// Sample of sections of the bodies in two slots at `t`; its bounds hold up to `until` at most.
    pub(in crate::dynamics) fn of(
        world: &World,
        slots: [Option<usize>; 2],
        sections: [usize; 2],
        t: f64,
        until: f64,
    ) -> Self {
        let horizon = (until - t).max(f64::MIN_POSITIVE);
        // Both sides have the same ground motion: its phase is evaluated once.
        let phase = world.model.ground.phase(t);
        // The pose of an abutment is that of the contact's site, which replaces this one.
        let mut frames = [Frame::fixed(DVec3::ZERO); 2];
        let flyers = [0, 1].map(|side| {
            let (frame, flyer) = flyer(world, [slots[side]?, sections[side]], t, phase, horizon)?;
            frames[side] = frame;
            Some(flyer)
        });
        let bound = |side: usize| flyers[side].as_ref().map_or(MotionBounds::still(horizon), |flyer| flyer.bound);
        Self { frames, bounds: [bound(0), bound(1)], between: RelativeBounds::of(&flyers, horizon) }
    }
}

fn flyer(
    world: &World,
    [slot, section]: [usize; 2],
    t: f64,
    phase: [f64; 2],
    horizon: f64,
) -> Option<(Frame, BodyInFlight<'_>)> {
    let track = &world.bodies[slot];
    let body = &world.model.bodies[track.body];
    let (Trajectory::Flight(flight), Some(motion)) = (&track.now, &track.system) else { return None };
    if let (BodyMotion::Girder(system), BodyFlight::Girder(flight)) = (motion, flight) {
        let (state, free) = system.parts_in(flight, t, phase);
        let bound = system.bound_from(t, &state, free.as_ref(), horizon);
        let girder = Some(GirderInFlight { system, state, free });
        return Some((body.planar_frame(&state), BodyInFlight { bound, girder }));
    }
    Some((
        motion.frame(body, section, flight, t),
        BodyInFlight { bound: motion.bounds(flight, t, horizon), girder: None },
    ))
}

/// End of one search \[s\]: a period of a sine, [`RECORD_SAMPLES_PER_SEARCH`] samples of a record, or the end of the
/// run.
pub(in crate::dynamics) fn horizon(ground: &Ground, t: f64, duration: f64) -> f64 {
    let stretch = match ground {
        Ground::Still => duration,
        Ground::Sine { omega, .. } => std::f64::consts::TAU / omega,
        Ground::Record { dt, .. } => RECORD_SAMPLES_PER_SEARCH * dt,
    };
    (t + stretch).min(duration)
}

/// Stores in flights under a record the states at its samples up to `until`, from which later states are computed.
pub(in crate::dynamics) fn remember(world: &mut World, slots: [Option<usize>; 2], until: f64) {
    for slot in slots.into_iter().flatten() {
        let track = &mut world.bodies[slot];
        if let (Trajectory::Flight(flight), Some(system)) = (&mut track.now, &track.system) {
            system.remember(flight, until);
        }
    }
}
