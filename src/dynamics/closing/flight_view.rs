//! Poses of two bodies in flight at one time, with bounds on their later motion.

use glam::DVec3;

use crate::contact::Frame;
use crate::dynamics::closing::constants::PHASE_END_SAMPLES;
use crate::dynamics::free_flight::body_flight::BodyFlight;
use crate::dynamics::free_flight::flight::StateInFlight;
use crate::dynamics::free_flight::relative_bounds::{BodyInFlight, GirderInFlight, RelativeBounds};
use crate::dynamics::linear::ModalCoordinates;
use crate::dynamics::locate::constants::SAMPLES_PER_SEARCH;
use crate::dynamics::locate::horizon::Horizon;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::{PairTrack, Trajectory};

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
        let mut parts = None;
        let flyers = [0, 1].map(|side| {
            let times = ([t, horizon], phase);
            let (frame, flyer) = flyer(world, [slots[side]?, sections[side]], times, &mut parts)?;
            frames[side] = frame;
            Some(flyer)
        });
        let bound = |side: usize| flyers[side].as_ref().map_or(MotionBounds::still(horizon), |flyer| flyer.bound);
        Self { frames, bounds: [bound(0), bound(1)], between: RelativeBounds::of(&flyers, horizon) }
    }
}

/// A body in flight at `t`, for at most `horizon` \[s\], with the ground's phase; `shared` is the block and the parts of its flight that
/// were computed last.
fn flyer<'a>(
    world: &'a World,
    [slot, section]: [usize; 2],
    ([t, horizon], phase): ([f64; 2], [f64; 2]),
    shared: &mut Option<(Option<usize>, ModalCoordinates)>,
) -> Option<(Frame, BodyInFlight<'a>)> {
    let track = &world.bodies[slot];
    let body = &world.model.bodies[track.body];
    let flight = track.flight()?;
    if let Some((free_motion, flight)) = flight.in_plan() {
        let StateInFlight { state, free } = free_motion.parts_in(flight, t, phase);
        let bound = free_motion.bound_from(t, &state, free.as_ref(), horizon);
        let girder = Some(GirderInFlight { free_motion, state, free });
        return Some((body.planar_frame(&state), BodyInFlight { bound, girder }));
    }
    if shared.as_ref().is_none_or(|(block, _)| block.is_none() || *block != track.block) {
        *shared = Some((track.block, flight.parts(t)));
    }
    let (_, parts) = shared.as_ref()?;
    let (frame, bound) = flight.look((body, section), parts, [t, horizon]);
    Some((frame, BodyInFlight { bound, girder: None }))
}

/// End of one search of bodies in flight \[s\]: a period of a sine, samples of a record, fewer where a girder flies on springs to the
/// ground, whose phases end, or the end of the run.
pub(in crate::dynamics) fn horizon(world: &World, slots: [Option<usize>; 2], t: f64) -> f64 {
    let on_springs = |slot: usize| world.bodies[slot].flight().is_some_and(BodyFlight::is_on_springs);
    let short = slots.into_iter().flatten().any(on_springs);
    let samples = if short { PHASE_END_SAMPLES } else { SAMPLES_PER_SEARCH };
    Horizon { periods: 1.0, samples }.end(&world.model.ground, t, world.model.duration)
}

/// Latest time to which bounds on flights apply in a search from `t` to `until` \[s\]: the end of the run; under a record that has not
/// ended, `until`.
pub(in crate::dynamics) fn farthest(world: &World, [t, until]: [f64; 2]) -> f64 {
    if world.model.ground.next_kink(t).is_finite() { until } else { world.model.duration }
}

