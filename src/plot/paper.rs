//! Colours of what is drawn on white: charts, plans, orbits. A line and the words on it have one colour.

/// The ground.
pub(crate) const WHITE: &str = "#ffffff";
/// Lines and words.
pub(crate) const INK: &str = "#222222";
/// Words of second rank, outlines of what carries.
pub(crate) const GREY: &str = "#6b6b6b";
/// A curve behind another.
pub(crate) const BEHIND: &str = "#b0b0b0";
/// Fields without a value, lines of a grid on a tint.
pub(crate) const EMPTY: &str = "#d0d0d0";
/// Lines of a grid on white.
pub(crate) const PALE: &str = "#e4e4e4";
/// A deck seen from above.
pub(crate) const DECK: &str = "#e9e3d6";
/// Where a deck was placed.
pub(crate) const PLACED: &str = "#9aa0a6";
/// The edge of a seat, and what is beyond it.
pub(crate) const EDGE: &str = "#a83f00";
