//! Contact numbers from restitution: paper equations (64), (65).

use std::f64::consts::PI;

/// Dashpots of a pair of facing ends \[N·s/m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dashpots {
    /// `C_n`.
    pub normal: f64,
    /// `C_t`.
    pub tangential: f64,
}

/// `ξ = −ln e / √(π² + (ln e)²)` (65), for a coefficient of restitution `0 < e ≤ 1`; 0 for e = 1.
pub fn damping_ratio(restitution: f64) -> f64 {
    let l = restitution.ln();
    -l / PI.hypot(l)
}

/// Mass that a pair of bodies moves with against each other, `M₁M₂/(M₁+M₂)`; a fixed body has infinite mass \[kg\].
pub fn reduced_mass(first: f64, second: f64) -> f64 {
    if second.is_infinite() { first } else { first * second / (first + second) }
}

/// `C_i = 2 ξ_i √(K M)` (65), `M` the reduced mass.
pub fn dashpots(stiffness: f64, mass: f64, restitution_normal: f64, restitution_tangential: f64) -> Dashpots {
    let critical = 2.0 * (stiffness * mass).sqrt();
    Dashpots {
        normal: damping_ratio(restitution_normal) * critical,
        tangential: damping_ratio(restitution_tangential) * critical,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_dashpots_come_from_its_restitution() {
        // (69b) prints 220 and 26.4 N·s/m for two 2 kg girders; `docs/physics.md#restitution-and-damping` has one more
        // digit and the wall.
        let pair = dashpots(1.55e5, reduced_mass(2.0, 2.0), 0.4, 0.9);
        let wall = dashpots(1.55e5, reduced_mass(2.0, f64::INFINITY), 0.4, 0.9);
        for (got, printed) in
            [(pair.normal, 220.5), (pair.tangential, 26.4), (wall.normal, 311.8), (wall.tangential, 37.3)]
        {
            assert!((got - printed).abs() < 0.05, "{got} is not {printed} to the digits given");
        }
    }

    #[test]
    fn no_dashpot_for_a_perfect_bounce() {
        assert_eq!(damping_ratio(1.0), 0.0, "exactly none");
    }
}
