//! Angles as they are written: in degrees, exact at quarter turns.

/// `(sin, cos)` of an angle in degrees, exact at multiples of 90°.
pub(super) fn sin_cos_deg(angle: f64) -> (f64, f64) {
    match angle.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => angle.to_radians().sin_cos(),
    }
}
