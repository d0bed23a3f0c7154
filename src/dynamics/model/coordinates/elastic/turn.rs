//! Rotations in plan.

use glam::{DMat2, DMat3, DVec2, DVec3};

/// Rotation matrix in plan less the identity, R(angle) − 1, without cancellation at small angles.
#[inline]
pub(super) fn planar_turn(angle: f64) -> DMat2 {
    let (s, c) = (0.5 * angle).sin_cos();
    let (sine, less) = (2.0 * s * c, -2.0 * s * s);
    DMat2::from_cols(DVec2::new(less, sine), DVec2::new(-sine, less))
}

/// Product of two rotations, each less the identity: (1 + a)(1 + b) − 1.
#[inline]
pub(super) fn composed(a: DMat2, b: DMat2) -> DMat2 {
    a + b + a * b
}

/// A matrix in plan as one in space.
#[inline]
pub(super) fn in_space(turned: DMat2) -> DMat3 {
    DMat3::from_cols(turned.x_axis.extend(0.0), turned.y_axis.extend(0.0), DVec3::ZERO)
}
