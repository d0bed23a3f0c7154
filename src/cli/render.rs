//! `girderbench render`: pictures of a run.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::compute::compute;
use super::{Console, Failure, SceneArgs};
use crate::files;
use crate::render::{GpuError, Quality};
use crate::scene::{Overlays, ViewPreset};
use crate::sim::History;
use crate::snapshot::{Instant, Shot, Studio};
use crate::view::Background;

/// Draw pictures of a scene's run
#[derive(Debug, clap::Args)]
pub(super) struct RenderArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// When [s], or `peak`: the instant of the largest contact force; may be given many times
    #[arg(long, value_name = "S|peak", value_parser = instant, default_value = "peak", allow_negative_numbers = true)]
    at: Vec<Instant>,
    /// Where the camera stands; the scene's own view when left out. `contact` frames the hardest hit
    #[arg(long, value_enum, value_name = "VIEW")]
    view: Option<View>,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "1280x720")]
    size: Size,
    /// A folder, or a file ending in .png for a single picture
    #[arg(long, value_name = "DIR|FILE", default_value = "out")]
    out: PathBuf,
    /// Layers to draw beside the scene's own, separated by commas
    #[arg(long, value_enum, value_name = "LAYER", value_delimiter = ',')]
    show: Vec<Layer>,
    /// Layers to leave out, separated by commas
    #[arg(long, value_enum, value_name = "LAYER", value_delimiter = ',')]
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

#[derive(Clone, Copy, Debug, ValueEnum)]
enum View {
    Iso,
    Top,
    Side,
    Contact,
}

