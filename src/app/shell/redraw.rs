//! Regions of a frame to draw: the shapes of the frame before and of this one are compared, and only regions of the window in which they
//! differ are drawn anew, over the pixels that are there.

use egui::epaint::ClippedShape;
use egui::{
    ClippedPrimitive, Color32, Context, CornerRadius, PaintCallback, Rect, Shape, TextureId, TexturesDelta, pos2,
};

use crate::app::shell::differing::Differing;
use crate::render::{Region, Regions};

/// How far a shape may be drawn beyond its own bounds: smoothed edges and the corners of strokes \[points, and widths of the stroke\].
const BEYOND: f32 = 3.0;
/// How far from its sides a rectangle may be smoothed \[points\].
const EDGE: f32 = 2.0;
/// How far a clip rectangle may begin inside a pixel that it does not cut off: a scissor rectangle is rounded to the nearest \[pixels\].
const CLIPPED: f32 = 0.49;

/// One frame to be shown.
pub(in crate::app) struct Frame<'a> {
    pub(in crate::app) context: &'a Context,
    pub(in crate::app) shapes: Vec<ClippedShape>,
    pub(in crate::app) pixels_per_point: f32,
    /// Textures that change with it.
    pub(in crate::app) textures: &'a TexturesDelta,
    /// Of pictures that are other ones than in the frame before: where each is \[points\], and what changes in it \[pixels of its own\].
    pub(in crate::app) changes: &'a [(Rect, Regions)],
}

/// Regions of a frame to draw.
pub(in crate::app) enum Redraw {
    /// Nothing: it is there already.
    Nothing,
    /// This, over the frame before, where it differs.
    Parts(Vec<ClippedPrimitive>, Regions),
    /// This, over nothing.
    Whole(Vec<ClippedPrimitive>),
}

impl Redraw {
    /// Triangles and paint callbacks.
    pub(in crate::app) fn jobs(&self) -> &[ClippedPrimitive] {
        match self {
            Self::Nothing => &[],
            Self::Parts(jobs, _) | Self::Whole(jobs) => jobs,
        }
    }

    /// Where a target of this size shows something else than before.
    pub(in crate::app) fn parts(&self, size: [u32; 2]) -> Regions {
        match self {
            Self::Nothing => Regions::default(),
            Self::Parts(_, regions) => regions.clone(),
            Self::Whole(_) => Regions::whole(size),
        }
    }
}

/// The frame that a target shows.
#[derive(Default)]
pub(in crate::app) struct Shown {
    shapes: Vec<ClippedShape>,
    /// Of what size, at how many pixels to a point; none when it is not known what is shown.
    of: Option<([u32; 2], f32)>,
}

impl Shown {
    /// Marks the shown frame as unknown: the next one is drawn whole.
    pub(in crate::app) fn forget(&mut self) {
        self.of = None;
    }

    /// Whether it is known what a target of this size shows \[pixels\].
    pub(in crate::app) fn is_of(&self, size: [u32; 2]) -> bool {
        self.of.is_some_and(|of| of.0 == size)
    }

    /// Regions to draw so that this frame is shown on a target of this size \[pixels\]; it counts as shown from here on. `in_parts`:
    /// whether the target keeps the pixels of the frame before.
    pub(in crate::app) fn show(&mut self, frame: Frame<'_>, size: [u32; 2], in_parts: bool) -> Redraw {
        if is_seen_changing(frame.textures) {
            self.forget();
        }
        let of = (size, frame.pixels_per_point);
        let mut shapes = Vec::with_capacity(frame.shapes.len());
        frame.shapes.into_iter().for_each(|shape| flatten(shape, &mut shapes));
        let before = std::mem::replace(self, Self { shapes, of: Some(of) });
        let changed = (before.of == Some(of)).then(|| {
            let differing = Differing { context: frame.context, changes: frame.changes, of };
            differing.regions(&before.shapes, &self.shapes)
        });
        self.redraw(frame.context, changed, of, in_parts)
    }

    /// Regions to draw so that other pictures are shown in the frame that a target of this size shows; `None` where that frame is not
    /// known. `changes` and `in_parts` as in a frame.
    pub(in crate::app) fn show_pictures(
        &mut self,
        context: &Context,
        (pictures, changes): (&[PaintCallback], &[(Rect, Regions)]),
        size: [u32; 2],
        in_parts: bool,
    ) -> Option<Redraw> {
        let of = self.of.filter(|of| of.0 == size)?;
        let differing = Differing { context, changes, of };
        let mut regions = Regions::default();
        for shown in &mut self.shapes {
            let Shape::Callback(before) = &shown.shape else { continue };
            let Some(now) = pictures.iter().find(|now| now.rect == before.rect) else { continue };
            let next = ClippedShape { shape: now.clone().into(), ..*shown };
            differing.add_changes(shown, &next, &mut regions);
            *shown = next;
        }
        Some(self.redraw(context, Some(regions), of, in_parts))
    }

    /// How what is known to be shown is drawn where it differs from what a target shows; everywhere where nothing is said.
    fn redraw(
        &self,
        context: &Context,
        changed: Option<Regions>,
        of @ (size, pixels_per_point): ([u32; 2], f32),
        in_parts: bool,
    ) -> Redraw {
        match changed {
            Some(regions) if regions.is_empty() => Redraw::Nothing,
            Some(regions) if in_parts && regions.are_a_part_of(size) => {
                Redraw::Parts(self.jobs(context, &regions, of), regions)
            }
            _ => Redraw::Whole(context.tessellate(self.shapes.clone(), pixels_per_point)),
        }
    }

