//! Plots written to the disk: SVG and PNG as seen, CSV as sampled.

use std::path::{Path, PathBuf};

use egui::ColorImage;

use crate::app::host::Told;
use crate::app::plot::sampled::{self, Sampled};
use crate::app::plot::source::Source;
use crate::app::run::answer::Answer;
use crate::app::run::comparison::Pin;
use crate::app::text;
use crate::files::write_atomic;
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::render::Image;
use crate::scene::PlotSettings;
use crate::sim::History;

/// Samples of a curve on paper.
const POINTS: usize = 2000;
/// Girders that are all drawn; of more the one in question alone.
const MOST_GIRDERS: usize = 4;
/// Curves that the name of a panel names.
const MOST_NAMED: usize = 3;
/// Pairs whose forces are drawn.
const MOST_PAIRS: usize = 6;

/// The work of writing the plots that are seen, over the window of time that is shown; none without an answer.
pub(in crate::app) fn writing(
    source: &Source<'_>,
    path: PathBuf,
) -> Option<impl FnOnce() -> Result<Told, String> + Send + 'static> {
    let answer = source.answer.cloned()?;
    let window = source.playback.window.unwrap_or([0.0, source.end]);
    let plots = seen(source, &answer.history);
    let title = source.scene.name.clone();
    let pins = source.pins.to_vec();
    // A table has every sample of the run shown, at the same times for all curves; kept runs have other times.
    let is_table = extension(&path) == "csv";
    Some(move || {
        let sampled = |p: &PlotSettings| {
            if is_table {
                sampled::sample(&answer.history, p, window, POINTS)
            } else {
                drawn(&answer, &pins, p, window)
            }
        };
        write(&path, &title, &plots.iter().map(sampled).collect::<Vec<_>>())
    })
}

/// The plots that are seen, over the window of time that is shown, as a picture.
///
/// # Errors
/// In words: there is no answer, or this build draws none.
pub(in crate::app) fn picture(source: &Source<'_>) -> Result<ColorImage, String> {
    let answer = source.answer.ok_or(text::NO_ANSWER)?;
    let window = source.playback.window.unwrap_or([0.0, source.end]);
    let plots = seen(source, &answer.history);
    let sampled: Vec<Sampled> = plots.iter().map(|p| drawn(answer, source.pins, p, window)).collect();
    let (_, svg) = charts(Path::new("plots"), &source.scene.name, &sampled).swap_remove(0);
    let image = Image::from_png(&png(&svg)?).map_err(|e| e.to_string())?;
    Ok(ColorImage::from_rgba_unmultiplied([image.width as usize, image.height as usize], &image.rgba))
}

/// A panel as it is seen, kept runs with it.
fn drawn(answer: &Answer, pins: &[Pin], plot: &PlotSettings, window: [f64; 2]) -> Sampled {
    let sampled = sampled::sample(&answer.history, plot, window, POINTS);
    sampled.beside_kept(pins, plot, window, POINTS).by_columns(window, POINTS)
}

/// The panels that are seen: those that every scene has, then the user's own.
fn seen(source: &Source<'_>, history: &History) -> Vec<PlotSettings> {
    standing(history, source.girder).into_iter().chain(source.scene.view.plots.iter().cloned()).collect()
}

/// The panels that every scene has, as in the window: places and rotations of the girder in question, of a few all; forces between
/// two bodies, of many pairs the hardest.
fn standing(history: &History, girder: usize) -> Vec<PlotSettings> {
    let model = history.model();
    let girders = model.girders();
    let others = (0..girders.len()).filter(|&other| other != girder && girders.len() <= MOST_GIRDERS);
    let names: Vec<&str> =
        std::iter::once(girder).chain(others).filter_map(|number| Some(girders.get(number)?.name.as_str())).collect();
    let each = |of: &str| names.iter().map(|name| format!("{name}.{of}")).collect::<Vec<_>>();
    let mut pairs = history.hits().largest_resultants();
    pairs.sort_by(|a, b| b.1.value.total_cmp(&a.1.value));
    let hit: Vec<usize> = pairs.into_iter().map(|(pair, _)| pair).collect();
    let pairs = if hit.is_empty() { history.hits().listed_pairs() } else { hit };
    let forces = pairs.iter().take(MOST_PAIRS).map(|pair| format!("{}.total", model.pairs[*pair].name));
    let over_time = PlotSettings::over_time;
    vec![over_time([each("x"), each("y")].concat()), over_time(each("theta")), over_time(forces.collect())]
}

/// In small letters.
fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
}

