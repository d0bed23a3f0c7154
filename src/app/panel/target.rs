//! The spectrum that a synthetic earthquake is matched to: periods and accelerations.

use egui::{CollapsingHeader, Grid, RichText, Ui};

use crate::app::field::{CLICK, Change, Named, Place, act, number};
use crate::app::text;
use crate::app::unit::{GRAVITIES, SECONDS};
use crate::scene::{STANDARD_GRAVITY, SyntheticMotion};
use crate::study::ground::psa;

/// Periods that a target begins with \[s\].
const PERIODS: [f64; 6] = [0.1, 0.2, 0.5, 1.0, 2.0, 4.0];

/// Shows the target, or the way to have one.
pub(super) fn show(ui: &mut Ui, place: Place<'_>, quake: &mut SyntheticMotion) -> Option<Change> {
    let folded =
        CollapsingHeader::new(text::TARGET_FOLD).id_salt(text::TARGET_FOLD.key()).default_open(quake.target.is_some());
    folded.show_unindented(ui, |ui| target(ui, place, quake)).body_returned.flatten()
}

fn target(ui: &mut Ui, place: Place<'_>, quake: &mut SyntheticMotion) -> Option<Change> {
    let Some(points) = &mut quake.target else {
        ui.label(RichText::new(text::TARGET_NONE).weak().small());
        if !act(ui, place, "target_psa_g", text::TARGET_ADD.as_str()) {
            return None;
        }
        quake.target = Some(own(quake));
        return CLICK;
    };
    let (mut change, mut gone) = (None, None);
    Grid::new("target").num_columns(2).spacing([8.0, 3.0]).show(ui, |ui| {
        for (n, [period, acceleration]) in points.iter_mut().enumerate() {
            let [name, psa, remove] = text::target(n + 1);
            change = change.or(number(ui, place, Named { key: "target_psa_g", label: &name }, period, SECONDS));
            change = change.or(number(ui, place, Named { key: "target_psa_g", label: &psa }, acceleration, GRAVITIES));
            ui.label("");
            if ui.small_button(remove).clicked() {
                gone = Some(n);
            }
            ui.end_row();
        }
    });
    if let Some(n) = gone.filter(|_| points.len() > 2) {
        points.remove(n);
        change = CLICK;
    }
    if act(ui, place, "target_psa_g", text::TARGET_POINT.as_str()) {
        let last = points.last().copied().unwrap_or([0.5, 0.1]);
        points.push([2.0 * last[0], last[1]]);
        change = CLICK;
    }
    if act(ui, place, "target_psa_g", text::TARGET_REMOVE.as_str()) {
        quake.target = None;
        change = CLICK;
    }
    change
}

/// The spectrum that the earthquake has by itself, to three digits.
fn own(quake: &SyntheticMotion) -> Vec<[f64; 2]> {
    let samples = quake.samples(0);
    let digits = |value: f64| format!("{value:.2e}").parse().unwrap_or(value);
    PERIODS.map(|period| [period, digits(psa(&samples, quake.dt, period) / STANDARD_GRAVITY)]).to_vec()
}
