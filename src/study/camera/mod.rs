//! Error of a film of marks: that of measured motion against mark size, resolution, exposure, noise and quantisation.
//!
//! Pictures are made here from the places of the marks (`study/camera/picture.rs`), so that each influence can be had alone, and measured as those
//! of a camera are. The film is the paper's: its 45° girder, driven along the axis at 0.40 g, hits and turns.

mod page;
mod picture;

use rayon::prelude::*;

use super::measured::{Difference, differences};
use crate::measure::{Calibration, Finder, Layout, Lost, MarkPlace, Poses, TABLE, Tracker, exposed};
use crate::scene::{SceneErrors, presets};
use crate::sim::History;
pub use page::{csv, page, plots};
pub use picture::Camera;

/// Length of a pixel of the paper's camera, 720 pixels wide, as `girderbench render --marks` sets it up for this girder \[mm\].
const MM_PER_PIXEL: f64 = 0.456;
/// Width and height of its pictures \[pixels\].
const SIZE: [f64; 2] = [720.0, 465.0];
/// Pictures a second \[Hz\].
const FPS: f64 = 30.0;
/// Pictures of the film: three seconds, eight periods of the ground.
const COUNT: u32 = 91;
/// Places of the marks on the deck, from G, and on the table \[mm\].
const ON_DECK: [[f64; 2]; 3] = [[-76.0, 0.0], [0.0, 0.0], [76.0, 0.0]];
const ON_TABLE: [[f64; 2]; 2] = [[-76.0, -66.5], [76.0, -66.5]];

/// Varied parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Influence {
    /// Diameter of the marks.
    Diameter,
    /// Pixels of the picture, with marks of one size in mm.
    Resolution,
    /// Time of exposure.
    Exposure,
    /// Noise of the sensor.
    Noise,
    /// Steps of brightness.
    Quantisation,
}

impl Influence {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Diameter, Self::Resolution, Self::Exposure, Self::Noise, Self::Quantisation];

    /// In words, with the unit of its values.
    pub fn words(self) -> &'static str {
        match self {
            Self::Diameter => "diameter of the marks [pixels]",
            Self::Resolution => "width of the picture [pixels]",
            Self::Exposure => "exposure [ms]",
            Self::Noise => "noise, standard deviation [steps of 255]",
            Self::Quantisation => "bits a pixel",
        }
    }

    /// A camera with this value of it.
    fn set(self, camera: &mut Camera, value: f64) {
        match self {
            Self::Diameter => camera.diameter = value * camera.mm_per_pixel,
            Self::Resolution => {
                let share = value / camera.size[0];
                camera.size = camera.size.map(|side| (side * share).round());
                camera.mm_per_pixel /= share;
            }
            Self::Exposure => camera.exposure = 1e-3 * value,
            Self::Noise => camera.noise = value,
            Self::Quantisation => camera.levels = value.exp2(),
        }
    }

    fn values(self) -> &'static [f64] {
        match self {
            Self::Diameter => &[2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0],
            Self::Resolution => &[180.0, 360.0, 720.0, 1440.0],
            Self::Exposure => &[0.0, 1.0, 2.0, 4.0, 8.0, 16.0, 33.0],
            Self::Noise => &[0.0, 1.0, 2.0, 5.0, 10.0, 20.0],
            Self::Quantisation => &[8.0, 6.0, 5.0, 4.0, 3.0, 2.0],
        }
    }

    /// Levels of noise that each value is measured under.
    fn noises(self) -> &'static [f64] {
        match self {
            Self::Diameter | Self::Resolution | Self::Quantisation => &[0.0, 2.0, 5.0],
            Self::Exposure => &[0.0, 2.0],
            Self::Noise => &[0.0],
        }
    }
}

/// A film of one camera, measured.
#[derive(Clone, Debug)]
pub struct Row {
    /// Varied parameter.
    pub influence: Influence,
    /// Its value.
    pub value: f64,
    /// Noise beside it \[steps of 255\].
    pub noise: f64,
    /// Length of a pixel \[mm\].
    pub mm_per_pixel: f64,
    /// Errors, or which mark was lost.
    pub found: Result<Errors, Lost>,
}

