//! Scenes shaken by the ground: anything at all, resonance, records, an hour.

use crate::geometry::End;
use crate::scene::{Bearings, Kind, Motion, PerDirection, Scene};
use crate::study::stability::parts::{self, FREQUENCY};
use crate::study::stability::random::{Random, three_digits};

/// Shortest way that counts as a gap, in parts of a girder's length.
const LEAST_REACH: f64 = 1e-4;

/// Everything over its whole range.
pub(super) fn wide(random: &mut Random) -> Scene {
    let kind = parts::kind(random);
    any(random, kind)
}

/// Shaken girders with six degrees of freedom.
pub(super) fn spatial(random: &mut Random) -> Scene {
    any(random, Kind::Spatial)
}

fn any(random: &mut Random, kind: Kind) -> Scene {
    let (ground, bearing) = (random.log(FREQUENCY[0], FREQUENCY[1]), random.log(FREQUENCY[0], FREQUENCY[1]));
    let (mut scene, reach) = placed(random, kind, bearing);
    match random.below(4) {
        0 => {}
        1 => scene.motion = parts::record(random, ground, bearing, reach),
        _ => scene.motion = parts::sine(random, ground, bearing, reach),
    }
    if scene.motion == Motion::None || random.chance(0.5) {
        parts::kick(random, &mut scene, bearing, reach);
    }
    parts::last(random, &mut scene, &[ground, bearing]);
    scene
}

/// One to five girders on bearings of a frequency, with walls and contact numbers; and the gap, or what counts as one.
fn placed(random: &mut Random, kind: Kind, bearing_hz: f64) -> (Scene, f64) {
    let mut scene = parts::blank(kind);
    let (first, gap) = (parts::girder(random), parts::gap(random));
    let count = 1 + random.below(5);
    scene.girders = parts::row(random, &first, count, gap, false);
    parts::walls(random, &mut scene, gap);
    parts::stand(random, &mut scene, bearing_hz);
    scene.contact = parts::contact(random);
    (scene, gap.max(LEAST_REACH * first.length))
}

/// The ground at the very frequency of the bearings, without damping or with little.
pub(super) fn resonance(random: &mut Random) -> Scene {
    let kind = parts::kind(random);
    let f = random.log(FREQUENCY[0], FREQUENCY[1]);
    let (mut scene, reach) = placed(random, kind, f);
    let damping = if random.chance(0.5) { 0.0 } else { random.log(1e-9, 1e-2) };
    for girder in &mut scene.girders {
        if let Some(Bearings::Shared(shared)) = &mut girder.bearings {
            shared.frequency_hz = PerDirection::Both(f);
            shared.damping_ratio = PerDirection::Both(damping);
        }
    }
    scene.motion = parts::sine(random, f, f, reach);
    parts::last(random, &mut scene, &[f]);
    scene
}

/// A record: kinks at every sample.
pub(super) fn record(random: &mut Random) -> Scene {
    let kind = parts::kind(random);
    let (ground, bearing) = (random.log(0.1, 10.0), random.log(0.1, 10.0));
    let (mut scene, reach) = placed(random, kind, bearing);
    scene.motion = parts::record(random, ground, bearing, reach);
    parts::last(random, &mut scene, &[ground, bearing]);
    scene
}

/// An hour of shaking between two walls.
pub(super) fn hour(random: &mut Random) -> Scene {
    let (ground, bearing) = (random.log(0.3, 3.0), random.log(0.3, 3.0));
    let mut scene = parts::blank(Kind::Planar);
    let first = parts::girder(random);
    let gap = three_digits(first.length * random.log(1e-4, 1e-2)).max(1e-6);
    scene.girders = vec![first];
    parts::wall(&mut scene, End::Plus, gap);
    if random.chance(0.5) {
        parts::wall(&mut scene, End::Minus, gap);
    }
    parts::stand(random, &mut scene, bearing);
    scene.contact = parts::contact(random);
    scene.motion = parts::sine(random, ground, bearing, gap);
    scene.duration = 3600.0;
    scene.solver.tolerance = random.log(1e-10, 1e-6);
    scene
}
