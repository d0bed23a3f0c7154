//! Contact numbers, ground motion, solver and view settings.

use super::complaints::{At, Complaints, number};
use super::record::record;
use crate::contact::NormalName;
use crate::contact::calibration::{self, least_bilinear_restitution};
use crate::language::{Text, message};
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
        let remedy = message!("wrong-bilinear", "least" => format!("{least:.4}"));
        at.add("restitution_normal", number(contact.restitution_normal), remedy);
    }
    if let Some(parameter) = contact.law_parameter {
        let returned = calibration::returned(contact.normal_law, parameter, contact.tension == Tension::Clamp);
        if returned < LEAST_RESTITUTION {
            let remedy = message!("wrong-law-parameter", "least" => LEAST_RESTITUTION);
            at.add("law_parameter", number(parameter), remedy);
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
        let remedy = Text::new("wrong-impact-in-space");
        complaints.at("model", keys::MODEL).add("kind", value, remedy);
    }
    let elastic = scene.girders.iter().find(|girder| girder.elastic.is_some());
    if let Some(girder) = elastic.filter(|_| scene.model.kind != ModelKind::Contact) {
        let value =
            message!("found-model-elastic", "model" => scene.model.kind.label(), "girder" => girder.name.as_str());
        let remedy = Text::new("wrong-impact-elastic");
        complaints.at("model", keys::MODEL).add("kind", value, remedy);
    }
}

fn stiffness(stiffness: Option<f64>, of_section: [Option<f64>; 3], at: &mut At<'_>) {
    if let (Some(k), true) = (stiffness, of_section.iter().any(Option::is_some)) {
        let remedy = Text::new("wrong-stiffness-twice");
        at.add("stiffness_n_per_m", number(k), remedy);
    }
}

/// A motion of the ground, by its place in the scene's file.
pub(super) fn motion(place: &str, motion: &Motion, kind: Kind, complaints: &mut Complaints) {
    match motion {
        Motion::None => {}
        Motion::Sine(sine) => harmonic(sine, kind, &mut complaints.at(place, keys::SINE)),
        Motion::Synthetic(synthetic) => {
            let at = &mut complaints.at(place, keys::SYNTHETIC);
            at.all(synthetic);
            at.fits(synthetic, kind);
            if let Some((key, value, remedy)) = synthetic.fault() {
                at.add(key, number(value), remedy);
            }
        }
        Motion::Sweep(sweep) => {
            let at = &mut complaints.at(place, keys::SWEEP);
            at.all(sweep);
            if let Some((key, value, remedy)) = sweep.fault() {
                at.add(key, number(value), remedy);
            }
        }
        Motion::Record(recorded) => record(place, recorded, kind, complaints),
    }
}

fn harmonic(sine: &SineMotion, kind: Kind, at: &mut At<'_>) {
    at.all(sine);
    at.fits(sine, kind);
    if sine.vertical_amplitude_g.is_some() && sine.vertical_amplitude.is_some() {
        at.add(
            "vertical_amplitude_g",
            message!("found-both", "one" => "vertical_amplitude_g", "other" => "vertical_amplitude_m_s2"),
            Text::new("wrong-both"),
        );
    }
    match (sine.amplitude_g, sine.amplitude) {
        (None, None) => at.add("amplitude_g", Text::new("found-nothing"), Text::new("wrong-no-amplitude")),
        (Some(_), Some(_)) => at.add(
            "amplitude_g",
            message!("found-both", "one" => "amplitude_g", "other" => "amplitude_m_s2"),
            Text::new("wrong-both"),
        ),
        _ => {}
    }
}

pub(super) fn solver_and_view(scene: &Scene, complaints: &mut Complaints) {
    complaints.at("solver", keys::SOLVER).all(&scene.solver);
    complaints.at("view", keys::VIEW).all(&scene.view);
}
