//! Results of a method at the instants of comparison, and the distance between two results.

use crate::sim::History;

/// Equal intervals that a run is compared at.
pub const INTERVALS: usize = 2000;

/// The instants of comparison: 0, and the ends of [`INTERVALS`] equal intervals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instants {
    /// The last \[s\].
    pub until: f64,
}

impl Instants {
    /// Instant number `i` \[s\].
    pub fn at(&self, i: usize) -> f64 {
        self.until * i as f64 / INTERVALS as f64
    }

    /// All of them.
    pub fn all(self) -> impl Iterator<Item = f64> {
        (0..=INTERVALS).map(move |i| self.at(i))
    }
}

/// Position of a body at one instant: displacement x, y, z \[m\] and rotation about the vertical \[rad\].
pub type Place = [f64; 4];

/// A run as a method sees it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// Places of all bodies, instant by instant.
    pub places: Vec<Place>,
    /// Bodies.
    pub bodies: usize,
    /// Largest force of a contact on its node \[N\].
    pub peak_force: f64,
    /// Steps taken; 0 where the method does not count them.
    pub steps: usize,
    /// Note on the run.
    pub note: String,
}

/// Errors of an answer against the reference, up to the instant where the comparison ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Largest difference in displacement \[m\].
    pub displacement: f64,
    /// Largest difference in rotation \[rad\].
    pub rotation: f64,
    /// Difference in the peak force, relative; 0 where nothing touches.
    pub peak_force: f64,
}

impl Answer {
    /// A history, asked at the instants.
    pub fn of(history: &History, instants: Instants) -> Self {
        let bodies = history.model().bodies.len();
        let place = |t: f64, body: usize| {
            let motion = history.motion(body, t);
            let d = motion.displacement;
            [d.x, d.y, d.z, motion.theta]
        };
        Self {
            places: instants.all().flat_map(|t| (0..bodies).map(move |body| place(t, body))).collect(),
            bodies,
            peak_force: history.hits().hardest().map_or(0.0, |touch| touch.peak_force),
            steps: 0,
            note: history
                .stop()
                .map_or(String::new(), |stop| format!("stopped at {} s: {}", stop.t, stop.reason.english())),
        }
    }

    /// Largest differences in displacement and rotation at each instant.
    fn apart(&self, other: &Self) -> Vec<(f64, f64)> {
        let bodies = self.bodies.max(1);
        let of = |(a, b): (&Place, &Place)| {
            let d = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
            (d.iter().map(|x| x * x).sum::<f64>().sqrt(), (a[3] - b[3]).abs())
        };
        // A NaN must not vanish in a maximum.
        let larger = |m: f64, x: f64| if x > m || x.is_nan() { x } else { m };
        self.places
            .chunks(bodies)
            .zip(other.places.chunks(bodies))
            .map(|(a, b)| a.iter().zip(b).map(of).fold((0.0, 0.0), |m, x| (larger(m.0, x.0), larger(m.1, x.1))))
            .collect()
    }

    /// Differences from another answer up to instant number `last`.
    pub fn errors(&self, reference: &Self, last: usize) -> Errors {
        let larger = |m: f64, x: f64| if x > m || x.is_nan() { x } else { m };
        let (displacement, rotation) = self
            .apart(reference)
            .into_iter()
            .take(last + 1)
            .fold((0.0, 0.0), |m, x| (larger(m.0, x.0), larger(m.1, x.1)));
        let peak = (self.peak_force - reference.peak_force).abs();
        let peak_force = if reference.peak_force > 0.0 { peak / reference.peak_force } else { peak };
        Errors { displacement, rotation, peak_force }
    }

    /// Last instant up to which two answers are nowhere more than `limit` apart (m, or rad times `arm`).
    pub fn together_until(&self, other: &Self, limit: f64, arm: f64) -> usize {
        let parts = self.apart(other).iter().position(|(d, r)| d.is_nan() || r.is_nan() || d.max(arm * r) > limit);
        parts.map_or(INTERVALS, |i| i.saturating_sub(1))
    }

    /// Largest displacement from where a body was placed \[m\].
    pub fn largest(&self) -> f64 {
        self.places.iter().map(|p| p[0].hypot(p[1]).hypot(p[2])).fold(0.0, f64::max)
    }
}
