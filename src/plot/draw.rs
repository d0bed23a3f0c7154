//! A log–log plot as an SVG document.

use std::fmt::Write as _;

use super::paper::{GREY, INK, PALE, WHITE};
use super::{Guide, Mark, Marker, Plot, Series, Ticks};

const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 560.0;
/// The field: left, top, right, bottom.
const FIELD: [f64; 4] = [86.0, 78.0, 660.0, 492.0];
/// Distance of two labels at least.
const LINE: f64 = 19.0;

/// A logarithmic axis on the paper.
struct Axis {
    from: f64,
    to: f64,
    low: f64,
    high: f64,
}

impl Axis {
    /// Whole decades around the values; counts with a little air.
    fn over(values: impl Iterator<Item = f64>, ticks: Ticks, low: f64, high: f64) -> Self {
        let logs = values.filter(|v| *v > 0.0 && v.is_finite()).map(f64::log10);
        let (least, most) = logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let (least, most) = if least <= most { (least, most) } else { (0.0, 1.0) };
        let (from, to) = match ticks {
            Ticks::Counts => (least - 0.2, most + 0.2),
            Ticks::Powers | Ticks::Times => ((least - 0.08).floor(), (most + 0.08).ceil()),
        };
        Self { from, to: to.max(from + 1.0), low, high }
    }

    fn at(&self, value: f64) -> f64 {
        let part = (value.log10() - self.from) / (self.to - self.from);
        self.low + (self.high - self.low) * part
    }

    /// Decades, thinned out where there are many.
    fn decades(&self) -> impl Iterator<Item = i32> {
        #[expect(clippy::cast_possible_truncation, reason = "decades of f64")]
        let (from, to) = (self.from.ceil() as i32, self.to.floor() as i32);
        let every = (to - from) / 12 + 1;
        (from..=to).filter(move |d| d.rem_euclid(every) == 0)
    }
}

/// A text in SVG and HTML; control characters, of which XML allows but line breaks and tabs, stand as U+FFFD.
pub(crate) fn escape(text: &str) -> String {
    let is_barred = |c: char| c.is_control() && !matches!(c, '\n' | '\t');
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace(is_barred, "\u{fffd}")
}

pub(crate) fn text(svg: &mut String, (x, y): (f64, f64), size: f64, anchor: &str, color: &str, content: &str) {
    let _ = writeln!(
        svg,
        r#"<text x="{x:.1}" y="{y:.1}" font-size="{size}" text-anchor="{anchor}" fill="{color}">{content}</text>"#
    );
}

