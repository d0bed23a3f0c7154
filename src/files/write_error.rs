//! Why a file could not be written, in words.

use std::io::ErrorKind;
use std::path::PathBuf;

use crate::language::{Message, Text, said};

/// A file that could not be written.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.line())]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// Error of the system.
    cause: std::io::Error,
}

impl WriteError {
    /// Of what the system answered when a file was written under this name, or under another that it has until then.
    pub fn new(path: impl Into<PathBuf>, cause: std::io::Error) -> Self {
        Self { path: path.into(), cause }
    }

    /// Whether nothing can be written under this name, rather than no more to this disk.
    pub fn is_of_place(&self) -> bool {
        use ErrorKind::{
            AlreadyExists, DirectoryNotEmpty, InvalidFilename, InvalidInput, IsADirectory, NotADirectory, NotFound,
            PermissionDenied, ReadOnlyFilesystem,
        };
        matches!(
            self.cause.kind(),
            AlreadyExists
                | DirectoryNotEmpty
                | InvalidFilename
                | InvalidInput
                | IsADirectory
                | NotADirectory
                | NotFound
                | PermissionDenied
                | ReadOnlyFilesystem
        )
    }

    /// Itself as one line, in the language in use.
    fn line(&self) -> String {
        let path = self.path.display().to_string();
        said!("unwritten", "path" => path, "reason" => self.reason().to_string(), "remedy" => self.remedy().as_str())
    }

    fn reason(&self) -> Message {
        match self.cause.kind() {
            ErrorKind::NotFound => Text::new("unwritten-no-folder").into(),
            ErrorKind::PermissionDenied => Text::new("unwritten-denied").into(),
            ErrorKind::NotADirectory => Text::new("unwritten-not-folder").into(),
            ErrorKind::IsADirectory => Text::new("unwritten-folder").into(),
            ErrorKind::ReadOnlyFilesystem => Text::new("unwritten-read-only").into(),
            ErrorKind::StorageFull => Text::new("unwritten-full").into(),
            ErrorKind::QuotaExceeded => Text::new("unwritten-quota").into(),
            ErrorKind::FileTooLarge => Text::new("unwritten-large").into(),
            // Words about a temporary file go on with its name, which is gone by now.
            _ => self.cause.to_string().split(" at path ").next().unwrap_or_default().into(),
        }
    }

    fn remedy(&self) -> Text {
        match self.cause.kind() {
            _ if self.is_of_place() => Text::new("unwritten-choose-folder"),
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => {
                Text::new("unwritten-make-room")
            }
            _ => Text::new("unwritten-try-again"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(kind: ErrorKind) -> String {
        WriteError::new("out/a.csv", kind.into()).to_string()
    }

    #[test]
    fn a_full_disk_is_no_fault_of_the_folder() {
        let full = words(ErrorKind::StorageFull);
        assert_eq!(
            full, "out/a.csv: cannot be written (the disk is full): make room, write less, or write to another disk",
            "what to do"
        );
        assert!(!WriteError::new("a", ErrorKind::StorageFull.into()).is_of_place(), "the place is good");
        assert!(words(ErrorKind::NotFound).contains("choose a folder that may be written to"), "another folder");
    }

    #[test]
    fn no_name_of_a_temporary_file_is_shown() {
        let error = std::io::Error::other("Input/output error (os error 5) at path \"/x/.girderbench-aB3dE6.tmp\"");
        let words = WriteError::new("a.csv", error).to_string();
        assert!(words.contains("(Input/output error (os error 5))") && !words.contains("aB3dE6"), "{words}");
    }
}
