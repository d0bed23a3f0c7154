//! Where a node is relative to a face (paper equations (52), (53)).
//!
//! Everything is measured in the face's axes `(t1, t2, n)`, origin at its corner a, so that a law never sees a body.
//! Velocities come twice: the rate of the node's coordinates in the face's frame, and `V = V_k − V_p` (53b), taken at the
//! point p of the face that holds the node; on a turning face the two differ by `ω × (X_k − X_p)`.

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::geometry::Face;

/// A gap as placed is none below this part of the levers that it is the difference of.
const PLACED: f64 = 4.0 * f64::EPSILON;

/// Pose and twist of a body, all in the world frame.
///
/// Place and attitude are kept as what they were as placed and what came since: their sum would round away the last digits
/// of a gap, which is as small against the girder as what came since.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Where G was placed \[m\].
    pub home: DVec3,
    /// Displacement of G since \[m\].
    pub shift: DVec3,
    /// What it has turned since, less the identity: `D` of `R = (1 + D) R₀`.
    pub turned: DMat3,
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
        Self { home, shift: still, turned: DMat3::ZERO, velocity: still, spin: still, level: true }
    }

    /// Where G is \[m\].
    pub fn origin(&self) -> DVec3 {
        self.home + self.shift
    }

    /// A vector that turns with the body, from what it was as placed.
    #[inline]
    pub fn turn(&self, placed: DVec3) -> DVec3 {
        placed + self.turned * placed
    }

    /// Body axes in the columns, from what they were as placed.
    #[inline]
    pub fn rotation(&self, placed: &DMat3) -> DMat3 {
        *placed + self.turned * *placed
    }

    /// How far a point at this distance from G has come since it was placed, at most \[m\].
    pub fn moved(&self, arm: f64) -> f64 {
        // Columns of D have the length of a chord, but for that along the axis.
        let [x, y, z] = [self.turned.x_axis, self.turned.y_axis, self.turned.z_axis];
        let chord2 = 0.5 * (x.length_squared() + y.length_squared() + z.length_squared());
        self.shift.length() + chord2.sqrt() * arm
    }

    /// How fast it is at most \[m/s\].
    pub fn speed(&self, arm: f64) -> f64 {
        self.velocity.length() + self.spin.length() * arm
    }

    /// World velocity of what is at `arm` from G and turns with the body \[m/s\].
    pub fn velocity_at(&self, arm: DVec3) -> DVec3 {
        self.velocity + self.spin.cross(arm)
    }
}

/// The rotation of a unit quaternion less the identity, exact to the last digits of a small one.
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

/// A node and a face as placed, world axes: what their motion since is counted from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Home {
    /// The face's axes `(t1, t2, n)` in the columns.
    pub axes: DMat3,
    /// The node in them, from corner a \[m\].
    at: DVec3,
    /// Node from corner a \[m\].
    apart: DVec3,
    /// Node from its own body's G \[m\].
    pub arm: DVec3,
    /// Node from the face body's G \[m\].
    pub lever: DVec3,
    /// Corner a from the face body's G \[m\].
    corner: DVec3,
    /// Whether the face stands upright, its first tangent level.
    pub upright: bool,
}

impl Home {
    /// `g` \[m\].
    pub fn gap(&self) -> f64 {
        self.at.z
    }

    /// The same as if both had been placed where they are in these poses, which do not move.
    #[must_use]
    pub fn seen_from(&self, node_body: &Frame, face_body: &Frame) -> Self {
        let Measured { here, arm, apart } = measure(self, node_body, face_body);
        let corner = face_body.turn(self.corner);
        Self {
            axes: face_body.rotation(&self.axes),
            at: here.at.extend(here.gap),
            apart: apart - corner,
            arm,
            lever: apart,
            corner,
            upright: self.upright && face_body.level,
        }
    }

    /// The same with the node there, in the face's axes from corner a \[m\].
    #[must_use]
    pub fn with_node(self, at: DVec3) -> Self {
        Self { at, ..self }
    }

