//! Where two frames differ.
//!
//! A pixel is what the shapes over it make of it, in their order. Where all shapes that differ are left out of both lists the two are
//! the same list; so a pixel under none of those that differ stays as it is.

use std::sync::Arc;

use egui::epaint::{ClippedShape, Primitive, TextShape};
use egui::{Context, Rect, Shape};

use crate::render::{Region, Regions};

/// How many shapes ahead, in both lists together, shapes are looked for that are the same again: 2000 comparisons at the most.
const AHEAD: usize = 64;

/// Two lists of shapes in comparison.
pub(super) struct Differing<'a> {
    pub(super) context: &'a Context,
    pub(super) changes: &'a [(Rect, Regions)],
    /// Width and height of the window \[pixels\], and pixels to a point.
    pub(super) of: ([u32; 2], f32),
}

impl Differing<'_> {
    /// Where they differ.
    pub(super) fn regions(&self, before: &[ClippedShape], now: &[ClippedShape]) -> Regions {
        let mut regions = Regions::default();
        let (mut i, mut j) = (0, 0);
        while let (Some(old), Some(new)) = (before.get(i), now.get(j)) {
            if self.is_same(old, new, &mut regions) {
                (i, j) = (i + 1, j + 1);
                continue;
            }
            let (next_i, next_j) =
                self.again(&before[i..], &now[j..]).map_or((before.len(), now.len()), |(a, b)| (i + a, j + b));
            self.add(&before[i..next_i], &mut regions);
            self.add(&now[j..next_j], &mut regions);
            (i, j) = (next_i, next_j);
        }
        self.add(before.get(i..).unwrap_or_default(), &mut regions);
        self.add(now.get(j..).unwrap_or_default(), &mut regions);
        regions
    }

    /// Adds where a shape differs from the one in its place.
    pub(super) fn add_changes(&self, old: &ClippedShape, new: &ClippedShape, regions: &mut Regions) {
        if !self.is_same(old, new, regions) {
            self.add(&[old.clone(), new.clone()], regions);
        }
    }

    /// How many shapes of either list come before two that are the same: the fewest within reach, else as many as leave ends that
    /// are the same.
    fn again(&self, before: &[ClippedShape], now: &[ClippedShape]) -> Option<(usize, usize)> {
        let mut none = Regions::default();
        let near = (1..=AHEAD).flat_map(|both| (0..=both).map(move |one| (one, both - one)));
        let mut near = near.filter(|(i, j)| *i < before.len() && *j < now.len());
        let found = near.find(|(i, j)| self.is_same(&before[*i], &now[*j], &mut none));
        found.or_else(|| {
            let pairs = before.iter().rev().zip(now.iter().rev());
            let same = pairs.take_while(|(old, new)| self.is_same(old, new, &mut none)).count();
            (same > 0).then(|| (before.len() - same, now.len() - same))
        })
    }

    /// Whether two shapes are the same; what changes in a picture that stays in its place is added.
    fn is_same(&self, old: &ClippedShape, new: &ClippedShape, regions: &mut Regions) -> bool {
        if old.clip_rect != new.clip_rect || old.transform_after_tessellation != new.transform_after_tessellation {
            return false;
        }
        match (&old.shape, &new.shape) {
            // Laid out once and kept: the same place in memory, mostly.
            (Shape::Text(old), Shape::Text(new)) if Arc::ptr_eq(&old.galley, &new.galley) => is_same_text(old, new),
            (Shape::Mesh(old), Shape::Mesh(new)) => Arc::ptr_eq(old, new) || old == new,
            (Shape::Callback(old), Shape::Callback(new)) if old.rect == new.rect && old != new => {
                let changes = self.changes.iter().find(|(rect, _)| *rect == new.rect);
                let corner = self.pixels(new.rect).map_or([0, 0], |region| region.min);
                changes.inspect(|(_, parts)| regions.extend(parts.iter().map(|part| part.moved(corner)))).is_some()
            }
            (old, new) => old == new,
        }
    }

    /// Adds where shapes are drawn.
    fn add(&self, shapes: &[ClippedShape], regions: &mut Regions) {
        for shape in shapes {
            for job in self.context.tessellate(vec![shape.clone()], self.of.1) {
                let drawn = match &job.primitive {
                    Primitive::Mesh(mesh) => mesh.calc_bounds(),
                    Primitive::Callback(callback) => callback.rect,
                };
                // A scissor rectangle is rounded to whole pixels: by less than one.
                regions.extend(self.pixels(drawn.intersect(job.clip_rect.expand(1.0 / self.of.1))));
            }
        }
    }

    /// The pixels that a rectangle touches.
    fn pixels(&self, rect: Rect) -> Option<Region> {
        let (size, scale) = self.of;
        Region::of([rect.min.x * scale, rect.min.y * scale], [rect.max.x * scale, rect.max.y * scale], size)
    }
}

/// Whether two texts of one layout are drawn alike.
fn is_same_text(old: &TextShape, new: &TextShape) -> bool {
    let look = |text: &TextShape| (text.underline, text.override_text_color, text.fallback_color);
    old.pos == new.pos && look(old) == look(new) && old.opacity_factor == new.opacity_factor && old.angle == new.angle
}
