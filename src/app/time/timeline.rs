//! The strip of time: every contact of every pair, the playhead, and the mouse on it.
//!
//! Each pair has a lane. Stick fills its upper half in blue, slip its lower half in hatched vermilion: the state can be
//! read by place, texture and colour. A touch shorter than a pixel is still drawn.

use egui::{Align2, FontId, Painter, Pos2, Rect, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};

use crate::app::command::Command;
use crate::app::run::answer::{Answer, Span};
use crate::app::style::theme::{Palette, SLIP, STICK};
use crate::app::text;
use crate::app::time::playback::Playback;
use crate::app::time::time_axis::{TimeAxis, ticks};
use crate::sim::readings::Passed;
use crate::sim::seats::verdict::Verdict;
use crate::sim::{ContactState, Overlap};

/// Height of the ticks' row \[points\].
const RULER: f32 = 15.0;

/// Height of all lanes together \[points\].
const LANES: f32 = 24.0;

/// Narrowest bar \[points\].
const NARROWEST: f32 = 1.5;

/// Between the hatch lines of slip \[points\].
const HATCH: f32 = 4.0;

/// Lowest bar that a hatch can be seen in, and half of the lowest lane \[points\]: stick and slip are one bar each.
const LOWEST: f32 = 1.5;

/// Part of half a lane that is left free over its bar, where that is less than a point. Chosen.
const OVER: f32 = 0.2;

/// Most pairs of a lane that are named \[–\].
const MOST_NAMES: usize = 4;

/// Contents of the timeline.
#[derive(Clone, Copy)]
pub(in crate::app) struct Shown<'a> {
    /// The time shown, and the window of time.
    pub(in crate::app) playback: &'a Playback,
    /// End of the answer \[s\].
    pub(in crate::app) end: f64,
    /// The last good answer.
    pub(in crate::app) answer: Option<&'a Answer>,
    /// Limits of the scene that were passed.
    pub(in crate::app) passed: &'a [Passed],
    /// Girders that do not stay on their seats.
    pub(in crate::app) falls: &'a [(usize, Verdict)],
}

/// Shows the timeline over the rest of the row, its time axis so far from both edges \[points\].
pub(in crate::app) fn show(ui: &mut Ui, shown: Shown<'_>, [left, right]: [f32; 2], out: &mut Vec<Command>) {
    let size = vec2(ui.available_width(), RULER + LANES);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    let Shown { playback, end, answer, passed, falls } = shown;
    let t = playback.clock.t;
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::Slider, true, text::TIMELINE);
        info.value = Some(t);
        info
    });
    let bars = answer.map_or(&[][..], |answer| &answer.spans);
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(told(bars)));
    let strip = Rect::from_min_max(pos2(rect.left() + left, rect.top()), pos2(rect.right() - right, rect.bottom()));
    let axis = TimeAxis::over(strip, playback.window, end);
    axis.interact(ui, &response, out);
    let painter = ui.painter_at(rect);
    let palette = Palette::of(ui);
    let lanes = Rect::from_min_max(pos2(strip.left(), strip.top() + RULER), strip.max);
    painter.rect_filled(lanes, 2.0, palette.track);
    let every = ticks(axis.window, f64::from(strip.width()) / 90.0);
    ruler(&painter, &axis, (strip, &every), &palette);
    caption(ui, rect, lanes);
    if let Some(answer) = answer {
        draw_lanes(&painter, answer, &axis, lanes, &palette);
    }
    if let Some(span) = playback.clock.span {
        bracket(&painter, &axis, strip, span, &palette);
    }
    let fallen = falls.iter().filter(|(_, verdict)| matches!(verdict, Verdict::Falls { .. }));
    if let Some(t) = fallen.map(|(_, verdict)| verdict.t()).reduce(f64::min) {
        beyond(&painter, &axis, strip, t, &palette);
    }
    let overlaps = answer.map_or(&[][..], |answer| answer.history.overlaps());
    let falls = falls.iter().map(|(_, verdict)| verdict.t());
    let times = passed.iter().map(|flag| flag.t).chain(falls).chain(overlaps.iter().map(Overlap::first));
    flags(&painter, times, &axis, strip, &palette);
    // Over the flags, so that both are read.
    times_of(&painter, &axis, (strip, &every), &palette);
    if let Some(x) = axis.pointed(ui) {
        painter.vline(x, strip.y_range(), Stroke::new(1.0, palette.weak));
    }
    playhead(&painter, &axis, strip, t, &palette);
    if let (Some(answer), Some(at)) = (answer, response.hover_pos().filter(|at| lanes.contains(*at))) {
        let whose = whose(answer, lanes, at.y);
        if !response.dragged() && !whose.is_empty() {
            response.on_hover_text_at_pointer(whose);
        }
    }
}

/// Names of the pairs in the lane at this height.
fn whose(answer: &Answer, lanes: Rect, y: f32) -> String {
    let pairs: Vec<usize> = Rows::of(answer, lanes).pairs_at(y).collect();
    let model = answer.history.model();
    let names: Vec<&str> = pairs.iter().take(MOST_NAMES).map(|pair| model.pairs[*pair].name.as_str()).collect();
    match pairs.len().saturating_sub(MOST_NAMES) {
        0 => names.join(", "),
        more => text::and_more(&names.join(", "), more),
    }
}

