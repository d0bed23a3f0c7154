//! Plot panels that the user has made: any quantity against time or against another; saved with the scene.

use std::sync::Arc;

use egui::{ComboBox, RichText, ScrollArea, TextEdit, Ui};

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::field::{Place, mark};
use crate::app::run::answer::Answer;
use crate::app::text;
use crate::scene::edit::Edit;
use crate::scene::{PlotSettings, ViewSettings};
use crate::sim::History;
use crate::sim::quantity::{OfContact, OfCorner, OfEnergy, Quantity, Unit};

/// Most panels of the user's own.
const MOST: usize = 6;

/// Points that a touch adds to a curve of a contact, so that its peak is not lost between two samples.
const IN_A_TOUCH: u32 = 6;

/// Most points of a curve.
const MOST_POINTS: usize = 20_000;

/// A panel's curves over a window of time.
#[derive(Clone, Debug, Default)]
pub(in crate::app) struct Sampled {
    /// Name, unit shown, values `[x or t, y]` in shown units.
    pub(in crate::app) curves: Vec<(String, Vec<[f64; 2]>)>,
    /// What is drawn upright, with its unit.
    pub(in crate::app) y: String,
    /// What is drawn level, with its unit; time when absent.
    pub(in crate::app) x: Option<String>,
    /// Whether the curves are energies that are stored or lost: drawn one upon the other.
    pub(in crate::app) stacked: bool,
}

/// What panels were sampled for.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    answer: u64,
    window: [f64; 2],
    points: usize,
    plots: Vec<PlotSettings>,
}

/// Keeps the last samples until something else is to be seen.
#[derive(Default)]
pub(in crate::app) struct PanelCache {
    key: Option<Key>,
    panels: Arc<Vec<Sampled>>,
}

impl PanelCache {
    /// Every panel over a window, about `points` samples long.
    pub(in crate::app) fn of(
        &mut self,
        (history, answer): (&History, u64),
        plots: &[PlotSettings],
        window: [f64; 2],
        points: usize,
    ) -> Arc<Vec<Sampled>> {
        let key = Key { answer, window, points, plots: plots.to_vec() };
        if self.key.as_ref() != Some(&key) {
            self.panels = Arc::new(plots.iter().map(|p| sample(history, p, window, points)).collect());
            self.key = Some(key);
        }
        self.panels.clone()
    }
}

/// How a unit is shown: factor from SI, and its name.
pub(in crate::app) fn shown(unit: Unit) -> (f64, &'static str) {
    match unit {
        Unit::Metre => (1e3, "mm"),
        Unit::Radian => (180.0 / std::f64::consts::PI, "°"),
        Unit::MetrePerSecond => (1.0, "m/s"),
        Unit::RadianPerSecond => (180.0 / std::f64::consts::PI, "°/s"),
        Unit::MetrePerSecond2 => (1.0, "m/s²"),
        Unit::Newton => (1.0, "N"),
        Unit::Joule => (1.0, "J"),
        Unit::One => (1.0, "1"),
    }
}

/// A panel's curves; quantities that the run does not have are left out.
pub(in crate::app) fn sample(history: &History, plot: &PlotSettings, window: [f64; 2], points: usize) -> Sampled {
    let model = history.model();
    let found: Vec<(&String, Quantity)> =
        plot.y.iter().filter_map(|name| Some((name, Quantity::find(model, name)?))).collect();
    let x = plot.x.as_ref().and_then(|name| Some((name, Quantity::find(model, name)?)));
    let times = times(history, window, points);
    let (factor_x, unit_x) = x.map_or((1.0, "s"), |(_, q)| shown(q.unit()));
    let level = |t: f64| x.map_or(t, |(_, q)| q.at(history, t) * factor_x);
    let curve = |(name, quantity): &(&String, Quantity)| {
        let (factor, _) = shown(quantity.unit());
        let point = |&t: &f64| [level(t), quantity.at(history, t) * factor];
        ((*name).clone(), times.iter().map(point).collect())
    };
    let unit = found.first().map_or("", |(_, q)| shown(q.unit()).1);
    Sampled {
        curves: found.iter().map(curve).collect(),
        y: format!("[{unit}]"),
        x: x.map(|(name, _)| format!("{name} [{unit_x}]")),
        stacked: x.is_none() && found.len() > 1 && found.iter().all(|(_, q)| matches!(q, Quantity::Energy(_))),
    }
}

