//! How far a sweep in the background has come, what stopped it, whether it is the scene's as that is now.

use egui::{ProgressBar, RichText, Ui};

use super::background::{Asked, Background};
use crate::app::command::Command;
use crate::app::field::complain;
use crate::app::style::theme::Palette;
use crate::app::text::{self, Sweeping};

/// Shows it, with what computes it again and what stops it.
pub(super) fn show<D: Asked>(
    ui: &mut Ui,
    background: &Background<D>,
    words: &Sweeping,
    [again, cancel]: [Command; 2],
    out: &mut Vec<Command>,
) {
    ui.horizontal(|ui| {
        if let Some([done, all]) = background.progress() {
            let words_of = text::runs_of(done, all);
            ui.add(ProgressBar::new(done as f32 / all.max(1) as f32).desired_width(220.0).text(words_of));
            if ui.button(words.stop).clicked() {
                out.push(cancel);
            }
            return;
        }
        let Some(swept) = background.swept() else { return };
        let [done, all] = [swept.rows.len(), swept.plan.runs()];
        ui.label(RichText::new(text::runs_of(done, all)).weak());
        if done < all || !background.fits() {
            let why = if background.fits() { text::SWEEP_STOPPED } else { text::SWEEP_OF_OLD };
            ui.label(RichText::new(why).color(Palette::of(ui).problem));
            if ui.button(words.again).clicked() {
                out.push(again);
            }
        }
    });
    for error in background.problems().iter().flat_map(|errors| &errors.0) {
        complain(ui, &error.to_string());
    }
}
