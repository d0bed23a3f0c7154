//! Runs a scene in the foreground, with a progress bar and a timer.

use super::progress::{Progress, Timer, Waiting};
use crate::language::Text;
use crate::scene::{ModelKind, Scene, SceneErrors};
use crate::sim::{ErrorEstimate, History, Session};
use crate::tables::{self, Table, TableOptions};

/// An answer, and how long it took \[s\].
#[derive(Debug)]
pub(super) struct Timed {
    pub(super) history: History,
    pub(super) run_time: f64,
    /// Whether its model leads.
    pub(super) leads: bool,
}

/// Text beside the time while bodies that met are computed again.
const AGAIN: Text = Text::new("progress-again");

/// Runs a scene by every model that it asks for, each timed for itself, the one that leads first; never empty.
pub(super) fn compute(scene: &Scene) -> Result<Vec<Timed>, SceneErrors> {
    let run = |(number, &kind): (usize, &ModelKind)| {
        let mut one = scene.clone();
        one.model.kind = kind;
        compute_as_asked(&one).map(|timed| Timed { leads: number == 0, ..timed })
    };
    scene.model.kind.models().iter().enumerate().map(run).collect()
}

/// Runs a scene to its end, or to where it gives up: the model that leads, with the other beside it.
pub(super) fn compute_as_asked(scene: &Scene) -> Result<Timed, SceneErrors> {
    let timer = Timer::start();
    let mut progress = Progress::over(scene.duration, Text::new("progress-seconds"));
    let mut session = Session::new(scene)?;
    session.advance(scene.duration, &mut |reached| {
        progress.show_of(reached.t, if reached.met > 0 { AGAIN.as_str() } else { "" });
        true
    });
    let history = session.finish();
    let run_time = timer.seconds();
    progress.done();
    Ok(Timed { history, run_time, leads: true })
}

impl Timed {
    /// Its tables, called by the model where another one leads.
    pub(super) fn tables(&self, options: &TableOptions) -> Vec<Table<'_>> {
        if self.leads { tables::all(&self.history, options) } else { tables::all_beside(&self.history, options) }
    }

    /// Estimated error, degree check and run time, and the rows per second of its tables \[Hz\]; a sign of life while a long run is
    /// repeated.
    pub(super) fn options(&self, sample_hz: f64) -> TableOptions {
        let _waiting = Waiting::for_about(self.run_time, Text::new("progress-error"));
        let history = &self.history;
        // Summaries want the poundings: they are found while another thread runs the scene again.
        let beside = || (history.sections().check_degree(), history.hits().poundings().len());
        let (estimated_error, (degree_check, _)) = rayon::join(|| ErrorEstimate::of(history), beside);
        TableOptions { sample_hz, estimated_error: Some(estimated_error), degree_check, run_time: Some(self.run_time) }
    }
}
