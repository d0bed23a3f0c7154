//! Scenes where geometry is on the edge: faces almost parallel, corners on corners, edges at borders, touches that graze.

use crate::geometry::End;
use crate::scene::{Bearings, Kind, PairSettings, PerDirection, Scene};
use crate::study::stability::parts;
use crate::study::stability::random::{Random, three_digits};

/// Two girders, or a girder and a wall, whose faces are parallel but for 1e-3 … 1e-12 degrees, or exactly.
pub(super) fn parallel(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let kind = parts::kind(random);
    let mut scene = parts::blank(kind);
    let first = parts::girder(random);
    let tilt = if random.chance(0.2) { 0.0 } else { random.sign() * random.log(1e-12, 1e-3) };
    // Ends tilted against each other must not overlap as placed.
    let room = 2.0 * first.prism().end_length() * tilt.abs().to_radians();
    let gap = parts::gap(random).max(three_digits(room * 1.5));
    let count = 1 + random.below(3);
    scene.girders = parts::row(random, &first, count, gap, false);
    if count > 1 && random.chance(0.5) {
        scene.girders[1].skew_deg += tilt;
    } else {
        scene.girders[0].initial.rotation_deg = tilt;
    }
    parts::wall(&mut scene, End::Plus, gap);
    finish(random, &mut scene, f, gap.max(1e-5 * first.length));
    scene
}

/// Two girders whose ends overlap sideways by very little: corner on corner.
pub(super) fn corner(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let kind = parts::kind(random);
    let mut scene = parts::blank(kind);
    let (first, gap) = (parts::girder(random), parts::gap(random));
    scene.girders = parts::row(random, &first, 2, gap, false);
    let skew = first.skew_deg.to_radians();
    // Along the face by all of its length but a part of 1e-12 … 1e-3; by all of it exactly only where the pair is declared.
    let exact = random.chance(0.3);
    let side = random.sign();
    let part = if exact { 1.0 } else { 1.0 - random.log(1e-12, 1e-3) };
    let along = side * first.prism().end_length() * part;
    let shift = if first.skew_deg == 90.0 { [0.0, along] } else { [along * skew.cos(), along * skew.sin()] };
    scene.girders[1].position[0] += shift[0];
    scene.girders[1].position[1] += shift[1];
    if exact {
        scene.contact.pairs.push(declared(["g0", "g1"], [End::Plus, End::Minus]));
    }
    let pairs = std::mem::take(&mut scene.contact.pairs);
    finish(random, &mut scene, f, gap.max(1e-4 * first.length));
    scene.contact.pairs = pairs;
    scene
}

/// A pair that is not found by itself.
fn declared(between: [&str; 2], ends: [End; 2]) -> PairSettings {
    PairSettings { between: between.map(str::to_owned), ends: Some(ends), ..PairSettings::default() }
}

/// A wall almost as wide as the girder's end, or whose side stands before a corner: nodes slide off and miss.
pub(super) fn border(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let kind = parts::kind(random);
    let mut scene = parts::blank(kind);
    let (first, gap) = (parts::girder(random), parts::gap(random));
    let end = first.prism().end_length();
    scene.girders = vec![first.clone()];
    parts::wall(&mut scene, End::Plus, gap);
    let wall = &mut scene.abutments[0];
    if random.chance(0.5) {
        wall.width = Some(end * (1.0 + random.hair()));
    } else {
        wall.width = Some(end * 3.0);
        wall.offset = Some(random.sign() * end * (1.0 + random.hair()));
    }
    if kind == Kind::Spatial && random.chance(0.5) {
        wall.height = Some(first.thickness * (1.0 + random.hair()));
    }
    finish(random, &mut scene, f, gap.max(1e-3 * first.length));
    scene
}

/// Free undamped swings whose end just meets the face, just misses it, or exactly touches.
pub(super) fn grazing(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let mut scene = parts::blank(Kind::Planar);
    let first = parts::girder(random);
    let gap = random.log(1e-5, 0.1);
    let count = 1 + random.below(2);
    scene.girders = parts::row(random, &first, count, gap, false);
    if count == 1 || random.chance(0.5) {
        parts::wall(&mut scene, End::Plus, gap);
    }
    parts::stand(random, &mut scene, f);
    for girder in &mut scene.girders {
        if let Some(Bearings::Shared(shared)) = &mut girder.bearings {
            shared.damping_ratio = PerDirection::Both(0.0);
        }
    }
    // Two neighbours would meet half-way: only the last moves away from its home.
    if let Some(girder) = scene.girders.last_mut() {
        girder.initial.displacement[0] = -gap * (1.0 + random.hair()) * random.pick(&[1.0, 1.0, 0.999]);
    }
    if count == 2 {
        scene.girders[1].initial.displacement[0] *= -1.0;
    }
    scene.contact = parts::contact(random);
    parts::last(random, &mut scene, &[f]);
    scene
}

/// Bearings, contact numbers, ground and duration.
fn finish(random: &mut Random, scene: &mut Scene, bearing_hz: f64, reach: f64) {
    let ground = random.log(0.1, 10.0);
    parts::stand(random, scene, bearing_hz);
    scene.contact = parts::contact(random);
    scene.motion = parts::sine(random, ground, bearing_hz, reach);
    if random.chance(0.5) {
        parts::kick(random, scene, bearing_hz, reach);
    }
    parts::last(random, scene, &[ground, bearing_hz]);
}
