//! Keeps unsaved work in side files, a few seconds behind the hand, on a thread.
//!
//! Unsaved work belongs to an origin: the source or target of a stretch of the history. A side file is removed when its origin is saved,
//! when undo has led back to the saved state, or when the user discards the work; work that was left behind by opening something else
//! stays, and is offered the next time.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use crate::app::disk::exit_hook::{self, ExitCallback};
use crate::app::host::{Instant, Thread, Wake, now, spawn};
use crate::files::{SceneSource, SideFile, WriteError};
use crate::scene::Scene;

/// How long after an edit the work is written.
pub(in crate::app) const DELAY: Duration = Duration::from_secs(3);

/// How long a process that is ended from outside waits for the disk.
const EXIT_WAIT: Duration = Duration::from_secs(10);

/// Tasks of the thread.
enum Job {
    /// Hold an origin's scene, to be written into its side file.
    Hold(Held),
    /// Write what is held.
    Write,
    /// An origin's side file is not needed any more.
    Forget(u64),
    /// A side file that was found is this origin's now.
    Adopt(u64, PathBuf),
    /// Answer when everything before is done: whether unsaved work is on the disk.
    Sync(Sender<bool>),
}

/// A scene that is held to be written.
struct Held {
    origin: u64,
    /// The file that the side file is beside.
    beside: PathBuf,
    /// Source of the scene, whose comments are kept.
    source: SceneSource,
    scene: Box<Scene>,
}

/// Work to keep.
pub(in crate::app) struct Work {
    /// The origin it belongs to.
    pub(in crate::app) origin: u64,
    /// Counts its changes.
    pub(in crate::app) revision: u64,
    /// Whether it would be lost.
    pub(in crate::app) dirty: bool,
    /// The file it is kept beside.
    pub(in crate::app) beside: PathBuf,
    /// Source of the scene, whose comments are kept.
    pub(in crate::app) source: SceneSource,
}

/// The thread that writes, and what it has been given.
pub(in crate::app) struct Autosave {
    jobs: Option<Sender<Job>>,
    thread: Option<Thread>,
    problems: Receiver<String>,
    /// Revision of each origin that was last written.
    written: BTreeMap<u64, u64>,
    /// Origin and revision that the thread holds.
    held: Option<(u64, u64)>,
    /// Called where the process ends without the window.
    at_exit: Option<ExitCallback>,
    due: Option<Instant>,
    /// How long after an edit the work is written.
    pub(in crate::app) delay: Duration,
}

impl Autosave {
    /// Starts the thread.
    pub(in crate::app) fn new(wake: Wake) -> Self {
        let (jobs, wanted) = channel();
        let (send, problems) = channel();
        let thread = spawn(move || write_as_asked(&wanted, &send, &wake));
        let at_exit: ExitCallback = Rc::new({
            let jobs = jobs.clone();
            move || jobs.send(Job::Write).is_ok() && ask_whether_kept(&jobs, EXIT_WAIT)
        });
        exit_hook::register(&at_exit);
        let (jobs, thread, at_exit) = (Some(jobs), thread, Some(at_exit));
        Self { jobs, thread, problems, written: BTreeMap::new(), held: None, at_exit, due: None, delay: DELAY }
    }

    /// Looks whether there is something to write; says when to look again.
    pub(in crate::app) fn watch(&mut self, work: &Work, scene: impl FnOnce() -> Scene) -> Option<Duration> {
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
        self.hold(work, scene);
        if time < due {
            return Some(due - time);
        }
        self.write(work);
        None
    }

    /// Writes at once what has not been written.
    pub(in crate::app) fn hurry(&mut self, work: &Work, scene: impl FnOnce() -> Scene) {
        if work.dirty && self.written.get(&work.origin) != Some(&work.revision) {
            self.hold(work, scene);
            self.write(work);
        }
    }

    fn hold(&mut self, work: &Work, scene: impl FnOnce() -> Scene) {
        let this = Some((work.origin, work.revision));
        if self.held != this {
            self.held = this;
            let (beside, source) = (work.beside.clone(), work.source.clone());
            self.ask(Job::Hold(Held { origin: work.origin, beside, source, scene: Box::new(scene()) }));
        }
    }

    fn write(&mut self, work: &Work) {
        self.due = None;
        self.written.insert(work.origin, work.revision);
        self.ask(Job::Write);
    }

    /// The work is saved or given up.
    pub(in crate::app) fn forget(&mut self, origin: u64) {
        self.due = None;
        let held = self.held.take_if(|(held, _)| *held == origin).is_some();
        if self.written.remove(&origin).is_some() || held {
            self.ask(Job::Forget(origin));
        }
    }

    /// Goes on with a side file that was found.
    pub(in crate::app) fn adopt(&mut self, origin: u64, revision: u64, path: PathBuf) {
        self.written.insert(origin, revision);
        self.ask(Job::Adopt(origin, path));
    }

    /// Waits until everything asked for is on the disk.
    pub(in crate::app) fn wait(&self) {
        if let Some(jobs) = &self.jobs {
            let _ = ask_whether_kept(jobs, Duration::MAX);
        }
    }

    /// A complaint about the disk, if there is a new one.
    pub(in crate::app) fn problem(&self) -> Option<String> {
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
        (self.jobs, self.at_exit) = (None, None);
        // What was asked for is finished; a thread that panicked has nothing more to say.
        let _ = self.thread.take().map(Thread::join);
    }
}

/// Waits until everything asked for is done; whether unsaved work is on the disk then.
fn ask_whether_kept(jobs: &Sender<Job>, patience: Duration) -> bool {
    let (done, told) = channel();
    // The thread has ended: nothing to wait for.
    jobs.send(Job::Sync(done)).is_ok() && told.recv_timeout(patience).unwrap_or(false)
}

/// Scene to be written next, and side files by origin.
#[derive(Default)]
struct Writer {
    held: Option<Held>,
    sides: BTreeMap<u64, SideFile>,
}

impl Writer {
    fn write(&mut self) -> Result<(), WriteError> {
        let Some(Held { origin, beside, source, scene }) = self.held.take() else { return Ok(()) };
        match self.sides.get_mut(&origin) {
            Some(side) => side.write(&scene, &source),
            None => SideFile::create(&scene, &source, &beside).map(|side| drop(self.sides.insert(origin, side))),
        }
    }

    fn forget(&mut self, origin: u64) {
        self.held.take_if(|held| held.origin == origin);
        self.sides.remove(&origin).into_iter().for_each(SideFile::remove);
    }
}

fn write_as_asked(wanted: &Receiver<Job>, problems: &Sender<String>, wake: &Wake) {
    let mut writer = Writer::default();
    for job in wanted {
        let mut done = Ok(());
        match job {
            Job::Hold(held) => writer.held = Some(held),
            Job::Write => done = writer.write(),
            Job::Forget(origin) => writer.forget(origin),
            Job::Adopt(origin, path) => drop(writer.sides.insert(origin, SideFile::adopt(path))),
            // Whoever asked may not wait any more.
            Job::Sync(done) => drop(done.send(!writer.sides.is_empty())),
        }
        if let Err(problem) = done {
            // Nobody listens any more when the window has closed.
            let _ = problems.send(problem.to_string());
            wake();
        }
    }
}
