//! What panels and tests read of the workbench.

use std::path::PathBuf;
use std::sync::Arc;

use super::window_state::Closing;
use super::workbench::Workbench;
use crate::app::command::{FilmPlan, Sight, Tool};
use crate::app::learn::lessons::Lesson;
use crate::app::run::answer::Answer;
use crate::app::text;
use crate::app::time::clock::Clock;
use crate::files::Found;
use crate::scene::{Scene, SceneErrors};
use crate::view::{Camera, DrawList, Target};

impl Workbench {
    /// What stands on the window's frame.
    pub fn title(&self) -> String {
        let mark = if self.is_dirty() { text::UNSAVED } else { "" };
        format!("{mark}{} – {}", self.file_name(), text::PROGRAM)
    }

    /// The name of the file, or of a scene without one.
    pub fn file_name(&self) -> String {
        self.files.name()
    }

    /// Whether the window is to close now.
    pub fn wants_to_close(&self) -> bool {
        self.window.closing() == Closing::Now
    }

    /// Whether the question about unsaved changes is open.
    pub fn asks_before_closing(&self) -> bool {
        self.window.closing() == Closing::Asking
    }

    /// Whether the help is open.
    pub fn help_is_open(&self) -> bool {
        self.window.help
    }

    /// What has happened to a file, until it is dismissed.
    pub fn notice(&self) -> Option<&str> {
        self.window.notice.as_deref()
    }

    /// The scene as it is now.
    pub fn scene(&self) -> &Scene {
        self.files.document.scene()
    }

    /// Whether something would be lost by closing.
    pub fn is_dirty(&self) -> bool {
        self.files.document.is_dirty()
    }

    /// The change that undo would take back.
    pub fn undo_label(&self) -> Option<&str> {
        self.files.document.undo_label()
    }

    /// The change that redo would make again.
    pub fn redo_label(&self) -> Option<&str> {
        self.files.document.redo_label()
    }

    /// The last good answer.
    pub fn answer(&self) -> Option<&Arc<Answer>> {
        self.runner.answer()
    }

    /// Whether the answer shown belongs to an older scene.
    pub fn is_stale(&self) -> bool {
        self.runner.is_stale()
    }

    /// Complaints about the scene as it is now.
    pub fn problems(&self) -> Option<&SceneErrors> {
        self.runner.problems()
    }

    /// How far a run on a thread has come, 0 to 1.
    pub fn progress(&self) -> Option<f64> {
        self.runner.progress()
    }

    /// The playing clock.
    pub fn clock(&self) -> &Clock {
        &self.playback.clock
    }

    /// End of the answer \[s\].
    pub fn end(&self) -> f64 {
        self.runner.end(self.scene())
    }

    /// The stretch of time that timeline and plots show; all of it when none \[s\].
    pub fn time_window(&self) -> Option<[f64; 2]> {
        self.playback.window
    }

    /// What is selected; of several the one that leads.
    pub fn selected(&self) -> Option<Target> {
        self.selection.lead()
    }

    /// All that is selected, in the order in which it was.
    pub fn selection(&self) -> &[Target] {
        self.selection.all()
    }

    /// How many runs are kept to compare with.
    pub fn pinned(&self) -> usize {
        self.comparison.pins().len()
    }

    /// What stands beside the mouse while a number is typed for what is held.
    pub fn hand_words(&self) -> &[String] {
        self.viewport.hand.words.as_deref().unwrap_or_default()
    }

    /// How the view is looked at.
    pub fn sight(&self) -> Sight {
        self.display.sight
    }

    /// What a click in the view does.
    pub fn tool(&self) -> Tool {
        self.display.tool
    }

    /// Where the view is seen from, once it has been shown.
    pub fn camera(&self) -> Option<&Camera> {
        self.viewport.camera()
    }

    /// The picture last made, as a list.
    pub fn picture(&self) -> Option<&Arc<DrawList>> {
        self.viewport.list()
    }

    /// How many different pictures have been made.
    pub fn pictures(&self) -> u64 {
        self.viewport.pictures()
    }

    /// Files that were used last.
    pub fn recent(&self) -> &[PathBuf] {
        self.files.session.recent()
    }

    /// Unsaved work that is asked about.
    pub fn found_work(&self) -> Option<&Found> {
        self.files.session.found_work()
    }

    /// Whether another program has changed the file, and nothing was chosen about it yet.
    pub fn file_has_changed(&self) -> bool {
        self.files.session.file_has_changed()
    }

    /// Frames written and frames in all, while a film is being written.
    pub fn filming(&self) -> Option<(usize, u32)> {
        self.films.progress()
    }

    /// What the film dialog shows, while it is open.
    pub fn film_plan(&self) -> Option<&FilmPlan> {
        self.films.plan.as_ref()
    }

    /// The guided scene whose words are shown.
    pub fn lesson(&self) -> Option<&'static Lesson> {
        self.learning.lesson()
    }
}
