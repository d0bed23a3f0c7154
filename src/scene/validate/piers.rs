//! Piers, each for itself, and the bearings that stand on them.

use super::complaints::{At, Complaints, number};
use crate::scene::keys::Range;
use crate::scene::pier::ColumnTop;
use crate::scene::{Bearings, Girder, Pier, Scene, keys};

/// Checks every pier and every bearing that names one.
pub(super) fn piers(scene: &Scene, complaints: &mut Complaints) {
    for (n, pier) in scene.piers.iter().enumerate() {
        let mut at = complaints.of("pier", &pier.name, keys::PIER);
        at.all(pier);
        stiffness(pier, &mut at);
        beside(pier, &mut at);
        if pier.position.is_none() && scene.standing_on(n).is_empty() {
            let remedy = "no bearing stands on it: name it in a girder's bearings (on_plus_x, on_minus_x, on), or give its place [x, y]";
            at.add("position_m", "nothing", remedy);
        }
    }
    for girder in &scene.girders {
        bearings(scene, girder, complaints);
    }
}

/// k is given in one of three ways, and with all that the way needs.
fn stiffness(pier: &Pier, at: &mut At<'_>) {
    let ways = [
        ("stiffness_n_per_m", pier.stiffness.is_some()),
        ("frequency_hz", pier.frequency.is_some()),
        ("column_m", pier.column.is_some()),
    ];
    let given: Vec<&str> = ways.iter().filter(|(_, given)| *given).map(|(key, _)| *key).collect();
    match given.as_slice() {
        [] => at.add("stiffness_n_per_m", "nothing", "give it in N/m, or frequency_hz, or column_m with height_m"),
        [_] => {}
        [first, ..] => at.add(first, given.join(" and "), "give one of them: they say the same thing"),
    }
    if pier.column.is_some() && pier.height.is_none() {
        at.add("height_m", "nothing", "k = 3EI/h³ needs it: give the height of the column in m");
    }
    if pier.column.is_none() && pier.modulus.is_some() {
        at.add("young_modulus_pa", "a modulus", "it belongs to column_m: give that, or leave it out");
    }
    if pier.column.is_none() && pier.top != ColumnTop::Free {
        at.add("column_top", pier.top.label(), "it belongs to column_m: give that, or leave it out");
    }
}

/// Keys that belong to another, and whole numbers.
fn beside(pier: &Pier, at: &mut At<'_>) {
    for (n, side) in pier.cap.iter().flatten().enumerate() {
        at.obeys(&format!("cap_m[{n}]"), *side, Range::Positive);
    }
    if pier.columns.fract() != 0.0 {
        at.add("columns", number(pier.columns), "give a whole number");
    }
    if let (Some(ratio), None) = (pier.post_yield_ratio, pier.yield_force) {
        at.add("post_yield_ratio", number(ratio), "it belongs to yield_force_n: give that, or leave it out");
    }
    if let (Some(inertia), None) = (pier.turn_inertia, pier.turn_stiffness) {
        at.add(
            "turn_inertia_kg_m2",
            number(inertia),
            "it belongs to turn_stiffness_n_m_per_rad: give that, or leave it out",
        );
    }
}

/// Piers that bearings name.
fn bearings(scene: &Scene, girder: &Girder, complaints: &mut Complaints) {
    let mut at = complaints.of("girder", &girder.name, keys::GIRDER);
    let named: Vec<(String, &str)> = match &girder.bearings {
        None => return,
        Some(Bearings::Shared(shared)) => {
            let ends = [("on_minus_x", &shared.on_minus_x), ("on_plus_x", &shared.on_plus_x)];
            ends.iter().filter_map(|(key, on)| Some((format!("bearings.{key}"), on.as_deref()?))).collect()
        }
        Some(Bearings::Deck(deck)) => {
            let ends = [("on_minus_x", &deck.on_minus_x), ("on_plus_x", &deck.on_plus_x)];
            ends.iter().filter_map(|(key, on)| Some((format!("bearings.{key}"), on.as_deref()?))).collect()
        }
        Some(Bearings::Each(each)) => {
            let named = each.iter().enumerate();
            named.filter_map(|(n, b)| Some((format!("bearings[{n}].on"), b.on.as_deref()?))).collect()
        }
    };
    let slides = girder.supports(scene.setting()).into_iter().map(|bearing| bearing.sliding.is_some());
    if slides.zip(scene.supports(girder)).any(|(slides, pier)| slides && pier.is_some()) {
        let remedy =
            "in space a slider goes by the force of its own spring on the ground: put it there, or use a planar scene";
        at.add("bearings", "a slider on a pier", remedy);
    }
    for (key, name) in named.iter().filter(|(_, name)| scene.pier_named(name).is_none()) {
        let known: Vec<&str> = scene.piers.iter().map(|pier| pier.name.as_str()).collect();
        let known = if known.is_empty() {
            "the scene has none: add a [[pier]]".to_owned()
        } else {
            format!("piers: {}", known.join(", "))
        };
        at.add(key, format!("{name:?}"), format!("no pier has this name; {known}, or leave it out for the ground"));
    }
}
