//! Impulses of a hit at one point: restitution (29)–(32), then (34)–(43) where the point approaches again.
//!
//! The first impulse reverses the normal velocity with `e_n` and then the tangential one with `e_t`; neither can add energy,
//! for any `e_n` in \[0, 1\] and `e_t` in \[−1, 1\]. Where the coupling `W_ns` of the tangential impulse makes the point
//! approach again, a second impulse stops it with stick (34)–(40) or, outside the friction cone, with slip (41)–(43).
//!
//! The slipping impulse adds no energy either where `μ_k ≤ μ_s`, although the slip may reverse under it. Its work is
//! `½ P_n' (v_n' − μ_k σ (v_s' + v_s''))`. Let `b = μ_k σ W_ns`, `c = μ_k² W_ss`, `b² ≤ c W_nn`; a positive work needs
//! `2 (W_nn − b) μ_k |v_s'| < (c − W_nn) |v_n'|`, and for no such slip is stick outside the friction cone
//! (`docs/physics.md#hit-at-a-corner`).

use crate::dynamics::impact2d::delassus::{Cluster, ContactPoint};

/// Coefficients of restitution and friction of a hit.
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
    /// Without restitution: `e_n` = 0, `e_t` = −1.
    #[must_use]
    pub fn inelastic(self) -> Self {
        Self { e_n: 0.0, e_t: -1.0, ..self }
    }
}

/// The second impulse, at a point that approaches again after the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecondImpulse {
    /// `[P_n, P_s]` \[N·s\].
    pub impulse: [f64; 2],
    /// Whether the point sticks: `|P_s| ≤ μ_s P_n` (40).
    pub held: bool,
    /// Work, not positive \[J\].
    pub work: f64,
}

/// Applies the first impulse, (29) and (31); returns `[P_n, P_s]` \[N·s\] and the work \[J\].
pub fn first_impulse(cluster: &mut Cluster, point: &ContactPoint, coefficients: &Coefficients) -> ([f64; 2], f64) {
    let [v_n, v_s] = cluster.speeds(point);
    let [w_n, w_s, w_ns] = cluster.mobilities(point);
    // Along a direction without inverse mass there is no impulse.
    let p_n = if w_n > 0.0 { -(1.0 + coefficients.e_n) * v_n / w_n } else { 0.0 };
    let p_s = if w_s > 0.0 { -(1.0 + coefficients.e_t) * (v_s + w_ns * p_n) / w_s } else { 0.0 };
    let work = cluster.push(point, [p_n, 0.0]) + cluster.push(point, [0.0, p_s]);
    ([p_n, p_s], work)
}

/// Applies the second impulse, (34)–(43). Past the Painlevé bound, `W_nn − μ_k σ W_ns ≤ 0`, no slip ends; stick takes at most
/// `W_nn/|W_ns| ≤ μ_k` of the normal impulse there, so the point sticks. `speed_noise` is the speed that rounding makes \[m/s\]: with
/// `e_t = 0` the first impulse leaves no other.
pub fn second_impulse(
    cluster: &mut Cluster,
    point: &ContactPoint,
    coefficients: &Coefficients,
    speed_noise: f64,
) -> SecondImpulse {
    let stay = sticking_impulse(cluster, point);
    if stay[1].abs() <= coefficients.mu_s * stay[0] {
        let work = cluster.push(point, stay);
        return SecondImpulse { impulse: stay, held: true, work };
    }
    let v_s = cluster.speeds(point)[1];
    // From rest the slip starts against the tangential impulse of stick.
    let sign = if v_s.abs() <= speed_noise { -stay[1].signum() } else { v_s.signum() };
    let Some(impulse) = slipping_impulse(cluster, point, coefficients.mu_k, sign) else {
        let work = cluster.push(point, stay);
        return SecondImpulse { impulse: stay, held: true, work };
    };
    let work = cluster.push(point, impulse);
    SecondImpulse { impulse, held: false, work }
}

