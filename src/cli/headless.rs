//! The main job without a window: the scene's pictures, its tables and a short summary.

use std::path::Path;

use super::compute::compute;
use super::console::Console;
use super::failure::Failure;
use super::run::write_files;
use super::{domain, summary};
use crate::scene::Scene;
use crate::sim::History;
use crate::tables::{Report, TableOptions};

/// Runs a scene and writes everything about it into a folder.
///
/// # Errors
/// Bad input; a run that gave up, after its answer has been written.
pub(super) fn run(scene: &Scene, folder: &Path, console: &mut Console) -> Result<(), Failure> {
    domain::warn(scene, console);
    let timed = compute(scene)?;
    let mut all = Vec::new();
    for answer in &timed {
        let (error, run_time) = (Some(answer.estimate_error()), Some(answer.run_time));
        let options = TableOptions { estimated_error: error, run_time, ..TableOptions::default() };
        console.print(&summary::text(&Report::of(&answer.history, &options)));
        all.extend(answer.tables(&options));
    }
    let stop = timed.iter().find_map(|timed| timed.history.stop().cloned());
    let Some(history) = timed.into_iter().map(|timed| timed.history).reduce(History::with_beside) else {
        return Ok(());
    };
    match pictures(&history) {
        Ok(pictures) => all.extend(pictures),
        Err(why) => console.note(&format!("no pictures: {why}")),
    }
    console.print(&write_files(folder, &all)?);
    match stop {
        Some(stop) => Err(Failure::GaveUp { scene: scene.name.clone(), stop }),
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
fn pictures(_: &History) -> Result<Vec<(String, Vec<u8>)>, &'static str> {
    Err("this build has none (feature render)")
}
