//! Modes in space against closed forms.

use std::f64::consts::PI;

use super::*;
use crate::geometry::rectangle::torsion_constant;

/// A deck of concrete, 30 × 10 × 1.5 m, 600 t, with oblique sections by cot β.
pub(in crate::dynamics) fn deck(cot: f64) -> SpaceBeam {
    let mut plan = crate::dynamics::elastic::modes::tests::deck();
    let (e, area) = (30e9, 8.0);
    plan.rotary *= 1.0 + cot * cot;
    SpaceBeam {
        plan,
        rotary: SpaceBeam::rotary_of(10.0, 1.5, cot),
        bending: e * area * 1.5 * 1.5 / 12.0,
        shear: plan.shear,
        torsion: e / 2.4 * torsion_constant(10.0, 1.5),
    }
}

fn is_near(value: f64, wanted: f64, tolerance: f64) -> bool {
    (value - wanted).abs() <= tolerance * wanted.abs()
}

/// Circular frequencies of the modes of which a coefficient is not 0.
fn of_kind(modes: &SpaceModes, moves: impl Fn(&Fields) -> bool) -> Vec<f64> {
    (0..modes.count()).filter(|&j| modes.coefficients(j).iter().any(&moves)).map(|j| modes.omega(j)).collect()
}

#[test]
fn there_are_six_n_less_two_modes_of_which_those_in_plan_are_the_plans() {
    for (cot, n) in [(0.0, 2), (0.6, 2), (0.0, 9), (-1.1, 9)] {
        let modes = SpaceModes::of(deck(cot), n);
        assert_eq!(modes.count(), 6 * n - 2, "cot β = {cot}, n = {n}");
        let in_plan = of_kind(&modes, |c| c.moved.x != 0.0 || c.moved.y != 0.0 || c.turned.z != 0.0);
        assert_eq!(in_plan, Modes::of(deck(cot).plan, n).frequencies().collect::<Vec<_>>());
    }
}

#[test]
fn a_straight_deck_twists_in_whole_multiples() {
    let beam = deck(0.0);
    let twisting = of_kind(&SpaceModes::of(beam, 16), |c| c.turned.x != 0.0);
    assert_eq!(twisting.len(), 16, "n modes of torsion");
    for (j, omega) in twisting.into_iter().take(4).enumerate() {
        let inertia = beam.plan.mass / beam.plan.length * beam.rotary.x_axis.x;
        let wanted = (j + 1) as f64 * PI / beam.plan.length * (beam.torsion / inertia).sqrt();
        assert!(is_near(omega, wanted, 1e-9), "{omega} against {wanted}");
    }
}

#[test]
fn a_slender_deck_bends_upwards_as_eulers_beam() {
    let slender = SpaceBeam { rotary: DMat3::from_diagonal(DVec3::splat(9e-4)), shear: 2.7e14, ..deck(0.0) };
    let modes = SpaceModes::of(slender, 16);
    let unit = (slender.bending * slender.plan.length / slender.plan.mass).sqrt() / slender.plan.length.powi(2);
    let bending = of_kind(&modes, |c| c.moved.z != 0.0);
    for (omega, wanted) in bending.into_iter().zip([4.730_041, 7.853_205, 10.995_608, 14.137_165]) {
        let value = (omega / unit).sqrt();
        assert!(is_near(value, wanted, 1e-3), "βL = {value} against {wanted}");
    }
}

/// Timoshenko's frequencies are those that plan bending has with the vertical numbers.
#[test]
fn a_straight_deck_bends_upwards_as_timoshenkos_beam() {
    let beam = deck(0.0);
    let plan = super::super::beam::Beam {
        rotary: beam.rotary.y_axis.y,
        bending: beam.bending,
        shear: beam.shear,
        ..beam.plan
    };
    let side = Modes::of(plan, 14);
    let across = (0..side.count()).filter(|&j| side.coefficients(j).iter().any(|c| c.y != 0.0));
    let upwards = of_kind(&SpaceModes::of(beam, 14), |c| c.moved.z != 0.0);
    // Rounding of the highest frequency reaches the lowest by the square of their ratio.
    for (omega, j) in upwards.into_iter().zip(across) {
        assert!(is_near(omega, side.omega(j), 1e-9), "{omega} against {}", side.omega(j));
    }
}

