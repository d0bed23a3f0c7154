//! Boxes that bodies sweep during a run: two whose boxes lie apart never come near.

use glam::DVec3;

use super::motion;
use super::solid::Solids;
use crate::geometry::shape::AlignedBox;
use crate::sim::History;

/// The box that a body sweeps from t = 0 to the end of the answer \[m\].
pub(super) fn of(history: &History, solids: &Solids, number: usize) -> AlignedBox {
    let Some(body) = solids.body(number) else { return solids.fixed_box(number) };
    let radius = solids.radius(number);
    let reach = motion::reach(history, body);
    let half = DVec3::splat(reach + radius);
    let home = history.model().bodies[body].home;
    solids.flat(AlignedBox { min: home - half, max: home + half })
}
