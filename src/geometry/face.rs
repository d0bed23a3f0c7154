//! Flat contact faces: four corners, outward normal, inside test.

use glam::{DVec2, DVec3};

/// Part of its size by which a face may be off a plane, or its sides off parallel \[–\]. Chosen: corners computed with a turn and a sum are
/// off by some 1e-16 of the distance from the origin, which may be millions of times their size.
const FLAT: f64 = 1e-9;
/// Area over the square of the size below which four points have no normal \[–\]: their cross product is rounding.
const NO_AREA: f64 = 1e-12;

/// Reasons why four points are not a face.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FaceError {
    /// The corners do not lie in one plane.
    #[error("its corners are not in one plane: one lies {0:.3e} m off the plane of the others")]
    NotFlat(f64),
    /// A corner turns the wrong way, or two corners coincide.
    #[error("it is not convex: corner {0} turns inwards, or lies on its neighbour")]
    NotConvex(usize),
    /// The foot of a perpendicular would leave the sides ab and cd.
    #[error("it is neither a rectangle nor a trapezium with its parallel sides first and third (paper equation (66))")]
    NotTrapezium,
}

/// A flat face in its body's frame (the world's, for an abutment).
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Corners a, b, c, d, anticlockwise seen from outside \[m\].
    pub corners: [DVec3; 4],
    /// Outward unit normal `n`.
    pub normal: DVec3,
    /// First tangent, along ab.
    pub tangent: DVec3,
    /// Second tangent, `n × tangent`.
    pub bitangent: DVec3,
    /// Depth of the body behind the face \[m\].
    pub depth: f64,
}

impl Face {
    /// Builds a face from its corners.
    ///
    /// # Errors
    ///
    /// The corners are not flat, not convex, or not a shape that paper equations (66), (67) cover.
    pub fn new(corners: [DVec3; 4], depth: f64) -> Result<Self, FaceError> {
        let [a, b, c, d] = corners;
        let size = (c - a).length().max((d - b).length());
        let area_normal = (c - a).cross(d - b);
        if area_normal.length() <= NO_AREA * size * size {
            return Err(FaceError::NotConvex(0));
        }
        let normal = area_normal / area_normal.length();
        let off = ((b - a).dot(normal)).abs().max((c - a).dot(normal).abs()).max((d - a).dot(normal).abs());
        if off > FLAT * size {
            return Err(FaceError::NotFlat(off));
        }
        for i in 0..4 {
            let (before, here, after) = (corners[(i + 3) % 4], corners[i], corners[(i + 1) % 4]);
            if (here - before).cross(after - here).dot(normal) <= FLAT * size * size {
                return Err(FaceError::NotConvex(i));
            }
        }
        let (ab, dc) = (b - a, c - d);
        if ab.cross(dc).length() > FLAT * ab.length() * dc.length() {
            return Err(FaceError::NotTrapezium);
        }
        let tangent = ab / ab.length();
        Ok(Self { corners, normal, tangent, bitangent: normal.cross(tangent), depth })
    }

    /// Whether the face stands upright, its first tangent level.
    #[inline]
    pub fn is_upright(&self) -> bool {
        self.normal.z == 0.0 && self.tangent.z == 0.0 && self.bitangent.x == 0.0 && self.bitangent.y == 0.0
    }

    /// Whether its normal is level, but for the rounding of corners that are not exact.
    pub fn has_level_normal(&self) -> bool {
        self.normal.z.abs() <= FLAT
    }

    /// Signed distance of a point from the plane, positive outside \[m\].
    pub fn gap(&self, point: DVec3) -> f64 {
        (point - self.corners[0]).dot(self.normal)
    }

    /// Distance of a point's projection to the nearest side of the polygon, negative outside \[m\].
    pub fn inset(&self, point: DVec3) -> f64 {
        self.inset_at(self.coordinates(point))
    }

    /// Coordinates of a point's projection along the two tangents, from corner a \[m\].
    pub fn coordinates(&self, point: DVec3) -> DVec2 {
        let from_corner = point - self.corners[0];
        DVec2::new(from_corner.dot(self.tangent), from_corner.dot(self.bitangent))
    }

    /// [`Face::inset`] of a projection that is already in the face's coordinates.
    pub fn inset_at(&self, at: DVec2) -> f64 {
        let corners = self.corners.map(|corner| self.coordinates(corner));
        (0..4)
            .map(|i| {
                let (from, side) = (corners[i], corners[(i + 1) % 4] - corners[i]);
                side.perp_dot(at - from) / side.length()
            })
            .fold(f64::INFINITY, f64::min)
    }

    /// Longest extent, for tolerances \[m\].
    pub fn size(&self) -> f64 {
        let [a, b, c, d] = self.corners;
        (c - a).length().max((d - b).length())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kite_is_refused() {
        let corners = [(0.0, 0.0), (2.0, -1.0), (3.0, 0.0), (2.0, 1.5)].map(|(x, y)| DVec3::new(x, y, 0.0));
        assert_eq!(Face::new(corners, 1.0), Err(FaceError::NotTrapezium), "no parallel sides");
    }
}
