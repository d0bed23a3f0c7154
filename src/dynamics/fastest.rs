//! How fast bodies in contact can swing, from above: what times and errors of an island are measured by.

use super::field::Active;
use super::{Body, Model};

/// Circular frequency that no contact or bearing of these bodies exceeds by much \[rad/s\].
pub(super) fn fastest(model: &Model, bodies: &[usize], active: &[Active]) -> f64 {
    let contacts = active.iter().map(|a| {
        let pair = &model.pairs[model.contacts[a.site].pair];
        a.closed.law.k * pair.bodies.iter().flatten().map(|&b| mobility(&model.bodies[b])).sum::<f64>()
    });
    let bearings = bodies.iter().map(|&b| stiffest(&model.bodies[b]));
    contacts.chain(bearings).fold(1e-6, f64::max).sqrt()
}

/// Rate that no dashpot of these contacts decays by much faster than \[1/s\].
pub(super) fn quickest(model: &Model, active: &[Active]) -> f64 {
    let contacts = active.iter().map(|a| {
        let (pair, law) = (&model.pairs[model.contacts[a.site].pair], &a.closed.law);
        law.c_n.max(law.c_t) * pair.bodies.iter().flatten().map(|&b| mobility(&model.bodies[b])).sum::<f64>()
    });
    contacts.fold(0.0, f64::max)
}

/// Upper bound on acceleration at a corner per unit force \[1/kg\].
fn mobility(body: &Body) -> f64 {
    let arm = body.radius;
    let smallest = (body.prism.width.powi(2) + body.prism.thickness.powi(2)) / 12.0;
    let turn = if body.free[3] || body.free[4] { arm * arm / smallest } else { arm * arm / body.gyration2 };
    (1.0 + turn) / body.mass
}

/// Largest stiffness per inertia of a body on its bearings \[1/s²\].
fn stiffest(body: &Body) -> f64 {
    let sum = body.bearings.iter().map(|b| b.stiffness.max_element()).sum::<f64>();
    let damping = body.bearings.iter().map(|b| b.damping.max_element()).sum::<f64>() / body.mass;
    if body.free[3] || body.free[4] {
        let arm2 = body.radius.powi(2);
        let smallest = (body.prism.width.powi(2) + body.prism.thickness.powi(2)) / 12.0;
        (sum / body.mass * (1.0 + arm2 / smallest)).max(damping * damping)
    } else {
        (3.0 * sum / body.mass).max(damping * damping)
    }
}
