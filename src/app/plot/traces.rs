//! Curves for the plots: only what can be seen is sampled, and no force peak is lost.
//!
//! About two samples a pixel are taken of the motion, more where it is faster, and then the lowest and the highest of each pixel are
//! drawn ([`resolution`]). The force of a touch of 10 ms would fall between them, so every
//! touch in the window adds its start, its end and its peak; where there are more touches than pixels, the highest of
//! each pixel stands for the rest.
//!
//! Of a crowd of girders no single curve can be told from the others: there the room that they all fill is shown instead,
//! and of all pairs' forces the largest, so that a frame costs as much for a hundred as for eight.

use std::sync::Arc;

use crate::app::plot::resolution::{self, Curve};
use crate::app::run::answer::Answer;
use crate::app::run::comparison::Pin;
use crate::sim::{History, Pounding, PoundingHit};

/// Most motions that are computed for the curves of one window, which a frame waits for. Chosen, not measured.
const MOST_MOTIONS: usize = 200_000;

/// More girders, or pairs of bodies that hit, than this are a crowd.
pub(in crate::app) const CROWD: usize = 8;

/// The room that many curves fill, time by time.
#[derive(Clone, Debug, Default)]
pub(in crate::app) struct Band {
    /// Times \[s\].
    pub(in crate::app) times: Vec<f64>,
    /// Lowest values.
    pub(in crate::app) low: Vec<f64>,
    /// Highest values.
    pub(in crate::app) high: Vec<f64>,
}

impl Band {
    /// Of curves that were sampled at the same times.
    fn of(curves: &[Curve]) -> Self {
        let times = curves.first().into_iter().flatten().map(|p| p[0]).collect();
        let among = |i: usize, pick: fn(f64, f64) -> f64| {
            curves.iter().filter_map(|c| c.get(i)).map(|p| p[1]).reduce(pick).unwrap_or_default()
        };
        let count = curves.first().map_or(0, Vec::len);
        let all = |pick: fn(f64, f64) -> f64| (0..count).map(|i| among(i, pick)).collect();
        Self { times, low: all(f64::min), high: all(f64::max) }
    }

    /// With at most one time a column: the lowest and the highest of the column.
    fn by_columns(self, [from, to]: [f64; 2], columns: usize) -> Self {
        if self.times.len() <= 2 * columns {
            return self;
        }
        let per_column = (to - from) / columns as f64;
        let mut drawn = Self::default();
        let mut until = f64::NEG_INFINITY;
        for ((t, low), high) in self.times.into_iter().zip(self.low).zip(self.high) {
            if t >= until {
                drawn.times.push(t);
                drawn.low.push(low);
                drawn.high.push(high);
                until = t + per_column;
            } else if let (Some(lowest), Some(highest)) = (drawn.low.last_mut(), drawn.high.last_mut()) {
                (*lowest, *highest) = (lowest.min(low), highest.max(high));
            }
        }
        drawn
    }
}

/// A girder in a run that is kept.
#[derive(Clone, Debug)]
pub(in crate::app) struct Kept {
    /// x, y \[mm\] and θ \[°\], or this run's less these.
    pub(in crate::app) curves: [Curve; 3],
    /// The run's colour.
    pub(in crate::app) color: usize,
    /// The girder's number there.
    pub(in crate::app) girder: usize,
    /// |Force| between two bodies there, as of the run shown \[N\].
    pub(in crate::app) force: Vec<Curve>,
}

/// Samples for one window of time.
#[derive(Clone, Debug, Default)]
pub(in crate::app) struct Traces {
    /// Displacement of G along world x, per girder \[mm\].
    pub(in crate::app) x: Vec<Curve>,
    /// Displacement of G along world y, per girder \[mm\].
    pub(in crate::app) y: Vec<Curve>,
    /// Rotation, per girder \[degrees\].
    pub(in crate::app) theta: Vec<Curve>,
    /// x, y and θ by the other model, where there is one.
    pub(in crate::app) ghosts: [Vec<Curve>; 3],
    /// One girder in every run that is kept.
    pub(in crate::app) pins: Vec<Kept>,
    /// Whether those are by how much this run differs.
    pub(in crate::app) differences: bool,
    /// |Force| between two bodies, all their contacts together, hit by hit of every two, or the largest of all \[N\].
    pub(in crate::app) force: Vec<Curve>,
    /// Whether the motion is faster than columns of the picture can show: a curve is the band that it fills.
    pub(in crate::app) dense: bool,
    /// Bands of x, y and θ of a crowd.
    pub(in crate::app) bands: Option<[Band; 3]>,
}

/// Inputs that a [`Traces`] was sampled for.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    answer: u64,
    window: [f64; 2],
    points: usize,
    girder: String,
    pins: Vec<u64>,
    differences: bool,
}

/// Keeps the last samples until something else is to be seen.
#[derive(Default)]
pub(in crate::app) struct TraceCache {
    key: Option<Key>,
    traces: Arc<Traces>,
}

