//! The stretch of time that the timeline and the plots show, and the mouse on it.
//!
//! One axis for all: a hit in the timeline stands over its force peak. Click and drag scrub, the wheel zooms about the
//! pointer, Shift or the other mouse buttons pan, a double click shows everything.

use egui::{PointerButton, Rect, Response, Ui};

use crate::app::command::{Command, TimeCommand};

/// Times on a strip of pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::app) struct TimeAxis {
    /// First and last time shown \[s\].
    pub(in crate::app) window: [f64; 2],
    /// Left and right edge \[points\].
    pub(in crate::app) edges: [f32; 2],
    /// End of the answer \[s\].
    pub(in crate::app) end: f64,
}

/// Shortest stretch of time that can be shown \[s\].
const SHORTEST: f64 = 1e-6;

impl TimeAxis {
    /// The axis over a rectangle.
    pub(in crate::app) fn over(rect: Rect, window: Option<[f64; 2]>, end: f64) -> Self {
        let end = end.max(SHORTEST);
        Self { window: window.unwrap_or([0.0, end]), edges: [rect.left(), rect.right()], end }
    }

    /// Length of the window \[s\].
    pub(in crate::app) fn span(&self) -> f64 {
        self.window[1] - self.window[0]
    }

    /// Where a time stands \[points\].
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    pub(in crate::app) fn x(&self, t: f64) -> f32 {
        let share = (t - self.window[0]) / self.span();
        // Far outside the window a place is only ever clipped: keep it finite.
        (f64::from(self.edges[0]) + share * f64::from(self.edges[1] - self.edges[0])).clamp(-1e5, 1e5) as f32
    }

    /// Which time stands at a place \[s\].
    pub(in crate::app) fn t(&self, x: f32) -> f64 {
        let width = f64::from((self.edges[1] - self.edges[0]).max(1.0));
        self.window[0] + f64::from(x - self.edges[0]) / width * self.span()
    }

    /// Time per point \[s\].
    pub(in crate::app) fn per_point(&self) -> f64 {
        self.span() / f64::from((self.edges[1] - self.edges[0]).max(1.0))
    }

    /// The window after zooming by `factor` about a place (below 1 comes nearer).
    pub(in crate::app) fn zoomed(&self, factor: f64, x: f32) -> Option<[f64; 2]> {
        let about = self.t(x).clamp(0.0, self.end);
        let span = (self.span() * factor).clamp(SHORTEST, self.end);
        let share = (about - self.window[0]) / self.span();
        self.inside(about - share * span, span)
    }

    /// The window after moving it by so many points.
    pub(in crate::app) fn panned(&self, points: f32) -> Option<[f64; 2]> {
        self.inside(self.window[0] - f64::from(points) * self.per_point(), self.span())
    }

    /// Moves a window inside the answer; `None` is all of it.
    fn inside(&self, start: f64, span: f64) -> Option<[f64; 2]> {
        if span >= self.end * (1.0 - 1e-9) {
            return None;
        }
        let start = start.clamp(0.0, self.end - span);
        Some([start, start + span])
    }

    /// Where the mouse points to a time, in the timeline or in the plots: both show it \[points\].
    pub(in crate::app) fn pointed(&self, ui: &Ui) -> Option<f32> {
        let at = ui.input(|i| i.pointer.hover_pos()).filter(|_| ui.rect_contains_pointer(ui.max_rect()))?;
        (self.edges[0]..=self.edges[1]).contains(&at.x).then_some(at.x)
    }

    /// Commands of the mouse on a strip that shows this axis.
    pub(in crate::app) fn interact(&self, ui: &Ui, response: &Response, out: &mut Vec<Command>) {
        if response.double_clicked() {
            out.push(TimeCommand::Window(None).into());
            return;
        }
        self.drag(ui, response, out);
        // With Alt the wheel is about the values of a chart.
        if let Some(pointer) = response.hover_pos().filter(|_| !ui.input(|i| i.modifiers.alt)) {
            let (scroll, pinch) = ui.input(|i| (i.smooth_scroll_delta, i.zoom_delta()));
            let factor = (-f64::from(scroll.y) * 0.005).exp() / f64::from(pinch);
            if factor != 1.0 {
                out.push(TimeCommand::Window(self.zoomed(factor, pointer.x)).into());
            } else if scroll.x != 0.0 {
                out.push(TimeCommand::Window(self.panned(scroll.x)).into());
            }
        }
    }

    fn drag(&self, ui: &Ui, response: &Response, out: &mut Vec<Command>) {
        let shift = ui.input(|i| i.modifiers.shift);
        let panning = response.dragged_by(PointerButton::Middle)
            || response.dragged_by(PointerButton::Secondary)
            || (shift && response.dragged_by(PointerButton::Primary));
        if panning {
            out.push(TimeCommand::Window(self.panned(response.drag_delta().x)).into());
        } else if (response.dragged_by(PointerButton::Primary) || response.clicked())
            && let Some(pointer) = response.interact_pointer_pos()
        {
            out.push(TimeCommand::Seek(self.t(pointer.x).clamp(0.0, self.end)).into());
        }
    }
}

/// Round times for ticks, about `wanted` of them \[s\].
pub(in crate::app) fn ticks(window: [f64; 2], wanted: f64) -> Vec<f64> {
    let raw = (window[1] - window[0]) / wanted.max(1.0);
    if !(raw.is_finite() && raw > 0.0) {
        return Vec::new();
    }
    let power = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].iter().map(|m| m * power).find(|&s| s >= raw * (1.0 - 1e-9)).unwrap_or(power);
    let first = (window[0] / step).ceil();
    let last = (window[1] / step + 1e-9).floor();
    let mut ticks = Vec::new();
    let mut k = first;
    while k <= last && ticks.len() < 1000 {
        ticks.push(k * step);
        k += 1.0;
    }
    ticks
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    fn axis(window: Option<[f64; 2]>) -> TimeAxis {
        TimeAxis::over(Rect::from_min_max(pos2(100.0, 0.0), pos2(300.0, 20.0)), window, 10.0)
    }

    #[test]
    fn a_time_and_its_place_are_each_other() {
        let axis = axis(Some([2.0, 4.0]));
        assert!((axis.t(axis.x(3.3)) - 3.3).abs() < 1e-5, "to a hundredth of a point, got {}", axis.t(axis.x(3.3)));
    }

    #[test]
    fn zooming_keeps_the_time_under_the_pointer() {
        let axis = axis(None);
        let under = axis.t(150.0);
        let zoomed = TimeAxis { window: axis.zoomed(0.5, 150.0).expect("a part"), ..axis };
        assert!((zoomed.t(150.0) - under).abs() < 1e-9, "stays at {under}, got {}", zoomed.t(150.0));
        assert_eq!(zoomed.zoomed(1e6, 150.0), None, "far out is everything");
    }

    #[test]
    fn panning_stays_inside_the_answer() {
        let axis = axis(Some([0.0, 1.0]));
        assert_eq!(axis.panned(50.0), Some([0.0, 1.0]), "nothing before the start");
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks([0.0, 10.0], 5.0), vec![0.0, 2.0, 4.0, 6.0, 8.0, 10.0], "every 2 s");
        assert_eq!(ticks([0.0, 0.0], 5.0), Vec::<f64>::new(), "no window, no ticks");
    }
}
