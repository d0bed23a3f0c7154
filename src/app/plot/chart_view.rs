//! One chart against time as it is drawn: its axis with numbers and unit, curves, the time shown, the time pointed to.

use std::f32::consts::FRAC_PI_2;

use egui::epaint::TextShape;
use egui::{Align2, FontId, Id, Label, Rect, RichText, Sense, Stroke, Ui, UiBuilder, Vec2, pos2, vec2};
use egui_plot::{FilledArea, Plot, PlotBounds, PlotUi, VLine};

use crate::app::command::{Command, PlotCommand};
use crate::app::plot::charts::{Chart, Drawn};
use crate::app::plot::value_axis::{AxisUnit, Ticks, ValueAxis, WHEEL, fitting};
use crate::app::plot::{dashes, legend, resolution};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::time::time_axis::{TimeAxis, ticks};

/// Base of a chart: its number, its place with axis and legend, the axis of time, the time shown \[s\].
pub(super) struct Over<'a> {
    pub(super) number: usize,
    pub(super) place: Rect,
    pub(super) axis: &'a TimeAxis,
    pub(super) t: f64,
}

/// The field of a chart, without its axis and its legend.
pub(super) fn field(over: &Over<'_>) -> Rect {
    let [left, right] = over.axis.edges;
    Rect::from_min_max(pos2(left, over.place.top()), pos2(right, over.place.bottom()))
}

/// Draws a chart; `shown` are the values that the user has chosen of it.
pub(super) fn draw(
    ui: &mut Ui,
    chart: &Chart<'_>,
    over: &Over<'_>,
    (shown, palette): (Option<[f64; 2]>, &Palette),
    out: &mut Vec<Command>,
) {
    let field = field(over);
    let range = shown.unwrap_or_else(|| chart.range());
    let axis = ValueAxis { range, edges: [field.top(), field.bottom()], log: chart.log };
    let missing = || Label::new(RichText::new(&chart.missing).weak().small()).truncate();
    if chart.curves.is_empty() && !chart.missing.is_empty() {
        // Neither numbers nor an axis that could be moved.
        ui.painter().rect_filled(field, 2.0, palette.track);
        ui.put(field, missing());
        return;
    }
    interact(ui, chart, over, &axis, out);
    let most = axis.range.map(|end| if chart.log { 10f64.powf(end) } else { end.abs() });
    let AxisUnit { factor, name: unit } = fitting(chart.unit, most[0].max(most[1]));
    let marks = axis.ticks();
    numbers(ui, over, (&axis, &marks, factor, &unit), palette);
    curves(ui, chart, over, &axis, palette);
    pointed(ui, chart, over, &axis, palette);
    let beside = Rect::from_min_max(field.right_top(), over.place.max);
    legend::show(ui, chart, beside, (factor, &unit), palette);
    if !chart.missing.is_empty() {
        ui.put(Rect::from_min_size(field.min, vec2(field.width(), MISSING_HEIGHT)), missing());
    }
}

/// Height of a line of small words \[points\].
const MISSING_HEIGHT: f32 = 14.0;

/// The mouse on the axis: the wheel zooms, a drag moves, a double click shows everything; with Alt the wheel does so over the
/// field too.
fn interact(ui: &mut Ui, chart: &Chart<'_>, over: &Over<'_>, axis: &ValueAxis, out: &mut Vec<Command>) {
    let field = field(over);
    let beside = Rect::from_min_max(over.place.min, field.left_bottom());
    let response = ui.interact(beside, ui.scope_id().with(("values", over.number)), Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, text::values_of(&chart.name)));
    let mut show = |range| out.push(PlotCommand::Values(chart.name.clone(), range).into());
    if response.double_clicked() {
        show(None);
    } else if response.dragged() && response.drag_delta().y != 0.0 {
        show(Some(axis.panned(response.drag_delta().y)));
    }
    let (scroll, alt) = ui.input(|i| (i.smooth_scroll_delta.y, i.modifiers.alt));
    let at = ui.input(|i| i.pointer.hover_pos()).filter(|at| response.hovered() || (alt && field.contains(*at)));
    if let Some(at) = at.filter(|_| scroll != 0.0 && ui.rect_contains_pointer(over.place)) {
        show(Some(axis.zoomed(f64::from(-scroll * WHEEL).exp(), at.y)));
    }
    response.on_hover_text(text::VALUES_HINT);
}

