//! After the impulses of an instant: contact modes, projected states, trajectories in force, log of state changes.

use crate::dynamics::Body;
use crate::dynamics::impact2d::GirderState;
use crate::dynamics::impact2d::constants::{GAP_ROUNDING, KEPT_TOUCH, LIFTED_DEPTH, ROTATION_ROUNDING, TOUCH};
use crate::dynamics::impact2d::impulse::collision::ContactManifold;
use crate::dynamics::impact2d::instant::ImpactInstant;
use crate::dynamics::impact2d::kinematics::{BodyKinematics, ground_acceleration};
use crate::dynamics::impact2d::lasting::candidates::{all_separate, tangential_speed};
use crate::dynamics::impact2d::lasting::constrained_motion::{ContactMode, FrictionMode, connected_groups};
use crate::dynamics::impact2d::lasting::lasting_contact::LastingContact;
use crate::dynamics::impact2d::lasting::mode_selection::select_modes;
use crate::dynamics::impact2d::lasting::painleve::consistent_modes;
use crate::dynamics::impact2d::lasting::switch::Ending;
use crate::dynamics::impact2d::projection::project;
use crate::dynamics::impact2d::record::Transition;
use crate::dynamics::impact2d::run::ImpactRun;
use crate::dynamics::impact2d::tables::Row;
use crate::dynamics::impact2d::tracks::Trajectory;
use crate::dynamics::impact2d::world::World;
use crate::dynamics::model::coordinates::planar::{self, PlanarState};

/// Selects contact modes and starts the trajectories from here on. `to` holds the states among a–f that the hits lead to, by
/// place, `energy` the kinetic energy that they left \[J\]; `ending` is what has ended a lasting contact at this instant.
pub(in crate::dynamics::impact2d) fn resume(
    run: &mut ImpactRun,
    instant: &mut ImpactInstant,
    to: &[GirderState],
    energy: f64,
    ending: Option<Ending>,
) {
    instant.take_velocities();
    let world = &run.world;
    let bodies = instant.kinematics.bodies.clone();
    let ground = &world.model.ground;
    let ground = ground_acceleration(ground, &ground.piece(ground.piece_number(instant.t)), instant.t);
    if all_separate(world, instant) {
        let mut lost = energy - instant.kinematics.cluster.kinetic_energy();
        let strain = strain_energy(world, instant);
        if project(world, instant, &[]) {
            lost += strain - strain_energy(world, instant);
            // A body that was moved out of a face begins its flight outside, not at the depth at which it was hit.
            instant.kinematics = BodyKinematics::new(&world.model, &bodies, &instant.states, ground);
        }
        start_trajectories(run, instant, to, Vec::new(), lost);
        return;
    }
    instant.kinematics = BodyKinematics::new(&world.model, &bodies, &instant.states, ground);
    let modes = modes(world, instant, ending, ground);
    let strain = strain_energy(world, instant);
    project(world, instant, &modes);
    instant.kinematics = BodyKinematics::new(&world.model, &bodies, &instant.states, ground);
    let lost = energy - instant.kinematics.cluster.kinetic_energy() + strain - strain_energy(world, instant);
    start_trajectories(run, instant, to, modes, lost);
}

/// Contact modes of an instant. A face that slips below the stop speed and cannot stick continues to slip in its direction.
fn modes(world: &World, instant: &mut ImpactInstant, ending: Option<Ending>, ground: glam::DVec3) -> Vec<ContactMode> {
    let (mut candidates, modes) = consistent_modes(world, instant, ending, ground);
    let mut slips_on = false;
    for candidate in &mut candidates {
        let sticks = modes.iter().any(|mode| mode.pair == candidate.pair && mode.friction.sticks());
        let v_s = tangential_speed(&instant.kinematics.cluster, &candidate.points);
        if candidate.slip == 0.0 && !sticks && v_s.abs() > instant.speed_noise {
            (candidate.slip, slips_on) = (v_s.signum(), true);
        }
    }
    let model = &world.model;
    let again = slips_on.then(|| select_modes(model, &instant.kinematics, &candidates)).flatten();
    again.unwrap_or(modes)
}

