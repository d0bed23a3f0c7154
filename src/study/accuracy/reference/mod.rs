//! Answers to measure errors against, computed by other methods than the ones that are measured.

mod bar;
mod block;
mod bouncer;
mod closed_form;
pub mod second;
mod st_venant;
pub mod wide;

use super::line::Line;
use super::problem::Source;
use super::{Answer, Instants};
use crate::scene::{FINEST_TOLERANCE, Scene, SceneErrors};
use crate::sim::History;

/// Change of the initial state that shows how far the answer can be trusted \[m\].
const NUDGE: f64 = 1e-12;
/// The comparison ends where the nudge has grown to this \[m\].
const TRUSTED: f64 = 1e-8;

/// An answer with what is known of its own error.
#[derive(Clone, Debug)]
pub struct Reference {
    /// The answer at the instants.
    pub answer: Answer,
    /// Method that computed it.
    pub what: &'static str,
    /// Instant number up to which a comparison means anything.
    pub last: usize,
    /// Whether it is a closed form, or computed in more digits than any answer: its own error is rounding.
    pub exact: bool,
    /// Its largest difference from the event-driven solver at its tightest.
    pub agreement: super::Errors,
    /// By how much a change of the initial displacement grows within the comparison, at the most.
    pub growth: f64,
}

impl Reference {
    /// Uncertainty of the reference itself: no error below this is quoted \[m\].
    pub fn known_to(&self) -> f64 {
        if self.exact { 0.0 } else { self.agreement.displacement }
    }
}

/// Whether a source errs by rounding alone.
fn is_exact(source: Source) -> bool {
    !matches!(source, Source::Bar | Source::Second)
}

/// Name of a source in tables and page.
pub fn describe(source: Source) -> &'static str {
    match source {
        Source::FreeDecay | Source::HarmonicResponse => "closed form",
        Source::Bouncer { .. } | Source::Rigid { .. } => "Taylor series in 32 digits, events as roots",
        Source::Block => "closed form between roots",
        Source::StVenant => "closed form of the force, integrated",
        Source::Bar => "spectral elements, exponential of their matrix, touches by halving",
        Source::Second => "second formulation: own forces and laws, extrapolation, own event search",
    }
}

/// The reference of a problem, and how far it reaches.
///
/// # Errors
///
/// Those of the scene's validation.
pub fn of(source: Source, scene: &Scene) -> Result<Reference, SceneErrors> {
    let instants = Instants { until: scene.duration };
    let answer = match source {
        Source::FreeDecay => closed_form::free_decay(instants),
        Source::HarmonicResponse => closed_form::harmonic_response(instants),
        Source::Bouncer { restitution } => bouncer::answer(restitution, false, instants),
        Source::Rigid { restitution } => bouncer::answer(restitution, true, instants),
        Source::Block => block::answer(instants),
        Source::StVenant => Line::of(scene).map(|line| st_venant::answer(&line, instants)).unwrap_or_default(),
        Source::Bar => Line::of(scene).map(|line| bar::answer(&line, instants)).unwrap_or_default(),
        Source::Second => second::answer(scene, instants)?,
    };
    let tight = tightest(scene, instants)?;
    let mut nudged = scene.clone();
    nudged.girders[0].initial.displacement[0] += NUDGE;
    nudged.girders[0].initial.displacement[1] += NUDGE;
    let nudged = tightest(&nudged, instants)?;
    let arm = scene.girders.iter().map(|g| g.length / 2.0).fold(0.0, f64::max);
    let last = tight.together_until(&nudged, TRUSTED, arm);
    let growth = tight.errors(&nudged, last).displacement / NUDGE;
    let agreement = tight.errors(&answer, last);
    Ok(Reference { answer, what: describe(source), last, exact: is_exact(source), agreement, growth })
}

fn tightest(scene: &Scene, instants: Instants) -> Result<Answer, SceneErrors> {
    let mut scene = scene.clone();
    scene.solver.tolerance = FINEST_TOLERANCE;
    Ok(Answer::of(&History::of(&scene)?, instants))
}
