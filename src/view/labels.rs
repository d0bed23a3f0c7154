//! Texts in the picture, placed so that they do not lie on one another.

use glam::Vec2;

use super::area::Area;
use super::crowd::Crowd;
use super::list::{Mark, Rgba};
use crate::language::is_japanese;

/// About how large a text is; the renderer lays it out exactly, this only keeps texts apart \[pixels\].
pub(super) fn text_size(text: &str, size: f32) -> Vec2 {
    let em: f32 = text
        .chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | 'I' | '.' | ',' | ':' | '\'' | '|' | '·' => 0.27,
            ' ' | 'f' | 't' | 'r' | '(' | ')' | '/' => 0.36,
            'm' | 'w' | 'M' | 'W' => 0.84,
            '_' => 0.0,
            c if c.is_uppercase() => 0.66,
            c if is_japanese(c) => 1.0,
            _ => 0.56,
        })
        .sum();
    Vec2::new(em * size, 1.3 * size)
}

/// A text that wants to stand at a point.
#[derive(Clone, Debug)]
pub(super) struct Label {
    /// Place that it names \[pixels\].
    pub(super) at: Vec2,
    /// Distance from it at which the text may start \[pixels\].
    pub(super) clear: f32,
    pub(super) text: String,
    pub(super) size: f32,
    pub(super) color: Rgba,
    pub(super) plate: Rgba,
    /// Directions to try, the best first; `ZERO` is on the point itself.
    pub(super) directions: Vec<Vec2>,
}

/// On the point, else around it.
pub(super) const ON: &[Vec2] = &[Vec2::ZERO, Vec2::new(0.0, -1.0), Vec2::new(0.0, 1.0), Vec2::X, Vec2::NEG_X];
/// Beside the point, above first.
pub(super) const BESIDE: &[Vec2] = &[
    Vec2::new(0.0, -1.0),
    Vec2::new(0.8, -0.8),
    Vec2::new(-0.8, -0.8),
    Vec2::X,
    Vec2::NEG_X,
    Vec2::new(0.8, 0.8),
    Vec2::new(-0.8, 0.8),
    Vec2::new(0.0, 1.0),
];

/// Distances from the point that are tried one after the other, in distances at which a text may start. The last ones lead out from under
/// a gauge or a card beside the point: 70 points, where a text may start at 5.
const DISTANCES: [f32; 5] = [1.0, 2.6, 4.4, 8.0, 14.0];

/// Places labels one after another on what is still free.
#[derive(Debug)]
pub(super) struct Placer {
    /// The picture.
    whole: Area,
    /// The picture without a margin at its edge.
    picture: Area,
    taken: Crowd,
    ppp: f32,
    leader: Rgba,
}

impl Placer {
    /// An empty picture; `leader` is the colour of the strokes that tie a far text to its point.
    pub(super) fn new(size: [u32; 2], ppp: f32, leader: Rgba) -> Self {
        let whole = Area { min: Vec2::ZERO, max: Vec2::from(size.map(|s| s as f32)) };
        let picture = Area { min: whole.min + 6.0 * ppp, max: whole.max - 6.0 * ppp };
        Self { whole, picture, taken: Crowd::new(size, ppp), ppp, leader }
    }

    /// Keeps an area free of labels.
    pub(super) fn take(&mut self, area: Area) {
        self.taken.take(area);
    }

    /// Keeps a stroke free of labels.
    pub(super) fn take_stroke(&mut self, from: Vec2, to: Vec2, width: f32) {
        let (length, step) = ((to - from).length(), 2.0 * width);
        let along = (0..64).map(|i| i as f32 * step).take_while(|way| *way < length);
        for way in along {
            let at = from + (to - from) * (way / length);
            self.take(Area::about(at, Vec2::splat(width)));
        }
    }

    /// Places a label where it covers least; nothing where its point is outside the picture, or a quarter of the text
    /// would lie on other things.
    pub(super) fn place(&mut self, label: &Label) -> Vec<Mark> {
        let half = text_size(&label.text, label.size) / 2.0 + Vec2::new(4.0, 1.5) * self.ppp;
        let inside = label.at.cmpge(self.picture.min).all() && label.at.cmple(self.picture.max).all();
        if !inside {
            return Vec::new();
        }
        let spots = DISTANCES.into_iter().flat_map(|far| {
            label.directions.iter().filter(move |d| far == 1.0 || **d != Vec2::ZERO).map(move |d| (far, *d))
        });
        let mut best: Option<(f32, f32, Area)> = None;
        for (far, direction) in spots {
            let middle = label.at + direction * (half + label.clear * far);
            let area = Area::about(middle, half);
            // A text half hidden says less than none.
            let most = best.map_or(half.x * half.y, |(_, least, _)| least);
            let Some(cost) = self.cost(&area, most) else { continue };
            if best.is_none_or(|(_, least, _)| cost < least) {
                best = Some((far, cost, area));
            }
            if cost == 0.0 {
                break;
            }
        }
        best.map(|(far, _, area)| self.settle(label, far, self.pushed_inside(area))).unwrap_or_default()
    }

