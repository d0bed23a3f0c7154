//! Upper bounds of the circular frequency and of the decay rates of closed contacts: sums over the contacts of
//! stiffness or dashpot times mobility (Gershgorin). Time scales and error scales of an island follow from them.

use glam::{DMat3, DVec3};

use crate::contact::{Frame, NormalLaw};
use crate::dynamics::connection::Connection;
use crate::dynamics::model::body::Point;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::penalty3d::constants::LEAST_SQUARED_FREQUENCY;
use crate::dynamics::{Body, Model};

/// Circular frequency of the fastest connection of these bodies, `√(k w)` with the bounds of stiffness k and mobility
/// w, or that of the stiffest bearing \[rad/s\]. Several connections of one body can exceed it by the root of their
/// number.
pub(in crate::dynamics) fn fastest(
    model: &Model,
    bodies: &[usize],
    active: &[ActiveContact],
    links: &[ActiveLink],
) -> f64 {
    let contacts = active.iter().map(|a| a.stiffness_bound(&a.closed.mode) * mobility(model, a));
    let links = links.iter().map(|link| link.link(model).device.stiffness_bound(&link.phase) * link.mobility(model));
    let bearings = bodies.iter().map(|&b| model.bodies[b].rate_bounds.stiffest);
    contacts.chain(links).chain(bearings).fold(LEAST_SQUARED_FREQUENCY, f64::max).sqrt()
}

/// Largest decay rate of the dashpot of a single connection, `c w` with the bounds of damping c and mobility w
/// \[1/s\].
pub(in crate::dynamics) fn largest_decay_rate(model: &Model, active: &[ActiveContact], links: &[ActiveLink]) -> f64 {
    let contacts = active.iter().map(|a| a.damping_bound(&a.closed.mode) * mobility(model, a));
    let links = links.iter().map(|link| link.link(model).device.damping_bound(&link.phase) * link.mobility(model));
    contacts.chain(links).fold(0.0, f64::max)
}

/// Upper bound of the relative acceleration of node and face per unit force \[1/kg\].
pub(super) fn mobility(model: &Model, active: &ActiveContact) -> f64 {
    let pair = &model.pairs[model.sites[active.site].pair];
    pair.bodies.iter().flatten().map(|&b| model.bodies[b].rate_bounds.mobility).sum::<f64>()
}

/// Upper bound of the decay rate of all dashpots of connections acting together \[1/s\]: the largest sum of the row sums
/// (Gershgorin) of the two bodies of a connection, with levers as placed.
pub(in crate::dynamics) fn decay(
    model: &Model,
    bodies: &[usize],
    active: &[ActiveContact],
    links: &[ActiveLink],
) -> f64 {
    let mut sums = vec![0.0; bodies.len()];
    for a in active {
        let geometry = model.sites[a.site].geometry_at(&a.closed.place);
        let [node, face] = model.sections(a.site);
        for (side, point) in [(a.ends[0], (node, geometry.arm)), (a.ends[1], (face, geometry.lever))] {
            if let Some(i) = side {
                sums[i] += decay_rows(&model.bodies[bodies[i]], a, &geometry.axes, point);
            }
        }
    }
    for link in links {
        let device = &link.link(model).device;
        let rate = device.damping_bound(&link.phase) * link.mobility(model);
        link.ends.into_iter().flatten().for_each(|i| sums[i] += rate);
    }
    let apart = |sides: [Option<usize>; 2]| sides.into_iter().flatten().map(|i| sums[i]).sum::<f64>();
    let sides = active.iter().map(|a| a.ends).chain(links.iter().map(|link| link.ends));
    sides.map(apart).fold(0.0, f64::max)
}

