//! Names of edits for undo.

use crate::language::{Text, values};
use crate::scene::Scene;
use crate::scene::edit::Edit;

/// An edit of what is called so.
fn named(key: &'static str, name: &str) -> String {
    Text::new(key).with(&values!["name" => name])
}

/// Name of an edit for undo.
pub(in crate::app) fn name_of_edit(edit: &Edit, scene: &Scene) -> String {
    let girder = |i: &usize| scene.girders.get(*i).map_or("girder", |g| g.name.as_str());
    let abutment = |i: &usize| scene.abutments.get(*i).map_or("abutment", |a| a.name.as_str());
    let pier = |i: &usize| scene.piers.get(*i).map_or("pier", |p| p.name.as_str());
    let device = |id| scene.device(id).map_or_else(|| "device".to_owned(), |d| d.part().ends().name.to_owned());
    match edit {
        Edit::AddGirder(_, new) => named("edit-add", &new.name),
        Edit::AddAbutment(_, new) => named("edit-add", &new.name),
        Edit::AddPier(_, new) => named("edit-add", &new.name),
        Edit::RemovePier(i) => named("edit-remove", pier(i)),
        Edit::ReplacePier(_, new) => named("edit-change", &new.name),
        Edit::AddDevice(_, new) => named("edit-add", new.part().ends().name),
        Edit::RemoveDevice(id) => named("edit-remove", &device(*id)),
        Edit::ReplaceDevice(_, new) => named("edit-change", new.part().ends().name),
        Edit::RemoveGirder(i) => named("edit-remove", girder(i)),
        Edit::RemoveAbutment(i) => named("edit-remove", abutment(i)),
        Edit::MoveGirder(i, ..) => named("edit-move", girder(i)),
        Edit::ReplaceGirder(i, _) => named("edit-change", girder(i)),
        Edit::ReplaceAbutment(i, _) => named("edit-change", abutment(i)),
        Edit::Rename(from, to) => Text::new("edit-rename").with(&values!["from" => from.as_str(), "to" => to.as_str()]),
        Edit::Contact(_) => Text::new("edit-contact").into(),
        Edit::Motion(_) | Edit::Grounds(_) => Text::new("edit-ground-motion").into(),
        Edit::Wave(_) => Text::new("edit-wave").into(),
        Edit::Model(_) => Text::new("edit-model").into(),
        Edit::Impact(_) => Text::new("edit-impact-numbers").into(),
        Edit::Scene(other) => named("edit-open", &other.name),
        Edit::Limits(_) => Text::new("edit-limits").into(),
        Edit::Codes(_) => Text::new("edit-inputs-of-codes").into(),
        Edit::View(_) => Text::new("edit-view").into(),
        Edit::Set(setting) => Text::new("edit-set").with(&values!["setting" => setting.as_str()]),
        Edit::General(_) | Edit::Solver(_) | Edit::Assumed(_) => Text::new("edit-scene").into(),
        Edit::Batch(edits) => match &edits[..] {
            [] => Text::new("edit-nothing").into(),
            [one] => name_of_edit(one, scene),
            [first, more @ ..] => {
                let first = name_of_edit(first, scene);
                Text::new("edit-several").with(&values!["first" => first, "more" => more.len()])
            }
        },
    }
}
