//! A computer: threads, the system's dialogs, the user's folders.

use std::future::Future;
use std::path::PathBuf;
use std::time::Duration;

use rfd::AsyncFileDialog;

use crate::app::host::{Choice, Filter, Wake};
use crate::language::Language;

/// Whether the window is a page in a browser.
pub(in crate::app) const PAGE: bool = false;

/// Whether work can go on beside the window.
pub(in crate::app) const THREADS: bool = true;

/// Work that goes on beside the window, to be waited for.
pub(in crate::app) type Thread = std::thread::JoinHandle<()>;

/// A thread whose texts are in the language of this one; nothing to wait for where the work has been done at once.
#[expect(clippy::unnecessary_wraps, reason = "on a page there is none")]
pub(in crate::app) fn spawn(work: impl FnOnce() + Send + 'static) -> Option<Thread> {
    let language = Language::current();
    Some(std::thread::spawn(move || {
        language.speak();
        work();
    }))
}

/// Bound on a thread's work.
pub(in crate::app) trait MaySend: Send {}
impl<T: Send> MaySend for T {}

/// Does work that waits now and then, on a thread whose texts are in the language of this one.
pub(super) fn finish(work: impl Future<Output = ()> + Send + 'static) {
    // It ends by itself.
    let _ = spawn(move || pollster::block_on(work));
}

/// Work that goes on beside the window, a portion after the other.
pub(in crate::app) struct Slices;

/// Does work that is asked for portions of this length, until it answers that there is no more.
pub(in crate::app) fn in_slices(mut work: impl FnMut(Duration) -> bool + Send + 'static, _: Wake) -> Slices {
    std::thread::spawn(move || while work(Duration::MAX) {});
    Slices
}

impl Slices {
    /// Does a portion, where nobody else does.
    #[expect(clippy::unused_self, clippy::needless_pass_by_ref_mut, reason = "a page has work to do here")]
    pub(in crate::app) fn go_on(&mut self) {}
}

/// Something that the graphics system makes in its own time.
pub(in crate::app) struct Later<T>(Option<T>);

impl<T: 'static> Later<T> {
    /// Begins; here it is waited for.
    pub(in crate::app) fn of(made: impl Future<Output = T> + 'static, _: Wake) -> Self {
        Self(Some(pollster::block_on(made)))
    }

    /// Result, once.
    pub(in crate::app) fn take(&mut self) -> Option<T> {
        self.0.take()
    }
}

/// Has the user choose a path in the system's dialog, beside the window; `None` where it was cancelled or there is none.
pub(in crate::app) fn choose(choice: Choice, filters: &[Filter], then: impl FnOnce(Option<PathBuf>) + Send + 'static) {
    let empty = AsyncFileDialog::new();
    let dialog = filters.iter().fold(empty, |dialog, (name, endings)| dialog.add_filter(name, endings));
    match choice {
        Choice::File => wait(dialog.pick_file(), then),
        Choice::Folder => wait(dialog.pick_folder(), then),
        Choice::New(name) => wait(dialog.set_file_name(name).save_file(), then),
    }
}

fn wait(
    dialog: impl Future<Output = Option<rfd::FileHandle>> + Send + 'static,
    then: impl FnOnce(Option<PathBuf>) + Send + 'static,
) {
    std::thread::spawn(move || then(pollster::block_on(dialog).map(|file| file.path().to_owned())));
}

/// Copies a link to the page: there is none here, and nothing is copied.
pub(in crate::app) fn share(_: &str) -> bool {
    false
}

/// The user's own folder.
pub(in crate::app) fn home_folder() -> Option<PathBuf> {
    etcetera::home_dir().ok()
}

/// Where this user's lists and unsaved work are kept: the state folder of the system.
pub(in crate::app) fn users_folder() -> Option<PathBuf> {
    use etcetera::{AppStrategy as _, AppStrategyArgs, choose_app_strategy};
    let names = AppStrategyArgs { app_name: "girderbench".into(), ..AppStrategyArgs::default() };
    let places = choose_app_strategy(names).ok()?;
    Some(places.state_dir().unwrap_or_else(|| places.data_dir()))
}
