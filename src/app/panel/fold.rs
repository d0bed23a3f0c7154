//! Panels that fold: the button in an open one, and the strip that a folded one leaves.

use egui::epaint::TextShape;
use egui::{FontId, Frame, Panel, Response, RichText, Role, Sense, Ui, WidgetInfo, vec2};

use crate::app::command::{Command, Pane, WindowCommand};
use crate::app::style::icons::{self, Icon};
use crate::app::style::theme::Palette;
use crate::app::text;

/// Width of what a folded panel leaves \[points\].
const STRIP: f32 = 22.0;

/// The name of an open panel with the button that folds it; what else stands in the row is added at the right.
pub(in crate::app) fn head(
    ui: &mut Ui,
    pane: Pane,
    out: &mut Vec<Command>,
    beside: impl FnOnce(&mut Ui, &mut Vec<Command>),
) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(text::pane(pane)).strong());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            button(ui, pane, out);
            beside(ui, out);
        });
    });
}

/// The button that folds an open panel.
pub(in crate::app) fn button(ui: &mut Ui, pane: Pane, out: &mut Vec<Command>) {
    let (rect, response) = ui.allocate_exact_size(vec2(16.0, 18.0), Sense::click());
    let icon = if pane == Pane::Placed { Icon::Left } else { Icon::Right };
    icons::draw(ui.painter(), rect, icon, ink(ui, &response));
    act(response, pane, true, out);
}

/// The strip of a folded panel, its name upright.
pub(in crate::app) fn strip(ui: &mut Ui, pane: Pane, out: &mut Vec<Command>) {
    let id = ("folded", pane as usize);
    let panel =
        if pane == Pane::Placed { Panel::left(egui::Id::unique(id)) } else { Panel::right(egui::Id::unique(id)) };
    let frame = Frame::side_top_panel(ui.style()).inner_margin(egui::Margin::same(0));
    panel.resizable(false).exact_size(STRIP).frame(frame).show(ui, |ui| {
        let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click());
        let color = ink(ui, &response);
        let top = egui::Rect::from_min_size(rect.min, vec2(rect.width(), 24.0));
        icons::draw(ui.painter(), top, if pane == Pane::Placed { Icon::Right } else { Icon::Left }, color);
        let galley = ui.painter().layout_no_wrap(text::pane(pane).to_owned(), FontId::proportional(12.0), color);
        let at = egui::pos2(rect.center().x + galley.size().y / 2.0, rect.top() + 30.0);
        ui.painter().add(TextShape::new(at, galley, color).with_angle(std::f32::consts::FRAC_PI_2));
        act(response, pane, false, out);
    });
}

fn ink(ui: &Ui, response: &Response) -> egui::Color32 {
    let near = response.hovered() || response.has_focus();
    if near { ui.visuals().strong_text_color() } else { Palette::of(ui).weak }
}

fn act(response: Response, pane: Pane, fold: bool, out: &mut Vec<Command>) {
    let words = if fold { text::fold(pane) } else { text::unfold(pane) };
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &words));
    if response.on_hover_text(format!("{words} ({})", text::pane_key(pane))).clicked() {
        out.push(WindowCommand::Fold(pane, fold).into());
    }
}
