//! The window of the ground motion: acceleration, velocity, displacement against time; the response spectrum against the period.

use egui::{Id, RichText, Stroke, Ui, Window, vec2};
use egui_plot::{AxisHints, Plot, PlotUi, Points, Text, VLine};

use super::shaking::{OwnPeriod, Shaking, own_periods};
use crate::app::command::{Command, QuakeCommand, TimeCommand};
use crate::app::plot::resolution::line;
use crate::app::plot::value_axis::grid_marks;
use crate::app::run::answer::Answer;
use crate::app::style::theme::{OWN, Palette};
use crate::app::text;
use crate::plot::chart::Panel;
use crate::study::ground::Component;

/// Width of a panel \[points\].
const WIDTH: f32 = 360.0;
/// Height of the window's plots together \[points\].
const HEIGHT: f32 = 400.0;
/// Height of an axis with numbers and a name \[points\].
const NAMED_AXIS: f32 = 32.0;
/// Distance of numbers along a level axis, in that along an upright one: numbers are wider than they are high.
const LEVEL: f32 = 5.0;
/// Most own periods that are marked: those of a long row would hide the curve.
const MOST_PERIODS: usize = 12;

/// Shows the window while it is open; the time shown is `t` \[s\].
pub(in crate::app) fn show(ui: &mut Ui, shaking: &Shaking, answer: Option<&Answer>, t: f64, out: &mut Vec<Command>) {
    if !shaking.is_open() {
        return;
    }
    let mut open = true;
    let room = ui.content_rect();
    let window = Window::new(text::QUAKE).id(Id::unique("quake")).open(&mut open).resizable(false);
    window.default_pos(room.left_top() + vec2(255.0, 40.0)).show(ui, |ui| {
        ui.set_width(750.0);
        let (Some(shaken), Some(answer)) = (shaking.shaken(), answer) else {
            ui.label(if shaking.is_computing() { text::COMPUTING } else { text::QUAKE_STILL });
            return;
        };
        let count = shaken.components.len();
        let Some(component) = shaken.components.get(shaking.component.min(count.max(1) - 1)) else {
            ui.label(text::QUAKE_STILL);
            return;
        };
        above(ui, (component, &shaken.components), shaking, out);
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| histories(ui, component, t, out));
            ui.vertical(|ui| spectra(ui, component, &own_periods(&answer.history)));
        });
        ui.label(RichText::new(text::QUAKE_HINT).weak().small());
    });
    if !open {
        out.push(QuakeCommand::Show(false).into());
    }
}

/// Which component, and its figures.
fn above(ui: &mut Ui, (shown, all): (&Component, &[Component]), shaking: &Shaking, out: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        for (number, component) in all.iter().enumerate().filter(|_| all.len() > 1) {
            let chosen = std::ptr::eq(component, shown);
            if ui.selectable_label(chosen, component.name).clicked() && number != shaking.component {
                out.push(QuakeCommand::Component(number).into());
            }
        }
        let f = &shown.figures;
        let peaks = [f.acceleration, f.velocity, f.displacement].map(|peak| (peak.value.abs(), peak.at));
        ui.label(text::quake_figures(peaks, f.strong.duration()));
    });
}

fn histories(ui: &mut Ui, component: &Component, t: f64, out: &mut Vec<Command>) {
    for (number, panel) in component.histories.iter().enumerate() {
        let last = number + 1 == component.histories.len();
        let axis = if last { text::QUAKE_TIME.as_str() } else { "" };
        let shown = plot(ui, "history", number, axis, panel, |plot| {
            plot.vline(VLine::new("", t).allow_hover(false).width(1.0));
            plot.pointer_coordinate().filter(|_| plot.response().clicked())
        });
        if let Some(at) = shown {
            out.push(TimeCommand::Seek(at.x).into());
        }
    }
}

