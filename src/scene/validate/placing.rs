//! Bodies among each other: names, who faces whom, faces, overlaps.

use std::collections::BTreeSet;

use glam::DVec3;

use super::complaints::{At, Complaints, numbers};
use crate::geometry::Face;
use crate::geometry::broad;
use crate::geometry::shape::{self, AlignedBox, Convex, Stand};
use crate::language::{Text, message, six};
use crate::scene::shown::is_obeyed;
use crate::scene::{Abutment, BackfillLaw, Kind, ResolvedBackfill, Scene, facing, keys, placed};

/// Bodies may reach this part of their size into each other: placing by hand touches to rounding.
const TOUCHING: f64 = 1e-9;

/// Characters that would break a table's heading, a `--set` path, or the name of a pair.
const RESERVED: &[char] = &['.', ',', ';', '"', '\'', '=', '|', '[', ']'];

/// Names that a plot, `ground.x` and `energy.friction`, and the marks of a measurement, `table`, have for something else.
const TAKEN: [&str; 3] = ["ground", "energy", "table"];

pub(super) fn names(scene: &Scene, complaints: &mut Complaints) {
    let girders = scene.girders.iter().enumerate().map(|(n, g)| ("girder", n, &g.name));
    let abutments = scene.abutments.iter().enumerate().map(|(n, a)| ("abutment", n, &a.name));
    let piers = scene.piers.iter().enumerate().map(|(n, p)| ("pier", n, &p.name));
    let mut seen = BTreeSet::new();
    let devices = scene.devices().into_iter().map(|(id, device)| (id.kind.label(), id.number, device.ends().name));
    let bodies = girders.chain(abutments).chain(piers).map(|(kind, n, name)| (kind, n, name.as_str()));
    // Grounds are called by their own key, so that one may have the name of a body.
    let mut grounds = BTreeSet::new();
    let named = scene.grounds.iter().enumerate().map(|(n, ground)| ("ground", n, ground.name.as_str()));
    for (kind, n, name) in bodies.chain(devices).chain(named) {
        let seen = if kind == "ground" { &mut grounds } else { &mut seen };
        let fault = if name.trim().is_empty() {
            Text::new("wrong-nameless")
        } else if name.trim() != name || name.contains(|c: char| RESERVED.contains(&c) || is_obeyed(c)) {
            Text::new("wrong-name")
        } else if kind != "ground" && TAKEN.contains(&name) {
            Text::new("wrong-name-taken")
        } else if !seen.insert(name) {
            Text::new(if kind == "ground" { "wrong-ground-twice" } else { "wrong-name-twice" })
        } else {
            continue;
        };
        complaints.at(format!("{kind}[{n}]"), keys::GIRDER).add("name", format!("{name:?}"), fault);
    }
}

/// Abutment faces, and everything that facing ends can be wrong about.
pub(super) fn faces(scene: &Scene, complaints: &mut Complaints) -> Vec<facing::Facing> {
    for abutment in &scene.abutments {
        backwall(scene, abutment, complaints);
    }
    let pairs = facing::find(scene).unwrap_or_else(|errors| {
        complaints.extend(errors);
        Vec::new()
    });
    for pair in &pairs {
        in_force(pair, complaints);
    }
    pairs
}

/// Several `[[contact.pair]]` may lie over one another: what comes out must make sense too.
fn in_force(pair: &facing::Facing, complaints: &mut Complaints) {
    let (mu_s, mu_k) = (pair.contact.mu_static, pair.contact.mu_kinetic);
    if mu_k > mu_s {
        let remedy = message!("wrong-pair-friction", "pair" => pair.name.as_str(), "mus" => format!("{mu_s:?}"));
        complaints.at("contact.pair", keys::PAIR).add("mu_kinetic", format!("{mu_k:?}"), remedy);
    }
}

