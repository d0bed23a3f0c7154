//! How the view is looked at: the menu of views beyond the standing ones, and the slider of the exaggeration.

use egui::{Button, ScrollArea, Slider, Ui};

use crate::app::command::{AppearanceCommand, Command, Follow, Sight, ViewCommand};
use crate::app::edits::Document;
use crate::app::field::slider_row;
use crate::app::style::size::SCALES;
use crate::app::text;
use crate::app::viewport::scene_view::SceneView;
use crate::language::Language;
use crate::scene::Kind;
use crate::sim::OfSection;
use crate::view::{Bending, section_force};

/// Most girders that the menu offers to go with; of more only the one that is selected. Chosen.
const MOST_FOLLOWED: usize = 8;

/// Part of a window's height that the menu leaves for the bar above it \[points\].
const ABOVE: f32 = 36.0;

/// The menu of views beyond the standing ones; where it is higher than the window it scrolls.
pub(in crate::app) fn menu(ui: &mut Ui, view: &SceneView, document: &Document, out: &mut Vec<Command>) {
    let room = ui.content_rect().height() - ABOVE;
    // A menu has the room of a small window until it asks for more.
    ui.set_max_height(room);
    ScrollArea::vertical().max_height(room).show(ui, |ui| items(ui, view, document, out));
}

fn items(ui: &mut Ui, view: &SceneView, document: &Document, out: &mut Vec<Command>) {
    if ui.add_enabled(view.has_been_turned(), Button::new(text::VIEW_BACK).shortcut_text("V")).clicked() {
        out.push(ViewCommand::Back.into());
    }
    ui.separator();
    let sight = view.display.sight;
    let mut new = sight;
    ui.checkbox(&mut new.plan, text::PLAN_BESIDE);
    ui.checkbox(&mut new.section, text::GAP_SECTION);
    ui.checkbox(&mut new.lecture, text::LECTURE);
    ui.separator();
    bending(ui, &mut new.bent, document.scene().kind);
    ui.separator();
    ui.label(text::FOLLOW);
    let girder = document.girder_shown();
    let girders = &document.scene().girders;
    let name = girders.get(girder).map_or("", |g| g.name.as_str());
    ui.radio_value(&mut new.follow, None, text::FOLLOW_NOTHING);
    let all = girders.len() <= MOST_FOLLOWED;
    for (i, other) in girders.iter().enumerate().filter(|(i, _)| all || *i == girder) {
        ui.radio_value(&mut new.follow, Some(Follow::Middle(i)), text::follow(&other.name, None));
    }
    for corner in 0..4 {
        ui.radio_value(&mut new.follow, Some(Follow::Corner(girder, corner)), text::follow(name, Some(corner)));
    }
    ui.separator();
    ui.label(text::SIZE);
    ui.horizontal(|ui| {
        for (words, scale) in SCALES {
            if ui.add(Button::selectable(ui.zoom_factor() == scale, words)).clicked() {
                out.push(AppearanceCommand::Scale(scale).into());
            }
        }
    });
    ui.label(text::LANGUAGE);
    ui.horizontal(|ui| {
        for language in Language::ALL {
            if ui.add(Button::selectable(Language::current() == language, language.name())).clicked() {
                out.push(AppearanceCommand::Language(language).into());
            }
        }
    });
    if new != sight {
        out.push(ViewCommand::Sight(new).into());
    }
}

/// How girders that bend are drawn: as rigid ones, or bent, plain or coloured by a section force.
fn bending(ui: &mut Ui, bent: &mut Option<Bending>, kind: Kind) {
    let mut on = bent.is_some();
    if ui.checkbox(&mut on, text::BENT).changed() {
        *bent = on.then(Bending::default);
    }
    if let Some(bending) = bent {
        ui.radio_value(&mut bending.force, None, text::BENT_PLAIN);
        for (_, force) in OfSection::of(kind) {
            ui.radio_value(&mut bending.force, Some(force), section_force(force).as_str());
        }
    }
}

/// The slider of the exaggeration, in the panel of what is shown.
pub(in crate::app) fn exaggeration(ui: &mut Ui, sight: Sight, out: &mut Vec<Command>) {
    let mut factor = sight.exaggeration;
    let slider = Slider::new(&mut factor, 1.0..=100.0).logarithmic(true).prefix("× ").max_decimals(1);
    if slider_row(ui, text::EXAGGERATION.into(), slider, "").changed() {
        let factor = if factor.is_finite() { factor.clamp(1.0, 1000.0) } else { 1.0 };
        out.push(ViewCommand::Sight(Sight { exaggeration: factor, ..sight }).into());
    }
}
