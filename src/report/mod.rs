//! A run on one page of HTML to hand to a colleague: scene with its numbers, assumptions, motion, the hardest hit, readings against
//! limits and codes, errors, ledger, versions. Every picture is inside; nothing outside is linked.

mod assumptions;
mod bending;
mod devices;
mod ground;
pub mod in_force;
mod loops;
mod orbit;
mod plan;
mod sections;
mod supports;
mod trust;
mod units;

use std::fmt::Write as _;

use crate::language::{Language, Text, said};
use crate::plot::draw::escape;
use crate::scene::{Scene, format, presets};
use crate::sim::History;
use crate::study::page;
use crate::tables::{Report, TableOptions};
use plan::{Plan, hardest};

/// The page of a run in the language of this thread; `estimated_error` and the time of the run as in the tables.
pub fn html(history: &History, options: &TableOptions) -> String {
    let report = Report::of(history, options);
    let scene = history.scene();
    let name = escape(&scene.name);
    let mut page = page::begin(&said!("report-title", "name" => name.as_str()), Language::current().code());
    let _ = writeln!(page, "<h1>{name}</h1>\n<p>{}</p>", escape(presets::told(scene)));
    page.push_str(&sections::verdicts(&report));
    page.push_str(&trust::departures(&report));
    page.push_str(&sections::headline(history, &report));
    heading(&mut page, Text::new("report-scene"));
    figure(&mut page, &Plan::as_placed(history).svg(), &plan::caption(history));
    page.push_str(&sections::scene(history));
    heading(&mut page, Text::new("report-assumptions"));
    page.push_str(&assumptions::section(history, &report));
    heading(&mut page, Text::new("report-ground"));
    page.push_str(&ground::section(history));
    heading(&mut page, Text::new("report-hardest"));
    match hardest(history) {
        Some((words, pictures)) => {
            let _ = writeln!(page, "<p>{}</p>", escape(&words));
            for (caption, svg) in pictures {
                figure(&mut page, &svg, &caption);
            }
        }
        None => {
            let _ = writeln!(page, "<p>{}</p>", Text::new("report-nothing-touches"));
        }
    }
    heading(&mut page, Text::new("report-girders"));
    page.push_str(&ground::girders(history));
    let loops = loops::pictures(history, &report);
    if !loops.is_empty() {
        heading(&mut page, Text::new("report-loops"));
    }
    for (caption, svg) in loops {
        figure(&mut page, &svg, &caption);
    }
    heading(&mut page, Text::new("report-readings"));
    page.push_str(&sections::readings(history, &report));
    page.push_str(&supports::bearings(&report));
    page.push_str(&bending::table(&report));
    page.push_str(&devices::table(&report));
    page.push_str(&supports::piers(&report));
    page.push_str(&supports::soils(&report));
    page.push_str(&sections::limits(history, &report));
    heading(&mut page, Text::new("report-seats"));
    page.push_str(&sections::seats(&report));
    for (caption, svg) in orbit::pictures(history) {
        figure(&mut page, &svg, &caption);
    }
    heading(&mut page, Text::new("report-trust"));
    page.push_str(&trust::section(&report));
    heading(&mut page, Text::new("report-file"));
    page.push_str(&file(scene));
    page.push_str(page::END);
    page
}

/// The scene as a file: what a colleague runs to have this answer.
fn file(scene: &Scene) -> String {
    let (open, text) = (Text::new("report-file-open"), escape(&format::write(scene)));
    format!("<details><summary>{open}</summary>\n<pre>{text}</pre></details>\n")
}

fn heading(page: &mut String, words: Text) {
    let _ = writeln!(page, "<h2>{words}</h2>");
}

/// A picture with a line under it.
fn figure(page: &mut String, svg: &str, caption: &str) {
    let _ = writeln!(
        page,
        "<figure><div class=\"picture\">{svg}</div><figcaption>{}</figcaption></figure>",
        escape(caption)
    );
}
