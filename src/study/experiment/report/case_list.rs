//! Every case: a table of the largest motions, hits and states, and the histories of each.

use std::fmt::Write as _;

use super::figures::histories;
use super::strip::{Band, pattern, strip};
use crate::plot::draw::escape;
use crate::study::experiment::cases::{Case, Specimen};
use crate::study::experiment::findings::rules::successions;
use crate::study::experiment::observe::Observed;
use crate::study::experiment::results::{MODELS, Results};

/// The table.
pub(super) fn table(results: &Results) -> String {
    let mut html = String::from(
        "<table><thead><tr><th rowspan=\"2\">Case</th><th colspan=\"5\">contact model</th><th colspan=\"5\">impact model</th></tr>\n<tr>",
    );
    for _ in MODELS {
        html.push_str("<th>x [mm]</th><th>y [mm]</th><th>θ [°]</th><th>hits</th><th>states</th>");
    }
    html.push_str("</tr></thead><tbody>\n");
    for case in Case::all() {
        let Some(result) = results.cases.get(&case.name()) else { continue };
        let _ = write!(html, "<tr><td><a href=\"#case-{}\">{}</a></td>", case.name(), escape(&case.label()));
        result.models.iter().for_each(|seen| html.push_str(&cells(seen)));
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody></table>\n");
    html
}

/// Largest motions of any girder, hits, letters of the states.
fn cells(seen: &Observed) -> String {
    let largest = |axis: usize| seen.girders.iter().map(|girder| girder.largest[axis]).fold(0.0, f64::max);
    let mut letters: Vec<char> = seen.girders.iter().flat_map(|girder| &girder.states).map(|s| s.letter).collect();
    letters.sort_unstable();
    letters.dedup();
    format!(
        "<td class=\"number\">{:.2}</td><td class=\"number\">{:.2}</td><td class=\"number\">{:.2}</td><td class=\"number\">{}</td><td>{}</td>",
        1e3 * largest(0),
        1e3 * largest(1),
        largest(2).to_degrees(),
        seen.hits.len(),
        letters.into_iter().collect::<String>()
    )
}

/// Histories, states and patterns of a case, folded.
pub(super) fn details(case: &Case, results: &Results) -> Option<String> {
    let result = results.cases.get(&case.name())?;
    let chart = histories(results, case, &[0, 1], &[0, 1, 2])?;
    let mut html = format!("<details id=\"case-{}\"><summary>{}</summary>\n", case.name(), escape(&case.label()));
    let _ = writeln!(html, "<div class=\"picture\">{chart}{}</div>\n<ul>", bands(&result.models));
    for (model, seen) in MODELS.iter().zip(&result.models) {
        for girder in &seen.girders {
            let _ =
                writeln!(html, "<li>{} model, {}: {}", model.label(), escape(&girder.name), pattern(&girder.states));
            let _ = writeln!(html, "; largest rotation {:.3}°</li>", girder.largest[2].to_degrees());
        }
        let _ = writeln!(html, "<li>{} model: {}</li>", model.label(), hits(seen, case.specimen));
    }
    html.push_str("</ul></details>\n");
    Some(html)
}

/// Hits, and how many come in succession.
fn hits(seen: &Observed, specimen: Specimen) -> String {
    let all = successions(&seen.hits, 1.0 / specimen.sine_hz());
    let most = all.iter().map(|hits| hits.len()).max().unwrap_or(0);
    let count = |size: usize| all.iter().filter(|hits| hits.len() == size).count();
    let sizes = (1..=most).filter(|&size| count(size) > 0).map(|size| format!("{} of {size}", count(size)));
    let stopped =
        seen.stopped.as_ref().map_or(String::new(), |why| format!("; ended at {:.3} s: {}", seen.end, escape(why)));
    format!("{} hits in successions: {}{stopped}", seen.hits.len(), sizes.collect::<Vec<_>>().join(", "))
}

fn bands(models: &[Observed; 2]) -> String {
    let end = models.iter().map(|seen| seen.end).fold(0.0, f64::max);
    let mut all = Vec::new();
    for (model, seen) in MODELS.iter().zip(models) {
        for girder in &seen.girders {
            let alone = seen.girders.len() == 1;
            let name = if alone { model.label().to_owned() } else { format!("{}, {}", model.label(), girder.name) };
            all.push(Band { name, states: &girder.states, hits: &seen.hits });
        }
    }
    strip(&all, end)
}
