//! Bounds on the second derivative of a gap between two bodies of which at least one is in a planned step.
//!
//! The other one may be in flight or in a step of another island. Two bodies of one island share their step, so that
//! the bound of their relative motion is that of the difference of the dense outputs.

use crate::dynamics::connection::SeparationBounds;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::motion_bounds::gap_acceleration;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::Trajectory;

/// Bounds on the motion of two bodies and on their relative motion over an interval of time.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct GapCurvature {
    /// Bounds of each body.
    sides: [MotionBounds; 2],
    /// Bound on the relative speed of the two G \[m/s\].
    speed: f64,
    /// Bound on the relative acceleration of the two G \[m/s²\].
    acceleration: f64,
}

impl GapCurvature {
    /// Bounds of the bodies in two slots from `from` to `to`; an abutment is at rest.
    pub(in crate::dynamics) fn of(world: &World, slots: [Option<usize>; 2], from: f64, to: f64) -> Self {
        let sides =
            slots.map(|slot| slot.map_or(MotionBounds::still(f64::INFINITY), |slot| bound(world, slot, from, to)));
        let sum = [sides[0].speed + sides[1].speed, sides[0].acceleration + sides[1].acceleration];
        let [speed, acceleration] = difference(world, slots).unwrap_or(sum);
        Self { sides, speed, acceleration }
    }

    /// Whether the bounds hold for an interval of length `stretch` \[s\].
    pub(in crate::dynamics) fn holds(&self, stretch: f64) -> bool {
        self.sides[0].window.min(self.sides[1].window) >= stretch
    }

    /// Bound on `|g̈|` of a node of side `node` \[m/s²\] over an interval of length `stretch` \[s\]; `arms` are the
    /// distances of the node from its own G and from the other side's at the start \[m\].
    pub(in crate::dynamics) fn curvature(&self, node: usize, [arm, apart]: [f64; 2], stretch: f64) -> f64 {
        let (face, node) = (&self.sides[1 - node], &self.sides[node]);
        let speed = self.speed + node.spin * arm;
        let relative = [self.speed, self.acceleration];
        gap_acceleration([node, face], relative, [arm, apart + speed * stretch])
    }

    /// Bound on the speed in the face's frame of a point of side `node` at `arms` from both G \[m/s\], as in
    /// [`GapCurvature::curvature`].
    pub(in crate::dynamics) fn speed_on_face(&self, node: usize, [arm, apart]: [f64; 2], stretch: f64) -> f64 {
        let speed = self.speed + self.sides[node].spin * arm;
        speed + self.sides[1 - node].spin * (apart + speed * stretch)
    }

    /// Bounds on the relative motion over an interval of length `stretch` \[s\] of a point at `arms[0]` from G of the
    /// first body and one at `arms[1]` from G of the second, `distance` apart at the start \[m\].
    pub(in crate::dynamics) fn separation(&self, arms: [f64; 2], distance: f64, stretch: f64) -> SeparationBounds {
        let sum = |of: fn(&MotionBounds) -> f64| self.sides.iter().zip(arms).map(|(b, arm)| of(b) * arm).sum::<f64>();
        let speed = self.speed + sum(|b| b.spin);
        let acceleration = self.acceleration + sum(MotionBounds::acceleration_per_arm);
        SeparationBounds { distance: distance + speed * stretch, speed, acceleration }
    }

    /// Such bounds in axes that turn with the second body.
    pub(in crate::dynamics) fn carried(&self, bounds: SeparationBounds) -> SeparationBounds {
        bounds.carried(self.sides[1].spin, self.sides[1].spin_rate)
    }
}

/// Bounds on relative speed and acceleration of two bodies of one island; `None` for others.
fn difference(world: &World, slots: [Option<usize>; 2]) -> Option<[f64; 2]> {
    let [a, b] = slots.map(|slot| match world.bodies[slot?].now {
        Trajectory::Island { island, index } => Some((island, index)),
        Trajectory::Placed | Trajectory::Flight(_) => None,
    });
    let ((island, a), (other, b)) = (a?, b?);
    (island == other).then(|| world.islands[island].as_ref()?.apart(&world.model, [a, b]))?
}