/// Errors of a measured film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Of x and y \[mm\].
    pub place: [Difference; 2],
    /// Of θ \[degrees\].
    pub rotation: Difference,
}

impl Errors {
    /// Root mean square along x and y together, of one of them \[mm\].
    pub fn rms(&self) -> f64 {
        let [x, y] = self.place;
        f64::midpoint(x.rms * x.rms, y.rms * y.rms).sqrt()
    }
}

/// Measures every film of the study, on all cores; rows in the order of the page.
///
/// # Errors
/// A preset that does not run.
pub fn study() -> Result<Vec<Row>, SceneErrors> {
    let history = History::of(&presets::load("skew45-abutment")?)?;
    let of = |influence: Influence| {
        let values = influence.values().iter();
        values.flat_map(move |value| influence.noises().iter().map(move |noise| (influence, *value, *noise)))
    };
    let all: Vec<(Influence, f64, f64)> = Influence::ALL.into_iter().flat_map(of).collect();
    Ok(all.into_par_iter().map(|(influence, value, noise)| row(&history, influence, value, noise)).collect())
}

fn row(history: &History, influence: Influence, value: f64, noise: f64) -> Row {
    let mut camera = Camera { noise, ..Camera::papers() };
    influence.set(&mut camera, value);
    let (noise, mm_per_pixel) = (camera.noise, camera.mm_per_pixel);
    Row { influence, value, noise, mm_per_pixel, found: errors(history, &camera, COUNT) }
}

/// Films a run with a camera and measures the film.
///
/// # Errors
/// A mark that was lost.
///
/// # Panics
/// Never: the scale follows from the table's marks, whose places the layout has.
pub fn errors(history: &History, camera: &Camera, count: u32) -> Result<Errors, Lost> {
    let times: Vec<f64> = (0..count).map(|n| f64::from(n) / FPS).collect();
    let layout = layout(camera);
    let finder = Finder { threshold: Camera::threshold(), least: 2 };
    let first = camera.take(&places(history, camera, times[0]), 0);
    let mut tracker = Tracker::start(&layout, finder, &first)?;
    let calibration = Calibration::of(&layout, tracker.places()).expect("the table's marks have places");
    let mut poses = Poses::start(&layout, calibration, tracker.places());
    let mut all = Vec::with_capacity(times.len());
    for (n, t) in (0..).zip(&times) {
        if n > 0 {
            tracker.follow(&camera.take(&places(history, camera, *t), n))?;
        }
        all.extend(poses.of(tracker.places()));
    }
    let run: Vec<[f64; 3]> = times
        .iter()
        .map(|t| {
            let motion = history.motion(0, *t);
            [motion.displacement.x, motion.displacement.y, motion.theta]
        })
        .collect();
    let found = differences(&times, &all, &run);
    Ok(Errors { place: found.place, rotation: found.rotation.unwrap_or_default() })
}

/// Places of the marks during the exposure about an instant \[pixels\]: those of every instant of it.
fn places(history: &History, camera: &Camera, t: f64) -> Vec<Vec<[f64; 2]>> {
    let at = |t: f64| {
        let motion = history.motion(0, t);
        let (sin, cos) = motion.theta.sin_cos();
        let [x, y] = [motion.displacement.x, motion.displacement.y].map(|d| 1e3 * d);
        let moved = ON_DECK.map(|[a, b]| [x + a * cos - b * sin, y + a * sin + b * cos]);
        ON_TABLE.into_iter().chain(moved).map(|mm| camera.pixel(mm)).collect()
    };
    exposed(t, camera.exposure, history.end()).map(at).collect()
}

fn layout(camera: &Camera) -> Layout {
    let mark = |body: &str, mm: [f64; 2]| MarkPlace { body: body.to_owned(), pixel: camera.pixel(mm), at_mm: Some(mm) };
    let table = ON_TABLE.map(|mm| mark(TABLE, mm));
    let mark = table.into_iter().chain(ON_DECK.map(|mm| mark("deck", mm))).collect();
    Layout { fps: FPS, from_s: 0.0, pictures: None, mm_per_pixel: None, mark }
}
