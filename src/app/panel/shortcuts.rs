//! Keys of the whole window.
//!
//! Keys act when no text is being typed; a slider that has the focus keeps its arrows. They are looked at when the panels
//! have been shown: a field that was pressed in the frame before takes text from then on. Keys that come in one frame
//! with a press of the mouse wait for the next, in which what was pressed has the focus.

use egui::{Event, Key, Modifiers};

use crate::app::bench::Folded;
use crate::app::command::{
    AngleCommand, Command, CompareCommand, EditCommand, FileCommand, LeaveCommand, MapCommand, Nudge, Pane,
    PlaceCommand, QuakeCommand, SelectCommand, TimeCommand, Tool, ViewCommand, Way, WindowCommand, Wish,
};
use crate::app::edits;
use crate::app::host::PAGE;
use crate::app::time::clock::Clock;
use crate::app::viewport::hand::Hand;
use crate::scene::{Scene, ViewPreset};

/// A window over the view that Escape closes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) enum Above {
    /// The polar plot of the shaking angle.
    Angles,
    /// The map of two numbers.
    Map,
    /// The ground motion.
    Quake,
}

impl Above {
    fn close(self) -> Command {
        match self {
            Self::Angles => Command::Angles(AngleCommand::Show(false)),
            Self::Map => Command::Map(MapCommand::Show(false)),
            Self::Quake => Command::Quake(QuakeCommand::Show(false)),
        }
    }
}

/// State that keys act on.
#[derive(Clone, Copy)]
pub(in crate::app) struct Keyboard<'a> {
    /// Whether a text had the focus when the frame began: it may have been left by one of its keys.
    pub(in crate::app) typing: bool,
    /// Whether a list or a menu was open when the frame began: Escape closes it, and nothing else.
    pub(in crate::app) listed: bool,
    /// Whether the help is open: keys close it then, and do nothing else.
    pub(in crate::app) help: bool,
    /// Object held in the view, whose typed number is its own.
    pub(in crate::app) hand: &'a Hand,
    /// Tool of a click in the view.
    pub(in crate::app) tool: Tool,
    /// The playing clock.
    pub(in crate::app) clock: &'a Clock,
    /// The scene, which says how far a step moves and which row is offered.
    pub(in crate::app) scene: &'a Scene,
    /// Which panels are folded.
    pub(in crate::app) folded: Folded,
    /// The window over the view that was opened, if one is.
    pub(in crate::app) above: Option<Above>,
}

/// Lets keys that came after a press of the mouse in this frame wait for the next.
pub(in crate::app) fn wait_for_focus(ui: &egui::Ui) {
    let id = egui::Id::unique("keys that wait");
    let waited: Vec<Event> = ui.data_mut(|data| data.remove_temp(id)).unwrap_or_default();
    let waits = ui.input_mut(|input| {
        let pressed = input.events.iter().position(|event| matches!(event, Event::PointerButton { .. }));
        let is_key =
            |event: &Event| matches!(event, Event::Key { .. } | Event::Text(_) | Event::Paste(_) | Event::Ime(_));
        let after = pressed.map_or_else(Vec::new, |at| input.events.split_off(at));
        let (waits, stays): (Vec<Event>, Vec<Event>) = after.into_iter().partition(is_key);
        input.events.extend(stays);
        input.events.splice(0..0, waited);
        waits
    });
    if !waits.is_empty() {
        ui.data_mut(|data| data.insert_temp(id, waits));
        ui.request_repaint();
    }
}

/// Commands for the keys pressed in this frame.
pub(in crate::app) fn keys(ui: &egui::Ui, on: Keyboard<'_>, out: &mut Vec<Command>) {
    if !on.help && on.hand.keys(ui, out) {
        return;
    }
    let typing = on.typing || ui.text_edit_focused();
    let focused = ui.memory(|m| m.focused().is_some());
    let events = ui.input(|i| i.events.clone());
    for event in events {
        let Event::Key { key, pressed: true, modifiers, .. } = event else { continue };
        if on.help {
            out.extend(matches!(key, Key::Escape | Key::F1).then_some(Command::Window(WindowCommand::Help(false))));
            continue;
        }
        if on.listed && key == Key::Escape {
            continue;
        }
        if on.hand.takes_number(key) && !modifiers.command && !modifiers.alt {
            continue;
        }
        let command = with_command(key, modifiers)
            .or_else(|| folding(key, on.folded))
            .or_else(|| if typing || (focused && is_widget_key(key)) { None } else { plain(key, modifiers, on) });
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
        return Some(Command::Window(WindowCommand::Help(true)));
    }
    if !modifiers.command {
        return None;
    }
    match (key, modifiers.shift) {
        (Key::S, true) => Some(Command::File(FileCommand::Ask(Wish::Save))),
        (Key::S, false) => Some(Command::File(FileCommand::Save)),
        (Key::N, _) => Some(Command::File(FileCommand::New)),
        (Key::O, _) => Some(Command::File(FileCommand::Ask(Wish::Open))),
        (Key::Q, _) if !PAGE => Some(Command::Leave(LeaveCommand::Close)),
        _ => None,
    }
}

