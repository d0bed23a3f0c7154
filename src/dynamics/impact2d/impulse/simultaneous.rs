//! Simultaneous plastic impact: least impulses after which no contact of an instant approaches.
//!
//! Sequential impulses converge slowly, or never, where girders are wedged between others. All points that still approach are
//! then stopped by one set of impulses without restitution and friction: the velocities nearest to those before, in the mass
//! metric, with no normal velocity below 0. The impulses are the non-negative least-squares solution of Lawson and Hanson
//! (1974, chapter 23), so no energy is added.
//!
//! Where no motion is consistent with friction (Painlevé), slipping points are stopped along the face in the same way, by
//! additional impulses of either sign.

use glam::DVec2;

use crate::dynamics::impact2d::constants::{ACTIVE_SET_CHANGES, ACTIVE_SET_RESIDUAL, SINGULAR_PIVOT};
use crate::dynamics::impact2d::delassus::{Cluster, ContactPoint};
use crate::dynamics::impact2d::impulse::collision::ContactManifold;
use crate::dynamics::integrator::dense_lu::solve_regularised;

/// Stops all points of the manifolds that approach, and these points along the face.
pub(in crate::dynamics::impact2d) fn stop(
    cluster: &mut Cluster,
    manifolds: &[ContactManifold],
    slips: &[ContactPoint],
) {
    let normals = manifolds.iter().flat_map(|manifold| manifold.points.iter().map(|p| (*p, p.n)));
    let rows: Vec<(ContactPoint, DVec2)> = slips.iter().map(|p| (*p, p.s)).chain(normals).collect();
    let speeds: Vec<f64> = rows.iter().map(|(p, direction)| cluster.speed(p, *direction)).collect();
    let impulses = non_negative_impulses(cluster, &rows, &speeds, slips.len());
    for (i, ((point, _), impulse)) in rows.iter().zip(impulses).enumerate() {
        cluster.push(point, if i < slips.len() { [0.0, impulse] } else { [impulse, 0.0] });
    }
}

/// Least impulses along these directions after which no rate is below 0. The first `free` impulses may have either sign and
/// bring their rates to 0.
pub(in crate::dynamics::impact2d) fn non_negative_impulses(
    cluster: &Cluster,
    rows: &[(ContactPoint, DVec2)],
    rates: &[f64],
    free: usize,
) -> Vec<f64> {
    let residual = ACTIVE_SET_RESIDUAL * rates.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let mobility = |i: usize, j: usize| cluster.mobility(&rows[i].0, rows[i].1, &rows[j].0, rows[j].1);
    let mut impulses = vec![0.0; rows.len()];
    let mut active: Vec<usize> = (0..free).collect();
    solve_active(&mut impulses, &mut active, &mobility, rates, free);
    for _ in 0..ACTIVE_SET_CHANGES {
        let rate = |i: usize| rates[i] + (0..rows.len()).map(|j| mobility(i, j) * impulses[j]).sum::<f64>();
        let worst = (0..rows.len()).filter(|i| !active.contains(i)).map(|i| (rate(i), i));
        match worst.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((v, i)) if v < -residual => active.push(i),
            _ => break,
        }
        solve_active(&mut impulses, &mut active, &mobility, rates, free);
    }
    impulses
}

/// Impulses of the active set that bring its rates to 0.
fn solve_active_set(active: &[usize], mobility: &impl Fn(usize, usize) -> f64, speeds: &[f64]) -> Option<Vec<f64>> {
    let entry = |r: usize, c: usize| mobility(active[r], active[c]);
    solve_regularised(active.len(), entry, |r| -speeds[active[r]], SINGULAR_PIVOT)
}

