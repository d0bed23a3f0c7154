//! Scenes that come with the program.

use super::{Scene, SceneError, SceneErrors, format};
use crate::language::{Language, Text, message};

/// A scene that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// Name for `run NAME`.
    pub name: &'static str,
    /// One line on what it shows.
    pub summary: Text,
    /// Its file.
    pub text: &'static str,
}

/// The preset that the workbench opens on.
pub const OPENING: &str = "skew45-abutment";

macro_rules! preset {
    ($name:literal, $summary:literal) => {
        Preset {
            name: $name,
            summary: Text::new($summary),
            text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/presets/", $name, ".toml")),
        }
    };
}

static PRESETS: [Preset; 13] = [
    preset!("straight-abutment", "preset-straight-abutment"),
    preset!("skew60-abutment", "preset-skew60-abutment"),
    preset!("skew45-abutment", "preset-skew45-abutment"),
    preset!("straight-straight", "preset-straight-straight"),
    preset!("flush-free-hit", "preset-flush-free-hit"),
    preset!("deck-30m", "preset-deck-30m"),
    preset!("deck-30m-elastic", "preset-deck-30m-elastic"),
    preset!("el-centro-45", "preset-el-centro-45"),
    preset!("two-components", "preset-two-components"),
    preset!("row-of-5", "preset-row-of-5"),
    preset!("viaduct-5", "preset-viaduct-5"),
    preset!("span-as-built", "preset-span-as-built"),
    preset!("twin-span-restrained", "preset-twin-span-restrained"),
];

/// Every preset, the paper's first.
pub fn all() -> &'static [Preset] {
    &PRESETS
}

/// The preset of this name.
pub fn get(name: &str) -> Option<&'static Preset> {
    PRESETS.iter().find(|preset| preset.name == name)
}

/// The scene of the preset of this name.
///
/// # Errors
/// There is no such preset.
pub fn load(name: &str) -> Result<Scene, SceneErrors> {
    get(name).ok_or_else(|| unknown(name).into()).and_then(|preset| format::parse(preset.text, preset.name))
}

/// Description of a scene; of a preset in the language in use, unless the user changed it.
pub fn told(scene: &Scene) -> &str {
    let own = scene.description.as_str();
    let preset = get(&scene.name).filter(|_| Language::current() != Language::English);
    let unchanged = preset.filter(|preset| load(preset.name).is_ok_and(|preset| preset.description == own));
    unchanged.map_or(own, |preset| preset.summary.as_str())
}

fn unknown(name: &str) -> SceneError {
    let names: Vec<_> = PRESETS.iter().map(|preset| preset.name).collect();
    SceneError {
        file: name.to_owned(),
        place: "preset".into(),
        value: format!("\"{name}\"").into(),
        remedy: message!("wrong-preset", "meant" => format::did_you_mean(name, &names), "names" => names.join(", ")),
    }
}