impl View {
    fn preset(self) -> ViewPreset {
        match self {
            Self::Iso => ViewPreset::Iso,
            Self::Top => ViewPreset::Top,
            Self::Side => ViewPreset::Side,
            Self::Contact => ViewPreset::Contact,
        }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Behind {
    Studio,
    White,
    Transparent,
    Dark,
}

impl Behind {
    fn background(self) -> Background {
        match self {
            Self::Studio => Background::Studio,
            Self::White => Background::White,
            Self::Transparent => Background::Transparent,
            Self::Dark => Background::Dark,
        }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Work {
    Auto,
    Draft,
    Fine,
}

impl Work {
    fn quality(self) -> Option<Quality> {
        match self {
            Self::Auto => None,
            Self::Draft => Some(Quality::DRAFT),
            Self::Fine => Some(Quality::FINE),
        }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Layer {
    Grid,
    Bearings,
    Gap,
    Contacts,
    Normal,
    Tangential,
    Resultant,
    Damping,
    Cones,
    Axes,
    Legend,
    Title,
    Names,
}

impl Layer {
    fn switch(self, overlays: &mut Overlays) -> &mut bool {
        match self {
            Self::Grid => &mut overlays.grid,
            Self::Bearings => &mut overlays.bearings,
            Self::Gap => &mut overlays.gap,
            Self::Contacts => &mut overlays.contacts,
            Self::Normal => &mut overlays.normal,
            Self::Tangential => &mut overlays.tangential,
            Self::Resultant => &mut overlays.resultant,
            Self::Damping => &mut overlays.damping,
            Self::Cones => &mut overlays.cones,
            Self::Axes => &mut overlays.axes,
            Self::Legend => &mut overlays.legend,
            Self::Title => &mut overlays.title,
            Self::Names => &mut overlays.names,
        }
    }
}

/// Width and height \[pixels\].
#[derive(Clone, Copy, Debug)]
struct Size([u32; 2]);

fn size(text: &str) -> Result<Size, String> {
    let read = |side: &str| side.trim().parse::<u32>().ok().filter(|s| (16..=16_384).contains(s));
    let sides = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some([read(w)?, read(h)?]));
    sides.map(Size).ok_or_else(|| "give width x height, each from 16 to 16384, such as 1280x720".to_owned())
}

fn instant(text: &str) -> Result<Instant, String> {
    match text.parse::<f64>() {
        Ok(t) if t.is_finite() && t >= 0.0 => Ok(Instant::At(t)),
        _ if text == "peak" => Ok(Instant::Peak),
        _ => Err("give a time of 0 s or later, or `peak`".to_owned()),
    }
}

impl RenderArgs {
    fn shot(&self, at: Instant, mut overlays: Overlays) -> Shot {
        self.show.iter().for_each(|layer| *layer.switch(&mut overlays) = true);
        self.hide.iter().for_each(|layer| *layer.switch(&mut overlays) = false);
        Shot {
            at,
            view: self.view.map(View::preset),
            size: self.size.0,
            overlays: Some(overlays),
            background: self.background.background(),
            force_scale: self.force_scale,
            selected: None,
            title: self.title.clone(),
        }
    }

    /// Where a picture goes; a file of that name only if there is one picture.
    fn path(&self, history: &History, at: Instant) -> Result<PathBuf, Failure> {
        let is_file = self.out.extension().is_some_and(|e| e.eq_ignore_ascii_case("png"));
        if !is_file {
            return Ok(self.out.join(file_name(history, self.view.map(View::preset), at)));
        }
        if self.at.len() > 1 {
            let (out, count) = (self.out.display(), self.at.len());
            return Err(Failure::Input(format!("--out {out}: one file for {count} pictures: give a folder")));
        }
        Ok(self.out.clone())
    }
}

/// `skew45-abutment-contact-peak.png`, `skew45-abutment-iso-1.25s.png`.
fn file_name(history: &History, view: Option<ViewPreset>, at: Instant) -> String {
    let scene = history.scene();
    let view = match view.unwrap_or(scene.view.camera) {
        ViewPreset::Iso => "iso",
        ViewPreset::Top => "top",
        ViewPreset::Side => "side",
        ViewPreset::Contact => "contact",
    };
    let when = match at {
        Instant::Peak => "peak".to_owned(),
        Instant::At(t) => format!("{t}s"),
    };
    // A name may hold anything; a file's name may not.
    let name: String =
        scene.name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' }).collect();
    format!("{name}-{view}-{when}.png")
}

/// Runs the scene and writes its pictures.
///
/// # Errors
/// Bad input, a time that the run does not reach, nothing that draws, a file that cannot be written; a run that gave up,
/// after its pictures have been written.
pub(super) fn run(args: &RenderArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.scene.load()?;
    // Before the run, so that a machine that cannot draw says so at once.
    let mut studio = Studio::open(args.quality.quality()).map_err(Failure::from)?;
    let history = compute(&scene)?.history;
    for &at in &args.at {
        reached(&history, at, console)?;
        let path = args.path(&history, at)?;
        let image = studio.shoot(&history, &args.shot(at, scene.view.overlays))?;
        let png = image.to_png(&studio.texts(&scene, at.of(&history)));
        make_folder(&path)?;
        files::write_atomic(&path, &png)?;
        console.print(&format!("{}\n", path.display()));
    }
    match history.stop() {
        Some(stop) => Err(Failure::GaveUp { scene: scene.name.clone(), stop: stop.clone() }),
        None => Ok(()),
    }
}

fn reached(history: &History, at: Instant, console: &mut Console) -> Result<(), Failure> {
    match at {
        Instant::At(t) if t > history.end() => {
            let end = history.end();
            Err(Failure::Input(format!("--at {t}: the run ends at {end} s: give a time from 0 to {end}")))
        }
        Instant::Peak if history.hardest().is_none() => {
            console.note("nothing touches in this run: `--at peak` shows its start");
            Ok(())
        }
        _ => Ok(()),
    }
}

fn make_folder(path: &Path) -> Result<(), Failure> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty());
    folder.map_or(Ok(()), |folder| {
        std::fs::create_dir_all(folder).map_err(|e| {
            let shown = folder.display();
            Failure::Input(format!("--out {shown}: the folder cannot be made ({e}): choose one that may be written to"))
        })
    })
}

impl From<GpuError> for Failure {
    fn from(error: GpuError) -> Self {
        match error {
            GpuError::Size(..) => Self::Input(format!("--size: {error}")),
            other => Self::NoPicture(other.to_string()),
        }
    }
}
