//! Each facing pair's contact numbers in force, where each comes from, and numbers of its own.

use egui::{RichText, Ui};

use super::rows::{grid, section};
use crate::app::command::{Command, EditCommand, SelectCommand};
use crate::app::edits;
use crate::app::field::{Form, Look, Without, rows};
use crate::app::run::answer::Answer;
use crate::app::text;
use crate::app::unit::{Size, unit_of};
use crate::language::Text;
use crate::scene::facing::{self, Facing};
use crate::scene::keys::Key;
use crate::scene::{ContactNumber, ContactSettings, PairSettings, Scene};
use crate::view::Target;

/// Most pairs shown at once: beyond that one girder is selected to see its own.
const MOST_PAIRS: usize = 40;

/// Shows the pairs of one body, or all, with the scene's answer where there is one.
pub(super) fn show(ui: &mut Ui, form: Form<'_>, answer: Option<&Answer>, of: Option<&str>, out: &mut Vec<Command>) {
    let scene = form.scene;
    let pairs = facing::find(scene).unwrap_or_default();
    let ours: Vec<&Facing> =
        pairs.iter().filter(|p| of.is_none_or(|name| edits::names_of(scene, p).contains(&name))).collect();
    if ours.is_empty() {
        return;
    }
    section(ui, (text::PAIRS_SECTION.key(), &text::PAIRS_SECTION), true, |ui| {
        for pair in ours.iter().take(MOST_PAIRS) {
            let title = format!("{} {}", text::PAIR, pair.name);
            section(ui, (&pair.name, &title), ours.len() == 1, |ui| one(ui, form, answer, pair, out));
        }
        if ours.len() > MOST_PAIRS {
            ui.label(RichText::new(text::more(ours.len() - MOST_PAIRS)).weak());
        }
    });
}

fn one(ui: &mut Ui, form: Form<'_>, answer: Option<&Answer>, pair: &Facing, out: &mut Vec<Command>) {
    let scene = form.scene;
    in_force(ui, scene, answer, pair);
    contacts(ui, answer, pair, out);
    let entry = edits::pair_entry(scene, pair);
    let mut own = entry.map_or_else(|| edits::new_pair(scene, pair), |n| scene.contact.pairs[n].clone());
    let table = entry.map_or_else(|| "contact.pair".to_owned(), |n| format!("contact.pair[{n}]"));
    let under = |key: &Key| number_under(scene, pair, key.name);
    let look = Look { whose: text::WHOSE_PAIR.as_str(), without: Without::Under(&under), ..form.look(&table) };
    // Pairs without an entry have no place of their own in the file that could tell their lists apart.
    let own_id = ("pair", &pair.name);
    let own_rows = |ui: &mut Ui| rows(ui, &look, &mut own, &["between", "ends"]);
    let change = ui.push_id(own_id, |ui| grid(ui, "own", own_rows)).inner;
    if let Some(change) = change {
        out.push(
            EditCommand::Change { edit: edits::contact(with_pair(scene, entry, own)), gesture: change.gesture }.into(),
        );
    }
    if let Some(n) = entry
        && ui.small_button(text::PAIR_RESET).on_hover_text(text::PAIR_RESET_HINT).clicked()
    {
        let mut contact = scene.contact.clone();
        contact.pairs.remove(n);
        out.push(EditCommand::Change { edit: edits::contact(contact), gesture: None }.into());
    }
}

/// A number in force for a pair, or what K follows from, by its key.
fn number_under(scene: &Scene, pair: &Facing, key: &str) -> f64 {
    let number = ContactNumber::ALL.iter().find(|number| number.key == key);
    let number = number.map(|number| (number.in_force)(&pair.contact));
    number.or_else(|| edits::optional(pair, key)).unwrap_or_else(|| edits::elastic(scene, key))
}

/// The pair's contacts, to be selected without having to hit them in the view.
fn contacts(ui: &mut Ui, answer: Option<&Answer>, pair: &Facing, out: &mut Vec<Command>) {
    let Some(answer) = answer else { return };
    let model = answer.history.model();
    let Some(run) = model.pairs.iter().find(|p| p.name == pair.name) else { return };
    ui.horizontal_wrapped(|ui| {
        for contact in run.sites.clone().take(MOST_PAIRS) {
            let name = format!("{} | {}", model.sites[contact].node_in_words(), model.sites[contact].face_name);
            if ui.small_button(name).on_hover_text(text::CONTACTS_OF_PAIR).clicked() {
                out.push(SelectCommand::Only(Some(Target::Contact(contact))).into());
            }
        }
    });
}

fn with_pair(scene: &Scene, entry: Option<usize>, own: PairSettings) -> ContactSettings {
    let mut contact = scene.contact.clone();
    match entry {
        Some(n) => contact.pairs[n] = own,
        None => contact.pairs.push(own),
    }
    contact
}

/// Every number of the pair, with where it comes from.
fn in_force(ui: &mut Ui, scene: &Scene, answer: Option<&Answer>, pair: &Facing) {
    let c = &pair.contact;
    let mut own = edits::pair_entry(scene, pair).map(|n| scene.contact.pairs[n].clone());
    let stiffness_from = match (&own, scene.contact.stiffness) {
        (Some(p), _) if p.stiffness.is_some() => text::FROM_PAIR,
        (Some(p), _) if p.young_modulus.is_some() || p.area.is_some() => text::FROM_EA_L,
        (_, Some(_)) => text::FROM_SCENE,
        _ => text::FROM_EA_L,
    };
    let dashpots = answer.and_then(|a| a.history.model().pairs.iter().find(|p| p.name == pair.name));
    let mut rows = vec![("K", text::stiffness(c.stiffness), stiffness_from)];
    if let Some(p) = dashpots {
        // The dashpot of a Hertz spring is 0 where the touch begins.
        let normal = p.law.dashpots().normal;
        if p.is_damped_by_65() || normal > 0.0 {
            let source = if p.is_damped_by_65() { text::FROM_65 } else { text::FROM_NORMAL_LAW };
            rows.push(("C n", text::damping(normal), source));
        }
        rows.push(("C t", text::damping(p.law.dashpots().tangential), text::FROM_65));
        rows.push((text::RETURNED_E.as_str(), text::short(p.returned_restitution()), text::FROM_NORMAL_LAW));
    }
    for one in ContactNumber::ALL {
        let given = own.as_mut().is_some_and(|pair| (one.of_pair)(pair).is_some());
        let source = if given { text::FROM_PAIR } else { text::FROM_SCENE };
        let value = (one.in_force)(c);
        let unit = unit_of(&format!("contact.{}", one.key), value, Size::of_scene(scene));
        rows.push((Text::new(one.label).as_str(), unit.words(value), source));
    }
    rows.push((Text::new("field-gap").as_str(), text::exact_length(pair.gap), text::FROM_PLACES));
    egui::Grid::new(("in force", &pair.name)).num_columns(3).striped(true).spacing([8.0, 2.0]).show(ui, |ui| {
        for (name, value, source) in rows {
            ui.label(RichText::new(name).weak());
            ui.label(value);
            ui.label(RichText::new(source).weak().small());
            ui.end_row();
        }
    });
}
