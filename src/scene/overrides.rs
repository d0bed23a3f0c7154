//! `--set motion.angle_deg=45`: any value of a scene, by its path in the file.
//!
//! A path walks the file's tables by key and its lists by name or number (`girder.deck.skew_deg`,
//! `contact.pair.0.mu_static`). The scene is laid out as the table that it would be written as, changed there, and read
//! again by the reader of files: so everything that a file can say can be set, and complaints are the same.

use crate::language::{Message, Text, message};
use toml::{Table, Value};

use super::path::{item_of, items, value_at};
use super::shown::shown;
use super::{Motion, Scene, SceneError, SceneErrors, assumed, format};

/// Keys that say the same thing in different ways: setting the first removes the others from its table.
const REPLACES: &[(&str, &[&str])] = &[
    ("amplitude_g", &["amplitude_m_s2"]),
    ("amplitude_m_s2", &["amplitude_g"]),
    ("vertical_amplitude_g", &["vertical_amplitude_m_s2"]),
    ("vertical_amplitude_m_s2", &["vertical_amplitude_g"]),
    ("gap_m", &["polygon_m"]),
    ("polygon_m", &["gap_m", "width_m", "height_m", "offset_m"]),
    (
        "stiffness_n_per_m",
        &[
            "young_modulus_pa",
            "area_m2",
            "contact_length_m",
            "axial_stiffness_n",
            "length_m",
            "depth_force_m_n",
            "frequency_hz",
            "column_m",
            "column_top",
        ],
    ),
    ("frequency_hz", &["stiffness_n_per_m", "column_m", "column_top", "young_modulus_pa"]),
    ("column_m", &["stiffness_n_per_m", "frequency_hz"]),
    ("contact_length_m", &["stiffness_n_per_m"]),
    ("axial_stiffness_n", &["stiffness_n_per_m"]),
    ("depth_force_m_n", &["stiffness_n_per_m"]),
    ("break_force_n", &["yield_force_n", "break_displacement_m"]),
    ("yield_force_n", &["break_force_n"]),
    ("young_modulus_pa", &["stiffness_n_per_m"]),
    ("area_m2", &["stiffness_n_per_m", "density_kg_m3"]),
    ("density_kg_m3", &["area_m2"]),
    ("damping_ratio", &["rayleigh"]),
    ("rayleigh", &["damping_ratio"]),
    ("at_m", &["at_skewed_m"]),
    ("at_skewed_m", &["at_m"]),
    ("samples_m_s2", &["file"]),
    ("file", &["samples_m_s2", "dt_s"]),
];

/// Keys that replace nothing in the tables of this name: E of a pier's columns belongs to `column_m`.
const BESIDE: &[(&str, &str)] = &[("pier", "young_modulus_pa")];

/// Keys of the same table that go when this key is given: they say the same thing in another way.
pub fn replaced_by(key: &str) -> &'static [&'static str] {
    REPLACES.iter().find(|(setting, _)| *setting == key).map_or(&[], |(_, rivals)| *rivals)
}

/// The scene with one value set: `path=value`.
///
/// # Errors
/// Not of the form `path=value`, nothing of this name on the way, or a value that the file could not have either.
pub fn apply(scene: &Scene, setting: &str) -> Result<Scene, SceneErrors> {
    apply_all(scene, &[setting])
}

/// The scene with several values set, in this order; they are read together, so that keys that need each other
/// (`motion.kind` and `motion.frequency_hz`) may come one by one.
///
/// # Errors
/// As [`apply`]; the complaint names the setting.
pub fn apply_all<S: AsRef<str>>(scene: &Scene, settings: &[S]) -> Result<Scene, SceneErrors> {
    if settings.is_empty() { Ok(scene.clone()) } else { Laid::out(scene)?.with(settings) }
}

/// A scene laid out as the table of its file, to have values set in it again and again.
#[derive(Clone, Debug)]
pub struct Laid {
    scene: Scene,
    table: Table,
}

