//! A run on one page of HTML to hand to a colleague: scene with its numbers, assumptions, motion, the hardest hit, readings against
//! limits and codes, errors, ledger, versions. Every picture is inside; nothing outside is linked.

mod ground;
mod loops;
mod orbit;
mod plan;
mod sections;

use std::fmt::Write as _;

use crate::sim::History;
use crate::study::page;
use crate::study::plot::draw::escape;
use crate::tables::{Report, TableOptions};
use plan::{Plan, hardest};

/// The page of a run; `estimated_error` and the time of the run as in the tables.
pub fn html(history: &History, options: &TableOptions) -> String {
    let report = Report::of(history, options);
    let scene = history.scene();
    let name = escape(&scene.name);
    let mut page = page::begin(&format!("{name}: seismic pounding, report"));
    let _ = writeln!(page, "<h1>{name}</h1>\n<p>{}</p>", escape(&scene.description));
    page.push_str(&sections::headline(&report));
    page.push_str("<h2>Scene</h2>\n");
    figure(
        &mut page,
        &Plan::as_placed(history).svg(),
        "Plan as placed, to scale. Dots: bearings; red: front edges of the seats, under the deck; numbers: corners.",
    );
    page.push_str(&sections::scene(history));
    page.push_str("<h2>Assumptions</h2>\n");
    page.push_str(&sections::assumptions(history, &report));
    page.push_str("<h2>Ground motion</h2>\n");
    page.push_str(&ground::section(history));
    page.push_str("<h2>Hardest hit</h2>\n");
    match hardest(history) {
        Some((words, pictures)) => {
            let _ = writeln!(page, "<p>{}</p>", escape(&words));
            for (caption, svg) in pictures {
                figure(&mut page, &svg, &caption);
            }
        }
        None => page.push_str("<p>Nothing touches.</p>\n"),
    }
    page.push_str("<h2>Motion of the girders</h2>\n");
    page.push_str(&ground::girders(history));
    let loops = loops::pictures(history);
    if !loops.is_empty() {
        page.push_str("<h2>Hysteresis loops</h2>\n");
    }
    for (caption, svg) in loops {
        figure(&mut page, &svg, &caption);
    }
    page.push_str("<h2>Readings and limits</h2>\n");
    page.push_str(&sections::readings(history, &report));
    page.push_str("<h2>Seats and codes</h2>\n");
    page.push_str(&sections::seats(&report));
    for (caption, svg) in orbit::pictures(history) {
        figure(&mut page, &svg, &caption);
    }
    page.push_str("<h2>How far to trust it</h2>\n");
    page.push_str(&sections::trust(&report));
    page.push_str(page::END);
    page
}

/// A picture with a line under it.
fn figure(page: &mut String, svg: &str, caption: &str) {
    let _ = writeln!(
        page,
        "<figure><div class=\"picture\">{svg}</div><figcaption>{}</figcaption></figure>",
        escape(caption)
    );
}
