//! The map's window: keys and measure above, how far it has come, the map itself.

use egui::{ComboBox, Grid, Id, RichText, Ui, Window, vec2};

use super::maps::Maps;
use super::{field, offer, progress};
use crate::app::command::{Command, MapAxis, MapCommand, MapDraft};
use crate::app::field::{Named, Place, narrowed, number};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::language::Text;
use crate::scene::Scene;
use crate::scene::keys::of_place;
use crate::scene::overrides::Laid;
use crate::study::sweep::MEASURES;

/// How many values of a key a map may have: powers of two and one, so that each grid lies in the next.
const CELLS: [usize; 4] = [9, 17, 33, 65];

/// A measure's name in words.
fn in_words(measure: &str) -> &str {
    MEASURES.iter().find(|known| known.name == measure).map_or(measure, |known| known.label.as_str())
}

/// Shows the window while it is open.
pub(in crate::app) fn show(ui: &mut Ui, maps: &Maps, scene: &Scene, out: &mut Vec<Command>) {
    let Some(draft) = maps.draft() else { return };
    let mut open = true;
    let room = ui.content_rect();
    let window = Window::new(text::MAP).id(Id::unique("map")).open(&mut open);
    let window =
        window.default_pos(room.left_top() + vec2(270.0, 40.0)).default_size([470.0, 500.0]).min_size([380.0, 380.0]);
    window.show(ui, |ui| {
        let mut new = draft.clone();
        above(ui, scene, &mut new);
        if new != *draft {
            out.push(MapCommand::Draft(new).into());
        } else if maps.is_due() && !ui.input(|input| input.pointer.any_down()) {
            out.push(MapCommand::Compute.into());
        }
        let [again, cancel] = [MapCommand::Compute, MapCommand::Cancel].map(Command::from);
        progress::show(ui, &maps.background, &text::OF_A_MAP, [again, cancel], out);
        if let Some(map) = maps.map() {
            below(ui);
            field::show(ui, maps, map, scene, out);
        }
    });
    if !open {
        out.push(MapCommand::Show(false).into());
    }
}

/// Both keys, the measure, the number of values.
fn above(ui: &mut Ui, scene: &Scene, draft: &mut MapDraft) {
    Grid::new("map axes").num_columns(5).spacing([6.0, 4.0]).show(ui, |ui| {
        for (axis, names) in draft.axes.iter_mut().zip([text::MAP_ACROSS, text::MAP_UP]) {
            key(ui, scene, axis, names.map(Text::as_str));
            ui.end_row();
        }
    });
    ui.horizontal(|ui| {
        let label = ui.label(text::MAP_MEASURE);
        let combo = ComboBox::from_id_salt("map measure").width(130.0).selected_text(in_words(draft.measure));
        let combo = combo.show_ui(ui, |ui| {
            for measure in MEASURES {
                ui.selectable_value(&mut draft.measure, measure.name, measure.label.as_str())
                    .on_hover_text(measure.meaning);
            }
        });
        combo.response.labelled_by(label.id);
        let label = ui.label(text::MAP_CELLS);
        let words = |cells: usize| format!("{cells} × {cells}");
        let combo =
            ComboBox::from_id_salt("map cells").width(72.0).selected_text(words(draft.cells)).show_ui(ui, |ui| {
                for cells in CELLS {
                    ui.selectable_value(&mut draft.cells, cells, words(cells));
                }
            });
        combo.response.labelled_by(label.id);
    });
}

/// A key and its stretch.
fn key(ui: &mut Ui, scene: &Scene, axis: &mut MapAxis, [name, from, to, log]: [&str; 4]) {
    ui.label(name);
    let title = RichText::new(text::title_of(&axis.key));
    let menu = narrowed(ui, title, (Id::unique(("narrow keys", name)), 240.0), |ui, part| choose(ui, scene, part));
    if let Some((key, laid)) = menu.inner.zip(Laid::out(scene).ok()) {
        *axis = offer::axis(&laid, &key);
    }
    menu.response.on_hover_text(format!("{}: {}", axis.key, meaning(&axis.key)));
    let unit = offer::unit(scene, &axis.key, axis.from.abs().max(axis.to.abs()));
    let place = Place::apart("");
    for (words, value) in [(from, &mut axis.from), (to, &mut axis.to)] {
        let mut shown = *value;
        Grid::new(words)
            .num_columns(2)
            .spacing([4.0, 0.0])
            .show(ui, |ui| number(ui, place, Named { key: "", label: words }, &mut shown, unit));
        *value = shown;
    }
    ui.checkbox(&mut axis.is_log, text::MAP_LOG).on_hover_text(log);
}

fn meaning(path: &str) -> &'static str {
    of_place(path).map_or("", |(_, key)| key.meaning_told())
}

/// A key from a list, of those whose path or title has these letters.
fn choose(ui: &mut Ui, scene: &Scene, part: &str) -> Option<String> {
    let (mut chosen, words) = (None, part.to_lowercase());
    for key in offer::keys(scene) {
        let title = text::title_of(&key);
        if !key.contains(&words) && !title.to_lowercase().contains(&words) {
            continue;
        }
        let button = egui::Button::new(title).right_text(RichText::new(&key).weak().small());
        if ui.add(button).on_hover_text(meaning(&key)).clicked() {
            chosen = Some(key);
        }
    }
    chosen
}

/// Legend.
fn below(ui: &mut Ui) {
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(16.0, 16.0), egui::Sense::hover());
        field::ring(ui.painter(), rect.center());
        ui.label(RichText::new(text::MAP_SCENE).weak().small());
        let (rect, _) = ui.allocate_exact_size(vec2(12.0, 12.0), egui::Sense::hover());
        ui.painter().rect_filled(rect, 0.0, Palette::of(ui).line);
        ui.label(RichText::new(text::MAP_EMPTY).weak().small());
        ui.label(RichText::new(text::MAP_HINT).weak().small());
    });
}
