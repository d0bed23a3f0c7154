//! One scene under examination: run it, and put every check to the answer.

use super::check::{self, Check, Complaint, Figures};
use super::watch::{Clock, Limits, NoAnswer, Watch};
use crate::scene::{Scene, domain};
use crate::sim::{Cause, History, Stop};

/// Outcome for a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Every check that is put to the scene passed.
    Passed,
    /// Outside the domain: the run ended early and said why.
    GaveUp(String),
    /// The scene makes no sense, and validation says so: nothing was run.
    Refused(String),
    /// Some checks failed; in their own order.
    Failed(Vec<Complaint>),
}

/// A scene's outcome with its figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Examined {
    /// Outcome.
    pub outcome: Outcome,
    /// Measured values.
    pub figures: Figures,
    /// Duration of the examined scene: its own, or the time at which the limit of events or steps was reached \[s\].
    pub until: f64,
}

/// Examines a scene within limits; a panic is a failure like any other. Inside the domain every check is put; outside, that the
/// run ends in time, with finite numbers or a reason.
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

/// Message of a panic.
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
    let inside = domain::is_inside(scene);
    // Where a support is lost the model's motion ends: the answer is that of a scene that ends then.
    let history = match history.stop() {
        Some(&Stop { cause: Cause::SupportLost, t, .. }) => history.cut(t),
        _ => history,
    };
    let stop = history.stop().filter(|stop| stop.cause != Cause::SupportLost);
    let gave_up = stop.map(|stop| format!("at t = {} s, {}: {}", stop.t, stop.place, stop.reason.english()));
    if let Some(reason) = gave_up.as_ref().filter(|_| inside) {
        return failed(scene, Check::Finishes, reason.clone());
    }
    let (mut complaints, mut figures) = (Vec::new(), Figures::default());
    if inside {
        check::answer(&history, &mut figures, &mut complaints);
    } else {
        check::numbers(&history, &mut figures, &mut complaints);
    }
    if inside && complaints.is_empty() {
        check::convergence(&history, watch, &mut figures, &mut complaints);
    }
    let outcome = match (complaints.is_empty(), gave_up) {
        (false, _) => Outcome::Failed(complaints),
        (true, Some(reason)) => Outcome::GaveUp(reason),
        (true, None) => Outcome::Passed,
    };
    Examined { outcome, figures, until: history.end() }
}
