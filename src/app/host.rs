//! What the window takes from the machine besides files: the time on the wall, threads, and a way for them to wake it.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Instant;

/// Calls the window back when a thread has news; does nothing in a test.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// The time on the wall, for waking the window and for timing a run; the physics never sees it.
#[expect(clippy::disallowed_methods, reason = "the one clock of the window")]
pub(in crate::app) fn now() -> Instant {
    Instant::now()
}

/// Work on threads that ends with one sentence for the user.
pub(in crate::app) struct Background {
    send: Sender<String>,
    done: Receiver<String>,
    wake: Wake,
}

impl Background {
    /// No work yet.
    pub(in crate::app) fn new(wake: Wake) -> Self {
        let (send, done) = channel();
        Self { send, done, wake }
    }

    /// Who is woken when work has ended.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.wake = wake;
    }

    /// Begins work; its result is a sentence, whether it succeeds or fails.
    pub(in crate::app) fn run(&self, work: impl FnOnce() -> Result<String, String> + Send + 'static) {
        let (send, wake) = (self.send.clone(), self.wake.clone());
        std::thread::spawn(move || {
            let words = work().unwrap_or_else(|problem| problem);
            // The window has closed, and with it the receiver: nothing to do then.
            let _ = send.send(words);
            wake();
        });
    }

    /// The sentence of work that has ended, one at a time.
    pub(in crate::app) fn take(&self) -> Option<String> {
        self.done.try_recv().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_ends_with_its_sentence_whether_it_succeeds_or_fails() {
        let (send, woken) = channel();
        let background = Background::new(Arc::new(move || send.send(()).expect("the test listens")));
        background.run(|| Err("no place".to_owned()));
        woken.recv().expect("the window is woken");
        assert_eq!(background.take().as_deref(), Some("no place"), "the reason");
        assert_eq!(background.take(), None, "once");
    }
}
