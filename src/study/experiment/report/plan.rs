//! Fig. 9: the straight girder before the abutment in plan, frame by frame about a hit. Displacements and gap are drawn larger
//! than the girder by one factor, so that a corner meets the wall in the picture where it does in the run.

use std::fmt::Write as _;

use crate::plot::draw::{line, text};
use crate::plot::paper::{DECK, INK, PLACED};
use crate::study::experiment::cases::girder;
use crate::study::experiment::observe::{DRAWN_HZ, Observed};

/// Factor of displacements and gap.
pub(super) const FACTOR: f64 = 6.0;
/// Frames before and after the one nearest the hit.
const FRAMES: [i64; 2] = [-2, 3];
/// Width and height of a frame.
const FRAME: [f64; 2] = [152.0, 190.0];
/// Points a millimetre of the girder.
const SCALE: f64 = 0.42;
/// Half length, half width and gap of the straight girder \[mm\].
const HALF: [f64; 2] = [1e3 * girder::HALF_LENGTH, 1e3 * girder::HALF_WIDTH];
const GAP: f64 = 1e3 * girder::GAP;

/// Frames about the first hit in the second half of a run, when the beginning has died away; none where there is no hit.
pub(super) fn frames(seen: &Observed) -> Option<String> {
    let hit = seen.hits.iter().find(|hit| hit.from > 0.5 * seen.end)?;
    let drawn = &seen.girders.first()?.drawn;
    #[expect(clippy::cast_possible_truncation, reason = "a number of samples")]
    let nearest = (hit.from * DRAWN_HZ).round() as i64;
    let mut svg = String::new();
    let count = FRAMES[1] - FRAMES[0] + 1;
    let (width, height) = (FRAME[0] * count as f64 + 8.0, FRAME[1] + 24.0);
    let _ = write!(
        svg,
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" font-family="sans-serif">"#
    );
    for (place, number) in (FRAMES[0]..=FRAMES[1]).enumerate() {
        let Some(&motion) = usize::try_from(nearest + number).ok().and_then(|i| drawn.get(i)) else { continue };
        let time = (nearest + number) as f64 / DRAWN_HZ - hit.from;
        frame(&mut svg, 8.0 + FRAME[0] * place as f64, motion, &format!("{:+.0} ms", 1e3 * time).replace('-', "−"));
    }
    svg.push_str("</svg>\n");
    Some(svg)
}

/// A frame: wall, girder as placed, girder now.
fn frame(svg: &mut String, left: f64, [x, y, degrees]: [f64; 3], time: &str) {
    let wall = left + FRAME[0] - 26.0;
    // The girder touches the wall where its displacement is the gap.
    let (origin, middle) = (wall - SCALE * (HALF[0] + FACTOR * GAP), 0.5 * FRAME[1]);
    let outline = |shift: [f64; 2], turn: f64| {
        let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|sign: [f64; 2]| {
            let [a, b] = [sign[0] * HALF[0], sign[1] * HALF[1]];
            let at = [a + FACTOR * (shift[0] - turn * b), b + FACTOR * (shift[1] + turn * a)];
            format!("{:.2},{:.2}", origin + SCALE * at[0], middle - SCALE * at[1])
        });
        corners.join(" ")
    };
    let _ = write!(svg, r##"<rect x="{wall}" y="8" width="12" height="{}" fill="#b9bec4"/>"##, FRAME[1] - 16.0);
    line(svg, (wall, 8.0), (wall, FRAME[1] - 8.0), &format!(r#"stroke="{INK}" stroke-width="1.2""#));
    let placed = outline([0.0; 2], 0.0);
    let _ = write!(svg, r#"<polygon points="{placed}" fill="none" stroke="{PLACED}" stroke-dasharray="3 3"/>"#);
    let now = outline([x, y], degrees.to_radians());
    let _ = write!(svg, r#"<polygon points="{now}" fill="{DECK}" fill-opacity="0.85" stroke="{INK}"/>"#);
    text(svg, (left + 0.5 * FRAME[0] - 8.0, FRAME[1] + 14.0), 11.0, "middle", INK, time);
}
