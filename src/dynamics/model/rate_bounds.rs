//! Upper bounds of a body's mobility at its corners and of the spectral radius of `M⁻¹ K` on its bearings (Gershgorin sums).

use crate::dynamics::connection::Connection;
use crate::dynamics::model::bearing::Bearing;
use crate::geometry::Prism;

/// Upper bounds of a body's mobility at its corners and of its stiffness per inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateBounds {
    /// Acceleration at a corner per unit force \[1/kg\].
    pub mobility: f64,
    /// Largest stiffness per inertia on its bearings \[1/s²\].
    pub stiffest: f64,
    /// Of the modes of a girder that bends, on their own springs and dashpots: 0 of any other body.
    pub modal: ModalRates,
}

/// Largest rates of modes on their own springs and dashpots.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ModalRates {
    /// Of a change: circular frequency or dashpot per mass, whichever is larger \[1/s\].
    pub change: f64,
    /// Rate of a decay, `2 ζ ω` \[1/s\]: a bound on the faster of the two exponents of an overdamped mode.
    pub decay: f64,
}

impl ModalRates {
    /// The larger ones of both.
    pub(in crate::dynamics) fn max(self, other: Self) -> Self {
        Self { change: self.change.max(other.change), decay: self.decay.max(other.decay) }
    }
}

impl RateBounds {
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
        let sum = bearings.iter().map(|b| b.stiffness_bound(&())).sum::<f64>();
        let damping = bearings.iter().map(|b| b.damping_bound(&())).sum::<f64>() / mass;
        let swing = if tilts { sum / mass * (1.0 + arm2 / smallest) } else { 3.0 * sum / mass };
        Self { mobility, stiffest: swing.max(damping * damping), modal: ModalRates::default() }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use crate::dynamics::Model;
    use crate::dynamics::model::body::Body;
    use crate::dynamics::model::rigid_body::{RigidAcceleration, response};
    use crate::scene::presets;

    /// Spectral radius of `M⁻¹ K` by the power method, `M = diag(m, m, m i²)`.
    fn spectral_radius(body: &Body) -> f64 {
        let inverse = DVec3::new(1.0, 1.0, 1.0 / body.gyration2) / body.mass;
        let (mut q, mut radius) = (DVec3::new(0.3, 0.5, 0.7), 0.0);
        for _ in 0..200 {
            let next = inverse * (body.planar.stiffness * q);
            (radius, q) = (next.length() / q.length(), next.normalize_or_zero());
        }
        radius
    }

    #[test]
    fn bounds_are_above_the_spectral_radius_and_not_far_above() {
        for name in ["straight-abutment", "skew45-abutment", "skew60-abutment", "row-of-5"] {
            let model = Model::compile(&presets::load(name).expect("a preset")).expect("a scene");
            for body in &model.bodies {
                let (radius, bound) = (spectral_radius(body), body.rate_bounds.stiffest);
                assert!(radius <= bound && bound < 4.0 * radius, "{name}: {bound} against {radius}");
            }
        }
    }

    #[test]
    fn no_corner_is_more_mobile_than_the_bound() {
        for name in ["skew45-abutment", "deck-30m"] {
            let model = Model::compile(&presets::load(name).expect("a preset")).expect("a scene");
            let body = &model.bodies[0];
            for corner in body.prism.corners() {
                let arm = body.axes * corner;
                for along in [DVec3::X, DVec3::Y, (DVec3::X + DVec3::Y).normalize_or_zero()] {
                    let RigidAcceleration { linear, angular } = response(body, &body.axes, along, arm);
                    let mobility = (linear + angular.cross(arm)).dot(along);
                    let bound = body.rate_bounds.mobility;
                    assert!(mobility <= bound * (1.0 + 1e-12), "{name}: {mobility} above {bound}");
                }
            }
        }
    }
}
