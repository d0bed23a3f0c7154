//! Complaints about a scene, and the checks of single numbers that make them.

use std::fmt::Display;

use crate::language::{Message, Text, message, said};
use crate::scene::Kind;
use crate::scene::keys::{self, Key, Keyed, Range, Stated};
use crate::scene::shown::{escaped, shown};

/// Characters of a place or a value that are shown: a face has twelve numbers of up to twenty-four characters.
const LONGEST: usize = 320;
/// Characters of a remedy that are shown: the names of all keys of a table have fewer.
const LONGEST_REMEDY: usize = 1000;

fn cut(text: &str) -> String {
    shown(text, LONGEST)
}

/// One complaint about a scene, shown as one line.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.line())]
pub struct SceneError {
    /// The file, or the preset's name, or "scene".
    pub file: String,
    /// `girder.deck.mass_kg`
    pub place: Message,
    /// Value found.
    pub value: Message,
    /// Fault and remedy.
    pub remedy: Message,
}

impl SceneError {
    /// Itself as one line, in the language in use.
    fn line(&self) -> String {
        said!(
            "complaint",
            "file" => escaped(&self.file),
            "place" => cut(&self.place.to_string()),
            "value" => cut(&self.value.to_string()),
            "remedy" => shown(&self.remedy.to_string(), LONGEST_REMEDY)
        )
    }
}

/// Complaints that are listed one by one: a terminal's height. Chosen.
const MOST_TOLD: usize = 20;

/// All complaints about a scene; never empty.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.told())]
pub struct SceneErrors(pub Vec<SceneError>);

impl SceneErrors {
    /// A line each, of many the first ones and how many there are beside them.
    fn told(&self) -> String {
        let mut lines: Vec<String> = self.0.iter().take(MOST_TOLD).map(ToString::to_string).collect();
        let more = self.0.len() - lines.len();
        if more > 0 {
            lines.push(said!("complaints-more", "more" => more));
        }
        lines.join("\n")
    }

    /// The complaints, about a file by this name.
    #[must_use]
    pub fn in_file(mut self, file: &str) -> Self {
        for error in &mut self.0 {
            file.clone_into(&mut error.file);
        }
        self
    }
}

impl From<SceneError> for SceneErrors {
    fn from(error: SceneError) -> Self {
        Self(vec![error])
    }
}

/// The complaints so far.
#[derive(Debug, Default)]
pub(super) struct Complaints(Vec<SceneError>);

impl Complaints {
    /// Complaints about what stands under `table`, whose keys are these.
    pub(super) fn at(&mut self, table: impl Into<String>, keys: &'static [Key]) -> At<'_> {
        At { complaints: self, table: Table::Called(table.into()), keys }
    }

    /// Complaints about a body: `girder` or `abutment`, and its name.
    pub(super) fn of<'a>(&'a mut self, kind: &'a str, name: &'a str, keys: &'static [Key]) -> At<'a> {
        At { complaints: self, table: Table::Body(kind, name), keys }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn extend(&mut self, errors: SceneErrors) {
        self.0.extend(errors.0);
    }

    pub(super) fn into_result(self) -> Result<(), SceneErrors> {
        if self.0.is_empty() { Ok(()) } else { Err(SceneErrors(self.0)) }
    }
}

/// Name of a table, formatted for a complaint only.
#[derive(Debug)]
enum Table<'a> {
    Called(String),
    Body(&'a str, &'a str),
    Below(&'a Table<'a>, &'a str),
}

impl Display for Table<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Called(name) => f.write_str(name),
            Self::Body(kind, name) => write!(f, "{kind}.{name}"),
            Self::Below(table, key) => write!(f, "{table}.{key}"),
        }
    }
}

/// A table of the scene, being checked.
#[derive(Debug)]
pub(super) struct At<'a> {
    complaints: &'a mut Complaints,
    table: Table<'a>,
    keys: &'static [Key],
}

