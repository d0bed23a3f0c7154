//! Handles in the 3D view: move, turn, length, width, skew, gaps, a wall's place and width.
//!
//! Handles are widgets: the mouse drags them, Tab reaches them, the arrow keys pull them, a screen reader names them.

mod grip;
mod paint;
mod pull;
mod snap;
mod typed;

use egui::{CursorIcon, EventFilter, Id, Key, Pos2, Rect, Role, Sense, Ui, Vec2, WidgetInfo};
use glam::{DQuat, DVec3};

pub use grip::{Flank, Grip};
pub(in crate::app) use grip::{Handle, Stance};
pub(in crate::app) use pull::Pulled;
pub(in crate::app) use typed::{Typing, begins_number, read as read_typed};

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::viewport::view;
use crate::scene::{Girder, Scene, placed};
use crate::view::{Camera, Target};
use pull::Pull;

/// Side of the square in which a handle is taken \[points\].
const HOLD: f32 = 18.0;

/// Snaps to lines nearer than this \[points\].
const SNAP: f64 = 8.0;

/// A girder shorter than this on the screen has no handles but for moving it \[points\].
const ROOM: f32 = 70.0;

/// The view as the handles need it.
#[derive(Clone, Copy)]
pub(in crate::app) struct Eye {
    /// From where.
    pub(in crate::app) camera: Camera,
    /// Where on the screen.
    pub(in crate::app) rect: Rect,
}

impl Eye {
    /// Where a point of the world is on the screen.
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    pub(in crate::app) fn at(&self, world: DVec3) -> Option<Pos2> {
        let size = [f64::from(self.rect.width()), f64::from(self.rect.height())];
        let [x, y] = self.camera.project(world, size)?;
        // Far outside a place is only ever clipped: keep it finite.
        Some(self.rect.min + Vec2::new(x.clamp(-1e5, 1e5) as f32, y.clamp(-1e5, 1e5) as f32))
    }

    /// Which way on the screen a direction goes at a point, with a length of 1; zero when it goes into the eye.
    pub(in crate::app) fn way(&self, from: DVec3, along: DVec3) -> Vec2 {
        let little = self.metres_per_point(from);
        let ends = self.at(from).zip(self.at(from + along * little * 10.0));
        ends.map_or(Vec2::ZERO, |(a, b)| b - a).normalized()
    }

    /// Metres to a point of the screen.
    pub(in crate::app) fn metres_per_point(&self, at: DVec3) -> f64 {
        self.camera.metres_per_pixel(at, f64::from(self.rect.height()))
    }

    /// Where the line of sight meets the level plane; seen edge-on, the upright plane through the camera's target.
    pub(in crate::app) fn on_level(&self, at: Pos2, height: f64) -> Option<DVec3> {
        let aspect = f64::from(self.rect.width() / self.rect.height().max(1.0));
        let (start, along) = self.camera.ray(view::ndc(self.rect, at), aspect);
        let (through, normal) = if along.z.abs() > 0.05 {
            (DVec3::new(self.camera.target.x, self.camera.target.y, height), DVec3::Z)
        } else {
            (self.camera.target, self.camera.basis().back)
        };
        let s = (through - start).dot(normal) / along.dot(normal);
        (s.is_finite() && s > 0.0).then(|| start + along * s)
    }
}

/// What a closed hand holds.
#[derive(Clone, Debug)]
pub(in crate::app) struct Held {
    /// Of what.
    pub(in crate::app) grip: Grip,
    /// Where the mouse took it, on its plane \[m\].
    pub(in crate::app) from: DVec3,
    /// The scene then: the way is counted from there, so that nothing drifts.
    pub(in crate::app) scene: Box<Scene>,
    /// What was selected then.
    pub(in crate::app) selected: Vec<Target>,
    /// The same for all edits of this pull.
    pub(in crate::app) gesture: u64,
    /// Whether it is held by keys alone.
    pub(in crate::app) by_keys: bool,
}

/// What a pull comes to, with the mouse at `at`; `free` pulls do not snap.
pub(in crate::app) fn pull(held: &Held, eye: &Eye, at: Pos2, free: bool) -> Option<Pulled> {
    let to = eye.on_level(at, held.from.z)?;
    let point = eye.metres_per_point(to);
    let reach = if free { 0.0 } else { SNAP * point };
    let (scene, selected) = (&*held.scene, &held.selected[..]);
    let step = snap::round_step(point);
    pull::pulled(held.grip, &Pull { scene, selected, from: held.from, to, step, reach, typed: None })
}

/// How far a new girder snaps from where it stands, and to what; a `point` of the screen is so many metres.
pub(in crate::app) fn snapped(scene: &Scene, new: &Girder, point: f64, free: bool) -> (DVec3, Vec<String>) {
    if free {
        return (DVec3::ZERO, Vec::new());
    }
    // Its own gap means nothing yet: only those that there were count.
    let (reach, gaps) = (SNAP * point, snap::usual_gaps(scene));
    let (mut with, number) = (scene.clone(), scene.girders.len());
    with.girders.push(new.clone());
    let found = snap::moved(&with, &[Target::Girder(number)], number, glam::DVec2::ZERO, (reach, &gaps));
    (found.way.extend(0.0), found.words)
}

/// Words on a plate beside the mouse.
pub(in crate::app) fn say(ui: &Ui, eye: &Eye, at: Pos2, words: &[String]) {
    paint::plate(
        &ui.painter().with_clip_rect(eye.rect),
        eye.rect,
        at,
        words,
        &crate::app::style::theme::Palette::of(ui),
    );
}

