//! The picture of the 3D view, kept until something changes that it depends on, and its camera.

use std::cell::Cell;
use std::sync::Arc;

use egui::{Pos2, Rect};
use glam::{DVec3, Vec2};

use crate::app::viewport::eye::ndc;
use crate::app::viewport::glide::Glide;
use crate::app::viewport::hand::Hand;
use crate::app::viewport::pane::Panes;
use crate::app::viewport::seen::Seen;
use crate::language::Language;
use crate::render::Regions;
use crate::scene::device::Joint;
use crate::scene::{Overlays, Scene, ViewPreset};
use crate::sim::History;
use crate::view::{Background, Bending, Bent, Bounds, Camera, DrawList, Target, ViewInput, block, draw_list};

/// Everything that a picture depends on; the same key is the same picture.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Key {
    pub(super) scene: u64,
    pub(super) answer: Option<u64>,
    pub(super) t: f64,
    pub(super) camera: Camera,
    pub(super) overlays: Overlays,
    pub(super) force_scale: Option<f64>,
    pub(super) selected: Vec<Target>,
    pub(super) kept: Vec<u64>,
    pub(super) clear: Vec<Vec2>,
    pub(super) exaggeration: f64,
    pub(super) bent: Option<Bent>,
    pub(super) size: [u32; 2],
    pub(super) pixels_per_point: f32,
    pub(super) background: Background,
    pub(super) language: Language,
}

/// The view's own state.
pub struct Viewport {
    pub(super) camera: Option<Camera>,
    wanted: Option<ViewPreset>,
    pub(super) glide: Glide,
    pub(super) picture: Option<(Key, Arc<DrawList>)>,
    pub(super) number: u64,
    /// When the picture was last another one, on the window's clock \[s\].
    pub(super) changed: f64,
    pub(super) size: [u32; 2],
    /// Object held by the mouse or the keys.
    pub hand: Hand,
    /// Where what is followed was at the last look \[m\].
    pub(in crate::app) followed: Option<DVec3>,
    /// How girders that bend were drawn last: of which answer, as asked how.
    bent: Cell<Option<(u64, Bending, Option<Bent>)>>,
    /// The plan beside the view: its picture, and how many there have been.
    pub(super) plan: (Option<(Key, Arc<DrawList>)>, u64),
    pub(super) panes: Panes,
}

impl Viewport {
    /// A view that will stand where a scene wants it.
    pub(in crate::app) fn new(preset: ViewPreset) -> Self {
        Self {
            camera: None,
            wanted: Some(preset),
            glide: Glide::default(),
            picture: None,
            number: 0,
            changed: 0.0,
            size: [1280, 720],
            hand: Hand::default(),
            followed: None,
            bent: Cell::new(None),
            plan: (None, 0),
            panes: Panes::default(),
        }
    }

    /// How girders that bend are drawn, looked for in a run once.
    pub(super) fn bent(&self, seen: &Seen<'_>) -> Option<Bent> {
        let (bending, answer) = (seen.display.sight.bent?, seen.answer()?);
        match self.bent.get() {
            Some((number, asked, bent)) if number == answer.number && asked == bending => bent,
            _ => {
                let bent = Bent::of(&answer.history, bending);
                self.bent.set(Some((answer.number, bending, bent)));
                bent
            }
        }
    }

    /// How many different pictures have been made.
    pub fn pictures(&self) -> u64 {
        self.number
    }

    /// The picture last made.
    pub fn list(&self) -> Option<&Arc<DrawList>> {
        self.picture.as_ref().map(|(_, list)| list)
    }

    /// Where pictures have changed since this was last asked \[points\], and what in them \[pixels of theirs\].
    pub(in crate::app) fn take_changes(&mut self) -> Vec<(Rect, Regions)> {
        self.panes.take_changes()
    }

    /// Background behind the bodies.
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
    pub fn camera(&self) -> Option<&Camera> {
        self.camera.as_ref()
    }

    /// Goes where the mouse has brought it.
    pub(in crate::app) fn set_camera(&mut self, camera: Camera) {
        self.glide.stop();
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
        self.glide.stop();
        if let Some(camera) = &mut self.camera {
            camera.frame(bounds, aspect);
        }
    }

