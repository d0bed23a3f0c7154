//! Geometry of a contact site as placed, and the bound on its gap that follows from bounds on the motion of both bodies.

use crate::contact::Local;
use crate::dynamics::Model;
use crate::dynamics::free_flight::relative_bounds::RelativeBounds;
use crate::dynamics::locate::advancement::BoundedGap;
use crate::dynamics::model::motion_bounds::MotionBounds;

/// Where the two sides of a contact stand as placed.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct SiteGeometry {
    /// Gap \[m\].
    pub home_gap: f64,
    /// Node from its G \[m\].
    pub arm: f64,
    /// Node from the face body's G \[m\].
    pub apart: f64,
    /// Size of what moves, which its places round with \[m\].
    pub size: f64,
}

impl SiteGeometry {
    pub(in crate::dynamics) fn of(model: &Model, site: usize) -> Self {
        let site = &model.contacts[site];
        let (arm, apart) = (site.home.arm.length(), site.home.lever.length());
        Self { home_gap: site.home.gap(), arm, apart, size: arm + apart + site.face.size() }
    }

    /// What the gap can do at most.
    pub(in crate::dynamics) fn bounded_gap(
        &self,
        here: &Local,
        node: &MotionBounds,
        face: &MotionBounds,
        between: &RelativeBounds,
    ) -> BoundedGap {
        let apart = self.apart + between.reach + node.turn * self.arm;
        let turn = |spin: f64, spin_rate: f64, arm: f64| (spin_rate + spin * spin) * arm;
        // g = n·r, r from the face's G to the node: n turns with the face.
        let curvature = between.acceleration
            + turn(node.spin, node.spin_rate, self.arm)
            + turn(face.spin, face.spin_rate, apart)
            + 2.0 * face.spin * (between.speed + node.spin * self.arm);
        let moved = between.reach + node.turn * self.arm + face.turn * apart;
        let window = between.window;
        BoundedGap { gap: here.gap, rate: here.gap_rate, curvature, window, out_of_reach: self.home_gap > moved }
    }
}
