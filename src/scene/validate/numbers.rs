//! Contact numbers, ground motion, solver and view settings.

use super::complaints::number;
use super::{At, Complaints};
use crate::scene::keys::{self, Range};
use crate::scene::{
    ContactSettings, ImpactSettings, Kind, Limits, ModelKind, Motion, PairSettings, RecordMotion, Scene, SineMotion,
};

pub(super) fn contact(contact: &ContactSettings, complaints: &mut Complaints) {
    let mut at = complaints.at("contact", keys::CONTACT);
    stiffness(contact.stiffness, contact.young_modulus, contact.area, &mut at);
    at.number("restitution_normal", contact.restitution_normal);
    at.number("restitution_tangential", contact.restitution_tangential);
    at.number("mu_static", contact.mu_static);
    at.number("mu_kinetic", contact.mu_kinetic);
    friction(contact.mu_static, contact.mu_kinetic, &mut at);
    for (n, pair) in contact.pairs.iter().enumerate() {
        pair_numbers(contact, pair, &mut complaints.at(format!("contact.pair[{n}]"), keys::PAIR));
    }
}

fn pair_numbers(contact: &ContactSettings, pair: &PairSettings, at: &mut At<'_>) {
    stiffness(pair.stiffness, pair.young_modulus, pair.area, at);
    at.if_given("restitution_normal", pair.restitution_normal);
    at.if_given("restitution_tangential", pair.restitution_tangential);
    at.if_given("mu_static", pair.mu_static);
    at.if_given("mu_kinetic", pair.mu_kinetic);
    if pair.mu_static.is_some() || pair.mu_kinetic.is_some() {
        let (mu_s, mu_k) = (pair.mu_static.unwrap_or(contact.mu_static), pair.mu_kinetic.unwrap_or(contact.mu_kinetic));
        friction(mu_s, mu_k, at);
    }
}

/// Numbers of the impact model.
pub(super) fn impact(impact: &ImpactSettings, complaints: &mut Complaints) {
    let mut at = complaints.at("impact", keys::IMPACT);
    at.number("restitution_normal", impact.restitution_normal);
    at.number("restitution_tangential", impact.restitution_tangential);
    at.number("mu_static", impact.mu_static);
    at.number("mu_kinetic", impact.mu_kinetic);
    at.if_given("corner_mu_static", impact.corner_mu_static);
    at.if_given("corner_mu_kinetic", impact.corner_mu_kinetic);
    at.number("stop_speed_m_s", impact.stop_speed);
    friction(impact.mu_static, impact.mu_kinetic, &mut at);
    let [mu_s, mu_k] = impact.corner_friction();
    if mu_k > mu_s {
        let remedy = format!("it must not exceed corner_mu_static = {mu_s:?}: lower it, or raise corner_mu_static");
        at.add("corner_mu_kinetic", number(mu_k), remedy);
    }
}

/// Limits are numbers; a seat may be asked to be longer than it is.
pub(super) fn limits(limits: &Limits, complaints: &mut Complaints) {
    let mut at = complaints.at("limits", keys::LIMITS);
    at.if_given("rotation_deg", limits.rotation_deg);
    at.if_given("drift_m", limits.drift);
    at.if_given("remaining_seat_m", limits.remaining_seat);
    at.if_given("force_n", limits.force);
}

/// The impact model is planar.
pub(super) fn model(scene: &Scene, complaints: &mut Complaints) {
    if scene.kind == Kind::Spatial && scene.model.kind != ModelKind::Contact {
        let value = format!("\"{}\"", scene.model.kind.label());
        let remedy = "the impact model knows planar scenes only: make it \"contact\", or kind = \"planar\"";
        complaints.at("model", keys::MODEL).add("kind", value, remedy);
    }
}

fn stiffness(stiffness: Option<f64>, young_modulus: Option<f64>, area: Option<f64>, at: &mut At<'_>) {
    at.if_given("stiffness_n_per_m", stiffness);
    at.if_given("young_modulus_pa", young_modulus);
    at.if_given("area_m2", area);
    if let (Some(k), true) = (stiffness, young_modulus.is_some() || area.is_some()) {
        let remedy = "K = E A / L comes from young_modulus_pa and area_m2: give either those or stiffness_n_per_m";
        at.add("stiffness_n_per_m", number(k), remedy);
    }
}

fn friction(mu_s: f64, mu_k: f64, at: &mut At<'_>) {
    if mu_k > mu_s {
        let remedy = format!("it must not exceed mu_static = {mu_s:?}: lower it, or raise mu_static");
        at.add("mu_kinetic", number(mu_k), remedy);
    }
}

pub(super) fn motion(motion: &Motion, complaints: &mut Complaints) {
    match motion {
        Motion::None => {}
        Motion::Sine(sine) => harmonic(sine, &mut complaints.at("motion", keys::SINE)),
        Motion::Record(recorded) => record(recorded, &mut complaints.at("motion", keys::RECORD)),
    }
}

fn harmonic(sine: &SineMotion, at: &mut At<'_>) {
    at.if_given("amplitude_g", sine.amplitude_g);
    at.if_given("amplitude_m_s2", sine.amplitude);
    at.number("frequency_hz", sine.frequency_hz);
    at.number("phase_deg", sine.phase_deg);
    at.number("angle_deg", sine.angle_deg);
    match (sine.amplitude_g, sine.amplitude) {
        (None, None) => at.add("amplitude_g", "nothing", "give the amplitude: amplitude_g, or amplitude_m_s2"),
        (Some(_), Some(_)) => at.add("amplitude_g", "amplitude_g and amplitude_m_s2", "give one of the two"),
        _ => {}
    }
}

fn record(record: &RecordMotion, at: &mut At<'_>) {
    at.number("scale", record.scale);
    at.number("angle_deg", record.angle_deg);
    at.if_given("dt_s", record.dt);
    match (&record.samples, &record.file) {
        (None, None) => at.add("samples_m_s2", "nothing", "give samples_m_s2 with dt_s, or file"),
        (Some(_), Some(_)) => at.add("samples_m_s2", "samples_m_s2 and file", "give one of the two"),
        (Some(list), None) => {
            if record.dt.is_none() {
                at.add("dt_s", "nothing", "give the interval between samples in seconds");
            }
            samples("samples_m_s2", list, at);
        }
        (None, Some(file)) => recorded_file(record, file, at),
    }
}

fn recorded_file(record: &RecordMotion, file: &str, at: &mut At<'_>) {
    if let Some(dt) = record.dt {
        at.add("dt_s", number(dt), "the file's own times say it: leave this out");
    }
    match &record.loaded {
        None => at.add("file", format!("\"{file}\""), "this record has not been read: load it beside the scene's file"),
        Some((dt, list)) => {
            at.obeys("file", *dt, Range::Positive);
            samples("file", list, at);
        }
    }
}

fn samples(key: &str, list: &[f64], at: &mut At<'_>) {
    if list.len() < 2 {
        at.add(key, format!("{} samples", list.len()), "a record needs at least 2 samples");
    }
    at.each(key, list);
}

pub(super) fn solver_and_view(scene: &Scene, complaints: &mut Complaints) {
    complaints.at("solver", keys::SOLVER).number("tolerance", scene.solver.tolerance);
    complaints.at("view", keys::VIEW).if_given("force_scale_n_per_m", scene.view.force_scale);
}
