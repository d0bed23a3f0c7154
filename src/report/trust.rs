//! How far to trust a report: where the answer does not hold, error, energies, versions and digest.

use super::bending;
use super::plan::trimmed;
use super::sections::{fact, facts};
use super::units::force;
use crate::language::{Text, said};
use crate::plot::draw::escape;
use crate::tables::{BackfillReport, PierReport, Report};

/// Part of the largest energy below which springs that contacts left do not head the page in alarm \[–\]. Chosen: a displacement differs
/// by its root at the most, 3 %.
const SMALL_SHARE: f64 = 1e-3;

/// Where the answer does not hold or a designer must look, a line each: girders that bend beyond their model, bearings that lift or pull,
/// bodies inside each other without a contact, contacts beyond the sense of their law, contacts that went on without friction.
pub(super) fn departures(report: &Report) -> String {
    let millimetres = |metres: f64| format!("{:.3} mm", 1e3 * metres);
    let time = |t: f64| format!("{t:.4}");
    let overlaps = report.overlaps.iter().map(|overlap| {
        let [one, other] = overlap.bodies.each_ref().map(String::as_str);
        let (depth, t) = (millimetres(overlap.depth), time(overlap.deepest_at));
        said!("overlaps", "one" => one, "other" => other, "depth" => depth, "t" => t)
    });
    let deep = report.too_deep.iter().map(|deep| {
        let (node, face) = (deep.node.as_str(), deep.face.as_str());
        let [depth, allowed] = [deep.depth, deep.allowed].map(millimetres);
        said!("too-deep", "node" => node, "face" => face, "depth" => depth, "t" => time(deep.t), "allowed" => allowed)
    });
    let dropped = report.dropped.iter().map(|dropped| {
        let (node, face, share) = (dropped.node.as_str(), dropped.face.as_str(), trimmed(100.0 * dropped.share));
        said!("dropped", "node" => node, "face" => face, "t" => time(dropped.t), "share" => share)
    });
    let uplifts = report.uplifts.iter().map(|uplift| {
        let (bearing, t) = (uplift.bearing.as_str(), time(uplift.t));
        let pull = force(uplift.pull);
        match (uplift.pull > 0.0, uplift.lifts) {
            (false, _) => said!("bearing-lifts", "bearing" => bearing, "t" => t),
            (true, true) => said!("bearing-damped", "bearing" => bearing, "t" => t, "pull" => pull),
            (true, false) => said!("bearing-pulls", "bearing" => bearing, "t" => t, "pull" => pull),
        }
    });
    let lost = report
        .lost_supports
        .iter()
        .map(|lost| said!("report-lost", "bearing" => lost.bearing.as_str(), "t" => time(lost.t)));
    // What no other contact took over and is too little to be seen is said, and does not alarm.
    let class = |share: f64| if share < SMALL_SHARE { "" } else { " class=\"no\"" };
    let dropped = dropped.zip(report.dropped.iter().map(|dropped| class(dropped.share)));
    let dropped = dropped.map(|(words, class)| format!("<p{class}>{}</p>\n", escape(&words)));
    let line = |words: String| format!("<p class=\"no\">{}</p>\n", escape(&words));
    bending::departures(report)
        .chain(report.uncertain())
        .chain(report.without_friction.clone())
        .chain(report.backfill.iter().filter_map(BackfillReport::fails))
        .chain(report.piers.iter().filter_map(PierReport::second_order_counts))
        .chain(lost)
        .chain(uplifts)
        .chain(overlaps)
        .chain(deep)
        .map(line)
        .chain(dropped)
        .collect()
}

/// Error, ledger, versions and digest.
pub(super) fn section(report: &Report) -> String {
    let l = &report.ledger;
    let joule = |value: f64| format!("{:.4e} J", value + 0.0);
    let error = report.error_in_words().map_or(Text::new("report-not-computed").into(), |e| {
        let of = said!("report-error", "error" => e, "tolerance" => format!("{:e}", report.tolerance));
        of + &Report::as_far_as(report.estimated_until)
    });
    let balance = said!("report-residual-of", "residual" => joule(l.residual), "bound" => joule(report.residual_bound));
    let energies = [
        ("report-work-ground", l.work_ground),
        ("report-work-push", l.work_push),
        ("report-initial", l.initial()),
        ("report-kinetic", l.kinetic),
        ("report-stored", l.bearing),
        ("report-stored-girders", l.girder),
        ("report-raised", l.gravity),
        ("report-stored-contacts", l.contact),
        ("report-stored-devices", l.device),
        ("report-lost-bearings", l.loss_bearing),
        ("report-lost-girders", l.loss_girder),
        ("report-lost-contacts", l.loss_normal + l.loss_tangential + l.loss_hits),
        ("report-lost-friction", l.loss_friction),
        ("report-lost-devices", l.loss_device),
        ("report-jumps", l.released()),
    ];
    let energies = energies.into_iter().filter(|(_, energy)| energy.abs() > report.residual_bound);
    let residual = if report.balances { balance } else { said!("report-unbalanced", "balance" => balance) };
    let error = fact(Text::new("report-estimated-error"), error);
    let energies = energies.map(|(name, energy)| fact(Text::new(name), joule(energy)));
    facts([error].into_iter().chain(energies).chain([
        fact(Text::new("report-residual"), residual),
        fact(Text::new("report-overlaps"), report.overlaps.len().to_string()),
        fact(
            Text::new("report-program"),
            said!(
                "report-versions",
                "program" => report.versions.girderbench,
                "format" => report.versions.scene_format
            ),
        ),
        fact(Text::new("report-digest"), report.digest.clone()),
    ]))
}
