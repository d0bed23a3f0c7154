//! The gap at each facing pair as a dimension line with its value, measured along the bridge axis.

use glam::DVec3;

use super::block::moved_girder_block;
use super::list::Line;
use super::moment::Moment;
use super::palette::Palette;
use super::{Target, ViewInput};
use super::{scale, walls};
use crate::geometry::End;
use crate::language::{Text, values};
use crate::scene::Scene;
use crate::scene::facing::Side;
use crate::sim::{SolidId, readings};

/// Difference of two readings of a gap that is not told, in parts of the larger one \[–\]. Chosen: the third digit.
const ALIKE: f64 = 0.01;

/// A gap as it is now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GapNow {
    /// Along the first girder's axis, from the middle of its end to the facing plane; negative in overlap \[m\].
    pub gap: f64,
    /// Middle of the end's upper edge \[m\].
    pub from: DVec3,
    /// Intersection of the axis through it with the facing plane \[m\].
    pub to: DVec3,
}

/// The face of a side at a moment: a point in its middle and its outward normal.
fn face_of(scene: &Scene, moment: &Moment, side: Side) -> Option<(DVec3, DVec3)> {
    let corners = match side {
        Side::Girder(i, end) => end_corners(scene, moment, i, end)?,
        Side::Abutment(i) => walls::block(scene, i, moment.wall(i))?.face,
        Side::Flank(..) | Side::Rear(..) => return None,
    };
    let [a, b, c, d] = corners;
    Some(((a + b + c + d) / 4.0, (c - a).cross(d - b).normalize_or_zero()))
}

fn end_corners(scene: &Scene, moment: &Moment, girder: usize, end: End) -> Option<[DVec3; 4]> {
    let (girder, motion) = (scene.girders.get(girder)?, moment.end(girder, end)?);
    Some(girder.prism().end_face(end).map(|p| motion.place + motion.attitude * p))
}

/// The gap of each pair of facing ends at a moment, in the order of the pairs.
pub fn gaps(scene: &Scene, moment: &Moment) -> Vec<Option<GapNow>> {
    moment.facings.iter().map(|f| gap_of(scene, moment, f.first, f.second)).collect()
}

fn gap_of(scene: &Scene, moment: &Moment, first: Side, second: Side) -> Option<GapNow> {
    let Side::Girder(i, end) = first else { return None };
    let motion = moment.motions.get(i)?;
    let axis = motion.attitude * DVec3::X * end.sign();
    let (middle, _) = face_of(scene, moment, first)?;
    let (there, normal) = face_of(scene, moment, second)?;
    let slope = axis.dot(normal);
    if slope.abs() < 1e-9 {
        return None;
    }
    let gap = (there - middle).dot(normal) / slope;
    let up = motion.attitude * DVec3::Z * (scene.girders.get(i)?.thickness / 2.0);
    Some(GapNow { gap, from: middle + up, to: middle + up + axis * gap })
}

/// A dimension line as drawn: the strokes, and where its value stands.
#[derive(Debug)]
pub(super) struct Dimension {
    pub(super) lines: Vec<Line>,
    /// Its two ends, outside of the arrows \[m\].
    pub(super) ends: [DVec3; 2],
    pub(super) gap: f64,
    /// The pair in the run's model.
    pair: Option<usize>,
}

impl Dimension {
    /// Whether one of the two bodies is selected.
    pub(super) fn is_selected(&self, input: &ViewInput<'_>) -> bool {
        let pairs = input.history.map(|history| &history.model().pairs);
        let Some(pair) = self.pair.and_then(|pair| pairs?.get(pair)) else { return false };
        let target = |side: Side| match side.solid() {
            SolidId::Girder(i) => Target::Girder(i),
            SolidId::Abutment(i) => Target::Abutment(i),
        };
        [pair.first, pair.second].into_iter().any(|side| input.selected.contains(&target(side)))
    }

