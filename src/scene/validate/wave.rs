//! Ground that does not move as one: what it can be combined with.

use glam::DVec3;

use super::complaints::Complaints;
use crate::language::{Text, message};
use crate::scene::{Girder, Kind, ModelKind, Motion, MovingSupports, Scene, keys, placed};

/// Grounds that abutments and piers name.
pub(super) fn grounds(scene: &Scene, complaints: &mut Complaints) {
    let abutments = scene.abutments.iter().map(|a| ("abutment", &a.name, keys::ABUTMENT, &a.ground));
    let piers = scene.piers.iter().map(|pier| ("pier", &pier.name, keys::PIER, &pier.ground));
    for (kind, name, keys, ground) in abutments.chain(piers) {
        let Some(wanted) = ground.as_ref().filter(|wanted| scene.ground_named(wanted).is_none()) else { continue };
        let known: Vec<&str> = scene.grounds.iter().map(|ground| ground.name.as_str()).collect();
        let known = if known.is_empty() {
            Text::new("wrong-no-ground").into()
        } else {
            message!("wrong-piers", "names" => known.join(", "))
        };
        let remedy = message!("wrong-no-such-ground", "known" => known);
        complaints.of(kind, name, keys).add("ground", format!("{wanted:?}"), remedy);
    }
}

/// Checks the wave, and what stands on ground that moves otherwise.
pub(super) fn wave(scene: &Scene, complaints: &mut Complaints) {
    if let Some(wave) = &scene.wave {
        complaints.at("wave", keys::WAVE).all(wave);
    }
    // The places of supports need sound numbers.
    if !complaints.is_empty() {
        return;
    }
    let Some(supports) = scene.moving_supports() else { return };
    if scene.model.kind != ModelKind::Contact {
        let value = message!("found-model-wave", "model" => scene.model.kind.label());
        complaints.at("model", keys::MODEL).add("kind", value, Text::new("wrong-impact-wave"));
    }
    for (number, pier) in scene.piers.iter().enumerate() {
        let own =
            pier.ground.as_ref().and_then(|name| scene.ground_named(name)).map(|number| &scene.grounds[number].motion);
        let vertical = scene.motion.is_vertical() || own.is_some_and(Motion::is_vertical);
        if scene.kind == Kind::Spatial && vertical && supports.of_pier(number).is_some() {
            let mut at = complaints.of("pier", &pier.name, keys::PIER);
            let key = if own.is_some() { "ground" } else { "delay_s" };
            at.add(key, Text::new("found-foot-wave"), Text::new("wrong-foot-wave"));
        }
    }
    for girder in scene.girders.iter().filter(|girder| slides_on_moving_ground(scene, girder, &supports)) {
        let mut at = complaints.of("girder", &girder.name, keys::GIRDER);
        at.add("bearings", Text::new("found-slider-wave"), Text::new("wrong-slider-wave"));
    }
}

fn slides_on_moving_ground(scene: &Scene, girder: &Girder, supports: &MovingSupports) -> bool {
    let (axes, home) = (placed::axes(girder), DVec3::from(girder.position));
    let mut bearings = girder.supports(scene.setting()).into_iter().zip(scene.standing(girder));
    bearings.any(|(bearing, on)| bearing.sliding.is_some() && supports.under(on, home + axes * bearing.place).is_some())
}
