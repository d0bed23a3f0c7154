//! Words beside numbers that are read off a girder, a contact or a run.

use crate::codes::Demand;
use crate::geometry::End;
use crate::sim::readings::Passed;
use crate::sim::{Dropped, History, Overlap, TooDeep};

use super::{force, length, short};

// What follows from a girder's own numbers.
pub(in crate::app) const US_SKEW: &str = "US skew";
pub(in crate::app) const CONDITION: &str = "condition (6)";
pub(in crate::app) const OMEGAS: &str = "ω x y θ";
pub(in crate::app) const FREQUENCIES: &str = "f x y θ";
pub(in crate::app) const DAMPING_RATIOS: &str = "h x y θ";
pub(in crate::app) const STIFFNESS_ECCENTRICITY: &str = "ε x y";
pub(in crate::app) const DAMPING_ECCENTRICITY: &str = "η x y";
pub(in crate::app) const GYRATION: &str = "i (4e)";

/// What condition (6) says of a girder with this rotation number.
pub(in crate::app) fn turns_or_not(number: f64) -> &'static str {
    if number >= 1.0 { "≥ 1: can turn" } else { "< 1: cannot" }
}

// What a designer reads off a run for a girder.
pub(in crate::app) const TURNS: &str = "turns";
pub(in crate::app) const DRIFTS: [&str; 4] = ["drift 1", "drift 2", "drift 3", "drift 4"];
pub(in crate::app) const NO_SEATS: &str = "No seats are given: whether it stays on them is not judged.";
pub(in crate::app) const GO_THERE: &str = "Go to that moment and look there";
pub(in crate::app) const CORNER_OFF: &str = "corner off";
pub(in crate::app) const UNSEATS: &str = "end lost";
pub(in crate::app) const LEAST_GAP: &str = "least gap";
pub(in crate::app) const PEAK_FORCE: &str = "peak force";

/// The seat under an end.
pub(in crate::app) fn seat_at(end: End) -> &'static str {
    if end == End::Plus { "seat +x" } else { "seat -x" }
}

/// What a code requires, what there is, and what the run used, square to the edge.
pub(in crate::app) fn demand(demand: &Demand) -> String {
    let [needed, there, used] = [demand.required, demand.provided, demand.used].map(length);
    let verdict = if demand.is_met() { "long enough" } else { "too short" };
    let doubt = if demand.confirmed { "" } else { "; quoted from memory, not confirmed" };
    format!("needs {needed}, has {there}, used {used}: {verdict}{doubt}")
}

/// What the picture of a corner over its seat shows.
pub(in crate::app) fn orbit_of(corner: usize) -> String {
    format!(
        "Corner {} over its seat, to scale: red its front edge, the ring where least remains, the dot now; darker is later",
        corner + 1
    )
}

/// A value and when it is reached.
pub(in crate::app) fn reached_at(words: &str, t: f64) -> String {
    format!("{words} at {t:.3} s")
}

/// A time.
pub(in crate::app) fn at_time(t: f64) -> String {
    format!("at {t:.4} s")
}

/// What is left of a seat, `least` with its time, and at the corners, square to the edge \[m\].
pub(in crate::app) fn seat_left(least: &str, seat: f64, corners: [f64; 2]) -> String {
    format!("{least} left of {}; at the corners {}", length(seat), corners.map(length).join(", "))
}

// A contact at the time shown.
pub(in crate::app) const GAP_OF_PAIR: &str = "gap of pair";
pub(in crate::app) const STATE: &str = "state";
pub(in crate::app) const NORMAL_SPRING: &str = "normal K δ";
pub(in crate::app) const TANGENTIAL_SPRING: &str = "tangential";
pub(in crate::app) const FORCE_RATIO: &str = "T / N";
pub(in crate::app) const CONE_USED: &str = "cone used";
pub(in crate::app) const DASHPOTS: &str = "dashpots";
pub(in crate::app) const WHOLE_FORCE: &str = "force |R|";
pub(in crate::app) const ELASTIC_FORCE: &str = "without dashpots";
pub(in crate::app) const OVERLAP: &str = "overlap δ";
pub(in crate::app) const ANCHOR_OFF: &str = "anchor off";
pub(in crate::app) const CLOSING: &str = "closing";
pub(in crate::app) const SLIDING: &str = "sliding";

