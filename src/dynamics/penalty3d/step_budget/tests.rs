//! Budgets of a girder that enters a wall or is pressed against it.

use super::*;
use crate::dynamics::penalty3d::coupled_system::Members;
use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, closed, stick, wall};

/// Budget of a girder at a wall with this displacement \[m\] and velocity \[m/s\] `x, y, ẋ, ẏ`, whose acceleration is 0.
fn budget(tolerance: f64, steps_taken: usize, [x, y, u, v]: [f64; 4]) -> (Model, CoupledSystem, StepBudget) {
    let (mut model, active) = closed(&wall(), stick);
    model.tolerance = tolerance;
    let mut y = vec![x, y, 0.0, u, v, 0.0];
    let members = Members { bodies: vec![0], bases: vec![model.bodies[0].placed()], active, links: Vec::new() };
    let system = CoupledSystem::of(&model, members, &mut y);
    let kind = IslandKind::of(&model, &system, &y);
    let (slope, pace) = (vec![0.0; y.len()], ControllerState::default());
    let start = StepStart { model: &model, system: &system, kind: &kind, y: &y, slope: &slope, pace, steps_taken };
    let budget = start.budget(StepBudget::default());
    (model, system, budget)
}

fn scale(tolerance: f64, taken: usize, state: [f64; 4]) -> ErrorScale {
    budget(tolerance, taken, state).2.scale
}

#[test]
fn round_off_of_a_contact_is_that_of_the_way_of_its_body() {
    let reach = |x: f64| {
        let (model, system, budget) = budget(1e-8, 1, [x, 0.0, 0.0, 0.0]);
        (budget.reach(&model, &system.active[0]), budget.moved)
    };
    let (near, moved) = reach(0.0);
    assert_eq!(moved, [0.0], "as placed");
    assert!(near > 0.0, "no less than a share of the size");
    let (far, moved) = reach(1e3);
    assert!((moved[0] - 1e3).abs() < 1e-9 && far >= moved[0], "{far} m of {moved:?}");
}

#[test]
fn elastic_contacts_leave_the_length_to_the_error_estimate() {
    let (.., budget) = budget(1e-8, 1, [1e-3, 0.0, SPEED, 0.0]);
    assert_eq!(budget.longest, f64::INFINITY, "nothing decays, no device acts");
    assert!(budget.auxiliary_errors.is_empty(), "no slip angle and no memory is a state");
}

#[test]
fn the_allowed_error_is_the_tolerance_of_the_contacts_speed() {
    let entering = scale(1e-8, 1, [0.0, 0.0, SPEED, 0.0]);
    assert!((entering.speed / (1e-8 * SPEED) - 1.0).abs() < 1e-3, "{} m/s", entering.speed);
    // A penetration counts by the speed of the oscillation with this amplitude.
    let pressed = scale(1e-8, 1, [1e-3, 0.0, 0.0, 0.0]);
    assert!((pressed.speed / (1e-8 * 1e-3 * pressed.omega) - 1.0).abs() < 1e-3, "{} m/s", pressed.speed);
    assert!(pressed.omega >= (STIFFNESS / 2.0 / MASS).sqrt(), "no slower than half of the spring");
}

#[test]
fn a_stretched_spring_counts_as_a_penetration_does() {
    let [still, sliding] = [0.0, 0.05].map(|u| scale(1e-8, 1, [1e-3, u, 0.0, 0.0]).speed);
    assert!(sliding > still, "{sliding} m/s against {still}");
}

#[test]
fn long_runs_have_smaller_errors_per_step() {
    let state = [0.0, 0.0, SPEED, 0.0];
    let [short, long] = [1, 2000].map(|taken| scale(1e-8, taken, state).speed);
    assert!((long / short - 0.5).abs() < 1e-3, "half after twice as many, {}", long / short);
}

#[test]
fn no_error_is_asked_for_below_round_off() {
    let scale = scale(1e-18, 1, [0.0, 0.0, SPEED, 0.0]);
    assert!(scale.speed > 1e-16 * SPEED, "{} m/s", scale.speed);
}
