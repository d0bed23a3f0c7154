//! The scenes of the problems: presets with changes.

use super::record;
use crate::scene::{
    Between, Degree, Direction, Elastic, FrictionLaw, ModelKind, Motion, NormalName, Rayleigh, RecordMotion, Scene,
    SceneErrors, SineMotion, presets,
};

/// Amplitude of the P problems, 0.4 × 9.81 \[m/s²\].
const AMPLITUDE: f64 = 3.924;
/// `μ_s = μ_k` of the P problems.
const MU: f64 = 0.15;

/// A sine that starts at phase 0.
fn sine(amplitude: f64, frequency_hz: f64, angle_deg: f64) -> Motion {
    Motion::Sine(SineMotion {
        amplitude_g: None,
        amplitude: Some(amplitude),
        frequency_hz,
        phase_deg: 0.0,
        angle_deg,
        vertical_amplitude_g: None,
        vertical_amplitude: None,
        vertical_phase_deg: None,
    })
}

/// The paper's straight girder 1 with nothing to touch, let go from a displacement and a rotation.
pub(super) fn free_decay() -> Result<Scene, SceneErrors> {
    let mut scene = alone("free-decay")?;
    scene.girders[0].initial.displacement = [0.010, 0.004, 0.0];
    scene.girders[0].initial.rotation_deg = 2.0;
    scene.girders[0].initial.velocity = [0.0, 0.1, 0.0];
    scene.motion = Motion::None;
    scene.duration = 4.0;
    Ok(scene)
}

/// From rest under a sine at 30° to the axis.
pub(super) fn harmonic_response() -> Result<Scene, SceneErrors> {
    let mut scene = alone("harmonic-response")?;
    scene.motion = sine(AMPLITUDE, 2.0, 30.0);
    scene.duration = 10.0;
    Ok(scene)
}

fn alone(name: &str) -> Result<Scene, SceneErrors> {
    let mut scene = presets::load("straight-abutment")?;
    name.clone_into(&mut scene.name);
    scene.abutments.clear();
    Ok(scene)
}

/// P1: head-on, elastic contact. With `dashpot`, P1d.
pub(super) fn head_on(dashpot: bool) -> Result<Scene, SceneErrors> {
    let mut scene = pounding(if dashpot { "P1d" } else { "P1" }, 0.0, 10.0)?;
    if dashpot {
        (scene.contact.restitution_normal, scene.contact.restitution_tangential) = (0.4, 0.9);
    }
    Ok(scene)
}

/// P3: P1 with an instantaneous restitution of 0.4.
pub(super) fn rigid() -> Result<Scene, SceneErrors> {
    let mut scene = pounding("P3", 0.0, 10.0)?;
    scene.model.kind = ModelKind::Impact;
    Ok(scene)
}

/// P2 (45°, it slips only) and P2k (5°, it sticks at every touch).
pub(super) fn oblique(name: &str, angle_deg: f64) -> Result<Scene, SceneErrors> {
    pounding(name, angle_deg, 5.0)
}

/// P2 with Hertz's spring, as deep as the linear one at 0.3 m/s.
pub(super) fn hertz() -> Result<Scene, SceneErrors> {
    let mut scene = oblique("P2h", 45.0)?;
    scene.contact.normal_law = NormalName::Hertz;
    Ok(scene)
}

/// The straight girder 5 mm before a wall, from rest, elastic contact, `μ_s = μ_k`, return mapping.
fn pounding(name: &str, angle_deg: f64, duration: f64) -> Result<Scene, SceneErrors> {
    let mut scene = presets::load("straight-abutment")?;
    name.clone_into(&mut scene.name);
    scene.abutments[0].gap = Some(0.005);
    let contact = &mut scene.contact;
    (contact.restitution_normal, contact.restitution_tangential) = (1.0, 1.0);
    (contact.mu_static, contact.mu_kinetic) = (MU, MU);
    contact.law = FrictionLaw::ReturnMapping;
    scene.motion = sine(AMPLITUDE, 2.4, angle_deg);
    scene.duration = duration;
    Ok(scene)
}

