//! Runs a scene in the foreground, with a progress bar and a timer.

use super::progress::{Progress, Timer, Waiting};
use crate::scene::{Scene, SceneErrors};
use crate::sim::{History, Session};

/// An answer, and how long it took \[s\].
#[derive(Debug)]
pub(super) struct Timed {
    pub(super) history: History,
    pub(super) run_time: f64,
}

/// Runs a scene to its end, or to where it gives up.
pub(super) fn compute(scene: &Scene) -> Result<Timed, SceneErrors> {
    let timer = Timer::start();
    let mut progress = Progress::over(scene.duration, "s");
    let mut session = Session::new(scene)?;
    session.advance(scene.duration, &mut |reached| {
        progress.show(reached);
        true
    });
    let history = session.finish();
    let run_time = timer.seconds();
    progress.done();
    Ok(Timed { history, run_time })
}

impl Timed {
    /// The estimated error \[m\], with a sign of life while a long run is repeated.
    pub(super) fn estimate_error(&self) -> f64 {
        let _waiting =
            Waiting::for_about(self.run_time, "estimating the error: the run at a hundredth of the tolerance");
        self.history.estimate_error()
    }
}
