//! Marks to triangles: text laid out and shapes smoothed by epaint.

use epaint::emath::{Align, pos2, vec2};
use epaint::text::{FontData, FontDefinitions, Fonts, LayoutJob, TextFormat, TextOptions, ViewportKey};
use epaint::{
    CircleShape, Color32, CornerRadius, FontFamily, FontId, ImageDelta, Mesh, PathShape, Pos2, Rect, RectShape, Shape,
    Stroke, StrokeKind, TessellationOptions, Tessellator, TextShape,
};
use glam::Vec2;

use super::letters::fonts;
use crate::language::{JAPANESE_FONT, is_japanese};
use crate::view::list::{Mark, Rgba};

/// Fonts and the way from marks to triangles. All lengths are pixels.
pub(super) struct Flat {
    fonts: Fonts,
    /// Whether the fonts have Japanese letters: from the first text on that has one.
    has_japanese: bool,
}

fn color(Rgba([r, g, b, a]): Rgba) -> Color32 {
    Color32::from_rgba_unmultiplied(r, g, b, a)
}

fn pos(p: Vec2) -> Pos2 {
    pos2(p.x, p.y)
}

/// The usual font, and Japanese letters where it lacks one.
fn with_japanese() -> FontDefinitions {
    let mut fonts = fonts();
    fonts.font_data.insert("japanese".to_owned(), FontData::from_static(JAPANESE_FONT).into());
    fonts.families.entry(FontFamily::Proportional).or_default().push("japanese".to_owned());
    fonts
}

impl Flat {
    pub(super) fn new() -> Self {
        Self { fonts: Fonts::new(TextOptions::default(), fonts()), has_japanese: false }
    }

    /// One mesh of all marks, in their order.
    pub(super) fn mesh(&mut self, marks: &[&Mark]) -> Mesh {
        let japanese = |mark: &&Mark| matches!(mark, Mark::Text { text, .. } if text.chars().any(is_japanese));
        if !self.has_japanese && marks.iter().any(japanese) {
            self.fonts = Fonts::new(TextOptions::default(), with_japanese());
            self.has_japanese = true;
        }
        self.fonts.begin_pass(TextOptions::default(), ViewportKey::default());
        let shapes: Vec<Shape> = marks.iter().flat_map(|mark| self.shapes(mark)).collect();
        let atlas = self.fonts.texture_atlas();
        let options = TessellationOptions::default();
        let mut tessellator = Tessellator::new(1.0, options, atlas.size(), atlas.prepared_discs());
        let mut mesh = Mesh::default();
        for shape in shapes {
            tessellator.tessellate_shape(shape, &mut mesh);
        }
        mesh
    }

    /// Change of the font atlas since the last call.
    pub(super) fn atlas_change(&mut self) -> Option<ImageDelta> {
        self.fonts.font_image_delta()
    }

    fn shapes(&mut self, mark: &Mark) -> Vec<Shape> {
        match mark {
            Mark::Text { at, align, size, text, color, plate } => self.text(*at, *align, *size, text, *color, *plate),
            Mark::Disk { at, radius, color, halo } => disk(*at, *radius, *color, *halo),
            Mark::Ring { at, radius, width, color, halo } => ring(*at, *radius, *width, *color, *halo),
            Mark::Cross { at, radius, width, color, halo } => cross(*at, *radius, *width, *color, *halo),
            Mark::Stroke { points, width, color } => vec![stroke(points, *width, *color)],
            Mark::Fill { points, color: c } => {
                let points = points.iter().copied().map(pos).collect();
                vec![PathShape::convex_polygon(points, color(*c), Stroke::NONE).into()]
            }
            Mark::Panel { min, max, color: c, rim } => {
                let rect = Rect::from_min_max(pos(*min), pos(*max));
                let rim = Stroke::new(1.0, color(*rim));
                vec![RectShape::new(rect, CornerRadius::same(6), color(*c), rim, StrokeKind::Inside).into()]
            }
        }
    }

