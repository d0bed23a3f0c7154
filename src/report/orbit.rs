//! The corner's orbit over its seat through time: the picture that shows unseating.

use std::fmt::Write as _;

use crate::language::{Text, said};
use crate::plot::chart::{number, ticks};
use crate::plot::draw::{line, text};
use crate::plot::paper::{EDGE, EMPTY, GREY, INK, WHITE};
use crate::sim::History;
use crate::sim::seats::seat_on::SeatOn;
use crate::sim::seats::{OrbitPoint, Seat, SeatCorner};
use crate::tables::corner_angle;

const PANEL: f64 = 400.0;
const MARGIN: f64 = 58.0;
/// First and last colour of an orbit.
const COLORS: [[f64; 3]; 2] = [[158.0, 202.0, 225.0], [8.0, 48.0, 107.0]];
/// Pieces of an orbit, each of one colour.
const PIECES: usize = 40;
/// Intervals of an orbit.
const INTERVALS: u32 = 4000;
/// Marks of time along an orbit.
const MARKS: usize = 6;

/// Every seat of a run: caption and picture of both corners.
pub(super) fn pictures(history: &History) -> Vec<(String, String)> {
    let mut all = Vec::new();
    for (girder, body) in history.model().girders().iter().enumerate() {
        for seat in history.seats().of_girder(girder) {
            let orbit = history.seats().orbit(girder, &seat, INTERVALS);
            let fixed = match seat.ledge.on {
                SeatOn::Ground => Text::new("report-orbit-ground"),
                SeatOn::Pier(_) => Text::new("report-orbit-pier"),
                SeatOn::Moved(_) => Text::new("report-orbit-moved"),
            };
            let caption = said!(
                "report-orbits",
                "fixed" => fixed.as_str(),
                "end" => format!("{}{}", body.name, seat.ledge.end.label()),
                "duration" => format!("{:.1}", history.end())
            );
            let kinds = seat.corners.map(|corner| body.prism.corner_kind(corner.corner));
            all.push((caption, svg(&seat, kinds, &orbit, history.end())));
        }
    }
    all
}

fn svg(seat: &Seat, kinds: [&str; 2], orbit: &[OrbitPoint], end: f64) -> String {
    let mut svg = String::new();
    let width = 2.0 * PANEL + 20.0;
    let _ = writeln!(
        svg,
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {PANEL}" width="{width}" height="{PANEL}" font-family="sans-serif"><rect width="{width}" height="{PANEL}" fill="{WHITE}"/>"#
    );
    for (which, (corner, kind)) in seat.corners.iter().zip(kinds).enumerate() {
        let panel = Panel::of(seat, which, orbit, (PANEL + 20.0) * which as f64);
        panel.frame(
            &mut svg,
            &said!("report-corner", "corner" => corner.corner + 1, "kind" => corner_angle(kind).as_str()),
        );
        panel.orbit(&mut svg, orbit, which, end);
        panel.marks(&mut svg, corner, orbit, which);
    }
    svg.push_str("</svg>\n");
    svg
}

/// One corner over its seat.
struct Panel<'a> {
    seat: &'a Seat,
    left: f64,
    /// Lowest along and remaining, and the extent of both \[m\].
    low: [f64; 2],
    extent: f64,
}

impl<'a> Panel<'a> {
    /// A square that holds the orbit, the corner as placed and the front edge.
    fn of(seat: &'a Seat, which: usize, orbit: &[OrbitPoint], left: f64) -> Self {
        let placed = seat.ledge.place_along(which, glam::DVec3::ZERO);
        let start = [[placed, placed], [0.0_f64.min(seat.ledge.placed()), seat.ledge.placed()]];
        let [along, remaining] = [0, 1].map(|axis| {
            orbit.iter().map(|point| point.corners[which][axis]).fold(start[axis], |[a, b], v| [a.min(v), b.max(v)])
        });
        let extent = 1.16 * (along[1] - along[0]).max(remaining[1] - remaining[0]).max(1e-9);
        let low = [along, remaining].map(|[a, b]| f64::midpoint(a, b) - 0.5 * extent);
        Self { seat, left, low, extent }
    }

    fn at(&self, [along, remaining]: [f64; 2]) -> (f64, f64) {
        let side = PANEL - 2.0 * MARGIN + 30.0;
        let part = |v: f64, low: f64| ((v - low) / self.extent).clamp(0.0, 1.0);
        (
            self.left + MARGIN + side * part(along, self.low[0]),
            PANEL - MARGIN + 10.0 - side * part(remaining, self.low[1]),
        )
    }

