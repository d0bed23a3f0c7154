//! Where the pictures of two lists differ: around what is in one and not in the other, and around its shadow.
//!
//! Items are compared in their order, from both ends of a list; what lies between is different. A pixel under nothing that differs is
//! made by the same items in the same order. Bounds are those of hulls in clip space, grown by what smoothing, widths and the look-ups
//! of the shadow map add; where a bound goes behind the eye, all may be different.

use glam::{Mat4, Vec2, Vec3, Vec4, Vec4Swizzles as _};

use super::cull::{ARROW_REACH, MARGIN, Shade, cone_ends, cone_reach, corners};
use super::letters::width_bound;
use super::{Quality, Region, Regions};
use crate::view::DrawList;
use crate::view::list::{Line, Mark, Solid};

/// A line of text is no higher than this, in heights of the font: 1.15 in the usual one, 1.45 with Japanese letters.
const LINE: f32 = 1.5;
/// A plate reaches no farther around it than this, in heights of the font: 0.32 (`Flat::text`).
const PLATE: f32 = 0.4;

/// Where the pictures of two lists differ, drawn as coarsely as any.
pub fn changes(before: &DrawList, now: &DrawList) -> Regions {
    let mut regions = Regions::default();
    let whole = Region::whole(now.size);
    let alike = before.size == now.size && before.pixels_per_point == now.pixels_per_point;
    if !(alike && before.frame == now.frame && before.ground == now.ground) {
        regions.add(whole);
        return regions;
    }
    let sight = Sight { clip_from_world: now.frame.clip_from_world, size: now.size };
    let lift = now.frame.lift;
    for (list, other) in [(before, now), (now, before)] {
        let shade = Shade::of(list, Quality::DRAFT);
        let solid = |s: &Solid| sight.hull(&shade.volume(s), shade.reach, MARGIN);
        let ghost = |s: &Solid| sight.hull(&corners(s), 0.0, MARGIN);
        let line = |l: &Line| sight.hull(&[l.from, l.to], lift, MARGIN + l.width);
        let of = [
            bounds(&list.solids, &other.solids, solid),
            bounds(&list.ghosts, &other.ghosts, ghost),
            bounds(&list.lines, &other.lines, line),
            bounds(&list.xray_lines, &other.xray_lines, line),
            bounds(&list.cones, &other.cones, |c| sight.hull(&cone_ends(c), cone_reach(c), MARGIN)),
            bounds(&list.arrows, &other.arrows, |a| sight.hull(&[a.from, a.to], ARROW_REACH * a.radius, MARGIN)),
            bounds(&list.marks, &other.marks, flat),
        ];
        for bound in of.into_iter().flatten() {
            match bound {
                Bound::Anywhere => regions.add(whole),
                Bound::Within(min, max) => regions.extend(Region::of(min.to_array(), max.to_array(), now.size)),
            }
        }
    }
    regions
}

/// Where the shadow maps of two lists differ \[texels\]; none where that is not known, and all is drawn anew.
pub(super) fn shadow_changes(before: &DrawList, now: &DrawList, quality: Quality) -> Option<Regions> {
    let side = quality.shadow_map_size();
    let lit = before.ground.is_some() && now.ground.is_some();
    // A body that throws no shadow into the view is not in the map: which these are depends on how low a shadow may fall.
    let lowest = |list| Shade::of(list, quality).lowest.to_bits();
    if !(lit && before.frame == now.frame && before.size == now.size && lowest(before) == lowest(now)) {
        return None;
    }
    let sight = Sight { clip_from_world: now.frame.light_from_world, size: [side; 2] };
    let mut regions = Regions::default();
    for (list, other) in [(before, now), (now, before)] {
        for bound in bounds(&list.solids, &other.solids, |s| sight.hull(&corners(s), 0.0, 1.0)) {
            let Bound::Within(min, max) = bound else { return None };
            regions.extend(Region::of(min.to_array(), max.to_array(), sight.size));
        }
    }
    Some(regions)
}

/// Where something may be drawn.
enum Bound {
    Anywhere,
    /// Pixels.
    Within(Vec2, Vec2),
}

/// Bounds of what is in a list and not in the other.
fn bounds<T: PartialEq>(list: &[T], other: &[T], bound: impl Fn(&T) -> Bound) -> Vec<Bound> {
    if list.len() == other.len() {
        let differing = list.iter().zip(other).filter(|(item, other)| item != other);
        return differing.map(|(item, _)| bound(item)).collect();
    }
    let before = list.iter().zip(other).take_while(|(item, other)| item == other).count();
    let (list, other) = (&list[before..], &other[before..]);
    let after = list.iter().rev().zip(other.iter().rev()).take_while(|(item, other)| item == other).count();
    list[..list.len() - after].iter().map(bound).collect()
}

/// A camera and a picture.
struct Sight {
    clip_from_world: Mat4,
    size: [u32; 2],
}

impl Sight {
    /// Where the hull of some points may be drawn, grown by a reach \[m\] and a margin \[pixels\].
    fn hull(&self, points: &[Vec3], reach: f32, margin: f32) -> Bound {
        let rows = [0, 1, 3].map(|i| self.clip_from_world.row(i).xyz().length() * reach);
        let half = Vec2::from(self.size.map(|side| 0.5 * side as f32));
        let (mut min, mut max) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
        for point in points {
            let clip: Vec4 = self.clip_from_world * point.extend(1.0);
            let near = clip.w - rows[2];
            if near.is_nan() || near <= 1e-3 * clip.w.abs() {
                return Bound::Anywhere;
            }
            let at = clip.xy() / clip.w;
            // (x + dx) / (w + dw) - x / w = (dx - x / w dw) / (w + dw).
            let aside = (Vec2::new(rows[0], rows[1]) + at.abs() * rows[2]) / near;
            let pixels = Vec2::new(at.x + 1.0, 1.0 - at.y) * half;
            min = min.min(pixels - aside * half);
            max = max.max(pixels + aside * half);
        }
        Bound::Within(min - margin, max + margin)
    }
}

/// Where something flat may be drawn.
fn flat(mark: &Mark) -> Bound {
    let about = |at: Vec2, reach: f32| Bound::Within(at - reach - MARGIN, at + reach + MARGIN);
    let around = |points: &[Vec2], reach: f32| {
        let low = points.iter().copied().fold(Vec2::INFINITY, Vec2::min);
        let high = points.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
        Bound::Within(low - reach - MARGIN, high + reach + MARGIN)
    };
    match mark {
        Mark::Text { at, align, size, text, .. } => {
            let extent = Vec2::new(width_bound(text, *size), LINE * size);
            let corner = *at - *align * extent;
            let beyond = PLATE * size + MARGIN;
            Bound::Within(corner - beyond, corner + extent + beyond)
        }
        Mark::Disk { at, radius, .. } => about(*at, 2.0 * radius),
        Mark::Ring { at, radius, width, .. } | Mark::Cross { at, radius, width, .. } => {
            about(*at, 2.0 * (radius + width))
        }
        Mark::Stroke { points, width, .. } => around(points, 2.0 * width),
        Mark::Fill { points, .. } => around(points, 0.0),
        Mark::Panel { min, max, .. } => around(&[*min, *max], 1.0),
    }
}
