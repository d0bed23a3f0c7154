//! Bodies among each other: names, who faces whom, faces, overlaps.

use std::collections::BTreeSet;

use glam::{DMat3, DQuat, DVec3};

use super::Complaints;
use super::complaints::numbers;
use crate::geometry::Face;
use crate::geometry::broad::Broad;
use crate::geometry::shape::{AlignedBox, Convex, Stand};
use crate::scene::{Abutment, Kind, Scene, facing, keys, placed};

/// Bodies may reach this part of their size into each other: placing by hand touches to rounding.
const TOUCHING: f64 = 1e-9;

/// Characters that would break a table's heading, a `--set` path, or the name of a pair.
const RESERVED: &[char] = &['.', ',', ';', '"', '\'', '=', '|', '[', ']'];

pub(super) fn names(scene: &Scene, complaints: &mut Complaints) {
    let girders = scene.girders.iter().enumerate().map(|(n, g)| (format!("girder[{n}]"), &g.name));
    let abutments = scene.abutments.iter().enumerate().map(|(n, a)| (format!("abutment[{n}]"), &a.name));
    let mut seen = BTreeSet::new();
    for (place, name) in girders.chain(abutments) {
        let mut at = complaints.at(place, keys::GIRDER);
        let value = format!("{name:?}");
        if name.trim().is_empty() {
            at.add("name", value, "give it a name");
        } else if name.trim() != name || name.contains(|c: char| RESERVED.contains(&c) || c.is_control()) {
            let remedy =
                "tables and --set could not tell it apart: use letters, digits, - and _, and single spaces inside";
            at.add("name", value, remedy);
        } else if !seen.insert(name) {
            at.add("name", value, "another body has this name: girders and abutments need a name each");
        }
    }
}

/// Abutment faces, and everything that facing ends can be wrong about.
pub(super) fn faces(scene: &Scene, complaints: &mut Complaints) {
    for abutment in &scene.abutments {
        backwall(scene, abutment, complaints);
    }
    match facing::find(scene) {
        Err(errors) => complaints.extend(errors),
        Ok(pairs) => pairs.iter().for_each(|pair| in_force(pair, complaints)),
    }
}

/// Several `[[contact.pair]]` may lie over one another: what comes out must make sense too.
fn in_force(pair: &facing::Facing, complaints: &mut Complaints) {
    let (mu_s, mu_k) = (pair.contact.mu_static, pair.contact.mu_kinetic);
    if mu_k > mu_s {
        let remedy =
            format!("for {} it exceeds the mu_static in force, {mu_s:?}: lower it, or raise mu_static", pair.name);
        complaints.at("contact.pair", keys::PAIR).add("mu_kinetic", format!("{mu_k:?}"), remedy);
    }
}

fn backwall(scene: &Scene, abutment: &Abutment, complaints: &mut Complaints) {
    let Some(corners) = placed::abutment_face(scene, abutment) else { return };
    let mut at = complaints.at(format!("abutment.{}", abutment.name), keys::ABUTMENT);
    let key = if abutment.polygon.is_some() { "polygon_m" } else { "width_m" };
    let value = || corners.map(|c| numbers(&c.to_array())).join(", ");
    match Face::new(corners, placed::abutment_depth(scene, abutment)) {
        Err(error) => at.add(key, value(), format!("this is no contact face: {error}")),
        Ok(face) => {
            let Some(girder) = scene.girders.iter().find(|g| g.name == abutment.faces) else { return };
            let outward = placed::axes(girder).x_axis * abutment.end.sign();
            if scene.kind == Kind::Planar && face.normal.z.abs() > 1e-9 {
                at.add(
                    key,
                    value(),
                    "a planar girder cannot slide up a leaning face: make it vertical, or kind = \"spatial\"",
                );
            }
            if face.normal.dot(outward) >= 0.0 {
                let remedy =
                    format!("it faces away from {}: list the corners anticlockwise as seen from there", girder.name);
                at.add(key, value(), remedy);
            }
        }
    }
}

/// A body as placed.
struct Placed {
    label: String,
    /// Where a complaint about its place belongs, and what stands there.
    place: (String, &'static str, String),
    shape: Convex,
    stand: Stand,
    hull: AlignedBox,
    fixed: bool,
}

/// Bodies that reach into each other as placed; what `initial` does is a pressed start, and allowed.
pub(super) fn overlaps(scene: &Scene, complaints: &mut Complaints) {
    let bodies: Vec<Placed> = girders(scene).chain(abutments(scene)).collect();
    let (tree, mut near) = (Broad::of(bodies.iter().map(|body| body.hull)), Vec::new());
    for (n, later) in bodies.iter().enumerate() {
        tree.meeting(&later.hull, &mut near);
        let earlier = near.iter().take_while(|&&other| other < n).map(|&other| &bodies[other]);
        for earlier in earlier.filter(|earlier| !(earlier.fixed && later.fixed)) {
            if let Some(depth) = overlap(earlier, later) {
                let (table, key, value) = &later.place;
                let remedy = format!("{} reaches {depth:.3e} m into {}: move them apart", later.label, earlier.label);
                complaints.at(table.as_str(), keys::GIRDER).add(key, value, remedy);
            }
        }
    }
}

fn overlap(a: &Placed, b: &Placed) -> Option<f64> {
    let size = (a.hull.max - a.hull.min).length().max((b.hull.max - b.hull.min).length());
    let depth = -a.shape.separation(a.stand, &b.shape, b.stand);
    (depth > TOUCHING * size).then_some(depth)
}

fn girders(scene: &Scene) -> impl Iterator<Item = Placed> {
    scene.girders.iter().filter_map(|girder| {
        let shape = Convex::girder(&girder.prism())?;
        let axes: DMat3 = placed::axes(girder);
        let stand = Stand { place: DVec3::from(girder.position), attitude: DQuat::from_mat3(&axes) };
        Some(Placed {
            label: format!("girder {}", girder.name),
            place: (format!("girder.{}", girder.name), "position_m", numbers(&girder.position)),
            hull: shape.aligned_box(stand),
            shape,
            stand,
            fixed: false,
        })
    })
}

fn abutments(scene: &Scene) -> impl Iterator<Item = Placed> {
    scene.abutments.iter().filter_map(|abutment| {
        let face = placed::abutment_face(scene, abutment)?;
        let shape = Convex::behind(face, placed::abutment_depth(scene, abutment))?;
        let (key, value) = match abutment.gap {
            Some(gap) => ("gap_m", numbers(&[gap])),
            None => ("polygon_m", face.map(|c| numbers(&c.to_array())).join(", ")),
        };
        Some(Placed {
            label: format!("abutment {}", abutment.name),
            place: (format!("abutment.{}", abutment.name), key, value),
            hull: shape.aligned_box(Stand::WORLD),
            shape,
            stand: Stand::WORLD,
            fixed: true,
        })
    })
}
