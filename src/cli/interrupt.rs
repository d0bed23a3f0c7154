//! SIGINT and SIGTERM while files are written: what is unfinished is removed before the program ends.
//!
//! While nothing is written they end the program at once, as by default. Within a [`Writing`] the first raises a flag, which
//! what writes looks at between two portions; the second ends the program at once, and the next run into the folder removes
//! what is left unfinished there.

use std::io::Write;

use super::failure::Failure;
use crate::language::Text;

/// A stretch in which files are written.
#[derive(Debug)]
pub(super) struct Writing {
    /// Whether a signal has come.
    raised: fn() -> bool,
}

impl Writing {
    /// Begins it.
    pub(super) fn begin() -> Self {
        system::end_at_once(false);
        Self { raised: system::raised }
    }

    /// Whether to go on.
    ///
    /// # Errors
    /// When a signal has come.
    pub(super) fn check(&self) -> Result<(), Failure> {
        if (self.raised)() { Err(Failure::Interrupted(Text::new("interrupted-nothing").into())) } else { Ok(()) }
    }

    /// A writer that fails once a signal has come.
    pub(super) fn guard<'a>(&'a self, out: &'a mut dyn Write) -> impl Write + 'a {
        Guarded { out, writing: self }
    }
}

impl Drop for Writing {
    fn drop(&mut self) {
        system::end_at_once(true);
    }
}

struct Guarded<'a> {
    out: &'a mut dyn Write,
    writing: &'a Writing,
}

impl Write for Guarded<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        // Not of the kind `Interrupted`, after which a writer tries again.
        if (self.writing.raised)() { Err(std::io::Error::other("interrupted")) } else { self.out.write(bytes) }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.out.flush()
    }
}

/// Ends the program by the signal that came while files were written, if one did: who started it sees what ended it.
pub(super) fn end_if_raised() {
    system::end();
}

#[cfg(unix)]
mod system {
    use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
    use std::sync::{Arc, OnceLock};

    use signal_hook::consts::{SIGINT, SIGTERM};
    use signal_hook::{flag, low_level};

    /// Flags shared by the handlers of the signals and the program.
    struct Seen {
        end_at_once: Arc<AtomicBool>,
        /// The signal that came; 0 before.
        raised: Arc<AtomicUsize>,
    }

    static SEEN: OnceLock<Seen> = OnceLock::new();

    fn seen() -> &'static Seen {
        SEEN.get_or_init(|| {
            let seen = Seen { end_at_once: Arc::new(AtomicBool::new(true)), raised: Arc::new(AtomicUsize::new(0)) };
            for signal in [SIGINT, SIGTERM] {
                // In this order: a first signal arms the end by a second. Where the system refuses, signals act by default.
                let number = usize::try_from(signal).unwrap_or_default();
                let _ = flag::register_conditional_default(signal, seen.end_at_once.clone())
                    .and_then(|_| flag::register_usize(signal, seen.raised.clone(), number))
                    .and_then(|_| flag::register(signal, seen.end_at_once.clone()));
            }
            seen
        })
    }

    pub(super) fn end_at_once(yes: bool) {
        seen().end_at_once.store(yes, Ordering::SeqCst);
    }

    pub(super) fn raised() -> bool {
        SEEN.get().is_some_and(|seen| seen.raised.load(Ordering::SeqCst) != 0)
    }

    pub(super) fn end() {
        let signal = SEEN.get().map_or(0, |seen| seen.raised.load(Ordering::SeqCst));
        if let (true, Ok(signal)) = (signal != 0, i32::try_from(signal)) {
            let _ = low_level::emulate_default_handler(signal);
        }
    }
}

#[cfg(not(unix))]
mod system {
    pub(super) fn end_at_once(_: bool) {}

    pub(super) fn raised() -> bool {
        false
    }

    pub(super) fn end() {}
}
