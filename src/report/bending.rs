//! Readings of elastic girders: a table, and the lines at the head of the page where the model is not valid.

use std::fmt::Write as _;

use super::sections::{at, head, row};
use crate::language::{Text, said, six};
use crate::plot::draw::escape;
use crate::sim::DegreeCheck;
use crate::tables::{FlexibleReport, FlexibleRun, Report};

/// Girders that bend, and what became of them.
fn bending(report: &Report) -> impl Iterator<Item = (&FlexibleReport, &FlexibleRun)> {
    report.flexible.iter().filter_map(|girder| Some((girder, girder.run.as_ref()?)))
}

/// Modes, hardest hit, section forces and stress of every girder that bends, and whether more polynomials would change them; nothing of
/// a scene without.
pub(super) fn table(report: &Report) -> String {
    if bending(report).next().is_none() {
        return String::new();
    }
    let mut html = head(&[
        Text::new("report-bends").as_str(),
        &Text::new("report-bends-modes"),
        &Text::new("report-bends-frequencies"),
        &Text::new("report-bends-hit"),
        &Text::new("report-bends-axial"),
        &Text::new("report-bends-moment"),
        &Text::new("report-bends-upwards"),
        &Text::new("report-bends-stress"),
        &Text::new("report-bends-strength"),
    ]);
    let mega = |[value, t]: [f64; 2]| at(six(value / 1e6), t);
    let none = || "–".to_owned();
    for (girder, run) in bending(report) {
        let frequencies: Vec<String> = girder.frequencies.iter().take(3).map(|f| six(*f)).collect();
        let hit = run.hit.map_or_else(none, |hit| {
            let returned = hit.restitution.map_or_else(none, six);
            at(format!("{}{}, {returned}", if hit.ended { "" } else { "> " }, six(hit.contact_time * 1e3)), hit.t)
        });
        let cells = [
            format!("{}, {}", girder.degree, girder.modes),
            frequencies.join(", "),
            hit,
            mega(run.axial),
            mega(run.moment),
            run.vertical_moment.map_or_else(none, mega),
            stress(run),
            run.strength.map_or_else(none, |strength| six(strength / 1e6)),
        ];
        html.push_str(&row(&girder.girder, &cells));
    }
    html.push_str("</table>\n");
    if let Some(check) = &report.degree_check {
        let _ = writeln!(html, "<p>{}</p>", escape(&checked(check)));
    }
    html
}

fn stress(run: &FlexibleRun) -> String {
    let [stress, t, s] = run.stress;
    said!("report-stress-at", "stress" => six(stress / 1e6), "s" => six(s), "t" => format!("{t:.3}"))
}

fn checked(check: &DegreeCheck) -> String {
    let part = |difference: f64| format!("{difference:.1e}");
    let differences = said!(
        "report-degrees",
        "one" => check.degree[0],
        "other" => check.degree[1],
        "force" => part(check.force),
        "impulse" => part(check.impulse),
        "ends" => part(check.ends),
        "section" => part(check.section),
        "moments" => part(check.moments)
    );
    differences + &Report::as_far_as(check.until)
}

/// Strengths that are passed, and terms left out that are not small, a line each.
pub(super) fn departures(report: &Report) -> impl Iterator<Item = String> + '_ {
    bending(report).flat_map(|(girder, run)| {
        let name = girder.girder.as_str();
        let passed = run.strength.filter(|_| run.strength_passed).map(|strength| {
            let (strength, stress) = (six(strength / 1e6), stress(run));
            said!("report-strength-passed", "girder" => name, "strength" => strength, "stress" => stress)
        });
        let names: Vec<&str> = run.not_negligible.iter().map(|name| name.as_str()).collect();
        let left_out =
            (!names.is_empty()).then(|| said!("report-not-negligible", "girder" => name, "names" => names.join(", ")));
        passed.into_iter().chain(left_out)
    })
}
