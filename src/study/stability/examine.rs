//! One scene under examination: run it, and put every check to the answer.

use super::check::{self, Check, Complaint, Figures};
use super::watch::{Clock, NoAnswer, Watch};
use crate::scene::Scene;

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
}

/// Examines a scene within `patience` seconds; a panic is a failure like any other.
pub fn examine(scene: &Scene, clock: Clock<'_>, patience: f64) -> Examined {
    let watched = std::panic::AssertUnwindSafe(|| checked(scene, &Watch::new(clock, patience)));
    std::panic::catch_unwind(watched).unwrap_or_else(|panic| failed(Check::Panic, message(panic.as_ref())))
}

fn failed(check: Check, detail: String) -> Examined {
    Examined { outcome: Outcome::Failed(vec![Complaint::new(check, detail)]), figures: Figures::default() }
}

/// What a panic said.
fn message(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str).or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("a panic without a message").to_owned()
}

fn checked(scene: &Scene, watch: &Watch<'_>) -> Examined {
    let history = match watch.run(scene) {
        Ok(history) => history,
        Err(NoAnswer::Refused(errors)) => {
            return Examined { outcome: Outcome::Refused(errors.to_string()), figures: Figures::default() };
        }
        Err(NoAnswer::Slow(t)) => return failed(Check::Time, format!("came to {t} s of {} s", scene.duration)),
    };
    if let Some(stop) = history.stop() {
        return failed(Check::Finishes, format!("at t = {} s, {}: {}", stop.t, stop.place, stop.reason));
    }
    let (mut complaints, mut figures) = (Vec::new(), Figures::default());
    check::answer(&history, &mut figures, &mut complaints);
    if complaints.is_empty() {
        check::convergence(&history, watch, &mut figures, &mut complaints);
    }
    let outcome = if complaints.is_empty() { Outcome::Passed } else { Outcome::Failed(complaints) };
    Examined { outcome, figures }
}
