//! Keys of the whole window.
//!
//! Keys act when no text is being typed; a slider that has the focus keeps its arrows.

use egui::{Event, Key, Modifiers};

use crate::app::bench::Workbench;
use crate::app::command::{Command, Nudge, Way};
use crate::app::panel::row_dialog::RowDraft;
use crate::app::viewport::mouse;
use crate::app::viewport::tool::Tool;
use crate::scene::ViewPreset;

/// Commands for the keys pressed in this frame.
pub(in crate::app) fn keys(ui: &egui::Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let asked = bench.asks_before_closing() || bench.asks_about_files();
    if asked || bench.film_plan().is_some() || bench.row_draft().is_some() {
        return;
    }
    if !bench.help_is_open() && mouse::keys(ui, bench, out) {
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
        if bench.takes_number(key) && !modifiers.command && !modifiers.alt {
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
        return with_control(key, modifiers.shift, bench);
    }
    if modifiers.alt {
        return nudge(key, modifiers.shift, bench);
    }
    match key {
        Key::G if modifiers.shift => Some(Command::Tool(Tool::Girder)),
        Key::B if modifiers.shift => Some(Command::Tool(Tool::Abutment)),
        Key::OpenBracket => Some(turn(1.0, modifiers)),
        Key::CloseBracket => Some(turn(-1.0, modifiers)),
        Key::Escape if bench.tool() != Tool::Select => Some(Command::Tool(Tool::Select)),
        Key::Space => Some(Command::TogglePlay),
        Key::ArrowRight => Some(Command::Step(steps(modifiers))),
        Key::ArrowLeft => Some(Command::Step(-steps(modifiers))),
        Key::Home => Some(Command::Seek(0.0)),
        Key::End => Some(Command::Seek(f64::INFINITY)),
        Key::Comma => Some(Command::StepSpeed(-1)),
        Key::Period => Some(Command::StepSpeed(1)),
        Key::L => Some(Command::Loop(!bench.clock().looping)),
        Key::M => Some(Command::SlowAtHits(!bench.clock().slow_at_hits)),
        Key::P => Some(Command::Pin),
        Key::I => Some(Command::SpanFrom),
        Key::O => Some(Command::SpanTo),
        Key::X => Some(Command::PlaySpan(None)),
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

fn turn(sign: f64, modifiers: Modifiers) -> Command {
    let turn_deg = if modifiers.shift { 15.0 } else { 1.0 } * sign;
    Command::Nudge(Nudge { way: [0.0; 2], turn_deg })
}

/// A step of about a thousandth of the largest girder, a round number.
fn nudge(key: Key, far: bool, bench: &Workbench) -> Option<Command> {
    let largest = bench.scene().girders.iter().map(|g| g.length).fold(1e-3, f64::max);
    let step = 10f64.powf((largest / 100.0).log10().floor()) * if far { 10.0 } else { 1.0 };
    let way = match key {
        Key::ArrowRight => [step, 0.0],
        Key::ArrowLeft => [-step, 0.0],
        Key::ArrowUp => [0.0, step],
        Key::ArrowDown => [0.0, -step],
        _ => return None,
    };
    Some(Command::Nudge(Nudge { way, turn_deg: 0.0 }))
}

fn with_control(key: Key, shift: bool, bench: &Workbench) -> Option<Command> {
    match (key, shift) {
        (Key::Z, false) => Some(Command::Undo),
        (Key::Z, true) | (Key::Y, _) => Some(Command::Redo),
        (Key::D, _) => Some(Command::Duplicate),
        (Key::A, false) => Some(Command::SelectAll),
        (Key::R, false) => Some(Command::AskRow(Some(RowDraft::of(bench)))),
        (Key::ArrowRight, _) => Some(Command::StepEvent(Way::Forward)),
        (Key::ArrowLeft, _) => Some(Command::StepEvent(Way::Back)),
        _ => None,
    }
}

fn steps(modifiers: Modifiers) -> f64 {
    if modifiers.shift { 10.0 } else { 1.0 }
}
