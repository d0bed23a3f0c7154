//! Impulse along a whole face: offset of the paper's rule (44), and the rule with an impulse at each end.
//!
//! **Paper.** An impulse proportional to the approach speed along the face acts at `ζ = b_f² (∂v_n/∂η)/(3 v_n,c)` from its
//! centre (44), `|ζ| ≤ b_f`; the second acts at the corner that the rotation after the first drives in (47), (48).
//!
//! **Two corners.** Every distribution of pressure along the face is an impulse `P_j ≥ 0` at each end. An end that
//! approaches leaves with at least `−e_n v_n`, exactly so where `P_j > 0`; friction is Coulomb's with `ΣP_j`: the face sticks
//! with `|P_s| ≤ μ_s ΣP_j`, or slips with `μ_k ΣP_j`. A parallelogram that comes along its axis turns only if
//! `(L/W) cos a (sin a − μ cos a) > 1`, a = 90° − β, which is (6) for μ = 0. Where slip and restitution together would add
//! energy, the restitution is lowered until they do not. Where no slip is consistent (Painlevé) the face sticks by the least
//! impulses that stop it, outside the friction cone; they add no energy.

use crate::dynamics::impact2d::constants::{CONE_ROUNDING, RESTITUTION_BISECTIONS, SINGULAR_PIVOT, WORK_ROUNDING};
use crate::dynamics::impact2d::delassus::{Cluster, ContactPoint};
use crate::dynamics::impact2d::impulse::corner::Coefficients;
use crate::dynamics::integrator::dense_lu::solve_regularised;

/// Two ends of a face, the lesser along `s` first.
pub type Ends = [ContactPoint; 2];

/// Point of action of the first impulse (44), as a part of the way from the first end to the second \[–\].
pub fn centroid(cluster: &Cluster, ends: &Ends) -> f64 {
    let [v0, v1] = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    let (middle, slope) = (f64::midpoint(v0, v1), 0.5 * (v1 - v0));
    // ζ/b_f, and b_f is half of the way.
    let zeta = if middle < 0.0 { (slope / (3.0 * middle)).clamp(-1.0, 1.0) } else { 0.0 };
    0.5 + 0.5 * zeta
}

/// Impulse along a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceImpulse {
    /// Normal impulse at each end \[N·s\].
    pub normal: [f64; 2],
    /// Tangential impulse \[N·s\].
    pub tangential: f64,
    /// Whether the face sticks.
    pub held: bool,
    /// Work, not positive but for round-off \[J\].
    pub work: f64,
}

/// Applies an impulse with unilateral conditions at both ends.
pub fn two_corner(cluster: &mut Cluster, ends: &Ends, coefficients: &Coefficients) -> FaceImpulse {
    let mut tried = cluster.clone();
    let impulse = apply(&mut tried, ends, coefficients, coefficients.e_n);
    if impulse.work <= work_round_off(cluster, ends, &impulse) {
        *cluster = tried;
        return impulse;
    }
    let (mut low, mut high) = (0.0, coefficients.e_n);
    for _ in 0..RESTITUTION_BISECTIONS {
        let e = f64::midpoint(low, high);
        let impulse = apply(&mut cluster.clone(), ends, coefficients, e);
        if impulse.work <= work_round_off(cluster, ends, &impulse) {
            low = e;
        } else {
            high = e;
        }
    }
    apply(cluster, ends, coefficients, low)
}

/// Work that is round-off \[J\].
fn work_round_off(cluster: &Cluster, ends: &Ends, impulse: &FaceImpulse) -> f64 {
    WORK_ROUNDING * (impulse.normal[0] + impulse.normal[1] + impulse.tangential.abs()) * cluster.speed_round_off(ends)
}

/// Motion of the face along the other.
#[derive(Clone, Copy, PartialEq)]
enum EdgeMode {
    Stick,
    Slip(f64),
    /// Stick outside the friction cone.
    Jam,
}