pub(crate) fn line(svg: &mut String, (x1, y1): (f64, f64), (x2, y2): (f64, f64), style: &str) {
    let _ = writeln!(svg, r#"<line x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}" {style}/>"#);
}

fn tick_label(decade: i32, ticks: Ticks) -> String {
    let power = || {
        let sign = if decade < 0 { "−" } else { "" };
        format!(r#"10<tspan dy="-5" font-size="10">{sign}{}</tspan>"#, decade.abs())
    };
    let of = |unit: &str, below: i32| format!("{} {unit}", 10_u64.pow(decade.abs_diff(below)));
    match ticks {
        Ticks::Times if (-9..-6).contains(&decade) => of("ns", -9),
        Ticks::Times if (-6..-3).contains(&decade) => of("µs", -6),
        Ticks::Times if (-3..0).contains(&decade) => of("ms", -3),
        Ticks::Times if (0..4).contains(&decade) => of("s", 0),
        Ticks::Counts if (0..7).contains(&decade) => 10_u64.pow(decade.unsigned_abs()).to_string(),
        _ => power(),
    }
}

fn marker(svg: &mut String, shape: Marker, (x, y): (f64, f64), r: f64, color: &str) {
    let points = |list: &[(f64, f64)]| -> String {
        list.iter().map(|(dx, dy)| format!("{:.1},{:.1}", x + r * dx, y + r * dy)).collect::<Vec<_>>().join(" ")
    };
    let rim = format!(r#"stroke="{WHITE}" stroke-width="1""#);
    let polygon: &[(f64, f64)] = match shape {
        Marker::Circle => {
            let _ = writeln!(svg, r#"<circle cx="{x:.1}" cy="{y:.1}" r="{r}" fill="{color}" {rim}/>"#);
            return;
        }
        Marker::Cross => {
            let style = format!(r#"stroke="{color}" stroke-width="2""#);
            line(svg, (x - r, y - r), (x + r, y + r), &style);
            line(svg, (x - r, y + r), (x + r, y - r), &style);
            return;
        }
        Marker::Square => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
        Marker::Triangle => &[(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)],
        Marker::Diamond => &[(0.0, -1.3), (1.1, 0.0), (0.0, 1.3), (-1.1, 0.0)],
        Marker::Down => &[(0.0, 1.2), (1.1, -0.8), (-1.1, -0.8)],
    };
    let _ = writeln!(svg, r#"<polygon points="{}" fill="{color}" {rim}/>"#, points(polygon));
}

/// Heights of labels, in the order given, moved apart where they would lie on one another.
fn spread(wanted: &[f64], low: f64, high: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]));
    let mut at = wanted.to_vec();
    let mut free = low;
    for &i in &order {
        at[i] = at[i].max(free);
        free = at[i] + LINE;
    }
    let mut limit = high;
    for &i in order.iter().rev() {
        at[i] = at[i].min(limit);
        limit = at[i] - LINE;
    }
    at
}

impl Plot {
    /// The plot as an SVG document.
    pub fn svg(&self) -> String {
        let [left, top, right, bottom] = FIELD;
        let all = || {
            let series = self.series.iter().flat_map(|s| s.points.iter().copied());
            series.chain(self.marks.iter().map(|m| m.at))
        };
        let x = Axis::over(all().map(|p| p.0), self.x.1, left, right);
        let y = Axis::over(all().map(|p| p.1).chain(self.floor.iter().map(|f| f.0)), self.y.1, bottom, top);
        let mut svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" font-family="Ubuntu, 'Helvetica Neue', Arial, sans-serif">
<rect width="{WIDTH}" height="{HEIGHT}" fill="{WHITE}"/>
<clipPath id="field"><rect x="{left}" y="{top}" width="{}" height="{}"/></clipPath>
"#,
            right - left,
            bottom - top
        );
        text(&mut svg, (left, 34.0), 19.0, "start", INK, &escape(&self.title));
        text(&mut svg, (left, 57.0), 13.0, "start", GREY, &escape(&self.subtitle));
        self.grid(&mut svg, &x, &y);
        svg.push_str("<g clip-path=\"url(#field)\">\n");
        self.floor(&mut svg, &y);
        draw_guides(&mut svg, &self.guides, &x, &y);
        self.series.iter().filter(|s| !s.strong).for_each(|s| draw_series(&mut svg, s, &x, &y));
        self.series.iter().filter(|s| s.strong).for_each(|s| draw_series(&mut svg, s, &x, &y));
        svg.push_str("</g>\n");
        draw_marks(&mut svg, &self.marks, &x, &y);
        self.labels(&mut svg, &x, &y);
        svg.push_str("</svg>\n");
        svg
    }

    fn grid(&self, svg: &mut String, x: &Axis, y: &Axis) {
        let [left, top, right, bottom] = FIELD;
        let style = format!(r#"stroke="{PALE}" stroke-width="1""#);
        for decade in x.decades() {
            let at = x.at(10.0_f64.powi(decade));
            line(svg, (at, top), (at, bottom), &style);
            text(svg, (at, bottom + 20.0), 13.0, "middle", INK, &tick_label(decade, self.x.1));
        }
        for decade in y.decades() {
            let at = y.at(10.0_f64.powi(decade));
            line(svg, (left, at), (right, at), &style);
            text(svg, (left - 9.0, at + 4.5), 13.0, "end", INK, &tick_label(decade, self.y.1));
        }
        let frame = format!(r#"stroke="{INK}" stroke-width="1""#);
        line(svg, (left, bottom), (right, bottom), &frame);
        line(svg, (left, top), (left, bottom), &frame);
        let middle = f64::midpoint(left, right);
        text(svg, (middle, bottom + 46.0), 14.0, "middle", INK, &escape(&self.x.0));
        let (px, py) = (24.0, f64::midpoint(top, bottom));
        let _ = writeln!(
            svg,
            r#"<text x="{px}" y="{py:.1}" font-size="14" text-anchor="middle" fill="{INK}" transform="rotate(-90 {px} {py:.1})">{}</text>"#,
            escape(&self.y.0)
        );
    }

    fn floor(&self, svg: &mut String, y: &Axis) {
        let Some((height, why)) = &self.floor else { return };
        let [left, _, right, bottom] = FIELD;
        let at = y.at(*height);
        let _ = writeln!(
            svg,
            r##"<rect x="{left}" y="{at:.1}" width="{}" height="{:.1}" fill="#f1f1f1"/>"##,
            right - left,
            (bottom - at).max(0.0)
        );
        line(svg, (left, at), (right, at), &format!(r#"stroke="{GREY}" stroke-width="1" stroke-dasharray="2 3""#));
        let below = at + 15.0 < bottom - 2.0;
        text(svg, (left + 8.0, if below { at + 15.0 } else { at - 6.0 }), 12.0, "start", GREY, &escape(why));
    }

    /// Names of the lines in the right margin, each beside its line's last point.
    fn labels(&self, svg: &mut String, x: &Axis, y: &Axis) {
        let [_, top, right, bottom] = FIELD;
        let ends: Vec<(&Series, (f64, f64))> =
            self.series.iter().filter_map(|s| s.points.last().map(|p| (s, (x.at(p.0), y.at(p.1))))).collect();
        let wanted: Vec<f64> = ends.iter().map(|(_, (_, y))| *y).collect();
        for ((series, (px, py)), at) in ends.iter().zip(spread(&wanted, top + 6.0, bottom - 4.0)) {
            let style =
                format!(r#"stroke="{}" stroke-width="0.8" stroke-opacity="0.55" stroke-dasharray="1 3""#, series.color);
            line(svg, (px + 7.0, *py), (right + 8.0, at), &style);
            marker(svg, series.marker, (right + 16.0, at), 5.0, series.color);
            let weight = if series.strong { r#" font-weight="bold""# } else { "" };
            let _ = writeln!(
                svg,
                r#"<text x="{:.1}" y="{:.1}" font-size="14"{weight} fill="{INK}">{}</text>"#,
                right + 27.0,
                at + 4.8,
                escape(&series.name)
            );
        }
    }
}

fn draw_series(svg: &mut String, series: &Series, x: &Axis, y: &Axis) {
    let points: Vec<(f64, f64)> = series.points.iter().map(|p| (x.at(p.0), y.at(p.1))).collect();
    let path: Vec<String> = points.iter().map(|(px, py)| format!("{px:.1},{py:.1}")).collect();
    let width = if series.strong { 3.0 } else { 1.8 };
    let _ = writeln!(
        svg,
        r#"<polyline points="{}" fill="none" stroke="{}" stroke-width="{width}" stroke-linejoin="round"/>"#,
        path.join(" "),
        series.color
    );
    let size = if series.strong { 5.5 } else { 4.5 };
    for at in points {
        marker(svg, series.marker, at, size, series.color);
    }
}

/// A fan of slopes in the upper right corner, each over a decade or as far as there is room.
fn draw_guides(svg: &mut String, guides: &[Guide], x: &Axis, y: &Axis) {
    let [_, top, right, _] = FIELD;
    let per_decade = |axis: &Axis| (axis.high - axis.low).abs() / (axis.to - axis.from);
    let (across, down) = (per_decade(x), per_decade(y));
    let rising = guides.iter().any(|guide| guide.slope > 0.0);
    let from = (right - 1.15 * across.min(90.0) - 46.0, top + if rising { 94.0 } else { 14.0 });
    let style = format!(r#"stroke="{GREY}" stroke-width="1" stroke-dasharray="7 4""#);
    let end = |guide: &Guide| {
        let steep = -guide.slope * down;
        let decades = (90.0 / across).min(1.0).min(80.0 / steep.abs().max(1e-9));
        (from.0 + decades * across, from.1 + decades * steep)
    };
    for guide in guides {
        let to = end(guide);
        line(svg, from, to, &style);
        // The name stands to the right of the end, or, where another end is just there, to the left, between two of them below.
        let width = 8.0 + 6.6 * guide.name.chars().count() as f64;
        let ends = || guides.iter().map(end).filter(|other| (to.1 - other.1).abs() < LINE);
        let is_met = |side: f64| ends().any(|other| (0.1..width).contains(&(side * (other.0 - to.0))));
        let (at, below, anchor) = match (is_met(1.0), is_met(-1.0)) {
            (false, _) => (to.0 + 4.0, 4.0, "start"),
            (true, false) => (to.0 - 4.0, 4.0, "end"),
            (true, true) => (to.0, LINE, "middle"),
        };
        text(svg, (at, to.1 + below), 12.0, anchor, GREY, &escape(&guide.name));
    }
}

fn draw_marks(svg: &mut String, marks: &[Mark], x: &Axis, y: &Axis) {
    let places: Vec<(f64, f64)> = marks.iter().map(|m| (x.at(m.at.0), y.at(m.at.1))).collect();
    for (i, (mark, &(px, py))) in marks.iter().zip(&places).enumerate() {
        if mark.goal {
            let _ = writeln!(
                svg,
                r#"<circle cx="{px:.1}" cy="{py:.1}" r="7" fill="none" stroke="{INK}" stroke-width="1.6"/>"#
            );
        } else {
            marker(svg, Marker::Cross, (px, py), 5.0, INK);
        }
        // Neighbours at one height take the room above and below.
        let near = places[..i].iter().filter(|(qx, qy)| (qx - px).abs() < 110.0 && (qy - py).abs() < 13.0).count();
        let beside = near == 0 && px + 12.0 + 6.6 * mark.name.chars().count() as f64 <= FIELD[2];
        let (at, height, anchor) = match near {
            0 if beside => (px + 12.0, py + 4.2, "start"),
            0 | 1 => (px, py - 11.0, "middle"),
            _ => (px, py + 20.0, "middle"),
        };
        let _ = writeln!(
            svg,
            r#"<text x="{at:.1}" y="{height:.1}" font-size="12" text-anchor="{anchor}" fill="{INK}" stroke="{WHITE}" stroke-width="3" paint-order="stroke">{}</text>"#,
            escape(&mark.name)
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_keep_their_distance_and_stay_inside() {
        let at = spread(&[10.0, 12.0, 11.0, 95.0, 99.0], 5.0, 100.0);
        let mut sorted = at.clone();
        sorted.sort_by(f64::total_cmp);
        assert!(sorted.windows(2).all(|w| w[1] - w[0] >= LINE - 1e-9), "apart: {at:?}");
        assert!(sorted[0] >= 5.0 && sorted[4] <= 100.0, "inside: {at:?}");
        assert!(at[0] < at[2] && at[2] < at[1], "in the order of their lines: {at:?}");
    }

    #[test]
    fn ticks_speak_the_unit_of_their_axis() {
        assert_eq!(tick_label(-5, Ticks::Times), "10 µs", "times");
        assert_eq!(tick_label(3, Ticks::Counts), "1000", "counts");
        assert!(tick_label(-12, Ticks::Powers).contains("−12"), "powers");
    }
}
