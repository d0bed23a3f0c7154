//! The main job without a window: the scene's pictures, its tables and a short summary.

use std::path::Path;

use super::compute::compute;
use super::console::Console;
use super::failure::Failure;
use super::output::write_answer;
use super::{domain, summary};
#[cfg(not(feature = "render"))]
use crate::language::Text;
use crate::language::said;
use crate::scene::Scene;
use crate::sim::History;
use crate::sim::moving_ground::moved_supports;
use crate::tables::{self, DEFAULT_SAMPLE_HZ, Report};

/// Runs a scene and writes everything about it into a folder.
///
/// # Errors
/// Bad input; a run that gave up, after its answer has been written.
pub(super) fn run(scene: &Scene, folder: &Path, console: &mut Console) -> Result<(), Failure> {
    domain::warn(scene, console);
    let (options, histories): (Vec<_>, Vec<_>) =
        compute(scene)?.into_iter().map(|answer| (answer.options(DEFAULT_SAMPLE_HZ), answer.history)).unzip();
    for (history, options) in histories.iter().zip(&options) {
        console.print(&summary::text(&Report::of(history, options)));
        domain::warn_of_balance(history, console);
        domain::warn_of_drift(&moved_supports(history.scene(), history.model()), console);
    }
    let Some(history) = histories.into_iter().reduce(History::with_beside) else { return Ok(()) };
    let beside = history.beside().into_iter().zip(options.iter().skip(1));
    let beside = beside.flat_map(|(history, options)| tables::all_beside(history, options));
    let tables: Vec<_> = tables::all(&history, &options[0]).into_iter().chain(beside).collect();
    let pictures = pictures(&history).unwrap_or_else(|why| {
        console.note(&said!("note-no-pictures", "why" => why.to_string()));
        Vec::new()
    });
    console.print(&write_answer(folder, &tables, &pictures)?);
    match history.stop().or_else(|| history.beside().and_then(History::stop)) {
        Some(stop) => Err(Failure::GaveUp { scene: scene.name.clone(), stop: stop.clone() }),
        None => Ok(()),
    }
}
/// The hardest hit from every side, as (file name, bytes of a PNG), or why there is none.
#[cfg(feature = "render")]
fn pictures(history: &History) -> Result<Vec<(String, Vec<u8>)>, crate::render::GpuError> {
    use crate::render::Packing;
    use crate::scene::ViewPreset::{Contact, Iso, Side, Top};
    use crate::snapshot::{Shot, Studio};

    let mut studio = Studio::open(None)?;
    [("iso.png", Iso), ("top.png", Top), ("side.png", Side), ("contact.png", Contact)]
        .into_iter()
        .map(|(name, view)| {
            let shot = Shot { view: Some(view), ..Shot::default() };
            let image = studio.shoot(history, &shot)?;
            let texts = studio.texts(history.scene(), shot.at.of(history));
            Ok((name.to_owned(), image.to_png(&texts, Packing::Small)))
        })
        .collect()
}

/// The hardest hit from every side, as (file name, bytes of a PNG), or why there is none.
#[cfg(not(feature = "render"))]
fn pictures(_: &History) -> Result<Vec<(String, Vec<u8>)>, Text> {
    Err(Text::new("headless-no-render"))
}
