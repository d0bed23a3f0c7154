//! Modes of a deck and of a slender beam against closed forms.

use super::*;

/// A straight deck of concrete, 30 × 10 m, 600 t.
pub(in crate::dynamics) fn deck() -> Beam {
    let (e, area) = (30e9, 8.0);
    let shear = 5.0 / 6.0 * e / (2.0 * 1.2) * area;
    Beam { length: 30.0, mass: 6e5, rotary: 100.0 / 12.0, axial: e * area, bending: e * area * 100.0 / 12.0, shear }
}

/// A deck so slender and so stiff in shear that it is nearly Euler and Bernoulli's.
fn slender() -> Beam {
    Beam { rotary: 9e-4, shear: 2.7e14, bending: 30e9 * 8.0, ..deck() }
}

/// ω a0/(π c).
fn ratios(beam: Beam, degree: usize) -> Vec<f64> {
    let unit = std::f64::consts::PI * beam.wave_speed() / beam.length;
    Modes::of(beam, degree).frequencies().map(|omega| omega / unit).collect()
}

/// Numbers of the modes along the axis, or of those across it.
fn numbers(modes: &Modes, axial: bool) -> Vec<usize> {
    let along = |j: &usize| modes.coefficients(*j).iter().any(|c| c.x != 0.0);
    (0..modes.count()).filter(|j| along(j) == axial).collect()
}

/// ω a0/(π c) of a deck's axial modes or of its others.
fn of_kind(degree: usize, axial: bool) -> Vec<f64> {
    let (modes, all) = (Modes::of(deck(), degree), ratios(deck(), degree));
    numbers(&modes, axial).into_iter().map(|j| all[j]).collect()
}

fn is_near(value: f64, wanted: f64, tolerance: f64) -> bool {
    (value - wanted).abs() <= tolerance * wanted.abs()
}

#[test]
fn frequencies_of_a_deck_are_those_of_a_timoshenko_beam() {
    let wanted = [0.525_439, 1.0, 1.083_318, 1.669_837, 1.989_026, 2.0, 2.454_729, 2.466_024];
    for (value, wanted) in ratios(deck(), 24).into_iter().zip(wanted) {
        assert!((value - wanted).abs() < 6e-7, "{value} against {wanted}");
    }
    // Axial ones up to n c/a0 are good to 1e-3, those of bending up to 0.65 n c/a0.
    for n in [8, 12, 16] {
        let limit = n as f64 / std::f64::consts::PI;
        for (axial, part) in [(true, 1.0), (false, 0.65)] {
            let pairs = of_kind(n, axial).into_iter().zip(of_kind(40, axial));
            for (value, wanted) in pairs.filter(|(_, fine)| *fine < part * limit) {
                assert!(is_near(value, wanted, 1e-3), "n = {n}: {value} against {wanted}");
            }
        }
    }
}

#[test]
fn axial_frequencies_are_whole_multiples_and_slender_ones_eulers() {
    let beam = slender();
    let modes = Modes::of(beam, 16);
    let unit = (beam.bending * beam.length / beam.mass).sqrt() / (beam.length * beam.length);
    let bending = numbers(&modes, false).into_iter().map(|j| (modes.omega(j) / unit).sqrt());
    for (value, wanted) in bending.zip([4.730_041, 7.853_205, 10.995_608, 14.137_165]) {
        // Slenderness leaves (βL)² 1e-6 of it.
        assert!(is_near(value, wanted, 3e-4), "βL = {value} against {wanted}");
    }
    let axial = numbers(&modes, true);
    assert_eq!((axial.len(), modes.count()), (16, 3 * 16 - 1), "n axial modes of 3n − 1");
    for (i, &j) in axial.iter().take(4).enumerate() {
        let wanted = (i + 1) as f64 * std::f64::consts::PI * beam.wave_speed() / beam.length;
        assert!(is_near(modes.omega(j), wanted, 1e-9), "{} against {wanted}", modes.omega(j));
    }
}

