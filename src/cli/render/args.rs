//! The flags of `render`, and the pictures that they ask for: how each is taken, where it goes.

use std::path::{Path, PathBuf};

use super::choices::{Behind, BendingFactor, Size, Work, bending_factor, frame_rate, instant, layer, size, view};
use super::mark_args::{MarkArgs, PAPERS_CAMERA};
use crate::cli::args::{SceneArgs, Threads, not_negative, positive};
use crate::cli::digits::six;
use crate::cli::failure::Failure;
use crate::cli::limits::after_end;
use crate::cli::waves::{known_in, section_force};
use crate::files::{self, as_file_name};
use crate::language::{Text, said};
use crate::scene::{Layer, Scene, ViewPreset};
use crate::sim::{History, OfSection};
use crate::snapshot::{Instant, Shot};
use crate::view::Bending;

/// Extensions of pictures and films in formats that are not written.
const OTHER_FORMATS: &[&str] = &[
    "apng", "avi", "avif", "bmp", "eps", "heic", "jpe", "jpeg", "jpg", "jxl", "m4v", "mkv", "mov", "mp4", "mpeg",
    "mpg", "pdf", "ppm", "ps", "svg", "tga", "tif", "tiff", "webm", "webp", "wmv",
];

/// Draw pictures of a scene's run
#[derive(Debug, clap::Args)]
pub(crate) struct RenderArgs {
    #[command(flatten)]
    pub(super) scene: SceneArgs,
    #[command(flatten)]
    pub(super) threads: Threads,
    /// When [s], or `peak`: the instant of the largest contact force; may be given many times
    #[arg(long, value_name = "S|peak", value_parser = instant, default_value = "peak", allow_negative_numbers = true)]
    pub(super) at: Vec<Instant>,
    /// A film: this many pictures at even intervals, seen by a camera that stands still, numbered from 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000), conflicts_with = "at", group = "film", allow_negative_numbers = true)]
    pub(super) frames: Option<u32>,
    #[command(flatten)]
    pub(super) marks: MarkArgs,
    /// When the film begins [s]
    #[arg(long, value_name = "S", value_parser = not_negative, requires = "film", default_value_t = 0.0, allow_negative_numbers = true)]
    pub(super) from: f64,
    /// When the film ends [s]; the end of the run when left out
    #[arg(long, value_name = "S", value_parser = not_negative, requires = "film", allow_negative_numbers = true)]
    pub(super) to: Option<f64>,
    /// Frames a second of a GIF, at most 50: how fast it is played
    #[arg(long, value_name = "HZ", value_parser = frame_rate, requires = "frames", default_value_t = 25.0, allow_negative_numbers = true)]
    pub(super) fps: f64,
    /// Where the camera stands; the scene's own view when left out. `contact` frames the hardest hit
    #[arg(long, value_parser = view(), value_name = "VIEW")]
    view: Option<ViewPreset>,
    /// Width and height in pixels; 1280x720 when left out, 720x465 with --marks
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<Size>,
    /// A folder, a file ending in .png for a single picture, or one ending in .gif for a film
    #[arg(long, value_name = "DIR|FILE", default_value = "out")]
    pub(super) out: PathBuf,
    /// Layers to draw beside the scene's own, separated by commas
    #[arg(long, value_parser = layer(), value_name = "LAYER", value_delimiter = ',')]
    show: Vec<Layer>,
    /// Layers to leave out, separated by commas
    #[arg(long, value_parser = layer(), value_name = "LAYER", value_delimiter = ',')]
    hide: Vec<Layer>,
    /// What stands behind the bodies
    #[arg(long, value_enum, default_value_t = Behind::Studio)]
    background: Behind,
    /// How much work a picture may cost; `auto` steps down where a processor draws
    #[arg(long, value_enum, default_value_t = Work::Auto)]
    pub(super) quality: Work,
    /// Scale of the force arrows [N per m]; from the run's peak when left out
    #[arg(long, value_name = "N_PER_M", value_parser = positive, allow_negative_numbers = true)]
    force_scale: Option<f64>,
    /// Draw girders that bend as they are bent, so many times larger; `auto` draws the largest deflection as 3 % of the length
    #[arg(long, value_name = "FACTOR|auto", value_parser = bending_factor, allow_negative_numbers = true)]
    bent: Option<BendingFactor>,
    /// Colour them by a section force: axial (N), shear (Q), moment (M), stress of the extreme fibre; in space `shear_z`, `moment_y`,
    /// torque, too
    #[arg(long, value_name = "FORCE", value_parser = section_force(), requires = "bent")]
    force: Option<OfSection>,
    /// Title; the scene's name when left out
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
}

/// A picture that is wanted: where it goes, and how it is taken.
pub(super) struct Wanted {
    pub(super) path: PathBuf,
    pub(super) shot: Shot,
}

