//! Identification as charts and tables: measured against fitted, and residuals.

use std::fmt::Write as _;

use crate::identify::{Identified, Measured, Quantity};
use crate::plot::COLORS;
use crate::plot::chart::{Chart, Curve, Panel};
use crate::plot::paper::{BEHIND, INK};

/// Measured points are drawn as crosses up to so many, else joined.
const MOST_CROSSES: usize = 200;
/// Half the width of a cross, as a share of the axes' lengths; the field is three times as wide as high.
const CROSS: [f64; 2] = [0.006, 0.022];
/// Points of a fitted curve at most: finer than the picture.
const MOST_POINTS: usize = 4000;

/// Measured and fitted, and their difference, as an SVG document.
pub fn chart(measured: &Measured, found: &Identified, first: Quantity, title: &str) -> String {
    let mm = |values: &[f64]| -> Vec<[f64; 2]> {
        let every = values.len().div_ceil(MOST_POINTS);
        measured.at.iter().zip(values).step_by(every).map(|(t, x)| [*t, 1e3 * x]).collect()
    };
    let curve = |name: &str, (color, dashes): (&str, &'static str), points| Curve {
        name: name.to_owned(),
        color: color.to_owned(),
        dashes,
        points,
    };
    let few = measured.x.len() <= MOST_CROSSES;
    let (name, x) = match first {
        Quantity::Time => ("displacement [mm]", "time [s]"),
        Quantity::Frequency => ("amplitude [mm]", "frequency [Hz]"),
    };
    // Crosses lie over the line of the fit; measured points that are joined lie under its dashes.
    let fitted = curve("least squares", (COLORS[0], if few { "none" } else { "7 4" }), mm(&found.fitted));
    let points = curve("measured", (if few { INK } else { BEHIND }, "none"), crossed(mm(&measured.x)));
    let residual = curve("residual", (COLORS[1], "none"), mm(&found.residuals));
    let panels = vec![
        Panel { name: name.to_owned(), curves: if few { vec![fitted, points] } else { vec![points, fitted] } },
        Panel { name: "measured − least squares [mm]".to_owned(), curves: vec![residual] },
    ];
    Chart { title: title.to_owned(), x: x.to_owned(), panels }.to_svg()
}

/// A few points as crosses, with breaks between them; many as they are.
pub(super) fn crossed(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    if points.len() > MOST_CROSSES {
        return points;
    }
    let extent = |axis: usize| {
        let values = || points.iter().map(|p| p[axis]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    let [dx, dy] = [0, 1].map(|axis| CROSS[axis] * extent(axis));
    let apart = [f64::NAN; 2];
    let cross = |[x, y]: [f64; 2]| [[x - dx, y], [x + dx, y], apart, [x, y - dy], [x, y + dy], apart];
    points.into_iter().flat_map(cross).collect()
}

/// Every row: `t_s,measured_m,fitted_m,residual_m`, or `f_hz` in place of `t_s`.
pub fn csv(measured: &Measured, found: &Identified, first: Quantity) -> String {
    let at = match first {
        Quantity::Time => "t_s",
        Quantity::Frequency => "f_hz",
    };
    let mut table = format!("{at},measured_m,fitted_m,residual_m\n");
    for (((at, x), fitted), left) in measured.at.iter().zip(&measured.x).zip(&found.fitted).zip(&found.residuals) {
        let _ = writeln!(table, "{at},{x},{fitted},{left}");
    }
    table
}
