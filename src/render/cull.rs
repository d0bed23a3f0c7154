//! Visible part of a draw list: instances that the view does not reach are neither uploaded nor drawn.
//!
//! An instance goes when all of it lies beyond one of the view's four sides, or behind the eye: a test of half spaces
//! in homogeneous clip space, linear in the world, so that it holds for a hull when it holds for its corners. Whatever
//! is in doubt stays. A solid that is not seen may still throw its shadow into the picture: it stays for the shadow map
//! while the volume between it and its shadow reaches the view. The picture is the same to the last bit.

use glam::{Mat4, Vec2, Vec3, Vec4};

use super::made::Thing;
use super::{Gpu, Quality};
use crate::view::DrawList;
use crate::view::list::{Arrow, Cone, Line, Mark, Solid};

/// How far beyond a side something may still touch the picture by rounding or smoothing \[pixels\].
pub(super) const MARGIN: f32 = 4.0;
/// Widest part of an arrow with its rim, in radii of its shaft (`HEAD_RADIUS` and the rim of `shaders/arrow.wgsl`).
pub(super) const ARROW_REACH: f32 = 5.0;
/// How far a shadow reaches beyond its caster's outline: look-ups beside the point and the lift off its surface, in
/// texels of the map.
const SHADOW_REACH: f32 = 8.0;
/// Share of its distance from the middle of the scene by which a place on a body's surface may round, where a shader asks for it \[–\].
const NEARNESS_ROUNDING: f32 = 1e-4;

/// The instances of a list that a picture needs, in the list's order but for the solids.
#[derive(Debug, Default)]
pub(super) struct Seen<'l> {
    /// Those that hide whatever is behind them first.
    pub(super) solids: Vec<&'l Solid>,
    /// How many of the solids do.
    pub(super) opaque: usize,
    /// Solids out of view whose shadow may fall into it.
    pub(super) casters: Vec<&'l Solid>,
    pub(super) ghosts: Vec<&'l Solid>,
    pub(super) lines: Vec<&'l Line>,
    pub(super) xray_lines: Vec<&'l Line>,
    pub(super) cones: Vec<&'l Cone>,
    pub(super) arrows: Vec<&'l Arrow>,
    pub(super) marks: Vec<&'l Mark>,
}

impl<'l> Seen<'l> {
    /// Everything, seen or not: what culling is measured against.
    pub(super) fn all(list: &'l DrawList) -> Self {
        let (solids, opaque) = opaque_first(list.solids.iter().collect(), list);
        Self {
            solids,
            opaque,
            casters: Vec::new(),
            ghosts: list.ghosts.iter().collect(),
            lines: list.lines.iter().collect(),
            xray_lines: list.xray_lines.iter().collect(),
            cones: list.cones.iter().collect(),
            arrows: list.arrows.iter().collect(),
            marks: list.marks.iter().collect(),
        }
    }

    /// Instances that reach a picture of `size` pixels.
    pub(super) fn of(list: &'l DrawList, size: [u32; 2], quality: Quality) -> Self {
        let view = |margin| View::new(list.frame.clip_from_world, size, margin);
        let bodies = view(MARGIN);
        let (solids, hidden): (Vec<_>, Vec<_>) = list.solids.iter().partition(|s| bodies.reaches(&corners(s), 0.0));
        let (solids, opaque) = opaque_first(solids, list);
        let shade = Shade::of(list, quality);
        let widest = list.lines.iter().chain(&list.xray_lines).map(|l| l.width).fold(0.0, f32::max);
        let strokes = view(MARGIN + widest);
        let line = |l: &&Line| strokes.reaches(&[l.from, l.to], 0.0);
        Self {
            casters: hidden.into_iter().filter(|s| bodies.reaches(&shade.volume(s), shade.reach)).collect(),
            solids,
            opaque,
            ghosts: list.ghosts.iter().filter(|s| bodies.reaches(&corners(s), 0.0)).collect(),
            lines: list.lines.iter().filter(line).collect(),
            xray_lines: list.xray_lines.iter().filter(line).collect(),
            cones: list.cones.iter().filter(|c| bodies.reaches(&cone_ends(c), cone_reach(c))).collect(),
            arrows: list.arrows.iter().filter(|a| bodies.reaches(&[a.from, a.to], ARROW_REACH * a.radius)).collect(),
            marks: list.marks.iter().filter(|m| mark_reaches(m, size)).collect(),
        }
    }

