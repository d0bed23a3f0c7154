//! Contact law of a pair of facing ends from the parameters of a scene, (64), (65) of the paper, and its division
//! among nodes.

use glam::DVec2;

use super::calibration::{self, Calibration, NormalName, damping_ratio};
use super::constants::{EDGE_TOLERANCE, V_STICK};
use super::normal::{Approach, Hertz, HertzDashpot, LEAST_IMPACT_SPEED, Linear, Normal, NormalLaw, Stage};
use super::{FrictionLaw, Law};
use crate::geometry::Face;

/// Contact parameters of a pair of facing ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairNumbers {
    /// Stiffness `K` of the linear laws and of the tangential spring \[N/m\].
    pub stiffness: f64,
    /// Normal law.
    pub normal: NormalName,
    /// Stiffness `k_h` of a Hertz spring, where that does not follow from K \[N/m^{3/2}\].
    pub hertz_stiffness: Option<f64>,
    /// Impact speed at which a Hertz or bilinear spring stands for K, `v_d` \[m/s\].
    pub design_speed: f64,
    /// Relation between the dashpot and `e_n`.
    pub calibration: Calibration,
    /// Parameter ζ, ξ or a of the normal law in place of that of `e_n` \[–\].
    pub parameter: Option<f64>,
    /// Reduced mass `M₁M₂/(M₁+M₂)` of the bodies \[kg\].
    pub mass: f64,
    /// Coefficient of restitution `e_n` \[–\].
    pub restitution_normal: f64,
    /// Coefficient of restitution `e_t` \[–\].
    pub restitution_tangential: f64,
    /// Coefficient of static friction `μ_s` \[–\].
    pub mu_static: f64,
    /// Coefficient of kinetic friction `μ_k` \[–\].
    pub mu_kinetic: f64,
    /// Friction law.
    pub friction: FrictionLaw,
    /// Whether the normal force is held at 0 or above (`clamp`).
    pub clamp: bool,
    /// Whether sliding has one direction.
    pub one_way: bool,
}

impl PairNumbers {
    /// Parameter ζ, ξ or a in force \[–\]; 0 for laws without one.
    pub fn parameter_in_force(&self) -> f64 {
        let of_restitution =
            || calibration::parameter(self.normal, self.calibration, self.restitution_normal, self.clamp);
        self.parameter.unwrap_or_else(of_restitution)
    }

    /// `k_h` in force \[N/m^{3/2}\].
    pub fn hertz_stiffness_in_force(&self) -> f64 {
        let by_depth = || calibration::hertz_stiffness(self.stiffness, self.mass, self.design_speed);
        self.hertz_stiffness.unwrap_or_else(by_depth)
    }
}

/// Law of a whole pair: its normal law, and K and the dashpot of (65) along the tangents.
pub fn law_of_pair(numbers: &PairNumbers) -> Law {
    let &PairNumbers { stiffness: k, mass, restitution_tangential, .. } = numbers;
    let normal = normal_law(numbers);
    Law {
        normal,
        k_t: k,
        c_t: damping_ratio(restitution_tangential) * critical_damping(k, mass),
        mu_s: numbers.mu_static,
        mu_k: numbers.mu_kinetic,
        friction: numbers.friction.into(),
        clamp: numbers.clamp || normal.excludes_pull(),
        v_stick: if numbers.one_way { 0.0 } else { V_STICK },
    }
}

/// Whether the normal dashpot is that of (65): of the linear law, from `e_n` without the clamp, and not by a parameter given.
pub fn is_damped_by_65(numbers: &PairNumbers) -> bool {
    let &PairNumbers { normal, calibration, restitution_normal: e, clamp, parameter, .. } = numbers;
    normal == NormalName::KelvinVoigt
        && parameter.is_none()
        && calibration::parameter(normal, calibration, e, clamp) == damping_ratio(e)
}

/// Normal law of a whole pair, with its dashpot or its yield from `e_n`, or with the parameter given.
fn normal_law(numbers: &PairNumbers) -> Normal {
    let &PairNumbers { stiffness, normal, design_speed, calibration, restitution_normal: e, mass, .. } = numbers;
    let parameter = numbers.parameter_in_force();
    let linear = || Linear { k: stiffness, c: parameter * critical_damping(stiffness, mass) };
    let k = numbers.hertz_stiffness_in_force();
    let viscous = parameter * critical_damping(k, mass);
    let hertz = |dashpot| Normal::Hertz(Hertz { k, dashpot });
    match normal {
        NormalName::KelvinVoigt => Normal::Linear(linear()),
        NormalName::Approach => Normal::Approach(Approach::of(linear())),
        NormalName::Hertz => hertz(HertzDashpot::Viscous(0.0)),
        NormalName::HertzViscous => hertz(HertzDashpot::Viscous(viscous)),
        NormalName::HertzDamp => hertz(HertzDashpot::Relative(parameter)),
        NormalName::Jankowski => hertz(HertzDashpot::Approach(viscous, Stage::Approach)),
        NormalName::Bilinear => Normal::Bilinear(calibration::bilinear(k, mass, design_speed, e, calibration)),
    }
}

