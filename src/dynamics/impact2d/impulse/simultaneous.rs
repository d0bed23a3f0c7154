//! Girders that are wedged between others, and slides that friction does not let go on, stopped together.
//!
//! Hits one after another come to an end slowly, or never, where girders are driven in between others. After so many at
//! one instant all points that still come in are stopped by one set of pushes without a bounce and without friction: the
//! velocities nearest to those before, in the metric of the masses, that drive nothing in. Its pushes are the non-negative
//! least-squares answer of Lawson and Hanson (1974, chapter 23), so no energy is added.
//!
//! Where no motion agrees with friction (Painlevé), points that slide are stopped along the face in the same way: the
//! nearest velocities that drive nothing in and slide nowhere of these.

use glam::DVec2;

use crate::dynamics::impact2d::delassus::{Cluster, Point};
use crate::dynamics::impact2d::dense;
use crate::dynamics::impact2d::impulse::collision::Edge;

/// Changes of who is pushed.
const ROUNDS: usize = 500;

/// Stops everybody who is driven in, and these points along the face.
pub(in crate::dynamics::impact2d) fn stop(cluster: &mut Cluster, edges: &[Edge], slides: &[Point]) {
    let normals = edges.iter().flat_map(|edge| edge.points.iter().map(|p| (*p, p.n)));
    let rows: Vec<(Point, DVec2)> = slides.iter().map(|p| (*p, p.s)).chain(normals).collect();
    let speeds: Vec<f64> = rows.iter().map(|(p, direction)| cluster.speed(p, *direction)).collect();
    let pushes = least(cluster, &rows, &speeds, slides.len());
    for (i, ((point, _), push)) in rows.iter().zip(pushes).enumerate() {
        cluster.push(point, if i < slides.len() { [0.0, push] } else { [push, 0.0] });
    }
}

/// The least pushes along these directions after which no rate is below 0; the first few may push either way and bring
/// theirs to 0.
pub(in crate::dynamics::impact2d) fn least(
    cluster: &Cluster,
    rows: &[(Point, DVec2)],
    rates: &[f64],
    either: usize,
) -> Vec<f64> {
    let hush = 1e-13 * rates.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let give = |i: usize, j: usize| cluster.mobility(&rows[i].0, rows[i].1, &rows[j].0, rows[j].1);
    let mut pushes = vec![0.0; rows.len()];
    let mut pushed: Vec<usize> = (0..either).collect();
    balance(&mut pushes, &mut pushed, &give, rates, either);
    for _ in 0..ROUNDS {
        let rate = |i: usize| rates[i] + (0..rows.len()).map(|j| give(i, j) * pushes[j]).sum::<f64>();
        let worst = (0..rows.len()).filter(|i| !pushed.contains(i)).map(|i| (rate(i), i));
        match worst.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((v, i)) if v < -hush => pushed.push(i),
            _ => break,
        }
        balance(&mut pushes, &mut pushed, &give, rates, either);
    }
    pushes
}

/// Solves for the pushes of a set, letting go whoever would have to pull; the first few may push either way.
fn balance(
    pushes: &mut [f64],
    pushed: &mut Vec<usize>,
    give: &impl Fn(usize, usize) -> f64,
    speeds: &[f64],
    either: usize,
) {
    while !pushed.is_empty() {
        let Some(new) = dense::solve(pushed.len(), |r, c| give(pushed[r], pushed[c]), |r| -speeds[pushed[r]]) else {
            return;
        };
        // As far towards the new answer as nobody pulls.
        let limit = |(&i, &to): (&usize, &f64)| {
            if i >= either && to < 0.0 { pushes[i] / (pushes[i] - to).max(f64::MIN_POSITIVE) } else { 1.0 }
        };
        let part = pushed.iter().zip(&new).map(limit).fold(1.0, f64::min);
        for (&i, to) in pushed.iter().zip(&new) {
            pushes[i] += part * (to - pushes[i]);
        }
        if part >= 1.0 {
            return;
        }
        let least = pushed.iter().zip(&new).filter(|(i, to)| **i >= either && **to < 0.0).map(|(&i, _)| i);
        let gone = least.min_by(|a, b| pushes[*a].total_cmp(&pushes[*b]));
        if let Some(gone) = gone {
            pushes[gone] = 0.0;
            pushed.retain(|i| *i != gone);
        }
    }
}
