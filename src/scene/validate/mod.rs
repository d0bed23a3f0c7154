//! Whether a scene makes sense: everything that can be known without running it.
//!
//! All complaints are collected, so that one reading of them is enough to mend the file. What needs sound sizes
//! (faces, overlaps, facing ends) is asked only where the sizes are sound.

mod bearings;
mod bodies;
mod complaints;
mod devices;
mod elastic;
mod numbers;
mod piers;
mod placing;
mod record;
mod wave;

pub use complaints::{SceneError, SceneErrors};

use super::facing::Facing;
use super::top::VERSION;
use super::{Scene, keys};
use crate::language::{Text, message};
use complaints::Complaints;

/// Checks a whole scene (everything that can be known without running it).
///
/// # Errors
/// Every complaint, about "scene"; [`SceneErrors::in_file`] names the file.
pub fn validate(scene: &Scene) -> Result<(), SceneErrors> {
    facings(scene).map(|_| ())
}

/// Validates a scene as its file gives it, with its assumed values.
///
/// # Errors
/// Those of [`validate`]; paths of assumed values that lead to nothing.
pub fn validate_file(scene: &Scene) -> Result<(), SceneErrors> {
    validate(scene)?;
    let unknown = scene.unknown_assumed();
    if unknown.is_empty() { Ok(()) } else { Err(SceneErrors(unknown)) }
}

/// The same; and who faces whom, which it finds out on the way.
///
/// # Errors
/// Those of [`validate`].
pub fn facings(scene: &Scene) -> Result<Vec<Facing>, SceneErrors> {
    let mut complaints = Complaints::default();
    top(scene, &mut complaints);
    placing::names(scene, &mut complaints);
    for girder in &scene.girders {
        bodies::girder(girder, scene.setting(), &mut complaints.of("girder", &girder.name, keys::GIRDER));
    }
    for abutment in &scene.abutments {
        bodies::abutment(abutment, &mut complaints.of("abutment", &abutment.name, keys::ABUTMENT));
    }
    piers::piers(scene, &mut complaints);
    let sound = complaints.is_empty();
    devices::devices(scene, sound, &mut complaints);
    numbers::contact(&scene.contact, &mut complaints);
    numbers::model(scene, &mut complaints);
    numbers::impact(&scene.impact, &mut complaints);
    numbers::limits(&scene.limits, &mut complaints);
    complaints.at("codes", keys::CODES).all(&scene.codes);
    for (place, motion) in scene.motions() {
        numbers::motion(&place, motion, scene.kind, &mut complaints);
    }
    wave::grounds(scene, &mut complaints);
    numbers::solver_and_view(scene, &mut complaints);
    wave::wave(scene, &mut complaints);
    let mut facings = Vec::new();
    if complaints.is_empty() {
        facings = placing::faces(scene, &mut complaints);
    }
    if complaints.is_empty() {
        placing::heights(scene, &mut complaints);
    }
    if complaints.is_empty() {
        placing::overlaps(scene, &mut complaints);
    }
    complaints.into_result().map(|()| facings)
}

fn top(scene: &Scene, complaints: &mut Complaints) {
    let mut at = complaints.at("", keys::TOP);
    if scene.format != VERSION {
        at.add("format", scene.format, message!("wrong-format", "version" => VERSION));
    }
    if scene.name.trim().is_empty() {
        at.add("name", format!("\"{}\"", scene.name), Text::new("wrong-no-name"));
    }
    at.number("duration_s", scene.duration);
    at.number("gravity_m_s2", scene.gravity);
    if scene.girders.is_empty() {
        at.add("girder", Text::new("found-nothing"), Text::new("wrong-no-girder"));
    }
}
