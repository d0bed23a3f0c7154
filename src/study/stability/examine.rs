//! One scene under examination: run it, and put every check to the answer.

use super::check::{self, Check, Complaint, Figures};
use super::watch::{Clock, Limits, NoAnswer, Watch};
use crate::scene::Scene;
use crate::sim::History;

/// What came out for a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Every check passed.
    Passed,
    /// The scene makes no sense, and validation says so: nothing was run.
    Refused(String),
    /// Some checks failed; in their own order.
    Failed(Vec<Complaint>),
}

/// A scene's outcome with its figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Examined {
    /// What came out.
    pub outcome: Outcome,
    /// What was measured.
    pub figures: Figures,
    /// How long the examined scene lasts: as it is, or until as many events have come up, or steps were taken, as were asked for \[s\].
    pub until: f64,
}

/// Examines a scene within limits; a panic is a failure like any other.
///
/// A scene with more events or steps than asked for is examined as one that ends with the last of them: where contacts
/// chatter or creep in jerks, millions of events say no more than the first ten thousands. What does not get that far fails.
pub fn examine(scene: &Scene, clock: Clock<'_>, limits: Limits) -> Examined {
    let watched = std::panic::AssertUnwindSafe(|| {
        let watch = Watch::new(clock, limits.patience);
        checked(scene, watch.run(scene, limits), &watch)
    });
    let panicked = |panic: Box<dyn std::any::Any + Send>| failed(scene, Check::Panic, message(panic.as_ref()));
    std::panic::catch_unwind(watched).unwrap_or_else(panicked)
}

fn failed(scene: &Scene, check: Check, detail: String) -> Examined {
    let outcome = Outcome::Failed(vec![Complaint::new(check, detail)]);
    Examined { outcome, figures: Figures::default(), until: scene.duration }
}

/// What a panic said.
fn message(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str).or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("a panic without a message").to_owned()
}

fn checked(scene: &Scene, ran: Result<History, NoAnswer>, watch: &Watch<'_>) -> Examined {
    let history = match ran {
        Ok(history) => history,
        Err(NoAnswer::Refused(errors)) => {
            let outcome = Outcome::Refused(errors.to_string());
            return Examined { outcome, figures: Figures::default(), until: scene.duration };
        }
        Err(NoAnswer::Slow(t)) => return failed(scene, Check::Time, format!("came to {t} s of {} s", scene.duration)),
    };
    if let Some(stop) = history.stop() {
        return failed(scene, Check::Finishes, format!("at t = {} s, {}: {}", stop.t, stop.place, stop.reason));
    }
    let (mut complaints, mut figures) = (Vec::new(), Figures::default());
    check::answer(&history, &mut figures, &mut complaints);
    if complaints.is_empty() {
        check::convergence(&history, watch, &mut figures, &mut complaints);
    }
    let outcome = if complaints.is_empty() { Outcome::Passed } else { Outcome::Failed(complaints) };
    Examined { outcome, figures, until: history.end() }
}
