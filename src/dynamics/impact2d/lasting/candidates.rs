//! Pairs that may stay in contact after the impulses of an instant: touching points without normal speed.

use crate::dynamics::impact2d::constants::REST_ROUNDINGS;
use crate::dynamics::impact2d::delassus::{Cluster, ContactPoint, centre};
use crate::dynamics::impact2d::impulse::collision::ContactManifold;
use crate::dynamics::impact2d::instant::{ImpactInstant, manifolds};
use crate::dynamics::impact2d::lasting::mode_selection::{Candidate, Excluded};
use crate::dynamics::impact2d::lasting::switch::Ending;
use crate::dynamics::impact2d::world::World;

/// Whether every touching point separates.
pub(in crate::dynamics::impact2d) fn all_separate(world: &World, instant: &ImpactInstant) -> bool {
    instant.manifolds.iter().all(|manifold| {
        let rest = rest_speed(world, manifold, instant.speed_noise);
        manifold.points.iter().all(|point| instant.kinematics.cluster.speed(point, point.n) > rest)
    })
}

/// Normal speed that counts as none \[m/s\].
fn rest_speed(world: &World, manifold: &ContactManifold, speed_noise: f64) -> f64 {
    if world.are_kept(&manifold.sites) { world.normal_drift(speed_noise) } else { REST_ROUNDINGS * speed_noise }
}

/// Candidates of an instant; `ending` is what has ended a lasting contact then.
pub(in crate::dynamics::impact2d) fn candidates(
    world: &World,
    instant: &ImpactInstant,
    ending: Option<Ending>,
) -> Vec<Candidate> {
    let cluster = &instant.kinematics.cluster;
    let mut all = Vec::new();
    for manifold in manifolds(world, &instant.slots, &instant.kinematics) {
        let rest = rest_speed(world, &manifold, instant.speed_noise);
        // A contact that lasted and that a hit elsewhere parts slower than the stop speed closes again within a hop, which is left out as
        // the hops of a bounce are, where it is pressed.
        let parting = if world.are_kept(&manifold.sites) { world.model.impact.stop_speed.max(rest) } else { rest };
        let stays = |point: &ContactPoint| (-rest..=parting).contains(&cluster.speed(point, point.n));
        let kept: Vec<(usize, ContactPoint)> =
            manifold.sites.iter().copied().zip(manifold.points.iter().copied()).filter(|(_, p)| stays(p)).collect();
        if kept.is_empty() {
            continue;
        }
        let (sites, points): (Vec<usize>, Vec<ContactPoint>) = kept.into_iter().unzip();
        let rest_along = if points.len() > 1 { world.model.impact.stop_speed } else { rest };
        let v_s = tangential_speed(cluster, &points);
        let slips = v_s.abs() > rest_along && ending != Some(Ending::SlipStops(manifold.pair));
        let excluded = match ending {
            Some(Ending::Opens(site)) => Excluded { stick: false, site: Some(site) },
            _ => Excluded { stick: ending == Some(Ending::BreaksAway(manifold.pair)), site: None },
        };
        let slip = if slips { v_s.signum() } else { 0.0 };
        all.push(Candidate { pair: manifold.pair, sites, points, slip, stick_or_open: false, excluded });
    }
    all
}

/// Relative speed along the face at the corner, or at the middle of the face \[m/s\].
pub(in crate::dynamics::impact2d) fn tangential_speed(cluster: &Cluster, points: &[ContactPoint]) -> f64 {
    let centre = centre(points);
    cluster.speed(&centre, centre.s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;
    use crate::scene::presets;

    /// A straight girder flush at its wall with this velocity of G \[m/s\].
    fn at_wall(v: [f64; 2]) -> (World, ImpactInstant) {
        let world = example::world(example::at_wall(|_| ()));
        let instant = example::instant(&world, v);
        (world, instant)
    }

    #[test]
    fn a_face_with_normal_speed_is_no_candidate() {
        // The wall is at +x, so the girder leaves it along −x.
        let (world, instant) = at_wall([-0.1, 0.0]);
        assert!(all_separate(&world, &instant), "both corners separate");
        assert!(candidates(&world, &instant, None).is_empty(), "none stays");
    }

    #[test]
    fn a_contact_that_lasted_stays_where_a_hit_elsewhere_parts_it_slower_than_the_stop_speed() {
        let stop = presets::load("straight-abutment").expect("a preset").impact.stop_speed;
        let count = |kept: bool, parting: f64| {
            let (mut world, instant) = at_wall([-parting, 0.0]);
            world.sites.iter_mut().for_each(|site| site.kept = kept);
            candidates(&world, &instant, None).len()
        };
        assert_eq!(count(true, 0.9 * stop), 1, "it lasted, and parts slowly");
        assert_eq!(count(true, 1.1 * stop), 0, "it parts faster than the stop speed");
        assert_eq!(count(false, 0.9 * stop), 0, "it has only just met");
    }

    #[test]
    fn a_face_slips_above_the_stop_speed_only_and_not_where_slip_has_just_stopped() {
        let slip = |v_y: f64, ending: Option<Ending>| {
            let (world, instant) = at_wall([0.0, v_y]);
            let all = candidates(&world, &instant, ending);
            assert_eq!((all.len(), all[0].sites.len()), (1, 2), "one flush pair");
            all[0].slip
        };
        let stop = presets::load("straight-abutment").expect("a preset").impact.stop_speed;
        assert_eq!(slip(0.5 * stop, None), 0.0, "below the stop speed");
        assert_eq!(slip(2.0 * stop, None).abs(), 1.0, "above");
        assert_eq!(slip(2.0 * stop, None), -slip(-2.0 * stop, None), "either way");
        assert_eq!(slip(2.0 * stop, Some(Ending::SlipStops(0))), 0.0, "the slip has just stopped");
    }

    #[test]
    fn what_has_ended_is_excluded() {
        let (world, instant) = at_wall([0.0, 0.0]);
        let excluded = |ending| candidates(&world, &instant, Some(ending))[0].excluded;
        assert_eq!(excluded(Ending::BreaksAway(0)), Excluded { stick: true, site: None }, "friction gave way");
        assert_eq!(excluded(Ending::Opens(1)), Excluded { stick: false, site: Some(1) }, "a point has opened");
    }
}
