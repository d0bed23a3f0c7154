//! Seats in the summary of a run: what remained, when a corner came off, and what design codes require.

use crate::codes::{RotationCondition, Source};
use crate::scene::shown::escaped;
use crate::tables::{CornerReport, DemandReport, SeatReport};

/// What remained of a seat, square to its edge, and a line for each corner that came off.
pub(super) fn lines(seat: &SeatReport) -> Vec<(String, String)> {
    let name = format!("seat {}{}", escaped(&seat.girder), seat.end);
    let off = seat.corners.iter().flat_map(|corner| departures(seat, corner));
    let lost = seat.lost_at.map(|t| format!("the whole end is off from {t:.4} s"));
    let words = std::iter::once(remaining(seat)).chain(off).chain(lost);
    words.map(|words| (name.clone(), words)).collect()
}

fn remaining(seat: &SeatReport) -> String {
    let [placed, least, used] = [seat.placed, seat.least_remaining, seat.used].map(|metres| metres * 1e3);
    let along =
        if seat.placed == seat.length { String::new() } else { format!(" ({:.3} along the axis)", seat.length * 1e3) };
    format!("placed {placed:.3} mm{along}, least {least:.3}, used {used:.3}, at {:.4} s", seat.t)
}

/// When a corner came off, over the front edge and over a side.
fn departures(seat: &SeatReport, corner: &CornerReport) -> Vec<String> {
    let which = format!("corner {} ({})", corner.corner, corner.angle);
    let front = corner.left_at.map(|t| {
        let share = 100.0 * seat.least_share;
        let at = corner.left_along.unwrap_or(0.0);
        format!(
            "{which} comes off at {t:.4} s, {at:.3} m along the edge; {share:.0} % of the end stay seated at the least"
        )
    });
    let side = corner.left_side_at.map(|t| format!("{which} leaves the seat over its side at {t:.4} s"));
    front.into_iter().chain(side).collect()
}

/// The table of what codes require of every seat, what there is and what the run used; nothing without seats.
pub(super) fn table(seats: &[SeatReport]) -> String {
    if seats.is_empty() {
        return String::new();
    }
    let head = format!("  {:<41} {:>8} {:>8} {:>8}\n", "seats, square to the edge [mm]", "needed", "there", "used");
    let of_seat = |seat: &SeatReport| {
        let name = format!("  {}{}\n", escaped(&seat.girder), seat.end);
        std::iter::once(name).chain(seat.codes.iter().map(row)).chain(turning(seat)).collect::<String>()
    };
    let legend =
        "  * quoted from memory, not confirmed in that edition; ° with assumed inputs, see `codes` of summary.json\n";
    let of_girder = |ends: &[SeatReport]| {
        let skewed = ends.first().filter(|seat| seat.rotation_condition != 0.0);
        let condition = skewed.map(|seat| {
            let condition = RotationCondition { number: seat.rotation_condition };
            format!("  {}: {}\n", escaped(&seat.girder), condition.words())
        });
        ends.iter().map(of_seat).chain(condition).collect::<String>()
    };
    let girders = seats.chunk_by(|one, other| one.girder == other.girder).map(of_girder);
    std::iter::once(head).chain(girders).chain([legend.to_owned()]).collect()
}

/// By how much the deck has to turn to come off a skewed seat.
fn turning(seat: &SeatReport) -> Option<String> {
    let [one, other] = &seat.corners;
    let angles = one.zero_rotation_deg.zip(other.zero_rotation_deg).zip(seat.middle_zero_rotation_deg);
    let ((first, second), middle) = angles.filter(|_| seat.rotation_condition != 0.0)?;
    Some(format!(
        "    turned about G nothing remains at the {} corner from {first:.2}°, at the {} from {second:.2}°, in the middle from \
         {middle:.2}°\n",
        one.angle, other.angle,
    ))
}

fn row(DemandReport { demand, met, .. }: &DemandReport) -> String {
    let assumed = demand.inputs.iter().any(|input| input.source == Source::Assumed);
    let marks =
        [(!demand.confirmed, "*"), (assumed, "°")].map(|(marked, mark)| if marked { mark } else { "" }).concat();
    let [needed, there, used] = [demand.required, demand.provided, demand.used].map(|metres| 1e3 * metres);
    let verdict = if *met { "" } else { "  too short" };
    format!("    {:<39} {needed:>8.1} {there:>8.1} {used:>8.1}{verdict}\n", format!("{} {marks}", demand.rule))
}