/// Bounds on the motion of a body on its trajectory from `from` to `to`.
fn bound(world: &World, slot: usize, from: f64, to: f64) -> MotionBounds {
    match &world.bodies[slot].now {
        Trajectory::Placed => MotionBounds::still(f64::INFINITY),
        Trajectory::Flight(flight) => flight.bounds(from, to - from),
        Trajectory::Island { island, index } => world.islands[*island]
            .as_ref()
            .map_or(MotionBounds::still(f64::INFINITY), |island| island.bound(&world.model, *index)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::gap;
    use crate::dynamics::penalty3d::example::{SPEED, free_to_turn, row, wall};
    use crate::dynamics::world::example::planned;

    const RATE_SAMPLES: u32 = 400;

    fn times(until: f64) -> Vec<f64> {
        (0..=RATE_SAMPLES).map(|i| until * f64::from(i) / f64::from(RATE_SAMPLES)).collect()
    }

    fn until(world: &World) -> f64 {
        world.islands[0].as_ref().expect("an island").step.until
    }

    /// Largest difference quotient of a contact's gap rate over the planned step, and its bound \[m/s²\].
    fn curvatures(world: &World, contact: usize) -> [f64; 2] {
        let track = &world.contacts[contact];
        let (site, until) = (&world.model.sites[track.site], until(world));
        let rate = |t: f64| gap(&site.geometry, &world.side(contact, 0, t), &world.side(contact, 1, t))[1];
        let rates: Vec<f64> = times(until).into_iter().map(rate).collect();
        let step = until / f64::from(RATE_SAMPLES);
        let largest = rates.windows(2).map(|two| (two[1] - two[0]).abs() / step).fold(0.0, f64::max);
        let pair = &world.pairs[track.pair];
        let bounds = GapCurvature::of(world, pair.slots, 0.0, until);
        assert!(bounds.holds(until), "a step's bounds hold to its end");
        let arms = [track.geometry.arm, track.geometry.lever];
        [largest, bounds.curvature(usize::from(track.slots[0] == pair.slots[1]), arms, until)]
    }

    #[test]
    fn the_bound_is_above_the_second_derivative_of_every_gap_and_not_far_above() {
        let spinning = [0.0, 0.0, 0.0, SPEED, 0.1, 2.0];
        let other = [0.0, 0.0, 0.0, -SPEED, 0.0, -1.0];
        let worlds = [planned(&free_to_turn(wall()), &[spinning]), planned(&free_to_turn(row()), &[spinning, other])];
        for world in worlds {
            let all: Vec<[f64; 2]> = (0..world.contacts.len()).map(|contact| curvatures(&world, contact)).collect();
            assert!(all.iter().all(|[value, bound]| value <= bound), "{all:?} m/s²");
            let [value, bound] = all.iter().fold([0.0f64; 2], |[v, b], [value, bound]| [v.max(*value), b.max(*bound)]);
            assert!(bound < 10.0 * value, "{bound} m/s² against {value}");
        }
    }

    #[test]
    fn a_common_acceleration_of_one_island_cancels() {
        let drift = [0.0, 0.0, 0.0, 1.0, 0.3, 0.0];
        let world = planned(&row(), &[drift, drift]);
        let bounds = GapCurvature::of(&world, [Some(0), Some(1)], 0.0, until(&world));
        assert!(bounds.curvature(0, [0.1, 0.1], until(&world)) < 1e-9, "{bounds:?}");
        let alone = GapCurvature::of(&world, [Some(0), None], 0.0, until(&world));
        assert!(alone.speed >= 1.0, "against the ground the speed counts: {alone:?}");
    }

    #[test]
    fn two_points_stay_within_the_bounds_of_their_separation() {
        let world = planned(&free_to_turn(row()), &[[0.0, 0.0, 0.0, SPEED, 0.1, 2.0], [0.0; 6]]);
        let (until, arm) = (until(&world), glam::DVec3::new(0.03, -0.02, 0.0));
        let point = |slot: usize, t: f64| {
            let frame = world.frame(slot, 0, t);
            frame.origin() + frame.turn(arm)
        };
        let apart = |t: f64| point(1, t) - point(0, t);
        let bounds = GapCurvature::of(&world, [Some(0), Some(1)], 0.0, until);
        let bounds = bounds.separation([arm.length(); 2], apart(0.0).length(), until);
        let times = times(until);
        let farthest = times.iter().map(|&t| apart(t).length()).fold(0.0, f64::max);
        assert!(farthest <= bounds.distance && bounds.distance < 1.1 * farthest, "{bounds:?} against {farthest} m");
        let step = until / f64::from(RATE_SAMPLES);
        let speeds: Vec<glam::DVec3> = times.windows(2).map(|two| (apart(two[1]) - apart(two[0])) / step).collect();
        let fastest = speeds.iter().map(|v| v.length()).fold(0.0, f64::max);
        assert!(fastest <= bounds.speed && bounds.speed < 3.0 * fastest, "{bounds:?} against {fastest} m/s");
        let sharpest = speeds.windows(2).map(|two| (two[1] - two[0]).length() / step).fold(0.0, f64::max);
        assert!(sharpest <= bounds.acceleration, "{bounds:?} against {sharpest} m/s²");
    }
}
