//! A device: the bodies and points that it is between, its law, its state at the time shown.

use egui::{ComboBox, Ui};

use super::rows::{grid, note, push};
use crate::app::command::Command;
use crate::app::field::{CLICK, Change, Form, Look, Named, Place, Without, act, number, rows, tag};
use crate::app::panel::name_field;
use crate::app::unit::{PURE, Size, Unit, force_unit, length_unit};
use crate::app::{edits, text};
use crate::scene::device::{Device, Joint};
use crate::scene::keys::{ENDS, Key};
use crate::scene::{DeviceId, Girder, Kind, Scene};
use crate::view::Target;

/// Keys that have rows of their own.
const APART: [&str; 3] = ["normal", "direction", "depth_force_m_n"];

/// Shows a device.
pub(super) fn show(ui: &mut Ui, form: Form<'_>, id: DeviceId, out: &mut Vec<Command>) {
    let scene = form.scene;
    let Some(mut new) = scene.device(id) else { return };
    let name = new.part().ends().name.to_owned();
    let table = format!("{}.{name}", id.kind.label());
    let girder = scene.girders.iter().find(|girder| girder.name == new.part().ends().girder);
    let size = girder.map_or(Size::of_scene(scene), Size::of);
    let place = form.place(&table);
    let before = new.clone();
    let first = |key: &Key| first_value(scene, &before, girder, key.name);
    let look = Look { without: Without::Off(&first), ..form.look_of(&table, size) };
    let change = grid(ui, "device", |ui| {
        name_field::show(ui, place, Target::Device(id), &name, out);
        let ends = ends(ui, place, scene, length_unit(size.length), &mut new);
        let law = law(ui, &look, scene.kind, size, &mut new);
        note(ui, text::DEVICE_ASSUMED.as_str());
        ends.or(law)
    });
    push(change, out, || edits::device(id, new));
}

/// A number that is switched on begins with this.
fn first_value(scene: &Scene, device: &Device, girder: Option<&Girder>, key: &str) -> f64 {
    let (length, mass) = girder.map_or((1.0, 1.0), |girder| (girder.length, girder.mass));
    let joint = Joint::of(scene, &device.part().ends());
    let (stiffness, force) = match device {
        Device::Restrainer(cable) => (joint.as_ref().and_then(|joint| cable.stiffness(joint)), cable.yield_force),
        Device::Stopper(key) => (Some(key.stiffness), key.yield_force.or(key.break_force)),
        Device::Bumper(rubber) => (rubber.stiffness, None),
        Device::Damper(_) => (None, None),
    };
    let weight = mass * crate::scene::STANDARD_GRAVITY;
    let stiffness = stiffness.unwrap_or(weight / (length / 600.0));
    match key {
        "stiffness_n_per_m" | "brace_stiffness_n_per_m" => stiffness,
        "axial_stiffness_n" => stiffness * joint.map_or(length, |joint| joint.length()),
        "yield_force_n" | "break_force_n" => force.unwrap_or(0.25 * weight),
        "post_yield_stiffness_n_per_m" => 0.05 * stiffness,
        "break_elongation_m" | "break_displacement_m" => length / 100.0,
        "length_m" => joint.map_or(length, |joint| joint.length()),
        "gap_m" => match device {
            Device::Bumper(rubber) => joint.and_then(|joint| rubber.gaps(&joint)).map_or(0.0, |[gap, _]| gap),
            _ => 0.0,
        },
        "minus_gap_m" => match device {
            Device::Stopper(key) => key.gap,
            _ => 0.0,
        },
        _ => 0.0,
    }
}

/// The bodies and the points on them.
fn ends(ui: &mut Ui, place: Place<'_>, scene: &Scene, unit: Unit, device: &mut Device) -> Option<Change> {
    let axes = if scene.kind == Kind::Planar { 2 } else { 3 };
    let own = device.part().ends();
    let (girder, to, second) = (own.girder.to_owned(), own.to.map(str::to_owned), own.to_at);
    let joint = Joint::of(scene, &own);
    let girders: Vec<Option<String>> = scene.girders.iter().map(|girder| Some(girder.name.clone())).collect();
    let walls = scene.abutments.iter().map(|wall| Some(wall.name.clone()));
    let others = girders.iter().filter(|name| name.as_deref() != Some(&girder)).cloned();
    let bodies: Vec<Option<String>> = std::iter::once(None).chain(others).chain(walls).collect();
    let as_it_was = device.clone();
    let anew = |to: Option<&str>| edits::points_before(scene, &as_it_was, to);
    let ends = device.part_mut().ends_mut();
    let mut from = Some(girder.clone());
    let mut change = body(ui, place, Named { key: "girder", label: text::DEVICE_ON.as_str() }, &mut from, &girders);
    if let (Some(_), Some(name)) = (change, from) {
        *ends.girder = name;
    }
    let mut onto = to.clone();
    for (axis, value) in ["x", "y", "z"].into_iter().zip(&mut *ends.at).take(axes) {
        change = change.or(number(
            ui,
            place,
            Named { key: "at_m", label: &format!("{} {axis}", text::DEVICE_AT) },
            value,
            unit,
        ));
    }
    let chosen = body(ui, place, Named { key: "to", label: text::DEVICE_TO.as_str() }, &mut onto, &bodies);
    if let Some((at, to_at)) = anew(onto.as_deref()).filter(|_| chosen.is_some()) {
        (*ends.to, *ends.at, *ends.to_at) = (onto, at, to_at);
        return chosen;
    }
    if chosen.is_some() {
        // The point stays where it is, seen from another body.
        let there = joint.and_then(|joint| crate::scene::device::point_on(scene, onto.as_deref(), joint.points[1]));
        (*ends.to, *ends.to_at) = (onto, there.map(|at| edits::tidy(at.into())));
        return chosen;
    }
    let placed = || {
        let there = joint.and_then(|joint| crate::scene::device::point_on(scene, to.as_deref(), joint.points[1]));
        there.map_or([0.0; 3], |at| edits::tidy(at.into()))
    };
    let mut second = second.unwrap_or_else(placed);
    let mut moved = None;
    for (axis, value) in ["x", "y", "z"].into_iter().zip(&mut second).take(axes) {
        moved = number(ui, place, Named { key: "to_m", label: &format!("{} {axis}", text::DEVICE_TO_AT) }, value, unit)
            .or(moved);
    }
    if moved.is_some() {
        *ends.to_at = Some(second);
    }
    change.or(moved)
}