    /// Goes out for `dt` \[s\] when an edit has taken the scene out of view, unless a hand holds something in it; whether
    /// it is still on its way.
    pub(super) fn keep_in_view(&mut self, seen: &Seen<'_>, dt: f64) -> bool {
        let (Some(camera), aspect) = (self.camera, self.aspect()) else { return false };
        // An older answer is shown with its own scene, which no edit has moved.
        if self.hand.held.is_none() && (!seen.is_stale() || seen.answer().is_none()) {
            self.glide.judge(&camera, (seen.scene, seen.revision), aspect);
        }
        if let Some(camera) = self.glide.advance(dt) {
            self.camera = Some(camera);
        }
        self.glide.is_on_its_way()
    }

    pub(super) fn go_where_wanted(&mut self, scene: &Scene, history: Option<&History>, t: f64) {
        let Some(preset) = self.wanted.take() else { return };
        self.glide.begin_anew();
        let aspect = self.aspect();
        self.camera = Some(match (preset, history) {
            (ViewPreset::Contact, Some(history)) => Camera::contact(history, t, aspect),
            _ => Camera::preset(preset, Bounds::of_scene(scene), aspect),
        });
    }

    /// Target at a place of the view.
    pub(in crate::app) fn pick(&self, seen: &Seen<'_>, rect: Rect, at: Pos2, pixels_per_point: f32) -> Option<Target> {
        let camera = self.camera?;
        let key = Key { camera, pixels_per_point, ..self.picture.as_ref()?.0.clone() };
        crate::view::pick(&input(seen, &camera, &key), ndc(rect, at))
    }
}

/// The box about what is selected, where it is at the time shown; about everything when that is nothing.
pub(in crate::app) fn bounds_of(seen: &Seen<'_>, targets: &[Target]) -> Bounds {
    let corners: Vec<DVec3> = targets.iter().flat_map(|target| corners_of(seen, *target)).collect();
    if corners.is_empty() { Bounds::of_scene(seen.shown().0) } else { Bounds::of_points(corners) }
}

fn corners_of(seen: &Seen<'_>, target: Target) -> Vec<DVec3> {
    let (scene, history) = seen.shown();
    let t = seen.t();
    match target {
        Target::Girder(i) => match (scene.girders.get(i), history.filter(|h| i < h.model().girders().len())) {
            (Some(girder), Some(history)) => block::moved_girder_block(girder, &history.motion(i, t)).corners().into(),
            (Some(girder), None) => block::girder_block(girder).corners().into(),
            (None, _) => Vec::new(),
        },
        Target::Abutment(i) => {
            let block = scene.abutments.get(i).and_then(|a| block::abutment_block(scene, a));
            block.map(|b| b.face.into()).unwrap_or_default()
        }
        Target::Pier(i) if i < scene.piers.len() => block::pier_block(&scene.pier(i)).corners().into(),
        Target::Pier(_) => Vec::new(),
        Target::Device(id) => {
            let device = scene.device(id);
            let joint = device.and_then(|device| Joint::of(scene, &device.part().ends()));
            joint.map(|joint| joint.points.into()).unwrap_or_default()
        }
        Target::Contact(number) => {
            let contacts = history.map(|h| h.contacts().at(t)).unwrap_or_default();
            let here = contacts.iter().find(|c| c.contact == number).map(|c| c.point);
            let reach = Bounds::of_scene(scene).radius() * 0.08;
            here.map(|p| vec![p - DVec3::splat(reach), p + DVec3::splat(reach)]).unwrap_or_default()
        }
    }
}

/// The draw list of a view, with the kept runs in it.
pub(super) fn listed(seen: &Seen<'_>, camera: &Camera, key: &Key) -> DrawList {
    let kept: Vec<_> = seen.pins.iter().map(|p| (&p.answer.history, p.color)).collect();
    draw_list(&ViewInput { kept: &kept, ..input(seen, camera, key) })
}

pub(super) fn input<'a>(seen: &Seen<'a>, camera: &'a Camera, key: &'a Key) -> ViewInput<'a> {
    let (scene, history) = seen.shown();
    ViewInput {
        scene,
        history,
        t: key.t,
        camera,
        overlays: key.overlays,
        force_scale: key.force_scale,
        selected: &key.selected,
        kept: &[],
        clear: &key.clear,
        exaggeration: key.exaggeration,
        bent: key.bent,
        size: key.size,
        pixels_per_point: key.pixels_per_point,
        background: key.background,
        title: None,
    }
}
