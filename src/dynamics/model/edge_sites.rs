//! Contact sites of edge nodes (`docs/physics.md#edge-nodes`): in space every edge of an end face against every side
//! of the facing face across it, both ways.

use glam::DVec3;

use crate::contact::parameters::edge_slack;
use crate::contact::{Frame, Home};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::contact_sites::{OVERHANG, PairSide, facade, placed_at};
use crate::dynamics::model::edge_node::Edge;
use crate::dynamics::model::pair::ContactSite;
use crate::scene::facing::Side;
use crate::scene::{Kind, Scene, SceneErrors};

/// Edges of a face by their first corner, seen from outside.
const EDGES: [&str; 4] = ["bottom", "right", "top", "left"];

/// Cosine of the angle between two faces of bodies that met up to which their edges have nodes, as placed \[–\]: 10°. The normal of an
/// edge node is wrong by half the angle; faces that are less parallel touch with a corner or with an edge along a face. Tuned.
const OPPOSED: f64 = 0.985;

/// Declares the edge nodes of a pair: of a planar scene none, against a backwall those of edges that can cross; with `met`, of a pair
/// that was added because the bodies met, those of faces that look at each other as placed.
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
    let reach = match (first.body, second.body) {
        (Some(girder), None) => OVERHANG * bodies[girder].prism.end_length(),
        _ => f64::INFINITY,
    };
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        let both = [node(bodies, (&first, i), (&second, j)), node(bodies, (&second, j), (&first, i))];
        if let [Some((one, near)), Some((other, close))] = both
            && near.max(close) < reach
        {
            sites.extend([one, other].map(|site| ContactSite { pair, ..site }));
        }
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

/// The node of an edge of `own` at a side of the face of `facing`, and the distance of the edge from the line of that
/// side \[m\]; `None` where they stand nearly parallel.
fn node(bodies: &[Body], (own, i): (&PairSide, usize), (facing, j): (&PairSide, usize)) -> Option<(ContactSite, f64)> {
    let [a, b] = [own.face.corners[i], own.face.corners[(i + 1) % 4]];
    let home = |point: DVec3| Home::of(point, placed_at(bodies, own), &facing.face, placed_at(bodies, facing));
    let fixed = if own.body.is_none() { own.fixed } else { facing.fixed };
    let stands = || [own, facing].map(|side| Frame::fixed(placed_at(bodies, side).0));
    let edge = Edge::of(&[a, b].map(|end| (home(end), own.face.coordinates(end))), &facing.face, j, stands)?;
    let [node, face] = stands();
    let insets = edge.ends(&node, &face).inset;
    let beside = if insets[0] * insets[1] > 0.0 { insets[0].abs().min(insets[1].abs()) } else { 0.0 };
    let site = ContactSite {
        node: format!("{}.{}-edge-at-{}", own.name, EDGES[i], EDGES[j]),
        face_name: std::sync::Arc::clone(&facing.name),
        pair: 0,
        ends: [own.end(), facing.end()],
        around: None,
        corner: None,
        node_body: own.body,
        point: a.midpoint(b),
        face_body: facing.body,
        home: home(a.midpoint(b)),
        face: facing.face.clone(),
        fixed,
        stand: Frame::fixed(fixed),
        edge: Some(Box::new(edge)),
    };
    Some((site, beside))
}
