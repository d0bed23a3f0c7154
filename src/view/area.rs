//! Rectangles on the picture.

use glam::Vec2;

/// A rectangle on the picture \[pixels\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Area {
    pub(super) min: Vec2,
    pub(super) max: Vec2,
}

impl Area {
    /// Area of the intersection \[pixels²\].
    pub(super) fn overlap(&self, other: &Self) -> f32 {
        let size = (self.max.min(other.max) - self.min.max(other.min)).max(Vec2::ZERO);
        size.x * size.y
    }

    pub(super) fn size(&self) -> Vec2 {
        self.max - self.min
    }

    pub(super) fn about(middle: Vec2, half: Vec2) -> Self {
        Self { min: middle - half, max: middle + half }
    }
}
