//! The mouse in the 3D view: orbit, pan, zoom, select, and drag what is selected over the ground.

use egui::{CursorIcon, Event, Key, PointerButton, Response, Ui};
use glam::DVec3;

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::viewport::gizmo::{self, Eye, Grip, Held, Pulled, Typing};
use crate::app::viewport::tool::Tool;
use crate::app::viewport::view;
use crate::scene::Scene;
use crate::view::{Camera, Target};

/// A key for the number of what is held.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum HandKey {
    /// Letters of it.
    Text(String),
    /// Take the last letter back.
    TakeBack,
    /// To the other number, where there are two.
    Next,
    /// It is good: let go.
    Set,
    /// Let go, and put everything back.
    Cancel,
}

/// What the mouse holds.
#[derive(Clone, Debug, Default)]
pub(in crate::app) struct Hand {
    pub(in crate::app) held: Option<Held>,
    /// What the pull has come to, to be read beside the mouse.
    pub(in crate::app) pulled: Option<Pulled>,
    /// What is typed instead.
    typing: Typing,
    /// What stands on the plate while something is typed.
    pub(in crate::app) words: Option<Vec<String>>,
    /// The handle that has the focus, and its place \[m\].
    pub(in crate::app) focused: Option<(Grip, DVec3)>,
    /// Whether the mouse is still down on something that was let go by a key.
    spent: bool,
    count: u64,
}

impl Hand {
    /// Opens: what was held stays where it is.
    pub(in crate::app) fn let_go(&mut self) {
        (self.held, self.pulled, self.words, self.typing) = (None, None, None, Typing::default());
    }

    /// Lets go of what the mouse has left without a word, and of what is held by keys once the hand is elsewhere: half a
    /// number may have moved the handle out of sight, so that its being gone says nothing.
    pub(in crate::app) fn forget_lost(&mut self, ui: &Ui) {
        let (down, pressed) = ui.input(|i| (i.pointer.any_down(), i.pointer.any_pressed()));
        let focus = ui.memory(egui::Memory::focused);
        let elsewhere = |grip| pressed || focus.is_some_and(|id| id != gizmo::handle_id(grip));
        let lost = self.held.as_ref().is_some_and(|held| if held.by_keys { elsewhere(held.grip) } else { !down });
        if lost {
            self.let_go();
        }
        self.spent &= down;
    }

    /// What of it can be seen.
    pub(in crate::app) fn seen(&self) -> (bool, Option<Vec<String>>) {
        (self.held.is_some(), self.words.clone())
    }
}

/// Keys while something is held are the hand's: a number, Enter, Escape. Answers whether they were.
pub(in crate::app) fn keys(ui: &Ui, bench: &Workbench, out: &mut Vec<Command>) -> bool {
    let hand = &bench.viewport.hand;
    let mut holds = hand.held.is_some();
    let events = ui.input(|i| i.events.clone());
    for event in events {
        match event {
            Event::Text(words) => {
                if let Some((grip, at)) = hand.focused.filter(|_| !holds && words.starts_with(gizmo::begins_number)) {
                    out.push(Command::Take(grip, at));
                    holds = true;
                }
                out.extend(holds.then_some(Command::Type(HandKey::Text(words))));
            }
            Event::Key { key, pressed: true, .. } if holds => {
                let key = match key {
                    Key::Enter => HandKey::Set,
                    Key::Escape => HandKey::Cancel,
                    Key::Backspace => HandKey::TakeBack,
                    Key::Tab => HandKey::Next,
                    _ => continue,
                };
                out.push(Command::Type(key));
            }
            _ => {}
        }
    }
    holds
}

impl Workbench {
    /// Closes the hand on something, at a place of its plane \[m\].
    pub(in crate::app) fn hold(&mut self, grip: Grip, from: DVec3) {
        let (scene, selected) = (Box::new(self.scene().clone()), self.selection().to_vec());
        let hand = &mut self.viewport.hand;
        hand.count += 1;
        hand.let_go();
        hand.held = Some(Held { grip, from, scene, selected, gesture: hand.count | 1 << 63, by_keys: false });
    }

    /// Whether a handle has the focus, to whose number this key belongs.
    pub(in crate::app) fn takes_number(&self, key: Key) -> bool {
        let letter = match key {
            Key::Plus | Key::Minus | Key::Comma | Key::Period => true,
            digit => digit.name().starts_with(|c: char| c.is_ascii_digit()),
        };
        letter && self.viewport.hand.focused.is_some()
    }

    /// Takes hold of a handle to type its number, without the mouse.
    pub(in crate::app) fn take_by_keys(&mut self, grip: Grip, at: DVec3) {
        self.hold(grip, at);
        if let Some(held) = &mut self.viewport.hand.held {
            held.by_keys = true;
        }
    }

    /// A key for the number of what is held.
    pub(in crate::app) fn type_in_hand(&mut self, key: &HandKey) {
        let hand = &mut self.viewport.hand;
        let Some(held) = &hand.held else { return };
        let two = held.grip == Grip::Bodies;
        match key {
            HandKey::Text(words) => hand.typing.add(words),
            HandKey::TakeBack => hand.typing.take_back(),
            HandKey::Next if two => hand.typing.next(),
            HandKey::Next => return,
            HandKey::Set | HandKey::Cancel => {
                let gesture = held.gesture;
                hand.spent = !held.by_keys;
                hand.let_go();
                if *key == HandKey::Cancel {
                    let done = self.document.abandon(gesture);
                    self.after(done);
                }
                return;
            }
        }
        self.say_typed();
    }

    /// Does what the typed number says, and says it.
    fn say_typed(&mut self) {
        let hand = &mut self.viewport.hand;
        let Some(held) = hand.held.as_ref() else { return };
        if hand.typing.is_empty() {
            hand.words = None;
            return;
        }
        let (said, gesture) = (gizmo::read_typed(held, &hand.typing), held.gesture);
        hand.words = Some(said.words);
        if let Some(pulled) = said.pulled {
            self.edit(pulled.edit, Some(gesture));
        }
    }

    /// What the hand that moves asks for; Ctrl keeps it from snapping.
    pub(in crate::app) fn drag_held(&mut self, ui: &Ui, eye: &Eye) -> Option<Command> {
        let (at, free) = ui.input(|i| (i.pointer.interact_pos(), i.modifiers.command));
        let held = self.viewport.hand.held.as_ref().filter(|_| self.viewport.hand.typing.is_empty())?;
        let pulled = gizmo::pull(held, eye, at?, free)?;
        let command = Command::Edit { edit: pulled.edit.clone(), gesture: Some(held.gesture) };
        self.viewport.hand.pulled = Some(pulled);
        Some(command)
    }
}

/// What the mouse asks for.
pub(in crate::app) fn interact(ui: &Ui, response: &Response, bench: &mut Workbench, out: &mut Vec<Command>) {
    let Some(camera) = bench.viewport.camera().copied() else { return };
    let eye = Eye { camera, rect: response.rect };
    if bench.tool() == Tool::Select
        && response.clicked()
        && let Some(at) = response.interact_pointer_pos()
    {
        let target = view::pick(bench, eye.rect, at, ui.pixels_per_point());
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
        } else if !bench.viewport.hand.spent {
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
    let target = view::pick(bench, eye.rect, at, ui.pixels_per_point());
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
