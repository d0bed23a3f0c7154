//! Who has a name, and which names are free.

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

/// A name that is not taken: the stem itself, or the stem with the first free number from 2.
pub fn free_among(stem: &str, taken: impl Fn(&str) -> bool) -> String {
    let numbered = (2..).map(|n: usize| format!("{stem}{n}"));
    std::iter::once(stem.to_owned()).chain(numbered).find(|name| !taken(name)).unwrap_or_default()
}
