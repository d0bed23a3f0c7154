//! All samples of a record as text, to be changed by hand.

use egui::{RichText, TextEdit, Ui};

use crate::app::field::{Named, Place, complain, tag};
use crate::app::text;

/// Most samples that are written out to be edited by hand.
const MOST_SAMPLES: usize = 2000;

/// Shows samples as text under a label, taken when the field is left; what is no number is said.
pub(super) fn show(ui: &mut Ui, place: Place<'_>, label: &str, list: &[f64]) -> Option<Vec<f64>> {
    if list.len() > MOST_SAMPLES {
        ui.label(RichText::new(text::TOO_MANY_SAMPLES).weak().small());
        return None;
    }
    let draft_id = egui::Id::unique(("samples draft", label));
    let written = || list.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
    let mut draft = ui.data(|d| d.get_temp::<String>(draft_id)).unwrap_or_else(written);
    let edit = TextEdit::multiline(&mut draft).desired_rows(3).desired_width(f32::INFINITY);
    let response = ui.add(edit);
    let response = tag(ui, &response, place, Named { key: "samples_m_s2", label });
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::MultilineTextInput, true, label));
    let words = || draft.split(|c: char| c.is_whitespace() || c == ';').filter(|word| !word.is_empty());
    let wrong = words().find(|word| word.parse::<f64>().is_err()).map(str::to_owned);
    if response.has_focus() {
        ui.data_mut(|d| d.insert_temp(draft_id, draft.clone()));
    } else if response.lost_focus() && wrong.is_none() {
        ui.data_mut(|d| d.remove::<String>(draft_id));
        let new: Vec<f64> = words().filter_map(|word| word.parse().ok()).collect();
        return Some(new).filter(|new| new != list);
    } else if wrong.is_none() {
        ui.data_mut(|d| d.remove::<String>(draft_id));
    }
    if let Some(wrong) = wrong {
        complain(ui, &format!("\u{201c}{wrong}\u{201d} {}", text::NO_SAMPLE));
    }
    if let Some(complaint) = place.complaint("samples_m_s2") {
        complain(ui, &complaint);
    }
    None
}
