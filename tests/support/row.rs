//! A row of girders of any length, as a test or a benchmark wants it.

use girderbench::scene::{Scene, presets};
use girderbench::view::block::girder_block;
use glam::DVec3;

/// The preset's row of five, repeated to `count` girders at its own spacing.
pub(crate) fn of(count: usize) -> Scene {
    let mut scene = presets::load("row-of-5").unwrap_or_else(|errors| panic!("{errors}"));
    let five = std::mem::take(&mut scene.girders);
    let [first, second] = [0, 1].map(|i| five[i].position[0]);
    scene.girders = (0..count)
        .zip(five.iter().cycle())
        .map(|(i, girder)| {
            let mut girder = girder.clone();
            girder.name = format!("g{}", i + 1);
            girder.position[0] = first + (second - first) * i as f64;
            girder
        })
        .collect();
    scene
}

/// Corners of one girder as placed.
pub(crate) fn corners_of(scene: &Scene, girder: usize) -> Vec<DVec3> {
    girder_block(&scene.girders[girder]).corners().to_vec()
}