impl At<'_> {
    pub(super) fn add(&mut self, key: &str, value: impl Into<Message>, remedy: impl Into<Message>) {
        let top = matches!(&self.table, Table::Called(name) if name.is_empty());
        let dot = if top || key.is_empty() { "" } else { "." };
        self.complaints.0.push(SceneError {
            file: "scene".to_owned(),
            place: format!("{}{dot}{key}", self.table).into(),
            value: value.into(),
            remedy: remedy.into(),
        });
    }

    /// A table below this one, with keys of its own.
    pub(super) fn below<'b>(&'b mut self, key: &'b str, keys: &'static [Key]) -> At<'b> {
        At { table: Table::Below(&self.table, key), complaints: self.complaints, keys }
    }

    /// The rule of a key of this table.
    fn range(&self, key: &str) -> Range {
        let known = keys::find(self.keys, key);
        debug_assert!(known.is_some(), "no key {key} in {}", self.table);
        known.map_or(Range::Any, |key| key.range)
    }

    /// Complains unless the number obeys the rule.
    pub(super) fn obeys(&mut self, key: &str, value: f64, range: Range) {
        if let Some(fault) = range.fault(value) {
            self.add(key, number(value), fault);
        }
    }

    /// Complains unless the number may stand under the key.
    pub(super) fn number(&mut self, key: &str, value: f64) {
        self.obeys(key, value, self.range(key));
    }

    pub(super) fn if_given(&mut self, key: &str, value: Option<f64>) {
        if let Some(value) = value {
            self.number(key, value);
        }
    }

    /// Complains about every number of a table that may not stand under its key.
    pub(super) fn all(&mut self, table: &impl Keyed) {
        self.all_but("", table);
    }

    /// The same, one key left out.
    pub(super) fn all_but(&mut self, left_out: &str, table: &impl Keyed) {
        for (key, stated) in table.stated().filter(|(key, _)| *key != left_out) {
            match stated {
                Stated::Nothing => {}
                Stated::Number(number) => self.number(key, number),
                Stated::Numbers(numbers) => self.each(key, numbers),
                Stated::Lists(lists) => self.each_of(key, lists),
            }
        }
    }

    /// Complains about every number of a table that a scene of this kind has no quantity for.
    pub(super) fn fits(&mut self, table: &impl Keyed, kind: Kind) {
        for (name, stated) in table.stated() {
            let Some(key) = keys::find(self.keys, name) else { continue };
            if let Stated::Number(value) = stated {
                self.fits_key(key, value, kind);
            }
        }
    }

    /// Checks one key.
    pub(super) fn fits_key(&mut self, key: &Key, value: f64, kind: Kind) {
        if key.spatial && kind == Kind::Planar && value != 0.0 {
            let remedy = Text::new("wrong-in-plan");
            self.add(key.name, number(value), remedy);
        }
    }

    /// Complains about numbers that exceed another of which the table states one or both; `in_force` has both.
    pub(super) fn in_order(&mut self, table: &impl Keyed, in_force: &impl Keyed) {
        for upper in self.keys {
            let Range::NotBelow(lower) = upper.range else { continue };
            let given = table.number(upper.name).or(table.number(lower)).is_some();
            let (Some(most), Some(value)) = (in_force.number(upper.name), in_force.number(lower)) else { continue };
            if given && value > most {
                let name = upper.name;
                self.add(lower, number(value), message!("wrong-order", "name" => name, "most" => format!("{most:?}")));
            }
        }
    }

    /// Complains about each number of the list under a key.
    pub(super) fn each(&mut self, key: &str, values: &[f64]) {
        let range = self.range(key);
        for (n, value) in values.iter().enumerate() {
            if let Some(fault) = range.fault(*value) {
                self.add(&format!("{key}[{n}]"), number(*value), fault);
            }
        }
    }

    /// Checks the lists in the list under a key: `at_m[2][0]`.
    pub(super) fn each_of<'l>(&mut self, key: &str, lists: impl IntoIterator<Item = &'l [f64]>) {
        let range = self.range(key);
        for (n, values) in lists.into_iter().enumerate() {
            for (i, value) in values.iter().enumerate() {
                if let Some(fault) = range.fault(*value) {
                    self.add(&format!("{key}[{n}][{i}]"), number(*value), fault);
                }
            }
        }
    }
}

/// A number as it stands in a file.
pub(super) fn number(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { format!("{value:?}") }
}

/// A list of numbers as it stands in a file.
pub(super) fn numbers(values: &[f64]) -> String {
    let list: Vec<String> = values.iter().map(|v| number(*v)).collect();
    format!("[{}]", list.join(", "))
}
