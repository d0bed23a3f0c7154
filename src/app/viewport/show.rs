//! Shows the 3D view: the plan beside it, the mouse in it, the picture, and what stands over it.

use std::sync::Arc;
use std::time::Duration;

use egui::{Rect, Response, Role, Sense, Ui, WidgetInfo};
use glam::{DVec3, Vec2};

use crate::app::command::{Command, Follow, SelectCommand};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::viewport::eye::{Eye, ndc};
use crate::app::viewport::picture::{Key, Viewport, input, listed};
use crate::app::viewport::screen::Screen;
use crate::app::viewport::seen::Seen;
use crate::app::viewport::{gizmo, mouse, section, tool};
use crate::language::Language;
use crate::scene::{Overlays, Scene, ViewPreset};
use crate::sim::History;
use crate::view::{Background, Bounds, Camera, Target};

/// Shows the view over the rest of the window up to its picture: the plan beside it, the mouse in it. `None` where there
/// is no room.
pub(in crate::app) fn begin(
    ui: &mut Ui,
    (viewport, seen): (&mut Viewport, &Seen<'_>),
    out: &mut Vec<Command>,
) -> Option<Response> {
    let pixels_per_point = ui.pixels_per_point();
    let mut rect = snapped(ui.available_rect_before_wrap(), pixels_per_point);
    if seen.display.sight.plan && rect.width() > 200.0 {
        let share = rect.left() + 0.4 * rect.width();
        let plan = snapped(Rect::from_min_max(rect.min, egui::pos2(share, rect.bottom())), pixels_per_point);
        show_plan(ui, plan, (viewport, seen), out);
        rect.min.x = plan.max.x;
    }
    let response = ui.allocate_rect(rect, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, text::VIEW));
    viewport.size = pixels(rect, pixels_per_point)?;
    aim(viewport, seen);
    if viewport.keep_in_view(seen, f64::from(ui.input(|i| i.stable_dt))) {
        ui.request_repaint();
    }
    mouse::interact(ui, &response, (viewport, seen), out);
    Some(response)
}

