//! Backwalls that move and the soil behind them.

use glam::DVec3;

use super::ViewInput;
use super::block::{Block, abutment_block};
use super::list::{Line, Rgba};
use super::palette::Palette;
use crate::scene::{Abutment, Scene};
use crate::sim::History;

/// Slope of the failure surface that is indicated behind a wall, run over rise: 30° from the horizontal, passive failure of soil
/// with an angle of friction of 30°.
const FAILURE_RUN: f64 = 1.732;

/// A backwall that moves, at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// Its displacement \[m\].
    pub displacement: DVec3,
    /// Soil behind it; `None` of an abutment that moves as one with its ground.
    pub soil: Option<Soil>,
}

/// The soil behind a backwall, at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Soil {
    /// Thickness of the wall before it \[m\].
    pub behind: f64,
    /// Displacement of its front \[m\].
    pub front: DVec3,
}

/// The backwalls of a scene by abutment, as placed or at `t` of a run; `None` for those that stand.
pub(super) fn at(scene: &Scene, run: Option<(&History, f64)>) -> Vec<Option<Wall>> {
    let wall = |(number, abutment): (usize, &Abutment)| {
        let now = run.and_then(|(history, t)| history.connections().wall(number, t));
        let front = now.and_then(|now| now.soil).map_or(DVec3::ZERO, |soil| soil.front);
        let soil = abutment.soil(scene).map(|soil| Soil { behind: soil.thickness, front });
        let displacement = now.map_or(DVec3::ZERO, |now| now.displacement);
        (now.is_some() || soil.is_some()).then_some(Wall { displacement, soil })
    };
    let walls: Vec<Option<Wall>> = scene.abutments.iter().enumerate().map(wall).collect();
    if walls.iter().all(Option::is_none) { Vec::new() } else { walls }
}

/// An abutment: the block that stands, or the wall alone where that moves.
pub(super) fn block(scene: &Scene, number: usize, wall: Option<&Wall>) -> Option<Block> {
    let whole = abutment_block(scene, scene.abutments.get(number)?)?;
    let Some(wall) = wall else { return Some(whole) };
    Some(match &wall.soil {
        Some(soil) => parted(&whole, wall.displacement, soil)[0],
        None => Block { face: whole.face.map(|corner| corner + wall.displacement), ..whole },
    })
}

/// The soil behind a wall that moves.
pub(super) fn soil(scene: &Scene, number: usize, wall: &Wall) -> Option<Block> {
    let whole = abutment_block(scene, scene.abutments.get(number)?)?;
    Some(parted(&whole, wall.displacement, wall.soil.as_ref()?)[1])
}

/// Wall and soil of an abutment; a thin shallow block keeps half of its depth for the soil.
fn parted(whole: &Block, displacement: DVec3, soil: &Soil) -> [Block; 2] {
    let inward = whole.sweep.normalize_or_zero();
    let thickness = inward * soil.behind.min(0.5 * whole.sweep.length());
    let front = Block { face: whole.face.map(|corner| corner + displacement), sweep: thickness };
    let soil = thickness + soil.front;
    [front, Block { face: whole.face.map(|corner| corner + soil), sweep: whole.sweep - soil }]
}

/// Failure surface of soil behind a wall, as lines on the sides and the top of its block.
pub(super) fn failure_lines(input: &ViewInput<'_>, soil: &Block, palette: &Palette) -> Vec<Line> {
    let [a, b, c, d] = soil.face;
    let inward = soil.sweep.normalize_or_zero();
    let back = |foot: DVec3, top: DVec3| {
        let run = (FAILURE_RUN * (top - foot).length()).min(soil.sweep.length());
        foot.lerp(top, run / (FAILURE_RUN * (top - foot).length()).max(f64::MIN_POSITIVE)) + inward * run
    };
    let (one, other) = (back(a, d), back(b, c));
    let line = |from: DVec3, to: DVec3| Line {
        group: "soil",
        from: from.as_vec3(),
        to: to.as_vec3(),
        width: 1.3 * input.pixels_per_point,
        color: faint(palette.edge),
    };
    vec![line(a, one), line(b, other), line(one, other)]
}

fn faint(color: Rgba) -> Rgba {
    let Rgba([r, g, b, a]) = color;
    Rgba::new(r, g, b, a / 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gap_opens_between_a_wall_that_came_back_and_its_soil() {
        let face = [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 2.0], [0.0, -1.0, 2.0]].map(DVec3::from);
        let whole = Block { face, sweep: DVec3::X * 5.0 };
        let soil = Soil { behind: 0.5, front: DVec3::X * 0.3 };
        let [front, soil] = parted(&whole, DVec3::X * 0.1, &soil);
        assert_eq!(front.face[0].x, 0.1, "the face where the wall is");
        assert!((front.face[0] + front.sweep).x < soil.face[0].x, "a gap behind it");
        assert!(((soil.face[0] + soil.sweep).x - 5.0).abs() < 1e-12, "the far end stands");
    }
}
