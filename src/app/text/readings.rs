//! Words beside numbers that are read off a girder, a contact or a run.

use crate::codes::Demand;
use crate::geometry::End;
use crate::language::{Text, values};
use crate::sim::readings::{Limit, Passed};
use crate::sim::seats::verdict::Verdict;
use crate::sim::{Dropped, History, Overlap, TooDeep};

use super::{force, length, short};

// What follows from a girder's own numbers.
pub(in crate::app) const US_SKEW: Text = Text::new("us-skew");
pub(in crate::app) const CONDITION: Text = Text::new("condition");
pub(in crate::app) const OMEGAS: Text = Text::new("omegas");
pub(in crate::app) const FREQUENCIES: Text = Text::new("frequencies");
pub(in crate::app) const DAMPING_RATIOS: Text = Text::new("damping-ratios");
pub(in crate::app) const STIFFNESS_ECCENTRICITY: Text = Text::new("stiffness-eccentricity");
pub(in crate::app) const DAMPING_ECCENTRICITY: Text = Text::new("damping-eccentricity");
pub(in crate::app) const GYRATION: Text = Text::new("gyration");

/// Text on condition (6) of a girder with this rotation number.
pub(in crate::app) fn turns_or_not(number: f64) -> &'static str {
    if number >= 1.0 { Text::new("can-turn") } else { Text::new("cannot-turn") }.as_str()
}

// What a designer reads off a run for a girder.
pub(in crate::app) const TURNS: Text = Text::new("turns");
pub(in crate::app) const BEARINGS_MOVE: Text = Text::new("bearings-move");
pub(in crate::app) const BEARING_FORCE: Text = Text::new("bearing-force");
pub(in crate::app) const DRIFTS: [Text; 4] =
    [Text::new("drift-1"), Text::new("drift-2"), Text::new("drift-3"), Text::new("drift-4")];
pub(in crate::app) const NO_SEATS: Text = Text::new("no-seats");
pub(in crate::app) const GO_THERE: Text = Text::new("go-there");
pub(in crate::app) const CORNER_OFF: Text = Text::new("corner-off");
pub(in crate::app) const UNSEATS: Text = Text::new("unseats");
pub(in crate::app) const LEAST_GAP: Text = Text::new("least-gap");
pub(in crate::app) const PEAK_FORCE: Text = Text::new("peak-force");
pub(in crate::app) const PEAK_OF_CORNER: Text = Text::new("peak-of-corner");

/// The seat under an end.
pub(in crate::app) fn seat_at(end: End) -> &'static str {
    if end == End::Plus { Text::new("seat-plus") } else { Text::new("seat-minus") }.as_str()
}

/// Text on lengths required by a code, provided and used, square to the edge.
pub(in crate::app) fn demand(demand: &Demand) -> String {
    // In one unit: they are compared.
    let of = [demand.required, demand.provided, demand.used];
    let in_metres = of.iter().any(|length| length.abs() >= 1.0);
    let [needed, there, used] =
        of.map(|metres| if in_metres { format!("{} m", short(metres)) } else { format!("{} mm", short(1e3 * metres)) });
    let doubt = if demand.confirmed { "" } else { Text::new("from-memory").as_str() };
    let values = values![
        "needed" => needed,
        "there" => there,
        "used" => used,
        "verdict" => demand.verdict().as_str(),
        "doubt" => doubt
    ];
    Text::new("demand").with(&values)
}

/// Which corner a picture shows.
pub(in crate::app) fn orbit_corner(corner: usize) -> String {
    Text::new("orbit-corner").with(&values!["corner" => corner + 1])
}

/// Caption of the picture of a corner over its seat.
pub(in crate::app) fn orbit_of(corner: usize) -> String {
    Text::new("orbit-of").with(&values!["corner" => corner + 1])
}

/// A value and when it is reached.
pub(in crate::app) fn reached_at(words: &str, t: f64) -> String {
    Text::new("reached-at").with(&values!["value" => words, "t" => format!("{t:.3}")])
}

