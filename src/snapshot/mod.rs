//! Scene in, picture out: for the command line, the window's export and anyone's tests.
//!
//! ```no_run
//! use girderbench::{scene::presets, snapshot::{Shot, picture}};
//!
//! let scene = presets::load("skew45-abutment")?;
//! let image = picture(&scene, &Shot::default())?;
//! assert_eq!([image.width, image.height], [1280, 720]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod film;
mod gif;
mod palette;

pub use film::{Frame, film, instants};
pub use gif::{GifError, MOST_FPS, gif};

use crate::render::{Fault, Gpu, GpuError, Image, Quality, Renderer};
use crate::scene::{Overlays, Scene, SceneErrors, ViewPreset};
use crate::sim::History;
use crate::view::{Background, Bending, Bent, Bounds, Camera, DrawList, Target, ViewInput, draw_list, marks};

/// Which instant of a run a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Instant {
    /// When the largest contact force acts; the start of a run without contact.
    #[default]
    Peak,
    /// This time \[s\].
    At(f64),
}

impl Instant {
    /// The time in a run \[s\].
    pub fn of(self, history: &History) -> f64 {
        match self {
            Self::Peak => history.hits().hardest().map_or(0.0, |touch| touch.peak_time),
            Self::At(t) => t,
        }
    }
}

/// How a picture is taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// When.
    pub at: Instant,
    /// Instants whose mean the picture is, as a sensor takes it whose numbers grow with the light \[s\]; `at` alone where there are none.
    pub during: Vec<f64>,
    /// From where; the scene's own view when absent.
    pub view: Option<ViewPreset>,
    /// From exactly where, whatever `view` says: a film's camera stands still.
    pub camera: Option<Camera>,
    /// Width and height \[pixels\].
    pub size: [u32; 2],
    /// Which layers; the scene's own when absent.
    pub overlays: Option<Overlays>,
    /// Background behind the bodies.
    pub background: Background,
    /// Scale of the arrows \[N/m\]; from the run's peak when absent.
    pub force_scale: Option<f64>,
    /// Selected body, contact or device.
    pub selected: Option<Target>,
    /// Title; the scene's name when absent.
    pub title: Option<String>,
    /// How girders that bend are drawn; as rigid ones when absent.
    pub bent: Option<Bending>,
    /// A picture of marks of this diameter alone, for a camera straight above \[m\].
    pub marks: Option<f64>,
}

impl Default for Shot {
    fn default() -> Self {
        Self {
            at: Instant::Peak,
            during: Vec::new(),
            view: None,
            camera: None,
            size: [1280, 720],
            overlays: None,
            background: Background::Studio,
            force_scale: None,
            selected: None,
            title: None,
            bent: None,
            marks: None,
        }
    }
}

impl Shot {
    /// Where this picture of a run is taken from.
    pub fn camera(&self, history: &History) -> Camera {
        let scene = history.scene();
        let aspect = f64::from(self.size[0].max(1)) / f64::from(self.size[1].max(1));
        self.camera.unwrap_or_else(|| match self.view.unwrap_or(scene.view.camera) {
            ViewPreset::Contact => Camera::contact(history, self.at.of(history), aspect),
            other => Camera::preset(other, Bounds::of_scene(scene), aspect),
        })
    }

    /// The draw lists whose mean this picture of a run is.
    pub(super) fn lists(&self, history: &History) -> Vec<DrawList> {
        if self.during.is_empty() {
            return vec![self.list(history)];
        }
        let at = |t: &f64| Self { at: Instant::At(*t), during: Vec::new(), ..self.clone() };
        self.during.iter().map(|t| at(t).list(history)).collect()
    }

    /// The draw list of this picture of a run at its instant.
    pub fn list(&self, history: &History) -> DrawList {
        let scene = history.scene();
        let t = self.at.of(history);
        let camera = self.camera(history);
        let input = ViewInput {
            scene,
            history: Some(history),
            t,
            camera: &camera,
            overlays: self.overlays.unwrap_or(scene.view.overlays),
            force_scale: self.force_scale,
            selected: self.selected.as_slice(),
            kept: &[],
            exaggeration: 1.0,
            bent: self.bent.and_then(|bending| Bent::of(history, bending)),
            clear: &[],
            size: self.size,
            pixels_per_point: points(self.size),
            background: self.background,
            title: self.title.as_deref(),
        };
        match self.marks {
            Some(diameter) => marks::marked_list(&input, history, diameter),
            None => draw_list(&input),
        }
    }
}

