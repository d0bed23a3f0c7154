//! A page in a browser: no threads and no folders, files by the browser's own dialogs.

use std::cell::RefCell;
use std::convert::Infallible;
use std::future::Future;
use std::path::PathBuf;
use std::rc::Rc;
use std::time::Duration;

use js_sys::Uint8Array;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::HtmlInputElement;

use crate::app::host::{Choice, Filter, Wake};
use crate::files;

/// Whether the window is a page in a browser.
pub(in crate::app) const PAGE: bool = true;

/// Whether work can go on beside the window.
pub(in crate::app) const THREADS: bool = false;

/// How long a portion of work may hold up a frame.
const SLICE: Duration = Duration::from_millis(30);

/// Does the work at once; there is nothing to wait for.
pub(in crate::app) fn spawn(work: impl FnOnce() + 'static) -> Option<Thread> {
    work();
    None
}

/// A thread, of which there are none.
pub(in crate::app) struct Thread(Infallible);

impl Thread {
    /// Waits for its end.
    pub(in crate::app) fn join(self) -> Result<(), Infallible> {
        match self.0 {}
    }
}

/// Bound on a thread's work, empty here.
pub(in crate::app) trait MaySend {}
impl<T> MaySend for T {}

/// Does work that waits now and then, in between.
pub(super) fn finish(work: impl Future<Output = ()> + 'static) {
    spawn_local(work);
}

/// Work that goes on between frames, a portion after the other.
pub(in crate::app) struct Slices {
    work: Option<Box<dyn FnMut(Duration) -> bool>>,
    wake: Wake,
}

/// Does work in portions of about the length that it is given, until it answers that there is no more.
pub(in crate::app) fn in_slices(work: impl FnMut(Duration) -> bool + 'static, wake: Wake) -> Slices {
    wake();
    Slices { work: Some(Box::new(work)), wake }
}

impl Slices {
    /// Does a portion, and has the window come back for the next.
    pub(in crate::app) fn go_on(&mut self) {
        let Some(work) = &mut self.work else { return };
        if work(SLICE) {
            (self.wake)();
        } else {
            self.work = None;
        }
    }
}

/// Something that the graphics system makes in its own time.
pub(in crate::app) struct Later<T>(Rc<RefCell<Option<T>>>);

impl<T: 'static> Later<T> {
    /// Begins; the window is woken when it is there.
    pub(in crate::app) fn of(made: impl Future<Output = T> + 'static, wake: Wake) -> Self {
        let here = Rc::new(RefCell::new(None));
        let there = Rc::clone(&here);
        spawn_local(async move {
            let made = made.await;
            *there.borrow_mut() = Some(made);
            wake();
        });
        Self(here)
    }

    /// Result, once.
    pub(in crate::app) fn take(&mut self) -> Option<T> {
        self.0.borrow_mut().take()
    }
}

/// Has the user choose a file, which is read into the page. A file that is written goes to the browser's downloads under the
/// name that is offered, with others beside it where a folder is asked for.
pub(in crate::app) fn choose(choice: Choice, filters: &[Filter], then: impl FnOnce(Option<PathBuf>) + 'static) {
    match choice {
        Choice::New(name) => then(Some(name.into())),
        Choice::Folder => then(Some(PathBuf::new())),
        // A browser without documents shows no window either.
        Choice::File => drop(pick(filters, then)),
    }
}

/// Opens the browser's dialog for a file; nothing follows where it is cancelled.
fn pick(filters: &[Filter], then: impl FnOnce(Option<PathBuf>) + 'static) -> Result<(), JsValue> {
    let document = web_sys::window().and_then(|window| window.document()).ok_or(JsValue::NULL)?;
    let input: HtmlInputElement = document.create_element("input")?.unchecked_into();
    input.set_type("file");
    let endings: Vec<String> = filters.iter().flat_map(|(_, endings)| endings).map(|e| format!(".{e}")).collect();
    input.set_accept(&endings.join(","));
    let chosen = input.clone();
    let changed = Closure::once_into_js(move || {
        let Some(file) = chosen.files().and_then(|files| files.get(0)) else { return };
        spawn_local(async move {
            if let Ok(bytes) = JsFuture::from(file.array_buffer()).await {
                let path = PathBuf::from(file.name());
                files::take_in(&path, Uint8Array::new(&bytes).to_vec());
                then(Some(path));
            }
        });
    });
    input.set_onchange(Some(changed.unchecked_ref()));
    input.click();
    Ok(())
}

/// Puts a link to the page, by what stands behind its `#`, into the address line and onto the clipboard.
pub(in crate::app) fn share(fragment: &str) -> bool {
    let Some(window) = web_sys::window() else { return false };
    let address = format!("#{fragment}");
    // A page that was opened from a file may not do either; then there is nothing to be done.
    let _ = window.history().and_then(|past| past.replace_state_with_url(&JsValue::NULL, "", Some(&address)));
    if let (true, Ok(whole)) = (window.is_secure_context(), window.location().href()) {
        let copied = JsFuture::from(window.navigator().clipboard().write_text(&whole));
        spawn_local(async move { drop(copied.await) });
    }
    true
}

/// The user's own folder.
pub(in crate::app) fn home_folder() -> Option<PathBuf> {
    None
}

/// Where this user's lists and unsaved work are kept.
pub(in crate::app) fn users_folder() -> Option<PathBuf> {
    None
}
