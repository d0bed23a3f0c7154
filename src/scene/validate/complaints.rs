//! Complaints about a scene, and the checks of single numbers that make them.

use std::fmt::Display;

/// One complaint about a scene.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{file}: {place}: found {value}; {remedy}")]
pub struct SceneError {
    /// The file, or the preset's name, or "scene".
    pub file: String,
    /// `girder.deck.mass_kg`
    pub place: String,
    /// What stands there.
    pub value: String,
    /// What is wrong and what would be right.
    pub remedy: String,
}

/// All complaints about a scene; never empty.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
pub struct SceneErrors(pub Vec<SceneError>);

impl SceneErrors {
    /// The same complaints, about a file by this name.
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
    /// Complaints about what stands under `table`.
    pub(super) fn at(&mut self, table: impl Into<String>) -> At<'_> {
        At { complaints: self, table: table.into() }
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

/// A table of the scene, being checked.
#[derive(Debug)]
pub(super) struct At<'a> {
    complaints: &'a mut Complaints,
    table: String,
}

/// Beyond this no unit of this world makes sense, and squares begin to overflow.
const LARGEST: f64 = 1e15;
/// Likewise below.
const SMALLEST: f64 = 1e-15;

impl At<'_> {
    pub(super) fn add(&mut self, key: &str, value: impl Display, remedy: impl Into<String>) {
        let dot = if self.table.is_empty() || key.is_empty() { "" } else { "." };
        self.complaints.0.push(SceneError {
            file: "scene".to_owned(),
            place: format!("{}{dot}{key}", self.table),
            value: value.to_string(),
            remedy: remedy.into(),
        });
    }

    /// A table below this one.
    pub(super) fn below(&mut self, key: &str) -> At<'_> {
        At { table: format!("{}.{key}", self.table), complaints: self.complaints }
    }

    /// Complains unless `sound`; false for NaN and infinity whatever the rule says.
    fn rule(&mut self, key: &str, value: f64, sound: bool, rule: &str) -> bool {
        if !value.is_finite() {
            self.add(key, number(value), format!("it must be a finite number: {rule}"));
        } else if !sound {
            self.add(key, number(value), rule);
        }
        sound && value.is_finite()
    }

    pub(super) fn finite(&mut self, key: &str, value: f64) {
        self.rule(key, value, value.abs() <= LARGEST, "give a plain number, no larger than 1e15");
    }

    pub(super) fn positive(&mut self, key: &str, value: f64) {
        self.rule(key, value, value > 0.0, "give a number greater than 0");
        if value > 0.0 && value.is_finite() && !(SMALLEST..=LARGEST).contains(&value) {
            self.rule(key, value, false, "give a number from 1e-15 to 1e15");
        }
    }

    pub(super) fn not_negative(&mut self, key: &str, value: f64) {
        self.rule(key, value, value >= 0.0, "give 0 or a number greater than 0");
        if value > LARGEST && value.is_finite() {
            self.rule(key, value, false, "give a number no larger than 1e15");
        }
    }

    pub(super) fn within(&mut self, key: &str, value: f64, [low, high]: [f64; 2]) {
        if (low..=high).contains(&value) {
            return;
        }
        let rule = format!("give a number from {low:?} to {high:?}");
        self.rule(key, value, false, &rule);
    }

    pub(super) fn between(&mut self, key: &str, value: f64, [low, high]: [f64; 2]) {
        if low < value && value < high {
            return;
        }
        let rule = format!("give a number between {low:?} and {high:?}, the limits excluded");
        self.rule(key, value, false, &rule);
    }

    /// Every number of a list; the complaint names the number's place in it.
    pub(super) fn each(&mut self, key: &str, values: &[f64], check: fn(&mut Self, &str, f64)) {
        for (n, value) in values.iter().enumerate() {
            check(self, &format!("{key}[{n}]"), *value);
        }
    }

    /// A number that may be missing.
    pub(super) fn if_given(&mut self, key: &str, value: Option<f64>, check: fn(&mut Self, &str, f64)) {
        if let Some(value) = value {
            check(self, key, value);
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
