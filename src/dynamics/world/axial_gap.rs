//! The one gap of a facing pair whose faces are all square to one axis and whose nodes are all equally far from them.

use crate::dynamics::Model;
use crate::dynamics::world::site_geometry::SiteGeometry;
use crate::scene::Kind;

/// Gaps as placed that differ by less than this part of what moves are one: rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A pair with all its faces square to one axis and all its nodes equally far from them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct AxialGap {
    /// 0 for x, 1 for y.
    pub axis: usize,
    /// `g₀` \[m\].
    pub rest: f64,
    /// What the gap gains per displacement of the pair's first side along the axis, ±1.
    pub towards: f64,
    /// Size of what moves, which its places round with \[m\].
    pub size: f64,
}

impl AxialGap {
    /// Of a pair's contact sites, by their numbers in the model, where the pair is so placed.
    pub(in crate::dynamics) fn of(model: &Model, pair: usize, sites: &[(usize, SiteGeometry)]) -> Option<Self> {
        let first = model.pairs[pair].bodies[0];
        let one = |(site, spot): &(usize, SiteGeometry), axis: usize| {
            let site = &model.contacts[*site];
            let normal = site.home.axes.z_axis;
            let square = site.face.is_upright() && normal[axis].abs() == 1.0 && normal[1 - axis] == 0.0;
            let side = if site.node_body == first { 1.0 } else { -1.0 };
            square.then(|| Self { axis, rest: spot.home_gap, towards: side * normal[axis], size: spot.size })
        };
        let all = |axis: usize| {
            let whole = one(sites.first()?, axis)?;
            let like = |site: &(usize, SiteGeometry)| {
                one(site, axis).is_some_and(|other| {
                    other.towards == whole.towards && (other.rest - whole.rest).abs() <= ROUNDING * whole.size
                })
            };
            sites.iter().all(like).then_some(whole)
        };
        (model.kind == Kind::Planar).then(|| all(0).or_else(|| all(1))).flatten()
    }
}