/// A body by its name.
fn body(
    ui: &mut Ui,
    place: Place<'_>,
    Named { key, label }: Named<'_>,
    value: &mut Option<String>,
    options: &[Option<String>],
) -> Option<Change> {
    let words = |body: &Option<String>| body.clone().unwrap_or_else(|| text::GROUND_ITSELF.to_string());
    let before = value.clone();
    let name = ui.label(label);
    let combo = ComboBox::from_id_salt((place.table, key)).width(79.0).selected_text(words(value)).show_ui(ui, |ui| {
        for option in options {
            ui.selectable_value(value, option.clone(), words(option));
        }
    });
    tag(ui, &combo.response.labelled_by(name.id), place, Named { key, label });
    ui.end_row();
    if *value == before { None } else { CLICK }
}

/// The numbers of its law.
fn law(ui: &mut Ui, look: &Look<'_>, kind: Kind, size: Size, device: &mut Device) -> Option<Change> {
    let shared: Vec<&str> = ENDS.iter().map(|key| key.name).chain(APART).collect();
    match device {
        Device::Restrainer(cable) => rows(ui, look, cable, &shared),
        Device::Damper(damper) => rows(ui, look, damper, &shared),
        Device::Bumper(rubber) => {
            let normal = direction(
                ui,
                look.place,
                kind,
                Named { key: "normal", label: text::DEVICE_NORMAL.as_str() },
                &mut rubber.normal,
            );
            let law = rows(ui, look, rubber, &shared);
            if law.is_some() && rubber.stiffness.is_some() {
                rubber.table = None;
            }
            normal.or(law).or(table(ui, look.place, size, &mut rubber.table, &mut rubber.stiffness))
        }
        Device::Stopper(key) => {
            let way = direction(
                ui,
                look.place,
                kind,
                Named { key: "direction", label: text::DEVICE_DIRECTION.as_str() },
                &mut key.direction,
            );
            way.or(rows(ui, look, key, &shared))
        }
    }
}

/// A direction in the girder's frame, or that which it has by itself.
fn direction(
    ui: &mut Ui,
    place: Place<'_>,
    kind: Kind,
    Named { key, label }: Named<'_>,
    value: &mut Option<[f64; 3]>,
) -> Option<Change> {
    let mut given = value.is_some();
    ui.label("");
    let response = ui.checkbox(&mut given, label);
    let switched = tag(ui, &response, place, Named { key, label }).changed();
    ui.end_row();
    if switched {
        *value = given.then_some(if key == "normal" { [-1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] });
        return CLICK;
    }
    let axes = if kind == Kind::Planar { 2 } else { 3 };
    let mut change = None;
    for (axis, component) in ["x", "y", "z"].into_iter().zip(value.iter_mut().flatten()).take(axes) {
        change = number(ui, place, Named { key, label: &format!("{label} {axis}") }, component, PURE).or(change);
    }
    change
}

/// Depths and forces in place of one stiffness.
fn table(
    ui: &mut Ui,
    place: Place<'_>,
    size: Size,
    value: &mut Option<Vec<[f64; 2]>>,
    stiffness: &mut Option<f64>,
) -> Option<Change> {
    let Some(points) = value else {
        ui.label("");
        let pressed = act(ui, place, "depth_force_m_n", text::DEVICE_TABLE.as_str());
        ui.end_row();
        if !pressed {
            return None;
        }
        // Twice as stiff in the second half.
        let (k, depth) = (stiffness.take().unwrap_or(1e6), size.length / 1000.0);
        *value = Some(vec![[depth, k * depth], [2.0 * depth, 3.0 * k * depth]]);
        return CLICK;
    };
    let (mut change, mut gone) = (None, None);
    for (n, [depth, force]) in points.iter_mut().enumerate() {
        let [name, load, remove] = text::depth(n + 1);
        let unit = length_unit(size.length);
        change = number(ui, place, Named { key: "depth_force_m_n", label: &name }, depth, unit).or(change);
        change =
            number(ui, place, Named { key: "depth_force_m_n", label: &load }, force, force_unit(size.mass)).or(change);
        ui.label("");
        if ui.small_button(remove).clicked() {
            gone = Some(n);
        }
        ui.end_row();
    }
    if let Some(n) = gone.filter(|_| points.len() > 1) {
        points.remove(n);
        change = CLICK;
    }
    ui.label("");
    if act(ui, place, "depth_force_m_n", text::DEVICE_TABLE_POINT.as_str())
        && let Some([depth, force]) = points.last().copied()
    {
        points.push([2.0 * depth, 2.0 * force]);
        change = CLICK;
    }
    ui.end_row();
    change
}
