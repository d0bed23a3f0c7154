//! Length of the line between the two points of a device, and its rate.

use glam::DVec3;

use crate::dynamics::connection::Separation;

/// Line from the second point of a device to its first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// Unit vector from the second point to the first; 0 where they coincide.
    pub direction: DVec3,
    /// Length since placed, longer is positive \[m\].
    pub elongation: f64,
    /// Its rate \[m/s\].
    pub rate: f64,
}

impl Line {
    pub(super) fn of(motion: &Separation) -> Self {
        let vector = motion.vector();
        let direction = vector.normalize_or_zero();
        // |a + m| − |a| without the cancellation of two lengths.
        let lengths = vector.length() + motion.placed.length();
        let elongation = motion.moved.dot(vector + motion.placed) / lengths.max(f64::MIN_POSITIVE);
        Self { direction, elongation, rate: direction.dot(motion.rate) }
    }

    /// Gap of a device that acts at any length, less its deformation, and the rate of it \[m, m/s\].
    pub(super) fn gap(&self) -> [f64; 2] {
        [-self.elongation.abs(), -self.rate.abs()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_elongation_is_the_difference_of_lengths_to_the_last_digit_of_the_motion() {
        let placed = DVec3::new(3.0, -4.0, 0.0);
        let motion = Separation { placed, moved: DVec3::new(6e-13, -8e-13, 0.0), rate: DVec3::new(0.3, 0.1, 0.0) };
        let line = Line::of(&motion);
        assert!((line.elongation / 1e-12 - 1.0).abs() < 1e-12, "{} m", line.elongation);
        assert!((line.rate - 0.1).abs() < 1e-15, "0.3 · 0.6 − 0.1 · 0.8, got {}", line.rate);
    }
}
