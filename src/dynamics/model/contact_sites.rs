//! Contact sites, each a node against a face (Fig. 24): both ways between girders, one way against a backwall unless a
//! corner of the backwall can enter the girder's face.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::contact::{ContactGeometry, Frame};
use crate::dynamics::model::backwall;
use crate::dynamics::model::body::Body;
use crate::dynamics::model::face_choice::FaceChoice;
use crate::dynamics::model::pair::{Carrier, ContactSite, NodeBeside};
use crate::geometry::shape::block_behind;
use crate::geometry::{End, Face, Prism};
use crate::language::{Message, Text};
use crate::scene::facing::{Facing, Flank, Rear, Side, SolidId};
use crate::scene::{Kind, Scene, SceneError, SceneErrors, placed};

/// Endings of the names of a planar girder's nodes.
const CORNERS: [&str; 4] = [".corner0", ".corner1", ".corner2", ".corner3"];
/// Distance beside a girder's end face below which a corner of a backwall is declared as a node, per length of the end \[–\]
/// (`docs/physics.md#contact-pairs`). Chosen.
const OVERHANG: f64 = 0.75;

/// A node of a side.
struct Node {
    name: String,
    /// In the frame of the body (about `fixed`, for an abutment) \[m\].
    point: DVec3,
    /// Number of the corner of its body where the node is; in plan of that at the underside or the lower edge.
    corner: usize,
}

/// One side of a pair as the other sees it: nodes, and the face they may enter.
pub(super) struct PairSide {
    side: Side,
    pub name: Arc<str>,
    pub body: Option<usize>,
    nodes: Vec<Node>,
    pub face: Face,
    /// Origin of an abutment's frame: its corner a \[m\].
    pub fixed: DVec3,
}

impl PairSide {
    /// Part of the body with the face.
    pub(super) fn carrier(&self) -> Carrier {
        Carrier::of_face(self.side)
    }
}

/// Declares all contacts of a pair: nodes of the first side against the face of the second, then back. With `met`, where
/// every face of the two bodies is in a pair, each node belongs to that of its faces which is the most opposed. Gives the nodes that are left
/// out, which lie too far beside the face of the first side.
///
/// # Errors
///
/// An abutment's four corners are no face.
pub(in crate::dynamics) fn contacts(
    scene: &Scene,
    bodies: &[Body],
    facing: &Facing,
    (pair, met): (usize, bool),
    sites: &mut Vec<ContactSite>,
) -> Result<Vec<NodeBeside>, SceneErrors> {
    let mut first = pair_side(scene, bodies, facing.first)?;
    let mut second = pair_side(scene, bodies, facing.second)?;
    let mut left_out = Vec::new();
    if let (Some(girder), SolidId::Abutment(_), false) = (first.body, second.side.solid(), met) {
        let fixed = second.fixed;
        let (kept, beside): (Vec<Node>, Vec<Node>) = std::mem::take(&mut second.nodes)
            .into_iter()
            .partition(|node| can_enter(&bodies[girder], &first.face, fixed + node.point));
        second.nodes = kept;
        let places = [placed_at(bodies, &second), placed_at(bodies, &first)];
        let geometry = |node: Node| ContactGeometry::of(node.point, places[0], &first.face, places[1]);
        left_out
            .extend(beside.into_iter().map(|node| NodeBeside { geometry: geometry(node), face: first.face.clone() }));
    }
    let fixed = if first.body.is_none() { first.fixed } else { second.fixed };
    let nodes = [std::mem::take(&mut first.nodes), std::mem::take(&mut second.nodes)];
    for (nodes, [own, face]) in nodes.into_iter().zip([[&first, &second], [&second, &first]]) {
        for Node { name, mut point, corner } in nodes {
            if facing.met && scene.kind == Kind::Planar {
                point.z += level(bodies, face) - height(bodies, own, point);
            }
            sites.push(ContactSite {
                node: name,
                face_name: Arc::clone(&face.name),
                pair,
                carriers: [Carrier::of_corner(own.side.solid(), corner), face.carrier()],
                around: met.then(|| around(scene, bodies, face)).transpose()?,
                corner: met.then(|| corner_faces(scene, bodies, own, corner)).transpose()?,
                node_body: own.body,
                point,
                face_body: face.body,
                geometry: ContactGeometry::of(point, placed_at(bodies, own), &face.face, placed_at(bodies, face)),
                face: face.face.clone(),
                fixed,
                stand: Frame::fixed(fixed),
                edge: None,
            });
        }
    }
    Ok(left_out)
}

/// Height of a point of a side's body \[m\].
fn height(bodies: &[Body], side: &PairSide, point: DVec3) -> f64 {
    placed_at(bodies, side).0.z + point.z
}

/// Height of the middle of a side's face \[m\]. In plan heights have no meaning: nodes are put at that of the face before them.
fn level(bodies: &[Body], side: &PairSide) -> f64 {
    height(bodies, side, side.face.corners.iter().sum::<DVec3>() / 4.0)
}

