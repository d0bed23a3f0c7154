//! Balance of forces and momentum, the norm of errors, and rank-one terms against differences.

use glam::DVec3;

use super::*;
use crate::contact::normal::Linear;
use crate::contact::{FrictionLaw, Law, Normal};
use crate::dynamics::Body;
use crate::dynamics::model::coordinates::planar::WIDTH;
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::penalty3d::example::{MASS, closed, row, stick, wall};

/// Rates of states counted from the placed poses, and of an error of such size its squared norm.
fn rates(model: &Model, active: &[ActiveContact], y: &[f64], scale: ErrorScale) -> (Vec<f64>, f64) {
    let bodies: Vec<usize> = (0..model.bodies.len()).collect();
    let bases: Vec<ReferencePose> = model.bodies.iter().map(Body::placed).collect();
    let layout = StateLayout::of(model.bodies.iter());
    let system = CoupledSystem::without_rates((bodies, layout, bases), active.to_vec(), Vec::new(), Vec::new());
    let mut equations = EquationsOfMotion {
        model,
        system: &system,
        piece: model.ground.piece(model.ground.piece_number(0.0)),
        scale,
        angles: &[],
        line: None,
        workspace: &mut Workspace::of(active),
    };
    let mut out = vec![0.0; y.len()];
    equations.slope(0.0, y, &mut out);
    (out, equations.size2(y))
}

#[test]
fn the_force_of_a_contact_accelerates_its_body() {
    let (model, active) = closed(&wall(), stick);
    let y = [1e-3, 2e-4, 0.0, 0.3, 0.1, 0.0];
    let (out, _) = rates(&model, &active, &y, ErrorScale::default());
    let frame = model.bodies[0].planar_frame(&y);
    let force = |a: &ActiveContact| {
        let site = &model.contacts[a.site];
        contact_force::act(site, &a.closed, &frame, &site.stand).force
    };
    let total: DVec3 = active.iter().map(force).sum();
    assert!(total.x < -100.0 && total.y < -10.0, "spring and friction act: {total} N");
    for (axis, rate) in [out[3], out[4]].into_iter().enumerate() {
        assert!((rate * MASS - total[axis]).abs() <= 1e-13 * total.length(), "m a is {} N", rate * MASS);
    }
    assert_eq!([out[0], out[1]], [0.3, 0.1], "places move with the velocity");
}

#[test]
fn contacts_between_two_bodies_keep_their_momentum() {
    let (model, active) = closed(&row(), stick);
    assert_eq!(active.len(), 4, "two corners of either girder");
    let y = [1e-3, 2e-4, 0.0, 0.3, 0.1, 0.0, -5e-4, -1e-4, 0.0, -0.2, 0.05, 0.0];
    let (out, _) = rates(&model, &active, &y, ErrorScale::default());
    for axis in [3, 4] {
        let (one, two) = (MASS * out[axis], MASS * out[WIDTH + axis]);
        assert!(one.abs() > 1.0, "a force acts");
        assert!((one + two).abs() <= 1e-13 * one.abs(), "{one} N and {two} N");
    }
}

#[test]
fn an_error_of_the_allowed_speed_has_norm_one() {
    let (model, active) = closed(&wall(), stick);
    let scale = ErrorScale { speed: 1e-6, omega: 500.0, place: 1.0 };
    let norm = |y: [f64; WIDTH]| rates(&model, &active, &y, scale).1;
    assert!((norm([0.0, 0.0, 0.0, 1e-6, 0.0, 0.0]) - 1.0).abs() < 1e-14, "of velocity");
    assert!((norm([0.0, 1e-6 / 500.0, 0.0, 0.0, 0.0, 0.0]) - 1.0).abs() < 1e-14, "of position, by ω");
    assert!(norm([f64::NAN; WIDTH]).is_nan(), "NaN is not hidden");
}

fn slider(friction: FrictionLaw, direction: DVec2) -> ClosedContact {
    let normal = Normal::Linear(Linear { k: 1e5, c: 20.0 });
    let law = Law { normal, k_t: 1e5, c_t: 5.0, mu_s: 0.3, mu_k: 0.2, friction, clamp: false, v_stick: 1e-2 };
    let regularisation = if friction == FrictionLaw::Paper { 0.0 } else { 1e-6 };
    ClosedContact::new(law, Mode::Slip { direction }, regularisation)
}

fn pressed(rate: DVec2) -> Local {
    Local { gap: -1e-3, gap_rate: 0.0, at: DVec2::ZERO, way: DVec2::ZERO, rate, spin: DVec3::ZERO }
}

#[test]
fn the_papers_friction_has_the_derivative_of_its_rank_one_terms() {
    let closed = slider(FrictionLaw::Paper, DVec2::X);
    for rate in [DVec2::new(0.03, 0.04), DVec2::new(0.003, -0.002)] {
        let here = pressed(rate);
        let mut sliding = Sliding { against: vec![DVec2::X], ..Sliding::default() };
        sliding.turns(0, &closed, &here, &closed.forces(&here));
        let h = 1e-7;
        for change in [DVec2::X, DVec2::Y] {
            let force = |h: f64| closed.forces(&pressed(rate + change * h)).tangential_total();
            let difference = (force(h) - force(-h)) / (2.0 * h);
            let terms: DVec2 = sliding.channels.iter().map(|term| term.input * term.output.dot(change)).sum();
            assert!((difference - terms).length() < 1e-6 * (1.0 + terms.length()), "{difference} is not {terms}");
        }
    }
}

#[test]
fn a_slip_angle_has_the_derivative_of_its_rank_one_term() {
    let (angle, rate) = (0.3, DVec2::new(0.05, 0.02));
    let (closed, here) = (slider(FrictionLaw::ReturnMapping, direction(angle)), pressed(rate));
    let forces = closed.forces(&here);
    let action = Action { here, forces, force: DVec3::ZERO, node_arm: DVec3::ZERO, face_arm: DVec3::ZERO };
    let length = closed.law.slip_stretch(&here) + closed.solver.regularisation;
    let mut sliding = Sliding::default();
    sliding.follows([0, 0], &closed, direction(angle), &action, length);
    let term = sliding.channels[0];
    let force = |angle: f64| closed.forces_in(&Mode::Slip { direction: direction(angle) }, &here).tangential_total();
    let difference = (force(angle + 1e-4) - force(angle - 1e-4)) / 2e-4;
    assert!((difference - term.input).length() < 1e-5 * term.input.length(), "{difference} is not {}", term.input);
    let turning = |rate: DVec2| direction(angle).perp_dot(rate) / length;
    let by_rate = DVec2::new(turning(DVec2::X), turning(DVec2::Y));
    assert!((by_rate - term.output).length() < 1e-12 * by_rate.length(), "{by_rate} is not {}", term.output);
}
