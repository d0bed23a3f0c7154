//! The gap of a facing pair on one axis: all faces square to the axis, all nodes at equal distance from their faces.

use crate::dynamics::Model;
use crate::dynamics::world::constants::AXIAL_GAP_ROUNDING;
use crate::dynamics::world::site_geometry::SiteGeometry;
use crate::scene::Kind;

/// Gap of a pair with all faces square to one axis and all nodes at equal distance from their faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct AxialGap {
    /// Axis: 0 for x, 1 for y.
    pub axis: usize,
    /// Gap `g₀` as placed \[m\].
    pub placed_gap: f64,
    /// Derivative of the gap by the displacement of the pair's first side along the axis, ±1 \[–\].
    pub towards: f64,
    /// Size of the contact geometry, to which round-off of positions is proportional \[m\].
    pub size: f64,
}

impl AxialGap {
    /// Axial gap of a pair's contact sites, given by their numbers in the model; `None` where the pair is not on one
    /// axis.
    pub(in crate::dynamics) fn of(model: &Model, pair: usize, sites: &[(usize, SiteGeometry)]) -> Option<Self> {
        let first = model.pairs[pair].bodies[0];
        let one = |(site, geometry): &(usize, SiteGeometry), axis: usize| {
            let site = &model.sites[*site];
            let normal = site.geometry.axes.z_axis;
            let square = site.face.is_upright() && normal[axis].abs() == 1.0 && normal[1 - axis] == 0.0;
            let side = if site.node_body == first { 1.0 } else { -1.0 };
            square.then(|| Self {
                axis,
                placed_gap: geometry.placed_gap,
                towards: side * normal[axis],
                size: geometry.size,
            })
        };
        let all = |axis: usize| {
            let whole = one(sites.first()?, axis)?;
            let like = |site: &(usize, SiteGeometry)| {
                one(site, axis).is_some_and(|other| {
                    other.towards == whole.towards
                        && (other.placed_gap - whole.placed_gap).abs() <= AXIAL_GAP_ROUNDING * whole.size
                })
            };
            sites.iter().all(like).then_some(whole)
        };
        (model.kind == Kind::Planar).then(|| all(0).or_else(|| all(1))).flatten()
    }
}