/// The bars in words, for who does not see them.
fn told(bars: &[Span]) -> String {
    let time = |state| bars.iter().filter(|bar| bar.state == state).map(|bar| bar.end - bar.start).sum();
    text::bars(bars.len(), time(ContactState::Stick), time(ContactState::Slip))
}

/// The nearest x of a strip, its left edge where a narrow row leaves it no width.
fn within(strip: Rect, x: f32) -> f32 {
    x.min(strip.right()).max(strip.left())
}

/// From when a girder falls on, where the model computes no motion of it: shaded.
fn beyond(painter: &Painter, axis: &TimeAxis, strip: Rect, t: f64, palette: &Palette) {
    let from = within(strip, axis.x(t));
    let shade = Rect::from_min_max(pos2(from, strip.top()), strip.max);
    painter.rect_filled(shade, 0.0, palette.problem.gamma_multiply(0.16));
    painter.vline(from, strip.y_range(), Stroke::new(1.0, palette.problem));
}

/// The stretch that is played: a bar over the ruler; what is not played is dimmed.
fn bracket(painter: &Painter, axis: &TimeAxis, strip: Rect, span: [f64; 2], palette: &Palette) {
    let [from, to] = span.map(|t| within(strip, axis.x(t)));
    let bar = Rect::from_min_max(pos2(from, strip.top()), pos2(to, strip.top() + 3.0));
    painter.rect_filled(bar, 1.0, palette.theta);
    for (a, b) in [(strip.left(), from), (to, strip.right())] {
        let dim = Rect::from_min_max(pos2(a, strip.top()), pos2(b, strip.bottom()));
        painter.rect_filled(dim, 0.0, palette.track.gamma_multiply(0.55));
    }
}

/// A little flag where a limit is passed, a girder comes off its seat or bodies overlap without contact for the first time.
fn flags(painter: &Painter, times: impl Iterator<Item = f64>, axis: &TimeAxis, strip: Rect, palette: &Palette) {
    for t in times {
        let x = axis.x(t);
        if !strip.x_range().contains(x) {
            continue;
        }
        painter.vline(x, strip.y_range(), Stroke::new(1.2, palette.problem));
        let top = strip.top();
        let cloth = vec![pos2(x, top), pos2(x + 8.0, top + 3.5), pos2(x, top + 7.0)];
        painter.add(egui::Shape::convex_polygon(cloth, palette.problem, Stroke::NONE));
    }
}

fn caption(ui: &Ui, rect: Rect, lanes: Rect) {
    let at = pos2(rect.left(), lanes.center().y);
    ui.painter().text(at, Align2::LEFT_CENTER, text::CONTACTS, small(), Palette::of(ui).weak);
}

fn small() -> FontId {
    FontId::proportional(10.5)
}

/// Lines at these times.
fn ruler(painter: &Painter, axis: &TimeAxis, (strip, every): (Rect, &[f64]), palette: &Palette) {
    for &t in every {
        painter.vline(axis.x(t), strip.top() + RULER - 4.0..=strip.bottom(), Stroke::new(1.0, palette.line));
    }
}

/// These times in figures above the lanes.
fn times_of(painter: &Painter, axis: &TimeAxis, (strip, every): (Rect, &[f64]), palette: &Palette) {
    let step = every.get(1).zip(every.first()).map_or(1.0, |(b, a)| b - a);
    for &t in every {
        let x = axis.x(t);
        let align = if x > strip.right() - 46.0 { Align2::RIGHT_TOP } else { Align2::LEFT_TOP };
        let aside = if align == Align2::LEFT_TOP { 2.0 } else { -2.0 };
        painter.text(pos2(x + aside, strip.top()), align, text::tick(t, step), small(), palette.weak);
    }
}

fn draw_lanes(painter: &Painter, answer: &Answer, axis: &TimeAxis, lanes: Rect, palette: &Palette) {
    let rows = Rows::of(answer, lanes);
    for i in 1..rows.count {
        painter.hline(lanes.x_range(), rows.top(i), Stroke::new(0.5, palette.line));
    }
    let mut last = vec![[f32::NEG_INFINITY; 2]; rows.count];
    for span in visible(&answer.spans, axis.window) {
        let slip = usize::from(span.state == ContactState::Slip);
        let (from, to) = (axis.x(span.start), axis.x(span.end));
        let to = to.max(from + NARROWEST);
        // Far out, thousands of touches share a pixel: one bar for each is enough.
        let Some(done) = last.get_mut(rows.of_pair(span.pair)).map(|l| &mut l[slip]) else { continue };
        if to - *done < 0.5 {
            continue;
        }
        *done = to;
        let bar = rows.bar(rows.of_pair(span.pair), slip, from..=to);
        if slip == 0 {
            painter.rect_filled(bar, 0.0, STICK);
        } else {
            hatched(painter, bar.intersect(lanes));
        }
    }
    hits(painter, answer, axis, lanes, palette);
}