fn backwall(scene: &Scene, abutment: &Abutment, complaints: &mut Complaints) {
    let Some(corners) = placed::abutment_face(scene, abutment) else { return };
    let mut at = complaints.of("abutment", &abutment.name, keys::ABUTMENT);
    let key = if abutment.polygon.is_some() { "polygon_m" } else { "width_m" };
    let value = || corners.map(|c| numbers(&c.to_array())).join(", ");
    match Face::new(corners, placed::abutment_depth(scene, abutment)) {
        Err(error) => at.add(key, value(), message!("wrong-face", "error" => error.to_string())),
        Ok(face) => {
            let Some(girder) = scene.girders.iter().find(|g| g.name == abutment.faces) else { return };
            let outward = placed::axes(girder).x_axis * abutment.end.sign();
            if scene.kind == Kind::Planar && face.normal.z.abs() > 1e-9 {
                at.add(key, value(), Text::new("wrong-leaning-face"));
            }
            if let Some(soil) = abutment.soil(scene) {
                backfill(&soil, face.normal.z, &mut at.below("backfill", keys::BACKFILL));
            }
            if face.normal.dot(outward) >= 0.0 {
                let remedy = message!("wrong-face-away", "girder" => girder.name.as_str());
                at.add(key, value(), remedy);
            }
        }
    }
}

/// Numbers of soil that follow from each other.
fn backfill(soil: &ResolvedBackfill, leaning: f64, at: &mut At<'_>) {
    if leaning.abs() > 1e-9 {
        at.add("", Text::new("found-leaning-backwall"), Text::new("wrong-leaning-backwall"));
    }
    if soil.law == BackfillLaw::MeanStiffness && soil.stiffness * soil.limit <= soil.ultimate {
        let remedy = message!(
            "wrong-soil-never-fails",
            "force" => format!("{:?}", soil.ultimate),
            "push" => format!("{:?}", soil.limit)
        );
        at.add("stiffness_n_per_m", format!("{:?}", soil.stiffness), remedy);
    } else if soil.unloading < soil.first_slope() {
        let remedy = message!("wrong-soil-unloads", "stiffness" => format!("{:?}", soil.first_slope()));
        at.add("unloading_stiffness_n_per_m", format!("{:?}", soil.unloading), remedy);
    }
}

/// A planar scene is a cut at one height, which every body has: bodies above one another do not touch, and would in plan.
pub(super) fn heights(scene: &Scene, complaints: &mut Complaints) {
    if scene.kind != Kind::Planar {
        return;
    }
    // A wall without a polygon is as high as its girder.
    let is_placed = |body: &Placed| match body.side {
        Body::Girder(_) => true,
        Body::Abutment(n) => scene.abutments[n].polygon.is_some(),
    };
    let bodies: Vec<Placed> = girders(scene).chain(abutments(scene)).filter(is_placed).collect();
    let Some(first) = bodies.first() else { return };
    let range = |body: &Placed| {
        let heights = || body.corners.iter().map(|corner| corner.z);
        [heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max)]
    };
    let mut common = range(first);
    for body in &bodies[1..] {
        let [low, high] = range(body);
        common = if low < common[1] && high > common[0] {
            [low.max(common[0]), high.min(common[1])]
        } else {
            let remedy = message!("wrong-plan-height", "low" => six(common[0]), "high" => six(common[1]));
            match body.side {
                Body::Girder(n) => {
                    let girder = &scene.girders[n];
                    complaints.of("girder", &girder.name, keys::GIRDER).add(
                        "position_m",
                        numbers(&girder.position),
                        remedy,
                    );
                }
                Body::Abutment(n) => {
                    let found = message!("found-heights", "low" => six(low), "high" => six(high));
                    complaints.of("abutment", &scene.abutments[n].name, keys::ABUTMENT).add("polygon_m", found, remedy);
                }
            }
            common
        };
    }
}

