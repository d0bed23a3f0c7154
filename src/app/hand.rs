//! The mouse in the 3D view: orbit, pan, zoom, select, and drag what is selected over the ground.

use egui::{CursorIcon, PointerButton, Response, Ui};
use glam::DVec3;

use super::command::Command;
use super::gizmo::{self, Eye, Grip, Held, Pulled};
use super::tool::Tool;
use super::{Workbench, viewport};
use crate::scene::Scene;
use crate::view::{Camera, Target};

/// What the mouse holds.
#[derive(Clone, Debug, Default)]
pub(super) struct Hand {
    pub(super) held: Option<Held>,
    /// What the pull has come to, to be read beside the mouse.
    pub(super) pulled: Option<Pulled>,
    count: u64,
}

impl Hand {
    /// Opens: what was held stays where it is.
    pub(super) fn let_go(&mut self) {
        (self.held, self.pulled) = (None, None);
    }
}

impl Workbench {
    /// Closes the hand on something, at a place of its plane \[m\].
    pub(super) fn hold(&mut self, grip: Grip, from: DVec3) {
        let (scene, selected) = (Box::new(self.scene().clone()), self.selection().to_vec());
        let hand = &mut self.viewport.hand;
        hand.count += 1;
        hand.held = Some(Held { grip, from, scene, selected, gesture: hand.count | 1 << 63 });
    }

    /// What the hand that moves asks for; Ctrl keeps it from snapping.
    pub(super) fn drag_held(&mut self, ui: &Ui, eye: &Eye) -> Option<Command> {
        let (at, free) = ui.input(|i| (i.pointer.interact_pos(), i.modifiers.command));
        let held = self.viewport.hand.held.as_ref()?;
        let pulled = gizmo::pull(held, eye, at?, free)?;
        let command = Command::Edit { edit: pulled.edit.clone(), gesture: Some(held.gesture) };
        self.viewport.hand.pulled = Some(pulled);
        Some(command)
    }
}

/// What the mouse asks for.
pub(super) fn interact(ui: &Ui, response: &Response, bench: &mut Workbench, out: &mut Vec<Command>) {
    let Some(camera) = bench.viewport.camera().copied() else { return };
    let eye = Eye { camera, rect: response.rect };
    if bench.tool() == Tool::Select
        && response.clicked()
        && let Some(at) = response.interact_pointer_pos()
    {
        let target = viewport::pick(bench, eye.rect, at, ui.pixels_per_point());
        out.push(match target.filter(|_| ui.input(|i| i.modifiers.command || i.modifiers.shift)) {
            Some(target) => Command::SelectAlso(target),
            None => Command::Select(target),
        });
    }
    if response.drag_started_by(PointerButton::Primary) {
        take(ui, bench, &eye);
    }
    if response.drag_stopped() {
        bench.viewport.hand.let_go();
    }
    if response.dragged() {
        if bench.viewport.hand.held.is_some() {
            ui.set_cursor_icon(CursorIcon::Grabbing);
            out.extend(bench.drag_held(ui, &eye));
        } else {
            out.extend(turn(ui, response, camera));
        }
    }
    out.extend(zoom(ui, response, camera));
}

/// Takes hold of what is selected, when the mouse went down on it.
fn take(ui: &Ui, bench: &mut Workbench, eye: &Eye) {
    let shift = ui.input(|i| i.modifiers.shift);
    let Some(at) = ui.input(|i| i.pointer.press_origin()).filter(|_| !shift) else { return };
    if bench.is_stale() {
        return;
    }
    let target = viewport::pick(bench, eye.rect, at, ui.pixels_per_point());
    let Some(target) = target.filter(|t| !matches!(t, Target::Contact(_)) && bench.selection().contains(t)) else {
        return;
    };
    if let Some(from) = eye.on_level(at, height(bench.scene(), target)) {
        bench.hold(Grip::Bodies, from);
    }
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