fn apply(cluster: &mut Cluster, ends: &Ends, coefficients: &Coefficients, e: f64) -> FaceImpulse {
    let asked: [f64; 2] = [0, 1].map(|i| (-e * cluster.speed(&ends[i], ends[i].n)).max(0.0));
    let middle = ends[0].towards(&ends[1], 0.5);
    let v_s = cluster.speed(&middle, middle.s);
    let slip = if v_s < 0.0 { -1.0 } else { 1.0 };
    let modes = [EdgeMode::Stick, EdgeMode::Slip(slip), EdgeMode::Slip(-slip)];
    let guesses = [&[0, 1][..], &[0], &[1]].into_iter().flat_map(|pushed| modes.map(|mode| (pushed, mode)));
    let jams = [&[0, 1][..], &[0], &[1], &[]].into_iter().map(|pushed| (pushed, EdgeMode::Jam));
    for (pushed, mode) in guesses.chain(jams) {
        if let Some((tried, impulse)) = solve_modes(cluster, ends, &middle, coefficients, pushed, mode, asked) {
            *cluster = tried;
            return impulse;
        }
    }
    // Only round-off excludes every combination, at approach speeds of its own size.
    FaceImpulse { normal: [0.0; 2], tangential: 0.0, held: false, work: 0.0 }
}

