//! Scenes where contact lasts or comes to many at once: rows, pre-loaded faces, blocks that stick and slip, stiff walls.

use crate::geometry::End;
use crate::scene::{Kind, Scene};
use crate::study::stability::dice::{Dice, three_digits};
use crate::study::stability::parts::{self, STIFFNESS};

/// Equal girders at equal gaps with equal speeds: everything is due at one instant.
pub(super) fn simultaneous(dice: &mut Dice) -> Scene {
    let f = dice.log(0.1, 10.0);
    let mut scene = parts::blank(parts::kind(dice));
    let (first, gap) = (parts::girder(dice), parts::gap(dice));
    let count = 2 + dice.below(4);
    scene.girders = parts::row(dice, &first, count, gap, true);
    parts::walls(dice, &mut scene, gap);
    parts::stand(dice, &mut scene, f);
    scene.contact = parts::contact(dice);
    let reach = gap.max(1e-4 * first.length);
    let speed = three_digits(std::f64::consts::TAU * f * reach * dice.log(0.5, 5.0));
    let mirrored = dice.chance(0.5);
    for (i, girder) in scene.girders.iter_mut().enumerate() {
        let away = mirrored && i % 2 == 1;
        girder.initial.velocity[0] = if away { -speed } else { speed };
    }
    parts::last(dice, &mut scene, &[f]);
    scene
}

/// A constant push into a wall at no gap or a small one, sideways within the cone or beyond it.
pub(super) fn preloaded(dice: &mut Dice) -> Scene {
    let f = dice.log(0.1, 10.0);
    let mut scene = parts::blank(parts::kind(dice));
    let first = parts::girder(dice);
    let gap = if dice.chance(0.7) { 0.0 } else { dice.log(1e-6, 1e-3) };
    let count = 1 + dice.below(3);
    scene.girders = parts::row(dice, &first, count, gap, false);
    parts::wall(&mut scene, End::Plus, gap);
    parts::stand(dice, &mut scene, f);
    scene.contact = parts::contact(dice);
    let k = scene.contact.stiffness.unwrap_or(STIFFNESS[0]);
    // Pressed in by a part of the girder's length, never by more than a thousand times its weight.
    let heaviest = 1e4 * first.mass;
    let force = three_digits((k * first.length * dice.log(1e-9, 1e-3)).min(heaviest));
    let sideways = three_digits(force * scene.contact.mu_static * dice.range(-1.5, 1.5));
    let moment = three_digits(force * first.width * dice.range(-0.3, 0.3));
    for girder in &mut scene.girders {
        girder.push.force = [force, sideways, 0.0];
        girder.push.moment = if dice.chance(0.5) { moment } else { 0.0 };
    }
    if dice.chance(0.5) {
        let ground = dice.log(0.1, 10.0);
        scene.motion = parts::sine(dice, ground, f, 1e-5 * first.length);
    }
    parts::last(dice, &mut scene, &[f]);
    scene
}

/// A block pressed to a wall and shaken along it: sticks, breaks away, stops.
pub(super) fn stick_slip(dice: &mut Dice) -> Scene {
    let f = dice.log(0.3, 10.0);
    let mut scene = parts::blank(parts::kind(dice));
    let first = parts::girder(dice);
    scene.girders = vec![first.clone()];
    parts::wall(&mut scene, End::Plus, 0.0);
    parts::stand(dice, &mut scene, f);
    scene.contact = parts::contact(dice);
    let push = three_digits(first.mass * dice.log(0.1, 30.0));
    scene.girders[0].push.force = [push, 0.0, 0.0];
    let ground = dice.log(0.3, 10.0);
    let mut motion = parts::sine(dice, ground, f, 1e-3 * first.length);
    if let crate::scene::Motion::Sine(sine) = &mut motion {
        // About as much as friction holds, along the wall.
        let holds = push / first.mass * scene.contact.mu_static.max(0.05);
        sine.amplitude = Some(three_digits(holds * dice.log(0.3, 10.0)).min(parts::AMPLITUDE));
        sine.angle_deg = first.skew_deg;
    }
    scene.motion = motion;
    parts::last(dice, &mut scene, &[ground, f]);
    scene
}

/// The stiffest walls against light girders, shaken for long.
pub(super) fn stiff(dice: &mut Dice) -> Scene {
    let f = dice.log(0.1, 10.0);
    let mut scene = parts::blank(Kind::Planar);
    let mut first = parts::girder(dice);
    first.mass = dice.log(1e-3, 1e3);
    let gap = parts::gap(dice).min(0.1);
    let count = 1 + dice.below(2);
    scene.girders = parts::row(dice, &first, count, gap, false);
    parts::wall(&mut scene, End::Plus, gap);
    parts::stand(dice, &mut scene, f);
    scene.contact = parts::contact(dice);
    scene.contact.stiffness = Some(dice.log(1e9, STIFFNESS[1]));
    let ground = dice.log(0.1, 10.0);
    scene.motion = parts::sine(dice, ground, f, gap.max(1e-4 * first.length));
    parts::last(dice, &mut scene, &[ground, f]);
    scene
}
