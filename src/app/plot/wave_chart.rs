//! A section force of a girder that bends, over time and station, under the plots: waves are seen to run and turn.
//!
//! Values are computed on an even grid of times and stations and coloured between its points. Where the window of time is so wide
//! that a wave would fall between the times, nothing is drawn but a button that leads to the hardest hit.

use egui::text::LayoutJob;
use egui::{
    Align2, Button, Color32, FontId, Painter, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2,
};

use crate::app::command::{Command, TimeCommand};
use crate::app::plot::chart_view::{self, Over};
use crate::app::plot::source::Source;
use crate::app::plot::value_axis::{AxisUnit, ValueAxis, fitting};
use crate::app::plot::wave_picture::{COLUMN, Key, colors};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::plot::color_map::level;
use crate::sim::OfSection;
use crate::study::waves;
use crate::view::section_force;

/// Columns in which a wave runs from end to end, at least: fewer would show its front as a staircase.
const COLUMNS_OF_A_TRANSIT: f64 = 8.0;
/// Width of the colour bar \[points\].
const BAR: f32 = 10.0;

/// Whether there is such a chart: the girder in question bends.
pub(super) fn is_shown(source: &Source<'_>) -> bool {
    source.answer.is_some_and(|answer| answer.history.sections().flexible(source.girder).is_some())
}

/// Draws it.
pub(super) fn draw(ui: &mut Ui, source: &Source<'_>, over: &Over<'_>, palette: &Palette, out: &mut Vec<Command>) {
    let Some(answer) = source.answer else { return };
    let history = &answer.history;
    let Some(beam) = history.sections().flexible(source.girder).map(|flexible| &flexible.beam) else { return };
    let what = source.section_force;
    let whole = chart_view::field(over);
    let title = text::wave_chart(&section_force(what), &history.scene().girders[source.girder].name);
    let half = 0.5 * beam.length;
    let axis = ValueAxis { range: [-half, half], edges: [whole.top(), whole.bottom()], log: false };
    let AxisUnit { factor, name: unit } = fitting("m", half);
    chart_view::numbers(ui, over, (&axis, &axis.ticks(), factor, &unit), palette);
    let per_column = over.axis.per_point() * f64::from(COLUMN);
    if per_column * COLUMNS_OF_A_TRANSIT > beam.transit_time() {
        let words = text::show_waves(beam.transit_time());
        let button = Rect::from_center_size(whole.center(), vec2(whole.width() - 8.0, 20.0));
        if ui.put(button, Button::new(words).small().truncate()).clicked() {
            let span = waves::hit_span(history, source.girder).unwrap_or([0.0, 3.0 * beam.transit_time()]);
            out.push(TimeCommand::Window(Some(span)).into());
            let peak = waves::hit_peak(history, source.girder).unwrap_or(span[0].midpoint(span[1]));
            out.push(TimeCommand::Seek(peak).into());
        }
        return;
    }
    // The run may end within the window.
    let window = [over.axis.window[0], over.axis.window[1].min(history.end())];
    if window[0] >= window[1] {
        return;
    }
    let field = Rect::from_min_max(whole.min, pos2(over.axis.x(window[1]), whole.bottom()));
    let response = ui.interact(field, ui.scope_id().with("waves"), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, &title));
    let key = Key { answer: answer.number, girder: source.girder, what, window, field };
    let Some(drawn) = source.samples.waves.borrow_mut().of(answer, key) else { return };
    let painter = ui.painter_at(whole);
    painter.add(Shape::mesh(drawn.mesh.clone()));
    painter.vline(over.axis.x(over.t), whole.y_range(), Stroke::new(1.2, palette.playhead));
    let pointed = response.hover_pos();
    if let Some(at) = pointed {
        let cross = Stroke::new(1.0, palette.weak);
        painter.vline(at.x, whole.y_range(), cross);
        painter.hline(whole.x_range(), at.y, cross);
    }
    let said = pointed.map(|at| {
        let station = axis.value(at.y).clamp(-half, half);
        let t = over.axis.t(at.x).clamp(window[0], window[1]);
        let force =
            history.sections().component(source.girder, &history.sections().forces(source.girder, station, t), what);
        let (unit, size) = what.unit();
        text::at_station(&format!("{} {unit}", text::short(force / size)), station)
    });
    if let (Some(at), Some(words)) = (pointed, &said) {
        beside_pointer(&painter, (at, field), words, palette);
    }
    bar(ui, over, (&title, said), (what, drawn.range), palette);
}

/// Words on a plate beside the mouse, on the side where the field has more room.
fn beside_pointer(painter: &Painter, (at, field): (Pos2, Rect), words: &str, palette: &Palette) {
    let galley = painter.layout_no_wrap(words.to_owned(), FontId::proportional(11.0), palette.force);
    let left = at.x > field.center().x;
    let (align, aside) = if left { (Align2::RIGHT_BOTTOM, -6.0) } else { (Align2::LEFT_BOTTOM, 6.0) };
    let top = field.top() + galley.size().y + 2.0;
    let plate = align.anchor_size(pos2(at.x + aside, (at.y - 4.0).max(top)), galley.size());
    painter.rect_filled(plate.expand(2.0), 2.0, palette.track.gamma_multiply(0.9));
    painter.galley(plate.min, galley, palette.force);
}

/// Lines of small letters between the values at both ends of a bar of this height \[points\].
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a height in points, at least 0")]
fn rows_between(height: f32) -> usize {
    const LINE: f32 = 13.0;
    (height / LINE - 2.0).max(0.0) as usize
}

/// Scale of the colours, at the right; its accessible label is the value pointed to.
fn bar(
    ui: &mut Ui,
    over: &Over<'_>,
    (title, said): (&str, Option<String>),
    (what, range): (OfSection, [f64; 2]),
    palette: &Palette,
) {
    let field = chart_view::field(over);
    let place = Rect::from_min_max(pos2(field.right() + 6.0, field.top()), over.place.max);
    let response = ui.interact(place, ui.scope_id().with("waves bar"), Sense::hover());
    let painter = ui.painter_at(place);
    let bar = Rect::from_min_size(place.min, vec2(BAR, place.height()));
    let steps = bar.height().max(1.0);
    let mut top = bar.top();
    while top < bar.bottom() {
        let part = f64::from((bar.bottom() - top) / steps);
        let [r, g, b] = colors(what).rgb(level(part, [0.0, 1.0]));
        let strip = Rect::from_min_size(pos2(bar.left(), top), vec2(BAR, 1.0));
        painter.rect_filled(strip, 0.0, Color32::from_rgb(r, g, b));
        top += 1.0;
    }
    let (unit, size) = what.unit();
    let small = FontId::proportional(10.5);
    let values = [(range[1], bar.top(), Align2::LEFT_TOP), (range[0], bar.bottom(), Align2::LEFT_BOTTOM)];
    for (value, y, align) in values {
        painter.text(
            pos2(bar.right() + 4.0, y),
            align,
            format!("{} {unit}", text::short(value / size)),
            small.clone(),
            palette.force,
        );
    }
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, said.as_deref().unwrap_or(title)));
    let mut job =
        LayoutJob::simple(title.to_owned(), small, palette.weak, (place.right() - bar.right() - 8.0).max(20.0));
    // Between the two values, as many lines as there is room for.
    job.wrap.max_rows = rows_between(place.height());
    if job.wrap.max_rows > 0 {
        let galley = painter.layout_job(job);
        painter.galley(pos2(bar.right() + 4.0, place.center().y - 0.5 * galley.size().y), galley, palette.weak);
    }
    response.on_hover_text(title);
}
