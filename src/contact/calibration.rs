//! Dashpots and yield of the normal laws from a coefficient of restitution, and the coefficient that comes back
//! (`docs/physics.md#restitution-of-the-other-laws`).
//!
//! A flush free head-on hit of a mass M at speed v₀ returns e'. Three functions of one parameter give it, independent of K,
//! `k_h`, M and v₀: [`viscous`] for a dashpot in both phases, [`approach`] for one in the approach alone, its square where
//! the force is held at 0 or above, and [`relative`] for one proportional to the spring's force. With `y = δ^{5/4}` a Hertz
//! spring with a dashpot `c δ^{1/4} δ̇` has the phase plane of a linear oscillator with the damping ratio `2ξ/√5`, where
//! `c = 2 ξ √(k_h M)`.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::NormalLaw;
use super::constants::{BISECTIONS, LARGEST_RATIO, YIELD_FRACTION};
use super::normal::{Bilinear, Branch};

/// Normal law of a pair in a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NormalName {
    /// Linear spring and dashpot, (54) of the paper.
    #[default]
    KelvinVoigt,
    /// Linear spring, dashpot in the approach alone (Mahmoud and Jankowski).
    Approach,
    /// Hertz's spring without a dashpot.
    Hertz,
    /// Hertz's spring with a dashpot proportional to its force (Muthukumar and `DesRoches`; Hunt and Crossley).
    HertzDamp,
    /// Hertz's spring with a dashpot `c δ^{1/4}` (Tsuji).
    HertzViscous,
    /// That dashpot in the approach alone (Jankowski).
    Jankowski,
    /// Bilinear spring (`DesRoches` and Muthukumar).
    Bilinear,
}

impl NormalName {
    /// All laws, in the order of the documentation.
    pub const ALL: &'static [Self] = &[
        Self::KelvinVoigt,
        Self::Approach,
        Self::Hertz,
        Self::HertzDamp,
        Self::HertzViscous,
        Self::Jankowski,
        Self::Bilinear,
    ];
    /// Names of all laws in files.
    pub const WORDS: &'static [&'static str] = &[
        Self::KelvinVoigt.label(),
        Self::Approach.label(),
        Self::Hertz.label(),
        Self::HertzDamp.label(),
        Self::HertzViscous.label(),
        Self::Jankowski.label(),
        Self::Bilinear.label(),
    ];
    /// Law of a scene without a normal law.
    pub const DEFAULT: Self = Self::KelvinVoigt;

    /// Name in files and tables.
    pub const fn label(self) -> &'static str {
        match self {
            Self::KelvinVoigt => "kelvin-voigt",
            Self::Approach => "approach",
            Self::Hertz => "hertz",
            Self::HertzDamp => "hertz-damp",
            Self::HertzViscous => "hertz-viscous",
            Self::Jankowski => "jankowski",
            Self::Bilinear => "bilinear",
        }
    }

    /// Whether the law has the stiffness `k_h` of a Hertz spring; the bilinear spring is derived from one.
    pub fn is_hertzian(self) -> bool {
        !matches!(self, Self::KelvinVoigt | Self::Approach)
    }
}

/// Relation between the parameter of a normal law and the coefficient of restitution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Calibration {
    /// `published` for `kelvin-voigt`, which is (65), `exact` for the other laws.
    #[default]
    ByLaw,
    /// So that a flush free head-on hit returns e.
    Exact,
    /// By the formula in print.
    Published,
}

impl Calibration {
    /// All calibrations, in the order of the documentation.
    pub const ALL: &'static [Self] = &[Self::ByLaw, Self::Exact, Self::Published];
    /// Their names in files.
    pub const WORDS: &'static [&'static str] = &[Self::ByLaw.label(), Self::Exact.label(), Self::Published.label()];
    /// Calibration of a scene without one.
    pub const DEFAULT: Self = Self::ByLaw;

    /// Name in files and tables.
    pub const fn label(self) -> &'static str {
        match self {
            Self::ByLaw => "by-law",
            Self::Exact => "exact",
            Self::Published => "published",
        }
    }

    /// Whether the parameter of this law is that of the formula in print.
    pub fn is_published(self, law: NormalName) -> bool {
        self == Self::Published || (self == Self::ByLaw && law == NormalName::KelvinVoigt)
    }
}

