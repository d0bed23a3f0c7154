//! A window drawn in parts against the window drawn whole.

use std::collections::BTreeMap;

use egui::{Event, Key, Modifiers, PointerButton, RawInput, ViewportId, vec2};

use super::*;
use crate::app::bench::Workbench;
use crate::app::command::{
    AppearanceCommand, EditCommand, Follow, LeaveCommand, PlaceCommand, Sight, TimeCommand, ViewCommand,
};
use crate::app::panel::layout;
use crate::app::shell::painter::tests::{bytes, painter};
use crate::app::shell::painter::{Painter, Shapes};
use crate::app::shell::reading::Reading;
use crate::app::shell::textures::Textures;
use crate::app::style::theme;
use crate::language::Language;
use crate::scene::{Scene, presets};
use crate::study::stability::random::Random;

/// Frames of a series.
const FRAMES: u64 = 50;
/// Time from one to the next \[s\].
const STEP: f64 = 0.04;
/// Message on a frame that cannot be shown without a layout.
const LAID_OUT: &str = "to be laid out";

/// A window without a display, drawn in parts and whole.
struct Both {
    bench: Workbench,
    context: Context,
    textures: Textures,
    shown: Shown,
    canvas: wgpu::Texture,
    /// Pixels of a window to which parts of the canvas are sent.
    sent: Vec<u8>,
    reading: Reading,
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
        (self.shown, self.reading) = (Shown::default(), Reading::default());
        self.sent = vec![0; 4 * size[0] as usize * size[1] as usize];
    }

    /// Shows a frame, drawn in parts; how it differs from the same frame drawn whole.
    fn frame(&mut self, painter: &Painter, events: Vec<Event>) -> Option<String> {
        self.time += STEP;
        let points = vec2(self.size[0] as f32, self.size[1] as f32) / self.scale;
        let screen = Rect::from_min_size(pos2(0.0, 0.0), points);
        let mut input = RawInput { screen_rect: Some(screen), time: Some(self.time), events, ..RawInput::default() };
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
        let differing =
            self.differing(painter, &redraw, &context.tessellate(std::mem::take(&mut output.shapes), scale));
        painter.free(&output.textures_delta);
        output.textures_delta.clear();
        differing
    }

    /// Shows a frame between two layouts, drawn in parts; how it differs from the same frame drawn whole.
    fn between(&mut self, painter: &Painter) -> Option<String> {
        self.time += STEP;
        self.bench.replay.advance_between(STEP);
        let context = self.context.clone();
        let (viewport, seen) = self.bench.view_and_seen();
        let Some(pictures) = viewport.play_on(&seen) else { return Some(LAID_OUT.to_owned()) };
        let changes = viewport.take_changes();
        let redraw = self.shown.show_pictures(&context, (&pictures, &changes), self.size, true).expect("it is shown");
        let whole = context.tessellate(self.shown.shapes.clone(), self.scale);
        self.differing(painter, &redraw, &whole)
    }

    /// Draws over the frame before; how that differs from the frame drawn whole.
    fn differing(&mut self, painter: &Painter, redraw: &Redraw, whole: &[ClippedPrimitive]) -> Option<String> {
        let (size, scale) = (self.size, self.scale);
        let (over, how) = match redraw {
            Redraw::Nothing => (true, "not at all"),
            Redraw::Parts(..) => (true, "in parts"),
            Redraw::Whole(_) => (false, "whole"),
        };
        *self.drawn.entry(how).or_default() += 1;
        let draw = |texture: &wgpu::Texture, jobs: &[ClippedPrimitive], over| {
            let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
            painter.draw(&view, size, Shapes { jobs, pixels_per_point: scale, over }).expect("it draws");
            bytes(painter, texture)
        };
        let parts = draw(&self.canvas, redraw.jobs(), over);
        let whole = draw(&painter.canvas(size), whole, false);
        let send = |part: Region, rows: &[u8]| {
            let ([left, top], [width, _]) = (part.min.map(|at| at as usize), part.size().map(|side| side as usize));
            for (number, row) in rows.chunks(4 * width).enumerate() {
                let first = 4 * ((top + number) * size[0] as usize + left);
                self.sent[first..first + row.len()].copy_from_slice(row);
            }
            Ok(())
        };
        self.reading.read(painter, &self.canvas, &redraw.parts(size), send).expect("it reads");
        if self.sent != parts {
            return Some(format!("{how}: what is sent is not what is drawn"));
        }
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
    let (sent, reading) = (Vec::new(), Reading::default());
    let mut both = Both { bench, context, textures, shown, canvas, sent, reading, size, scale: 1.0, time: 0.0, drawn };
    both.resize(&painter, size, 1.0);
    Some((both, painter))
}

/// Events before a frame.
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

#[test]
fn a_frame_between_two_layouts_is_the_window_at_its_time_and_lays_nothing_out() {
    let Some((mut both, painter)) = open(presets::OPENING) else { return };
    (0..5).for_each(|_| assert_eq!(both.frame(&painter, Vec::new()), None));
    both.bench.replay.playback.clock.playing = true;
    assert_eq!(both.frame(&painter, Vec::new()), None);
    let counted = |both: &Both| (both.context.cumulative_pass_nr(), both.bench.view.viewport.pictures());
    let before = counted(&both);
    for number in 0..12 {
        let differing = if number % 3 == 2 { both.frame(&painter, Vec::new()) } else { both.between(&painter) };
        assert_eq!(differing, None, "frame {number}");
    }
    let now = counted(&both);
    assert_eq!((now.0 - before.0, now.1 - before.1), (4, 12), "layouts of the window, pictures of the view");
    assert_eq!(both.between(&painter), None);
    let Some((mut other, other_painter)) = open(presets::OPENING) else { return };
    other.bench.apply(TimeCommand::Seek(both.bench.replay.t()));
    (0..5).for_each(|_| assert_eq!(other.frame(&other_painter, Vec::new()), None));
    let [played, sought] = [&both, &other].map(|both| both.bench.view.viewport.list().expect("it is shown"));
    assert_eq!(played, sought, "the view at a time does not depend on how it came there");
}

#[test]
fn a_frame_in_which_more_moves_than_bodies_is_laid_out() {
    let Some((mut both, painter)) = open(presets::OPENING) else { return };
    both.bench.replay.playback.clock.playing = true;
    (0..3).for_each(|_| assert_eq!(both.frame(&painter, Vec::new()), None));
    assert_eq!(both.between(&painter), None, "nothing is held or followed");
    let sight = both.bench.view.display.sight;
    for moving in [Sight { follow: Some(Follow::Middle(0)), ..sight }, Sight { section: true, ..sight }] {
        both.bench.apply(ViewCommand::Sight(moving));
        assert_eq!(both.frame(&painter, Vec::new()), None);
        assert_eq!(both.between(&painter).as_deref(), Some(LAID_OUT), "{moving:?}");
    }
}
