//! Curves on linear axes as an SVG document: panels one above the other over one axis, or a single one of any kind.

use std::fmt::Write as _;

use super::draw::{escape, line, text};
use super::paper::{GREY, INK, PALE, WHITE};

const WIDTH: f64 = 900.0;
/// Height of a panel with the room below it.
const PANEL: f64 = 190.0;
const TOP: f64 = 64.0;
/// The same of a chart without a title.
const UNTITLED: f64 = 26.0;
const LEFT: f64 = 84.0;
const RIGHT: f64 = 690.0;

/// A line of a panel.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Text of its label.
    pub name: String,
    /// `#rrggbb`.
    pub color: String,
    /// Lengths of dashes and breaks; none for a full line.
    pub dashes: &'static str,
    /// In the order they are joined in; what is not finite is a break.
    pub points: Vec<[f64; 2]>,
}

/// A field with curves.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Name of the upright axis with its unit.
    pub name: String,
    /// The lines.
    pub curves: Vec<Curve>,
}

/// Panels over one axis.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Title, in a line.
    pub title: String,
    /// Name of the level axis with its unit.
    pub x: String,
    /// From above to below.
    pub panels: Vec<Panel>,
}

/// Lowest and highest of finite values, never empty.
pub(crate) fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let finite = values.filter(|v| v.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    match (low <= high, low == high) {
        (true, false) => [low, high],
        (true, true) => [low - 0.5 * low.abs().max(1e-9), high + 0.5 * high.abs().max(1e-9)],
        _ => [0.0, 1.0],
    }
}

/// About `wanted` round values in a range.
pub(crate) fn ticks([low, high]: [f64; 2], wanted: f64) -> Vec<f64> {
    let raw = (high - low) / wanted;
    let power = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].iter().map(|m| m * power).find(|s| *s >= raw * (1.0 - 1e-9)).unwrap_or(raw);
    let first = (low / step).ceil();
    (0..40).map(|i| (first + f64::from(i)) * step).take_while(|v| *v <= high * (1.0 + 1e-12) + 1e-300).collect()
}

/// Short, with no needless zeros.
pub(crate) fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !(1e-3..1e6).contains(&value.abs()) {
        return format!("{value:.1e}").replace('-', "−");
    }
    let words = format!("{value:.4}");
    words.trim_end_matches('0').trim_end_matches('.').replace('-', "−")
}

impl Chart {
    /// The document.
    pub fn to_svg(&self) -> String {
        self.document(None)
    }

    /// The document with all panels on one scale, for comparison.
    pub fn to_svg_on_one_scale(&self) -> String {
        self.document(Some(range(self.panels.iter().flat_map(Panel::values))))
    }

    /// The document; upright axes over this range, or each over that of its curves.
    fn document(&self, upright: Option<[f64; 2]>) -> String {
        let first = if self.title.is_empty() { UNTITLED } else { TOP };
        let height = first + PANEL * self.panels.len().max(1) as f64 + 14.0;
        let mut svg = String::new();
        let _ = writeln!(
            svg,
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" font-family="sans-serif">"#
        );
        let _ = writeln!(svg, r#"<rect width="{WIDTH}" height="{height}" fill="{WHITE}"/>"#);
        text(&mut svg, (LEFT, 30.0), 17.0, "start", INK, &escape(&self.title));
        let x = range(self.panels.iter().flat_map(|p| &p.curves).flat_map(|c| &c.points).map(|p| p[0]));
        for (number, panel) in self.panels.iter().enumerate() {
            let y = upright.unwrap_or_else(|| range(panel.values()));
            panel.draw(&mut svg, [x, y], first + PANEL * number as f64, number + 1 == self.panels.len());
        }
        text(&mut svg, (f64::midpoint(LEFT, RIGHT), height - 10.0), 13.0, "middle", INK, &escape(&self.x));
        svg.push_str("</svg>\n");
        svg
    }
}

impl Panel {
    /// Upright values of all curves.
    fn values(&self) -> impl Iterator<Item = f64> {
        self.curves.iter().flat_map(|curve| &curve.points).map(|point| point[1])
    }