/// Upper bound of the decay rate that the dashpots of one contact give one body \[1/s\]: largest row sum of
/// `bᵢᵀ M⁻¹ bⱼ` over the directions `b` of its dashpots, each times the root of its constant; the contact is at lever
/// `arm` from the origin of the body's section.
fn decay_rows(body: &Body, contact: &ActiveContact, axes: &DMat3, (section, arm): (usize, DVec3)) -> f64 {
    let law = &contact.closed.law;
    let across = law.tangential_damping(&contact.closed.mode).sqrt();
    let directions =
        [axes.x_axis * across, axes.y_axis * across, axes.z_axis * law.normal.damping_bound(contact.depth).sqrt()];
    let row = |direction: DVec3| {
        let there = body.acceleration(Point { section, frame: &Frame::fixed(body.home), arm }, direction);
        directions.iter().map(|other| there.dot(*other).abs()).sum::<f64>()
    };
    directions.into_iter().map(row).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::normal::Linear;
    use crate::contact::{FrictionLaw, Mode, Normal};
    use crate::dynamics::penalty3d::example::{MASS, STIFFNESS, closed, free_to_turn, row, stick, wall};
    use crate::scene::Scene;

    const DASHPOT: f64 = 30.0;

    /// A scene with all nodes in stick, with equal dashpots along the normal and the tangents of each.
    fn damped(scene: &Scene) -> (Model, Vec<ActiveContact>) {
        let (model, mut active) = closed(scene, stick);
        for contact in &mut active {
            let law = &mut contact.closed.law;
            (law.normal, law.c_t) = (Normal::Linear(Linear { k: law.k_t, c: DASHPOT }), DASHPOT);
        }
        (model, active)
    }

    fn bodies(model: &Model) -> Vec<usize> {
        (0..model.bodies.len()).collect()
    }

    /// Largest eigenvalue of `M⁻¹ C` in plane motion with `C = Σ c b bᵀ` over the dashpots, by the power method.
    fn spectral_radius(model: &Model, active: &[ActiveContact]) -> f64 {
        let inverse =
            |body: &Body| DVec3::new(1.0, 1.0, if body.free[5] { 1.0 / body.gyration2 } else { 0.0 }) / body.mass;
        let mut q: Vec<DVec3> = (0..model.bodies.len()).map(|i| DVec3::new(0.3, 0.5, 0.7) / (i as f64 - 1.7)).collect();
        let mut radius = 0.0;
        for _ in 0..500 {
            let mut next = vec![DVec3::ZERO; q.len()];
            for contact in active {
                let geometry = &model.sites[contact.site].geometry;
                let sides = [(contact.ends[0], geometry.arm, 1.0), (contact.ends[1], geometry.lever, -1.0)];
                for axis in [geometry.axes.x_axis, geometry.axes.y_axis, geometry.axes.z_axis] {
                    let row = |arm: DVec3| DVec3::new(axis.x, axis.y, arm.cross(axis).z);
                    let rates = sides.map(|(side, arm, sign)| side.map_or(0.0, |i| sign * row(arm).dot(q[i])));
                    for (side, arm, sign) in sides {
                        let Some(i) = side else { continue };
                        next[i] += inverse(&model.bodies[i]) * row(arm) * (sign * DASHPOT * (rates[0] + rates[1]));
                    }
                }
            }
            radius = next.iter().map(|q| q.length_squared()).sum::<f64>().sqrt();
            q = next.into_iter().map(|next| next / radius).collect();
        }
        radius
    }

    #[test]
    fn flush_translation_decays_at_the_bound_exactly() {
        // Two nodes at the wall, c each; four nodes between two girders, which approach each other.
        for (scene, expected) in [(wall(), 2.0 * DASHPOT / MASS), (row(), 8.0 * DASHPOT / MASS)] {
            let (model, active) = damped(&scene);
            let bound = decay(&model, &bodies(&model), &active, &[]);
            assert!((bound / expected - 1.0).abs() < 1e-12, "{bound} 1/s is not {expected}");
            let radius = spectral_radius(&model, &active);
            assert!((bound / radius - 1.0).abs() < 1e-9, "{bound} 1/s is not the spectral radius {radius}");
        }
    }

    #[test]
    fn with_rotation_the_bound_is_above_the_spectral_radius_and_not_far_above() {
        for scene in [wall(), row()].map(free_to_turn) {
            let (model, active) = damped(&scene);
            let (bound, radius) = (decay(&model, &bodies(&model), &active, &[]), spectral_radius(&model, &active));
            assert!(radius <= bound * (1.0 + 1e-12) && bound < 2.5 * radius, "{bound} 1/s against {radius}");
        }
    }

    #[test]
    fn the_dashpot_of_a_slip_without_tangential_damping_does_not_count() {
        let (model, mut active) = damped(&wall());
        for contact in &mut active {
            contact.closed.mode = Mode::Slip { direction: glam::DVec2::X };
            contact.closed.law.normal = Normal::Linear(Linear { k: STIFFNESS, c: 0.0 });
        }
        assert_eq!(decay(&model, &[0], &active, &[]), 0.0, "law paper: friction only");
        for contact in &mut active {
            contact.closed.law.friction = FrictionLaw::ReturnMapping.into();
        }
        let bound = decay(&model, &[0], &active, &[]);
        assert!((bound / (2.0 * DASHPOT / MASS) - 1.0).abs() < 1e-12, "return mapping: {bound} 1/s");
    }

    #[test]
    fn the_frequency_of_one_node_is_that_of_its_spring_on_the_mass_seen_at_a_corner() {
        // Held against rotation the factor of mobility is 1, which the bound leaves out; at the corner of a rectangle
        // in plan it is 1 + r²/i² = 4, and the bound has the distance in space.
        for (scene, corner) in [(wall(), 1.0), (free_to_turn(wall()), 4.0)] {
            let (model, active) = damped(&scene);
            let omega = fastest(&model, &bodies(&model), &active, &[]);
            let expected = (corner * 0.5 * STIFFNESS / MASS).sqrt();
            assert!(omega >= expected * (1.0 - 1e-12) && omega < 2.02 * expected, "{omega} rad/s against {expected}");
            let rate = largest_decay_rate(&model, &active, &[]);
            let expected = corner * DASHPOT / MASS;
            assert!(rate >= expected * (1.0 - 1e-12) && rate < 4.04 * expected, "{rate} 1/s against {expected}");
        }
    }

    #[test]
    fn without_connections_a_frequency_is_left_and_no_decay() {
        let (model, _) = damped(&wall());
        assert_eq!(fastest(&model, &[0], &[], &[]), LEAST_SQUARED_FREQUENCY.sqrt(), "no bearings either");
        assert_eq!([largest_decay_rate(&model, &[], &[]), decay(&model, &[0], &[], &[])], [0.0; 2]);
    }
}
