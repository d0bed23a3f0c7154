//! The scene that is worked on: edits, undo and redo, what is selected in it, the file it came from.

use std::path::{Path, PathBuf};

use super::assuming::{with_assumed, with_new_assumed};
use super::change::rename;
use super::placing::placed;
use super::selection::Selection;
use crate::app::command::{EditCommand, PlaceCommand, SelectCommand};
use crate::app::text;
use crate::files::SceneSource;
use crate::scene::Scene;
use crate::scene::edit::{Edit, EditError, UndoStack};

/// Source or target of a stretch of the history.
struct Origin {
    /// Tells it from every other one.
    id: u64,
    /// Steps done when it began: opening a scene is a step that can be undone, and then the older file is meant again.
    depth: usize,
    source: SceneSource,
    /// Scene on the disk, unless another program has changed it.
    saved: Option<Scene>,
    /// Tells the scene that was opened from every other one; saving it goes on with it.
    work: u64,
    /// The origin whose scene was saved as this one.
    saved_from: Option<u64>,
}

/// A scene with its past, and what is selected in it: nothing that the scene does not have.
pub struct Document {
    scene: Scene,
    selection: Selection,
    steps: UndoStack,
    origins: Vec<Origin>,
    /// How many origins there have been.
    begun: u64,
    revision: u64,
}

impl Document {
    /// A scene as it was read.
    pub(in crate::app) fn new(scene: Scene, source: SceneSource) -> Self {
        let origins = vec![Origin { id: 0, depth: 0, source, saved: Some(scene.clone()), work: 0, saved_from: None }];
        Self { scene, selection: Selection::default(), steps: UndoStack::default(), origins, begun: 1, revision: 0 }
    }

    /// The scene as it is now.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Selection.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }

    /// The girder whose curves stand out.
    pub(in crate::app) fn girder_shown(&self) -> usize {
        self.selection.girder_shown(&self.scene)
    }

    /// Counts the changes: the same number is the same scene.
    pub(in crate::app) fn revision(&self) -> u64 {
        self.revision
    }

    fn origin(&self) -> Option<&Origin> {
        self.origins.iter().rev().find(|o| o.depth <= self.steps.depth())
    }

    pub(in crate::app) fn file(&self) -> Option<&Path> {
        self.origin()?.source.file()
    }

    /// Source of the scene, or its file after saving.
    pub(in crate::app) fn source(&self) -> SceneSource {
        self.origin().map_or(SceneSource::New, |o| o.source.clone())
    }

    /// Whether something would be lost by closing.
    pub fn is_dirty(&self) -> bool {
        self.origin().is_none_or(|o| o.saved.as_ref() != Some(&self.scene))
    }

    /// Scene on the disk, as far as it is known.
    pub(in crate::app) fn saved(&self) -> Option<&Scene> {
        self.origin()?.saved.as_ref()
    }

    /// Marks the scene as differing from the disk, whatever it is.
    pub(in crate::app) fn unsave(&mut self) {
        let depth = self.steps.depth();
        if let Some(origin) = self.origins.iter_mut().rev().find(|o| o.depth <= depth) {
            origin.saved = None;
        }
    }

    /// Tells what this stretch of the past was opened from or saved to from every other.
    pub(in crate::app) fn origin_id(&self) -> u64 {
        self.origin().map_or(0, |o| o.id)
    }

    /// The stretch of the past whose end was saved as the beginning of this one.
    pub(in crate::app) fn saved_from(&self) -> Option<u64> {
        self.origin()?.saved_from
    }

    /// Tells the scene that is worked on from every other that was opened before or after it, wherever it is saved.
    pub(in crate::app) fn work(&self) -> u64 {
        self.origin().map_or(0, |o| o.work)
    }

    /// Name of the edit that undo reverts.
    pub fn undo_label(&self) -> Option<&str> {
        self.steps.undo_label()
    }

    /// Name of the edit that redo repeats.
    pub fn redo_label(&self) -> Option<&str> {
        self.steps.redo_label()
    }

