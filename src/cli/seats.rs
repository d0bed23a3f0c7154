//! Seats in the summary of a run: what remained, when a corner came off, and what design codes require.

use super::columns::{left, right};
use crate::codes::{RotationCondition, Source};
use crate::language::{Text, said};
use crate::scene::shown::escaped;
use crate::tables::{CornerReport, DemandReport, SeatReport, corner_angle};

/// Last digit of a distance in millimetres, as it is said \[m\].
const LAST_DIGIT: f64 = 1e-6;

/// Remaining length of a seat, square to its edge, and a line for each corner that came off.
pub(super) fn lines(seat: &SeatReport) -> Vec<(String, String)> {
    let name = said!("run-seat", "girder" => escaped(&seat.girder), "end" => seat.end);
    let off = seat.corners.iter().flat_map(|corner| departures(seat, corner));
    let lost = seat.lost_at.map(|t| said!("run-seat-lost", "t" => format!("{t:.4}")));
    let words = std::iter::once(remaining(seat)).chain(off).chain(lost);
    words.map(|words| (name.clone(), words)).collect()
}

fn remaining(seat: &SeatReport) -> String {
    let [placed, least, used] = [seat.placed, seat.least_remaining, seat.used].map(|metres| metres * 1e3);
    let along = if seat.placed == seat.length {
        String::new()
    } else {
        said!("run-seat-along", "length" => format!("{:.3}", seat.length * 1e3))
    };
    said!(
        "run-seat-of",
        "placed" => format!("{placed:.3}"),
        "along" => along,
        "least" => format!("{least:.3}"),
        "corner" => worse(seat).map_or_else(String::new, |corner| said!("run-seat-at", "which" => name(corner))),
        "used" => format!("{used:.3}"),
        "t" => format!("{:.4}", seat.t)
    )
}

/// The corner at which less remained; nothing where both differ by less than the last digit said.
fn worse(seat: &SeatReport) -> Option<&CornerReport> {
    let [one, other] = &seat.corners;
    let less = if one.least_remaining < other.least_remaining { one } else { other };
    ((one.least_remaining - other.least_remaining).abs() >= LAST_DIGIT).then_some(less)
}

/// A corner by its number and angle.
fn name(corner: &CornerReport) -> String {
    said!("run-corner", "corner" => corner.corner, "angle" => corner_angle(corner.angle))
}

/// When a corner came off, over the front edge and over a side.
fn departures(seat: &SeatReport, corner: &CornerReport) -> Vec<String> {
    let which = name(corner);
    let front = corner.left_at.map(|t| {
        let share = 100.0 * seat.least_share;
        let at = corner.left_along.unwrap_or(0.0);
        said!(
            "run-corner-off",
            "which" => which.as_str(),
            "t" => format!("{t:.4}"),
            "at" => format!("{at:.3}"),
            "share" => format!("{share:.0}")
        )
    });
    let side =
        corner.left_side_at.map(|t| said!("run-corner-side", "which" => which.as_str(), "t" => format!("{t:.4}")));
    front.into_iter().chain(side).collect()
}

/// The table of what codes require of every seat, what there is and what the run used; nothing without seats.
pub(super) fn table(seats: &[SeatReport]) -> String {
    if seats.is_empty() {
        return String::new();
    }
    let head = format!(
        "  {} {} {} {}\n",
        left(&Text::new("run-seats-head"), 41),
        right(&Text::new("run-needed"), 8),
        right(&Text::new("run-there"), 8),
        right(&Text::new("run-used"), 8)
    );
    let of_seat = |seat: &SeatReport| {
        let name = format!("  {}{}\n", escaped(&seat.girder), seat.end);
        std::iter::once(name).chain(seat.codes.iter().map(row)).chain(turning(seat)).collect::<String>()
    };
    let legend = format!("  {}\n", Text::new("run-seats-legend"));
    let of_girder = |ends: &[SeatReport]| {
        let skewed = ends.first().filter(|seat| seat.rotation_condition != 0.0);
        let condition = skewed.map(|seat| {
            let condition = RotationCondition { number: seat.rotation_condition };
            format!("  {}: {}\n", escaped(&seat.girder), condition.words())
        });
        ends.iter().map(of_seat).chain(condition).collect::<String>()
    };
    let girders = seats.chunk_by(|one, other| one.girder == other.girder).map(of_girder);
    std::iter::once(head).chain(girders).chain([legend]).collect()
}

/// By how much the deck has to turn to come off a skewed seat.
fn turning(seat: &SeatReport) -> Option<String> {
    let [one, other] = &seat.corners;
    let angles = one.zero_rotation_deg.zip(other.zero_rotation_deg).zip(seat.middle_zero_rotation_deg);
    let ((first, second), middle) = angles.filter(|_| seat.rotation_condition != 0.0)?;
    Some(format!(
        "    {}\n",
        said!(
            "run-seats-turned",
            "one" => corner_angle(one.angle),
            "first" => format!("{first:.2}"),
            "other" => corner_angle(other.angle),
            "second" => format!("{second:.2}"),
            "middle" => format!("{middle:.2}")
        )
    ))
}

fn row(DemandReport { demand, .. }: &DemandReport) -> String {
    let assumed = demand.inputs.iter().any(|input| input.source == Source::Assumed);
    let marks =
        [(!demand.confirmed, "*"), (assumed, "°")].map(|(marked, mark)| if marked { mark } else { "" }).concat();
    let [needed, there, used] = [demand.required, demand.provided, demand.used].map(|metres| 1e3 * metres);
    let verdict = if demand.holds() { String::new() } else { format!("  {}", demand.verdict()) };
    let rule = left(&format!("{} {marks}", demand.rule), 39);
    format!("    {rule} {needed:>8.1} {there:>8.1} {used:>8.1}{verdict}\n")
}
