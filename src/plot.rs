//! Log–log plots that draw themselves as SVG, and with feature `study` as PNG from the same SVG.
//!
//! Lines are named at their right end, in a margin of their own: a label never lies on a line. Colours are Okabe and
//! Ito's, told apart by every kind of colour vision; every series has its own marker as well.

pub mod chart;
pub(crate) mod color_map;
pub(crate) mod draw;
pub mod heat_map;
pub(crate) mod paper;
#[cfg(feature = "study")]
mod raster;

pub use color_map::Colors;

#[cfg(feature = "study")]
pub use raster::{RasterError, png};

/// A marker's shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    /// ●
    Circle,
    /// ■
    Square,
    /// ▲
    Triangle,
    /// ◆
    Diamond,
    /// ▼
    Down,
    /// ✕
    Cross,
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub struct Series {
    /// Text of its label.
    pub name: String,
    /// `#rrggbb`.
    pub color: &'static str,
    /// Shape of its points.
    pub marker: Marker,
    /// Whether it is the one to look at: drawn stronger.
    pub strong: bool,
    /// In the order they are joined in; both above 0.
    pub points: Vec<(f64, f64)>,
}

/// A single point with a name beside it, such as a figure of another program.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Its name.
    pub name: String,
    /// Where.
    pub at: (f64, f64),
    /// Whether it is a goal: drawn as a ring.
    pub goal: bool,
}

/// A slope to hold the lines against, drawn in the upper right corner.
#[derive(Clone, Debug)]
pub struct Guide {
    /// Its exponent: `y ∝ x^slope`.
    pub slope: f64,
    /// Its text.
    pub name: String,
}

/// How the numbers along an axis are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ticks {
    /// 10⁻⁶.
    Powers,
    /// 1 µs, 10 µs, 100 µs.
    Times,
    /// 1, 10, 100.
    Counts,
}

/// A log–log plot.
#[derive(Clone, Debug)]
pub struct Plot {
    /// Title, in a line.
    pub title: String,
    /// How to read it, in a line.
    pub subtitle: String,
    /// Name of the axis with its unit.
    pub x: (String, Ticks),
    /// Name of the axis with its unit.
    pub y: (String, Ticks),
    /// The lines.
    pub series: Vec<Series>,
    /// Single points.
    pub marks: Vec<Mark>,
    /// Slopes.
    pub guides: Vec<Guide>,
    /// A height below which nothing means anything, and why.
    pub floor: Option<(f64, String)>,
}

/// Okabe and Ito's blue, vermilion, green, orange, purple and sky blue.
pub const COLORS: [&str; 6] = ["#0072B2", "#D55E00", "#009E73", "#E69F00", "#CC79A7", "#56B4E9"];
