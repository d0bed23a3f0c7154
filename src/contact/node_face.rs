//! Position and velocity of a node relative to a face (paper, (52), (53); `docs/physics.md#contact-kinematics`).
//!
//! Quantities are in the face's axes `(t1, t2, n)` with their origin at corner a, so that a law is independent of
//! bodies. There are two velocities: the rate of the node's coordinates in the face's frame, and `V = V_k − V_p`
//! (53b) relative to the anchor p; on a rotating face they differ by `ω × (X_k − X_p)`.

use glam::{DMat3, DQuat, DVec2, DVec3};

use super::constants::PLACED_ROUNDING;
use super::crossed_edges::Crossed;
use crate::geometry::Face;

/// Pose and twist of a body, world axes.
///
/// Position and attitude are split into the placed ones and the change since: their sum would round off the last
/// digits of a gap, which is as small against the girder as that change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Position of G as placed \[m\].
    pub home: DVec3,
    /// Displacement of G since placed \[m\].
    pub shift: DVec3,
    /// Rotation since placed less the identity: `D` of `R = (1 + D) R₀` \[–\].
    pub turned: DMat3,
    /// Rotation about the vertical since placed with its whole turns, of a motion in plan; 0 in space \[rad\].
    pub heading: f64,
    /// Velocity of G \[m/s\].
    pub velocity: DVec3,
    /// Angular velocity \[rad/s\].
    pub spin: DVec3,
    /// Whether the motion is plane: no roll, no pitch, no vertical velocity.
    pub level: bool,
}

impl Frame {
    /// A body at rest as placed, with G at `home`.
    pub const fn fixed(home: DVec3) -> Self {
        let still = DVec3::ZERO;
        Self { home, shift: still, turned: DMat3::ZERO, heading: 0.0, velocity: still, spin: still, level: true }
    }

    /// Position of G \[m\].
    pub fn origin(&self) -> DVec3 {
        self.home + self.shift
    }

    /// Present vector of one fixed to the body that is `placed` as placed.
    #[inline]
    pub fn turn(&self, placed: DVec3) -> DVec3 {
        placed + self.turned * placed
    }

    /// Present body axes, in the columns, from those as placed.
    #[inline]
    pub fn rotation(&self, placed: &DMat3) -> DMat3 {
        *placed + self.turned * *placed
    }

    /// Upper bound of the displacement since placed of a point at distance `arm` from G \[m\].
    pub fn moved(&self, arm: f64) -> f64 {
        self.shift.length() + self.chord() * arm
    }

    /// Upper bound of the displacement of a unit vector by the rotation since placed \[–\].
    pub fn chord(&self) -> f64 {
        // Half of the squared Frobenius norm of D is the squared chord `(2 sin θ/2)²` of a point at unit distance
        // from the axis.
        let [x, y, z] = [self.turned.x_axis, self.turned.y_axis, self.turned.z_axis];
        let chord2 = 0.5 * (x.length_squared() + y.length_squared() + z.length_squared());
        chord2.sqrt()
    }

    /// Upper bound of the speed of a point at distance `arm` from G \[m/s\].
    pub fn speed(&self, arm: f64) -> f64 {
        self.velocity.length() + self.spin.length() * arm
    }

    /// World velocity of a point of the body at `arm` from G \[m/s\].
    pub fn velocity_at(&self, arm: DVec3) -> DVec3 {
        self.velocity + self.spin.cross(arm)
    }
}

/// Rotation of a unit quaternion less the identity, without cancellation for a small rotation.
pub fn turned_by(q: DQuat) -> DMat3 {
    let (x, y, z, w) = (2.0 * q.x, 2.0 * q.y, 2.0 * q.z, q.w);
    let (xx, yy, zz) = (x * q.x, y * q.y, z * q.z);
    let (xy, xz, yz) = (x * q.y, x * q.z, y * q.z);
    let (wx, wy, wz) = (w * x, w * y, w * z);
    DMat3::from_cols(
        DVec3::new(-(yy + zz), xy + wz, xz - wy),
        DVec3::new(xy - wz, -(xx + zz), yz + wx),
        DVec3::new(xz + wy, yz - wx, -(xx + yy)),
    )
}

