//! What undo calls an edit.

use crate::scene::Scene;
use crate::scene::edit::Edit;

/// What undo calls an edit.
pub(in crate::app) fn name_of_edit(edit: &Edit, scene: &Scene) -> String {
    let girder = |i: &usize| scene.girders.get(*i).map_or("girder", |g| g.name.as_str());
    let abutment = |i: &usize| scene.abutments.get(*i).map_or("abutment", |a| a.name.as_str());
    let pier = |i: &usize| scene.piers.get(*i).map_or("pier", |p| p.name.as_str());
    let device = |id| scene.device(id).map_or_else(|| "device".to_owned(), |d| d.part().ends().name.to_owned());
    match edit {
        Edit::AddGirder(_, new) => format!("add {}", new.name),
        Edit::AddAbutment(_, new) => format!("add {}", new.name),
        Edit::AddPier(_, new) => format!("add {}", new.name),
        Edit::RemovePier(i) => format!("remove {}", pier(i)),
        Edit::ReplacePier(_, new) => format!("change {}", new.name),
        Edit::AddDevice(_, new) => format!("add {}", new.part().ends().name),
        Edit::RemoveDevice(id) => format!("remove {}", device(*id)),
        Edit::ReplaceDevice(_, new) => format!("change {}", new.part().ends().name),
        Edit::RemoveGirder(i) => format!("remove {}", girder(i)),
        Edit::RemoveAbutment(i) => format!("remove {}", abutment(i)),
        Edit::MoveGirder(i, ..) => format!("move {}", girder(i)),
        Edit::ReplaceGirder(i, _) => format!("change {}", girder(i)),
        Edit::ReplaceAbutment(i, _) => format!("change {}", abutment(i)),
        Edit::Rename(from, to) => format!("rename {from} to {to}"),
        Edit::Contact(_) => "change contact".into(),
        Edit::Motion(_) => "change ground motion".into(),
        Edit::Model(_) => "change model".into(),
        Edit::Impact(_) => "change impact numbers".into(),
        Edit::Scene(other) => format!("open {}", other.name),
        Edit::Limits(_) => "change limits".into(),
        Edit::Codes(_) => "change inputs of codes".into(),
        Edit::View(_) => "change view".into(),
        Edit::Set(setting) => format!("set {setting}"),
        Edit::General(_) | Edit::Solver(_) => "change scene".into(),
        Edit::Batch(edits) => match &edits[..] {
            [] => "nothing".into(),
            [one] => name_of_edit(one, scene),
            [first, ..] => {
                let first = name_of_edit(first, scene);
                format!("{} {} things", first.split(' ').next().unwrap_or("change"), edits.len())
            }
        },
    }
}