fn plain(key: Key, modifiers: Modifiers, on: Keyboard<'_>) -> Option<Command> {
    if modifiers.command {
        return with_control(key, modifiers.shift, on.scene);
    }
    if modifiers.alt {
        return nudge(key, modifiers.shift, on.scene);
    }
    match key {
        Key::G if modifiers.shift => Some(Command::View(ViewCommand::Tool(Tool::Girder))),
        Key::B if modifiers.shift => Some(Command::View(ViewCommand::Tool(Tool::Abutment))),
        Key::OpenBracket => Some(turn(1.0, modifiers)),
        Key::CloseBracket => Some(turn(-1.0, modifiers)),
        Key::Escape if on.tool != Tool::Select => Some(Command::View(ViewCommand::Tool(Tool::Select))),
        Key::Space => Some(Command::Time(TimeCommand::TogglePlay)),
        Key::ArrowRight => Some(Command::Time(TimeCommand::Step(steps(modifiers)))),
        Key::ArrowLeft => Some(Command::Time(TimeCommand::Step(-steps(modifiers)))),
        Key::Home => Some(Command::Time(TimeCommand::Seek(0.0))),
        Key::End => Some(Command::Time(TimeCommand::Seek(f64::INFINITY))),
        Key::Comma => Some(Command::Time(TimeCommand::StepSpeed(-1))),
        Key::Period => Some(Command::Time(TimeCommand::StepSpeed(1))),
        Key::L => Some(Command::Time(TimeCommand::Loop(!on.clock.looping))),
        Key::W if modifiers.shift => Some(Command::Angles(AngleCommand::Show(true))),
        Key::M if modifiers.shift => Some(Command::Map(MapCommand::Show(true))),
        Key::M => Some(Command::Time(TimeCommand::SlowAtHits(!on.clock.slow_at_hits))),
        Key::P if modifiers.shift => Some(Command::Place(PlaceCommand::AddPier)),
        Key::P => Some(Command::Compare(CompareCommand::Pin)),
        Key::I => Some(Command::Time(TimeCommand::SpanFrom)),
        Key::O => Some(Command::Time(TimeCommand::SpanTo)),
        Key::X => Some(Command::Time(TimeCommand::PlaySpan(None))),
        Key::F => Some(Command::View(ViewCommand::Frame)),
        Key::V => Some(Command::View(ViewCommand::Back)),
        Key::Num1 => Some(Command::View(ViewCommand::Preset(ViewPreset::Iso))),
        Key::Num2 => Some(Command::View(ViewCommand::Preset(ViewPreset::Top))),
        Key::Num3 => Some(Command::View(ViewCommand::Preset(ViewPreset::Side))),
        Key::Num4 => Some(Command::View(ViewCommand::Preset(ViewPreset::Contact))),
        Key::G => Some(Command::Place(PlaceCommand::AddGirder)),
        Key::B => Some(Command::Place(PlaceCommand::AddAbutment)),
        Key::Delete | Key::Backspace => Some(Command::Place(PlaceCommand::Remove)),
        Key::Escape => Some(on.above.map_or(Command::Select(SelectCommand::Only(None)), Above::close)),
        _ => None,
    }
}

/// Keys that fold panels, while typing too.
fn folding(key: Key, folded: Folded) -> Option<Command> {
    let pane = match key {
        Key::F2 => Pane::Placed,
        Key::F3 => Pane::WhatIf,
        Key::F4 => Pane::Plots,
        Key::F5 => Pane::Lesson,
        Key::F6 => return Some(WindowCommand::FoldAll(!folded.is_all()).into()),
        _ => return None,
    };
    Some(WindowCommand::Fold(pane, !folded.has(pane)).into())
}

fn turn(sign: f64, modifiers: Modifiers) -> Command {
    let turn_deg = if modifiers.shift { 15.0 } else { 1.0 } * sign;
    Command::Place(PlaceCommand::Nudge(Nudge { way: [0.0; 2], turn_deg }))
}

/// A step of about a thousandth of the largest girder, a round number.
fn nudge(key: Key, far: bool, scene: &Scene) -> Option<Command> {
    let largest = scene.girders.iter().map(|g| g.length).fold(1e-3, f64::max);
    let step = 10f64.powf((largest / 100.0).log10().floor()) * if far { 10.0 } else { 1.0 };
    let way = match key {
        Key::ArrowRight => [step, 0.0],
        Key::ArrowLeft => [-step, 0.0],
        Key::ArrowUp => [0.0, step],
        Key::ArrowDown => [0.0, -step],
        _ => return None,
    };
    Some(Command::Place(PlaceCommand::Nudge(Nudge { way, turn_deg: 0.0 })))
}

fn with_control(key: Key, shift: bool, scene: &Scene) -> Option<Command> {
    match (key, shift) {
        (Key::Z, false) => Some(Command::Edit(EditCommand::Undo)),
        (Key::Z, true) | (Key::Y, _) => Some(Command::Edit(EditCommand::Redo)),
        (Key::D, _) => Some(Command::Place(PlaceCommand::Duplicate)),
        (Key::A, false) => Some(Command::Select(SelectCommand::All)),
        (Key::R, false) => Some(Command::Window(WindowCommand::AskRow(Some(edits::offered_row(scene))))),
        (Key::ArrowRight, _) => Some(Command::Time(TimeCommand::StepEvent(Way::Forward))),
        (Key::ArrowLeft, _) => Some(Command::Time(TimeCommand::StepEvent(Way::Back))),
        _ => None,
    }
}

fn steps(modifiers: Modifiers) -> f64 {
    if modifiers.shift { 10.0 } else { 1.0 }
}
