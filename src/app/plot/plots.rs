//! Curves over time, under the timeline and on its axis: place, rotation and force of every scene, panels of the user's own.

use egui::scroll_area::ScrollSource;
use egui::{Rect, Role, ScrollArea, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::app::command::Command;
use crate::app::plot::charts::{self, Chart};
use crate::app::plot::resolution::Curve;
use crate::app::plot::source::Source;
use crate::app::plot::value_axis::LEAST_HEIGHT;
use crate::app::plot::{chart_view, wave_chart, windows};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::time::time_axis::TimeAxis;

/// Width of the value axis; the timeline above begins as far from the edge \[points\].
pub(in crate::app) const AXIS_WIDTH: f32 = 62.0;

/// Between two charts \[points\].
const BETWEEN: f32 = 5.0;

/// Width of the legends at the right; the timeline above ends as far from the edge \[points\].
pub(in crate::app) fn legend_width(ui: &Ui) -> f32 {
    (ui.available_width() * 0.16).clamp(110.0, 190.0)
}

/// Shows the plots over the rest of the room.
pub(in crate::app) fn show(ui: &mut Ui, source: &Source<'_>, out: &mut Vec<Command>) {
    let legend = legend_width(ui);
    let height = ui.available_height();
    let own = source.scene.view.plots.iter().filter(|plot| Source::is_over_time(plot)).count();
    let own = own + usize::from(wave_chart::is_shown(source));
    let least = (3 + own) as f32 * (LEAST_HEIGHT + BETWEEN) - BETWEEN;
    // The wheel zooms: what does not fit is reached by the bar.
    // The bar takes of the legends, never of the axis of time: that is the timeline's.
    let right = ui.max_rect().right() - legend;
    let area = ScrollArea::vertical().id_salt("plots").scroll_source(ScrollSource::SCROLL_BAR).auto_shrink(false);
    area.show(ui, |ui| over_time(ui, source, (right, height.max(least)), out));
    windows::show(ui, source, out);
}

/// Rows of charts that waves take below others: two where there is room; none where the girder in question does not bend.
fn wave_rows(source: &Source<'_>, height: f32, others: usize) -> usize {
    let room = height >= (others + 2) as f32 * (LEAST_HEIGHT + BETWEEN) - BETWEEN;
    match (wave_chart::is_shown(source), room) {
        (false, _) => 0,
        (true, false) => 1,
        (true, true) => 2,
    }
}

fn over_time(ui: &mut Ui, source: &Source<'_>, (right, height): (f32, f32), out: &mut Vec<Command>) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let strip = Rect::from_min_max(pos2(rect.left() + AXIS_WIDTH, rect.top()), pos2(right, rect.bottom()));
    let response = ui.interact(strip, ui.scope_id().with("strip"), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, text::PLOTS));
    let axis = TimeAxis::over(strip, source.playback.window, source.end);
    axis.interact(ui, &response, out);
    let t = source.playback.clock.t;
    let at = axis.pointed(ui).map_or(t, |x| axis.t(x).clamp(0.0, source.end));
    let points = samples(strip.width());
    let traces = source.traces(axis.window, points);
    let (numbers, own) = source.own_panels(true, (axis.window, points));
    let stacks: Vec<Vec<Curve>> = own.iter().map(charts::stack).collect();
    let palette = Palette::of(ui);
    let mut all: Vec<Chart<'_>> = charts::standing(source, &traces, at, &palette);
    let panels = own.iter().zip(&stacks).zip(numbers);
    all.extend(panels.map(|((panel, stack), i)| charts::own(panel, stack, &source.own_at(i, at))));
    let waves = wave_rows(source, rect.height(), all.len());
    let row = (rect.height() + BETWEEN) / (all.len() + waves) as f32;
    let over = |number: usize, rows: usize| {
        let top = rect.top() + number as f32 * row;
        let place = Rect::from_min_size(pos2(rect.left(), top), vec2(rect.width(), rows as f32 * row - BETWEEN));
        chart_view::Over { number, place, axis: &axis, t }
    };
    if waves > 0 {
        wave_chart::draw(ui, source, &over(all.len(), waves), &palette, out);
    }
    for (number, chart) in all.iter().enumerate() {
        let over = over(number, 1);
        chart_view::draw(ui, chart, &over, (source.views.values(&chart.name), &palette), out);
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a width in points, clamped")]
fn samples(width: f32) -> usize {
    (width * 1.5).clamp(16.0, 8000.0) as usize
}