    /// Seat, front edge, sides and axes.
    fn frame(&self, svg: &mut String, title: &str) {
        let ledge = &self.seat.ledge;
        let high = self.low.map(|low| low + self.extent);
        let half = ledge.side.map_or(f64::INFINITY, |side| ledge.half_end + side);
        let (left, top) = self.at([(-half).max(self.low[0]), ledge.placed().min(high[1])]);
        let (right, bottom) = self.at([half.min(high[0]), 0.0]);
        let _ = writeln!(
            svg,
            r##"<rect x="{left:.1}" y="{top:.1}" width="{:.1}" height="{:.1}" fill="#e4e8ec"/>"##,
            (right - left).max(0.0),
            (bottom - top).max(0.0)
        );
        let pale = format!(r#"stroke="{EMPTY}" stroke-width="0.7""#);
        for value in ticks([self.low[0], high[0]], 4.0) {
            let ((x, y), (_, y_top)) = (self.at([value, self.low[1]]), self.at([value, high[1]]));
            line(svg, (x, y), (x, y_top), &pale);
            text(svg, (x, y + 14.0), 10.0, "middle", GREY, &number(1e3 * value));
        }
        for value in ticks([self.low[1], high[1]], 4.0) {
            let ((x, y), (x_right, _)) = (self.at([self.low[0], value]), self.at([high[0], value]));
            line(svg, (x, y), (x_right, y), &pale);
            text(svg, (x - 5.0, y + 4.0), 10.0, "end", GREY, &number(1e3 * value));
        }
        let edge = format!(r#"stroke="{EDGE}" stroke-width="2.4""#);
        line(svg, (left, bottom), (right, bottom), &edge);
        let (x, y) = self.at([self.low[0], high[1]]);
        text(svg, (x, y - 8.0), 12.0, "start", INK, &said!("report-orbit-axes", "title" => title));
        text(svg, (right - 4.0, bottom + 26.0), 10.0, "end", EDGE, &Text::new("report-front-edge"));
    }

    fn orbit(&self, svg: &mut String, orbit: &[OrbitPoint], which: usize, end: f64) {
        let size = orbit.len().div_ceil(PIECES).max(1);
        for first in (0..orbit.len()).step_by(size) {
            let piece = &orbit[first..(first + size + 1).min(orbit.len())];
            let points: Vec<String> = piece
                .iter()
                .map(|point| {
                    let (x, y) = self.at(point.corners[which]);
                    format!("{x:.1},{y:.1}")
                })
                .collect();
            let part = piece[0].t / end.max(1e-12);
            let color: Vec<String> =
                (0..3).map(|i| format!("{:.0}", COLORS[0][i] + part * (COLORS[1][i] - COLORS[0][i]))).collect();
            let _ = writeln!(
                svg,
                r#"<polyline points="{}" fill="none" stroke="rgb({})" stroke-width="1.3"/>"#,
                points.join(" "),
                color.join(",")
            );
        }
    }

    /// Times along the orbit, the least, and where it comes off.
    fn marks(&self, svg: &mut String, corner: &SeatCorner, orbit: &[OrbitPoint], which: usize) {
        for n in 0..MARKS {
            let Some(point) = orbit.get(n * orbit.len().saturating_sub(1) / (MARKS - 1)) else { continue };
            let (x, y) = self.at(point.corners[which]);
            let _ = writeln!(svg, r#"<circle cx="{x:.1}" cy="{y:.1}" r="1.8" fill="{INK}"/>"#);
            text(svg, (x + 4.0, y - 3.0), 9.0, "start", GREY, &format!("{:.1} s", point.t));
        }
        if let Some(least) = orbit.iter().min_by(|a, b| a.corners[which][1].total_cmp(&b.corners[which][1])) {
            let (x, y) = self.at(least.corners[which]);
            let _ = writeln!(
                svg,
                r#"<circle cx="{x:.1}" cy="{y:.1}" r="5" fill="none" stroke="{INK}" stroke-width="1.6"/>"#
            );
            let words = said!(
                "report-least",
                "least" => number((1e4 * corner.least.value).round() / 10.0),
                "t" => format!("{:.2}", corner.least.t)
            );
            self.beside(svg, (x, y + 14.0), INK, &words);
        }
        if let Some(off) = corner.off {
            let (x, y) = self.at([off.along, 0.0]);
            let style = format!(r#"stroke="{EDGE}" stroke-width="2""#);
            line(svg, (x - 5.0, y - 5.0), (x + 5.0, y + 5.0), &style);
            line(svg, (x - 5.0, y + 5.0), (x + 5.0, y - 5.0), &style);
            self.beside(svg, (x, y - 8.0), EDGE, &said!("report-off-at", "t" => format!("{:.3}", off.t)));
        }
    }

    /// Words beside a point, towards the middle of the panel.
    fn beside(&self, svg: &mut String, (x, y): (f64, f64), color: &str, words: &str) {
        let right = x > self.left + 0.5 * PANEL;
        let (x, anchor) = if right { (x - 9.0, "end") } else { (x + 9.0, "start") };
        text(svg, (x, y), 11.0, anchor, color, words);
    }
}
