//! Words at the handles: what each is called, and what a drag says.

use crate::geometry::End;

pub(in crate::app) const ALONG: &str = "along";
pub(in crate::app) const ACROSS: &str = "across";
pub(in crate::app) const TURNED_TO: &str = "heading";
pub(in crate::app) const LONG: &str = "length";
pub(in crate::app) const WIDE: &str = "width";
pub(in crate::app) const SKEWED: &str = "β";
pub(in crate::app) const APART: &str = "gap as placed";
pub(in crate::app) const SIDEWAYS: &str = "sideways";
pub(in crate::app) const FACE_WIDE: &str = "face width";
pub(in crate::app) const SHIFT_X: &str = "Δx";
pub(in crate::app) const SHIFT_Y: &str = "Δy";

/// What a handle moves, and to where.
pub(in crate::app) fn move_by_handle(name: &str, way: &str) -> String {
    format!("move {name} {way}")
}

pub(in crate::app) fn turn_by_handle(name: &str) -> String {
    format!("turn {name}")
}

pub(in crate::app) fn length_handle(name: &str, end: End) -> String {
    format!("length of {name} at {}", end.label())
}

/// A corner, seen along the girder.
pub(in crate::app) fn skew_handle(name: &str, end: End, left: bool) -> String {
    format!("skew of {name} at {} {}", end.label(), if left { "left" } else { "right" })
}

pub(in crate::app) fn width_handle(name: &str) -> String {
    format!("width of {name}")
}

pub(in crate::app) fn face_width_handle(name: &str, left: bool) -> String {
    format!("width of {name}, {}", if left { "one side" } else { "other side" })
}

pub(in crate::app) fn gap_handle(pair: &str) -> String {
    format!("gap of {pair}")
}

/// What is dragged and the value it has come to.
pub(in crate::app) fn dragged(what: &str, value: &str) -> String {
    format!("{what} {value}")
}

/// The gap that the view shows, beside the one that is set.
pub(in crate::app) fn gap_now(gap: &str, t: f64) -> String {
    format!("gap {gap} at {t:.4} s")
}

pub(in crate::app) fn skewed_to(degrees: &str, end: End) -> String {
    format!("{SKEWED} {degrees}° at {}", end.label())
}

// What a drag has snapped to.
pub(in crate::app) fn on_axis_of(name: &str) -> String {
    format!("on the axis of {name}")
}

pub(in crate::app) fn gap_to(gap: &str, name: &str) -> String {
    format!("gap {gap} to {name}")
}

pub(in crate::app) fn parallel_to(name: &str) -> String {
    format!("parallel to {name}")
}

pub(in crate::app) fn ends_parallel_to(name: &str) -> String {
    format!("ends parallel to {name}")
}

pub(in crate::app) fn as_at(pair: &str) -> String {
    format!("as {pair}")
}

/// A point of a device.
pub(in crate::app) fn device_point(name: &str, which: usize) -> String {
    format!("{} point of {name}", if which == 0 { "first" } else { "second" })
}
