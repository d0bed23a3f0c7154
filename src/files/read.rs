//! Reads files that a user names: regular files of a bounded size.
//!
//! A device or a pipe may have no end, and to open a pipe may wait for ever: what stands under the name is looked at before
//! it is opened.

#[cfg(not(target_arch = "wasm32"))]
use std::fs::{File, FileType, Metadata};
use std::io::ErrorKind;
#[cfg(not(target_arch = "wasm32"))]
use std::io::Read as _;
use std::path::{Path, PathBuf};

use crate::language::{Message, Text, message};

/// Largest scene or record that is read \[bytes\]: three million lines of twenty characters, eight hours at 100 Hz.
pub(super) const LARGEST_INPUT: u64 = 64 << 20;
/// Largest table that is read \[bytes\]; a table of as many cells as `run` writes is smaller.
const LARGEST_TABLE: u64 = 4 << 30;

/// A file that could not be read.
#[derive(Debug, thiserror::Error)]
#[error("{}: {}: {}", path.display(), self.found(), self.remedy())]
pub struct ReadError {
    /// The file.
    pub path: PathBuf,
    cause: Cause,
}

#[derive(Debug)]
enum Cause {
    /// Error of the system.
    System(std::io::Error),
    /// It is no regular file, but this.
    #[cfg(not(target_arch = "wasm32"))]
    Kind(Text),
    /// So large, and so large at the most \[bytes\].
    Size(u64, u64),
}

impl ReadError {
    /// Whether nothing has that name.
    pub(super) fn is_missing(&self) -> bool {
        matches!(&self.cause, Cause::System(error) if error.kind() == ErrorKind::NotFound)
    }

    /// Message on the file that cannot be read.
    pub(super) fn found(&self) -> Message {
        match self.cause {
            Cause::System(ref error) => message!("found-unreadable", "error" => error.to_string()),
            #[cfg(not(target_arch = "wasm32"))]
            Cause::Kind(what) => message!("found-kind", "what" => what),
            Cause::Size(size, most) => {
                let (size, most) = (size as f64 / f64::from(1 << 20), most >> 20);
                message!("found-size", "size" => format!("{size:.1}"), "most" => most)
            }
        }
    }

    /// Remedy.
    pub(super) fn remedy(&self) -> Text {
        match self.cause {
            Cause::System(_) => Text::new("wrong-unreadable"),
            #[cfg(not(target_arch = "wasm32"))]
            Cause::Kind(_) => Text::new("wrong-file-kind"),
            Cause::Size(..) => Text::new("wrong-file-size"),
        }
    }
}

/// Reads a whole table.
///
/// # Errors
/// When it is not there or may not be read, is no regular file, or has more than 4 GiB.
pub fn read_table(path: &Path) -> Result<Vec<u8>, ReadError> {
    read_regular(path, LARGEST_TABLE)
}

/// Reads a whole scene, record or measured table, or a picture.
///
/// # Errors
/// When it is not there or may not be read, is no regular file, or has more than 64 MiB.
pub fn read_input(path: &Path) -> Result<Vec<u8>, ReadError> {
    read_regular(path, LARGEST_INPUT)
}

/// Reads a whole regular file of at most so many bytes.
///
/// # Errors
/// When it is not there or may not be read, is no regular file, or has more bytes.
pub(super) fn read_regular(path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
    contents(path, most).map_err(|cause| ReadError { path: path.to_owned(), cause })
}

#[cfg(target_arch = "wasm32")]
fn contents(path: &Path, most: u64) -> Result<Vec<u8>, Cause> {
    let bytes = super::page::read(path).ok_or_else(|| Cause::System(ErrorKind::NotFound.into()))?;
    let size = bytes.len() as u64;
    if size > most { Err(Cause::Size(size, most)) } else { Ok(bytes) }
}

#[cfg(not(target_arch = "wasm32"))]
fn contents(path: &Path, most: u64) -> Result<Vec<u8>, Cause> {
    regular(&std::fs::metadata(path).map_err(Cause::System)?, most)?;
    bytes_of(path, most)
}

/// Reads a file that seems to be regular; a file that grows meanwhile, or that states no length, is read no further.
#[cfg(not(target_arch = "wasm32"))]
fn bytes_of(path: &Path, most: u64) -> Result<Vec<u8>, Cause> {
    let file = File::open(path).map_err(Cause::System)?;
    let mut bytes = Vec::new();
    file.take(most + 1).read_to_end(&mut bytes).map_err(Cause::System)?;
    let size = bytes.len() as u64;
    if size > most { Err(Cause::Size(size, most)) } else { Ok(bytes) }
}

#[cfg(not(target_arch = "wasm32"))]
fn regular(about: &Metadata, most: u64) -> Result<(), Cause> {
    let (kind, size) = (about.file_type(), about.len());
    match () {
        () if about.is_dir() => Err(Cause::Kind(Text::new("file-folder"))),
        () if !about.is_file() => Err(Cause::Kind(special(kind))),
        () if size > most => Err(Cause::Size(size, most)),
        () => Ok(()),
    }
}

#[cfg(unix)]
fn special(kind: FileType) -> Text {
    use std::os::unix::fs::FileTypeExt as _;
    match () {
        () if kind.is_fifo() => Text::new("file-pipe"),
        () if kind.is_socket() => Text::new("file-socket"),
        () if kind.is_char_device() || kind.is_block_device() => Text::new("file-device"),
        () => Text::new("file-not-regular"),
    }
}

#[cfg(not(any(unix, target_arch = "wasm32")))]
fn special(_: FileType) -> Text {
    Text::new("file-not-regular")
}