    fn text(&mut self, at: Vec2, align: Vec2, size: f32, text: &str, ink: Rgba, plate: Option<Rgba>) -> Vec<Shape> {
        let job = layout(text, size, color(ink));
        let galley = self.fonts.with_pixels_per_point(1.0).layout_job(job);
        let extent = galley.size();
        // Whole pixels keep the letters sharp.
        let corner = pos2((at.x - align.x * extent.x).round(), (at.y - align.y * extent.y).round());
        let backing = plate.map(|plate| {
            let rect = Rect::from_min_size(corner, extent).expand2(vec2(0.32 * size, 0.1 * size));
            RectShape::filled(rect, CornerRadius::from(0.3 * size), color(plate)).into()
        });
        let letters = TextShape::new(corner, galley, color(ink)).into();
        backing.into_iter().chain([letters]).collect()
    }
}

/// A line of text; in `μ_s` and `μ_k` the letter after the bar is a subscript.
fn layout(text: &str, size: f32, ink: Color32) -> LayoutJob {
    let format = |size: f32, valign| TextFormat { valign, ..TextFormat::simple(FontId::proportional(size), ink) };
    let mut job = LayoutJob::default();
    let mut parts = text.split("μ_");
    if let Some(first) = parts.next() {
        job.append(first, 0.0, format(size, Align::Center));
    }
    for part in parts {
        let after = part.chars().next().map_or(0, char::len_utf8);
        let (subscript, rest) = part.split_at(after);
        job.append("μ", 0.0, format(size, Align::Center));
        job.append(subscript, 0.0, format(0.72 * size, Align::BOTTOM));
        job.append(rest, 0.0, format(size, Align::Center));
    }
    job
}

fn stroke(points: &[Vec2], width: f32, c: Rgba) -> Shape {
    let points = points.iter().copied().map(pos).collect();
    PathShape::line(points, Stroke::new(width, color(c))).into()
}

/// Width of the rim around a disk, as a share of its radius.
const RIM: f32 = 0.34;
/// Width of the rims along strokes, as a share of their width.
const STROKE_RIM: f32 = 0.7;

fn disk(at: Vec2, radius: f32, c: Rgba, halo: Rgba) -> Vec<Shape> {
    let around = CircleShape::filled(pos(at), radius * (1.0 + RIM), color(halo));
    vec![around.into(), CircleShape::filled(pos(at), radius, color(c)).into()]
}

fn ring(at: Vec2, radius: f32, width: f32, c: Rgba, halo: Rgba) -> Vec<Shape> {
    let around = Stroke::new(width * (1.0 + 2.0 * STROKE_RIM), color(halo));
    vec![
        CircleShape::filled(pos(at), radius, color(halo)).into(),
        CircleShape::stroke(pos(at), radius, around).into(),
        CircleShape::stroke(pos(at), radius, Stroke::new(width, color(c))).into(),
    ]
}

fn cross(at: Vec2, radius: f32, width: f32, c: Rgba, halo: Rgba) -> Vec<Shape> {
    let arms = [Vec2::new(1.0, 1.0), Vec2::new(1.0, -1.0)].map(|d| [at - d * radius, at + d * radius]);
    let wide = width * (1.0 + 2.0 * STROKE_RIM);
    let around = arms.map(|[a, b]| stroke(&[a - (b - a) * 0.12, b + (b - a) * 0.12], wide, halo));
    around.into_iter().chain(arms.map(|arm| stroke(&arm, width, c))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::letters::width_bound;

    #[test]
    fn no_line_is_wider_than_its_bound_and_few_are_much_narrower() {
        let mut flat = Flat { fonts: Fonts::new(TextOptions::default(), with_japanese()), has_japanese: true };
        let lines = [
            "t = 1.1209 s · 2.914 periods",
            "gap 4.77 mm, least 1.34 mm square",
            "ground: sine 0.40 g, 2.6 Hz at 0°",
            "AVAVAWLTo. fi ffl, WWWMMM iiilll",
            "−12.5 kN·m, ±0.3 ‰, Σ|R|, θ² ≤ μ_s",
            "遊間 4.77 mm、最小 1.34 mm",
            "",
        ];
        for (line, size) in lines.iter().flat_map(|line| [9.0, 13.0, 15.0, 26.7, 40.0].map(|size| (line, size))) {
            let job = layout(line, size, Color32::WHITE);
            let width = flat.fonts.with_pixels_per_point(1.0).layout_job(job).size().x;
            let bound = width_bound(line, size);
            assert!(width <= bound, "{line:?} at {size}: {width} > {bound}");
            let narrow = line.is_ascii() && bound > 1.2 * width + 2.0;
            assert!(!narrow, "{line:?} at {size}: {bound} for {width}");
        }
    }
}
