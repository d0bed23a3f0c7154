//! Bearings of an elastic girder, (F6): linear at every rotation, the elastic part added unrotated.

use glam::{DMat3, DVec2, DVec3};

use crate::dynamics::elastic::{Modes, modes::displacement};
use crate::dynamics::model::bearing::Bearing;

/// A spring and a dashpot along one axis of one bearing.
#[derive(Clone, Debug)]
pub(in crate::dynamics) struct BearingAxis {
    /// Station along the girder's axis \[m\].
    pub station: f64,
    /// Offset from the section's centre, girder axes \[m\].
    pub offset: DVec2,
    /// Its direction, girder axes.
    pub along: DVec2,
    /// Displacement along it by x, y, θ, then by the modes.
    pub row: Vec<f64>,
    /// k \[N/m\].
    pub stiffness: f64,
    /// c \[N·s/m\].
    pub damping: f64,
}

impl BearingAxis {
    /// Displacement along it, or its rate.
    pub(in crate::dynamics) fn along(&self, coordinates: &[f64]) -> f64 {
        self.row.iter().zip(coordinates).map(|(row, x)| row * x).sum()
    }
}

/// Both axes of every bearing, those without spring and dashpot left out.
pub(super) fn axes_of(bearings: &[Bearing], modes: &Modes, cot: f64, axes: &DMat3) -> Vec<BearingAxis> {
    let mut all = Vec::new();
    for bearing in bearings {
        let place = bearing.place.truncate();
        // The oblique section that the bearing stands on.
        let (station, offset) = (place.x - place.y * cot, DVec2::new(place.y * cot, place.y));
        let fields = modes.section(2.0 * station / modes.beam.length);
        for (axis, unit) in [DVec2::X, DVec2::Y].into_iter().enumerate() {
            let (stiffness, damping) = (bearing.stiffness[axis], bearing.damping[axis]);
            if stiffness == 0.0 && damping == 0.0 {
                continue;
            }
            let world = axes.col(axis).truncate();
            let lever = (*axes * place.extend(0.0)).truncate();
            let rigid = [world.x, world.y, lever.perp_dot(world)];
            let modal = fields.iter().map(|field: &DVec3| displacement(*field, offset)[axis]);
            let row = rigid.into_iter().chain(modal).collect();
            all.push(BearingAxis { station, offset, along: unit, row, stiffness, damping });
        }
    }
    all
}
