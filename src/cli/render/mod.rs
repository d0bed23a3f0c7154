//! `girderbench render`: pictures of a run, one device for all of them.

mod choices;
mod film;

use std::path::{Path, PathBuf};

use choices::{Behind, Size, Work, frame_rate, instant, layer, size, view};

use super::compute::compute_as_asked;
use super::{Console, Failure, SceneArgs};
use crate::files;
use crate::render::GpuError;
use crate::scene::{Layer, Scene, ViewPreset};
use crate::sim::History;
use crate::snapshot::{Instant, Shot, Studio};

/// Draw pictures of a scene's run
#[derive(Debug, clap::Args)]
pub(super) struct RenderArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// When [s], or `peak`: the instant of the largest contact force; may be given many times
    #[arg(long, value_name = "S|peak", value_parser = instant, default_value = "peak", allow_negative_numbers = true)]
    at: Vec<Instant>,
    /// A film: this many pictures at even intervals, seen by a camera that stands still, numbered from 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000), conflicts_with = "at")]
    frames: Option<u32>,
    /// When the film begins [s]
    #[arg(long, value_name = "S", value_parser = super::args::not_negative, requires = "frames", default_value_t = 0.0, allow_negative_numbers = true)]
    from: f64,
    /// When the film ends [s]; the end of the run when left out
    #[arg(long, value_name = "S", value_parser = super::args::not_negative, requires = "frames", allow_negative_numbers = true)]
    to: Option<f64>,
    /// Frames a second of a GIF, at most 50: how fast it is played
    #[arg(long, value_name = "HZ", value_parser = frame_rate, requires = "frames", default_value_t = 25.0, allow_negative_numbers = true)]
    fps: f64,
    /// Where the camera stands; the scene's own view when left out. `contact` frames the hardest hit
    #[arg(long, value_parser = view(), value_name = "VIEW")]
    view: Option<ViewPreset>,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "1280x720")]
    size: Size,
    /// A folder, a file ending in .png for a single picture, or one ending in .gif for a film
    #[arg(long, value_name = "DIR|FILE", default_value = "out")]
    out: PathBuf,
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
    quality: Work,
    /// Scale of the force arrows [N per m]; from the run's peak when left out
    #[arg(long, value_name = "N_PER_M", value_parser = super::args::positive, allow_negative_numbers = true)]
    force_scale: Option<f64>,
    /// Title; the scene's name when left out
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
}

/// A picture that is wanted: where it goes, and how it is taken.
struct Wanted {
    path: PathBuf,
    shot: Shot,
}

impl RenderArgs {
    fn shot(&self, at: Instant, scene: &Scene) -> Shot {
        let mut overlays = scene.view.overlays;
        self.show.iter().for_each(|layer| *(layer.switch)(&mut overlays) = true);
        self.hide.iter().for_each(|layer| *(layer.switch)(&mut overlays) = false);
        Shot {
            at,
            view: self.view,
            camera: None,
            size: self.size.0,
            overlays: Some(overlays),
            background: self.background.background(),
            force_scale: self.force_scale,
            selected: None,
            title: self.title.clone(),
        }
    }

    /// Refuses a file for more pictures than one, and a folder that cannot be written to, before anything is computed.
    fn check_out(&self) -> Result<(), Failure> {
        let count = self.frames.map_or(self.at.len(), |frames| frames as usize);
        if let Some(gif) = self.gif_file() {
            return self.check_gif(gif);
        }
        match self.out_file() {
            Some(file) if count > 1 => {
                let out = file.display();
                Err(Failure::Input(format!("--out {out}: one file for {count} pictures: give a folder")))
            }
            Some(file) => Ok(files::check_folder(file.parent().unwrap_or(Path::new("")))?),
            None => Ok(files::check_folder(&self.out)?),
        }
    }

