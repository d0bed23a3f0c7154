//! Number of polynomials of a girder, (F9): from the stiffness of its contacts against its own.

use glam::{DMat2, DVec2, DVec3};
use nalgebra::{Matrix3, SymmetricEigen};

use super::beam::Beam;
use super::modes::Modes;
use super::space_beam::SpaceBeam;
use super::space_modes::SpaceModes;

/// Degree from which the flexibility of an end is exact.
const EXACT_ENDS: usize = 6;
/// Least degree: the first that bends.
pub const SMALLEST_DEGREE: usize = 2;
/// Largest degree.
pub const LARGEST_DEGREE: usize = 64;

/// Stiffness of a contact against that of the girder that it touches.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Softness {
    /// `κ = K a0/(E A)`.
    pub kappa: f64,
    /// `κ_e`: by what part the girder's own yielding softens the contact.
    pub end: f64,
}

impl Softness {
    /// Of a beam whose ends are touched through springs of this stiffness \[N/m\] at these offsets from the section's centre.
    pub fn of(beam: &Beam, stiffness: f64, offsets: &[DVec2]) -> Self {
        let modes = Modes::of(*beam, EXACT_ENDS);
        let at = |xi: f64, r: DVec2| largest(&modes.flexibility(&modes.point(xi, r)));
        let most = offsets.iter().flat_map(|&r| [at(-1.0, r), at(1.0, r)]).fold(0.0, f64::max);
        Self { kappa: stiffness * beam.length / beam.axial, end: stiffness * most }
    }

    /// Softness in space, with vertical deflection and twist too.
    pub fn in_space(beam: &SpaceBeam, stiffness: f64, offsets: &[DVec3]) -> Self {
        let modes = SpaceModes::of(*beam, EXACT_ENDS);
        let at = |xi: f64, r: DVec3| {
            let flexibility = modes.flexibility(&modes.point(xi, r)).to_cols_array();
            SymmetricEigen::new(Matrix3::from_column_slice(&flexibility)).eigenvalues.max()
        };
        let most = offsets.iter().flat_map(|&r| [at(-1.0, r), at(1.0, r)]).fold(0.0, f64::max);
        Self { kappa: stiffness * beam.plan.length / beam.plan.axial, end: stiffness * most }
    }
}

/// Larger eigenvalue of a symmetric matrix.
fn largest(m: &DMat2) -> f64 {
    let (mean, apart) = (0.5 * (m.x_axis.x + m.y_axis.y), 0.5 * (m.x_axis.x - m.y_axis.y));
    mean + apart.hypot(m.y_axis.x)
}

/// The degree for a softness; none where the girder is as good as rigid: `κ_e` below `tolerance`.
pub fn automatic_degree(softness: &Softness, tolerance: f64) -> Option<usize> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count, clamped")]
    let degree = (6.0 + 4.0 * softness.kappa.sqrt()).ceil().clamp(6.0, LARGEST_DEGREE as f64) as usize;
    (softness.end >= tolerance).then_some(degree)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::elastic::modes::tests::deck;

    #[test]
    fn a_contact_on_the_axis_is_softened_by_a_third_of_kappa() {
        let beam = Beam { shear: 1e30, bending: 1e30, ..deck() };
        let softness = Softness::of(&beam, 2e9, &[DVec2::ZERO]);
        assert!((softness.kappa - 0.25).abs() < 1e-15, "κ = {}", softness.kappa);
        assert!((softness.end / (0.25 / 3.0) - 1.0).abs() < 1e-11, "κ_e = {}", softness.end);
        // A corner of a deck yields more: it turns.
        let corner = Softness::of(&deck(), 2e9, &[DVec2::new(0.0, 5.0), DVec2::new(0.0, -5.0)]);
        assert!(corner.end > softness.end, "κ_e = {}", corner.end);
    }

    #[test]
    fn the_degree_grows_with_the_root_of_kappa_and_ends_at_64() {
        let degree = |kappa: f64| automatic_degree(&Softness { kappa, end: kappa / 3.0 }, 1e-4);
        assert_eq!([0.25, 1.0, 10.0, 1e4].map(degree), [Some(8), Some(10), Some(19), Some(64)]);
        assert_eq!(degree(2e-4), None, "as good as rigid");
        assert_eq!(degree(4e-4), Some(7), "and just not");
    }

    #[test]
    fn the_larger_eigenvalue_is_that_of_the_matrix() {
        let m = DMat2::from_cols(DVec2::new(3.0, 1.0), DVec2::new(1.0, 3.0));
        assert!((largest(&m) - 4.0).abs() < 1e-15, "{}", largest(&m));
    }
}
