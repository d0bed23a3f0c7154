//! A quantity over two others as colours, as an SVG document: panels side by side over one colour bar.

use std::fmt::Write as _;

use super::chart::{number, range, ticks};
use super::color_map::{Colors, LEVELS, level};
use super::draw::{escape, line, text};
use super::paper::{EMPTY, GREY, INK, WHITE};

/// Side of a panel's field.
const FIELD: f64 = 330.0;
/// From the left edge of a panel's field to that of the next.
const PANEL: f64 = FIELD + 22.0;
const LEFT: f64 = 78.0;
const TOP: f64 = 84.0;
/// Room for the colour bar.
const BAR: f64 = 118.0;
const BELOW: f64 = 78.0;
/// Ticks along an axis that are labelled, about.
const LABELS: usize = 7;

/// An axis in even steps, one a cell.
#[derive(Clone, Debug)]
pub struct Steps {
    /// Its name with its unit.
    pub name: String,
    /// The value of each cell.
    pub values: Vec<f64>,
    /// Where the scene itself is, in cells from the middle of the first; none outside.
    pub mark: Option<f64>,
}

/// A field of cells.
#[derive(Clone, Debug)]
pub struct Map {
    /// Its distinction from the other maps.
    pub name: String,
    /// Its values, the rows of the level axis one upon the other; none where there is none.
    pub values: Vec<Option<f64>>,
}

/// Fields over the same axes.
#[derive(Clone, Debug)]
pub struct HeatMap {
    /// Title, in a line.
    pub title: String,
    /// Of what, in a line.
    pub subtitle: String,
    /// The level axis.
    pub x: Steps,
    /// The upright one.
    pub y: Steps,
    /// Name of the colour bar with its unit.
    pub bar: String,
    /// Scale of colours.
    pub colors: Colors,
    /// From left to right.
    pub maps: Vec<Map>,
}

