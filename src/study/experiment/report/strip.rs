//! The motion pattern in the six states (Fig. 13) as bands over time, one a girder and model, with ticks at the hits.

use std::fmt::Write as _;

use crate::plot::COLORS;
use crate::plot::draw::{escape, line, text};
use crate::plot::paper::INK;
use crate::sim::GirderState;
use crate::study::experiment::observe::HitSeen;
use crate::study::experiment::states::Stretch;

const WIDTH: f64 = 900.0;
/// The field of a chart above it.
const FIELD: [f64; 2] = [84.0, 690.0];
/// Height of a band with the room below it.
const BAND: f64 = 26.0;
/// A hit of a millisecond is seen.
const LEAST: f64 = 0.7;

/// A band.
pub(super) struct Band<'a> {
    /// Before it.
    pub(super) name: String,
    pub(super) states: &'a [Stretch],
    pub(super) hits: &'a [HitSeen],
}

/// Colour of a state, a to f: pale without contact, each contact its own.
fn color(letter: char) -> &'static str {
    match letter {
        'a' => "#d6e3ee",
        'b' => "#efefef",
        'c' => COLORS[1],
        'd' => COLORS[3],
        'e' => COLORS[0],
        _ => COLORS[2],
    }
}

/// Bands over the same time, up to `end` \[s\].
pub(super) fn strip(bands: &[Band<'_>], end: f64) -> String {
    let height = 16.0 + BAND * bands.len() as f64 + 22.0;
    let mut svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" font-family="sans-serif">"#
    );
    let at = |t: f64| FIELD[0] + (FIELD[1] - FIELD[0]) * t / end.max(1e-9);
    for (number, band) in bands.iter().enumerate() {
        let top = 14.0 + BAND * number as f64;
        text(&mut svg, (FIELD[0] - 8.0, top + 12.0), 11.0, "end", INK, &escape(&band.name));
        for stretch in band.states {
            let (x, width) = (at(stretch.from), (at(stretch.until) - at(stretch.from)).max(LEAST));
            let _ = write!(
                svg,
                r#"<rect x="{x:.2}" y="{top}" width="{width:.2}" height="16" fill="{}"/>"#,
                color(stretch.letter)
            );
        }
        for hit in band.hits {
            let x = at(hit.from);
            line(&mut svg, (x, top - 4.0), (x, top), &format!(r#"stroke="{INK}" stroke-width="0.7""#));
        }
    }
    legend(&mut svg, height - 8.0);
    svg.push_str("</svg>\n");
    svg
}

fn legend(svg: &mut String, y: f64) {
    let mut x = FIELD[0];
    for state in GirderState::ALL {
        let words = format!("{}: {}", state.letter(), state.label());
        let _ =
            write!(svg, r#"<rect x="{x}" y="{}" width="10" height="10" fill="{}"/>"#, y - 9.0, color(state.letter()));
        text(svg, (x + 14.0, y), 10.0, "start", INK, &words);
        x += 30.0 + 5.4 * words.len() as f64;
    }
    text(svg, (x, y), 10.0, "start", INK, "| hit");
}

/// States with their part of the time and how often they were entered: `a 92.1 %, c 0.4 % (31×)`.
pub(super) fn pattern(states: &[Stretch]) -> String {
    let whole: f64 = states.iter().map(Stretch::length).sum();
    let of_state = |state: GirderState| {
        let own = || states.iter().filter(|stretch| stretch.letter == state.letter());
        let (times, part) = (own().count(), 100.0 * own().map(Stretch::length).sum::<f64>() / whole);
        (times > 0).then(|| format!("{} {part:.1} % ({times}×)", state.letter()))
    };
    GirderState::ALL.into_iter().filter_map(of_state).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_names_what_there_is_with_its_part_of_the_time() {
        let stretch = |from: f64, until: f64, letter: char| Stretch { from, until, letter };
        let states = [stretch(0.0, 0.5, 'b'), stretch(0.5, 0.75, 'e'), stretch(0.75, 1.0, 'b')];
        assert_eq!(pattern(&states), "b 75.0 % (2×), e 25.0 % (1×)", "in the paper's order");
    }
}
