//! Handles in the 3D view, and their places.
//!
//! A handle belongs to the scene as it is edited and stands where its girder is at the time shown.

use glam::{DQuat, DVec2, DVec3};

use crate::app::command::{Flank, Grip};
use crate::app::text;
use crate::geometry::End;
use crate::scene::device::{Joint, point_on};
use crate::scene::facing::{self, Facing, Side};
use crate::scene::{Abutment, DeviceId, Girder, Scene, placed};
use crate::view::Target;

/// Most gaps with a handle of their own: beyond that they would hide the row.
const MOST_GAPS: usize = 24;

/// Something to take hold of.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Handle {
    /// Quantity that it changes.
    pub(super) grip: Grip,
    /// Where it is \[m\].
    pub(super) at: DVec3,
    /// Which way it goes, as far as it goes one way \[unit\].
    pub(super) along: DVec3,
    pub(super) name: String,
}

/// A girder's place and attitude now.
#[derive(Clone, Copy, Debug)]
pub(in crate::app) struct Stance {
    /// Where G is \[m\].
    pub(in crate::app) place: DVec3,
    /// Body to world.
    pub(in crate::app) attitude: DQuat,
}

/// The handles of what is selected, and the gaps.
pub(super) fn handles(scene: &Scene, selected: &[Target], gaps: bool, stance: impl Fn(usize) -> Stance) -> Vec<Handle> {
    let mut all = Vec::new();
    match *selected {
        [Target::Girder(i)] => {
            if let Some(girder) = scene.girders.get(i) {
                of_girder(i, girder, stance(i), &mut all);
            }
        }
        [Target::Abutment(i)] => {
            if let Some(abutment) = scene.abutments.get(i) {
                of_abutment(scene, i, abutment, &mut all);
            }
        }
        [Target::Device(id)] => of_device(scene, id, &stance, &mut all),
        [Target::Pier(i)] if i < scene.piers.len() => of_pier(scene, i, &mut all),
        _ => {}
    }
    let pairs = if gaps { facing::find(scene).unwrap_or_default() } else { Vec::new() };
    if pairs.len() <= MOST_GAPS {
        all.extend(pairs.iter().enumerate().filter_map(|(n, pair)| of_gap(scene, n, pair, &stance)));
    }
    // What lies in space nowhere cannot be drawn: a scene may hold any number while it is edited.
    all.retain(|h| h.at.is_finite() && h.along.is_finite());
    all
}

fn of_girder(i: usize, girder: &Girder, stance: Stance, out: &mut Vec<Handle>) {
    let prism = girder.prism();
    let (a, b, shear) = (prism.length / 2.0, prism.width / 2.0, prism.shear());
    let top = prism.thickness / 2.0;
    let name = &girder.name;
    let mut add = |grip, at: DVec2, along: DVec2, what: String| {
        let (at, along) = (stance.place + stance.attitude * at.extend(top), stance.attitude * along.extend(0.0));
        out.push(Handle { grip, at, along, name: what });
    };
    let (x, y) = (DVec2::X, DVec2::Y);
    add(Grip::Along(i), DVec2::ZERO, x, text::move_by_handle(name, text::ALONG.as_str()));
    add(Grip::Across(i), DVec2::ZERO, y, text::move_by_handle(name, text::ACROSS.as_str()));
    // Pulled toward -x, the knob on the left turns the girder against the clock.
    add(Grip::Turn(i), DVec2::new(b * shear, b), -x, text::turn_by_handle(name));
    for end in End::BOTH {
        let s = end.sign();
        add(Grip::Length(i, end), x * (s * a), x * s, text::length_handle(name, end));
        for flank in Flank::BOTH {
            let at = DVec2::new(s * a + flank.sign() * b * shear, flank.sign() * b);
            add(Grip::Skew(i, end, flank), at, x, text::skew_handle(name, end, flank == Flank::Left));
        }
    }
    let s = -1.0;
    add(Grip::Width(i, Flank::Right), DVec2::new(s * b * shear, s * b), y * s, text::width_handle(name));
}

fn of_abutment(scene: &Scene, i: usize, abutment: &Abutment, out: &mut Vec<Handle>) {
    let Some([a, b, c, d]) = placed::abutment_face(scene, abutment) else { return };
    let name = &abutment.name;
    let (top, side) = ((c + d) / 2.0, (b - a).normalize_or_zero());
    out.push(Handle {
        grip: Grip::Offset(i),
        at: top,
        along: side,
        name: text::move_by_handle(name, text::SIDEWAYS.as_str()),
    });
    if abutment.polygon.is_none() {
        for (flank, at) in Flank::BOTH.into_iter().zip([c, d]) {
            let name = text::face_width_handle(name, flank == Flank::Left);
            out.push(Handle { grip: Grip::FaceWidth(i, flank), at, along: side * flank.sign(), name });
        }
    }
}

/// The foot of a pier as placed, and the side of its columns where these say how stiff it is.
fn of_pier(scene: &Scene, i: usize, out: &mut Vec<Handle>) {
    let (pier, here) = (&scene.piers[i], scene.pier(i));
    let foot = here.top - DVec3::Z * here.height;
    out.push(Handle {
        grip: Grip::PierHeight(i),
        at: foot,
        along: DVec3::NEG_Z,
        name: text::pier_height_handle(&pier.name),
    });
    if let Some(column) = pier.column {
        let [along, _] = column.xy();
        let at = here.top - DVec3::Z * (0.5 * here.height) + here.axes.x_axis * (0.5 * along);
        let name = text::pier_column_handle(&pier.name);
        out.push(Handle { grip: Grip::PierColumn(i), at, along: here.axes.x_axis, name });
    }
}

/// Both points of a device, where their girders are.
fn of_device(scene: &Scene, id: DeviceId, stance: &impl Fn(usize) -> Stance, out: &mut Vec<Handle>) {
    let Some(device) = scene.device(id) else { return };
    let ends = device.part().ends();
    let Some(joint) = Joint::of(scene, &ends) else { return };
    for (which, girder) in [Some(joint.girder), joint.other].into_iter().enumerate() {
        let local = girder.and_then(|girder| {
            let name = &scene.girders.get(girder)?.name;
            Some((stance(girder), point_on(scene, Some(name), joint.points[which])?))
        });
        let at = local.map_or(joint.points[which], |(here, local)| here.place + here.attitude * DVec3::from(local));
        let name = text::device_point(ends.name, which);
        out.push(Handle { grip: Grip::DevicePoint(id, which), at, along: DVec3::X, name });
    }
}

fn of_gap(scene: &Scene, n: usize, pair: &Facing, stance: &impl Fn(usize) -> Stance) -> Option<Handle> {
    let Side::Girder(i, end) = pair.first else { return None };
    let girder = scene.girders.get(i)?;
    if let Side::Abutment(k) = pair.second {
        scene.abutments.get(k)?.gap?;
    }
    let here = stance(i);
    let along = here.attitude * DVec3::X * end.sign();
    let middle = DVec3::new(end.sign() * girder.length / 2.0, 0.0, girder.thickness / 2.0);
    let at = here.place + here.attitude * middle + along * pair.gap;
    Some(Handle { grip: Grip::Gap(n), at, along, name: text::gap_handle(&pair.name) })
}
