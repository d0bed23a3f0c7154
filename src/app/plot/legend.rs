//! The legend beside a chart, off its curves: a sample of each line, its name, its value at the time pointed to or shown.

use egui::text::LayoutJob;
use egui::{Align2, Color32, FontId, Painter, Rect, Stroke, TextFormat, Ui, pos2, vec2};
use egui_plot::LineStyle;

use crate::app::plot::charts::{Chart, Entry};
use crate::app::style::theme::Palette;
use crate::app::text;

/// Height of a line \[points\].
const ROW: f32 = 13.0;

/// Length of a sample of a line \[points\].
const SAMPLE: f32 = 18.0;

/// Shows the legend of a chart at its right; `factor` and `unit` are those of its axis.
pub(super) fn show(ui: &mut Ui, chart: &Chart<'_>, place: Rect, (factor, unit): (f64, &str), palette: &Palette) {
    let response = ui.interact(place, ui.scope_id().with(("legend", chart.name.as_str())), egui::Sense::hover());
    let words = |entry: &Entry| {
        let value = entry.value.map_or_else(String::new, |v| format!(" {} {unit}", text::short(v * factor)));
        format!("{}{value}", entry.name)
    };
    let all: Vec<String> = chart.entries.iter().map(words).collect();
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, all.join(", ")));
    let painter = ui.painter_at(place);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some lines")]
    let fit = ((place.height() / ROW) as usize).max(1);
    let hidden = if chart.entries.len() > fit { chart.entries.len() + 1 - fit } else { 0 };
    for (n, entry) in chart.entries.iter().take(chart.entries.len() - hidden).enumerate() {
        row(&painter, entry, row_at(place, n), (factor, unit), palette);
    }
    if hidden > 0 {
        let at = row_at(place, fit - 1);
        painter.text(at.left_center(), Align2::LEFT_CENTER, text::more(hidden), small(), palette.weak);
    }
    response.on_hover_text(all.join("\n"));
}

fn small() -> FontId {
    FontId::proportional(11.0)
}

fn row_at(place: Rect, n: usize) -> Rect {
    Rect::from_min_size(pos2(place.left() + 6.0, place.top() + n as f32 * ROW), vec2(place.width() - 8.0, ROW))
}

fn row(painter: &Painter, entry: &Entry, place: Rect, (factor, unit): (f64, &str), palette: &Palette) {
    let y = place.center().y;
    sample(painter, [place.left(), place.left() + SAMPLE], y, (entry.color, entry.style));
    let value = entry.value.map_or_else(String::new, |v| format!("{} {unit}", text::short(v * factor)));
    let value = painter.text(place.right_center(), Align2::RIGHT_CENTER, value, small(), palette.force);
    let room = value.left() - 6.0 - (place.left() + SAMPLE + 5.0);
    let mut job = LayoutJob::single_section(entry.name.clone(), TextFormat::simple(small(), palette.weak));
    job.wrap = egui::text::TextWrapping::truncate_at_width(room.max(10.0));
    let galley = painter.layout_job(job);
    painter.galley(pos2(place.left() + SAMPLE + 5.0, y - galley.size().y / 2.0), galley, palette.weak);
}

fn sample(painter: &Painter, [from, to]: [f32; 2], y: f32, (color, style): (Color32, LineStyle)) {
    let (ends, stroke) = ([pos2(from, y), pos2(to, y)], Stroke::new(1.6, color));
    match style {
        LineStyle::Solid => drop(painter.line_segment(ends, stroke)),
        LineStyle::Dashed { length } => {
            let dash = length.min(6.0);
            painter.extend(egui::Shape::dashed_line(&ends, stroke, dash, dash * 0.6));
        }
        LineStyle::Dotted { .. } => painter.extend(egui::Shape::dotted_line(&ends, color, 4.0, 1.0)),
    }
}
