//! Keeps unsaved work in side files, a few seconds behind the hand, on a thread.
//!
//! What is kept belongs to an origin: what a stretch of the past was opened from or saved to. A side file goes when its
//! origin is saved, when undo has led back to what is saved, or when the user gives the work up; work that was left
//! behind by opening something else stays, and is offered the next time.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use super::clock::now;
use super::runner::Wake;
use crate::files::SideFile;
use crate::scene::Scene;

/// How long after an edit the work is written.
pub(super) const DELAY: Duration = Duration::from_secs(3);

/// What the thread is asked for.
enum Job {
    /// Write an origin's scene into its side file, which is beside this file.
    Write(u64, PathBuf, Box<Scene>),
    /// An origin's side file is not needed any more.
    Forget(u64),
    /// A side file that was found is this origin's now.
    Adopt(u64, PathBuf),
    /// Answer when everything before is done.
    Sync(Sender<()>),
}

/// What is to be kept.
pub(super) struct Work {
    /// The origin it belongs to.
    pub(super) origin: u64,
    /// Counts its changes.
    pub(super) revision: u64,
    /// Whether it would be lost.
    pub(super) dirty: bool,
    /// The file it is kept beside.
    pub(super) beside: PathBuf,
}

/// The thread that writes, and what it has been given.
pub(super) struct Autosave {
    jobs: Option<Sender<Job>>,
    thread: Option<JoinHandle<()>>,
    problems: Receiver<String>,
    /// Revision of each origin that was last written.
    written: BTreeMap<u64, u64>,
    due: Option<Instant>,
    /// How long after an edit the work is written.
    pub(super) delay: Duration,
}

impl Autosave {
    /// Starts the thread.
    pub(super) fn new(wake: Wake) -> Self {
        let (jobs, wanted) = channel();
        let (send, problems) = channel();
        let thread = std::thread::spawn(move || write_as_asked(&wanted, &send, &wake));
        let written = BTreeMap::new();
        Self { jobs: Some(jobs), thread: Some(thread), problems, written, due: None, delay: DELAY }
    }

    /// Looks whether there is something to write; says when to look again.
    pub(super) fn watch(&mut self, work: Work, scene: impl FnOnce() -> Scene) -> Option<Duration> {
        if !work.dirty {
            self.forget(work.origin);
            return None;
        }
        if self.written.get(&work.origin) == Some(&work.revision) {
            self.due = None;
            return None;
        }
        let time = now();
        let due = *self.due.get_or_insert(time + self.delay);
        if time < due {
            return Some(due - time);
        }
        self.write(work, scene());
        None
    }

    /// Writes at once what has not been written.
    pub(super) fn hurry(&mut self, work: Work, scene: impl FnOnce() -> Scene) {
        if work.dirty && self.written.get(&work.origin) != Some(&work.revision) {
            self.write(work, scene());
        }
    }

    fn write(&mut self, work: Work, scene: Scene) {
        self.due = None;
        self.written.insert(work.origin, work.revision);
        self.ask(Job::Write(work.origin, work.beside, Box::new(scene)));
    }

    /// The work is saved or given up.
    pub(super) fn forget(&mut self, origin: u64) {
        self.due = None;
        if self.written.remove(&origin).is_some() {
            self.ask(Job::Forget(origin));
        }
    }

    /// Goes on with a side file that was found.
    pub(super) fn adopt(&mut self, origin: u64, revision: u64, path: PathBuf) {
        self.written.insert(origin, revision);
        self.ask(Job::Adopt(origin, path));
    }

    /// Waits until everything asked for is on the disk.
    pub(super) fn wait(&self) {
        let (done, told) = channel();
        self.ask(Job::Sync(done));
        // The thread has ended: nothing to wait for.
        let _ = told.recv();
    }

    /// A complaint about the disk, if there is a new one.
    pub(super) fn problem(&self) -> Option<String> {
        self.problems.try_iter().last()
    }

    fn ask(&self, job: Job) {
        if let Some(jobs) = &self.jobs {
            // It ends after this end does.
            let _ = jobs.send(job);
        }
    }
}

impl Drop for Autosave {
    fn drop(&mut self) {
        self.jobs = None;
        // What was asked for is finished; a thread that panicked has nothing more to say.
        let _ = self.thread.take().map(JoinHandle::join);
    }
}

fn write_as_asked(wanted: &Receiver<Job>, problems: &Sender<String>, wake: &Wake) {
    let mut sides: BTreeMap<u64, SideFile> = BTreeMap::new();
    for job in wanted {
        let done = match job {
            Job::Write(origin, beside, scene) => match sides.get_mut(&origin) {
                Some(side) => side.write(&scene),
                None => SideFile::create(&scene, &beside).map(|side| drop(sides.insert(origin, side))),
            },
            Job::Forget(origin) => {
                sides.remove(&origin).into_iter().for_each(SideFile::remove);
                Ok(())
            }
            Job::Adopt(origin, path) => {
                drop(sides.insert(origin, SideFile::adopt(path)));
                Ok(())
            }
            Job::Sync(done) => {
                // Whoever asked does not wait any more.
                let _ = done.send(());
                Ok(())
            }
        };
        if let Err(problem) = done {
            // Nobody listens any more when the window has closed.
            let _ = problems.send(problem.to_string());
            wake();
        }
    }
}
