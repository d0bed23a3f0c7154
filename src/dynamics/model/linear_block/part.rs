//! A body in plan as part of a linear block: its coordinates, and how its sections move by them.

use glam::{DVec2, DVec3};
use nalgebra::DMatrix;

/// Coordinates x, y, θ that come before the modes.
pub(in crate::dynamics) const RIGID: usize = 3;

/// A body whose free motion is linear in plan: x, y, θ, then modal coordinates of one that bends.
#[derive(Clone, Debug)]
pub struct LinearPart {
    /// Mass of each coordinate.
    pub masses: Vec<f64>,
    /// Whether it may change.
    pub free: Vec<bool>,
    /// Its own bearings on the ground, and what it resists deformation with.
    pub stiffness: DMatrix<f64>,
    /// Dashpots of its own bearings.
    pub damping: DMatrix<f64>,
    /// Dashpots of its modes, those of x, y and θ 0.
    pub own_damping: Vec<f64>,
    /// Constant generalised force of the push.
    pub push: Vec<f64>,
    /// Initial values of its coordinates.
    pub start: Vec<f64>,
    /// Distance of its ends from G, of a body that bends \[m\].
    pub lever: f64,
    /// Its sections; the first moves with G.
    pub sections: Vec<SectionShape>,
}

/// Displacement of a section by the modal coordinates.
#[derive(Clone, Debug, Default)]
pub struct SectionShape {
    /// From G to its centre, world axes as placed \[m\].
    pub lever: DVec2,
    /// u, v in the world's axes as placed, φ, of every mode; none of the section that moves with G.
    pub fields: Vec<DVec3>,
}

impl LinearPart {
    /// Number of coordinates.
    pub fn places(&self) -> usize {
        self.masses.len()
    }

    /// Displacement by each coordinate, along an axis, of a point at `arm` from G that a section carries: linear in all rotations.
    pub fn row(&self, section: usize, arm: DVec2, axis: DVec2) -> Vec<f64> {
        let SectionShape { lever, fields } = &self.sections[section];
        let modal = |field: &DVec3| axis.dot(field.truncate()) + (arm - *lever).perp_dot(axis) * field.z;
        let mut row = vec![axis.x, axis.y, arm.perp_dot(axis)];
        row.extend(fields.iter().map(modal));
        row.resize(self.places(), 0.0);
        row
    }
}