/// Stores in flights under a record the states at its samples up to `until`, from which later states are computed.
pub(in crate::dynamics) fn remember(world: &mut World, slots: [Option<usize>; 2], until: f64) {
    for slot in slots.into_iter().flatten() {
        let track = &mut world.bodies[slot];
        if let Trajectory::Flight(flight) = &mut track.now {
            flight.remember(until);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::world::example::in_flight;
    use crate::scene::{Motion, Scene, presets};

    const FLIGHT_SAMPLES: u32 = 2000;

    /// Every bound of two girders in flight is above the motion, and below `factor` times it.
    fn expect_bounds(scene: &Scene, factor: f64) {
        let states = [[0.01, 0.002, 0.003, 0.1, -0.2, 0.1], [-0.01, 0.001, 0.0, 0.05, 0.1, -0.3]];
        let world = in_flight(scene, &states);
        let until = 0.4;
        let slots = [Some(0), Some(1)];
        let sample = FlightSample::of(&world, slots, [0; 2], 0.0, until);
        assert!(sample.bounds.iter().all(|bound| bound.window >= until) && sample.between.window >= until);
        let times: Vec<f64> = (0..=FLIGHT_SAMPLES).map(|i| until * f64::from(i) / f64::from(FLIGHT_SAMPLES)).collect();
        let frames: Vec<[Frame; 2]> = times.iter().map(|&t| [0, 1].map(|slot| world.frame(slot, 0, t))).collect();
        let largest = |of: &dyn Fn(&[Frame; 2]) -> f64| frames.iter().map(of).fold(0.0, f64::max);
        let step = until / f64::from(FLIGHT_SAMPLES);
        let change = |of: &dyn Fn(&[Frame; 2]) -> DVec3| {
            frames.windows(2).map(|two| (of(&two[1]) - of(&two[0])).length() / step).fold(0.0, f64::max)
        };
        let between = &sample.between;
        let mut pairs = vec![
            ("relative reach", largest(&|f| (f[0].shift - f[1].shift).length()), between.reach),
            ("relative speed", largest(&|f| (f[0].velocity - f[1].velocity).length()), between.speed),
            ("relative acceleration", change(&|f| f[0].velocity - f[1].velocity), between.acceleration),
        ];
        for (i, bound) in sample.bounds.iter().enumerate() {
            pairs.extend([
                ("reach", largest(&|f| f[i].shift.length()), bound.reach),
                ("speed", largest(&|f| f[i].velocity.length()), bound.speed),
                ("spin", largest(&|f| f[i].spin.length()), bound.spin),
                ("acceleration", change(&|f| f[i].velocity), bound.acceleration),
                ("spin rate", change(&|f| f[i].spin), bound.spin_rate),
            ]);
        }
        for (name, value, bound) in pairs {
            assert!(value <= bound * (1.0 + 1e-9) && bound < factor * value, "{name}: {bound} against {value}");
        }
    }

    #[test]
    fn bounds_hold_in_free_flight_and_are_not_far_above() {
        let mut scene = presets::load("row-of-5").expect("a preset");
        scene.motion = Motion::None;
        expect_bounds(&scene, 3.0);
    }

    #[test]
    fn bounds_hold_under_a_sine_whatever_its_phase() {
        expect_bounds(&presets::load("row-of-5").expect("a preset"), 20.0);
    }

    #[test]
    fn the_ground_is_at_rest_and_a_girder_moves_against_it_as_it_moves() {
        let scene = presets::load("row-of-5").expect("a preset");
        let world = in_flight(&scene, &[[0.01, 0.0, 0.0, 0.1, 0.0, 0.0]]);
        let sample = FlightSample::of(&world, [None, Some(0)], [0; 2], 0.0, 0.1);
        let [ground, girder] = &sample.bounds;
        assert_eq!([ground.reach, ground.speed, ground.acceleration], [0.0; 3]);
        assert_eq!([sample.between.reach, sample.between.speed], [girder.reach, girder.speed]);
        assert_eq!(sample.frames[0].velocity, DVec3::ZERO);
        assert_eq!(sample.frames[1].velocity, world.frame(0, 0, 0.0).velocity);
    }
}
