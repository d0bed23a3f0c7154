//! The 3D view: the camera, the picture that is kept until something changes, and what stands over it.

use std::sync::Arc;

use egui::{Rect, Role, Sense, Ui, WidgetInfo};
use glam::DVec3;

use crate::app::bench::Workbench;
use crate::app::panel::notices;
use crate::app::text;
use crate::app::viewport::mouse::Hand;
use crate::app::viewport::screen::Screen;
use crate::scene::{Overlays, Scene, ViewPreset};
use crate::sim::History;
use crate::view::{Background, Bounds, Camera, DrawList, Target, ViewInput, block, draw_list};

/// Everything that a picture depends on; the same key is the same picture.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    scene: u64,
    answer: Option<u64>,
    t: f64,
    camera: Camera,
    overlays: Overlays,
    force_scale: Option<f64>,
    selected: Vec<Target>,
    kept: Vec<u64>,
    exaggeration: f64,
    size: [u32; 2],
    pixels_per_point: f32,
    background: Background,
}

/// The view's own state.
pub(in crate::app) struct Viewport {
    camera: Option<Camera>,
    wanted: Option<ViewPreset>,
    picture: Option<(Key, Arc<DrawList>)>,
    number: u64,
    size: [u32; 2],
    pub(in crate::app) hand: Hand,
    /// Where what is followed was at the last look \[m\].
    pub(in crate::app) followed: Option<DVec3>,
    /// The plan beside the view: its picture, and how many there have been.
    plan: (Option<(Key, Arc<DrawList>)>, u64),
}

impl Viewport {
    /// A view that will stand where a scene wants it.
    pub(in crate::app) fn new(preset: ViewPreset) -> Self {
        Self {
            camera: None,
            wanted: Some(preset),
            picture: None,
            number: 0,
            size: [1280, 720],
            hand: Hand::default(),
            followed: None,
            plan: (None, 0),
        }
    }

    /// How many different pictures have been made.
    pub(in crate::app) fn pictures(&self) -> u64 {
        self.number
    }

    /// The picture last made.
    pub(in crate::app) fn list(&self) -> Option<&Arc<DrawList>> {
        self.picture.as_ref().map(|(_, list)| list)
    }

    /// What stands behind the bodies.
    pub(in crate::app) fn background(&self) -> Background {
        self.picture.as_ref().map_or(Background::Studio, |(key, _)| key.background)
    }

    /// Width over height.
    pub(in crate::app) fn aspect(&self) -> f64 {
        f64::from(self.size[0]) / f64::from(self.size[1].max(1))
    }

    /// Width and height \[pixels\].
    pub(in crate::app) fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The camera, once the view has been seen.
    pub(in crate::app) fn camera(&self) -> Option<&Camera> {
        self.camera.as_ref()
    }

    /// Goes where the mouse has brought it.
    pub(in crate::app) fn set_camera(&mut self, camera: Camera) {
        self.camera = Some(camera);
    }

    /// The standing place it is about to go to.
    pub(in crate::app) fn wanted(&self) -> Option<ViewPreset> {
        self.wanted
    }

    /// Goes to a standing place at the next look.
    pub(in crate::app) fn want(&mut self, preset: ViewPreset) {
        self.wanted = Some(preset);
    }

    /// Frames a box without turning.
    pub(in crate::app) fn frame(&mut self, bounds: Bounds) {
        let aspect = self.aspect();
        if let Some(camera) = &mut self.camera {
            camera.frame(bounds, aspect);
        }
    }

    fn go_where_wanted(&mut self, scene: &Scene, history: Option<&History>, t: f64) {
        let Some(preset) = self.wanted.take() else { return };
        let aspect = self.aspect();
        self.camera = Some(match (preset, history) {
            (ViewPreset::Contact, Some(history)) => Camera::contact(history, t, aspect),
            _ => Camera::preset(preset, Bounds::of_scene(scene), aspect),
        });
    }
}

/// The box about what is selected, where it is at the time shown; about everything when that is nothing.
pub(in crate::app) fn bounds_of(bench: &Workbench, targets: &[Target]) -> Bounds {
    let corners: Vec<DVec3> = targets.iter().flat_map(|target| corners_of(bench, *target)).collect();
    if corners.is_empty() { Bounds::of_scene(bench.shown().0) } else { Bounds::of_points(corners) }
}

