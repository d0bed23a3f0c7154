//! Whether a lasting contact is one face sliding along a wall, its closed form (state e, (17)–(20)), and bounds on the motion.

use glam::{DVec2, DVec3};

use crate::dynamics::Model;
use crate::dynamics::free_flight::sliding_face::SlidingFace;
use crate::dynamics::impact2d::delassus::centre;
use crate::dynamics::impact2d::kinematics::BodyKinematics;
use crate::dynamics::impact2d::lasting::constrained_motion::{ContactMode, FrictionMode};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::coordinates::planar::{self, PlanarState};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::motion::{Ground, LinearPiece};

/// The slide of one girder whose face lies on a wall, from `state` at `t` on, for at most `longest` \[s\], and bounds on it
/// while it is in sight; none for any other lasting contact.
pub(in crate::dynamics::impact2d) fn slide_on_wall(
    model: &Model,
    (body, modes): (usize, &[ContactMode]),
    piece: &LinearPiece,
    (t, state): (f64, &PlanarState),
    longest: f64,
) -> Option<(SlidingFace, MotionBounds)> {
    let [mode] = modes else { return None };
    let (Some(sign), true) = (mode.friction.slip_sign(), mode.is_flush()) else { return None };
    if let FrictionMode::SlipAtEnd { .. } = mode.friction {
        return None;
    }
    let (sides, girder) = (model.pairs[mode.pair].bodies, &model.bodies[body]);
    if !(sides.contains(&None) && girder.free[0] && girder.free[1]) {
        return None;
    }
    let kinematics = BodyKinematics::new(model, &[body], std::slice::from_ref(state), DVec3::ZERO);
    let touching = centre(&mode.points(model, &kinematics));
    // The wall's normal towards the girder, whichever side of the pair it is.
    let normal = if sides[0].is_none() { -touching.n } else { touching.n };
    let s = normal.perp();
    let felt = s + normal * (mode.friction_coefficients(&model.impact)[1] * sign);
    let slide = SlidingFace::new((girder, &model.ground), [s, felt], piece, (t, state), longest);
    let bounds = slide_bounds((girder, &model.ground), [s, felt], state, longest.min(slide.sight));
    Some((slide, bounds))
}

/// Bounds on a slide along `s` from `state` on, for `duration` \[s\]; `d` is the direction along which forces are felt.
///
/// `ü = F − γ u̇ − κ u` with `u = 0` at the start. Of `z = (ω u, u̇)`, `ω² = |κ|`, the length grows by
/// `|z|˙ ≤ |F| + β |z|`, β = ω where κ < 0, and −γ more where γ < 0. So `|z| ≤ (|u̇₀| + |F| τ) exp(β τ)` bounds `u̇` and `ω u`.
fn slide_bounds(
    (girder, ground): (&Body, &Ground),
    [s, d]: [DVec2; 2],
    state: &PlanarState,
    duration: f64,
) -> MotionBounds {
    let per_mass = |force: DVec3| d.dot(force.truncate()) / girder.mass;
    let (place, along) = (planar::positions(state), s.extend(0.0));
    let (kappa, gamma) = (per_mass(girder.planar.stiffness * along), per_mass(girder.planar.damping * along));
    let constant = per_mass(girder.push.truncate().extend(0.0) - girder.planar.stiffness * place);
    let force = constant.abs() + d.length() * ground.peak();
    let omega = kappa.abs().sqrt();
    let growth = if kappa < 0.0 { omega } else { 0.0 } + (-gamma).max(0.0);
    let start = planar::rates(state).truncate().dot(s).abs();
    let speed = (start + force * duration) * (growth * duration).exp();
    MotionBounds {
        reach: place.truncate().length() + speed * duration,
        turn: place.z.abs(),
        speed,
        acceleration: force + (omega + gamma.abs()) * speed,
        ..MotionBounds::still(f64::INFINITY)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;
    use crate::dynamics::model::coordinates::planar::WIDTH;

    /// Whether a straight girder at its wall, with this number of kept points, has a closed form.
    fn closed_form(points: usize, friction: FrictionMode, change: impl FnOnce(&mut Model)) -> Option<SlidingFace> {
        let mut model = example::at_wall(|_| ());
        change(&mut model);
        let kinematics = BodyKinematics::new(&model, &[0], &[[0.0; WIDTH]], DVec3::ZERO);
        let mut sites = example::touching(&model, &kinematics);
        sites.truncate(points);
        let mode = ContactMode { pair: 0, sites, friction };
        slide_on_wall(&model, (0, &[mode]), &model.ground.piece(0), (0.0, &[0.0; WIDTH]), 1.0).map(|(slide, _)| slide)
    }

    #[test]
    fn no_slide_is_faster_or_bends_more_than_its_bounds() {
        let mut model = example::preset("straight-abutment", |scene| scene.girders[0].push.force = [5.0, 3.0, 0.0]);
        let (s, piece) = (DVec2::from_angle(0.4), model.ground.piece(0));
        // As given, of negative stiffness along d, and of negative damping.
        for (stiffness, damping, friction) in [(1.0, 1.0, 0.2), (-1.0, 1.0, -0.7), (1.0, -1.0, 2.0)] {
            let girder = &mut model.bodies[0];
            girder.planar.stiffness *= stiffness;
            girder.planar.damping *= damping;
            let (girder, d) = (&model.bodies[0], s + s.perp() * friction);
            let start = [0.01, -0.02, 0.0, 0.3 * s.x, 0.3 * s.y, 0.0];
            let slide = SlidingFace::new((girder, &model.ground), [s, d], &piece, (0.0, &start), 1.0);
            let bounds = slide_bounds((girder, &model.ground), [s, d], &start, slide.sight);
            let along = |t: f64| planar::rates(&slide.state(t)).truncate().dot(s);
            let h = 1e-6 * slide.sight;
            let mut largest = [0.0f64; 3];
            for k in 1..1000 {
                let t = slide.sight * f64::from(k) / 1000.0;
                let reached = planar::positions(&slide.state(t)).truncate().length();
                let acceleration = (along(t + h) - along(t - h)) / (2.0 * h);
                let now = [reached, along(t).abs(), acceleration.abs()];
                largest = std::array::from_fn(|i| largest[i].max(now[i]));
            }
            let bounds = [bounds.reach, bounds.speed, bounds.acceleration];
            for (now, bound) in largest.into_iter().zip(bounds) {
                assert!(now <= bound * (1.0 + 1e-6), "{stiffness}, {damping}: {largest:?} against {bounds:?}");
            }
        }
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