/// The lanes: one for each pair, as long as they can be told apart.
struct Rows {
    count: usize,
    pairs: Vec<usize>,
    first: f32,
    height: f32,
}

impl Rows {
    fn of(answer: &Answer, lanes: Rect) -> Self {
        Self::over(answer.history.hits().listed_pairs(), lanes)
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a strip of some points")]
    fn over(pairs: Vec<usize>, lanes: Rect) -> Self {
        let count = pairs.len().min((lanes.height() / (2.0 * LOWEST)) as usize).max(1);
        Self { count, pairs, first: lanes.top(), height: lanes.height() / count as f32 }
    }

    fn of_pair(&self, pair: usize) -> usize {
        let place = self.pairs.binary_search(&pair).unwrap_or(0);
        place * self.count / self.pairs.len().max(1)
    }

    fn top(&self, row: usize) -> f32 {
        self.first + row as f32 * self.height
    }

    /// A bar of a row between two places of the strip: of stick above (0), of slip below (1).
    fn bar(&self, row: usize, state: usize, between: std::ops::RangeInclusive<f32>) -> Rect {
        let half = 0.5 * self.height;
        let top = self.top(row) + state as f32 * half;
        Rect::from_x_y_ranges(between, top + (OVER * half).min(1.0)..=top + half)
    }

    /// Numbers of the pairs whose bars are in the row at this height \[points\].
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a row of the strip")]
    fn pairs_at(&self, y: f32) -> impl Iterator<Item = usize> + '_ {
        let row = (((y - self.first) / self.height).max(0.0) as usize).min(self.count - 1);
        self.pairs.iter().copied().filter(move |pair| self.of_pair(*pair) == row)
    }
}

/// Hits of the impact model: a tick over the lane's whole height, with a head.
fn hits(painter: &Painter, answer: &Answer, axis: &TimeAxis, lanes: Rect, palette: &Palette) {
    let rows = Rows::of(answer, lanes);
    let height = rows.height;
    let mut last = vec![f32::NEG_INFINITY; rows.count];
    for &(pair, t) in &answer.hits {
        let x = axis.x(t);
        let Some(done) =
            last.get_mut(rows.of_pair(pair)).filter(|done| x - **done >= 1.0 && lanes.x_range().contains(x))
        else {
            continue;
        };
        *done = x;
        let top = rows.top(rows.of_pair(pair));
        painter.vline(x, top..=top + height, Stroke::new(1.0, palette.force));
        let head = vec![pos2(x - 2.5, top), pos2(x + 2.5, top), pos2(x, top + 4.0)];
        painter.add(egui::Shape::convex_polygon(head, palette.force, Stroke::NONE));
    }
}

/// The spans that reach into a window; spans are ordered by start, touches are short.
fn visible(spans: &[Span], window: [f64; 2]) -> impl Iterator<Item = &Span> {
    let upto = spans.partition_point(|s| s.start <= window[1]);
    spans[..upto].iter().filter(move |s| s.end >= window[0])
}

fn hatched(painter: &Painter, bar: Rect) {
    let line = Stroke::new(1.2, SLIP);
    if bar.width() < HATCH || bar.height() < LOWEST {
        painter.rect_filled(bar, 0.0, SLIP);
        return;
    }
    painter.rect_filled(bar, 0.0, SLIP.gamma_multiply(0.35));
    let inside = painter.with_clip_rect(painter.clip_rect().intersect(bar));
    let mut x = bar.left() - bar.height();
    while x < bar.right() {
        inside.line_segment([Pos2::new(x, bar.bottom()), Pos2::new(x + bar.height(), bar.top())], line);
        x += HATCH;
    }
}

fn playhead(painter: &Painter, axis: &TimeAxis, strip: Rect, t: f64, palette: &Palette) {
    let x = axis.x(t);
    if x < strip.left() - 1.0 || x > strip.right() + 1.0 {
        return;
    }
    painter.vline(x, strip.y_range(), Stroke::new(1.5, palette.playhead));
    let top = strip.top();
    let handle = vec![pos2(x - 5.0, top), pos2(x + 5.0, top), pos2(x, top + 7.0)];
    painter.add(egui::Shape::convex_polygon(handle, palette.playhead, Stroke::NONE));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_of_many_has_bars_that_are_seen_and_a_lane_that_names_it() {
        for pairs in [1, 3, 8, 21, 400] {
            let lanes = Rect::from_min_size(pos2(0.0, 100.0), vec2(500.0, LANES));
            let rows = Rows::over((0..pairs).collect(), lanes);
            for pair in 0..pairs {
                for state in [0, 1] {
                    let bar = rows.bar(rows.of_pair(pair), state, 10.0..=12.0);
                    assert!(bar.height() >= 0.75 * LOWEST && lanes.contains_rect(bar), "{pair} of {pairs}: {bar:?}");
                    let whose: Vec<usize> = rows.pairs_at(bar.center().y).collect();
                    assert!(whose.contains(&pair), "{pair} of {pairs}: {whose:?}");
                }
            }
        }
    }
}
