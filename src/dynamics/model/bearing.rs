//! Bearings: Voigt elements under a girder (paper equations (1)–(5)).
//!
//! A planar girder sees them linear at every rotation, through one stiffness and one dashpot matrix over `(x, y, θ)`; a
//! spatial one sees each at its true attachment point. The printed (2c,d) pair `k_x` with `l_x²`; a spring along x has
//! the lever `l_y`, as here.

use glam::{DMat3, DVec2, DVec3};
use nalgebra::{Matrix2, SymmetricEigen};

use crate::dynamics::connection::{Connection, Separation};

/// Eccentricity below this part of the matrix is rounding of the bearings' places.
const DECOUPLED: f64 = 1e-14;
/// Part of a weight, or of its moment, below which the difference from the sum over the bearings is rounding of [`carry`] \[–\].
const CARRIED: f64 = 1e-12;
/// Part of the mean square of the bearings' distances from G below which their spread across a line is its rounding: bearings within 1e-7
/// of their distance from one line stand on it.
const ON_A_LINE: f64 = 1e-14;

/// One bearing of a girder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearing {
    /// Attachment point in the body frame \[m\].
    pub place: DVec3,
    /// `k_x, k_y, k_z` along the girder's axes as placed \[N/m\].
    pub stiffness: DVec3,
    /// `c_x, c_y, c_z` along the girder's axes as placed \[N·s/m\].
    pub damping: DVec3,
    /// Force at rest, which carries the girder's weight (spatial) \[N\].
    pub preload: DVec3,
}

/// A Voigt element between a point of a girder and the ground, in the girder's axes as placed; the preload, which is constant,
/// is apart.
impl Connection for Bearing {
    type State = ();
    type Motion = Separation;

    #[inline]
    fn force(&self, (): &(), motion: &Separation) -> DVec3 {
        -self.stiffness * motion.moved - self.damping * motion.rate
    }

    #[inline]
    fn stored_energy(&self, (): &(), motion: &Separation) -> f64 {
        0.5 * motion.moved.dot(self.stiffness * motion.moved)
    }

    #[inline]
    fn dissipated_power(&self, (): &(), motion: &Separation) -> f64 {
        motion.rate.dot(self.damping * motion.rate)
    }

    fn stiffness_bound(&self, (): &()) -> f64 {
        self.stiffness.max_element()
    }

    fn damping_bound(&self, (): &()) -> f64 {
        self.damping.max_element()
    }
}

/// Part of a girder's weight that its bearings do not carry. Adding up their preloads against the weight in every evaluation would add
/// their rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UnbalancedWeight {
    /// Force, upwards: 0 where they carry it all \[N\].
    pub force: f64,
    /// `Σ f l` of the preloads, at `l` from G in the body frame: upright where they leave no moment \[N·m\].
    pub first_moment: DVec3,
}

/// Stiffness and dashpots of a planar girder over `(x, y, θ)`, world axes: symmetric matrices, N/m, N and N·m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarBearings {
    /// The right-hand sides of (1) gathered.
    pub stiffness: DMat3,
    /// The dashpots gathered in the same way.
    pub damping: DMat3,
}

impl PlanarBearings {
    /// Stiffness and dashpots of a girder's bearings, whose axes as placed are the columns of `axes`.
    pub fn gather(bearings: &[Bearing], axes: DMat3) -> Self {
        let sum = |of: fn(&Bearing) -> DVec3| {
            bearings.iter().fold(DMat3::ZERO, |sum, b| sum + element(axes * b.place, axes, of(b)))
        };
        Self { stiffness: sum(|b| b.stiffness), damping: sum(|b| b.damping) }
    }
}

/// One Voigt element's matrix over `(x, y, θ)`: `Bᵀ K B` with `B = [1, ẑ × l]`.
fn element(lever: DVec3, axes: DMat3, diagonal: DVec3) -> DMat3 {
    let (u, v) = (axes.x_axis, axes.y_axis);
    let along = |a: DVec3| DVec3::new(a.x, a.y, lever.x * a.y - lever.y * a.x);
    let outer = |a: DVec3, k: f64| DMat3::from_cols(a * (a.x * k), a * (a.y * k), a * (a.z * k));
    outer(along(u), diagonal.x) + outer(along(v), diagonal.y)
}

/// Frequencies, damping ratios and eccentricities (3), (4) of a planar girder on its bearings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingQuantities {
    /// `ω_x, ω_y, ω_θ` \[rad/s\].
    pub omega: [f64; 3],
    /// `h_x, h_y, h_θ`, of critical; 0 where there is no stiffness.
    pub damping_ratio: [f64; 3],
    /// `ε_x, ε_y`: eccentricities of the stiffness \[m\].
    pub stiffness_eccentricity: [f64; 2],
    /// `η_x, η_y`: eccentricities of the dashpots \[m\].
    pub damping_eccentricity: [f64; 2],
    /// `i`, radius of gyration about the vertical (4e) \[m\].
    pub gyration: f64,
}