    /// Does a command; `false` when nothing is different after it.
    ///
    /// # Errors
    /// An edit that does not fit the scene; nothing is changed then.
    pub(in crate::app) fn apply(&mut self, command: EditCommand) -> Result<bool, EditError> {
        match command {
            EditCommand::Change { edit, gesture } => self.edit(edit, gesture),
            EditCommand::Undo => self.undo(),
            EditCommand::Redo => self.redo(),
            EditCommand::Rename(target, name) => {
                rename(&self.scene, target, name).map_or(Ok(false), |edit| self.edit(edit, None))
            }
        }
    }

    /// Selects something else.
    pub(in crate::app) fn select(&mut self, command: SelectCommand) {
        self.selection.apply(command, &self.scene);
    }

    /// Adds, copies, moves or removes bodies, and selects the new ones; `false` when nothing is different after it.
    ///
    /// # Errors
    /// An edit that does not fit the scene; nothing is changed then.
    pub(in crate::app) fn place(&mut self, command: PlaceCommand) -> Result<bool, EditError> {
        let fresh = matches!(
            command,
            PlaceCommand::Put(_)
                | PlaceCommand::AddGirder
                | PlaceCommand::AddAbutment
                | PlaceCommand::AddPier
                | PlaceCommand::AddDevice(_)
        );
        let Some(placed) = placed(command, &self.scene, &self.selection) else { return Ok(false) };
        let edit = if fresh { with_new_assumed(placed.edit, &self.scene)? } else { placed.edit };
        let done = self.edit(edit, None)?;
        if let Some(then) = placed.then {
            self.selection.these(then);
        }
        Ok(done)
    }

    /// Changes the scene; edits of one gesture become one step of undo. `false` when nothing is different after it.
    ///
    /// # Errors
    /// An edit that does not fit the scene; nothing is changed then.
    pub(in crate::app) fn edit(&mut self, edit: Edit, gesture: Option<u64>) -> Result<bool, EditError> {
        let mut after = self.scene.clone();
        edit.clone().apply(&mut after)?;
        if after == self.scene {
            return Ok(false);
        }
        let depth = self.steps.depth();
        self.origins.retain(|o| o.depth <= depth);
        let label = text::name_of_edit(&edit, &self.scene);
        let edit = with_assumed(edit, &self.scene, &after);
        match gesture {
            Some(hand) => self.steps.drag(&mut self.scene, edit, &label, &hand.to_string())?,
            None => self.steps.perform(&mut self.scene, edit, &label)?,
        }
        Ok(self.counted(true))
    }

    /// Takes back what a gesture has done, as if it had never begun; `false` when it has done nothing.
    ///
    /// # Errors
    /// As [`UndoStack::abandon`].
    pub(in crate::app) fn abandon(&mut self, gesture: u64) -> Result<bool, EditError> {
        let done = self.steps.abandon(&mut self.scene, &gesture.to_string())?;
        Ok(self.counted(done))
    }

    /// Counts a change that was `done`, and lets go of what is no longer there.
    fn counted(&mut self, done: bool) -> bool {
        if done {
            self.revision += 1;
            self.selection.keep_in(&self.scene);
        }
        done
    }

    /// Takes the last change back; `false` when there is none.
    ///
    /// # Errors
    /// As [`UndoStack::undo`].
    fn undo(&mut self) -> Result<bool, EditError> {
        let done = self.steps.undo(&mut self.scene)?;
        Ok(self.counted(done))
    }

    /// Makes it again; `false` when there is none.
    ///
    /// # Errors
    /// As [`UndoStack::redo`].
    fn redo(&mut self) -> Result<bool, EditError> {
        let done = self.steps.redo(&mut self.scene)?;
        Ok(self.counted(done))
    }

