//! Runs of a sweep on several threads.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

use super::plan::Plan;
use super::row::Row;

/// Computes runs on so many threads and hands each row to `told` on this one, as it comes out; the first error ends the work.
///
/// A row depends on its run alone: not on the order, nor on the number of threads.
///
/// # Errors
///
/// Those of `told`.
pub fn compute<E>(
    plan: &Plan,
    runs: &[usize],
    threads: usize,
    told: &mut dyn FnMut(Row) -> Result<(), E>,
) -> Result<(), E> {
    let next = AtomicUsize::new(0);
    // A thread waits while so many rows are not written yet: none is computed long before it is kept.
    let (sender, receiver) = mpsc::sync_channel(threads.max(1));
    std::thread::scope(|scope| {
        for _ in 0..threads.max(1) {
            let (sender, next) = (sender.clone(), &next);
            scope.spawn(move || {
                while let Some(&run) = runs.get(next.fetch_add(1, Ordering::Relaxed)) {
                    // Nobody receives any more: the work has ended.
                    if sender.send(Row::compute(plan, run)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(sender);
        let mut rows = receiver.into_iter();
        rows.try_for_each(told)
    })
}
