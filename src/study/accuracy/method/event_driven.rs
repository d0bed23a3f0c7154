//! The event-driven solver, as the product runs it: closed-form flight, Dormand–Prince 8(5,3) in contact, every change of
//! state a root. Asked by its continuous answer, so the instants of comparison cost it nothing on the way.

use super::interface::{Job, Method, SettingKind, Work};
use crate::scene::Scene;
use crate::sim::History;

/// The event-driven solver.
#[derive(Debug)]
pub(super) struct EventDriven;

impl Method for EventDriven {
    fn name(&self) -> &'static str {
        "event-driven"
    }

    fn setting_kind(&self) -> SettingKind {
        SettingKind::Tolerance
    }

    fn knows(&self, _: &Scene) -> bool {
        true
    }

    fn work(&self, job: &Job<'_>) -> Result<Work, String> {
        let mut scene = job.scene.clone();
        scene.solver.tolerance = job.setting;
        let history = History::of(&scene).map_err(|errors| errors.to_string())?;
        match history.stop() {
            Some(stop) => Err(format!("stopped at {} s: {}", stop.t, stop.reason.english())),
            None => Ok(Work::History(Box::new(history))),
        }
    }
}
