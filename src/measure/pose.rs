//! Places and rotations of bodies from their marks.
//!
//! Pictures are plane and to scale. A place in a picture, x to the right and y up, is a complex number z; the table's marks of known
//! place w give `w = a z + b` by least squares in the first picture: a is the scale and the turn of the camera. Then every picture
//! is moved so that the mean of the table's marks stands still. The marks of a body at places c on it lie at
//! `w = e^{iθ} c + p`: θ and p of least squares, `e^{iθ} ∝ Σ (w − w̄) conj(c − c̄)`.

use num_complex::Complex64;

use super::layout::{Layout, TABLE};
use crate::language::Text;

/// Scale and turn of a film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    /// Millimetres a pixel, turned by the camera.
    factor: Complex64,
}

/// A body in a picture, since the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Displacement of the point that places on the body are counted from, or of the middle of its marks \[mm\].
    pub displacement: [f64; 2],
    /// Rotation, anticlockwise; none of a body with a single mark \[rad\].
    pub rotation: Option<f64>,
}

fn mean(all: &[Complex64]) -> Complex64 {
    all.iter().sum::<Complex64>() / (all.len().max(1) as f64)
}

fn complex([x, y]: [f64; 2]) -> Complex64 {
    Complex64::new(x, y)
}

/// `Σ (to − t̄o) conj(from − f̄rom)`.
fn turn(from: &[Complex64], to: &[Complex64]) -> Complex64 {
    let [f, t] = [mean(from), mean(to)];
    from.iter().zip(to).map(|(from, to)| (to - t) * (from - f).conj()).sum()
}

impl Calibration {
    /// From the first picture: by the layout's scale, else by marks of known place on the table, else by those on the first
    /// body that has two.
    ///
    /// # Errors
    ///
    /// Without anything that gives a scale.
    pub fn of(layout: &Layout, places: &[[f64; 2]]) -> Result<Self, String> {
        let bodies = std::iter::once(TABLE).chain(layout.bodies());
        let known = bodies.filter_map(|body| {
            let marks = layout.of(body);
            let at: Vec<Complex64> = marks.iter().filter_map(|n| layout.mark[*n].at_mm.map(complex)).collect();
            let seen: Vec<Complex64> = marks.iter().map(|n| upright(places[*n])).collect();
            let spread: f64 = seen.iter().map(|z| (z - mean(&seen)).norm_sqr()).sum();
            (at.len() == marks.len() && marks.len() > 1 && spread > 0.0).then(|| turn(&seen, &at) / spread)
        });
        let known = known.into_iter().find(|factor| factor.norm() > 0.0);
        match (layout.mm_per_pixel, known) {
            // A stated scale is kept, and the turn of the camera from the marks, if they show it.
            (Some(scale), Some(factor)) => Ok(Self { factor: factor * (scale / factor.norm()) }),
            (Some(scale), None) => Ok(Self { factor: scale.into() }),
            (None, Some(factor)) => Ok(Self { factor }),
            (None, None) => Err(Text::new("layout-no-scale").into()),
        }
    }

    /// Length of a pixel \[mm\].
    pub fn mm_per_pixel(&self) -> f64 {
        self.factor.norm()
    }
}

/// A place in a picture with y up.
fn upright([x, y]: [f64; 2]) -> Complex64 {
    Complex64::new(x, -y)
}

/// Bodies of a film.
#[derive(Clone, Debug)]
pub struct Poses {
    calibration: Calibration,
    table: Vec<usize>,
    bodies: Vec<Body>,
}

#[derive(Clone, Debug)]
struct Body {
    marks: Vec<usize>,
    /// Places on the body \[mm\].
    at: Vec<Complex64>,
    /// Place and rotation in the first picture, rotation in the last \[mm, rad\].
    first: (Complex64, f64),
    last: f64,
}

impl Poses {
    /// From the first picture.
    pub fn start(layout: &Layout, calibration: Calibration, places: &[[f64; 2]]) -> Self {
        let table = layout.of(TABLE);
        let mut poses = Self { calibration, table, bodies: Vec::new() };
        let seen = poses.on_table(places);
        for name in layout.bodies() {
            let marks = layout.of(name);
            let at: Option<Vec<Complex64>> = marks.iter().map(|n| layout.mark[*n].at_mm.map(complex)).collect();
            let here: Vec<Complex64> = marks.iter().map(|n| seen[*n]).collect();
            let at = at.unwrap_or_else(|| here.iter().map(|w| w - mean(&here)).collect());
            let mut body = Body { marks, at, first: (Complex64::ZERO, 0.0), last: 0.0 };
            let (place, rotation) = body.fit(&seen);
            (body.first, body.last) = ((place, rotation), rotation);
            poses.bodies.push(body);
        }
        poses
    }

