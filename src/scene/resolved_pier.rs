//! Piers with everything filled in: by the formulas of `docs/physics.md#piers`, and from the girders that stand on them.

use std::f64::consts::{PI, TAU};

use glam::{DMat3, DVec2, DVec3};

use super::angle::sin_cos_deg;
use super::concrete::CONCRETE_MODULUS;
use super::pier::{ColumnTop, Pier};
use super::supports::{extent, underside};
use super::{PerDirection, Scene};
use crate::motion::spectrum::DESIGN_DAMPING;

/// Stiffness after yield over that before where none is given \[–\].
const USUAL_POST_YIELD: f64 = 0.05;
/// Height of a pier that is only drawn, in girder depths \[–\].
const DEPTHS: f64 = 5.0;

/// A pier with everything filled in; pairs of numbers are along and across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResolvedPier {
    /// Middle of its cap's top, world \[m\].
    pub top: DVec3,
    /// Its axes along, across and up, in the columns.
    pub axes: DMat3,
    /// m \[kg\].
    pub mass: f64,
    /// k before any yield \[N/m\].
    pub stiffness: [f64; 2],
    /// c \[N·s/m\].
    pub damping: [f64; 2],
    /// Moment of inertia about the vertical \[kg·m²\].
    pub inertia: f64,
    /// `k_θ` \[N·m/rad\]; `None` where it does not turn.
    pub turn_stiffness: Option<f64>,
    /// Yield of its base.
    pub yielding: Option<BaseYield>,
    /// From its foot to its cap's top \[m\].
    pub height: f64,
    /// Arm of the base shear for the moment at its feet, along and across: the height, half of it where a cap holds the tops of its
    /// columns from turning \[m\].
    pub arm: [f64; 2],
    /// Sides of its cap along, across and up \[m\].
    pub cap: [f64; 3],
    /// Its columns: diameter, or sides along and across \[m\].
    pub column: PerDirection,
    /// Number of columns across it.
    pub columns: usize,
}

/// Bilinear yield of a pier's base, along and across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BaseYield {
    /// Force at which it yields \[N\].
    pub force: [f64; 2],
    /// Stiffness after yield over that before \[–\].
    pub ratio: f64,
}

impl BaseYield {
    /// Stiffness and force of the part that yields: `(1 − α) k` up to `(1 − α) F_y`.
    pub fn part(&self, stiffness: [f64; 2]) -> [[f64; 2]; 2] {
        [0, 1].map(|axis| [stiffness[axis], self.force[axis]].map(|v| (1.0 - self.ratio) * v))
    }
}

impl ResolvedPier {
    /// Undamped circular frequencies of the pier alone along, across and about the vertical \[rad/s\]; 0 where it does not turn.
    pub fn frequencies(&self) -> [f64; 3] {
        let [along, across] = self.stiffness.map(|k| (k / self.mass).sqrt());
        [along, across, self.turn_stiffness.map_or(0.0, |k| (k / self.inertia).sqrt())]
    }
}

impl Pier {
    /// Second moments of area of one column for bending along and across \[m⁴\].
    fn second_moments(column: PerDirection) -> [f64; 2] {
        match column {
            PerDirection::Both(diameter) => [PI * diameter.powi(4) / 64.0; 2],
            PerDirection::Each([along, across]) => [across * along.powi(3) / 12.0, along * across.powi(3) / 12.0],
        }
    }

    /// Whether the cap holds the tops of its columns from turning as they bend along and across.
    fn held(&self) -> [bool; 2] {
        match self.top {
            ColumnTop::Free => [false, false],
            ColumnTop::FixedAcross => [false, true],
            ColumnTop::Fixed => [true, true],
        }
    }

    /// `n · 3 E I/h³`, or `n · 12 E I/h³` where the tops do not turn.
    fn column_stiffness(&self, column: PerDirection) -> [f64; 2] {
        let factors = self.held().map(|held| if held { 12.0 } else { 3.0 });
        let height = self.height.unwrap_or(f64::NAN);
        let share = self.columns * self.modulus.unwrap_or(CONCRETE_MODULUS) / height.powi(3);
        let moments = Self::second_moments(column);
        [0, 1].map(|axis| factors[axis] * share * moments[axis])
    }

