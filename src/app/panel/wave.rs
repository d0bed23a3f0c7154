//! How the motion of the ground travels along the bridge.

use egui::Ui;

use crate::app::command::{Command, EditCommand};
use crate::app::field::{CLICK, Form, sliders};
use crate::app::{edits, text};
use crate::scene::Wave;
use crate::scene::edit::Edit;

/// Shows speed and direction, or the way to let it travel.
pub(super) fn show(ui: &mut Ui, form: Form<'_>, out: &mut Vec<Command>) {
    let look = form.look("wave");
    let mut new = form.scene.wave;
    let change = match &mut new {
        None => ui.button(text::WAVE_ADD).clicked().then(|| new = Some(Wave::default())).and(CLICK),
        Some(wave) => {
            let moved = sliders(ui, &look, wave, &[]);
            if ui.button(text::WAVE_REMOVE).clicked() {
                new = None;
                CLICK
            } else {
                moved
            }
        }
    };
    let Some(change) = change else { return };
    let edit = if form.scene.wave.is_none() { edits::wave_assumed(form.scene, new) } else { Edit::Wave(new) };
    out.push(EditCommand::Change { edit, gesture: change.gesture }.into());
}