/// Coefficient of restitution that a flush free head-on hit of a pair returns at this impact speed \[m/s\] \[–\].
pub fn returned_restitution(numbers: &PairNumbers, speed: f64) -> f64 {
    let &PairNumbers { normal, clamp, mass, .. } = numbers;
    if let Normal::Bilinear(law) = normal_law(numbers) {
        return calibration::bilinear_restitution(&law, mass, speed);
    }
    let parameter = numbers.parameter_in_force();
    // A slower hit than the least impact speed of `hertz-damp` has a smaller a.
    let slow = if normal == NormalName::HertzDamp { (speed / LEAST_IMPACT_SPEED).min(1.0) } else { 1.0 };
    calibration::returned(normal, parameter * slow, clamp)
}

impl Law {
    /// This law divided by `parts`: that of one of so many nodes that share it.
    #[must_use]
    pub fn shared(&self, parts: f64) -> Self {
        Self { normal: self.normal.divided(parts), k_t: self.k_t / parts, c_t: self.c_t / parts, ..*self }
    }

    /// Dashpots at penetration 0.
    pub fn dashpots(&self) -> Dashpots {
        Dashpots { normal: self.normal.damping_coefficient(0.0), tangential: self.c_t }
    }
}

/// Distance of a projection outside of the face's polygon, edges included; negative inside \[m\]. The projection is
/// from corner a.
#[inline]
pub fn outside(face: &Face, at: DVec2) -> f64 {
    -(face.inset_at(at) + edge_slack(face))
}

/// Distance beyond an edge of a face that counts as inside \[m\]: round-off.
pub fn edge_slack(face: &Face) -> f64 {
    EDGE_TOLERANCE * face.size()
}

/// Whether a projection is inside a face's polygon, edges included to `EDGE_TOLERANCE` of its size.
pub fn is_over(face: &Face, at: DVec2) -> bool {
    face.inset_at(at) >= -edge_slack(face)
}

/// Number of nodes that share the law of a pair: those with projections inside the facing polygon, at least one.
pub fn sharers<'a>(nodes: impl Iterator<Item = (&'a Face, DVec2)>) -> usize {
    nodes.filter(|(face, at)| is_over(face, *at)).count().max(1)
}

/// Dashpots of a pair of facing ends \[N·s/m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dashpots {
    /// Normal dashpot `C_n` \[N·s/m\].
    pub normal: f64,
    /// Tangential dashpot `C_t` \[N·s/m\].
    pub tangential: f64,
}

/// Reduced mass of two bodies, `M₁M₂/(M₁+M₂)`; a fixed body has infinite mass \[kg\].
pub fn reduced_mass(first: f64, second: f64) -> f64 {
    if second.is_infinite() {
        first
    } else if first.is_infinite() {
        second
    } else {
        first * second / (first + second)
    }
}

