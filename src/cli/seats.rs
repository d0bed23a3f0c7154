//! Seats in the summary of a run: what remained, and when a corner came off.

use crate::scene::shown::escaped;
use crate::tables::{CornerReport, SeatReport};

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
