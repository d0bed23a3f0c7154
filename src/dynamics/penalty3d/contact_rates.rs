//! Upper bounds of the circular frequency and of the decay rates of closed contacts: sums over the contacts of stiffness or
//! dashpot times mobility (Gershgorin). Time scales and error scales of an island follow from them.

use glam::{DMat3, DVec3};

use crate::contact::{Frame, FrictionLaw, Mode, NormalLaw};
use crate::dynamics::connection::Connection;
use crate::dynamics::model::body::Point;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::{Body, Model};

/// Circular frequency that no contact or bearing of these bodies exceeds by much \[rad/s\].
pub(in crate::dynamics) fn fastest(
    model: &Model,
    bodies: &[usize],
    active: &[ActiveContact],
    links: &[ActiveLink],
) -> f64 {
    let contacts = active.iter().map(|a| a.stiffness_bound(&a.closed.mode) * mobility(model, a));
    let links = links.iter().map(|link| link.of(model).device.stiffness_bound(&link.phase) * link.mobility(model));
    let bearings = bodies.iter().map(|&b| model.bodies[b].rate_bounds.stiffest);
    contacts.chain(links).chain(bearings).fold(1e-6, f64::max).sqrt()
}

/// Rate that no dashpot of these contacts decays by much faster than \[1/s\].
pub(in crate::dynamics) fn quickest(model: &Model, active: &[ActiveContact], links: &[ActiveLink]) -> f64 {
    let contacts = active.iter().map(|a| a.damping_bound(&a.closed.mode) * mobility(model, a));
    let links = links.iter().map(|link| link.of(model).device.damping_bound(&link.phase) * link.mobility(model));
    contacts.chain(links).fold(0.0, f64::max)
}

/// Acceleration of node and face against each other per unit force, from above \[1/kg\].
fn mobility(model: &Model, active: &ActiveContact) -> f64 {
    let pair = &model.pairs[model.contacts[active.site].pair];
    pair.bodies.iter().flatten().map(|&b| model.bodies[b].rate_bounds.mobility).sum::<f64>()
}

/// Rate that the dashpots of these contacts of an island's bodies decay by at most, all together, with the levers that they
/// had as placed \[1/s\].
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
                sums[i] += yielding(&model.bodies[bodies[i]], a, &home.axes, point);
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

/// How fast the dashpots of one contact, with the face's axes and a lever from G, slow a body down at most \[1/s\].
fn yielding(body: &Body, contact: &ActiveContact, axes: &DMat3, (section, arm): (usize, DVec3)) -> f64 {
    let law = &contact.closed.law;
    let holds = matches!(contact.closed.mode, Mode::Stick { .. }) || law.friction == FrictionLaw::ReturnMapping;
    let across = if holds { law.c_t.sqrt() } else { 0.0 };
    let pushes =
        [axes.x_axis * across, axes.y_axis * across, axes.z_axis * law.normal.damping_bound(contact.depth).sqrt()];
    let row = |push: DVec3| {
        let there = body.acceleration(Point { section, frame: &Frame::fixed(body.home), arm }, push);
        pushes.iter().map(|other| there.dot(*other).abs()).sum::<f64>()
    };
    pushes.into_iter().map(row).fold(0.0, f64::max)
}
