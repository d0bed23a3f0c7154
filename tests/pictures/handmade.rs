//! Instants made by hand, so that drawing can be tested without a run.

use girderbench::scene::{Overlays, Scene, ViewPreset, presets};
use girderbench::sim::{ContactNow, ContactState};
use girderbench::view::{Background, Bounds, Camera, DrawList, Moment, ViewInput, draw_moment};
use glam::{DQuat, DVec3};

/// The scale of the arrows \[N/m\].
const SCALE: f64 = 2000.0;

/// The 45° girder a little turned at its wall, its two corners in `states`.
pub(crate) fn pressed(states: [ContactState; 2]) -> (Scene, Moment) {
    let scene = presets::load("skew45-abutment").expect("a preset is valid");
    let mut moment = Moment::placed(&scene);
    moment.t = Some(0.4321);
    moment.force_scale = Some(SCALE);
    let motion = &mut moment.motions[0];
    motion.theta = 0.01;
    motion.displacement = DVec3::new(0.0033, -0.002, 0.0);
    motion.place += motion.displacement;
    motion.attitude = DQuat::from_rotation_z(motion.theta) * motion.attitude;
    let corners = scene.girders[0].prism().plan_corners();
    let corner = |i: usize| motion.place + motion.attitude * corners[i].extend(0.0);
    moment.contacts = vec![contact(0, corner(1), states[0], 150.0), contact(1, corner(2), states[1], 60.0)];
    (scene, moment)
}

/// The same with one contact, in stick with this share of its cone used.
#[cfg(feature = "render")]
pub(crate) fn sticking(share: f64) -> (Scene, Moment) {
    let (scene, mut moment) = pressed([ContactState::Stick; 2]);
    moment.contacts.truncate(1);
    let contact = &mut moment.contacts[0];
    let along = contact.tangential_force / contact.tangential_force.length();
    contact.tangential_force = along * (share * contact.mu_static * contact.normal_force);
    contact.force = contact.elastic_force();
    (scene, moment)
}

/// A contact on the 45° wall: in slip on the kinetic cone, in stick well inside the static one.
fn contact(number: usize, point: DVec3, state: ContactState, normal_force: f64) -> ContactNow {
    let normal = DVec3::new(-1.0, 1.0, 0.0) / 2f64.sqrt();
    let along = DVec3::new(1.0, 1.0, 0.0) / 2f64.sqrt();
    let (mu_static, mu_kinetic) = (0.20, 0.15);
    let share = if state == ContactState::Slip { mu_kinetic } else { 0.4 * mu_static };
    let tangential_force = -along * (share * normal_force);
    let sliding = if state == ContactState::Slip { along * 0.05 } else { DVec3::ZERO };
    let penetration = normal_force / 1.55e5;
    ContactNow {
        contact: number,
        pair: 0,
        state,
        point,
        anchor: point + normal * penetration,
        normal,
        penetration,
        normal_velocity: -0.1,
        sliding,
        normal_force,
        tangential_force,
        normal_damping: 31.0,
        tangential_damping: DVec3::ZERO,
        force: normal * (normal_force + 31.0) + tangential_force,
        couple: DVec3::ZERO,
        mu_static,
        mu_kinetic,
    }
}

/// The draw list of a moment, seen from the standing view.
pub(crate) fn list(
    scene: &Scene,
    moment: &Moment,
    size: [u32; 2],
    pixels_per_point: f32,
    overlays: Overlays,
) -> DrawList {
    draw_moment(&input(scene, &camera(scene, size), size, pixels_per_point, overlays), moment)
}

/// The standing view.
pub(crate) fn camera(scene: &Scene, size: [u32; 2]) -> Camera {
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    Camera::preset(ViewPreset::Iso, Bounds::of_scene(scene), aspect)
}

/// What a picture of a moment is made from.
pub(crate) fn input<'a>(
    scene: &'a Scene,
    camera: &'a Camera,
    size: [u32; 2],
    pixels_per_point: f32,
    overlays: Overlays,
) -> ViewInput<'a> {
    ViewInput {
        scene,
        history: None,
        t: 0.0,
        camera,
        overlays,
        force_scale: None,
        selected: &[],
        kept: &[],
        exaggeration: 1.0,
        bent: None,
        clear: &[],
        size,
        pixels_per_point,
        background: Background::Studio,
        title: None,
    }
}
