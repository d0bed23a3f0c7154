//! Sequential impulses of one instant: the contact that approaches fastest is hit first, until none approaches.
//!
//! After [`HITS_WITH_RESTITUTION`] hits restitution is 0, after [`SEQUENTIAL_HITS`] all contacts are stopped at once
//! ([`simultaneous`]).

use glam::DVec2;

use crate::dynamics::impact2d::GirderState;
use crate::dynamics::impact2d::constants::{HITS_WITH_RESTITUTION, SEQUENTIAL_HITS};
use crate::dynamics::impact2d::impulse::collision::{Collision, ContactManifold, ImpactLaw, collide};
use crate::dynamics::impact2d::impulse::simultaneous;
use crate::dynamics::impact2d::instant::ImpactInstant;
use crate::dynamics::impact2d::record::{Hit, ImpactRecord, Transition};
use crate::dynamics::impact2d::tables::{Outcome, Row};
use crate::dynamics::impact2d::world::World;

/// Applies impulses and logs them; returns the energy lost \[J\]. `to` holds the states among a–f, by place, and receives
/// those that the hits lead to.
pub(in crate::dynamics::impact2d) fn impulses(
    world: &World,
    record: &mut ImpactRecord,
    instant: &mut ImpactInstant,
    to: &mut [GirderState],
) -> f64 {
    let mut lost = 0.0;
    for count in 0.. {
        let cluster = &instant.kinematics.cluster;
        let speed = |manifold: &ContactManifold| {
            manifold.points.iter().map(|p| cluster.speed(p, p.n)).fold(f64::INFINITY, f64::min)
        };
        let fastest =
            (0..instant.manifolds.len()).map(|i| (speed(&instant.manifolds[i]), i)).min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((speed, number)) = fastest else { break };
        if speed >= -instant.speed_noise {
            break;
        }
        let manifold = instant.manifolds[number].clone();
        let drift = world.normal_drift(instant.speed_noise);
        if count == 0 && speed >= -drift && world.are_kept(&manifold.sites) && !new_contact_approaches(world, instant) {
            // The error of the integrator, no hit.
            break;
        }
        if count > SEQUENTIAL_HITS {
            simultaneous::stop(&mut instant.kinematics.cluster, &instant.manifolds, &[]);
            break;
        }
        lost += hit(world, record, instant, &manifold, to, count > HITS_WITH_RESTITUTION);
    }
    lost
}

/// Whether a contact approaches that is not in lasting contact.
fn new_contact_approaches(world: &World, instant: &ImpactInstant) -> bool {
    let cluster = &instant.kinematics.cluster;
    let approaches =
        |manifold: &ContactManifold| manifold.points.iter().any(|p| cluster.speed(p, p.n) < -instant.speed_noise);
    instant.manifolds.iter().any(|manifold| !world.are_kept(&manifold.sites) && approaches(manifold))
}

/// One hit of one pair; returns the energy lost \[J\].
fn hit(
    world: &World,
    record: &mut ImpactRecord,
    instant: &mut ImpactInstant,
    manifold: &ContactManifold,
    to: &mut [GirderState],
    inelastic: bool,
) -> f64 {
    let model = &world.model;
    let places = instant.kinematics.places(model, manifold.pair);
    let place = places.into_iter().flatten().next().unwrap_or(0);
    let from = to[place];
    let law = ImpactLaw { settings: &model.impact, speed_noise: instant.speed_noise, inelastic };
    let collision = collide(&mut instant.kinematics.cluster, manifold, from, &law);
    let to_wall = model.pairs[manifold.pair].bodies.contains(&None);
    let row = if to_wall { Row::of_hit(&collision.conditions) } else { None };
    let after = state_after(&collision, to_wall);
    for place in places.into_iter().flatten() {
        if to[place] != after {
            let (t, body, pair) = (instant.t, instant.kinematics.bodies[place], Some(manifold.pair));
            record.transitions.push(Transition { t, body, pair, from: to[place], to: after, row, lost: 0.0 });
        }
        to[place] = after;
    }
    let frame = &instant.kinematics.frames[place];
    let lost = collision.impulses.lost;
    record.hits.push(Hit {
        t: instant.t,
        pair: manifold.pair,
        sites: manifold.sites.to_vec(),
        point: frame.origin().truncate() + if places[0].is_some() { collision.arm } else { DVec2::ZERO },
        impulses: collision.impulses,
        from,
        to: after,
        row,
    });
    lost
}

