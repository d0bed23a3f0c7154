//! Geometry of a contact site as placed, and the bound on its gap that follows from bounds on the motion of both
//! bodies.

use crate::contact::Local;
use crate::dynamics::Model;
use crate::dynamics::free_flight::relative_bounds::RelativeBounds;
use crate::dynamics::locate::advancement::BoundedGap;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::motion_bounds::gap_acceleration;

/// Geometry of a contact site as placed.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct SiteGeometry {
    /// Gap as placed \[m\].
    pub placed_gap: f64,
    /// Distance of the node from G of its own body, of an edge node at most \[m\].
    pub arm: f64,
    /// Distance of the node from G of the face's body as placed \[m\].
    pub lever: f64,
    /// Size of the contact geometry, to which round-off of positions is proportional \[m\].
    pub size: f64,
    /// Whether it is of two bodies that have met: most of their nodes stay behind most of their faces.
    pub of_met: bool,
}

impl SiteGeometry {
    pub(in crate::dynamics) fn of(model: &Model, site: usize) -> Self {
        let site = &model.sites[site];
        let half = site.half_edge();
        let (arm, lever) = (site.geometry.arm.length() + half, site.geometry.lever.length() + half);
        let of_met = site.corner.is_some();
        Self { placed_gap: site.geometry.placed_gap(), arm, lever, size: arm + lever + site.face.size(), of_met }
    }

    /// The gap `here` with a bound on `|g̈|` from bounds on the motion of both bodies and on their relative motion,
    /// and whether these exclude a closing.
    pub(in crate::dynamics) fn bounded_gap(
        &self,
        here: &Local,
        node: &MotionBounds,
        face: &MotionBounds,
        between: &RelativeBounds,
    ) -> BoundedGap {
        let apart = self.lever + between.reach + node.turn * self.arm;
        let relative = [between.speed, between.acceleration];
        let curvature = gap_acceleration([node, face], relative, [self.arm, apart]);
        let moved = between.reach + node.turn * self.arm + face.turn * apart;
        let out_of_reach = self.placed_gap > moved || (self.of_met && -self.placed_gap > moved);
        let window = between.window;
        BoundedGap { gap: here.gap, rate: here.gap_rate, curvature, window, out_of_reach }
    }
}
