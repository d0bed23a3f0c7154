//! Girders that are wedged between others, stopped together.
//!
//! Hits one after another come to an end slowly, or never, where girders are driven in between others. After so many at
//! one instant all points that still come in are stopped by one set of pushes without a bounce and without friction: the
//! velocities nearest to those before, in the metric of the masses, that drive nothing in. Its pushes are the non-negative
//! least-squares answer of Lawson and Hanson (1974, chapter 23), so no energy is added.

use glam::DVec2;

use super::blow::Edge;
use super::dense;
use super::point::{Cluster, Point};

/// Changes of who is pushed.
const ROUNDS: usize = 500;

/// Stops everybody who is driven in.
pub(super) fn stop(cluster: &mut Cluster, edges: &[Edge]) {
    let points: Vec<(Point, DVec2)> = edges.iter().flat_map(|edge| edge.points.iter().map(|p| (*p, p.n))).collect();
    let speeds: Vec<f64> = points.iter().map(|(p, n)| cluster.speed(p, *n)).collect();
    let hush = 1e-13 * speeds.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let give = |i: usize, j: usize| cluster.mobility(&points[i].0, points[i].1, &points[j].0, points[j].1);
    let mut pushes = vec![0.0; points.len()];
    let mut pushed: Vec<usize> = Vec::new();
    for _ in 0..ROUNDS {
        let speed = |i: usize| speeds[i] + (0..points.len()).map(|j| give(i, j) * pushes[j]).sum::<f64>();
        let worst = (0..points.len()).filter(|i| !pushed.contains(i)).map(|i| (speed(i), i));
        match worst.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((v, i)) if v < -hush => pushed.push(i),
            _ => break,
        }
        balance(&mut pushes, &mut pushed, &give, &speeds);
    }
    for ((point, _), push) in points.iter().zip(pushes) {
        cluster.push(point, [push, 0.0]);
    }
}

/// Solves for the pushes of a set, letting go whoever would have to pull.
fn balance(pushes: &mut [f64], pushed: &mut Vec<usize>, give: &impl Fn(usize, usize) -> f64, speeds: &[f64]) {
    while !pushed.is_empty() {
        let Some(new) = dense::solve(pushed.len(), |r, c| give(pushed[r], pushed[c]), |r| -speeds[pushed[r]]) else {
            return;
        };
        // As far towards the new answer as nobody pulls.
        let limit = |(&i, &to): (&usize, &f64)| {
            if to < 0.0 { pushes[i] / (pushes[i] - to).max(f64::MIN_POSITIVE) } else { 1.0 }
        };
        let part = pushed.iter().zip(&new).map(limit).fold(1.0, f64::min);
        for (&i, to) in pushed.iter().zip(&new) {
            pushes[i] += part * (to - pushes[i]);
        }
        if part >= 1.0 {
            return;
        }
        let least = pushed.iter().zip(&new).filter(|(_, to)| **to < 0.0).map(|(&i, _)| i);
        let gone = least.min_by(|a, b| pushes[*a].total_cmp(&pushes[*b]));
        if let Some(gone) = gone {
            pushes[gone] = 0.0;
            pushed.retain(|i| *i != gone);
        }
    }
}
