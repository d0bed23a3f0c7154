//! Whether a lasting contact is one face sliding along a wall, and its closed form (state e, (17)–(20)).

use glam::DVec3;

use crate::dynamics::Model;
use crate::dynamics::free_flight::sliding_face::SlidingFace;
use crate::dynamics::impact2d::delassus::centre;
use crate::dynamics::impact2d::kinematics::Kinematics;
use crate::dynamics::impact2d::lasting::constrained_motion::ContactMode;
use crate::dynamics::model::coordinates::planar::PlanarState;
use crate::motion::LinearPiece;

/// The slide of one girder whose face lies on a wall, from `state` at `t` on, for at most `longest` \[s\]; none for any
/// other lasting contact.
pub(in crate::dynamics::impact2d) fn slide_on_wall(
    model: &Model,
    (body, modes): (usize, &[ContactMode]),
    piece: &LinearPiece,
    (t, state): (f64, &PlanarState),
    longest: f64,
) -> Option<SlidingFace> {
    let [mode] = modes else { return None };
    let (Some(sign), true) = (mode.friction.slip_sign(), mode.is_flush()) else { return None };
    let (sides, girder) = (model.pairs[mode.pair].bodies, &model.bodies[body]);
    if !(sides.contains(&None) && girder.free[0] && girder.free[1]) {
        return None;
    }
    let kinematics = Kinematics::new(model, &[body], std::slice::from_ref(state), DVec3::ZERO);
    let touching = centre(&mode.points(model, &kinematics));
    // The wall's normal towards the girder, whichever side of the pair it is.
    let normal = if sides[0].is_none() { -touching.n } else { touching.n };
    let s = normal.perp();
    let felt = s + normal * (mode.friction_coefficients(&model.impact)[1] * sign);
    Some(SlidingFace::new((girder, &model.ground), [s, felt], piece, (t, state), longest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::lasting::constrained_motion::FrictionMode;
    use crate::dynamics::model::coordinates::planar::WIDTH;
    use crate::scene::presets;

    /// Whether a straight girder at its wall, with this number of kept points, has a closed form.
    fn closed_form(points: usize, friction: FrictionMode, change: impl FnOnce(&mut Model)) -> Option<SlidingFace> {
        let mut scene = presets::load("straight-abutment").expect("a preset");
        scene.abutments[0].gap = Some(0.0);
        let mut model = Model::compile(&scene).expect("a sound scene");
        change(&mut model);
        let kinematics = Kinematics::new(&model, &[0], &[[0.0; WIDTH]], DVec3::ZERO);
        let mut sites: Vec<usize> = model.pairs[0].contacts.clone().collect();
        sites.retain(|&site| kinematics.point(&model, site).gap.abs() < 1e-12);
        sites.truncate(points);
        let mode = ContactMode { pair: 0, sites, friction };
        slide_on_wall(&model, (0, &[mode]), &model.ground.piece(0), (0.0, &[0.0; WIDTH]), 1.0)
    }

    #[test]
    fn one_slipping_face_has_a_closed_form_and_nothing_else_has() {
        let slip = FrictionMode::Slip(1.0);
        assert!(closed_form(2, slip, |_| ()).is_some(), "state e");
        assert!(closed_form(2, FrictionMode::Frictionless, |_| ()).is_some(), "without friction");
        assert!(closed_form(1, slip, |_| ()).is_none(), "a corner turns");
        assert!(closed_form(2, FrictionMode::Stick, |_| ()).is_none(), "a face at rest");
        assert!(closed_form(2, slip, |model| model.bodies[0].free[1] = false).is_none(), "held along the wall");
    }
}
