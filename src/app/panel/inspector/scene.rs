//! The scene's own values: name, kind, time, gravity, tolerance; contact numbers of all pairs; pairs that are declared.

use egui::{Id, TextEdit, Ui};

use super::rows::{grid, push, section};
use super::{declared, stiffness};
use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::field::{CLICK, Change, Place, choice, number, tag};
use crate::app::unit::{GRAVITIES, PARTS, PURE, SECONDS};
use crate::app::{edits, text};
use crate::scene::edit::{Edit, General};
use crate::scene::facing::{self, DEFAULT_YOUNG_MODULUS};
use crate::scene::{ContactNumber, Kind, STANDARD_GRAVITY, Scene, SolverMethod};

const KINDS: [(Kind, &str); 2] = [(Kind::Planar, text::PLANAR), (Kind::Spatial, text::SPATIAL)];
const METHODS: [(SolverMethod, &str); 1] = [(SolverMethod::EventDriven, text::EVENT_DRIVEN)];

/// Shows what belongs to no body.
pub(super) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    section(ui, text::SCENE_SECTION, true, |ui| {
        general(ui, bench, out);
        solver(ui, bench, out);
    });
    section(ui, text::ALL_PAIRS_SECTION, false, |ui| contact(ui, bench, out));
    section(ui, text::DECLARED_SECTION, false, |ui| declared::show(ui, bench, out));
}

fn general(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let mut new = General::of(bench.scene());
    let place = Place { problems: bench.problems(), table: "" };
    let change = grid(ui, "scene", |ui| {
        let name = line(ui, place, ("name", text::NAME), &mut new.name);
        let about = line(ui, place, ("description", text::DESCRIPTION), &mut new.description);
        let kind = choice(ui, place, ("kind", text::KIND), &mut new.kind, &KINDS);
        let time = number(ui, place, ("duration_s", text::DURATION), &mut new.duration, SECONDS);
        let gravity = number(ui, place, ("gravity_m_s2", text::GRAVITY), &mut new.gravity, gravities());
        name.or(about).or(kind).or(time).or(gravity)
    });
    push(change, out, || Edit::General(Box::new(new)));
}

/// Metres a second squared, shown as multiples of g.
fn gravities() -> crate::app::unit::Unit {
    crate::app::unit::Unit { factor: 1.0 / STANDARD_GRAVITY, ..GRAVITIES }
}

fn solver(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let mut solver = bench.scene().solver;
    let place = Place { problems: bench.problems(), table: "solver" };
    let change = grid(ui, "solver", |ui| {
        let tolerance = number(ui, place, ("tolerance", text::TOLERANCE), &mut solver.tolerance, PARTS);
        tolerance.or(choice(ui, place, ("method", text::METHOD), &mut solver.method, &METHODS))
    });
    push(change, out, || Edit::Solver(solver));
}

/// Contact numbers of every pair that has none of its own.
fn contact(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    let scene = bench.scene();
    let mut new = scene.contact.clone();
    let place = Place { problems: bench.problems(), table: "contact" };
    let name = |words: &str| format!("{words} {}", text::OF_ALL);
    let change = grid(ui, "all pairs", |ui| {
        let mut numbers = None;
        for one in ContactNumber::ALL {
            let changed = number(ui, place, (one.key, &name(one.symbol)), (one.of_all)(&mut new), PURE);
            numbers = numbers.or(changed);
        }
        let given = stiffness::Given { k: &mut new.stiffness, e: &mut new.young_modulus, a: &mut new.area };
        let stiff = stiffness::rows(ui, place, text::OF_ALL, given, elastic(scene));
        let law = choice(ui, place, ("law", &name(text::LAW_SHORT)), &mut new.law, &stiffness::LAWS);
        let sharing = choice(ui, place, ("sharing", &name(text::SHARING)), &mut new.sharing, &stiffness::SHARINGS);
        let tension = choice(ui, place, ("tension", &name(text::TENSION)), &mut new.tension, &stiffness::TENSIONS);
        numbers.or(stiff).or(law).or(sharing).or(tension)
    });
    push(change, out, || edits::contact(new));
}

/// K = E A / L and A of the first pair's girder, shown where the scene gives none \[N/m, m²\].
fn elastic(scene: &Scene) -> (f64, Option<f64>) {
    let Some(girder) = scene.girders.first() else { return (0.0, None) };
    let area = girder.width * girder.thickness;
    let (e, a) = (scene.contact.young_modulus, scene.contact.area);
    let k = e.unwrap_or(DEFAULT_YOUNG_MODULUS) * a.unwrap_or(area) / girder.length;
    let pair = facing::find(scene).ok().and_then(|pairs| pairs.first().map(|p| p.contact.stiffness));
    (pair.filter(|_| scene.contact.stiffness.is_none()).unwrap_or(k), Some(area))
}

/// A line of text, given when the field is left.
fn line(ui: &mut Ui, place: Place<'_>, (key, label): (&str, &str), value: &mut String) -> Option<Change> {
    let name = ui.label(label);
    let draft_id = Id::unique(("draft", key));
    let mut draft = ui.data(|d| d.get_temp::<String>(draft_id)).unwrap_or_else(|| value.clone());
    let response = ui.add(TextEdit::singleline(&mut draft).desired_width(104.0)).labelled_by(name.id);
    let response = tag(ui, &response, place, (key, label));
    ui.end_row();
    if response.has_focus() {
        ui.data_mut(|d| d.insert_temp(draft_id, draft));
        return None;
    }
    ui.data_mut(|d| d.remove::<String>(draft_id));
    if response.lost_focus() && draft != *value {
        *value = draft;
        return CLICK;
    }
    None
}
