//! The one device that the tests of a process share; without an adapter they are skipped, counted and printed.

use std::io::Write as _;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use girderbench::snapshot::Studio;

static STUDIO: OnceLock<Option<Mutex<Studio>>> = OnceLock::new();
static SKIPPED: AtomicUsize = AtomicUsize::new(0);

/// Straight to the terminal: what a passing test prints is swallowed, and a skip must be seen.
fn say(line: &str) {
    writeln!(std::io::stderr(), "{line}").expect("standard error is open");
}

/// The device, or nothing after saying so.
///
/// # Panics
/// Where there is no adapter and `GIRDERBENCH_REQUIRE_GPU=1` asks for one.
pub(crate) fn studio(test: &str) -> Option<MutexGuard<'static, Studio>> {
    let studio = STUDIO.get_or_init(|| match Studio::open(None) {
        Ok(studio) => Some(Mutex::new(studio)),
        Err(error) => {
            let required = std::env::var_os("GIRDERBENCH_REQUIRE_GPU").is_some_and(|v| v == "1");
            assert!(!required, "GIRDERBENCH_REQUIRE_GPU=1, but {error}");
            say(&error.to_string());
            None
        }
    });
    let Some(studio) = studio else {
        let count = SKIPPED.fetch_add(1, Ordering::Relaxed) + 1;
        say(&format!("skipped for want of an adapter ({count} so far): {test}"));
        return None;
    };
    // A test that failed while it held the device leaves it whole: every picture begins anew.
    Some(studio.lock().unwrap_or_else(PoisonError::into_inner))
}
