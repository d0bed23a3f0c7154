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
    /// What the system answered.
    System(std::io::Error),
    /// It is no regular file, but this.
    #[cfg(not(target_arch = "wasm32"))]
    Kind(&'static str),
    /// So large, and so large at the most \[bytes\].
    Size(u64, u64),
}

impl ReadError {
    /// Whether nothing has that name.
    pub(super) fn is_missing(&self) -> bool {
        matches!(&self.cause, Cause::System(error) if error.kind() == ErrorKind::NotFound)
    }

    /// What was found in place of a file that can be read.
    pub(super) fn found(&self) -> String {
        match self.cause {
            Cause::System(ref error) => format!("it cannot be read ({error})"),
            #[cfg(not(target_arch = "wasm32"))]
            Cause::Kind(what) => format!("it is {what}"),
            Cause::Size(size, most) => {
                let (size, most) = (size as f64 / f64::from(1 << 20), most >> 20);
                format!("it has {size:.1} MiB, more than the {most} MiB that are read")
            }
        }
    }

    /// What would be right.
    pub(super) fn remedy(&self) -> &'static str {
        match self.cause {
            Cause::System(_) => "give a file that is there and may be read",
            #[cfg(not(target_arch = "wasm32"))]
            Cause::Kind(_) => "give a regular file",
            Cause::Size(..) => "give a smaller file",
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
        () if about.is_dir() => Err(Cause::Kind("a directory")),
        () if !about.is_file() => Err(Cause::Kind(special(kind))),
        () if size > most => Err(Cause::Size(size, most)),
        () => Ok(()),
    }
}

#[cfg(unix)]
fn special(kind: FileType) -> &'static str {
    use std::os::unix::fs::FileTypeExt as _;
    match () {
        () if kind.is_fifo() => "a pipe",
        () if kind.is_socket() => "a socket",
        () if kind.is_char_device() || kind.is_block_device() => "a device",
        () => "no regular file",
    }
}

#[cfg(not(any(unix, target_arch = "wasm32")))]
fn special(_: FileType) -> &'static str {
    "no regular file"
}
