//! Upper bounds of the circular frequency and of the decay rates of closed contacts: sums over the contacts of stiffness or
//! dashpot times mobility (Gershgorin). Time scales and error scales of an island follow from them.

use glam::{DMat3, DVec3};

use crate::contact::{Frame, FrictionLaw, Mode, NormalLaw};
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
    let links = links.iter().map(|link| link.of(model).device.stiffness_bound(&link.phase) * link.mobility(model));
    let bearings = bodies.iter().map(|&b| model.bodies[b].rate_bounds.stiffest);
    contacts.chain(links).chain(bearings).fold(LEAST_SQUARED_FREQUENCY, f64::max).sqrt()
}

/// Largest decay rate of the dashpot of a single connection, `c w` with the bounds of damping c and mobility w
/// \[1/s\].
pub(in crate::dynamics) fn quickest(model: &Model, active: &[ActiveContact], links: &[ActiveLink]) -> f64 {
    let contacts = active.iter().map(|a| a.damping_bound(&a.closed.mode) * mobility(model, a));
    let links = links.iter().map(|link| link.of(model).device.damping_bound(&link.phase) * link.mobility(model));
    contacts.chain(links).fold(0.0, f64::max)
}

/// Upper bound of the relative acceleration of node and face per unit force \[1/kg\].
fn mobility(model: &Model, active: &ActiveContact) -> f64 {
    let pair = &model.pairs[model.contacts[active.site].pair];
    pair.bodies.iter().flatten().map(|&b| model.bodies[b].rate_bounds.mobility).sum::<f64>()
}

/// Upper bound of the decay rate of all dashpots acting together \[1/s\]: the largest sum of the row sums
/// (Gershgorin) of the two bodies of a connection, with levers as placed.
pub(in crate::dynamics) fn decay(
    model: &Model,
    bodies: &[usize],
    active: &[ActiveContact],
    links: &[ActiveLink],
) -> f64 {
    let mut sums = vec![0.0; bodies.len()];
    for a in active {
        let home = &model.contacts[a.site].home;
        let [node, face] = model.sections(a.site);
        for (side, point) in [(a.node, (node, home.arm)), (a.face, (face, home.lever))] {
            if let Some(i) = side {
                sums[i] += decay_rows(&model.bodies[bodies[i]], a, &home.axes, point);
            }
        }
    }
    for link in links {
        let device = &link.of(model).device;
        let rate = device.damping_bound(&link.phase) * link.mobility(model);
        link.ends.into_iter().flatten().for_each(|i| sums[i] += rate);
    }
    let apart = |sides: [Option<usize>; 2]| sides.into_iter().flatten().map(|i| sums[i]).sum::<f64>();
    let sides = active.iter().map(|a| [a.node, a.face]).chain(links.iter().map(|link| link.ends));
    sides.map(apart).fold(0.0, f64::max)
}

/// Upper bound of the decay rate that the dashpots of one contact give one body \[1/s\]: largest row sum of
/// `bᵢᵀ M⁻¹ bⱼ` over the directions `b` of its dashpots, each times the root of its constant; the contact is at lever
/// `arm` from the origin of the body's section.
fn decay_rows(body: &Body, contact: &ActiveContact, axes: &DMat3, (section, arm): (usize, DVec3)) -> f64 {
    let law = &contact.closed.law;
    let has_tangential_dashpot =
        matches!(contact.closed.mode, Mode::Stick { .. }) || law.friction == FrictionLaw::ReturnMapping;
    let across = if has_tangential_dashpot { law.c_t.sqrt() } else { 0.0 };
    let directions =
        [axes.x_axis * across, axes.y_axis * across, axes.z_axis * law.normal.damping_bound(contact.depth).sqrt()];
    let row = |direction: DVec3| {
        let there = body.acceleration(Point { section, frame: &Frame::fixed(body.home), arm }, direction);
        directions.iter().map(|other| there.dot(*other).abs()).sum::<f64>()
    };
    directions.into_iter().map(row).fold(0.0, f64::max)
}