    /// k along and across, where it is given in one of the three ways \[N/m\].
    pub(super) fn stiffness(&self) -> Option<[f64; 2]> {
        let by_frequency = || Some(self.frequency?.xy().map(|f| self.mass * (TAU * f).powi(2)));
        self.stiffness.map(PerDirection::xy).or_else(by_frequency).or_else(|| Some(self.column_stiffness(self.column?)))
    }
}

impl Scene {
    /// Weight that a pier carries: its own, and of each girder the share of its bearings that stand on the pier \[N\].
    pub fn weight_on(&self, number: usize) -> f64 {
        let share = |(girder, _): (usize, DVec3)| {
            let girder = &self.girders[girder];
            girder.mass / girder.supports(self.setting()).len() as f64
        };
        let above: f64 = self.standing_on(number).into_iter().map(share).sum();
        self.gravity * (self.piers[number].mass + above)
    }

    /// The pier of this number with everything filled in; of a scene that was checked.
    pub fn pier(&self, number: usize) -> ResolvedPier {
        let pier = &self.piers[number];
        let bearings = self.standing_on(number);
        let above = bearings.first().map(|(girder, _)| &self.girders[*girder]);
        // Of the deepest, so that the order in which girders are listed changes nothing.
        let on_it = || bearings.iter().map(|(girder, _)| &self.girders[*girder]);
        let depth = on_it().map(|girder| girder.thickness).reduce(f64::max).unwrap_or(1.0);
        let square = above.map(|girder| girder.heading_deg + girder.skew_deg - 90.0);
        let (s, c) = sin_cos_deg(pier.heading_deg.or(square).unwrap_or(0.0));
        let axes = DMat3::from_cols(DVec3::new(c, s, 0.0), DVec3::new(-s, c, 0.0), DVec3::Z);
        let plan = [axes.x_axis, axes.y_axis].map(|axis| extent(&bearings, axis.truncate()));
        let middle = plan.map(|[low, high]| 0.5 * (low + high));
        let below = if bearings.is_empty() { DVec2::ZERO } else { DVec2::from(middle) };
        let below = axes.x_axis.truncate() * below.x + axes.y_axis.truncate() * below.y;
        let position = pier.position.map_or(below, DVec2::from);
        let cap = pier.cap.unwrap_or_else(|| {
            // Over its bearings, and half the depth of the deepest girder beyond them on every side.
            let sides = plan.map(|[low, high]| (high - low).max(0.0) + depth);
            [sides[0], sides[1], depth]
        });
        let stiffness = pier.stiffness().unwrap_or([f64::NAN; 2]);
        let ratio = pier.damping_ratio.map_or([DESIGN_DAMPING; 2], PerDirection::xy);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number from 1 to 12")]
        let columns = pier.columns as usize;
        let height = pier.height.unwrap_or(DEPTHS * depth);
        let width = if columns == 1 { cap[0].min(cap[1]) * 0.6 } else { cap[1] / (2.0 * pier.columns) };
        ResolvedPier {
            top: position.extend(on_it().map(underside).reduce(f64::min).unwrap_or(0.0)),
            axes,
            mass: pier.mass,
            stiffness,
            damping: [0, 1].map(|axis| 2.0 * ratio[axis] * (stiffness[axis] * pier.mass).sqrt()),
            inertia: pier.turn_inertia.unwrap_or(pier.mass * (cap[0] * cap[0] + cap[1] * cap[1]) / 12.0),
            turn_stiffness: pier.turn_stiffness,
            yielding: pier
                .yield_force
                .map(|force| BaseYield { force: force.xy(), ratio: pier.post_yield_ratio.unwrap_or(USUAL_POST_YIELD) }),
            height,
            arm: pier.held().map(|held| if held { 0.5 * height } else { height }),
            cap,
            column: pier.column.unwrap_or(PerDirection::Both(width.min(cap[0]))),
            columns,
        }
    }
}
