//! Edits of the outlines of girders: devices keep their places on them.

use glam::DVec3;

use super::change::{girder, row_shifted, tidy};
use super::devices::device;
use crate::geometry::End;
use crate::scene::edit::Edit;
use crate::scene::facing::{self, Side};
use crate::scene::keys::Editable as _;
use crate::scene::{Bearings, Girder, Scene, is_assumed, placed};
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

/// Gives a girder another outline; devices keep their places on it as shares of its plan, and a mass that is assumed follows its area.
pub(in crate::app) fn reshaped(scene: &Scene, i: usize, new: Girder) -> Edit {
    let Some(old) = scene.girders.get(i) else { return girder(i, new) };
    let new = Girder { mass: mass_of(scene, old, &new), ..new };
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

/// The mass of a girder that gets another outline: an assumed one, to four digits, by the area of the plan.
fn mass_of(scene: &Scene, old: &Girder, new: &Girder) -> f64 {
    let area = new.length * new.width / (old.length * old.width);
    let follows = old.mass == new.mass && is_assumed(&scene.assumed, &format!("girder.{}.mass_kg", old.name));
    let mass = old.mass * area;
    if !follows || area == 1.0 || !(mass > 0.0 && mass.is_finite()) {
        return new.mass;
    }
    let step = 10f64.powf(mass.log10().floor() - 3.0);
    (mass / step).round() * step
}

/// A girder whose bearings keep their places as shares of its plan.
pub(in crate::app) fn stretched(girder: &Girder, along: f64, across: f64, skew_deg: f64) -> Girder {
    let before = girder.prism().shear();
    let after = Girder { skew_deg, ..girder.clone() }.prism().shear();
    let moved = |[x, y]: [f64; 2]| {
        let y_new = y * across;
        tidy(DVec3::new((x - y * before) * along + y_new * after, y_new, 0.0))
    };
    let lists = |at: &mut Option<Vec<[f64; 2]>>, skewed: &mut Option<Vec<[f64; 2]>>| {
        for place in at.iter_mut().flatten() {
            let [x, y, _] = moved(*place);
            *place = [x, y];
        }
        for place in skewed.iter_mut().flatten() {
            let [x, y, _] = tidy(DVec3::new(place[0] * along, place[1] * across, 0.0));
            *place = [x, y];
        }
    };
    let mut new = girder.clone();
    match &mut new.bearings {
        Some(Bearings::Shared(shared)) => lists(&mut shared.at, &mut shared.at_skewed),
        Some(Bearings::Deck(deck)) => lists(&mut deck.at, &mut deck.at_skewed),
        Some(Bearings::Each(each)) => {
            for bearing in each {
                let [x, y, _] = moved(bearing.at);
                bearing.at = [x, y];
            }
        }
        None => {}
    }
    new
}

/// Gives a girder another length or width that was typed. Bearings keep their places as shares of its plan unless they were given others;
/// an end that faces another girder stays where it is, and where both do the row beyond the `+x` end moves.
fn resized(scene: &Scene, i: usize, new: Girder) -> Edit {
    let Some(old) = scene.girders.get(i) else { return girder(i, new) };
    let (along, across) = (new.length / old.length, new.width / old.width);
    if (along, across) == (1.0, 1.0) || !(along > 0.0 && across > 0.0 && along.is_finite() && across.is_finite()) {
        return reshaped(scene, i, new);
    }
    let kept = new.bearings == old.bearings;
    let bearings = if kept { stretched(old, along, across, new.skew_deg).bearings } else { new.bearings.clone() };
    let mut new = Girder { bearings, ..new };
    let grown = placed::axes(&new).x_axis * (new.length - old.length);
    let beyond = if new.position == old.position {
        [End::Minus, End::Plus].map(|end| facing_girder(scene, i, end))
    } else {
        [None; 2]
    };
    let way = match beyond {
        [Some(_), _] => grown / 2.0,
        [None, Some(_)] => -grown / 2.0,
        [None, None] => DVec3::ZERO,
    };
    new.position = tidy(DVec3::from(new.position) + way);
    match beyond {
        [Some(_), Some(next)] if grown != DVec3::ZERO => {
            let row = row_shifted(scene, i, next, grown);
            let mut after = scene.clone();
            if row.clone().apply(&mut after).is_err() {
                return reshaped(scene, i, new);
            }
            Edit::Batch(vec![row, reshaped(&after, i, new)])
        }
        _ => reshaped(scene, i, new),
    }
}

/// The girder that an end faces.
fn facing_girder(scene: &Scene, girder: usize, end: End) -> Option<usize> {
    facing::find(scene).unwrap_or_default().into_iter().find_map(|pair| match (pair.first, pair.second) {
        (Side::Girder(one, own), Side::Girder(other, _)) if (one, own) == (girder, end) => Some(other),
        (Side::Girder(other, _), Side::Girder(one, own)) if (one, own) == (girder, end) => Some(other),
        _ => None,
    })
}

/// Gives several girders other outlines, one after the other: a device may stand on two of them.
fn all_reshaped(scene: &Scene, new: impl IntoIterator<Item = (usize, Girder)>) -> Edit {
    let mut after = scene.clone();
    let mut edits = Vec::new();
    for (i, new) in new {
        let edit = resized(&after, i, new);
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
    fn a_typed_length_keeps_joints_bearings_and_what_stands_beyond() {
        let scene = presets::load("viaduct-5").expect("ships");
        let ends = |scene: &Scene, i: usize| {
            let girder = &scene.girders[i];
            let (x, half) = (placed::axes(girder).x_axis, girder.length / 2.0);
            let middle = DVec3::from(girder.position).dot(x);
            [middle - half, middle + half]
        };
        let gaps = |scene: &Scene| -> Vec<f64> { (0..4).map(|i| ends(scene, i + 1)[0] - ends(scene, i)[1]).collect() };
        for i in 0..5 {
            let longer = Girder { length: 35.0, ..scene.girders[i].clone() };
            let mut after = scene.clone();
            girders_alike(&scene, i, &longer, &[]).apply(&mut after).expect("fits");
            assert_eq!(after.girders[i].length, 35.0);
            assert!(crate::scene::validate::validate(&after).is_ok(), "span {i}: nothing is in anything");
            let apart = gaps(&after).into_iter().zip(gaps(&scene)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 2e-6, "span {i}: gaps differ by {apart} m");
            let first =
                if i == 0 { ends(&after, 0)[1] - ends(&scene, 0)[1] } else { ends(&after, 0)[0] - ends(&scene, 0)[0] };
            assert!(first.abs() < 2e-6, "span {i}: the joint, or what is before it, stays");
            let shares = |scene: &Scene| -> Vec<f64> {
                let places = scene.girders[i].supports(scene.setting());
                let (shear, length) = (scene.girders[i].prism().shear(), scene.girders[i].length);
                places.iter().map(|b| (b.place.x - b.place.y * shear) / length).collect()
            };
            assert_ne!(shares(&scene), Vec::<f64>::new(), "it stands on bearings");
            for (now, before) in shares(&after).into_iter().zip(shares(&scene)) {
                assert!((now - before).abs() < 1e-3, "span {i}: a bearing at {now} of the length, {before} before");
            }
        }
    }

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
