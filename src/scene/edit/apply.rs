//! Application of each edit, and its inverse.

use std::mem::replace;

use super::names::is_named;
use super::{Edit, EditError, General};
use crate::scene::{Abutment, Device, DeviceId, Girder, Pier, Scene, assumed, overrides};

type Undone = Result<Edit, EditError>;

impl Edit {
    /// Does the edit and answers with the one that undoes it, exactly.
    ///
    /// # Errors
    /// Numbers or names that are not there, names that are taken, values that cannot be read; nothing is changed.
    pub fn apply(self, scene: &mut Scene) -> Result<Self, EditError> {
        apply(self, scene)
    }
}

fn apply(edit: Edit, scene: &mut Scene) -> Undone {
    match edit {
        Edit::AddGirder(at, girder) => whole(scene, |scene| add_girder(scene, at, *girder)),
        Edit::RemoveGirder(at) => whole(scene, |scene| remove_girder(scene, at)),
        Edit::ReplaceGirder(at, girder) => replace_girder(scene, at, *girder),
        Edit::MoveGirder(at, position, heading_deg) => move_girder(scene, at, position, heading_deg),
        Edit::AddAbutment(at, abutment) => whole(scene, |scene| add_abutment(scene, at, *abutment)),
        Edit::RemoveAbutment(at) => whole(scene, |scene| remove_abutment(scene, at)),
        Edit::ReplaceAbutment(at, abutment) => replace_abutment(scene, at, *abutment),
        Edit::AddPier(at, pier) => whole(scene, |scene| add_pier(scene, at, *pier)),
        Edit::RemovePier(at) => whole(scene, |scene| remove_pier(scene, at)),
        Edit::ReplacePier(at, pier) => replace_pier(scene, at, *pier),
        Edit::AddDevice(at, device) => whole(scene, |scene| add_device(scene, at, *device)),
        Edit::RemoveDevice(id) => whole(scene, |scene| match scene.remove_device(id) {
            Some(_) => Ok(()),
            None => Err(no_device(scene, id)),
        }),
        Edit::ReplaceDevice(id, device) => replace_device(scene, id, *device),
        Edit::Rename(from, to) => whole(scene, |scene| rename(scene, &from, &to)),
        Edit::Assumed(assumed) => Ok(Edit::Assumed(replace(&mut scene.assumed, assumed))),
        Edit::General(general) => Ok(set_general(scene, *general)),
        Edit::Contact(contact) => Ok(Edit::Contact(Box::new(replace(&mut scene.contact, *contact)))),
        Edit::Model(model) => Ok(Edit::Model(replace(&mut scene.model, model))),
        Edit::Impact(impact) => Ok(Edit::Impact(replace(&mut scene.impact, impact))),
        Edit::Motion(motion) => Ok(Edit::Motion(Box::new(replace(&mut scene.motion, *motion)))),
        Edit::Grounds(grounds) => Ok(Edit::Grounds(replace(&mut scene.grounds, grounds))),
        Edit::Wave(wave) => Ok(Edit::Wave(replace(&mut scene.wave, wave))),
        Edit::Limits(limits) => Ok(Edit::Limits(replace(&mut scene.limits, limits))),
        Edit::Codes(codes) => Ok(Edit::Codes(replace(&mut scene.codes, codes))),
        Edit::Solver(solver) => Ok(Edit::Solver(replace(&mut scene.solver, solver))),
        Edit::View(view) => Ok(Edit::View(replace(&mut scene.view, view))),
        Edit::Set(setting) => whole(scene, |scene| {
            *scene = overrides::apply(scene, &setting)?;
            Ok(())
        }),
        Edit::Scene(other) => Ok(Edit::Scene(Box::new(replace(scene, *other)))),
        Edit::Batch(edits) => batch(scene, edits),
    }
}

fn missing(what: &'static str, index: usize, count: usize) -> EditError {
    EditError::Missing { what, index, count }
}

/// Does what renumbers, adds or takes away to a copy, and undoes it by the scene as it was: exact whatever refers to
/// whom, and nothing is changed halfway.
fn whole(scene: &mut Scene, change: impl FnOnce(&mut Scene) -> Result<(), EditError>) -> Undone {
    let mut changed = scene.clone();
    change(&mut changed)?;
    Ok(Edit::Scene(Box::new(replace(scene, changed))))
}