/// Where girders stand at the time shown; as placed, where no answer fits the scene.
fn stance(bench: &Workbench) -> impl Fn(usize) -> Stance + '_ {
    let history = bench.answer().map(|a| &a.history).filter(|_| !bench.is_stale());
    move |i| {
        if let Some(history) = history.filter(|h| i < h.model().bodies.len()) {
            let motion = history.motion(i, bench.clock().t);
            return Stance { place: motion.place, attitude: motion.attitude };
        }
        let girder = bench.scene().girders.get(i);
        Stance {
            place: girder.map_or(DVec3::ZERO, |g| DVec3::from(g.position)),
            attitude: girder.map_or(DQuat::IDENTITY, |g| DQuat::from_mat3(&placed::axes(g))),
        }
    }
}

/// Shows the handles and does what is done to them.
pub(in crate::app) fn show(ui: &mut Ui, rect: Rect, bench: &mut Workbench, out: &mut Vec<Command>) {
    let Some(camera) = bench.viewport.camera().copied() else { return };
    let eye = Eye { camera, rect };
    paint::outlines(ui, &eye, bench);
    bench.viewport.hand.focused = None;
    if !bench.clock().playing {
        let handles = grip::handles(bench.scene(), bench.selection(), bench.overlays().gap, stance(bench));
        let crowded = is_crowded(&handles, &eye);
        for handle in handles.iter().filter(|h| !crowded || is_mover(h.grip)) {
            one(ui, &eye, handle, bench, out);
        }
    }
    bench.viewport.hand.forget_lost(ui);
    if let Some(words) = &bench.viewport.hand.words {
        let at = bench.viewport.hand.held.as_ref().filter(|h| h.by_keys).and_then(|h| eye.at(h.from));
        if let Some(at) = at.or_else(|| ui.input(|i| i.pointer.latest_pos())) {
            say(ui, &eye, at, words);
        }
    } else if let Some(pulled) = &bench.viewport.hand.pulled {
        paint::pulled(ui, &eye, pulled);
    }
}

/// What a handle is called among widgets.
pub(in crate::app) fn handle_id(grip: Grip) -> Id {
    Id::unique(("handle", grip))
}

fn is_mover(grip: Grip) -> bool {
    matches!(grip, Grip::Along(_) | Grip::Across(_) | Grip::Offset(_))
}

/// Whether the girder is too small on the screen for all its handles.
fn is_crowded(handles: &[Handle], eye: &Eye) -> bool {
    let ends = handles.iter().filter(|h| matches!(h.grip, Grip::Length(..))).filter_map(|h| eye.at(h.at));
    let ends: Vec<Pos2> = ends.collect();
    matches!(ends[..], [a, b] if a.distance(b) < ROOM)
}

fn one(ui: &mut Ui, eye: &Eye, handle: &Handle, bench: &mut Workbench, out: &mut Vec<Command>) {
    let Some(at) = paint::place(eye, handle).filter(|p| eye.rect.shrink(4.0).contains(*p)) else { return };
    let id = handle_id(handle.grip);
    let response = ui.interact(Rect::from_center_size(at, Vec2::splat(HOLD)), id, Sense::drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Splitter, true, &handle.name));
    let held = bench.viewport.hand.held.as_ref().is_some_and(|h| h.grip == handle.grip);
    let look = (response.hovered() || response.has_focus(), held);
    paint::handle(ui, eye, handle, at, look);
    if response.drag_started()
        && let Some(from) = ui.input(|i| i.pointer.press_origin()).and_then(|p| eye.on_level(p, handle.at.z))
    {
        bench.hold(handle.grip, from);
    }
    if held && response.dragged() {
        ui.set_cursor_icon(CursorIcon::Grabbing);
        out.extend(bench.drag_held(ui, eye));
    } else if response.hovered() {
        ui.set_cursor_icon(CursorIcon::Grab);
    }
    if response.drag_stopped() {
        bench.viewport.hand.let_go();
    }
    if response.has_focus() {
        let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|m| m.set_focus_lock_filter(id, arrows));
        bench.viewport.hand.focused = Some((handle.grip, handle.at));
        out.extend(keys(ui, bench, handle));
    }
    response.on_hover_text(&handle.name);
}

/// The arrow keys pull a handle that has the focus: a small step, with Shift ten.
fn keys(ui: &Ui, bench: &Workbench, handle: &Handle) -> Option<Command> {
    let steps: f64 = ui.input(|i| {
        let pressed =
            |more: Key, less: Key| f64::from(u8::from(i.key_pressed(more))) - f64::from(u8::from(i.key_pressed(less)));
        let steps = pressed(Key::ArrowRight, Key::ArrowLeft) + pressed(Key::ArrowUp, Key::ArrowDown);
        if i.modifiers.shift { 10.0 * steps } else { steps }
    });
    if steps == 0.0 {
        return None;
    }
    let scene = bench.scene();
    let largest = scene.girders.iter().map(|g| g.length).fold(1e-3, f64::max);
    let step = snap::round_step(largest / 100.0);
    let (from, to) = (handle.at, handle.at + handle.along * (step * steps));
    let pull = Pull { scene, selected: bench.selection(), from, to, step: step / 10.0, reach: 0.0, typed: None };
    let edit = pull::pulled(handle.grip, &pull)?.edit;
    Some(Command::Edit { edit, gesture: None })
}