/// The ground of a chart, numbers and lines of both axes, and the unit.
pub(super) fn numbers(
    ui: &Ui,
    over: &Over<'_>,
    (axis, marks, factor, unit): (&ValueAxis, &Ticks, f64, &str),
    palette: &Palette,
) {
    let (field, painter) = (field(over), ui.painter_at(over.place));
    ui.painter().rect_filled(field, 2.0, palette.track);
    let (small, line) = (FontId::proportional(axis.letters()), Stroke::new(0.7, palette.line));
    for t in ticks(over.axis.window, f64::from(field.width()) / 90.0) {
        painter.vline(over.axis.x(t), field.y_range(), line);
    }
    let mut free = field.left() - over.place.left();
    for &value in &marks.values {
        let y = axis.y(value);
        painter.hline(field.x_range(), y, line);
        let words = marks.words(value, factor);
        let taken = painter.text(pos2(field.left() - 4.0, y), Align2::RIGHT_CENTER, words, small.clone(), palette.weak);
        free = free.min(taken.left() - over.place.left());
    }
    // Upright where it would lie under the numbers.
    let unit = painter.layout_no_wrap(unit.to_owned(), small, palette.force);
    let middle = over.place.left_center();
    if unit.size().x + 2.0 < free {
        painter.galley(middle - vec2(0.0, 0.5 * unit.size().y), unit, palette.force);
    } else {
        let corner = middle + vec2(0.0, 0.5 * unit.size().x);
        painter.add(TextShape::new(corner, unit, palette.force).with_angle(-FRAC_PI_2));
    }
}

fn curves(ui: &mut Ui, chart: &Chart<'_>, over: &Over<'_>, axis: &ValueAxis, palette: &Palette) {
    let (field, window) = (field(over), over.axis.window);
    let mut inner = ui.new_child(UiBuilder::new().max_rect(field).id_salt(("plot", over.number)));
    let bounds = PlotBounds::from_min_max([window[0], axis.range[0]], [window[1], axis.range[1]]);
    let plot = Plot::new(Id::unique(("plot", over.number))).width(field.width()).height(field.height());
    let still = plot.allow_drag(false).allow_zoom(false).allow_scroll(false).allow_boxed_zoom(false);
    let still = still.allow_double_click_reset(false).allow_axis_zoom_drag(false).sense(Sense::hover());
    let bare = still.show_axes(false).show_grid(false).show_background(false).show_x(false).show_y(false);
    bare.set_margin_fraction(Vec2::ZERO).show(&mut inner, |plot: &mut PlotUi<'_>| {
        plot.set_plot_bounds(bounds);
        for (band, color) in &chart.bands {
            let area = FilledArea::new("", &band.times, &band.low, &band.high);
            plot.add(area.fill_color(*color).allow_hover(false));
        }
        for drawn in chart.curves.iter().filter(|drawn| chart.filled || !dashes::is_broken(drawn.style)) {
            let line = resolution::line("", drawn.curve.to_vec()).stroke(stroke(drawn)).allow_hover(false);
            plot.line(if chart.filled { line.fill(0.0).fill_alpha(1.0) } else { line });
        }
        plot.vline(VLine::new("", over.t).stroke(Stroke::new(1.2, palette.playhead)).allow_hover(false));
    });
    let painter = ui.painter_at(field);
    for drawn in chart.curves.iter().filter(|_| !chart.filled) {
        let places = drawn.curve.iter().map(|[t, value]| pos2(over.axis.x(*t), axis.y(*value)));
        dashes::draw(&painter, places, drawn.style, stroke(drawn));
    }
}

fn stroke(drawn: &Drawn<'_>) -> Stroke {
    Stroke::new(if drawn.chosen { 1.4 } else { 1.0 }, drawn.color)
}

