//! The user's files beside the scene itself: recent files, settings, unsaved work, the file's state on the disk.
//!
//! Nothing is kept unless [`SessionFiles::keep_in`] says where, so that a test or a picture of the window leaves the
//! user's files alone. The disk is looked at while a frame is drawn anyway, at most once a second: an idle window sleeps.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::app::disk::autosave::{Autosave, Work};
use crate::app::edits::Document;
use crate::app::host::{Instant, Wake, now};
use crate::app::text;
use crate::files::{Chosen, Found, Recent, Settings, Stamp, find_beside, find_in, load_scene, load_unsaved};
use crate::scene::Scene;

/// How often the opened file is looked at.
const LOOK: Duration = Duration::from_secs(1);

/// The user's files, in a known folder.
#[derive(Default)]
pub struct SessionFiles {
    folder: Option<PathBuf>,
    recent: Recent,
    settings: Settings,
    autosave: Option<Autosave>,
    found: Vec<FoundWork>,
    stamps: BTreeMap<PathBuf, Option<Stamp>>,
    looked: Option<Instant>,
    changed: bool,
}

/// Unsaved work that was found, and what its scene is called.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundWork {
    /// Where it is.
    pub found: Found,
    /// The scene's name; of work that cannot be read, the side file's.
    pub name: String,
}

impl FoundWork {
    fn of(found: Found) -> Self {
        let file = || found.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let name = load_unsaved(&found.path).map_or_else(|_| file(), |scene| scene.name);
        Self { found, name }
    }
}

/// Work beside a file, the newest first, that its scene does not hold: what is equal to it is removed. The scene is asked for where anything
/// is found.
fn lost_beside(file: &Path, scene: impl FnOnce() -> Option<Scene>) -> Vec<Found> {
    let mut found = find_beside(file);
    let Some(scene) = (if found.is_empty() { None } else { scene() }) else { return found };
    found.retain(|found| {
        let is_saved = load_unsaved(&found.path).is_ok_and(|unsaved| unsaved == scene);
        if is_saved {
            // Gone already is as good.
            let _ = std::fs::remove_file(&found.path);
        }
        !is_saved
    });
    found
}

/// How a file compares with what was last seen of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::app) struct Compared {
    /// Whether it holds what is known of it; a question is open otherwise.
    pub(in crate::app) same: bool,
    /// Message to the user.
    pub(in crate::app) notice: Option<String>,
}

impl SessionFiles {
    /// Keeps recent files, settings and unsaved work in a folder from now on, and looks for work that was left there.
    pub(in crate::app) fn keep_in(&mut self, folder: &Path, wake: Wake) {
        self.recent = Recent::open(folder.join("recent.toml"));
        self.settings = Settings::open(folder.join("settings.toml"));
        self.autosave = Some(Autosave::new(wake));
        let beside = self.recent.files().iter().flat_map(|file| lost_beside(file, || load_scene(file, &[]).ok()));
        let mut found: Vec<Found> = find_in(&folder.join("unsaved")).into_iter().chain(beside).collect();
        found.sort_by_key(|found| std::cmp::Reverse(found.written));
        self.found = found.into_iter().map(FoundWork::of).collect();
        self.folder = Some(folder.to_owned());
    }

    /// How long after an edit unsaved work is kept (3 s unless told otherwise).
    pub fn set_autosave_delay(&mut self, delay: Duration) {
        self.autosave.iter_mut().for_each(|autosave| autosave.delay = delay);
    }

    /// Waits until what is to be kept is on the disk.
    pub fn wait(&self) {
        self.autosave.iter().for_each(Autosave::wait);
    }

    /// Whether anything is kept.
    pub(in crate::app) fn is_kept(&self) -> bool {
        self.folder.is_some()
    }

    /// Everything of it that a frame shows.
    pub(in crate::app) fn seen(&self) -> (usize, bool, usize) {
        (self.found.len(), self.changed, self.recent.files().len())
    }

    /// Whether a question about files is open.
    pub(in crate::app) fn asks(&self) -> bool {
        !self.found.is_empty() || self.file_has_changed()
    }

    /// Settings for every window, chosen in this one or an earlier one.
    pub fn chosen(&self) -> &Chosen {
        self.settings.chosen()
    }

    /// Keeps what was chosen, for the next start too where there is a folder for it.
    ///
    /// # Errors
    /// In words: the settings cannot be written.
    pub(in crate::app) fn keep(&mut self, chosen: Chosen) -> Result<(), String> {
        if self.folder.is_none() {
            self.settings.choose(chosen);
            return Ok(());
        }
        self.settings.keep(chosen).map_err(|e| e.to_string())
    }

    /// Files that were used last.
    pub fn recent(&self) -> &[PathBuf] {
        self.recent.files()
    }

    /// Unsaved work that is asked about.
    pub fn found_work(&self) -> &[FoundWork] {
        &self.found
    }

