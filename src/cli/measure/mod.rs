//! `girderbench measure`: the motion of bodies from pictures of marks on them.

mod pictures;
mod reference;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::args::positive;
use super::console::Console;
use super::digits::six;
use super::failure::Failure;
use super::output::write_files;
use super::plot_files::plot_files;
use super::progress::Progress;
use crate::files::{self, as_file_name};
use crate::language::{Text, said};
use crate::measure::{Calibration, Finder, Grey, LAYOUT, Layout, MOST_MARKS, Poses, Tracker};
use crate::scene::shown::escaped;
use crate::study::measured::{Difference, Differences, Film, Measured, differences};
use reference::Reference;

/// Find the motion of bodies in pictures of marks on them: x, y and rotation against time
#[derive(Clone, Debug, clap::Args)]
pub(super) struct MeasureArgs {
    /// A folder of PNG pictures, taken in the order of their names, or the pictures themselves
    #[arg(value_name = "DIR|PNG", required = true)]
    pictures: Vec<PathBuf>,
    /// What is marked and where, as TOML; `marks.toml` beside the pictures when left out, and where there is none every mark of
    /// the first picture, on one body
    #[arg(long, value_name = "FILE")]
    layout: Option<PathBuf>,
    /// Pictures a second, whatever the layout says; 30 without a layout [Hz]
    #[arg(long, value_name = "HZ", value_parser = positive, allow_negative_numbers = true)]
    fps: Option<f64>,
    /// Length of a pixel, whatever the layout says [mm]
    #[arg(long, value_name = "MM", value_parser = positive, allow_negative_numbers = true)]
    mm_per_pixel: Option<f64>,
    /// Brightness above which a pixel is of a mark, 0 to 255; half-way between background and brightest when left out
    #[arg(long, value_name = "B", value_parser = brightness)]
    threshold: Option<f32>,
    /// Fewest pixels of a mark
    #[arg(long, value_name = "N", default_value_t = 6, allow_negative_numbers = true)]
    least_pixels: usize,
    #[command(flatten)]
    reference: reference::ReferenceArgs,
    /// Write table, JSON and plots into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

fn brightness(text: &str) -> Result<f32, String> {
    text.parse().ok().filter(|b| (0.0..255.0).contains(b)).ok_or_else(|| Text::new("wrong-brightness").into())
}

/// Does it.
///
/// # Errors
/// Pictures that cannot be read, marks that are missing, merged or cut off, a layout without a scale, a run without such a body;
/// files that cannot be written.
pub(super) fn run(args: &MeasureArgs, console: &mut Console) -> Result<(), Failure> {
    if let Some(out) = &args.out {
        files::check_folder(out)?;
    }
    let layout = args.read_layout()?;
    let paths = pictures::listed(&args.pictures, layout.as_ref().and_then(|layout| layout.pictures))?;
    let reference = args.reference.read()?;
    let first = pictures::read(&paths[0])?;
    let finder = args.finder(&first, &paths[0])?;
    let layout = args.complete(layout, finder, &first, &paths[0])?;
    let film = follow(&layout, finder, &first, &paths)?;
    console.print(&heading(&paths, &first, &layout, finder, &film));
    let mut all = Vec::new();
    for (number, body) in film.bodies.iter().enumerate() {
        console.print(&extent(body));
        let run = reference.as_ref().map(|reference| reference.of(&body.body, &film.times)).transpose()?;
        let found = run.as_ref().map(|run| differences(&film.times, &body.poses, run));
        if let Some(found) = &found {
            console.print(&against(found, film.mm_per_pixel));
        }
        all.push((number, run, found));
    }
    let Some(out) = &args.out else { return Ok(()) };
    let files = written(&film, &all, reference.as_ref())?;
    console.print(&write_files(out, &files)?);
    Ok(())
}

impl MeasureArgs {
    /// The layout that is named, or the one beside the pictures.
    fn read_layout(&self) -> Result<Option<Layout>, Failure> {
        let beside = match &self.pictures[..] {
            [folder] if folder.is_dir() => Some(folder.join(LAYOUT)).filter(|path| path.is_file()),
            _ => None,
        };
        let Some(path) = self.layout.clone().or(beside) else { return Ok(None) };
        let wrong = |what: &dyn std::fmt::Display| Failure::Input(format!("{}: {what}", path.display()));
        let text = String::from_utf8(files::read_input(&path)?).map_err(|_| wrong(&Text::new("measure-no-text")))?;
        Layout::parse(&text).map(Some).map_err(|error| wrong(&error))
    }

    fn finder(&self, first: &Grey, path: &Path) -> Result<Finder, Failure> {
        let threshold = self
            .threshold
            .or_else(|| Finder::threshold_of(first))
            .ok_or_else(|| Failure::Input(format!("{}: {}", path.display(), Text::new("measure-dark"))))?;
        Ok(Finder { threshold, least: self.least_pixels })
    }

