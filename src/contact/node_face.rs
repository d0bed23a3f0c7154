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
}

impl Frame {
    /// A frame at rest in the ground, world axes, about `home`.
    pub fn fixed(home: DVec3) -> Self {
        Self { home, shift: DVec3::ZERO, rotation: DMat3::IDENTITY, velocity: DVec3::ZERO, spin: DVec3::ZERO }
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

/// Measures a node, a fixed point of one body, against a face of another.
#[inline]
pub fn locate(node: DVec3, node_body: &Frame, face: &Face, face_body: &Frame) -> Local {
    let arm = node_body.rotation * node;
    let apart = (node_body.home - face_body.home) + (node_body.shift - face_body.shift) + arm;
    let to_face = face_body.rotation.transpose();
    let from_corner = to_face * apart - face.corners[0];
    let velocity = to_face * (node_body.velocity_at(arm) - face_body.velocity_at(apart));
    let spin = to_face * face_body.spin;
    Local {
        gap: from_corner.dot(face.normal),
        gap_rate: velocity.dot(face.normal),
        at: DVec2::new(from_corner.dot(face.tangent), from_corner.dot(face.bitangent)),
        rate: DVec2::new(velocity.dot(face.tangent), velocity.dot(face.bitangent)),
        spin: DVec3::new(spin.dot(face.tangent), spin.dot(face.bitangent), spin.dot(face.normal)),
    }
}
