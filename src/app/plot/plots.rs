//! Curves of x, y, θ and contact force against time, under the timeline and on its axis.

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, FontId, Id, Rect, RichText, Role, Sense, Stroke, Ui, UiBuilder, WidgetInfo, Window, pos2, vec2};
use egui_plot::{
    AxisHints, FilledArea, GridMark, Line, LineStyle, Plot, PlotBounds, PlotPoints, PlotUi, Points, VLine,
};

use crate::app::command::Command;
use crate::app::plot::sampled::Sampled;
use crate::app::plot::source::Source;
use crate::app::plot::traces::{Band, Curve, Traces};
use crate::app::style::theme::{OWN, PINS, Palette};
use crate::app::text;
use crate::app::time::time_axis::{TimeAxis, ticks};

/// Width of the value axis; the timeline above begins as far from the edge \[points\].
pub(in crate::app) const AXIS_WIDTH: f32 = 62.0;

/// A set of curves in one frame.
struct Chart<'a> {
    label: LayoutJob,
    curves: Vec<(&'a Curve, Color32, LineStyle, bool)>,
    /// What a crowd of curves fills, behind them.
    bands: Vec<(&'a Band, Color32)>,
    words: fn(f64) -> String,
    /// Filled down to 0, the highest first.
    filled: bool,
}

/// Shows the plots over the rest of the room.
pub(in crate::app) fn show(ui: &mut Ui, source: &Source<'_>, out: &mut Vec<Command>) {
    let size = ui.available_size();
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, text::PLOTS));
    let strip = Rect::from_min_max(pos2(rect.left() + AXIS_WIDTH, rect.top()), rect.max);
    let axis = TimeAxis::over(strip, source.playback.window, source.end);
    axis.interact(ui, &response, out);
    let traces = source.traces(axis.window, samples(strip.width()));
    let palette = Palette::of(ui);
    let own = source.own_panels(axis.window, samples(strip.width()));
    let stacks: Vec<Vec<Curve>> = own.iter().map(stack).collect();
    let mut charts = charts(ui, source, &traces, &palette);
    charts.extend(own.iter().zip(&stacks).filter(|(p, _)| p.x.is_none()).map(|(p, s)| own_chart(p, s, &palette)));
    let height = (rect.height() + 4.0) / charts.len() as f32 - 4.0;
    for (i, chart) in charts.iter().enumerate() {
        let top = rect.top() + i as f32 * (height + 4.0);
        let place = Rect::from_min_size(pos2(rect.left(), top), vec2(rect.width(), height));
        draw(ui, i, chart, place, &axis, source.playback.clock.t, &palette);
    }
    for (i, panel) in own.iter().enumerate().filter(|(_, p)| p.x.is_some()) {
        orbit(ui, source, i, panel, &palette);
    }
}

/// Curves one upon the other.
fn stack(panel: &Sampled) -> Vec<Curve> {
    if !panel.stacked {
        return Vec::new();
    }
    let mut under: Curve = Vec::new();
    let mut all = Vec::with_capacity(panel.curves.len());
    for (_, curve) in &panel.curves {
        let sum = |(i, p): (usize, &[f64; 2])| [p[0], p[1] + under.get(i).map_or(0.0, |u| u[1])];
        under = curve.iter().enumerate().map(sum).collect();
        all.push(under.clone());
    }
    all
}

/// A panel of the user's own, against time.
fn own_chart<'a>(panel: &'a Sampled, stack: &'a [Curve], palette: &Palette) -> Chart<'a> {
    let color = |i: usize| OWN[i % OWN.len()];
    let style = |i: usize| if i < OWN.len() { LineStyle::Solid } else { LineStyle::Dashed { length: 6.0 } };
    let plain = panel.curves.iter().map(|(_, curve)| curve);
    let curves: Vec<_> = if panel.stacked { stack.iter().collect() } else { plain.collect() };
    let mut curves: Vec<_> = curves.into_iter().enumerate().map(|(i, c)| (c, color(i), style(i), true)).collect();
    if panel.stacked {
        // The highest is filled first, so that the lower ones lie on it.
        curves.reverse();
    }
    Chart { label: names(panel, palette), curves, bands: Vec::new(), words: text::short, filled: panel.stacked }
}

/// The curves' names in their colours.
fn names(panel: &Sampled, palette: &Palette) -> LayoutJob {
    let mut job = LayoutJob::default();
    let font = FontId::proportional(11.0);
    for (i, (name, _)) in panel.curves.iter().enumerate() {
        job.append(&format!("{name}  "), 0.0, TextFormat::simple(font.clone(), OWN[i % OWN.len()]));
    }
    job.append(&panel.y, 0.0, TextFormat::simple(font, palette.weak));
    job
}

