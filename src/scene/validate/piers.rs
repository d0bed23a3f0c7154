//! Piers, each for itself, and the bearings that stand on them.

use super::complaints::{At, Complaints, number};
use crate::language::{Message, Text, message};
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
            let remedy = Text::new("wrong-pier-bears-nothing");
            at.add("position_m", Text::new("found-nothing"), remedy);
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
        [] => at.add("stiffness_n_per_m", Text::new("found-nothing"), Text::new("wrong-pier-no-stiffness")),
        [_] => {}
        [first, others @ ..] => {
            let both = |one, other: &&str| message!("found-both", "one" => one, "other" => *other);
            at.add(first, others.iter().fold(Message::from(*first), both), Text::new("wrong-same-thing"));
        }
    }
    if pier.column.is_some() && pier.height.is_none() {
        at.add("height_m", Text::new("found-nothing"), Text::new("wrong-no-column-height"));
    }
    if pier.column.is_none() && pier.modulus.is_some() {
        at.add("young_modulus_pa", Text::new("found-modulus"), Text::new("wrong-column-missing"));
    }
    if pier.column.is_none() && pier.top != ColumnTop::Free {
        at.add("column_top", pier.top.label(), Text::new("wrong-column-missing"));
    }
}

/// Keys that belong to another, and whole numbers.
fn beside(pier: &Pier, at: &mut At<'_>) {
    for (n, side) in pier.cap.iter().flatten().enumerate() {
        at.obeys(&format!("cap_m[{n}]"), *side, Range::Positive);
    }
    if pier.columns.fract() != 0.0 {
        at.add("columns", number(pier.columns), Text::new("wrong-not-whole"));
    }
    if let (Some(ratio), None) = (pier.post_yield_ratio, pier.yield_force) {
        at.add("post_yield_ratio", number(ratio), Text::new("wrong-yield-force-missing"));
    }
    if let (Some(inertia), None) = (pier.turn_inertia, pier.turn_stiffness) {
        at.add("turn_inertia_kg_m2", number(inertia), Text::new("wrong-turn-stiffness-missing"));
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
        let remedy = Text::new("wrong-slider-on-pier");
        at.add("bearings", Text::new("found-slider-on-pier"), remedy);
    }
    let abutments = || scene.abutments.iter().map(|abutment| abutment.name.as_str());
    let known: Vec<&str> = scene.piers.iter().map(|pier| pier.name.as_str()).chain(abutments()).collect();
    for (key, name) in named.iter().filter(|(_, name)| !known.contains(name)) {
        let known = if known.is_empty() {
            Text::new("wrong-no-pier").into()
        } else {
            message!("wrong-piers", "names" => known.join(", "))
        };
        at.add(key, format!("{name:?}"), message!("wrong-no-such-pier", "known" => known));
    }
}
