//! A file that lines are appended to and that this process alone writes.

use std::fs::File;
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

use super::save::folder_of;
use super::write_error::WriteError;

/// A file that grows by whole lines. What is appended is with the system at once: a process that is killed loses none of it.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    /// Locked for as long as it is open, where the file system has locks.
    file: File,
}

impl Journal {
    /// Opens a file, made where it is missing, and reads what is in it; none where another process writes it.
    ///
    /// # Errors
    /// When it cannot be read or written.
    pub fn open(path: &Path) -> Result<Option<(Self, Vec<u8>)>, WriteError> {
        let fail = |cause| WriteError::new(path, cause);
        std::fs::create_dir_all(folder_of(path)).map_err(fail)?;
        let mut file = File::options().read(true).append(true).create(true).open(path).map_err(fail)?;
        if matches!(file.try_lock(), Err(std::fs::TryLockError::WouldBlock)) {
            return Ok(None);
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(fail)?;
        Ok(Some((Self { path: path.to_owned(), file }, bytes)))
    }

    /// Cuts off what is behind so many bytes.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn cut(&mut self, length: u64) -> Result<(), WriteError> {
        let cut = self.file.set_len(length).and_then(|()| self.file.seek(SeekFrom::End(0)));
        cut.map(|_| ()).map_err(|cause| WriteError::new(&self.path, cause))
    }

    /// Appends a text.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn append(&mut self, text: &str) -> Result<(), WriteError> {
        self.file.write_all(text.as_bytes()).map_err(|cause| WriteError::new(&self.path, cause))
    }
}