/// Mass of two motions of the whole beam.
fn product(beam: &SpaceBeam, one: &[Fields], other: &[Fields]) -> f64 {
    let term = |(k, (a, b)): (usize, (&Fields, &Fields))| {
        0.5 * beam.plan.mass * square(k) * (a.moved.dot(b.moved) + a.turned.dot(beam.rotary * b.turned))
    };
    one.iter().zip(other).enumerate().map(term).sum()
}

/// Unit rigid motions: three translations, three turns about G.
fn rigid(beam: &SpaceBeam) -> Vec<Vec<Fields>> {
    let moved = |v: DVec3| vec![Fields { moved: v, turned: DVec3::ZERO }];
    let turned = |v: DVec3| {
        let arm = Fields { moved: v.cross(DVec3::X * (0.5 * beam.plan.length)), turned: DVec3::ZERO };
        vec![Fields { moved: DVec3::ZERO, turned: v }, arm]
    };
    DVec3::AXES.into_iter().map(moved).chain(DVec3::AXES.into_iter().map(turned)).collect()
}

#[test]
fn modes_are_orthogonal_in_mass_to_each_other_and_to_all_rigid_motions() {
    for cot in [0.0, 0.577, -1.3] {
        let modes = SpaceModes::of(deck(cot), 9);
        for i in 0..modes.count() {
            for j in 0..modes.count() {
                let value = product(&modes.beam, modes.coefficients(i), modes.coefficients(j));
                assert!((value - f64::from(u8::from(i == j))).abs() < 1e-11, "{cot}: {i}, {j}: {value}");
            }
            for motion in rigid(&modes.beam) {
                let size = product(&modes.beam, &motion, &motion).sqrt();
                let value = product(&modes.beam, modes.coefficients(i), &motion) / size;
                assert!(value.abs() < 1e-12, "{cot}: mode {i} moves the mean axes: {value}");
            }
        }
    }
}

#[test]
fn the_inertia_of_the_beam_is_that_of_the_prism() {
    for skew in [90.0f64, 60.0, 130.0] {
        let prism = crate::geometry::Prism { length: 30.0, width: 10.0, thickness: 1.5, skew: skew.to_radians() };
        let beam = deck(prism.shear());
        let turns = &rigid(&beam)[3..];
        let wanted = prism.inertia_per_mass() * beam.plan.mass;
        for i in 0..3 {
            for j in 0..3 {
                let value = product(&beam, &turns[i], &turns[j]);
                assert!((value - wanted.col(i)[j]).abs() < 1e-12 * wanted.z_axis.z, "{skew}°: {i}, {j}: {value}");
            }
        }
    }
}

#[test]
fn ends_yield_as_a_beam_relieved_by_its_inertia() {
    let beam = deck(0.0);
    // Twist at an end by a moment there: a0/(3 G J), as axially a0/(3 E A).
    let twist = |beam: SpaceBeam, n: usize| {
        let modes = SpaceModes::of(beam, n);
        let end = modes.section(1.0);
        end.iter().zip(modes.frequencies()).map(|(f, omega)| (f.turned.x / omega).powi(2)).sum::<f64>()
    };
    for n in [2, 3, 8] {
        let wanted = beam.plan.length / (3.0 * beam.torsion);
        assert!(is_near(twist(beam, n), wanted, 1e-10), "{} against {wanted}", twist(beam, n));
    }
    let thin = SpaceBeam { rotary: DMat3::from_diagonal(DVec3::new(8.5, 1e-5, 8.4)), ..beam };
    let wanted = beam.plan.length.powi(3) / (105.0 * beam.bending) + 2.0 * beam.plan.length / (15.0 * beam.shear);
    for n in [6, 7, 12] {
        let modes = SpaceModes::of(thin, n);
        let f = modes.flexibility(&modes.point(-1.0, DVec3::ZERO)).z_axis.z;
        assert!(is_near(f, wanted, 1e-6), "upwards at n = {n}: {f} against {wanted}");
    }
    // Skewed, no longer changed from n = 6 on.
    let corner = |n: usize| {
        let modes = SpaceModes::of(deck(0.577), n);
        modes.flexibility(&modes.point(1.0, DVec3::new(2.9, 5.0, 0.75)))
    };
    let (six, more) = (corner(6), corner(15));
    assert!(six.abs_diff_eq(more, 1e-8 * more.z_axis.z), "{six} against {more}");
}
