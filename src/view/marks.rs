//! Marks on decks and table for a camera that looks straight down, as the paper filmed its experiment (Fig. 4).
//!
//! A girder carries three: at G and on its axis at [`SHARE`] of its length to either side. The table carries two beside the decks,
//! on an abutment where one stands there: it moves with the table.
//! They are white disks, decks and walls grey, the table nearly black, and nothing else is drawn.

use glam::{DVec3, Vec2};

use super::list::{DrawList, Mark, Rgba};
use super::moment::at_rest;
use super::{Bounds, Camera, draw_list};
use crate::scene::{Girder, Scene, ViewPreset};
use crate::sim::{History, Motion};
use crate::view::ViewInput;

/// Distance of the outer marks from G, as a share of the girder's length.
pub const SHARE: f64 = 0.4;
/// Diameter of a mark where none is given, as a share of the narrowest girder's width: 5.6 mm on the paper's.
pub const DIAMETER: f64 = 0.08;
/// Distance of the table's marks from the decks, as a share of the same width.
const BESIDE: f64 = 0.45;

const WHITE: Rgba = Rgba::rgb(0xf4, 0xf4, 0xf4);
const DECK: Rgba = Rgba::rgb(0x4a, 0x4f, 0x55);
const WALL: Rgba = Rgba::rgb(0x33, 0x37, 0x3c);
const FLOOR: Rgba = Rgba::rgb(0x16, 0x18, 0x1b);

/// A mark of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The girder that carries it, by its number; none of a mark on the table.
    pub girder: Option<usize>,
    /// Its place on the girder, from G, or in the world \[m\].
    pub at: DVec3,
}

impl Place {
    /// Position in the world \[m\].
    fn world(&self, motions: &[Motion]) -> DVec3 {
        self.girder.map_or(self.at, |n| motions[n].place + motions[n].attitude * self.at)
    }
}

/// The narrowest girder's width; 1 where there is none \[m\].
fn width(scene: &Scene) -> f64 {
    let least = scene.girders.iter().map(|girder| girder.width).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 1.0 }
}

/// Diameter of marks where none is given \[m\].
pub fn diameter(scene: &Scene) -> f64 {
    DIAMETER * width(scene)
}

/// Marks of a scene: two on the table, then three a girder.
pub fn places(scene: &Scene) -> Vec<Place> {
    let on_girder = |n: usize| {
        let [reach, top] = [SHARE * scene.girders[n].length, 0.5 * scene.girders[n].thickness];
        [-reach, 0.0, reach].map(|x| Place { girder: Some(n), at: DVec3::new(x, 0.0, top) })
    };
    let decks: Vec<Place> = (0..scene.girders.len()).flat_map(on_girder).collect();
    let rest: Vec<Motion> = scene.girders.iter().map(at_rest).collect();
    let marked = Bounds::of_points(decks.iter().map(|place| place.world(&rest)));
    let corners = scene
        .girders
        .iter()
        .zip(&rest)
        .flat_map(|(girder, home)| girder.prism().corners().map(|corner| home.place + home.attitude * corner));
    let beside = Bounds::of_points(corners).min.y - BESIDE * width(scene);
    let on_table = [marked.min.x, marked.max.x].map(|x| Place { girder: None, at: DVec3::new(x, beside, 0.0) });
    on_table.into_iter().chain(decks).collect()
}

/// Corners of every girder \[m\].
fn corners(scene: &Scene, motions: &[Motion]) -> Vec<DVec3> {
    let of = |(girder, motion): (&Girder, &Motion)| {
        girder.prism().corners().map(|corner| motion.place + motion.attitude * corner)
    };
    scene.girders.iter().zip(motions).flat_map(of).collect()
}

/// Every girder at an instant.
fn motions(history: &History, t: f64) -> Vec<Motion> {
    (0..history.scene().girders.len()).map(|n| history.motion(n, t)).collect()
}

/// A camera straight above that keeps every mark and girder in view at all of these instants \[s\].
pub fn camera(history: &History, instants: &[f64], aspect: f64) -> Camera {
    let scene = history.scene();
    let marks = places(scene);
    let of_instant = |t: &f64| {
        let motions = motions(history, *t);
        let mut seen = corners(scene, &motions);
        seen.extend(marks.iter().map(|mark| mark.world(&motions)));
        seen
    };
    Camera::preset(ViewPreset::Top, Bounds::of_points(instants.iter().flat_map(of_instant)), aspect)
}

/// Places of the marks in a picture of this size at an instant: to the right and down from its top left \[pixels\].
pub fn pixels(history: &History, t: f64, camera: &Camera, size: [u32; 2]) -> Vec<[f64; 2]> {
    let motions = motions(history, t);
    let project = |place: &Place| camera.project(place.world(&motions), size.map(f64::from));
    places(history.scene()).iter().filter_map(project).collect()
}

/// The picture: bodies in grey and white marks of this diameter \[m\].
pub fn marked_list(input: &ViewInput<'_>, history: &History, diameter: f64) -> DrawList {
    let mut list = draw_list(input);
    list.ground = None;
    (list.frame.sky, list.frame.floor) = (FLOOR, FLOOR);
    // A wall that would hide something is a ghost.
    list.solids.append(&mut list.ghosts);
    list.lines.clear();
    list.xray_lines.clear();
    list.cones.clear();
    list.arrows.clear();
    for solid in &mut list.solids {
        let deck = input.scene.girders.iter().any(|girder| girder.name == solid.name);
        solid.color = if deck { DECK } else { WALL };
    }
    let radius = 0.5 * diameter / input.camera.metres_per_pixel(DVec3::ZERO, f64::from(input.size[1]));
    let disk = |[x, y]: [f64; 2]| Mark::Disk {
        at: Vec2::new(x as f32, y as f32),
        radius: radius as f32,
        color: WHITE,
        halo: Rgba::CLEAR,
    };
    list.marks = pixels(history, input.t, input.camera, input.size).into_iter().map(disk).collect();
    list
}
