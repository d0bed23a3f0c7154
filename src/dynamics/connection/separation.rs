//! Kinematics of a connection: its first point against its second.

use glam::{DMat3, DVec3};

use crate::contact::Frame;

/// Motion of the first point of a connection against the second, in the connection's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Separation {
    /// Vector from the second point to the first as placed \[m\].
    pub placed: DVec3,
    /// Its change since \[m\].
    pub moved: DVec3,
    /// Rate of that change \[m/s\].
    pub rate: DVec3,
}

impl Separation {
    /// Vector from the second point to the first \[m\].
    pub fn vector(&self) -> DVec3 {
        self.placed + self.moved
    }

    /// Of two points at `arms` from G as placed, world axes, of bodies in these poses; then the arms as they are now. `placed`
    /// and the result are in `axes`, whose columns are in the world.
    pub fn between(frames: [&Frame; 2], arms: [DVec3; 2], placed: DVec3, axes: &DMat3) -> (Self, [DVec3; 2]) {
        let [(moved, rate, arm), (other_moved, other_rate, other_arm)] = [0, 1].map(|i| {
            let (frame, arm) = (frames[i], arms[i]);
            let turned = frame.turned * arm;
            let now = arm + turned;
            (frame.shift + turned, frame.velocity_at(now), now)
        });
        let into_axes = axes.transpose();
        let separation =
            Self { placed, moved: into_axes * (moved - other_moved), rate: into_axes * (rate - other_rate) };
        (separation, [arm, other_arm])
    }

    /// The same, linear in the rotations about the vertical, with the arms as placed.
    fn linear(frames: [&Frame; 2], arms: [DVec3; 2], placed: DVec3, axes: &DMat3) -> (Self, [DVec3; 2]) {
        let [(moved, rate), (other_moved, other_rate)] = [0, 1].map(|i| {
            let frame = frames[i];
            let across = DVec3::Z.cross(arms[i]);
            (frame.shift + across * frame.heading, frame.velocity + across * frame.spin.z)
        });
        let separation = Self {
            placed,
            moved: axes.mul_transpose_vec3(moved - other_moved),
            rate: axes.mul_transpose_vec3(rate - other_rate),
        };
        (separation, arms)
    }
}

/// Measure of the motion of the first point relative to the second.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kinematics {
    /// Points at their true places, axes fixed in the world.
    #[default]
    Points,
    /// Points at their true places, axes that turn with the body of the second point.
    Carried,
    /// Linear in the rotation about the vertical, arms as placed: planar bearings (`docs/physics.md#bearings`).
    Linear,
}

impl Kinematics {
    /// Motion of two points at `arms` from G as placed, world axes, of bodies in these poses, and the arms from both G to
    /// the point at which the force acts: the first point for both bodies, so that force and reaction share one line.
    /// `placed` and the motion are in `axes`, whose columns are in the world as placed.
    pub fn motion(
        self,
        frames: [&Frame; 2],
        arms: [DVec3; 2],
        placed: DVec3,
        axes: &DMat3,
    ) -> (Separation, [DVec3; 2]) {
        if self == Self::Linear {
            return Separation::linear(frames, arms, placed, axes);
        }
        let (separation, [arm, other]) = Separation::between(frames, arms, placed, axes);
        let apart = axes * separation.vector();
        let reaction = other + apart;
        if self == Self::Points || frames[1].turned == DMat3::ZERO && frames[1].spin == DVec3::ZERO {
            return (separation, [arm, reaction]);
        }
        // R = 1 + D of the second body: Rᵀ (p + Δ) − p = Dᵀ (p + Δ) + Δ.
        let (back, into_axes) = (frames[1].turned.transpose(), axes.transpose());
        let moved = into_axes * (back * apart) + separation.moved;
        let rate = axes * separation.rate - frames[1].spin.cross(apart);
        (Separation { placed, moved, rate: into_axes * (rate + back * rate) }, [arm, reaction])
    }

    /// A vector of the connection's axes in the world.
    pub fn in_world(self, axes: &DMat3, second: &Frame, vector: DVec3) -> DVec3 {
        let placed = axes * vector;
        if self == Self::Carried { second.turn(placed) } else { placed }
    }
}

/// Upper bounds on the motion of a connection's first point against its second over a stretch of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeparationBounds {
    /// Distance \[m\].
    pub distance: f64,
    /// Relative speed \[m/s\].
    pub speed: f64,
    /// Relative acceleration \[m/s²\].
    pub acceleration: f64,
}

impl SeparationBounds {
    /// Bounds in axes that turn with bounds `spin` \[rad/s\] and `spin_rate` \[rad/s²\]: of `Rᵀ x` with the first and second derivatives
    /// `Rᵀ(ẋ − ω×x)` and `Rᵀ(ẍ − 2ω×ẋ − ω̇×x + ω×(ω×x))`.
    #[must_use]
    pub fn carried(&self, spin: f64, spin_rate: f64) -> Self {
        let Self { distance, speed, acceleration } = *self;
        let turning = (spin_rate + spin * spin) * distance;
        Self { distance, speed: speed + spin * distance, acceleration: acceleration + 2.0 * spin * speed + turning }
    }
}

/// Upper bounds of how far the motion of a connection's first point against its second departs from what it is at the start of a
/// stretch of time, in the connection's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excursion {
    /// Displacement \[m\].
    pub way: f64,
    /// Integral of the magnitude of the relative acceleration, which the rate changes by at most \[m/s\].
    pub rate: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_two_turning_bodies_move_as_finite_differences_say() {
        let axes = DMat3::from_rotation_z(0.7);
        let arms = [DVec3::new(2.0, 0.5, 0.3), DVec3::new(-1.0, 0.2, 0.0)];
        let placed = DVec3::new(0.4, -0.1, 0.2);
        let pose = |i: usize, t: f64| {
            let (velocity, spin) = [(DVec3::new(0.3, -0.2, 0.0), 0.5), (DVec3::new(-0.1, 0.4, 0.0), -0.8)][i];
            let turned = DMat3::from_rotation_z(spin * t) - DMat3::IDENTITY;
            Frame { shift: velocity * t, turned, velocity, spin: DVec3::Z * spin, ..Frame::fixed(DVec3::ZERO) }
        };
        let at = |t: f64| Separation::between([&pose(0, t), &pose(1, t)], arms, placed, &axes).0;
        let (here, dt) = (at(0.4), 1e-6);
        let rate = (at(0.4 + dt).moved - at(0.4 - dt).moved) / (2.0 * dt);
        assert!((here.rate - rate).length() < 1e-8, "{} against {rate}", here.rate);
        assert_eq!(at(0.0).moved, DVec3::ZERO, "as placed nothing has moved");
        assert_eq!(at(0.0).vector(), placed);
    }
}