/// Spectra over the period, the girders' own periods marked; the name stands with the uppermost.
fn spectra(ui: &mut Ui, component: &Component, own: &[OwnPeriod]) {
    let palette = Palette::of(ui);
    for (number, panel) in component.spectrum.iter().enumerate() {
        let last = number + 1 == component.spectrum.len();
        let axis = if last { text::QUAKE_PERIOD.as_str() } else { "" };
        let longest =
            panel.curves.iter().filter_map(|curve| curve.points.last()).fold(0.0, |most: f64, p| most.max(p[0]));
        let highest = panel.curves.iter().flat_map(|c| &c.points).fold(0.0, |most: f64, p| most.max(p[1]));
        plot(ui, "spectrum", number, axis, panel, |plot| {
            for (row, OwnPeriod { name, period }) in distinct(own).iter().take(MOST_PERIODS).enumerate() {
                if *period > longest {
                    continue;
                }
                plot.vline(VLine::new("", *period).color(palette.weak).allow_hover(false).width(1.0));
                let value = value_at(panel, *period);
                let dot = Points::new("", vec![[*period, value]]).radius(3.5).color(palette.playhead);
                plot.points(dot.allow_hover(false));
                if number == 0 {
                    let at = [*period, highest * (0.97 - 0.13 * (row % 4) as f64)];
                    let words = RichText::new(format!(" {name} {} s", text::short(*period))).size(10.5);
                    let words = Text::new("", at.into(), words).color(palette.force).anchor(egui::Align2::LEFT_CENTER);
                    plot.text(words.allow_hover(false));
                }
            }
            None::<egui_plot::PlotPoint>
        });
    }
}

/// Own periods, those that are equal to three digits as one with both names.
fn distinct(own: &[OwnPeriod]) -> Vec<OwnPeriod> {
    let mut all: Vec<OwnPeriod> = Vec::new();
    for one in own {
        match all.iter_mut().find(|known| text::short(known.period) == text::short(one.period)) {
            Some(known) => known.name = format!("{}, {}", known.name, one.name),
            None => all.push(one.clone()),
        }
    }
    all
}

/// Value of the first curve at a place, on the straight line between its points.
fn value_at(panel: &Panel, x: f64) -> f64 {
    let Some(points) = panel.curves.first().map(|curve| &curve.points) else { return 0.0 };
    let after = points.partition_point(|p| p[0] < x).clamp(1, points.len().max(2) - 1);
    match (points.get(after - 1), points.get(after)) {
        (Some(a), Some(b)) if b[0] > a[0] => a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]),
        (Some(a), _) => a[1],
        _ => 0.0,
    }
}

/// Panel of this number among those of a kind, `what`, in the colour of its number, with the name of its level axis and what is drawn upon
/// it.
fn plot<R>(
    ui: &mut Ui,
    what: &str,
    number: usize,
    axis: &'static str,
    panel: &Panel,
    upon: impl FnOnce(&mut PlotUi<'_>) -> Option<R>,
) -> Option<R> {
    let palette = Palette::of(ui);
    ui.label(RichText::new(&panel.name).small());
    let height = HEIGHT / 3.0 - 18.0 + if axis.is_empty() { 0.0 } else { NAMED_AXIS - 18.0 };
    let y = AxisHints::new_y().min_thickness(44.0).formatter(|mark, _| text::short(mark.value));
    // Below the numbers the axis' name.
    let x = AxisHints::new_x().label(axis).formatter(|mark, _| text::short(mark.value));
    let x = if axis.is_empty() { x } else { x.min_thickness(NAMED_AXIS) };
    let plot = Plot::new(Id::unique(("quake", what, number))).height(height).width(WIDTH).show_x(false).show_y(false);
    let plot = plot.allow_scroll(false).allow_drag(false).allow_zoom(false).allow_boxed_zoom(false);
    let plot = plot.custom_y_axes(vec![y]).custom_x_axes(vec![x]).grid_color(palette.line);
    let plot = plot.y_grid_spacer(move |grid| grid_marks(grid.bounds, height, false)).grid_spacing(6.0..=14.0);
    let plot = plot.x_grid_spacer(move |grid| grid_marks(grid.bounds, WIDTH / LEVEL, false));
    plot.show(ui, |plot| {
        for curve in &panel.curves {
            let line = line("", curve.points.clone()).stroke(Stroke::new(1.2, OWN[number]));
            plot.line(line.allow_hover(false));
        }
        upon(plot)
    })
    .inner
}
