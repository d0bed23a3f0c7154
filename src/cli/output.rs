//! The files of an answer, written whole or not at all.

use std::path::Path;

use super::failure::Failure;
use super::interrupt::Writing;
use crate::files::{FileSet, earlier_files, remove_files};
use crate::language::said;
use crate::tables::{self, Table};

/// Writes the tables of an answer and pictures, as (file name, bytes), into a folder, and says so; tables of an earlier answer
/// that this one does not have are removed.
///
/// # Errors
/// A folder or file that cannot be written; a signal meanwhile. Then nothing is written.
pub(super) fn write_answer(
    folder: &Path,
    tables: &[Table<'_>],
    pictures: &[(String, Vec<u8>)],
) -> Result<String, Failure> {
    let writing = Writing::begin();
    let mut set = FileSet::default();
    for table in tables {
        let added = set.add_with(&folder.join(&table.name), |out| table.write(&mut writing.guard(out)));
        writing.check()?;
        added?;
    }
    for (name, bytes) in pictures {
        set.add(&folder.join(name), bytes)?;
    }
    let names: Vec<&str> =
        tables.iter().map(|table| table.name.as_str()).chain(pictures.iter().map(|(name, _)| name.as_str())).collect();
    let earlier = earlier_files(folder, tables::SUMMARIES, tables::named_in);
    writing.check()?;
    set.finish()?;
    let stale = earlier.iter().map(String::as_str).filter(|name| !names.contains(name));
    let removed = remove_files(folder, stale);
    let of_earlier = if removed.is_empty() {
        String::new()
    } else {
        format!("{}\n", said!("run-removed", "names" => removed.join(", ")))
    };
    Ok(written(folder, &names) + &of_earlier)
}

/// Which files were written where, a line.
fn written(folder: &Path, names: &[&str]) -> String {
    format!("{}\n", said!("run-written", "folder" => folder.display().to_string(), "names" => names.join(", ")))
}

/// Writes files, as (file name, bytes), into a folder, and says so.
///
/// # Errors
/// A folder or file that cannot be written; a signal meanwhile. Then nothing is written.
pub(super) fn write_files(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<String, Failure> {
    let writing = Writing::begin();
    let mut set = FileSet::default();
    for (name, bytes) in files {
        set.add(&folder.join(name), bytes)?;
        writing.check()?;
    }
    set.finish()?;
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    Ok(written(folder, &names))
}
