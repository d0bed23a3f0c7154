//! Gap `g = n·r − h` of a node above a face in plan, with `ġ` and `g̈`, from the planar poses of both sides.
//!
//! `n` turns with the face, `r` runs from the face's G to the node, `h` is the level of the face along `n`.

use glam::DVec2;

use crate::dynamics::Model;
use crate::dynamics::model::coordinates::planar::{self, PlanarState};

/// A declared contact as placed, in plan.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics::impact2d) struct PlanarSite {
    /// From the face body's G to the node body's \[m\].
    pub home: DVec2,
    /// Node from its G \[m\].
    pub arm: DVec2,
    /// Outward normal of the face.
    pub normal: DVec2,
    /// Level `h` of the face along its normal, from its G \[m\].
    pub level: f64,
}

impl PlanarSite {
    /// A declared contact, by its number in the model.
    pub(in crate::dynamics::impact2d) fn of(model: &Model, site: usize) -> Self {
        let site = &model.sites[site];
        let placed = |body: Option<usize>| match body {
            Some(body) => model.bodies[body].planar_frame(&[0.0; planar::WIDTH]),
            None => crate::contact::Frame::fixed(site.fixed),
        };
        let (node, face) = (placed(site.node_body), placed(site.face_body));
        Self {
            home: (node.home - face.home).truncate(),
            arm: site.geometry.arm.truncate(),
            normal: site.geometry.axes.z_axis.truncate(),
            level: site.face.corners[0].dot(site.face.normal),
        }
    }

    /// Whether both nodes are declared against one face.
    pub(in crate::dynamics::impact2d) fn shares_face(&self, other: &Self) -> bool {
        self.normal == other.normal && self.level == other.level
    }
}

/// Pose and velocity of one side of a pair.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics::impact2d) struct PlanarPose {
    /// Displacement of G since placed \[m\].
    pub shift: DVec2,
    /// Cosine and sine of θ.
    pub turn: DVec2,
    /// Velocity of G \[m/s\].
    pub velocity: DVec2,
    /// θ̇ \[rad/s\].
    pub spin: f64,
}

impl PlanarPose {
    /// A side that does not move.
    pub(in crate::dynamics::impact2d) const STILL: Self =
        Self { shift: DVec2::ZERO, turn: DVec2::X, velocity: DVec2::ZERO, spin: 0.0 };

    /// The pose in a planar state.
    pub(in crate::dynamics::impact2d) fn of(state: &PlanarState) -> Self {
        let (place, rate) = (planar::positions(state), planar::rates(state));
        Self {
            shift: place.truncate(),
            turn: if place.z == 0.0 { DVec2::X } else { DVec2::from_angle(place.z) },
            velocity: rate.truncate(),
            spin: rate.z,
        }
    }
}

/// `[g, ġ]` of a contact \[m\], \[m/s\]; `sides` are those of its node and its face.
pub(in crate::dynamics::impact2d) fn gap(
    site: &PlanarSite,
    sides: [Option<usize>; 2],
    poses: &[PlanarPose; 2],
) -> [f64; 2] {
    RelativeNode::of(site, sides, poses).gap(site)
}

/// A node relative to its face.
pub(in crate::dynamics::impact2d) struct RelativeNode {
    arm: DVec2,
    normal: DVec2,
    /// `r` \[m\], and the difference of the velocities of node and face body's G \[m/s\].
    apart: DVec2,
    rate: DVec2,
    /// θ̇ of node and face \[rad/s\].
    spins: [f64; 2],
}

impl RelativeNode {
    /// The node of a contact, `sides` being those of node and face.
    pub(in crate::dynamics::impact2d) fn of(
        site: &PlanarSite,
        sides: [Option<usize>; 2],
        poses: &[PlanarPose; 2],
    ) -> Self {
        let pose = |which: usize| sides[which].map_or(PlanarPose::STILL, |side| poses[side]);
        let (node, face) = (pose(0), pose(1));
        let arm = node.turn.rotate(site.arm);
        Self {
            arm,
            normal: face.turn.rotate(site.normal),
            apart: site.home + (node.shift - face.shift) + arm,
            rate: node.velocity - face.velocity + arm.perp() * node.spin,
            spins: [node.spin, face.spin],
        }
    }

