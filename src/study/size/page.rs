//! Cost against size as a page: the plot, the table, what others need for the largest row.

use std::fmt::Write as _;

use super::Row;
use crate::study::Occasion;

/// Time that other kinds of program need for 1000 girders and one simulated second, as it was given \[s\].
const OTHERS: [(&str, f64); 3] =
    [("the fastest of them, at an error of 1e-5 m", 3.3), ("the second", 13.9), ("the third", 650.0)];

/// The page, in Markdown.
pub fn page(rows: &[Row], occasion: &Occasion, extension: &str) -> String {
    let mut page = format!(
        "# Cost against size\n\nMeasured {} on {} with\n\n    {}\n\n\
         A row of the paper's straight girders, gaps of 5 mm, periods that change from one to the next, 0.4 g at 2.4 Hz, one \
         second. In one row neighbours collide all along it; in the other only three girders in the middle are near enough to \
         touch. Times are the least CPU time of several runs, all threads together, from the scene to a history. The difference is the largest in displacement \
         from the same run at a thousandth of the tolerance.\n\n\
         ![Cost against size](size.{extension})\n\n\
         | row | girders | simulated | time | time per girder | hits | difference |\n|---|---|---|---|---|---|---|\n",
        occasion.date, occasion.machine, occasion.command
    );
    for r in rows {
        let _ = writeln!(
            page,
            "| {} | {} | {} s | {:.3} ms | {:.1} µs | {} | {:.1e} m |",
            r.scene,
            r.girders,
            r.simulated,
            r.seconds * 1e3,
            r.seconds * 1e6 / r.girders as f64,
            r.hits,
            r.error
        );
    }
    if let Some(row) = rows.iter().find(|r| r.scene == "colliding" && r.girders == 1000) {
        page.push_str("\nOther kinds of program on such a row of 1000, in CPU seconds, as given and not measured here:\n\n| program | time | over ours |\n|---|---|---|\n");
        for (name, seconds) in OTHERS {
            let _ = writeln!(page, "| {name} | {seconds} s | {:.1} |", seconds / row.seconds);
        }
    }
    page
}