    /// Places of all marks, with the mean of the table's as origin \[mm\].
    fn on_table(&self, places: &[[f64; 2]]) -> Vec<Complex64> {
        let all: Vec<Complex64> = places.iter().map(|place| self.calibration.factor * upright(*place)).collect();
        let table: Vec<Complex64> = self.table.iter().map(|n| all[*n]).collect();
        let origin = mean(&table);
        all.iter().map(|w| w - origin).collect()
    }

    /// Each body in a picture.
    pub fn of(&mut self, places: &[[f64; 2]]) -> Vec<Pose> {
        let seen = self.on_table(places);
        self.bodies.iter_mut().map(|body| body.pose(&seen)).collect()
    }
}

impl Body {
    /// Place of its origin and rotation.
    fn fit(&self, seen: &[Complex64]) -> (Complex64, f64) {
        let here: Vec<Complex64> = self.marks.iter().map(|n| seen[*n]).collect();
        let turned = turn(&self.at, &here);
        let rotation = if turned.norm() > 0.0 { turned.arg() } else { 0.0 };
        (mean(&here) - Complex64::from_polar(1.0, rotation) * mean(&self.at), rotation)
    }

    fn pose(&mut self, seen: &[Complex64]) -> Pose {
        let (place, rotation) = self.fit(seen);
        // Continued beyond half a turn.
        let turns = ((self.last - rotation) / std::f64::consts::TAU).round();
        self.last = rotation + turns * std::f64::consts::TAU;
        let moved = place - self.first.0;
        let rotation = (self.marks.len() > 1).then_some(self.last - self.first.1);
        Pose { displacement: [moved.re, moved.im], rotation }
    }
}

#[cfg(test)]
mod tests {
    use super::super::layout::MarkPlace;
    use super::*;

    /// Marks of a table and a deck as a turned and shifted camera of 0.4 mm a pixel sees them, the deck at a pose.
    fn seen(deck: [f64; 3], shift: [f64; 2]) -> (Layout, Vec<[f64; 2]>) {
        let table = [[-80.0, -60.0], [80.0, -60.0]];
        let on_deck = [[-76.0, 0.0], [0.0, 0.0], [76.0, 0.0]];
        let camera = Complex64::from_polar(0.4, 0.05);
        let pixel = |w: Complex64| {
            let z = w / camera;
            [z.re + 360.0 + shift[0], 232.0 + shift[1] - z.im]
        };
        let moved = |c: [f64; 2]| Complex64::from_polar(1.0, deck[2]) * complex(c) + complex([deck[0], deck[1]]);
        let mark = |body: &str, at: [f64; 2]| MarkPlace { body: body.into(), pixel: [0.0; 2], at_mm: Some(at) };
        let all = table.map(|at| mark(TABLE, at)).into_iter().chain(on_deck.map(|at| mark("deck", at)));
        let layout = Layout { fps: 30.0, from_s: 0.0, pictures: None, mm_per_pixel: None, mark: all.collect() };
        let places = table.map(|at| pixel(complex(at))).into_iter().chain(on_deck.map(|at| pixel(moved(at))));
        (layout, places.collect())
    }

    #[test]
    fn a_moving_deck_is_measured_under_a_turned_and_shaken_camera() {
        let (layout, first) = seen([1.0, 2.0, 0.01], [0.0; 2]);
        let calibration = Calibration::of(&layout, &first).expect("marks of known place");
        assert!((calibration.mm_per_pixel() - 0.4).abs() < 1e-12, "{}", calibration.mm_per_pixel());
        let mut poses = Poses::start(&layout, calibration, &first);
        for n in 0..60 {
            // Through two turns and a half, with a camera that shakes.
            let pose = [1.0 + 0.5 * f64::from(n), 2.0 - 0.1 * f64::from(n), 0.01 + 0.26 * f64::from(n)];
            let found = poses.of(&seen(pose, [3.0 * f64::from(n % 3), -2.0]).1)[0];
            let rotation = found.rotation.expect("three marks");
            let off = [
                found.displacement[0] - (pose[0] - 1.0),
                found.displacement[1] - (pose[1] - 2.0),
                rotation - (pose[2] - 0.01),
            ];
            assert!(off.iter().all(|off| off.abs() < 1e-9), "{n}: {off:?}");
        }
    }

    #[test]
    fn scales_come_from_the_layout_or_from_a_body_or_are_missing() {
        let (mut layout, first) = seen([0.0; 3], [0.0; 2]);
        layout.mm_per_pixel = Some(0.5);
        assert!((Calibration::of(&layout, &first).expect("stated").mm_per_pixel() - 0.5).abs() < 1e-12, "stated");
        layout.mm_per_pixel = None;
        (layout.mark[0].at_mm, layout.mark[1].at_mm) = (None, None);
        assert!(
            (Calibration::of(&layout, &first).expect("the deck").mm_per_pixel() - 0.4).abs() < 1e-12,
            "of the deck"
        );
        layout.mark.iter_mut().for_each(|mark| mark.at_mm = None);
        assert!(Calibration::of(&layout, &first).expect_err("nothing").contains("no scale"), "nothing gives one");
    }
}
