//! Parts by which a deck of full size looks like a bridge: its section, parapets, seats under its ends, backwall, wing walls and
//! embankment. Drawn and not computed.
//!
//! Nothing of it reaches out of the blocks that are computed towards a gap: a deck's slab, beams and diaphragms lie in its block
//! and the diaphragms are its end faces; an abutment's parts fill its block.

use std::ops::Range;

use glam::DVec3;

use super::block::Block;
use crate::geometry::End;
use crate::scene::{Girder, Scene};
use crate::sim::Motion;

/// Shortest deck that is a bridge \[m\]: Japan counts road bridges from 2 m on. What is shorter is a specimen, drawn as the block
/// that it is.
const SHORTEST: f64 = 2.0;
// Proportions of a slab on girders and of a wall with wings, by eye: nothing is computed from them.

/// Depth of the slab, in depths of the deck.
const SLAB: f64 = 0.17;
/// Spacing of beams that is come near to \[m\].
const SPACING: f64 = 2.5;
/// Fewest and most beams.
const BEAMS: Range<f64> = 2.0..8.0;
/// Width of a beam, in spacings.
const BEAM: f64 = 0.22;
/// Length of a diaphragm in depths of the deck, and at most in lengths.
const DIAPHRAGM: [f64; 2] = [0.5, 0.08];
/// Height of a parapet in deck depths, and its width in deck widths.
const PARAPET: [f64; 2] = [0.55, 0.035];
/// Thickness of a backwall in depths of its block, and of a wing wall in widths of it.
const WALL: [f64; 2] = [0.14, 0.025];
/// Height of a wing wall at its far end, in heights of the block.
const WING_END: f64 = 0.35;

/// Whether a deck is drawn as a bridge.
pub(super) fn is_bridge(girder: &Girder) -> bool {
    girder.length >= SHORTEST
}

/// Whether any deck of a scene is.
pub(super) fn has_bridge(scene: &Scene) -> bool {
    scene.girders.iter().any(is_bridge)
}

/// A part of a girder where its motion has brought it: `along` its axis from an end face to the other \[m\], between two places
/// across and two heights in its own frame \[m\].
fn part(girder: &Girder, motion: &Motion, along: Range<f64>, [from, to]: [f64; 2], [low, high]: [f64; 2]) -> Block {
    let shear = girder.prism().shear();
    let corner = |y: f64, z: f64| motion.place + motion.attitude * DVec3::new(along.end + y * shear, y, z);
    // Seen from the +x end.
    let face = [corner(from, low), corner(to, low), corner(to, high), corner(from, high)];
    Block { face, sweep: motion.attitude * DVec3::new(along.start - along.end, 0.0, 0.0) }
}

/// A part of a deck and those of its edges that are edges of the whole.
pub(super) struct Part {
    pub(super) block: Block,
    pub(super) edges: Vec<[DVec3; 2]>,
}

impl Part {
    /// The slab between the diaphragms: its edges along the deck.
    fn slab(block: Block) -> Self {
        Self { edges: block.edges()[8..].to_vec(), block }
    }

    /// A beam: the edges of its underside.
    fn beam(block: Block) -> Self {
        Self { edges: block.edges()[8..10].to_vec(), block }
    }

    /// A diaphragm, outside at `end`, below the slab inside: its edges but for those in the slab, which has this part of its height.
    fn diaphragm(block: Block, end: End, slab: f64) -> Self {
        let all = block.edges();
        let (outer, inner) = if end == End::Plus { (0, 4) } else { (4, 0) };
        let below = |[from, to]: [DVec3; 2]| [from, from.lerp(to, 1.0 - slab)];
        let [_, one, _, other] = [0, 1, 2, 3].map(|side| all[inner + side]);
        let mut edges = [&all[outer..outer + 4], &all[8..], &all[inner..=inner]].concat();
        // The second goes down.
        edges.extend([below(one), below([other[1], other[0]])]);
        Self { block, edges }
    }
}

/// A deck in parts: slab, beams, a diaphragm at either end, which are the end faces of its block.
pub(super) fn deck(girder: &Girder, motion: &Motion) -> Vec<Part> {
    let half = [girder.length, girder.width, girder.thickness].map(|side| 0.5 * side);
    let slab = half[2] - SLAB * girder.thickness;
    let end = (DIAPHRAGM[0] * girder.thickness).min(DIAPHRAGM[1] * girder.length);
    let between = end - half[0]..half[0] - end;
    let whole = [-half[1], half[1]];
    let mut parts = vec![
        Part::slab(part(girder, motion, between.clone(), whole, [slab, half[2]])),
        Part::diaphragm(part(girder, motion, between.end..half[0], whole, [-half[2], half[2]]), End::Plus, SLAB),
        Part::diaphragm(part(girder, motion, -half[0]..between.start, whole, [-half[2], half[2]]), End::Minus, SLAB),
    ];
    let count = (girder.width / SPACING).round().clamp(BEAMS.start, BEAMS.end);
    let spacing = girder.width / count;
    #[expect(clippy::cast_sign_loss, reason = "a few")]
    let beams = (0..count as u32).map(|beam| {
        let middle = (f64::from(beam) + 0.5) * spacing - half[1];
        let across = [middle - 0.5 * BEAM * spacing, middle + 0.5 * BEAM * spacing];
        Part::beam(part(girder, motion, between.clone(), across, [-half[2], slab]))
    });
    parts.extend(beams);
    parts
}

