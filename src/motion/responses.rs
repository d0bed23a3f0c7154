//! The impulse response of an undamped oscillator and its integrals, of which a motion under a force that is linear in time is made.

/// ω τ below which the integrals are summed as series, whose terms beyond the last are below rounding.
const SMALL: f64 = 0.5;
/// Terms of these series: 0.5¹⁶/18! of the first is below 1e-20.
const TERMS: i32 = 8;

/// Over τ \[s\]: `C = 1 − ω² S1`, `S0 = sin(ω τ)/ω` \[s\], `S1 = ∫S0` \[s²\], `S2 = ∫S1` \[s³\]; at ω = 0 their limits.
pub fn responses(omega2: f64, tau: f64) -> [f64; 4] {
    let omega = omega2.sqrt();
    if omega * tau > SMALL {
        let (sin, cos) = (0.5 * omega * tau).sin_cos();
        let (less, s0) = (2.0 * sin * sin, 2.0 * sin * cos / omega);
        return [1.0 - less, s0, less / omega2, (tau - s0) / omega2];
    }
    // S1 = τ² Σ x^k/(2k + 2)!, S2 = τ³ Σ x^k/(2k + 3)!, x = −ω² τ².
    let x = -omega2 * tau * tau;
    let (mut s1, mut s2) = (0.0, 0.0);
    for k in (0..TERMS).rev() {
        let n = f64::from(2 * k);
        s1 = (1.0 + x * s1) / ((n + 1.0) * (n + 2.0));
        s2 = (1.0 + x * s2) / ((n + 2.0) * (n + 3.0));
    }
    let (s1, s2) = (tau * tau * s1, tau * tau * tau * s2);
    [1.0 - omega2 * s1, tau - omega2 * s2, s1, s2]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_forms_meet_and_end_in_powers_of_time() {
        let [below, above] = [SMALL * (1.0 - 1e-9), SMALL * (1.0 + 1e-9)].map(|omega| responses(omega * omega, 1.0));
        for (a, b) in below.into_iter().zip(above) {
            assert!((a / b - 1.0).abs() < 1e-8, "{a} and {b}");
        }
        assert_eq!(responses(0.0, 2.0), [1.0, 2.0, 2.0, 8.0 / 6.0], "1, τ, τ²/2, τ³/6");
    }
}
