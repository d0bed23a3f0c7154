//! Frames of a film, and how any number of pictures is taken and written: one device, all files or none, but for what an
//! interrupt leaves finished.

use super::args::{RenderArgs, Wanted};
use crate::cli::failure::Failure;
use crate::cli::interrupt::Writing;
use crate::cli::progress::Progress;
use crate::files::{Draft, FileSet};
use crate::language::{Text, said, values};
use crate::render::Packing;
use crate::sim::History;
use crate::snapshot::{Frame, GifError, Instant, Shot, Studio, film, gif, instants};

/// `count` pictures at even intervals, both ends among them.
///
/// # Errors
/// A span that the run does not reach or that runs backwards.
pub(super) fn frames(args: &RenderArgs, history: &History, count: u32) -> Result<Vec<Wanted>, Failure> {
    let (from, to) = args.span(history)?;
    let still = args.shot(Instant::Peak, history.scene());
    let camera = Some(still.camera(history));
    let digits = count.to_string().len().max(4);
    let frame = |(i, t): (usize, f64)| Wanted {
        path: args.path(history, &format!("{:0digits$}", i + 1)),
        shot: Shot { at: Instant::At(t), camera, ..still.clone() },
    };
    Ok(instants(from, to, count).enumerate().map(frame).collect())
}

/// Takes the pictures and writes them, all or none; says where they are.
///
/// # Errors
/// A size that the device does not draw, a file that cannot be written.
pub(super) fn take(
    args: &RenderArgs,
    studio: &mut Studio,
    history: &History,
    wanted: &[Wanted],
) -> Result<String, Failure> {
    let shots: Vec<Shot> = wanted.iter().map(|w| w.shot.clone()).collect();
    let mut progress = Progress::over(shots.len() as f64, Text::new("progress-pictures"));
    let drawn = if args.gif_file().is_some() {
        take_gif(args, studio, history, &shots, &mut progress)
    } else {
        take_files(args, studio, history, (&shots, wanted), &mut progress)
    };
    progress.done();
    Ok(said(args, wanted, drawn?))
}

fn take_files(
    args: &RenderArgs,
    studio: &mut Studio,
    history: &History,
    (shots, wanted): (&[Shot], &[Wanted]),
    progress: &mut Progress,
) -> Result<usize, Failure> {
    let packing = if args.frames.is_some() || args.marks.given() { Packing::Quick } else { Packing::Small };
    let writing = Writing::begin();
    let mut set = FileSet::default();
    let drawn = film::<Failure>(studio, history, shots, packing, &mut |Frame { number, png }| {
        set.add(&wanted[number].path, &png)?;
        progress.show(set.count() as f64);
        writing.check()
    });
    let finished = set.count();
    match drawn {
        Err(Failure::Interrupted(_)) => {
            set.finish()?;
            Err(interrupted(finished, wanted.len(), args))
        }
        drawn => {
            let drawn = drawn?;
            set.finish()?;
            Ok(drawn)
        }
    }
}

/// Failure by a signal, with the finished pictures of the film.
fn interrupted(finished: usize, count: usize, args: &RenderArgs) -> Failure {
    let place = args.out.display().to_string();
    let values = values!["finished" => finished, "count" => count, "place" => place];
    let words = if args.gif_file().is_some() { "render-finished-frames" } else { "render-finished-pictures" };
    Failure::Interrupted(Text::new(words).with(&values))
}

fn take_gif(
    args: &RenderArgs,
    studio: &mut Studio,
    history: &History,
    shots: &[Shot],
    progress: &mut Progress,
) -> Result<usize, Failure> {
    let writing = Writing::begin();
    let mut draft = Draft::create(&args.out)?;
    let mut finished = 0;
    let drawn = gif::<Failure>(studio, history, shots, args.fps, &mut draft, &mut |written| {
        finished = written;
        progress.show(written as f64);
        writing.check()
    });
    match drawn {
        Err(Failure::Interrupted(_)) if finished > 0 => {
            draft.finish()?;
            Err(interrupted(finished, shots.len(), args))
        }
        drawn => {
            let drawn = drawn?;
            draft.finish()?;
            Ok(drawn)
        }
    }
}

fn said(args: &RenderArgs, wanted: &[Wanted], drawn: usize) -> String {
    let path = |w: &Wanted| w.path.display().to_string();
    let frames = |place: String, count: u32, drawn: usize| {
        format!("{}\n", said!("render-frames", "place" => place, "count" => count, "drawn" => drawn))
    };
    let count = if args.marks.given() { u32::try_from(wanted.len()).ok() } else { args.frames };
    match (count, wanted) {
        (Some(count), _) if args.gif_file().is_some() => frames(args.out.display().to_string(), count, drawn),
        (Some(count), [first, .., last]) => frames(format!("{} … {}", path(first), path(last)), count, drawn),
        _ => wanted.iter().flat_map(|w| [path(w), "\n".to_owned()]).collect(),
    }
}

impl From<GifError> for Failure {
    fn from(error: GifError) -> Self {
        match error {
            GifError::Size(..) => Self::Input(format!("--size: {error}")),
            GifError::Write(_) => Self::Output(error.to_string()),
        }
    }
}
