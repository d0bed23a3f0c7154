//! Contact sites of edge nodes (`docs/physics.md#edge-nodes`): in space every edge of a face against every side of the
//! facing face. The node is on the steeper of the two edges, or on both.

use std::sync::Arc;

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

/// Declares the edge nodes of a pair; of a planar scene none. With `met`, where every face of the two bodies is in a pair, a crossing
/// belongs to the two faces that look along its normal the most.
///
/// # Errors
/// When an abutment's four corners are no face.
pub(in crate::dynamics) fn edge_nodes(
    scene: &Scene,
    bodies: &[Body],
    sides: [Side; 2],
    (pair, met): (usize, bool),
    sites: &mut Vec<ContactSite>,
) -> Result<(), SceneErrors> {
    if scene.kind == Kind::Planar {
        return Ok(());
    }
    let [first, second] = [pair_side(scene, bodies, sides[0])?, pair_side(scene, bodies, sides[1])?];
    let faces = met.then(|| faces(scene, bodies, [&first, &second])).transpose()?;
    let nodes = (0..4).flat_map(|i| (0..4).map(move |j| (i, j)));
    for (i, j) in nodes {
        let (one, other) = ((&first, i), (&second, j));
        let steeper = steepness(bodies, one) - steepness(bodies, other);
        let both = [(steeper >= -STEEPNESS_ROUNDING, one, other, 0), (steeper <= STEEPNESS_ROUNDING, other, one, 1)];
        let nodes = both.into_iter().filter(|(carries, ..)| *carries);
        let shared = steeper.abs() <= STEEPNESS_ROUNDING;
        let among = |first: usize| faces.as_ref().map(|faces| Arc::clone(&faces[first]));
        sites.extend(nodes.map(|(_, own, facing, first)| node(bodies, own, facing, (pair, shared, among(first)))));
    }
    Ok(())
}

/// The faces of two sides among those of their bodies, from the first and from the second.
fn faces(scene: &Scene, bodies: &[Body], sides: [&PairSide; 2]) -> Result<[Arc<[FaceChoice; 2]>; 2], SceneErrors> {
    let [first, second] = sides.map(|side| face_choice(scene, bodies, side, |_| true));
    let (first, second) = (first?, second?);
    Ok([Arc::new([first.clone(), second.clone()]), Arc::new([second, first])])
}

/// Sine of the angle of an edge to the horizontal as placed \[–\].
fn steepness(bodies: &[Body], (side, i): (&PairSide, usize)) -> f64 {
    let edge = side.face.corners[(i + 1) % 4] - side.face.corners[i];
    (placed_at(bodies, side).1 * edge).z.abs() / edge.length()
}

/// The node of an edge of `own` at a side of the face of `facing`; with `shared`, the other's edge has a node there as well.
fn node(
    bodies: &[Body],
    (own, i): (&PairSide, usize),
    (facing, j): (&PairSide, usize),
    (pair, shared, faces): (usize, bool, Option<Arc<[FaceChoice; 2]>>),
) -> ContactSite {
    let ends = [own.face.corners[i], own.face.corners[(i + 1) % 4]];
    let [own_placed, facing_placed] = [own, facing].map(|side| placed_at(bodies, side));
    let home = |point| ContactGeometry::of(point, own_placed, &facing.face, facing_placed);
    let stands = [own_placed, facing_placed].map(|(home, _)| Frame::fixed(home));
    let outward = own_placed.1 * own.face.normal;
    let edge = Edge::of(
        &ends.map(|end| (home(end), own.face.coordinates(end))),
        outward,
        (&facing.face, j),
        [&stands[0], &stands[1]],
    )
    .with_other(shared)
    .among(faces);
    let fixed = if own.body.is_none() { own.fixed } else { facing.fixed };
    let middle = ends[0].midpoint(ends[1]);
    ContactSite {
        node: format!("{}.{}-edge-at-{}", own.name, EDGES[i], EDGES[j]),
        face_name: Arc::clone(&facing.name),
        pair,
        carriers: [own.carrier(), facing.carrier()],
        around: None,
        corner: None,
        node_body: own.body,
        point: middle,
        face_body: facing.body,
        geometry: home(middle),
        face: facing.face.clone(),
        fixed,
        stand: Frame::fixed(fixed),
        edge: Some(Box::new(edge)),
    }
}