impl HeatMap {
    /// The document.
    pub fn to_svg(&self) -> String {
        let count = self.maps.len().max(1) as f64;
        let (width, height) = (LEFT + PANEL * count + BAR, TOP + FIELD + BELOW);
        let mut svg = String::new();
        let _ = writeln!(
            svg,
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" font-family="sans-serif">"#
        );
        let _ = writeln!(svg, r#"<rect width="{width}" height="{height}" fill="{WHITE}"/>"#);
        text(&mut svg, (LEFT, 28.0), 17.0, "start", INK, &escape(&self.title));
        text(&mut svg, (LEFT, 48.0), 12.0, "start", GREY, &escape(&self.subtitle));
        let colors = self.colors.range(range(self.maps.iter().flat_map(|map| &map.values).flatten().copied()));
        for (number, map) in self.maps.iter().enumerate() {
            self.draw(&mut svg, map, LEFT + PANEL * number as f64, colors);
        }
        self.draw_upright_axis(&mut svg);
        self.draw_bar(&mut svg, LEFT + PANEL * count, colors);
        svg.push_str("</svg>\n");
        svg
    }

    /// Width and height of a cell.
    fn cell(&self) -> [f64; 2] {
        [&self.x, &self.y].map(|axis| FIELD / axis.values.len().max(1) as f64)
    }

    fn draw(&self, svg: &mut String, map: &Map, left: f64, colors: [f64; 2]) {
        let [width, height] = self.cell();
        text(svg, (left, TOP - 8.0), 12.0, "start", INK, &escape(&map.name));
        let _ = writeln!(svg, r#"<rect x="{left}" y="{TOP}" width="{FIELD}" height="{FIELD}" fill="{EMPTY}"/>"#);
        // Cells of one colour are one path, one unit a cell, the first row at the bottom.
        let _ = writeln!(
            svg,
            r#"<g transform="translate({left} {}) scale({width:.6} {:.6})" shape-rendering="crispEdges">"#,
            TOP + FIELD,
            -height
        );
        for (color, path) in self.paths(map, colors) {
            let _ = writeln!(svg, r#"<path fill="{color}" d="{path}"/>"#);
        }
        svg.push_str("</g>\n");
        self.draw_mark(svg, left);
        for index in labelled(self.x.values.len()) {
            let x = left + width * (index as f64 + 0.5);
            line(svg, (x, TOP + FIELD), (x, TOP + FIELD + 4.0), &format!(r#"stroke="{GREY}""#));
            text(svg, (x, TOP + FIELD + 18.0), 11.0, "middle", GREY, &step(self.x.values[index]));
        }
        text(svg, (left + 0.5 * FIELD, TOP + FIELD + 38.0), 12.0, "middle", INK, &escape(&self.x.name));
    }

    /// Colours of the cells, and where they are.
    fn paths(&self, map: &Map, colors: [f64; 2]) -> Vec<(String, String)> {
        let mut paths = vec![String::new(); usize::from(LEVELS) + 1];
        for (cell, value) in map.values.iter().enumerate() {
            if let Some(value) = value {
                let (x, y) = (cell % self.x.values.len(), cell / self.x.values.len());
                let _ = write!(paths[usize::from(level(*value, colors))], "M{x} {y}h1v1h-1z");
            }
        }
        let used = (0..=LEVELS).zip(paths).filter(|(_, path)| !path.is_empty());
        used.map(|(level, path)| (self.colors.hex(level), path)).collect()
    }

    /// A ring where the scene itself is.
    fn draw_mark(&self, svg: &mut String, left: f64) {
        if let (Some(x), Some(y)) = (self.x.mark, self.y.mark) {
            let [width, height] = self.cell();
            ring(svg, (left + width * (x + 0.5), TOP + FIELD - height * (y + 0.5)));
        }
    }

    fn draw_upright_axis(&self, svg: &mut String) {
        let [_, height] = self.cell();
        for index in labelled(self.y.values.len()) {
            let y = TOP + FIELD - height * (index as f64 + 0.5);
            line(svg, (LEFT - 4.0, y), (LEFT, y), &format!(r#"stroke="{GREY}""#));
            text(svg, (LEFT - 8.0, y + 4.0), 11.0, "end", GREY, &step(self.y.values[index]));
        }
        let (x, y) = (18.0, TOP + 0.5 * FIELD);
        let _ = writeln!(
            svg,
            r#"<text x="{x}" y="{y}" font-size="12" text-anchor="middle" fill="{INK}" transform="rotate(-90 {x} {y})">{}</text>"#,
            escape(&self.y.name)
        );
    }

    fn draw_bar(&self, svg: &mut String, left: f64, colors: [f64; 2]) {
        let [low, high] = colors;
        let part = FIELD / (f64::from(LEVELS) + 1.0);
        for level in 0..=LEVELS {
            let y = TOP + FIELD - part * (f64::from(level) + 1.0);
            let _ = writeln!(
                svg,
                r#"<rect x="{left}" y="{y:.2}" width="16" height="{:.2}" fill="{}" shape-rendering="crispEdges"/>"#,
                part + 0.3,
                self.colors.hex(level)
            );
        }
        for value in ticks(colors, 6.0) {
            let y = TOP + FIELD * (1.0 - (value - low) / (high - low));
            line(svg, (left + 16.0, y), (left + 20.0, y), &format!(r#"stroke="{GREY}""#));
            text(svg, (left + 24.0, y + 4.0), 11.0, "start", GREY, &number(value));
        }
        text(svg, (left + BAR - 8.0, TOP - 8.0), 12.0, "end", INK, &escape(&self.bar));
        let mut y = TOP + FIELD + 18.0;
        if self.x.mark.and(self.y.mark).is_some() {
            ring(svg, (left + 8.0, y - 4.0));
            text(svg, (left + 24.0, y), 11.0, "start", GREY, "the scene");
            y += 20.0;
        }
        if self.maps.iter().any(|map| map.values.contains(&None)) {
            let _ =
                writeln!(svg, r#"<rect x="{}" y="{}" width="12" height="12" fill="{EMPTY}"/>"#, left + 2.0, y - 10.0);
            text(svg, (left + 24.0, y), 11.0, "start", GREY, "no value");
        }
    }
}

/// A ring that is seen on every colour.
fn ring(svg: &mut String, (x, y): (f64, f64)) {
    for (color, width) in [(WHITE, 4.0), (INK, 1.6)] {
        let _ = writeln!(
            svg,
            r#"<circle cx="{x:.1}" cy="{y:.1}" r="6" fill="none" stroke="{color}" stroke-width="{width}"/>"#
        );
    }
}

/// A step's number, to five digits: steps of equal ratios have no round ones.
fn step(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return number(value);
    }
    let unit = 10_f64.powf(value.abs().log10().floor() - 4.0);
    number((value / unit).round() * unit)
}

/// Which of so many steps are labelled: evenly spaced, the last one among them where a spacing fits.
fn labelled(count: usize) -> impl Iterator<Item = usize> {
    let last = count.saturating_sub(1);
    let least = last.div_ceil(LABELS).max(1);
    let fits = (least..=2 * least).find(|&spacing| last.is_multiple_of(spacing));
    (0..count).step_by(fits.unwrap_or(least))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(columns: usize, rows: usize, values: Vec<Option<f64>>) -> HeatMap {
        let steps =
            |count: usize, mark| Steps { name: "a < b".into(), values: (0..count).map(|i| i as f64).collect(), mark };
        HeatMap {
            title: "two".into(),
            subtitle: String::new(),
            x: steps(columns, Some(0.5)),
            y: steps(rows, Some(0.0)),
            bar: "x [mm]".into(),
            colors: Colors::Even,
            maps: vec![Map { name: "one".into(), values }],
        }
    }

    #[test]
    fn every_value_is_a_cell_of_its_colour() {
        let svg = map(2, 2, vec![Some(0.0), Some(1.0), None, Some(1.0)]).to_svg();
        assert!(svg.contains(r##"fill="#440154" d="M0 0h1v1h-1z""##), "the lowest: {svg}");
        assert!(svg.contains(r##"fill="#fde725" d="M1 0h1v1h-1zM1 1h1v1h-1z""##), "the highest: {svg}");
        assert!(svg.contains("no value") && svg.contains("the scene"), "what else is seen is explained");
        assert!(svg.contains("a &lt; b"), "names cannot break the document");
    }

    #[test]
    fn steps_have_no_more_digits_than_there_is_room_for() {
        let said = [31_622.776_601, 316_227.766_01, 0.012_345_678, 0.0, 45.5].map(step);
        assert_eq!(said, ["31623", "316230", "0.0123", "0", "45.5"], "as round as they are");
    }

    #[test]
    fn nothing_and_constants_are_drawn_too() {
        for values in [vec![], vec![None; 4], vec![Some(3.0); 4], vec![Some(0.0); 4]] {
            let svg = map(2, 2, values).to_svg();
            assert!(svg.ends_with("</svg>\n") && !svg.contains("inf") && !svg.contains("NaN"), "{svg}");
        }
        assert!(map(0, 0, vec![]).to_svg().ends_with("</svg>\n"), "no axis at all");
    }

    #[test]
    fn labels_are_even_and_few() {
        let of = |count| labelled(count).collect::<Vec<_>>();
        assert_eq!(of(61), [0, 10, 20, 30, 40, 50, 60], "every tenth");
        assert_eq!(of(3), [0, 1, 2], "each");
        assert_eq!(of(0), [0; 0], "none");
        assert!((1..500).all(|count| (1..=9).contains(&of(count).len())), "few");
    }
}
