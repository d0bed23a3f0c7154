//! Contact numbers, ground motion, solver and view settings.

use super::complaints::{At, Complaints, number};
use super::record::record;
use crate::contact::NormalName;
use crate::contact::calibration::{self, least_bilinear_restitution};
use crate::scene::contact::LEAST_RESTITUTION;
use crate::scene::keys;
use crate::scene::{ContactSettings, ImpactSettings, Kind, Limits, ModelKind, Motion, Scene, SineMotion, Tension};

pub(super) fn contact(contact: &ContactSettings, complaints: &mut Complaints) {
    let mut at = complaints.at("contact", keys::CONTACT);
    at.all(contact);
    stiffness(contact.stiffness, [contact.young_modulus, contact.area, contact.contact_length], &mut at);
    at.in_order(contact, contact);
    normal_law(contact, &mut at);
    for (n, pair) in contact.pairs.iter().enumerate() {
        let mut in_force = contact.alone();
        in_force.lay_over(pair);
        let mut at = complaints.at(format!("contact.pair[{n}]"), keys::PAIR);
        at.all(pair);
        stiffness(pair.stiffness, [pair.young_modulus, pair.area, pair.contact_length], &mut at);
        at.in_order(pair, &in_force);
        normal_law(&in_force, &mut at);
    }
}

/// A bilinear spring that loses too much has no stiffness after yield; a parameter of a dashpot returns at least the least
/// restitution that can be asked for.
fn normal_law(contact: &ContactSettings, at: &mut At<'_>) {
    let least = least_bilinear_restitution(contact.calibration);
    if contact.normal_law == NormalName::Bilinear && contact.restitution_normal <= least {
        let remedy = format!(
            "the bilinear spring has no stiffness after yield up to e_n = {least:.4}: give more, or another normal_law"
        );
        at.add("restitution_normal", number(contact.restitution_normal), &remedy);
    }
    if let Some(parameter) = contact.law_parameter {
        let returned = calibration::returned(contact.normal_law, parameter, contact.tension == Tension::Clamp);
        if returned < LEAST_RESTITUTION {
            let remedy =
                format!("a head-on hit would return less than e = {LEAST_RESTITUTION}, or never part: give less");
            at.add("law_parameter", number(parameter), &remedy);
        }
    }
}

/// Numbers of the impact model.
pub(super) fn impact(impact: &ImpactSettings, complaints: &mut Complaints) {
    let mut at = complaints.at("impact", keys::IMPACT);
    at.all(impact);
    let [mu_s, mu_k] = impact.corner_friction();
    let in_force = ImpactSettings { corner_mu_static: Some(mu_s), corner_mu_kinetic: Some(mu_k), ..*impact };
    at.in_order(&in_force, &in_force);
}

/// Limits are numbers; a seat may be asked to be longer than it is.
pub(super) fn limits(limits: &Limits, complaints: &mut Complaints) {
    complaints.at("limits", keys::LIMITS).all(limits);
}

/// The impact model is planar.
pub(super) fn model(scene: &Scene, complaints: &mut Complaints) {
    if scene.kind == Kind::Spatial && scene.model.kind != ModelKind::Contact {
        let value = format!("\"{}\"", scene.model.kind.label());
        let remedy = "the impact model knows planar scenes only: make it \"contact\", or kind = \"planar\"";
        complaints.at("model", keys::MODEL).add("kind", value, remedy);
    }
    let elastic = scene.girders.iter().find(|girder| girder.elastic.is_some());
    if let Some(girder) = elastic.filter(|_| scene.model.kind != ModelKind::Contact) {
        let value = format!("\"{}\" with an elastic girder, {}", scene.model.kind.label(), girder.name);
        let remedy = "the impact model knows rigid girders only: make it \"contact\", or leave out [girder.elastic]";
        complaints.at("model", keys::MODEL).add("kind", value, remedy);
    }
}

fn stiffness(stiffness: Option<f64>, of_section: [Option<f64>; 3], at: &mut At<'_>) {
    if let (Some(k), true) = (stiffness, of_section.iter().any(Option::is_some)) {
        let remedy = "K = E A / L comes from young_modulus_pa, area_m2 and contact_length_m: give either those or stiffness_n_per_m";
        at.add("stiffness_n_per_m", number(k), remedy);
    }
}

pub(super) fn motion(motion: &Motion, kind: Kind, complaints: &mut Complaints) {
    match motion {
        Motion::None => {}
        Motion::Sine(sine) => harmonic(sine, kind, &mut complaints.at("motion", keys::SINE)),
        Motion::Synthetic(synthetic) => {
            let at = &mut complaints.at("motion", keys::SYNTHETIC);
            at.all(synthetic);
            at.fits(synthetic, kind);
            if let Some((key, value, remedy)) = synthetic.fault() {
                at.add(key, number(value), remedy);
            }
        }
        Motion::Sweep(sweep) => {
            let at = &mut complaints.at("motion", keys::SWEEP);
            at.all(sweep);
            if let Some((key, value, remedy)) = sweep.fault() {
                at.add(key, number(value), remedy);
            }
        }
        Motion::Record(recorded) => record(recorded, kind, complaints),
    }
}

fn harmonic(sine: &SineMotion, kind: Kind, at: &mut At<'_>) {
    at.all(sine);
    at.fits(sine, kind);
    if sine.vertical_amplitude_g.is_some() && sine.vertical_amplitude.is_some() {
        at.add("vertical_amplitude_g", "vertical_amplitude_g and vertical_amplitude_m_s2", "give one of the two");
    }
    match (sine.amplitude_g, sine.amplitude) {
        (None, None) => at.add("amplitude_g", "nothing", "give the amplitude: amplitude_g, or amplitude_m_s2"),
        (Some(_), Some(_)) => at.add("amplitude_g", "amplitude_g and amplitude_m_s2", "give one of the two"),
        _ => {}
    }
}

pub(super) fn solver_and_view(scene: &Scene, complaints: &mut Complaints) {
    complaints.at("solver", keys::SOLVER).all(&scene.solver);
    complaints.at("view", keys::VIEW).all(&scene.view);
}
