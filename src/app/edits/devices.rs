//! Devices to begin with: between a girder and what it faces, with values that fit its weight and its length. None of them
//! is given: the window says that they are assumed.

use std::cmp::Reverse;

use glam::DVec3;

use super::bridge::BEARING_FREQUENCY;
use super::change::tidy;
use crate::geometry::End;
use crate::scene::device::{Device, DeviceKind, point_on};
use crate::scene::edit::{Edit, free_name, free_name_after};
use crate::scene::facing::{self, Side};
use crate::scene::{
    Bearings, Bumper, Damper, DeviceId, Girder, PerDirection, Restrainer, Scene, Sides, Stopper, placed,
};
use crate::view::Target;

/// A device's points from the girder's axis, in parts of its width: those of several kinds do not lie upon each other, and stoppers
/// stand in the ground.
const fn aside(kind: DeviceKind) -> f64 {
    match kind {
        DeviceKind::Restrainer | DeviceKind::Stopper => 0.35,
        DeviceKind::Bumper => 0.25,
        DeviceKind::Damper => 0.15,
    }
}

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

/// Points of a device that is to act on another body: those of a new one where that body is before another end of the girder than
/// the device is at; none where the device can stay.
pub(in crate::app) fn points_before(
    scene: &Scene,
    device: &Device,
    to: Option<&str>,
) -> Option<([f64; 3], Option<[f64; 3]>)> {
    let ends = device.part().ends();
    let girder = scene.girders.iter().position(|girder| girder.name == ends.girder)?;
    let wall = scene.abutments.iter().position(|wall| Some(wall.name.as_str()) == to).map(Target::Abutment);
    let other = scene.girders.iter().position(|girder| Some(girder.name.as_str()) == to).map(Target::Girder);
    let new = new_device(scene, device.kind(), &[wall.or(other)?, Target::Girder(girder)])?;
    let there = new.part().ends();
    (there.to == to && there.at[0] * ends.at[0] < 0.0).then_some((there.at, there.to_at))
}

/// A copy of a device on the other side of its girder.
pub(super) fn copy(scene: &Scene, id: DeviceId) -> Option<Device> {
    let mut copy = scene.device(id)?;
    let ends = copy.part_mut().ends_mut();
    *ends.name = free_name_after(scene, ends.name);
    ends.at[1] = -ends.at[1];
    if let Some(to) = ends.to_at {
        to[1] = -to[1];
    }
    Some(copy)
}

/// Body before a girder's end.
struct Before {
    end: End,
    /// Name of the body before it; the ground without.
    to: Option<String>,
    gap: f64,
}

/// Girder and gap that the numbers of a new device are chosen by.
#[derive(Clone, Copy)]
struct Room {
    /// Length of the girder \[m\].
    length: f64,
    /// Weight of the girder \[N\].
    weight: f64,
    /// Gap before its end \[m\].
    gap: f64,
}

/// A new device of a kind at the girder that is selected, the one at the abutment or on the pier that is, or the first; none without
/// a girder. It goes to what is selected beside the girder, else to the end with the fewest of its kind.
pub(super) fn new_device(scene: &Scene, kind: DeviceKind, selected: &[Target]) -> Option<Device> {
    let wanted = wanted(scene, selected);
    let girder = selected.iter().rev().find_map(|t| if let Target::Girder(i) = t { Some(*i) } else { None });
    let girder = girder.or_else(|| scene.girders.iter().position(|girder| wanted.contains(&girder.name.as_str())));
    let girder = girder.unwrap_or_default();
    let body = scene.girders.get(girder)?;
    let before = before(scene, girder, kind, &wanted);
    let own = aside(kind);
    // Stoppers stand in the ground, whatever is before the end.
    let to = before.to.as_deref().filter(|_| kind != DeviceKind::Stopper);
    let beside = count_between(scene, kind, (&body.name, to));
    let aside = if beside.is_multiple_of(2) { own } else { -own } * body.width;
    let axes = placed::axes(body);
    let (half, shear, sign) = (body.length / 2.0, body.prism().shear(), before.end.sign());
    // Along the girder from its skewed end.
    let along =
        |way: f64| DVec3::from(body.position) + axes * DVec3::new(sign * (half + way) + aside * shear, aside, 0.0);
    let name = free_name(scene, kind.label());
    let own = |world: DVec3| point_on(scene, Some(&body.name), world).map(|at| tidy(at.into()));
    let other = |world: DVec3| point_on(scene, before.to.as_deref(), world).map(|at| tidy(at.into()));
    let room = Room { length: body.length, weight: body.mass * gravity(scene), gap: before.gap };
    let inside = along(-FROM_END * room.length);
    let beyond = along(room.gap + 2.0 * FROM_END * room.length);
    let shared = (name, body.name.clone(), before.to.clone());
    Some(match kind {
        DeviceKind::Restrainer => cable(shared, own(inside)?, other(beyond)?, room),
        DeviceKind::Bumper => bumper(shared, own(along(0.0))?, other(along(room.gap))?, room),
        DeviceKind::Damper => damper(shared, own(inside)?, other(beyond)?, body),
        DeviceKind::Stopper => {
            let here = along(-2.0 * FROM_END * room.length);
            stopper((shared.0, shared.1), own(here)?, room)
        }
    })
}

fn gravity(scene: &Scene) -> f64 {
    if scene.gravity > 0.0 { scene.gravity } else { crate::scene::STANDARD_GRAVITY }
}