/// That bearings of a girder, by their numbers from 1, stand beyond the front edge of their seats as placed.
pub(in crate::app) fn off_seats(girder: &str, bearings: &[usize]) -> String {
    let bearings = bearings.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    Text::new("off-seats").with(&values!["girder" => girder, "bearings" => bearings])
}

/// A value that was reached after an end had come off its seat.
pub(in crate::app) fn reached_after(reached: &str) -> String {
    Text::new("reached-after").with(&values!["reached" => reached])
}

/// Which corner of a seat came off first, by its number in plan from 0, and when.
pub(in crate::app) fn corner_off_at(corner: usize, t: f64) -> String {
    Text::new("corner-off-at").with(&values!["corner" => corner + 1, "t" => format!("{t:.4}")])
}

/// A time.
pub(in crate::app) fn at_time(t: f64) -> String {
    Text::new("at-time").with(&values!["t" => format!("{t:.4}")])
}

/// Text on the remaining length of a seat, `least` with its time, and at the corners by their numbers in plan, square to the edge \[m\].
pub(in crate::app) fn seat_left(least: &str, seat: f64, corners: [(usize, f64); 2]) -> String {
    let corners = corners.map(|(number, left)| {
        Text::new("seat-left-corner").with(&values!["corner" => number + 1, "left" => length(left)])
    });
    let values = values!["least" => least, "seat" => length(seat), "corners" => corners.join(", ")];
    Text::new("seat-left").with(&values)
}

// A contact at the time shown.
pub(in crate::app) const GAP_OF_PAIR: Text = Text::new("gap-of-pair");
pub(in crate::app) const STATE: Text = Text::new("state");
pub(in crate::app) const NORMAL_SPRING: Text = Text::new("normal-spring");
pub(in crate::app) const TANGENTIAL_SPRING: Text = Text::new("tangential-spring");
pub(in crate::app) const FORCE_RATIO: Text = Text::new("force-ratio");
pub(in crate::app) const CONE_USED: Text = Text::new("cone-used");
pub(in crate::app) const DASHPOTS: Text = Text::new("dashpots");
pub(in crate::app) const WHOLE_FORCE: Text = Text::new("whole-force");
pub(in crate::app) const ELASTIC_FORCE: Text = Text::new("elastic-force");
pub(in crate::app) const OVERLAP: Text = Text::new("overlap");
pub(in crate::app) const ANCHOR_OFF: Text = Text::new("anchor-off");
pub(in crate::app) const CLOSING: Text = Text::new("closing");
pub(in crate::app) const SLIDING: Text = Text::new("sliding");

/// A ratio and the one that it may reach.
pub(in crate::app) fn one_of(used: &str, most: &str) -> String {
    Text::new("one-of").with(&values!["used" => used, "most" => most])
}

// Runs side by side.
pub(in crate::app) const MOVES: Text = Text::new("moves");
pub(in crate::app) const PEAK: Text = Text::new("peak");
pub(in crate::app) const HITS: Text = Text::new("hits");
pub(in crate::app) const LOST: Text = Text::new("lost");
pub(in crate::app) const LEAST_SEAT: Text = Text::new("least-seat");

/// A time in periods of the shaking.
pub(in crate::app) fn periods(count: f64) -> String {
    Text::new("periods").with(&values!["count" => format!("{count:.3}")])
}

/// Text on the run after an end has come off its seat.
pub(in crate::app) const GOES_ON: Text = Text::new("report-goes-on");
pub(in crate::app) const REACHED_AFTER_MEANS: Text = Text::new("reached-after-means");

/// That a girder does not stay on its seats, and when, in few words.
pub(in crate::app) fn falls(verdict: &Verdict) -> String {
    let text = match verdict {
        Verdict::Tipped { .. } => Text::new("falls-tips"),
        Verdict::SupportLost { .. } => Text::new("falls-support"),
        Verdict::Falls { .. } => Text::new("falls-down"),
        Verdict::Stays { .. } | Verdict::CornerOff { .. } | Verdict::Lost { .. } => Text::new("falls-seat"),
    };
    text.with(&values!["t" => format!("{:.2}", verdict.t())])
}

