//! A hundredth of the tolerance makes a smaller error, as long as the case can be trusted.
//!
//! Three runs: at the scene's tolerance, at a hundredth of it, and at a hundredth of that (never below the finest that a
//! scene may ask for), which stands for the truth. Where the finer error is not below the coarser one and not at the
//! rounding floor, the reference is run again from starts that differ by a hair: the case is trusted until their
//! difference has grown a thousandfold, and an error no larger than what starts a finer tolerance apart have come to is
//! what that tolerance promises.

use super::super::watch::{NoAnswer, Watch};
use super::{Check, Complaint, Figures, size};
use crate::scene::Scene;
use crate::sim::History;

pub(super) const CLAIM: &str = "the error at a hundredth of the tolerance is below the error at it, or below the \
                                floor (rounding, or ten times what starts that differ by the finer tolerance come \
                                apart), until the time to which the case can be trusted: starts that differ by a \
                                hair have then come a thousand hairs apart";

/// The finest tolerance that a scene may ask for.
const FINEST: f64 = 1e-13;
/// Instants at which answers are compared.
const COMPARED: usize = 400;
/// Rounding of a place at the end of a run, in parts of what moves and how far.
const FLOOR: f64 = 1e-12;
/// A case is trusted until two starts have come so many times further apart.
const GROWN: f64 = 1e3;
/// A start's relative difference that stands for rounding.
const HAIR: f64 = 1e-12;
/// An error may be so many times what a start's difference of the tolerance has grown to.
const HAIRS: f64 = 10.0;

/// Puts the check.
pub fn convergence(history: &History, watch: &Watch<'_>, figures: &mut Figures, complaints: &mut Vec<Complaint>) {
    match compare(history, watch, figures) {
        Ok(None) => {}
        Ok(Some(detail)) => complaints.push(Complaint::new(Check::Converges, detail)),
        Err(complaint) => complaints.push(complaint),
    }
}

/// What is wrong, if anything; a run at another tolerance may fail as the first one might have.
fn compare(coarse: &History, watch: &Watch<'_>, figures: &mut Figures) -> Result<Option<String>, Complaint> {
    let tolerance = coarse.scene().solver.tolerance;
    let at = |part: f64| (tolerance * part).max(FINEST);
    let finer = run(&with_tolerance(coarse.scene(), at(1e-2)), watch)?;
    let truth =
        if at(1e-4) < at(1e-2) { run(&with_tolerance(coarse.scene(), at(1e-4)), watch)? } else { finer.clone() };
    let (errors, finer_errors) = (errors(coarse, &truth), errors(&finer, &truth));
    let floor = FLOOR * extent(&truth);
    let rises = |last: usize, floor: &dyn Fn(usize) -> f64| finer_errors[last] > errors[last].max(floor(last));
    (figures.error, figures.finer_error, figures.trusted) = (errors[COMPARED], finer_errors[COMPARED], truth.end());
    if !rises(COMPARED, &|_| floor) {
        return Ok(None);
    }
    let trust = trust(&truth, at(1e-2), watch)?;
    let last = trust.until;
    figures.trusted = truth.end() * last as f64 / COMPARED as f64;
    (figures.error, figures.finer_error) = (errors[last], finer_errors[last]);
    let grown = |i: usize| floor.max(trust.floor[i]);
    Ok(rises(last, &grown).then(|| {
        format!(
            "until {} s: error {:e} m at tolerance {:e}, {:e} m at {:e}; floor there {:e} m",
            figures.trusted,
            errors[last],
            tolerance,
            finer_errors[last],
            at(1e-2),
            grown(last)
        )
    }))
}

/// How far a case can be trusted, and what differences of the tolerance have grown to, by the number of the instant.
struct Trust {
    until: usize,
    floor: Vec<f64>,
}

fn trust(truth: &History, finer: f64, watch: &Watch<'_>) -> Result<Trust, Complaint> {
    let extent = extent(truth);
    let (mut until, mut floor) = (COMPARED, vec![0.0; COMPARED + 1]);
    for hair in [HAIR, -HAIR, finer, -finer] {
        let other = run(&nudged(truth, hair), watch)?;
        let apart = errors(&other, truth);
        let limit = GROWN * hair.abs() * extent;
        until = until.min(apart.iter().position(|d| *d > limit).map_or(COMPARED, |i| i.saturating_sub(1)));
        floor.iter_mut().zip(&apart).for_each(|(f, d)| *f = f64::max(*f, HAIRS * d));
    }
    Ok(Trust { until, floor })
}

fn run(scene: &Scene, watch: &Watch<'_>) -> Result<History, Complaint> {
    let tolerance = scene.solver.tolerance;
    let failed = |check: Check, what: String| {
        Err(Complaint { check, detail: format!("at tolerance {tolerance:e}, {what}"), tolerance: Some(tolerance) })
    };
    match watch.run(scene) {
        Ok(history) => match history.stop() {
            None => Ok(history),
            Some(stop) => failed(Check::Finishes, format!("t = {} s, {}: {}", stop.t, stop.place, stop.reason)),
        },
        Err(NoAnswer::Slow(t)) => failed(Check::Time, format!("came to {t} s of {} s", scene.duration)),
        Err(NoAnswer::Refused(errors)) => failed(Check::Finishes, errors.to_string()),
    }
}

fn with_tolerance(scene: &Scene, tolerance: f64) -> Scene {
    let mut scene = scene.clone();
    scene.solver.tolerance = tolerance;
    scene
}

/// The scene of a run, started a part `hair` of its extent further on.
fn nudged(history: &History, hair: f64) -> Scene {
    let (mut scene, d) = (history.scene().clone(), hair * extent(history));
    for (i, girder) in scene.girders.iter_mut().enumerate() {
        // No symmetry survives: each girder by another part.
        let part = 1.0 / (1.0 + i as f64);
        girder.initial.displacement[0] += d * part;
        girder.initial.displacement[1] -= d * part * 0.7;
        girder.initial.rotation_deg += (d / girder.length * part * 0.3).to_degrees();
    }
    scene
}

/// What moves and how far: the largest girder and the largest displacement \[m\].
fn extent(history: &History) -> f64 {
    let bodies = 0..history.model().bodies.len();
    let farthest = |t: f64| bodies.clone().map(|b| history.motion(b, t).displacement.length()).fold(0.0, f64::max);
    (0..=100).map(|i| farthest(history.end() * f64::from(i) / 100.0)).fold(size(history), f64::max)
}

/// Largest difference of any corner so far, at every instant compared \[m\].
fn errors(one: &History, other: &History) -> Vec<f64> {
    let end = one.end().min(other.end());
    let mut largest: f64 = 0.0;
    (0..=COMPARED)
        .map(|i| {
            let t = end * i as f64 / COMPARED as f64;
            for (number, body) in one.model().bodies.iter().enumerate() {
                let (a, b) = (one.motion(number, t), other.motion(number, t));
                let turned = (a.attitude.inverse() * b.attitude).xyz().length() * 2.0 * body.radius;
                largest = largest.max((a.displacement - b.displacement).length() + turned);
            }
            largest
        })
        .collect()
}
