//! The kinds of islands: what differs between an island of bodies with all their coordinates and one on a single axis.
//! The kind is found where an island is formed and lasts as long as the island.

use crate::dynamics::Model;
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::penalty3d::collinear_island::CollinearIsland;
use crate::dynamics::penalty3d::coupled_system::CoupledSystem;
use crate::dynamics::penalty3d::general_island;
use crate::dynamics::penalty3d::workspace::Workspace;

/// Kind of an island.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::dynamics) enum IslandKind {
    /// Bodies with all their coordinates; each contact has a motion of its own and may slide.
    #[default]
    General,
    /// Bodies restricted to one coordinate each, girders that bend to it and their modes along its axis; the contacts between two faces
    /// have one motion and cannot slide.
    Collinear(CollinearIsland),
}

impl IslandKind {
    /// Kind of an island of these bodies and connections that starts in the state `y`.
    pub(in crate::dynamics) fn of(model: &Model, system: &CoupledSystem, y: &[f64]) -> Self {
        let collinear = CollinearIsland::of(model, system).filter(|island| island.holds(y));
        collinear.map_or(Self::General, Self::Collinear)
    }

    /// Derivative of a state `y` under the ground's motion. A state of a collinear island that is off its
    /// axis, as in a difference quotient, has the rates of the general island.
    #[inline]
    pub(in crate::dynamics) fn rates(
        &self,
        model: &Model,
        system: &CoupledSystem,
        ground: GroundNow,
        y: &[f64],
        workspace: &mut Workspace,
        out: &mut [f64],
    ) {
        match self {
            Self::Collinear(island) if island.holds(y) => island.rates(model, system, ground.acceleration, y, out),
            _ => general_island::rates(model, system, ground, y, workspace, out),
        }
    }

    /// The first of the contacts whose motion is that of this one at all times.
    #[inline]
    pub(in crate::dynamics) fn representative(&self, contact: usize) -> usize {
        match self {
            Self::General => contact,
            Self::Collinear(island) => island.first(contact),
        }
    }

    /// Numbers of those of `count` contacts that have different motions: of those with one motion, the first.
    pub(in crate::dynamics) fn distinct(&self, count: usize) -> impl Iterator<Item = usize> + '_ {
        (0..count).filter(|&contact| self.representative(contact) == contact)
    }

    /// Numbers of the others of `count` contacts that one of the [`distinct`](Self::distinct) ones represents.
    pub(in crate::dynamics) fn represented_by(&self, contact: usize, count: usize) -> impl Iterator<Item = usize> + '_ {
        (contact + 1..count).filter(move |&other| self.representative(other) == contact)
    }

    /// Whether its contacts can slide. On one axis the tangential spring has no stretch, and the friction limit is
    /// reached only where the normal force vanishes, which is the opening.
    #[inline]
    pub(in crate::dynamics) fn can_slide(&self) -> bool {
        matches!(self, Self::General)
    }

    /// Components of position and velocity of a body along `axis` (0 is x, 1 is y) in the island's vector, where that is
    /// the only motion of all its sections; `None` otherwise.
    pub(in crate::dynamics) fn components(&self, body: usize, axis: usize) -> Option<[usize; 2]> {
        match self {
            Self::Collinear(island) if island.axis() == axis => island.components(body),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::dynamics::model::coordinates::planar::WIDTH;
    use crate::dynamics::penalty3d::example::{SPEED, closed, island_of, row, stick};

    const ALONG: [f64; 2 * WIDTH] = [1e-3, 0.0, 0.0, SPEED, 0.0, 0.0, -1e-3, 0.0, 0.0, -SPEED, 0.0, 0.0];

    /// Model, bodies and connections of two girders pressed end to end that start in the state `y`.
    fn pressed(y: &[f64]) -> (Model, CoupledSystem, IslandKind) {
        let (model, active) = closed(&row(), stick);
        let island = island_of(&model, active, y.to_vec());
        (model, island.system, island.kind)
    }

    fn rates(kind: &IslandKind, model: &Model, system: &CoupledSystem, y: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; y.len()];
        kind.rates(model, system, GroundNow::of(DVec3::ZERO), y, &mut Workspace::of(&system.active), &mut out);
        out
    }

    #[test]
    fn the_initial_state_decides_whether_an_island_is_collinear() {
        assert!(matches!(pressed(&ALONG).2, IslandKind::Collinear(_)), "at rest across the axis");
        for across in [1, 2, 4, 5, WIDTH + 1, WIDTH + 5] {
            let mut y = ALONG;
            y[across] = 1e-300;
            assert_eq!(pressed(&y).2, IslandKind::General, "component {across} is not 0");
        }
    }

    #[test]
    fn contacts_of_two_faces_have_one_motion_on_an_axis_and_their_own_elsewhere() {
        let (.., collinear) = pressed(&ALONG);
        let first = |kind: &IslandKind| (0..4).map(|contact| kind.representative(contact)).collect::<Vec<_>>();
        assert_eq!(first(&collinear), [0; 4], "two nodes of either girder on the other's face");
        assert_eq!(first(&IslandKind::General), [0, 1, 2, 3]);
        assert!(!collinear.can_slide() && IslandKind::General.can_slide());
        assert_eq!(collinear.components(1, 0), Some([WIDTH, WIDTH + 3]), "x and its rate of the second body");
        assert_eq!(collinear.components(1, 1), None, "across the axis");
        assert_eq!(IslandKind::General.components(1, 0), None);
    }

    #[test]
    fn off_its_axis_a_collinear_island_has_the_rates_of_the_general_one() {
        let (model, system, kind) = pressed(&ALONG);
        let general = IslandKind::General;
        let [on, also_on] = [&kind, &general].map(|kind| rates(kind, &model, &system, &ALONG));
        let largest = also_on.iter().fold(0.0f64, |most, rate| most.max(rate.abs()));
        assert!(on.iter().zip(&also_on).all(|(a, b)| (a - b).abs() <= 1e-13 * largest), "{on:?} is not {also_on:?}");
        let mut y = ALONG;
        y[2] = 1e-9;
        let [off, also_off] = [&kind, &general].map(|kind| rates(kind, &model, &system, &y));
        assert_eq!(off, also_off, "turned");
    }
}
