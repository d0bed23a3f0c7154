//! Free motion on connections to the ground that are linear in their present phases: springs, dashpots and constant forces.

use glam::{DMat3, DVec3};

use crate::dynamics::free_flight::constants::CANCELLED;
use crate::dynamics::model::bearing::is_diagonal;
use crate::dynamics::model::body::Body;
use crate::dynamics::model::closed_form::GroundSpring;

/// Force of connections between the ground and a rigid girder in plan over (x, y, θ): `load − stiffness q − damping q̇` \[N, N·m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarSprings {
    /// \[N/m, N, N·m\].
    pub stiffness: DMat3,
    /// \[N·s/m, N·s, N·m·s\].
    pub damping: DMat3,
    /// \[N, N·m\].
    pub load: DVec3,
}

impl PlanarSprings {
    /// No force.
    pub const NONE: Self = Self { stiffness: DMat3::ZERO, damping: DMat3::ZERO, load: DVec3::ZERO };

    /// Stiffness and damping with those of the girder's bearings.
    pub(super) fn with_bearings(&self, body: &Body) -> [DMat3; 2] {
        [sum(&body.planar.stiffness, &self.stiffness), sum(&body.planar.damping, &self.damping)]
    }

    /// Whether these couple x, y and θ.
    pub(in crate::dynamics) fn couple(&self, body: &Body) -> bool {
        self.with_bearings(body).iter().any(|matrix| !is_diagonal(matrix))
    }
}

/// Connections to the ground that act on a body in flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) enum GroundSprings {
    /// On a body of one coordinate.
    OneCoordinate(GroundSpring),
    /// On a rigid girder in plan.
    InPlan(PlanarSprings),
}

/// Sum of two matrices; what cancels, as a bearing that has lost its support takes away its own spring, is 0.
fn sum(one: &DMat3, other: &DMat3) -> DMat3 {
    let (one, other) = (one.to_cols_array(), other.to_cols_array());
    DMat3::from_cols_array(&std::array::from_fn(|i| {
        let sum = one[i] + other[i];
        if sum.abs() > CANCELLED * (one[i].abs() + other[i].abs()) { sum } else { 0.0 }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cancels_is_nothing_and_the_rest_is_the_sum() {
        let own = DMat3::from_diagonal(DVec3::new(3e6, 2e6, 7e8));
        let lost = DMat3::from_diagonal(DVec3::new(-3e6 * (1.0 + 4.0 * f64::EPSILON), 1e6, 0.0));
        assert_eq!(sum(&own, &lost), DMat3::from_diagonal(DVec3::new(0.0, 3e6, 7e8)), "x is free");
        assert_eq!(sum(&own, &PlanarSprings::NONE.stiffness), own, "to the last bit");
    }
}