fn add_girder(scene: &mut Scene, at: usize, girder: Girder) -> Result<(), EditError> {
    if at > scene.girders.len() {
        return Err(missing("girder", at, scene.girders.len()));
    }
    if is_named(scene, &girder.name) {
        return Err(EditError::NameTaken(girder.name));
    }
    scene.girders.insert(at, girder);
    Ok(())
}

fn add_abutment(scene: &mut Scene, at: usize, abutment: Abutment) -> Result<(), EditError> {
    if at > scene.abutments.len() {
        return Err(missing("abutment", at, scene.abutments.len()));
    }
    if is_named(scene, &abutment.name) {
        return Err(EditError::NameTaken(abutment.name));
    }
    scene.abutments.insert(at, abutment);
    Ok(())
}

fn add_pier(scene: &mut Scene, at: usize, pier: Pier) -> Result<(), EditError> {
    if at > scene.piers.len() {
        return Err(missing("pier", at, scene.piers.len()));
    }
    if is_named(scene, &pier.name) {
        return Err(EditError::NameTaken(pier.name));
    }
    scene.piers.insert(at, pier);
    Ok(())
}

/// Takes a pier out and puts what stood on it on the ground.
fn remove_pier(scene: &mut Scene, at: usize) -> Result<(), EditError> {
    if at >= scene.piers.len() {
        return Err(missing("pier", at, scene.piers.len()));
    }
    let name = scene.piers.remove(at).name;
    for on in scene.support_names().filter(|on| on.as_ref() == Some(&name)) {
        *on = None;
    }
    Ok(())
}

fn no_device(scene: &Scene, id: DeviceId) -> EditError {
    missing(id.kind.label(), id.number, scene.count_of(id.kind))
}

fn add_device(scene: &mut Scene, at: usize, device: Device) -> Result<(), EditError> {
    let count = scene.count_of(device.kind());
    if at > count {
        return Err(missing(device.kind().label(), at, count));
    }
    let name = device.part().ends().name.to_owned();
    if is_named(scene, &name) {
        return Err(EditError::NameTaken(name));
    }
    scene.insert_device(at, device);
    Ok(())
}

/// Another device of one kind and name.
fn replace_device(scene: &mut Scene, id: DeviceId, device: Device) -> Undone {
    let here = scene.device(id).filter(|here| here.kind() == device.kind()).ok_or_else(|| no_device(scene, id))?;
    let [old, new] = [&here, &device].map(|device| device.part().ends().name.to_owned());
    if old != new {
        return Err(EditError::OtherName(old, new));
    }
    scene.remove_device(id);
    scene.insert_device(id.number, device);
    Ok(Edit::ReplaceDevice(id, Box::new(here)))
}

/// Takes a girder out with everything that would be left referring to nobody.
fn remove_girder(scene: &mut Scene, at: usize) -> Result<(), EditError> {
    if at >= scene.girders.len() {
        return Err(missing("girder", at, scene.girders.len()));
    }
    let name = scene.girders.remove(at).name;
    let facing = scene.abutments.iter().filter(|a| a.faces == name).map(|a| a.name.clone());
    let gone: Vec<String> = facing.chain([name.clone()]).collect();
    scene.abutments.retain(|a| a.faces != name);
    drop_references(scene, &gone);
    Ok(())
}

fn remove_abutment(scene: &mut Scene, at: usize) -> Result<(), EditError> {
    if at >= scene.abutments.len() {
        return Err(missing("abutment", at, scene.abutments.len()));
    }
    let name = scene.abutments.remove(at).name;
    drop_references(scene, &[name]);
    Ok(())
}

/// Takes out the pairs and the devices that name somebody who is gone; what stood there stands on the ground.
fn drop_references(scene: &mut Scene, gone: &[String]) {
    for on in scene.support_names().filter(|on| on.as_ref().is_some_and(|name| gone.contains(name))) {
        *on = None;
    }
    scene.contact.pairs.retain(|pair| !pair.between.iter().any(|name| gone.contains(name)));
    let is_gone = |name: &str| gone.iter().any(|gone| gone == name);
    scene.retain_devices(|device| {
        let ends = device.ends();
        !is_gone(ends.girder) && !ends.to.is_some_and(is_gone)
    });
}

