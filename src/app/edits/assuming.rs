//! What an edit says of assumed values.

use super::change::girder;
use crate::scene::edit::{Edit, EditError};
use crate::scene::{Girder, Scene, is_assumed};

/// An edit with what it says of assumed values: a number that it changes is given now. Of a girder with another outline the bearings, whose
/// places are shares of the plan, stay assumed where they were, and the mass follows the plan's area.
pub(super) fn with_assumed(edit: Edit, before: &Scene, after: &Scene) -> Edit {
    // Another scene comes with its own list, which may read as the one before; so does the list itself, and a renamed body's paths have
    // been renamed.
    if matches!(edit, Edit::Scene(_)) || before.assumed != after.assumed || before.assumed.is_empty() {
        return edit;
    }
    let outline = |girder: &Girder| (girder.length, girder.width, girder.skew_deg);
    let pairs = before.girders.iter().zip(&after.girders).enumerate();
    let reshaped: Vec<_> =
        pairs.filter(|(_, (old, new))| old.name == new.name && outline(old) != outline(new)).collect();
    let of_bearings = |path: &str, name: &str| {
        path.strip_prefix(&format!("girder.{name}.bearings"))
            .is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
    };
    let still = before.still_assumed(after);
    let left = before.assumed.iter().flat_map(|path| {
        if reshaped.iter().any(|(_, (old, _))| of_bearings(path, &old.name)) {
            return vec![path.clone()];
        }
        let is_part = |part: &&String| {
            part.strip_prefix(path.as_str()).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        still.iter().filter(is_part).cloned().collect()
    });
    let left: Vec<String> = left.collect();
    let masses = reshaped.iter().filter_map(|(i, (old, new))| {
        let area = new.length * new.width / (old.length * old.width);
        let is_left = old.mass == new.mass && is_assumed(&left, &format!("girder.{}.mass_kg", old.name));
        let mass = to_four_digits(new.mass * area);
        (is_left && area != 1.0 && mass > 0.0 && mass.is_finite())
            .then(|| girder(*i, Girder { mass, ..(*new).clone() }))
    });
    let masses: Vec<Edit> = masses.collect();
    if left == before.assumed && masses.is_empty() {
        return edit;
    }
    Edit::Batch(std::iter::once(edit).chain(masses).chain([Edit::Assumed(left)]).collect())
}

/// A positive number to four significant digits.
fn to_four_digits(value: f64) -> f64 {
    let step = 10f64.powf(value.log10().floor() - 3.0);
    (value / step).round() * step
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