/// A panel against another quantity: a small window of its own over the view, with a dot at the time shown.
fn orbit(ui: &Ui, source: &Source<'_>, number: usize, panel: &Sampled, palette: &Palette) {
    let title = text::panel(number + 1);
    let id = Id::unique(("orbit", number));
    let at = ui.content_rect().left_top() + vec2(280.0 + 30.0 * number as f32, 150.0 + 24.0 * number as f32);
    Window::new(title).id(id).default_pos(at).default_size([250.0, 210.0]).show(ui, |ui| {
        ui.label(names(panel, palette));
        let here = source.own_at(number);
        let plot =
            Plot::new(id.with("plot")).height((ui.available_height() - 20.0).max(80.0)).show_x(false).show_y(false);
        plot.allow_scroll(false).grid_color(palette.line).show(ui, |plot: &mut PlotUi<'_>| {
            for (i, (_, curve)) in panel.curves.iter().enumerate() {
                let points = PlotPoints::new(curve.clone());
                plot.line(Line::new("", points).stroke(Stroke::new(1.2, OWN[i % OWN.len()])).allow_hover(false));
            }
            plot.points(Points::new("", PlotPoints::new(here)).radius(4.0).color(palette.playhead).allow_hover(false));
        });
        ui.vertical_centered(|ui| ui.label(RichText::new(panel.x.as_deref().unwrap_or_default()).small()));
    });
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a width in points, clamped")]
fn samples(width: f32) -> usize {
    (width * 1.5).clamp(16.0, 8000.0) as usize
}

fn charts<'a>(ui: &Ui, source: &Source<'_>, traces: &'a Traces, palette: &Palette) -> Vec<Chart<'a>> {
    let shown = source.girder;
    let pick = |curves: &'a [Curve], color: Color32, style: LineStyle| -> Vec<_> {
        let curve = move |(i, c): (usize, &'a Curve)| {
            let chosen = i == shown;
            (c, if chosen { color } else { color.gamma_multiply(0.3) }, style, chosen)
        };
        // Of a crowd only the girder in question: the others are in the band.
        let alone = traces.bands.is_some();
        let mut all: Vec<_> = curves.iter().enumerate().map(curve).filter(|c| c.3 || !alone).collect();
        // The girder in question is drawn last, over the others.
        all.sort_by_key(|c| c.3);
        all
    };
    let mut place = pick(&traces.x, palette.x, LineStyle::Solid);
    place.extend(pick(&traces.y, palette.y, LineStyle::Dashed { length: 7.0 }));
    let dotted = LineStyle::Dotted { spacing: 4.0 };
    place.extend(pick(&traces.ghosts[0], palette.x, dotted));
    place.extend(pick(&traces.ghosts[1], palette.y, dotted));
    for (curves, color) in &traces.pins {
        place.push((&curves[0], PINS[*color], pin_style(*color), false));
        place.push((&curves[1], PINS[*color], LineStyle::Dashed { length: 4.0 }, false));
    }
    place.sort_by_key(|c| c.3);
    let mut theta = pick(&traces.theta, palette.theta, LineStyle::Solid);
    theta.extend(pick(&traces.ghosts[2], palette.theta, dotted));
    theta.extend(traces.pins.iter().map(|(curves, color)| (&curves[2], PINS[*color], pin_style(*color), false)));
    theta.sort_by_key(|c| c.3);
    let both = !traces.ghosts[0].is_empty();
    let chart = |label, curves, bands, words| Chart {
        label: text::legend(label, palette, ui),
        curves,
        bands,
        words,
        filled: false,
    };
    let force = traces.force.iter().map(|c| (c, palette.force, LineStyle::Solid, true)).collect();
    let faint = |color: Color32| color.gamma_multiply(0.3);
    let [x, y, turn] = traces.bands.as_ref().map_or([None; 3], |[x, y, turn]| [Some(x), Some(y), Some(turn)]);
    let places = x.map(|x| (x, faint(palette.x))).into_iter().chain(y.map(|y| (y, faint(palette.y)))).collect();
    let turns = turn.map(|turn| (turn, faint(palette.theta))).into_iter().collect();
    vec![
        chart(if both { text::PLOT_PLACE_BOTH } else { text::PLOT_PLACE }, place, places, text::short),
        chart(text::PLOT_THETA, theta, turns, text::short),
        chart(text::PLOT_FORCE, force, Vec::new(), text::force),
    ]
}