impl TraceCache {
    /// The curves of a window, about `points` samples long; of kept runs, those of the girder of this name, or the differences from
    /// them.
    pub(in crate::app) fn of(
        &mut self,
        answer: &Answer,
        window: [f64; 2],
        points: usize,
        (girder, pins, differences): (&str, &[Pin], bool),
    ) -> Arc<Traces> {
        let numbers = pins.iter().map(|p| p.answer.number).collect();
        let key = Key { answer: answer.number, window, points, girder: girder.to_owned(), pins: numbers, differences };
        if self.key.as_ref() != Some(&key) {
            let mut traces = sample(answer, window, points.max(2));
            let less = differences.then_some(answer);
            traces.pins = pins.iter().filter_map(|p| kept(p, girder, (window, points.max(2)), less)).collect();
            traces.differences = differences;
            self.traces = Arc::new(traces);
            self.key = Some(key);
        }
        self.traces.clone()
    }
}

/// Curves of the girder of this name in a kept run; by how much `less` differs from them, where it is given.
fn kept(pin: &Pin, girder: &str, (window, points): ([f64; 2], usize), less: Option<&Answer>) -> Option<Kept> {
    let named = |history: &History| history.scene().girders.iter().position(|g| g.name == girder);
    let history = &pin.answer.history;
    let number = named(history)?;
    let now = less.and_then(|answer| Some((&answer.history, named(&answer.history)?)));
    let values = |history: &History, number: usize, t: f64| {
        let motion = history.motion(number, t);
        [motion.displacement.x * 1e3, motion.displacement.y * 1e3, motion.theta.to_degrees()]
    };
    let end = now.map_or(history.end(), |(now, _)| now.end().min(history.end()));
    let values = |t: f64| {
        let there = values(history, number, t);
        now.map_or(there, |(now, own)| {
            let here = values(now, own, t);
            [0, 1, 2].map(|n| here[n] - there[n])
        })
    };
    let shown = [window[0], window[1].min(end)];
    let fine = 1 + (points - 1) * resolution::parts(shown, points - 1, MOST_MOTIONS, |t| values(t).to_vec());
    let mut curves = [(); 3].map(|()| Vec::with_capacity(fine));
    for t in grid(window, fine, end) {
        for (curve, value) in curves.iter_mut().zip(values(t)) {
            curve.push([t, value]);
        }
    }
    let curves = curves.map(|curve| resolution::by_columns(curve, window, points));
    Some(Kept { curves, color: pin.color, girder: number, force: forces(history, window, points) })
}

fn sample(answer: &Answer, window: [f64; 2], points: usize) -> Traces {
    let history = &answer.history;
    let girders = history.model().girders().len();
    let mut traces = Traces {
        x: vec![Vec::with_capacity(points); girders],
        y: vec![Vec::with_capacity(points); girders],
        theta: vec![Vec::with_capacity(points); girders],
        ghosts: [(); 3].map(|()| vec![Vec::new(); if history.beside().is_some() { girders } else { 0 }]),
        pins: Vec::new(),
        differences: false,
        force: Vec::new(),
        dense: false,
        bands: None,
    };
    let values = |history: &History, girder: usize, t: f64| {
        let motion = history.motion(girder, t);
        [motion.displacement.x * 1e3, motion.displacement.y * 1e3, motion.theta.to_degrees()]
    };
    let shown = [window[0], window[1].min(history.end())];
    let all = |t: f64| (0..girders).flat_map(|girder| values(history, girder, t)).collect();
    let parts = resolution::parts(shown, points - 1, MOST_MOTIONS / girders.max(1), all);
    // Four samples a point: half a period is narrower than three of them.
    traces.dense = parts > 2;
    let fine = 1 + (points - 1) * parts;
    for t in grid(window, fine, history.end()) {
        for girder in 0..girders {
            let own = [&mut traces.x, &mut traces.y, &mut traces.theta];
            for (curves, value) in own.into_iter().zip(values(history, girder, t)) {
                curves[girder].push([t, value]);
            }
            let Some(beside) = history.beside() else { continue };
            for (curves, value) in traces.ghosts.iter_mut().zip(values(beside, girder, t)) {
                curves[girder].push([t, value]);
            }
        }
    }
    traces.bands = (girders > CROWD)
        .then(|| [&traces.x, &traces.y, &traces.theta].map(|curves| Band::of(curves).by_columns(window, points)));
    let [one, two, three] = &mut traces.ghosts;
    for curves in [&mut traces.x, &mut traces.y, &mut traces.theta, one, two, three] {
        for curve in curves {
            *curve = resolution::by_columns(std::mem::take(curve), window, points);
        }
    }
    traces.force = forces(history, window, points);
    traces
}

/// |Force| between two bodies, hit by hit of every two, or of a crowd the largest \[N\].
fn forces(history: &History, window: [f64; 2], points: usize) -> Vec<Curve> {
    let poundings = history.hits().poundings();
    let all: Vec<Curve> = poundings.iter().flat_map(|between| force(history, between, window, points)).collect();
    if poundings.len() > CROWD { vec![largest(&all, window, points)] } else { all }
}