/// The panel's points at one instant.
pub(in crate::app) fn at(answer: &Answer, plot: &PlotSettings, t: f64) -> Vec<[f64; 2]> {
    let value = |name: &String| {
        let quantity = answer.quantity(name)?;
        Some(quantity.at(&answer.history, t) * shown(quantity.unit()).0)
    };
    let level = plot.x.as_ref().and_then(value).unwrap_or(t);
    plot.y.iter().filter_map(value).map(|y| [level, y]).collect()
}

/// Evenly spaced times, and enough of them inside every touch.
fn times(history: &History, window: [f64; 2], points: usize) -> Vec<f64> {
    let (from, to) = (window[0], window[1].min(history.end()));
    let step = (to - from) / (points.max(2) - 1) as f64;
    let mut times: Vec<f64> = (0..points.max(2)).map(|i| from + step * i as f64).collect();
    for touch in history.touches().iter().filter(|touch| touch.end >= from && touch.start <= to) {
        if times.len() > MOST_POINTS {
            break;
        }
        let inside =
            (0..=IN_A_TOUCH).map(|i| touch.start + (touch.end - touch.start) * f64::from(i) / f64::from(IN_A_TOUCH));
        times.extend(inside.chain([touch.peak_time]).filter(|t| (from..=to).contains(t)));
    }
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// Shows the list of panels and lets it be changed.
pub(in crate::app) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let Some(answer) = bench.answer() else { return };
    let names = answer.quantities();
    let mut plots = bench.scene().view.plots.clone();
    let mut gone = None;
    for (i, plot) in plots.iter_mut().enumerate() {
        ui.horizontal(|ui| {
            ui.label(RichText::new(text::panel(i + 1)).strong());
            if ui.small_button(text::remove_panel(i + 1)).clicked() {
                gone = Some(i);
            }
        });
        one(ui, i, plot, names);
    }
    if let Some(i) = gone {
        plots.remove(i);
    }
    ui.horizontal(|ui| {
        ui.add_enabled_ui(plots.len() < MOST, |ui| {
            let adding = ui.menu_button(text::ADD_PANEL, |ui| {
                for (words, plot) in offers(names, bench.shown_girder()) {
                    if ui.button(words).clicked() {
                        plots.push(plot);
                        ui.close();
                    }
                }
            });
            let place = Place { problems: None, table: "view" };
            mark(&adding.response, place, ("plot", text::ADD_PANEL));
        });
        ui.menu_button(text::EXPORT_PLOTS, |ui| {
            for (words, format) in [("SVG…", "svg"), ("PNG…", "png"), ("CSV…", "csv")] {
                if ui.button(words).clicked() {
                    out.push(Command::AskPlots(format));
                    ui.close();
                }
            }
        });
    });
    if plots != bench.scene().view.plots {
        let view = ViewSettings { plots, ..bench.scene().view.clone() };
        out.push(Command::Edit { edit: Edit::View(view), gesture: None });
    }
}

/// Panels that are often wanted.
fn offers(names: &[(String, Quantity)], girder: usize) -> Vec<(&'static str, PlotSettings)> {
    let first =
        |wanted: &dyn Fn(&Quantity) -> bool| names.iter().find(|(_, q)| wanted(q)).map(|(name, _)| name.clone());
    let of_girder = |what: usize| {
        let own: Vec<&String> =
            names.iter().filter(|(_, q)| matches!(q, Quantity::Girder(i, _) if *i == girder)).map(|(n, _)| n).collect();
        own.get(what).map(|n| (*n).clone())
    };
    let corner =
        |wanted: OfCorner| first(&|q| matches!(q, Quantity::Corner(i, 1, of) if *i == girder && *of == wanted));
    let contact = |wanted: OfContact| first(&|q| matches!(q, Quantity::Contact(_, of) if *of == wanted));
    let against = |x: Option<String>, y: Option<String>| Some(PlotSettings { x: Some(x?), y: vec![y?] });
    let energies: Vec<String> = names
        .iter()
        .filter(|(_, q)| matches!(q, Quantity::Energy(of) if !matches!(of, OfEnergy::Work | OfEnergy::Residual)))
        .map(|(name, _)| name.clone())
        .collect();
    let list = [
        (text::OFFER_ENERGY, Some(PlotSettings { x: None, y: energies })),
        (text::OFFER_DRIFT, corner(OfCorner::Drift).map(|y| PlotSettings { x: None, y: vec![y] })),
        (text::OFFER_ORBIT, against(corner(OfCorner::X), corner(OfCorner::Y))),
        (text::OFFER_PENETRATION, against(contact(OfContact::Penetration), contact(OfContact::Force))),
        (text::OFFER_HYSTERESIS, against(of_girder(1), contact(OfContact::Tangential))),
        (text::OFFER_USE, contact(OfContact::Use).map(|y| PlotSettings { x: None, y: vec![y] })),
        (text::OFFER_EMPTY, of_girder(0).map(|y| PlotSettings { x: None, y: vec![y] })),
    ];
    list.into_iter().filter_map(|(words, plot)| Some((words, plot?))).collect()
}

