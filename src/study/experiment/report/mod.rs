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
use crate::study::Occasion;
use crate::study::plot::draw::escape;

const STYLE: &str = "
body { font: 15px/1.5 system-ui, sans-serif; color: #222; max-width: 1100px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.7em; } h2 { margin-top: 2.2em; border-bottom: 1px solid #ccc; } h3 { margin-top: 1.8em; }
table { border-collapse: collapse; margin: 0.8em 0; font-size: 0.93em; }
th, td { border-bottom: 1px solid #ddd; padding: 0.25em 0.6em; text-align: left; vertical-align: top; }
th { background: #f4f4f4; } .number { font-variant-numeric: tabular-nums; } .word { white-space: nowrap; }
.yes { color: #00694d; font-weight: 600; } .part { color: #8a5a00; font-weight: 600; }
.no { color: #a83f00; font-weight: 600; } .open { color: #6b6b6b; }
.picture { overflow-x: auto; } .picture svg { max-width: 100%; height: auto; }
figure { margin: 1.4em 0; } figcaption { color: #444; font-size: 0.93em; }
details { border-bottom: 1px solid #ddd; } summary { padding: 0.35em 0; cursor: pointer; }
code { background: #f4f4f4; padding: 0 0.25em; }
@media print { details { break-inside: avoid; } .picture { break-inside: avoid; } }
";

/// The page.
pub fn html(results: &Results, earthquake: &Earthquake, occasion: &Occasion) -> String {
    let findings = findings(results);
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">\
         <title>The experiment of Abe et al. (2004), computed</title><style>{STYLE}</style></head><body>\n"
    );
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
    page.push_str("</body></html>\n");
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
