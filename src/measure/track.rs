//! Marks followed from picture to picture.
//!
//! A mark is looked for where it would be at constant velocity, within half the least distance of two marks of the first picture:
//! nearer to its place than to any other's.

use super::grey::Grey;
use super::layout::Layout;
use super::marks::{Finder, Mark};
use crate::language::said;

/// Ratio of a mark's pixels to those in the first picture above which it has merged with something; below the inverse it is partly
/// covered. Chosen between 1 and the 2 of two equal marks that merge.
const MERGED: f64 = 1.7;

/// Pixels by which the number that a round mark covers may exceed [`MERGED`] times that in another picture by where it is between them: of
/// marks 1.5 to 3.3 pixels across by up to 2.3 (four for one, nine for four), of larger ones by none. Counted at 3000 places of each size.
const SMALL: f64 = 2.5;

/// Whether so many pixels are more than a mark of the others can have.
fn exceed(more: usize, fewer: usize) -> bool {
    more as f64 > MERGED * fewer as f64 + SMALL
}

/// Search radius of a mark that is alone, as a share of the picture's height (chosen).
const ALONE: f64 = 0.2;

/// A place in a picture, in a message \[pixels\].
fn place(pixels: f64) -> String {
    format!("{pixels:.1}")
}

/// Reasons why a mark was not followed. Marks are numbered from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Lost {
    /// No mark at the expected place.
    #[error("{}", said!("mark-missing", "mark" => *mark, "body" => body.as_str(), "within" => format!("{within:.0}"), "x" => place(near[0]), "y" => place(near[1])))]
    Missing {
        /// Its number.
        mark: usize,
        /// Body that it is on.
        body: String,
        /// Expected place \[pixels\].
        near: [f64; 2],
        /// Radius of the search about that place \[pixels\].
        within: f64,
    },
    /// It and another are one.
    #[error("{}", said!("mark-merged", "one" => marks[0], "other" => marks[1], "x" => place(at[0]), "y" => place(at[1])))]
    Merged {
        /// Their numbers.
        marks: [usize; 2],
        /// Place \[pixels\].
        at: [f64; 2],
    },
    /// It is one with something else that is bright.
    #[error("{}", said!("mark-grown", "mark" => *mark, "body" => body.as_str(), "x" => place(at[0]), "y" => place(at[1]), "area" => *area, "first" => *first))]
    Grown {
        /// Its number.
        mark: usize,
        /// Body that it is on.
        body: String,
        /// Place \[pixels\].
        at: [f64; 2],
        /// Its pixels.
        area: usize,
        /// Those in the first picture.
        first: usize,
    },
    /// Part of it is covered.
    #[error("{}", said!("mark-shrunk", "mark" => *mark, "body" => body.as_str(), "x" => place(at[0]), "y" => place(at[1]), "area" => *area, "first" => *first))]
    Shrunk {
        /// Its number.
        mark: usize,
        /// Body that it is on.
        body: String,
        /// Place \[pixels\].
        at: [f64; 2],
        /// Its pixels.
        area: usize,
        /// Those in the first picture.
        first: usize,
    },
    /// The edge of the picture cuts it off.
    #[error("{}", said!("mark-at-edge", "mark" => *mark, "body" => body.as_str(), "x" => place(at[0]), "y" => place(at[1])))]
    AtEdge {
        /// Its number.
        mark: usize,
        /// Body that it is on.
        body: String,
        /// Place \[pixels\].
        at: [f64; 2],
    },
    /// Another size of picture.
    #[error("{}", said!("mark-size", "width" => found[0], "height" => found[1], "firstwidth" => first[0], "firstheight" => first[1]))]
    Size {
        /// Its width and height.
        found: [usize; 2],
        /// Those of the first.
        first: [usize; 2],
    },
}

