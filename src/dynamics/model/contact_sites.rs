//! Contact sites, each a node against a face (Fig. 24): both ways between girders, one way against a backwall unless a
//! corner of the backwall can enter the girder's face.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::contact::{Frame, Home};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::pair::ContactSite;
use crate::geometry::{End, Face, Prism};
use crate::scene::facing::{Facing, Side};
use crate::scene::{Kind, Scene, SceneError, SceneErrors, placed};

/// What a planar girder's nodes are called after it.
const CORNERS: [&str; 4] = [".corner0", ".corner1", ".corner2", ".corner3"];
/// A backwall's corners are declared when they are less than this part of the girder's end beside that end.
const OVERHANG: f64 = 0.75;

/// One side of a pair as the other sees it: nodes, and the face they may enter.
struct PairSide {
    name: Arc<str>,
    body: Option<usize>,
    end: Option<End>,
    /// Node names and places, in the frame of the body (about `fixed`, for an abutment).
    nodes: Vec<(String, DVec3)>,
    face: Face,
    /// Where an abutment's frame stands: its corner a.
    fixed: DVec3,
}

/// Declares all contacts of a facing pair: nodes of the first against the face of the second, then back.
///
/// # Errors
/// When an abutment's four corners are no face.
pub(in crate::dynamics) fn contacts(
    scene: &Scene,
    bodies: &[Body],
    facing: &Facing,
    pair: usize,
    sites: &mut Vec<ContactSite>,
) -> Result<(), SceneErrors> {
    let mut first = facade(scene, bodies, facing.first)?;
    let mut second = facade(scene, bodies, facing.second)?;
    if let (Some(girder), None) = (first.body, second.body) {
        let fixed = second.fixed;
        second.nodes.retain(|(_, point)| can_enter(&bodies[girder], &first.face, fixed + *point));
    }
    let fixed = if first.body.is_none() { first.fixed } else { second.fixed };
    let nodes = [std::mem::take(&mut first.nodes), std::mem::take(&mut second.nodes)];
    for (nodes, [own, face]) in nodes.into_iter().zip([[&first, &second], [&second, &first]]) {
        sites.extend(nodes.into_iter().map(|(node, point)| ContactSite {
            node,
            face_name: Arc::clone(&face.name),
            pair,
            ends: [own.end, face.end],
            node_body: own.body,
            point,
            face_body: face.body,
            home: Home::of(point, placed_at(bodies, own), &face.face, placed_at(bodies, face)),
            face: face.face.clone(),
            fixed,
            stand: Frame::fixed(fixed),
        }));
    }
    Ok(())
}

/// Where the body of a facade was placed, and its axes there.
fn placed_at(bodies: &[Body], facade: &PairSide) -> (DVec3, DMat3) {
    facade.body.map_or((facade.fixed, DMat3::IDENTITY), |body| (bodies[body].home, bodies[body].axes))
}

fn can_enter(body: &Body, face: &Face, world: DVec3) -> bool {
    let local = body.axes.transpose() * (world - body.home);
    face.inset(local) > -OVERHANG * body.prism.end_length()
}

fn facade(scene: &Scene, bodies: &[Body], side: Side) -> Result<PairSide, SceneErrors> {
    match side {
        Side::Girder(girder, end) => Ok(girder_facade(scene.kind, &bodies[girder], girder, end)),
        Side::Abutment(number) => abutment_facade(scene, number),
    }
}

fn girder_facade(kind: Kind, body: &Body, number: usize, end: End) -> PairSide {
    let corners = body.prism.corners();
    let plan = Prism::end_corners(end);
    let nodes = match kind {
        Kind::Planar => plan.iter().map(|&c| ([&body.name, CORNERS[c]].concat(), corners[c].with_z(0.0))).collect(),
        Kind::Spatial => plan
            .iter()
            .flat_map(|&c| {
                [("bottom", corners[c]), ("top", corners[c + 4])]
                    .map(|(level, at)| (format!("{}.corner{c}-{level}", body.name), at))
            })
            .collect(),
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
        name: [&body.name, end.label()].concat().into(),
        body: Some(number),
        end: Some(end),
        nodes,
        face,
        fixed: DVec3::ZERO,
    }
}

fn abutment_facade(scene: &Scene, number: usize) -> Result<PairSide, SceneErrors> {
    let abutment = &scene.abutments[number];
    let complaint = |value: String, remedy: String| {
        SceneErrors(vec![SceneError {
            file: scene.name.clone(),
            place: format!("abutment.{}", abutment.name),
            value,
            remedy,
        }])
    };
    let corners = placed::abutment_face(scene, abutment).ok_or_else(|| {
        complaint("no face".into(), "give gap_m, or polygon_m with four corners, before a girder that is there".into())
    })?;
    let fixed = corners[0];
    let corners = corners.map(|corner| corner - fixed);
    let face = Face::new(corners, placed::abutment_depth(scene, abutment))
        .map_err(|error| complaint("its face".into(), error.to_string()))?;
    let [a, b, c, d] = corners;
    let nodes: Vec<(String, DVec3)> = match scene.kind {
        Kind::Planar => vec![
            (format!("{}.side0", abutment.name), a.midpoint(d)),
            (format!("{}.side1", abutment.name), b.midpoint(c)),
        ],
        Kind::Spatial => (0..4).map(|i| (format!("{}.corner{i}", abutment.name), corners[i])).collect(),
    };
    Ok(PairSide { name: abutment.name.as_str().into(), body: None, end: None, nodes, face, fixed })
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
        assert!(model.pairs.len() == 1 && model.contacts.len() >= 2, "{} contacts", model.contacts.len());
        for site in &model.contacts {
            let node = world(site.node_body, site.fixed, site.point);
            let corner = world(site.face_body, site.fixed, site.face.corners[0]);
            let normal = site.face_body.map_or(site.face.normal, |b| model.bodies[b].axes * site.face.normal);
            let gap = normal.dot(node - corner);
            assert!((site.home.gap() - gap).abs() < 1e-14 && gap > 0.0, "{}: {} for {gap}", site.node, site.home.gap());
            assert!((normal.x.abs() - normal.y.abs()).abs() < 1e-12, "{}: 45°, not {normal}", site.node);
            assert_eq!(site.pair, 0, "{}", site.node);
            assert!(site.node_body.is_some() != site.face_body.is_some(), "{}: girder against abutment", site.node);
        }
        let of_deck = model.contacts.iter().filter(|site| site.node_body == Some(0)).count();
        assert_eq!(of_deck, 2, "both corners of the end that faces the wall");
        let [shortest, longest] = [f64::min, f64::max]
            .map(|pick| model.contacts.iter().map(|site| site.home.gap()).reduce(pick).unwrap_or(f64::NAN));
        assert!(longest - shortest < 1e-12, "parallel faces: {shortest} to {longest}");
    }
}