    /// Whether another program has changed the file, and nothing was chosen about it yet.
    pub fn file_has_changed(&self) -> bool {
        self.changed
    }

    /// A file was opened or saved, and holds this scene.
    pub(in crate::app) fn opened(&mut self, file: &Path, scene: &Scene) {
        if self.folder.is_none() {
            return;
        }
        // What was just saved or given up is no longer beside it.
        self.wait();
        self.stamp(file);
        // A list that cannot be written is no reason to disturb the work.
        let _ = self.recent.add(file);
        let known: Vec<PathBuf> = self.found.iter().map(|work| work.found.path.clone()).collect();
        for found in lost_beside(file, || Some(scene.clone())).into_iter().rev().filter(|f| !known.contains(&f.path)) {
            self.found.insert(0, FoundWork::of(found));
        }
    }

    /// Remembers what the file looks like now.
    pub(in crate::app) fn stamp(&mut self, file: &Path) {
        self.stamps.insert(file.to_owned(), Stamp::of(file));
        self.changed = false;
    }

    fn work(&self, document: &Document) -> Option<Work> {
        let folder = self.folder.as_ref()?;
        let untitled = || folder.join("unsaved").join(format!("{}.toml", text::UNTITLED));
        Some(Work {
            origin: document.origin_id(),
            revision: document.revision(),
            dirty: document.is_dirty(),
            beside: document.file().map_or_else(untitled, Path::to_owned),
            source: document.source(),
        })
    }

    /// Keeps unsaved work when it is time: when to come back, and what went wrong.
    pub(in crate::app) fn keep_work(
        &mut self,
        document: &Document,
        as_seen: impl FnOnce() -> Scene,
    ) -> (Option<Duration>, Option<String>) {
        let (Some(work), Some(autosave)) = (self.work(document), &mut self.autosave) else { return (None, None) };
        // What undo led back to is on the disk as the beginning of what redo has led to.
        document.saved_from().into_iter().for_each(|before| autosave.forget(before));
        let again = autosave.watch(&work, as_seen);
        (again, autosave.problem().map(|problem| format!("{} {problem}", text::NOT_KEPT)))
    }

    /// Keeps unsaved work now: something else is about to be opened, or the window ends otherwise than by being closed.
    pub(in crate::app) fn keep_work_now(&mut self, document: &Document, as_seen: impl FnOnce() -> Scene) {
        if let (Some(work), Some(autosave)) = (self.work(document), &mut self.autosave) {
            autosave.hurry(&work, as_seen);
        }
    }

    /// Work of an origin is saved or given up.
    pub(in crate::app) fn forget_work(&mut self, origin: u64) {
        self.autosave.iter_mut().for_each(|autosave| autosave.forget(origin));
    }

    /// Found work is an origin's from now on, at this revision.
    pub(in crate::app) fn adopt(&mut self, origin: u64, revision: u64, found: &Path) {
        self.autosave.iter_mut().for_each(|autosave| autosave.adopt(origin, revision, found.to_owned()));
    }

    /// Takes found work to bring it back; the rest is not asked about again.
    pub(in crate::app) fn take_found(&mut self, number: usize) -> Option<Found> {
        std::mem::take(&mut self.found).into_iter().nth(number).map(|work| work.found)
    }

    /// Leaves all found work where it is.
    pub(in crate::app) fn leave_found(&mut self) {
        self.found.clear();
    }

    /// Throws found work away.
    ///
    /// # Errors
    /// The side file cannot be removed.
    pub(in crate::app) fn discard(&mut self, number: usize) -> std::io::Result<()> {
        if number >= self.found.len() {
            return Ok(());
        }
        std::fs::remove_file(self.found.remove(number).found.path)
    }

    /// Takes a file from the list of recent ones.
    ///
    /// # Errors
    /// In words: the list cannot be written.
    pub(in crate::app) fn forget(&mut self, file: &Path) -> Result<(), String> {
        self.recent.remove(file).map_err(|e| e.to_string())
    }

    /// Forgets all recent files.
    ///
    /// # Errors
    /// In words: the list cannot be written.
    pub(in crate::app) fn forget_all(&mut self) -> Result<(), String> {
        self.recent.clear().map_err(|e| e.to_string())
    }

    /// Whether it is time to look at the disk again: the window has `returned` to the front, or a while has passed.
    pub(in crate::app) fn is_time_to_look(&mut self, returned: bool) -> bool {
        let time = now();
        let lately = self.looked.is_some_and(|looked| time - looked < LOOK);
        let look = self.folder.is_some() && !self.changed && (returned || !lately);
        if look {
            self.looked = Some(time);
        }
        look
    }

