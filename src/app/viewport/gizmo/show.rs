//! Shows the handles of what is selected, and turns what is done to them into commands.

use egui::{CursorIcon, EventFilter, Key, Pos2, Rect, Role, Sense, Ui, Vec2, WidgetInfo};
use glam::{DQuat, DVec3};

use super::handles::{self, Handle, Stance};
use super::held::{handle_id, on_way};
use super::paint;
use super::pull::{self, Pull};
use super::snap;
use crate::app::command::{Command, EditCommand, Grip};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::viewport::eye::Eye;
use crate::app::viewport::hand::Hand;
use crate::app::viewport::seen::Seen;
use crate::scene::{facing, placed};
use crate::view::list::Mark;
use crate::view::{DrawList, Moment, gap};

/// Side of the square in which a handle is taken \[points\].
const HOLD: f32 = 18.0;

/// A girder shorter than this on the screen has no handles but for moving it \[points\].
const ROOM: f32 = 70.0;

/// Least sides of a card in the picture under which handles are hidden \[points\]: of legend and friction circle, not of the gauge at a
/// contact.
const CARD: f32 = 40.0;

/// Words on a plate beside the mouse.
pub(in crate::app) fn say(ui: &Ui, eye: &Eye, at: Pos2, words: &[String]) {
    paint::plate(&ui.painter().with_clip_rect(eye.rect), eye.rect, at, words, &Palette::of(ui));
}

/// Where girders stand at the time shown; as placed, where no answer fits the scene.
fn stance<'a>(seen: &'a Seen<'_>) -> impl Fn(usize) -> Stance + 'a {
    let history = seen.answer().map(|a| &a.history).filter(|_| !seen.is_stale());
    move |i| {
        if let Some(history) = history.filter(|h| i < h.model().girders().len()) {
            let motion = history.motion(i, seen.t());
            return Stance { place: motion.place, attitude: motion.attitude };
        }
        let girder = seen.scene.girders.get(i);
        Stance {
            place: girder.map_or(DVec3::ZERO, |g| DVec3::from(g.position)),
            attitude: girder.map_or(DQuat::IDENTITY, |g| DQuat::from_mat3(&placed::axes(g))),
        }
    }
}

/// Shows the handles and does what is done to them.
pub(in crate::app) fn show(
    ui: &mut Ui,
    eye: &Eye,
    (hand, list): (&mut Hand, Option<&DrawList>),
    seen: &Seen<'_>,
    out: &mut Vec<Command>,
) {
    paint::outlines(ui, eye, seen);
    hand.focused = None;
    let cards: Vec<Rect> = list.map_or(Vec::new(), |list| cards(eye, list));
    for handle in &shown(eye, seen) {
        let id = handle_id(handle.grip);
        let is_in_use =
            hand.held.as_ref().is_some_and(|held| held.grip == handle.grip) || ui.memory(|m| m.has_focus(id));
        let is_covered = paint::place(eye, handle).is_some_and(|at| cards.iter().any(|card| card.contains(at)));
        if is_in_use || !is_covered {
            one(ui, eye, handle, (&mut *hand, seen), out);
        }
    }
    hand.forget_lost(ui);
    if let Some(words) = &hand.words {
        let at = hand.held.as_ref().filter(|h| h.by_keys).and_then(|h| eye.at(h.from));
        if let Some(at) = at.or_else(|| ui.input(|i| i.pointer.latest_pos())) {
            say(ui, eye, at, words);
        }
    } else if let Some(pulled) = &hand.pulled {
        paint::pulled(ui, eye, pulled);
    }
}

/// Legend and friction circles of a picture, where they are shown \[points\].
fn cards(eye: &Eye, list: &DrawList) -> Vec<Rect> {
    let all = list.marks.iter().filter_map(|mark| match mark {
        Mark::Panel { min, max, .. } => {
            let [min, max] =
                [min, max].map(|corner| eye.rect.min + Vec2::new(corner.x, corner.y) / list.pixels_per_point);
            Some(Rect::from_min_max(min, max))
        }
        _ => None,
    });
    all.filter(|card| card.width() >= CARD && card.height() >= CARD).collect()
}

/// The handles that are shown; none while the scene plays.
fn shown(eye: &Eye, seen: &Seen<'_>) -> Vec<Handle> {
    if seen.playback.clock.playing {
        return Vec::new();
    }
    let mut handles = handles::handles(seen.scene, seen.selection, seen.display.overlays.gap, stance(seen));
    let crowded = is_crowded(&handles, eye);
    handles.retain(|handle| !crowded || is_mover(handle.grip));
    handles
}

