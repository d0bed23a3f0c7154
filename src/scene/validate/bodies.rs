//! Girders with what they stand on, and abutments, each for itself.

use super::complaints::{At, numbers};
use crate::geometry::{End, Face};
use crate::scene::domain::measures::bearing_place;
use crate::scene::keys::{self, Range};
use crate::scene::{Abutment, Bearing, Bearings, Direction, Girder, Kind, SharedBearings};

pub(super) fn girder(girder: &Girder, kind: Kind, at: &mut At<'_>) {
    at.all(girder);
    at.below("seat_m", keys::SEAT).all(&girder.seat);
    start(girder, kind, at);
    end_faces(girder, at);
    far_bearings(girder, kind, at);
    elastic(girder, kind, at);
    match &girder.bearings {
        None => {}
        Some(Bearings::Shared(bearings)) => {
            let mut table = at.below("bearings", keys::BEARINGS);
            table.fits(bearings, kind);
            shared(bearings, needs_vertical(girder, kind), &mut table);
        }
        Some(Bearings::Each(bearings)) => single(bearings, needs_vertical(girder, kind), kind, at),
    }
}

/// Numbers of an elastic girder, and what it cannot be yet.
fn elastic(girder: &Girder, kind: Kind, at: &mut At<'_>) {
    let Some(elastic) = &girder.elastic else { return };
    if kind == Kind::Spatial {
        let remedy = "elastic girders are known in planar scenes only so far: set kind = \"planar\", or leave it out";
        at.add("elastic", "an elastic girder in a spatial scene", remedy);
    }
    if let Some(Bearings::Each(bearings)) = &girder.bearings
        && bearings.iter().any(|bearing| bearing.yield_force.is_some())
    {
        let remedy = "bearings of an elastic girder are linear so far: leave out yield_force_n, or `elastic`";
        at.add("elastic", "an elastic girder on bearings that yield", remedy);
    }
    if girder.bearings.as_ref().is_some_and(|bearings| bearings.piers(girder).iter().any(Option::is_some)) {
        let remedy =
            "bearings of an elastic girder stand on the ground so far: leave out the pier under them, or `elastic`";
        at.add("elastic", "an elastic girder on a pier", remedy);
    }
    let mut at = at.below("elastic", keys::ELASTIC);
    at.all(elastic);
    for (key, value, remedy) in elastic.faults(girder) {
        at.add(key, value, remedy);
    }
    if let Some(rayleigh) = &elastic.rayleigh {
        at.below("rayleigh", keys::RAYLEIGH).all(rayleigh);
    }
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

/// Of three numbers a planar scene knows two.
fn level(key: &str, vector: &[f64; 3], kind: Kind, at: &mut At<'_>) {
    if kind == Kind::Planar && vector[2] != 0.0 {
        let remedy = "a planar scene knows no vertical: give two numbers, or set kind = \"spatial\"";
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
        let value = format!("{:?} m × {:?} m ends at {:?}°", girder.width, girder.thickness, girder.skew_deg);
        at.add("", value, "no face can be computed from these ends: choose sizes and skew less extreme");
    }
}

/// Whether sizes and skew make a prism.
fn is_sound(girder: &Girder) -> bool {
    let sizes = [girder.length, girder.width, girder.thickness];
    sizes.iter().all(|v| v.is_finite() && *v > 0.0) && girder.skew_deg > 0.0 && girder.skew_deg < 180.0
}

/// Bearings so far outside that their places can only be in another unit.
fn far_bearings(girder: &Girder, kind: Kind, at: &mut At<'_>) {
    /// Places in mm for m are a thousand times as far, at least four hundred times the farthest corner.
    const FAR: f64 = 100.0;
    let far = if is_sound(girder) { bearing_place(girder, kind) } else { 0.0 };
    if far > FAR {
        let value = format!("a bearing {far:.3e} times as far from G as the farthest corner");
        at.add("bearings", value, "no bearing carries a girder from there: give its place in m, relative to G");
    }
}

fn shared(bearings: &SharedBearings, needs_vertical: bool, at: &mut At<'_>) {
    at.all_but("vertical_frequency_hz", bearings);
    match bearings.vertical_frequency_hz {
        Some(f) if needs_vertical => at.number("vertical_frequency_hz", f),
        // Where it carries nothing it may say so.
        Some(f) => at.obeys("vertical_frequency_hz", f, Range::NotNegative),
        None if needs_vertical => {
            let remedy = "a girder in a spatial scene stands on its bearings: give their vertical frequency in Hz";
            at.add("vertical_frequency_hz", "nothing", remedy);
        }
        None => {}
    }
    let (key, places) = match (&bearings.at, &bearings.at_skewed) {
        (Some(places), None) => ("at_m", places),
        (None, Some(places)) => ("at_skewed_m", places),
        (None, None) => {
            return at.add("at_m", "nothing", "give the bearings' places: at_m = [[x, y], …], or at_skewed_m");
        }
        (Some(_), Some(_)) => return at.add("at_m", "at_m and at_skewed_m", "give one of the two"),
    };
    if places.is_empty() {
        at.add(key, "[]", "give at least one place [x, y], or leave out `bearings`");
    }
}

fn single(bearings: &[Bearing], needs_vertical: bool, kind: Kind, at: &mut At<'_>) {
    if bearings.is_empty() {
        at.add("bearings", "[]", "give at least one bearing, or leave out `bearings`");
    }
    for (n, bearing) in bearings.iter().enumerate() {
        let key = format!("bearings[{n}]");
        let mut table = at.below(&key, keys::BEARING);
        table.all(bearing);
        table.fits(bearing, kind);
        match (bearing.yield_force, bearing.yield_displacement) {
            (Some(_), None) => {
                table.add("yield_displacement_m", "nothing", "give the displacement at which the bearing yields, in m");
            }
            (None, Some(_)) => table.add("yield_force_n", "nothing", "give the force Q in N, or leave out both"),
            _ => {}
        }
        if bearing.per_axis.is_some() && bearing.yield_force.is_none() {
            table.add("yields_per_axis", "a switch", "give yield_force_n and yield_displacement_m, or leave it out");
        }
    }
    if needs_vertical && !bearings.is_empty() && bearings.iter().all(|b| b.stiffness[2] == 0.0) {
        let remedy = "a girder in a spatial scene stands on its bearings: give a third, vertical number";
        at.add("bearings[0].stiffness_n_per_m", numbers(&bearings[0].stiffness[..2]), remedy);
    }
}

pub(super) fn abutment(abutment: &Abutment, at: &mut At<'_>) {
    at.all(abutment);
    if let Some(backfill) = &abutment.backfill {
        let mut at = at.below("backfill", keys::BACKFILL);
        at.all(backfill);
        match (backfill.fuse_stiffness, backfill.fuse_force) {
            (Some(stiffness), None) => {
                at.add("fuse_stiffness_n_per_m", stiffness, "give fuse_force_n as well, or neither");
            }
            (None, Some(force)) => at.add("fuse_force_n", force, "give fuse_stiffness_n_per_m as well, or neither"),
            _ => {}
        }
    }
    match (abutment.gap, &abutment.polygon) {
        (None, None) => at.add("gap_m", "nothing", "give gap_m, or the face's corners as polygon_m"),
        (Some(_), Some(_)) => at.add("gap_m", "gap_m and polygon_m", "give one of the two"),
        (Some(_), None) => {}
        (None, Some(corners)) => polygon(abutment, corners, at),
    }
}

fn polygon(abutment: &Abutment, corners: &[[f64; 3]], at: &mut At<'_>) {
    if corners.len() != 4 {
        at.add("polygon_m", format!("{} corners", corners.len()), "give four corners [x, y, z]");
    }
    let beside = [("width_m", abutment.width), ("height_m", abutment.height), ("offset_m", abutment.offset)];
    for (key, value) in beside {
        if let Some(value) = value {
            at.add(key, value, "polygon_m says it already: leave this out");
        }
    }
}