    fn draw(&self, svg: &mut String, [x, [low, high]]: [[f64; 2]; 2], top: f64, last: bool) {
        let bottom = top + PANEL - 34.0;
        let margin = 0.06 * (high - low);
        let y = [low - margin, high + margin];
        let at = |p: [f64; 2]| {
            let part = |v: f64, [a, b]: [f64; 2]| (v - a) / (b - a);
            (LEFT + (RIGHT - LEFT) * part(p[0], x), bottom + (top - bottom) * part(p[1], y))
        };
        let pale = format!(r#"stroke="{PALE}" stroke-width="1""#);
        for value in ticks(x, 8.0) {
            let (px, _) = at([value, y[0]]);
            line(svg, (px, top), (px, bottom), &pale);
            if last {
                text(svg, (px, bottom + 16.0), 11.0, "middle", GREY, &number(value));
            }
        }
        for value in ticks(y, 5.0) {
            let (_, py) = at([x[0], value]);
            line(svg, (LEFT, py), (RIGHT, py), &pale);
            text(svg, (LEFT - 8.0, py + 4.0), 11.0, "end", GREY, &number(value));
        }
        text(svg, (LEFT, top - 7.0), 12.0, "start", INK, &escape(&self.name));
        for (number, curve) in self.curves.iter().enumerate() {
            curve.draw(svg, &at);
            // The only curve of a panel has the panel's name.
            if curve.name.is_empty() {
                continue;
            }
            let beside = top + 12.0 + 17.0 * number as f64;
            let style = format!(r#"stroke="{}" stroke-width="2" stroke-dasharray="{}""#, curve.color, curve.dashes);
            line(svg, (RIGHT + 12.0, beside - 4.0), (RIGHT + 36.0, beside - 4.0), &style);
            text(svg, (RIGHT + 42.0, beside), 12.0, "start", INK, &escape(&curve.name));
        }
    }
}

impl Curve {
    fn draw(&self, svg: &mut String, at: &impl Fn([f64; 2]) -> (f64, f64)) {
        for piece in self.points.split(|p| !(p[0].is_finite() && p[1].is_finite())) {
            if piece.is_empty() {
                continue;
            }
            let points: Vec<String> = piece
                .iter()
                .map(|p| {
                    let (x, y) = at(*p);
                    format!("{x:.2},{y:.2}")
                })
                .collect();
            let _ = writeln!(
                svg,
                r#"<polyline points="{}" fill="none" stroke="{}" stroke-width="1.4" stroke-linejoin="round" stroke-dasharray="{}"/>"#,
                points.join(" "),
                self.color,
                self.dashes
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(points: Vec<[f64; 2]>) -> Chart {
        let curve = Curve { name: "a < b & c".into(), color: "#0072B2".into(), dashes: "none", points };
        Chart {
            title: "two".into(),
            x: "time [s]".into(),
            panels: vec![Panel { name: "x [mm]".into(), curves: vec![curve] }],
        }
    }

    #[test]
    fn a_break_in_a_curve_is_a_break_in_its_line() {
        let svg = chart(vec![[0.0, 0.0], [1.0, 1.0], [f64::NAN, 0.0], [2.0, 1.0], [3.0, 0.0]]).to_svg();
        assert_eq!(svg.matches("<polyline").count(), 2, "two pieces");
        assert!(svg.contains("a &lt; b &amp; c"), "names cannot break the document");
        assert!(!svg.contains("NaN"), "nothing that is no number");
    }

    #[test]
    fn nothing_and_constants_have_a_range_too() {
        for points in [vec![], vec![[1.0, 3.0]], vec![[0.0, 0.0], [1.0, 0.0]]] {
            let svg = chart(points.clone()).to_svg();
            assert!(svg.ends_with("</svg>\n") && !svg.contains("inf") && !svg.contains("NaN"), "{points:?}");
        }
    }

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(ticks([0.0, 10.0], 5.0), vec![0.0, 2.0, 4.0, 6.0, 8.0, 10.0], "every two");
    }
}
