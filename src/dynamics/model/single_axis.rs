//! Planar motion along one world axis: whether anything but contact leads a body off it.

use glam::DMat3;

use crate::dynamics::model::body::Body;
use crate::motion::Ground;

/// Whether ground, bearings and pushes never drive a body off a world axis, 0 or 1, that it moves along.
pub(in crate::dynamics) fn keeps_to_axis(body: &Body, ground: &Ground, axis: usize) -> bool {
    let across = 1 - axis;
    let held = [!body.free[across], !body.free[5]];
    let straight = |m: &DMat3| (held[0] || m.col(axis)[across] == 0.0) && (held[1] || m.col(axis)[2] == 0.0);
    let undriven = held[0] || (ground.axis()[across] == 0.0 && body.push[across] == 0.0);
    straight(&body.planar.stiffness) && straight(&body.planar.damping) && undriven && (held[1] || body.moment.z == 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    use crate::dynamics::Model;
    use crate::scene::presets;

    #[test]
    fn a_girder_keeps_to_an_axis_unless_ground_push_or_bearings_lead_off_it() {
        let model = Model::compile(&presets::load("straight-abutment").expect("a preset")).expect("a scene");
        let (body, along_x) =
            (&model.bodies[0], Ground::Sine { amplitude: DVec3::X, quadrature: DVec3::ZERO, omega: 9.0, phase: 0.0 });
        assert!(keeps_to_axis(body, &along_x, 0), "straight bearings, shaken along x");
        assert!(!keeps_to_axis(body, &along_x, 1), "the ground drives it off y");
        let mut pushed = body.clone();
        pushed.push.y = 1.0;
        assert!(!keeps_to_axis(&pushed, &along_x, 0), "a push across");
        pushed.free[1] = false;
        assert!(keeps_to_axis(&pushed, &along_x, 0), "held across");
        let mut eccentric = body.clone();
        eccentric.planar.damping.x_axis.z = 1e-3;
        assert!(!keeps_to_axis(&eccentric, &along_x, 0), "a dashpot that turns it");
    }
}
