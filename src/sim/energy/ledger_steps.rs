//! Common parts of the accounts of contacts and devices: the steps that they are integrated over, and the power of bodies with a given
//! motion.

use glam::DVec3;

use crate::sim::History;

/// Times in a stretch at which the steps of any of these bodies begin, with its ends.
pub(in crate::sim) fn step_borders(
    history: &History,
    bodies: impl Iterator<Item = usize>,
    from: f64,
    until: f64,
) -> Vec<f64> {
    let mut borders = vec![from, until];
    for body in bodies {
        let begins = history.trajectories.path(body).spans_after(from).map(|span| span.from);
        borders.extend(begins.take_while(|t| *t < until).filter(|t| *t > from));
    }
    borders.sort_by(f64::total_cmp);
    borders
}

/// Power of what moves as given against the forces on it \[W\].
pub(in crate::sim) fn given_power(history: &History, pushed: [(Option<usize>, DVec3); 2], t: f64) -> f64 {
    if history.model().moving.is_none() {
        return 0.0;
    }
    let pushed = pushed.into_iter().filter_map(|(body, force)| Some((body?, force)));
    let given = |body: usize| history.model().bodies[body].given_velocity(&history.state(body, t));
    pushed.map(|(body, force)| -force.dot(given(body))).sum()
}