/// Pixels to a point: 1 at 1280 × 720, in proportion above; texts shrink more slowly below, to stay readable.
pub fn points(size: [u32; 2]) -> f32 {
    let share = (size[0] as f32 / 1280.0).min(size[1] as f32 / 720.0);
    if share >= 1.0 { share } else { share.max(0.05).sqrt() }
}

/// A device with its pipelines, kept for many pictures.
#[derive(Debug)]
pub struct Studio {
    /// Device that draws.
    pub gpu: Gpu,
    renderer: Renderer,
}

impl Studio {
    /// Brings up a device without a window; the quality suits it unless given.
    ///
    /// # Errors
    /// When there is no adapter, not even in software.
    pub fn open(quality: Option<Quality>) -> Result<Self, GpuError> {
        let gpu = Gpu::headless()?;
        let quality = quality.unwrap_or_else(|| Quality::for_stills(&gpu.adapter));
        let renderer = Renderer::new(&gpu, quality);
        Ok(Self { gpu, renderer })
    }

    /// A picture of a run.
    ///
    /// # Errors
    /// When the size is not one that the device draws.
    pub fn shoot(&mut self, history: &History, shot: &Shot) -> Result<Image, GpuError> {
        self.expose(&shot.lists(history))
    }

    /// The mean of pictures of draw lists; lists that are alike are drawn once.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub(super) fn expose(&mut self, lists: &[DrawList]) -> Result<Image, GpuError> {
        let mut images: Vec<Image> = Vec::with_capacity(lists.len());
        for (n, list) in lists.iter().enumerate() {
            let known = images.last().filter(|_| n > 0 && lists[n - 1] == *list).cloned();
            images.push(match known {
                Some(image) => image,
                None => self.draw(list)?,
            });
        }
        Ok(Image::mean(&images))
    }

    /// A picture of a draw list. Should the device be lost, it is drawn on another: a film goes on.
    ///
    /// # Errors
    /// When the size is not one that the device draws, or it has failed and so has the next.
    pub fn draw(&mut self, list: &DrawList) -> Result<Image, GpuError> {
        match self.renderer.picture(&self.gpu, list, list.size) {
            Err(GpuError::Fault(Fault::Lost(_))) => {
                let culls = self.renderer.culls();
                *self = Self::open(Some(self.renderer.quality()))?;
                self.set_culling(culls);
                self.renderer.picture(&self.gpu, list, list.size)
            }
            other => other,
        }
    }

    /// Whether instances out of view are left out, as they are unless told otherwise; the picture is the same.
    pub fn set_culling(&mut self, culls: bool) {
        self.renderer.set_culling(culls);
    }

    /// The passes that pictures so far have needed.
    pub fn passes(&self) -> Vec<&'static str> {
        self.renderer.built()
    }

    /// Metadata of a picture's file: keywords and texts.
    pub fn texts(&self, scene: &Scene, t: f64) -> [(&'static str, String); 4] {
        [
            ("Software", format!("girderbench {}", env!("CARGO_PKG_VERSION"))),
            ("Source", self.gpu.adapter.to_string()),
            ("Title", scene.name.clone()),
            ("Time", format!("{t:?} s")),
        ]
    }
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum SnapshotError {
    /// The scene cannot be run.
    #[error(transparent)]
    Scene(#[from] SceneErrors),
    /// Nothing draws it.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

/// Runs a scene and takes one picture of it.
///
/// # Errors
/// When the scene cannot be run, or nothing draws it.
pub fn picture(scene: &Scene, shot: &Shot) -> Result<Image, SnapshotError> {
    let history = History::of(scene)?;
    Ok(Studio::open(None)?.shoot(&history, shot)?)
}
