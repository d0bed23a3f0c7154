//! Girders with what they stand on, and abutments, each for itself.

use super::complaints::{At, numbers};
use super::{bearings, elastic};
use crate::geometry::{End, Face};
use crate::language::{Text, message};
use crate::scene::domain::measures::bearing_place;
use crate::scene::keys;
use crate::scene::{Abutment, Direction, Girder, Kind, Setting};

pub(super) fn girder(girder: &Girder, setting: Setting, at: &mut At<'_>) {
    let kind = setting.kind;
    at.all(girder);
    at.fits(girder, kind);
    at.below("seat_m", keys::SEAT).all(&girder.seat);
    start(girder, kind, at);
    end_faces(girder, at);
    far_bearings(girder, setting, at);
    elastic::check(girder, kind, at);
    bearings::check(girder, setting, needs_vertical(girder, kind), at);
}

/// Whether something must carry the girder's weight.
fn needs_vertical(girder: &Girder, kind: Kind) -> bool {
    kind == Kind::Spatial && !girder.held.contains(&Direction::Z)
}

fn start(girder: &Girder, kind: Kind, at: &mut At<'_>) {
    let (initial, push) = (&girder.initial, &girder.push);
    let mut table = at.below("initial", keys::INITIAL);
    table.all(initial);
    table.fits(initial, kind);
    level("displacement_m", &initial.displacement, kind, &mut table);
    level("velocity_m_s", &initial.velocity, kind, &mut table);
    let mut table = at.below("push", keys::PUSH);
    table.all(push);
    table.fits(push, kind);
    level("force_n", &push.force, kind, &mut table);
}

/// Of three numbers a planar scene has two.
fn level(key: &str, vector: &[f64; 3], kind: Kind, at: &mut At<'_>) {
    if kind == Kind::Planar && vector[2] != 0.0 {
        let remedy = Text::new("wrong-vertical-in-plan");
        at.add(key, numbers(vector), remedy);
    }
}

/// Sound numbers may still make no face: an extreme skew, or a side a million million times the other.
fn end_faces(girder: &Girder, at: &mut At<'_>) {
    if !is_sound(girder) {
        return;
    }
    let prism = girder.prism();
    let face = Face::new(prism.end_face(End::Plus), prism.depth_behind_end());
    let finite = prism.corners().iter().all(|corner| corner.is_finite());
    if !finite || face.is_err() {
        let value = message!(
            "found-ends",
            "width" => format!("{:?}", girder.width),
            "thickness" => format!("{:?}", girder.thickness),
            "skew" => format!("{:?}", girder.skew_deg)
        );
        at.add("", value, Text::new("wrong-ends"));
    }
}

/// Whether sizes and skew make a prism.
fn is_sound(girder: &Girder) -> bool {
    let sizes = [girder.length, girder.width, girder.thickness];
    sizes.iter().all(|v| v.is_finite() && *v > 0.0) && girder.skew_deg > 0.0 && girder.skew_deg < 180.0
}

/// Distance from G over that of the farthest corner at which a place can only be in another unit: in mm for m it is a thousand times as
/// far, at least four hundred times the farthest corner.
pub(super) const FAR: f64 = 100.0;

/// Bearings so far outside that their places can only be in another unit.
fn far_bearings(girder: &Girder, setting: Setting, at: &mut At<'_>) {
    let far = if is_sound(girder) { bearing_place(girder, setting) } else { 0.0 };
    if far > FAR {
        let value = message!("found-bearing-far", "far" => format!("{far:.3e}"));
        at.add("bearings", value, Text::new("wrong-bearing-far"));
    }
}

pub(super) fn abutment(abutment: &Abutment, at: &mut At<'_>) {
    at.all(abutment);
    if let Some(backfill) = &abutment.backfill {
        let mut at = at.below("backfill", keys::BACKFILL);
        at.all(backfill);
        match (backfill.fuse_stiffness, backfill.fuse_force) {
            (Some(stiffness), None) => {
                at.add("fuse_stiffness_n_per_m", stiffness, Text::new("wrong-fuse-force-missing"));
            }
            (None, Some(force)) => at.add("fuse_force_n", force, Text::new("wrong-fuse-stiffness-missing")),
            _ => {}
        }
    }
    match (abutment.gap, &abutment.polygon) {
        (None, None) => at.add("gap_m", Text::new("found-nothing"), Text::new("wrong-no-face")),
        (Some(_), Some(_)) => {
            at.add("gap_m", message!("found-both", "one" => "gap_m", "other" => "polygon_m"), Text::new("wrong-both"));
        }
        (Some(_), None) => {}
        (None, Some(corners)) => polygon(abutment, corners, at),
    }
}

fn polygon(abutment: &Abutment, corners: &[[f64; 3]], at: &mut At<'_>) {
    if corners.len() != 4 {
        at.add("polygon_m", message!("found-corners", "count" => corners.len()), Text::new("wrong-corners"));
    }
    let beside = [("width_m", abutment.width), ("height_m", abutment.height), ("offset_m", abutment.offset)];
    for (key, value) in beside {
        if let Some(value) = value {
            at.add(key, value, Text::new("wrong-beside-polygon"));
        }
    }
}