/// A body as placed: its corners in the world, and who it is by its number in the scene.
struct Placed {
    side: Body,
    corners: [DVec3; 8],
    hull: AlignedBox,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Body {
    Girder(usize),
    Abutment(usize),
}

/// Bodies that reach into each other as placed; what `initial` does is a pressed start, and allowed.
pub(super) fn overlaps(scene: &Scene, complaints: &mut Complaints) {
    let mut bodies: Vec<Placed> = girders(scene).chain(abutments(scene)).collect();
    if scene.kind == Kind::Planar {
        stand_up(&mut bodies);
    }
    let mut pairs = broad::pairs(&bodies.iter().map(|body| body.hull).collect::<Vec<_>>());
    pairs.sort_unstable_by_key(|&(earlier, later)| (later, earlier));
    for [earlier, later] in pairs.into_iter().map(|(earlier, later)| [&bodies[earlier], &bodies[later]]) {
        if let Some(depth) = overlap(earlier, later) {
            complain(scene, [earlier, later], depth, complaints);
        }
    }
}

fn complain(scene: &Scene, [earlier, later]: [&Placed; 2], depth: f64, complaints: &mut Complaints) {
    let label = |body: &Placed| match body.side {
        Body::Girder(n) => message!("found-girder", "name" => scene.girders[n].name.as_str()),
        Body::Abutment(n) => message!("found-abutment", "name" => scene.abutments[n].name.as_str()),
    };
    let remedy = message!("wrong-overlap", "one" => label(later), "depth" => six(depth), "other" => label(earlier));
    match later.side {
        Body::Girder(n) => {
            let girder = &scene.girders[n];
            let at = &mut complaints.of("girder", &girder.name, keys::GIRDER);
            at.add("position_m", numbers(&girder.position), remedy);
        }
        Body::Abutment(n) => {
            let abutment = &scene.abutments[n];
            let (key, value) = if let Some(gap) = abutment.gap {
                ("gap_m", numbers(&[gap]))
            } else {
                let face = placed::abutment_face(scene, abutment).unwrap_or_default();
                ("polygon_m", face.map(|c| numbers(&c.to_array())).join(", "))
            };
            complaints.of("abutment", &abutment.name, keys::ABUTMENT).add(key, value, remedy);
        }
    }
}

/// Makes bodies whose heights mean nothing higher than they are long: none gets out of another upwards.
fn stand_up(bodies: &mut [Placed]) {
    let longest = bodies.iter().map(|body| (body.hull.max - body.hull.min).length()).fold(0.0, f64::max);
    for body in bodies {
        let middle = body.corners.iter().map(|corner| corner.z).sum::<f64>() / body.corners.len() as f64;
        for corner in &mut body.corners {
            corner.z = if corner.z < middle { -longest } else { longest };
        }
        body.hull = AlignedBox::around(&body.corners);
    }
}

/// Overlap of two bodies \[m\]; two abutments may.
fn overlap(a: &Placed, b: &Placed) -> Option<f64> {
    let fixed = |body: &Placed| matches!(body.side, Body::Abutment(_));
    // Most neighbours stand apart along a side of one of them: only for the others bodies are built.
    if (fixed(a) && fixed(b)) || shape::stand_apart(&a.corners, &b.corners) {
        return None;
    }
    let size = (a.hull.max - a.hull.min).length().max((b.hull.max - b.hull.min).length());
    let (one, other) = (Convex::between(a.corners)?, Convex::between(b.corners)?);
    let depth = -one.separation(Stand::WORLD, &other, Stand::WORLD);
    (depth > TOUCHING * size).then_some(depth)
}

fn girders(scene: &Scene) -> impl Iterator<Item = Placed> {
    scene.girders.iter().enumerate().map(|(n, girder)| {
        let (axes, place) = (placed::axes(girder), DVec3::from(girder.position));
        let corners = girder.prism().corners().map(|corner| place + axes * corner);
        Placed { side: Body::Girder(n), corners, hull: AlignedBox::around(&corners) }
    })
}

fn abutments(scene: &Scene) -> impl Iterator<Item = Placed> {
    scene.abutments.iter().enumerate().filter_map(|(n, abutment)| {
        let face = placed::abutment_face(scene, abutment)?;
        let corners = shape::block_behind(face, placed::abutment_depth(scene, abutment));
        Some(Placed { side: Body::Abutment(n), corners, hull: AlignedBox::around(&corners) })
    })
}
