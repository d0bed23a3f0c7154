//! The folder of a sweep: what it is, and the journals of its runs.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::cli::console::Console;
use crate::cli::failure::Failure;
use crate::files::{Journal, WriteError, read_table, write_atomic};
use crate::language::{Text, said};
use crate::study::sweep::journal::{Contents, Identity, read};
use crate::study::sweep::{Plan, Row, changed};

/// File that describes the sweep of a folder.
const ABOUT: &str = "sweep.json";
/// The journal of a sweep that is not divided.
pub(super) const JOURNAL: &str = "runs.journal";

/// The folder of a sweep, with its rows so far.
#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    identity: Identity,
    journals: Vec<Journal>,
    /// Rows so far, by the number of the run.
    pub(super) rows: BTreeMap<usize, Row>,
}

impl Folder {
    /// Opens a folder for a sweep, made where it is missing.
    ///
    /// # Errors
    /// It holds another sweep; it cannot be read or written.
    pub(super) fn open(path: &Path, about: &Value, identity: Identity) -> Result<Self, Failure> {
        let file = path.join(ABOUT);
        let mut text = serde_json::to_vec_pretty(about).unwrap_or_default();
        text.push(b'\n');
        if file.exists() {
            let there = read_table(&file)?;
            if there != text {
                return Err(differs(&file, &there, about));
            }
        } else {
            std::fs::create_dir_all(path).map_err(|cause| WriteError::new(path, cause))?;
            write_atomic(&file, &text)?;
        }
        Ok(Self { path: path.to_owned(), identity, journals: Vec::new(), rows: BTreeMap::new() })
    }

    /// Reads a journal, which [`append`](Self::append) goes on with if it is the first; made where it is missing.
    ///
    /// # Errors
    /// Another process writes it; it is of another sweep; it cannot be read or written.
    pub(super) fn read(&mut self, name: &str, plan: &Plan, console: &mut Console) -> Result<(), Failure> {
        let path = self.path.join(name);
        let Some((mut journal, bytes)) = Journal::open(&path)? else {
            return Err(of_journal(&path, Text::new("wrong-journal-busy")));
        };
        let Ok(Contents { rows, whole, damaged }) = read(&bytes, self.identity, plan) else {
            return Err(of_journal(&path, Text::new("wrong-journal-other")));
        };
        if let Some(changed) = changed(plan, &rows) {
            let (changed, remedy) = (changed.words(plan), Text::new("wrong-journal-changed"));
            return Err(of_journal(&path, said!("mistake-of", "what" => changed, "subject" => remedy)));
        }
        if damaged > 0 {
            console.note(&said!("warning-journal", "file" => path.display().to_string(), "damaged" => damaged));
        }
        if whole < bytes.len() {
            journal.cut(whole as u64)?;
        }
        if whole == 0 {
            journal.append(&self.identity.heading())?;
        }
        self.journals.push(journal);
        self.rows.extend(rows);
        Ok(())
    }

    /// Reads every journal that there is besides the first.
    ///
    /// # Errors
    /// Those of [`read`](Self::read).
    pub(super) fn read_others(&mut self, first: &str, plan: &Plan, console: &mut Console) -> Result<(), Failure> {
        let entries = std::fs::read_dir(&self.path).map_err(|cause| WriteError::new(&self.path, cause))?;
        let mut names: Vec<String> =
            entries.flatten().filter_map(|entry| entry.file_name().into_string().ok()).collect();
        names.retain(|name| name.ends_with(".journal") && name != first);
        names.sort();
        names.iter().try_for_each(|name| self.read(name, plan, console))
    }

    /// Writes a row into the journal that was read first.
    ///
    /// # Errors
    /// When it cannot be written.
    pub(super) fn append(&mut self, row: Row) -> Result<(), Failure> {
        if let Some(journal) = self.journals.first_mut() {
            journal.append(&self.identity.line(&row))?;
        }
        self.rows.insert(row.run, row);
        Ok(())
    }
}

/// Failure by a fault of a journal.
fn of_journal(path: &Path, fault: impl Into<String>) -> Failure {
    let (file, fault): (_, String) = (path.display().to_string(), fault.into());
    Failure::Input(said!("mistake-of", "what" => file, "subject" => fault))
}

/// Failure by a difference between the sweep of a folder and the wanted one.
fn differs(file: &Path, there: &[u8], about: &Value) -> Failure {
    let there: Value = serde_json::from_slice(there).unwrap_or_default();
    let parts = [
        ("girderbench", Text::new("sweep-by-version").as_str()),
        ("scene", Text::new("sweep-by-scene").as_str()),
        ("records", Text::new("sweep-by-records").as_str()),
        ("vary", "--vary"),
        ("measures", "--measure"),
    ];
    let other: Vec<&str> = parts.iter().filter(|(key, _)| there[key] != about[key]).map(|(_, words)| *words).collect();
    let found = if other.is_empty() {
        Text::new("sweep-changed").into()
    } else {
        said!("sweep-another", "parts" => other.join(", "))
    };
    Failure::Input(said!("wrong-sweep-folder", "file" => file.display().to_string(), "found" => found))
}
