//! Yaw, pitch and roll (`docs/physics.md#motion-in-space`): a girder whose axes as placed are the columns of `A` has them at
//! `R_z(ψ) A R_y(pitch) R_x(roll)`.

use glam::{DMat3, DQuat, DVec3};

/// Rotation since placed, world axes, by roll, pitch and yaw \[rad\].
pub(in crate::dynamics) fn turned(axes: DMat3, [roll, pitch, yaw]: [f64; 3]) -> DQuat {
    let yawed = DQuat::from_rotation_z(yaw);
    if roll == 0.0 && pitch == 0.0 {
        return yawed;
    }
    let placed = DQuat::from_mat3(&axes);
    yawed * placed * (DQuat::from_rotation_y(pitch) * DQuat::from_rotation_x(roll)) * placed.inverse()
}

/// Angular velocity in the world by the rates of roll, pitch and yaw \[rad/s\] at these angles \[rad\]: the yaw turns about the
/// vertical, the pitch about the transverse axis after the yaw, the roll about the girder's axis.
pub(in crate::dynamics) fn angular_velocity(axes: DMat3, [pitch, yaw]: [f64; 2], rates: [f64; 3]) -> DVec3 {
    let [roll_rate, pitch_rate, yaw_rate] = rates;
    if roll_rate == 0.0 && pitch_rate == 0.0 {
        return DVec3::new(0.0, 0.0, yaw_rate);
    }
    let yawed = DMat3::from_rotation_z(yaw) * axes;
    let axis = yawed * (DMat3::from_rotation_y(pitch) * DVec3::X);
    DVec3::Z * yaw_rate + yawed.y_axis * pitch_rate + axis * roll_rate
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angular_velocity_is_the_rate_of_the_rotation() {
        let axes = DMat3::from_rotation_z(0.7);
        let (angles, rates, dt) = ([0.3, -0.5, 1.1], [0.4, 0.9, -0.6], 1e-6);
        let at = |t: f64| turned(axes, std::array::from_fn(|i| angles[i] + rates[i] * t));
        let change = (at(dt) * at(-dt).inverse()).to_scaled_axis() / (2.0 * dt);
        let spin = angular_velocity(axes, [angles[1], angles[2]], rates);
        assert!((change - spin).length() < 1e-9, "{change} against {spin}");
    }

    #[test]
    fn pitch_lowers_the_plus_end_and_roll_raises_the_left_side() {
        let axes = DMat3::from_rotation_z(0.7);
        let here = DMat3::from_quat(turned(axes, [0.2, 0.1, 0.4])) * axes;
        assert!((here.x_axis.z + 0.1f64.sin()).abs() < 1e-15, "axis {}", here.x_axis);
        assert!((here.y_axis.z - 0.2f64.sin() * 0.1f64.cos()).abs() < 1e-15, "transverse {}", here.y_axis);
        let heading = here.x_axis.y.atan2(here.x_axis.x);
        assert!((heading - 1.1).abs() < 1e-15, "yaw after the heading: {heading}");
    }
}