impl RenderArgs {
    pub(super) fn shot(&self, at: Instant, scene: &Scene) -> Shot {
        let mut overlays = scene.view.overlays;
        self.show.iter().for_each(|layer| *(layer.switch)(&mut overlays) = true);
        self.hide.iter().for_each(|layer| *(layer.switch)(&mut overlays) = false);
        Shot {
            at,
            during: Vec::new(),
            view: self.view,
            camera: None,
            size: self.size(),
            overlays: Some(overlays),
            background: self.background.background(),
            force_scale: self.force_scale,
            selected: None,
            title: self.title.clone(),
            bent: self.bent.map(|factor| Bending { factor: factor.0, force: self.force }),
            marks: self.marks.diameter(scene),
        }
    }

    /// The section force that colours girders.
    ///
    /// # Errors
    /// One that the scene's girders have not.
    pub(super) fn force_of(&self, scene: &Scene) -> Result<Option<OfSection>, Failure> {
        self.force.map(|force| known_in(force, scene.kind).map(|()| force)).transpose()
    }

    /// Width and height \[pixels\].
    pub(super) fn size(&self) -> [u32; 2] {
        let usual = if self.marks.given() { PAPERS_CAMERA } else { Shot::default().size };
        self.size.map_or(usual, |size| size.0)
    }

    /// When the film begins and ends \[s\].
    ///
    /// # Errors
    /// A span that the run does not reach or that runs backwards.
    pub(super) fn span(&self, history: &History) -> Result<(f64, f64), Failure> {
        let (from, to) = (self.from, self.to.unwrap_or(history.end()));
        reaches(history, "--from", from)?;
        reaches(history, "--to", to)?;
        if from > to {
            let [to, from] = [to, from].map(six);
            return Err(Failure::Input(said!("wrong-film-backwards", "to" => to, "from" => from)));
        }
        Ok((from, to))
    }

    /// Refuses a file for more pictures than one, and a folder that cannot be written to, before anything is computed.
    pub(super) fn check_out(&self) -> Result<(), Failure> {
        self.refuse_other_formats()?;
        self.check_marks()?;
        let count = self.frames.map_or(self.at.len(), |frames| frames as usize);
        if let Some(gif) = self.gif_file() {
            return self.check_gif(gif);
        }
        match self.out_file() {
            Some(file) if count > 1 => {
                let out = file.display().to_string();
                Err(Failure::Input(said!("wrong-one-file", "out" => out, "count" => count)))
            }
            Some(file) => Ok(files::check_folder(file.parent().unwrap_or(Path::new("")))?),
            None => Ok(files::check_folder(&self.out)?),
        }
    }

    /// A film of marks is a folder of pictures with their layout, seen from above.
    fn check_marks(&self) -> Result<(), Failure> {
        if !self.marks.given() {
            return Ok(());
        }
        match self.view {
            Some(other) if other != ViewPreset::Top => {
                Err(Failure::Input(said!("wrong-marks-view", "view" => other.label())))
            }
            _ if self.out_file().or(self.gif_file()).is_some() => {
                Err(Failure::Input(said!("wrong-marks-file", "out" => self.out.display().to_string())))
            }
            _ => Ok(()),
        }
    }

    /// Refuses a file in a format that is not written; a folder may have any name once it is there.
    fn refuse_other_formats(&self) -> Result<(), Failure> {
        let extension = self.out.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        match extension {
            Some(other) if OTHER_FORMATS.contains(&other.as_str()) && !self.out.is_dir() => {
                let out = self.out.display().to_string();
                Err(Failure::Input(said!("wrong-picture-format", "out" => out, "format" => other)))
            }
            _ => Ok(()),
        }
    }

    fn check_gif(&self, gif: &Path) -> Result<(), Failure> {
        match (self.frames, self.background) {
            (None, _) => Err(Failure::Input(said!("wrong-gif-frames", "out" => gif.display().to_string()))),
            (Some(_), Behind::Transparent) => Err(Failure::Input(Text::new("wrong-gif-background").into())),
            _ => Ok(files::check_folder(gif.parent().unwrap_or(Path::new("")))?),
        }
    }

    /// The one picture that is asked for, if `--out` names one.
    fn out_file(&self) -> Option<&Path> {
        self.out_with("png")
    }

    /// The one film that is asked for, if `--out` names one.
    pub(super) fn gif_file(&self) -> Option<&Path> {
        self.out_with("gif")
    }

    fn out_with(&self, extension: &str) -> Option<&Path> {
        let is_file = self.out.extension().is_some_and(|e| e.eq_ignore_ascii_case(extension));
        is_file.then_some(self.out.as_path())
    }

    /// `skew45-abutment-contact-peak.png`, `skew45-abutment-iso-1.25s.png` in the folder, or the file that is asked for.
    pub(super) fn path(&self, history: &History, when: &str) -> PathBuf {
        if let Some(file) = self.out_file() {
            return file.to_owned();
        }
        let scene = history.scene();
        let view = if self.marks.given() { "marks" } else { self.view.unwrap_or(scene.view.camera).label() };
        let name = as_file_name(&scene.name);
        self.out.join(format!("{name}-{view}-{when}.png"))
    }
}

/// Refuses a time after the end of the run.
pub(super) fn reaches(history: &History, flag: &str, t: f64) -> Result<(), Failure> {
    if t <= history.end() { Ok(()) } else { Err(after_end(flag, t, history)) }
}