/// One curve for many: the largest value within every point, and 0 between.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a column, inside the window")]
fn largest(curves: &[Curve], window: [f64; 2], points: usize) -> Curve {
    let per_point = (window[1] - window[0]) / points as f64;
    let mut columns: Vec<Option<[f64; 2]>> = vec![None; points + 1];
    for p in curves.iter().flatten().filter(|p| p[1] > 0.0 && p[0] >= window[0]) {
        let Some(column) = columns.get_mut(((p[0] - window[0]) / per_point) as usize) else { continue };
        if column.is_none_or(|highest| p[1] > highest[1]) {
            *column = Some(*p);
        }
    }
    let mut curve = Curve::new();
    for (i, column) in columns.iter().enumerate() {
        let Some([t, value]) = *column else { continue };
        let open = |at: Option<usize>| at.and_then(|at| columns.get(at)).is_none_or(Option::is_none);
        curve.extend(open(i.checked_sub(1)).then_some([t, 0.0]));
        curve.push([t, value]);
        curve.extend(open(Some(i + 1)).then_some([t, 0.0]));
    }
    curve
}

/// Evenly spaced times in a window, both ends included, not past the end of the answer.
fn grid(window: [f64; 2], points: usize, end: f64) -> impl Iterator<Item = f64> {
    let step = (window[1] - window[0]) / (points - 1) as f64;
    (0..points).map(move |i| window[0] + step * i as f64).filter(move |&t| t <= end * (1.0 + 1e-12))
}

/// One curve for every hit of two bodies that can be told apart: a spike as high as its peak, or its shape.
fn force(history: &History, between: &Pounding, window: [f64; 2], points: usize) -> Vec<Curve> {
    let per_point = (window[1] - window[0]) / points as f64;
    let seen = between.hits.iter().filter(|hit| hit.start <= window[1] && hit.end >= window[0]);
    let curve = |hit: PoundingHit| {
        if hit.end - hit.start < 4.0 * per_point {
            vec![[hit.peak.t, 0.0], [hit.peak.t, hit.peak.value]]
        } else {
            shape((history, between.pair), &hit, window, per_point)
        }
    };
    highest(seen.copied(), per_point).into_iter().map(curve).collect()
}

/// Of the hits that end within one point of each other, keeps the highest.
fn highest(hits: impl Iterator<Item = PoundingHit>, per_point: f64) -> Vec<PoundingHit> {
    let mut kept: Vec<PoundingHit> = Vec::new();
    for hit in hits {
        match kept.last_mut() {
            Some(last) if hit.end - last.start < per_point => {
                if hit.peak.value > last.peak.value {
                    *last = hit;
                }
            }
            _ => kept.push(hit),
        }
    }
    kept
}

/// Samples a hit that is wide enough to be seen, its peak among the samples.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count of samples, clamped")]
fn shape((history, pair): (&History, usize), hit: &PoundingHit, window: [f64; 2], per_point: f64) -> Curve {
    let (from, to) = (hit.start.max(window[0]), hit.end.min(window[1]));
    let n = ((to - from) / per_point).ceil().clamp(4.0, 8000.0) as usize;
    let mut times: Vec<f64> = (0..=n).map(|i| from + (to - from) * i as f64 / n as f64).collect();
    times.extend(Some(hit.peak.t).filter(|&t| t > from && t < to));
    times.sort_by(f64::total_cmp);
    times.into_iter().map(|t| [t, history.hits().resultant(pair, t).length()]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sim::readings::Extreme;

    fn hit(start: f64, end: f64, peak: f64) -> PoundingHit {
        PoundingHit { start, end, peak: Extreme { value: peak, t: start.midpoint(end) } }
    }

    #[test]
    fn no_peak_is_lost_where_hits_share_a_point() {
        let hits = [hit(1.0, 1.01, 5.0), hit(1.02, 1.03, 50.0), hit(1.04, 1.05, 7.0), hit(3.0, 3.01, 2.0)];
        let peaks: Vec<f64> = highest(hits.into_iter(), 0.1).iter().map(|hit| hit.peak.value).collect();
        assert_eq!(peaks, vec![50.0, 2.0], "the highest of the first three, and the last");
    }

    #[test]
    fn a_band_holds_every_curve_and_touches_some() {
        let band = Band::of(&[vec![[0.0, 1.0], [1.0, -2.0]], vec![[0.0, -1.0], [1.0, 3.0]]]);
        assert_eq!(
            (band.times, band.low, band.high),
            (vec![0.0, 1.0], vec![-1.0, -2.0], vec![1.0, 3.0]),
            "time by time"
        );
    }

    #[test]
    fn of_many_forces_the_largest_is_left_with_gaps_where_nothing_touches() {
        let spike = |t: f64, force: f64| vec![[t, 0.0], [t, force]];
        let curve = largest(&[spike(1.01, 5.0), spike(1.02, 9.0), spike(3.0, 2.0)], [0.0, 10.0], 100);
        let wanted = [[1.02, 0.0], [1.02, 9.0], [1.02, 0.0], [3.0, 0.0], [3.0, 2.0], [3.0, 0.0]];
        assert_eq!(curve, wanted, "the higher of two in one point, and the other one, each from 0");
    }
}
