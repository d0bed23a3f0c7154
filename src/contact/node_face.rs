//! Where a node is relative to a face (paper equations (52), (53)).
//!
//! Everything is measured in the face's axes `(t1, t2, n)`, origin at its corner a, so that a law never sees a body.
//! Velocities come twice: the rate of the node's coordinates in the face's frame, and `V = V_k − V_p` (53b), taken at the
//! point p of the face that holds the node; on a turning face the two differ by `ω × (X_k − X_p)`.

use glam::{DMat3, DVec2, DVec3};

use crate::geometry::Face;

/// Pose and twist of a body, all in the world frame.
///
/// The place is kept as home and displacement: their sum far from the origin would round away the gap's last digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Where G was placed \[m\].
    pub home: DVec3,
    /// Displacement of G since \[m\].
    pub shift: DVec3,
    /// Body axes in the columns.
    pub rotation: DMat3,
    /// Velocity of G \[m/s\].
    pub velocity: DVec3,
    /// Angular velocity \[rad/s\].
    pub spin: DVec3,
    /// Whether it stands upright and moves in plan only: no roll, no pitch, no vertical velocity.
    pub level: bool,
}

impl Frame {
    /// A frame at rest in the ground, world axes, about `home`.
    pub fn fixed(home: DVec3) -> Self {
        let still = DVec3::ZERO;
        Self { home, shift: still, rotation: DMat3::IDENTITY, velocity: still, spin: still, level: true }
    }

    /// Where G is \[m\].
    pub fn origin(&self) -> DVec3 {
        self.home + self.shift
    }

    /// World place of a body point \[m\].
    pub fn place(&self, point: DVec3) -> DVec3 {
        self.origin() + self.rotation * point
    }

    /// World velocity of what is at `arm` from G and turns with the body \[m/s\].
    pub fn velocity_at(&self, arm: DVec3) -> DVec3 {
        self.velocity + self.spin.cross(arm)
    }
}

/// A node relative to a face, in the face's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Local {
    /// `g`, positive apart \[m\].
    pub gap: f64,
    /// `ġ` \[m/s\].
    pub gap_rate: f64,
    /// Projection of the node, from corner a \[m\].
    pub at: DVec2,
    /// Its rate in the face's frame \[m/s\].
    pub rate: DVec2,
    /// Angular velocity of the face about its own axes `(t1, t2, n)` \[rad/s\].
    pub spin: DVec3,
}

impl Local {
    /// `δ = −g` \[m\].
    pub fn penetration(&self) -> f64 {
        -self.gap
    }

    /// `(V_t, V_n)` of (53b) with the holding point at `at − stretch` \[m/s\].
    pub fn relative_velocity(&self, stretch: DVec2) -> (DVec2, f64) {
        let w = self.spin;
        let tangential =
            DVec2::new(self.rate.x + w.y * self.gap - w.z * stretch.y, self.rate.y + w.z * stretch.x - w.x * self.gap);
        (tangential, self.gap_rate + w.x * stretch.y - w.y * stretch.x)
    }
}

/// A node against a face, and where it is from either body's G.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// In the face's axes.
    pub here: Local,
    /// Node from its own body's G, world axes \[m\].
    pub arm: DVec3,
    /// Node from the face body's G, world axes \[m\].
    pub apart: DVec3,
}

/// Measures a node, a fixed point of one body, against a face of another.
#[inline]
pub fn locate(node: DVec3, node_body: &Frame, face: &Face, face_body: &Frame) -> Local {
    measure(node, node_body, face, face_body).here
}

/// The gap and its rate alone.
#[inline]
pub fn gap(node: DVec3, node_body: &Frame, face: &Face, face_body: &Frame) -> [f64; 2] {
    let here = measure(node, node_body, face, face_body).here;
    [here.gap, here.gap_rate]
}

/// The same, with the node's levers.
#[inline]
pub fn measure(node: DVec3, node_body: &Frame, face: &Face, face_body: &Frame) -> Measured {
    if node_body.level && face_body.level && face.is_upright() {
        measure_in_plan(node, node_body, face, face_body)
    } else {
        measure_in_space(node, node_body, face, face_body)
    }
}

