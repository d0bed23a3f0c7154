//! Scenes shaken by the ground: anything at all, resonance, records, an hour.

use crate::geometry::End;
use crate::scene::{Bearings, Kind, Motion, PerDirection, Scene};
use crate::study::stability::dice::{Dice, three_digits};
use crate::study::stability::parts::{self, FREQUENCY};

/// Shortest way that counts as a gap, in parts of a girder's length.
const LEAST_REACH: f64 = 1e-4;

/// Everything over its whole range.
pub(super) fn wide(dice: &mut Dice) -> Scene {
    let kind = parts::kind(dice);
    any(dice, kind)
}

/// The same with six degrees of freedom.
pub(super) fn spatial(dice: &mut Dice) -> Scene {
    any(dice, Kind::Spatial)
}

fn any(dice: &mut Dice, kind: Kind) -> Scene {
    let (ground, bearing) = (dice.log(FREQUENCY[0], FREQUENCY[1]), dice.log(FREQUENCY[0], FREQUENCY[1]));
    let (mut scene, reach) = placed(dice, kind, bearing);
    match dice.below(4) {
        0 => {}
        1 => scene.motion = parts::record(dice, ground, bearing, reach),
        _ => scene.motion = parts::sine(dice, ground, bearing, reach),
    }
    if scene.motion == Motion::None || dice.chance(0.5) {
        parts::kick(dice, &mut scene, bearing, reach);
    }
    parts::last(dice, &mut scene, &[ground, bearing]);
    scene
}

/// One to five girders on bearings of a frequency, with walls and contact numbers; and the gap, or what counts as one.
fn placed(dice: &mut Dice, kind: Kind, bearing_hz: f64) -> (Scene, f64) {
    let mut scene = parts::blank(kind);
    let (first, gap) = (parts::girder(dice), parts::gap(dice));
    let count = 1 + dice.below(5);
    scene.girders = parts::row(dice, &first, count, gap, false);
    parts::walls(dice, &mut scene, gap);
    parts::stand(dice, &mut scene, bearing_hz);
    scene.contact = parts::contact(dice);
    (scene, gap.max(LEAST_REACH * first.length))
}

/// The ground at the very frequency of the bearings, without damping or with little.
pub(super) fn resonance(dice: &mut Dice) -> Scene {
    let kind = parts::kind(dice);
    let f = dice.log(FREQUENCY[0], FREQUENCY[1]);
    let (mut scene, reach) = placed(dice, kind, f);
    let damping = if dice.chance(0.5) { 0.0 } else { dice.log(1e-9, 1e-2) };
    for girder in &mut scene.girders {
        if let Some(Bearings::Shared(shared)) = &mut girder.bearings {
            shared.frequency_hz = PerDirection::Both(f);
            shared.damping_ratio = PerDirection::Both(damping);
        }
    }
    scene.motion = parts::sine(dice, f, f, reach);
    parts::last(dice, &mut scene, &[f]);
    scene
}

/// A record: kinks at every sample.
pub(super) fn record(dice: &mut Dice) -> Scene {
    let kind = parts::kind(dice);
    let (ground, bearing) = (dice.log(0.1, 10.0), dice.log(0.1, 10.0));
    let (mut scene, reach) = placed(dice, kind, bearing);
    scene.motion = parts::record(dice, ground, bearing, reach);
    parts::last(dice, &mut scene, &[ground, bearing]);
    scene
}

/// An hour of shaking between two walls.
pub(super) fn hour(dice: &mut Dice) -> Scene {
    let (ground, bearing) = (dice.log(0.3, 3.0), dice.log(0.3, 3.0));
    let mut scene = parts::blank(Kind::Planar);
    let first = parts::girder(dice);
    let gap = three_digits(first.length * dice.log(1e-4, 1e-2)).max(1e-6);
    scene.girders = vec![first];
    parts::wall(&mut scene, End::Plus, gap);
    if dice.chance(0.5) {
        parts::wall(&mut scene, End::Minus, gap);
    }
    parts::stand(dice, &mut scene, bearing);
    scene.contact = parts::contact(dice);
    scene.motion = parts::sine(dice, ground, bearing, gap);
    scene.duration = 3600.0;
    scene.solver.tolerance = dice.log(1e-10, 1e-6);
    scene
}
