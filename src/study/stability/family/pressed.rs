//! Scenes where contact lasts or acts on many bodies at once: rows, pre-loaded faces, blocks that stick and slip, stiff walls.

use crate::geometry::End;
use crate::scene::{Kind, Scene};
use crate::study::stability::parts::{self, STIFFNESS};
use crate::study::stability::random::{Random, three_digits};

/// Equal girders at equal gaps with equal speeds: everything is due at one instant.
pub(super) fn simultaneous(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let mut scene = parts::blank(parts::kind(random));
    let (first, gap) = (parts::girder(random), parts::gap(random));
    let count = 2 + random.below(4);
    scene.girders = parts::row(random, &first, count, gap, true);
    parts::walls(random, &mut scene, gap);
    parts::stand(random, &mut scene, f);
    scene.contact = parts::contact(random);
    let reach = gap.max(1e-4 * first.length);
    let speed = three_digits(std::f64::consts::TAU * f * reach * random.log(0.5, 5.0));
    let mirrored = random.chance(0.5);
    for (i, girder) in scene.girders.iter_mut().enumerate() {
        let away = mirrored && i % 2 == 1;
        girder.initial.velocity[0] = if away { -speed } else { speed };
    }
    parts::last(random, &mut scene, &[f]);
    scene
}

/// A constant push into a wall at no gap or a small one, sideways within the cone or beyond it.
pub(super) fn preloaded(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let mut scene = parts::blank(parts::kind(random));
    let first = parts::girder(random);
    let gap = if random.chance(0.7) { 0.0 } else { random.log(1e-6, 1e-3) };
    let count = 1 + random.below(3);
    scene.girders = parts::row(random, &first, count, gap, false);
    parts::wall(&mut scene, End::Plus, gap);
    parts::stand(random, &mut scene, f);
    scene.contact = parts::contact(random);
    let k = scene.contact.stiffness.unwrap_or(STIFFNESS[0]);
    // Pressed in by a part of the girder's length, never by more than a thousand times its weight.
    let heaviest = 1e4 * first.mass;
    let force = three_digits((k * first.length * random.log(1e-9, 1e-3)).min(heaviest));
    let sideways = three_digits(force * scene.contact.mu_static * random.range(-1.5, 1.5));
    let moment = three_digits(force * first.width * random.range(-0.3, 0.3));
    for girder in &mut scene.girders {
        girder.push.force = [force, sideways, 0.0];
        girder.push.moment = if random.chance(0.5) { moment } else { 0.0 };
    }
    if random.chance(0.5) {
        let ground = random.log(0.1, 10.0);
        scene.motion = parts::sine(random, ground, f, 1e-5 * first.length);
    }
    parts::last(random, &mut scene, &[f]);
    scene
}

/// A block pressed to a wall and shaken along it: sticks, breaks away, stops.
pub(super) fn stick_slip(random: &mut Random) -> Scene {
    let f = random.log(0.3, 10.0);
    let mut scene = parts::blank(parts::kind(random));
    let first = parts::girder(random);
    scene.girders = vec![first.clone()];
    parts::wall(&mut scene, End::Plus, 0.0);
    parts::stand(random, &mut scene, f);
    scene.contact = parts::contact(random);
    let push = three_digits(first.mass * random.log(0.1, 30.0));
    scene.girders[0].push.force = [push, 0.0, 0.0];
    let ground = random.log(0.3, 10.0);
    let mut motion = parts::sine(random, ground, f, 1e-3 * first.length);
    if let crate::scene::Motion::Sine(sine) = &mut motion {
        // About as much as friction holds, along the wall.
        let holds = push / first.mass * scene.contact.mu_static.max(0.05);
        sine.amplitude = Some(three_digits(holds * random.log(0.3, 10.0)).min(parts::AMPLITUDE));
        sine.angle_deg = first.skew_deg;
    }
    scene.motion = motion;
    parts::last(random, &mut scene, &[ground, f]);
    scene
}

/// The stiffest walls against light girders, shaken for long.
pub(super) fn stiff(random: &mut Random) -> Scene {
    let f = random.log(0.1, 10.0);
    let mut scene = parts::blank(Kind::Planar);
    let mut first = parts::girder(random);
    first.mass = random.log(1e-3, 1e3);
    let gap = parts::gap(random).min(0.1);
    let count = 1 + random.below(2);
    scene.girders = parts::row(random, &first, count, gap, false);
    parts::wall(&mut scene, End::Plus, gap);
    parts::stand(random, &mut scene, f);
    scene.contact = parts::contact(random);
    scene.contact.stiffness = Some(random.log(1e9, STIFFNESS[1]));
    let ground = random.log(0.1, 10.0);
    scene.motion = parts::sine(random, ground, f, gap.max(1e-4 * first.length));
    parts::last(random, &mut scene, &[ground, f]);
    scene
}