/// Mass of two motions of the whole beam: coefficients of `P_k` in u, v, φ.
fn product(beam: &Beam, one: &[DVec3], other: &[DVec3]) -> f64 {
    let factor = DVec3::new(1.0, 1.0, beam.rotary);
    let term = |(k, (a, b)): (usize, (&DVec3, &DVec3))| 0.5 * beam.mass * square(k) * (*a * *b).dot(factor);
    one.iter().zip(other).enumerate().map(term).sum()
}

#[test]
fn modes_are_orthogonal_in_mass_to_each_other_and_to_rigid_motions() {
    let modes = Modes::of(deck(), 9);
    let rigid = [vec![DVec3::X], vec![DVec3::Y], vec![DVec3::Z, DVec3::Y * (0.5 * modes.beam.length)]];
    for i in 0..modes.count() {
        for j in 0..modes.count() {
            let value = product(&modes.beam, modes.coefficients(i), modes.coefficients(j));
            assert!((value - f64::from(u8::from(i == j))).abs() < 1e-12, "{i}, {j}: {value}");
        }
        for motion in &rigid {
            let size = product(&modes.beam, motion, motion).sqrt();
            let value = product(&modes.beam, modes.coefficients(i), motion) / size;
            assert!(value.abs() < 1e-13, "mode {i} moves the mean axes: {value}");
        }
    }
}

#[test]
fn every_mode_is_its_own_mirror_image() {
    let modes = Modes::of(deck(), 10);
    let [left, right] = [-0.7, 0.7].map(|xi| modes.section(xi));
    for (a, b) in left.iter().zip(&right) {
        let (same, other) = ((*a - *b * DVec3::new(1.0, 1.0, -1.0)), (*a + *b * DVec3::new(1.0, 1.0, -1.0)));
        assert!(same == DVec3::ZERO || other == DVec3::ZERO, "{a} against {b}");
    }
}

#[test]
fn ends_yield_as_a_beam_relieved_by_its_inertia() {
    let beam = deck();
    let axial = |degree: usize| Modes::of(beam, degree);
    for degree in [2, 3, 8] {
        let modes = axial(degree);
        let f = modes.flexibility(&modes.point(1.0, DVec2::ZERO));
        assert!(is_near(f.x_axis.x, beam.length / (3.0 * beam.axial), 1e-12), "a0/3EA at n = {degree}");
    }
    let thin = Beam { rotary: 1e-9, ..beam };
    let wanted = beam.length.powi(3) / (105.0 * beam.bending) + 2.0 * beam.length / (15.0 * beam.shear);
    for degree in [6, 7, 12] {
        let modes = Modes::of(thin, degree);
        let f = modes.flexibility(&modes.point(-1.0, DVec2::ZERO));
        assert!(is_near(f.y_axis.y, wanted, 1e-7), "lateral at n = {degree}: {} against {wanted}", f.y_axis.y);
    }
    let short = Modes::of(thin, 4);
    let f = short.flexibility(&short.point(-1.0, DVec2::ZERO)).y_axis.y;
    assert!(!is_near(f, wanted, 1e-7), "not with fewer: {f}");
    // With rotary inertia the value no longer changes from n = 6 on, and a point off the axis turns with its section.
    let corner = |degree: usize| {
        let modes = Modes::of(beam, degree);
        modes.flexibility(&modes.point(1.0, DVec2::new(2.9, 5.0)))
    };
    let (six, more) = (corner(6), corner(15));
    assert!(six.abs_diff_eq(more, 1e-11 * more.x_axis.x), "{six} against {more}");
}

#[test]
fn the_end_mass_is_the_smallest_of_a_polynomial() {
    let beam = deck();
    for n in [2, 6, 11] {
        let modes = Modes::of(beam, n);
        let elastic: f64 = modes.section(1.0).iter().map(|field| field.x * field.x).sum();
        // With the rigid translation Σ(2k + 1)/m = (n + 1)²/m.
        let whole = elastic + 1.0 / beam.mass;
        assert!(is_near(whole, ((n + 1) * (n + 1)) as f64 / beam.mass, 1e-11), "n = {n}: {whole}");
    }
}
