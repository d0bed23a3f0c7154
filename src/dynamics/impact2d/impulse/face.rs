//! A hit along a whole face: the paper's rule (44)–(48), and the rigid parallelogram's.
//!
//! **Paper.** An impulse proportional to the approach speed along the face acts at `ζ = b_f² (∂v_n/∂η)/(3 v_n,c)` from its
//! centre (44), `|ζ| ≤ b_f`; the second acts at the corner that the rotation after the first drives in.
//!
//! **Two corners.** Every distribution of pushes along the face is an impulse at each end, neither pulling. An end that
//! approaches leaves with at least `−e_n v_n`, exactly so where it is pushed; friction is Coulomb's with the sum of both,
//! the edge at rest with `|P_s| ≤ μ_s ΣP_n`, or sliding with `μ_k ΣP_n`. A parallelogram that comes along its axis turns only if
//! `(L/W) cos a (sin a − μ cos a) > 1`, a = 90° − β, which is (6) for μ = 0. Where slip and restitution together would add
//! energy, the restitution is lowered until they do not. Where friction would drive the face in whichever way it slid, the
//! edge is held, whatever friction that takes: the least pushes that stop it, which add no energy.

use crate::dynamics::impact2d::delassus::{Cluster, Point};
use crate::dynamics::impact2d::impulse::corner::Coefficients;

/// Two ends of a face, the one further back along `s` first.
pub type Ends = [Point; 2];

/// Where the paper's first impulse acts, as a part of the way from the first end to the second (44).
pub fn centroid(cluster: &Cluster, ends: &Ends) -> f64 {
    let [v0, v1] = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    let (middle, slope) = (f64::midpoint(v0, v1), 0.5 * (v1 - v0));
    // ζ/b_f, and b_f is half of the way.
    let zeta = if middle < 0.0 { (slope / (3.0 * middle)).clamp(-1.0, 1.0) } else { 0.0 };
    0.5 + 0.5 * zeta
}

/// What an impulse along a face does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Normal impulse at each end \[N·s\].
    pub normal: [f64; 2],
    /// Tangential impulse \[N·s\].
    pub tangential: f64,
    /// Whether the edge stays put.
    pub held: bool,
    /// Energy that it adds; never above 0 but for rounding \[J\].
    pub work: f64,
}

/// An impulse with unilateral conditions at both ends.
pub fn two_corner(cluster: &mut Cluster, ends: &Ends, numbers: &Coefficients) -> Spread {
    let mut tried = cluster.clone();
    let spread = apply(&mut tried, ends, numbers, numbers.e_n);
    if spread.work <= rounding(cluster, ends, &spread) {
        *cluster = tried;
        return spread;
    }
    let (mut low, mut high) = (0.0, numbers.e_n);
    for _ in 0..BISECTIONS {
        let e = f64::midpoint(low, high);
        let spread = apply(&mut cluster.clone(), ends, numbers, e);
        if spread.work <= rounding(cluster, ends, &spread) {
            low = e;
        } else {
            high = e;
        }
    }
    apply(cluster, ends, numbers, low)
}

/// To the last bit of a restitution.
const BISECTIONS: u32 = 52;

/// Work that is rounding \[J\].
fn rounding(cluster: &Cluster, ends: &Ends, spread: &Spread) -> f64 {
    1e-2 * (spread.normal[0] + spread.normal[1] + spread.tangential.abs()) * cluster.rounding(ends)
}

/// How the edge goes along the face.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Held,
    Slides(f64),
    /// Held by more than friction.
    Jams,
}

fn apply(cluster: &mut Cluster, ends: &Ends, numbers: &Coefficients, e: f64) -> Spread {
    let asked: [f64; 2] = [0, 1].map(|i| (-e * cluster.speed(&ends[i], ends[i].n)).max(0.0));
    let middle = ends[0].towards(&ends[1], 0.5);
    let v_s = cluster.speed(&middle, middle.s);
    let slip = if v_s < 0.0 { -1.0 } else { 1.0 };
    let ways = [Way::Held, Way::Slides(slip), Way::Slides(-slip)];
    let guesses = [&[0, 1][..], &[0], &[1]].into_iter().flat_map(|pushed| ways.map(|way| (pushed, way)));
    let jams = [&[0, 1][..], &[0], &[1], &[]].into_iter().map(|pushed| (pushed, Way::Jams));
    for (pushed, way) in guesses.chain(jams) {
        if let Some((tried, spread)) = attempt(cluster, ends, &middle, numbers, pushed, way, asked) {
            *cluster = tried;
            return spread;
        }
    }
    // Rounding alone has ruled out every guess: nothing to speak of comes in.
    Spread { normal: [0.0; 2], tangential: 0.0, held: false, work: 0.0 }
}

/// One guess of who is pushed and how the edge goes; nothing where it contradicts itself.
fn attempt(
    cluster: &Cluster,
    ends: &Ends,
    middle: &Point,
    numbers: &Coefficients,
    pushed: &[usize],
    way: Way,
    asked: [f64; 2],
) -> Option<(Cluster, Spread)> {
    let hush = cluster.rounding(ends);
    let friction = if let Way::Slides(sign) = way { -numbers.mu_k * sign } else { 0.0 };
    let held = matches!(way, Way::Held | Way::Jams);
    // Unknown: the pushes, and what holds the edge.
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
    let solution = crate::dynamics::impact2d::dense::solve(size, entry, right)?;
    let mut normal = [0.0; 2];
    for (&i, &p) in pushed.iter().zip(&solution) {
        normal[i] = p;
    }
    let total = normal[0] + normal[1];
    let tangential = if held { solution[pushed.len()] } else { friction * total };
    if normal.iter().any(|p| *p < 0.0) || (way == Way::Held && tangential.abs() > numbers.mu_s * total * (1.0 + 1e-12))
    {
        return None;
    }
    let mut tried = cluster.clone();
    let mut work = 0.0;
    // One push, so that the work is that of the sum.
    let before =
        [cluster.speed(&ends[0], ends[0].n), cluster.speed(&ends[1], ends[1].n), cluster.speed(middle, middle.s)];
    tried.push(&ends[0], [normal[0], 0.0]);
    tried.push(&ends[1], [normal[1], 0.0]);
    tried.push(middle, [0.0, tangential]);
    let after = [tried.speed(&ends[0], ends[0].n), tried.speed(&ends[1], ends[1].n), tried.speed(middle, middle.s)];
    for (i, impulse) in [normal[0], normal[1], tangential].into_iter().enumerate() {
        work += 0.5 * impulse * (before[i] + after[i]);
    }
    let open = |i: usize| pushed.contains(&i) || after[i] >= asked[i] - hush;
    let slides = match way {
        Way::Slides(sign) => sign * after[2] >= -hush,
        Way::Held | Way::Jams => true,
    };
    (open(0) && open(1) && slides).then_some((tried, Spread { normal, tangential, held, work }))
}