/// Geometry of a node and a face as placed, world axes: reference of their motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactGeometry {
    /// The face's axes `(t1, t2, n)` in the columns.
    pub axes: DMat3,
    /// Node from corner a, in the face's axes \[m\].
    at: DVec3,
    /// Node from corner a, world axes \[m\].
    from_corner: DVec3,
    /// Node from its own body's G \[m\].
    pub arm: DVec3,
    /// Node from the face body's G \[m\].
    pub lever: DVec3,
    /// Corner a from the face body's G \[m\].
    corner: DVec3,
    /// Whether the face is vertical and its first tangent horizontal.
    pub upright: bool,
    /// Direction of the edge that the node is on, where the gap is the distance of its line from that of the first axis through
    /// corner a, world axes \[–\]; 0 of a node before a face.
    pub edge: DVec3,
    /// Part of the turn of the common perpendicular of both edges from the third axis by which the normal follows it \[–\].
    follow: f64,
}

impl ContactGeometry {
    /// Gap as placed \[m\].
    pub fn placed_gap(&self) -> f64 {
        self.at.z
    }

    /// Geometry of a node at `by` from this one \[m\], world axes as placed.
    #[must_use]
    pub fn shifted(&self, by: DVec3) -> Self {
        let (arm, lever, from_corner) = (self.arm + by, self.lever + by, self.from_corner + by);
        Self { at: self.at + self.axes.transpose() * by, from_corner, arm, lever, ..*self }
    }

    /// Geometry of the same node before the plane through `from`, from corner a \[m\], with these axes; world axes as
    /// placed.
    #[must_use]
    pub fn before(&self, from: DVec3, axes: DMat3) -> Self {
        let from_corner = self.from_corner - from;
        Self {
            axes,
            at: axes.transpose() * from_corner,
            from_corner,
            corner: self.corner + from,
            upright: false,
            ..*self
        }
    }

    /// Geometry of the same node as a point of an edge in this direction, world axes as placed, across the first axis; its normal
    /// follows the common perpendicular by the part `follow` \[–\].
    #[must_use]
    pub fn across(&self, edge: DVec3, follow: f64) -> Self {
        Self { edge, follow, ..*self }
    }

    /// Part of the way from the node to the anchor at which the reaction on the face's body acts, of laws along the stretch \[–\].
    #[inline]
    pub fn anchor_part(&self) -> f64 {
        1.0 - self.follow
    }

    /// Outward normal of the contact, world axes: that of the face, or the common perpendicular of two edges.
    pub fn normal(&self, node_body: &Frame, face_body: &Frame) -> DVec3 {
        if self.edge == DVec3::ZERO {
            return face_body.turn(self.axes.z_axis);
        }
        face_body.turn(self.axes * self.crossed(node_body, face_body).in_axes(DVec3::Z))
    }

    /// Turn of the normal from the third axis.
    fn crossed(&self, node_body: &Frame, face_body: &Frame) -> Crossed {
        let edge = node_body.turn(self.edge);
        Crossed::of(self.axes.transpose() * (edge + face_body.turned.transpose() * edge)).partly(self.follow)
    }

    /// Geometry with the poses of `node_body` and `face_body`, at rest, in place of the placed ones.
    #[must_use]
    pub fn seen_from(&self, node_body: &Frame, face_body: &Frame) -> Self {
        let Measured { here, arm, lever, .. } = measure(&Self { edge: DVec3::ZERO, ..*self }, node_body, face_body);
        let corner = face_body.turn(self.corner);
        Self {
            axes: face_body.rotation(&self.axes),
            at: here.at.extend(here.gap),
            from_corner: lever - corner,
            arm,
            lever,
            corner,
            upright: self.upright && face_body.level,
            edge: node_body.turn(self.edge),
            follow: self.follow,
        }
    }

    /// Geometry of `node`, a fixed point of one body, and a face of another, with position of G and axes of both as
    /// placed.
    pub fn of(node: DVec3, (node_home, node_axes): (DVec3, DMat3), face: &Face, (home, axes): (DVec3, DMat3)) -> Self {
        let (arm, corner) = (node_axes * node, axes * face.corners[0]);
        let lever = (node_home - home) + arm;
        let in_face = axes.transpose() * lever - face.corners[0];
        let along = DMat3::from_cols(face.tangent, face.bitangent, face.normal);
        let mut at = along.transpose() * in_face;
        // A gap within round-off of the placed positions is 0.
        if at.z.abs() <= PLACED_ROUNDING * (lever.length() + face.corners[0].length()) {
            at.z = 0.0;
        }
        let upright = face.is_upright();
        Self {
            axes: axes * along,
            at,
            from_corner: lever - corner,
            arm,
            lever,
            corner,
            upright,
            edge: DVec3::ZERO,
            follow: 0.0,
        }
    }
}