/// The time pointed to, through every chart, with a dot on each curve that has a value there.
fn pointed(ui: &Ui, chart: &Chart<'_>, over: &Over<'_>, axis: &ValueAxis, palette: &Palette) {
    let Some(x) = over.axis.pointed(ui) else { return };
    let (field, painter) = (field(over), ui.painter_at(field(over)));
    painter.vline(x, field.y_range(), Stroke::new(1.0, palette.weak));
    if over.number == 0 {
        let words = text::short_instant(over.axis.t(x), over.axis.per_point());
        let left = x > field.right() - 70.0;
        let (align, aside) = if left { (Align2::RIGHT_TOP, -4.0) } else { (Align2::LEFT_TOP, 4.0) };
        let galley = painter.layout_no_wrap(words, FontId::proportional(11.0), palette.playhead);
        let plate = align.anchor_size(pos2(x + aside, field.top() + 2.0), galley.size());
        painter.rect_filled(plate.expand(2.0), 2.0, palette.track.gamma_multiply(0.9));
        painter.galley(plate.min, galley, palette.playhead);
    }
    for entry in chart.entries.iter().filter(|_| !chart.filled) {
        let Some(value) = entry.value.map(|v| if chart.log { v.abs().log10() } else { v }) else { continue };
        painter.circle_filled(pos2(x, axis.y(value)), 2.6, entry.color);
    }
}

#[cfg(test)]
mod tests {
    use std::borrow::Cow;

    use egui::RawInput;
    use egui::epaint::Primitive;
    use egui_plot::LineStyle;

    use super::*;
    use crate::app::style::theme;

    /// Triangles of a curve in a field of 400 × 100 points, 10 s by 10 N.
    fn triangles(curve: &[[f64; 2]]) -> Vec<Rect> {
        let place = Rect::from_min_size(pos2(0.0, 0.0), vec2(400.0, 100.0));
        let axis = TimeAxis::over(place, None, 10.0);
        let over = Over { number: 0, place, axis: &axis, t: 0.0 };
        let values = ValueAxis { range: [0.0, 10.0], edges: [place.top(), place.bottom()], log: false };
        let drawn = Drawn {
            curve: Cow::Owned(curve.to_vec()),
            color: egui::Color32::WHITE,
            style: LineStyle::Solid,
            chosen: true,
        };
        let (curves_of, bands, entries) = (vec![drawn], Vec::new(), Vec::new());
        let chart = Chart {
            name: String::new(),
            unit: "N",
            curves: curves_of,
            bands,
            entries,
            filled: false,
            log: false,
            missing: String::new(),
        };
        let context = theme::context();
        let input = RawInput { screen_rect: Some(place), ..RawInput::default() };
        let mut output = context.run_ui(input, |ui| {
            let palette = Palette::of(ui);
            curves(ui, &chart, &over, &values, &palette);
        });
        output.textures_delta.clear();
        let mut all = Vec::new();
        for clipped in context.tessellate(std::mem::take(&mut output.shapes), 1.0) {
            let Primitive::Mesh(mesh) = clipped.primitive else { continue };
            let corners = |i: &[u32]| i.iter().map(|&i| mesh.vertices[i as usize].pos).collect::<Vec<_>>();
            all.extend(mesh.indices.chunks_exact(3).map(|i| Rect::from_points(&corners(i))));
        }
        all
    }

    #[test]
    fn where_a_curve_has_no_points_nothing_is_filled() {
        let curve =
            [[1.0, 0.0], [1.0, 5.0], [1.01, 4.0], [1.01, 0.0], [8.0, 0.0], [8.0, 9.0], [8.01, 6.0], [8.01, 0.0]];
        let all = triangles(&curve);
        let second = all.iter().filter(|t| t.left() > 300.0);
        let highest = second.map(Rect::top).fold(f32::INFINITY, f32::min);
        assert!((8.0..12.0).contains(&highest), "the second spike is drawn: up to {highest}");
        let between = all.iter().filter(|t| t.left() < 200.0 && t.right() > 200.0);
        let up_to = between.map(Rect::top).fold(f32::INFINITY, f32::min);
        assert!(up_to > 95.0, "between the two there is the line at 0 N alone, not up to {up_to} of 100 points");
    }
}
