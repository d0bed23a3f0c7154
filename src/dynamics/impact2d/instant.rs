//! The bodies that an instant concerns, with their velocities and the contacts among them.

use smallvec::smallvec;

use crate::dynamics::impact2d::constants::{RUN_SPEED_ROUNDING, TOUCH};
use crate::dynamics::impact2d::delassus::ContactPoint;
use crate::dynamics::impact2d::impulse::collision::ContactManifold;
use crate::dynamics::impact2d::kinematics::{BodyKinematics, ground_acceleration};
use crate::dynamics::impact2d::tracks::Trajectory;
use crate::dynamics::impact2d::world::World;
use crate::dynamics::impact2d::{GirderState, InlineVec};
use crate::dynamics::model::coordinates::planar::{POSITIONS, PlanarState};

/// Bodies joined by touching pairs and lasting contacts at one instant. A *place* is the position of a body in these lists.
pub(in crate::dynamics::impact2d) struct ImpactInstant {
    /// \[s\].
    pub t: f64,
    /// Slots, rising; so are the numbers in the model.
    pub slots: InlineVec<usize>,
    pub states: InlineVec<PlanarState>,
    pub kinematics: BodyKinematics,
    /// States among a–f before.
    pub before: InlineVec<GirderState>,
    /// Pairs that touch.
    pub manifolds: InlineVec<ContactManifold>,
    /// Speed that is round-off \[m/s\].
    pub speed_noise: f64,
}

impl ImpactInstant {
    /// The instant `t` of all bodies joined to the seeds.
    pub(in crate::dynamics::impact2d) fn new(world: &World, t: f64, seeds: &[usize]) -> Self {
        let slots = connected(world, t, seeds);
        let states: InlineVec<PlanarState> = slots.iter().map(|&slot| world.state(slot, t)).collect();
        let bodies: InlineVec<usize> = slots.iter().map(|&slot| world.bodies[slot].body).collect();
        let ground = &world.model.ground;
        let piece = ground.piece(ground.piece_number(t));
        let kinematics = BodyKinematics::new(&world.model, &bodies, &states, ground_acceleration(ground, &piece, t));
        let before = slots.iter().map(|&slot| world.bodies[slot].state).collect();
        let manifolds = manifolds(world, &slots, &kinematics);
        let points = manifolds.iter().flat_map(|manifold| &manifold.points);
        let speed_noise = kinematics.cluster.speed_round_off(points).max(RUN_SPEED_ROUNDING * world.peak_speed);
        Self { t, slots, states, kinematics, before, manifolds, speed_noise }
    }

    /// Writes the velocities after impulses into the states.
    pub(in crate::dynamics::impact2d) fn take_velocities(&mut self) {
        for (state, v) in self.states.iter_mut().zip(&self.kinematics.cluster.velocity) {
            state[POSITIONS..].copy_from_slice(&v.to_array());
        }
    }
}

/// Slots that touching pairs and lasting contacts join to the seeds, rising.
fn connected(world: &World, t: f64, seeds: &[usize]) -> InlineVec<usize> {
    let mut slots: InlineVec<usize> = seeds.into();
    let mut next = 0;
    while let Some(&slot) = slots.get(next) {
        next += 1;
        let mut joined: InlineVec<usize> = InlineVec::new();
        if let Trajectory::Lasting(number, _) = world.bodies[slot].motion
            && let Some(contact) = &world.lasting[number]
        {
            joined.extend(world.slots(&contact.bodies));
        }
        for &pair in &world.bodies[slot].pairs {
            if let [Some(a), Some(b)] = world.pairs[pair].slots
                && world.pair_touches(pair, t)
            {
                joined.extend([a, b]);
            }
        }
        joined.retain(|slot| !slots.contains(slot));
        joined.dedup();
        slots.extend(joined);
    }
    slots.sort_unstable();
    slots.dedup();
    slots
}

/// Touching pairs among these slots, each at a corner or at the two outermost points of a face.
pub(in crate::dynamics::impact2d) fn manifolds(
    world: &World,
    slots: &[usize],
    kinematics: &BodyKinematics,
) -> InlineVec<ContactManifold> {
    let mut manifolds = InlineVec::new();
    for pair in world.pairs_within(slots) {
        let mut touching: InlineVec<(usize, ContactPoint)> = InlineVec::new();
        for site in world.pairs[pair].sites.clone() {
            let number = world.sites[site].number;
            let point = kinematics.point(&world.model, number);
            if world.touches(site, pair, &point) {
                touching.push((number, point));
            }
        }
        touching.sort_by(|a, b| a.1.along.total_cmp(&b.1.along));
        let near = TOUCH * world.radius(pair);
        let outermost: InlineVec<(usize, ContactPoint)> = match (touching.first(), touching.last()) {
            (Some(&first), Some(&last)) if last.1.along - first.1.along > near => smallvec![first, last],
            (Some(&first), _) => smallvec![first],
            _ => continue,
        };
        let (sites, points) = outermost.into_iter().unzip();
        manifolds.push(ContactManifold { pair: world.pairs[pair].number, sites, points });
    }
    manifolds
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;

    #[test]
    fn a_flush_face_touches_with_its_two_corners_and_an_open_one_not_at_all() {
        for (gap, count) in [(0.0, 2), (1e-6, 0)] {
            let model = example::preset("straight-abutment", |scene| scene.abutments[0].gap = Some(gap));
            let instant = ImpactInstant::new(&example::world(model), 0.0, &[0]);
            let points: usize = instant.manifolds.iter().map(|manifold| manifold.points.len()).sum();
            assert_eq!(points, count, "gap {gap} m");
            assert_eq!(instant.slots[..], [0], "the wall is no body");
        }
    }

    #[test]
    fn velocities_after_an_impulse_go_into_the_states() {
        let world = example::world(example::preset("straight-abutment", |_| ()));
        let mut instant = ImpactInstant::new(&world, 0.0, &[0]);
        let place = instant.states[0][0];
        instant.kinematics.cluster.velocity[0] = glam::DVec3::new(1.0, 2.0, 3.0);
        instant.take_velocities();
        assert_eq!(instant.states[0], [place, instant.states[0][1], instant.states[0][2], 1.0, 2.0, 3.0], "rates only");
    }
}
