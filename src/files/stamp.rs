//! Size and time of a file when it was last read or written, by which a change by another program is noticed.

use std::path::Path;
use std::time::SystemTime;

/// A file's time and length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamp {
    modified: SystemTime,
    length: u64,
}

impl Stamp {
    /// The file as it is now; `None` when it is not there.
    pub fn of(path: &Path) -> Option<Self> {
        let about = std::fs::metadata(path).ok()?;
        Some(Self { modified: about.modified().ok()?, length: about.len() })
    }

    /// When it was written.
    pub fn modified(&self) -> SystemTime {
        self.modified
    }
}
