//! Contact sites of edge nodes (`docs/physics.md#edge-nodes`): in space every edge of a face against every side of the
//! facing face. The node is on the steeper of the two edges, or on both.

use std::sync::Arc;

use glam::DVec3;

use crate::contact::{ContactGeometry, Frame};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::contact_sites::{PairSide, face_choice, pair_side, placed_at};
use crate::dynamics::model::edge_node::Edge;
use crate::dynamics::model::face_choice::FaceChoice;
use crate::dynamics::model::pair::ContactSite;
use crate::scene::facing::Side;
use crate::scene::{Kind, Scene, SceneErrors};

/// Edges of a face by their first corner, seen from outside.
const EDGES: [&str; 4] = ["bottom", "right", "top", "left"];

/// Steepness up to which two edges are alike \[–\]: round-off of axes.
const STEEPNESS_ROUNDING: f64 = 1e-9;

/// The pair whose edge nodes are declared.
#[derive(Clone, Copy)]
pub(in crate::dynamics) struct EdgePair {
    /// Number in the model.
    pub number: usize,
    /// Its two sides.
    pub sides: [Side; 2],
    /// Whether every face of the two bodies is in a pair: a crossing belongs to the two faces that look along its normal the most.
    pub met: bool,
}

/// An edge of a face.
#[derive(Clone, Copy)]
struct FaceEdge<'a> {
    side: &'a PairSide,
    /// Number of its first corner, seen from outside.
    first: usize,
}

impl FaceEdge<'_> {
    /// Its corners \[m\].
    fn ends(&self) -> [DVec3; 2] {
        [self.first, (self.first + 1) % 4].map(|corner| self.side.face.corners[corner])
    }

    /// Sine of its angle to the horizontal as placed \[–\].
    fn steepness(&self, bodies: &[Body]) -> f64 {
        let [from, to] = self.ends();
        (placed_at(bodies, self.side).1 * (to - from)).z.abs() / (to - from).length()
    }
}

/// Declares the edge nodes of a pair; of a planar scene none.
///
/// # Errors
///
/// An abutment's four corners are no face.
pub(in crate::dynamics) fn edge_nodes(
    scene: &Scene,
    bodies: &[Body],
    pair: EdgePair,
    sites: &mut Vec<ContactSite>,
) -> Result<(), SceneErrors> {
    if scene.kind == Kind::Planar {
        return Ok(());
    }
    let [first, second] = [pair_side(scene, bodies, pair.sides[0])?, pair_side(scene, bodies, pair.sides[1])?];
    let faces = pair.met.then(|| faces(scene, bodies, [&first, &second])).transpose()?;
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        let edges = [FaceEdge { side: &first, first: i }, FaceEdge { side: &second, first: j }];
        let steeper = edges[0].steepness(bodies) - edges[1].steepness(bodies);
        let carries = [steeper >= -STEEPNESS_ROUNDING, steeper <= STEEPNESS_ROUNDING];
        for own in [0, 1].into_iter().filter(|&own| carries[own]) {
            let among = faces.as_ref().map(|faces| Arc::clone(&faces[own]));
            let [own, facing] = [edges[own], edges[1 - own]];
            let edge = edge(bodies, [own, facing]).with_other(carries == [true; 2]).among(among);
            sites.push(site(bodies, pair.number, [own, facing], edge));
        }
    }
    Ok(())
}

/// The faces of two sides among those of their bodies, from the first and from the second.
fn faces(scene: &Scene, bodies: &[Body], sides: [&PairSide; 2]) -> Result<[Arc<[FaceChoice; 2]>; 2], SceneErrors> {
    let [first, second] = sides.map(|side| face_choice(scene, bodies, side, |_| true));
    let (first, second) = (first?, second?);
    Ok([Arc::new([first.clone(), second.clone()]), Arc::new([second, first])])
}

/// An edge with the side of a face that its node is at.
fn edge(bodies: &[Body], edges: [FaceEdge<'_>; 2]) -> Edge {
    let [own, facing] = edges;
    let placed = edges.map(|edge| placed_at(bodies, edge.side));
    let stands = placed.map(|(home, _)| Frame::fixed(home));
    let end = |end| (home(bodies, edges, end), own.side.face.coordinates(end));
    let outward = placed[0].1 * own.side.face.normal;
    Edge::of(&own.ends().map(end), outward, (&facing.side.face, facing.first), [&stands[0], &stands[1]])
}

/// A point of an edge's body against the face that the edge is at.
fn home(bodies: &[Body], edges: [FaceEdge<'_>; 2], point: DVec3) -> ContactGeometry {
    let [own, facing] = edges.map(|edge| placed_at(bodies, edge.side));
    ContactGeometry::of(point, own, &edges[1].side.face, facing)
}

/// The contact site of an edge's node.
fn site(bodies: &[Body], pair: usize, edges: [FaceEdge<'_>; 2], edge: Edge) -> ContactSite {
    let [own, facing] = edges.map(|edge| edge.side);
    let fixed = if own.body.is_none() { own.fixed } else { facing.fixed };
    let [from, to] = edges[0].ends();
    let middle = from.midpoint(to);
    ContactSite {
        node: format!("{}.{}-edge-at-{}", own.name, EDGES[edges[0].first], EDGES[edges[1].first]),
        face_name: Arc::clone(&facing.name),
        pair,
        carriers: [own.carrier(), facing.carrier()],
        around: None,
        corner: None,
        node_body: own.body,
        point: middle,
        face_body: facing.body,
        geometry: home(bodies, edges, middle),
        face: facing.face.clone(),
        fixed,
        stand: Frame::fixed(fixed),
        edge: Some(Box::new(edge)),
    }
}