fn corners_of(bench: &Workbench, target: Target) -> Vec<DVec3> {
    let (scene, history) = bench.shown();
    let t = bench.clock().t;
    match target {
        Target::Girder(i) => match (scene.girders.get(i), history.filter(|h| i < h.model().bodies.len())) {
            (Some(girder), Some(history)) => block::moved_girder_block(girder, &history.motion(i, t)).corners().into(),
            (Some(girder), None) => block::girder_block(girder).corners().into(),
            (None, _) => Vec::new(),
        },
        Target::Abutment(i) => {
            let block = scene.abutments.get(i).and_then(|a| block::abutment_block(scene, a));
            block.map(|b| b.face.into()).unwrap_or_default()
        }
        Target::Contact(number) => {
            let contacts = history.map(|h| h.contacts(t)).unwrap_or_default();
            let here = contacts.iter().find(|c| c.contact == number).map(|c| c.point);
            let reach = Bounds::of_scene(scene).radius() * 0.08;
            here.map(|p| vec![p - DVec3::splat(reach), p + DVec3::splat(reach)]).unwrap_or_default()
        }
    }
}

/// Shows the view over the rest of the window.
pub(in crate::app) fn show(ui: &mut Ui, bench: &mut Workbench) {
    let pixels_per_point = ui.pixels_per_point();
    let mut rect = snapped(ui.available_rect_before_wrap(), pixels_per_point);
    if bench.sight().plan && rect.width() > 200.0 {
        let share = rect.left() + 0.4 * rect.width();
        let plan = snapped(Rect::from_min_max(rect.min, egui::pos2(share, rect.bottom())), pixels_per_point);
        show_plan(ui, plan, bench, pixels_per_point);
        rect.min.x = plan.max.x;
    }
    let response = ui.allocate_rect(rect, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, text::VIEW));
    let Some(size) = pixels(rect, pixels_per_point) else { return };
    bench.viewport.size = size;
    aim(bench);
    let mut out = Vec::new();
    crate::app::viewport::mouse::interact(ui, &response, bench, &mut out);
    bench.apply_all(ui, out);
    aim(bench);
    paint(ui, rect, bench, pixels_per_point);
    let mut out = Vec::new();
    // Over the picture, which is painted by now.
    crate::app::viewport::gizmo::show(ui, rect, bench, &mut out);
    crate::app::viewport::tool::show(ui, &response, bench, &mut out);
    crate::app::viewport::view_options::section(ui, rect, bench);
    notices::over_view(ui, rect, bench, &mut out);
    bench.apply_all(ui, out);
}

fn aim(bench: &mut Workbench) {
    let t = bench.clock().t;
    let answer = bench.answer().cloned();
    let scene = answer.as_ref().filter(|_| bench.is_stale()).map_or(bench.scene(), |a| a.history.scene()).clone();
    bench.viewport.go_where_wanted(&scene, answer.as_ref().map(|a| &a.history), t);
    follow(bench, answer.as_ref().map(|a| &a.history), t);
}

/// Takes the camera along with what it follows.
fn follow(bench: &mut Workbench, history: Option<&History>, t: f64) {
    let here =
        bench.sight().follow.zip(history).and_then(|(f, h)| crate::app::viewport::view_options::followed(h, f, t));
    let view = &mut bench.viewport;
    if let (Some(here), Some(before), Some(camera)) = (here, view.followed, &mut view.camera) {
        camera.target += here - before;
    }
    view.followed = here;
}