/// Energy in the bearings of the bodies of an instant \[J\].
fn strain_energy(world: &World, instant: &ImpactInstant) -> f64 {
    let body = |(&body, state): (&usize, &PlanarState)| {
        let q = planar::positions(state);
        0.5 * q.dot(world.model.bodies[body].planar.stiffness * q)
    };
    instant.kinematics.bodies.iter().zip(&instant.states).map(body).sum()
}

/// Starts flights and lasting contacts, logs changes of state, and searches the next impacts.
fn start_trajectories(
    run: &mut ImpactRun,
    instant: &ImpactInstant,
    to: &[GirderState],
    modes: Vec<ContactMode>,
    lost: f64,
) {
    let first_step = end_trajectories(run, instant);
    for (place, &slot) in instant.slots.iter().enumerate() {
        let state = state_of(&run.world, instant, place, &modes);
        log_change(run, instant, place, [to[place], state], &modes, if place == 0 { lost } else { 0.0 });
        let track = &mut run.world.bodies[slot];
        track.since = instant.t;
        track.state = state;
        track.motion = Trajectory::Flight(track.free_motion.fly(instant.t, instant.states[place]));
        run.world.update_peaks(slot, &instant.states[place]);
    }
    mark_sites(&mut run.world, instant, &modes);
    let model = std::sync::Arc::clone(&run.world.model);
    for group in connected_groups(&model, &instant.kinematics, modes) {
        start_lasting(run, instant, group, first_step);
    }
    run.search_around(&instant.slots, instant.t);
}

/// The shortest step that an ended lasting contact would have taken next, from which those that follow begin \[s\]; `None` where none ended
/// or none took steps.
fn end_trajectories(run: &mut ImpactRun, instant: &ImpactInstant) -> Option<f64> {
    for &slot in &instant.slots {
        run.close_segment(slot, instant.t);
    }
    let ended = instant.slots.iter().filter_map(|&slot| match run.world.bodies[slot].motion {
        Trajectory::Lasting(number, _) => run.end_lasting(number, instant.t),
        Trajectory::Flight(_) => None,
    });
    ended.reduce(f64::min)
}

fn start_lasting(
    run: &mut ImpactRun,
    instant: &ImpactInstant,
    (places, modes): (Vec<usize>, Vec<ContactMode>),
    first_step: Option<f64>,
) {
    let bodies: Vec<usize> = places.iter().map(|&place| instant.kinematics.bodies[place]).collect();
    let states: Vec<PlanarState> = places.iter().map(|&place| instant.states[place]).collect();
    let lasting = &mut run.world.lasting;
    let number = lasting.iter().position(Option::is_none).unwrap_or(lasting.len());
    if number == lasting.len() {
        lasting.push(None);
    }
    lasting[number] = Some(LastingContact::new(bodies, modes, &states, instant.t).with_first_step(first_step));
    for (at, &place) in places.iter().enumerate() {
        run.world.bodies[instant.slots[place]].motion = Trajectory::Lasting(number, at);
    }
    run.plan(number);
}

/// Marks the declared contacts: kept, lifted off without normal speed, or behind a face beside it.
fn mark_sites(world: &mut World, instant: &ImpactInstant, modes: &[ContactMode]) {
    for pair in world.pairs_within(&instant.slots) {
        let pair_number = world.pairs[pair].number;
        let flush = modes.iter().any(|mode| mode.is_flush() && mode.pair == pair_number);
        let radius = world.radius(pair);
        let near = TOUCH * radius;
        for site in world.pairs[pair].sites.clone() {
            let number = world.sites[site].number;
            let point = instant.kinematics.point(&world.model, number);
            let on_face = flush && point.gap.abs() <= KEPT_TOUCH * near;
            let kept = modes.iter().any(|mode| mode.sites.contains(&number)) || on_face;
            let touches = world.touches(site, pair, &point);
            let track = &mut world.sites[site];
            (track.kept, track.in_front_at) = (kept, None);
            if touches && !kept {
                // Until it is clearly in front it hits again just behind the face, so that round-off is no hit.
                (track.armed, track.lifted) = (false, true);
                let behind = (LIFTED_DEPTH * radius).max(GAP_ROUNDING * track.spot.size);
                track.depth = behind + (-point.gap).max(0.0);
            } else if point.gap < near && !touches && !kept {
                track.pass_beside(instant.t);
            }
        }
    }
}

