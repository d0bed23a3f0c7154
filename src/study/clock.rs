//! Computing time: the least CPU time of several runs after a warm-up.
//!
//! CPU time of the process, all its threads together, and not the clock on the wall: a machine that others work on too
//! gives the same figure, and a run on several threads is charged for all of them.

/// Once a measurement has taken this long, it is not repeated any more \[s\].
const ENOUGH: f64 = 1.5;

/// Processor time that this thread has used \[s\]; not a number where the system keeps no such clock.
pub fn thread_seconds() -> f64 {
    system::thread_seconds().unwrap_or(f64::NAN)
}

/// A value and how long it takes to get.
#[derive(Clone, Copy, Debug)]
pub struct Timed<T> {
    /// Result of the last run.
    pub value: T,
    /// The least CPU time of the runs counted \[s\].
    pub seconds: f64,
    /// Runs counted.
    pub runs: usize,
}

/// Runs `work` once to warm up, then up to `repeat` times; what takes longer than a second or so is run less often, and
/// its warm-up counts where nothing else does.
pub fn fastest<T>(repeat: usize, mut work: impl FnMut() -> T) -> Timed<T> {
    let mut once = || {
        // Where the system keeps no such clock, the time is not a number and says so in the tables.
        let start = system::process_seconds();
        let value = work();
        let seconds = start.zip(system::process_seconds()).map_or(f64::NAN, |(start, end)| end - start);
        (value, seconds)
    };
    let (mut value, warm_up) = once();
    let (mut least, mut runs, mut spent) = (f64::INFINITY, 0, warm_up);
    while runs < repeat && spent + 0.5 * warm_up < ENOUGH {
        let (again, seconds) = once();
        value = again;
        least = least.min(seconds);
        spent += seconds;
        runs += 1;
    }
    if runs == 0 {
        (least, runs) = (warm_up, 1);
    }
    Timed { value, seconds: least, runs }
}

/// Processor time that was used \[s\]; `None` where the system keeps no such clock.
#[cfg(not(target_arch = "wasm32"))]
mod system {
    use cpu_time::{ProcessTime, ThreadTime};

    /// By this thread.
    pub(super) fn thread_seconds() -> Option<f64> {
        ThreadTime::try_now().ok().map(|time| time.as_duration().as_secs_f64())
    }

    /// By the process, all its threads together.
    pub(super) fn process_seconds() -> Option<f64> {
        ProcessTime::try_now().ok().map(|time| time.as_duration().as_secs_f64())
    }
}

/// A page in a browser has no such clock.
#[cfg(target_arch = "wasm32")]
mod system {
    /// By this thread: not known.
    pub(super) fn thread_seconds() -> Option<f64> {
        None
    }

    /// By the process: not known.
    pub(super) fn process_seconds() -> Option<f64> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_work_is_repeated_as_often_as_asked_after_a_warm_up() {
        let mut count = 0;
        let timed = fastest(4, || {
            count += 1;
            count
        });
        assert_eq!((timed.value, timed.runs), (5, 4), "one warm-up, four that count");
        assert!(timed.seconds.is_finite(), "a time was measured");
    }
}