/// e' of a dashpot with damping ratio ζ in both phases, `exp(−π ζ/√(1−ζ²))`; the inverse is [`damping_ratio`] \[–\].
pub fn viscous(ratio: f64) -> f64 {
    if ratio >= 1.0 { 0.0 } else { (-PI * ratio / ((1.0 - ratio) * (1.0 + ratio)).sqrt()).exp() }
}

/// Damping ratio `ξ = −ln e / √(π² + (ln e)²)` (65) of a coefficient of restitution `0 < e ≤ 1` \[–\].
pub fn damping_ratio(restitution: f64) -> f64 {
    let l = restitution.ln();
    -l / PI.hypot(l)
}

/// e' of a dashpot with damping ratio ζ in the approach alone, `H(ζ) = exp(−ζ arccos ζ/√(1−ζ²))` \[–\].
pub fn approach(ratio: f64) -> f64 {
    let root = ((1.0 - ratio) * (1.0 + ratio)).abs().sqrt();
    let angle = if root == 0.0 {
        1.0
    } else if ratio < 1.0 {
        ratio.acos() / root
    } else {
        ratio.acosh() / root
    };
    (-ratio * angle).exp()
}

/// Damping ratio at which [`approach`] returns e \[–\].
pub fn approach_ratio(restitution: f64) -> f64 {
    bisect([0.0, LARGEST_RATIO], |ratio| approach(ratio) - restitution)
}

/// e' of a dashpot proportional to the spring's force, `N (1 + a δ̇/v₀)`: the root of
/// `a (1 + e') = ln[(1 + a)/(1 − a e')]` \[–\].
pub fn relative(a: f64) -> f64 {
    if a == 0.0 {
        return 1.0;
    }
    bisect([0.0, (1.0 / a).min(1.0)], |e| a * (1.0 + e) - a.ln_1p() + (-a * e).ln_1p())
}

/// Parameter a at which [`relative`] returns e \[–\].
pub fn relative_parameter(restitution: f64) -> f64 {
    let e = restitution;
    // The function is positive below its root and has a double zero at 0.
    if e == 1.0 { 0.0 } else { bisect([0.0, 1.0 / e], |a| a * (1.0 + e) - a.ln_1p() + (-a * e).ln_1p()) }
}

/// The parameter of a law from e: damping ratio ζ of the linear laws, ξ of the viscous Hertz laws, a of `hertz-damp`; 0 for
/// laws without a dashpot \[–\]. `clamp` holds the force of a viscous law at 0 or above.
pub fn parameter(law: NormalName, calibration: Calibration, restitution: f64, clamp: bool) -> f64 {
    let (e, published) = (restitution, calibration.is_published(law));
    let viscous_ratio = || if published || !clamp { damping_ratio(e) } else { approach_ratio(e.sqrt()) };
    let of_hertz = 0.5 * 5f64.sqrt();
    match law {
        NormalName::KelvinVoigt => viscous_ratio(),
        NormalName::HertzViscous => of_hertz * viscous_ratio(),
        // Mahmoud and Jankowski (2011), from memory.
        NormalName::Approach if published => (1.0 - e * e) / (e * (e * (PI - 2.0) + 2.0)),
        NormalName::Approach => approach_ratio(e),
        // Jankowski (2006).
        NormalName::Jankowski if published => 9.0 * of_hertz * (1.0 - e * e) / (e * (e * (9.0 * PI - 16.0) + 16.0)),
        NormalName::Jankowski => of_hertz * approach_ratio(e),
        // Muthukumar and DesRoches (2006).
        NormalName::HertzDamp if published => 0.75 * (1.0 - e * e),
        NormalName::HertzDamp => relative_parameter(e),
        NormalName::Hertz | NormalName::Bilinear => 0.0,
    }
}

/// e' that a flush free head-on hit returns with this parameter of a law, at any speed; that of `bilinear` depends on the
/// speed: [`bilinear_restitution`] \[–\].
pub fn returned(law: NormalName, parameter: f64, clamp: bool) -> f64 {
    let ratio = match law {
        NormalName::HertzViscous | NormalName::Jankowski => 2.0 * parameter / 5f64.sqrt(),
        NormalName::KelvinVoigt
        | NormalName::Approach
        | NormalName::Hertz
        | NormalName::HertzDamp
        | NormalName::Bilinear => parameter,
    };
    match law {
        NormalName::KelvinVoigt | NormalName::HertzViscous if clamp => approach(ratio).powi(2),
        NormalName::KelvinVoigt | NormalName::HertzViscous => viscous(ratio),
        NormalName::Approach | NormalName::Jankowski => approach(ratio),
        NormalName::HertzDamp => relative(parameter),
        NormalName::Hertz | NormalName::Bilinear => 1.0,
    }
}

