//! The workbench: a scene, its answer, and how both are looked at.

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use wgpu::TextureFormat;

use super::window_state::{Closing, WindowState};
use crate::app::disk::dialogs::Dialogs;
use crate::app::disk::film::Films;
use crate::app::disk::scene_files::SceneFiles;
use crate::app::edits::Selection;
use crate::app::host::{Background, Wake};
use crate::app::learn::lessons::Learning;
use crate::app::plot::source::{Samples, Source};
use crate::app::run::comparison::Comparison;
use crate::app::run::runner::Runner;
use crate::app::time::playback::Playback;
use crate::app::viewport::display::Display;
use crate::app::viewport::picture::Viewport;
use crate::app::viewport::seen::Seen;
use crate::files::SceneSource;
use crate::scene::{Scene, ViewPreset};

/// The state of the window, each part with its own job.
pub struct Workbench {
    pub(in crate::app) files: SceneFiles,
    pub(in crate::app) runner: Runner,
    pub(in crate::app) playback: Playback,
    pub(in crate::app) selection: Selection,
    pub(in crate::app) comparison: Comparison,
    pub(in crate::app) display: Display,
    pub(in crate::app) viewport: Viewport,
    pub(in crate::app) samples: Samples,
    pub(in crate::app) learning: Learning,
    pub(in crate::app) dialogs: Dialogs,
    pub(in crate::app) films: Films,
    pub(in crate::app) background: Background,
    pub(in crate::app) window: WindowState,
    /// Format that egui draws into, and what draws, in words.
    pub(in crate::app) target: (TextureFormat, String),
    /// Where to look from once the panels have taken their room.
    pub(in crate::app) aim_next: Option<ViewPreset>,
    /// Whether the theme has been set.
    pub(in crate::app) dressed: bool,
    wake: Wake,
}

impl Workbench {
    /// Opens on a scene and runs it.
    pub fn new(scene: Scene, source: SceneSource) -> Self {
        let wake: Wake = Arc::new(|| ());
        let mut bench = Self {
            runner: Runner::default(),
            playback: Playback::default(),
            selection: Selection::default(),
            comparison: Comparison::default(),
            display: Display::of(&scene),
            viewport: Viewport::new(scene.view.camera),
            samples: Samples::default(),
            learning: Learning::default(),
            dialogs: Dialogs::new(wake.clone()),
            films: Films::default(),
            background: Background::new(wake.clone()),
            window: WindowState::default(),
            target: (TextureFormat::Rgba8Unorm, String::new()),
            aim_next: None,
            dressed: false,
            wake,
            files: SceneFiles::new(scene, source),
        };
        bench.runner.start(bench.files.document.scene());
        bench
    }

    /// Tells who is to be woken when a thread has news; the window's event loop.
    pub fn set_wake(&mut self, wake: Wake) {
        self.runner.set_wake(wake.clone());
        self.dialogs.set_wake(wake.clone());
        self.background.set_wake(wake.clone());
        self.wake = wake;
    }

    pub(in crate::app) fn wake(&self) -> Wake {
        self.wake.clone()
    }

    /// Tells which format egui draws into, and with what.
    pub fn set_target(&mut self, format: TextureFormat, adapter: String) {
        self.target = (format, adapter);
    }

    /// Whether the error is estimated while the window is idle (it is unless told otherwise).
    pub fn set_estimates(&mut self, wanted: bool) {
        self.runner.set_estimates(wanted);
    }

    /// Opens no dialogs of the system's: there is no user to answer them.
    pub fn set_silent(&mut self) {
        self.dialogs.silent = true;
    }

    /// Keeps recent files and unsaved work in a folder from now on, and asks about work that is found.
    pub fn keep_in(&mut self, folder: &Path) {
        self.files.session.keep_in(folder, self.wake.clone());
        let SceneFiles { document, session } = &mut self.files;
        if let Some(file) = document.file() {
            session.opened(file, document.scene());
        }
    }

    /// How long after an edit unsaved work is kept (3 s unless told otherwise).
    pub fn set_autosave_delay(&mut self, delay: Duration) {
        self.files.session.set_autosave_delay(delay);
    }

    /// Waits until what is to be kept is on the disk.
    pub fn wait_for_disk(&self) {
        self.files.session.wait();
    }

    /// Waits for the run on a thread.
    pub fn wait(&mut self) {
        self.runner.wait();
    }

    /// The 3D view, and what it is a picture of.
    pub(in crate::app) fn view_and_seen(&mut self) -> (&mut Viewport, Seen<'_>) {
        let seen = Seen {
            scene: self.files.document.scene(),
            revision: self.files.document.revision(),
            runner: &self.runner,
            playback: &self.playback,
            selection: self.selection.all(),
            display: &self.display,
            pins: self.comparison.pins(),
            format: self.target.0,
        };
        (&mut self.viewport, seen)
    }

    /// What the plots are drawn from.
    pub(in crate::app) fn plot_source(&self) -> Source<'_> {
        Source {
            scene: self.files.document.scene(),
            answer: self.runner.answer(),
            girder: self.selection.girder_shown(self.files.document.scene()),
            pins: self.comparison.pins(),
            playback: &self.playback,
            end: self.end(),
            samples: &self.samples,
        }
    }
}

impl Drop for Workbench {
    fn drop(&mut self) {
        // Closed as it should be, or the display is gone: what is unsaved then is found the next time.
        if self.window.closing() != Closing::Now {
            self.keep_work_now();
        }
    }
}
