//! Panels that are not over time, each in a small window over the view: a quantity against another, Fourier amplitudes, response
//! spectra. The mouse moves and zooms both axes; a double click shows everything.

use egui::{Id, Label, RichText, Stroke, Ui, Vec2, Window, vec2};
use egui_plot::{HoverPosition, Plot, PlotUi, Points};

use crate::app::command::{Command, EditCommand};
use crate::app::plot::charts::look;
use crate::app::plot::resolution;
use crate::app::plot::sampled::Sampled;
use crate::app::plot::source::Source;
use crate::app::plot::value_axis::{AxisUnit, WHEEL, fitting, grid_marks};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::scene::edit::Edit;

/// Shows them; one that is closed is taken from the scene.
pub(super) fn show(ui: &Ui, source: &Source<'_>, out: &mut Vec<Command>) {
    let window = source.playback.window.unwrap_or([0.0, source.end]);
    let (numbers, own) = source.own_panels(false, (window, POINTS));
    for (number, panel) in numbers.into_iter().zip(own.iter()) {
        if !one(ui, source, number, panel) {
            let mut view = source.scene.view.clone();
            view.plots.remove(number);
            out.push(EditCommand::Change { edit: Edit::View(view), gesture: None }.into());
        }
    }
}

/// Points of a curve against another quantity.
const POINTS: usize = 2000;

/// Size of a new window: a quarter of the view of a small screen \[points\].
const SIZE: [f32; 2] = [240.0, 180.0];

/// Whether it stays open.
fn one(ui: &Ui, source: &Source<'_>, number: usize, panel: &Sampled) -> bool {
    let id = Id::unique(("own plot", number));
    let at = ui.content_rect().left_top() + vec2(280.0 + 30.0 * number as f32, 150.0 + 24.0 * number as f32);
    let mut open = true;
    // A window is a layer of its own, which the ink of what it stands over does not reach.
    let ink = ui.opacity();
    let window = Window::new(text::panel(number + 1)).id(id).default_pos(at).default_size(SIZE).open(&mut open);
    window.show(ui, |ui| {
        ui.set_opacity(ink);
        if !panel.missing.is_empty() {
            ui.add(Label::new(RichText::new(text::missing(&panel.missing)).weak()).wrap());
        }
        let most = panel.curves.iter().flat_map(|(_, curve)| curve).fold(0.0, |most: f64, p| most.max(p[1].abs()));
        let unit = fitting(panel.unit, most);
        names(ui, panel, &unit.name);
        let height = (ui.available_height() - 20.0).max(90.0);
        let here = source.own_at(number, source.playback.clock.t);
        draw(ui, id, height, unit, panel, &here);
        ui.vertical_centered(|ui| ui.label(RichText::new(panel.x.as_deref().unwrap_or_default()).small()));
    });
    open
}

/// The curves' names in their colours, and the unit that their axis counts in.
fn names(ui: &mut Ui, panel: &Sampled, unit: &str) {
    ui.horizontal_wrapped(|ui| {
        for (i, (name, _)) in panel.curves.iter().enumerate() {
            ui.label(RichText::new(name).small().color(look(panel, i).0));
        }
        ui.label(RichText::new(panel.y.replacen(panel.unit, unit, 1)).small().weak());
    });
}

/// Whether this is not the next frame after one in which it was shown too: a window that is opened anew shows everything.
fn is_new(ui: &Ui, id: Id) -> bool {
    let now = ui.ctx().cumulative_frame_nr();
    let last = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or(id.with("shown"), now), now));
    now > last + 1
}

fn draw(
    ui: &mut Ui,
    id: Id,
    height: f32,
    AxisUnit { factor, name: unit }: AxisUnit,
    panel: &Sampled,
    here: &[[f64; 2]],
) {
    let palette = Palette::of(ui);
    let (log, factors) = (panel.log, [1.0, factor]);
    let titles = [panel.x.clone().unwrap_or_default(), panel.y.replacen(panel.unit, &unit, 1)];
    let scaled = move |p: &[f64; 2]| [0, 1].map(|n| if log[n] { p[n].abs().log10() } else { p[n] });
    let words = move |n: usize, value: f64| text::short(factors[n] * if log[n] { 10f64.powf(value) } else { value });
    let width = ui.available_width();
    let plot = Plot::new(id.with("plot"));
    let plot = if is_new(ui, id) { plot.reset() } else { plot };
    plot.height(height)
        .allow_scroll(false)
        .grid_color(palette.line)
        .x_grid_spacer(move |grid| grid_marks(grid.bounds, width / 5.0, log[0]))
        .y_grid_spacer(move |grid| grid_marks(grid.bounds, height / 2.0, log[1]))
        .grid_spacing(6.0..=14.0)
        .x_axis_formatter(move |mark, _| words(0, mark.value))
        .y_axis_formatter(move |mark, _| words(1, mark.value))
        .label_formatter(move |at| {
            let (name, position) = match at {
                HoverPosition::NearDataPoint { plot_name, position, .. } => (format!("{plot_name}\n"), position),
                HoverPosition::Elsewhere { position } => (String::new(), position),
            };
            let line = |n: usize, value: f64| format!("{}: {}", titles[n], words(n, value));
            Some(format!("{name}{}\n{}", line(0, position.x), line(1, position.y)))
        })
        .show(ui, |plot: &mut PlotUi<'_>| {
            let scrolled = plot.ctx().input(|i| i.smooth_scroll_delta.y);
            if scrolled != 0.0 && plot.response().hovered() {
                plot.zoom_bounds_around_hovered(Vec2::splat((WHEEL * scrolled).exp()));
            }
            // Kept runs lie behind the one shown.
            for (i, (name, curve)) in panel.curves.iter().enumerate().rev() {
                let points: Vec<[f64; 2]> =
                    curve.iter().map(scaled).filter(|p| p[1].is_finite() && p[0].is_finite()).collect();
                let (color, style) = look(panel, i);
                let stroke = Stroke::new(if panel.kept(i).is_some() { 0.9 } else { 1.5 }, color);
                plot.line(resolution::line(name, points).stroke(stroke).style(style));
            }
            for (i, at) in here.iter().map(scaled).enumerate().filter(|(_, at)| at[1].is_finite()) {
                let ring = Points::new("", vec![at]).radius(5.0).color(palette.playhead).allow_hover(false);
                plot.points(ring);
                plot.points(Points::new("", vec![at]).radius(3.5).color(look(panel, i).0).allow_hover(false));
            }
        });
}
