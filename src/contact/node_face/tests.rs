//! Tests of the position and velocity of a node relative to a face.

use super::*;

/// A body rotated by `turn` about the vertical since placed, in plane motion.
fn body(home: DVec3, turn: f64, spin: f64) -> Frame {
    Frame {
        shift: DVec3::new(0.013, -0.021, 0.0),
        turned: turned_by(DQuat::from_rotation_z(turn)),
        velocity: DVec3::new(0.3, -0.7, 0.0),
        spin: DVec3::Z * spin,
        ..Frame::fixed(home)
    }
}

fn face() -> Face {
    let quad = [(0.5, -0.4, -0.1), (0.7, 0.3, -0.1), (0.7, 0.3, 0.2), (0.5, -0.4, 0.2)];
    Face::new(quad.map(DVec3::from), 1.0).expect("a rectangle")
}

const NODE: DVec3 = DVec3::new(-0.4, 0.31, 0.02);

#[test]
fn in_plan_every_number_is_that_of_space() {
    let face = face();
    assert!(face.is_upright(), "{face:?}");
    for turn in [0.0, 0.1, -0.37, 1.9] {
        let owner = body(DVec3::new(1.1, 0.2, 0.05), turn, 0.9);
        let other = body(DVec3::ZERO, 0.7 * turn, -2.3);
        let home = ContactGeometry::of(NODE, (owner.home, DMat3::IDENTITY), &face, (other.home, DMat3::IDENTITY));
        let (plan, space) = (measure_in_plan(&home, &owner, &other), measure_in_space(&home, &owner, &other));
        assert_eq!(plan, space, "turned by {turn}");
    }
}

#[test]
fn counted_from_home_a_node_is_where_it_is() {
    let face = face();
    for (heading, turn) in [(0.3, 1e-9), (-1.2, 0.4), (2.9, -2.0)] {
        let owner = body(DVec3::new(1.1, 0.2, 0.05), turn, 0.9);
        let other = body(DVec3::new(0.1, -0.3, 0.0), 0.7 * turn, -2.3);
        let [node_axes, face_axes] = [heading, 1.7 * heading].map(DMat3::from_rotation_z);
        let home = ContactGeometry::of(NODE, (owner.home, node_axes), &face, (other.home, face_axes));
        let there = measure(&home, &owner, &other);
        let [turned, facing] = [owner.rotation(&node_axes), other.rotation(&face_axes)];
        let place = owner.origin() + turned * NODE;
        let apart = place - (other.origin() + facing * face.corners[0]);
        let axes = [face.tangent, face.bitangent, face.normal].map(|axis| facing * axis);
        let plain = DVec3::from_array(axes.map(|axis| apart.dot(axis)));
        let found = there.here.at.extend(there.here.gap);
        assert!((found - plain).length() < 1e-14, "{found} against {plain}");
        assert!((there.lever - (place - other.origin())).length() < 1e-14, "its levers");
        let speed = owner.velocity_at(there.arm) - other.velocity_at(there.lever);
        let rates = there.here.rate.extend(there.here.gap_rate);
        assert!((rates - DVec3::from_array(axes.map(|axis| speed.dot(axis)))).length() < 1e-14, "its rates");
    }
}

#[test]
fn what_is_placed_on_a_face_is_on_it() {
    // 0.1 + 0.2 is not 0.3 in round-off: two girders end to end.
    let quad = [(0.0, -1.0, -1.0), (0.0, 1.0, -1.0), (0.0, 1.0, 1.0), (0.0, -1.0, 1.0)];
    let face = Face::new(quad.map(|(x, y, z)| DVec3::new(0.3 + x, y, z)), 1.0).expect("a square");
    let axes = DMat3::IDENTITY;
    let gap =
        |x: f64| ContactGeometry::of(DVec3::X * 0.2, (DVec3::X * x, axes), &face, (DVec3::ZERO, axes)).placed_gap();
    assert_ne!(0.1 + 0.2, 0.3, "rounding is there");
    assert_eq!(gap(0.1), 0.0, "and is no gap");
    assert!((gap(0.1 + 1e-14) - 1e-14).abs() < 1e-16, "a small gap is one: {:e}", gap(0.1 + 1e-14));
}

#[test]
fn a_small_motion_moves_the_gap_by_its_own_last_digit() {
    // With positions of the size of the bodies, a sum would have a round-off of 1e-16 m.
    let face = face();
    let still = Frame::fixed(DVec3::ZERO);
    let placed = Frame::fixed(DVec3::new(9.0, 0.4, 0.0));
    let home = ContactGeometry::of(NODE, (placed.home, DMat3::IDENTITY), &face, (still.home, DMat3::IDENTITY));
    let shift = 1e-12;
    let before = ContactGeometry { at: DVec3::ZERO, ..home };
    let moved = Frame { shift: face.normal * shift, ..placed };
    let step = locate(&before, &moved, &still).gap;
    assert!((step - shift).abs() < 4e-16 * shift, "{step:e}");
    let turn = 1e-11;
    let turned = turned_by(DQuat::from_xyzw(0.0, 0.0, 0.5 * turn, 1.0));
    let spun = Frame { turned, ..placed };
    let step = locate(&before, &spun, &still).gap;
    let swung = turn * DVec3::Z.cross(NODE).dot(face.normal);
    assert!((step - swung).abs() < 1e-10 * swung.abs(), "{step:e} against {swung:e}, to second order");
}
