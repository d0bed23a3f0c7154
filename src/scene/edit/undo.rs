//! Undo and redo without limit; one drag of the mouse or a slider is one step.

use super::{Edit, EditError};
use crate::scene::Scene;

/// A step that can be undone or redone.
#[derive(Clone, Debug)]
struct Step {
    /// For menus: "Undo move deck".
    label: String,
    edit: Edit,
    /// Value that the step drags, while it may still grow.
    dragging: Option<String>,
}

/// Edits done to a scene, and edits undone.
#[derive(Clone, Debug, Default)]
pub struct UndoStack {
    done: Vec<Step>,
    undone: Vec<Step>,
}

impl UndoStack {
    /// Does an edit as a step of its own.
    ///
    /// # Errors
    /// As [`Edit::apply`]; scene and steps are then as they were.
    pub fn perform(&mut self, scene: &mut Scene, edit: Edit, label: &str) -> Result<(), EditError> {
        self.push(scene, edit, label, None)
    }

    /// Does an edit that is part of a drag: directly after an edit of the same `key` it becomes one step with it, until
    /// [`seal`](Self::seal), another edit, or an undo ends the drag.
    ///
    /// # Errors
    /// As [`Edit::apply`]; scene and steps are then as they were.
    pub fn drag(&mut self, scene: &mut Scene, edit: Edit, label: &str, key: &str) -> Result<(), EditError> {
        self.push(scene, edit, label, Some(key.to_owned()))
    }

    fn push(&mut self, scene: &mut Scene, edit: Edit, label: &str, key: Option<String>) -> Result<(), EditError> {
        let inverse = edit.apply(scene)?;
        self.undone.clear();
        match self.done.last_mut() {
            Some(last) if key.is_some() && last.dragging == key => {
                if !last.edit.covers(&inverse) {
                    let earlier = std::mem::replace(&mut last.edit, Edit::Batch(Vec::new()));
                    last.edit = after(inverse, earlier);
                }
            }
            _ => {
                self.seal();
                self.done.push(Step { label: label.to_owned(), edit: inverse, dragging: key });
            }
        }
        Ok(())
    }

    /// Ends a drag: the next edit is a step of its own.
    pub fn seal(&mut self) {
        if let Some(last) = self.done.last_mut() {
            last.dragging = None;
        }
    }

    /// Takes back what a drag has done, as if it had never begun; false when the last step is not this drag.
    ///
    /// # Errors
    /// As [`undo`](Self::undo).
    pub fn abandon(&mut self, scene: &mut Scene, key: &str) -> Result<bool, EditError> {
        let Some(step) = self.done.last().filter(|step| step.dragging.as_deref() == Some(key)) else {
            return Ok(false);
        };
        step.edit.clone().apply(scene)?;
        self.done.pop();
        Ok(true)
    }

    /// Undoes the last step; false when there is none.
    ///
    /// # Errors
    /// The scene was changed by other means, and the step does not fit it any more; the step stays.
    pub fn undo(&mut self, scene: &mut Scene) -> Result<bool, EditError> {
        shift(&mut self.done, &mut self.undone, scene)
    }

    /// Does the last undone step again; false when there is none.
    ///
    /// # Errors
    /// As [`undo`](Self::undo).
    pub fn redo(&mut self, scene: &mut Scene) -> Result<bool, EditError> {
        shift(&mut self.undone, &mut self.done, scene)
    }

    /// Label of the edit that [`undo`](Self::undo) reverts.
    pub fn undo_label(&self) -> Option<&str> {
        self.done.last().map(|step| step.label.as_str())
    }

    /// Label of the edit that [`redo`](Self::redo) repeats.
    pub fn redo_label(&self) -> Option<&str> {
        self.undone.last().map(|step| step.label.as_str())
    }

    /// Number of steps that can be undone.
    pub fn depth(&self) -> usize {
        self.done.len()
    }
}

/// Undoes the later edit, then the earlier ones, as one flat batch.
fn after(later: Edit, earlier: Edit) -> Edit {
    let mut edits = vec![later];
    match earlier {
        Edit::Batch(earlier) => edits.extend(earlier),
        other => edits.push(other),
    }
    Edit::Batch(edits)
}

/// Applies the last step of one list and keeps its inverse on the other.
fn shift(from: &mut Vec<Step>, to: &mut Vec<Step>, scene: &mut Scene) -> Result<bool, EditError> {
    let Some(step) = from.last() else { return Ok(false) };
    let edit = step.edit.clone().apply(scene)?;
    if let Some(step) = from.pop() {
        to.push(Step { edit, dragging: None, ..step });
    }
    Ok(true)
}
