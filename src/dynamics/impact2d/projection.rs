//! Projection of places and velocities onto the constraints of the kept contacts, in the mass metric.
//!
//! Removes what the error of the integrator has left: gaps and normal speeds of kept points, slip of sticking contacts, and
//! penetration of points that separate, which would otherwise deepen with every small hop.

use glam::DVec2;

use crate::dynamics::impact2d::constants::{PLACE_ROUNDING, REST_SNAP_ROUNDINGS, SINGULAR_PIVOT};
use crate::dynamics::impact2d::delassus::{ContactPoint, centre};
use crate::dynamics::impact2d::instant::ImpactInstant;
use crate::dynamics::impact2d::lasting::constrained_motion::ContactMode;
use crate::dynamics::impact2d::world::World;
use crate::dynamics::integrator::dense_lu::solve_regularised;
use crate::dynamics::model::coordinates::planar::POSITIONS;

/// A kinematic constraint of a contact point.
struct Constraint {
    point: ContactPoint,
    /// Unit vector along which the point is held.
    direction: DVec2,
    /// Error along it that is removed \[m\].
    distance: f64,
}

impl Constraint {
    /// Of the gap of a point.
    fn of_gap(point: &ContactPoint) -> Self {
        Self { point: *point, direction: point.n, distance: point.gap }
    }
}

/// Projects the states of an instant; returns whether there was any constraint.
pub(in crate::dynamics::impact2d) fn project(
    world: &World,
    instant: &mut ImpactInstant,
    modes: &[ContactMode],
) -> bool {
    let mut rows = kept_rows(world, instant, modes);
    let kept = rows.len();
    rows.extend(separating_rows(world, instant, modes));
    if rows.is_empty() {
        return false;
    }
    let cluster = &instant.kinematics.cluster;
    let entry =
        |r: usize, c: usize| cluster.mobility(&rows[r].point, rows[r].direction, &rows[c].point, rows[c].direction);
    let speed = |r: usize| -cluster.speed(&rows[r].point, rows[r].direction);
    let speeds = solve_regularised(kept, entry, speed, SINGULAR_PIVOT);
    let shifts = solve_regularised(rows.len(), entry, |r| -rows[r].distance, SINGULAR_PIVOT);
    for (solution, from) in [(shifts, 0), (speeds, 3)] {
        for (Constraint { point, direction, .. }, size) in rows.iter().zip(solution.unwrap_or_default()) {
            for (body, row) in point.row(*direction * size) {
                if let Some(b) = body {
                    let change = instant.kinematics.cluster.inverse[b] * row;
                    for i in 0..3 {
                        instant.states[b][from + i] += change[i];
                    }
                }
            }
        }
    }
    stop_resting_bodies(world, instant, modes);
    true
}

fn kept_rows(world: &World, instant: &ImpactInstant, modes: &[ContactMode]) -> Vec<Constraint> {
    let mut rows = Vec::new();
    for mode in modes {
        let points = mode.points(&world.model, &instant.kinematics);
        rows.extend(points.iter().map(Constraint::of_gap));
        if mode.friction.sticks() {
            let centre = centre(&points);
            rows.push(Constraint { point: centre, direction: centre.s, distance: 0.0 });
        }
    }
    rows
}

/// Penetration of points that touch and are not kept, where it is more than round-off.
fn separating_rows(world: &World, instant: &ImpactInstant, modes: &[ContactMode]) -> Vec<Constraint> {
    let mut rows = Vec::new();
    for manifold in &instant.manifolds {
        let separates = |site: &usize| !modes.iter().any(|mode| mode.sites.contains(site));
        let round_off = PLACE_ROUNDING * world.pair(manifold.pair).map_or(0.0, |pair| world.radius(pair));
        let points = manifold.sites.iter().zip(&manifold.points);
        let behind = points.filter(|(site, p)| separates(site) && p.gap < -round_off);
        rows.extend(behind.map(|(_, p)| Constraint::of_gap(p)));
    }
    rows
}

/// Sets the rates of bodies that rest on a wall to exactly 0 where they are round-off.
fn stop_resting_bodies(world: &World, instant: &mut ImpactInstant, modes: &[ContactMode]) {
    for (place, state) in instant.states.iter_mut().enumerate() {
        let rests = modes.iter().any(|mode| {
            mode.is_flush()
                && mode.friction.sticks()
                && instant.kinematics.places(&world.model, mode.pair).contains(&Some(place))
        });
        let own = &world.bodies[instant.slots[place]];
        let before_wall = |pair: &usize| world.model.pairs[world.pairs[*pair].number].bodies == [Some(own.body), None];
        if rests && own.pairs.iter().any(before_wall) {
            for rate in &mut state[POSITIONS..] {
                *rate = if rate.abs() <= REST_SNAP_ROUNDINGS * instant.speed_noise { 0.0 } else { *rate };
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;
    use crate::dynamics::impact2d::lasting::constrained_motion::FrictionMode;

    /// A straight girder flush at its wall, then moved by `x` and given this velocity \[m\], \[m/s\].
    fn moved(x: f64, v: [f64; 2]) -> (World, ImpactInstant, ContactMode) {
        let model = example::at_wall(|scene| scene.girders[0].initial.displacement = [x, 0.0, 0.0]);
        let world = example::world(model);
        let mut instant = ImpactInstant::new(&world, 0.0, &[0]);
        instant.kinematics.cluster.velocity[0] = glam::DVec3::new(v[0], v[1], 0.0);
        instant.take_velocities();
        let sites = instant.manifolds[0].sites.to_vec();
        (world, instant, ContactMode { pair: 0, sites, friction: FrictionMode::Stick })
    }

    #[test]
    fn a_sticking_face_comes_onto_the_wall_and_to_rest() {
        let (world, mut instant, mode) = moved(3e-11, [1e-9, -2e-9]);
        assert!(project(&world, &mut instant, &[mode]), "three constraints");
        let [x, y, _, v_x, v_y, spin] = instant.states[0];
        assert!(x.abs() < 1e-24 && y.abs() < 1e-24, "back by its penetration: {x}, {y}");
        assert!(v_x.abs() < 1e-21 && v_y.abs() < 1e-21 && spin.abs() < 1e-20, "at rest: {:?}", instant.states[0]);
    }

    #[test]
    fn a_separating_face_is_moved_out_with_its_velocity_unchanged() {
        let (world, mut instant, _) = moved(3e-11, [-0.1, 0.2]);
        assert!(project(&world, &mut instant, &[]), "two penetrating points");
        assert!(instant.states[0][0].abs() < 1e-23, "moved out: {}", instant.states[0][0]);
        assert_eq!(instant.states[0][3..5], [-0.1, 0.2], "no impulse");
    }

    #[test]
    fn round_off_of_a_gap_is_no_penetration() {
        let (world, mut instant, _) = moved(1e-17, [-0.1, 0.0]);
        assert!(!project(&world, &mut instant, &[]), "nothing to remove");
    }
}