impl BearingQuantities {
    /// From a girder's bearings, mass and `i²`, in its own axes.
    pub fn of(bearings: &[Bearing], mass: f64, gyration2: f64) -> Self {
        let PlanarBearings { stiffness: k, damping: c } = PlanarBearings::gather(bearings, DMat3::IDENTITY);
        let inertia = [mass, mass, mass * gyration2];
        let omega: [f64; 3] = std::array::from_fn(|i| (k.col(i)[i] / inertia[i]).sqrt());
        let damping_ratio = std::array::from_fn(|i| ratio(c.col(i)[i], 2.0 * inertia[i] * omega[i]));
        Self {
            omega,
            damping_ratio,
            stiffness_eccentricity: eccentricity(k),
            damping_eccentricity: eccentricity(c),
            gyration: gyration2.sqrt(),
        }
    }
}

/// `ε_x = Σ k_y l_x / k_y`, `ε_y = Σ k_x l_y / k_x`.
fn eccentricity(m: DMat3) -> [f64; 2] {
    [ratio(m.z_axis.y, m.y_axis.y), ratio(-m.z_axis.x, m.x_axis.x)]
}

fn ratio(part: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { part / whole }
}

/// Vertical forces that carry a weight on the bearings, shared by vertical stiffness as by a rigid girder (`docs/physics.md#weight`):
/// `f = k (W/Σk + μ·(l − c))` about the centroid `c` of the stiffness, so that `Σ f = W` whatever `μ`, with `S μ = -W c`,
/// `S = Σ k (l − c)(l − c)ᵀ`, for no moment about G. Across a line or a point on which all bearings stand, `S` has no stiffness and a
/// moment `W c` is left.
pub fn carry(weight: f64, bearings: &mut [Bearing], axes: DMat3) -> UnbalancedWeight {
    let levers: Vec<DVec2> = bearings.iter().map(|b| (axes * b.place).truncate()).collect();
    let shares: Vec<f64> = bearings.iter().map(|b| b.stiffness.z).collect();
    let whole: f64 = shares.iter().sum();
    if whole == 0.0 {
        return UnbalancedWeight { force: -weight, first_moment: DVec3::ZERO };
    }
    let parts = || levers.iter().zip(shares.iter().map(|k| k / whole));
    let centre: DVec2 = parts().map(|(l, part)| *l * part).sum();
    // S/Σk and the mean square of the distances from G.
    let mut spread = Matrix2::zeros();
    for (arm, part) in parts().map(|(l, part)| (*l - centre, part)) {
        spread += part * Matrix2::new(arm.x * arm.x, arm.x * arm.y, arm.x * arm.y, arm.y * arm.y);
    }
    let reach2: f64 = parts().map(|(l, part)| l.length_squared() * part).sum();
    let SymmetricEigen { eigenvalues, eigenvectors } = spread.symmetric_eigen();
    let principal = eigenvectors.column_iter().map(|axis| DVec2::new(axis[0], axis[1])).zip(&eigenvalues);
    let held = principal.filter(|(_, spread)| **spread > ON_A_LINE * reach2);
    let slope: DVec2 = held.map(|(axis, spread)| axis * (-axis.dot(centre) * weight / (spread * whole))).sum();
    for ((bearing, l), k) in bearings.iter_mut().zip(&levers).zip(&shares) {
        bearing.preload = DVec3::Z * (k * (weight / whole + slope.dot(*l - centre)));
    }
    let forces: f64 = bearings.iter().map(|b| b.preload.z).sum();
    let moment: DVec3 = bearings.iter().map(|b| b.place * b.preload.z).sum();
    let size: f64 = bearings.iter().map(|b| b.place.length() * b.preload.z.abs()).sum();
    let unless_rounding = |part: f64, whole: f64| if part.abs() > CARRIED * whole { part } else { 0.0 };
    UnbalancedWeight {
        force: unless_rounding(forces - weight, weight),
        first_moment: DVec3::new(unless_rounding(moment.x, size), unless_rounding(moment.y, size), moment.z),
    }
}

