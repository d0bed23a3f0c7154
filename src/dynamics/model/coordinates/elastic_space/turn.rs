//! Rotation of a section by its rotation vector φ: `exp [φ]×`, and the angular velocity by the rate of φ.

use glam::{DMat3, DVec3};

/// Squared angle up to which `(θ − sin θ)/θ³` is summed as a series: seven terms leave 1e-17 there, the difference is as exact above.
const SERIES: f64 = 0.25;

/// Rotation matrix of a section less the identity, and the map from φ̇ to its angular velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct SectionTurn {
    /// `exp [φ]× − 1 = a [φ]× + b [φ]×²`, without loss where it is small.
    pub(super) own: DMat3,
    /// Angular velocity per rate of φ, `1 + b [φ]× + c [φ]×²`.
    pub(super) map: DMat3,
}

impl SectionTurn {
    /// By a rotation vector: a = sin θ/θ, b = (1 − cos θ)/θ², c = (θ − sin θ)/θ³.
    pub(super) fn of(phi: DVec3) -> Self {
        let square = phi.length_squared();
        let (a, b, c) = if square == 0.0 {
            (1.0, 0.5, 1.0 / 6.0)
        } else {
            let angle = square.sqrt();
            let (half, sine) = ((0.5 * angle).sin() / (0.5 * angle), angle.sin() / angle);
            let c = if square < SERIES { cubic(square) } else { (1.0 - sine) / square };
            (sine, 0.5 * half * half, c)
        };
        let cross = DMat3::from_cols(phi.cross(DVec3::X), phi.cross(DVec3::Y), phi.cross(DVec3::Z));
        let twice = cross * cross;
        Self { own: cross * a + twice * b, map: DMat3::IDENTITY + cross * b + twice * c }
    }
}

/// `Σ (−θ²)^k/(2k + 3)!`.
fn cubic(square: f64) -> f64 {
    let next = |term: f64, k: f64| -term * square / ((2.0 * k + 2.0) * (2.0 * k + 3.0));
    let (mut term, mut sum) = (1.0 / 6.0, 1.0 / 6.0);
    for k in 1..=7 {
        term = next(term, f64::from(k));
        sum += term;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;

    #[test]
    fn it_is_the_rotation_and_its_rate() {
        for phi in [
            DVec3::ZERO,
            DVec3::new(1e-9, -2e-9, 3e-9),
            DVec3::new(0.01, -0.3, 0.2),
            DVec3::new(0.3, 0.39, 0.05),
            DVec3::new(1.0, -0.4, 0.3),
        ] {
            let turn = SectionTurn::of(phi);
            let wanted = DMat3::from_quat(DQuat::from_scaled_axis(phi));
            assert!((turn.own + DMat3::IDENTITY).abs_diff_eq(wanted, 1e-15), "{phi}: {}", turn.own);
            // Ė = [J φ̇]× E by a difference quotient.
            let (rate, dt) = (DVec3::new(0.3, 0.7, -0.5), 1e-5);
            let at = |t: f64| SectionTurn::of(phi + rate * t).own;
            let spin = turn.map * rate;
            let v = DVec3::new(0.4, -1.0, 2.0);
            let slope = (at(dt) - at(-dt)) * v / (2.0 * dt);
            let here = spin.cross(v + turn.own * v);
            assert!((slope - here).length() < 1e-9, "{phi}: {slope} against {here}");
        }
        let plane = SectionTurn::of(DVec3::Z * 0.4);
        assert_eq!(plane.map * DVec3::Z, DVec3::Z, "about one axis the rate is the angular velocity");
    }

    #[test]
    fn the_series_and_the_difference_agree_where_they_meet() {
        let angle = SERIES.sqrt();
        let difference = (angle - angle.sin()) / angle.powi(3);
        assert!((cubic(SERIES) - difference).abs() < 4e-16, "{} against {difference}", cubic(SERIES));
    }
}
