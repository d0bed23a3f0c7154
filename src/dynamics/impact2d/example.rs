//! Scenes of the impact model's unit tests: a girder at its wall, with its contacts.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use crate::dynamics::Model;
use crate::dynamics::impact2d::delassus::{Cluster, ContactPoint};
use crate::dynamics::impact2d::instant::ImpactInstant;
use crate::dynamics::impact2d::kinematics::BodyKinematics;
use crate::dynamics::impact2d::world::World;
use crate::scene::{Scene, format, presets};

/// A preset after a change of its scene.
pub(in crate::dynamics::impact2d) fn preset(name: &str, change: impl FnOnce(&mut Scene)) -> Model {
    let mut scene = presets::load(name).expect("a preset");
    change(&mut scene);
    Model::compile(&scene).expect("a sound scene")
}

/// A straight girder flush at its wall at +x, after a change of its scene.
pub(in crate::dynamics::impact2d) fn at_wall(change: impl FnOnce(&mut Scene)) -> Model {
    preset("straight-abutment", |scene| {
        scene.abutments[0].gap = Some(0.0);
        change(scene);
    })
}

/// Half length and half width of [`block`] \[m\].
pub(in crate::dynamics::impact2d) const BLOCK_HALF: [f64; 2] = [0.095, 0.035];

/// A girder of 2 kg before a wall at +x at this gap \[m\], with these keys in its table; without bearings by default.
pub(in crate::dynamics::impact2d) fn block(keys: &str, gap: f64) -> Model {
    let text = format!(
        r#"
        name = "block"
        duration_s = 2.0
        [[girder]]
        name = "deck"
        length_m = {:?}
        width_m = {:?}
        thickness_m = 0.02
        mass_kg = 2.0
        {keys}
        [[abutment]]
        name = "wall"
        faces = "deck"
        gap_m = {gap:?}
        width_m = 2.0
        "#,
        2.0 * BLOCK_HALF[0],
        2.0 * BLOCK_HALF[1],
    );
    Model::compile(&format::parse(&text, "test").expect("a scene")).expect("a sound scene")
}

/// The first group of a model at t = 0.
pub(in crate::dynamics::impact2d) fn world(model: Model) -> World {
    World::new(&Arc::new(model), 0)
}

/// The instant t = 0 of the first girder, with this velocity of G \[m/s\] and a round-off of speeds of 1e-15 m/s.
pub(in crate::dynamics::impact2d) fn instant(world: &World, [v_x, v_y]: [f64; 2]) -> ImpactInstant {
    let mut instant = ImpactInstant::new(world, 0.0, &[0]);
    instant.kinematics.cluster.velocity[0] = DVec3::new(v_x, v_y, 0.0);
    instant.speed_noise = 1e-15;
    instant
}

/// Declared contacts of the first pair with a gap below 1e-12 m, along their face.
pub(in crate::dynamics::impact2d) fn touching(model: &Model, kinematics: &BodyKinematics) -> Vec<usize> {
    let point = |site: usize| kinematics.point(model, site);
    let mut sites: Vec<usize> = model.pairs[0].sites.clone().collect();
    sites.retain(|&site| point(site).gap.abs() < 1e-12);
    sites.sort_by(|&a, &b| point(a).along.total_cmp(&point(b).along));
    sites
}

/// Bodies with these inverse inertias over `(x, y, θ)` and velocities.
pub(in crate::dynamics::impact2d) fn cluster<const N: usize>(inverse: [DVec3; N], velocity: [[f64; 3]; N]) -> Cluster {
    Cluster { inverse: inverse.into_iter().collect(), velocity: velocity.into_iter().map(DVec3::from).collect() }
}

/// A closed contact well inside its face, `along` s from the face's middle \[m\], with these levers of its bodies \[m\].
pub(in crate::dynamics::impact2d) fn touch(
    bodies: [Option<usize>; 2],
    n: DVec2,
    arms: [DVec2; 2],
    along: f64,
) -> ContactPoint {
    ContactPoint { bodies, n, s: n.perp(), arms, gap: 0.0, inset: 1.0, along, bias: [0.0; 2] }
}
