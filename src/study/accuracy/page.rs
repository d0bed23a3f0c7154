//! The study as a page: what was measured, how far each reference can be trusted, what failed.

use std::fmt::Write as _;

use super::others::{OTHERS, Other};
use super::picture::GOALS;
use super::study::{Part, Row, Study};
use crate::study::Occasion;

/// Errors at which the methods are compared \[m\].
const LEVELS: [f64; 4] = [1e-6, 1e-8, 1e-9, 1e-10];

impl Study {
    /// The page, in Markdown; its pictures are the plots' PNGs, or their SVGs.
    pub fn page(&self, occasion: &Occasion, extension: &str) -> String {
        let mut page = head(occasion);
        page.push_str(&self.headline());
        self.parts.iter().for_each(|part| part_text(&mut page, part, extension));
        page.push_str(&self.others());
        page.push_str(&self.failures());
        page
    }

    /// Fastest time of each method at each error level.
    fn headline(&self) -> String {
        let mut text = String::from(
            "## Time to an error\n\nThe least time in which a method came below a displacement error; — where no setting did.\n\n",
        );
        let methods = self.methods();
        let _ = writeln!(text, "| problem | error | {} | next best over event-driven |", methods.join(" | "));
        let _ = writeln!(text, "|---|---|---|{}", "---|".repeat(methods.len()));
        for part in &self.parts {
            for level in LEVELS.iter().filter(|l| **l > part.reference.known_to()) {
                let times: Vec<Option<f64>> = methods.iter().map(|m| best(part, m, *level)).collect();
                let cells: Vec<String> = times.iter().map(|t| time(*t)).collect();
                let _ = writeln!(
                    text,
                    "| {} | {level:.0e} m | {} | {} |",
                    part.problem.name,
                    cells.join(" | "),
                    lead(&methods, &times)
                );
            }
        }
        text.push('\n');
        text.push_str(&self.goals());
        text
    }

    fn goals(&self) -> String {
        let mut text = String::from("| goal | asked | measured |\n|---|---|---|\n");
        for (problem, seconds, error) in GOALS {
            let Some(part) = self.part(problem) else { continue };
            let got = time(best(part, "event-driven", *error));
            let _ = writeln!(text, "| {problem} at {error:.0e} m | {} | {got} |", time(Some(*seconds)));
        }
        if let Some(part) = self.part("skew45") {
            let _ = writeln!(text, "| skew45 at 1e-8 m | 2.0 ms | {} |", time(best(part, "event-driven", 1e-8)));
        }
        if let Some(part) = self.part("deck-3d") {
            let got = time(best(part, "event-driven", 1e-6 * part.largest));
            let asked = part.until.0 / 1000.0;
            let _ = writeln!(text, "| deck-3d at 1e-6 of its peak | {} | {got} |", time(Some(asked)));
        }
        text.push('\n');
        text
    }

    fn part(&self, name: &str) -> Option<&Part> {
        self.parts.iter().find(|part| part.problem.name == name)
    }

    fn methods(&self) -> Vec<&'static str> {
        let mut names: Vec<&str> = Vec::new();
        for row in self.parts.iter().flat_map(|part| &part.rows) {
            if !names.contains(&row.method) {
                names.push(row.method);
            }
        }
        names
    }

    /// Other programs against ours, at the same error.
    fn others(&self) -> String {
        let mut text = String::from(
            "## Others\n\nCPU seconds of other kinds of program on one core of a like machine, at the best setting found for \
             each; these figures were given, not measured here. The ratio is their time over ours (event-driven) at no larger \
             error.\n\n| problem | program | error | their time | ours | ratio |\n|---|---|---|---|---|---|\n",
        );
        for other in OTHERS {
            let Some(part) = self.part(other.problem) else { continue };
            let ours = other.error.and_then(|e| best(part, "event-driven", e));
            let _ = writeln!(text, "{}", other_row(other, ours));
        }
        text.push('\n');
        text
    }

    /// Runs without a result, motions left out of equilibrium, and the smallest error of each method.
    fn failures(&self) -> String {
        let mut text = String::from("## What failed, and what was remarked\n\n");
        for part in &self.parts {
            for method in self.methods() {
                let rows: Vec<&Row> = part.rows.iter().filter(|row| row.method == method).collect();
                for remark in remarks(part.problem.name, method, &rows) {
                    let _ = writeln!(text, "- {remark}");
                }
            }
        }
        text
    }
}

/// Remarks on one method at one problem.
fn remarks(problem: &str, method: &str, rows: &[&Row]) -> Vec<String> {
    let mut said = Vec::new();
    for row in rows.iter().filter(|row| row.errors.is_none()) {
        said.push(format!("{problem} with {method} at {}: no answer; {}", setting(row), row.note));
    }
    let restless: Vec<&&Row> = rows.iter().filter(|row| row.note.contains("not in equilibrium")).collect();
    if let [first, .., last] = restless[..] {
        said.push(format!(
            "{problem} with {method} at {} to {}: some steps were not in equilibrium when the iteration ended, \
             where a contact closes or switches within it (the first: {}).",
            setting(first),
            setting(last),
            first.note
        ));
    }
    let least = rows.iter().filter_map(|row| Some(row.errors?.displacement)).fold(f64::INFINITY, f64::min);
    if least > 1e-6 && least.is_finite() {
        said.push(format!("{problem} with {method}: never below {least:.1e} m within a second of work."));
    }
    said
}

