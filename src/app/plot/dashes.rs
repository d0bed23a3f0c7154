//! Broken lines of curves: what lies in the field alone, each dash one stroke. A curve that goes on far beyond the field is not walked
//! dash by dash, and one of many points is not broken at each of them.

use egui::{Painter, Pos2, Rect, Shape, Stroke};
use egui_plot::LineStyle;

/// Length of a dot in parts of the distance of two \[–\].
const DOT: f32 = 0.3;
/// Length of a gap in parts of a dash \[–\]; as in legends.
const GAP: f32 = 0.6;

/// Lengths of dashes and gaps of a style \[points\]; none of a solid line.
fn lengths(style: LineStyle) -> Option<[f32; 2]> {
    match style {
        LineStyle::Solid => None,
        LineStyle::Dotted { spacing } => Some([DOT * spacing, (1.0 - DOT) * spacing]),
        LineStyle::Dashed { length } => Some([length, GAP * length]),
    }
}

/// Whether a style is of broken lines.
pub(super) fn is_broken(style: LineStyle) -> bool {
    lengths(style).is_some()
}

/// Draws a curve through these places in a broken line, as far as the painter draws.
pub(super) fn draw(painter: &Painter, places: impl Iterator<Item = Pos2>, style: LineStyle, stroke: Stroke) {
    let Some(lengths) = lengths(style) else { return };
    let field = painter.clip_rect().expand(stroke.width);
    painter.extend(dashes(places, field, lengths).into_iter().map(|dash| Shape::line(dash, stroke)));
}

/// The dashes of a curve inside a field. Where the curve comes into the field it begins with a dash.
fn dashes(places: impl Iterator<Item = Pos2>, field: Rect, [dash, gap]: [f32; 2]) -> Vec<Vec<Pos2>> {
    let mut all: Vec<Vec<Pos2>> = Vec::new();
    // Way since the beginning of the dash, and where the last piece ended.
    let (mut way, mut end, mut before) = (0.0, None, None);
    for place in places {
        let Some(from) = before.replace(place) else { continue };
        let Some([mut here, to]) = inside(field, from, place) else { continue };
        if end != Some(here) {
            way = 0.0;
            all.push(vec![here]);
        }
        loop {
            let (left, next) = (here.distance(to), if way < dash { dash } else { dash + gap } - way);
            let there = if left < next { to } else { here.lerp(to, next / left) };
            if way < dash
                && let Some(points) = all.last_mut()
            {
                points.push(there);
            }
            way += left.min(next);
            if left < next {
                break;
            }
            here = there;
            if way >= dash + gap {
                way = 0.0;
                all.push(vec![here]);
            }
        }
        end = Some(to);
    }
    all.retain(|dash| dash.len() > 1);
    all
}

/// The part of a segment that is in a field (Liang and Barsky).
fn inside(field: Rect, from: Pos2, to: Pos2) -> Option<[Pos2; 2]> {
    if !(from.is_finite() && to.is_finite()) {
        return None;
    }
    let [x, y] = [[from.x, to.x], [from.y, to.y]].map(|ends| ends.map(f64::from));
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for ([from, to], low, high) in [(x, field.left(), field.right()), (y, field.top(), field.bottom())] {
        let (step, near, far) = (to - from, f64::from(low) - from, f64::from(high) - from);
        if step == 0.0 {
            if near > 0.0 || far < 0.0 {
                return None;
            }
            continue;
        }
        let (enters, leaves) = if step > 0.0 { (near / step, far / step) } else { (far / step, near / step) };
        (first, last) = (first.max(enters), last.min(leaves));
    }
    let along = |[from, to]: [f64; 2], part: f64| from + (to - from) * part;
    let at = |part: f64| match part {
        0.0 => from,
        1.0 => to,
        _ => glam::DVec2::new(along(x, part), along(y, part)).as_vec2().to_array().into(),
    };
    (first < last).then(|| [at(first), at(last)])
}

#[cfg(test)]
mod tests {
    use egui::pos2;

    use super::*;

    const FIELD: Rect = Rect { min: pos2(0.0, 0.0), max: pos2(100.0, 50.0) };

    fn length(dashes: &[Vec<Pos2>]) -> f32 {
        dashes.iter().flat_map(|dash| dash.windows(2)).map(|w| w[0].distance(w[1])).sum()
    }

    #[test]
    fn a_level_curve_of_many_points_has_even_dashes() {
        let places = (0..=990).map(|i| pos2(0.1 * i as f32, 20.0));
        let found = dashes(places, FIELD, [6.0, 4.0]);
        assert_eq!(found.len(), 10);
        for (i, dash) in found.iter().enumerate() {
            let [from, to] = [dash[0], dash[dash.len() - 1]];
            assert!(
                (from.x - 10.0 * i as f32).abs() < 1e-3 && (to.x - from.x - 6.0).abs() < 1e-3,
                "{from:?} to {to:?}"
            );
        }
    }

    #[test]
    fn a_curve_far_beyond_the_field_has_no_more_dashes_than_the_field_holds() {
        let places = [
            pos2(-1e9, -1e9),
            pos2(50.0, 25.0),
            pos2(60.0, 1e12),
            pos2(70.0, -1e12),
            pos2(f32::NAN, 3.0),
            pos2(80.0, 10.0),
        ];
        let found = dashes(places.into_iter(), FIELD, [6.0, 4.0]);
        assert!(found.len() < 30, "{} dashes", found.len());
        assert!(found.iter().flatten().all(|at| FIELD.expand(0.01).contains(*at)), "{found:?}");
        assert!(length(&found) > 50.0, "what is in the field is there: {} points", length(&found));
    }

    #[test]
    fn a_corner_does_not_end_a_dash() {
        let places = [pos2(0.0, 10.0), pos2(3.0, 10.0), pos2(3.0, 13.0), pos2(20.0, 13.0)];
        let found = dashes(places.into_iter(), FIELD, [6.0, 4.0]);
        assert_eq!(found[0].len(), 3, "through the corner: {found:?}");
        assert!((length(&found[..1]) - 6.0).abs() < 1e-4);
    }

    #[test]
    fn solid_lines_are_not_broken() {
        assert!(!is_broken(LineStyle::Solid) && is_broken(LineStyle::Dashed { length: 4.0 }));
        assert_eq!(lengths(LineStyle::Dotted { spacing: 5.0 }), Some([1.5, 3.5]));
    }
}
