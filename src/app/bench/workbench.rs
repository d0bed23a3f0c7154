//! The workbench: a scene, its answer, and how both are looked at.

use std::path::Path;

use super::folds::Folds;
use super::window_state::WindowState;
use crate::app::disk::scene_files::SceneFiles;
use crate::app::disk::tasks::Tasks;
use crate::app::host::Wake;
use crate::app::learn::lessons::Learning;
use crate::app::map::{Angles, Maps};
use crate::app::plot::source::{Samples, Source};
use crate::app::plot::views::PlotViews;
use crate::app::quake::Shaking;
use crate::app::run::comparison::Comparison;
use crate::app::text;
use crate::app::time::replay::Replay;
use crate::app::viewport::picture::Viewport;
use crate::app::viewport::scene_view::SceneView;
use crate::app::viewport::seen::Seen;
use crate::files::SceneSource;
use crate::scene::Scene;

/// The state of the window: parts that do their own work and know nothing of one another.
pub struct Workbench {
    /// The scene with its past, what is selected in it, and its files.
    pub files: SceneFiles,
    /// The scene's answer, and the time of it that is shown.
    pub replay: Replay,
    /// Runs kept to compare with.
    pub comparison: Comparison,
    /// The 3D view.
    pub view: SceneView,
    /// The guided scene whose words are shown.
    pub learning: Learning,
    /// A number of the run over two keys.
    pub maps: Maps,
    /// Numbers of the run over the angle of the shaking.
    pub angles: Angles,
    /// Histories and response spectrum of the ground motion.
    pub shaking: Shaking,
    /// Which values of the plots are shown.
    pub plots: PlotViews,
    /// Dialogs, exports and films on threads.
    pub tasks: Tasks,
    /// The window itself: its dialogs, its notice, its end.
    pub window: WindowState,
    pub(super) samples: Samples,
}

impl Workbench {
    /// Opens on a scene and runs it.
    pub fn new(scene: Scene, source: SceneSource) -> Self {
        let mut bench = Self {
            replay: Replay::default(),
            comparison: Comparison::default(),
            view: SceneView::new(&scene),
            learning: Learning::default(),
            maps: Maps::default(),
            angles: Angles::default(),
            shaking: Shaking::default(),
            plots: PlotViews::default(),
            tasks: Tasks::default(),
            window: WindowState::default(),
            samples: Samples::default(),
            files: SceneFiles::new(scene, source),
        };
        bench.run();
        bench
    }

    /// Runs the scene if it is another one than before.
    pub(super) fn run(&mut self) {
        let document = &self.files.document;
        self.replay.follow((document.revision(), document.work()), document.scene());
        self.comparison.turn_to(document.work());
        self.maps.follow(document.scene());
        self.angles.follow(document.scene());
    }

    /// Resets the state that belongs to the scene before: lesson, charts, map, angles, the time shown, the camera.
    pub(super) fn turn_to_another_scene(&mut self, scene: &Scene) {
        self.learning.close();
        self.plots = PlotViews::default();
        self.maps.forget();
        self.angles.forget();
        self.view.look_as(scene);
        self.replay.playback.rewind();
    }

    /// Tells who is to be woken when a thread has news; the window's event loop.
    pub fn set_wake(&mut self, wake: Wake) {
        self.replay.runner.set_wake(wake.clone());
        self.maps.set_wake(wake.clone());
        self.angles.set_wake(wake.clone());
        self.shaking.set_wake(wake.clone());
        self.tasks.set_wake(wake);
    }

    /// Keeps recent files, settings and unsaved work in a folder from now on, and asks about work that is found.
    pub fn keep_in(&mut self, folder: &Path) {
        self.files.keep_in(folder, self.tasks.wake());
        self.window.folds = Folds::as_in(self.files.session.chosen().folded);
    }

    /// Title of the window.
    pub fn title(&self) -> String {
        let mark = if self.files.document.is_dirty() { text::UNSAVED } else { "" };
        format!("{mark}{} – {}", self.files.name(), text::PROGRAM)
    }

    /// The 3D view's own state, and what it is a picture of.
    pub(in crate::app) fn view_and_seen(&mut self) -> (&mut Viewport, Seen<'_>) {
        self.view.parts(&self.files.document, &self.replay, self.comparison.pins())
    }

    /// Data of the plots.
    pub(in crate::app) fn plot_source(&self) -> Source<'_> {
        Source {
            scene: self.files.document.scene(),
            answer: self.replay.runner.answer(),
            girder: self.files.document.girder_shown(),
            pins: self.comparison.pins(),
            differences: self.comparison.differences(),
            section_force: self.view.section_force(),
            views: &self.plots,
            playback: &self.replay.playback,
            end: self.replay.end(),
            samples: &self.samples,
        }
    }

    /// Keeps unsaved work now: something else is about to be opened, or the window ends otherwise than by being closed.
    pub(super) fn keep_work_now(&mut self) {
        self.files.keep_work_now(|scene| self.view.display.scene_as_seen(scene));
    }
}

impl Drop for Workbench {
    fn drop(&mut self) {
        // Closed as it should be, or the display is gone: what is unsaved then is found the next time.
        if !self.window.closes() {
            self.keep_work_now();
        }
    }
}
