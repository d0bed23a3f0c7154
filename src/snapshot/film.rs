//! Many pictures of one run: one device draws them while other threads make of those before what is written.

use std::num::NonZero;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{Scope, available_parallelism, scope};

use super::{Shot, Studio};
use crate::render::{GpuError, Image, Packing};
use crate::sim::History;
use crate::view::DrawList;

/// More threads than this would wait for the device.
const MOST_THREADS: usize = 8;

/// A finished frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Its place in the film, from 0.
    pub number: usize,
    /// The bytes of its PNG file.
    pub png: Vec<u8>,
}

/// Metadata of a picture's file.
type Texts = [(&'static str, String); 4];

/// A picture on its way to its file.
struct Job {
    number: usize,
    image: Arc<Image>,
    texts: Texts,
}

/// `count` instants at even intervals, both ends among them \[s\].
pub fn instants(from: f64, to: f64, count: u32) -> impl Iterator<Item = f64> {
    let last = f64::from(count.saturating_sub(1).max(1));
    (0..count).map(move |i| from + (to - from) * (f64::from(i) / last))
}

/// Takes the shots one after another; `each` gets the finished frames, in whatever order they are ready.
///
/// A shot that shows what the one before it showed is not drawn again. Returns how many were drawn.
///
/// # Errors
///
/// Those of the device or of `each`; frames after that are not made.
pub fn film<E: From<GpuError>>(
    studio: &mut Studio,
    history: &History,
    shots: &[Shot],
    packing: Packing,
    each: &mut dyn FnMut(Frame) -> Result<(), E>,
) -> Result<usize, E> {
    let png = |image: &Image, texts: &Texts| image.to_png(texts, packing);
    reel(studio, history, shots, &png, &mut |number, png| each(Frame { number, png }))
}

/// Takes the shots one after another; threads `develop` each, and `each` gets what comes of it, in whatever order.
///
/// # Errors
/// As [`film`].
pub(super) fn reel<T: Send, E: From<GpuError>>(
    studio: &mut Studio,
    history: &History,
    shots: &[Shot],
    develop: &(dyn Fn(&Image, &Texts) -> T + Sync),
    each: &mut dyn FnMut(usize, T) -> Result<(), E>,
) -> Result<usize, E> {
    let threads = available_parallelism().map_or(1, NonZero::get).saturating_sub(1).clamp(1, MOST_THREADS);
    let (to_pack, jobs) = sync_channel(threads);
    let (done, frames) = channel();
    let jobs = Mutex::new(jobs);
    scope(|scope| {
        (0..threads).for_each(|_| pack(scope, &jobs, done.clone(), develop));
        // The last sender's end is the packers' own.
        drop(done);
        let drawn = draw(studio, history, shots, &to_pack, &mut || {
            frames.try_iter().try_for_each(|(number, made)| each(number, made))
        });
        // No more jobs: the packers end, and with them what is received.
        drop(to_pack);
        let drawn = drawn?;
        frames.iter().try_for_each(|(number, made)| each(number, made))?;
        Ok(drawn)
    })
}

/// Draws the shots and hands them on; `collect` takes what is ready between two of them.
fn draw<E: From<GpuError>>(
    studio: &mut Studio,
    history: &History,
    shots: &[Shot],
    to_pack: &SyncSender<Job>,
    collect: &mut dyn FnMut() -> Result<(), E>,
) -> Result<usize, E> {
    let mut last: Option<(Vec<DrawList>, Arc<Image>)> = None;
    let mut drawn = 0;
    for (number, shot) in shots.iter().enumerate() {
        let lists = shot.lists(history);
        let image = if let Some((_, image)) = last.take().filter(|(before, _)| *before == lists) {
            image
        } else {
            drawn += 1;
            Arc::new(studio.expose(&lists)?)
        };
        last = Some((lists, image.clone()));
        let texts = studio.texts(history.scene(), shot.at.of(history));
        // The packers outlive this loop, so that somebody always takes it.
        let _ = to_pack.send(Job { number, image, texts });
        collect()?;
    }
    Ok(drawn)
}

/// A thread that develops pictures until there are no more.
fn pack<'s, T: Send + 's>(
    scope: &'s Scope<'s, '_>,
    jobs: &'s Mutex<Receiver<Job>>,
    done: Sender<(usize, T)>,
    develop: &'s (dyn Fn(&Image, &Texts) -> T + Sync),
) {
    scope.spawn(move || {
        loop {
            let job = jobs.lock().unwrap_or_else(PoisonError::into_inner).recv();
            let Ok(Job { number, image, texts }) = job else { break };
            if done.send((number, develop(&image, &texts))).is_err() {
                break;
            }
        }
    });
}