fn one(ui: &mut Ui, i: usize, plot: &mut PlotSettings, names: &[(String, Quantity)]) {
    let unit = plot.y.first().and_then(|y| names.iter().find(|(n, _)| n == y)).map(|(_, q)| q.unit());
    let mut gone = None;
    for (k, name) in plot.y.iter().enumerate() {
        ui.horizontal(|ui| {
            if plot.y.len() > 1 && ui.small_button("–").on_hover_text(text::REMOVE).clicked() {
                gone = Some(k);
            }
            let known = names.iter().any(|(n, _)| n == name);
            let words = if known { RichText::new(name) } else { RichText::new(name).strikethrough() };
            ui.add(egui::Label::new(words).truncate());
        });
    }
    if let Some(k) = gone {
        plot.y.remove(k);
    }
    ui.horizontal(|ui| {
        let table = format!("view.plot[{i}]");
        let place = Place { problems: None, table: &table };
        let curves = ui.menu_button(text::ADD_CURVE, |ui| {
            if let Some(name) = choose(ui, i, names.iter().filter(|(_, q)| unit.is_none_or(|u| q.unit() == u))) {
                if !plot.y.contains(&name) {
                    plot.y.push(name);
                }
                ui.close();
            }
        });
        mark(&curves.response, place, ("y", text::ADD_CURVE));
        ui.menu_button(text::CHANGE_CURVE, |ui| {
            if let Some(name) = choose(ui, i, names.iter()) {
                plot.y = vec![name];
                ui.close();
            }
        });
    });
    against(ui, i, plot, names);
}

fn against(ui: &mut Ui, i: usize, plot: &mut PlotSettings, names: &[(String, Quantity)]) {
    ui.horizontal(|ui| {
        let label = ui.label(text::AGAINST);
        let words = plot.x.clone().unwrap_or_else(|| text::TIME.to_owned());
        let table = format!("view.plot[{i}]");
        let place = Place { problems: None, table: &table };
        let combo = ComboBox::from_id_salt(("against", i)).width(150.0).selected_text(words).show_ui(ui, |ui| {
            ui.selectable_value(&mut plot.x, None, text::TIME);
            for (name, _) in names {
                ui.selectable_value(&mut plot.x, Some(name.clone()), name);
            }
        });
        mark(&combo.response.labelled_by(label.id), place, ("x", text::AGAINST));
    });
}

/// A name from a list that can be narrowed by typing.
fn choose<'a>(ui: &mut Ui, i: usize, names: impl Iterator<Item = &'a (String, Quantity)>) -> Option<String> {
    let id = egui::Id::unique(("narrow", i));
    let mut part = ui.data(|d| d.get_temp::<String>(id)).unwrap_or_default();
    ui.add(TextEdit::singleline(&mut part).hint_text(text::NARROW).desired_width(170.0));
    let mut chosen = None;
    ScrollArea::vertical().max_height(260.0).show(ui, |ui| {
        for (name, _) in names.filter(|(name, _)| name.contains(part.trim())) {
            if ui.button(name).clicked() {
                chosen = Some(name.clone());
            }
        }
    });
    ui.data_mut(|d| d.insert_temp(id, part));
    chosen
}
