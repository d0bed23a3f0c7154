//! Girders without bearings thrown at one another from anywhere, in plan and in space: every face, edge and corner meets every
//! other.

use std::f64::consts::{PI, TAU};

use crate::scene::{Between, Girder, Kind, Scene};
use crate::study::stability::parts;
use crate::study::stability::random::{Random, three_digits};

/// Lengths and widths \[m\].
const LENGTH: [f64; 2] = [0.4, 1.2];
const WIDTH: [f64; 2] = [0.2, 0.6];
/// Thickness \[m\]: heights have no meaning in plan.
const THICKNESS: f64 = 0.2;
/// Thicknesses in space, and heights from which girders are thrown, either way \[m\].
const THICKNESSES: [f64; 2] = [0.1, 0.5];
const ASIDE: f64 = 0.2;
/// Masses \[kg\], stiffness \[N/m\] and speeds \[m/s\]: a few centimetres deep at the most.
const MASS: [f64; 2] = [1.0, 5.0];
const STIFFNESS: [f64; 2] = [3e4, 1e7];
const SPEED: [f64; 2] = [0.5, 3.0];
/// Spin, either way \[°/s\].
const SPIN: f64 = 200.0;
/// From where they are thrown, about the origin \[m\].
const FROM: [f64; 2] = [1.3, 1.8];

/// Girders thrown in space, thicker, in any attitude and turning about any axis, without weight.
pub(super) fn thrown_in_space(random: &mut Random) -> Scene {
    let mut scene = thrown(random);
    (scene.kind, scene.gravity) = (Kind::Spatial, 0.0);
    for girder in &mut scene.girders {
        girder.thickness = three_digits(random.range(THICKNESSES[0], THICKNESSES[1]));
        girder.position[2] = three_digits(random.range(-ASIDE, ASIDE));
        girder.initial.roll_deg = Some(three_digits(random.range(-180.0, 180.0)));
        girder.initial.pitch_deg = Some(three_digits(random.range(-80.0, 80.0)));
        girder.initial.roll_deg_s = Some(three_digits(random.range(-SPIN, SPIN)));
        girder.initial.pitch_deg_s = Some(three_digits(random.range(-SPIN, SPIN)));
    }
    scene
}

/// Two to four girders that fly towards one another, each as it lies.
pub(super) fn thrown(random: &mut Random) -> Scene {
    let mut scene = parts::blank(Kind::Planar);
    scene.duration = 2.0;
    scene.contact = parts::contact(random);
    scene.contact.between = Between::All;
    scene.contact.stiffness = Some(random.log(STIFFNESS[0], STIFFNESS[1]));
    let count = 2 + random.below(3);
    scene.girders = (0..count).map(|number| girder(random, number, count)).collect();
    scene
}

fn girder(random: &mut Random, number: usize, count: usize) -> Girder {
    let size = [random.range(LENGTH[0], LENGTH[1]), random.range(WIDTH[0], WIDTH[1])].map(three_digits);
    let mut girder =
        Girder::straight(format!("g{number}"), [size[0], size[1], THICKNESS], random.log(MASS[0], MASS[1]));
    girder.skew_deg = random.pick(&[90.0, 90.0, 60.0, 45.0, 120.0]);
    girder.heading_deg = three_digits(random.range(0.0, 360.0));
    // Far enough from their neighbours on the circle not to overlap as placed.
    let (from, angle) = (random.range(FROM[0], FROM[1]), TAU * number as f64 / count as f64 + random.range(-0.1, 0.1));
    girder.position = [from * angle.cos(), from * angle.sin(), 0.0].map(three_digits);
    let (speed, towards) = (random.range(SPEED[0], SPEED[1]), angle + PI + random.range(-0.25, 0.25));
    girder.initial.velocity = [speed * towards.cos(), speed * towards.sin(), 0.0].map(three_digits);
    girder.initial.spin_deg_s = three_digits(random.range(-SPIN, SPIN));
    girder
}
