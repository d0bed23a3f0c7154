//! Edges across each other at known places, against closed forms.

use super::*;
use crate::contact::turned_by;
use glam::{DMat3, DQuat};

/// A unit square in the plane z = 0 with its outward normal up, and an edge at height `h` across its side y = 0,
/// rising by `slope` inwards, of a face that looks down.
fn across(h: f64, slope: f64) -> (Edge, ContactGeometry, [Frame; 2]) {
    let quad = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)].map(DVec3::from);
    let face = Face::new(quad, 0.5).expect("a square");
    let frames = [DVec3::new(0.3, 0.1, 2.0), DVec3::ZERO].map(Frame::fixed);
    let point = |y: f64| DVec3::new(0.3, y, h + slope * y);
    let home = |at: DVec3| {
        ContactGeometry::of(
            at - frames[0].home,
            (frames[0].home, DMat3::IDENTITY),
            &face,
            (DVec3::ZERO, DMat3::IDENTITY),
        )
    };
    let edge = Edge::of(
        &[point(-0.4), point(0.6)].map(|at| (home(at), at.truncate())),
        DVec3::NEG_Z,
        (&face, 0),
        [&frames[0], &frames[1]],
    );
    (edge, home(point(-0.4).midpoint(point(0.6))), frames)
}

#[test]
fn the_normal_is_perpendicular_to_both_edges_and_the_distance_along_it() {
    for slope in [0.0, 0.3, -0.9] {
        let (edge, _, [node, face]) = across(0.02, slope);
        let crossing = edge.crossing([&node, &face], edge.tolerance).expect("they cross");
        let normal = DVec3::new(0.0, -slope, 1.0).normalize_or_zero();
        assert!((crossing.normal - normal).length() < 1e-15, "{} at slope {slope}", crossing.normal);
        let distance = edge.distance(&node, &face).expect("they cross");
        assert!((distance - 0.02 * normal.z).abs() < 1e-15, "{distance} m at slope {slope}");
    }
}

#[test]
fn the_gap_is_0_where_the_lines_meet_and_its_rate_is_its_derivative() {
    let (edge, _, [node, face]) = across(0.0, 0.4);
    let ends = edge.ends(&node, &face);
    assert!(edge.gap(&ends, ends.sense())[0].abs() < 1e-16, "the lines meet");
    let moving = |t: f64| Frame {
        shift: DVec3::new(0.1, 0.2, 0.3) * t,
        turned: turned_by(DQuat::from_scaled_axis(DVec3::new(0.5, -0.7, 0.2) * t)),
        velocity: DVec3::new(0.1, 0.2, 0.3),
        spin: DVec3::new(0.5, -0.7, 0.2),
        level: false,
        ..node
    };
    let at = |t: f64| edge.gap(&edge.ends(&moving(t), &face), ends.sense());
    let dt = 1e-5;
    let slope = (at(0.1 + dt)[0] - at(0.1 - dt)[0]) / (2.0 * dt);
    assert!((at(0.1)[1] / slope - 1.0).abs() < 1e-8, "{} against {slope}", at(0.1)[1]);
}

#[test]
fn the_node_at_a_crossing_is_on_the_side_with_the_distance_as_its_gap() {
    let (edge, middle, [node, face]) = across(-0.01, 0.7);
    let crossing = edge.crossing([&node, &face], edge.tolerance).expect("they cross");
    let place = edge.place(&crossing);
    let here = locate(&edge.geometry(&middle, &place), &node, &face);
    let distance = edge.distance(&node, &face).expect("they cross");
    assert!((here.gap - distance).abs() < 1e-15 && here.at.y.abs() < 1e-15, "{here:?}");
    assert!(edge.left(&place, here.at) < 0.0 && !edge.has_slid(here.at), "on the side, not slid");
    assert!((edge.to_face(here.at) - DVec2::new(0.3, 0.0)).length() < 1e-15, "its place on the face");
}

#[test]
fn edges_that_miss_each_other_or_are_nearly_parallel_do_not_cross() {
    let (edge, _, [node, face]) = across(0.0, 0.0);
    let beside = Frame { shift: DVec3::X * 0.8, ..node };
    assert_eq!(edge.crossing([&beside, &face], edge.tolerance), None, "beyond the side's end");
    let turned = |degrees: f64| Frame {
        turned: turned_by(DQuat::from_rotation_z(f64::to_radians(degrees))),
        level: false,
        ..node
    };
    assert!(edge.crossing([&turned(55.0), &face], edge.tolerance).is_some(), "35° from parallel");
    assert_eq!(edge.crossing([&turned(65.0), &face], edge.tolerance), None, "25° from parallel");
    let over = Frame { turned: turned_by(DQuat::from_rotation_y(std::f64::consts::PI)), level: false, ..node };
    let over = Frame { shift: DVec3::new(0.0, 0.0, -4.0), ..over };
    assert_eq!(edge.crossing([&over, &face], edge.tolerance), None, "the edge's face looks up, too");
}