/// Solves for the impulses of the active set and drops those that would have to pull.
fn solve_active(
    impulses: &mut [f64],
    active: &mut Vec<usize>,
    mobility: &impl Fn(usize, usize) -> f64,
    speeds: &[f64],
    free: usize,
) {
    while !active.is_empty() {
        let Some(new) = solve_active_set(active, mobility, speeds) else {
            return;
        };
        // The part of the way to the solution on which no impulse is negative.
        let limit = |(&i, &to): (&usize, &f64)| {
            if i >= free && to < 0.0 { impulses[i] / (impulses[i] - to).max(f64::MIN_POSITIVE) } else { 1.0 }
        };
        let part = active.iter().zip(&new).map(limit).fold(1.0, f64::min);
        for (&i, to) in active.iter().zip(&new) {
            impulses[i] += part * (to - impulses[i]);
        }
        if part >= 1.0 {
            return;
        }
        let least = active.iter().zip(&new).filter(|(i, to)| **i >= free && **to < 0.0).map(|(&i, _)| i);
        let gone = least.min_by(|a, b| impulses[*a].total_cmp(&impulses[*b]));
        if let Some(gone) = gone {
            impulses[gone] = 0.0;
            active.retain(|i| *i != gone);
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    /// A point of girders that move along x only, the first of them (if any) on the side of the normal.
    fn point(bodies: [Option<usize>; 2]) -> ContactPoint {
        let (n, arms) = (DVec2::X, [DVec2::ZERO; 2]);
        ContactPoint { bodies, n, s: n.perp(), arms, gap: 0.0, inset: 1.0, along: 0.0, bias: [0.0; 2] }
    }

    fn row(velocities: &[f64]) -> Cluster {
        Cluster {
            inverse: velocities.iter().map(|_| DVec3::new(1.0, 1.0, 0.0)).collect(),
            velocity: velocities.iter().map(|&v| DVec3::new(v, 0.0, 0.0)).collect(),
        }
    }

    #[test]
    fn equal_girders_in_a_row_that_close_up_share_their_momentum() {
        // Three girders at −1, 0, 2 m/s from right to left: all close up and go on at 1/3 m/s.
        let mut cluster = row(&[-1.0, 0.0, 2.0]);
        let points = [point([Some(0), Some(1)]), point([Some(1), Some(2)])];
        let manifold = |p: ContactPoint| ContactManifold {
            pair: 0,
            sites: [0].into_iter().collect(),
            points: [p].into_iter().collect(),
        };
        stop(&mut cluster, &points.map(manifold), &[]);
        for v in &cluster.velocity {
            assert!((v.x - 1.0 / 3.0).abs() < 1e-14, "{:?}", cluster.velocity);
        }
    }

    #[test]
    fn a_contact_that_opens_by_itself_takes_no_impulse() {
        let cluster = row(&[3.0, 0.0, 2.0]);
        let rows = [(point([Some(0), Some(1)]), DVec2::X), (point([Some(1), Some(2)]), DVec2::X)];
        let rates: Vec<f64> = rows.iter().map(|(p, d)| cluster.speed(p, *d)).collect();
        let impulses = non_negative_impulses(&cluster, &rows, &rates, 0);
        // The second pair stops at 1 m/s: an impulse of 1 N·s; the first still separates at 2 m/s.
        assert_eq!(impulses[0], 0.0, "it separates");
        assert!((impulses[1] - 1.0).abs() < 1e-15, "{impulses:?}");
    }

    #[test]
    fn an_impulse_that_would_pull_is_dropped_again() {
        // The far point approaches faster and is loaded first; once the near one is loaded too, it would have to pull.
        let at = |lever: f64| ContactPoint { arms: [DVec2::new(0.0, -lever), DVec2::ZERO], ..point([Some(0), None]) };
        let cluster = Cluster {
            inverse: [DVec3::new(1.0, 1.0, 10.0)].into_iter().collect(),
            velocity: [DVec3::new(-0.875, 0.0, -0.25)].into_iter().collect(),
        };
        let rows = [(at(0.1), DVec2::X), (at(0.5), DVec2::X)];
        let rates: Vec<f64> = rows.iter().map(|(p, d)| cluster.speed(p, *d)).collect();
        let impulses = non_negative_impulses(&cluster, &rows, &rates, 0);
        // Stationarity of the quadratic problem: P ≥ 0, rate ≥ 0, P · rate = 0.
        let mut after = cluster.clone();
        for ((p, _), impulse) in rows.iter().zip(&impulses) {
            after.push(p, [*impulse, 0.0]);
        }
        for ((p, d), impulse) in rows.iter().zip(&impulses) {
            let rate = after.speed(p, *d);
            assert!(*impulse >= 0.0 && rate >= -1e-13 && (impulse * rate).abs() < 1e-13, "{impulse} N·s, {rate} m/s");
        }
        // Rates −0.9 and −1 m/s; 1.1 kg⁻¹ at the near point.
        assert!(impulses[1] == 0.0 && (impulses[0] - 0.9 / 1.1).abs() < 1e-15, "{impulses:?}");
    }

    #[test]
    fn a_free_impulse_may_pull() {
        let cluster = row(&[3.0]);
        let impulses = non_negative_impulses(&cluster, &[(point([Some(0), None]), DVec2::X)], &[3.0], 1);
        assert!((impulses[0] + 3.0).abs() < 1e-15, "it stops a point that separates: {impulses:?}");
    }
}
