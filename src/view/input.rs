//! Input of a picture, and the targets that can be picked in it.

use glam::{DVec3, Vec2};

use super::bending::Bent;
use super::camera::Camera;
use super::list::Background;
use crate::scene::{DeviceId, Overlays, Scene};
use crate::sim::History;

/// Something in the picture that can be picked and selected, by its number in the scene or in the run's model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Target {
    /// A girder of the scene.
    Girder(usize),
    /// An abutment of the scene.
    Abutment(usize),
    /// A pier of the scene.
    Pier(usize),
    /// A device of the scene.
    Device(DeviceId),
    /// A contact of the run's model.
    Contact(usize),
}

/// Input of a picture.
#[derive(Clone, Copy, Debug)]
pub struct ViewInput<'a> {
    /// Scene.
    pub scene: &'a Scene,
    /// Its run; the bodies as placed when there is none.
    pub history: Option<&'a History>,
    /// The instant \[s\].
    pub t: f64,
    /// Camera.
    pub camera: &'a Camera,
    /// Layers.
    pub overlays: Overlays,
    /// Force scale of the arrows \[N per m\]; from the scene's settings or the run's peak when absent.
    pub force_scale: Option<f64>,
    /// Selected bodies, contacts and devices.
    pub selected: &'a [Target],
    /// Magnification of displacements and rotations; 1 for the true ones \[–\].
    pub exaggeration: f64,
    /// Drawing of elastic girders; as rigid ones when absent.
    pub bent: Option<Bent>,
    /// Other runs, seen as ghosts at the same instant, each with its number among [`MOST_KEPT`].
    pub kept: &'a [(&'a History, usize)],
    /// Places of what is drawn over the picture, which labels keep clear of \[pixels\].
    pub clear: &'a [Vec2],
    /// Width and height \[pixels\].
    pub size: [u32; 2],
    /// Size of texts and lines: pixels of the picture to a point, 1 on a plain screen.
    pub pixels_per_point: f32,
    /// Background behind the bodies.
    pub background: Background,
    /// Title; the scene's name when absent.
    pub title: Option<&'a str>,
}

/// Ghosts of other runs that can be told apart.
pub const MOST_KEPT: usize = 4;

/// Arrows and cones shorter than this are not drawn \[points\].
pub(super) const LEAST_FORCE: f64 = 1.5;

impl ViewInput<'_> {
    /// Width over height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.size[0].max(1)) / f64::from(self.size[1].max(1))
    }

    /// World length of a point of the picture at a place \[m\].
    pub(super) fn point_length(&self, at: DVec3) -> f64 {
        self.camera.metres_per_pixel(at, f64::from(self.size[1])) * f64::from(self.pixels_per_point)
    }

    /// Whether displacements are shown larger or smaller than they are.
    pub(super) fn is_exaggerated(&self) -> bool {
        self.exaggeration.is_finite() && self.exaggeration > 0.0 && self.exaggeration != 1.0
    }
}

/// Pixel of a point of the scene \[pixels\]; `None` behind the camera.
pub(super) fn pixel(input: &ViewInput<'_>, at: DVec3) -> Option<Vec2> {
    let [x, y] = input.camera.project(at, input.size.map(f64::from))?;
    (x.is_finite() && y.is_finite()).then(|| Vec2::new(x as f32, y as f32))
}
