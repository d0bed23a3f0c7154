//! `summary.json`, and the same facts for whoever prints them: headline numbers, ledger, error, versions.

use glam::DVec3;
use serde::Serialize;

use super::events::law_of;
use super::{TableOptions, sample_times};
use crate::geometry::{End, Prism};
use crate::scene::Kind;
use crate::sim::{History, Ledger, Stop, Summary};

/// Everything a summary says, SI.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The scene's name.
    pub scene: String,
    /// Planar or spatial.
    pub kind: Kind,
    /// Which model computed it, `contact` or `impact`.
    pub model: &'static str,
    /// What was asked for \[s\].
    pub duration: f64,
    /// How far the answer reaches \[s\].
    pub end: f64,
    /// Why it ends before `duration`, if it does.
    pub gave_up: Option<Stop>,
    /// The headline numbers.
    #[serde(flatten)]
    pub numbers: Summary,
    /// Facing pairs and the law each used.
    pub pairs: Vec<PairReport>,
    /// What remains of the seats that the scene gives.
    pub seats: Vec<SeatReport>,
    /// Local error per step that was asked for.
    pub tolerance: f64,
    /// Largest displacement difference from a run at a hundredth of the tolerance, when asked for \[m\].
    pub estimated_error: Option<f64>,
    /// The energy ledger at the end \[J\].
    pub ledger: Ledger,
    /// Hash of the whole answer, bit for bit.
    pub digest: String,
    /// Time to compute it, when timed \[s\].
    pub run_time: Option<f64>,
    /// How many times faster than real time, when timed.
    pub times_real_time: Option<f64>,
    /// What computed it.
    pub versions: Versions,
}

/// A facing pair in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PairReport {
    /// `deck+x|wall`.
    pub name: String,
    /// The friction law that it used.
    pub law: &'static str,
    /// Touches of its contacts.
    pub touches: usize,
    /// Largest force of one contact \[N\].
    pub peak_force: f64,
}

/// A seat in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SeatReport {
    /// The girder.
    pub girder: String,
    /// Its end, `+x` or `-x`.
    pub end: &'static str,
    /// Length of the seat under it \[m\].
    pub length: f64,
    /// The least that remained of it at a sample or an event; negative when the end came off \[m\].
    pub least_remaining: f64,
    /// When \[s\].
    pub t: f64,
    /// When the end came off for the first time, to a part in a thousand million of the run; `None` where it stayed \[s\].
    pub left_at: Option<f64>,
}

/// Versions that an answer depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Versions {
    /// This program.
    pub girderbench: &'static str,
    /// The scene format.
    pub scene_format: u32,
}

impl Report {
    /// Gathers the facts of an answer.
    pub fn of(history: &History, options: &TableOptions) -> Self {
        let scene = history.scene();
        Self {
            scene: scene.name.clone(),
            kind: scene.kind,
            model: if history.impact().is_some() { "impact" } else { "contact" },
            duration: scene.duration,
            end: history.end(),
            gave_up: history.stop().cloned(),
            numbers: history.summary(),
            pairs: pairs(history),
            seats: seats(history, options.sample_hz),
            tolerance: scene.solver.tolerance,
            estimated_error: options.estimated_error,
            ledger: history.ledger(history.end()),
            digest: format!("{:016x}", history.digest()),
            run_time: options.run_time,
            times_real_time: options.run_time.filter(|&s| s > 0.0).map(|s| history.end() / s),
            versions: Versions { girderbench: env!("CARGO_PKG_VERSION"), scene_format: scene.format },
        }
    }

    /// The file's bytes. A number that is not finite is written as `null`, −0 as 0.
    pub fn to_json(&self) -> Vec<u8> {
        // Plain structs with string keys always serialise.
        let mut text = serde_json::to_string_pretty(self).unwrap_or_default();
        text.push('\n');
        // One value a line, and a line within a text is written as `\n`: only numbers end a line like this.
        text.replace(" -0.0,\n", " 0.0,\n").replace(" -0.0\n", " 0.0\n").into_bytes()
    }
}

fn pairs(history: &History) -> Vec<PairReport> {
    let of_pair = |(number, pair): (usize, &crate::dynamics::Pair)| {
        let touches: Vec<_> = history.touches().iter().filter(|touch| touch.pair == number).collect();
        PairReport {
            name: pair.name.clone(),
            law: law_of(history, number),
            touches: touches.len(),
            peak_force: touches.iter().map(|touch| touch.peak_force).fold(0.0, f64::max),
        }
    };
    history.model().pairs.iter().enumerate().map(of_pair).collect()
}

fn seats(history: &History, sample_hz: f64) -> Vec<SeatReport> {
    let girders = history.scene().girders.iter().enumerate();
    girders
        .flat_map(|(number, girder)| {
            let ends = [(End::Plus, girder.seat.plus), (End::Minus, girder.seat.minus)];
            ends.into_iter().filter_map(move |(end, length)| Some((number, girder, end, length?)))
        })
        .map(|(number, girder, end, length)| {
            let (t, moved) = farthest_off(history, number, end, sample_hz);
            let left_at = (moved > length).then(|| first_off(history, number, end, length, sample_hz)).flatten();
            let least_remaining = length - moved;
            SeatReport { girder: girder.name.clone(), end: end.label(), length, least_remaining, t, left_at }
        })
        .collect()
}

/// When an end has moved farthest off its seat, and by how much: the corner at the underside that moved most towards
/// the girder's middle, along the axis as placed \[s, m\].
fn farthest_off(history: &History, girder: usize, end: End, sample_hz: f64) -> (f64, f64) {
    let mut farthest = (0.0, f64::NEG_INFINITY);
    for t in looks(history, sample_hz) {
        let moved = off_seat(history, girder, end, t);
        if moved > farthest.1 {
            farthest = (t, moved);
        }
    }
    farthest
}

/// When an end first came off a seat of this length: between the two looks that see it on and off, by bisection \[s\].
fn first_off(history: &History, girder: usize, end: End, length: f64, sample_hz: f64) -> Option<f64> {
    let off = |t: f64| off_seat(history, girder, end, t) > length;
    let mut looks: Vec<f64> = looks(history, sample_hz).collect();
    looks.sort_by(f64::total_cmp);
    let seen = looks.iter().position(|&t| off(t))?;
    let (mut on, mut gone) = (looks[seen.saturating_sub(1)], looks[seen]);
    while gone - on > 1e-9 * history.end() {
        let middle = f64::midpoint(on, gone);
        if off(middle) {
            gone = middle;
        } else {
            on = middle;
        }
    }
    Some(gone)
}

/// The instants at which seats are looked at: samples, then events \[s\].
fn looks(history: &History, sample_hz: f64) -> impl Iterator<Item = f64> {
    sample_times(history.end(), sample_hz).chain(history.events().iter().map(|event| event.t))
}

fn off_seat(history: &History, girder: usize, end: End, t: f64) -> f64 {
    let body = &history.model().bodies[girder];
    let motion = history.motion(girder, t);
    let corners = body.prism.corners();
    let inwards = -body.axes.x_axis * end.sign();
    let moved = |corner: DVec3| (motion.place + motion.attitude * corner - body.home - body.axes * corner).dot(inwards);
    Prism::end_corners(end).map(|number| moved(corners[number])).into_iter().fold(f64::NEG_INFINITY, f64::max)
}
