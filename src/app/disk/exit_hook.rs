//! What is still done when the process ends in the middle of things.
//!
//! Xlib ends the process by C's `exit` when its server goes away: nothing unwinds and nothing is dropped, but the
//! destructors of the calling thread's thread-locals run, and the other threads go on meanwhile. That thread is the
//! window's. Whoever must do something first leaves a will with it.

use std::cell::RefCell;
use std::io::Write as _;
use std::rc::{Rc, Weak};

use crate::app::text;

/// What is to be done, and says whether there was anything to do. It is taken back by dropping it.
pub(in crate::app) type Will = Rc<dyn Fn() -> bool>;

thread_local! {
    static WILLS: RefCell<Wills> = const { RefCell::new(Wills(Vec::new())) };
}

struct Wills(Vec<Weak<dyn Fn() -> bool>>);

impl Drop for Wills {
    fn drop(&mut self) {
        let left: Vec<Will> = self.0.drain(..).filter_map(|will| will.upgrade()).collect();
        if left.is_empty() {
            return;
        }
        // Each is done, whatever the others say.
        let kept = left.iter().filter(|will| will()).count() > 0;
        let words = if kept { text::CUT_OFF_KEPT } else { text::CUT_OFF };
        // With the display the terminal may be gone too.
        let _ = writeln!(std::io::stderr(), "{words}");
    }
}

/// Leaves a will with this thread.
pub(in crate::app) fn leave(will: &Will) {
    WILLS.with_borrow_mut(|wills| {
        wills.0.retain(|old| old.strong_count() > 0);
        wills.0.push(Rc::downgrade(will));
    });
}
