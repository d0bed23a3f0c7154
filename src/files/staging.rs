//! Files on their way to their names: in the folder they are meant for, under names of their own, locked by the process that
//! writes them for as long as it lives.
//!
//! A process that is killed leaves them behind. The lock goes with the process, so the next one to write into that folder can
//! tell such leftovers from another's work, and removes them.

use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::fs::{File, FileType};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use tempfile::{Builder, NamedTempFile, TempDir};

use super::write_error::WriteError;

/// Beginning of the names of unfinished files and of folders of them.
const MARK: &str = ".girderbench-";
/// Ending of an unfinished file's name.
const UNFINISHED: &str = ".tmp";
/// Letters and digits of such a name that are drawn by chance.
const DRAWN: usize = 6;
/// The file in a folder of unfinished ones that its process holds.
const LOCK: &str = "lock";
/// Least age of a file that [`sweep`] removes (chosen); a younger one may be made and not locked yet.
const LEFT: Duration = Duration::from_mins(1);

/// An unfinished file in a folder, locked while it is open; removed when dropped.
pub(super) fn file_in(folder: &Path) -> std::io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(MARK).rand_bytes(DRAWN).suffix(UNFINISHED);
    // Temporary files are private by default; a result is for whoever the user's umask lets read it.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder)?;
    hold(file.as_file());
    Ok(file)
}

/// Locks a file for as long as it is open; where a file system has no locks, nothing is held.
pub(super) fn hold(file: &File) {
    let _ = file.try_lock();
}

/// Unfinished files that get their names in one folder together; dropped before that, they are removed.
#[derive(Debug)]
pub(super) struct Stage {
    /// Where they go.
    pub(super) folder: PathBuf,
    names: BTreeSet<OsString>,
    inside: TempDir,
    /// Open for as long as they are unfinished.
    _lock: File,
}

#[cfg_attr(target_arch = "wasm32", expect(dead_code, reason = "a page has no folders"))]
impl Stage {
    pub(super) fn in_folder(folder: &Path) -> std::io::Result<Self> {
        sweep(folder);
        let inside = Builder::new().prefix(MARK).rand_bytes(DRAWN).tempdir_in(folder)?;
        let lock = File::create_new(inside.path().join(LOCK))?;
        hold(&lock);
        Ok(Self { folder: folder.to_owned(), names: BTreeSet::new(), inside, _lock: lock })
    }

    /// Writes an unfinished file; it is closed afterwards, since there may be more than a process may hold open.
    pub(super) fn write(
        &mut self,
        name: &OsStr,
        write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
    ) -> std::io::Result<()> {
        let mut file = BufWriter::new(File::create(self.place(name))?);
        write(&mut file)?;
        file.flush()?;
        self.names.insert(name.to_owned());
        Ok(())
    }

    /// Gives the files their names, in the order of these.
    pub(super) fn finish(self) -> Result<(), WriteError> {
        self.names.iter().try_for_each(|name| {
            let path = self.folder.join(name);
            std::fs::rename(self.place(name), &path).map_err(|cause| WriteError::new(path, cause))
        })
    }

    /// Files so far.
    pub(super) fn count(&self) -> usize {
        self.names.len()
    }

    /// Where a file is while it is unfinished; beside the lock none can have its name.
    fn place(&self, name: &OsStr) -> PathBuf {
        let mut unfinished = name.to_owned();
        unfinished.push(UNFINISHED);
        self.inside.path().join(unfinished)
    }
}

/// Removes what processes that have ended left unfinished in a folder.
pub(super) fn sweep(folder: &Path) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let (name, path) = (entry.file_name(), entry.path());
        match (entry.file_type(), name.to_str().and_then(kind)) {
            (Ok(kind), Some(Unfinished::File)) if kind.is_file() && is_left(&path) => {
                let _ = std::fs::remove_file(&path);
            }
            (Ok(kind), Some(Unfinished::Folder)) if is_own(kind, &path) => {
                let _ = std::fs::remove_dir_all(&path);
            }
            _ => {}
        }
    }
}

enum Unfinished {
    File,
    Folder,
}

/// Kind of an unfinished file or folder by its name; `None` of any other name.
fn kind(name: &str) -> Option<Unfinished> {
    let rest = name.strip_prefix(MARK)?;
    let (drawn, kind) = match rest.strip_suffix(UNFINISHED) {
        Some(drawn) => (drawn, Unfinished::File),
        None => (rest, Unfinished::Folder),
    };
    (drawn.len() == DRAWN && drawn.chars().all(|c| c.is_ascii_alphanumeric())).then_some(kind)
}

fn is_own(kind: FileType, folder: &Path) -> bool {
    kind.is_dir() && is_left(&folder.join(LOCK))
}

/// Whether a file is older than what was made just now, and no process holds it.
fn is_left(file: &Path) -> bool {
    let old = |file: &File| {
        let modified = file.metadata().and_then(|about| about.modified()).ok();
        modified.and_then(|modified| modified.elapsed().ok()).is_some_and(|age| age > LEFT)
    };
    File::open(file).is_ok_and(|file| old(&file) && file.try_lock().is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::SystemTime;

    /// Makes a file that was written an hour ago.
    fn old(path: &Path) {
        let file = File::create(path).expect("made");
        file.set_modified(SystemTime::now() - Duration::from_hours(1)).expect("set back");
    }

    fn names_in(folder: &Path) -> Vec<String> {
        let entries = std::fs::read_dir(folder).expect("the folder").map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<String> = entries.map(|name| name.into_string().expect("Unicode")).collect();
        names.sort();
        names
    }

    #[test]
    fn leftovers_of_a_process_that_has_ended_are_removed_and_nothing_else() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        let mine = [".girderbench-notes", ".girderbench-abcdef.txt", ".tmpABCDEF", "girderbench-abcdef.tmp"];
        for name in mine {
            old(&at(name));
        }
        for name in [".girderbench-nolock", ".girderbench-my-own"] {
            std::fs::create_dir(at(name)).expect("made");
            old(&at(name).join("frame.png"));
        }
        old(&at(".girderbench-aB3dE6.tmp"));
        std::fs::create_dir(at(".girderbench-aB3dE7")).expect("made");
        for name in [LOCK, "frame.png.tmp"] {
            old(&at(".girderbench-aB3dE7").join(name));
        }
        sweep(folder.path());
        let mut kept = [&mine[..], &[".girderbench-nolock", ".girderbench-my-own"]].concat();
        kept.sort_unstable();
        assert_eq!(names_in(folder.path()), kept, "only its own, and those surely");
    }

    #[test]
    fn what_a_living_process_writes_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut stage = Stage::in_folder(folder.path()).expect("staged");
        stage.write(OsStr::new("a.csv"), |out| out.write_all(b"1")).expect("written");
        let file = file_in(folder.path()).expect("made");
        for held in [file.path(), &stage.inside.path().join(LOCK)] {
            let held = File::options().write(true).open(held).expect("there");
            held.set_modified(SystemTime::now() - Duration::from_hours(1)).expect("set back");
        }
        let before = names_in(folder.path());
        sweep(folder.path());
        assert_eq!(names_in(folder.path()), before, "held");
        stage.finish().expect("named");
        drop(file);
        assert_eq!(names_in(folder.path()), ["a.csv"], "finished");
    }
}
