//! Adds, copies, arrays, nudges and removes: from a command and what is selected to an edit.

use super::change::{add_abutment, gap_of, remove, shifted};
use super::devices::{copy, new_device};
use super::piers::{add_pier, add_pier_like};
use super::selection::Selection;
use super::spans::{add_girder, add_span, array};
use crate::app::command::{Nudge, PlaceCommand, RowDraft};
use crate::scene::edit::Edit;
use crate::scene::{DeviceId, Scene};
use crate::view::Target;

/// Most spans that an array makes: more than any bridge has, and few enough to be run.
pub(in crate::app) const MOST_SPANS: usize = 1000;

/// Result of a placing command.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub(super) edit: Edit,
    /// Selection after it; `None` leaves the selection as it is.
    pub(super) then: Option<Vec<Target>>,
}

/// The row that is offered at first: five spans with the gap that the scene has.
pub(in crate::app) fn offered_row(scene: &Scene) -> RowDraft {
    RowDraft { spans: 5, gap: gap_of(scene).unwrap_or(0.003) }
}

/// Result of a placing command; `None` when the scene or the selection gives it nothing to do.
pub(super) fn placed(command: PlaceCommand, scene: &Scene, selection: &Selection) -> Option<Placed> {
    let girder = selection.girders().last();
    let (edit, then) = match command {
        PlaceCommand::Put(edit) => {
            let new = match &edit {
                Edit::AddGirder(i, _) => Target::Girder(*i),
                Edit::AddPier(i, _) => Target::Pier(*i),
                _ => Target::Abutment(scene.abutments.len()),
            };
            (edit, Some(vec![new]))
        }
        PlaceCommand::AddGirder => (add_span(scene, girder), Some(vec![Target::Girder(scene.girders.len())])),
        PlaceCommand::AddAbutment => {
            (add_abutment(scene, girder)?, Some(vec![Target::Abutment(scene.abutments.len())]))
        }
        PlaceCommand::AddPier => (add_pier(scene, girder)?, Some(vec![Target::Pier(scene.piers.len())])),
        PlaceCommand::AddDevice(kind) => {
            let new = new_device(scene, kind, selection.all())?;
            let number = scene.count_of(kind);
            let target = Target::Device(DeviceId { kind, number });
            (Edit::AddDevice(number, Box::new(new)), Some(vec![target]))
        }
        PlaceCommand::Duplicate => return duplicates(scene, selection),
        PlaceCommand::Array(row) => return row_of(scene, selection, row),
        PlaceCommand::Remove => (removal(selection)?, Some(Vec::new())),
        PlaceCommand::Nudge(by) => (nudge(scene, selection.all(), by)?, None),
    };
    Some(Placed { edit, then })
}

fn duplicates(scene: &Scene, selection: &Selection) -> Option<Placed> {
    let mut scene = scene.clone();
    let (mut edits, mut copies) = (Vec::new(), Vec::new());
    for target in selection.bodies() {
        let (edit, copy) = match target {
            Target::Girder(i) => (Some(add_girder(&scene, Some(i))), Target::Girder(scene.girders.len())),
            Target::Pier(i) => (add_pier_like(&scene, i), Target::Pier(scene.piers.len())),
            Target::Device(id) => {
                let new = DeviceId { number: scene.count_of(id.kind), ..id };
                let copied = copy(&scene, id).map(|device| Edit::AddDevice(new.number, Box::new(device)));
                (copied, Target::Device(new))
            }
            _ => (add_abutment(&scene, None), Target::Abutment(scene.abutments.len())),
        };
        let Some(edit) = edit.filter(|e| e.clone().apply(&mut scene).is_ok()) else { continue };
        edits.push(edit);
        copies.push(copy);
    }
    (!copies.is_empty()).then_some(Placed { edit: Edit::Batch(edits), then: Some(copies) })
}

/// So many spans like the one selected, in a row along its axis.
fn row_of(scene: &Scene, selection: &Selection, row: RowDraft) -> Option<Placed> {
    let girder = selection.girders().last().or((!scene.girders.is_empty()).then_some(0));
    let first = girder.filter(|_| row.gap.is_finite() && (2..=MOST_SPANS).contains(&row.spans))?;
    let copies = (scene.girders.len()..).take(row.spans - 1).map(Target::Girder);
    Some(Placed {
        edit: array(scene, first, row.spans, row.gap),
        then: Some(std::iter::once(Target::Girder(first)).chain(copies).collect()),
    })
}

fn removal(selection: &Selection) -> Option<Edit> {
    let mut gone: Vec<Target> = selection.bodies().collect();
    // The last first, so that the numbers of the others stay; a girder takes its abutments along, so it comes last.
    gone.sort_by_key(|t| std::cmp::Reverse(*t));
    let mut edits: Vec<Edit> = gone.into_iter().filter_map(remove).collect();
    match edits.len() {
        0 => None,
        1 => edits.pop(),
        _ => Some(Edit::Batch(edits)),
    }
}

/// Moves and turns bodies by so much.
fn nudge(scene: &Scene, targets: &[Target], by: Nudge) -> Option<Edit> {
    let mut moved: Vec<Edit> = targets.iter().filter_map(|t| shifted(scene, *t, by.way, by.turn_deg)).collect();
    if moved.len() > 1 { Some(Edit::Batch(moved)) } else { moved.pop() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    fn opening() -> Scene {
        presets::load(presets::OPENING).expect("ships")
    }

    #[test]
    fn nothing_selected_gives_nothing_to_copy_move_or_remove() {
        let (scene, none) = (opening(), Selection::default());
        let nudge = Nudge { way: [1.0, 0.0], turn_deg: 0.0 };
        for command in [PlaceCommand::Duplicate, PlaceCommand::Remove, PlaceCommand::Nudge(nudge)] {
            assert!(placed(command.clone(), &scene, &none).is_none(), "{command:?} has nothing to do");
        }
    }

    #[test]
    fn a_row_selects_its_spans_and_refuses_impossible_numbers() {
        let scene = opening();
        let mut selection = Selection::default();
        selection.only(Some(Target::Girder(0)));
        let row = |spans, gap| PlaceCommand::Array(RowDraft { spans, gap });
        let made = placed(row(3, 0.01), &scene, &selection).expect("three spans");
        assert_eq!(made.then.map(|all| all.len()), Some(3), "the first and two copies");
        for (spans, gap) in [(1, 0.01), (MOST_SPANS + 1, 0.01), (3, f64::NAN)] {
            assert!(placed(row(spans, gap), &scene, &selection).is_none(), "{spans} spans, gap {gap} m");
        }
    }
}
