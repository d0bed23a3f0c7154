//! What of a frame has to be drawn: the shapes of the frame before and of this one are compared, and only regions of the window in
//! which they differ are drawn anew, over what is there.

use egui::epaint::ClippedShape;
use egui::{ClippedPrimitive, Color32, Context, CornerRadius, Rect, Shape, TextureId, TexturesDelta, pos2};

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

/// What of a frame is drawn.
pub(in crate::app) enum Redraw {
    /// Nothing: it is there already.
    Nothing,
    /// This, over the frame before.
    Parts(Vec<ClippedPrimitive>),
    /// This, over nothing.
    Whole(Vec<ClippedPrimitive>),
}

impl Redraw {
    /// Triangles and paint callbacks.
    pub(in crate::app) fn jobs(&self) -> &[ClippedPrimitive] {
        match self {
            Self::Nothing => &[],
            Self::Parts(jobs) | Self::Whole(jobs) => jobs,
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
    /// What is shown is not known: the next frame is drawn whole.
    pub(in crate::app) fn forget(&mut self) {
        self.of = None;
    }

    /// What has to be drawn so that this frame is shown on a target of this size \[pixels\]; it counts as shown from here on.
    /// `in_parts`: whether the target keeps what was drawn on it before.
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
        match changed {
            Some(regions) if regions.is_empty() => Redraw::Nothing,
            Some(regions) if in_parts && regions.are_a_part_of(size) => {
                Redraw::Parts(self.jobs(frame.context, &regions, of))
            }
            _ => Redraw::Whole(frame.context.tessellate(self.shapes.clone(), frame.pixels_per_point)),
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
mod tests {
    use std::collections::BTreeMap;

    use egui::{Event, Key, Modifiers, PointerButton, RawInput, ViewportId, vec2};

    use super::*;
    use crate::app::bench::Workbench;
    use crate::app::command::{AppearanceCommand, EditCommand, LeaveCommand, PlaceCommand};
    use crate::app::panel::layout;
    use crate::app::shell::painter::tests::{bytes, painter};
    use crate::app::shell::painter::{Painter, Shapes};
    use crate::app::shell::textures::Textures;
    use crate::app::style::theme;
    use crate::language::Language;
    use crate::scene::{Scene, presets};
    use crate::study::stability::random::Random;

    /// Frames of a series.
    const FRAMES: u64 = 50;
    /// Time from one to the next \[s\].
    const STEP: f64 = 0.04;

    /// A window without a display, drawn in parts and whole.
    struct Both {
        bench: Workbench,
        context: Context,
        textures: Textures,
        shown: Shown,
        canvas: wgpu::Texture,
        size: [u32; 2],
        scale: f32,
        time: f64,
        /// How many frames were drawn how.
        drawn: BTreeMap<&'static str, u32>,
    }

    impl Both {
        fn resize(&mut self, painter: &Painter, size: [u32; 2], scale: f32) {
            (self.size, self.scale) = (size, scale);
            self.canvas = painter.canvas(size);
            self.shown = Shown::default();
        }

        /// Shows a frame, drawn in parts; how it differs from the same frame drawn whole.
        fn frame(&mut self, painter: &Painter, events: Vec<Event>) -> Option<String> {
            self.time += STEP;
            let points = vec2(self.size[0] as f32, self.size[1] as f32) / self.scale;
            let screen = Rect::from_min_size(pos2(0.0, 0.0), points);
            let mut input =
                RawInput { screen_rect: Some(screen), time: Some(self.time), events, ..RawInput::default() };
            input.viewports.entry(ViewportId::ROOT).or_default().native_pixels_per_point = Some(self.scale);
            let mut output = self.context.run_ui(input, |ui| layout::show(&mut self.bench, ui));
            self.bench.replay.runner.wait();
            self.textures.take_in(&output.textures_delta);
            painter.upload(&output.textures_delta);
            let (context, scale, size) = (self.context.clone(), output.pixels_per_point, self.size);
            let changes = self.bench.view.viewport.take_changes();
            let shapes = output.shapes.clone();
            let textures = &output.textures_delta;
            let frame = Frame { context: &context, shapes, pixels_per_point: scale, textures, changes: &changes };
            let redraw = self.shown.show(frame, size, true);
            let (over, how) = match &redraw {
                Redraw::Nothing => (true, "not at all"),
                Redraw::Parts(_) => (true, "in parts"),
                Redraw::Whole(_) => (false, "whole"),
            };
            *self.drawn.entry(how).or_default() += 1;
            let draw = |texture: &wgpu::Texture, jobs: &[ClippedPrimitive], over| {
                let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
                painter.draw(&view, size, Shapes { jobs, pixels_per_point: scale, over }).expect("it draws");
                bytes(painter, texture)
            };
            let parts = draw(&self.canvas, redraw.jobs(), over);
            let whole =
                draw(&painter.canvas(size), &context.tessellate(std::mem::take(&mut output.shapes), scale), false);
            painter.free(&output.textures_delta);
            output.textures_delta.clear();
            let differing: Vec<usize> = (0..parts.len()).filter(|i| parts[*i] != whole[*i]).collect();
            differing.first().map(|first| {
                let place = [first / 4 % size[0] as usize, first / 4 / size[0] as usize];
                let most = differing.iter().map(|i| parts[*i].abs_diff(whole[*i])).max();
                format!("{how}: {} bytes differ, by {most:?}, the first at {place:?}", differing.len())
            })
        }
    }

    fn open(preset: &str) -> Option<(Both, Painter)> {
        // What is drawn is looked at; long runs after each edit are not.
        let scene = Scene { duration: 1.0, ..presets::load(preset).expect("ships") };
        let mut bench = Workbench::new(scene, crate::files::SceneSource::New);
        bench.replay.runner.set_estimates(false);
        bench.replay.runner.wait();
        bench.tasks.set_silent();
        let (textures, size) = (Textures::default(), [900, 560]);
        let painter = painter(&textures)?;
        bench.view.set_target(painter.format(), Some(painter.summary()));
        let (context, shown, canvas) = (theme::context(), Shown::default(), painter.canvas(size));
        let drawn = BTreeMap::new();
        Some((Both { bench, context, textures, shown, canvas, size, scale: 1.0, time: 0.0, drawn }, painter))
    }

    /// What happens before a frame.
    fn act(both: &mut Both, painter: &mut Painter, random: &mut Random) -> Vec<Event> {
        let place = |random: &mut Random| pos2(random.below(900) as f32, random.below(560) as f32);
        let modifiers = Modifiers::NONE;
        let key = |key, pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        match random.below(40) {
            0 => both.resize(painter, [if random.below(2) == 0 { 700 } else { 987 }, 500], 1.0),
            1 => both.resize(painter, [900, 560], 1.25),
            2 => both.bench.apply(AppearanceCommand::Language(if random.below(2) == 0 {
                Language::Japanese
            } else {
                Language::English
            })),
            3 => both.bench.apply(PlaceCommand::AddGirder),
            4 => both.bench.apply(EditCommand::Undo),
            5 => {
                painter.device().destroy();
                *painter = super::super::painter::tests::painter(&both.textures).expect("there was one before");
                both.resize(painter, both.size, both.scale);
            }
            6..=9 => return vec![key(Key::Space, true), key(Key::Space, false)],
            10..=14 => {
                let pos = place(random);
                let button = |pressed| Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers };
                return vec![Event::PointerMoved(pos), button(true), button(false)];
            }
            15..=22 => return vec![Event::PointerMoved(place(random))],
            _ => {}
        }
        Vec::new()
    }

    fn series(preset: &str, seed: u64) {
        let Some((mut both, mut painter)) = open(preset) else { return };
        let mut random = Random::new(seed);
        for number in 0..FRAMES {
            let events = act(&mut both, &mut painter, &mut random);
            if both.bench.window.asks() {
                both.bench.apply(LeaveCommand::Stay);
            }
            assert_eq!(both.frame(&painter, events), None, "{preset}, seed {seed}, frame {number}");
        }
        let count = |how: &str| both.drawn.get(how).copied().unwrap_or(0);
        assert!(count("in parts") > 10 && count("whole") > 3, "{:?}", both.drawn);
        (0..8).for_each(|_| assert_eq!(both.frame(&painter, Vec::new()), None, "coming to rest"));
    }

    #[test]
    fn a_window_drawn_in_parts_is_the_window_drawn_whole() {
        series(presets::OPENING, 1);
        series("deck-30m", 2);
    }

    #[test]
    fn nothing_is_drawn_where_nothing_has_changed() {
        let Some((mut both, painter)) = open(presets::OPENING) else { return };
        (0..40).for_each(|_| assert_eq!(both.frame(&painter, Vec::new()), None));
        both.drawn.clear();
        (0..5).for_each(|_| assert_eq!(both.frame(&painter, Vec::new()), None));
        assert_eq!(both.drawn, BTreeMap::from([("not at all", 5)]));
    }
}