    /// Whatever of the frame lies in some regions, cut at their sides.
    fn jobs(
        &self,
        context: &Context,
        regions: &Regions,
        (size, pixels_per_point): ([u32; 2], f32),
    ) -> Vec<ClippedPrimitive> {
        let reaches: Vec<Rect> = self.shapes.iter().map(reach).collect();
        let mut jobs = Vec::new();
        for region in regions.iter() {
            let cut = points(region, pixels_per_point);
            // Whatever lies under something opaque is not seen.
            let covering = self.shapes.iter().rposition(|shape| covers(shape, cut, pixels_per_point));
            let ground = covering.is_none().then(|| {
                let everything = points(Region::whole(size), pixels_per_point).expand(BEYOND);
                clipped(everything, Shape::rect_filled(everything, CornerRadius::ZERO, Color32::BLACK))
            });
            let first = covering.unwrap_or(0);
            let over = self.shapes[first..].iter().zip(&reaches[first..]).filter(|(_, reach)| reach.intersects(cut));
            let shapes: Vec<_> = ground.into_iter().chain(over.map(|(shape, _)| shape.clone())).collect();
            // Cut after they are triangles: what is left out of these must not depend on the region.
            let triangles = context.tessellate(shapes, pixels_per_point);
            let cut =
                triangles.into_iter().map(|job| ClippedPrimitive { clip_rect: job.clip_rect.intersect(cut), ..job });
            jobs.extend(cut.filter(|job| job.clip_rect.is_positive()));
        }
        jobs
    }
}

/// Whether textures change that are shown already; of the letters' one, what is new is not.
#[expect(clippy::iter_over_hash_type, reason = "asked of each by itself")]
fn is_seen_changing(delta: &TexturesDelta) -> bool {
    for (id, images) in &delta.set {
        if *id != TextureId::default() || images.iter().any(|image| image.pos.is_none()) {
            return true;
        }
    }
    false
}

fn clipped(clip_rect: Rect, shape: Shape) -> ClippedShape {
    ClippedShape { clip_rect, shape, transform_after_tessellation: egui::emath::TSTransform::IDENTITY }
}

/// Shapes in shapes, one by one.
fn flatten(shape: ClippedShape, into: &mut Vec<ClippedShape>) {
    match shape.shape {
        Shape::Noop => {}
        Shape::Vec(shapes) => {
            for inner in shapes {
                flatten(ClippedShape { shape: inner, ..shape }, into);
            }
        }
        _ => into.push(shape),
    }
}

/// A region in points; cut at it, a scissor rectangle of whole pixels is the region again.
fn points(region: Region, pixels_per_point: f32) -> Rect {
    let place = |[x, y]: [u32; 2]| pos2(x as f32 / pixels_per_point, y as f32 / pixels_per_point);
    Rect::from_min_max(place(region.min), place(region.max))
}

/// Where a shape may be drawn \[points\].
fn reach(shape: &ClippedShape) -> Rect {
    let own = if shape.transform_after_tessellation == egui::emath::TSTransform::IDENTITY {
        shape.shape.visual_bounding_rect().expand(BEYOND * (1.0 + stroke(&shape.shape)))
    } else {
        Rect::EVERYTHING
    };
    own.intersect(shape.clip_rect)
}

/// Width of a shape's stroke \[points\].
fn stroke(shape: &Shape) -> f32 {
    match shape {
        Shape::Path(path) => path.stroke.width,
        Shape::LineSegment { stroke, .. } => stroke.width,
        Shape::Rect(rect) => rect.stroke.width + rect.blur_width,
        Shape::Circle(circle) => circle.stroke.width,
        Shape::Ellipse(ellipse) => ellipse.stroke.width,
        Shape::QuadraticBezier(curve) => curve.stroke.width,
        Shape::CubicBezier(curve) => curve.stroke.width,
        Shape::Band(band) => band.stroke.width,
        Shape::Noop | Shape::Vec(_) | Shape::Text(_) | Shape::Mesh(_) | Shape::Callback(_) => 0.0,
    }
}

/// Whether nothing under a shape is seen in a part of the window, of whole pixels.
fn covers(shape: &ClippedShape, part: Rect, pixels_per_point: f32) -> bool {
    if !shape.clip_rect.expand(CLIPPED / pixels_per_point).contains_rect(part) {
        return false;
    }
    match &shape.shape {
        Shape::Rect(rect) => {
            let plain = rect.corner_radius == CornerRadius::ZERO && rect.blur_width == 0.0 && rect.angle == 0.0;
            let opaque = rect.fill.is_opaque() && rect.brush.is_none();
            let moved = shape.transform_after_tessellation != egui::emath::TSTransform::IDENTITY;
            plain && opaque && !moved && rect.rect.shrink(EDGE + rect.stroke.width).contains_rect(part)
        }
        // Pictures are opaque.
        Shape::Callback(callback) => callback.rect.contains_rect(part),
        _ => false,
    }
}

#[cfg(test)]
mod tests;
