//! Bounds on the second derivative of a gap between two bodies of which at least one is in a planned step.
//!
//! The other one may be in flight or in a step of another island. Two bodies of one island share their step, so that
//! the bound of their relative motion is that of the difference of the dense outputs.

use crate::dynamics::connection::SeparationBounds;
use crate::dynamics::model::motion_bounds::MotionBounds;
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
    /// distances of the node from its own G and from the other side's at the start \[m\]. With r from the face's G to
    /// the node and n fixed to the face, `g = n·r` and `g̈ = n·r̈ + 2 ṅ·ṙ + n̈·r`.
    pub(in crate::dynamics) fn curvature(&self, node: usize, [arm, apart]: [f64; 2], stretch: f64) -> f64 {
        let (face, node) = (&self.sides[1 - node], &self.sides[node]);
        let speed = self.speed + node.spin * arm;
        let apart = apart + speed * stretch;
        self.acceleration
            + (node.spin_rate + node.spin * node.spin) * arm
            + (face.spin_rate + face.spin * face.spin) * apart
            + 2.0 * face.spin * speed
    }

    /// Bounds on the relative motion over an interval of length `stretch` \[s\] of a point at `arms[0]` from G of the
    /// first body and one at `arms[1]` from G of the second, `distance` apart at the start \[m\].
    pub(in crate::dynamics) fn separation(&self, arms: [f64; 2], distance: f64, stretch: f64) -> SeparationBounds {
        let sum = |of: fn(&MotionBounds) -> f64| self.sides.iter().zip(arms).map(|(b, arm)| of(b) * arm).sum::<f64>();
        let speed = self.speed + sum(|b| b.spin);
        let acceleration = self.acceleration + sum(|b| b.spin_rate + b.spin * b.spin);
        SeparationBounds { distance: distance + speed * stretch, speed, acceleration }
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
    match (&world.bodies[slot].now, &world.bodies[slot].system) {
        (Trajectory::Island { island, index }, _) => world.islands[*island]
            .as_ref()
            .map_or(MotionBounds::still(f64::INFINITY), |island| island.bound(&world.model, *index)),
        (Trajectory::Flight(flight), Some(system)) => system.bounds(flight, from, to - from),
        _ => MotionBounds::still(f64::INFINITY),
    }
}
