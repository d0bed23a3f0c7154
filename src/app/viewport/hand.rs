//! Object held by the mouse or the keys in the 3D view: a handle or the selected bodies.

use egui::{Event, Key, Ui};
use glam::DVec3;

use crate::app::command::{Command, EditCommand, Grip, HandCommand, HandKey};
use crate::app::viewport::eye::Eye;
use crate::app::viewport::gizmo::{self, Held, Manner, Pulled, Typing};
use crate::scene::Scene;
use crate::scene::edit::Edit;
use crate::view::Target;

/// Result of a key for the held object's number.
#[derive(Clone, Debug)]
pub(in crate::app) enum Keyed {
    /// The scene is changed, as a part of this gesture.
    Change(Edit, u64),
    /// The changes of this gesture are reverted.
    Abandon(u64),
}

/// Object held by the mouse.
#[derive(Clone, Debug, Default)]
pub struct Hand {
    pub(in crate::app) held: Option<Held>,
    /// Result of the pull so far, to be read beside the mouse.
    pub(in crate::app) pulled: Option<Pulled>,
    /// Text typed instead.
    typing: Typing,
    /// Text on the plate while something is typed.
    pub words: Option<Vec<String>>,
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

    /// State that determines the picture.
    pub(in crate::app) fn seen(&self) -> (bool, Option<Vec<String>>) {
        (self.held.is_some(), self.words.clone())
    }

    /// Whether a handle has the focus, to whose number this key belongs.
    pub(in crate::app) fn takes_number(&self, key: Key) -> bool {
        let letter = match key {
            Key::Plus | Key::Minus | Key::Comma | Key::Period => true,
            digit => digit.name().starts_with(|c: char| c.is_ascii_digit()),
        };
        letter && self.focused.is_some()
    }

    /// Keys while something is held are the hand's: a number, Enter, Escape. Answers whether they were.
    pub(in crate::app) fn keys(&self, ui: &Ui, out: &mut Vec<Command>) -> bool {
        let mut holds = self.held.is_some();
        let events = ui.input(|i| i.events.clone());
        for event in events {
            match event {
                Event::Text(words) => {
                    if let Some((grip, at)) = self.focused.filter(|_| !holds && words.starts_with(gizmo::begins_number))
                    {
                        out.push(HandCommand::Take(grip, at).into());
                        holds = true;
                    }
                    out.extend(holds.then_some(Command::Hand(HandCommand::Type(HandKey::Text(words)))));
                }
                Event::Key { key, pressed: true, .. } if holds => {
                    let key = match key {
                        Key::Enter => HandKey::Set,
                        Key::Escape => HandKey::Cancel,
                        Key::Backspace => HandKey::TakeBack,
                        Key::Tab => HandKey::Next,
                        _ => continue,
                    };
                    out.push(HandCommand::Type(key).into());
                }
                _ => {}
            }
        }
        holds
    }

    /// Does a command; answers with what is to be done to the scene.
    pub(in crate::app) fn apply(&mut self, command: &HandCommand, scene: &Scene, selected: &[Target]) -> Option<Keyed> {
        match command {
            HandCommand::Take(grip, at) => {
                self.hold_by_keys(*grip, *at, scene, selected);
                None
            }
            HandCommand::Type(key) => self.type_key(key),
        }
    }

    /// Closes on something, at a place of its plane \[m\].
    pub(in crate::app) fn hold(&mut self, grip: Grip, from: DVec3, scene: &Scene, selected: &[Target]) {
        self.count += 1;
        self.let_go();
        let (scene, selected) = (Box::new(scene.clone()), selected.to_vec());
        self.held = Some(Held { grip, from, scene, selected, gesture: self.count | 1 << 63, by_keys: false });
    }

    /// Takes hold of a handle to type its number, without the mouse.
    fn hold_by_keys(&mut self, grip: Grip, at: DVec3, scene: &Scene, selected: &[Target]) {
        self.hold(grip, at, scene, selected);
        if let Some(held) = &mut self.held {
            held.by_keys = true;
        }
    }

    /// A key for the number of what is held; `None` when nothing is changed by it.
    fn type_key(&mut self, key: &HandKey) -> Option<Keyed> {
        let held = self.held.as_ref()?;
        match key {
            HandKey::Text(words) => self.typing.add(words),
            HandKey::TakeBack => self.typing.take_back(),
            HandKey::Next if held.grip.moves_two_ways() => self.typing.next(),
            HandKey::Next => return None,
            HandKey::Set | HandKey::Cancel => {
                let gesture = held.gesture;
                self.spent = !held.by_keys;
                self.let_go();
                return (*key == HandKey::Cancel).then_some(Keyed::Abandon(gesture));
            }
        }
        self.read_typed()
    }

    /// Result of the typed number; it stands on the plate from now on.
    fn read_typed(&mut self) -> Option<Keyed> {
        let held = self.held.as_ref()?;
        if self.typing.is_empty() {
            self.words = None;
            return None;
        }
        let (said, gesture) = (gizmo::read_typed(held, &self.typing), held.gesture);
        self.words = Some(said.words);
        said.pulled.map(|pulled| Keyed::Change(pulled.edit, gesture))
    }

    /// Command of the moving mouse; Ctrl keeps it from snapping, Alt makes it fine.
    pub(in crate::app) fn drag(&mut self, ui: &Ui, eye: &Eye) -> Option<Command> {
        let (at, keys) = ui.input(|i| (i.pointer.interact_pos(), i.modifiers));
        let manner = Manner { free: keys.command, fine: keys.alt };
        let held = self.held.as_ref().filter(|_| self.typing.is_empty())?;
        let pulled = gizmo::pull(held, eye, at?, manner)?;
        let command = EditCommand::Change { edit: pulled.edit.clone(), gesture: Some(held.gesture) };
        self.pulled = Some(pulled);
        Some(command.into())
    }

    /// Whether the mouse is still down on something that was let go by a key.
    pub(in crate::app) fn is_spent(&self) -> bool {
        self.spent
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    fn holding() -> Hand {
        let scene = presets::load(presets::OPENING).expect("ships");
        let mut hand = Hand::default();
        hand.hold_by_keys(Grip::Width(0, crate::app::command::Flank::Left), DVec3::ZERO, &scene, &[]);
        hand
    }

    #[test]
    fn a_typed_number_changes_the_scene_in_one_gesture_and_cancel_names_it() {
        let mut hand = holding();
        let typed = hand.type_key(&HandKey::Text("12".into()));
        let Some(Keyed::Change(_, gesture)) = typed else { panic!("a width is typed: {typed:?}") };
        let cancelled = hand.type_key(&HandKey::Cancel);
        assert!(matches!(cancelled, Some(Keyed::Abandon(same)) if same == gesture), "the same: {cancelled:?}");
        assert!(hand.held.is_none() && !hand.is_spent(), "let go, and no mouse button is down");
    }

    #[test]
    fn a_hand_that_holds_nothing_takes_no_key() {
        assert!(Hand::default().type_key(&HandKey::Text("1".into())).is_none(), "nothing to change");
        assert!(holding().type_key(&HandKey::Next).is_none(), "a width is one number");
    }
}