    /// Counts what is drawn of the list and what is left out.
    pub(super) fn count(&self, gpu: &Gpu, list: &DrawList) {
        let all = [
            ("solids", self.solids.len(), list.solids.len()),
            ("ghosts", self.ghosts.len(), list.ghosts.len()),
            ("lines", self.lines.len(), list.lines.len()),
            ("lines seen through", self.xray_lines.len(), list.xray_lines.len()),
            ("cones", self.cones.len(), list.cones.len()),
            ("arrows", self.arrows.len(), list.arrows.len()),
            ("marks", self.marks.len(), list.marks.len()),
        ];
        for (label, seen, whole) in all {
            gpu.count(Thing::Drawn, label, seen);
            gpu.count(Thing::Culled, label, whole - seen);
        }
        gpu.count(Thing::Drawn, "casters", self.casters.len());
    }
}

/// Solids with those first that hide whatever is behind them, and how many these are.
fn opaque_first<'l>(solids: Vec<&'l Solid>, list: &DrawList) -> (Vec<&'l Solid>, usize) {
    let (mut solids, fading): (Vec<_>, Vec<_>) = solids.into_iter().partition(|solid| is_opaque(solid, list));
    let opaque = solids.len();
    solids.extend(fading);
    (solids, opaque)
}

/// Whether no part of a solid lets anything through, by its colour or because it is far from the scene.
fn is_opaque(solid: &Solid, list: &DrawList) -> bool {
    // Places between the corners round.
    let near = list.frame.fade[0] * (1.0 - NEARNESS_ROUNDING);
    let is_near = |corner: &Vec3| corner.truncate().distance(list.frame.middle) <= near;
    solid.color.0[3] == u8::MAX && corners(solid).iter().all(is_near)
}

/// The half spaces that a view lies in: a point is inside where the product with each is not negative.
struct View([Vec4; 5]);

impl View {
    fn new(clip_from_world: Mat4, size: [u32; 2], margin: f32) -> Self {
        let [x, y, _, w] = [0, 1, 2, 3].map(|i| clip_from_world.row(i));
        let [wide, high] = size.map(|side| 1.0 + 2.0 * margin / side.max(1) as f32);
        Self([w * wide + x, w * wide - x, w * high + y, w * high - y, w])
    }

    /// Whether the hull of some points, grown by `reach`, may lie in the view; so it may where a number is not finite.
    fn reaches(&self, points: &[Vec3], reach: f32) -> bool {
        !self.0.iter().any(|side| {
            let least = -reach * side.truncate().length();
            points.iter().all(|p| side.dot(p.extend(1.0)) < least)
        })
    }
}

pub(super) fn corners(solid: &Solid) -> [Vec3; 8] {
    let [a, b, c, d] = solid.face;
    [a, b, c, d, a + solid.sweep, b + solid.sweep, c + solid.sweep, d + solid.sweep]
}

/// Where shadows fall.
pub(super) struct Shade {
    /// Unit vector away from the light, and how low anything is that a shadow can fall on \[m\].
    away: Vec3,
    pub(super) lowest: f32,
    /// How far a shadow reaches beyond its caster's outline \[m\].
    pub(super) reach: f32,
}

impl Shade {
    pub(super) fn of(list: &DrawList, quality: Quality) -> Self {
        let ground = list.ground.map_or(f32::INFINITY, |g| g.centre.z);
        let bodies = list.solids.iter().chain(&list.ghosts).flat_map(corners);
        let texel = list.frame.light_width / quality.shadow_map_size() as f32;
        Self {
            away: -list.frame.towards_light,
            lowest: bodies.map(|p| p.z).fold(ground, f32::min),
            reach: SHADOW_REACH * texel,
        }
    }

    /// Corners of the volume between a solid and its shadow.
    pub(super) fn volume(&self, solid: &Solid) -> [Vec3; 16] {
        let near = corners(solid);
        let down = |p: Vec3| p + self.away * ((self.lowest - p.z) / self.away.z).max(0.0);
        std::array::from_fn(|i| if i < 8 { near[i] } else { down(near[i - 8]) })
    }
}

pub(super) fn cone_ends(cone: &Cone) -> [Vec3; 2] {
    [cone.apex, cone.apex + cone.axis * cone.height]
}

pub(super) fn cone_reach(cone: &Cone) -> f32 {
    cone.height * cone.mu_kinetic
}

/// Whether a glyph may lie in the picture; other marks are placed inside it, or few.
fn mark_reaches(mark: &Mark, size: [u32; 2]) -> bool {
    let (at, reach) = match mark {
        Mark::Disk { at, radius, .. } => (*at, 2.0 * radius),
        Mark::Ring { at, radius, width, .. } | Mark::Cross { at, radius, width, .. } => (*at, 2.0 * (radius + width)),
        _ => return true,
    };
    let far = Vec2::from(size.map(|side| side as f32)) + reach + MARGIN;
    !(at.cmplt(Vec2::splat(-reach - MARGIN)).any() || at.cmpgt(far).any())
}