/// A ratio and the one that it may reach.
pub(in crate::app) fn one_of(used: &str, most: &str) -> String {
    format!("{used} of {most}")
}

// Runs side by side.
pub(in crate::app) const MOVES: &str = "moves";
pub(in crate::app) const PEAK: &str = "peak";
pub(in crate::app) const HITS: &str = "hits";
pub(in crate::app) const LOST: &str = "lost";

/// A time in periods of the shaking.
pub(in crate::app) fn periods(count: f64) -> String {
    format!("{count:.3} periods")
}

/// Which bodies are inside each other without contact, how deep at the most and when.
pub(in crate::app) fn overlap(history: &History, overlap: &Overlap) -> String {
    let [one, other] = overlap.bodies.map(|body| body.name(history.scene()));
    format!("{one} and {other} overlap by {} at {:.4} s, no contact", length(overlap.depth.value), overlap.depth.t)
}

/// What an overlap means.
pub(in crate::app) const OVERLAP_MEANS: &str =
    "These bodies pass through each other: no contact is defined where they meet. A click goes to where it begins.";

/// Which contacts left the sense of their law, a line each.
pub(in crate::app) fn law_sense(history: &History, too_deep: &[TooDeep], dropped: Option<&Dropped>) -> Vec<String> {
    let name = |contact: usize| {
        let site = &history.model().contacts[contact];
        (site.node.as_str(), &site.face_name)
    };
    let deep = too_deep.iter().map(|deep| {
        let (node, face) = name(deep.contact);
        let [depth, allowed] = [deep.depth.value, deep.allowed].map(length);
        format!(
            "{node} in {face}: {depth} at {:.4} s, more than a tenth of the shortest side ({allowed})",
            deep.depth.t
        )
    });
    let left = dropped.into_iter().map(|dropped| {
        let (node, face) = name(dropped.contact);
        let share = short(100.0 * dropped.share);
        format!("{node} left {face} over its edge at {:.4} s; springs held {share} % of the largest energy", dropped.t)
    });
    deep.chain(left).collect()
}

/// What was passed, by whom, when and how far.
pub(in crate::app) fn passed(flag: &Passed) -> String {
    let reached = match flag.limit {
        "rotation_deg" => format!("turns by {}°", short(flag.reached)),
        "drift_m" => format!("drifts by {}", length(flag.reached)),
        "remaining_seat_m" => format!("keeps {} of its seat", length(flag.reached)),
        _ => format!("reaches {}", force(flag.reached)),
    };
    format!("{} {reached}; limit passed at {:.4} s", flag.whose, flag.t)
}

// What a device does at the time shown.
pub(in crate::app) const DEVICE_FORCE: &str = "force";
pub(in crate::app) const DEVICE_DEFORMATION: &str = "deformation";
pub(in crate::app) const DEVICE_USE: &str = "used";
pub(in crate::app) const DEVICE_LEFT: &str = "until it acts";

/// Part of a strength that a force is \[N\].
pub(in crate::app) fn used_of(part: f64, strength: f64) -> String {
    format!("{} % of {}", short(100.0 * part), force(strength))
}

/// A state of a device and when it begins \[s\].
pub(in crate::app) fn phase(from: f64, state: &str) -> String {
    format!("{from:.4} s  {state}")
}

/// Stands in the status line while the answer is of a coarse pass.
pub(in crate::app) const COARSE: &str = "coarse, the full run follows";
pub(in crate::app) const COARSE_MEANS: &str =
    "Computed at a tolerance of 1e-4 so that it is seen soon; limits, verdicts, pins and files wait for the full run";
/// Told instead of writing a file of a coarse pass.
pub(in crate::app) const STILL_COARSE: &str =
    "The run is not computed in full yet: nothing was written; ask again when it is";
/// Heads the verdicts on every girder.
pub(in crate::app) const VERDICTS: &str = "On its seats?";
