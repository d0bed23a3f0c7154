//! Names in use, and free names.

use crate::scene::Scene;

pub(super) fn is_named(scene: &Scene, name: &str) -> bool {
    let named = |name: &str| scene.devices().iter().any(|(_, device)| device.ends().name == name);
    scene.girders.iter().any(|g| g.name == name)
        || scene.abutments.iter().any(|a| a.name == name)
        || scene.piers.iter().any(|p| p.name == name)
        || named(name)
}

/// A name that no girder, abutment, pier or device has.
pub fn free_name(scene: &Scene, stem: &str) -> String {
    free_among(stem, |name| is_named(scene, name))
}

/// A name that counts on from another: `g6` after `g5`, `deck2` after `deck`, the next one where it is taken.
pub fn free_name_after(scene: &Scene, name: &str) -> String {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &name[stem.len()..];
    let Some(next) = digits.parse::<u32>().ok().and_then(|number| number.checked_add(1)) else {
        return free_name(scene, name);
    };
    let numbered = (next..).map(|n| format!("{stem}{n:0width$}", width = digits.len()));
    numbered.into_iter().find(|name| !is_named(scene, name)).unwrap_or_default()
}

/// A name that is not taken: the stem itself, or the stem with the first free number from 2.
pub fn free_among(stem: &str, taken: impl Fn(&str) -> bool) -> String {
    let numbered = (2..).map(|n: usize| format!("{stem}{n}"));
    std::iter::once(stem.to_owned()).chain(numbered).find(|name| !taken(name)).unwrap_or_default()
}