    /// Another scene, nothing selected in it; the one before can be had back by undo.
    ///
    /// # Errors
    /// None that is known: any scene can be put in another's place.
    pub(in crate::app) fn open(&mut self, scene: Scene, source: SceneSource) -> Result<(), EditError> {
        self.edit(Edit::Scene(Box::new(scene.clone())), None)?;
        self.selection.only(None);
        self.begin(source, scene, self.begun, None);
        Ok(())
    }

    /// It is on the disk now.
    pub(in crate::app) fn saved_as(&mut self, file: PathBuf) {
        let from = self.origin_id();
        self.begin(SceneSource::File(file), self.scene.clone(), self.work(), Some(from));
        self.steps.seal();
    }

    fn begin(&mut self, source: SceneSource, saved: Scene, work: u64, saved_from: Option<u64>) {
        let depth = self.steps.depth();
        self.origins.retain(|o| o.depth < depth);
        self.origins.push(Origin { id: self.begun, depth, source, saved: Some(saved), work, saved_from });
        self.begun += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{DeviceId, DeviceKind, is_assumed, presets};
    use crate::view::Target;

    fn renamed(name: &str) -> EditCommand {
        EditCommand::Rename(Target::Girder(0), name.into())
    }

    #[test]
    fn undo_leads_back_to_what_is_saved() {
        let scene = presets::load(presets::OPENING).expect("ships");
        let mut document = Document::new(scene.clone(), SceneSource::New);
        assert!(document.apply(renamed("east")).expect("fits") && document.is_dirty(), "another scene");
        assert!(!document.apply(renamed("east")).expect("fits"), "the same again is no change");
        assert!(document.apply(EditCommand::Undo).expect("there is a step") && !document.is_dirty(), "as read");
        assert_eq!(document.scene(), &scene, "to the last number");
        assert!(document.apply(EditCommand::Redo).expect("there is a step") && document.is_dirty(), "again");
        assert_eq!(document.revision(), 3, "three changes");
    }

    #[test]
    fn an_assumed_mass_follows_the_plan_and_a_given_one_does_not() {
        let draft = crate::app::command::BridgeDraft { span: 25.0, width: 12.0, skew_deg: 60.0, spans: 2 };
        let (scene, source) = crate::app::edits::bridge(draft).expect("sound");
        let mut document = Document::new(scene.clone(), source);
        let longer = crate::scene::Girder { length: 30.0, ..scene.girders[1].clone() };
        document.edit(crate::app::edits::girders_alike(&scene, 1, &longer, &[]), None).expect("fits");
        let now = document.scene();
        let share = now.girders[1].mass / scene.girders[1].mass;
        assert!((share - 1.2).abs() < 1e-3, "{share} of the mass for 1.2 of the length");
        assert_eq!(now.girders[0].mass, scene.girders[0].mass, "the other span's stays");
        let name = &now.girders[1].name;
        for key in ["mass_kg", "bearings", "thickness_m"] {
            assert!(is_assumed(&now.assumed, &format!("girder.{name}.{key}")), "{key} in {:?}", now.assumed);
        }
        document.apply(EditCommand::Undo).expect("there is a step");
        assert_eq!(document.scene(), &scene, "in one step");
        // Every edit of a drag is counted from the scene at its beginning.
        for length in [26.0, 28.0, 27.0] {
            let longer = crate::scene::Girder { length, ..scene.girders[0].clone() };
            document.edit(crate::app::edits::reshaped(&scene, 0, longer), Some(1)).expect("fits");
            let share = document.scene().girders[0].mass / scene.girders[0].mass;
            assert!((share - length / 25.0).abs() < 1e-3, "{share} of the mass at {length} m");
            let path = format!("girder.{}.mass_kg", scene.girders[0].name);
            assert!(is_assumed(&document.scene().assumed, &path), "at {length} m");
        }
        document.apply(EditCommand::Undo).expect("there is a step");
        assert_eq!(document.scene(), &scene, "in one step, too");
        let heavy = crate::scene::Girder { mass: 5e5, ..scene.girders[1].clone() };
        document.edit(crate::app::edits::girder(1, heavy.clone()), None).expect("fits");
        let longer = crate::scene::Girder { length: 30.0, ..heavy };
        let edit = crate::app::edits::girders_alike(document.scene(), 1, &longer, &[]);
        document.edit(edit, None).expect("fits");
        assert_eq!(document.scene().girders[1].mass, 5e5, "what was given stays");
    }

    #[test]
    fn what_is_placed_is_selected_and_let_go_of_when_it_is_gone() {
        let mut document = Document::new(presets::load(presets::OPENING).expect("ships"), SceneSource::New);
        let before = document.scene().girders.len();
        assert!(document.place(PlaceCommand::AddGirder).expect("fits"), "one more");
        assert_eq!(document.selection().all(), [Target::Girder(before)], "the new one");
        document.apply(EditCommand::Undo).expect("there is a step");
        assert!(document.selection().all().is_empty(), "there is no such girder");
        assert!(!document.place(PlaceCommand::Remove).expect("nothing to do"), "nothing is selected");
        document.select(SelectCommand::All);
        document.open(document.scene().clone(), SceneSource::New).expect("fits");
        assert!(document.selection().all().is_empty(), "nothing of another scene");
    }

    #[test]
    fn what_is_added_is_assumed_until_its_numbers_are_given() {
        let mut document = Document::new(presets::load("deck-30m").expect("ships"), SceneSource::New);
        let before = document.scene().clone();
        document.place(PlaceCommand::AddDevice(DeviceKind::Restrainer)).expect("fits");
        let name = document.scene().restrainers[0].name.clone();
        let of = |key: &str| format!("restrainer.{name}.{key}");
        let assumed = |document: &Document, key: &str| is_assumed(&document.scene().assumed, &of(key));
        assert!(
            assumed(&document, "slack_m") && assumed(&document, "stiffness_n_per_m"),
            "{:?}",
            document.scene().assumed
        );
        assert!(!assumed(&document, "at_m"), "where it is, was said");
        let given = Edit::Set(format!("{}=0.031", of("slack_m")));
        document.edit(given, None).expect("fits");
        assert!(!assumed(&document, "slack_m") && assumed(&document, "stiffness_n_per_m"), "one of them is given");
        document.apply(EditCommand::Undo).expect("there is a step");
        assert!(assumed(&document, "slack_m"), "taken back");
        document
            .apply(EditCommand::Rename(
                Target::Device(DeviceId { kind: DeviceKind::Restrainer, number: 0 }),
                "tie".into(),
            ))
            .expect("fits");
        assert!(is_assumed(&document.scene().assumed, "restrainer.tie.slack_m"), "by its new name");
        document.apply(EditCommand::Undo).expect("there is a step");
        document.apply(EditCommand::Undo).expect("there is a step");
        assert_eq!(document.scene(), &before, "as before");
    }

    #[test]
    fn how_an_added_pier_is_held_is_assumed_until_it_is_chosen() {
        let mut document = Document::new(presets::load("row-of-5").expect("ships"), SceneSource::New);
        document.place(PlaceCommand::AddPier).expect("fits");
        let path = format!("pier.{}.column_top", document.scene().piers[0].name);
        assert!(is_assumed(&document.scene().assumed, &path), "{:?}", document.scene().assumed);
        assert!(document.scene().assumed_numbers().iter().any(|(known, _)| *known == path), "listed with its value");
        document.edit(Edit::Set(format!("{path}=\"fixed\"")), None).expect("fits");
        assert!(!is_assumed(&document.scene().assumed, &path), "chosen");
    }

    #[test]
    fn a_gesture_is_undone_as_a_whole() {
        let mut document = Document::new(presets::load(presets::OPENING).expect("ships"), SceneSource::New);
        let before = document.scene().clone();
        for duration in [1.0, 2.0, 3.0] {
            let edit = crate::app::edits::duration(document.scene(), duration);
            document.edit(edit, Some(7)).expect("fits");
        }
        document.apply(EditCommand::Undo).expect("there is a step");
        assert_eq!(document.scene(), &before, "one step back");
    }
}