/// Position and velocity of a node relative to a face, in the face's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Local {
    /// Gap `g`, positive apart \[m\].
    pub gap: f64,
    /// Rate of the gap `ġ` \[m/s\].
    pub gap_rate: f64,
    /// Projection of the node, from corner a \[m\].
    pub at: DVec2,
    /// Displacement of the projection since placed, without cancellation for a small one \[m\].
    pub way: DVec2,
    /// Rate of the projection in the face's frame \[m/s\].
    pub rate: DVec2,
    /// Angular velocity of the face about its own axes `(t1, t2, n)` \[rad/s\].
    pub spin: DVec3,
}

impl Local {
    /// Penetration `δ = −g` \[m\].
    pub fn penetration(&self) -> f64 {
        -self.gap
    }

    /// Velocities `(V_t, V_n)` of (53b), relative to the anchor at `at − stretch` \[m/s\].
    pub fn relative_velocity(&self, stretch: DVec2) -> (DVec2, f64) {
        let w = self.spin;
        let tangential =
            DVec2::new(self.rate.x + w.y * self.gap - w.z * stretch.y, self.rate.y + w.z * stretch.x - w.x * self.gap);
        (tangential, self.gap_rate + w.x * stretch.y - w.y * stretch.x)
    }
}

/// A node relative to a face, with its levers from G of both bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Position and velocity in the face's axes.
    pub here: Local,
    /// Node from its own body's G, world axes \[m\].
    pub arm: DVec3,
    /// Node from the face body's G, world axes \[m\].
    pub lever: DVec3,
    /// Turn of the axes in which the position is, from the face's.
    pub crossed: Crossed,
}

/// Position and velocity of a node, a fixed point of one body, relative to a face of another.
#[inline]
pub fn locate(geometry: &ContactGeometry, node_body: &Frame, face_body: &Frame) -> Local {
    measure(geometry, node_body, face_body).here
}

/// Gap \[m\] and its rate \[m/s\] alone.
#[inline]
pub fn gap(geometry: &ContactGeometry, node_body: &Frame, face_body: &Frame) -> [f64; 2] {
    let here = measure(geometry, node_body, face_body).here;
    [here.gap, here.gap_rate]
}

/// Position, velocity and levers of a node relative to a face.
///
/// With `D` of both bodies, `e` an axis of the face as placed and `d = Δx + D_k arm − D_p corner`, the node is at
/// `e·r₀ + e·(d + D_pᵀ (r₀ + d))` from corner a, where `r₀` is its position as placed; all terms but the first are as
/// small as the motion.
#[inline]
pub fn measure(geometry: &ContactGeometry, node_body: &Frame, face_body: &Frame) -> Measured {
    if node_body.level && face_body.level && geometry.upright {
        measure_in_plan(geometry, node_body, face_body)
    } else {
        measure_in_space(geometry, node_body, face_body)
    }
}

#[inline]
fn measure_in_space(geometry: &ContactGeometry, node_body: &Frame, face_body: &Frame) -> Measured {
    let swung = node_body.turned * geometry.arm;
    let shifted = (node_body.shift - face_body.shift) + swung;
    let (arm, lever) = (geometry.arm + swung, geometry.lever + shifted);
    let velocity = node_body.velocity_at(arm) - face_body.velocity_at(lever);
    // The products with the zero rotation of an abutment are left out; the result is equal to the last bit.
    let (moved, velocity, spin) = if face_body.turned == DMat3::ZERO {
        (shifted, velocity, face_body.spin)
    } else {
        let back = face_body.turned.transpose();
        let moved = shifted - face_body.turned * geometry.corner;
        (
            moved + back * (geometry.from_corner + moved),
            velocity + back * velocity,
            face_body.spin + back * face_body.spin,
        )
    };
    let in_face =
        |v: DVec3| DVec3::new(v.dot(geometry.axes.x_axis), v.dot(geometry.axes.y_axis), v.dot(geometry.axes.z_axis));
    let (way, rate) = (in_face(moved), in_face(velocity));
    if geometry.edge != DVec3::ZERO {
        return measure_across(geometry, [node_body, face_body], [arm, lever], [way, rate]);
    }
    let here = Local {
        gap: geometry.at.z + way.z,
        gap_rate: rate.z,
        at: geometry.at.truncate() + way.truncate(),
        way: way.truncate(),
        rate: rate.truncate(),
        spin: in_face(spin),
    };
    Measured { here, arm, lever, crossed: Crossed::SQUARE }
}