/// `2 √(K M)` \[N·s/m\], or with the stiffness of a Hertz spring \[N·s/m^{5/4}\].
fn critical_damping(stiffness: f64, mass: f64) -> f64 {
    2.0 * (stiffness * mass).sqrt()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn the_papers_dashpots_come_from_its_restitution() {
        // (69b) prints 220 and 26.4 N·s/m for two 2 kg girders; `docs/physics.md#restitution-and-damping` has one more
        // digit and the wall.
        let [pair, wall] = [2.0, f64::INFINITY]
            .map(|other| law_of_pair(&PairNumbers { mass: reduced_mass(2.0, other), ..numbers() }).dashpots());
        for (got, printed) in
            [(pair.normal, 220.5), (pair.tangential, 26.4), (wall.normal, 311.8), (wall.tangential, 37.3)]
        {
            assert!((got - printed).abs() < 0.05, "{got} is not {printed} to the digits given");
        }
    }

    #[test]
    fn the_body_that_moves_counts_whichever_of_the_two_is_fixed() {
        for (first, second, reduced) in [(2.0, f64::INFINITY, 2.0), (f64::INFINITY, 2.0, 2.0), (3.0, 6.0, 2.0)] {
            assert_eq!(reduced_mass(first, second), reduced, "{first} and {second} kg");
        }
    }

    #[test]
    fn no_dashpot_for_a_perfect_bounce() {
        assert_eq!(damping_ratio(1.0), 0.0, "exactly none");
    }

    fn numbers() -> PairNumbers {
        PairNumbers {
            stiffness: 1.55e5,
            normal: NormalName::KelvinVoigt,
            hertz_stiffness: None,
            design_speed: 0.3,
            calibration: Calibration::ByLaw,
            parameter: None,
            mass: 1.0,
            restitution_normal: 0.4,
            restitution_tangential: 0.9,
            mu_static: 0.2,
            mu_kinetic: 0.15,
            friction: FrictionLaw::Paper,
            clamp: true,
            one_way: false,
        }
    }

    #[test]
    fn a_pairs_law_has_the_scenes_numbers() {
        let law = law_of_pair(&numbers());
        assert_eq!((law.normal.tangent_stiffness(0.0), law.k_t), (1.55e5, 1.55e5), "one K for both directions");
        assert_eq!(
            (law.mu_s, law.mu_k, law.friction, law.clamp),
            (0.2, 0.15, FrictionLaw::Paper.into(), true),
            "as given"
        );
        assert!(law.v_stick > 0.0, "two directions of sliding are regularised");
        assert_eq!(law_of_pair(&PairNumbers { one_way: true, ..numbers() }).v_stick, 0.0, "one is not");
    }

    #[test]
    fn the_dashpot_of_65_is_told_from_every_other() {
        assert!(is_damped_by_65(&numbers()), "by e_n, K and M alone");
        let others = [
            PairNumbers { calibration: Calibration::Exact, ..numbers() },
            PairNumbers { parameter: Some(0.1), ..numbers() },
            PairNumbers { normal: NormalName::Approach, ..numbers() },
            PairNumbers { normal: NormalName::HertzDamp, ..numbers() },
        ];
        for other in others {
            assert!(!is_damped_by_65(&other), "{other:?}");
        }
    }

    #[test]
    fn nodes_share_stiffness_and_dashpots_but_not_friction() {
        let (whole, part) = (law_of_pair(&numbers()), law_of_pair(&numbers()).shared(4.0));
        assert_eq!(4.0 * part.normal.elastic(1e-3), whole.normal.elastic(1e-3), "normal force");
        assert_eq!((4.0 * part.k_t, 4.0 * part.c_t), (whole.k_t, whole.c_t), "tangential spring and dashpot");
        assert_eq!((part.mu_s, part.mu_k), (whole.mu_s, whole.mu_k), "coefficients of friction");
    }

    #[test]
    fn every_normal_law_has_the_force_of_k_at_the_design_speed() {
        let numbers = PairNumbers { mass: 2.0, restitution_normal: 1.0, ..numbers() };
        let depth = 0.3 * (2.0f64 / 1.55e5).sqrt();
        for &normal in NormalName::ALL {
            let law = law_of_pair(&PairNumbers { normal, ..numbers });
            let reached = law.normal.depth(2.0, 0.3);
            // A bilinear spring that loses nothing is linear with its own K_eff.
            let bound = if normal == NormalName::Bilinear { 0.1 } else { 1e-12 };
            assert!((reached / depth - 1.0).abs() < bound, "{}: {reached} against {depth}", normal.label());
            assert_eq!(law.k_t, 1.55e5, "the tangential spring is K");
        }
    }

    #[test]
    fn a_given_parameter_takes_the_place_of_restitution() {
        let numbers = PairNumbers { normal: NormalName::HertzDamp, parameter: Some(2.4), mass: 2.0, ..numbers() };
        assert!((returned_restitution(&numbers, 0.3) - 0.362_872_318_508_3).abs() < 1e-12, "Ye");
        assert!(returned_restitution(&numbers, 1e-5) > 0.95, "below the least impact speed it rebounds with more");
        let Normal::Hertz(law) = law_of_pair(&numbers).normal else { panic!("a Hertz spring") };
        assert_eq!(law.dashpot, HertzDashpot::Relative(2.4), "as given");
        assert!(law_of_pair(&PairNumbers { clamp: false, ..numbers }).clamp, "it never pulls");
    }

    #[test]
    fn sharers_are_the_nodes_over_their_faces() {
        let corners = [[0.0, 0.0], [0.2, 0.0], [0.2, 0.1], [0.0, 0.1]].map(|[y, z]| DVec3::new(0.0, y, z));
        let face = Face::new(corners, 1.0).expect("a rectangle");
        let [inside, edge, far] = [DVec2::new(0.1, 0.05), DVec2::ZERO, DVec2::new(-0.1, 0.05)];
        assert_eq!(sharers([inside, edge, far].into_iter().map(|at| (&face, at))), 2, "edges count");
        assert_eq!(sharers([far].into_iter().map(|at| (&face, at))), 1, "at least one");
        assert!(outside(&face, far) > 0.0 && outside(&face, inside) < 0.0, "the sign of the distance");
    }
}
