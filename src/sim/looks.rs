//! Times at which quantities of a body are looked at for their extremes.

use super::History;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::motion::Ground;

/// Looks per period of the fastest motion in free flight \[–\]: a sine rises above the nearest look by at most 1 − cos(π/24) = 0.9 % of
/// its amplitude.
const PER_PERIOD: f64 = 24.0;

/// Fewest and most looks in a stretch of a flight, and looks in a step \[–\]. Chosen: a step is short against every period of its bodies; at
/// most a flight of some thousand of its periods is looked at.
const LEAST_LOOKS: f64 = 4.0;
pub(super) const MOST_LOOKS: f64 = 2e5;

/// Times at which a body's extremes are looked for: every step of an integrator several times, flights at a rate that
/// neither its bearings nor the ground can outrun; none after it has fallen.
pub(super) fn of_body(history: &History, body: usize) -> Vec<f64> {
    let (rate, last) = (flight_rate(history, body), history.seats().sound_until(body));
    let mut times = Vec::new();
    for span in history.trajectories.path(body).spans().take_while(|span| span.from < last) {
        let (from, until) = (span.from, span.until.min(last));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count of looks, clamped")]
        let count =
            if span.flies { ((until - from) * rate).clamp(LEAST_LOOKS, MOST_LOOKS) } else { LEAST_LOOKS } as usize;
        times.extend((0..count).map(|i| from + (until - from) * i as f64 / count as f64));
    }
    times.push(last);
    times
}

/// Looks per second in free flight.
pub(super) fn flight_rate(history: &History, body: usize) -> f64 {
    let model = history.model();
    let together = history.trajectories.free_motion(body).map_or(0.0, BodyMotion::fastest);
    let on_springs = history.trajectories.path(body).fastest_on_springs().unwrap_or(0.0);
    let omega = model.bodies[body].fastest().max(together).max(on_springs);
    let drive = match &model.ground {
        Ground::Still => 0.0,
        Ground::Sine { omega, .. } => *omega,
        Ground::Record { dt, .. } => std::f64::consts::TAU / (8.0 * dt),
    };
    PER_PERIOD * omega.max(drive) / std::f64::consts::TAU
}
