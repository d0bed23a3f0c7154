//! What is kept for the user beside the scene itself: recent files, unsaved work, the file's state on the disk.
//!
//! Nothing is kept unless [`Workbench::keep_in`] says where, so that a test or a picture of the window touches nobody's
//! files. The disk is looked at while a frame is drawn anyway, at most once a second: an idle window sleeps.

use std::collections::{BTreeMap, VecDeque};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use egui::Ui;

use crate::app::bench::Workbench;
use crate::app::bench::workbench::Closing;
use crate::app::disk::autosave::{Autosave, Work};
use crate::app::text;
use crate::app::time::clock::now;
use crate::files::{Found, Recent, Stamp, find_beside, find_in, load_scene, load_unsaved};
use crate::scene::Scene;
use crate::scene::edit::Edit;

/// How often the opened file is looked at.
const LOOK: Duration = Duration::from_secs(1);

/// A wish about what is kept.
#[derive(Clone, Debug)]
pub enum Keep {
    /// Bring the unsaved work back that is asked about.
    Recover,
    /// Throw it away.
    Discard,
    /// Leave it where it is and ask again the next time.
    Later,
    /// Read the file again that another program has changed.
    Reload,
    /// Go on with the scene as it is here.
    KeepMine,
    /// Take a file from the list of recent ones.
    Forget(PathBuf),
    /// Forget all recent files.
    ForgetAll,
}

/// What is kept, once it is known where.
#[derive(Default)]
pub(in crate::app) struct Keeping {
    folder: Option<PathBuf>,
    recent: Recent,
    autosave: Option<Autosave>,
    found: VecDeque<Found>,
    stamps: BTreeMap<PathBuf, Option<Stamp>>,
    looked: Option<Instant>,
    changed: bool,
}

/// Where this user's lists and unsaved work are kept: the state folder of the system.
pub(in crate::app) fn users_folder() -> Option<PathBuf> {
    use etcetera::{AppStrategy as _, AppStrategyArgs, choose_app_strategy};
    let names = AppStrategyArgs { app_name: "girderbench".into(), ..AppStrategyArgs::default() };
    let places = choose_app_strategy(names).ok()?;
    Some(places.state_dir().unwrap_or_else(|| places.data_dir()))
}

impl Keeping {
    /// What is asked: another answer is another frame.
    pub(in crate::app) fn asked(&self) -> (usize, bool, usize) {
        (self.found.len(), self.changed, self.recent.files().len())
    }
}

impl Workbench {
    /// Keeps recent files and unsaved work in a folder from now on, and asks about work that is found.
    pub fn keep_in(&mut self, folder: &Path) {
        self.keeping.recent = Recent::open(folder.join("recent.toml"));
        self.keeping.autosave = Some(Autosave::new(self.wake.clone()));
        self.keeping.found = find_in(&folder.join("unsaved")).into();
        self.keeping.folder = Some(folder.to_owned());
        if let Some(file) = self.document.file().map(Path::to_owned) {
            self.opened(&file);
        }
    }

    /// How long after an edit unsaved work is kept (3 s unless told otherwise).
    pub fn set_autosave_delay(&mut self, delay: Duration) {
        self.keeping.autosave.iter_mut().for_each(|autosave| autosave.delay = delay);
    }

    /// Waits until what is to be kept is on the disk.
    pub fn wait_for_disk(&self) {
        self.keeping.autosave.iter().for_each(Autosave::wait);
    }

    /// Whether anything is kept.
    pub(in crate::app) fn is_kept(&self) -> bool {
        self.keeping.folder.is_some()
    }

    /// Whether a question about files is open.
    pub(in crate::app) fn asks_about_files(&self) -> bool {
        self.found_work().is_some() || self.file_has_changed()
    }

    /// Files that were used last.
    pub fn recent(&self) -> &[PathBuf] {
        self.keeping.recent.files()
    }

    /// Unsaved work that is asked about.
    pub fn found_work(&self) -> Option<&Found> {
        self.keeping.found.front()
    }

    /// Whether another program has changed the file, and nothing was chosen about it yet.
    pub fn file_has_changed(&self) -> bool {
        self.keeping.changed
    }

    /// A file was opened or saved.
    pub(in crate::app) fn opened(&mut self, file: &Path) {
        if self.keeping.folder.is_none() {
            return;
        }
        self.stamp(file);
        // A list that cannot be written is no reason to disturb the work.
        let _ = self.keeping.recent.add(file);
        let known: Vec<PathBuf> = self.keeping.found.iter().map(|f| f.path.clone()).collect();
        for found in find_beside(file).into_iter().rev().filter(|f| !known.contains(&f.path)) {
            if load_unsaved(&found.path).is_ok_and(|scene| scene == *self.scene()) {
                // It is what the file says: nothing would be lost.
                let _ = std::fs::remove_file(&found.path);
            } else {
                self.keeping.found.push_front(found);
            }
        }
    }

    /// Remembers what the file looks like now.
    pub(in crate::app) fn stamp(&mut self, file: &Path) {
        self.keeping.stamps.insert(file.to_owned(), Stamp::of(file));
        self.keeping.changed = false;
    }

    fn work(&self) -> Option<Work> {
        let folder = self.keeping.folder.as_ref()?;
        let untitled = || folder.join("unsaved").join(format!("{}.toml", text::UNTITLED));
        Some(Work {
            origin: self.document.origin_id(),
            revision: self.revision(),
            dirty: self.is_dirty(),
            beside: self.document.file().map_or_else(untitled, Path::to_owned),
        })
    }

