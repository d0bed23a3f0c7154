//! Two bending spans on one pier that turns and yields, whose corners pass one another at the joint: what they hand on is all there is.

use glam::{DMat2, DVec2};

use crate::support::{scene, within};
use girderbench::scene::{Between, Motion, Scene};
use girderbench::sim::{Event, EventKind, History};

/// Spans of 30 and 20 m and 60°, in a bridge turned by 37°; the supports move later and by less than the ground.
const BRIDGE: &str = r#"
name = "joint"
kind = "planar"
duration_s = 2.28
[[girder]]
name = "g1"
length_m = 30.0
width_m = 8.0
thickness_m = 1.5
skew_deg = 60
mass_kg = 4e5
position_m = [0.0, 0.0, 0.0]
heading_deg = 37
bearings = [
    { at_m = [-13, -3], stiffness_n_per_m = [2e7, 1e7], damping_n_s_per_m = [2e5, 1e5] },
    { at_m = [-14, 3], stiffness_n_per_m = [1e7, 2e7], damping_n_s_per_m = [1e5, 2e5] },
    { at_m = [12, -3], stiffness_n_per_m = [1e7, 3e7], damping_n_s_per_m = [1e5, 3e5], on = "p", yield_force_n = 4e5, yield_displacement_m = 0.01 },
    { at_m = [14, 2], stiffness_n_per_m = [2e7, 2e7], damping_n_s_per_m = [2e5, 2e5], on = "p" },
]
initial = { velocity_m_s = [0.4189998037131708, 0.44095256489595824], spin_deg_s = 1.0 }
[girder.elastic]
young_modulus_pa = 3e10
density_kg_m3 = 2400
modes = 4

[[girder]]
name = "g2"
length_m = 20.0
width_m = 8.0
thickness_m = 1.5
skew_deg = 60
mass_kg = 3e5
position_m = [20.005819526684686, 15.07546632995881, 0.0]
heading_deg = 37
bearings = [
    { at_m = [-9, -3], stiffness_n_per_m = [1e7, 1e7], damping_n_s_per_m = [1e5, 1e5], on = "p" },
    { at_m = [-8, 3], stiffness_n_per_m = [1e7, 2e7], damping_n_s_per_m = [1e5, 2e5], on = "p" },
    { at_m = [8, -3], stiffness_n_per_m = [1e7, 3e7], damping_n_s_per_m = [1e5, 3e5] },
    { at_m = [9, 2], stiffness_n_per_m = [2e7, 2e7], damping_n_s_per_m = [2e5, 2e5] },
]
[girder.elastic]
young_modulus_pa = 2e10
density_kg_m3 = 2400
modes = 4

[[pier]]
name = "p"
mass_kg = 1.5e5
position_m = [11.859169646078984, 9.186952449290184]
heading_deg = 7
stiffness_n_per_m = [6e7, 9e7]
damping_ratio = [0.04, 0.07]
turn_stiffness_n_m_per_rad = 5e8
turn_inertia_kg_m2 = 1e6
height_m = 8.0
yield_force_n = [9e5, 7e5]

[[abutment]]
name = "w"
faces = "g1"
end = "-x"
gap_m = 0.004
delay_s = 0.04
[[abutment]]
name = "e"
faces = "g2"
end = "+x"
gap_m = 0.003
motion_factor = 0.9
[[restrainer]]
name = "cab"
girder = "g1"
to = "g2"
at_m = [14.0, 3]
to_m = [-9.0, 2.5]
slack_m = 0.01
stiffness_n_per_m = 3e7
[[damper]]
name = "dam"
girder = "g1"
to = "w"
at_m = [-12.0, -2]
to_m = [-1.0, 1.0]
coefficient = 3e5
exponent = 0.5
[contact]
stiffness_n_per_m = 2e9
restitution_normal = 0.5
mu_static = 0.5
mu_kinetic = 0.4
[solver]
tolerance = 1e-6
[motion]
kind = "sine"
amplitude_g = 0.3
frequency_hz = 0.9
phase_deg = 40
angle_deg = 57
"#;

#[test]
fn a_corner_that_took_over_opens_once_and_for_all() {
    let history = History::of(&scene(BRIDGE)).expect("runs");
    let balance = history.energy().balance();
    assert!(balance.holds(), "{balance:?}");
    // Displaced by what the corner before it was deeper, it opens behind the plane of its face.
    let opened: Vec<f64> = history.events().iter().filter(|e| e.kind == EventKind::Opened).map(|e| e.t).collect();
    let again = history.events().iter().find(|event| event.kind.is_touch() && opened.contains(&event.t));
    assert!(again.is_none(), "closes at the instant at which it opens: {again:?}");
}

/// The scene turned in plan by this angle \[degrees\], over 3 s.
fn turned(angle: f64) -> Scene {
    let mut scene = scene(BRIDGE);
    scene.duration = 3.0;
    let turn = DMat2::from_angle(angle.to_radians());
    let apply = |x: &mut [f64]| {
        let there = turn * DVec2::new(x[0], x[1]);
        x[..2].copy_from_slice(&there.to_array());
    };
    for girder in &mut scene.girders {
        apply(&mut girder.position);
        apply(&mut girder.initial.velocity);
        girder.heading_deg += angle;
    }
    let pier = &mut scene.piers[0];
    pier.position.iter_mut().for_each(|place| apply(place));
    pier.heading_deg.iter_mut().for_each(|heading| *heading += angle);
    match &mut scene.motion {
        Motion::Sine(sine) => sine.angle_deg += angle,
        _ => panic!("shaken by a sine"),
    }
    scene
}

#[test]
fn spans_that_pass_at_a_joint_do_not_enter_each_other_however_the_bridge_lies() {
    let of = |angle| {
        let history = History::of(&turned(angle)).expect("runs");
        assert!(history.energy().balance().holds(), "turned by {angle}°: {:?}", history.energy().balance());
        let passed = |event: &&Event| event.kind == EventKind::LeftFace;
        assert!(history.events().iter().filter(passed).count() > 1, "turned by {angle}°: their corners pass");
        assert_eq!(history.overlaps(), [], "turned by {angle}°");
        [0, 1].map(|girder| history.motion(girder, 3.0).theta)
    };
    let straight = of(0.0);
    for angle in [-37.0, 53.0] {
        for (here, there) in straight.into_iter().zip(of(angle)) {
            // Three seconds of hits carry the rounding of a turned scene to the tolerance of 1e-6 at the most.
            within(&format!("turned by {angle}°"), here - there, 1e-9);
        }
    }
}

#[test]
fn between_ends_alone_what_enters_is_found_however_the_bridge_lies() {
    let depth = |angle| {
        let mut scene = turned(angle);
        scene.contact.between = Between::Ends;
        let history = History::of(&scene).expect("runs");
        history.overlaps().iter().map(|overlap| overlap.depth.value).fold(0.0, f64::max)
    };
    let straight = depth(0.0);
    assert!(straight > 5e-3, "they pass through each other by {straight} m");
    for angle in [-37.0, 53.0] {
        // The error of the run, 9e-9 m.
        within(&format!("turned by {angle}°"), straight - depth(angle), 1e-8);
    }
}
