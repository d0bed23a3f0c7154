//! Separations and distances of prisms against closed forms, and what a ray is stopped by.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, SQRT_2};

use super::*;

fn girder(length: f64, skew_deg: f64) -> Convex {
    girder_of(&Prism { length, width: 0.4 * length, thickness: 0.1 * length, skew: f64::to_radians(skew_deg) })
}

fn girder_of(prism: &Prism) -> Convex {
    Convex::girder(prism).expect("a prism with volume")
}

fn at(x: f64) -> Stand {
    Stand { place: DVec3::new(x, 0.0, 0.0), attitude: DQuat::IDENTITY }
}

#[test]
fn aligned_prisms_overlap_by_the_shortest_way_out() {
    // From a millimetre model to a ten kilometre one; in units of its length a girder is 1 × 0.4 × 0.1.
    for length in [1e-3, 0.19, 30.0, 1e4] {
        for skew_deg in [90.0_f64, 60.0, 135.0] {
            let (body, skew) = (girder(length, skew_deg), skew_deg.to_radians());
            for (i, j, k) in grid() {
                let d = DVec3::new(0.125 * i, 0.05 * j, 0.025 * k) * length;
                let there = Stand { place: d, attitude: DQuat::IDENTITY };
                let ends = (d.x * skew.sin() - d.y * skew.cos()).abs() - length * skew.sin();
                let expected = ends.max(d.y.abs() - 0.4 * length).max(d.z.abs() - 0.1 * length);
                let found = body.separation(at(0.0), &body, there);
                // Apart, an edge may part them more than any side does.
                let off = if expected > 0.0 { expected - found } else { (found - expected).abs() } / length;
                // 64 roundings of numbers of the size of the length.
                assert!(off < 64.0 * f64::EPSILON, "{length} m, β {skew_deg}°, at {d}: {found} for {expected}");
            }
        }
    }
}

fn grid() -> impl Iterator<Item = (f64, f64, f64)> {
    let range = || (-9..=9).map(f64::from);
    let coarse = || (-3..=3).map(|n| 3.0 * f64::from(n));
    range().flat_map(move |i| coarse().flat_map(move |j| coarse().map(move |k| (i, j, k))))
}

#[test]
fn turned_prisms_are_parted_by_their_edges_too() {
    // Two cubes, edge to edge: the second stands on a corner line, turned 45° about z and then tilted 45°.
    let cube = Convex::girder(&Prism { length: 1.0, width: 1.0, thickness: 1.0, skew: FRAC_PI_2 }).expect("a cube");
    let here = Stand { place: DVec3::ZERO, attitude: DQuat::from_rotation_z(FRAC_PI_4) };
    let tilted = DQuat::from_rotation_y(FRAC_PI_4);
    // The first has an upright edge at x = √½; the second a level one, along y, at −√½ from its centre.
    for gap in [-0.01, 0.0, 0.3] {
        let there = Stand { place: DVec3::new(2.0 * 0.5_f64.sqrt() + gap, 0.0, 0.0), attitude: tilted };
        let off = cube.separation(here, &cube, there) - gap;
        assert!(off.abs() < 16.0 * f64::EPSILON, "edges crossed along x: off by {off:e}");
    }
}

fn square(at: DVec2, half: f64, turn: f64) -> [DVec2; 4] {
    let axis = DVec2::from_angle(turn);
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| at + axis.rotate(DVec2::new(x, y) * half))
}

#[test]
fn in_plan_the_axis_that_parts_most_is_a_side_of_either() {
    let here = square(DVec2::ZERO, 1.0, 0.0);
    // Side by side; corner on side, where the turned square's own sides part less; across a corner, by its own sides.
    let cases = [
        (square(DVec2::new(2.3, 0.4), 1.0, 0.0), 0.3),
        (square(DVec2::new(1.9, 0.4), 1.0, 0.0), -0.1),
        (square(DVec2::new(1.0 + 2.0_f64.sqrt() - 0.2, 0.0), 1.0, FRAC_PI_4), -0.2),
        (
            square(DVec2::splat(1.5 + FRAC_PI_4.cos()), 1.0, FRAC_PI_4),
            2.0_f64.sqrt() * (1.5 + FRAC_PI_4.cos()) - 1.0 - 2.0_f64.sqrt(),
        ),
    ];
    for (i, (there, expected)) in cases.into_iter().enumerate() {
        for found in [plan_separation(&here, &there), plan_separation(&there, &here)] {
            assert!((found - expected).abs() < 1e-14, "case {i}: {found} for {expected}");
        }
    }
}