/// Impulse for one choice of loaded ends and motion along the face; none where it violates a condition.
fn solve_modes(
    cluster: &Cluster,
    ends: &Ends,
    middle: &ContactPoint,
    coefficients: &Coefficients,
    pushed: &[usize],
    mode: EdgeMode,
    asked: [f64; 2],
) -> Option<(Cluster, FaceImpulse)> {
    let speed_noise = cluster.speed_round_off(ends);
    let friction = if let EdgeMode::Slip(sign) = mode { -coefficients.mu_k * sign } else { 0.0 };
    let held = matches!(mode, EdgeMode::Stick | EdgeMode::Jam);
    // Unknowns: normal impulses of the loaded ends, and the tangential impulse where the face sticks.
    let size = pushed.len() + usize::from(held);
    let row = |r: usize| pushed.get(r).map_or((middle, middle.s), |&i| (&ends[i], ends[i].n));
    let entry = |r: usize, c: usize| {
        let (p, d) = row(r);
        match pushed.get(c) {
            Some(&i) => {
                cluster.mobility(p, d, &ends[i], ends[i].n) + friction * cluster.mobility(p, d, &ends[i], ends[i].s)
            }
            None => cluster.mobility(p, d, middle, middle.s),
        }
    };
    let right = |r: usize| {
        let (p, d) = row(r);
        pushed.get(r).map_or(0.0, |&i| asked[i]) - cluster.speed(p, d)
    };
    let solution = solve_regularised(size, entry, right, SINGULAR_PIVOT)?;
    let mut normal = [0.0; 2];
    for (&i, &p) in pushed.iter().zip(&solution) {
        normal[i] = p;
    }
    let total = normal[0] + normal[1];
    let tangential = if held { solution[pushed.len()] } else { friction * total };
    if normal.iter().any(|p| *p < 0.0)
        || (mode == EdgeMode::Stick && tangential.abs() > coefficients.mu_s * total * (1.0 + CONE_ROUNDING))
    {
        return None;
    }
    let mut tried = cluster.clone();
    let mut work = 0.0;
    // The work of the sum, not of one impulse after another.
    let before =
        [cluster.speed(&ends[0], ends[0].n), cluster.speed(&ends[1], ends[1].n), cluster.speed(middle, middle.s)];
    tried.push(&ends[0], [normal[0], 0.0]);
    tried.push(&ends[1], [normal[1], 0.0]);
    tried.push(middle, [0.0, tangential]);
    let after = [tried.speed(&ends[0], ends[0].n), tried.speed(&ends[1], ends[1].n), tried.speed(middle, middle.s)];
    for (i, impulse) in [normal[0], normal[1], tangential].into_iter().enumerate() {
        work += 0.5 * impulse * (before[i] + after[i]);
    }
    let open = |i: usize| pushed.contains(&i) || after[i] >= asked[i] - speed_noise;
    let slides = match mode {
        EdgeMode::Slip(sign) => sign * after[2] >= -speed_noise,
        EdgeMode::Stick | EdgeMode::Jam => true,
    };
    (open(0) && open(1) && slides).then_some((tried, FaceImpulse { normal, tangential, held, work }))
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use super::*;
    use crate::dynamics::impact2d::example::{cluster, touch};

    const FACE_LAW: Coefficients = Coefficients { e_n: 0.4, e_t: -1.0, mu_s: 0.2, mu_k: 0.15 };

    /// A girder of 1 kg, 0.19 × 0.07 m, its face on a wall with normal −x; `lever` is the offset of the face's middle along s.
    fn at_wall(lever: f64, velocity: [f64; 3]) -> (Cluster, Ends) {
        let n = DVec2::NEG_X;
        let i2 = (0.19 * 0.19 + 0.07 * 0.07) / 12.0;
        let girder = cluster([DVec3::new(1.0, 1.0, 1.0 / i2)], [velocity]);
        let end = |along: f64| {
            let arms = [DVec2::new(0.095, 0.0) + n.perp() * along, DVec2::ZERO];
            touch([Some(0), None], n, arms, along)
        };
        (girder, [end(lever - 0.035), end(lever + 0.035)])
    }

    #[test]
    fn the_offset_is_zero_in_translation_a_third_about_a_corner_and_bounded() {
        let (cluster, ends) = at_wall(0.0, [1.0, 0.2, 0.0]);
        assert_eq!(centroid(&cluster, &ends), 0.5, "(49)");
        // One end at rest: |ζ| = b_f/3 (50), (51).
        let (cluster, ends) = at_wall(0.0, [0.035, 0.0, 1.0]);
        let offset = (centroid(&cluster, &ends) - 0.5).abs();
        assert!((offset - 1.0 / 6.0).abs() < 1e-15, "a third of the half length: {offset}");
        let (cluster, ends) = at_wall(0.0, [1e-3, 0.0, 1.0]);
        let part = centroid(&cluster, &ends);
        assert!(part == 0.0 || part == 1.0, "at an end: {part}");
    }

    #[test]
    fn a_centred_face_leaves_with_its_restitution_and_sticks_or_slips_by_the_cone() {
        let (mut cluster, ends) = at_wall(0.0, [1.0, 0.0, 0.0]);
        let impulse = two_corner(&mut cluster, &ends, &FACE_LAW);
        assert!((cluster.velocity[0] - DVec3::new(-0.4, 0.0, 0.0)).length() < 1e-14, "{:?}", cluster.velocity);
        assert!((impulse.normal[0] - 0.7).abs() < 1e-14 && (impulse.normal[1] - 0.7).abs() < 1e-14, "shared");
        assert!(impulse.held, "nothing drives it along");
        let (mut cluster, ends) = at_wall(0.0, [1.0, 2.0, 0.0]);
        let impulse = two_corner(&mut cluster, &ends, &FACE_LAW);
        let total = impulse.normal[0] + impulse.normal[1];
        assert!(!impulse.held, "far outside the cone");
        // s = −y, so the face slips along −s.
        assert!((impulse.tangential - FACE_LAW.mu_k * total).abs() < 1e-14, "{impulse:?}");
    }

    #[test]
    fn beyond_the_rotation_condition_one_end_alone_is_loaded() {
        // The centre of mass lies beside the face: the far end lifts off.
        let (mut cluster, ends) = at_wall(0.06, [1.0, 0.0, 0.0]);
        let impulse = two_corner(&mut cluster, &ends, &Coefficients { mu_s: 0.0, mu_k: 0.0, ..FACE_LAW });
        assert!(impulse.normal[0] > 0.0 && impulse.normal[1] == 0.0, "{impulse:?}");
        let speeds = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
        assert!((speeds[0] - 0.4).abs() < 1e-14, "restitution where it is loaded");
        assert!(speeds[1] > 0.4, "faster where it is not: {speeds:?}");
    }

    #[test]
    fn no_impulse_adds_energy() {
        for k in 0..200 {
            let angle = 0.1 * f64::from(k);
            let (mut cluster, ends) = at_wall(0.05 * (3.0 * angle).sin(), [1.0, 2.0 * angle.cos(), 5.0 * angle.sin()]);
            let before = cluster.kinetic_energy();
            let impulse = two_corner(&mut cluster, &ends, &Coefficients { e_n: 0.9, mu_s: 0.9, mu_k: 0.9, ..FACE_LAW });
            let gained = cluster.kinetic_energy() - before;
            assert!(gained <= 1e-13 * before, "{gained} J");
            assert!((gained - impulse.work).abs() <= 1e-13 * before, "work {} J", impulse.work);
        }
    }
}