/// Whether the off-diagonal entries are round-off, relative to the geometric mean of the diagonal it couples.
pub(in crate::dynamics) fn is_diagonal(m: &DMat3) -> bool {
    (0..3).all(|i| (0..i).all(|j| m.col(i)[j].abs() <= DECOUPLED * (m.col(i)[i] * m.col(j)[j]).sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn legs(ecc: f64) -> Vec<Bearing> {
        [(0.07, 0.025), (0.07, -0.025), (-0.07, 0.025), (-0.07, -0.025)]
            .map(|(x, y)| Bearing {
                place: DVec3::new(x + ecc, y, 0.0),
                stiffness: DVec3::new(100.0, 200.0, 400.0),
                damping: DVec3::new(1.0, 2.0, 4.0),
                preload: DVec3::ZERO,
            })
            .to_vec()
    }

    #[test]
    fn the_matrix_is_that_of_the_settled_equations() {
        let m = PlanarBearings::gather(&legs(0.01), DMat3::IDENTITY).stiffness;
        let k_theta: f64 = legs(0.01).iter().map(|b| 100.0 * b.place.y.powi(2) + 200.0 * b.place.x.powi(2)).sum();
        assert_eq!(m.x_axis.x, 400.0, "k_x");
        assert!((m.z_axis.y - 800.0 * 0.01).abs() < 1e-12, "k_y ε_x, got {}", m.z_axis.y);
        assert!((m.z_axis.z - k_theta).abs() < 1e-12, "k_θ = Σ(k_x l_y² + k_y l_x²)");
    }

    #[test]
    fn the_weight_is_carried_without_a_moment() {
        let mut bearings = legs(0.013);
        let unbalanced = carry(50.0, &mut bearings, DMat3::IDENTITY);
        let total: DVec3 = bearings.iter().map(|b| b.preload).sum();
        let moment: DVec3 = bearings.iter().map(|b| b.place.cross(b.preload)).sum();
        assert!((total.z - 50.0).abs() < 1e-11, "whole weight, got {}", total.z);
        assert!(moment.length() < 1e-11, "no moment, got {moment}");
        assert_eq!(unbalanced, UnbalancedWeight::default(), "exactly: all legs are as high as G");
    }

    #[test]
    fn what_one_bearing_beside_g_leaves_is_its_moment() {
        let mut bearings = vec![Bearing { place: DVec3::new(0.2, 0.0, -0.1), ..legs(0.0)[0] }];
        let UnbalancedWeight { force, first_moment } = carry(50.0, &mut bearings, DMat3::IDENTITY);
        let away = (first_moment - DVec3::new(10.0, 0.0, -5.0)).length();
        assert!(away < 1e-9 && force.abs() < 1e-9, "{first_moment}, {force} left");
        assert_eq!(carry(50.0, &mut [], DMat3::IDENTITY).force, -50.0, "none carries nothing");
    }

    #[test]
    fn bearings_on_a_line_or_a_point_carry_the_whole_weight() {
        let places: [&[[f64; 2]]; 5] = [
            &[[0.0, 0.0]],
            &[[3.0, 0.0]],
            &[[9.0, 3.0], [9.0, -3.0]],
            &[[9.0, 3.0], [9.0, 1.0], [9.0, -3.0]],
            &[[1.0, 2.0], [2.0, 3.0], [4.0, 5.0]],
        ];
        for stiffness in [1e2, 1e6, 1.3e9] {
            for places in places {
                let leg = |[x, y]: [f64; 2]| Bearing {
                    place: DVec3::new(x, y, 0.0),
                    stiffness: DVec3::splat(stiffness),
                    ..legs(0.0)[0]
                };
                let mut bearings: Vec<Bearing> = places.iter().map(|&place| leg(place)).collect();
                let unbalanced = carry(1e6, &mut bearings, DMat3::from_rotation_z(0.3));
                let total: f64 = bearings.iter().map(|b| b.preload.z).sum();
                assert!((total - 1e6).abs() < 1e-8, "{places:?} on {stiffness}: {total}");
                assert_eq!(unbalanced.force, 0.0, "{places:?} on {stiffness}");
                let moment: DVec3 = bearings.iter().map(|b| b.place * b.preload.z).sum();
                // No line of these goes through G; the moment left is that of the weight at the foot of the perpendicular from G.
                let from_g = match places {
                    [[x, y]] => DVec2::new(*x, *y),
                    [[9.0, _], ..] => DVec2::new(9.0, 0.0),
                    _ => DVec2::new(-0.5, 0.5),
                };
                let away = moment.truncate() - 1e6 * from_g;
                assert!(away.length() < 1e-6, "{places:?} on {stiffness}: {moment}");
            }
        }
    }

    #[test]
    fn stiffness_and_damping_are_those_assembled_by_hand_in_turned_axes() {
        let axes = DMat3::from_rotation_z(0.4);
        let m = PlanarBearings::gather(&legs(0.01), axes);
        let q = DVec3::new(0.3, -0.2, 0.1);
        // Energy and power of every leg by the linear motion of its own place.
        let by_hand = |of: fn(&Bearing) -> DVec3| -> f64 {
            let leg = |b: &Bearing| {
                let lever = axes * b.place;
                let moved = axes.transpose() * DVec3::new(q.x - q.z * lever.y, q.y + q.z * lever.x, 0.0);
                (of(b) * moved).dot(moved)
            };
            legs(0.01).iter().map(leg).sum()
        };
        for (matrix, wanted) in [(m.stiffness, by_hand(|b| b.stiffness)), (m.damping, by_hand(|b| b.damping))] {
            assert!((q.dot(matrix * q) - wanted).abs() < 1e-13 * wanted, "{} against {wanted}", q.dot(matrix * q));
            assert!(matrix.transpose().abs_diff_eq(matrix, 1e-13 * matrix.x_axis.x), "symmetric: {matrix}");
        }
        assert!(is_diagonal(&PlanarBearings::gather(&legs(0.0), DMat3::IDENTITY).stiffness), "legs about G");
        assert!(!is_diagonal(&m.stiffness), "an eccentricity couples");
    }
}
