//! What the workbench can be asked for: everything that panels and tests read.

use std::sync::Arc;

use wgpu::TextureFormat;

use crate::app::bench::Workbench;
use crate::app::bench::workbench::Closing;
use crate::app::panel::row_dialog::RowDraft;
use crate::app::plot::traces::Traces;
use crate::app::plot::user_plots::Sampled;
use crate::app::run::answer::Answer;
use crate::app::text;
use crate::app::time::clock::Clock;
use crate::app::viewport::tool::Tool;
use crate::app::viewport::view_options::Sight;
use crate::scene::{Overlays, Scene, SceneErrors};
use crate::sim::History;
use crate::view::{Camera, DrawList, Target, auto_force_scale};

impl Workbench {
    /// What stands on the window's frame.
    pub fn title(&self) -> String {
        let mark = if self.document.is_dirty() { text::UNSAVED } else { "" };
        format!("{mark}{} – {}", self.file_name(), text::PROGRAM)
    }

    /// The name of the file, or of a scene without one.
    pub fn file_name(&self) -> String {
        let file = self.document.file().and_then(|f| f.file_name()).map(|f| f.to_string_lossy().into_owned());
        file.unwrap_or_else(|| self.document.scene().name.clone())
    }

    /// Whether the window is to close now.
    pub fn wants_to_close(&self) -> bool {
        self.closing == Closing::Now
    }

    /// Whether the question about unsaved changes is open.
    pub fn asks_before_closing(&self) -> bool {
        self.closing == Closing::Asking
    }

    /// Whether the help is open.
    pub fn help_is_open(&self) -> bool {
        self.help
    }

    /// What has happened to a file, until it is dismissed.
    pub fn notice(&self) -> Option<&str> {
        self.notice.as_deref()
    }

    /// The scene as it is now.
    pub fn scene(&self) -> &Scene {
        self.document.scene()
    }

    /// Counts the changes of the scene.
    pub fn revision(&self) -> u64 {
        self.document.revision()
    }

    /// Whether something would be lost by closing.
    pub fn is_dirty(&self) -> bool {
        self.document.is_dirty()
    }

    /// The change that undo would take back.
    pub fn undo_label(&self) -> Option<&str> {
        self.document.undo_label()
    }

    /// The change that redo would make again.
    pub fn redo_label(&self) -> Option<&str> {
        self.document.redo_label()
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

    /// Waits for the run on a thread.
    pub fn wait(&mut self) {
        self.runner.wait();
    }

    /// What the view shows: an old answer is shown with its own scene, so that the two belong together.
    pub(in crate::app) fn shown(&self) -> (&Scene, Option<&History>) {
        let history = self.answer().map(|a| &a.history);
        match history {
            Some(old) if self.is_stale() => (old.scene(), Some(old)),
            _ => (self.scene(), history),
        }
    }

    /// The playing clock.
    pub fn clock(&self) -> &Clock {
        &self.clock
    }

    /// End of the answer \[s\].
    pub fn end(&self) -> f64 {
        self.answer().map_or(self.scene().duration, |a| a.history.end())
    }

    /// The stretch of time that timeline and plots show; all of it when none \[s\].
    pub fn time_window(&self) -> Option<[f64; 2]> {
        self.time_window
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
        self.pins.len()
    }

    /// Numbers of the kept runs' answers.
    pub(in crate::app) fn pin_numbers(&self) -> Vec<u64> {
        self.pins.iter().map(|p| p.answer.number).collect()
    }

    /// What stands beside the hand while a number is typed for what it holds.
    pub fn hand_words(&self) -> &[String] {
        self.viewport.hand.words.as_deref().unwrap_or_default()
    }

    /// The row that is being asked for.
    pub fn row_draft(&self) -> Option<RowDraft> {
        self.row
    }

    /// How the view is looked at.
    pub fn sight(&self) -> Sight {
        self.sight
    }

    /// What a click in the view does.
    pub fn tool(&self) -> Tool {
        self.tool
    }

    /// The girder or abutment that is selected.
    pub fn selected_body(&self) -> Option<Target> {
        self.selection.lead().filter(|t| !matches!(t, Target::Contact(_)))
    }

    /// The girder whose curves stand out.
    pub(in crate::app) fn shown_girder(&self) -> usize {
        match self.selection.lead() {
            Some(Target::Girder(i)) => i,
            Some(Target::Abutment(i)) => {
                let faces = self.scene().abutments.get(i).map(|a| &a.faces);
                self.scene().girders.iter().position(|g| Some(&g.name) == faces).unwrap_or(0)
            }
            _ => 0,
        }
    }

    /// Which layers are shown.
    pub fn overlays(&self) -> Overlays {
        self.overlays
    }

    /// Force scale, unless it follows the run's peak \[N per m\].
    pub fn force_scale(&self) -> Option<f64> {
        self.force_scale
    }

    /// Force scale from the run's peak \[N per m\].
    pub(in crate::app) fn automatic_force_scale(&self) -> f64 {
        self.automatic_scale.1
    }

    /// Reckons the automatic scale anew when the answer is a new one.
    pub(in crate::app) fn rescale(&mut self) {
        if let Some(answer) = self.runner.answer()
            && self.automatic_scale.0 != answer.number
        {
            self.automatic_scale = (answer.number, auto_force_scale(&answer.history).max(1e-6));
        }
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

    /// What draws, in words.
    pub fn adapter(&self) -> &str {
        &self.adapter
    }

    pub(in crate::app) fn target_format(&self) -> TextureFormat {
        self.target_format
    }

    /// Samples for the panels of the user's own.
    pub(in crate::app) fn own_panels(&self, window: [f64; 2], points: usize) -> Arc<Vec<Sampled>> {
        let plots = &self.scene().view.plots;
        let sampled = |a: &Arc<Answer>| self.panels.borrow_mut().of((&a.history, a.number), plots, window, points);
        self.answer().filter(|_| !plots.is_empty()).map(sampled).unwrap_or_default()
    }

    /// Where the curves of an own panel are at the time shown.
    pub(in crate::app) fn own_at(&self, panel: usize) -> Vec<[f64; 2]> {
        let (Some(answer), Some(plot)) = (self.answer(), self.scene().view.plots.get(panel)) else { return Vec::new() };
        crate::app::plot::user_plots::at(answer, plot, self.clock.t)
    }

    /// Samples for the plots.
    pub(in crate::app) fn traces(&self, window: [f64; 2], points: usize) -> Arc<Traces> {
        let girder = self.shown_girder();
        let name = self.scene().girders.get(girder).map_or("", |g| g.name.as_str());
        self.answer().map(|a| self.traces.borrow_mut().of(a, window, points, (name, &self.pins))).unwrap_or_default()
    }
}