/// `k_h` with the largest elastic penetration of a linear spring K at the design speed, `(5/4) K/√δ_d`,
/// `δ_d = v_d √(M/K)` \[N/m^{3/2}\].
pub fn hertz_stiffness(stiffness: f64, mass: f64, design_speed: f64) -> f64 {
    1.25 * stiffness / (design_speed * (mass / stiffness).sqrt()).sqrt()
}

/// K with the largest elastic penetration of a Hertz spring at the design speed, the inverse of [`hertz_stiffness`]
/// \[N/m\].
pub fn linear_stiffness(hertz: f64, mass: f64, design_speed: f64) -> f64 {
    (0.8 * hertz).powf(0.8) * (design_speed * design_speed * mass).powf(0.2)
}

/// Relative loss `ΔE/(K_eff δ_m²)` of a bilinear spring by its calibration \[–\].
fn bilinear_loss(restitution: f64, calibration: Calibration) -> f64 {
    let square = restitution * restitution;
    if calibration.is_published(NormalName::Bilinear) { 0.4 * (1.0 - square) } else { (1.0 - square) / (1.0 + square) }
}

/// Smallest e of a bilinear spring with `K₂ > 0` by this calibration; 0 where there is no limit \[–\].
pub fn least_bilinear_restitution(calibration: Calibration) -> f64 {
    if calibration.is_published(NormalName::Bilinear) {
        0.0
    } else {
        // (1 − e²)/(1 + e²) = 1 − δ_y/δ_m.
        (YIELD_FRACTION / (2.0 - YIELD_FRACTION)).sqrt()
    }
}

/// Bilinear spring of `k_h` \[N/m^{3/2}\] that loses `ΔE` at the design speed \[m/s\] of a mass \[kg\]:
/// `K_eff = k_h √δ_m`, `δ_y` a tenth of `δ_m`, `K₁ = K_eff + ΔE/(δ_y δ_m)`, `K₂ = K_eff − ΔE/((δ_m − δ_y) δ_m)`.
///
/// `DesRoches` and Muthukumar, from memory; `ΔE = ⅖ k_h δ_m^{5/2} (1 − e²)` as published, or the loss of `1 − e²` of the
/// impact's energy.
pub fn bilinear(hertz: f64, mass: f64, design_speed: f64, restitution: f64, calibration: Calibration) -> Bilinear {
    let loss = bilinear_loss(restitution, calibration);
    // The energy at δ_m is (K_eff δ_m² + ΔE)/2.
    let deepest = (mass * design_speed * design_speed / (hertz * (1.0 + loss))).powf(0.4);
    let effective = hertz * deepest.sqrt();
    Bilinear {
        k1: effective * (1.0 + loss / YIELD_FRACTION),
        k2: effective * (1.0 - loss / (1.0 - YIELD_FRACTION)),
        yielding: YIELD_FRACTION * deepest,
        branch: Branch::Elastic(0.0),
    }
}

/// e' of a flush free head-on hit of a mass \[kg\] on a bilinear spring at this speed \[m/s\] \[–\].
pub fn bilinear_restitution(law: &Bilinear, mass: f64, speed: f64) -> f64 {
    let lost = law.loop_area(law.depth(mass, speed)) / (0.5 * mass * speed * speed);
    (1.0 - lost).max(0.0).sqrt()
}

