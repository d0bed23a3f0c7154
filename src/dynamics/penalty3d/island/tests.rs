//! A flush hit against the half-sine of its closed form, and what an island is at its start.

use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, closed, island, row, stick, wall};

#[test]
fn a_flush_hit_is_half_a_sine() {
    let (model, active) = closed(&wall(), stick);
    let mut island = island(&model, active, &[[0.0, 0.0, SPEED, 0.0]]);
    let omega = (STIFFNESS / MASS).sqrt();
    let mut steps = 0;
    while island.step.until < 3.0 / omega {
        island.plan(&model, 3.0 / omega, f64::INFINITY).expect("a step that can be made");
        let phase = omega * island.step.until;
        let depth = island.state_at(&model, 0, island.step.until)[0];
        assert!((depth * omega / SPEED - phase.sin()).abs() < 1e-10, "{depth} m at {phase} rad");
        steps += 1;
    }
    assert!(steps > 1, "the closed form holds from step to step");
}

#[test]
fn the_dense_output_joins_the_ends_of_a_step() {
    let (model, active) = closed(&wall(), stick);
    let mut island = island(&model, active, &[[0.0, 0.0, SPEED, 0.0]]);
    island.plan(&model, 1.0, f64::INFINITY).expect("a step that can be made");
    let omega = (STIFFNESS / MASS).sqrt();
    let middle = 0.5 * (island.step.from + island.step.until);
    let depth = island.state_at(&model, 0, middle)[0];
    assert!((depth * omega / SPEED - (omega * middle).sin()).abs() < 1e-8, "{depth} m in the middle");
    let [before, end] =
        [island.step.until * (1.0 - 1e-12), island.step.until].map(|t| island.state_at(&model, 0, t)[0]);
    assert!((before - end).abs() < 1e-12, "{before} m before the end, {end} m there");
}

#[test]
fn stiff_contacts_between_girders_set_the_time_scale() {
    let (model, active) = closed(&row(), stick);
    let island = island(&model, active, &[[0.0, 0.0, SPEED, 0.0], [0.0, 0.0, -SPEED, 0.0]]);
    // Four nodes share K; each swings no faster than K/4 times the mobility of its two bodies at their corners.
    let omega = island.omega();
    assert!(omega > (STIFFNESS / 4.0 * 2.0 / MASS).sqrt(), "not below that of two masses, {omega} rad/s");
    assert!(omega < 10.0 * (STIFFNESS / MASS).sqrt(), "nor far above, {omega} rad/s");
}

#[test]
fn a_normal_force_held_at_zero_does_not_push() {
    let (model, mut active) = closed(&wall(), stick);
    for contact in &mut active {
        contact.closed.held_at_zero = true;
    }
    let mut island = island(&model, active, &[[0.0, 0.0, SPEED, 0.0]]);
    island.plan(&model, 1e-4, f64::INFINITY).expect("a step that can be made");
    assert_eq!(island.state_at(&model, 0, island.step.until)[3], SPEED, "its velocity stays");
}