/// A girder without bearings pressed 10 N on a wall, shaken along it: it sticks and slips.
pub(super) fn block() -> Result<Scene, SceneErrors> {
    let mut scene = presets::load("straight-abutment")?;
    "block".clone_into(&mut scene.name);
    let girder = &mut scene.girders[0];
    girder.bearings = None;
    girder.initial.displacement = [0.005 + 10.0 / 1.55e5, 0.0, 0.0];
    girder.held = vec![Direction::X, Direction::Yaw];
    scene.abutments[0].gap = Some(0.005);
    scene.contact.law = FrictionLaw::ReturnMapping;
    scene.motion = sine(1.4715, 2.0, 90.0);
    scene.duration = 4.0;
    Ok(scene)
}

/// The 45° girder of the paper under 40 s of a record.
pub(super) fn under_a_record() -> Result<Scene, SceneErrors> {
    let mut scene = presets::load("skew45-abutment")?;
    "record".clone_into(&mut scene.name);
    scene.motion = Motion::Record(RecordMotion {
        samples: Some(record::samples(2004)),
        dt: Some(record::INTERVAL),
        ..RecordMotion::default()
    });
    scene.duration = record::SAMPLES as f64 * record::INTERVAL;
    Ok(scene)
}

/// A preset with contact between facing ends alone, as all methods have it.
pub(super) fn facing_ends(preset: &str) -> Result<Scene, SceneErrors> {
    let mut scene = presets::load(preset)?;
    scene.contact.between = Between::Ends;
    Ok(scene)
}

/// The first half of the preset's earthquake.
pub(super) fn viaduct() -> Result<Scene, SceneErrors> {
    let mut scene = facing_ends("viaduct-5")?;
    "viaduct".clone_into(&mut scene.name);
    scene.duration = 10.0;
    Ok(scene)
}

/// F1: two equal bars of concrete without damping, 1 mm apart, the first under way at 0.5 m/s.
pub(super) fn two_bars() -> Result<Scene, SceneErrors> {
    let mut scene = presets::load("deck-30m-elastic")?;
    "F1".clone_into(&mut scene.name);
    smooth(&mut scene, 8e9, 24.0);
    scene.abutments.clear();
    let first = &mut scene.girders[0];
    first.bearings = None;
    first.elastic = first.elastic.map(|elastic| Elastic { damping_ratio: Some(0.0), ..elastic });
    first.position = [-15.0005, 0.0, 0.0];
    let mut second = first.clone();
    first.initial.velocity = [0.5, 0.0, 0.0];
    "other".clone_into(&mut second.name);
    second.position = [15.0005, 0.0, 0.0];
    scene.girders.push(second);
    scene.motion = Motion::None;
    scene.duration = 0.05;
    Ok(scene)
}

/// F2: the deck, straight and without friction, before its abutment; damped like β E ε̇, 0.02 of critical of its first mode.
pub(super) fn deck_that_rings() -> Result<Scene, SceneErrors> {
    let mut scene = presets::load("deck-30m-elastic")?;
    "F2".clone_into(&mut scene.name);
    smooth(&mut scene, 2e9, 16.0);
    let rayleigh = Some(Rayleigh { mass: 0.0, stiffness: 1.1e-4 });
    let deck = &mut scene.girders[0];
    deck.elastic = deck.elastic.map(|elastic| Elastic { rayleigh, ..elastic });
    scene.motion = sine(AMPLITUDE, 0.8, 0.0);
    Ok(scene)
}

/// Straight ends, elastic contact of this stiffness without friction, polynomials of this degree.
fn smooth(scene: &mut Scene, stiffness: f64, degree: f64) {
    let contact = &mut scene.contact;
    contact.stiffness = Some(stiffness);
    (contact.restitution_normal, contact.restitution_tangential) = (1.0, 1.0);
    (contact.mu_static, contact.mu_kinetic) = (0.0, 0.0);
    for girder in &mut scene.girders {
        girder.skew_deg = 90.0;
        girder.elastic = girder.elastic.map(|elastic| Elastic { modes: Degree(Some(degree)), ..elastic });
    }
}
