//! The findings with their checks, and the scans beside them.

use std::fmt::Write as _;

use crate::plot::Colors;
use crate::plot::draw::escape;
use crate::plot::heat_map::{HeatMap, Map, Steps};
use crate::study::experiment::earthquake::Earthquake;
use crate::study::experiment::findings::{Finding, Outcome, Verdict};
use crate::study::experiment::results::Results;
use crate::study::experiment::scan::{Axis, Scan};

/// A sign that needs no colour, in the colour of the outcome.
pub(super) fn badge(outcome: Outcome) -> String {
    let (class, sign) = match outcome {
        Outcome::ComesOut => ("yes", "●"),
        Outcome::InPart => ("part", "◐"),
        Outcome::DoesNot => ("no", "○"),
        Outcome::Open => ("open", "–"),
    };
    format!(r#"<span class="{class}">{sign} {}</span>"#, outcome.label())
}

/// All findings in one table, a row each.
pub(super) fn overview(findings: &[Finding]) -> String {
    let mut html = String::from(
        "<table><thead><tr><th>Finding</th><th>The paper saw</th><th>contact model</th><th>impact model</th></tr></thead><tbody>\n",
    );
    for finding in findings {
        let outcome = |model: usize| finding.verdicts.get(model).or(finding.verdicts.first()).map(Verdict::outcome);
        let cells = [0, 1].map(|model| outcome(model).map_or(String::new(), badge));
        let _ = writeln!(
            html,
            "<tr><td><a href=\"#finding-{0}\">{0}. {1}</a></td><td>{2}</td><td class=\"word\">{3}</td><td class=\"word\">{4}</td></tr>",
            finding.number,
            escape(finding.title),
            escape(finding.paper),
            cells[0],
            cells[1]
        );
    }
    html.push_str("</tbody></table>\n");
    html
}

/// A finding: what the paper saw, checks with their numbers, maps.
pub(super) fn section(finding: &Finding, results: &Results, earthquake: &Earthquake) -> String {
    let mut html = format!(
        "<section id=\"finding-{0}\"><h3>{0}. {1}</h3><p>The paper: {2}</p>\n",
        finding.number,
        escape(finding.title),
        escape(finding.paper)
    );
    if finding.of_earthquake() && earthquake.synthetic {
        html.push_str("<p>Here the earthquake is the built-in synthetic one.</p>\n");
    }
    html.push_str("<table><thead><tr><th>Model</th><th>Check</th><th>Found</th><th>Holds</th></tr></thead><tbody>\n");
    for (number, verdict) in finding.verdicts.iter().enumerate() {
        let model = format!("{}<br>{}", finding.model(number), badge(verdict.outcome()));
        let rows = verdict.checks.len().max(1);
        let _ = write!(html, "<tr><td rowspan=\"{rows}\" class=\"word\">{model}</td>");
        if verdict.checks.is_empty() {
            html.push_str("<td colspan=\"3\">runs that it needs were not made</td></tr>\n");
        }
        for (place, check) in verdict.checks.iter().enumerate() {
            let begin = if place > 0 { "<tr>" } else { "" };
            let holds = if check.holds { "yes" } else { "no" };
            let _ = writeln!(
                html,
                "{begin}<td>{}</td><td class=\"number\">{}</td><td>{holds}</td></tr>",
                escape(&check.claim),
                escape(&check.found)
            );
        }
    }
    html.push_str("</tbody></table>\n");
    let scans = Scan::all().filter(|scan| finding.scans.contains(&scan.name));
    scans.filter_map(|scan| map(&scan, results)).for_each(|svg| {
        let _ = writeln!(html, "<div class=\"picture\">{svg}</div>");
    });
    html.push_str("</section>\n");
    html
}

/// The checks of all findings as a table in Markdown, for a page of its own.
pub(super) fn markdown(findings: &[Finding]) -> String {
    let mut table = String::from("| finding | model | outcome | check | found | holds |\n|---|---|---|---|---|---|\n");
    for finding in findings {
        for (number, verdict) in finding.verdicts.iter().enumerate() {
            let (model, outcome) = (finding.model(number), verdict.outcome().label());
            for check in &verdict.checks {
                let (holds, claim) = (if check.holds { "yes" } else { "no" }, check.claim.replace('|', "\\|"));
                let (title, found) = (finding.title, &check.found);
                let _ = writeln!(
                    table,
                    "| {} {title} | {model} | {outcome} | {claim} | {found} | {holds} |",
                    finding.number
                );
            }
        }
    }
    table
}

/// The maps of a scan side by side.
pub(super) fn map(scan: &Scan, results: &Results) -> Option<String> {
    let values = &results.scans.get(scan.name)?.maps;
    let axis = |axis: Axis| {
        let Axis { parameter, range: [from, to], count } = axis;
        let place = (parameter.preset() - from) / (to - from);
        Steps {
            name: parameter.label().to_owned(),
            values: axis.steps(),
            mark: (0.0..=1.0).contains(&place).then_some(place * (count.saturating_sub(1)) as f64),
        }
    };
    let maps = scan.variants.iter().zip(values);
    let maps = maps.map(|(variant, values)| Map { name: variant.name.to_owned(), values: values.clone() });
    Some(
        HeatMap {
            title: scan.title.to_owned(),
            subtitle: "The ring is the preset.".to_owned(),
            x: axis(scan.x),
            y: axis(scan.y),
            bar: scan.measure.label().to_owned(),
            colors: Colors::default(),
            maps: maps.collect(),
        }
        .to_svg(),
    )
}