/// The state that a hit alone leads to; between two girders contact modes are selected afterwards.
fn state_after(collision: &Collision, to_wall: bool) -> GirderState {
    let (conditions, last) = (&collision.conditions, collision.impulses.last);
    let flat = conditions.flush && (!conditions.turns || last.is_some());
    match (last, conditions.outcome) {
        (Some(_), _) => GirderState::Sliding,
        (_, Outcome::Separates) if !conditions.turns => GirderState::Free,
        (_, Outcome::Separates) => GirderState::FreeTurning,
        _ if !to_wall => GirderState::FreeTurning,
        (_, Outcome::Contact { at_rest: true }) if flat => GirderState::Resting,
        (_, Outcome::Contact { at_rest: false }) if flat => GirderState::Sliding,
        (_, Outcome::Contact { at_rest: true } | Outcome::SecondImpulse { held: true }) => GirderState::Turning,
        (_, Outcome::Contact { .. } | Outcome::SecondImpulse { held: false }) => GirderState::SlidingTurning,
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::dynamics::impact2d::example;

    /// A straight girder flush at its wall with this velocity of G \[m/s\].
    fn at_wall(v: [f64; 2]) -> (World, ImpactInstant) {
        let world = example::world(example::at_wall(|scene| scene.impact.restitution_tangential = -1.0));
        let instant = example::instant(&world, v);
        (world, instant)
    }

    #[test]
    fn a_girder_that_approaches_is_hit_once_and_one_that_separates_is_not() {
        for (v_x, count) in [(0.5, 1), (-0.5, 0)] {
            let (world, mut instant) = at_wall([v_x, 0.0]);
            let before = instant.kinematics.cluster.kinetic_energy();
            let (mut record, mut to) = (ImpactRecord::default(), [GirderState::Free]);
            let lost = impulses(&world, &mut record, &mut instant, &mut to);
            assert_eq!(record.hits.len(), count, "{v_x} m/s");
            let after = instant.kinematics.cluster.kinetic_energy();
            assert!((before - after - lost).abs() < 1e-15, "{lost} J");
            assert!(
                instant.manifolds[0].points.iter().all(|p| instant.kinematics.cluster.speed(p, p.n) > 0.0),
                "apart"
            );
        }
    }

    #[test]
    fn the_drift_of_a_kept_contact_is_no_hit() {
        let (mut world, mut instant) = at_wall([1e-12, 0.0]);
        for site in &mut world.sites {
            site.kept = true;
        }
        let mut record = ImpactRecord::default();
        let lost = impulses(&world, &mut record, &mut instant, &mut [GirderState::Resting]);
        assert_eq!((record.hits.len(), lost), (0, 0.0), "1e-12 m/s by the integrator");
    }

    #[test]
    fn an_oblique_hit_without_friction_keeps_its_tangential_velocity() {
        let (world, mut instant) = at_wall([0.5, 0.3]);
        let (mut record, mut to) = (ImpactRecord::default(), [GirderState::Free]);
        impulses(&world, &mut record, &mut instant, &mut to);
        let v = instant.kinematics.cluster.velocity[0];
        let e_n = world.model.impact.restitution_normal;
        assert!((v - DVec3::new(-0.5 * e_n, 0.3, 0.0)).length() < 1e-15, "{v}");
        assert_eq!(to, [GirderState::Free], "b");
    }
}