    /// Of `node`, a fixed point of one body, and a face of another, with where both were placed and their axes there.
    pub fn of(node: DVec3, (node_home, node_axes): (DVec3, DMat3), face: &Face, (home, axes): (DVec3, DMat3)) -> Self {
        let (arm, corner) = (node_axes * node, axes * face.corners[0]);
        let lever = (node_home - home) + arm;
        let in_face = axes.transpose() * lever - face.corners[0];
        let along = DMat3::from_cols(face.tangent, face.bitangent, face.normal);
        let mut at = along.transpose() * in_face;
        // What is placed on a face is on it: its places' rounding is no gap.
        if at.z.abs() <= PLACED * (lever.length() + face.corners[0].length()) {
            at.z = 0.0;
        }
        Self { axes: axes * along, at, apart: lever - corner, arm, lever, corner, upright: face.is_upright() }
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
    /// How far that is from where it was as placed, exact to the last digits of a small way \[m\].
    pub way: DVec2,
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
pub fn locate(home: &Home, node_body: &Frame, face_body: &Frame) -> Local {
    measure(home, node_body, face_body).here
}

/// The gap and its rate alone.
#[inline]
pub fn gap(home: &Home, node_body: &Frame, face_body: &Frame) -> [f64; 2] {
    let here = measure(home, node_body, face_body).here;
    [here.gap, here.gap_rate]
}

/// The same, with the node's levers.
///
/// With `D` of both bodies, `e` an axis of the face as placed and `d = Δx + D_k arm − D_p corner`, the node is at
/// `e·r₀ + e·(d + D_pᵀ (r₀ + d))` from corner a, where `r₀` is what it was: all but the first is as small as the motion.
#[inline]
pub fn measure(home: &Home, node_body: &Frame, face_body: &Frame) -> Measured {
    if node_body.level && face_body.level && home.upright {
        measure_in_plan(home, node_body, face_body)
    } else {
        measure_in_space(home, node_body, face_body)
    }
}

#[inline]
fn measure_in_space(home: &Home, node_body: &Frame, face_body: &Frame) -> Measured {
    let swung = node_body.turned * home.arm;
    let shifted = (node_body.shift - face_body.shift) + swung;
    let (arm, apart) = (home.arm + swung, home.lever + shifted);
    let velocity = node_body.velocity_at(arm) - face_body.velocity_at(apart);
    // An abutment does not turn: the products with 0 left out, not a bit differs.
    let (moved, velocity, spin) = if face_body.turned == DMat3::ZERO {
        (shifted, velocity, face_body.spin)
    } else {
        let back = face_body.turned.transpose();
        let moved = shifted - face_body.turned * home.corner;
        (moved + back * (home.apart + moved), velocity + back * velocity, face_body.spin + back * face_body.spin)
    };
    let in_face = |v: DVec3| DVec3::new(v.dot(home.axes.x_axis), v.dot(home.axes.y_axis), v.dot(home.axes.z_axis));
    let (way, rate) = (in_face(moved), in_face(velocity));
    let here = Local {
        gap: home.at.z + way.z,
        gap_rate: rate.z,
        at: home.at.truncate() + way.truncate(),
        way: way.truncate(),
        rate: rate.truncate(),
        spin: in_face(spin),
    };
    Measured { here, arm, apart }
}

/// The same sums without the terms that are 0 between upright bodies: not a bit differs, at a third of the work.
#[inline]
fn measure_in_plan(home: &Home, node_body: &Frame, face_body: &Frame) -> Measured {
    let times = |m: &DMat3, v: DVec3| (m.x_axis.x * v.x + m.y_axis.x * v.y, m.x_axis.y * v.x + m.y_axis.y * v.y);
    let facing = &face_body.turned;
    let back = |x: f64, y: f64| {
        (x + (facing.x_axis.x * x + facing.x_axis.y * y), y + (facing.y_axis.x * x + facing.y_axis.y * y))
    };
    let along = |(x, y): (f64, f64), axis: DVec3| x * axis.x + y * axis.y;
    let swung = times(&node_body.turned, home.arm);
    let between = node_body.shift - face_body.shift;
    let shifted = DVec3::new(between.x + swung.0, between.y + swung.1, between.z);
    let arm = DVec3::new(home.arm.x + swung.0, home.arm.y + swung.1, home.arm.z);
    let apart = home.lever + shifted;
    let corner = times(facing, home.corner);
    let (x, y) = (shifted.x - corner.0, shifted.y - corner.1);
    let (from_x, from_y) = (home.apart.x + x, home.apart.y + y);
    let moved = (
        x + (facing.x_axis.x * from_x + facing.x_axis.y * from_y),
        y + (facing.y_axis.x * from_x + facing.y_axis.y * from_y),
    );
    let (spin, turning) = (node_body.spin.z, face_body.spin.z);
    let velocity = back(
        (node_body.velocity.x - spin * arm.y) - (face_body.velocity.x - turning * apart.y),
        (node_body.velocity.y + spin * arm.x) - (face_body.velocity.y + turning * apart.x),
    );
    let [first, second, normal] = [home.axes.x_axis, home.axes.y_axis, home.axes.z_axis];
    let way = DVec2::new(along(moved, first), shifted.z * second.z);
    let here = Local {
        gap: home.at.z + along(moved, normal),
        gap_rate: along(velocity, normal),
        at: home.at.truncate() + way,
        way,
        rate: DVec2::new(along(velocity, first), 0.0),
        spin: DVec3::new(0.0, turning * second.z, 0.0),
    };
    Measured { here, arm, apart }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body turned by `turn` about the vertical since it was placed, moving in plan.
    fn body(home: DVec3, turn: f64, spin: f64) -> Frame {
        Frame {
            shift: DVec3::new(0.013, -0.021, 0.0),
            turned: turned_by(DQuat::from_rotation_z(turn)),
            velocity: DVec3::new(0.3, -0.7, 0.0),
            spin: DVec3::Z * spin,
            ..Frame::fixed(home)
        }
    }

    fn face() -> Face {
        let quad = [(0.5, -0.4, -0.1), (0.7, 0.3, -0.1), (0.7, 0.3, 0.2), (0.5, -0.4, 0.2)];
        Face::new(quad.map(DVec3::from), 1.0).expect("a rectangle")
    }

    const NODE: DVec3 = DVec3::new(-0.4, 0.31, 0.02);

    #[test]
    fn in_plan_every_number_is_that_of_space() {
        let face = face();
        assert!(face.is_upright(), "{face:?}");
        for turn in [0.0, 0.1, -0.37, 1.9] {
            let owner = body(DVec3::new(1.1, 0.2, 0.05), turn, 0.9);
            let other = body(DVec3::ZERO, 0.7 * turn, -2.3);
            let home = Home::of(NODE, (owner.home, DMat3::IDENTITY), &face, (other.home, DMat3::IDENTITY));
            let (plan, space) = (measure_in_plan(&home, &owner, &other), measure_in_space(&home, &owner, &other));
            assert_eq!(plan, space, "turned by {turn}");
        }
    }

    #[test]
    fn counted_from_home_a_node_is_where_it_is() {
        let face = face();
        for (heading, turn) in [(0.3, 1e-9), (-1.2, 0.4), (2.9, -2.0)] {
            let owner = body(DVec3::new(1.1, 0.2, 0.05), turn, 0.9);
            let other = body(DVec3::new(0.1, -0.3, 0.0), 0.7 * turn, -2.3);
            let [node_axes, face_axes] = [heading, 1.7 * heading].map(DMat3::from_rotation_z);
            let home = Home::of(NODE, (owner.home, node_axes), &face, (other.home, face_axes));
            let there = measure(&home, &owner, &other);
            let [turned, facing] = [owner.rotation(&node_axes), other.rotation(&face_axes)];
            let place = owner.origin() + turned * NODE;
            let apart = place - (other.origin() + facing * face.corners[0]);
            let axes = [face.tangent, face.bitangent, face.normal].map(|axis| facing * axis);
            let plain = DVec3::from_array(axes.map(|axis| apart.dot(axis)));
            let found = there.here.at.extend(there.here.gap);
            assert!((found - plain).length() < 1e-14, "{found} against {plain}");
            assert!((there.apart - (place - other.origin())).length() < 1e-14, "its levers");
            let speed = owner.velocity_at(there.arm) - other.velocity_at(there.apart);
            let rates = there.here.rate.extend(there.here.gap_rate);
            assert!((rates - DVec3::from_array(axes.map(|axis| speed.dot(axis)))).length() < 1e-14, "its rates");
        }
    }

    #[test]
    fn what_is_placed_on_a_face_is_on_it() {
        // 0.1 + 0.2 is not 0.3: two girders in a row end to end.
        let quad = [(0.0, -1.0, -1.0), (0.0, 1.0, -1.0), (0.0, 1.0, 1.0), (0.0, -1.0, 1.0)];
        let face = Face::new(quad.map(|(x, y, z)| DVec3::new(0.3 + x, y, z)), 1.0).expect("a square");
        let axes = DMat3::IDENTITY;
        let gap = |x: f64| Home::of(DVec3::X * 0.2, (DVec3::X * x, axes), &face, (DVec3::ZERO, axes)).gap();
        assert_ne!(0.1 + 0.2, 0.3, "rounding is there");
        assert_eq!(gap(0.1), 0.0, "and is no gap");
        assert!((gap(0.1 + 1e-14) - 1e-14).abs() < 1e-16, "a small gap is one: {:e}", gap(0.1 + 1e-14));
    }

    #[test]
    fn a_small_motion_moves_the_gap_by_its_own_last_digit() {
        // As far apart as the bodies are wide, the sum of places would know 1e-16 m.
        let face = face();
        let still = Frame::fixed(DVec3::ZERO);
        let placed = Frame::fixed(DVec3::new(9.0, 0.4, 0.0));
        let home = Home::of(NODE, (placed.home, DMat3::IDENTITY), &face, (still.home, DMat3::IDENTITY));
        let shift = 1e-12;
        let before = Home { at: DVec3::ZERO, ..home };
        let moved = Frame { shift: face.normal * shift, ..placed };
        let step = locate(&before, &moved, &still).gap;
        assert!((step - shift).abs() < 4e-16 * shift, "{step:e}");
        let turn = 1e-11;
        let turned = turned_by(DQuat::from_xyzw(0.0, 0.0, 0.5 * turn, 1.0));
        let spun = Frame { turned, ..placed };
        let step = locate(&before, &spun, &still).gap;
        let swung = turn * DVec3::Z.cross(NODE).dot(face.normal);
        assert!((step - swung).abs() < 1e-10 * swung.abs(), "{step:e} against {swung:e}, to second order");
    }
}