    /// The value in words: along the axis from the middle of the end, and where it is another the least gap, square to the face.
    pub(super) fn words(&self, input: &ViewInput<'_>) -> String {
        let along = scale::length(self.gap);
        let least = self.pair.zip(input.history).map(|(pair, history)| {
            let t = if input.t.is_finite() { input.t.clamp(0.0, history.end()) } else { 0.0 };
            readings::gap(history, pair, t)
        });
        let differs = |least: &f64| (least - self.gap).abs() > ALIKE * least.abs().max(self.gap.abs());
        match least.filter(differs).map(scale::length) {
            Some(least) => Text::new("view-gap-least").with(&values!["length" => along, "least" => least]),
            None => Text::new("view-gap").with(&values!["length" => along]),
        }
    }
}

/// Numbers of the facing pairs in the run's model, in the order of [`gaps`]; none as placed.
pub(super) fn pairs(input: &ViewInput<'_>) -> Vec<usize> {
    let pairs = input.history.map(|history| history.model().pairs.iter().enumerate());
    pairs.into_iter().flatten().filter(|(_, pair)| !pair.met).map(|(number, _)| number).collect()
}

/// The dimension line of a gap: a tick at either side and arrows from outside, as drawings have it.
pub(super) fn dimension(input: &ViewInput<'_>, (now, pair): (&GapNow, Option<usize>), palette: &Palette) -> Dimension {
    let pixel = input.camera.metres_per_pixel(now.from, f64::from(input.size[1])) * f64::from(input.pixels_per_point);
    let axis = (now.to - now.from).normalize_or(DVec3::X);
    let reach = axis * (22.0 * pixel);
    let raised = DVec3::Z * (9.0 * pixel);
    let across = (DVec3::Z.cross(axis)).normalize_or(DVec3::Y) * (4.0 * pixel);
    let (from, to) = (now.from + raised, now.to + raised);
    let mut strokes = vec![(now.from, from + raised * 0.5), (now.to, to + raised * 0.5)];
    for (tip, away) in [(from, -1.0), (to, 1.0)] {
        let back = axis * (away * 7.0 * pixel);
        strokes.extend([(tip, tip + reach * away), (tip, tip + back + across), (tip, tip + back - across)]);
    }
    let line = |(a, b): (DVec3, DVec3)| Line {
        group: "gap dimension",
        from: a.as_vec3(),
        to: b.as_vec3(),
        width: 1.3 * input.pixels_per_point,
        color: palette.dimension,
    };
    Dimension { lines: strokes.into_iter().map(line).collect(), ends: [from - reach, to + reach], gap: now.gap, pair }
}

/// The block of a girder at a moment, by number.
pub(super) fn girder_block_at(scene: &Scene, moment: &Moment, girder: usize) -> Option<super::block::Block> {
    Some(moved_girder_block(scene.girders.get(girder)?, moment.motions.get(girder)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::sim::History;

    #[test]
    fn the_gap_of_an_end_that_shortens_is_that_of_its_corners() {
        let mut scene = presets::load("deck-30m-elastic").expect("a preset");
        scene.girders[0].skew_deg = 90.0;
        scene.duration = 1.5;
        let history = History::of(&scene).expect("runs");
        let hardest =
            history.hits().touches().iter().max_by(|a, b| a.peak_force.total_cmp(&b.peak_force)).expect("a hit");
        let t = hardest.peak_time;
        let moment = Moment::at(&history, t);
        let shown = gaps(&scene, &moment)[0].expect("a gap").gap;
        let least = readings::gap(&history, 0, t);
        assert!(least < -1e-4 && (shown - least).abs() < ALIKE * least.abs(), "{shown} and {least} m");
        // That of its G alone is another: the half deck is 1.5 mm shorter.
        let rigid = gaps(&scene, &Moment { ends: Vec::new(), ..moment })[0].expect("a gap").gap;
        assert!((rigid - least).abs() > 5.0 * ALIKE * least.abs(), "{rigid} and {least} m");
    }
}