#[test]
fn a_point_is_as_far_in_as_its_nearest_side() {
    let mut square = square(DVec2::new(1.0, 0.0), 1.0, FRAC_PI_4);
    for _ in 0..2 {
        assert!((plan_distance(&square, DVec2::new(1.0, 0.0)) + 1.0).abs() < 1e-15, "the middle");
        // The corner at x = 1 − √2 stands apart along either of its sides.
        let found = plan_distance(&square, DVec2::new(1.0 - 2.0 * SQRT_2, 0.0));
        assert!((found - 1.0).abs() < 1e-14, "before a corner: {found}");
        square.reverse();
    }
}

#[test]
fn the_centre_of_what_is_shared_is_that_of_the_polygon() {
    let here = square(DVec2::ZERO, 1.0, 0.0);
    let strip = common_centre(&here, &square(DVec2::new(1.5, 0.5), 1.0, 0.0)).expect("they overlap");
    assert!(strip.distance(DVec2::new(0.75, 0.25)) < 1e-15, "{strip}");
    // A corner enters a side: a triangle of height 0.3, its centroid a third of it behind the side.
    let corner = square(DVec2::new(1.0 + 2.0_f64.sqrt() - 0.3, 0.0), 1.0, FRAC_PI_4);
    for (a, b) in [(here, corner), (corner, here)] {
        let centre = common_centre(&a, &b).expect("they overlap");
        assert!(centre.distance(DVec2::new(0.9, 0.0)) < 1e-14, "{centre}");
    }
    let turned_round = [corner[3], corner[2], corner[1], corner[0]];
    assert!(common_centre(&here, &turned_round).is_some_and(|c| c.distance(DVec2::new(0.9, 0.0)) < 1e-14));
    assert_eq!(common_centre(&here, &square(DVec2::splat(3.0), 0.5, 0.0)), None, "apart");
}

#[test]
fn distance_is_the_gap_square_to_the_face() {
    let body = girder(30.0, 60.0);
    let square = 0.5 * 60.0_f64.to_radians().sin();
    let found = body.distance(at(0.0), &body, at(30.5));
    // What parry's GJK leaves over.
    assert!((found - square).abs() < 1e-11 * 30.0, "{found} for {square}");
}

#[test]
fn prisms_apart_along_a_side_are_told_without_building_them() {
    for skew_deg in [90.0, 60.0, 135.0] {
        let prism = Prism { length: 30.0, width: 10.0, thickness: 2.0, skew: f64::to_radians(skew_deg) };
        let (body, corners) = (girder_of(&prism), prism.corners());
        for (i, j, k) in grid() {
            let shift = DVec3::new(4.0 * i, 1.5 * j, 0.3 * k);
            let found = stand_apart(&corners, &corners.map(|corner| corner + shift));
            let there = Stand { place: shift, attitude: DQuat::IDENTITY };
            let apart = body.separation(at(0.0), &body, there);
            // Prisms alike part along a side, never across two edges only; what touches may go either way.
            assert!(found == (apart > 0.0) || apart.abs() < 1e-12, "β {skew_deg}°, at {shift}: {apart}");
        }
    }
}

#[test]
fn a_block_lies_behind_its_face() {
    // From y to z is anticlockwise seen from +x; this one goes from z to y.
    let face = [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0)].map(|(z, y)| DVec3::new(3.0, y, z));
    let found = AlignedBox::around(&block_behind(face, 0.5));
    assert_eq!((found.min.x, found.max.x), (3.0, 3.5), "behind is away from the side it is seen from");
}

#[test]
fn a_ray_is_stopped_by_the_side_it_meets_first() {
    let body = girder(2.0, 90.0);
    let up = body.pick(at(0.0), DVec3::new(0.3, 0.1, 5.0), DVec3::NEG_Z).expect("it points down at the deck");
    assert!((up - 4.9).abs() < 1e-9, "the top lies at 0.1 m: {up}");
    assert_eq!(body.pick(at(0.0), DVec3::new(0.3, 0.1, 5.0), DVec3::Z), None, "it points away");
    assert_eq!(body.pick(at(0.0), DVec3::ZERO, DVec3::ZERO), None, "a ray without direction hits nothing");
}
