//! Keys of the whole window.
//!
//! Keys act when no text is being typed; a slider that has the focus keeps its arrows.

use egui::{Event, Key, Modifiers};

use super::Workbench;
use super::command::{Command, Way};
use crate::scene::ViewPreset;

/// Commands for the keys pressed in this frame.
pub(super) fn keys(ui: &egui::Ui, bench: &Workbench, out: &mut Vec<Command>) {
    if bench.asks_before_closing() || bench.asks_about_files() || bench.film_plan().is_some() {
        return;
    }
    let typing = ui.text_edit_focused();
    let focused = ui.memory(|m| m.focused().is_some());
    let events = ui.input(|i| i.events.clone());
    for event in events {
        let Event::Key { key, pressed: true, modifiers, .. } = event else { continue };
        if bench.help_is_open() {
            out.extend(matches!(key, Key::Escape | Key::F1).then_some(Command::Help(false)));
            continue;
        }
        let command = with_command(key, modifiers)
            .or_else(|| if typing || (focused && is_widget_key(key)) { None } else { plain(key, modifiers, bench) });
        out.extend(command);
    }
}

/// Keys that a focused button or slider wants for itself.
fn is_widget_key(key: Key) -> bool {
    matches!(
        key,
        Key::Space
            | Key::ArrowLeft
            | Key::ArrowRight
            | Key::ArrowUp
            | Key::ArrowDown
            | Key::Enter
            | Key::Home
            | Key::End
    )
}

/// Keys that work while typing too.
fn with_command(key: Key, modifiers: Modifiers) -> Option<Command> {
    if key == Key::F1 {
        return Some(Command::Help(true));
    }
    if !modifiers.command {
        return None;
    }
    match (key, modifiers.shift) {
        (Key::S, true) => Some(Command::SaveAs),
        (Key::S, false) => Some(Command::Save),
        (Key::N, _) => Some(Command::New),
        (Key::O, _) => Some(Command::OpenDialog),
        (Key::Q, _) => Some(Command::Close),
        _ => None,
    }
}

fn plain(key: Key, modifiers: Modifiers, bench: &Workbench) -> Option<Command> {
    if modifiers.command {
        return with_control(key, modifiers.shift);
    }
    match key {
        Key::Space => Some(Command::TogglePlay),
        Key::ArrowRight => Some(Command::Step(steps(modifiers))),
        Key::ArrowLeft => Some(Command::Step(-steps(modifiers))),
        Key::Home => Some(Command::Seek(0.0)),
        Key::End => Some(Command::Seek(f64::INFINITY)),
        Key::Comma => Some(Command::StepSpeed(-1)),
        Key::Period => Some(Command::StepSpeed(1)),
        Key::L => Some(Command::Loop(!bench.clock().looping)),
        Key::M => Some(Command::SlowAtHits(!bench.clock().slow_at_hits)),
        Key::F => Some(Command::Frame),
        Key::Num1 => Some(Command::View(ViewPreset::Iso)),
        Key::Num2 => Some(Command::View(ViewPreset::Top)),
        Key::Num3 => Some(Command::View(ViewPreset::Side)),
        Key::Num4 => Some(Command::View(ViewPreset::Contact)),
        Key::G => Some(Command::AddGirder),
        Key::B => Some(Command::AddAbutment),
        Key::Delete | Key::Backspace => Some(Command::Remove),
        Key::Escape => Some(Command::Select(None)),
        _ => None,
    }
}

fn with_control(key: Key, shift: bool) -> Option<Command> {
    match (key, shift) {
        (Key::Z, false) => Some(Command::Undo),
        (Key::Z, true) | (Key::Y, _) => Some(Command::Redo),
        (Key::D, _) => Some(Command::Duplicate),
        (Key::ArrowRight, _) => Some(Command::StepEvent(Way::Forward)),
        (Key::ArrowLeft, _) => Some(Command::StepEvent(Way::Back)),
        _ => None,
    }
}

fn steps(modifiers: Modifiers) -> f64 {
    if modifiers.shift { 10.0 } else { 1.0 }
}
