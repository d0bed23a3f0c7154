//! Skewed decks whose corners slide past one another during a hit, at a joint and at a backwall as wide as the deck: in plan, however the
//! scene lies, as in space held flat, where edge nodes pass the vertices on.

use girderbench::scene::Scene;
use girderbench::sim::History;
use glam::{DMat2, DVec2};

use super::held_flat;
use crate::support::{run, scene, within};

const CONTACT: &str = "[contact]\nstiffness_n_per_m = 2e9\nrestitution_normal = 0.6\nrestitution_tangential = 0.8\n\
                       mu_static = 0.45\nmu_kinetic = 0.35\n";

/// A deck of 30 m and this skew \[degrees\] at this velocity, and `rest` of the scene.
fn deck(skew: f64, velocity: [f64; 2], rest: &str) -> Scene {
    scene(&format!(
        "name = \"flush\"\nduration_s = 0.2\n[[girder]]\nname = \"a\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n\
         skew_deg = {skew:?}\nmass_kg = 6e5\ninitial = {{ velocity_m_s = {velocity:?} }}\n{rest}{CONTACT}"
    ))
}

/// A deck of 24 m, as wide, at this place \[m\]: 10 mm before the other where that is (27.01, 0).
fn joint(velocity: [f64; 2], [ahead, beside]: [f64; 2]) -> Scene {
    let other = format!(
        "[[girder]]\nname = \"b\"\nlength_m = 24.0\nwidth_m = 10.0\nthickness_m = 1.5\nskew_deg = 70.0\nmass_kg = 4.2e5\n\
         position_m = [{ahead:?}, {beside:?}, 0.0]\n"
    );
    deck(70.0, velocity, &other)
}

/// A backwall 10 mm before a deck of this skew \[degrees\], as wide as its end, `offset` \[m\].
fn backwall(skew: f64, velocity: [f64; 2], offset: f64) -> Scene {
    let width = 10.0 / skew.to_radians().sin();
    let wall = format!(
        "[[abutment]]\nname = \"w\"\nfaces = \"a\"\nend = \"+x\"\ngap_m = 0.01\nwidth_m = {width:?}\noffset_m = {offset:?}\n"
    );
    deck(skew, velocity, &wall)
}

fn scenes() -> [(&'static str, Scene); 4] {
    [
        ("a joint, obliquely", joint([0.4, 0.1], [27.01, 0.005])),
        ("a joint, head-on", joint([0.4, 0.0], [27.01, 0.0])),
        ("a backwall of 70°", backwall(70.0, [0.4, 0.1], -0.003)),
        ("a backwall of 60°", backwall(60.0, [0.4, -0.1], 0.0)),
    ]
}

/// Largest rotation of the first deck \[rad\], and the speeds of all at the end \[m/s\].
fn answer(history: &History) -> Vec<f64> {
    assert_eq!(history.overlaps(), [], "contacts carry all");
    assert!(history.energy().balance().holds(), "{:?}", history.energy().balance());
    let turned = (0..=200).map(|i| history.motion(0, f64::from(i) * 1e-3).theta.abs()).fold(0.0, f64::max);
    let speeds = (0..history.model().girders().len()).map(|girder| history.motion(girder, 0.2).velocity.length());
    std::iter::once(turned).chain(speeds).collect()
}

/// The scene turned in plan by this angle \[degrees\].
fn turned(flat: &Scene, angle: f64) -> Scene {
    let mut turned = flat.clone();
    let turn = DMat2::from_angle(angle.to_radians());
    for girder in &mut turned.girders {
        for vector in [&mut girder.position, &mut girder.initial.velocity] {
            let [x, y] = (turn * DVec2::new(vector[0], vector[1])).to_array();
            (vector[0], vector[1]) = (x, y);
        }
        girder.heading_deg = angle;
    }
    turned
}

#[test]
fn however_the_scene_lies_corners_pass_as_they_do_in_space() {
    for (name, flat) in scenes() {
        let in_space = answer(&run(&held_flat(&flat)));
        assert!(in_space[0] > 5e-5, "{name}: it turns by {} rad", in_space[0]);
        for angle in [0.0, 15.0, 37.0, 180.0] {
            for (plan, space) in answer(&run(&turned(&flat, angle))).into_iter().zip(&in_space) {
                // Edge nodes and corners take a vertex at places apart by the depth times the faces' angle.
                within(&format!("{name}, turned by {angle}°"), plan - space, 1e-5 * space);
            }
        }
    }
}

/// A number from 0 to 1 of a seed.
fn part(seed: u32, which: u32) -> f64 {
    ((f64::from(seed * 37 + which * 101 + 1) * 12.9898).sin() * 43758.5453).rem_euclid(1.0)
}

/// A hit of two decks, or of one against a backwall, by a seed.
fn random(seed: u32) -> Scene {
    let between = |which: u32, from: f64, to: f64| from + (to - from) * part(seed, which);
    let velocity = [between(0, 0.2, 0.8), between(1, -0.3, 0.3)];
    let beside = [0.0, between(2, -0.02, 0.02), between(2, -2.0, 2.0)][seed as usize % 3];
    let mut scene = if seed.is_multiple_of(2) {
        joint(velocity, [27.01 + beside / 70f64.to_radians().tan(), beside])
    } else {
        backwall(between(3, 50.0, 130.0), velocity, beside)
    };
    scene.girders[0].initial.spin_deg_s = between(4, -1.0, 1.0);
    scene.contact.stiffness = Some(10f64.powf(between(5, 8.5, 9.7)));
    (scene.contact.mu_static, scene.contact.mu_kinetic) = (between(6, 0.1, 0.6), 0.8 * between(6, 0.1, 0.6));
    scene
}

#[test]
fn hits_of_random_decks_are_the_same_in_plan_turned_and_in_space() {
    for seed in 0..24 {
        let flat = random(seed);
        let answers = [answer(&run(&flat)), answer(&run(&turned(&flat, 37.0)))];
        for (n, space) in answer(&run(&held_flat(&flat))).into_iter().enumerate() {
            // As above: 1.4e-4 were seen.
            within(&format!("seed {seed}, in space"), answers[0][n] - space, 1e-3 * space.max(0.01));
            within(&format!("seed {seed}, turned"), answers[0][n] - answers[1][n], 1e-9);
        }
    }
}

/// What an independent integration gives that takes the corners of both ends as one (relative offset of the corners 5e-4 of the width).
#[test]
fn a_joint_turns_as_an_independent_integration_says() {
    let oblique = answer(&run(&joint([0.4, 0.1], [27.01, 0.005])));
    within("rotation [rad]", oblique[0] - 1.564e-4, 3e-7);
    let (history, masses) = (run(&joint([0.4, 0.1], [27.01, 0.005])), [6e5, 4.2e5]);
    let kinetic: f64 = masses
        .into_iter()
        .enumerate()
        .map(|(girder, mass)| {
            let (body, here) = (&history.model().bodies[girder], history.motion(girder, 0.2));
            0.5 * mass * (here.velocity.length_squared() + body.gyration2 * here.spin.z.powi(2))
        })
        .sum();
    within("kinetic energy [J]", kinetic - 34407.0, 5.0);
}