/// Where handles are shown \[points\].
pub(in crate::app) fn places(eye: &Eye, seen: &Seen<'_>) -> Vec<Pos2> {
    shown(eye, seen).iter().filter_map(|handle| paint::place(eye, handle)).collect()
}

fn is_mover(grip: Grip) -> bool {
    matches!(grip, Grip::Along(_) | Grip::Across(_) | Grip::Offset(_))
}

/// Whether the girder is too small on the screen for all its handles.
fn is_crowded(handles: &[Handle], eye: &Eye) -> bool {
    let ends = handles.iter().filter(|h| matches!(h.grip, Grip::Length(..))).filter_map(|h| eye.at(h.at));
    let ends: Vec<Pos2> = ends.collect();
    matches!(ends[..], [a, b] if a.distance(b) < ROOM)
}

fn one(ui: &mut Ui, eye: &Eye, handle: &Handle, (hand, seen): (&mut Hand, &Seen<'_>), out: &mut Vec<Command>) {
    let Some(at) = paint::place(eye, handle).filter(|p| eye.rect.shrink(4.0).contains(*p)) else { return };
    let id = handle_id(handle.grip);
    let response = ui.interact(Rect::from_center_size(at, Vec2::splat(HOLD)), id, Sense::drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Splitter, true, &handle.name));
    let held = hand.held.as_ref().is_some_and(|h| h.grip == handle.grip);
    let look = (response.hovered() || response.has_focus(), held);
    paint::handle(ui, eye, handle, at, look);
    if response.drag_started()
        && let Some(from) = ui.input(|i| i.pointer.press_origin()).and_then(|p| on_way(handle.grip, eye, p, handle.at))
    {
        hand.hold(handle.grip, from, seen.scene, seen.selection);
    }
    if held && response.dragged() {
        ui.set_cursor_icon(CursorIcon::Grabbing);
        out.extend(hand.drag(ui, eye));
        if let (Grip::Gap(pair), Some(pulled)) = (handle.grip, &mut hand.pulled) {
            pulled.words.extend(gap_now(seen, pair));
        }
    } else if response.hovered() {
        ui.set_cursor_icon(CursorIcon::Grab);
    }
    if response.drag_stopped() {
        hand.let_go();
    }
    if response.has_focus() {
        let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|m| m.set_focus_lock_filter(id, arrows));
        hand.focused = Some((handle.grip, handle.at));
        out.extend(keys(ui, seen, handle));
    }
    if held {
        let words = hand.pulled.as_ref().map(|pulled| pulled.words.join("\n")).unwrap_or_default();
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(words));
    }
    // What is read while something is dragged is its number.
    if hand.held.is_none() && !response.dragged() {
        response.on_hover_text(&handle.name);
    }
}

/// The gap of a pair at the time shown, beside the one that is set.
fn gap_now(seen: &Seen<'_>, pair: usize) -> Option<String> {
    let history = &seen.answer()?.history;
    let sides = facing::find(history.scene()).ok()?.into_iter().nth(pair)?;
    let moment = Moment::at(history, seen.t());
    let number = moment.facings.iter().position(|f| (f.first, f.second) == (sides.first, sides.second))?;
    let gap = gap::gaps(history.scene(), &moment).get(number).copied().flatten()?;
    Some(text::gap_now(&text::length(gap.gap), seen.t()))
}

/// The arrow keys pull a handle that has the focus: a small step, with Shift ten.
fn keys(ui: &Ui, seen: &Seen<'_>, handle: &Handle) -> Option<Command> {
    let steps: f64 = ui.input(|i| {
        let pressed =
            |more: Key, less: Key| f64::from(u8::from(i.key_pressed(more))) - f64::from(u8::from(i.key_pressed(less)));
        let steps = pressed(Key::ArrowRight, Key::ArrowLeft) + pressed(Key::ArrowUp, Key::ArrowDown);
        if i.modifiers.shift { 10.0 * steps } else { steps }
    });
    if steps == 0.0 {
        return None;
    }
    let scene = seen.scene;
    let largest = scene.girders.iter().map(|g| g.length).fold(1e-3, f64::max);
    let step = snap::round_step(largest / 100.0);
    let (from, to) = (handle.at, handle.at + handle.along * (step * steps));
    let pull = Pull { scene, selected: seen.selection, from, to, step: step / 10.0, reach: 0.0, typed: None };
    let edit = pull::pulled(handle.grip, &pull)?.edit;
    Some(Command::Edit(EditCommand::Change { edit, gesture: None }))
}