fn write(path: &Path, title: &str, plots: &[Sampled]) -> Result<Told, String> {
    let format = extension(path);
    let files: Vec<(PathBuf, Vec<u8>)> = match format.as_str() {
        "csv" => tables(path, plots),
        "png" => charts(path, title, plots)
            .into_iter()
            .map(|(path, svg)| Ok((path, png(&svg)?)))
            .collect::<Result<_, String>>()?,
        _ => charts(path, title, plots).into_iter().map(|(path, svg)| (path, svg.into_bytes())).collect(),
    };
    for (path, bytes) in &files {
        write_atomic(path, bytes).map_err(|e| e.to_string())?;
    }
    let names: Vec<String> = files.iter().map(|(path, _)| path.display().to_string()).collect();
    let words = format!("{}: {}", text::PLOTS_WRITTEN, names.join(", "));
    Ok(Told { words, place: files.first().map(|(path, _)| path.clone()) })
}

#[cfg(feature = "study")]
fn png(svg: &str) -> Result<Vec<u8>, String> {
    crate::plot::png(svg).map_err(|e| e.to_string())
}

#[cfg(not(feature = "study"))]
fn png(_: &str) -> Result<Vec<u8>, String> {
    Err(text::NO_PNG.to_string())
}

/// `NAME.ext` for what is drawn against time, `NAME-2.ext` and so on for what is drawn against something else.
fn numbered(path: &Path, number: usize) -> PathBuf {
    if number == 0 {
        return path.to_owned();
    }
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let extension = path.extension().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    path.with_file_name(format!("{stem}-{}.{extension}", number + 1))
}

/// One document for all panels against time, and one for every other.
fn charts(path: &Path, title: &str, plots: &[Sampled]) -> Vec<(PathBuf, String)> {
    let (timed, other): (Vec<_>, Vec<_>) = plots.iter().partition(|s| s.x.is_none());
    let chart = |x: &str, panels: Vec<Panel>| Chart { title: title.to_owned(), x: x.to_owned(), panels };
    let first = chart("time [s]", timed.into_iter().map(panel).collect());
    let level = |s: &Sampled| format!("{}{}", log_of(s.log[0]), s.x.as_deref().unwrap_or_default());
    let others = other.into_iter().map(|s| chart(&level(s), vec![panel(s)]));
    std::iter::once(first).chain(others).enumerate().map(|(i, c)| (numbered(path, i), c.to_svg())).collect()
}

/// Prefix of the name of a logarithmic axis.
fn log_of(log: bool) -> &'static str {
    if log { "log10 of " } else { "" }
}

fn panel(sampled: &Sampled) -> Panel {
    let scaled = |p: &[f64; 2]| [0, 1].map(|n| if sampled.log[n] { p[n].abs().log10() } else { p[n] });
    let curve = |(i, (name, points)): (usize, &(String, Vec<[f64; 2]>))| Curve {
        name: name.clone(),
        color: COLORS[i % COLORS.len()].to_owned(),
        dashes: ["none", "6 3", "2 3", "9 3 2 3"][(i / 2) % 4],
        points: points.iter().map(scaled).collect(),
    };
    let own = sampled.curves.iter().enumerate().filter(|(i, _)| sampled.kept(*i).is_none());
    let names: Vec<&str> = own.map(|(_, (name, _))| name.as_str()).collect();
    let more = if names.len() > MOST_NAMED { ", …" } else { "" };
    let named = names[..names.len().min(MOST_NAMED)].join(", ");
    Panel {
        name: format!("{}{named}{more} {}", log_of(sampled.log[1]), sampled.y),
        curves: sampled.curves.iter().enumerate().map(curve).collect(),
    }
}

/// One table for each panel: the first column is what it is drawn against.
fn tables(path: &Path, plots: &[Sampled]) -> Vec<(PathBuf, Vec<u8>)> {
    plots.iter().enumerate().map(|(i, sampled)| (numbered(path, i), table(sampled))).collect()
}

fn table(sampled: &Sampled) -> Vec<u8> {
    let mut csv = csv::Writer::from_writer(Vec::new());
    let first = sampled.x.clone().unwrap_or_else(|| "t [s]".to_owned());
    let heads = sampled.curves.iter().map(|(name, _)| format!("{name} {}", sampled.y));
    // Writing into memory cannot fail.
    let _ = csv.write_record(std::iter::once(first).chain(heads));
    let rows = sampled.curves.first().map_or(0, |(_, points)| points.len());
    for row in 0..rows {
        let level = sampled.curves[0].1[row][0];
        let values = sampled.curves.iter().map(|(_, points)| points[row][1]);
        let _ = csv.write_record(std::iter::once(level).chain(values).map(|v| format!("{v:e}")));
    }
    csv.into_inner().unwrap_or_default()
}