    /// The layout with what the flags say.
    fn complete(&self, layout: Option<Layout>, finder: Finder, first: &Grey, path: &Path) -> Result<Layout, Failure> {
        /// Of the paper's camera \[Hz\].
        const FPS: f64 = 30.0;
        let mut layout = match layout {
            Some(layout) => layout,
            None => Layout::unknown(FPS, None, finder.find(first).iter().map(|mark| mark.at)),
        };
        let count = layout.mark.len();
        if count == 0 || count > MOST_MARKS {
            let least = finder.least;
            let what = said!("measure-count", "count" => count, "least" => least);
            return Err(Failure::Input(format!("{}: {what}", path.display())));
        }
        layout.fps = self.fps.unwrap_or(layout.fps);
        layout.mm_per_pixel = self.mm_per_pixel.or(layout.mm_per_pixel);
        Ok(layout)
    }
}

/// Follows the marks through all pictures.
fn follow(layout: &Layout, finder: Finder, first: &Grey, paths: &[PathBuf]) -> Result<Film, Failure> {
    let in_picture = |number: usize, error: &dyn std::fmt::Display| {
        let picture = said!("measure-picture", "number" => number + 1);
        Failure::Input(format!("{} ({picture}): {error}", paths[number].display()))
    };
    let mut tracker = Tracker::start(layout, finder, first).map_err(|error| in_picture(0, &error))?;
    let calibration = Calibration::of(layout, tracker.places()).map_err(|error| in_picture(0, &error))?;
    let mut poses = Poses::start(layout, calibration, tracker.places());
    let names = layout.bodies();
    let mut bodies: Vec<Measured> =
        names.iter().map(|name| Measured { body: (*name).to_owned(), poses: Vec::new() }).collect();
    let mut progress = Progress::over(paths.len() as f64, Text::new("progress-pictures"));
    for (number, path) in paths.iter().enumerate() {
        if number > 0 {
            let image = pictures::read(path)?;
            tracker.follow(&image).map_err(|error| in_picture(number, &error))?;
        }
        bodies.iter_mut().zip(poses.of(tracker.places())).for_each(|(body, pose)| body.poses.push(pose));
        progress.show(number as f64 + 1.0);
    }
    progress.done();
    let times = (0..paths.len()).map(|n| layout.from_s + n as f64 / layout.fps).collect();
    Ok(Film { times, mm_per_pixel: calibration.mm_per_pixel(), bodies })
}

fn heading(paths: &[PathBuf], first: &Grey, layout: &Layout, finder: Finder, film: &Film) -> String {
    let folder = paths[0].parent().unwrap_or(Path::new("")).display().to_string();
    let pictures = said!(
        "measure-film",
        "folder" => escaped(&folder),
        "count" => paths.len(),
        "width" => first.width,
        "height" => first.height,
        "fps" => six(layout.fps),
        "from" => six(layout.from_s)
    );
    let marks = said!(
        "measure-marks",
        "marks" => layout.mark.len(),
        "threshold" => finder.threshold.to_string(),
        "scale" => format!("{:.5}", film.mm_per_pixel)
    );
    format!("{pictures}\n  {marks}\n")
}

/// Extremes of a body's motion.
fn extent(Measured { body, poses }: &Measured) -> String {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        said!("measure-range", "low" => format!("{low:.3}"), "high" => format!("{high:.3}"))
    };
    let [x, y] = [0, 1].map(|axis| range(&mut poses.iter().map(|pose| pose.displacement[axis])));
    let turned = poses.first().is_some_and(|pose| pose.rotation.is_some());
    let rotation = range(&mut poses.iter().filter_map(|pose| pose.rotation.map(f64::to_degrees)));
    let rotation = if turned { format!("θ {rotation}°") } else { Text::new("measure-one-mark").into() };
    format!("{}\n", said!("measure-extent", "body" => escaped(body), "x" => x, "y" => y, "rotation" => rotation))
}

/// How it differs from the run.
fn against(found: &Differences, mm_per_pixel: f64) -> String {
    let mut text = String::new();
    for (name, Difference { rms, largest, at }) in ["x", "y"].into_iter().zip(found.place) {
        let [rms_px, largest_px] = [rms, largest].map(|mm| format!("{:.4}", mm / mm_per_pixel));
        let line = said!(
            "measure-against",
            "name" => name,
            "rmspx" => rms_px,
            "rms" => format!("{rms:.5}"),
            "largestpx" => largest_px,
            "largest" => format!("{largest:.5}"),
            "t" => format!("{at:.3}")
        );
        let _ = writeln!(text, "  {line}");
    }
    if let Some(Difference { rms, largest, at }) = found.rotation {
        let [rms, largest, t] = [format!("{rms:.5}"), format!("{largest:.5}"), format!("{at:.3}")];
        let line = said!("measure-against-turn", "rms" => rms, "largest" => largest, "t" => t);
        let _ = writeln!(text, "  {line}");
    }
    text
}

type Compared = (usize, Option<Vec<[f64; 3]>>, Option<Differences>);

/// Table, JSON and a plot a body.
fn written(film: &Film, all: &[Compared], reference: Option<&Reference>) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let difference = |d: &Difference| json!({ "rms": d.rms, "largest": d.largest, "at_s": d.at });
    let of_body = |(number, _, found): &Compared| {
        let found = found.as_ref().map(|found| {
            let [x, y] = &found.place;
            let theta = found.rotation.as_ref().map(difference);
            json!({ "x_mm": difference(x), "y_mm": difference(y), "theta_deg": theta })
        });
        json!({ "body": film.bodies[*number].body, "difference": found })
    };
    let report = json!({
        "pictures": film.times.len(),
        "mm_per_pixel": film.mm_per_pixel,
        "run": reference.map(Reference::name),
        "bodies": all.iter().map(of_body).collect::<Vec<_>>(),
        "version": env!("CARGO_PKG_VERSION"),
    });
    let json = serde_json::to_string_pretty(&report).unwrap_or_default() + "\n";
    let mut files =
        vec![("measured.csv".to_owned(), film.csv().into_bytes()), ("measured.json".to_owned(), json.into_bytes())];
    for (number, run, _) in all {
        let body = &film.bodies[*number].body;
        let name = as_file_name(body);
        let beside = reference.map_or(String::new(), |reference| format!(", computed: {}", reference.name()));
        let title = format!("{body}: {} pictures{beside}", film.times.len());
        files.extend(plot_files(&format!("measured-{name}"), film.chart(*number, run.as_deref(), &title))?);
    }
    Ok(files)
}
