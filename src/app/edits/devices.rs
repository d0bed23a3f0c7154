//! Devices to begin with: between a girder and what it faces, with values that fit its weight and its length. None of them
//! is given: the window says that they are assumed.

use glam::DVec3;

use super::bridge::BEARING_FREQUENCY;
use super::change::tidy;
use crate::geometry::End;
use crate::scene::device::{Device, DeviceKind, point_on};
use crate::scene::edit::{Edit, free_name};
use crate::scene::facing::{self, Side};
use crate::scene::{
    Bearings, Bumper, Damper, DeviceId, Girder, PerDirection, Restrainer, Scene, Sides, Stopper, placed,
};

/// A device's points from the girder's axis, in parts of its width, kind by kind: they do not lie upon each other.
const ASIDE: [f64; 4] = [0.35, 0.25, 0.15, 0.35];
/// From the end of the girder to the point that a cable or damper holds it at, in parts of its length.
const FROM_END: f64 = 1.0 / 60.0;
/// Slack of a cable, gap of a stopper, in parts of the girder's length.
const SLACK: f64 = 1.0 / 1500.0;
/// Deformation at which a cable or a stopper yields, in parts of the girder's length.
const YIELD: f64 = 1.0 / 600.0;
/// Part of the girder's weight at which a cable yields, and a stopper.
const STRENGTH: [f64; 2] = [0.25, 0.5];
/// Damping of the girder on its bearings that a damper adds, of critical.
const DAMPING: f64 = 0.1;
/// Stiffness of a cable in yield, in parts of that before.
const HARDENING: f64 = 0.05;

/// Gives a device other numbers.
pub(in crate::app) fn device(id: DeviceId, device: Device) -> Edit {
    Edit::ReplaceDevice(id, Box::new(device))
}

/// A copy of a device on the other side of its girder.
pub(super) fn copy(scene: &Scene, id: DeviceId) -> Option<Device> {
    let mut copy = scene.device(id)?;
    let ends = copy.part_mut().ends_mut();
    *ends.name = free_name(scene, ends.name);
    ends.at[1] = -ends.at[1];
    if let Some(to) = ends.to_at {
        to[1] = -to[1];
    }
    Some(copy)
}

/// What a girder's end faces.
struct Before {
    end: End,
    /// Name of the body before it; the ground without.
    to: Option<String>,
    gap: f64,
}

/// A new device of a kind at a girder, at its first end that faces something; none without a girder.
pub(super) fn new_device(scene: &Scene, kind: DeviceKind, girder: usize) -> Option<Device> {
    let body = scene.girders.get(girder)?;
    let before = before(scene, girder);
    let own = DeviceKind::ALL.iter().zip(ASIDE).find(|(known, _)| **known == kind).map_or(0.0, |(_, part)| part);
    let aside = if scene.count_of(kind).is_multiple_of(2) { own } else { -own } * body.width;
    let axes = placed::axes(body);
    let (half, shear, sign) = (body.length / 2.0, body.prism().shear(), before.end.sign());
    // Along the girder from its skewed end.
    let along =
        |way: f64| DVec3::from(body.position) + axes * DVec3::new(sign * (half + way) + aside * shear, aside, 0.0);
    let name = free_name(scene, kind.label());
    let own = |world: DVec3| point_on(scene, Some(&body.name), world).map(|at| tidy(at.into()));
    let other = |world: DVec3| point_on(scene, before.to.as_deref(), world).map(|at| tidy(at.into()));
    let (length, weight) = (body.length, body.mass * gravity(scene));
    let inside = along(-FROM_END * length);
    let beyond = along(before.gap + 2.0 * FROM_END * length);
    let shared = (name, body.name.clone(), before.to.clone());
    Some(match kind {
        DeviceKind::Restrainer => cable(shared, own(inside)?, other(beyond)?, (length, weight)),
        DeviceKind::Bumper => bumper(shared, own(along(0.0))?, other(along(before.gap))?, (length, weight, before.gap)),
        DeviceKind::Damper => damper(shared, own(inside)?, other(beyond)?, body),
        DeviceKind::Stopper => {
            let here = along(-2.0 * FROM_END * length);
            stopper((shared.0, shared.1), own(here)?, (length, weight))
        }
    })
}

fn gravity(scene: &Scene) -> f64 {
    if scene.gravity > 0.0 { scene.gravity } else { crate::scene::STANDARD_GRAVITY }
}

