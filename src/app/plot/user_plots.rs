//! Plot panels that the user has made: any quantity against time or against another; saved with the scene.

use egui::{ComboBox, Id, RichText, Ui};

use crate::app::command::{Command, EditCommand, FileCommand, WindowCommand, Wish};
use crate::app::field::{Named, Place, mark, narrowed, tag};
use crate::app::plot::plot_files;
use crate::app::plot::source::Source;
use crate::app::text;
use crate::scene::edit::Edit;
use crate::scene::{PlotSettings, PlotShows, ViewSettings};
use crate::sim::quantity::{OfBearing, OfContact, OfCorner, OfEnergy, OfGirder, OfLink, Quantity};

/// Most panels of the user's own.
const MOST_PANELS: usize = 6;

/// Shows the list of panels and lets it be changed.
pub(in crate::app) fn show(ui: &mut Ui, source: &Source<'_>, out: &mut Vec<Command>) {
    let Some(answer) = source.answer else { return };
    let names = answer.quantities();
    let mut plots = source.scene.view.plots.clone();
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
        ui.add_enabled_ui(plots.len() < MOST_PANELS, |ui| {
            let adding = ui.menu_button(text::ADD_PANEL, |ui| {
                for (words, plot) in offers(names, source.girder) {
                    if ui.button(words).clicked() {
                        plots.push(plot);
                        ui.close();
                    }
                }
            });
            let place = Place::apart("view");
            mark(&adding.response, place, Named { key: "plot", label: text::ADD_PANEL.as_str() });
        });
        ui.menu_button(text::EXPORT_PLOTS, |ui| {
            if ui.button(text::COPY_PLOTS).clicked() {
                match plot_files::picture(source) {
                    Ok(image) => ui.copy_image(image),
                    Err(problem) => out.push(WindowCommand::Say(problem).into()),
                }
                ui.close();
            }
            for (words, format) in [("SVG…", "svg"), ("PNG…", "png"), ("CSV…", "csv")] {
                if ui.button(words).clicked() {
                    out.push(FileCommand::Ask(Wish::Plots(format)).into());
                    ui.close();
                }
            }
        });
    });
    if plots != source.scene.view.plots {
        let view = ViewSettings { plots, ..source.scene.view.clone() };
        out.push(EditCommand::Change { edit: Edit::View(view), gesture: None }.into());
    }
}

