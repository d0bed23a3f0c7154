//! Times at which a check reads an answer, and the length that it measures against.

use crate::sim::History;

/// Looks at even distances over a run.
const EVEN: usize = 500;
/// Events around which it is looked, spread over all of them where there are more.
const EVENTS: usize = 400;

/// Times at which an answer is looked at: even ones, and just before, at and half-way to the next of its events.
pub(super) fn looks(history: &History) -> Vec<f64> {
    let end = history.end();
    let mut times: Vec<f64> = (0..=EVEN).map(|i| end * i as f64 / EVEN as f64).collect();
    let events = history.events();
    let stride = events.len().div_ceil(EVENTS).max(1);
    for (i, event) in events.iter().enumerate().step_by(stride) {
        let next = events.get(i + 1).map_or(end, |e| e.t);
        times.extend([event.t * (1.0 - 1e-12), event.t, f64::midpoint(event.t, next)]);
    }
    times.retain(|t| (0.0..=end).contains(t));
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// Events closer than this part of the contact's radian are one (`docs/physics.md#simultaneous-events`).
const TOGETHER: f64 = 1e-9;

/// Allowed shift of a node of a pair along the normal by events that count as one, at this velocity \[m\].
pub(super) fn early_or_late(history: &History, pair: usize, velocity: f64) -> f64 {
    let model = history.model();
    let pair = &model.pairs[pair];
    let lightest = pair.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
    velocity.abs() * TOGETHER * (lightest / pair.contact.stiffness).sqrt()
}

/// Length of the largest girder \[m\].
pub(super) fn size(history: &History) -> f64 {
    history.model().bodies.iter().map(|body| body.radius).fold(0.0, f64::max)
}
