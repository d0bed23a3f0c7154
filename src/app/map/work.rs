//! The runs of a sweep beside the window: coarse grids first, each run told as it comes out, to be cancelled.

use std::collections::VecDeque;
use std::num::NonZero;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};

use crate::app::host::{Slices, THREADS, Wake, in_slices};
use crate::files::Records;
use crate::scene::{Scene, SceneErrors};
use crate::study::sweep::{Nested, Plan, Row, compute};

/// Message of a thread.
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
    news: Receiver<News>,
    work: Slices,
}

impl Drop for Job {
    fn drop(&mut self) {
        self.cancel.store(true, Ordering::Relaxed);
    }
}

impl Job {
    /// Next message, if there is one.
    pub(super) fn take(&self) -> Option<News> {
        self.news.try_recv().ok()
    }

    /// Computes a run, where nobody else does.
    pub(super) fn go_on(&mut self) {
        self.work.go_on();
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
    let (cancelled, woken) = (cancel.clone(), wake.clone());
    let mut runs = None;
    let work = in_slices(
        move |_| {
            let known = runs.get_or_insert_with(|| Runs::planned(scene.clone(), &order, folder.clone(), &send));
            let more = match known {
                Ok(runs) => !cancelled.load(Ordering::Relaxed) && runs.go_on(&cancelled, &send),
                Err(()) => false,
            };
            if !more {
                // Nobody listens any more where the window of the sweep is closed.
                let _ = send.send(News::Ended);
                woken();
            }
            more
        },
        wake,
    );
    Job { cancel, news, work }
}

/// One processor is left to the window.
fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, NonZero::get).saturating_sub(1).max(1)
}

/// Runs that are left to be computed.
struct Runs {
    plan: Arc<Plan>,
    left: VecDeque<usize>,
}

impl Runs {
    /// The runs of an order, once their number is sent; `Err` where the order is refused, or the receiver is gone.
    fn planned(scene: Scene, order: &Order, folder: PathBuf, send: &Sender<News>) -> Result<Self, ()> {
        let records = Records::in_folder(folder);
        let read = Box::new(move |scene: &mut Scene| records.complete(scene));
        let plan = Plan::new(scene, &order.vary, &order.measures, read);
        let plan = Arc::new(plan.map_err(|errors| drop(send.send(News::Refused(errors))))?);
        let left = Nested::of(&plan).map(Nested::order).unwrap_or_default().into();
        send.send(News::Begun(plan.clone())).map_err(|_| ())?;
        Ok(Self { plan, left })
    }

    /// Computes all of them on threads, or the next one where there are none; whether some are left.
    fn go_on(&mut self, cancelled: &AtomicBool, send: &Sender<News>) -> bool {
        if !THREADS {
            let row = self.left.pop_front().map(|run| Row::compute(&self.plan, run));
            return row.is_some_and(|row| send.send(News::Row(row)).is_ok());
        }
        // An end before its time is no fault: it was asked for.
        let _ = compute(&self.plan, self.left.make_contiguous(), threads(), &mut |row| {
            let goes_on = !cancelled.load(Ordering::Relaxed) && send.send(News::Row(row)).is_ok();
            if goes_on { Ok(()) } else { Err(()) }
        });
        false
    }
}
