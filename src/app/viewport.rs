//! The 3D view: the camera, the picture that is kept until something changes, and what stands over it.

use std::sync::Arc;

use egui::{Rect, Role, Sense, Ui, WidgetInfo};
use glam::DVec3;

use super::hand::Hand;
use super::screen::Screen;
use super::{Workbench, notices, text};
use crate::scene::{Overlays, Scene, ViewPreset};
use crate::sim::History;
use crate::view::{Background, Bounds, Camera, DrawList, Target, ViewInput, block, draw_list};

/// Everything that a picture depends on; the same key is the same picture.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Key {
    scene: u64,
    answer: Option<u64>,
    t: f64,
    camera: Camera,
    overlays: Overlays,
    force_scale: Option<f64>,
    selected: Option<Target>,
    size: [u32; 2],
    pixels_per_point: f32,
    background: Background,
}

/// The view's own state.
pub(super) struct Viewport {
    camera: Option<Camera>,
    wanted: Option<ViewPreset>,
    picture: Option<(Key, Arc<DrawList>)>,
    number: u64,
    size: [u32; 2],
    pub(super) hand: Hand,
}

impl Viewport {
    /// A view that will stand where a scene wants it.
    pub(super) fn new(preset: ViewPreset) -> Self {
        Self { camera: None, wanted: Some(preset), picture: None, number: 0, size: [1280, 720], hand: Hand::default() }
    }

    /// How many different pictures have been made.
    pub(super) fn pictures(&self) -> u64 {
        self.number
    }

    /// The picture last made.
    pub(super) fn list(&self) -> Option<&Arc<DrawList>> {
        self.picture.as_ref().map(|(_, list)| list)
    }

    /// What stands behind the bodies.
    pub(super) fn background(&self) -> Background {
        self.picture.as_ref().map_or(Background::Studio, |(key, _)| key.background)
    }

    /// Width over height.
    pub(super) fn aspect(&self) -> f64 {
        f64::from(self.size[0]) / f64::from(self.size[1].max(1))
    }

    /// Width and height \[pixels\].
    pub(super) fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The camera, once the view has been seen.
    pub(super) fn camera(&self) -> Option<&Camera> {
        self.camera.as_ref()
    }

    /// Goes where the mouse has brought it.
    pub(super) fn set_camera(&mut self, camera: Camera) {
        self.camera = Some(camera);
    }

    /// The standing place it is about to go to.
    pub(super) fn wanted(&self) -> Option<ViewPreset> {
        self.wanted
    }

    /// Goes to a standing place at the next look.
    pub(super) fn want(&mut self, preset: ViewPreset) {
        self.wanted = Some(preset);
    }

    /// Frames a box without turning.
    pub(super) fn frame(&mut self, bounds: Bounds) {
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

/// The box about something selected, where it is at `t`.
pub(super) fn bounds_of(bench: &Workbench, target: Option<Target>) -> Bounds {
    let (scene, history) = bench.shown();
    let t = bench.clock().t;
    let corners: Vec<DVec3> = match target {
        Some(Target::Girder(i)) => match (scene.girders.get(i), history) {
            (Some(girder), Some(history)) => block::moved_girder_block(girder, &history.motion(i, t)).corners().into(),
            (Some(girder), None) => block::girder_block(girder).corners().into(),
            (None, _) => Vec::new(),
        },
        Some(Target::Abutment(i)) => {
            let block = scene.abutments.get(i).and_then(|a| block::abutment_block(scene, a));
            block.map(|b| b.face.into()).unwrap_or_default()
        }
        Some(Target::Contact(number)) => {
            let contacts = history.map(|h| h.contacts(t)).unwrap_or_default();
            let here = contacts.iter().find(|c| c.contact == number).map(|c| c.point);
            let reach = Bounds::of_scene(scene).radius() * 0.08;
            here.map(|p| vec![p - DVec3::splat(reach), p + DVec3::splat(reach)]).unwrap_or_default()
        }
        None => Vec::new(),
    };
    if corners.is_empty() { Bounds::of_scene(scene) } else { Bounds::of_points(corners) }
}

/// Shows the view over the rest of the window.
pub(super) fn show(ui: &mut Ui, bench: &mut Workbench) {
    let pixels_per_point = ui.pixels_per_point();
    let rect = snapped(ui.available_rect_before_wrap(), pixels_per_point);
    let response = ui.allocate_rect(rect, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, text::VIEW));
    let Some(size) = pixels(rect, pixels_per_point) else { return };
    bench.viewport.size = size;
    aim(bench);
    let mut out = Vec::new();
    super::hand::interact(ui, &response, bench, &mut out);
    bench.apply_all(ui, out);
    aim(bench);
    paint(ui, rect, bench, pixels_per_point);
    let mut out = Vec::new();
    notices::over_view(ui, rect, bench, &mut out);
    bench.apply_all(ui, out);
}

fn aim(bench: &mut Workbench) {
    let t = bench.clock().t;
    let answer = bench.answer().cloned();
    let scene = answer.as_ref().filter(|_| bench.is_stale()).map_or(bench.scene(), |a| a.history.scene()).clone();
    bench.viewport.go_where_wanted(&scene, answer.as_ref().map(|a| &a.history), t);
}

fn paint(ui: &Ui, rect: Rect, bench: &mut Workbench, pixels_per_point: f32) {
    let Some(camera) = bench.viewport.camera else { return };
    let background = if ui.visuals().dark_mode { Background::Dark } else { Background::Studio };
    let key = Key {
        scene: bench.revision(),
        answer: bench.answer().map(|a| a.number),
        t: bench.clock().t,
        camera,
        overlays: bench.overlays(),
        force_scale: bench.force_scale(),
        selected: bench.selected(),
        size: bench.viewport.size,
        pixels_per_point,
        background,
    };
    if bench.viewport.picture.as_ref().is_none_or(|(kept, _)| *kept != key) {
        let list = draw_list(&input(bench, &camera, &key));
        bench.viewport.picture = Some((key, Arc::new(list)));
        bench.viewport.number += 1;
    }
    if let Some((_, list)) = &bench.viewport.picture {
        let (number, size, format) = (bench.viewport.number, bench.viewport.size, bench.target_format());
        let screen = Screen { list: list.clone(), number, size, format };
        ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, screen));
    }
}

fn input<'a>(bench: &'a Workbench, camera: &'a Camera, key: &Key) -> ViewInput<'a> {
    let (scene, history) = bench.shown();
    ViewInput {
        scene,
        history,
        t: key.t,
        camera,
        overlays: key.overlays,
        force_scale: key.force_scale,
        selected: key.selected,
        size: key.size,
        pixels_per_point: key.pixels_per_point,
        background: key.background,
        title: None,
    }
}

/// What is seen at a place of the view.
pub(super) fn pick(bench: &Workbench, rect: Rect, at: egui::Pos2, pixels_per_point: f32) -> Option<Target> {
    let camera = bench.viewport.camera?;
    let key = bench.viewport.picture.as_ref()?.0;
    let key = Key { camera, pixels_per_point, ..key };
    crate::view::pick(&input(bench, &camera, &key), ndc(rect, at))
}

/// `[-1, 1]` across a rectangle, y up.
pub(super) fn ndc(rect: Rect, at: egui::Pos2) -> [f64; 2] {
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
