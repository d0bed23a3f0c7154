//! Scenes whose bodies are unusual: slender or square, spinning, without bearings, held.

use crate::geometry::End;
use crate::scene::{Bearings, Direction, Kind, PerDirection, Scene};
use crate::study::stability::parts::{self, SKEW};
use crate::study::stability::random::{Random, three_digits};

/// Needles, plates and squares at the ends of the range of skew.
pub(super) fn slender(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let mut scene = parts::blank(parts::kind(random));
    let length = random.log(0.05, 50.0);
    let width = length * random.pick(&[1e-3, 1e-2, 1.0, 1.0, 30.0]);
    let skew = random.pick(&[SKEW[0], SKEW[1], 45.0, 90.0, 135.0]);
    let first = parts::shaped(random, [length, width], skew);
    let gap = three_digits(length * random.log(1e-6, 1e-2));
    let count = 1 + random.below(2);
    scene.girders = parts::row(random, &first, count, gap, false);
    parts::walls(random, &mut scene, gap);
    shaken(random, &mut scene, f, gap);
    scene
}

/// Bodies that spin fast when they reach the wall.
pub(super) fn spinning(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let mut scene = parts::blank(Kind::Planar);
    let first = parts::girder(random);
    let gap = three_digits(first.length * random.log(1e-4, 0.3));
    let count = 1 + random.below(2);
    scene.girders = parts::row(random, &first, count, gap, false);
    parts::walls(random, &mut scene, gap);
    shaken(random, &mut scene, f, gap);
    for girder in &mut scene.girders {
        girder.initial.spin_deg_s = three_digits(random.sign() * 360.0 * f * random.log(0.01, 10.0));
    }
    scene
}

/// No bearings at all: girders fly between walls, and fall where they can.
pub(super) fn free(random: &mut Random) -> Scene {
    let mut scene = parts::blank(parts::kind(random));
    let first = parts::girder(random);
    let gap = three_digits(first.length * random.log(1e-4, 0.1));
    let count = 1 + random.below(3);
    scene.girders = parts::row(random, &first, count, gap, false);
    parts::walls(random, &mut scene, gap);
    if scene.kind == Kind::Spatial && random.chance(0.7) {
        scene.gravity = 0.0;
    }
    scene.contact = parts::contact(random);
    let crossings = random.log(0.1, 10.0);
    parts::kick(random, &mut scene, crossings, gap);
    parts::last(random, &mut scene, &[crossings]);
    scene
}

/// Spatial bodies that may only do what planar ones do, or less.
pub(super) fn held(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let mut scene = parts::blank(Kind::Spatial);
    let first = parts::girder(random);
    let gap = three_digits(first.length * random.log(1e-5, 1e-2));
    let count = 1 + random.below(2);
    scene.girders = parts::row(random, &first, count, gap, false);
    parts::wall(&mut scene, End::Plus, gap);
    shaken(random, &mut scene, f, gap);
    let extra = random.pick(&[None, None, Some(Direction::Yaw), Some(Direction::Y)]);
    for girder in &mut scene.girders {
        girder.held = vec![Direction::Z, Direction::Roll, Direction::Pitch];
        girder.held.extend(extra);
        if let Some(Bearings::Shared(shared)) = &mut girder.bearings {
            (shared.vertical_frequency_hz, shared.frequency_hz) = (None, PerDirection::Both(f));
        }
    }
    scene
}

fn shaken(random: &mut Random, scene: &mut Scene, bearing_hz: f64, reach: f64) {
    let ground = random.log(0.1, 10.0);
    parts::stand(random, scene, bearing_hz);
    scene.contact = parts::contact(random);
    if random.chance(0.7) {
        scene.motion = parts::sine(random, ground, bearing_hz, reach);
    }
    parts::kick(random, scene, bearing_hz, reach);
    parts::last(random, scene, &[ground, bearing_hz]);
}
