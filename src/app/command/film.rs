//! Commands about films, and the numbers of one.

use std::path::PathBuf;

use crate::snapshot::MOST_FPS;

/// A longer film is a mistake in a number.
const MOST_FRAMES: u32 = 20_000;

/// Longest film that is offered before a number is typed \[s\]. Chosen: a longer one is not watched to its end, nor sent as a file.
const OFFERED_LENGTH: f64 = 20.0;
/// Speeds that are offered \[s of the run per s\]. Chosen: at the slowest a hit of 10 ms lasts 0.1 s.
const OFFERED_SPEEDS: [f64; 6] = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0];
/// That of longer films \[s of the run per s\]: the fastest at which a run plays.
const FASTEST_OFFERED: f64 = 10.0;

/// Format of a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmFormat {
    /// Numbered pictures in a folder.
    Png,
    /// One file that plays by itself.
    Gif,
}

/// Choices in the film dialog.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmPlan {
    /// Pictures or one file.
    pub format: FilmFormat,
    /// Where in the run it begins \[s\].
    pub from: f64,
    /// Where it ends \[s\].
    pub to: f64,
    /// Seconds of the run in a second of the film.
    pub speed: f64,
    /// Frames in a second of the film \[Hz\].
    pub fps: f64,
    /// Width and height \[pixels\]; as large as the view when none.
    pub size: Option<[u32; 2]>,
}

impl FilmPlan {
    /// A film of a stretch of the run: as slow as leaves it no longer than [`OFFERED_LENGTH`], but
    /// no faster than a run plays.
    pub(in crate::app) fn of(from: f64, to: f64) -> Self {
        let short_enough = |speed: &f64| (to - from) / speed <= OFFERED_LENGTH;
        let speed = OFFERED_SPEEDS.into_iter().find(short_enough).unwrap_or(FASTEST_OFFERED);
        Self { format: FilmFormat::Gif, from, to, speed, fps: 25.0, size: None }
    }

    /// Frames a second that the format can have.
    pub(in crate::app) fn fastest(format: FilmFormat) -> f64 {
        if format == FilmFormat::Gif { MOST_FPS } else { 120.0 }
    }

    /// How many frames there are; `None` when there would be none, or far too many.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked to be in 1..=MOST_FRAMES")]
    pub fn frames(&self) -> Option<u32> {
        let frames = ((self.to - self.from) / self.speed * self.fps).round() + 1.0;
        (self.to >= self.from && (1.0..=f64::from(MOST_FRAMES)).contains(&frames)).then_some(frames as u32)
    }
}

/// The film dialog, and a film that is being written.
#[derive(Clone, Debug, PartialEq)]
pub enum FilmCommand {
    /// Open the dialog.
    Ask,
    /// Another plan.
    Plan(FilmPlan),
    /// Close the dialog.
    Never,
    /// Film into a folder (pictures) or file (GIF).
    Shoot(PathBuf),
    /// Stop filming; nothing stays.
    Cancel,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_film_has_a_frame_at_both_ends() {
        // 1 s of the run at 0.1 s/s and 25 Hz: 250 intervals, 251 frames.
        assert_eq!(FilmPlan::of(0.0, 1.0).frames(), Some(251), "both ends");
        assert_eq!(FilmPlan::of(0.0, 40.0).frames(), Some(501), "20 s of 40 s");
        assert_eq!(FilmPlan::of(0.0, 400.0).frames(), Some(1001), "at the fastest");
        assert_eq!(FilmPlan::of(1.0, 0.0).frames(), None, "ends before it begins");
        assert_eq!(FilmPlan { speed: 1e-6, ..FilmPlan::of(0.0, 1.0) }.frames(), None, "far too long");
    }
}