/// The parapets of a deck.
pub(super) fn parapets(girder: &Girder, motion: &Motion) -> [Block; 2] {
    let (half, top) = (0.5 * girder.width, 0.5 * girder.thickness);
    let [height, width] = [PARAPET[0] * girder.thickness, PARAPET[1] * girder.width];
    let along = -0.5 * girder.length..0.5 * girder.length;
    [[-half, width - half], [half - width, half]]
        .map(|across| part(girder, motion, along.clone(), across, [top, top + height]))
}

/// Parts inside an abutment's block.
pub(super) struct Abutment {
    /// The wall before the deck, as high and as wide as the block.
    pub(super) backwall: Block,
    /// Walls beside the embankment, lower towards its end.
    pub(super) wings: [Block; 2],
    /// The embankment between them.
    pub(super) fill: Block,
}

/// An abutment in parts; the block's face has its lower corners first.
pub(super) fn abutment(whole: &Block) -> Abutment {
    let [a, b, c, d] = whole.face;
    let (wall, wing) = (whole.sweep * WALL[0], WALL[1]);
    let behind = whole.sweep - wall;
    let inner = |share: f64| {
        let (low, high) = (a.lerp(b, share), d.lerp(c, share));
        [low + wall, high + wall]
    };
    let slice = |from: f64, to: f64| {
        let ([low, high], [low_to, high_to]) = (inner(from), inner(to));
        Block { face: [low, low_to, high_to, high], sweep: behind }
    };
    // A trapezium along the embankment, swept across it.
    let side = |from: f64, to: f64| {
        let ([low, high], [low_to, _]) = (inner(from), inner(to));
        let foot = (low + behind).lerp(high + behind, 1.0 - WING_END);
        Block { face: [low, high, high + behind, foot], sweep: low_to - low }
    };
    Abutment {
        backwall: Block { face: whole.face, sweep: wall },
        wings: [side(0.0, wing), outwards(&side(1.0, 1.0 - wing))],
        fill: slice(wing, 1.0 - wing),
    }
}

/// The block with its face turned round.
fn outwards(block: &Block) -> Block {
    let [a, b, c, d] = block.face;
    Block { face: [d, c, b, a], ..*block }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::block::moved_girder_block;
    use crate::view::moment::at_rest;

    fn girder() -> Girder {
        Girder { skew_deg: 60.0, heading_deg: 25.0, ..Girder::straight("deck", [30.0, 10.0, 1.5], 1e5) }
    }

    /// Whether a block holds a point, but for rounding.
    fn holds(block: &Block, point: DVec3) -> bool {
        block.sides().iter().all(|(normal, on)| normal.normalize_or_zero().dot(point - *on) < 1e-9)
    }

    fn faces_outwards(block: &Block) -> bool {
        let middle = block.corners().iter().sum::<DVec3>() / 8.0;
        block.sides().iter().all(|(normal, on)| normal.dot(middle - *on) < 0.0)
    }

    #[test]
    fn a_deck_in_parts_lies_in_its_block_and_ends_where_that_ends() {
        let girder = girder();
        let motion = Motion { displacement: DVec3::new(0.1, -0.2, 0.05), ..at_rest(&girder) };
        let (parts, whole) = (deck(&girder, &motion), moved_girder_block(&girder, &motion));
        assert_eq!(parts.len(), 3 + 4, "slab, diaphragms, a beam every 2.5 m");
        for Part { block, edges } in &parts {
            assert!(faces_outwards(block), "{block:?}");
            assert!(block.corners().iter().all(|corner| holds(&whole, *corner)), "{block:?} in {whole:?}");
            let ends = edges.iter().flatten();
            assert!(ends.clone().all(|end| holds(block, *end) && holds(&whole, *end)), "{edges:?}");
        }
        let is_corner =
            |corner: &DVec3| parts.iter().flat_map(|part| part.block.corners()).any(|p| (p - corner).length() < 1e-9);
        assert!(whole.corners().iter().all(is_corner), "every corner of the block is one of a diaphragm");
    }

    #[test]
    fn an_abutment_in_parts_fills_its_block_and_keeps_its_face() {
        let face = [[0.0, -4.0, -1.0], [0.0, 4.0, -1.0], [0.0, 4.0, 2.0], [0.0, -4.0, 2.0]].map(DVec3::from);
        let whole = Block { face, sweep: -DVec3::X * 5.0 };
        let parts = abutment(&whole);
        assert_eq!(parts.backwall.face, whole.face, "the face that is hit");
        let all = [parts.backwall, parts.wings[0], parts.wings[1], parts.fill];
        for part in all {
            assert!(faces_outwards(&part), "{part:?}");
            assert!(part.corners().iter().all(|corner| holds(&whole, *corner)), "{part:?}");
        }
    }

    #[test]
    fn a_specimen_is_no_bridge() {
        assert!(is_bridge(&girder()) && !is_bridge(&Girder::straight("specimen", [0.19, 0.07, 0.02], 2.0)));
    }
}
