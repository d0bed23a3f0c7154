//! Contact sites of edge nodes (`docs/physics.md#edge-nodes`): in space every edge of a face against every side of the
//! facing face. The node is on the steeper of the two edges, or on both.

use glam::DVec3;

use crate::contact::parameters::edge_slack;
use crate::contact::{Frame, Home};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::contact_sites::{PairSide, facade, placed_at};
use crate::dynamics::model::edge_node::Edge;
use crate::dynamics::model::pair::ContactSite;
use crate::scene::facing::Side;
use crate::scene::{Kind, Scene, SceneErrors};

/// Edges of a face by their first corner, seen from outside.
const EDGES: [&str; 4] = ["bottom", "right", "top", "left"];

/// Cosine of the angle between two faces of bodies that met up to which their edges have nodes, as placed \[–\]: 10°. Faces that
/// are less parallel touch with a corner, or with an edge along a face. Tuned.
const OPPOSED: f64 = 0.985;

/// Steepness up to which two edges are alike \[–\]: round-off of axes.
const ALIKE: f64 = 1e-9;

/// Declares the edge nodes of a pair; of a planar scene none. With `met`, of a pair that was added because the bodies met, those of
/// faces that look at each other as placed.
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
    let [first, second] = [facade(scene, bodies, sides[0])?, facade(scene, bodies, sides[1])?];
    if met && !look_at_each_other(bodies, [&first, &second]) {
        return Ok(());
    }
    let nodes = (0..4).flat_map(|i| (0..4).map(move |j| (i, j)));
    for (i, j) in nodes {
        let (one, other) = ((&first, i), (&second, j));
        let steeper = steepness(bodies, one) - steepness(bodies, other);
        let both = [(steeper >= -ALIKE, one, other), (steeper <= ALIKE, other, one)];
        let nodes = both.into_iter().filter(|(carries, ..)| *carries);
        let shared = steeper.abs() <= ALIKE;
        sites.extend(nodes.map(|(_, own, facing)| node(bodies, own, facing, (pair, shared))));
    }
    Ok(())
}

/// Whether two faces look at each other as placed: outward normals opposed, and the centre of each before the other.
fn look_at_each_other(bodies: &[Body], sides: [&PairSide; 2]) -> bool {
    let [(one, n), (other, m)] = sides.map(|side| {
        let (home, axes) = placed_at(bodies, side);
        let centre = side.face.corners.iter().sum::<DVec3>() / 4.0;
        (home + axes * centre, axes * side.face.normal)
    });
    let near = edge_slack(&sides[0].face).max(edge_slack(&sides[1].face));
    n.dot(m) <= -OPPOSED && (other - one).dot(n) >= -near && (one - other).dot(m) >= -near
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
    (pair, shared): (usize, bool),
) -> ContactSite {
    let ends = [own.face.corners[i], own.face.corners[(i + 1) % 4]];
    let [own_placed, facing_placed] = [own, facing].map(|side| placed_at(bodies, side));
    let home = |point| Home::of(point, own_placed, &facing.face, facing_placed);
    let stands = [own_placed, facing_placed].map(|(home, _)| Frame::fixed(home));
    let outward = own_placed.1 * own.face.normal;
    let edge = Edge::of(
        &ends.map(|end| (home(end), own.face.coordinates(end))),
        outward,
        (&facing.face, j),
        [&stands[0], &stands[1]],
    )
    .with_other(shared);
    let fixed = if own.body.is_none() { own.fixed } else { facing.fixed };
    let middle = ends[0].midpoint(ends[1]);
    ContactSite {
        node: format!("{}.{}-edge-at-{}", own.name, EDGES[i], EDGES[j]),
        face_name: std::sync::Arc::clone(&facing.name),
        pair,
        ends: [own.end(), facing.end()],
        around: None,
        corner: None,
        node_body: own.body,
        point: middle,
        face_body: facing.body,
        home: home(middle),
        face: facing.face.clone(),
        fixed,
        stand: Frame::fixed(fixed),
        edge: Some(Box::new(edge)),
    }
}