/// Panels that are often wanted.
fn offers(names: &[(String, Quantity)], girder: usize) -> Vec<(&'static str, PlotSettings)> {
    let over_time = |y: String| PlotSettings::over_time(vec![y]);
    let first =
        |wanted: &dyn Fn(&Quantity) -> bool| names.iter().find(|(_, q)| wanted(q)).map(|(name, _)| name.clone());
    let of_girder =
        |wanted: OfGirder| first(&|q| matches!(q, Quantity::Girder(i, of) if *i == girder && *of == wanted));
    let corner =
        |wanted: OfCorner| first(&|q| matches!(q, Quantity::Corner(i, 1, of) if *i == girder && *of == wanted));
    let contact = |wanted: OfContact| first(&|q| matches!(q, Quantity::Contact(_, of) if *of == wanted));
    let against = |x: Option<String>, y: Option<String>| Some(PlotSettings { x: Some(x?), ..over_time(y?) });
    let spectrum = |shows, y: Option<String>| Some(PlotSettings { shows, log: true, ..over_time(y?) });
    let energies: Vec<String> = names
        .iter()
        .filter(|(_, q)| matches!(q, Quantity::Energy(of) if !matches!(of, OfEnergy::Work | OfEnergy::Residual)))
        .map(|(name, _)| name.clone())
        .collect();
    let of_link = |wanted: OfLink| first(&|q| matches!(q, Quantity::Link(_, of) if *of == wanted));
    let of_bearing =
        |wanted: OfBearing| first(&|q| matches!(q, Quantity::Bearing(i, 0, of) if *i == girder && *of == wanted));
    let list = [
        (text::OFFER_ENERGY, Some(PlotSettings::over_time(energies))),
        (text::OFFER_DRIFT, corner(OfCorner::Drift).map(over_time)),
        (text::OFFER_ORBIT, against(corner(OfCorner::X), corner(OfCorner::Y))),
        (text::OFFER_PENETRATION, against(contact(OfContact::Penetration), contact(OfContact::Force))),
        (text::OFFER_HYSTERESIS, against(of_girder(OfGirder::Y), contact(OfContact::Tangential))),
        (text::OFFER_LOOP_DEVICE, against(of_link(OfLink::Deformation), of_link(OfLink::Force))),
        (text::OFFER_LOOP_BEARING, against(of_bearing(OfBearing::Deformation(0)), of_bearing(OfBearing::Force(0)))),
        (text::OFFER_USE, contact(OfContact::Use).map(over_time)),
        (text::OFFER_FOURIER, spectrum(PlotShows::Fourier, of_girder(OfGirder::Vx))),
        (text::OFFER_RESPONSE, spectrum(PlotShows::Response, first(&|q| matches!(q, Quantity::Ground(0))))),
        (text::OFFER_EMPTY, of_girder(OfGirder::X).map(over_time)),
    ];
    list.into_iter().filter_map(|(words, plot)| Some((words.as_str(), plot?))).collect()
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
        let place = Place::apart(&table);
        let alike = names.iter().filter(|(_, q)| unit.is_none_or(|u| q.unit() == u));
        let curves =
            narrowed(ui, text::ADD_CURVE, (Id::unique(("more", i)), 170.0), |ui, part| choose(ui, part, alike));
        plot.y.extend(curves.inner.filter(|name| !plot.y.contains(name)));
        mark(&curves.response, place, Named { key: "y", label: text::ADD_CURVE.as_str() });
        let other = (Id::unique(("other", i)), 170.0);
        if let Some(name) = narrowed(ui, text::CHANGE_CURVE, other, |ui, part| choose(ui, part, names.iter())).inner {
            plot.y = vec![name];
        }
    });
    if plot.shows == PlotShows::History {
        against(ui, i, plot, names);
    }
    shows(ui, i, plot);
}

/// Whether their course is shown or a spectrum, and on what axis.
fn shows(ui: &mut Ui, i: usize, plot: &mut PlotSettings) {
    let table = format!("view.plot[{i}]");
    let place = Place::apart(&table);
    ui.horizontal(|ui| {
        let label = ui.label(text::SHOWS);
        let words = |shows: PlotShows| text::SHOWN[shows as usize];
        let combo =
            ComboBox::from_id_salt(("shows", i)).width(150.0).selected_text(words(plot.shows)).show_ui(ui, |ui| {
                for shows in PlotShows::ALL {
                    ui.selectable_value(&mut plot.shows, *shows, words(*shows));
                }
            });
        tag(ui, &combo.response.labelled_by(label.id), place, Named { key: "shows", label: text::SHOWS.as_str() });
    });
    let response = ui.checkbox(&mut plot.log, text::LOG);
    tag(ui, &response, place, Named { key: "log", label: text::LOG.as_str() });
}

fn against(ui: &mut Ui, i: usize, plot: &mut PlotSettings, names: &[(String, Quantity)]) {
    ui.horizontal(|ui| {
        let label = ui.label(text::AGAINST);
        let words = plot.x.clone().unwrap_or_else(|| text::TIME.to_string());
        let table = format!("view.plot[{i}]");
        let place = Place::apart(&table);
        let combo = ComboBox::from_id_salt(("against", i)).width(150.0).selected_text(words).show_ui(ui, |ui| {
            ui.selectable_value(&mut plot.x, None, text::TIME);
            for (name, _) in names {
                ui.selectable_value(&mut plot.x, Some(name.clone()), name);
            }
        });
        mark(&combo.response.labelled_by(label.id), place, Named { key: "x", label: text::AGAINST.as_str() });
    });
}

/// A name from a list, of those that have these letters.
fn choose<'a>(ui: &mut Ui, part: &str, names: impl Iterator<Item = &'a (String, Quantity)>) -> Option<String> {
    let mut chosen = None;
    for (name, _) in names.filter(|(name, _)| name.contains(part)) {
        if ui.button(name).clicked() {
            chosen = Some(name.clone());
        }
    }
    chosen
}