fn replace_girder(scene: &mut Scene, at: usize, girder: Girder) -> Undone {
    let count = scene.girders.len();
    let here = scene.girders.get_mut(at).ok_or_else(|| missing("girder", at, count))?;
    if here.name != girder.name {
        return Err(EditError::OtherName(here.name.clone(), girder.name));
    }
    Ok(Edit::ReplaceGirder(at, Box::new(replace(here, girder))))
}

fn replace_abutment(scene: &mut Scene, at: usize, abutment: Abutment) -> Undone {
    let count = scene.abutments.len();
    let here = scene.abutments.get_mut(at).ok_or_else(|| missing("abutment", at, count))?;
    if here.name != abutment.name {
        return Err(EditError::OtherName(here.name.clone(), abutment.name));
    }
    Ok(Edit::ReplaceAbutment(at, Box::new(replace(here, abutment))))
}

fn replace_pier(scene: &mut Scene, at: usize, pier: Pier) -> Undone {
    let count = scene.piers.len();
    let here = scene.piers.get_mut(at).ok_or_else(|| missing("pier", at, count))?;
    if here.name != pier.name {
        return Err(EditError::OtherName(here.name.clone(), pier.name));
    }
    Ok(Edit::ReplacePier(at, Box::new(replace(here, pier))))
}

fn move_girder(scene: &mut Scene, at: usize, position: [f64; 3], heading_deg: f64) -> Undone {
    let count = scene.girders.len();
    let here = scene.girders.get_mut(at).ok_or_else(|| missing("girder", at, count))?;
    let before = (replace(&mut here.position, position), replace(&mut here.heading_deg, heading_deg));
    Ok(Edit::MoveGirder(at, before.0, before.1))
}

fn rename(scene: &mut Scene, from: &str, to: &str) -> Result<(), EditError> {
    if !is_named(scene, from) {
        return Err(EditError::Nobody(from.to_owned()));
    }
    if from != to && is_named(scene, to) {
        return Err(EditError::NameTaken(to.to_owned()));
    }
    let own = scene.girders.iter_mut().map(|g| &mut g.name);
    let abutments = scene.abutments.iter_mut().flat_map(|a| [&mut a.name, &mut a.faces]);
    let pairs = scene.contact.pairs.iter_mut().flat_map(|pair| pair.between.iter_mut());
    for name in own.chain(abutments).chain(pairs).filter(|name| *name == from) {
        to.clone_into(name);
    }
    assumed::rename(&mut scene.assumed, from, to);
    let piers = scene.piers.iter_mut().map(|pier| &mut pier.name);
    piers.filter(|name| *name == from).for_each(|name| to.clone_into(name));
    for on in scene.support_names().flatten().filter(|name| *name == from) {
        to.clone_into(on);
    }
    for device in scene.devices_mut() {
        let ends = device.ends_mut();
        for name in [Some(ends.name), Some(ends.girder), ends.to.as_mut()].into_iter().flatten() {
            if name == from {
                to.clone_into(name);
            }
        }
    }
    Ok(())
}

fn set_general(scene: &mut Scene, general: General) -> Edit {
    let before = General::of(scene);
    let General { name, description, kind, duration, gravity } = general;
    (scene.name, scene.description, scene.kind) = (name, description, kind);
    (scene.duration, scene.gravity) = (duration, gravity);
    Edit::General(Box::new(before))
}

/// All or nothing.
fn batch(scene: &mut Scene, edits: Vec<Edit>) -> Undone {
    let mut back = Vec::with_capacity(edits.len());
    for edit in edits {
        match apply(edit, scene) {
            Ok(inverse) => back.push(inverse),
            Err(error) => {
                for inverse in back.into_iter().rev() {
                    apply(inverse, scene)?;
                }
                return Err(error);
            }
        }
    }
    back.reverse();
    Ok(Edit::Batch(back))
}
