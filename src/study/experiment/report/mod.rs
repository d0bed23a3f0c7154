//! The report: one HTML page with every picture inside and no link to anything outside; its checks as Markdown too.

mod case_list;
mod figures;
mod plan;
mod strip;
mod verdicts;

use std::fmt::Write as _;

use super::cases::Case;
use super::earthquake::Earthquake;
use super::findings::findings;
use super::results::Results;
use super::scan::Scan;
use crate::plot::draw::escape;
use crate::study::Occasion;
use crate::study::page;

/// The page.
pub fn html(results: &Results, earthquake: &Earthquake, occasion: &Occasion) -> String {
    let findings = findings(results);
    let mut page = page::begin("The experiment of Abe et al. (2004), computed", "en");
    page.push_str(&introduction(results, earthquake, occasion));
    page.push_str("<h2>Findings</h2>\n");
    page.push_str(&verdicts::overview(&findings));
    for finding in &findings {
        page.push_str(&verdicts::section(finding, results, earthquake));
    }
    page.push_str("<h2>Figures of the paper</h2>\n<p>Quantities and axes as in the captions of the paper, ranges those of our runs. It \
                   does not state the amplitude of the sine in its figures; 0.40 g is taken, at which hits come in succession as in its \
                   Fig. 15.</p>\n");
    for figure in figures::figures(results) {
        let _ = writeln!(page, "<figure><figcaption><b>{}</b> {}</figcaption>", figure.number, escape(&figure.caption));
        for (words, svg) in &figure.pictures {
            let _ = writeln!(page, "<p>{}</p><div class=\"picture\">{svg}</div>", escape(words));
        }
        page.push_str("</figure>\n");
    }
    page.push_str("<h2>Every case of Table 2</h2>\n<p>Largest displacements and rotation of any girder, hits, states (Fig. 13): a free, \
                   turning; b free; c contact, sliding and turning; d contact, turning; e contact, sliding; f contact, resting. States \
                   of the contact model are read off its contacts.</p>\n");
    page.push_str(&case_list::table(results));
    page.push_str("<h2>Histories</h2>\n");
    Case::all().iter().filter_map(|case| case_list::details(case, results)).for_each(|html| page.push_str(&html));
    page.push_str(page::END);
    page
}

/// The checks of all findings as a table in Markdown.
pub fn markdown(results: &Results) -> String {
    verdicts::markdown(&findings(results))
}

/// The maps by themselves: name of the scan and SVG document.
pub fn maps(results: &Results) -> Vec<(&'static str, String)> {
    Scan::all().filter_map(|scan| Some((scan.name, verdicts::map(&scan, results)?))).collect()
}

fn introduction(results: &Results, earthquake: &Earthquake, occasion: &Occasion) -> String {
    let quake = if earthquake.synthetic {
        "No record file was given: the earthquake of every case called “record” is the built-in synthetic one, not El Centro."
    } else {
        "The record is run as its file has it, without a scale of time."
    };
    format!(
        "<h1>The experiment of Abe et al. (2004), computed</h1>\n\
         <p>Every case of Table 2 of Abe, Fujino, Yoshida, Zhu and Yanagino, <i>Multi-dimensional models of pounding of girders for \
         elevated bridges and their experimental verification</i> (JSCE, 2004), run with the numbers of Table 3 under both of its \
         models. Computed {} on {} with <code>{}</code>: {} of {} cases.</p>\n\
         <ul>\
         <li>Assumed, for the paper does not state them: a gap of 3 mm, legs at (±70, ±25) mm.</li>\
         <li>Earthquake: {}, scale {}, peak {:.4} g, {:.1} s. The paper does not state the scale of its record. {quake}</li>\
         <li>The paper's impact model is derived for an abutment; for two girders it is used with the levers of both.</li>\
         <li>A finding comes out where all its checks hold, in part where some do. Limits are stated in each check; nothing is fitted to \
         the paper.</li></ul>\n",
        escape(&occasion.date),
        escape(&occasion.machine),
        escape(&occasion.command),
        results.cases.len(),
        Case::all().len(),
        escape(&earthquake.name),
        earthquake.scale,
        earthquake.peak_g(),
        earthquake.duration(),
    )
}