/// Whether a contact mode concerns the body at a place.
fn concerns(world: &World, instant: &ImpactInstant, pair: usize, place: usize) -> bool {
    instant.kinematics.places(&world.model, pair).contains(&Some(place))
}

/// State among a–f of the body at a place.
fn state_of(world: &World, instant: &ImpactInstant, place: usize, modes: &[ContactMode]) -> GirderState {
    if let Some(mode) = modes.iter().find(|mode| concerns(world, instant, mode.pair, place)) {
        return mode.state();
    }
    let body = &world.model.bodies[instant.kinematics.bodies[place]];
    let v = instant.kinematics.cluster.velocity[place];
    let turns = turns_without_contact(body)
        || body.radius * v.z.abs() > instant.speed_noise.max(ROTATION_ROUNDING * v.truncate().length())
        || instant.states[place][2].abs() > ROTATION_ROUNDING;
    if turns { GirderState::FreeTurning } else { GirderState::Free }
}

/// Logs the change of a body from the state after the hits to the one in force.
fn log_change(
    run: &mut ImpactRun,
    instant: &ImpactInstant,
    place: usize,
    [after_hits, now]: [GirderState; 2],
    modes: &[ContactMode],
    lost: f64,
) {
    let (world, record) = (&run.world, &mut run.record);
    let body = instant.kinematics.bodies[place];
    let first = instant.t == 0.0 && !record.transitions.iter().any(|change| change.body == body);
    if now == after_hits && !first && lost.abs() <= f64::MIN_POSITIVE {
        return;
    }
    let pair = modes.iter().map(|mode| mode.pair).find(|&pair| concerns(world, instant, pair, place));
    let touching = |manifold: &&ContactManifold| concerns(world, instant, manifold.pair, place);
    let pair = pair.or_else(|| instant.manifolds.iter().find(touching).map(|manifold| manifold.pair));
    let to_wall = pair.is_some_and(|pair| world.model.pairs[pair].bodies.contains(&None));
    // The tables know one coefficient of a face and its corners, and friction that something agrees with.
    let outside = |mode: &ContactMode| {
        matches!(mode.friction, FrictionMode::SlipAtEnd { .. } | FrictionMode::Wedged | FrictionMode::Frictionless)
            && concerns(world, instant, mode.pair, place)
    };
    let by_tables = to_wall && now != after_hits && !modes.iter().any(outside);
    let row = if by_tables { Row::without_hit(after_hits, now) } else { None };
    let from = if first { now } else { after_hits };
    record.transitions.push(Transition { t: instant.t, body, pair, from, to: now, row, lost });
}

