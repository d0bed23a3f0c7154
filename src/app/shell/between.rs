//! Frames between two layouts of the window. While an answer is played where a processor draws, the views go on in every frame and what
//! stands around them now and then: the layout of all panels takes about as much of a frame as the views (`docs/cost.md`).

use egui::Context;

use crate::app::bench::Workbench;
use crate::app::host::Instant;
use crate::app::shell::redraw::Redraw;
use crate::app::shell::surface::Surface;

/// Most frames between two layouts: at 30 frames a second numbers change 5 times a second, which an eye can still read.
const MOST: u32 = 5;
/// How far the time shown goes on between two layouts at most, in the stretch that timeline and plots show \[–\]: 10 points of 1000.
const MOST_TIME: f64 = 0.01;

/// The frames since the last layout.
#[derive(Default)]
pub(super) struct Between {
    /// How many more there may be.
    left: u32,
    /// When the last frame of either kind began.
    since: Option<Instant>,
    /// Time that was shown before the first of them \[s\].
    shown: Option<f64>,
}

impl Between {
    /// A frame that is laid out begins.
    pub(super) fn lay_out(&mut self, began: Instant) {
        *self = Self { left: MOST, since: Some(began), shown: None };
    }

    /// Something but time has happened: the next frame is laid out.
    pub(super) fn end(&mut self) {
        self.left = 0;
    }

    /// Seconds since the last frame where one that began now may be a frame between two layouts.
    fn next(&mut self, began: Instant) -> Option<f64> {
        let since = self.since.replace(began).filter(|_| self.left > 0)?;
        self.left -= 1;
        Some(began.saturating_duration_since(since).as_secs_f64())
    }

    /// Plays on in the views of what is shown, and answers what has to be drawn; none where the frame has to be laid out.
    pub(super) fn play_on(
        &mut self,
        began: Instant,
        bench: &mut Workbench,
        (surface, context): (&mut Surface, &Context),
    ) -> Option<Redraw> {
        // Asked before the views go on: their changes are reported once, to the frame that shows them.
        if !(surface.is_drawn_by_processor() && surface.has_known_frame() && bench.replay.playback.clock.playing) {
            return None;
        }
        let dt = self.next(began)?;
        let shown = *self.shown.get_or_insert(bench.replay.t());
        bench.replay.advance_between(dt);
        let [from, to] = bench.replay.stretch();
        let is_near = (bench.replay.t() - shown).abs() <= MOST_TIME * (to - from);
        // At the end of an answer the window says that nothing is played any more.
        if !(is_near && bench.replay.playback.clock.playing) {
            return None;
        }
        let (viewport, seen) = bench.view_and_seen();
        let pictures = viewport.play_on(&seen)?;
        surface.plan_pictures(context, &pictures, &viewport.take_changes())
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::app::host::now;

    #[test]
    fn every_sixth_frame_is_laid_out_and_each_after_something_has_happened() {
        let (begun, mut between) = (now(), Between::default());
        let mut laid_out = Vec::new();
        for number in 0..20 {
            let began = begun + Duration::from_millis(30 * number);
            if number == 8 {
                between.end();
            }
            if let Some(dt) = between.next(began) {
                assert!((dt - 0.03).abs() < 1e-9, "since the frame before, of either kind: {dt} s");
            } else {
                between.lay_out(began);
                laid_out.push(number);
            }
        }
        assert_eq!(laid_out, [0, 6, 8, 14]);
    }
}