/// The face of a side among those that meet in a corner of its body.
fn corner_faces(scene: &Scene, bodies: &[Body], own: &PairSide, corner: usize) -> Result<FaceChoice, SceneErrors> {
    face_choice(scene, bodies, own, |side| side.corners().contains(&corner))
}

/// The face of a side among those of its body that `count`.
pub(super) fn face_choice(
    scene: &Scene,
    bodies: &[Body],
    own: &PairSide,
    count: impl Fn(&Side) -> bool,
) -> Result<FaceChoice, SceneErrors> {
    let axes = placed_at(bodies, own).1;
    let mut others = Vec::new();
    for side in Side::of(scene.kind, own.side.solid()).into_iter().filter(count) {
        if side != own.side {
            others.push((axes * pair_side(scene, bodies, side)?.face.normal, own.side < side));
        }
    }
    Ok(FaceChoice { own: axes * own.face.normal, others })
}

/// Outward unit normals, in the face's axes, of the faces along the sides of the face's polygon, from corner a on; in plan, of
/// the polygon itself above and below.
fn around(scene: &Scene, bodies: &[Body], face: &PairSide) -> Result<[DVec3; 4], SceneErrors> {
    let (quad, axes) = (face.side.corners(), [face.face.tangent, face.face.bitangent, face.face.normal]);
    let mut normals = [DVec3::NEG_Y, DVec3::X, DVec3::Y, DVec3::NEG_X];
    for side in Side::of(scene.kind, face.side.solid()).into_iter().filter(|&side| side != face.side) {
        let corners = side.corners();
        for (edge, normal) in normals.iter_mut().enumerate() {
            if corners.contains(&quad[edge]) && corners.contains(&quad[(edge + 1) % 4]) {
                let outward = pair_side(scene, bodies, side)?.face.normal;
                *normal = DVec3::from(axes.map(|axis| axis.dot(outward)));
            }
        }
    }
    Ok(normals)
}

/// G and axes of the body of a side, as placed.
pub(super) fn placed_at(bodies: &[Body], side: &PairSide) -> (DVec3, DMat3) {
    side.body.map_or((side.fixed, DMat3::IDENTITY), |body| (bodies[body].home, bodies[body].axes))
}

fn can_enter(body: &Body, face: &Face, world: DVec3) -> bool {
    let local = body.axes.transpose() * (world - body.home);
    face.inset(local) > -OVERHANG * body.prism.end_length()
}

pub(super) fn pair_side(scene: &Scene, bodies: &[Body], side: Side) -> Result<PairSide, SceneErrors> {
    match side {
        Side::Girder(girder, end) => Ok(end_side(scene.kind, &bodies[girder], girder, end)),
        Side::Flank(girder, _) => flank_side(scene.kind, &bodies[girder], girder, side),
        Side::Abutment(number) | Side::Rear(number, _) => abutment_side(scene, bodies, number, side),
    }
}

/// A node at a corner of a girder, by the number of that among the eight.
fn girder_node(kind: Kind, body: &Body, corner: usize) -> Node {
    let at = body.prism.corners()[corner];
    let name = match (kind, corner < 4) {
        (Kind::Planar, _) => [&body.name, CORNERS[corner % 4]].concat(),
        (Kind::Spatial, true) => format!("{}.corner{corner}-bottom", body.name),
        (Kind::Spatial, false) => format!("{}.corner{}-top", body.name, corner - 4),
    };
    Node { name, point: if kind == Kind::Planar { at.with_z(0.0) } else { at }, corner }
}

fn end_side(kind: Kind, body: &Body, number: usize, end: End) -> PairSide {
    let plan = Prism::end_corners(end);
    let corners: Vec<usize> = match kind {
        Kind::Planar => plan.to_vec(),
        Kind::Spatial => plan.iter().flat_map(|&corner| [corner, corner + 4]).collect(),
    };
    let quad = body.prism.end_face(end);
    let [a, b, _, d] = quad;
    let tangent = (b - a) / body.prism.end_length();
    let bitangent = (d - a) / body.prism.thickness;
    // An end face is a rectangle by construction.
    let face = Face {
        corners: quad,
        normal: tangent.cross(bitangent),
        tangent,
        bitangent,
        depth: body.prism.depth_behind_end(),
    };
    PairSide {
        side: Side::Girder(number, end),
        name: [&body.name, end.label()].concat().into(),
        body: Some(number),
        nodes: corners.into_iter().map(|corner| girder_node(kind, body, corner)).collect(),
        face,
        fixed: DVec3::ZERO,
    }
}

