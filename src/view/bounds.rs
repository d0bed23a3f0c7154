//! The box that a scene stands in, for cameras, grids and lights.

use glam::DVec3;

use super::block::{abutment_block, girder_block};
use super::piers::foot;
use crate::scene::Scene;

/// Part of a long backwall that counts, beside the girders, as a share of their extent \[–\].
const WALL_MARGIN: f64 = 0.12;

/// An axis-aligned box in the world \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least corner \[m\].
    pub min: DVec3,
    /// Greatest corner \[m\].
    pub max: DVec3,
}

impl Bounds {
    /// A cubic metre about the origin, for a scene with nothing in it.
    pub const UNIT: Self = Self { min: DVec3::splat(-0.5), max: DVec3::splat(0.5) };

    /// The box about some points; [`Bounds::UNIT`] where there are none (or none that is finite).
    pub fn of_points(points: impl IntoIterator<Item = DVec3>) -> Self {
        let mut points = points.into_iter().filter(|p| p.is_finite());
        let Some(first) = points.next() else { return Self::UNIT };
        points.fold(Self { min: first, max: first }, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The box about every body of a scene as placed.
    ///
    /// A backwall counts only near the girders: a long one must not make the girders small.
    pub fn of_scene(scene: &Scene) -> Self {
        let piers = (0..scene.piers.len()).map(|number| scene.pier(number));
        let feet = piers.map(|pier| pier.top.with_z(foot(&pier)));
        let own = Self::of_points(scene.girders.iter().flat_map(|g| girder_block(g).corners()).chain(feet));
        let walls = scene.abutments.iter().filter_map(|a| abutment_block(scene, a)).flat_map(|b| b.corners());
        if scene.girders.is_empty() {
            return Self::of_points(walls);
        }
        let near = own.grown(own.size().max_element() * WALL_MARGIN);
        let walls: Vec<_> = walls.map(|p| p.clamp(near.min, near.max)).collect();
        Self::of_points(walls.into_iter().chain([own.min, own.max]))
    }

    /// The box with `margin` more on every side \[m\].
    #[must_use]
    pub fn grown(&self, margin: f64) -> Self {
        Self { min: self.min - margin, max: self.max + margin }
    }

    /// Its middle \[m\].
    pub fn centre(&self) -> DVec3 {
        (self.min + self.max) / 2.0
    }

    /// Its extents \[m\].
    pub fn size(&self) -> DVec3 {
        self.max - self.min
    }

    /// Half its diagonal, never 0 \[m\].
    pub fn radius(&self) -> f64 {
        (self.size().length() / 2.0).max(1e-6)
    }

    /// Its eight corners \[m\].
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|i| {
            let pick = |bit: usize, axis: usize| if i & bit == 0 { self.min[axis] } else { self.max[axis] };
            DVec3::new(pick(1, 0), pick(2, 1), pick(4, 2))
        })
    }
}
