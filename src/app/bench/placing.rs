//! Adds, copies, arrays, nudges and removes: what keys and buttons do to what is selected.

use crate::app::bench::Workbench;
use crate::app::command::{Command, Nudge};
use crate::app::edits;
use crate::scene::Scene;
use crate::scene::edit::Edit;
use crate::view::Target;

/// Most spans that an array makes: more than any bridge has, and few enough to be run.
pub(in crate::app) const MOST_SPANS: usize = 1000;

impl Workbench {
    /// Does what a placing command asks.
    pub(in crate::app) fn place(&mut self, command: &Command) {
        let scene = self.scene();
        let girder = self.selection.girders().last();
        let (edit, then) = match *command {
            Command::Place(ref edit) => {
                let new = match edit {
                    Edit::AddGirder(i, _) => Target::Girder(*i),
                    _ => Target::Abutment(scene.abutments.len()),
                };
                (Some(edit.clone()), Some(vec![new]))
            }
            Command::AddGirder => {
                (Some(edits::add_girder(scene, girder)), Some(vec![Target::Girder(scene.girders.len())]))
            }
            Command::AddAbutment => {
                (edits::add_abutment(scene, girder), Some(vec![Target::Abutment(scene.abutments.len())]))
            }
            Command::Duplicate => self.duplicates(),
            Command::Array { spans, gap } => self.array(spans, gap),
            Command::Remove => (self.removal(), Some(Vec::new())),
            Command::Nudge(by) => (nudge(scene, self.selection.all(), by), None),
            _ => (None, None),
        };
        if let Some(edit) = edit {
            self.edit(edit, None);
            if let Some(then) = then.filter(|_| self.notice.is_none()) {
                self.selection.these(then);
            }
        }
    }

    fn duplicates(&self) -> (Option<Edit>, Option<Vec<Target>>) {
        let mut scene = self.scene().clone();
        let (mut edits, mut copies) = (Vec::new(), Vec::new());
        for target in self.selection.bodies() {
            let (edit, copy) = match target {
                Target::Girder(i) => (Some(edits::add_girder(&scene, Some(i))), Target::Girder(scene.girders.len())),
                _ => (edits::add_abutment(&scene, None), Target::Abutment(scene.abutments.len())),
            };
            let Some(edit) = edit.filter(|e| e.clone().apply(&mut scene).is_ok()) else { continue };
            edits.push(edit);
            copies.push(copy);
        }
        (Some(Edit::Batch(edits)).filter(|_| !copies.is_empty()), Some(copies))
    }

    /// So many spans like the one selected, in a row along its axis.
    fn array(&self, spans: usize, gap: f64) -> (Option<Edit>, Option<Vec<Target>>) {
        let scene = self.scene();
        let girder = self.selection.girders().last().or((!scene.girders.is_empty()).then_some(0));
        let Some(first) = girder.filter(|_| gap.is_finite() && (2..=MOST_SPANS).contains(&spans)) else {
            return (None, None);
        };
        let copies = (scene.girders.len()..).take(spans - 1).map(Target::Girder);
        (
            Some(edits::array(scene, first, spans, gap)),
            Some(std::iter::once(Target::Girder(first)).chain(copies).collect()),
        )
    }

    fn removal(&self) -> Option<Edit> {
        let mut gone: Vec<Target> = self.selection.bodies().collect();
        // The last first, so that the numbers of the others stay; a girder takes its abutments along, so it comes last.
        gone.sort_by_key(|t| std::cmp::Reverse(*t));
        let mut edits: Vec<Edit> = gone.into_iter().filter_map(edits::remove).collect();
        match edits.len() {
            0 => None,
            1 => edits.pop(),
            _ => Some(Edit::Batch(edits)),
        }
    }
}

/// Moves and turns bodies by so much.
fn nudge(scene: &Scene, targets: &[Target], by: Nudge) -> Option<Edit> {
    let mut moved: Vec<Edit> = targets.iter().filter_map(|t| edits::shifted(scene, *t, by.way, by.turn_deg)).collect();
    if moved.len() > 1 { Some(Edit::Batch(moved)) } else { moved.pop() }
}