    /// Compares the document's file with what was last seen of it; a file that has gone is no longer saved.
    pub(in crate::app) fn compare(&mut self, document: &mut Document) -> Compared {
        let nothing = Compared { same: true, notice: None };
        let Some(file) = document.file().map(Path::to_owned) else { return nothing };
        let found = Stamp::of(&file);
        let known = *self.stamps.entry(file.clone()).or_insert(found);
        if known == found {
            return nothing;
        }
        if found.is_none() {
            self.stamp(&file);
            document.unsave();
            return Compared { notice: Some(format!("{}: {}", file.display(), text::FILE_GONE)), ..nothing };
        }
        let same = load_scene(&file, &[]).is_ok_and(|scene| document.saved() == Some(&scene));
        if same {
            self.stamp(&file);
        }
        self.changed = !same;
        Compared { same, notice: None }
    }

    /// Goes on with the scene as it is here, whatever another program has written: it is not saved then.
    pub(in crate::app) fn keep_mine(&mut self, document: &mut Document) {
        if let Some(file) = document.file().map(Path::to_owned) {
            self.stamp(&file);
            document.unsave();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::{SceneSource, save_scene};
    use crate::scene::presets;

    /// A document that was read from a file in a folder of its own, and the files of its session.
    fn opened(folder: &Path) -> (SessionFiles, Document) {
        let scene = presets::load(presets::OPENING).expect("ships");
        let file = folder.join("bridge.toml");
        save_scene(&scene, &SceneSource::New, &file).expect("written");
        let mut files = SessionFiles { folder: Some(folder.to_owned()), ..SessionFiles::default() };
        files.opened(&file, &scene);
        (files, Document::new(scene, SceneSource::File(file)))
    }

    #[test]
    fn a_file_that_another_program_has_changed_opens_a_question() {
        let folder = tempfile::tempdir().expect("a folder");
        let (mut files, mut document) = opened(folder.path());
        assert!(files.compare(&mut document).same, "as it was left");
        let other = Scene { name: "a longer name than before".into(), ..document.scene().clone() };
        save_scene(&other, &SceneSource::New, document.file().expect("it has one")).expect("written");
        assert_eq!(files.compare(&mut document), Compared { same: false, notice: None }, "another scene");
        assert!(files.asks(), "what to do about it");
        files.keep_mine(&mut document);
        assert!(!files.asks() && document.is_dirty(), "kept, and not what is on the disk");
    }

    #[test]
    fn a_file_that_has_gone_is_not_saved_any_more() {
        let folder = tempfile::tempdir().expect("a folder");
        let (mut files, mut document) = opened(folder.path());
        std::fs::remove_file(document.file().expect("it has one")).expect("removed");
        let compared = files.compare(&mut document);
        assert!(
            compared.same && compared.notice.is_some_and(|words| words.contains(text::FILE_GONE.as_str())),
            "it is said"
        );
        assert!(document.is_dirty(), "the work is nowhere else");
    }

    #[test]
    fn work_left_beside_a_file_that_was_used_lately_is_found_at_the_start_and_saved_work_is_not() {
        let folder = tempfile::tempdir().expect("a folder");
        let (_, document) = opened(folder.path());
        let file = document.file().expect("it has one").to_owned();
        let mut recent = Recent::open(folder.path().join("recent.toml"));
        recent.add(&file).expect("there is room");
        let other = Scene { duration: 7.25, ..document.scene().clone() };
        for scene in [&other, document.scene()] {
            drop(crate::files::SideFile::create(scene, &SceneSource::New, &file).expect("written"));
        }
        let mut files = SessionFiles::default();
        files.keep_in(folder.path(), std::sync::Arc::new(|| ()));
        let found: Vec<_> = files.found_work().iter().map(|work| work.found.clone()).collect();
        assert_eq!(found.len(), 1, "what the file does not hold: {found:?}");
        assert_eq!((found[0].file.as_ref(), load_unsaved(&found[0].path).ok()), (Some(&file), Some(other)));
    }

    #[test]
    fn what_undo_led_back_to_is_not_left_as_lost_work_once_redo_has_led_on() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut document = Document::new(presets::load(presets::OPENING).expect("ships"), SceneSource::New);
        let mut files = SessionFiles::default();
        files.keep_in(folder.path(), std::sync::Arc::new(|| ()));
        files.set_autosave_delay(Duration::ZERO);
        let mut keep = |document: &Document| {
            let _ = files.keep_work(document, || document.scene().clone());
            let _ = files.keep_work(document, || document.scene().clone());
            files.wait();
        };
        for duration in [3.0, 4.0] {
            let edit = crate::app::edits::duration(document.scene(), duration);
            document.edit(edit, None).expect("fits");
        }
        document.saved_as(folder.path().join("saved.toml"));
        let step = |document: &mut Document, command| document.apply(command).expect("there is one");
        step(&mut document, crate::app::command::EditCommand::Undo);
        keep(&document);
        let side = folder.path().join("unsaved").join(format!("{}.toml.unsaved", text::UNTITLED));
        assert!(side.exists(), "kept while it is what is seen");
        step(&mut document, crate::app::command::EditCommand::Redo);
        keep(&document);
        assert!(!side.exists(), "it is on the disk under the other name");
    }
}