/// Whether eccentric bearings or a given moment turn a girder without a hit.
fn turns_without_contact(body: &Body) -> bool {
    let coupled = |m: &glam::DMat3| {
        let [x, y] = [m.z_axis.x, m.z_axis.y];
        x.abs() > ROTATION_ROUNDING * (m.x_axis.x * m.z_axis.z).sqrt()
            || y.abs() > ROTATION_ROUNDING * (m.y_axis.y * m.z_axis.z).sqrt()
    };
    planar::free(body)[2] && (body.moment.z != 0.0 || coupled(&body.planar.stiffness) || coupled(&body.planar.damping))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;

    /// A straight girder flush at its wall at +x under this push \[N\], after impulses that leave this velocity \[m/s\] in
    /// state b.
    fn resumed(push: [f64; 2], velocity: [f64; 2]) -> ImpactRun {
        let model = example::at_wall(|scene| scene.girders[0].push.force = [push[0], push[1], 0.0]);
        let mut run = ImpactRun::before_start(example::world(model));
        let mut instant = example::instant(&run.world, velocity);
        let energy = instant.kinematics.cluster.kinetic_energy();
        resume(&mut run, &mut instant, &[GirderState::Free], energy, None);
        run
    }

    #[test]
    fn a_separating_girder_flies_and_its_points_hit_again_behind_the_face_only() {
        let run = resumed([0.0; 2], [-0.1, 0.0]);
        let body = &run.world.bodies[0];
        assert!(matches!(body.motion, Trajectory::Flight(_)) && body.state == GirderState::Free, "{:?}", body.motion);
        let lifted: Vec<_> = run.world.sites.iter().filter(|site| site.lifted).collect();
        assert_eq!(lifted.len(), 2, "both corners of the face");
        for site in lifted {
            assert!(!site.kept && !site.armed && site.depth >= LIFTED_DEPTH * run.world.radius(0), "{site:?}");
        }
    }

    #[test]
    fn a_pressed_face_rests_and_is_kept() {
        let run = resumed([40.0, 0.0], [0.0; 2]);
        assert_eq!(run.world.bodies[0].state, GirderState::Resting, "f");
        assert!(matches!(run.world.bodies[0].motion, Trajectory::Lasting(0, 0)), "the first lasting contact");
        assert_eq!(run.world.sites.iter().filter(|site| site.kept).count(), 2, "both corners of the face");
        assert!(run.world.planned_end(0).is_some_and(|end| end > 0.0), "a step is planned");
    }

    #[test]
    fn a_face_above_the_stop_speed_slides() {
        let run = resumed([40.0, 0.0], [0.0, 0.3]);
        assert_eq!(run.world.bodies[0].state, GirderState::Sliding, "e");
    }

    #[test]
    fn a_point_behind_a_face_that_it_is_not_on_is_beside_it() {
        let mut run = ImpactRun::before_start(example::world(example::at_wall(|_| ())));
        run.world.sites[0].beside = Some(0.0);
        let mut instant = example::instant(&run.world, [-0.1, 0.0]);
        resume(&mut run, &mut instant, &[GirderState::Free], 0.0, None);
        let site = &run.world.sites[0];
        assert_eq!((site.armed, site.lifted, site.beside), (false, false, Some(0.0)), "not lifted: it has not touched");
    }

    #[test]
    fn the_first_state_is_logged_and_afterwards_changes_alone() {
        let mut run = resumed([0.0; 2], [-0.1, 0.0]);
        let first = &run.record.transitions[0];
        assert_eq!(
            (run.record.transitions.len(), first.from, first.to),
            (1, GirderState::Free, GirderState::Free),
            "the first"
        );
        let mut instant = ImpactInstant { t: 0.1, ..example::instant(&run.world, [-0.1, 0.0]) };
        let energy = instant.kinematics.cluster.kinetic_energy();
        resume(&mut run, &mut instant, &[GirderState::Free], energy, None);
        assert_eq!(run.record.transitions.len(), 1, "the same state without a loss of energy");
        let mut instant = ImpactInstant { t: 0.2, ..example::instant(&run.world, [-0.1, 0.0]) };
        resume(&mut run, &mut instant, &[GirderState::Sliding], energy, None);
        let last = run.record.transitions.last().expect("a change");
        assert_eq!(
            (last.t, last.from, last.to),
            (0.2, GirderState::Sliding, GirderState::Free),
            "from the state after the hits"
        );
    }

    #[test]
    fn a_given_moment_turns_a_girder_that_is_free_to_turn() {
        let mut model = example::at_wall(|_| ());
        assert!(!turns_without_contact(&model.bodies[0]), "bearings on both axes");
        model.bodies[0].moment.z = 1.0;
        assert!(turns_without_contact(&model.bodies[0]), "a moment");
        model.bodies[0].free[5] = false;
        assert!(!turns_without_contact(&model.bodies[0]), "held");
    }
}