    /// `[g, ġ]` \[m\], \[m/s\].
    pub(in crate::dynamics::impact2d) fn gap(&self, site: &PlanarSite) -> [f64; 2] {
        let rate = self.rate - self.apart.perp() * self.spins[1];
        [self.normal.dot(self.apart) - site.level, self.normal.dot(rate)]
    }

    /// `g̈` under these accelerations `(ẍ, ÿ, θ̈)` of node and face \[m/s²\].
    pub(in crate::dynamics::impact2d) fn second_derivative(&self, [node, face]: [[f64; 3]; 2]) -> f64 {
        let [w_n, w_f] = self.spins;
        let linear = DVec2::new(node[0] - face[0], node[1] - face[1]);
        let apart = linear + self.arm.perp() * node[2] - self.arm * (w_n * w_n);
        let turned = apart - self.apart.perp() * face[2] - self.rate.perp() * (2.0 * w_f) - self.apart * (w_f * w_f);
        self.normal.dot(turned)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SITE: PlanarSite = PlanarSite {
        home: DVec2::new(0.3, 0.1),
        arm: DVec2::new(-0.1, 0.04),
        normal: DVec2::new(0.6, 0.8),
        level: 0.05,
    };

    /// Node and face on polynomials of time: their poses and accelerations.
    fn moving(t: f64) -> ([PlanarPose; 2], [[f64; 3]; 2]) {
        let side = |q: [f64; 3], v: [f64; 3], a: [f64; 3]| {
            let at = |i: usize| q[i] + t * (v[i] + 0.5 * t * a[i]);
            let rate = |i: usize| v[i] + t * a[i];
            (PlanarPose::of(&[at(0), at(1), at(2), rate(0), rate(1), rate(2)]), a)
        };
        let (node, a) = side([0.01, -0.02, 0.3], [0.4, -0.3, 2.0], [1.5, 0.7, -8.0]);
        let (face, b) = side([-0.03, 0.01, -0.2], [-0.2, 0.5, -1.0], [-0.6, 2.0, 5.0]);
        ([node, face], [a, b])
    }

    #[test]
    fn rate_and_second_derivative_agree_with_differences_of_the_gap() {
        for sides in [[Some(0), Some(1)], [Some(0), None], [None, Some(1)], [Some(1), Some(0)]] {
            let gap_at = |t: f64| gap(&SITE, sides, &moving(t).0);
            let (h, t) = (1e-5, 0.07);
            let [_, rate] = gap_at(t);
            let difference = (gap_at(t + h)[0] - gap_at(t - h)[0]) / (2.0 * h);
            assert!((rate - difference).abs() < 1e-9, "{sides:?}: ġ = {rate}, differenced {difference}");
            let (poses, accelerations) = moving(t);
            let of = |which: usize| sides[which].map_or([0.0; 3], |side| accelerations[side]);
            let second = RelativeNode::of(&SITE, sides, &poses).second_derivative([of(0), of(1)]);
            let difference = (gap_at(t + h)[1] - gap_at(t - h)[1]) / (2.0 * h);
            assert!((second - difference).abs() < 1e-7, "{sides:?}: g̈ = {second}, differenced {difference}");
        }
    }

    #[test]
    fn sides_at_rest_as_placed_have_the_placed_gap() {
        let [gap, rate] = gap(&SITE, [Some(0), Some(1)], &[PlanarPose::STILL; 2]);
        let placed = SITE.normal.dot(SITE.home + SITE.arm) - SITE.level;
        assert_eq!([gap, rate], [placed, 0.0], "g = n·r − h");
    }

    #[test]
    fn nodes_share_a_face_when_normal_and_level_are_equal() {
        let other = PlanarSite { arm: DVec2::new(-0.1, -0.04), ..SITE };
        assert!(SITE.shares_face(&other), "another node of the same face");
        assert!(!SITE.shares_face(&PlanarSite { level: 0.06, ..SITE }), "a parallel face");
    }
}
