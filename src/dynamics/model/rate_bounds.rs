//! Upper bounds of a body's mobility at its corners and of the spectral radius of `M⁻¹ K` on its bearings (Gershgorin sums).

use crate::dynamics::model::bearing::Bearing;
use crate::geometry::Prism;

/// How fast a body can answer, from above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quickness {
    /// Acceleration at a corner per unit force \[1/kg\].
    pub(in crate::dynamics) mobility: f64,
    /// Largest stiffness per inertia on its bearings \[1/s²\].
    pub(in crate::dynamics) stiffest: f64,
}

impl Quickness {
    /// Of a body of that shape and mass, free in these directions, on these bearings.
    pub(in crate::dynamics) fn of(
        prism: &Prism,
        mass: f64,
        [radius, gyration2]: [f64; 2],
        free: [bool; 6],
        bearings: &[Bearing],
    ) -> Self {
        let arm2 = radius * radius;
        let smallest = (prism.width.powi(2) + prism.thickness.powi(2)) / 12.0;
        let tilts = free[3] || free[4];
        let mobility = (1.0 + if tilts { arm2 / smallest } else { arm2 / gyration2 }) / mass;
        let sum = bearings.iter().map(|b| b.stiffness.max_element()).sum::<f64>();
        let damping = bearings.iter().map(|b| b.damping.max_element()).sum::<f64>() / mass;
        let swing = if tilts { sum / mass * (1.0 + arm2 / smallest) } else { 3.0 * sum / mass };
        Self { mobility, stiffest: swing.max(damping * damping) }
    }
}