/// Impulse after which `v_n'' = v_s'' = 0` (34)–(39) \[N·s\].
fn sticking_impulse(cluster: &Cluster, point: &ContactPoint) -> [f64; 2] {
    let [v_n, v_s] = cluster.speeds(point);
    let [w_n, w_s, w_ns] = cluster.mobilities(point);
    let determinant = w_n * w_s - w_ns * w_ns;
    // No independent motion along s: what prevents it carries the tangential load.
    if determinant <= f64::EPSILON * w_n * w_s {
        return [if w_n > 0.0 { -v_n / w_n } else { 0.0 }, 0.0];
    }
    [(w_ns * v_s - w_s * v_n) / determinant, (w_ns * v_n - w_n * v_s) / determinant]
}

/// Impulse after which `v_n'' = 0`, with `P_s = −μ_k σ P_n` (41)–(43) \[N·s\]; none past the Painlevé bound.
fn slipping_impulse(cluster: &Cluster, point: &ContactPoint, mu_k: f64, sign: f64) -> Option<[f64; 2]> {
    let [w_n, _, w_ns] = cluster.mobilities(point);
    let give = w_n - mu_k * sign * w_ns;
    let p_n = -cluster.speeds(point)[0] / give;
    (give > 0.0).then_some([p_n, -mu_k * sign * p_n])
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use super::*;
    use crate::dynamics::impact2d::example::{cluster, touch};

    const CORNER_LAW: Coefficients = Coefficients { e_n: 0.4, e_t: -0.3, mu_s: 0.5, mu_k: 0.4 };

    /// A girder of 1 kg with i² = 0.01 m² at a wall with normal −x, touching at this lever.
    fn at_wall(arm: [f64; 2], velocity: [f64; 3]) -> (Cluster, ContactPoint) {
        let n = DVec2::NEG_X;
        let girder = cluster([DVec3::new(1.0, 1.0, 100.0)], [velocity]);
        (girder, touch([Some(0), None], n, [DVec2::from(arm), DVec2::ZERO], 0.0))
    }

    #[test]
    fn without_coupling_both_velocities_reverse_with_their_restitution() {
        // A lever along n only: W_ns = 0.
        let (mut cluster, point) = at_wall([0.1, 0.0], [1.0, 0.3, 0.0]);
        let before = cluster.speeds(&point);
        first_impulse(&mut cluster, &point, &CORNER_LAW);
        let after = cluster.speeds(&point);
        assert!((after[0] + CORNER_LAW.e_n * before[0]).abs() < 1e-15, "v_n' = −e_n v_n");
        assert!((after[1] + CORNER_LAW.e_t * before[1]).abs() < 1e-15, "v_s' = −e_t v_s");
    }

    #[test]
    fn the_work_of_the_first_impulse_is_the_loss_of_kinetic_energy() {
        let (mut cluster, point) = at_wall([0.1, 0.05], [1.0, 0.3, -2.0]);
        let before = cluster.kinetic_energy();
        let (_, work) = first_impulse(&mut cluster, &point, &CORNER_LAW);
        assert!((cluster.kinetic_energy() - before - work).abs() < 1e-14 && work < 0.0, "{work} J");
    }

    #[test]
    fn inside_the_cone_the_second_impulse_stops_the_point() {
        let (mut cluster, point) = at_wall([0.1, 0.05], [1.0, 0.3, -2.0]);
        let again = second_impulse(&mut cluster, &point, &Coefficients { mu_s: 50.0, ..CORNER_LAW }, 0.0);
        assert!(again.held && again.work < 0.0, "{again:?}");
        let [v_n, v_s] = cluster.speeds(&point);
        assert!(v_n.abs() < 1e-15 && v_s.abs() < 1e-15, "at rest: {v_n}, {v_s}");
    }

    #[test]
    fn outside_the_cone_friction_is_that_of_slip() {
        let (mut cluster, point) = at_wall([0.1, 0.05], [1.0, 3.0, 0.0]);
        let slip = cluster.speeds(&point)[1].signum();
        let again = second_impulse(&mut cluster, &point, &Coefficients { mu_s: 0.02, mu_k: 0.01, ..CORNER_LAW }, 0.0);
        assert!(!again.held && again.work < 0.0, "{again:?}");
        assert!((again.impulse[1] + 0.01 * slip * again.impulse[0]).abs() < 1e-15, "P_s = −μ_k σ P_n");
        assert!(cluster.speeds(&point)[0].abs() < 1e-15, "it no longer approaches");
    }

    #[test]
    fn a_slip_of_rounding_is_none() {
        let impulse = |slip: f64| {
            let (mut cluster, point) = at_wall([0.1, 0.05], [1.0, 0.0, 0.0]);
            let v_s = cluster.speeds(&point)[1];
            cluster.velocity[0] += (point.s * (slip - v_s)).extend(0.0);
            second_impulse(&mut cluster, &point, &Coefficients { mu_s: 0.02, mu_k: 0.01, ..CORNER_LAW }, 1e-15).impulse
        };
        let at_rest = impulse(0.0);
        assert!(at_rest[1] != 0.0, "friction acts: {at_rest:?}");
        for slip in [1e-16, -1e-16] {
            let [p_n, p_s] = impulse(slip);
            assert!((p_n - at_rest[0]).abs() < 1e-14 && (p_s - at_rest[1]).abs() < 1e-14, "{slip:e}: {p_n}, {p_s}");
        }
    }

    #[test]
    fn past_the_painleve_bound_the_point_sticks() {
        // W_nn = 1 + 100 · 0.01 = 2, |W_ns| = 100 · 0.1 · 0.2 = 2: bound at μ_k = 1.
        let (cluster, point) = at_wall([0.2, 0.1], [1.0, 0.0, 0.0]);
        let [w_n, _, w_ns] = cluster.mobilities(&point);
        assert!((w_n.abs() - w_ns.abs()).abs() < 1e-14, "{w_n}, {w_ns}");
        for sign in [1.0, -1.0] {
            let none = slipping_impulse(&cluster, &point, 1.01, sign).is_none();
            assert_eq!(none, sign * w_ns > 0.0, "one direction of slip jams");
        }
        let mut held = cluster;
        let v = point.s * (0.5 * w_ns.signum());
        held.velocity[0] += v.extend(0.0);
        let again = second_impulse(&mut held, &point, &Coefficients { mu_s: 1.02, mu_k: 1.01, ..CORNER_LAW }, 0.0);
        assert!(again.impulse[1].abs() <= 1.02 * again.impulse[0], "{again:?}");
    }

    #[test]
    fn no_second_impulse_adds_energy_though_slips_reverse() {
        let (mut slips, mut reversed) = (0, 0);
        for k in 0..4000 {
            let angle = 0.05 * f64::from(k);
            let arm = [0.2, 0.3 * (0.37 * angle).sin()];
            let (mut cluster, point) = at_wall(arm, [1.0, (1.3 * angle).sin(), 10.0 * angle.cos()]);
            let mu_k = 1.5 + 1.4 * (0.71 * angle).sin();
            let (before, [v_n, slip]) = (cluster.kinetic_energy(), cluster.speeds(&point));
            if v_n >= 0.0 {
                continue;
            }
            let again = second_impulse(&mut cluster, &point, &Coefficients { mu_s: mu_k, mu_k, ..CORNER_LAW }, 0.0);
            let [after_n, after_s] = cluster.speeds(&point);
            assert!(again.work <= 0.0 && cluster.kinetic_energy() <= before, "{again:?}");
            assert!(after_n.abs() < 1e-12, "it no longer approaches: {after_n}");
            slips += usize::from(!again.held);
            reversed += usize::from(!again.held && after_s * slip < 0.0);
        }
        assert!(slips > 100 && reversed > 0, "{slips} slips, {reversed} of them reversed");
    }
}
