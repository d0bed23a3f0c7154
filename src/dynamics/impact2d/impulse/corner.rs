//! A hit at one point: the paper's two impulses (26)–(43).
//!
//! The first sends the point back with `e_n` along the normal and `e_t` along the tangent, one after the other (29), (31);
//! neither can add energy, for any `e_n` in \[0, 1\] and `e_t` in \[−1, 1\]. Where the coupling of the second has pushed the
//! point in again, another impulse holds it (34)–(40) or, where friction cannot, lets it slide (41)–(43). A sliding impulse
//! that turns the slip round can add energy, `ΔE = ½ P_n' (v_n' − μ_k σ (v_s' + v_s''))`; there, and only there, the program
//! departs from the paper: it ends the slide where the point stops, and holds it or slides it back from there.

use crate::dynamics::impact2d::delassus::{Cluster, Point};

/// Coefficients in force at a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// `e_n`.
    pub e_n: f64,
    /// `e_t`.
    pub e_t: f64,
    /// `μ_s`.
    pub mu_s: f64,
    /// `μ_k`.
    pub mu_k: f64,
}

impl Coefficients {
    /// The same without any bounce.
    #[must_use]
    pub fn dead(self) -> Self {
        Self { e_n: 0.0, e_t: -1.0, ..self }
    }
}

/// The second impulse, which holds a point that was pushed in again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Second {
    /// `[P_n, P_s]` \[N·s\].
    pub impulse: [f64; 2],
    /// Whether the point stays put: `|P_s| ≤ μ_s P_n` (40).
    pub held: bool,
    /// Energy that it adds; negative \[J\].
    pub work: f64,
}

/// The first impulse, (29) and (31): its `[P_n, P_s]` \[N·s\] and the energy that it adds \[J\].
pub fn first(cluster: &mut Cluster, point: &Point, numbers: &Coefficients) -> ([f64; 2], f64) {
    let [v_n, v_s] = cluster.speeds(point);
    let [w_n, w_s, w_ns] = cluster.mobilities(point);
    // A side that cannot give way along a direction takes no impulse along it.
    let p_n = if w_n > 0.0 { -(1.0 + numbers.e_n) * v_n / w_n } else { 0.0 };
    let p_s = if w_s > 0.0 { -(1.0 + numbers.e_t) * (v_s + w_ns * p_n) / w_s } else { 0.0 };
    let work = cluster.push(point, [p_n, 0.0]) + cluster.push(point, [0.0, p_s]);
    ([p_n, p_s], work)
}

/// The second impulse, (34)–(43). Past the Painlevé bound, `w_n − μ_k σ w_ns ≤ 0`, no slide ends: but there staying put takes
/// `w_n/|w_ns| ≤ μ_k` of the push at most, so the point is held.
pub fn second(cluster: &mut Cluster, point: &Point, numbers: &Coefficients) -> Second {
    let stay = staying(cluster, point);
    if stay[1].abs() <= numbers.mu_s * stay[0] {
        let work = cluster.push(point, stay);
        return Second { impulse: stay, held: true, work };
    }
    let v_s = cluster.speeds(point)[1];
    // Without a slip to go by, against the way that holding it would push.
    let sign = if v_s == 0.0 { -stay[1].signum() } else { v_s.signum() };
    let Some(impulse) = sliding(cluster, point, numbers.mu_k, sign) else {
        let work = cluster.push(point, stay);
        return Second { impulse: stay, held: true, work };
    };
    let mut tried = cluster.clone();
    let work = tried.push(point, impulse);
    if work <= 0.0 {
        *cluster = tried;
        return Second { impulse, held: false, work };
    }
    in_two(cluster, point, numbers, sign)
}

/// The impulse after which the point stays put: `v_n'' = v_s'' = 0`.
fn staying(cluster: &Cluster, point: &Point) -> [f64; 2] {
    let [v_n, v_s] = cluster.speeds(point);
    let [w_n, w_s, w_ns] = cluster.mobilities(point);
    let determinant = w_n * w_s - w_ns * w_ns;
    // What cannot move along s is held along it by what holds it.
    if determinant <= f64::EPSILON * w_n * w_s {
        return [if w_n > 0.0 { -v_n / w_n } else { 0.0 }, 0.0];
    }
    [(w_ns * v_s - w_s * v_n) / determinant, (w_ns * v_n - w_n * v_s) / determinant]
}

/// The impulse after which the point slides along the face: `v_n'' = 0`, `P_s = −μ_k σ P_n`; nothing where friction would
/// drive it in.
fn sliding(cluster: &Cluster, point: &Point, mu_k: f64, sign: f64) -> Option<[f64; 2]> {
    let [w_n, _, w_ns] = cluster.mobilities(point);
    let give = w_n - mu_k * sign * w_ns;
    let p_n = -cluster.speeds(point)[0] / give;
    (give > 0.0).then_some([p_n, -mu_k * sign * p_n])
}

/// The slide ends where the point stops; from there it is held, or slides the other way.
fn in_two(cluster: &mut Cluster, point: &Point, numbers: &Coefficients, sign: f64) -> Second {
    let [_, w_s, w_ns] = cluster.mobilities(point);
    let p_n = cluster.speeds(point)[1] / (numbers.mu_k * sign * w_s - w_ns);
    let first = [p_n, -numbers.mu_k * sign * p_n];
    let mut work = cluster.push(point, first);
    let stay = staying(cluster, point);
    let back =
        if stay[1].abs() <= numbers.mu_s * stay[0] { None } else { sliding(cluster, point, numbers.mu_k, -sign) };
    let rest = back.unwrap_or(stay);
    work += cluster.push(point, rest);
    Second { impulse: [first[0] + rest[0], first[1] + rest[1]], held: back.is_none(), work }
}
