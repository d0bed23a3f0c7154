//! The runs of a sweep on threads of their own: coarse grids first, each run told as it comes out, to be cancelled.

use std::num::NonZero;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};

use crate::app::host::Wake;
use crate::files::Records;
use crate::scene::{Scene, SceneErrors};
use crate::study::sweep::{Nested, Plan, Row, compute};

/// What a thread has brought.
pub(super) enum News {
    /// The runs are known, and begin.
    Begun(Arc<Plan>),
    /// A run has come out.
    Row(Row),
    /// The sweep cannot be computed.
    Refused(SceneErrors),
    /// Nothing more comes.
    Ended,
}

/// Runs that are being computed; dropped, no further one is begun.
pub(super) struct Job {
    cancel: Arc<AtomicBool>,
    pub(super) news: Receiver<News>,
}

impl Drop for Job {
    fn drop(&mut self) {
        self.cancel.store(true, Ordering::Relaxed);
    }
}

/// A sweep that is asked for: `KEY=VALUES` of each key, the names of what is kept of each run.
pub(super) struct Order {
    pub(super) vary: Vec<String>,
    pub(super) measures: Vec<String>,
}

/// Begins to compute a sweep of a scene whose records lie in `folder`.
pub(super) fn begin(scene: Scene, order: Order, folder: PathBuf, wake: Wake) -> Job {
    let (send, news) = channel();
    let cancel = Arc::new(AtomicBool::new(false));
    let cancelled = cancel.clone();
    std::thread::spawn(move || {
        let records = Records::in_folder(folder);
        let read = Box::new(move |scene: &mut Scene| records.complete(scene));
        let last = match Plan::new(scene, &order.vary, &order.measures, read) {
            Ok(plan) => {
                runs(&Arc::new(plan), &cancelled, &send);
                News::Ended
            }
            Err(errors) => News::Refused(errors),
        };
        // Nobody listens any more where the window of the sweep is closed.
        let _ = send.send(last);
        wake();
    });
    Job { cancel, news }
}

/// One processor is left to the window.
fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, NonZero::get).saturating_sub(1).max(1)
}

fn runs(plan: &Arc<Plan>, cancelled: &AtomicBool, send: &Sender<News>) {
    let order = Nested::of(plan).map(Nested::order).unwrap_or_default();
    if send.send(News::Begun(plan.clone())).is_err() {
        return;
    }
    // An end before its time is no fault: it was asked for.
    let _ = compute(plan, &order, threads(), &mut |row| {
        let goes_on = !cancelled.load(Ordering::Relaxed) && send.send(News::Row(row)).is_ok();
        if goes_on { Ok(()) } else { Err(()) }
    });
}
