//! Each reason that ends a contact's state, where its time is known in closed form.

use glam::DVec2;

use super::*;
use crate::contact::Normal;
use crate::contact::normal::Linear;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, closed, first_event, island, stick, wall};

/// Slides along the first tangent of the face towards its positive or negative end.
fn slip(sign: f64) -> impl Fn(&Local) -> Mode {
    move |_| Mode::Slip { direction: DVec2::X * sign }
}

/// The contacts with another friction coefficient.
fn with_friction(active: &mut [ActiveContact], mu: f64) {
    for contact in active {
        (contact.closed.law.mu_s, contact.closed.law.mu_k) = (mu, mu);
    }
}

/// Rate along the first tangent of a girder that moves along the world's y \[–\].
fn along(model: &Model, active: &[ActiveContact]) -> f64 {
    model.sites[active[0].site].geometry.axes.x_axis.y
}

fn expect(due: &[Due], reason: Reason, count: usize) {
    assert_eq!(due.len(), count, "both nodes: {due:?}");
    assert!(due.iter().all(|due| due.reason == reason), "{due:?}");
}

#[test]
fn a_contact_opens_after_half_a_period() {
    let (model, active) = closed(&wall(), stick);
    let mut island = island(&model, active, &[[0.0, 0.0, SPEED, 0.0]]);
    let (t, due) = first_event(&model, &mut island);
    expect(&due, Reason::Opening, 2);
    let omega = (STIFFNESS / MASS).sqrt();
    assert!((omega * t - std::f64::consts::PI).abs() < 1e-10, "opens at {} rad", omega * t);
}

#[test]
fn sliding_stops_where_friction_has_used_up_the_velocity() {
    let (mu, across) = (0.2, 0.05);
    let (model, probe) = closed(&wall(), stick);
    let sign = along(&model, &probe).signum();
    let (model, mut active) = closed(&wall(), slip(sign));
    with_friction(&mut active, mu);
    let mut island = island(&model, active, &[[0.0, 0.0, SPEED, across]]);
    let (t, due) = first_event(&model, &mut island);
    expect(&due, Reason::Switching, 2);
    // V = V₀ − μ v (1 − cos ωt) is 0.
    let phase = (1.0 - across / (mu * SPEED)).acos();
    let omega = (STIFFNESS / MASS).sqrt();
    assert!((omega * t - phase).abs() < 1e-9, "stops at {} rad, not at {phase}", omega * t);
}

#[test]
fn a_stick_breaks_away_where_its_spring_reaches_the_cone() {
    let (mu, across) = (0.2, 0.05);
    let (model, mut active) = closed(&wall(), stick);
    with_friction(&mut active, mu);
    // Pressed in by v/ω at rest and moving along the face: δ = (v/ω) cos ωt, s = (V/ω) sin ωt.
    let omega = (STIFFNESS / MASS).sqrt();
    let mut island = island(&model, active, &[[SPEED / omega, 0.0, 0.0, across]]);
    let (t, due) = first_event(&model, &mut island);
    expect(&due, Reason::Switching, 2);
    let phase = (mu * SPEED / across).atan();
    assert!((omega * t - phase).abs() < 1e-9, "breaks away at {} rad, not at {phase}", omega * t);
}

#[test]
fn a_node_leaves_the_face_over_its_edge() {
    let mut scene = wall();
    let (beyond, across) = (5e-5, 0.05);
    scene.abutments[0].width = Some(0.07 + 2.0 * beyond);
    let (_, probe) = closed(&scene, stick);
    let (model, mut active) = closed(&scene, slip(1.0));
    assert_eq!((probe.len(), active.len()), (2, 2), "both corners are over the wall");
    with_friction(&mut active, 0.0);
    let mut island = island(&model, active, &[[0.0, 0.0, SPEED, across]]);
    let (t, due) = first_event(&model, &mut island);
    expect(&due, Reason::Edge, 1);
    assert!((t - beyond / across).abs() < 1e-5 * t, "leaves at {t} s");
}

#[test]
fn the_dashpot_out_pulls_the_spring_before_a_clamped_contact_opens() {
    let (model, mut active) = closed(&wall(), stick);
    let ratio = 0.3;
    let nodes = active.len() as f64;
    let whole = Linear { k: STIFFNESS, c: 2.0 * ratio * (STIFFNESS * MASS).sqrt() };
    for contact in &mut active {
        contact.closed.law.normal = Normal::Linear(whole.divided(nodes));
        contact.closed.law.clamp = true;
    }
    let mut island = island(&model, active, &[[0.0, 0.0, SPEED, 0.0]]);
    let (t, due) = first_event(&model, &mut island);
    expect(&due, Reason::Kink, 2);
    // K δ + C δ̇ = 0 of δ = e^{−ξωt} sin(ω_d t): tan(ω_d t) = 2ξ√(1 − ξ²)/(2ξ² − 1).
    let root = f64::sqrt(1.0 - ratio * ratio);
    let phase = (2.0 * ratio * root).atan2(2.0 * ratio * ratio - 1.0);
    let damped = (STIFFNESS / MASS).sqrt() * root;
    assert!((damped * t - phase).abs() < 1e-9, "at {} rad, not at {phase}", damped * t);
}
