//! Edits of the outlines of girders: devices keep their places on them.

use glam::DVec3;

use super::change::{girder, tidy};
use super::devices::device;
use crate::scene::edit::Edit;
use crate::scene::keys::Editable as _;
use crate::scene::{Girder, Scene};
use crate::view::Target;

/// Turns the ends of these girders, or of all where none is given.
pub(in crate::app) fn skew(scene: &Scene, these: &[usize], skew_deg: f64) -> Edit {
    let turned = scene.girders.iter().enumerate().filter(|(i, _)| these.is_empty() || these.contains(i));
    all_reshaped(scene, turned.map(|(i, g)| (i, Girder { skew_deg, ..g.clone() })))
}

/// A girder with other numbers; each number that was changed goes to the other selected girders too.
pub(in crate::app) fn girders_alike(scene: &Scene, i: usize, new: &Girder, selected: &[Target]) -> Edit {
    let Some(old) = scene.girders.get(i) else { return girder(i, new.clone()) };
    let mut all = vec![(i, new.clone())];
    for target in selected {
        let Target::Girder(k) = *target else { continue };
        if let Some(other) = scene.girders.get(k).filter(|_| k != i) {
            let mut other = other.clone();
            other.carry(old, new);
            all.push((k, other));
        }
    }
    all_reshaped(scene, all)
}

/// Gives a girder another outline; devices keep their places on it as shares of its plan.
pub(in crate::app) fn reshaped(scene: &Scene, i: usize, new: Girder) -> Edit {
    let Some(old) = scene.girders.get(i) else { return girder(i, new) };
    let [before, after] = [old.prism().shear(), new.prism().shear()];
    let (along, across) = (new.length / old.length, new.width / old.width);
    let mut edits = vec![girder(i, new.clone())];
    if (before, 1.0, 1.0) != (after, along, across) {
        let moved = |[x, y, z]: [f64; 3]| {
            let place = DVec3::new((x - y * before) * along + y * across * after, y * across, z);
            if place.is_finite() { tidy(place) } else { [x, y, z] }
        };
        for (id, known) in scene.devices() {
            let ends = known.ends();
            let (own, other) = (ends.girder == old.name, ends.to == Some(old.name.as_str()) && ends.to_at.is_some());
            let Some(mut part) = scene.device(id).filter(|_| own || other) else { continue };
            let ends = part.part_mut().ends_mut();
            if own {
                *ends.at = moved(*ends.at);
            }
            if other {
                *ends.to_at = ends.to_at.map(moved);
            }
            edits.push(device(id, part));
        }
    }
    if edits.len() == 1 { girder(i, new) } else { Edit::Batch(edits) }
}

/// Gives several girders other outlines, one after the other: a device may stand on two of them.
fn all_reshaped(scene: &Scene, new: impl IntoIterator<Item = (usize, Girder)>) -> Edit {
    let mut after = scene.clone();
    let mut edits = Vec::new();
    for (i, new) in new {
        let edit = reshaped(&after, i, new);
        if edit.clone().apply(&mut after).is_ok() {
            edits.push(edit);
        }
    }
    if edits.len() == 1 { edits.remove(0) } else { Edit::Batch(edits) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::device::Joint;
    use crate::scene::presets;

    #[test]
    fn devices_follow_the_outline_of_their_girders() {
        let scene = presets::load("twin-span-restrained").expect("ships");
        let shares = |scene: &Scene| -> Vec<[f64; 2]> {
            let share = |name: &str, [x, y, _]: [f64; 3]| {
                let girder = scene.girders.iter().find(|girder| girder.name == name)?;
                Some([(x - y * girder.prism().shear()) / girder.length, y / girder.width])
            };
            let of = |ends: crate::scene::device::Ends<'_>| {
                let other = ends.to.zip(ends.to_at).and_then(|(name, at)| share(name, at));
                share(ends.girder, ends.at).into_iter().chain(other)
            };
            scene.devices().iter().flat_map(|(_, device)| of(device.ends()).collect::<Vec<_>>()).collect()
        };
        let before = shares(&scene);
        let longer = Girder { length: 35.0, width: 12.0, ..scene.girders[0].clone() };
        for edit in [skew(&scene, &[], 75.0), skew(&scene, &[1], 120.0), reshaped(&scene, 0, longer)] {
            let mut after = scene.clone();
            edit.apply(&mut after).expect("fits");
            let apart =
                shares(&after).into_iter().zip(&before).map(|(a, b)| (a[0] - b[0]).abs().max((a[1] - b[1]).abs()));
            let most = apart.fold(0.0, f64::max);
            assert!(most < 1e-6, "{most}");
            assert!(
                after.devices().iter().all(|(_, device)| Joint::of(&after, &device.ends()).is_some()),
                "all joined"
            );
        }
    }
}
