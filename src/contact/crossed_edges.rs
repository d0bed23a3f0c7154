//! Two straight edges across each other: the distance of their lines, and what acts between them
//! (`docs/physics.md#edge-nodes`).
//!
//! In the axes `(t1, t2, n)` of a face with one edge along `t1` through the origin, the other edge has the direction
//! `u` and a point at `(x, y, z)`. The common perpendicular is `n` turned about `t1` by the angle φ of `(u₂, u₃)`; in the turned
//! axes that point is at
//!
//! ```text
//! y' = y cos φ + z sin φ,   D = z cos φ − y sin φ,   φ̇ = a·Ω,   a = t1 − (u₁/h) t2',   h = ±√(u₂² + u₃²)
//! ```
//!
//! with `D` the distance of the lines, whichever point is looked at, and Ω the angular velocity relative to the face. From
//! `Ḋ = ż cos φ − ẏ sin φ − φ̇ y'` and `ẏ' = ẏ cos φ + ż sin φ + φ̇ D` follows what a normal force N and a tangential force T do to
//! the bodies: both act at the point, and the couple `(T₂ D − N y') a` acts on the body of the edge, the opposite one on that of
//! the face. The work of N is that of the distance: its line of action is the common perpendicular. `h` has the sign of `u₂`.
//!
//! Axes that follow the common perpendicular by a part `f` alone are turned by `f φ`, so that `f a` stands for `a`: the same
//! balance of work, with a gap that at `f = 0` is that of a node before the face.

use glam::DVec3;

/// Turn of the common perpendicular of two edges about the first axis, from the third.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossed {
    /// Cosine and sine of φ \[–\].
    cos: f64,
    sin: f64,
    /// `u₁/h` \[–\].
    shear: f64,
    /// The vector `a`, in the axes.
    lever: DVec3,
}

impl Crossed {
    /// Edges that are not turned against the axes: a node before a face.
    pub const SQUARE: Self = Self { cos: 1.0, sin: 0.0, shear: 0.0, lever: DVec3::X };

    /// Of an edge with this direction in the axes; one along the first axis has no common perpendicular, and keeps the third axis.
    #[inline]
    pub(super) fn of(edge: DVec3) -> Self {
        let h = edge.y.hypot(edge.z).copysign(edge.y);
        if h == 0.0 {
            return Self::SQUARE;
        }
        let (cos, sin, shear) = (edge.y / h, edge.z / h, edge.x / h);
        Self { cos, sin, shear, lever: DVec3::new(1.0, -shear * cos, -shear * sin) }
    }

    /// Axes that follow the common perpendicular by the part `follow` \[–\].
    #[inline]
    pub(super) fn partly(self, follow: f64) -> Self {
        if follow == 1.0 {
            return self;
        }
        let (sin, cos) = (follow * self.sin.atan2(self.cos)).sin_cos();
        Self { cos, sin, shear: self.shear, lever: follow * self.lever }
    }

    /// Components in the turned axes of a vector given in the axes.
    #[inline]
    pub(super) fn seen(self, v: DVec3) -> DVec3 {
        DVec3::new(v.x, self.cos * v.y + self.sin * v.z, self.cos * v.z - self.sin * v.y)
    }

    /// Components in the axes of a vector given in the turned ones.
    #[inline]
    pub fn in_axes(self, v: DVec3) -> DVec3 {
        DVec3::new(v.x, self.cos * v.y - self.sin * v.z, self.sin * v.y + self.cos * v.z)
    }

    /// Coordinate along the first axis at which the lines are nearest, of a point `at` of the edge in the turned axes \[m\]. Edges that
    /// turn parallel send it beyond their ends.
    #[inline]
    pub(super) fn along(self, at: DVec3) -> f64 {
        at.x - self.shear * at.y
    }

    /// Rates of `(x, y', D)`, of a point `at` in the turned axes, from the rates of `(x, y, z)` and the angular velocity relative to
    /// the face, both in the axes.
    #[inline]
    pub(super) fn rates(self, at: DVec3, rates: DVec3, spin: DVec3) -> DVec3 {
        let turning = self.lever.dot(spin);
        self.seen(rates) + turning * DVec3::new(0.0, at.z, -at.y)
    }

    /// Couple on the body of the edge besides the force at the point, of a point `at` and a force in the turned axes; in the axes
    /// \[N·m\].
    #[inline]
    pub fn couple(self, at: DVec3, force: DVec3) -> DVec3 {
        self.lever * (force.y * at.z - force.z * at.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EDGE: DVec3 = DVec3::new(0.3, -0.8, 0.25);
    const AT: DVec3 = DVec3::new(0.7, 0.02, -0.03);

    /// `(x, y', D)` of the point on the edge after a small motion, in axes that follow by a part.
    fn after(follow: f64, spin: DVec3, rates: DVec3, dt: f64) -> DVec3 {
        Crossed::of(EDGE + spin.cross(EDGE) * dt).partly(follow).seen(AT + rates * dt)
    }

    #[test]
    fn the_distance_is_that_of_the_two_lines() {
        let across = DVec3::X.cross(EDGE).normalize_or_zero();
        let along = AT.dot(across);
        let found = Crossed::of(EDGE).seen(AT);
        assert!((found.z.abs() - along.abs()).abs() < 1e-16, "{} m is not {along} m", found.z);
        let other = Crossed::of(EDGE).seen(AT + 0.4 * EDGE);
        assert!((other.z - found.z).abs() < 1e-16, "whichever point of the edge: {} m", other.z);
        assert!(Crossed::of(EDGE).in_axes(DVec3::Z).z > 0.0, "outward");
        assert!((Crossed::of(EDGE).in_axes(found) - AT).length() < 1e-16, "and back");
        // The point of the first axis from which the other line is seen along the common perpendicular.
        let seen = DVec3::X * Crossed::of(EDGE).along(found) + Crossed::of(EDGE).in_axes(DVec3::Z) * found.z;
        assert!((seen - AT).cross(EDGE).length() < 1e-15, "on the edge");
        assert_eq!(Crossed::of(DVec3::X), Crossed::SQUARE, "without a common perpendicular");
    }

    #[test]
    fn rates_are_derivatives_and_the_forces_do_their_work() {
        let (spin, rates) = (DVec3::new(0.9, -1.3, 0.4), DVec3::new(0.2, -0.5, 0.3));
        for follow in [0.0, 0.3, 1.0] {
            let crossed = Crossed::of(EDGE).partly(follow);
            let h = 1e-6;
            let difference = (after(follow, spin, rates, h) - after(follow, spin, rates, -h)) / (2.0 * h);
            let found = crossed.rates(crossed.seen(AT), rates, spin);
            assert!((difference - found).length() < 1e-9, "{found} is not {difference}, followed by {follow}");
            let force = DVec3::new(3.0, -5.0, 11.0);
            let power = force.dot(found);
            let couple = crossed.couple(crossed.seen(AT), force);
            let done = crossed.in_axes(force).dot(rates) + couple.dot(spin);
            assert!((power - done).abs() < 1e-13 * power.abs(), "{done} W is not {power} W, followed by {follow}");
        }
    }

    #[test]
    fn square_edges_are_a_node_before_a_face() {
        let square = Crossed::of(DVec3::Y);
        assert_eq!(square, Crossed::SQUARE);
        assert_eq!([square.seen(AT), square.in_axes(AT)], [AT, AT]);
        let kept = Crossed::of(EDGE).partly(0.0);
        assert_eq!(
            [kept.seen(AT), kept.couple(AT, AT)],
            [AT, DVec3::ZERO],
            "and where the common perpendicular is not followed"
        );
    }
}
