//! Callbacks that run when C's `exit` ends the process.
//!
//! Xlib calls `exit` when the X server goes away: no stack unwinds and nothing is dropped, but destructors of the calling thread's
//! thread-locals run while other threads go on. The calling thread is the window's; callbacks are registered there.

use std::cell::RefCell;
use std::io::Write as _;
use std::rc::{Rc, Weak};

use crate::app::text;

/// A callback at exit; returns whether unsaved work is on the disk. Dropping the last `Rc` unregisters the callback.
pub(in crate::app) type ExitCallback = Rc<dyn Fn() -> bool>;

thread_local! {
    static CALLBACKS: RefCell<Callbacks> = const { RefCell::new(Callbacks(Vec::new())) };
}

struct Callbacks(Vec<Weak<dyn Fn() -> bool>>);

impl Drop for Callbacks {
    fn drop(&mut self) {
        let left: Vec<ExitCallback> = self.0.drain(..).filter_map(|callback| callback.upgrade()).collect();
        if left.is_empty() {
            return;
        }
        // Each is called, whatever the others return.
        let kept = left.iter().filter(|callback| callback()).count() > 0;
        let words = if kept { text::CUT_OFF_KEPT } else { text::CUT_OFF };
        // With the display the terminal may be gone too.
        let _ = writeln!(std::io::stderr(), "{words}");
    }
}

/// Registers a callback with this thread.
pub(in crate::app) fn register(callback: &ExitCallback) {
    CALLBACKS.with_borrow_mut(|callbacks| {
        callbacks.0.retain(|old| old.strong_count() > 0);
        callbacks.0.push(Rc::downgrade(callback));
    });
}
