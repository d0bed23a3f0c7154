//! How sharply a gap between two bodies can bend while at least one of them is in a planned step.
//!
//! The other may fly in closed form or be in a step of its own; two bodies of one island share their step, so that what they
//! do together cancels.

use crate::dynamics::connection::SeparationBounds;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::Trajectory;

/// What two bodies can do against each other over a stretch of time.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct GapCurvature {
    /// Each by itself.
    sides: [MotionBounds; 2],
    /// Speed of one G against the other \[m/s\].
    speed: f64,
    /// Its change \[m/s²\].
    acceleration: f64,
}

impl GapCurvature {
    /// Of the bodies in two slots from `from` to `to`; an abutment stands.
    pub(in crate::dynamics) fn of(world: &World, slots: [Option<usize>; 2], from: f64, to: f64) -> Self {
        let sides =
            slots.map(|slot| slot.map_or(MotionBounds::still(f64::INFINITY), |slot| bound(world, slot, from, to)));
        let summed = [sides[0].speed + sides[1].speed, sides[0].acceleration + sides[1].acceleration];
        let [speed, acceleration] = together(world, slots).unwrap_or(summed);
        Self { sides, speed, acceleration }
    }

    /// Whether it holds for so long \[s\].
    pub(in crate::dynamics) fn holds(&self, stretch: f64) -> bool {
        self.sides[0].window.min(self.sides[1].window) >= stretch
    }

    /// Bound on `|g̈|` of a node of side `node`, at `arms` from its own G and from the other side's at the start of the
    /// stretch \[m/s²\]. `g = n·r`, r from the face's G to the node, and n turns with the face.
    pub(in crate::dynamics) fn curvature(&self, node: usize, [arm, apart]: [f64; 2], stretch: f64) -> f64 {
        let (face, node) = (&self.sides[1 - node], &self.sides[node]);
        let speed = self.speed + node.spin * arm;
        let apart = apart + speed * stretch;
        self.acceleration
            + (node.spin_rate + node.spin * node.spin) * arm
            + (face.spin_rate + face.spin * face.spin) * apart
            + 2.0 * face.spin * speed
    }

    /// Bounds on the motion of a point at `arms[0]` from G of the first body against one at `arms[1]` from G of the second,
    /// `distance` apart at the start of the stretch \[m\].
    pub(in crate::dynamics) fn separation(&self, arms: [f64; 2], distance: f64, stretch: f64) -> SeparationBounds {
        let sum = |of: fn(&MotionBounds) -> f64| self.sides.iter().zip(arms).map(|(b, arm)| of(b) * arm).sum::<f64>();
        let speed = self.speed + sum(|b| b.spin);
        let acceleration = self.acceleration + sum(|b| b.spin_rate + b.spin * b.spin);
        SeparationBounds { distance: distance + speed * stretch, speed, acceleration }
    }
}

/// The difference of two bodies of one island.
fn together(world: &World, slots: [Option<usize>; 2]) -> Option<[f64; 2]> {
    let [a, b] = slots.map(|slot| match world.bodies[slot?].now {
        Trajectory::Island { island, index } => Some((island, index)),
        Trajectory::Placed | Trajectory::Flight(_) => None,
    });
    let ((island, a), (other, b)) = (a?, b?);
    (island == other).then(|| world.islands[island].as_ref()?.apart(&world.model, [a, b]))?
}

/// What a body can do at most on its trajectory.
fn bound(world: &World, slot: usize, from: f64, to: f64) -> MotionBounds {
    match (&world.bodies[slot].now, &world.bodies[slot].system) {
        (Trajectory::Island { island, index }, _) => world.islands[*island]
            .as_ref()
            .map_or(MotionBounds::still(f64::INFINITY), |island| island.bound(&world.model, *index)),
        (Trajectory::Flight(flight), Some(system)) => system.bounds(flight, from, to - from),
        _ => MotionBounds::still(f64::INFINITY),
    }
}
