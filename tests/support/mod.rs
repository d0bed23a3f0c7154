//! What several tests of the core share: reference cases as scenes, small scenes in words, and a helper that prints residuals.

pub(crate) mod mutate;
pub(crate) mod reference;
pub(crate) mod rows;

use girderbench::scene::{Scene, format};
use girderbench::sim::History;
use glam::DVec3;

/// Asserts that a value is within a tolerance and says by how much it misses, or stays inside.
#[expect(clippy::print_stdout, reason = "shown when a test fails, or with --nocapture")]
pub(crate) fn within(what: &str, value: f64, tolerance: f64) {
    println!("{what}: {value:.3e} (allowed {tolerance:.1e})");
    assert!(value.abs() <= tolerance, "{what}: {value:e} is more than {tolerance:e}");
}

/// A scene from its text.
pub(crate) fn scene(text: &str) -> Scene {
    format::parse(text, "test").unwrap_or_else(|errors| panic!("{errors}"))
}

/// Runs a scene to its end.
pub(crate) fn run(scene: &Scene) -> History {
    let history = History::of(scene).unwrap_or_else(|errors| panic!("{errors}"));
    assert!(history.stop().is_none(), "{} runs to its end: {:?}", scene.name, history.stop());
    history
}

/// The paper's straight girder without bearings, 5 mm before a wall, moving at it.
pub(crate) fn free_hit() -> Scene {
    scene(
        r#"
        name = "free-hit"
        duration_s = 0.1
        [[girder]]
        name = "deck"
        length_m = 0.19
        width_m = 0.07
        thickness_m = 0.02
        mass_kg = 2.0
        initial = { velocity_m_s = [0.5, 0.0] }
        [[abutment]]
        name = "wall"
        faces = "deck"
        gap_m = 0.005
        width_m = 2.0
        [contact]
        stiffness_n_per_m = 1.55e5
        law = "paper"
        [solver]
        tolerance = 1e-12
        "#,
    )
}

/// Two of them, end to end.
pub(crate) fn free_pair() -> Scene {
    scene(
        r#"
        name = "free-pair"
        duration_s = 0.1
        [[girder]]
        name = "one"
        length_m = 0.19
        width_m = 0.07
        thickness_m = 0.02
        mass_kg = 2.0
        initial = { velocity_m_s = [0.5, 0.0] }
        [[girder]]
        name = "two"
        length_m = 0.19
        width_m = 0.07
        thickness_m = 0.02
        mass_kg = 2.0
        position_m = [0.195, 0.0, 0.0]
        [contact]
        stiffness_n_per_m = 1.55e5
        law = "paper"
        [solver]
        tolerance = 1e-12
        "#,
    )
}

/// Momentum along x and y \[N·s\] and angular momentum about the vertical through the origin \[N·m·s\] of all girders.
pub(crate) fn momenta(history: &History, t: f64) -> [f64; 3] {
    let [linear, angular] = momenta_in_space(history, t);
    [linear.x, linear.y, angular.z]
}

/// Momentum \[N·s\] and angular momentum about the origin \[N·m·s\] of all girders.
pub(crate) fn momenta_in_space(history: &History, t: f64) -> [DVec3; 2] {
    let bodies = history.model().bodies.iter().enumerate();
    bodies.fold([DVec3::ZERO; 2], |[linear, angular], (number, body)| {
        let motion = history.motion(number, t);
        let momentum = motion.velocity * body.mass;
        let spin = motion.attitude * (body.inertia * (motion.attitude.inverse() * motion.spin));
        [linear + momentum, angular + motion.place.cross(momentum) + spin]
    })
}