#[inline]
fn measure_in_space(node: DVec3, node_body: &Frame, face: &Face, face_body: &Frame) -> Measured {
    let arm = node_body.rotation * node;
    let apart = (node_body.home - face_body.home) + (node_body.shift - face_body.shift) + arm;
    let velocity = node_body.velocity_at(arm) - face_body.velocity_at(apart);
    // An abutment's axes are the world's: the products with 0 and 1 left out, not a bit differs.
    let (place, velocity, spin) = if face_body.rotation == DMat3::IDENTITY {
        (apart, velocity, face_body.spin)
    } else {
        let to_face = face_body.rotation.transpose();
        (to_face * apart, to_face * velocity, to_face * face_body.spin)
    };
    let from_corner = place - face.corners[0];
    let here = Local {
        gap: from_corner.dot(face.normal),
        gap_rate: velocity.dot(face.normal),
        at: DVec2::new(from_corner.dot(face.tangent), from_corner.dot(face.bitangent)),
        rate: DVec2::new(velocity.dot(face.tangent), velocity.dot(face.bitangent)),
        spin: DVec3::new(spin.dot(face.tangent), spin.dot(face.bitangent), spin.dot(face.normal)),
    };
    Measured { here, arm, apart }
}

/// The same sums without the terms that are 0 between upright bodies: not a bit differs, at a third of the work.
#[inline]
fn measure_in_plan(node: DVec3, node_body: &Frame, face: &Face, face_body: &Frame) -> Measured {
    let (turned, facing) = (&node_body.rotation, &face_body.rotation);
    let arm = DVec3::new(
        turned.x_axis.x * node.x + turned.y_axis.x * node.y,
        turned.x_axis.y * node.x + turned.y_axis.y * node.y,
        node.z,
    );
    let apart = (node_body.home - face_body.home) + (node_body.shift - face_body.shift) + arm;
    let to_face =
        |x: f64, y: f64| (facing.x_axis.x * x + facing.x_axis.y * y, facing.y_axis.x * x + facing.y_axis.y * y);
    let along = |(x, y): (f64, f64), axis: DVec3| x * axis.x + y * axis.y;
    let (x, y) = to_face(apart.x, apart.y);
    let from_corner = (x - face.corners[0].x, y - face.corners[0].y);
    let (spin, turning) = (node_body.spin.z, face_body.spin.z);
    let velocity = to_face(
        (node_body.velocity.x - spin * arm.y) - (face_body.velocity.x - turning * apart.y),
        (node_body.velocity.y + spin * arm.x) - (face_body.velocity.y + turning * apart.x),
    );
    let here = Local {
        gap: along(from_corner, face.normal),
        gap_rate: along(velocity, face.normal),
        at: DVec2::new(along(from_corner, face.tangent), (apart.z - face.corners[0].z) * face.bitangent.z),
        rate: DVec2::new(along(velocity, face.tangent), 0.0),
        spin: DVec3::new(0.0, turning * face.bitangent.z, 0.0),
    };
    Measured { here, arm, apart }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body turned by `turn` about the vertical, moving in plan.
    fn body(home: DVec3, turn: f64, spin: f64) -> Frame {
        Frame {
            home,
            shift: DVec3::new(0.013, -0.021, 0.0),
            rotation: DMat3::from_rotation_z(turn),
            velocity: DVec3::new(0.3, -0.7, 0.0),
            spin: DVec3::Z * spin,
            level: true,
        }
    }

    #[test]
    fn in_plan_every_number_is_that_of_space() {
        let quad = [(0.5, -0.4, -0.1), (0.7, 0.3, -0.1), (0.7, 0.3, 0.2), (0.5, -0.4, 0.2)];
        let face = Face::new(quad.map(DVec3::from), 1.0).expect("a rectangle");
        assert!(face.is_upright(), "{face:?}");
        for turn in [0.0, 0.1, -0.37, 1.9] {
            let (owner, other) = (body(DVec3::new(1.1, 0.2, 0.05), turn, 0.9), body(DVec3::ZERO, 0.7 * turn, -2.3));
            let node = DVec3::new(-0.4, 0.31, 0.02);
            let (plan, space) =
                (measure_in_plan(node, &owner, &face, &other), measure_in_space(node, &owner, &face, &other));
            assert_eq!(plan, space, "turned by {turn}");
        }
    }
}