/// Position and velocity of a point of an edge relative to the edge along the first axis, in axes turned about that one to the common
/// perpendicular: the gap is the distance of the lines, and the place that of their nearest points along the first axis, with the distance
/// of the node from that axis. Where the normal follows wholly both reactions act at the node, so that its velocity is that relative to
/// its own place in the face's body; else the reaction on that body acts nearer to the anchor, by the part by which it does not.
fn measure_across(
    geometry: &ContactGeometry,
    [node_body, face_body]: [&Frame; 2],
    [arm, lever]: [DVec3; 2],
    [way, rates]: [DVec3; 2],
) -> Measured {
    let in_face = |v: DVec3| geometry.axes.transpose() * (v + face_body.turned.transpose() * v);
    let crossed = geometry.crossed(node_body, face_body);
    let from = Crossed::of(geometry.axes.transpose() * geometry.edge).partly(geometry.follow).seen(geometry.at);
    let at = crossed.seen(geometry.at + way);
    let rates = crossed.rates(at, rates, in_face(node_body.spin - face_body.spin));
    let here = Local {
        gap: at.z,
        gap_rate: rates.z,
        at: DVec2::new(crossed.along(at), at.y),
        way: (at - from).truncate(),
        rate: rates.truncate(),
        spin: match geometry.anchor_part() {
            0.0 => DVec3::ZERO,
            part => crossed.seen(in_face(face_body.spin)) * part,
        },
    };
    Measured { here, arm, lever, crossed }
}

/// The sums of [`measure`] without the terms that are 0 in plane motion: equal to the last bit, at a third of the
/// operations.
#[inline]
fn measure_in_plan(geometry: &ContactGeometry, node_body: &Frame, face_body: &Frame) -> Measured {
    let times = |m: &DMat3, v: DVec3| (m.x_axis.x * v.x + m.y_axis.x * v.y, m.x_axis.y * v.x + m.y_axis.y * v.y);
    let facing = &face_body.turned;
    let back = |x: f64, y: f64| {
        (x + (facing.x_axis.x * x + facing.x_axis.y * y), y + (facing.y_axis.x * x + facing.y_axis.y * y))
    };
    let along = |(x, y): (f64, f64), axis: DVec3| x * axis.x + y * axis.y;
    let swung = times(&node_body.turned, geometry.arm);
    let between = node_body.shift - face_body.shift;
    let shifted = DVec3::new(between.x + swung.0, between.y + swung.1, between.z);
    let arm = DVec3::new(geometry.arm.x + swung.0, geometry.arm.y + swung.1, geometry.arm.z);
    let lever = geometry.lever + shifted;
    let corner = times(facing, geometry.corner);
    let (x, y) = (shifted.x - corner.0, shifted.y - corner.1);
    let (from_x, from_y) = (geometry.from_corner.x + x, geometry.from_corner.y + y);
    let moved = (
        x + (facing.x_axis.x * from_x + facing.x_axis.y * from_y),
        y + (facing.y_axis.x * from_x + facing.y_axis.y * from_y),
    );
    let (spin, turning) = (node_body.spin.z, face_body.spin.z);
    let velocity = back(
        (node_body.velocity.x - spin * arm.y) - (face_body.velocity.x - turning * lever.y),
        (node_body.velocity.y + spin * arm.x) - (face_body.velocity.y + turning * lever.x),
    );
    let [first, second, normal] = [geometry.axes.x_axis, geometry.axes.y_axis, geometry.axes.z_axis];
    let way = DVec2::new(along(moved, first), shifted.z * second.z);
    let here = Local {
        gap: geometry.at.z + along(moved, normal),
        gap_rate: along(velocity, normal),
        at: geometry.at.truncate() + way,
        way,
        rate: DVec2::new(along(velocity, first), 0.0),
        spin: DVec3::new(0.0, turning * second.z, 0.0),
    };
    Measured { here, arm, lever, crossed: Crossed::SQUARE }
}

#[cfg(test)]
mod tests;