    fn check_gif(&self, gif: &Path) -> Result<(), Failure> {
        let out = gif.display();
        match (self.frames, self.background) {
            (None, _) => Err(Failure::Input(format!("--out {out}: a GIF is a film: say how many --frames"))),
            (Some(_), Behind::Transparent) => {
                let remedy = "choose another, or a folder of PNG pictures";
                Err(Failure::Input(format!("--background transparent: a GIF film has none: {remedy}")))
            }
            _ => Ok(files::check_folder(gif.parent().unwrap_or(Path::new("")))?),
        }
    }

    /// The one picture that is asked for, if `--out` names one.
    fn out_file(&self) -> Option<&Path> {
        self.out_with("png")
    }

    /// The one film that is asked for, if `--out` names one.
    fn gif_file(&self) -> Option<&Path> {
        self.out_with("gif")
    }

    fn out_with(&self, extension: &str) -> Option<&Path> {
        let is_file = self.out.extension().is_some_and(|e| e.eq_ignore_ascii_case(extension));
        is_file.then_some(self.out.as_path())
    }

    /// Every picture that is asked for.
    fn wanted(&self, history: &History, console: &mut Console) -> Result<Vec<Wanted>, Failure> {
        match self.frames {
            Some(count) => film::frames(self, history, count),
            None => self.at.iter().map(|&at| self.still(history, at, console)).collect(),
        }
    }

    fn still(&self, history: &History, at: Instant, console: &mut Console) -> Result<Wanted, Failure> {
        reached(history, at, console)?;
        let when = match at {
            Instant::Peak => "peak".to_owned(),
            Instant::At(t) => format!("{t}s"),
        };
        Ok(Wanted { path: self.path(history, &when), shot: self.shot(at, history.scene()) })
    }

    /// `skew45-abutment-contact-peak.png`, `skew45-abutment-iso-1.25s.png` in the folder, or the file that is asked for.
    fn path(&self, history: &History, when: &str) -> PathBuf {
        if let Some(file) = self.out_file() {
            return file.to_owned();
        }
        let scene = history.scene();
        let view = self.view.unwrap_or(scene.view.camera).label();
        // A name may hold anything; a file's name may not.
        let name: String =
            scene.name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' }).collect();
        self.out.join(format!("{name}-{view}-{when}.png"))
    }
}

/// Runs the scene and writes its pictures: all of them, or none.
///
/// # Errors
/// Bad input, a time that the run does not reach, nothing that draws, a file that cannot be written; a run that gave up,
/// after its pictures have been written.
pub(super) fn run(args: &RenderArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.scene.load()?;
    args.check_out()?;
    // Before the run, so that a machine that cannot draw says so at once.
    let mut studio = Studio::open(args.quality.quality()).map_err(Failure::from)?;
    let history = compute_as_asked(&scene)?.history;
    let wanted = args.wanted(&history, console)?;
    console.print(&film::take(args, &mut studio, &history, &wanted)?);
    match history.stop() {
        Some(stop) => Err(Failure::GaveUp { scene: scene.name.clone(), stop: stop.clone() }),
        None => Ok(()),
    }
}

fn reached(history: &History, at: Instant, console: &mut Console) -> Result<(), Failure> {
    match at {
        Instant::At(t) => reaches(history, "--at", t),
        Instant::Peak => {
            if history.hardest().is_none() {
                console.note("nothing touches in this run: `--at peak` shows its start");
            }
            Ok(())
        }
    }
}

/// Refuses a time after the end of the run.
fn reaches(history: &History, flag: &str, t: f64) -> Result<(), Failure> {
    let end = history.end();
    if t <= end {
        return Ok(());
    }
    Err(Failure::Input(format!("{flag} {t}: the run ends at {end} s: give a time from 0 to {end}")))
}

impl From<GpuError> for Failure {
    fn from(error: GpuError) -> Self {
        match error {
            GpuError::Size(..) => Self::Input(format!("--size: {error}")),
            other => Self::NoPicture(other.to_string()),
        }
    }
}
