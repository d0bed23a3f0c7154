//! A film from the window: asked for in a dialog, drawn off screen on a thread, written whole or not at all.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};

use crate::app::command::{FilmCommand, FilmFormat, FilmPlan};
use crate::app::host::{THREADS, Thread, Told, Wake, spawn};
use crate::app::run::answer::Answer;
use crate::app::text;
use crate::files::{Draft, FileSet, WriteError, as_file_name};
use crate::render::{GpuError, Packing};
use crate::snapshot::{Frame, GifError, Instant, Shot, Studio, film, gif, instants};

/// Input of a film.
pub(in crate::app) struct Source<'a> {
    /// The run.
    pub(in crate::app) answer: Option<&'a Arc<Answer>>,
    /// The stretch of the run that is in view \[s\].
    pub(in crate::app) stretch: [f64; 2],
    /// How each picture is taken, but for its instant; as large as the view.
    pub(in crate::app) shot: Shot,
    /// Name of the scene.
    pub(in crate::app) name: &'a str,
    /// Who is woken when the film has ended.
    pub(in crate::app) wake: Wake,
}

/// Everything that a film depends on, when it is begun.
struct Order {
    answer: Arc<Answer>,
    plan: FilmPlan,
    shot: Shot,
    /// Name of numbered pictures.
    name: String,
}

/// A film on its way.
struct Job {
    cancel: Arc<AtomicBool>,
    done: Arc<AtomicUsize>,
    count: u32,
    told: Receiver<Result<Told, Ended>>,
    thread: Option<Thread>,
}

impl Drop for Job {
    fn drop(&mut self) {
        // Waits for a frame at most: what was written so far must be taken away again.
        self.cancel.store(true, Ordering::Relaxed);
        let _ = self.thread.take().map(Thread::join);
    }
}

/// The dialog's plan, and the film that is being written.
#[derive(Default)]
pub struct Films {
    /// State of the dialog, while it is open.
    pub plan: Option<FilmPlan>,
    job: Option<Job>,
}

impl Films {
    /// Executes a command; returns a message to the user.
    pub(in crate::app) fn apply(&mut self, command: FilmCommand, source: Source<'_>) -> Option<&'static str> {
        match command {
            FilmCommand::Ask if !THREADS => return Some(text::NOT_ON_A_PAGE.as_str()),
            FilmCommand::Ask => self.plan = Some(FilmPlan::of(source.stretch[0], source.stretch[1])),
            FilmCommand::Plan(plan) => self.plan = Some(plan),
            FilmCommand::Never => self.plan = None,
            FilmCommand::Shoot(path) => self.shoot(source, path),
            FilmCommand::Cancel => {
                self.job = None;
                return Some(text::FILM_CANCELLED.as_str());
            }
        }
        None
    }

    /// Begins a film; one before is given up.
    fn shoot(&mut self, source: Source<'_>, path: PathBuf) {
        let (Some(plan), Some(answer)) = (self.plan.take(), source.answer.cloned()) else { return };
        self.job = None;
        let Some(count) = plan.frames() else { return };
        let shot = Shot { size: plan.size.unwrap_or(source.shot.size), ..source.shot };
        let (order, wake) = (Order { answer, plan, shot, name: as_file_name(source.name) }, source.wake);
        let (send, told) = channel();
        let (cancel, done) = (Arc::new(AtomicBool::new(false)), Arc::new(AtomicUsize::new(0)));
        let watch = Watch { cancel: cancel.clone(), done: done.clone() };
        let thread = spawn(move || make(&order, count, &path, &watch, &send, &wake));
        self.job = Some(Job { cancel, done, count, told, thread });
    }

    /// Frames written and frames in all, while a film is being written.
    pub fn progress(&self) -> Option<(usize, u32)> {
        self.job.as_ref().map(|job| (job.done.load(Ordering::Relaxed), job.count))
    }

    /// Message on a film that has ended.
    pub(in crate::app) fn poll(&mut self) -> Option<Told> {
        let told = match self.job.as_ref()?.told.try_recv() {
            Err(TryRecvError::Empty) => return None,
            Ok(Ok(told)) => told,
            Ok(Err(ended)) => Told::from(ended.to_string()),
            Err(TryRecvError::Disconnected) => Told::from(Ended::Cancelled.to_string()),
        };
        self.job = None;
        Some(told)
    }
}

/// Why there is no film.
#[derive(Debug, thiserror::Error)]
enum Ended {
    #[error("{}", text::FILM_CANCELLED)]
    Cancelled,
    #[error(transparent)]
    Gpu(#[from] GpuError),
    #[error(transparent)]
    Gif(#[from] GifError),
    #[error(transparent)]
    Write(#[from] WriteError),
}

/// Flags shared by the window and the thread.
struct Watch {
    cancel: Arc<AtomicBool>,
    done: Arc<AtomicUsize>,
}

impl Watch {
    fn reached(&self, frames: usize) -> Result<(), Ended> {
        self.done.store(frames, Ordering::Relaxed);
        if self.cancel.load(Ordering::Relaxed) { Err(Ended::Cancelled) } else { Ok(()) }
    }
}

fn make(order: &Order, count: u32, path: &Path, watch: &Watch, told: &Sender<Result<Told, Ended>>, wake: &Wake) {
    let plan = &order.plan;
    let history = &order.answer.history;
    let camera = Some(order.shot.camera(history));
    let shot = |t| Shot { at: Instant::At(t), camera, ..order.shot.clone() };
    let shots: Vec<Shot> = instants(plan.from, plan.to, count).map(shot).collect();
    let made = Studio::open(None).map_err(Ended::from).and_then(|mut studio| match plan.format {
        FilmFormat::Gif => one_file(&mut studio, order, &shots, path, watch),
        FilmFormat::Png => pictures(&mut studio, order, &shots, path, watch),
    });
    // Nobody listens any more when the window has closed: nothing to do then.
    let words = || format!("{} {}: {count}", text::FILM_WRITTEN, path.display());
    let _ = told.send(made.map(|()| Told { words: words(), place: Some(path.to_owned()) }));
    wake();
}

fn one_file(studio: &mut Studio, order: &Order, shots: &[Shot], path: &Path, watch: &Watch) -> Result<(), Ended> {
    let mut draft = Draft::create(path)?;
    gif::<Ended>(studio, &order.answer.history, shots, order.plan.fps, &mut draft, &mut |done| watch.reached(done))?;
    Ok(draft.finish()?)
}

fn pictures(studio: &mut Studio, order: &Order, shots: &[Shot], folder: &Path, watch: &Watch) -> Result<(), Ended> {
    let (mut set, mut written) = (FileSet::default(), 0);
    film::<Ended>(studio, &order.answer.history, shots, Packing::Quick, &mut |Frame { number, png }| {
        set.add(&folder.join(format!("{}-{:04}.png", order.name, number + 1)), &png)?;
        written += 1;
        watch.reached(written)
    })?;
    Ok(set.finish()?)
}
