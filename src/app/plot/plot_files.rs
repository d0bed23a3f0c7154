//! Plots written to the disk: SVG and PNG as seen, CSV as sampled.

use std::path::{Path, PathBuf};

use egui::ColorImage;

use crate::app::host::Told;
use crate::app::plot::sampled::{self, Sampled};
use crate::app::plot::source::Source;
use crate::app::text;
use crate::files::write_atomic;
use crate::render::Image;
use crate::scene::PlotSettings;
use crate::sim::History;
use crate::study::plot::COLORS;
use crate::study::plot::chart::{Chart, Curve, Panel};

/// Samples of a curve on paper.
const POINTS: usize = 2000;

/// The work of writing the plots that are seen, over the window of time that is shown; none without an answer.
pub(in crate::app) fn writing(
    source: &Source<'_>,
    path: PathBuf,
) -> Option<impl FnOnce() -> Result<Told, String> + Send + 'static> {
    let answer = source.answer.cloned()?;
    let window = source.playback.window.unwrap_or([0.0, source.end]);
    let mut plots = standing(&answer.history, source.girder);
    plots.extend(source.scene.view.plots.iter().cloned());
    let title = source.scene.name.clone();
    // A table has every sample, at the same times for all curves.
    let is_table = extension(&path) == "csv";
    Some(move || {
        let sampled = |p: PlotSettings| {
            let sampled = sampled::sample(&answer.history, &p, window, POINTS);
            (p, if is_table { sampled } else { sampled.by_columns(window, POINTS) })
        };
        let sampled: Vec<(PlotSettings, Sampled)> = plots.into_iter().map(sampled).collect();
        write(&path, &title, &sampled)
    })
}

/// The plots that are seen, over the window of time that is shown, as a picture.
///
/// # Errors
/// In words: there is no answer, or this build draws none.
pub(in crate::app) fn picture(source: &Source<'_>) -> Result<ColorImage, String> {
    let answer = source.answer.ok_or(text::NO_ANSWER)?;
    let window = source.playback.window.unwrap_or([0.0, source.end]);
    let plots = standing(&answer.history, source.girder).into_iter().chain(source.scene.view.plots.iter().cloned());
    let drawn = |p: &PlotSettings| sampled::sample(&answer.history, p, window, POINTS).by_columns(window, POINTS);
    let sampled: Vec<_> = plots.map(|p| (p.clone(), drawn(&p))).collect();
    let (_, svg) = charts(Path::new("plots"), &source.scene.name, &sampled).swap_remove(0);
    let image = Image::from_png(&png(&svg)?).map_err(|e| e.to_string())?;
    Ok(ColorImage::from_rgba_unmultiplied([image.width as usize, image.height as usize], &image.rgba))
}

/// The panels that every scene has: place, rotation, contact force.
fn standing(history: &History, girder: usize) -> Vec<PlotSettings> {
    let model = history.model();
    let name = model.bodies.get(girder).map_or("", |b| b.name.as_str());
    let against_time = PlotSettings::over_time;
    vec![
        against_time(vec![format!("{name}.x"), format!("{name}.y")]),
        against_time(vec![format!("{name}.theta")]),
        against_time(
            history.listed_pairs().iter().take(6).map(|&p| format!("{}.force", model.pairs[p].name)).collect(),
        ),
    ]
}

/// In small letters.
fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
}

fn write(path: &Path, title: &str, plots: &[(PlotSettings, Sampled)]) -> Result<Told, String> {
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
    crate::study::plot::png(svg).map_err(|e| e.to_string())
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
fn charts(path: &Path, title: &str, plots: &[(PlotSettings, Sampled)]) -> Vec<(PathBuf, String)> {
    let (timed, other): (Vec<_>, Vec<_>) = plots.iter().partition(|(_, s)| s.x.is_none());
    let chart = |x: &str, panels: Vec<Panel>| Chart { title: title.to_owned(), x: x.to_owned(), panels };
    let first = chart("time [s]", timed.iter().map(|(_, s)| panel(s)).collect());
    let level = |s: &Sampled| format!("{}{}", log_of(s.log[0]), s.x.as_deref().unwrap_or_default());
    let others = other.iter().map(|(_, s)| chart(&level(s), vec![panel(s)]));
    std::iter::once(first).chain(others).enumerate().map(|(i, c)| (numbered(path, i), c.to_svg())).collect()
}

/// What stands before the name of an axis of logarithms.
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
    let names: Vec<&str> = sampled.curves.iter().map(|(name, _)| name.as_str()).collect();
    Panel {
        name: format!("{}{} {}", log_of(sampled.log[1]), names.join(", "), sampled.y),
        curves: sampled.curves.iter().enumerate().map(curve).collect(),
    }
}

/// One table for each panel: the first column is what it is drawn against.
fn tables(path: &Path, plots: &[(PlotSettings, Sampled)]) -> Vec<(PathBuf, Vec<u8>)> {
    plots.iter().enumerate().map(|(i, (_, sampled))| (numbered(path, i), table(sampled))).collect()
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