/// Paints the picture and what stands over it; the commands of [`begin`] are done by now.
pub(in crate::app) fn finish(
    ui: &mut Ui,
    response: &Response,
    (viewport, seen): (&mut Viewport, &Seen<'_>),
    out: &mut Vec<Command>,
) {
    aim(viewport, seen);
    let Some(camera) = viewport.camera else { return };
    paint(ui, response.rect, camera, (&mut *viewport, seen));
    // Over the picture, which is painted by now.
    let eye = Eye { camera, rect: response.rect };
    let list = viewport.list().cloned();
    gizmo::show(ui, &eye, (&mut viewport.hand, list.as_deref()), seen, out);
    tool::show(ui, &eye, response, seen, out);
    section::show(ui, response.rect, seen, out);
}

fn aim(viewport: &mut Viewport, seen: &Seen<'_>) {
    let (scene, _) = seen.shown();
    let history = seen.answer().map(|a| &a.history);
    viewport.go_where_wanted(scene, history, seen.t());
    follow(viewport, seen.display.sight.follow, history, seen.t());
}

/// Takes the camera along with what it follows.
fn follow(viewport: &mut Viewport, follow: Option<Follow>, history: Option<&History>, t: f64) {
    let here = follow.zip(history).and_then(|(f, h)| followed(h, f, t));
    if let (Some(here), Some(before), Some(camera)) = (here, viewport.followed, &mut viewport.camera) {
        camera.target += here - before;
    }
    viewport.followed = here;
}

/// Where what is followed is at a time \[m\].
fn followed(history: &History, follow: Follow, t: f64) -> Option<DVec3> {
    let (Follow::Middle(girder) | Follow::Corner(girder, _)) = follow;
    let body = history.model().bodies.get(girder)?;
    let motion = history.motion(girder, t);
    let arm = match follow {
        Follow::Middle(_) => DVec3::ZERO,
        Follow::Corner(_, corner) => body.prism.plan_corners().get(corner)?.extend(0.0),
    };
    Some(motion.place + motion.attitude * arm)
}

/// The plan of everything, in a view of its own; a click selects.
fn show_plan(ui: &mut Ui, rect: Rect, (viewport, seen): (&mut Viewport, &Seen<'_>), out: &mut Vec<Command>) {
    let pixels_per_point = ui.pixels_per_point();
    let response = ui.allocate_rect(rect, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, text::PLAN));
    let Some(size) = pixels(rect, pixels_per_point) else { return };
    let aspect = f64::from(size[0]) / f64::from(size[1].max(1));
    let camera = Camera::preset(ViewPreset::Top, Bounds::of_scene(seen.shown().0), aspect);
    let overlays = Overlays { title: false, legend: false, ..seen.display.overlays };
    // The friction circle stands in the view already.
    let selected = seen.selection.iter().copied().filter(|t| !matches!(t, Target::Contact(_))).collect();
    let key = Key { camera, overlays, selected, size, ..key(ui, camera, (viewport, seen)) };
    if response.clicked()
        && let Some(at) = response.interact_pointer_pos()
    {
        let target = crate::view::pick(&input(seen, &camera, &key), ndc(rect, at));
        out.push(SelectCommand::Only(target).into());
    }
    if viewport.plan.0.as_ref().is_none_or(|(kept, _)| *kept != key) {
        let list = Arc::new(listed(seen, &camera, &key));
        viewport.plan = (Some((key, list)), viewport.plan.1 + 1);
        viewport.changed = ui.input(|i| i.time);
    }
    if let (Some((_, list)), number) = &viewport.plan {
        let moves = seen.is_drawn_by_processor && moves(ui, viewport);
        let screen = Screen { list: list.clone(), number: *number, size, format: seen.format, place: 1, moves };
        ui.painter().add(viewport.panes.callback(rect, screen));
    }
    let line = egui::Stroke::new(1.0, Palette::of(ui).line);
    ui.painter().vline(rect.right(), rect.y_range(), line);
}

/// Leaves the legend out where it would lie on title and axes, and all three behind the start page of an empty scene.
fn fitting(overlays: Overlays, (scene, size): (&Scene, [u32; 2]), pixels_per_point: f32) -> Overlays {
    if scene.girders.is_empty() && scene.abutments.is_empty() {
        return Overlays { title: false, legend: false, axes: false, ..overlays };
    }
    let [width, height] = size.map(|side| side as f32 / pixels_per_point);
    let room = (width >= 320.0 && height >= 290.0) || (width >= 520.0 && height >= 210.0);
    Overlays { legend: overlays.legend && room, ..overlays }
}

fn key(ui: &Ui, camera: Camera, (viewport, seen): (&Viewport, &Seen<'_>)) -> Key {
    let pixels_per_point = ui.pixels_per_point();
    Key {
        scene: seen.revision,
        answer: seen.answer().map(|a| a.number),
        t: seen.t(),
        camera,
        overlays: fitting(seen.display.overlays, (seen.scene, viewport.size), pixels_per_point),
        force_scale: seen.display.force_scale(),
        selected: seen.selection.to_vec(),
        kept: seen.pins.iter().map(|p| p.answer.number).collect(),
        clear: Vec::new(),
        exaggeration: seen.display.sight.exaggeration,
        bent: viewport.bent(seen),
        size: viewport.size,
        pixels_per_point,
        background: if ui.visuals().dark_mode { Background::Dark } else { Background::Studio },
        language: Language::current(),
    }
}

fn paint(ui: &Ui, rect: Rect, camera: Camera, (viewport, seen): (&mut Viewport, &Seen<'_>)) {
    let places = gizmo::places(&Eye { camera, rect }, seen);
    let clear = places.into_iter().map(|at| (at - rect.min) * ui.pixels_per_point()).map(|at| Vec2::new(at.x, at.y));
    let key = Key { clear: clear.collect(), ..key(ui, camera, (viewport, seen)) };
    if viewport.picture.as_ref().is_none_or(|(kept, _)| *kept != key) {
        let list = listed(seen, &camera, &key);
        viewport.picture = Some((key, Arc::new(list)));
        viewport.number += 1;
        viewport.changed = ui.input(|i| i.time);
    }
    if let Some((_, list)) = &viewport.picture {
        let (number, size, format) = (viewport.number, viewport.size, seen.format);
        let moves = seen.is_drawn_by_processor && moves(ui, viewport);
        let screen = Screen { list: list.clone(), number, size, format, place: 0, moves };
        ui.painter().add(viewport.panes.callback(rect, screen));
    }
}

/// How long a picture has to stand before it is drawn sharp \[s\]: more than a frame of a processor that draws (0.1 s, docs/cost.md),
/// so that a film in slow frames is not taken for a picture at rest.
const REST: f64 = 0.15;

/// Whether the picture moves; asks for the frame in which it will have come to rest.
fn moves(ui: &Ui, viewport: &Viewport) -> bool {
    let left = viewport.changed + REST - ui.input(|i| i.time);
    if left > 0.0 {
        ui.request_repaint_after(Duration::from_secs_f64(left));
    }
    left > 0.0
}

/// A rectangle whose edges are pixels, so that the picture is copied texel by pixel.
fn snapped(rect: Rect, pixels_per_point: f32) -> Rect {
    let snap = |v: f32| (v * pixels_per_point).round() / pixels_per_point;
    Rect::from_min_max(egui::pos2(snap(rect.min.x), snap(rect.min.y)), egui::pos2(snap(rect.max.x), snap(rect.max.y)))
}

/// Width and height in pixels; `None` when there is nothing to draw on.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "checked to be 1 or more, and a screen is small"
)]
fn pixels(rect: Rect, pixels_per_point: f32) -> Option<[u32; 2]> {
    let size = rect.size() * pixels_per_point;
    (size.x >= 1.0 && size.y >= 1.0).then(|| [size.x.round() as u32, size.y.round() as u32])
}