/// Marks and where they are.
#[derive(Clone, Debug)]
pub struct Tracker {
    finder: Finder,
    bodies: Vec<String>,
    size: [usize; 2],
    within: f64,
    areas: Vec<usize>,
    /// Places in the last two pictures \[pixels\].
    last: [Vec<[f64; 2]>; 2],
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

impl Tracker {
    /// Finds the marks of a layout in the first picture.
    ///
    /// # Errors
    /// A mark that is not there.
    pub fn start(layout: &Layout, finder: Finder, first: &Grey) -> Result<Self, Lost> {
        let places: Vec<[f64; 2]> = layout.mark.iter().map(|mark| mark.pixel).collect();
        let pairs = places.iter().enumerate().flat_map(|(n, a)| places[..n].iter().map(move |b| apart(*a, *b)));
        let least = pairs.fold(f64::INFINITY, f64::min);
        let within = if least.is_finite() { 0.5 * least } else { ALONE * first.height as f64 };
        let bodies = layout.mark.iter().map(|mark| mark.body.clone()).collect();
        let size = [first.width, first.height];
        let mut tracker =
            Self { finder, bodies, size, within, areas: vec![0; places.len()], last: [places.clone(), places] };
        let marks = tracker.matched(first)?;
        tracker.areas = marks.iter().map(|mark| mark.area).collect();
        tracker.last = [places_of(&marks), places_of(&marks)];
        Ok(tracker)
    }

    /// Places of the marks in the last picture, to the right and down \[pixels\].
    pub fn places(&self) -> &[[f64; 2]] {
        &self.last[1]
    }

    /// Finds them in the next picture.
    ///
    /// # Errors
    /// A mark that is missing, merged or cut off; a picture of another size.
    pub fn follow(&mut self, image: &Grey) -> Result<&[[f64; 2]], Lost> {
        let marks = self.matched(image)?;
        self.last.swap(0, 1);
        self.last[1] = places_of(&marks);
        Ok(self.places())
    }

    fn matched(&self, image: &Grey) -> Result<Vec<Mark>, Lost> {
        let found = [image.width, image.height];
        if found != self.size {
            return Err(Lost::Size { found, first: self.size });
        }
        let all = self.finder.find(image);
        let mut taken: Vec<Option<usize>> = vec![None; all.len()];
        let mut marks = Vec::with_capacity(self.bodies.len());
        for number in 0..self.bodies.len() {
            let [before, last] = [self.last[0][number], self.last[1][number]];
            let near = [0, 1].map(|axis| 2.0 * last[axis] - before[axis]);
            let (own, mark) = self.nearest(&all, near, number)?;
            if let Some(other) = taken[own].replace(number) {
                return Err(Lost::Merged { marks: [other + 1, number + 1], at: mark.at });
            }
            marks.push(mark);
        }
        marks.iter().enumerate().try_for_each(|(number, mark)| self.whole(number, *mark))?;
        Ok(marks)
    }

    fn nearest(&self, all: &[Mark], near: [f64; 2], number: usize) -> Result<(usize, Mark), Lost> {
        let distance = |(_, mark): &(usize, &Mark)| apart(mark.at, near);
        let best = all.iter().enumerate().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let best = best.filter(|best| distance(best) <= self.within).map(|(own, mark)| (own, *mark));
        let body = self.bodies[number].clone();
        best.ok_or(Lost::Missing { mark: number + 1, body, near, within: self.within })
    }

