//! The files that were opened or saved last, kept in a small list of the user's own.
//!
//! A list that is missing, unreadable or malformed is read as empty: it never keeps the program from starting. Every change reads it anew
//! first, so that two windows keep each other's files.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::read::{LARGEST_INPUT, read_regular};
use super::save::{folder_of, write_atomic};
use super::write_error::WriteError;

/// Most files in the list (chosen: users do not search a longer one).
const MOST_FILES: usize = 12;

/// The list.
#[derive(Debug, Default)]
pub struct Recent {
    list: PathBuf,
    files: Vec<PathBuf>,
}

/// The list as it stands in its file.
#[derive(Default, Serialize, Deserialize)]
struct Written {
    #[serde(default)]
    files: Vec<String>,
}

impl Recent {
    /// Reads the list that is kept in the file `list`.
    pub fn open(list: PathBuf) -> Self {
        let files = read(&list);
        Self { list, files }
    }

    /// The files, last used first; they may have gone since.
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// Puts a file first.
    ///
    /// # Errors
    /// When the list cannot be written.
    pub fn add(&mut self, file: &Path) -> Result<(), WriteError> {
        let file = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
        self.change(|files| {
            files.retain(|other| *other != file);
            files.insert(0, file);
            files.truncate(MOST_FILES);
        })
    }

    /// Takes a file from the list; the file itself stays.
    ///
    /// # Errors
    /// When the list cannot be written.
    pub fn remove(&mut self, file: &Path) -> Result<(), WriteError> {
        self.change(|files| files.retain(|other| other != file))
    }

    /// Forgets all of them.
    ///
    /// # Errors
    /// When the list cannot be written.
    pub fn clear(&mut self) -> Result<(), WriteError> {
        self.change(Vec::clear)
    }

    fn change(&mut self, change: impl FnOnce(&mut Vec<PathBuf>)) -> Result<(), WriteError> {
        self.files = read(&self.list);
        change(&mut self.files);
        // A name that is not Unicode cannot be written: it lasts as long as this window.
        let files = self.files.iter().filter_map(|file| file.to_str()).map(str::to_owned).collect();
        let text = toml::to_string(&Written { files }).unwrap_or_default();
        let folder = folder_of(&self.list);
        std::fs::create_dir_all(folder).map_err(|cause| WriteError::new(folder, cause))?;
        write_atomic(&self.list, text.as_bytes())
    }
}

fn read(list: &Path) -> Vec<PathBuf> {
    let bytes = read_regular(list, LARGEST_INPUT).unwrap_or_default();
    let written: Written = toml::from_slice(&bytes).unwrap_or_default();
    written.files.into_iter().take(MOST_FILES).map(PathBuf::from).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_used_is_first_and_stands_once() {
        let folder = tempfile::tempdir().expect("a folder");
        let list = folder.path().join("state/recent.toml");
        let mut recent = Recent::open(list.clone());
        for name in ["/a.toml", "/b.toml", "/a.toml"] {
            recent.add(Path::new(name)).expect("written, folder and all");
        }
        let wanted = [PathBuf::from("/a.toml"), PathBuf::from("/b.toml")];
        assert_eq!(recent.files(), wanted, "last used first");
        assert_eq!(Recent::open(list).files(), wanted, "and kept");
    }

    #[test]
    fn two_windows_do_not_forget_each_others_files() {
        let folder = tempfile::tempdir().expect("a folder");
        let list = folder.path().join("recent.toml");
        let (mut one, mut other) = (Recent::open(list.clone()), Recent::open(list.clone()));
        one.add(Path::new("/one.toml")).expect("written");
        other.add(Path::new("/other.toml")).expect("written");
        assert_eq!(Recent::open(list).files().len(), 2, "both");
    }

    #[test]
    fn nonsense_is_an_empty_list_that_can_be_used() {
        let folder = tempfile::tempdir().expect("a folder");
        let list = folder.path().join("recent.toml");
        for nonsense in [&b"files = 3"[..], b"\xff\xfe", b"files = [1, 2]", b""] {
            std::fs::write(&list, nonsense).expect("written");
            let mut recent = Recent::open(list.clone());
            assert!(recent.files().is_empty(), "nothing in {nonsense:?}");
            recent.add(Path::new("/a.toml")).expect("written over");
            assert_eq!(Recent::open(list.clone()).files().len(), 1, "good again");
        }
    }

    #[test]
    fn the_list_is_short() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut recent = Recent::open(folder.path().join("recent.toml"));
        (0..40).for_each(|i| recent.add(&PathBuf::from(format!("/{i}.toml"))).expect("written"));
        assert_eq!(recent.files().len(), MOST_FILES, "the oldest are forgotten");
        recent.clear().expect("written");
        assert!(recent.files().is_empty(), "all forgotten");
    }
}
