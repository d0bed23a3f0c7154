//! Snapping: a girder's axis to its neighbours' axes, gaps to the gaps there are, faces parallel to other faces.

use glam::{DVec2, DVec3};

use crate::app::text;
use crate::geometry::End;
use crate::scene::facing;
use crate::scene::{Girder, Scene, placed};
use crate::view::Target;

/// How near an angle must be to be snapped to \[degrees\].
const NEAR_DEG: f64 = 1.2;

/// Round angles to snap to \[degrees\].
const ROUND_DEG: f64 = 15.0;

/// A line that was snapped to, from and to \[m\].
pub(in crate::app) type Guide = [DVec3; 2];

/// A way over the ground after snapping.
#[derive(Clone, Debug)]
pub(super) struct Snapped {
    /// \[m\].
    pub(super) way: DVec2,
    /// Lines that it snapped to.
    pub(super) guides: Vec<Guide>,
    /// The same in words.
    pub(super) words: Vec<String>,
}

impl Snapped {
    /// As it came.
    pub(super) fn free(way: DVec2) -> Self {
        Self { way, guides: Vec::new(), words: Vec::new() }
    }
}

/// A line to snap to: how far the girder still has to go, and what it is then.
struct Candidate {
    left: f64,
    guide: Guide,
    words: String,
}

/// Snaps a girder that is moved by `way` to its neighbours, across its axis to theirs and along it to one of `gaps`.
pub(super) fn moved(scene: &Scene, selected: &[Target], i: usize, way: DVec2, (reach, gaps): (f64, &[f64])) -> Snapped {
    let Some(girder) = scene.girders.get(i) else { return Snapped::free(way) };
    let axes = placed::axes(girder);
    let (u, v) = (axes.x_axis, axes.y_axis);
    let here = DVec3::from(girder.position) + way.extend(0.0);
    let others = scene.girders.iter().enumerate().filter(|(k, _)| !selected.contains(&Target::Girder(*k)));
    let parallel: Vec<&Girder> =
        others.map(|(_, g)| g).filter(|g| placed::axes(g).x_axis.cross(u).length() < 1e-6).collect();
    let line = |at: DVec3| [at - u * girder.length, at + u * girder.length];
    let mut across = Vec::new();
    if way != DVec2::ZERO {
        let start = DVec3::from(girder.position);
        across.push(Candidate { left: (start - here).dot(v), guide: line(start), words: String::new() });
    }
    across.extend(parallel.iter().map(|other| {
        let there = DVec3::from(other.position);
        Candidate { left: (there - here).dot(v), guide: line(there), words: text::on_axis_of(&other.name) }
    }));
    let along = parallel.iter().flat_map(|other| end_to_end(girder, other, here, u, gaps));
    let (a, b) = (nearest(along, reach), nearest(across, reach));
    let mut out = Snapped::free(way);
    for (found, direction) in [(a, u), (b, v)] {
        let Some(found) = found else { continue };
        out.way += direction.truncate() * found.left;
        if !found.words.is_empty() {
            out.guides.push(found.guide);
            out.words.push(found.words);
        }
    }
    out
}

fn nearest(candidates: impl IntoIterator<Item = Candidate>, reach: f64) -> Option<Candidate> {
    let near = candidates.into_iter().filter(|c| c.left.abs() <= reach);
    near.min_by(|a, b| a.left.abs().total_cmp(&b.left.abs()))
}

/// Each of two ends at each usual gap from the other girder's end.
fn end_to_end(girder: &Girder, other: &Girder, here: DVec3, u: DVec3, gaps: &[f64]) -> Vec<Candidate> {
    let between = f64::midpoint(girder.length, other.length);
    let there = DVec3::from(other.position);
    let ahead = (there - here).dot(u);
    let mut all = Vec::new();
    for end in End::BOTH {
        for &gap in gaps {
            let face = there - u * (end.sign() * other.length / 2.0);
            let side = placed::axes(girder).y_axis * (0.6 * girder.width);
            all.push(Candidate {
                left: ahead - end.sign() * (between + gap),
                guide: [face - side, face + side],
                words: text::gap_to(&text::exact_length(gap), &other.name),
            });
        }
    }
    all
}

/// Gaps that the scene has already, each once \[m\].
pub(super) fn usual_gaps(scene: &Scene) -> Vec<f64> {
    let mut gaps: Vec<f64> =
        facing::find(scene).unwrap_or_default().iter().map(|f| f.gap).filter(|g| *g > 0.0 && g.is_finite()).collect();
    gaps.sort_by(f64::total_cmp);
    gaps.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    gaps
}

