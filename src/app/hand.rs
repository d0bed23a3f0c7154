//! The mouse in the 3D view: orbit, pan, zoom, select, and drag what is selected over the ground.

use egui::{CursorIcon, PointerButton, Pos2, Rect, Response, Ui};
use glam::{DVec2, DVec3};

use super::command::Command;
use super::{Workbench, edits, viewport};
use crate::scene::edit::Edit;
use crate::scene::{Scene, placed};
use crate::view::{Camera, Target};

/// What the mouse holds.
#[derive(Clone, Debug, Default)]
pub(super) struct Hand {
    held: Option<Held>,
    count: u64,
}

/// A body that is being dragged.
#[derive(Clone, Debug)]
struct Held {
    target: Target,
    /// Where the mouse took it, on its plane \[m\].
    from: DVec3,
    /// The scene then: the way is counted from there, so that nothing drifts.
    scene: Box<Scene>,
    gesture: u64,
}

/// What the mouse asks for.
pub(super) fn interact(ui: &Ui, response: &Response, bench: &mut Workbench, out: &mut Vec<Command>) {
    let Some(camera) = bench.viewport.camera().copied() else { return };
    let rect = response.rect;
    if response.clicked()
        && let Some(at) = response.interact_pointer_pos()
    {
        out.push(Command::Select(viewport::pick(bench, rect, at, ui.pixels_per_point())));
    }
    if response.drag_started_by(PointerButton::Primary) {
        take(ui, rect, bench, &camera);
    }
    if response.drag_stopped() {
        bench.viewport.hand.held = None;
    }
    if response.dragged() {
        if let Some(held) = bench.viewport.hand.held.clone() {
            ui.set_cursor_icon(CursorIcon::Grabbing);
            out.extend(drag(response, rect, &camera, &held));
        } else {
            out.extend(turn(ui, response, camera));
        }
    }
    out.extend(zoom(ui, response, camera));
}

/// Takes hold of what is selected, when the mouse went down on it.
fn take(ui: &Ui, rect: Rect, bench: &mut Workbench, camera: &Camera) {
    let shift = ui.input(|i| i.modifiers.shift);
    let Some(at) = ui.input(|i| i.pointer.press_origin()).filter(|_| !shift) else { return };
    let Some(target) = bench.selected().filter(|t| !matches!(t, Target::Contact(_))) else { return };
    if bench.is_stale() || viewport::pick(bench, rect, at, ui.pixels_per_point()) != Some(target) {
        return;
    }
    let height = height(bench.scene(), target);
    let Some(from) = on_plane(camera, rect, at, height) else { return };
    let scene = Box::new(bench.scene().clone());
    let hand = &mut bench.viewport.hand;
    hand.count += 1;
    hand.held = Some(Held { target, from, scene, gesture: hand.count | 1 << 63 });
}

/// Height of the middle of a body \[m\].
fn height(scene: &Scene, target: Target) -> f64 {
    let girder = match target {
        Target::Girder(i) => scene.girders.get(i),
        Target::Abutment(i) => scene.abutments.get(i).and_then(|a| scene.girders.iter().find(|g| g.name == a.faces)),
        Target::Contact(_) => None,
    };
    girder.map_or(0.0, |g| g.position[2])
}

/// Where the line of sight meets the level plane; seen edge-on, the upright plane through the camera's target.
fn on_plane(camera: &Camera, rect: Rect, at: Pos2, height: f64) -> Option<DVec3> {
    let aspect = f64::from(rect.width() / rect.height().max(1.0));
    let (start, along) = camera.ray(viewport::ndc(rect, at), aspect);
    let (through, normal) = if along.z.abs() > 0.05 {
        (DVec3::new(camera.target.x, camera.target.y, height), DVec3::Z)
    } else {
        (camera.target, camera.basis().back)
    };
    let s = (through - start).dot(normal) / along.dot(normal);
    (s.is_finite() && s > 0.0).then(|| start + along * s)
}

