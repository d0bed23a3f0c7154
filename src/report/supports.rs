//! Tables of what a run did to bearings, to piers and to the soil behind backwalls.

use std::fmt::Write as _;

use super::sections::{at, carried_from, head, marked, row, sign_told};
use super::units::force;
use crate::language::{Text, said};
use crate::tables::{BackfillReport, Report};

/// Girders whose bearings are listed; `summary.json` has all.
const MOST_LISTED: usize = 40;

/// Largest movement and force of the bearings of every girder; nothing of a scene without bearings.
pub(super) fn bearings(report: &Report) -> String {
    if report.bearings.is_empty() {
        return String::new();
    }
    let mut html = head(&[
        Text::new("report-bearings-under").as_str(),
        &Text::new("report-bearing-moves"),
        &Text::new("report-bearing-force"),
    ]);
    let carried = carried_from(report);
    let at = |value: String, t: f64| marked(at(value, t), Some(t), carried);
    for of in report.bearings.iter().take(MOST_LISTED) {
        let which = |number: usize, value: String| said!("report-of-bearing", "value" => value, "number" => number);
        let numbers = [
            at(which(of.bearing, format!("{:.1}", 1e3 * of.deformation)), of.t),
            at(which(of.force_bearing, force(of.force)), of.force_t),
        ];
        html.push_str(&row(&of.girder, &numbers));
    }
    let told = sign_told(&html, carried);
    html.push_str("</table>\n");
    html.push_str(&told);
    let more = report.bearings.len().saturating_sub(MOST_LISTED);
    if more > 0 {
        let _ = writeln!(html, "<p>{}</p>", said!("report-girders-more", "more" => more));
    }
    html
}

/// Period, drift, base shear and moment, yield of every pier; nothing of a scene without piers.
pub(super) fn piers(report: &Report) -> String {
    if report.piers.is_empty() {
        return String::new();
    }
    let mut html = head(&[
        Text::new("report-pier").as_str(),
        &Text::new("report-pier-periods"),
        &Text::new("report-pier-drift"),
        &Text::new("report-pier-shear"),
        &Text::new("report-pier-moment"),
        &Text::new("report-pier-yields"),
        &Text::new("report-pier-ductility"),
        &Text::new("report-pier-residual"),
        &Text::new("report-pier-second-order"),
    ]);
    for pier in &report.piers {
        let yielded = pier.yielded_at.map_or("–".to_owned(), |t| format!("{t:.3}"));
        let [along, across] = pier.periods;
        let residual = pier.residual_drift.filter(|_| pier.yielded_at.is_some());
        let numbers = [
            format!("{along:.3}, {across:.3}"),
            at(format!("{:.1}", 1e3 * pier.drift), pier.drift_t),
            at(force(pier.shear), pier.shear_t),
            format!("{:.2}", pier.moment / 1e6),
            yielded,
            pier.ductility_words().unwrap_or_else(|| "–".to_owned()),
            residual.map_or("–".to_owned(), |[x, y]| format!("{:.1}, {:.1}", 1e3 * x, 1e3 * y)),
            pier.second_order.map_or("–".to_owned(), |share| format!("{:.1} %", 100.0 * share)),
        ];
        html.push_str(&row(&pier.name, &numbers));
    }
    html + "</table>\n"
}

/// Push, resistance and the gap that stays of the soil behind every backwall; nothing of a scene without.
pub(super) fn soils(report: &Report) -> String {
    if report.backfill.is_empty() {
        return String::new();
    }
    let mut html = head(&[
        Text::new("report-soil").as_str(),
        &Text::new("report-soil-push"),
        &Text::new("report-soil-force"),
        &Text::new("report-soil-part"),
        &Text::new("report-soil-gap"),
    ]);
    for soil in &report.backfill {
        let numbers = [
            at(format!("{:.1}", 1e3 * soil.push), soil.t),
            force(soil.force),
            format!("{:.0} %", 100.0 * soil.force / soil.ultimate),
            format!("{:.1}", 1e3 * soil.remaining_gap),
        ];
        html.push_str(&row(&soil.abutment, &numbers));
    }
    html.push_str("</table>\n");
    if report.backfill.iter().any(BackfillReport::is_beyond) {
        let _ = writeln!(html, "<p>{}</p>", Text::new("soil-beyond"));
    }
    html
}
