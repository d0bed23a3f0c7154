//! Poses, velocities and free accelerations of a set of bodies at an instant.
//!
//! Free accelerations are those of (1) without contact forces: bearings, pushes and ground.

use glam::DVec3;

use crate::contact::Frame;
use crate::dynamics::impact2d::InlineVec;
use crate::dynamics::impact2d::constants::IMPACT_FORCE_ROUNDING;
use crate::dynamics::impact2d::delassus::{Cluster, ContactPoint, inverse_mass, rates};
use crate::dynamics::model::coordinates::planar::{self, PlanarState, WIDTH};
use crate::dynamics::model::wrench::Wrench;
use crate::dynamics::{Body, Model};
use crate::motion::{Ground, LinearPiece};

/// Bodies at an instant. A *place* is the position of a body in these lists.
#[derive(Clone, Debug)]
pub struct BodyKinematics {
    /// Numbers in the model, rising.
    pub bodies: InlineVec<usize>,
    /// Poses.
    pub frames: InlineVec<Frame>,
    /// Inverse masses and velocities.
    pub cluster: Cluster,
    /// `(ẍ, ÿ, θ̈)` without contact forces \[m/s²\], \[rad/s²\].
    pub free: InlineVec<DVec3>,
    /// Sum of the magnitudes of the terms of `free` at the farthest corner, by which it rounds \[m/s²\].
    pub sizes: InlineVec<f64>,
}

impl BodyKinematics {
    /// Bodies in these states under this acceleration of the ground \[m/s²\].
    pub fn new(model: &Model, bodies: &[usize], states: &[PlanarState], ground: DVec3) -> Self {
        let mut kinematics = Self {
            bodies: bodies.into(),
            frames: InlineVec::with_capacity(bodies.len()),
            cluster: Cluster {
                inverse: bodies.iter().map(|&b| inverse_mass(&model.bodies[b])).collect(),
                velocity: InlineVec::with_capacity(bodies.len()),
            },
            free: InlineVec::with_capacity(bodies.len()),
            sizes: InlineVec::with_capacity(bodies.len()),
        };
        for (&number, state) in bodies.iter().zip(states) {
            let body = &model.bodies[number];
            let mut rate = [0.0; WIDTH];
            planar::slope(body, state, &Wrench::default(), ground, &mut rate);
            kinematics.frames.push(body.planar_frame(state));
            kinematics.cluster.velocity.push(rates(state));
            kinematics.free.push(planar::rates(&rate));
            kinematics.sizes.push(acceleration_size(body, state, ground));
        }
        kinematics
    }

    /// Places of the bodies of a pair; none for an abutment, and for a body that is not in the set.
    pub fn places(&self, model: &Model, pair: usize) -> [Option<usize>; 2] {
        model.pairs[pair].bodies.map(|body| body.and_then(|b| self.bodies.binary_search(&b).ok()))
    }

    /// A declared contact, by its number in the model.
    pub fn point(&self, model: &Model, site: usize) -> ContactPoint {
        let pair = model.sites[site].pair;
        let places = self.places(model, pair);
        let still = Frame::fixed(DVec3::ZERO);
        let frame = |side: usize| places[side].map_or(&still, |place| &self.frames[place]);
        ContactPoint::of(model, site, places, [frame(0), frame(1)])
    }

    /// Largest acceleration in play, before terms cancel \[m/s²\].
    pub fn scale(&self) -> f64 {
        self.sizes.iter().copied().fold(f64::MIN_POSITIVE, f64::max)
    }

    /// Contact force that is round-off at a point \[N\].
    pub fn force_round_off(&self, point: &ContactPoint) -> f64 {
        let w_n = self.cluster.mobilities(point)[0];
        if w_n > 0.0 { IMPACT_FORCE_ROUNDING * self.scale() / w_n } else { 0.0 }
    }
}

/// Sum of the magnitudes of the accelerations that act on a body \[m/s²\].
fn acceleration_size(body: &Body, state: &PlanarState, ground: DVec3) -> f64 {
    let (q, v) = (planar::positions(state), planar::rates(state));
    let push = DVec3::new(body.push.x, body.push.y, body.moment.z);
    let at_corner = |force: DVec3| {
        let a = inverse_mass(body) * force;
        a.truncate().length() + a.z.abs() * body.radius
    };
    at_corner(body.planar.stiffness * q) + at_corner(body.planar.damping * v) + at_corner(push) + ground.length()
}

/// Acceleration of the ground within one linear piece of a record, or at any time without one \[m/s²\].
pub fn ground_acceleration(ground: &Ground, piece: &LinearPiece, t: f64) -> DVec3 {
    match ground {
        Ground::Record { .. } => piece.acceleration(t),
        other => other.acceleration(t),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example;

    #[test]
    fn free_accelerations_and_their_size_are_those_of_springs_and_ground() {
        let model = example::preset("straight-abutment", |scene| scene.girders[0].push.force = [4.0, 0.0, 0.0]);
        let body = &model.bodies[0];
        let q = DVec3::new(1e-3, -2e-3, 0.0);
        let ground = DVec3::new(0.5, 0.0, 0.0);
        let kinematics = BodyKinematics::new(&model, &[0], &[[q.x, q.y, 0.0, 0.0, 0.0, 0.0]], ground);
        let spring = body.planar.stiffness * q / body.mass;
        let expected = DVec3::new(4.0 / body.mass - spring.x - 0.5, -spring.y, 0.0);
        assert!((kinematics.free[0] - expected).length() < 1e-12, "{} against {expected}", kinematics.free[0]);
        assert!(kinematics.scale() >= kinematics.free[0].truncate().length(), "terms before they cancel");
        assert_eq!(kinematics.places(&model, 0), [Some(0), None], "the wall has no place");
    }

    #[test]
    fn a_record_is_linear_within_a_piece() {
        let ground = Ground::record(DVec3::X, 0.5, [1.0, 3.0]);
        let piece = ground.piece(0);
        assert!((ground_acceleration(&ground, &piece, 0.25) - DVec3::new(2.0, 0.0, 0.0)).length() < 1e-15, "midway");
    }
}
