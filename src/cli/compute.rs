//! Runs a scene in the foreground, with a progress bar and a timer.

use super::progress::{Progress, Timer, Waiting};
use crate::scene::{ModelKind, Scene, SceneErrors};
use crate::sim::{History, Session};
use crate::tables::{self, TableOptions};

/// An answer, and how long it took \[s\].
#[derive(Debug)]
pub(super) struct Timed {
    pub(super) history: History,
    pub(super) run_time: f64,
    /// Whether its model leads.
    pub(super) leads: bool,
}

/// Runs a scene by every model that it asks for, the one that leads first; never empty.
pub(super) fn compute(scene: &Scene) -> Result<Vec<Timed>, SceneErrors> {
    let run = |(number, &kind): (usize, &ModelKind)| {
        if number == 0 {
            return compute_leading(scene);
        }
        let mut other = scene.clone();
        other.model.kind = kind;
        compute_leading(&other).map(|timed| Timed { leads: false, ..timed })
    };
    scene.model.kind.models().iter().enumerate().map(run).collect()
}

/// Runs a scene by the model that leads, to its end or to where it gives up.
pub(super) fn compute_leading(scene: &Scene) -> Result<Timed, SceneErrors> {
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
    Ok(Timed { history, run_time, leads: true })
}

impl Timed {
    /// Its tables, called by the model where another one leads.
    pub(super) fn tables(&self, options: &TableOptions) -> Vec<(String, Vec<u8>)> {
        if self.leads { tables::all(&self.history, options) } else { tables::all_beside(&self.history, options) }
    }

    /// The estimated error \[m\], with a sign of life while a long run is repeated.
    pub(super) fn estimate_error(&self) -> f64 {
        let _waiting =
            Waiting::for_about(self.run_time, "estimating the error: the run at a hundredth of the tolerance");
        self.history.estimate_error()
    }
}