/// The first of its ends that faces an abutment, else another girder; else its far end before nothing.
fn before(scene: &Scene, girder: usize) -> Before {
    let pairs = facing::find(scene).unwrap_or_default();
    let of = |pair: &facing::Facing| {
        let (end, other) = match (pair.first, pair.second) {
            (Side::Girder(own, end), other) if own == girder => (end, other),
            (other, Side::Girder(own, end)) if own == girder => (end, other),
            _ => return None,
        };
        let to = match other {
            Side::Girder(other, _) => scene.girders.get(other)?.name.clone(),
            Side::Abutment(wall) => scene.abutments.get(wall)?.name.clone(),
            Side::Flank(..) | Side::Rear(..) => return None,
        };
        Some((matches!(other, Side::Abutment(_)), Before { end, to: Some(to), gap: pair.gap.max(0.0) }))
    };
    let all: Vec<_> = pairs.iter().filter_map(of).collect();
    let best = all.into_iter().max_by_key(|(is_wall, _)| *is_wall).map(|(_, before)| before);
    best.unwrap_or(Before { end: End::Plus, to: None, gap: 0.0 })
}

/// To two digits: it is assumed.
fn two(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

type Shared = (String, String, Option<String>);

fn cable((name, girder, to): Shared, at: [f64; 3], to_at: [f64; 3], (length, weight): (f64, f64)) -> Device {
    let (force, stiffness) = (two(STRENGTH[0] * weight), two(STRENGTH[0] * weight / (YIELD * length)));
    Device::Restrainer(Restrainer {
        name,
        girder,
        to,
        at,
        to_at: Some(to_at),
        slack: two(SLACK * length),
        stiffness: Some(stiffness),
        axial_stiffness: None,
        cable_length: None,
        yield_force: Some(force),
        post_yield_stiffness: Some(two(HARDENING * stiffness)),
        break_elongation: None,
    })
}

/// It begins half-way through the gap, and stops a push of half the weight in the other half.
fn bumper((name, girder, to): Shared, at: [f64; 3], to_at: [f64; 3], (length, weight, gap): (f64, f64, f64)) -> Device {
    let room = if gap > 0.0 { gap } else { YIELD * length };
    let normal = to.is_none().then_some([-1.0, 0.0, 0.0]);
    Device::Bumper(Bumper {
        name,
        girder,
        to,
        at,
        to_at: Some(to_at),
        normal,
        gap: Some(two(0.5 * room)),
        stiffness: Some(two(weight / room)),
        table: None,
        damping: 0.0,
    })
}

/// c = 2 ζ ω m.
fn damper((name, girder, to): Shared, at: [f64; 3], to_at: [f64; 3], body: &Girder) -> Device {
    let frequency = match &body.bearings {
        Some(Bearings::Shared(shared)) => match shared.frequency_hz {
            PerDirection::Both(f) => f,
            PerDirection::Each(each) => each[0],
        },
        _ => BEARING_FREQUENCY,
    };
    let coefficient = two(2.0 * DAMPING * std::f64::consts::TAU * frequency * body.mass);
    Device::Damper(Damper {
        name,
        girder,
        to,
        at,
        to_at: Some(to_at),
        coefficient,
        exponent: 1.0,
        regularisation: 1e-4,
        brace_stiffness: None,
    })
}

/// A key in the ground at either side, across the girder.
fn stopper((name, girder): (String, String), at: [f64; 3], (length, weight): (f64, f64)) -> Device {
    let force = two(STRENGTH[1] * weight);
    Device::Stopper(Stopper {
        name,
        girder,
        to: None,
        at,
        to_at: None,
        direction: None,
        sides: Sides::Both,
        gap: two(SLACK * length),
        minus_gap: None,
        stiffness: two(force / (YIELD * length)),
        break_force: None,
        yield_force: Some(force),
        break_displacement: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::sim::History;

    #[test]
    fn every_new_device_of_every_preset_is_sound_and_runs() {
        for preset in presets::all() {
            let mut scene = presets::load(preset.name).expect("ships");
            // Devices stand at rigid girders.
            scene.girders.iter_mut().for_each(|girder| girder.elastic = None);
            for kind in DeviceKind::ALL {
                for _ in 0..2 {
                    let new = new_device(&scene, *kind, 0).expect("there is a girder");
                    Edit::AddDevice(scene.count_of(*kind), Box::new(new)).apply(&mut scene).expect("fits");
                }
            }
            scene.duration = 0.05;
            let run = History::of(&scene);
            assert!(run.is_ok(), "{}: {}", preset.name, run.err().map(|errors| errors.to_string()).unwrap_or_default());
        }
    }

    #[test]
    fn values_fit_the_size_of_the_girder() {
        let scene = presets::load("deck-30m").expect("ships");
        let Some(Device::Restrainer(cable)) = new_device(&scene, DeviceKind::Restrainer, 0) else { panic!("a cable") };
        let weight = scene.girders[0].mass * scene.gravity;
        let part = cable.yield_force.expect("yields") / weight;
        assert!((part - 0.25).abs() < 0.02, "a quarter of the weight: {part}");
        assert_eq!(cable.slack, 0.02, "2 cm of 30 m");
    }
}
