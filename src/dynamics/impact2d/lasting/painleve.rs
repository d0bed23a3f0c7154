//! Contact modes where no motion is consistent with Coulomb friction (Painlevé).
//!
//! Past `W_nn − μ_k σ W_ns ≤ 0`, and where several contacts with friction are coupled, a slip may neither continue nor end.
//! Then, in this order,
//!
//! 1. slips below the stop speed become stick;
//! 2. a face at rest that opens at one end slips along it, with pressure at both ends, where its friction has fallen to the kinetic;
//! 3. modes that the event of this instant has ended are tried again, beside others than those with which they ended;
//! 4. contacts at rest that are statically indeterminate are *wedged* where some of their reactions lie in the friction cones
//!    ([`indeterminate`](super::indeterminate));
//! 5. **impact without collision**: friction stops slips at once, by impulses within Coulomb's law
//!    ([`impact_without_collision`](super::impact_without_collision)), and where there are no such the slowest first and as few as needed, by the
//!    least impulses that stop them and let no point approach (an orthogonal projection in the mass metric: no energy is added);
//! 6. otherwise the contacts go on without friction, which always has a solution; the run says so.
//!
//! A contact that is wedged or without friction remains so until other modes agree with Coulomb's law.

use glam::DVec3;

use crate::dynamics::impact2d::delassus::{Cluster, ContactPoint, centre};
use crate::dynamics::impact2d::impulse::simultaneous;
use crate::dynamics::impact2d::instant::ImpactInstant;
use crate::dynamics::impact2d::kinematics::BodyKinematics;
use crate::dynamics::impact2d::lasting::candidates::{candidates, tangential_speed};
use crate::dynamics::impact2d::lasting::constrained_motion::{
    ConstrainedMotion, ContactMode, FrictionMode, least_reactions,
};
use crate::dynamics::impact2d::lasting::impact_without_collision::{Stopped, stop_within_friction};
use crate::dynamics::impact2d::lasting::indeterminate::reactions_in_cones;
use crate::dynamics::impact2d::lasting::mode_selection::{Candidate, Excluded, select_modes, select_wedged};
use crate::dynamics::impact2d::lasting::switch::Ending;
use crate::dynamics::impact2d::world::World;

/// Candidates and their contact modes; velocities of the instant change where friction has to stop a slip. `ground` is the
/// acceleration of the ground \[m/s²\].
pub(in crate::dynamics::impact2d) fn consistent_modes(
    world: &World,
    instant: &mut ImpactInstant,
    ending: Option<Ending>,
    ground: DVec3,
) -> (Vec<Candidate>, Vec<ContactMode>) {
    let mut all = candidates(world, instant, ending);
    if let Some(modes) = modes_or_slow_stick(world, &instant.kinematics, &mut all) {
        return (all, modes);
    }
    if let Some(Ending::Opens(site)) = ending {
        // Of the contact that opens at one end: what has ended is the face at rest, not a slip with pressure at both ends.
        let mut again = candidates(world, instant, ending);
        for candidate in again.iter_mut().filter(|candidate| candidate.sites.contains(&site)) {
            candidate.excluded = Excluded { stick: true, site: None };
        }
        if let Some(modes) = select_modes(&world.model, &instant.kinematics, &again) {
            return (again, modes);
        }
    }
    let anew = candidates(world, instant, None);
    if let Some(modes) = select_modes(&world.model, &instant.kinematics, &anew) {
        return (anew, modes);
    }
    if let Some(modes) = select_wedged(&world.model, &instant.kinematics, &all) {
        return (all, modes);
    }
    let stops = ending.filter(|ending| matches!(ending, Ending::SlipStops(_)));
    // Each impact stops a slip; those of the second may have begun with the first.
    for _ in 0..=all.len() {
        let stopped = stop_within_friction(&world.model, &instant.kinematics, &all);
        let Some(Stopped { velocities, pairs }) = stopped else { break };
        instant.kinematics.cluster.velocity = velocities;
        all = anew_after_impulses(world, instant, stops, ground, &pairs);
        if let Some(modes) = modes_at_rest_or_wedged(world, &instant.kinematics, &mut all) {
            return (all, modes);
        }
    }
    let mut slipping = slips(&instant.kinematics.cluster, &all);
    let before = instant.kinematics.cluster.clone();
    let mut count = 0;
    while count < slipping.len() {
        count += 1;
        let stopped: Vec<ContactPoint> = slipping[..count].iter().map(|slip| slip.centre).collect();
        let pairs: Vec<usize> = slipping[..count].iter().map(|slip| slip.pair).collect();
        instant.kinematics.cluster = before.clone();
        simultaneous::stop(&mut instant.kinematics.cluster, &instant.manifolds, &stopped);
        all = anew_after_impulses(world, instant, stops, ground, &pairs);
        if let Some(modes) = modes_at_rest_or_wedged(world, &instant.kinematics, &mut all) {
            return (all, modes);
        }
        // What has begun to slip as others were stopped is stopped after those that had slipped.
        if count == slipping.len() {
            let begun = slips(&instant.kinematics.cluster, &all);
            slipping.extend(begun.into_iter().take(1));
        }
    }
    let modes = frictionless_modes(&instant.kinematics, &all);
    (all, modes)
}

