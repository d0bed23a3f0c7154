//! The mouse in the 3D view: orbit, pan, zoom, select, and drag what is selected over the ground.

use egui::{CursorIcon, PointerButton, Response, Ui};

use crate::app::command::{Command, Grip, SelectCommand, Tool, ViewCommand};
use crate::app::viewport::eye::Eye;
use crate::app::viewport::picture::Viewport;
use crate::app::viewport::seen::Seen;
use crate::scene::Scene;
use crate::view::{Camera, Target};

/// Commands of the mouse.
pub(in crate::app) fn interact(
    ui: &Ui,
    response: &Response,
    (viewport, seen): (&mut Viewport, &Seen<'_>),
    out: &mut Vec<Command>,
) {
    let Some(camera) = viewport.camera().copied() else { return };
    let eye = Eye { camera, rect: response.rect };
    if seen.display.tool == Tool::Select
        && response.clicked()
        && let Some(at) = response.interact_pointer_pos()
    {
        let target = viewport.pick(seen, eye.rect, at, ui.pixels_per_point());
        out.push(match target.filter(|_| ui.input(|i| i.modifiers.command || i.modifiers.shift)) {
            Some(target) => Command::Select(SelectCommand::Also(target)),
            None => Command::Select(SelectCommand::Only(target)),
        });
    }
    if response.drag_started_by(PointerButton::Primary) {
        take(ui, (&mut *viewport, seen), &eye);
    }
    if response.drag_stopped() {
        viewport.hand.let_go();
    }
    if response.dragged() {
        if viewport.hand.held.is_some() {
            ui.set_cursor_icon(CursorIcon::Grabbing);
            out.extend(viewport.hand.drag(ui, &eye));
        } else if !viewport.hand.is_spent() {
            out.extend(turn(ui, response, camera));
        }
    }
    out.extend(zoom(ui, response, camera));
}

/// Takes hold of what is selected, when the mouse went down on it.
fn take(ui: &Ui, (viewport, seen): (&mut Viewport, &Seen<'_>), eye: &Eye) {
    let shift = ui.input(|i| i.modifiers.shift);
    let Some(at) = ui.input(|i| i.pointer.press_origin()).filter(|_| !shift) else { return };
    if seen.is_stale() {
        return;
    }
    let target = viewport.pick(seen, eye.rect, at, ui.pixels_per_point());
    let goes = |t: &Target| matches!(t, Target::Girder(_) | Target::Abutment(_));
    let Some(target) = target.filter(|t| goes(t) && seen.selection.contains(t)) else {
        return;
    };
    if let Some(from) = eye.on_level(at, height(seen.scene, target)) {
        viewport.hand.hold(Grip::Bodies, from, seen.scene, seen.selection);
    }
}

/// Height of the middle of a body \[m\].
fn height(scene: &Scene, target: Target) -> f64 {
    let girder = match target {
        Target::Girder(i) => scene.girders.get(i),
        Target::Abutment(i) => scene.abutments.get(i).and_then(|a| scene.girders.iter().find(|g| g.name == a.faces)),
        Target::Pier(i) => return scene.piers.get(i).map_or(0.0, |_| scene.pier(i).top.z),
        Target::Device(_) | Target::Contact(_) => None,
    };
    girder.map_or(0.0, |g| g.position[2])
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
    Some(Command::View(ViewCommand::Camera(camera)))
}

fn zoom(ui: &Ui, response: &Response, mut camera: Camera) -> Option<Command> {
    response.hover_pos()?;
    let (scroll, pinch) = ui.input(|i| (i.smooth_scroll_delta.y, i.zoom_delta()));
    let factor = (-f64::from(scroll) * 0.003).exp() / f64::from(pinch);
    if factor == 1.0 {
        return None;
    }
    camera.zoom(factor);
    Some(Command::View(ViewCommand::Camera(camera)))
}
