//! Scenes whose bodies are unusual: slender or square, spinning, without bearings, held.

use crate::geometry::End;
use crate::scene::{Bearings, Direction, Kind, PerDirection, Scene};
use crate::study::stability::dice::{Dice, three_digits};
use crate::study::stability::parts::{self, SKEW};

/// Needles, plates and squares at the ends of the range of skew.
pub(super) fn slender(dice: &mut Dice) -> Scene {
    let f = dice.log(0.1, 10.0);
    let mut scene = parts::blank(parts::kind(dice));
    let length = dice.log(0.05, 50.0);
    let width = length * dice.pick(&[1e-3, 1e-2, 1.0, 1.0, 30.0]);
    let skew = dice.pick(&[SKEW[0], SKEW[1], 45.0, 90.0, 135.0]);
    let first = parts::shaped(dice, [length, width], skew);
    let gap = three_digits(length * dice.log(1e-6, 1e-2));
    let count = 1 + dice.below(2);
    scene.girders = parts::row(dice, &first, count, gap, false);
    parts::walls(dice, &mut scene, gap);
    shaken(dice, &mut scene, f, gap);
    scene
}

/// Bodies that turn fast when they come to the wall.
pub(super) fn spinning(dice: &mut Dice) -> Scene {
    let f = dice.log(0.1, 10.0);
    let mut scene = parts::blank(Kind::Planar);
    let first = parts::girder(dice);
    let gap = three_digits(first.length * dice.log(1e-4, 0.3));
    let count = 1 + dice.below(2);
    scene.girders = parts::row(dice, &first, count, gap, false);
    parts::walls(dice, &mut scene, gap);
    shaken(dice, &mut scene, f, gap);
    for girder in &mut scene.girders {
        girder.initial.spin_deg_s = three_digits(dice.sign() * 360.0 * f * dice.log(0.01, 10.0));
    }
    scene
}

/// No bearings at all: girders fly between walls, and fall where they can.
pub(super) fn free(dice: &mut Dice) -> Scene {
    let mut scene = parts::blank(parts::kind(dice));
    let first = parts::girder(dice);
    let gap = three_digits(first.length * dice.log(1e-4, 0.1));
    let count = 1 + dice.below(3);
    scene.girders = parts::row(dice, &first, count, gap, false);
    parts::walls(dice, &mut scene, gap);
    if scene.kind == Kind::Spatial && dice.chance(0.7) {
        scene.gravity = 0.0;
    }
    scene.contact = parts::contact(dice);
    let crossings = dice.log(0.1, 10.0);
    parts::kick(dice, &mut scene, crossings, gap);
    parts::last(dice, &mut scene, &[crossings]);
    scene
}

/// Spatial bodies that may only do what planar ones do, or less.
pub(super) fn held(dice: &mut Dice) -> Scene {
    let f = dice.log(0.1, 10.0);
    let mut scene = parts::blank(Kind::Spatial);
    let first = parts::girder(dice);
    let gap = three_digits(first.length * dice.log(1e-5, 1e-2));
    let count = 1 + dice.below(2);
    scene.girders = parts::row(dice, &first, count, gap, false);
    parts::wall(&mut scene, End::Plus, gap);
    shaken(dice, &mut scene, f, gap);
    let extra = dice.pick(&[None, None, Some(Direction::Yaw), Some(Direction::Y)]);
    for girder in &mut scene.girders {
        girder.held = vec![Direction::Z, Direction::Roll, Direction::Pitch];
        girder.held.extend(extra);
        if let Some(Bearings::Shared(shared)) = &mut girder.bearings {
            (shared.vertical_frequency_hz, shared.frequency_hz) = (None, PerDirection::Both(f));
        }
    }
    scene
}

fn shaken(dice: &mut Dice, scene: &mut Scene, bearing_hz: f64, reach: f64) {
    let ground = dice.log(0.1, 10.0);
    parts::stand(dice, scene, bearing_hz);
    scene.contact = parts::contact(dice);
    if dice.chance(0.7) {
        scene.motion = parts::sine(dice, ground, bearing_hz, reach);
    }
    parts::kick(dice, scene, bearing_hz, reach);
    parts::last(dice, scene, &[ground, bearing_hz]);
}