/// Which bodies are inside each other without contact, how deep at the most and when.
pub(in crate::app) fn overlap(history: &History, overlap: &Overlap) -> String {
    let [one, other] = overlap.bodies.map(|body| body.name(history.scene()));
    let values = values![
        "one" => one,
        "other" => other,
        "depth" => length(overlap.depth.value),
        "t" => format!("{:.4}", overlap.depth.t)
    ];
    Text::new("overlaps").with(&values)
}

/// Explanation of an overlap.
pub(in crate::app) const OVERLAP_MEANS: Text = Text::new("overlap-means");

/// Which contacts left the sense of their law, a line each.
pub(in crate::app) fn law_sense(history: &History, too_deep: &[TooDeep], dropped: Option<&Dropped>) -> Vec<String> {
    let name = |contact: usize| {
        let site = &history.model().sites[contact];
        (site.node_in_words(), &site.face_name)
    };
    let deep = too_deep.iter().map(|deep| {
        let (node, face) = name(deep.contact);
        let [depth, allowed] = [deep.depth.value, deep.allowed].map(length);
        let t = format!("{:.4}", deep.depth.t);
        let values =
            values!["node" => node, "face" => face.to_string(), "depth" => depth, "t" => t, "allowed" => allowed];
        Text::new("too-deep").with(&values)
    });
    let left = dropped.into_iter().map(|dropped| {
        let (node, face) = name(dropped.contact);
        let share = short(100.0 * dropped.share);
        let t = format!("{:.4}", dropped.t);
        Text::new("dropped").with(&values!["node" => node, "face" => face.to_string(), "t" => t, "share" => share])
    });
    deep.chain(left).collect()
}

/// Text on an exceeded limit: body, time and value.
pub(in crate::app) fn passed(flag: &Passed) -> String {
    let reached = match flag.limit {
        Limit::Rotation => Text::new("passed-turns").with(&values!["value" => short(flag.reached)]),
        Limit::Drift => Text::new("passed-drifts").with(&values!["value" => length(flag.reached)]),
        Limit::RemainingSeat => Text::new("passed-seat").with(&values!["value" => length(flag.reached)]),
        Limit::TotalForce => Text::new("passed-total").with(&values!["value" => force(flag.reached)]),
        Limit::BearingDisplacement | Limit::PierDrift => {
            Text::new("passed-moves").with(&values!["value" => length(flag.reached)])
        }
        Limit::Force => Text::new("passed-force").with(&values!["value" => force(flag.reached)]),
    };
    let t = format!("{:.4}", flag.t);
    Text::new("passed").with(&values!["whose" => flag.whose(), "reached" => reached, "t" => t])
}

// What a device does at the time shown.
pub(in crate::app) const DEVICE_FORCE: Text = Text::new("device-force");
pub(in crate::app) const DEVICE_DEFORMATION: Text = Text::new("device-deformation");
pub(in crate::app) const DEVICE_USE: Text = Text::new("device-use");
pub(in crate::app) const DEVICE_LEFT: Text = Text::new("device-left");

/// Part of a strength that a force is \[N\].
pub(in crate::app) fn used_of(part: f64, strength: f64) -> String {
    Text::new("used-of").with(&values!["part" => short(100.0 * part), "strength" => force(strength)])
}

/// A state of a device and when it begins \[s\].
pub(in crate::app) fn phase(from: f64, state: &str) -> String {
    format!("{from:.4} s  {state}")
}

/// Stands in the status line while the answer is of a coarse pass.
pub(in crate::app) const COARSE: Text = Text::new("coarse");
pub(in crate::app) const COARSE_MEANS: Text = Text::new("coarse-means");
/// Told instead of writing a file of a coarse pass.
pub(in crate::app) const STILL_COARSE: Text = Text::new("still-coarse");
/// Heads the verdicts on every girder.
pub(in crate::app) const VERDICTS: Text = Text::new("verdicts");

/// The largest force of a device, by its name.
pub(in crate::app) fn force_of(name: &str) -> String {
    Text::new("force-of-device").with(&values!["name" => name])
}
