//! Tables of what a run did to piers and to the soil behind backwalls.

use std::fmt::Write as _;

use super::sections::{at, head, row};
use super::units::force;
use crate::language::Text;
use crate::tables::{BackfillReport, Report};

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
    ]);
    for pier in &report.piers {
        let yielded = pier.yielded_at.map_or("–".to_owned(), |t| format!("{t:.3}"));
        let [along, across] = pier.periods;
        let numbers = [
            format!("{along:.3}, {across:.3}"),
            at(format!("{:.1}", 1e3 * pier.drift), pier.drift_t),
            at(force(pier.shear), pier.shear_t),
            format!("{:.2}", pier.moment / 1e6),
            yielded,
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
