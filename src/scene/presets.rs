//! Scenes that come with the program.

use super::{Scene, SceneError, SceneErrors, format};
use crate::language::message;

/// A scene that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// What `run NAME` calls it.
    pub name: &'static str,
    /// One line on what it shows.
    pub summary: &'static str,
    /// Its file.
    pub text: &'static str,
}

/// The preset that the workbench opens on.
pub const OPENING: &str = "skew45-abutment";

macro_rules! preset {
    ($name:literal, $summary:literal) => {
        Preset {
            name: $name,
            summary: $summary,
            text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/presets/", $name, ".toml")),
        }
    };
}

static PRESETS: [Preset; 13] = [
    preset!("straight-abutment", "paper: straight girder head-on against an abutment, 2.4 Hz, 0.40 g"),
    preset!("skew60-abutment", "paper: 60° girder against an abutment, 2.6 Hz, 0.40 g"),
    preset!("skew45-abutment", "paper: 45° girder against an abutment, 2.6 Hz, 0.40 g"),
    preset!("straight-straight", "paper: two straight girders of different period, shaken at 22.5°, 0.40 g"),
    preset!("flush-free-hit", "one flush hit of a free girder at 0.5 m/s: it returns the restitution asked for"),
    preset!("deck-30m", "full scale, spatial, with gravity: 30 m deck of 60° skew between two abutments"),
    preset!("deck-30m-elastic", "the same deck in plan, of concrete that shortens, bends and rings, one abutment"),
    preset!("el-centro-45", "45° girder under a synthetic earthquake with the peak of El Centro, 0.313 g"),
    preset!("two-components", "45° girder under two horizontal components of a synthetic earthquake at once"),
    preset!("row-of-5", "five 30 m girders of different period in a row, 50 mm apart: neighbours pound"),
    preset!("viaduct-5", "five 30 m spans of 60° skew on four piers between abutments, two components"),
    preset!(
        "span-as-built",
        "full scale: a 60° span on lead rubber, with restrainers, backfill and seats, 40 s of an earthquake"
    ),
    preset!(
        "twin-span-restrained",
        "full scale: two 60° spans on lead rubber of different period, tied by cables over the pier"
    ),
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

fn unknown(name: &str) -> SceneError {
    let names: Vec<_> = PRESETS.iter().map(|preset| preset.name).collect();
    SceneError {
        file: name.to_owned(),
        place: "preset".into(),
        value: format!("\"{name}\"").into(),
        remedy: message!("wrong-preset", "meant" => format::did_you_mean(name, &names), "names" => names.join(", ")),
    }
}
