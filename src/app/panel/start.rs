//! Panel over an empty scene: a bridge by its numbers, presets, files used last, lessons.

use egui::{
    Align2, Area, Button, Frame, Grid, Id, Key, Label, Order, Rect, RichText, Role, ScrollArea, Sense, StrokeKind, Ui,
};
use egui::{Vec2, WidgetInfo, vec2};

use crate::app::command::{BridgeDraft, Command, FileCommand, LearnCommand, WindowCommand};
use crate::app::disk::recent;
use crate::app::disk::scene_files::SceneFiles;
use crate::app::edits;
use crate::app::field::{Named, Place, focus_next, number};
use crate::app::learn::lessons::lessons;
use crate::app::panel::plan_icon;
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::unit::{DEGREES, PURE, Unit, length_unit};
use crate::scene::presets;

/// Widest that it is \[points\].
const WIDTH: f32 = 640.0;
/// Size of the plan of a preset \[points\].
const PLAN: Vec2 = vec2(76.0, 34.0);

/// Shows it in the middle of the view.
pub(in crate::app) fn show(ui: &Ui, view: Rect, (files, draft): (&SceneFiles, BridgeDraft), out: &mut Vec<Command>) {
    let room = view.shrink(12.0);
    if room.width() < 200.0 || room.height() < 80.0 {
        return;
    }
    let area =
        Area::new(Id::unique("start")).order(Order::Middle).pivot(Align2::CENTER_CENTER).fixed_pos(room.center());
    area.constrain_to(room).show(ui.ctx(), |ui| {
        Frame::popup(ui.style()).show(ui, |ui| {
            ui.set_width(WIDTH.min(room.width() - 16.0));
            let scrolled = |name: &str| ScrollArea::vertical().id_salt(name).max_height(room.height() - 24.0);
            ui.columns(2, |columns| {
                // A bridge stays in sight however far the others are scrolled.
                scrolled("start bridge").show(&mut columns[0], |ui| bridge(ui, draft, out));
                scrolled("start others").show(&mut columns[1], |ui| others(ui, files, out));
            });
        });
    });
}

fn bridge(ui: &mut Ui, draft: BridgeDraft, out: &mut Vec<Command>) {
    ui.label(RichText::new(text::START_BRIDGE).heading());
    let (mut new, mut spans) = (draft, draft.spans as f64);
    if is_first_tab(ui) {
        focus_next(ui);
    }
    let place = Place::apart("");
    Grid::new("bridge").num_columns(2).show(ui, |ui| {
        let metres = length_unit(100.0);
        number(ui, place, Named { key: "", label: text::START_SPAN.as_str() }, &mut new.span, metres);
        number(ui, place, Named { key: "", label: text::START_WIDTH.as_str() }, &mut new.width, metres);
        number(ui, place, Named { key: "", label: text::START_SKEW.as_str() }, &mut new.skew_deg, DEGREES);
        number(
            ui,
            place,
            Named { key: "", label: text::START_SPANS.as_str() },
            &mut spans,
            Unit { speed: 0.05, ..PURE },
        );
    });
    let new = edits::sound(BridgeDraft { spans: whole(spans), ..new });
    if new != draft {
        out.push(WindowCommand::Bridge(new).into());
    }
    // Before what is said of the numbers: in a low window that is scrolled, the button is not.
    ui.add_space(4.0);
    if ui.button(text::START_BUILD).clicked() {
        out.push(FileCommand::Build(new).into());
    }
    ui.add_space(4.0);
    let a = edits::assumed(new);
    let assumed = text::assumed([a.thickness, a.gap, a.seat], a.mass, a.stiffness, a.frequency);
    // Columns justify; words are not stretched to their width.
    ui.vertical(|ui| {
        for words in [text::ranges(edits::RANGES, edits::MOST_BRIDGE_SPANS), assumed] {
            ui.add(Label::new(RichText::new(words).weak()).wrap());
            ui.add_space(4.0);
        }
    });
}

/// Whether Tab was pressed while nothing had the keyboard: it leads to the numbers of the bridge, which 58 buttons and fields of the panels
/// around them would precede.
fn is_first_tab(ui: &Ui) -> bool {
    let known = Id::unique("keyboard before the start page");
    let now = ui.memory(egui::Memory::focused);
    let before: Option<Id> = ui.data_mut(|data| {
        let before = data.get_temp::<Option<Id>>(known).flatten();
        data.insert_temp(known, now);
        before
    });
    before.is_none() && ui.input(|input| input.key_pressed(Key::Tab) && input.modifiers.is_none())
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a small whole number")]
fn whole(spans: f64) -> usize {
    spans.round().clamp(0.0, 1e3) as usize
}

fn others(ui: &mut Ui, files: &SceneFiles, out: &mut Vec<Command>) {
    if !files.session.recent().is_empty() {
        ui.label(RichText::new(text::OPEN_RECENT).strong());
        recent::show(ui, files.session.recent(), out);
        ui.add_space(4.0);
    }
    ui.label(RichText::new(text::PRESETS).strong());
    for (number, preset) in presets::all().iter().enumerate() {
        let card = ui.horizontal(|ui| {
            let (rect, _) = ui.allocate_exact_size(PLAN, Sense::hover());
            plan_icon::draw(ui.painter(), rect.shrink(3.0), number, &Palette::of(ui));
            ui.vertical(|ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                ui.add(Label::new(RichText::new(preset.name).strong()).selectable(false));
                ui.add(Label::new(RichText::new(&*preset.summary).weak().small()).selectable(false).wrap());
            });
        });
        let response = ui.interact(card.response.rect, ui.scope_id().with(preset.name), Sense::click());
        let words = || format!("{}: {}", preset.name, preset.summary);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, words()));
        if response.hovered() || response.has_focus() {
            let visuals = &ui.visuals().widgets.hovered;
            ui.painter().rect_stroke(response.rect.expand(1.0), 3.0, visuals.bg_stroke, StrokeKind::Outside);
        }
        if response.clicked() {
            out.push(FileCommand::OpenPreset(preset.name.to_owned()).into());
        }
    }
    ui.add_space(4.0);
    ui.label(RichText::new(text::LEARN).strong());
    for (number, lesson) in lessons().iter().enumerate() {
        if ui.add(Button::new(&lesson.title).frame(false).truncate()).clicked() {
            out.push(LearnCommand::Open(number).into());
        }
    }
}
