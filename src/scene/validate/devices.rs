//! Devices: their numbers, the bodies that they name, their points.

use super::bodies::FAR;
use super::complaints::{Complaints, numbers};
use crate::language::{Message, Text, message};
use crate::scene::device::{DeviceKind, Ends, Joint, Part};
use crate::scene::domain::measures::device_places;
use crate::scene::facing::names;
use crate::scene::keys::{Keyed, Stated};
use crate::scene::{Kind, Scene};

/// Checks every device; `sound` says whether the bodies of the scene are.
pub(super) fn devices(scene: &Scene, sound: bool, complaints: &mut Complaints) {
    for &kind in DeviceKind::ALL {
        match kind {
            DeviceKind::Restrainer => each(scene, sound, (kind, &scene.restrainers), complaints),
            DeviceKind::Bumper => each(scene, sound, (kind, &scene.bumpers), complaints),
            DeviceKind::Damper => each(scene, sound, (kind, &scene.dampers), complaints),
            DeviceKind::Stopper => each(scene, sound, (kind, &scene.stoppers), complaints),
        }
    }
}

fn each<T: Keyed + Part>(scene: &Scene, sound: bool, (kind, devices): (DeviceKind, &[T]), complaints: &mut Complaints) {
    for device in devices {
        let ends = device.ends();
        let mut at = complaints.of(kind.label(), ends.name, kind.keys());
        at.all(device);
        let planar = scene.kind == Kind::Planar;
        for (key, stated) in device.stated() {
            // Points and directions.
            if let Stated::Numbers(vector @ [_, _, up]) = stated
                && planar
                && *up != 0.0
            {
                let remedy = Text::new("wrong-vertical-in-plan");
                at.add(key, numbers(vector), remedy);
            }
        }
        let wrong_body = bodies(scene, &ends);
        if let Some((key, value, remedy)) = wrong_body.clone() {
            at.add(key, value, remedy);
        }
        let places = if sound { device_places(scene, &ends) } else { Vec::new() };
        for (key, far) in places.into_iter().filter(|(_, far)| *far > FAR) {
            at.add(key, message!("found-device-far", "far" => format!("{far:.3e}")), Text::new("wrong-device-far"));
        }
        let joint = if sound && wrong_body.is_none() { Joint::of(scene, &ends) } else { None };
        for (key, value, remedy) in device.faults(joint.as_ref()) {
            at.add(key, value, remedy);
        }
    }
}

/// Fault of the bodies that a device names.
fn bodies(scene: &Scene, ends: &Ends<'_>) -> Option<(&'static str, Message, Message)> {
    let is_girder = |name: &str| scene.girders.iter().any(|g| g.name == name);
    if !is_girder(ends.girder) {
        let remedy = message!("wrong-no-such-girder", "names" => names(scene));
        return Some(("girder", format!("{:?}", ends.girder).into(), remedy));
    }
    let to = ends.to?;
    if to == ends.girder {
        let remedy = Text::new("wrong-one-girder");
        return Some(("to", format!("{to:?}").into(), remedy.into()));
    }
    let known = is_girder(to) || scene.abutments.iter().any(|a| a.name == to);
    let remedy = || {
        let is_pier = scene.piers.iter().any(|pier| pier.name == to);
        if is_pier {
            message!("wrong-device-on-pier", "names" => names(scene))
        } else {
            message!("wrong-no-such-body", "names" => names(scene))
        }
    };
    (!known).then(|| ("to", format!("{to:?}").into(), remedy()))
}