/// Root of a function that is positive to its left, by bisection.
fn bisect([mut low, mut high]: [f64; 2], function: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        if function(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative difference from a value given to 13 figures.
    fn agree(what: &str, got: f64, expected: f64) {
        assert!((got - expected).abs() <= 1e-12 * expected.abs(), "{what}: {got} is not {expected}");
    }

    #[test]
    fn formulas_in_print_return_what_they_return() {
        // `docs/physics.md#restitution-of-the-other-laws`, closed forms in 40 digits.
        let check = |law, clamp, e, expected: f64| {
            let parameter = parameter(law, Calibration::Published, e, clamp);
            agree(law.label(), returned(law, parameter, clamp), expected);
        };
        check(NormalName::HertzDamp, false, 0.4, 0.701_634_727_673_5);
        check(NormalName::HertzDamp, false, 0.65, 0.774_819_081_180_0);
        check(NormalName::Jankowski, false, 0.4, 0.392_976_517_310_8);
        check(NormalName::Jankowski, false, 0.65, 0.647_029_026_872_5);
        check(NormalName::Approach, false, 0.4, 0.407_076_199_889_0);
        check(NormalName::Approach, false, 0.65, 0.653_787_390_424_6);
        check(NormalName::KelvinVoigt, true, 0.4, 0.472_013_980_170_6);
        check(NormalName::KelvinVoigt, true, 0.65, 0.674_751_472_505_3);
        // Ye, Li and Zhu (2009), a = 8(1−e)/(5e).
        agree("Ye", relative(2.4), 0.362_872_318_508_3);
    }

    #[test]
    fn exact_parameters_return_the_restitution_asked_for() {
        for law in NormalName::ALL.iter().filter(|law| !matches!(law, NormalName::Hertz | NormalName::Bilinear)) {
            for (e, clamp) in [(0.01, false), (0.4, false), (0.65, true), (0.999, true), (1.0, false)] {
                let parameter = parameter(*law, Calibration::Exact, e, clamp);
                let got = returned(*law, parameter, clamp);
                assert!((got - e).abs() < 2e-13, "{}: {got} is not {e}", law.label());
            }
        }
        let exact = |law, e, clamp| parameter(law, Calibration::Exact, e, clamp);
        agree("a of 0.4", exact(NormalName::HertzDamp, 0.4, false), 2.082_498_164_147_007);
        agree("ξ of jankowski", exact(NormalName::Jankowski, 0.4, false), 0.982_795_063_209_978_9);
        agree("ξ of hertz-viscous", exact(NormalName::HertzViscous, 0.4, false), 0.313_047_273_330_343);
        agree("ξ of approach", exact(NormalName::Approach, 0.4, false), 0.879_038_627_715_486_2);
        agree("ξ of clamp", exact(NormalName::KelvinVoigt, 0.4, true), 0.354_507_715_803_090_65);
    }

    #[test]
    fn kelvin_voigt_keeps_its_dashpot_of_65_unless_exact_is_asked_for() {
        let by = |calibration| parameter(NormalName::KelvinVoigt, calibration, 0.4, true);
        assert_eq!(by(Calibration::ByLaw), damping_ratio(0.4), "(65)");
        assert_eq!(by(Calibration::Published), damping_ratio(0.4), "(65)");
        assert!(by(Calibration::Exact) > damping_ratio(0.4), "held at 0 it needs more");
    }

    #[test]
    fn hertz_stiffness_has_the_depth_of_the_linear_spring_at_the_design_speed() {
        let hertz = hertz_stiffness(1.55e5, 2.0, 0.3);
        assert!((hertz - 5_902_099.264_97).abs() < 1e-4, "{hertz}");
        agree("the inverse", linear_stiffness(hertz, 2.0, 0.3), 1.55e5);
    }

    #[test]
    fn a_bilinear_spring_returns_e_at_its_design_speed() {
        let hertz = hertz_stiffness(1.55e5, 2.0, 0.3);
        let exact = bilinear(hertz, 2.0, 0.3, 0.4, Calibration::Exact);
        agree("K₁", exact.k1, 1_369_446.941_289_926_4);
        agree("K₂", exact.k2, 32_469.453_280_235_353);
        agree("δ_y", exact.yielding, 7.926_429_398_788_921e-5);
        agree("e at 0.3 m/s", bilinear_restitution(&exact, 2.0, 0.3), 0.4);
        agree("e at 0.1 m/s", bilinear_restitution(&exact, 2.0, 0.1), 0.669_335_524_779_5);
        let published = bilinear(hertz, 2.0, 0.3, 0.4, Calibration::Published);
        agree("K₁ as published", published.k1, 762_403.543_619_552_5);
        agree("e as published", bilinear_restitution(&published, 2.0, 0.3), 0.704_986_516_200_1);
        assert_eq!(bilinear_restitution(&exact, 2.0, 1e-4), 1.0, "elastic below yield");
    }

    #[test]
    fn a_bilinear_spring_needs_a_stiffness_after_yield() {
        let least = least_bilinear_restitution(Calibration::Exact);
        assert!((least - 0.2294).abs() < 1e-4, "{least}");
        let k2 = |e| bilinear(1e6, 2.0, 0.3, e, Calibration::Exact).k2;
        assert!(k2(least + 1e-6) > 0.0 && k2(least - 1e-6) < 0.0, "the limit");
        assert_eq!(least_bilinear_restitution(Calibration::Published), 0.0, "no limit");
    }
}