/// An angle that is near a round one or one of `others` becomes it, with the reason.
fn angle(free: f64, others: impl Iterator<Item = (f64, String)>) -> (f64, Option<String>) {
    let round = (free / ROUND_DEG).round() * ROUND_DEG;
    let near = others.filter(|(there, _)| (there - free).abs() <= NEAR_DEG);
    match near.min_by(|a, b| (a.0 - free).abs().total_cmp(&(b.0 - free).abs())) {
        Some((there, why)) => (there, Some(why)),
        None if (round - free).abs() <= NEAR_DEG => (round, None),
        None => (free, None),
    }
}

/// Snaps a heading to the other girders' \[degrees\].
pub(super) fn heading(scene: &Scene, i: usize, free: f64) -> (f64, Option<String>) {
    let others = scene.girders.iter().enumerate().filter(|(k, _)| *k != i);
    angle(free, others.map(|(_, g)| (g.heading_deg, text::parallel_to(&g.name))))
}

/// Snaps a skew so that the ends are parallel to other girders' ends \[degrees\].
pub(super) fn skew(scene: &Scene, i: usize, free: f64) -> (f64, Option<String>) {
    let Some(own) = scene.girders.get(i) else { return (free, None) };
    let others = scene.girders.iter().enumerate().filter(|(k, _)| *k != i);
    // An end's direction in the world is heading + β.
    let parallel = others.map(|(_, g)| {
        let skew = (g.skew_deg + g.heading_deg - own.heading_deg).rem_euclid(180.0);
        (skew, text::ends_parallel_to(&g.name))
    });
    angle(free, parallel)
}

/// Snaps a gap to another one of the scene, or to none at all \[m\].
pub(super) fn gap(scene: &Scene, n: usize, free: f64, reach: f64) -> (f64, Option<String>) {
    if free <= reach / 2.0 {
        return (0.0, None);
    }
    let pairs = facing::find(scene).unwrap_or_default();
    let others = pairs.iter().enumerate().filter(|(k, p)| *k != n && (p.gap - free).abs() <= reach);
    match others.min_by(|a, b| (a.1.gap - free).abs().total_cmp(&(b.1.gap - free).abs())) {
        Some((_, pair)) => (pair.gap, Some(text::as_at(&pair.name))),
        None => (free, None),
    }
}

/// The power of ten at or below a pixel, so that dragged numbers stay short.
pub(super) fn round_step(per_pixel: f64) -> f64 {
    if per_pixel.is_finite() && per_pixel > 0.0 { 10f64.powf(per_pixel.log10().floor()) } else { 1e-6 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::unit;
    use crate::scene::presets;

    #[test]
    fn steps_are_powers_of_ten_below_a_pixel() {
        assert_eq!(round_step(0.00037), 1e-4, "below a pixel");
        assert_eq!(unit::rounded(0.123_456, 1e-4), 0.1235, "four digits");
        assert_eq!(unit::rounded(1234.0, 100.0), 1200.0, "large scenes round too");
    }

    #[test]
    fn a_girder_snaps_to_the_axis_and_the_gap_of_its_neighbour() {
        let scene = presets::load("row-of-5").expect("ships");
        let gap = facing::find(&scene).expect("fine")[1].gap;
        let row: Vec<Target> = vec![Target::Girder(4)];
        // Off by a little in both directions from where it stands now.
        let way = DVec2::new(-gap * 0.1, gap * 0.2);
        let snapped = moved(&scene, &row, 4, way, (gap * 0.5, &[gap]));
        assert!(snapped.way.length() < 1e-12, "back into the row, got {:?}", snapped.way);
        assert!(snapped.words.iter().any(|w| w.starts_with("gap ")), "says so: {:?}", snapped.words);
        let far = moved(&scene, &row, 4, DVec2::new(0.0, 10.0), (gap * 0.5, &[gap]));
        assert_eq!(far.way.y, 10.0, "nothing is near there");
    }

    #[test]
    fn angles_snap_to_neighbours_before_round_ones() {
        let near = |free| angle(free, std::iter::once((44.0, "b".to_owned())));
        assert_eq!(near(44.4), (44.0, Some("b".into())), "the neighbour's");
        assert_eq!(near(59.0), (60.0, None), "a round one");
        assert_eq!(near(52.3), (52.3, None), "neither");
    }
}
