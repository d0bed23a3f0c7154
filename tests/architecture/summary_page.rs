//! The tables of `docs/summary.md` are what the structs say that `summary.json` is written from: a row a field, its meaning the field's own
//! words. `GIRDERBENCH_BLESS=1` writes them anew.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;

use crate::source::{root, sources};

/// A struct that is written, by its fields.
struct Written {
    fields: Vec<Field>,
}

struct Field {
    name: String,
    meaning: String,
    holds: String,
    /// Attributes of serde.
    serde: String,
}

impl Field {
    fn has(&self, attribute: &str) -> bool {
        self.serde.contains(attribute)
    }

    fn is_left_out(&self) -> bool {
        self.serde.split([',', '(', ')']).any(|word| word.trim() == "skip")
    }

    /// Whether it is always there.
    fn there(&self) -> &'static str {
        match (self.has("skip_serializing_if"), self.holds.starts_with("Option<")) {
            (true, _) => "where there is one",
            (false, true) => "or `null`",
            (false, false) => "always",
        }
    }

    /// The struct that it holds, one or more of them, and how its keys are written below it.
    fn below(&self) -> (&str, &'static str) {
        let mut holds = self.holds.as_str();
        let mut many = "";
        loop {
            let inside = |before: &str| holds.strip_prefix(before)?.strip_suffix('>');
            if let Some(inner) = inside("Option<") {
                holds = inner;
            } else if let Some(inner) = inside("Vec<") {
                (holds, many) = (inner, "[]");
            } else if let Some(inner) =
                holds.strip_prefix('[').and_then(|array| array.split(';').next()).filter(|_| holds.contains(';'))
            {
                (holds, many) = (inner, "[]");
            } else {
                return (holds.rsplit("::").next().unwrap_or(holds), many);
            }
        }
    }
}

/// A comment as a page has it: no links into the code, a bar that does not end a cell.
fn on_a_page(comment: &str) -> String {
    let plain = comment.replace("[`", "`").replace("`]", "`").replace("\\[", "[").replace("\\]", "]");
    plain.replace('|', "\\|").replace("`None`", "`null`")
}

fn structs() -> BTreeMap<String, Written> {
    let mut all = BTreeMap::new();
    for source in sources("src", "rs") {
        let mut lines = source.text.lines().peekable();
        let mut derives = String::new();
        while let Some(line) = lines.next() {
            if line.starts_with("#[derive(") {
                line.clone_into(&mut derives);
            }
            let Some(name) = line.strip_prefix("pub struct ").and_then(|rest| rest.strip_suffix(" {")) else {
                continue;
            };
            if !derives.contains("Serialize") {
                continue;
            }
            let mut written = Written { fields: Vec::new() };
            let (mut comment, mut serde) = (String::new(), String::new());
            for line in lines.by_ref().map(str::trim).take_while(|line| *line != "}") {
                if let Some(words) = line.strip_prefix("///") {
                    comment = format!("{comment}{words}");
                } else if line.starts_with("#[") {
                    serde.push_str(line);
                } else if let Some((name, holds)) = line.strip_prefix("pub ").and_then(|field| field.split_once(": ")) {
                    written.fields.push(Field {
                        name: name.to_owned(),
                        meaning: on_a_page(comment.trim()),
                        holds: holds.trim_end_matches(',').to_owned(),
                        serde: std::mem::take(&mut serde),
                    });
                    comment.clear();
                }
            }
            assert!(all.insert(name.to_owned(), written).is_none(), "two structs are written that are called {name}");
        }
    }
    all
}

/// The rows of a struct, and below them the tables of what its fields hold.
fn tables(all: &BTreeMap<String, Written>, name: &str, place: &str) -> String {
    let mut rows = String::new();
    let mut below = String::new();
    write_rows(all, name, place, (&mut rows, &mut below));
    let title = if place.is_empty() { "The whole".to_owned() } else { format!("`{place}`") };
    format!("\n## {title}\n\n| key | there | meaning |\n|---|---|---|\n{rows}{below}")
}

fn write_rows(all: &BTreeMap<String, Written>, name: &str, place: &str, (rows, below): (&mut String, &mut String)) {
    for field in all[name].fields.iter().filter(|field| !field.is_left_out()) {
        let (holds, many) = field.below();
        if field.has("flatten") {
            write_rows(all, holds, place, (rows, below));
            continue;
        }
        let Field { name, meaning, .. } = field;
        let _ = writeln!(rows, "| `{name}` | {} | {meaning} |", field.there());
        if all.contains_key(holds) {
            let dot = if place.is_empty() { "" } else { "." };
            below.push_str(&tables(all, holds, &format!("{place}{dot}{name}{many}")));
        }
    }
}

#[test]
fn the_page_on_the_summary_has_every_key_and_no_other() {
    let (page, mark) = (root().join("docs/summary.md"), "\n## The whole\n");
    let text = fs::read_to_string(&page).expect("the page is there");
    let wanted = tables(&structs(), "Report", "");
    let at = text.find(mark).expect("the page has its tables");
    if std::env::var_os("GIRDERBENCH_BLESS").is_some() {
        fs::write(&page, format!("{}{wanted}", &text[..at])).expect("the page can be written");
        return;
    }
    for (there, row) in text[at..].lines().zip(wanted.lines()) {
        assert_eq!(there, row, "docs/summary.md; GIRDERBENCH_BLESS=1 writes its tables anew");
    }
    assert_eq!(text[at..].lines().count(), wanted.lines().count(), "rows of docs/summary.md");
}
