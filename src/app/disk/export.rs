//! Pictures and tables written to the disk, beside the window.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::app::host::{PAGE, Told};
use crate::app::run::answer::Answer;
use crate::app::text;
use crate::files::{FileSet, earlier_files, remove_files, write_atomic};
use crate::render::{Gpu, Packing, Quality, Renderer};
use crate::tables::{SUMMARIES, Table, TableOptions, all, all_beside, named_in};
use crate::view::DrawList;

/// Draws a list anew, off screen and in full quality, and writes it.
///
/// # Errors
/// In words: no adapter, or no place to write.
pub(in crate::app) async fn picture(
    list: Arc<DrawList>,
    size: [u32; 2],
    title: String,
    path: PathBuf,
) -> Result<Told, String> {
    let gpu = Gpu::bring_up().await.map_err(|e| e.to_string())?;
    let mut renderer = Renderer::new(&gpu, Quality::FINE);
    let image = renderer.picture_later(&gpu, &list, size).await.map_err(|e| e.to_string())?;
    let texts = [("Title", title), ("Adapter", gpu.adapter.to_string())];
    write_atomic(&path, &image.to_png(&texts, Packing::Small)).map_err(|e| e.to_string())?;
    Ok(told(text::PICTURE_WRITTEN.as_str(), &path))
}

/// Message on a written file, with its place.
pub(super) fn told(what: &str, path: &Path) -> Told {
    Told { words: format!("{what}: {}", path.display()), place: Some(path.to_owned()) }
}

/// Writes the report of an answer.
///
/// # Errors
/// In words: no place to write.
pub(in crate::app) fn report(answer: &Arc<Answer>, path: &Path) -> Result<Told, String> {
    let page = crate::report::html(&answer.history, &options(answer));
    write_atomic(path, page.as_bytes()).map_err(|e| e.to_string())?;
    Ok(told(text::REPORT_WRITTEN.as_str(), path))
}

/// Options of the tables beyond the answer.
fn options(answer: &Answer) -> TableOptions {
    let run_time = Some(answer.took.as_secs_f64());
    let estimated_error = answer.error().filter(|estimate| estimate.error.is_finite());
    TableOptions { estimated_error, run_time, ..TableOptions::default() }
}

/// Writes every table of an answer into a folder.
///
/// # Errors
/// In words: no place to write.
pub(in crate::app) fn tables(answer: &Arc<Answer>, folder: &Path) -> Result<Told, String> {
    let options = options(answer);
    let mut tables = all(&answer.history, &options);
    if let Some(beside) = answer.history.beside() {
        tables.extend(all_beside(beside, &TableOptions::default()));
    }
    let names: Vec<&str> = tables.iter().map(|table| table.name.as_str()).collect();
    let mut set = FileSet::default();
    let add = |table: &Table<'_>| set.add_with(&folder.join(&table.name), |out| table.write(out));
    tables.iter().try_for_each(add).map_err(|e| e.to_string())?;
    let earlier = earlier_files(folder, SUMMARIES, named_in);
    set.finish().map_err(|e| e.to_string())?;
    remove_files(folder, earlier.iter().map(String::as_str).filter(|name| !names.contains(name)));
    // A browser puts them where it puts what it loads.
    let into = if PAGE { String::new() } else { format!(" {}", folder.display()) };
    let words =
        format!("{}{into}: {}", if PAGE { text::TABLES_LOADED } else { text::TABLES_WRITTEN }, names.join(", "));
    Ok(Told { words, place: Some(folder.to_owned()) })
}