fn flank_side(kind: Kind, body: &Body, number: usize, side: Side) -> Result<PairSide, SceneErrors> {
    let (corners, all) = (side.corners(), body.prism.corners());
    let depth = match side {
        Side::Flank(_, Flank::Left | Flank::Right) => body.prism.width,
        _ => body.prism.thickness,
    };
    let face = Face::new(corners.map(|i| all[i]), depth)
        .map_err(|error| complaint(&body.name, Text::new("found-face"), error.to_string()))?;
    let nodes = corners.iter().filter(|&&corner| kind == Kind::Spatial || corner < 4);
    Ok(PairSide {
        side,
        name: [&body.name, side.label()].concat().into(),
        body: Some(number),
        nodes: nodes.map(|&corner| girder_node(kind, body, corner)).collect(),
        face,
        fixed: DVec3::ZERO,
    })
}

fn complaint(body: &str, value: Text, remedy: impl Into<Message>) -> SceneErrors {
    SceneError { file: "scene".to_owned(), place: body.into(), value: value.into(), remedy: remedy.into() }.into()
}

/// A face of an abutment: the front, or of the block behind it.
fn abutment_side(scene: &Scene, bodies: &[Body], number: usize, side: Side) -> Result<PairSide, SceneErrors> {
    let abutment = &scene.abutments[number];
    let complaint = |value: Text, remedy: Message| complaint(&format!("abutment.{}", abutment.name), value, remedy);
    let front = placed::abutment_face(scene, abutment)
        .ok_or_else(|| complaint(Text::new("found-no-face"), Text::new("wrong-abutment-no-face").into()))?;
    let fixed = front[0];
    let front = front.map(|corner| corner - fixed);
    let behind = placed::abutment_depth(scene, abutment);
    let block = block_behind(front, behind);
    let [a, b, _, d] = front;
    let depth = match side {
        Side::Rear(_, Rear::Left | Rear::Right) => (b - a).length(),
        Side::Rear(_, Rear::Bottom | Rear::Top) => (d - a).length(),
        _ => behind,
    };
    let corners = side.corners();
    let face = Face::new(corners.map(|i| block[i]), depth)
        .map_err(|error| complaint(Text::new("found-its-face"), error.to_string().into()))?;
    let node = |corner: usize| {
        let (place, number) = if corner < 4 { ("back", corner) } else { ("corner", corner - 4) };
        Node { name: format!("{}.{place}{number}", abutment.name), point: block[corner], corner }
    };
    // In plan a node stands for a whole upright edge: for that above and below it.
    let edge = |corner: usize, above: usize, name: &str| Node {
        name: [&abutment.name, name].concat(),
        point: block[corner].midpoint(block[above]),
        corner,
    };
    let nodes = match scene.kind {
        Kind::Spatial => corners.map(node).into(),
        Kind::Planar => {
            let edges = [(4, 7, ".side0"), (5, 6, ".side1"), (0, 3, ".back0"), (1, 2, ".back1")];
            edges
                .into_iter()
                .filter(|(c, ..)| corners.contains(c))
                .map(|(c, above, name)| edge(c, above, name))
                .collect()
        }
    };
    let name = [&abutment.name, side.label()].concat();
    Ok(PairSide { side, name: name.into(), body: backwall::number(scene, bodies, number), nodes, face, fixed })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::scene::presets;

    #[test]
    fn the_nodes_of_a_skewed_pair_stand_off_by_the_gap_along_the_normal() {
        let scene = presets::load("skew45-abutment").expect("a preset");
        let model = Model::compile(&scene).expect("a scene");
        let world = |body: Option<usize>, stand: DVec3, point: DVec3| {
            body.map_or(stand + point, |b| model.bodies[b].home + model.bodies[b].axes * point)
        };
        assert!(model.pairs.len() == 1 && model.sites.len() >= 2, "{} contacts", model.sites.len());
        for site in &model.sites {
            let node = world(site.node_body, site.fixed, site.point);
            let corner = world(site.face_body, site.fixed, site.face.corners[0]);
            let normal = site.face_body.map_or(site.face.normal, |b| model.bodies[b].axes * site.face.normal);
            let gap = normal.dot(node - corner);
            assert!(
                (site.geometry.placed_gap() - gap).abs() < 1e-14 && gap > 0.0,
                "{}: {} for {gap}",
                site.node,
                site.geometry.placed_gap()
            );
            assert!((normal.x.abs() - normal.y.abs()).abs() < 1e-12, "{}: 45°, not {normal}", site.node);
            assert_eq!(site.pair, 0, "{}", site.node);
            assert!(site.node_body.is_some() != site.face_body.is_some(), "{}: girder against abutment", site.node);
        }
        let of_deck = model.sites.iter().filter(|site| site.node_body == Some(0)).count();
        assert_eq!(of_deck, 2, "both corners of the end that faces the wall");
        let [shortest, longest] = [f64::min, f64::max]
            .map(|pick| model.sites.iter().map(|site| site.geometry.placed_gap()).reduce(pick).unwrap_or(f64::NAN));
        assert!(longest - shortest < 1e-12, "parallel faces: {shortest} to {longest}");
    }
}
