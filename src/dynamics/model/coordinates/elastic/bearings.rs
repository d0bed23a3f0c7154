//! Bearings of an elastic girder, (F6): linear at every rotation, the elastic part added unrotated.

use glam::{DMat3, DVec2, DVec3};

use super::section::station_and_offset;
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

/// The axes as their forces need them: coordinate by coordinate, so that one pass serves all axes.
#[derive(Clone, Debug)]
pub(super) struct BearingRows {
    /// Displacements along the axes by each coordinate in turn, those of an axis that is not there 0.
    rows: Vec<[f64; LANES]>,
    /// Groups of axes, each with the first of its rows.
    groups: Vec<Group>,
}

/// Axes of which one pass takes care: as many as most girders have, four bearings with two axes each.
const LANES: usize = 8;

/// k \[N/m\] and c \[N·s/m\] of axes, 0 of one that is not there.
#[derive(Clone, Copy, Debug)]
struct Group {
    stiffness: [f64; LANES],
    damping: [f64; LANES],
}

impl BearingRows {
    /// Of axes over this many coordinates.
    pub(super) fn of(axes: &[BearingAxis], coordinates: usize) -> Self {
        let (mut rows, mut groups) = (Vec::new(), Vec::new());
        for some in axes.chunks(LANES) {
            let each = |of: &dyn Fn(&BearingAxis) -> f64| std::array::from_fn(|i| some.get(i).map_or(0.0, of));
            rows.extend((0..coordinates).map(|k| each(&|axis| axis.row[k])));
            groups.push(Group { stiffness: each(&|axis| axis.stiffness), damping: each(&|axis| axis.damping) });
        }
        Self { rows, groups }
    }

    /// Adds the generalised forces of all axes.
    pub(super) fn resist(&self, place: &[f64], rate: &[f64], out: &mut [f64]) {
        for (group, rows) in self.groups.iter().zip(self.rows.chunks(place.len())) {
            let (mut moved, mut moving) = ([0.0; LANES], [0.0; LANES]);
            for ((row, x), v) in rows.iter().zip(place).zip(rate) {
                for i in 0..LANES {
                    moved[i] += row[i] * x;
                    moving[i] += row[i] * v;
                }
            }
            let force: [f64; LANES] =
                std::array::from_fn(|i| group.stiffness[i] * moved[i] + group.damping[i] * moving[i]);
            for (out, row) in out.iter_mut().zip(rows) {
                *out -= row.iter().zip(&force).map(|(row, force)| row * force).sum::<f64>();
            }
        }
    }
}

/// Both axes of every bearing, those without spring and dashpot left out.
pub(super) fn axes_of(bearings: &[Bearing], modes: &Modes, cot: f64, axes: &DMat3) -> Vec<BearingAxis> {
    let mut all = Vec::new();
    for bearing in bearings {
        let place = bearing.place.truncate();
        let (station, offset) = station_and_offset(place, cot, 0.5 * modes.beam.length);
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