    /// The spot moved by what it exceeds the picture: `382 kN` cut at the edge reads `32 kN`. A spot inside stays where it is.
    fn pushed_inside(&self, area: Area) -> Area {
        let by = (self.whole.min - area.min).max(Vec2::ZERO) - (area.max - self.whole.max).max(Vec2::ZERO);
        Area { min: area.min + by, max: area.max + by }
    }

    /// Area that a label at a spot would cover: of other labels, and outside of the picture \[pixels²\]; `None` above `most`.
    fn cost(&self, area: &Area, most: f32) -> Option<f32> {
        let size = area.size();
        let outside = (size.x * size.y - area.overlap(&self.picture)).max(0.0);
        let cost = self.taken.covered(area, most)? + outside;
        (cost <= most).then_some(cost)
    }

    fn settle(&mut self, label: &Label, far: f32, area: Area) -> Vec<Mark> {
        let middle = (area.min + area.max) / 2.0;
        self.take(area);
        let mut marks = Vec::new();
        if far > 1.0 {
            let end = label.at.clamp(area.min, area.max);
            let points = vec![label.at, end];
            marks.push(Mark::Stroke { points, width: self.ppp, color: self.leader });
        }
        marks.push(Mark::Text {
            at: middle,
            align: Vec2::splat(0.5),
            size: label.size,
            text: label.text.clone(),
            color: label.color,
            plate: Some(label.plate),
        });
        marks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn label(text: &str) -> Label {
        let ink = Rgba::rgb(0, 0, 0);
        Label {
            at: Vec2::splat(200.0),
            clear: 6.0,
            text: text.into(),
            size: 13.0,
            color: ink,
            plate: ink,
            directions: ON.to_vec(),
        }
    }

    /// Area of the letters of a placed label; `None` where it was not placed.
    fn letters(marks: &[Mark]) -> Option<Area> {
        marks.iter().find_map(|mark| match mark {
            Mark::Text { at, size, text, .. } => Some(Area::about(*at, text_size(text, *size) / 2.0)),
            _ => None,
        })
    }

    #[test]
    fn labels_of_one_point_do_not_lie_on_one_another() {
        let mut placer = Placer::new([400, 400], 1.0, Rgba::CLEAR);
        let texts = ["deck", "wall", "124 N", "gap 3.00 mm", "another"];
        let taken = texts.map(|text| letters(&placer.place(&label(text))).expect("it is placed"));
        let clear = |i: usize| taken[..i].iter().all(|other| other.overlap(&taken[i]) == 0.0);
        assert!((0..taken.len()).all(clear), "no two areas overlap: {taken:?}");
    }

    #[test]
    fn a_label_comes_out_from_under_a_card_about_its_point() {
        let mut placer = Placer::new([400, 400], 1.0, Rgba::CLEAR);
        let card = Area::about(Vec2::splat(200.0), Vec2::splat(60.0));
        placer.take(card);
        let marks = placer.place(&label("gap \u{2212}0.47 mm"));
        assert!(marks.iter().any(|mark| matches!(mark, Mark::Stroke { .. })), "a leader goes there: {marks:?}");
        let own = letters(&marks).expect("it is placed");
        assert_eq!(own.overlap(&card), 0.0, "no letter is covered: {own:?}");
    }

    #[test]
    fn a_text_at_the_edge_of_the_picture_is_whole() {
        let picture = Area { min: Vec2::ZERO, max: Vec2::splat(400.0) };
        for at in [Vec2::new(8.0, 200.0), Vec2::new(392.0, 200.0), Vec2::new(200.0, 8.0), Vec2::new(9.0, 391.0)] {
            let mut placer = Placer::new([400, 400], 1.0, Rgba::CLEAR);
            let marks = placer.place(&Label { at, directions: BESIDE.to_vec(), ..label("382 kN, slip (548 kN)") });
            let own = letters(&marks).expect("it is placed");
            let size = own.size();
            assert!((own.overlap(&picture) - size.x * size.y).abs() < 1e-2, "at {at}: {own:?}");
        }
    }

    #[test]
    fn a_text_that_only_reaches_into_the_margin_stays() {
        let placer = Placer::new([400, 400], 1.0, Rgba::CLEAR);
        let [inside, beyond] = [1.0, -20.0].map(|x| Area { min: Vec2::new(x, 50.0), max: Vec2::new(x + 80.0, 70.0) });
        assert_eq!(placer.pushed_inside(inside), inside, "nothing of it is cut");
        assert_eq!(placer.pushed_inside(beyond).min, Vec2::new(0.0, 50.0), "by the 20 pixels that it exceeds");
    }

    #[test]
    fn a_point_outside_the_picture_gets_no_label() {
        let mut placer = Placer::new([100, 100], 1.0, Rgba::CLEAR);
        assert!(placer.place(&label("far away")).is_empty(), "(200, 200) is outside 100 x 100");
    }
}