/// By how much the event-driven solver is ahead of the next best, or behind it.
fn lead(methods: &[&str], times: &[Option<f64>]) -> String {
    let ours = methods.iter().zip(times).find(|(m, _)| **m == "event-driven").and_then(|(_, t)| *t);
    let theirs = methods.iter().zip(times).filter(|(m, _)| **m != "event-driven").filter_map(|(_, t)| *t);
    match (ours, theirs.min_by(f64::total_cmp)) {
        (Some(ours), Some(theirs)) if theirs / ours < 10.0 => format!("{:.1}", theirs / ours),
        (Some(ours), Some(theirs)) => format!("{:.0}", theirs / ours),
        (Some(_), None) => "no other came there".to_owned(),
        _ => "—".to_owned(),
    }
}

fn other_row(other: &Other, ours: Option<f64>) -> String {
    let error = other.error.map_or("—".to_owned(), |e| format!("{e:.1e} m"));
    let ratio = match (other.seconds, ours) {
        (Some(theirs), Some(ours)) => format!("{:.0}", theirs / ours),
        _ => "—".to_owned(),
    };
    let theirs = other.seconds.map_or(other.note.to_owned(), |t| time(Some(t)));
    format!("| {} | {} | {error} | {theirs} | {} | {ratio} |", other.problem, other.program, time(ours))
}

/// The least time of a method below an error.
fn best(part: &Part, method: &str, error: f64) -> Option<f64> {
    let rows = part.rows.iter().filter(|row| row.method == method);
    let times = rows.filter_map(|row| (row.errors?.displacement <= error).then_some(row.seconds));
    times.min_by(f64::total_cmp)
}

fn time(seconds: Option<f64>) -> String {
    match seconds {
        None => "—".to_owned(),
        Some(t) if t < 1e-3 => format!("{:.3} ms", t * 1e3),
        Some(t) if t < 1.0 => format!("{:.3} ms", t * 1e3).replace(".000", ""),
        Some(t) => format!("{t:.2} s"),
    }
}

fn setting(row: &Row) -> String {
    if row.is_step { format!("a step of {:.2e} s", row.setting) } else { format!("tolerance {:.0e}", row.setting) }
}

fn head(occasion: &Occasion) -> String {
    format!(
        "# Work against error\n\n\
         Measured {} on {} with\n\n    {}\n\n\
         Every method answers every problem at a range of settings. The time of an answer is the least CPU time of several runs after \
         a warm-up, from the scene to something that can be asked for its motion; the error is measured apart from \
         it, as the largest difference in displacement from the reference at 2001 instants. The event-driven solver is the \
         product's own. The others are what a user of other tools would do with the same equations: the gap is tested wherever \
         forces are evaluated, the states {{open, stick, slip}} are brought up to date at the end of each step, and no event is \
         located. All numbers are in [results.csv](results.csv).\n\n",
        occasion.date, occasion.machine, occasion.command
    )
}

fn part_text(page: &mut String, part: &Part, extension: &str) {
    let (name, reference) = (part.problem.name, &part.reference);
    let _ =
        writeln!(page, "## {name}\n\n{}.\n\n![{name}: error against time]({name}.{extension})\n", part.problem.summary);
    let compared = if part.until.1 < part.until.0 {
        format!(
            "compared up to {:.3} s of {} s, where a change of 1e-12 m at the start has grown to 1e-8 m",
            part.until.1, part.until.0
        )
    } else {
        format!("compared over all of its {} s", part.until.0)
    };
    let _ = writeln!(
        page,
        "Reference: {}. {} {:.1e} m, {:.1e} rad and {:.1e} of the peak force; \
         {compared}. A change of the start grows {:.1}-fold at the most. Largest displacement {:.4} m.\n",
        reference.what,
        if reference.exact {
            "The event-driven solver at its tightest is within"
        } else {
            "It and the event-driven solver at its tightest agree to"
        },
        reference.agreement.displacement,
        reference.agreement.rotation,
        reference.agreement.peak_force,
        reference.growth,
        part.largest
    );
    let mut seen = String::new();
    let mut names: Vec<&str> = part.rows.iter().map(|r| r.method).collect();
    names.dedup();
    for method in names {
        if let Some(row) = most_exact(part, method) {
            let errors = row.errors.unwrap_or_default();
            let _ = writeln!(
                seen,
                "| {method} | {} | {} | {:.1e} m | {:.1e} rad | {:.1e} |",
                setting(row),
                time(Some(row.seconds)),
                errors.displacement,
                errors.rotation,
                errors.peak_force
            );
        }
    }
    let _ = writeln!(
        page,
        "| at its best | setting | time | displacement | rotation | peak force |\n|---|---|---|---|---|---|\n{seen}"
    );
}

fn most_exact<'a>(part: &'a Part, method: &str) -> Option<&'a Row> {
    let error = |row: &&Row| row.errors.map_or(f64::INFINITY, |e| e.displacement);
    part.rows
        .iter()
        .filter(|row| row.method == method && row.errors.is_some())
        .min_by(|a, b| error(a).total_cmp(&error(b)))
}