/// A slip that is stopped by an impulse.
struct Slip {
    /// `|v_s|` \[m/s\].
    speed: f64,
    pair: usize,
    /// Middle of the contact.
    centre: ContactPoint,
}

/// Slips of the candidates, the slowest first.
fn slips(cluster: &Cluster, all: &[Candidate]) -> Vec<Slip> {
    let slips = all.iter().filter(|candidate| candidate.slip != 0.0);
    let slip = |c: &Candidate| Slip {
        speed: tangential_speed(cluster, &c.points).abs(),
        pair: c.pair,
        centre: centre(&c.points),
    };
    let mut slips: Vec<_> = slips.map(slip).collect();
    slips.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    slips
}

/// Whether at `t` no modes of these bodies agree with Coulomb's law and those in force, for want of others, still hold.
pub(in crate::dynamics::impact2d) fn must_go_on(world: &World, t: f64, slots: &[usize], modes: &[ContactMode]) -> bool {
    let instant = ImpactInstant::new(world, t, slots);
    let (kinematics, settings) = (&instant.kinematics, &world.model.impact);
    let holds = || {
        let points: Vec<_> = modes.iter().map(|mode| mode.points(&world.model, kinematics)).collect();
        let motion = least_reactions(kinematics, modes, &points, settings);
        motion.is_some_and(|m| reactions_in_cones(kinematics, modes, &points, settings, &m).is_some())
    };
    modes_or_slow_stick(world, kinematics, &mut candidates(world, &instant, None)).is_none()
        && (modes.iter().all(|mode| mode.friction != FrictionMode::Wedged) || holds())
}

/// Consistent modes, if need be with slips below the stop speed turned into stick.
fn modes_or_slow_stick(world: &World, kinematics: &BodyKinematics, all: &mut [Candidate]) -> Option<Vec<ContactMode>> {
    let stop_speed = world.model.impact.stop_speed;
    select_modes(&world.model, kinematics, all).or_else(|| {
        let mut slow = false;
        let is_slow = |c: &Candidate| tangential_speed(&kinematics.cluster, &c.points).abs() <= stop_speed;
        for candidate in all.iter_mut().filter(|c| is_slow(c)) {
            (candidate.stick_or_open, slow) = (true, true);
        }
        slow.then(|| select_modes(&world.model, kinematics, all)).flatten()
    })
}

/// Consistent modes, with slips below the stop speed turned into stick or wedged ones where there are no others.
fn modes_at_rest_or_wedged(
    world: &World,
    kinematics: &BodyKinematics,
    all: &mut [Candidate],
) -> Option<Vec<ContactMode>> {
    modes_or_slow_stick(world, kinematics, all).or_else(|| select_wedged(&world.model, kinematics, all))
}

