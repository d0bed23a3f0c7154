//! The timer, and a progress bar on a terminal for anything longer than half a second.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::digits::six;
use crate::language::{Text, said};

/// How long something may take before a bar shows.
const BAR_DELAY: Duration = Duration::from_millis(500);
/// Parts that a bar's length is divided into.
const PARTS: f64 = 1000.0;

/// Time since it was started.
#[derive(Clone, Copy, Debug)]
pub(super) struct Timer(Instant);

impl Timer {
    /// Starts now.
    #[expect(clippy::disallowed_methods, reason = "the timer: it measures the program, not the physics")]
    pub(super) fn start() -> Self {
        Self(Instant::now())
    }

    /// Seconds since the start.
    pub(super) fn seconds(self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}

/// A bar on standard error; nothing where that is no terminal.
#[derive(Debug)]
pub(super) struct Progress {
    started: Timer,
    whole: f64,
    unit: Text,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// For work that goes from 0 to `whole`, counted in `unit`.
    pub(super) fn over(whole: f64, unit: Text) -> Self {
        Self { started: Timer::start(), whole, unit, bar: None }
    }

    /// Shows that the work has reached `reached`.
    pub(super) fn show(&mut self, reached: f64) {
        self.show_of(reached, "");
    }

    /// The same, with more words.
    pub(super) fn show_of(&mut self, reached: f64, words: &str) {
        if self.bar.is_none() && self.started.seconds() > BAR_DELAY.as_secs_f64() {
            self.bar = Some(new_bar());
        }
        if let Some(bar) = &self.bar {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0..=PARTS")]
            bar.set_position((reached / self.whole * PARTS).clamp(0.0, PARTS) as u64);
            let digits = if reached.fract() == 0.0 { 0 } else { 3 };
            let reached = format!("{reached:.digits$}");
            let (whole, unit) = (six(self.whole), self.unit);
            bar.set_message(
                said!("progress-of", "reached" => reached, "whole" => whole, "unit" => unit, "words" => words),
            );
        }
    }

    /// Takes the bar away.
    pub(super) fn done(self) {
        if let Some(bar) = self.bar {
            bar.finish_and_clear();
        }
    }
}

/// A sign of life on a terminal while something goes on that does not say how far it is; it ends when dropped.
#[derive(Debug)]
pub(super) struct Waiting(Option<ProgressBar>);

impl Waiting {
    /// For work that may take about `seconds`; nothing shows if that is short.
    pub(super) fn for_about(seconds: f64, what: Text) -> Self {
        let long = seconds > BAR_DELAY.as_secs_f64();
        Self(long.then(|| {
            let spinner = ProgressBar::new_spinner().with_message(what.as_str());
            spinner.enable_steady_tick(Duration::from_millis(200));
            spinner
        }))
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        if let Some(spinner) = &self.0 {
            spinner.finish_and_clear();
        }
    }
}

fn new_bar() -> ProgressBar {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive constant")]
    let bar = ProgressBar::new(PARTS as u64);
    // The template is a constant; were it wrong, indicatif's own would do.
    match ProgressStyle::with_template(&format!(
        "{{bar:40}} {{percent}}% {{msg}}, {}",
        said!("progress-left", "left" => "{eta}")
    )) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