/// The plan of everything, in a view of its own; a click selects.
fn show_plan(ui: &mut Ui, rect: Rect, bench: &mut Workbench, pixels_per_point: f32) {
    let response = ui.allocate_rect(rect, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, text::PLAN));
    let Some(size) = pixels(rect, pixels_per_point) else { return };
    let aspect = f64::from(size[0]) / f64::from(size[1].max(1));
    let camera = Camera::preset(ViewPreset::Top, Bounds::of_scene(bench.shown().0), aspect);
    let overlays = Overlays { title: false, legend: false, ..bench.overlays() };
    // The friction circle stands in the view already.
    let selected = bench.selection.bodies().collect();
    let key = Key { camera, overlays, selected, size, ..key(ui, bench, camera, pixels_per_point) };
    if response.clicked()
        && let Some(at) = response.interact_pointer_pos()
    {
        let target = crate::view::pick(&input(bench, &camera, &key), ndc(rect, at));
        bench.apply_all(ui, vec![crate::app::command::Command::Select(target)]);
    }
    if bench.viewport.plan.0.as_ref().is_none_or(|(kept, _)| *kept != key) {
        let list = Arc::new(listed(bench, &camera, &key));
        bench.viewport.plan = (Some((key, list)), bench.viewport.plan.1 + 1);
    }
    if let (Some((_, list)), number) = &bench.viewport.plan {
        let screen = Screen { list: list.clone(), number: *number, size, format: bench.target_format(), place: 1 };
        ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, screen));
    }
    let line = egui::Stroke::new(1.0, crate::app::style::theme::Palette::of(ui).line);
    ui.painter().vline(rect.right(), rect.y_range(), line);
}

/// The draw list of a view, with the kept runs in it.
fn listed(bench: &Workbench, camera: &Camera, key: &Key) -> DrawList {
    let kept: Vec<_> = bench.pins.iter().map(|p| (&p.answer.history, p.color)).collect();
    draw_list(&ViewInput { kept: &kept, ..input(bench, camera, key) })
}

/// Leaves the legend out where it would lie on title and axes.
fn fitting(overlays: Overlays, size: [u32; 2], pixels_per_point: f32) -> Overlays {
    let [width, height] = size.map(|side| side as f32 / pixels_per_point);
    let room = (width >= 320.0 && height >= 290.0) || (width >= 520.0 && height >= 210.0);
    Overlays { legend: overlays.legend && room, ..overlays }
}

fn key(ui: &Ui, bench: &Workbench, camera: Camera, pixels_per_point: f32) -> Key {
    Key {
        scene: bench.revision(),
        answer: bench.answer().map(|a| a.number),
        t: bench.clock().t,
        camera,
        overlays: fitting(bench.overlays(), bench.viewport.size, pixels_per_point),
        force_scale: bench.force_scale(),
        selected: bench.selection().to_vec(),
        kept: bench.pin_numbers(),
        exaggeration: bench.sight().exaggeration,
        size: bench.viewport.size,
        pixels_per_point,
        background: if ui.visuals().dark_mode { Background::Dark } else { Background::Studio },
    }
}

fn paint(ui: &Ui, rect: Rect, bench: &mut Workbench, pixels_per_point: f32) {
    let Some(camera) = bench.viewport.camera else { return };
    let key = key(ui, bench, camera, pixels_per_point);
    if bench.viewport.picture.as_ref().is_none_or(|(kept, _)| *kept != key) {
        let list = listed(bench, &camera, &key);
        bench.viewport.picture = Some((key, Arc::new(list)));
        bench.viewport.number += 1;
    }
    if let Some((_, list)) = &bench.viewport.picture {
        let (number, size, format) = (bench.viewport.number, bench.viewport.size, bench.target_format());
        let screen = Screen { list: list.clone(), number, size, format, place: 0 };
        ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, screen));
    }
}

fn input<'a>(bench: &'a Workbench, camera: &'a Camera, key: &'a Key) -> ViewInput<'a> {
    let (scene, history) = bench.shown();
    ViewInput {
        scene,
        history,
        t: key.t,
        camera,
        overlays: key.overlays,
        force_scale: key.force_scale,
        selected: &key.selected,
        kept: &[],
        exaggeration: key.exaggeration,
        size: key.size,
        pixels_per_point: key.pixels_per_point,
        background: key.background,
        title: None,
    }
}

/// What is seen at a place of the view.
pub(in crate::app) fn pick(bench: &Workbench, rect: Rect, at: egui::Pos2, pixels_per_point: f32) -> Option<Target> {
    let camera = bench.viewport.camera?;
    let key = Key { camera, pixels_per_point, ..bench.viewport.picture.as_ref()?.0.clone() };
    crate::view::pick(&input(bench, &camera, &key), ndc(rect, at))
}

/// `[-1, 1]` across a rectangle, y up.
pub(in crate::app) fn ndc(rect: Rect, at: egui::Pos2) -> [f64; 2] {
    let from_centre = (at - rect.center()) / (rect.size() / 2.0);
    [f64::from(from_centre.x), -f64::from(from_centre.y)]
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
