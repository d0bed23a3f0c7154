//! Overlaps that no contact carries: the area that two bodies share in plan, outlined and hatched, and its depth in words.

use std::f64::consts::FRAC_PI_4;

use glam::{DVec2, DVec3};

use super::ViewInput;
use super::block::Block;
use super::gap::girder_block_at;
use super::input::pixel;
use super::labels::{BESIDE, Label, Placer};
use super::list::{Line, Mark};
use super::moment::{Moment, OverlapNow};
use super::palette::{OVERLAP, Palette};
use super::scale;
use super::texts::TEXT;
use super::walls;
use crate::geometry::shape::{common_area, common_centre};
use crate::language::{Text, values};
use crate::sim::SolidId;

/// Width of the outline \[points\].
const OUTLINE: f32 = 2.2;
/// Width of a hatch line \[points\].
const HATCH: f32 = 1.1;
/// Hatch lines across the shared area.
const HATCH_LINES: u32 = 9;

/// Intersection of two bodies, as drawn.
struct Shared {
    /// Outline in plan \[m\].
    area: Vec<DVec2>,
    /// Its centre, at the height of the lower top \[m\].
    centre: DVec3,
}

/// Outline and hatching of every overlap of a moment.
pub(super) fn lines(input: &ViewInput<'_>, moment: &Moment) -> Vec<Line> {
    let shared = moment.overlaps.iter().filter_map(|overlap| shared(input, moment, overlap));
    shared.flat_map(|shared| area_lines(input, &shared)).collect()
}

/// The depth of every overlap of a moment, beside it.
pub(super) fn labels(input: &ViewInput<'_>, moment: &Moment, palette: &Palette, placer: &mut Placer) -> Vec<Mark> {
    let ppp = input.pixels_per_point;
    let label = |overlap: &OverlapNow| {
        // Bodies that are drawn farther from home than they are may lie apart.
        let place = shared(input, moment, overlap).map_or(overlap.place, |shared| shared.centre);
        Some(Label {
            at: pixel(input, place)?,
            clear: 14.0 * ppp,
            text: Text::new("view-overlap").with(&values!["depth" => scale::length(overlap.depth)]),
            size: TEXT * ppp,
            color: palette.ink,
            plate: palette.plate,
            directions: BESIDE.to_vec(),
        })
    };
    moment.overlaps.iter().filter_map(label).flat_map(|label| placer.place(&label)).collect()
}

/// The block of a body as drawn.
fn block(input: &ViewInput<'_>, moment: &Moment, body: SolidId) -> Option<Block> {
    match body {
        SolidId::Girder(number) => girder_block_at(input.scene, moment, number),
        SolidId::Abutment(number) => walls::block(input.scene, number, moment.wall(number)),
    }
}

fn shared(input: &ViewInput<'_>, moment: &Moment, overlap: &OverlapNow) -> Option<Shared> {
    let [one, other] = overlap.bodies.map(|body| block(input, moment, body));
    let (one, other) = (one?, other?);
    let [here, there] = [&one, &other].map(outline);
    let top = |block: &Block| block.corners().into_iter().map(|corner| corner.z).fold(f64::NEG_INFINITY, f64::max);
    let centre = common_centre(&here, &there)?.extend(top(&one).min(top(&other)));
    Some(Shared { area: common_area(&here, &there), centre })
}

/// Corners of a block's outline in plan, one after another: the upper edge of its face, then that of the opposite one.
fn outline(block: &Block) -> [DVec2; 4] {
    let [a, b] = upper_edge(block);
    [a, b, b + block.sweep, a + block.sweep].map(DVec3::truncate)
}

/// The horizontal edge of a block's face that lies higher, or one that does not stand upright.
fn upper_edge(block: &Block) -> [DVec3; 2] {
    let edges: [[DVec3; 2]; 4] = std::array::from_fn(|i| [block.face[i], block.face[(i + 1) % 4]]);
    let height = |[a, b]: &[DVec3; 2]| a.z + b.z;
    edges.into_iter().reduce(|a, b| if height(&b) > height(&a) { b } else { a }).unwrap_or(edges[0])
}

fn area_lines(input: &ViewInput<'_>, shared: &Shared) -> Vec<Line> {
    let ppp = input.pixels_per_point;
    let z = shared.centre.z;
    let line = |from: DVec2, to: DVec2, width: f32| Line {
        group: "overlap",
        from: from.extend(z).as_vec3(),
        to: to.extend(z).as_vec3(),
        width: width * ppp,
        color: OVERLAP,
    };
    let ends = (0..shared.area.len()).map(|i| (shared.area[i], shared.area[(i + 1) % shared.area.len()]));
    let outline = ends.clone().map(|(from, to)| line(from, to, OUTLINE));
    // At 45° to the axes, so that the hatching is parallel to no straight bridge's edge.
    let across = DVec2::from_angle(FRAC_PI_4);
    let offsets = shared.area.iter().map(|corner| corner.dot(across));
    let [low, high] = offsets.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], s| [low.min(s), high.max(s)]);
    let hatch = (1..=HATCH_LINES).filter_map(|k| {
        let offset = low + (high - low) * f64::from(k) / f64::from(HATCH_LINES + 1);
        let crossing = |(from, to): (DVec2, DVec2)| {
            let [a, b] = [from, to].map(|corner| corner.dot(across) - offset);
            ((a < 0.0) != (b < 0.0)).then(|| from.lerp(to, a / (a - b)))
        };
        let mut crossings = ends.clone().filter_map(crossing);
        Some(line(crossings.next()?, crossings.next()?, HATCH))
    });
    outline.chain(hatch).collect()
}