/// Candidates with the velocities of the cluster after impulses that have stopped the slips of these pairs.
fn anew_after_impulses(
    world: &World,
    instant: &mut ImpactInstant,
    ending: Option<Ending>,
    ground: DVec3,
    stopped: &[usize],
) -> Vec<Candidate> {
    instant.take_velocities();
    instant.kinematics = BodyKinematics::new(&world.model, &instant.kinematics.bodies, &instant.states, ground);
    let mut all = candidates(world, instant, ending);
    for candidate in all.iter_mut().filter(|candidate| stopped.contains(&candidate.pair)) {
        candidate.slip = 0.0;
    }
    all
}

/// Contacts under pressure without friction: those of the accelerations nearest to the free ones that let no point approach.
fn frictionless_modes(kinematics: &BodyKinematics, all: &[Candidate]) -> Vec<ContactMode> {
    let free = ConstrainedMotion { reactions: Vec::new(), accelerations: kinematics.free.clone() };
    let points: Vec<ContactPoint> = all.iter().flat_map(|candidate| candidate.points.clone()).collect();
    let rates: Vec<f64> = points.iter().map(|p| free.along(p, p.n, p.bias[0])).collect();
    let rows: Vec<_> = points.iter().map(|p| (*p, p.n)).collect();
    let forces = simultaneous::non_negative_impulses(&kinematics.cluster, &rows, &rates, 0);
    let mut pressed = points.iter().zip(forces).map(|(point, force)| force > kinematics.force_round_off(point));
    let mut modes = Vec::new();
    for candidate in all {
        let kept = pressed.by_ref().take(candidate.sites.len());
        let sites: Vec<usize> = candidate.sites.iter().zip(kept).filter(|(_, kept)| *kept).map(|(&s, _)| s).collect();
        if !sites.is_empty() {
            modes.push(ContactMode { pair: candidate.pair, sites, friction: FrictionMode::Frictionless });
        }
    }
    modes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;

    /// A girder of 2 kg flush at a wall under this push \[N\], moving along it at 0.1 m/s.
    fn pushed(force: [f64; 2]) -> (World, ImpactInstant) {
        let keys = format!("push = {{ force_n = {force:?} }}\ninitial = {{ velocity_m_s = [0.0, 0.1] }}");
        let world = example::world(example::block(&keys, 0.0));
        let instant = ImpactInstant::new(&world, 0.0, &[0]);
        (world, instant)
    }

    #[test]
    fn without_friction_the_pressed_face_is_kept_and_the_pulled_one_is_not() {
        for (force, count) in [([10.0, 0.0], 1), ([-10.0, 0.0], 0)] {
            let (world, instant) = pushed(force);
            let all = candidates(&world, &instant, None);
            let modes = frictionless_modes(&instant.kinematics, &all);
            assert_eq!(modes.len(), count, "push {force:?} N");
            assert!(modes.iter().all(|m| m.is_flush() && m.friction == FrictionMode::Frictionless), "{modes:?}");
        }
    }

    #[test]
    fn stopping_a_slip_takes_the_speed_along_the_face_and_no_more_energy_than_there_was() {
        let (world, mut instant) = pushed([10.0, 0.0]);
        let before = instant.kinematics.cluster.clone();
        let point = centre(&instant.manifolds[0].points);
        simultaneous::stop(&mut instant.kinematics.cluster, &instant.manifolds, &[point]);
        let all = anew_after_impulses(&world, &mut instant, None, DVec3::ZERO, &[0]);
        assert_eq!(all[0].slip, 0.0, "it has stopped");
        let after = &instant.kinematics.cluster;
        assert!(after.speed(&point, point.s).abs() < 1e-15, "the middle of the face is at rest along it");
        assert!(after.kinetic_energy() <= before.kinetic_energy(), "a projection adds no energy");
        assert_eq!(instant.states[0][3..], after.velocity[0].to_array(), "states have the velocities");
    }

    #[test]
    fn a_consistent_slip_needs_no_resolution() {
        let (world, mut instant) = pushed([10.0, 0.0]);
        let before = instant.kinematics.cluster.clone();
        let (all, modes) = consistent_modes(&world, &mut instant, None, DVec3::ZERO);
        assert_eq!(instant.kinematics.cluster, before, "no impulse");
        assert_eq!((all.len(), modes.len()), (1, 1), "one flush pair");
        assert!(matches!(modes[0].friction, FrictionMode::Slip(_)), "{modes:?}");
    }
}
