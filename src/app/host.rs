//! Services of the machine for the window: the time on the wall, threads and a way for them to wake it, paths that the user chooses. A page
//! in a browser has the same by other means; it has no threads, and work that would go on beside the window is done at once or in slices
//! between frames.

#[cfg(target_arch = "wasm32")]
#[path = "host/browser.rs"]
mod machine;
#[cfg(not(target_arch = "wasm32"))]
#[path = "host/native.rs"]
mod machine;

use std::future::Future;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};

use machine::{MaySend, finish};

pub(in crate::app) use machine::{
    Later, PAGE, Slices, THREADS, Thread, choose, home_folder, in_slices, share, spawn, users_folder,
};
pub(in crate::app) use web_time::Instant;

/// Calls the window back when a thread has news; does nothing in a test.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// The time on the wall, for waking the window and for timing a run; the physics never sees it.
#[expect(clippy::disallowed_methods, reason = "the one clock of the window")]
pub(in crate::app) fn now() -> Instant {
    Instant::now()
}

/// Purpose of a chosen path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::app) enum Choice {
    /// A file that is there.
    File,
    /// A folder.
    Folder,
    /// A file that is to be written, called so unless the user says otherwise.
    New(String),
}

/// Files of a kind: its name, and what their names end in.
pub(in crate::app) type Filter = (String, Vec<&'static str>);

/// A sentence for the user, and the file or folder that it is about.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::app) struct Told {
    /// The sentence.
    pub(in crate::app) words: String,
    /// Where something was written.
    pub(in crate::app) place: Option<PathBuf>,
}

impl<T: Into<String>> From<T> for Told {
    fn from(words: T) -> Self {
        Self { words: words.into(), place: None }
    }
}

/// Work whose result is a sentence, whether it succeeds or fails.
pub(in crate::app) type Work = Box<dyn FnOnce() -> Result<Told, String> + Send>;

/// Work on threads that ends with one sentence for the user.
pub(in crate::app) struct Background {
    send: Sender<Told>,
    done: Receiver<Told>,
    /// Files that are being written.
    written: Arc<Mutex<Vec<PathBuf>>>,
    wake: Wake,
}

impl Background {
    /// No work yet.
    pub(in crate::app) fn new(wake: Wake) -> Self {
        let (send, done) = channel();
        Self { send, done, written: Arc::default(), wake }
    }

    /// Who is woken when work has ended.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.wake = wake;
    }

    /// Begins work; its result is a sentence, whether it succeeds or fails; an empty one is not told.
    pub(in crate::app) fn run(&self, work: Work) {
        let (send, wake) = (self.send.clone(), self.wake.clone());
        // It ends by itself.
        let _ = spawn(move || {
            let words = work().unwrap_or_else(Told::from);
            // The window has closed, and with it the receiver: nothing to do then.
            let _ = send.send(words);
            wake();
        });
    }

    /// Begins work that writes a file; `false` where that is being written already.
    pub(in crate::app) fn write(&self, path: &Path, work: Work) -> bool {
        let mut all = self.written.lock().unwrap_or_else(PoisonError::into_inner);
        if all.iter().any(|written| written == path) {
            return false;
        }
        all.push(path.to_owned());
        drop(all);
        let until_done = BeingWritten { all: self.written.clone(), path: path.to_owned() };
        self.run(Box::new(move || {
            let _until_done = until_done;
            work()
        }));
        true
    }

    /// Files that are being written, the first begun first.
    pub(in crate::app) fn written(&self) -> Vec<PathBuf> {
        self.written.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Begins work that has to wait for the graphics system, or for the browser.
    pub(in crate::app) fn run_later(&self, work: impl Future<Output = Result<Told, String>> + MaySend + 'static) {
        let (send, wake) = (self.send.clone(), self.wake.clone());
        finish(async move {
            let words = work.await.unwrap_or_else(Told::from);
            // The window has closed, and with it the receiver: nothing to do then.
            let _ = send.send(words);
            wake();
        });
    }

    /// The sentence of work that has ended, one at a time.
    pub(in crate::app) fn take(&self) -> Option<Told> {
        self.done.try_recv().ok().filter(|told| !told.words.is_empty())
    }
}

/// A file among those that are being written, however its work ends.
struct BeingWritten {
    all: Arc<Mutex<Vec<PathBuf>>>,
    path: PathBuf,
}

impl Drop for BeingWritten {
    fn drop(&mut self) {
        self.all.lock().unwrap_or_else(PoisonError::into_inner).retain(|other| *other != self.path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Language;

    #[test]
    fn work_speaks_the_language_of_who_began_it() {
        let background = Background::new(Arc::new(|| ()));
        Language::Japanese.within(|| background.run(Box::new(|| Ok(Language::current().code().into()))));
        assert_eq!(background.done.recv().expect("it ends").words, "ja", "there");
        assert_eq!(Language::current(), Language::English, "and here as before");
    }

    #[test]
    fn a_file_is_written_once_at_a_time_and_known_to_be_meanwhile() {
        let (go, wait) = channel();
        let (send, woken) = channel();
        let background = Background::new(Arc::new(move || send.send(()).expect("the test listens")));
        let path = Path::new("deck.html");
        assert!(
            background.write(path, Box::new(move || wait.recv().map(|()| "written".into()).map_err(|e| e.to_string())))
        );
        assert!(!background.write(path, Box::new(|| Ok("again".into()))), "not while it is written");
        assert_eq!(background.written(), [path], "it is shown");
        go.send(()).expect("it waits");
        woken.recv().expect("the window is woken");
        assert_eq!((background.take(), background.written()), (Some(Told::from("written")), Vec::new()));
    }

    #[test]
    fn work_ends_with_its_sentence_whether_it_succeeds_or_fails() {
        let (send, woken) = channel();
        let background = Background::new(Arc::new(move || send.send(()).expect("the test listens")));
        background.run(Box::new(|| Err("no place".to_owned())));
        woken.recv().expect("the window is woken");
        assert_eq!(background.take(), Some(Told::from("no place")), "the reason");
        assert_eq!(background.take(), None, "once");
    }
}