fn drag(response: &Response, rect: Rect, camera: &Camera, held: &Held) -> Option<Command> {
    let at = response.interact_pointer_pos()?;
    let to = on_plane(camera, rect, at, height(&held.scene, held.target))?;
    let step = round_step(camera.metres_per_pixel(to, f64::from(rect.height())));
    let way = (to - held.from).truncate();
    let edit = match held.target {
        Target::Girder(i) => {
            let girder = held.scene.girders.get(i)?;
            let [x, y, z] = girder.position;
            Edit::MoveGirder(i, [rounded(x + way.x, step), rounded(y + way.y, step), z], girder.heading_deg)
        }
        Target::Abutment(i) => move_abutment(&held.scene, i, way, step)?,
        Target::Contact(_) => return None,
    };
    Some(Command::Edit { edit, gesture: Some(held.gesture) })
}

/// An abutment follows its gap and its offset, or its corners.
fn move_abutment(scene: &Scene, number: usize, way: DVec2, step: f64) -> Option<Edit> {
    let mut abutment = scene.abutments.get(number)?.clone();
    if let Some(corners) = &mut abutment.polygon {
        for corner in corners {
            corner[0] = rounded(corner[0] + way.x, step);
            corner[1] = rounded(corner[1] + way.y, step);
        }
        return Some(edits::abutment(number, abutment));
    }
    let girder = scene.girders.iter().find(|g| g.name == abutment.faces)?;
    let along = (placed::axes(girder).x_axis * abutment.end.sign()).truncate();
    let [a, b, ..] = placed::end_face(girder, abutment.end);
    let side = (a - b).truncate().normalize_or_zero();
    // way = along * u + side * v: the two are not square to each other on a skewed girder.
    let area = along.perp_dot(side);
    if area.abs() < 1e-9 {
        return None;
    }
    let (u, v) = (way.perp_dot(side) / area, along.perp_dot(way) / area);
    abutment.gap = Some(rounded(abutment.gap? + u, step).max(0.0));
    abutment.offset = Some(rounded(abutment.offset.unwrap_or(0.0) + v, step)).filter(|o| *o != 0.0);
    Some(edits::abutment(number, abutment))
}

/// The power of ten at or below a pixel, so that dragged numbers stay short.
fn round_step(per_pixel: f64) -> f64 {
    if per_pixel.is_finite() && per_pixel > 0.0 { 10f64.powf(per_pixel.log10().floor()) } else { 1e-6 }
}

fn rounded(value: f64, step: f64) -> f64 {
    // Dividing by a whole number keeps the decimal digits short, multiplying by 0.0001 does not.
    if step < 1.0 {
        let per_metre = (1.0 / step).round();
        (value * per_metre).round() / per_metre
    } else {
        (value / step).round() * step
    }
}

fn turn(ui: &Ui, response: &Response, mut camera: Camera) -> Option<Command> {
    let way = response.drag_delta();
    let height = response.rect.height().max(1.0);
    let shift = ui.input(|i| i.modifiers.shift);
    let (dx, dy) = (f64::from(way.x), f64::from(way.y));
    if dx == 0.0 && dy == 0.0 {
        return None;
    }
    if response.dragged_by(PointerButton::Primary) && !shift {
        camera.orbit(dx / f64::from(height), dy / f64::from(height));
    } else {
        camera.pan(dx, dy, f64::from(height));
    }
    Some(Command::Camera(camera))
}

fn zoom(ui: &Ui, response: &Response, mut camera: Camera) -> Option<Command> {
    response.hover_pos()?;
    let (scroll, pinch) = ui.input(|i| (i.smooth_scroll_delta.y, i.zoom_delta()));
    let factor = (-f64::from(scroll) * 0.003).exp() / f64::from(pinch);
    if factor == 1.0 {
        return None;
    }
    camera.zoom(factor);
    Some(Command::Camera(camera))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dragged_numbers_are_short() {
        assert_eq!(round_step(0.00037), 1e-4, "below a pixel");
        assert_eq!(rounded(0.123_456, 1e-4), 0.1235, "four digits");
        assert_eq!(rounded(1234.0, 100.0), 1200.0, "large scenes round too");
    }
}
