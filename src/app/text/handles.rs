//! Words at the handles: what each is called, and what a drag says.

use crate::geometry::End;
use crate::language::{Text, said, values};

pub(in crate::app) const ALONG: Text = Text::new("along");
pub(in crate::app) const ACROSS: Text = Text::new("across");
pub(in crate::app) const TURNED_TO: Text = Text::new("turned-to");
pub(in crate::app) const LONG: Text = Text::new("long");
pub(in crate::app) const WIDE: Text = Text::new("wide");
pub(in crate::app) const SKEWED: &str = "β";
pub(in crate::app) const APART: Text = Text::new("apart");
pub(in crate::app) const SIDEWAYS: Text = Text::new("sideways");
pub(in crate::app) const FACE_WIDE: Text = Text::new("face-wide");
pub(in crate::app) const HIGH: Text = Text::new("high");
pub(in crate::app) const COLUMN: Text = Text::new("column-size");
pub(in crate::app) const SHIFT_X: &str = "Δx";
pub(in crate::app) const SHIFT_Y: &str = "Δy";

/// Text on a handle: its object and direction.
pub(in crate::app) fn move_by_handle(name: &str, way: &str) -> String {
    Text::new("move-by-handle").with(&values!["name" => name, "way" => way])
}

pub(in crate::app) fn turn_by_handle(name: &str) -> String {
    Text::new("turn-by-handle").with(&values!["name" => name])
}

pub(in crate::app) fn length_handle(name: &str, end: End) -> String {
    Text::new("length-handle").with(&values!["name" => name, "end" => end.label()])
}

/// A corner, seen along the girder.
pub(in crate::app) fn skew_handle(name: &str, end: End, left: bool) -> String {
    let side = if left { Text::new("left") } else { Text::new("right") };
    Text::new("skew-handle").with(&values!["name" => name, "end" => end.label(), "side" => side.as_str()])
}

pub(in crate::app) fn width_handle(name: &str) -> String {
    Text::new("width-handle").with(&values!["name" => name])
}

pub(in crate::app) fn face_width_handle(name: &str, left: bool) -> String {
    let side = if left { Text::new("one-side") } else { Text::new("other-side") };
    Text::new("face-width-handle").with(&values!["name" => name, "side" => side.as_str()])
}

pub(in crate::app) fn gap_handle(pair: &str) -> String {
    Text::new("gap-handle").with(&values!["pair" => pair])
}

/// Text on the dragged quantity and its value.
pub(in crate::app) fn dragged(what: &str, value: &str) -> String {
    Text::new("dragged").with(&values!["what" => what, "value" => value])
}

/// The gap that the view shows, beside the one that is set.
pub(in crate::app) fn gap_now(gap: &str, t: f64) -> String {
    Text::new("gap-now").with(&values!["gap" => gap, "t" => format!("{t:.4}")])
}

pub(in crate::app) fn skewed_to(degrees: &str, end: End) -> String {
    Text::new("skewed-to").with(&values!["degrees" => degrees, "end" => end.label()])
}

// What a drag has snapped to.
pub(in crate::app) fn on_axis_of(name: &str) -> String {
    Text::new("on-axis-of").with(&values!["name" => name])
}

pub(in crate::app) fn gap_to(gap: &str, name: &str) -> String {
    Text::new("gap-to").with(&values!["gap" => gap, "name" => name])
}

pub(in crate::app) fn parallel_to(name: &str) -> String {
    Text::new("parallel-to").with(&values!["name" => name])
}

pub(in crate::app) fn ends_parallel_to(name: &str) -> String {
    Text::new("ends-parallel-to").with(&values!["name" => name])
}

pub(in crate::app) fn as_at(pair: &str) -> String {
    Text::new("as-at").with(&values!["pair" => pair])
}

pub(in crate::app) fn pier_height_handle(name: &str) -> String {
    Text::new("pier-height-handle").with(&values!["name" => name])
}

pub(in crate::app) fn pier_column_handle(name: &str) -> String {
    Text::new("pier-column-handle").with(&values!["name" => name])
}

/// Stiffness of a pier along and across \[N/m\].
pub(in crate::app) fn pier_stiffness(stiffness: [f64; 2]) -> String {
    let [along, across] = stiffness.map(|k| format!("{k:.3e}"));
    Text::new("pier-stiffness").with(&values!["along" => along, "across" => across])
}

/// A point of a device.
pub(in crate::app) fn device_point(name: &str, which: usize) -> String {
    let key = if which == 0 { "first-point" } else { "second-point" };
    Text::new(key).with(&values!["name" => name])
}

/// Beside the mouse: a new abutment, and the end of the girder that it is placed before.
pub(in crate::app) fn abutment_before(name: &str, girder: &str, end: &str) -> String {
    said!("tool-abutment-before", "name" => name, "girder" => girder, "end" => end)
}