impl Laid {
    /// Lays a scene out.
    ///
    /// # Errors
    /// A scene that cannot be written.
    pub fn out(scene: &Scene) -> Result<Self, SceneErrors> {
        let table = Table::try_from(scene);
        let table = table.map_err(|error| complaint("", error.to_string(), Text::new("wrong-unwritable")))?;
        Ok(Self { scene: scene.clone(), table })
    }

    /// The scene with several values set: [`apply_all`].
    ///
    /// # Errors
    /// Those of [`apply_all`].
    pub fn with<S: AsRef<str>>(&self, settings: &[S]) -> Result<Scene, SceneErrors> {
        let settings: Vec<Setting<'_>> =
            settings.iter().map(|s| Setting::parse(s.as_ref())).collect::<Result<_, _>>()?;
        let mut table = self.table.clone();
        for setting in &settings {
            setting.set_in(&mut table)?;
        }
        let sets_list = settings.iter().any(|setting| setting.path == ["assumed"]);
        if !self.scene.assumed.is_empty() && !sets_list {
            let left = assumed::left(&self.scene.assumed, &self.table, &table);
            table.insert("assumed".to_owned(), left.into());
        }
        let mut changed = format::from_table(table, "scene").map_err(|errors| blame(errors, &settings))?;
        keep_loaded(&self.scene, &mut changed);
        Ok(changed)
    }

    /// Value at a path.
    pub fn value(&self, path: &str) -> Option<&Value> {
        value_at(&self.table, path)
    }
}

/// Keeps the samples read from a record's file, which are no part of the written scene, while the file is the same.
fn keep_loaded(scene: &Scene, changed: &mut Scene) {
    for (place, after) in changed.motions_mut() {
        let before = scene.motions().find(|(before, _)| *before == place).map(|(_, motion)| motion);
        if let (Some(Motion::Record(before)), Motion::Record(after)) = (before, after) {
            after.take_loaded(before);
        }
    }
}

/// Most steps of a path: no value of a scene is deeper, and a tree of any depth is no table that can be read.
const LONGEST_PATH: usize = 16;

struct Setting<'a> {
    /// As given.
    text: &'a str,
    path: Vec<&'a str>,
    value: Value,
}

fn complaint(setting: &str, value: impl Into<Message>, remedy: impl Into<Message>) -> SceneErrors {
    let place = format!("--set {setting}").into();
    SceneError { file: "scene".to_owned(), place, value: value.into(), remedy: remedy.into() }.into()
}

impl<'a> Setting<'a> {
    fn parse(text: &'a str) -> Result<Self, SceneErrors> {
        let Some((path, value)) = text.split_once('=') else {
            return Err(complaint(text, Text::new("found-no-equals"), Text::new("wrong-setting")));
        };
        let path: Vec<&str> = path.split('.').map(str::trim).collect();
        if path.len() > LONGEST_PATH {
            return Err(complaint(
                &shown(text, 80),
                message!("found-steps", "steps" => path.len()),
                Text::new("wrong-setting"),
            ));
        }
        if path.iter().any(|step| step.is_empty()) {
            return Err(complaint(text, Text::new("found-empty-step"), Text::new("wrong-setting")));
        }
        Ok(Self { text, path, value: value_of(text, value.trim())? })
    }