/// Kept runs differ by their dashes too.
fn pin_style(color: usize) -> LineStyle {
    match color {
        0 => LineStyle::Solid,
        1 => LineStyle::Dashed { length: 10.0 },
        2 => LineStyle::Dashed { length: 5.0 },
        _ => LineStyle::Dotted { spacing: 5.0 },
    }
}

fn draw(ui: &mut Ui, number: usize, chart: &Chart<'_>, place: Rect, axis: &TimeAxis, t: f64, palette: &Palette) {
    let mut inner = ui.new_child(UiBuilder::new().max_rect(place).id_salt(("plot", number)));
    let [low, high] = range(chart);
    let bounds = PlotBounds::from_min_max([axis.window[0], low], [axis.window[1], high]);
    Plot::new(Id::unique(("plot", number)))
        .height(place.height())
        .width(place.width())
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .allow_axis_zoom_drag(false)
        .show_axes([false, true])
        .show_x(false)
        .show_y(false)
        .sense(Sense::hover())
        .custom_y_axes(vec![values(chart.words)])
        .x_grid_spacer(move |grid| marks(grid.bounds, place.width() / 90.0))
        .y_grid_spacer(move |grid| inside(marks(grid.bounds, place.height() / 17.0), grid.bounds, place.height()))
        .grid_spacing(6.0..=14.0)
        .grid_color(palette.line)
        .set_margin_fraction(egui::Vec2::ZERO)
        .show(&mut inner, |plot: &mut PlotUi<'_>| {
            plot.set_plot_bounds(bounds);
            for (band, color) in &chart.bands {
                let area = FilledArea::new("", &band.times, &band.low, &band.high);
                plot.add(area.fill_color(*color).allow_hover(false));
            }
            for (curve, color, style, chosen) in &chart.curves {
                let width = if *chosen { 1.4 } else { 1.0 };
                let points = PlotPoints::new((*curve).clone());
                let line = Line::new("", points).stroke(Stroke::new(width, *color)).style(*style).allow_hover(false);
                plot.line(if chart.filled { line.fill(0.0).fill_alpha(1.0) } else { line });
            }
            plot.vline(VLine::new("", t).stroke(Stroke::new(1.2, palette.playhead)).allow_hover(false));
        });
    legend(ui, chart, place, palette);
}

/// The axis of values, its numbers written by `words`.
fn values(words: fn(f64) -> String) -> AxisHints<'static> {
    AxisHints::new_y().min_thickness(AXIS_WIDTH).label_spacing(6.0..=12.0).formatter(move |mark, _| words(mark.value))
}

/// About `wanted` round values.
fn marks((low, high): (f64, f64), wanted: f32) -> Vec<GridMark> {
    let values = ticks([low, high], f64::from(wanted));
    let step_size = values.get(1).zip(values.first()).map_or(high - low, |(b, a)| b - a);
    values.into_iter().map(|value| GridMark { value, step_size }).collect()
}

/// Only values whose numbers do not reach into the next chart.
fn inside(mut marks: Vec<GridMark>, (low, high): (f64, f64), height: f32) -> Vec<GridMark> {
    let margin = (high - low) * 6.0 / f64::from(height.max(12.0));
    marks.retain(|mark| mark.value > low + margin && mark.value < high - margin);
    marks
}

/// The name of the chart in its corner, with a plate behind it so that curves do not cross the letters.
fn legend(ui: &Ui, chart: &Chart<'_>, place: Rect, palette: &Palette) {
    let galley = ui.painter().layout_job(chart.label.clone());
    let at = pos2(place.left() + AXIS_WIDTH + 6.0, place.top() + 3.0);
    let plate = Rect::from_min_size(at, galley.size()).expand2(vec2(3.0, 1.0));
    ui.painter().rect_filled(plate, 2.0, palette.track.gamma_multiply(0.8));
    ui.painter().galley(at, galley, palette.force);
}

/// Lowest and highest value with a margin, 0 always inside.
fn range(chart: &Chart<'_>) -> [f64; 2] {
    let bands = chart.bands.iter().flat_map(|(band, _)| band.low.iter().chain(&band.high).copied());
    let values = chart.curves.iter().flat_map(|c| c.0.iter().map(|p| p[1])).chain(bands).filter(|v| v.is_finite());
    let (low, high) = values.fold((0.0f64, 0.0f64), |(l, h), v| (l.min(v), h.max(v)));
    let margin = ((high - low) * 0.08).max(1e-9);
    [low - margin, high + margin]
}