/// Names of girders and abutments that are selected; of an abutment the girder that it faces, of a pier the girders on it.
fn wanted<'a>(scene: &'a Scene, selected: &[Target]) -> Vec<&'a str> {
    let girder = |i: usize| scene.girders.get(i).map(|girder| girder.name.as_str());
    let names = |target: &Target| match *target {
        Target::Girder(i) => girder(i).into_iter().collect(),
        Target::Abutment(i) => {
            scene.abutments.get(i).map_or(Vec::new(), |wall| vec![wall.name.as_str(), wall.faces.as_str()])
        }
        Target::Pier(pier) => {
            let on = |girder: &&Girder| End::BOTH.iter().any(|end| scene.pier_under(girder, *end) == Some(pier));
            scene.girders.iter().filter(on).map(|girder| girder.name.as_str()).collect()
        }
        Target::Device(_) | Target::Contact(_) => Vec::new(),
    };
    selected.iter().flat_map(names).collect()
}

/// How many devices of a kind act between two bodies.
fn count_between(scene: &Scene, kind: DeviceKind, (one, other): (&str, Option<&str>)) -> usize {
    let devices = scene.devices();
    let between = devices.iter().filter(|(id, device)| {
        let ends = device.ends();
        id.kind == kind
            && (((ends.girder, ends.to) == (one, other)) || (other, Some(one)) == (Some(ends.girder), ends.to))
    });
    between.count()
}

/// Body before the end of a girder that a new device goes to: the wanted one, else at the end with the fewest pairs of devices of this
/// kind; of equals the joint with another girder for a cable, which ties spans to each other, and an abutment for others; else no body, at
/// its far end.
fn before(scene: &Scene, girder: usize, kind: DeviceKind, wanted: &[&str]) -> Before {
    let own = scene.girders[girder].name.as_str();
    let pairs = facing::find(scene).unwrap_or_default();
    let ties = kind == DeviceKind::Restrainer;
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
        let pairs_there = count_between(scene, kind, (own, Some(&to))) / 2;
        let rank = (wanted.contains(&to.as_str()), Reverse(pairs_there), matches!(other, Side::Abutment(_)) != ties);
        Some((rank, Before { end, to: Some(to), gap: pair.gap.max(0.0) }))
    };
    // Of equals the first.
    let best = pairs.iter().filter_map(of).reduce(|a, b| if b.0 > a.0 { b } else { a }).map(|(_, before)| before);
    best.unwrap_or(Before { end: End::Plus, to: None, gap: 0.0 })
}

/// To two digits: it is assumed.
fn two(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

type Shared = (String, String, Option<String>);

fn cable((name, girder, to): Shared, at: [f64; 3], to_at: [f64; 3], room: Room) -> Device {
    let Room { length, weight, .. } = room;
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
fn bumper((name, girder, to): Shared, at: [f64; 3], to_at: [f64; 3], room: Room) -> Device {
    let Room { length, weight, gap } = room;
    let way = if gap > 0.0 { gap } else { YIELD * length };
    let normal = to.is_none().then_some([-1.0, 0.0, 0.0]);
    Device::Bumper(Bumper {
        name,
        girder,
        to,
        at,
        to_at: Some(to_at),
        normal,
        gap: Some(two(0.5 * way)),
        stiffness: Some(two(weight / way)),
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
fn stopper((name, girder): (String, String), at: [f64; 3], room: Room) -> Device {
    let Room { length, weight, .. } = room;
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
                    let new = new_device(&scene, *kind, &[]).expect("there is a girder");
                    Edit::AddDevice(scene.count_of(*kind), Box::new(new)).apply(&mut scene).expect("fits");
                }
            }
            scene.duration = 0.05;
            let run = History::of(&scene);
            assert!(run.is_ok(), "{}: {}", preset.name, run.err().map(|errors| errors.to_string()).unwrap_or_default());
        }
    }

    #[test]
    fn a_device_goes_to_what_is_selected_and_then_to_the_next_end() {
        let mut scene = presets::load("viaduct-5").expect("ships");
        let mut add = |selected: &[Target]| {
            let new = new_device(&scene, DeviceKind::Restrainer, selected).expect("there are girders");
            let ends = new.part().ends();
            let between = (ends.girder.to_owned(), ends.to.map(str::to_owned));
            let number = scene.count_of(DeviceKind::Restrainer);
            Edit::AddDevice(number, Box::new(new)).apply(&mut scene).expect("fits");
            (between.0, between.1.unwrap_or_default())
        };
        let named = |one: &str, other: &str| (one.to_owned(), other.to_owned());
        assert_eq!(add(&[Target::Girder(1), Target::Girder(2)]), named("g3", "g2"), "the joint of two girders");
        assert_eq!(add(&[Target::Pier(3)]), named("g4", "g5"), "the joint on a pier");
        assert_eq!(add(&[Target::Abutment(1)]), named("g5", "east"), "an abutment and its girder");
        for other in ["g2", "g2", "west", "west"] {
            assert_eq!(add(&[Target::Girder(0)]), named("g1", other), "two at the joint, then at the next end");
        }
    }

    #[test]
    fn values_fit_the_size_of_the_girder() {
        let scene = presets::load("deck-30m").expect("ships");
        let Some(Device::Restrainer(cable)) = new_device(&scene, DeviceKind::Restrainer, &[]) else {
            panic!("a cable")
        };
        let weight = scene.girders[0].mass * scene.gravity;
        let part = cable.yield_force.expect("yields") / weight;
        assert!((part - 0.25).abs() < 0.02, "a quarter of the weight: {part}");
        assert_eq!(cable.slack, 0.02, "2 cm of 30 m");
    }
}