    fn set_in(&self, table: &mut Table) -> Result<(), SceneErrors> {
        let Some((key, way)) = self.path.split_last() else { return Ok(()) };
        let mut here = table;
        let mut rest = way;
        while let Some((step, after)) = rest.split_first() {
            let number = after.first().filter(|item| item.parse::<usize>().is_ok());
            if let (false, Some(item)) = (here.contains_key(*step), number) {
                return Err(self.not_there(item, &[]));
            }
            if !here.contains_key(*step) {
                set(here, step, Value::Table(Table::new()));
            }
            let Some(next) = here.get_mut(*step) else { return Ok(()) };
            rest = after;
            let into = match next {
                Value::Array(list) => {
                    let Some((item, after)) = after.split_first() else {
                        // The last step is an item of this list.
                        return self.set_item(list, key);
                    };
                    rest = after;
                    let names = items(list);
                    item_of(list, item).ok_or_else(|| self.not_there(item, &names))?
                }
                other => other,
            };
            let found = into.type_str();
            here = into.as_table_mut().ok_or_else(|| self.no_table(step, found))?;
        }
        if matches!(self.path[..], ["motion", "kind"] | ["ground", _, "kind"]) {
            self.change_kind(here);
        }
        if BESIDE.contains(&(self.path[0], *key)) {
            here.insert((*key).to_owned(), self.value.clone());
        } else {
            set(here, key, self.value.clone());
        }
        Ok(())
    }

    /// Another kind of motion has other keys; the direction is the one that they share.
    fn change_kind(&self, motion: &mut Table) {
        if motion.get("kind") != Some(&self.value) {
            let moves = self.value.as_str() != Some("none");
            motion.retain(|key, _| key == "name" || moves && key == "angle_deg");
        }
    }

    /// `girder.deck.position_m.0=1`: a number of a list.
    fn set_item(&self, list: &mut [Value], item: &str) -> Result<(), SceneErrors> {
        let names = items(list);
        *item_of(list, item).ok_or_else(|| self.not_there(item, &names))? = self.value.clone();
        Ok(())
    }

    fn not_there(&self, item: &str, names: &[String]) -> SceneErrors {
        let known: Vec<&str> = names.iter().map(String::as_str).collect();
        let meant = format::did_you_mean(item, &known);
        let there = if names.is_empty() { Text::new("found-nothing").into() } else { Message::from(names.join(", ")) };
        complaint(self.text, format!("`{item}`"), message!("wrong-not-there", "meant" => meant, "there" => there))
    }

    fn no_table(&self, step: &str, found: &str) -> SceneErrors {
        complaint(
            self.text,
            message!("found-one-value", "step" => step, "found" => found),
            Text::new("wrong-path-ends"),
        )
    }
}

/// The value as TOML; a word that is not TOML stands for itself.
fn value_of(setting: &str, text: &str) -> Result<Value, SceneErrors> {
    let mut read = format!("value = {text}").parse::<Table>().unwrap_or_default();
    match read.remove("value") {
        Some(value) if read.is_empty() => Ok(value),
        _ if text.is_empty() || text.starts_with(['[', '{', '"', '\'']) || text.contains('\n') => {
            let remedy = Text::new("wrong-value");
            Err(complaint(setting, format!("`{text}`"), remedy))
        }
        _ => Ok(Value::String(text.to_owned())),
    }
}

fn set(table: &mut Table, key: &str, value: Value) {
    for rival in replaced_by(key) {
        table.remove(*rival);
    }
    table.insert(key.to_owned(), value);
}

/// The reader's complaints, about the setting that they come from: the last one on the way to the place.
fn blame(errors: SceneErrors, settings: &[Setting<'_>]) -> SceneErrors {
    let about = |error: SceneError| {
        let is_cause = |s: &&Setting<'_>| {
            let path = s.path.join(".");
            let place = error.place.plain();
            place == path || place.starts_with(&format!("{path}.")) || path.starts_with(&format!("{place}."))
        };
        let cause = settings.iter().rfind(is_cause).or(settings.last());
        let (text, path) = cause.map_or(("", String::new()), |s| (s.text, s.path.join(".")));
        let SceneError { place, remedy, .. } = error;
        let remedy =
            if place.plain() == path { remedy } else { message!("wrong-there", "place" => place, "remedy" => remedy) };
        SceneError { place: format!("--set {text}").into(), remedy, ..error }
    };
    SceneErrors(errors.0.into_iter().map(about).collect())
}