    fn whole(&self, number: usize, Mark { at, area, at_edge }: Mark) -> Result<(), Lost> {
        let (mark, body, first) = (number + 1, self.bodies[number].clone(), self.areas[number]);
        match () {
            () if at_edge => Err(Lost::AtEdge { mark, body, at }),
            () if first > 0 && exceed(area, first) => Err(Lost::Grown { mark, body, at, area, first }),
            () if exceed(first, area) => Err(Lost::Shrunk { mark, body, at, area, first }),
            () => Ok(()),
        }
    }
}

fn places_of(marks: &[Mark]) -> Vec<[f64; 2]> {
    marks.iter().map(|mark| mark.at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(marks: &[[f64; 2]]) -> Grey {
        let (width, height) = (120, 60);
        let bright = |n: usize| {
            let at = [(n % width) as f64 + 0.5, (n / width) as f64 + 0.5];
            marks.iter().any(|mark| apart(*mark, at) < 3.0)
        };
        Grey { width, height, values: (0..width * height).map(|n| if bright(n) { 200.0 } else { 20.0 }).collect() }
    }

    fn started() -> Tracker {
        let layout = Layout::unknown(30.0, None, [[20.0, 30.0], [60.0, 30.0]].into_iter());
        Tracker::start(&layout, Finder { threshold: 100.0, least: 5 }, &image(&[[21.0, 31.0], [60.0, 30.0]]))
            .expect("both are there")
    }

    #[test]
    fn marks_keep_their_numbers_while_they_move() {
        let mut tracker = started();
        for n in 1..6 {
            let x = 12.0 * f64::from(n);
            // The first overtakes nothing: both move, faster than half their distance over several pictures.
            let places = tracker.follow(&image(&[[60.0 + 9.0 * f64::from(n), 30.0], [21.0 + x * 0.5, 31.0]]));
            let places = places.expect("both");
            assert!(places[0][0] < places[1][0], "picture {n}: {places:?}");
        }
    }

    #[test]
    fn marks_of_two_and_three_pixels_are_followed_from_anywhere_to_anywhere() {
        for diameter in [2.0, 3.0] {
            let picture = |at: [f64; 2]| {
                let mut picture = image(&[]);
                for (n, value) in picture.values.iter_mut().enumerate() {
                    let pixel = [(n % 120) as f64 + 0.5, (n / 120) as f64 + 0.5];
                    *value = if apart(at, pixel) < 0.5 * diameter { 200.0 } else { 20.0 };
                }
                picture
            };
            let places =
                (0..10).flat_map(|i| (0..10).map(move |j| [20.0 + 0.1 * f64::from(i), 30.0 + 0.1 * f64::from(j)]));
            let places: Vec<[f64; 2]> = places.collect();
            for first in &places {
                let layout = Layout::unknown(30.0, None, [*first].into_iter());
                let mut tracker =
                    Tracker::start(&layout, Finder { threshold: 100.0, least: 1 }, &picture(*first)).expect("there");
                for next in &places {
                    tracker
                        .follow(&picture(*next))
                        .unwrap_or_else(|lost| panic!("{diameter}, {first:?}, {next:?}: {lost}"));
                }
            }
        }
    }

    #[test]
    fn what_is_lost_is_told() {
        let said = |marks: &[[f64; 2]]| started().follow(&image(marks)).expect_err("lost").to_string();
        assert!(said(&[[21.0, 31.0]]).contains("mark 2 (marks) is missing"), "{}", said(&[[21.0, 31.0]]));
        let merged = [[38.5, 30.5], [42.5, 30.5]];
        assert!(said(&merged).contains("marks 1 and 2 are merged"), "{}", said(&merged));
        let grown = [[21.0, 31.0], [60.0, 30.0], [62.0, 34.0], [58.0, 34.0]];
        assert!(said(&grown).contains("mark 2 (marks) has run together"), "{}", said(&grown));
        // Half of the second one is left.
        let mut covered = image(&[[21.0, 31.0], [60.0, 30.0]]);
        (0..60).for_each(|y| covered.values[y * 120 + 60..y * 120 + 70].fill(20.0));
        let covered = started().follow(&covered).expect_err("covered").to_string();
        assert!(covered.contains("mark 2 (marks) is partly covered"), "{covered}");
        let edge = [[21.0, 31.0], [60.0, 30.0]];
        let mut tracker = started();
        tracker.last = [vec![[3.0, 30.0], [60.0, 30.0]], vec![[3.0, 30.0], [60.0, 30.0]]];
        let cut = tracker.follow(&image(&[[2.0, 30.0], [60.0, 30.0]])).expect_err("cut off").to_string();
        assert!(cut.contains("edge of the picture"), "{cut}");
        let mut small = image(&edge);
        (small.width, small.height) = (60, 120);
        assert!(started().follow(&small).expect_err("another size").to_string().contains("60 × 120"), "size");
    }
}