    /// The scene with the view as it is seen, as it would be saved.
    pub(in crate::app) fn scene_as_seen(&self) -> Scene {
        let mut scene = self.scene().clone();
        scene.view.overlays = self.overlays;
        scene.view.force_scale = self.force_scale;
        scene
    }

    /// Keeps unsaved work when it is time; says when to come back.
    pub(in crate::app) fn keep_work(&mut self) -> Option<Duration> {
        let work = self.work().filter(|_| self.closing != Closing::Now)?;
        let mut autosave = self.keeping.autosave.take()?;
        let again = autosave.watch(&work, || self.scene_as_seen());
        if let Some(problem) = autosave.problem() {
            self.notice = Some(format!("{} {problem}", text::NOT_KEPT));
        }
        self.keeping.autosave = Some(autosave);
        again
    }

    /// Keeps unsaved work now: something else is about to be opened, or the window ends otherwise than by being closed.
    pub(in crate::app) fn keep_work_now(&mut self) {
        let (Some(work), Some(mut autosave)) = (self.work(), self.keeping.autosave.take()) else { return };
        autosave.hurry(&work, || self.scene_as_seen());
        self.keeping.autosave = Some(autosave);
    }

    /// The work is saved or given up.
    pub(in crate::app) fn forget_work(&mut self) {
        let origin = self.document.origin_id();
        self.keeping.autosave.iter_mut().for_each(|autosave| autosave.forget(origin));
    }

    /// Looks whether another program has changed the file.
    pub(in crate::app) fn look_at_disk(&mut self, ui: &Ui) {
        let returned = ui.input(|i| i.events.contains(&egui::Event::WindowFocused(true)));
        let time = now();
        let lately = self.keeping.looked.is_some_and(|looked| time - looked < LOOK);
        if self.keeping.folder.is_some() && !self.keeping.changed && (returned || !lately) {
            self.keeping.looked = Some(time);
            self.compare_with_disk();
        }
    }

    /// Whether the file is as it was last seen; if not, says so or asks.
    pub(in crate::app) fn compare_with_disk(&mut self) -> bool {
        let Some(file) = self.document.file().map(Path::to_owned) else { return true };
        let found = Stamp::of(&file);
        let known = *self.keeping.stamps.entry(file.clone()).or_insert(found);
        if known == found {
            return true;
        }
        if found.is_none() {
            self.stamp(&file);
            self.document.unsave();
            self.notice = Some(format!("{}: {}", file.display(), text::FILE_GONE));
            return true;
        }
        let same = load_scene(&file.to_string_lossy(), &[]).is_ok_and(|scene| self.document.saved() == Some(&scene));
        if same {
            self.stamp(&file);
        }
        self.keeping.changed = !same;
        same
    }

    /// Does what is wished.
    pub(in crate::app) fn apply_keep(&mut self, wish: Keep) {
        match wish {
            Keep::Recover => self.recover(),
            Keep::Discard => {
                if let Some(found) = self.keeping.found.pop_front() {
                    self.say(std::fs::remove_file(&found.path));
                }
            }
            Keep::Later => drop(self.keeping.found.pop_front()),
            Keep::Reload => {
                if let Some(file) = self.document.file().map(Path::to_owned) {
                    let mine = self.document.origin_id();
                    self.stamp(&file);
                    self.document.unsave();
                    self.open(&file.to_string_lossy(), Some(file.clone()));
                    // Given up; undo brings it back, and then it is kept again.
                    self.keeping.autosave.iter_mut().for_each(|autosave| autosave.forget(mine));
                }
            }
            Keep::KeepMine => {
                if let Some(file) = self.document.file().map(Path::to_owned) {
                    self.stamp(&file);
                    self.document.unsave();
                }
            }
            Keep::Forget(file) => {
                let done = self.keeping.recent.remove(&file);
                self.say(done);
            }
            Keep::ForgetAll => {
                let done = self.keeping.recent.clear();
                self.say(done);
            }
        }
    }

    fn say<E: std::fmt::Display>(&mut self, done: Result<(), E>) {
        if let Err(problem) = done {
            self.notice = Some(problem.to_string());
        }
    }

    /// Brings found work back as an edit of its file's scene, or as a scene without a file.
    fn recover(&mut self) {
        let Some(found) = self.keeping.found.pop_front() else { return };
        let scene = match load_unsaved(&found.path) {
            Ok(scene) => scene,
            Err(errors) => {
                self.notice = Some(errors.to_string());
                return;
            }
        };
        self.look_as(&scene);
        if found.file.is_some() && found.file.as_deref() == self.document.file() {
            self.edit(Edit::Scene(Box::new(scene)), None);
        } else {
            self.keep_work_now();
            let opened = self.document.open(scene, found.file);
            self.document.unsave();
            self.after(opened.map(|()| true));
        }
        let (origin, revision) = (self.document.origin_id(), self.revision());
        self.keeping.autosave.iter_mut().for_each(|autosave| autosave.adopt(origin, revision, found.path.clone()));
    }
}

impl Drop for Workbench {
    fn drop(&mut self) {
        // Closed as it should be, or the display is gone: what is unsaved then is found the next time.
        if self.closing != Closing::Now {
            self.keep_work_now();
        }
    }
}
