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
