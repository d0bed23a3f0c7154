//! Assumed values that an edit states.

use crate::scene::edit::{Edit, EditError};
use crate::scene::{Girder, Scene, is_assumed};

/// An edit with what it says of assumed values: a number that it changes is given now, but for what follows the outline of a girder, its
/// bearings and its mass.
pub(super) fn with_assumed(edit: Edit, before: &Scene, after: &Scene) -> Edit {
    // Another scene comes with its own list, which may read as the one before; so does the list itself, and a renamed body's paths have
    // been renamed.
    if matches!(edit, Edit::Scene(_)) || before.assumed != after.assumed || before.assumed.is_empty() {
        return edit;
    }
    let outline = |girder: &Girder| (girder.length, girder.width, girder.skew_deg);
    let pairs = before.girders.iter().zip(&after.girders);
    let reshaped = pairs.filter(|(old, new)| old.name == new.name && outline(old) != outline(new));
    let followers: Vec<String> =
        reshaped.flat_map(|(old, _)| ["bearings", "mass_kg"].map(|key| format!("girder.{}.{key}", old.name))).collect();
    let still = before.still_assumed(after);
    let left = before.assumed.iter().flat_map(|path| {
        if followers.iter().any(|follower| is_part(path, follower)) {
            return vec![path.clone()];
        }
        still.iter().filter(|part| is_part(part, path)).cloned().collect()
    });
    let left: Vec<String> = left.collect();
    if left == before.assumed { edit } else { Edit::Batch(vec![edit, Edit::Assumed(left)]) }
}

/// Whether a path is another one or leads on from it.
fn is_part(path: &str, whole: &str) -> bool {
    path.strip_prefix(whole).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// An edit that adds something, with its numbers, but for its place, as assumed.
///
/// # Errors
/// An edit that does not fit the scene.
pub(super) fn with_new_assumed(edit: Edit, before: &Scene) -> Result<Edit, EditError> {
    let mut after = before.clone();
    edit.clone().apply(&mut after)?;
    let new = after.new_numbers(before);
    let listed =
        before.assumed.iter().cloned().chain(new.into_iter().filter(|path| !is_assumed(&before.assumed, path)));
    Ok(Edit::Batch(vec![edit, Edit::Assumed(listed.collect())]))
}
