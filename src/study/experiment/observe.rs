//! Observations on a run as in the experiment: hits and their corners, states, extremes, histories.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use super::states::{Stretch, stretches};
use crate::sim::{History, Touch};

/// Instants a second at which extremes are looked for besides events \[Hz\]: at most a quarter of a millisecond from its peak a
/// displacement of the model girders has lost 50 m/s² · (0.25 ms)² / 2 = 2 µm.
const LOOKS_HZ: f64 = 2000.0;
/// Instants a second of a history as it is drawn; 20 a period of the sine.
pub(super) const DRAWN_HZ: f64 = 50.0;
/// Time of a frame of the paper's film (Table 1) \[s\].
pub const FRAME: f64 = 1.0 / 30.0;
/// Intervals of Simpson's rule over the force of a hit.
const INTERVALS: u32 = 48;

/// Observations on a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Observed {
    /// Time reached \[s\].
    pub end: f64,
    /// Reason of an early end.
    pub stopped: Option<String>,
    /// Hits, in order of time.
    pub hits: Vec<HitSeen>,
    /// The girders, in the order of the scene.
    pub girders: Vec<GirderSeen>,
}

/// A hit: from the first touch of a corner to the last parting, without a break.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct HitSeen {
    /// From \[s\].
    pub from: f64,
    /// Until; of an impulse the same instant \[s\].
    pub until: f64,
    /// First touch of a corner on the right (−y) and on the left (+y) of the axis \[s\].
    pub corners: [Option<f64>; 2],
    /// Change of the first girder's velocity by the contact within a frame of the film, `|Δv_x|` and `|Δv_y|` \[m/s\].
    pub jump: [f64; 2],
}

/// Observations on a girder.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct GirderSeen {
    /// Its name.
    pub name: String,
    /// Largest |x|, |y| of G \[m\] and |θ| \[rad\].
    pub largest: [f64; 3],
    /// Largest |θ| in the second half of the run, when the sudden start has died away \[rad\].
    pub late_rotation: f64,
    /// Largest `|v_x|`, `|v_y|` of G \[m/s\].
    pub fastest: [f64; 2],
    /// Its states, one after the other.
    pub states: Vec<Stretch>,
    /// x, y \[mm\] and θ \[degrees\] at `DRAWN_HZ`, rounded to what a picture shows.
    pub drawn: Vec<[f64; 3]>,
}

impl Observed {
    /// Of a run.
    pub fn of(history: &History) -> Self {
        Self {
            girders: (0..history.model().girders().len()).map(|girder| girder_seen(history, girder)).collect(),
            ..Self::without_histories(history)
        }
    }

    /// Hits and extremes of a run alone.
    pub fn without_histories(history: &History) -> Self {
        Self {
            end: history.end(),
            stopped: history.stop().map(|stop| format!("{}: {}", stop.place, stop.reason.english())),
            hits: hits(history),
            girders: (0..history.model().girders().len()).map(|girder| extremes(history, girder)).collect(),
        }
    }

    /// Largest |θ| of any girder \[rad\].
    pub fn rotation(&self) -> f64 {
        self.girders.iter().map(|girder| girder.largest[2]).fold(0.0, f64::max)
    }

    /// Largest |θ| of any girder in the second half of the run \[rad\].
    pub fn late_rotation(&self) -> f64 {
        self.girders.iter().map(|girder| girder.late_rotation).fold(0.0, f64::max)
    }
}

fn girder_seen(history: &History, girder: usize) -> GirderSeen {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count, of a minute at most")]
    let count = (history.end() * DRAWN_HZ).max(0.0) as u32;
    let drawn = (0..=count).map(|i| {
        let motion = history.motion(girder, f64::from(i) / DRAWN_HZ);
        let shown = [1e3 * motion.displacement.x, 1e3 * motion.displacement.y, motion.theta.to_degrees()];
        shown.map(|v| (v * 1e4).round() / 1e4)
    });
    GirderSeen {
        name: history.model().bodies[girder].name.clone(),
        states: stretches(history, girder),
        drawn: drawn.collect(),
        ..extremes(history, girder)
    }
}

/// Extremes of a girder, at even instants and at events.
fn extremes(history: &History, girder: usize) -> GirderSeen {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count, of a minute at most")]
    let count = (history.end() * LOOKS_HZ).max(0.0) as u32;
    let even = (0..=count).map(|i| f64::from(i) / LOOKS_HZ);
    let mut seen = GirderSeen::default();
    for t in even.chain(history.events().iter().map(|event| event.t)) {
        let motion = history.motion(girder, t);
        let places = [motion.displacement.x, motion.displacement.y, motion.theta];
        seen.largest.iter_mut().zip(places).for_each(|(most, v)| *most = most.max(v.abs()));
        let speeds = [motion.velocity.x, motion.velocity.y];
        seen.fastest.iter_mut().zip(speeds).for_each(|(most, v)| *most = most.max(v.abs()));
        if t > 0.5 * history.end() {
            seen.late_rotation = seen.late_rotation.max(motion.theta.abs());
        }
    }
    seen
}

/// A touch of one corner: from, until, contact.
type Strike = (f64, f64, usize);

/// Touches of single corners; of a hit along a face both of its ends.
fn strikes(history: &History) -> Vec<Strike> {
    let lasts = |touch: &&Touch| history.impact().is_none() || touch.impulse == 0.0;
    let mut all: Vec<Strike> =
        history.hits().touches().iter().filter(lasts).map(|touch| (touch.start, touch.end, touch.contact)).collect();
    for hit in history.impact().map_or(&[][..], |record| &record.hits) {
        all.extend(hit.sites.iter().map(|&site| (hit.t, hit.t, site)));
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.2.cmp(&b.2)));
    all
}

/// Strikes that overlap in time are one hit.
fn hits(history: &History) -> Vec<HitSeen> {
    let mut hits: Vec<HitSeen> = Vec::new();
    for (from, until, contact) in strikes(history) {
        if hits.last().is_none_or(|hit| from > hit.until) {
            hits.push(HitSeen { from, until, ..HitSeen::default() });
        }
        if let Some(hit) = hits.last_mut() {
            hit.until = hit.until.max(until);
            let left = history.model().sites[contact].geometry.arm.y > 0.0;
            hit.corners[usize::from(left)].get_or_insert(from);
        }
    }
    for hit in &mut hits {
        hit.jump = jump(history, hit).abs().to_array();
    }
    hits
}

/// Change of velocity of the first girder by a hit within a frame of the film \[m/s\].
fn jump(history: &History, hit: &HitSeen) -> DVec2 {
    let mass = history.model().bodies[0].mass;
    let until = hit.until.min(hit.from + FRAME);
    if let Some(record) = history.impact() {
        let of_hit = record.hits.iter().filter(|other| other.t >= hit.from && other.t <= until);
        let impulse = of_hit.map(|other| {
            let [normal, along] = other.impulses.total();
            other.impulses.normal * normal + other.impulses.normal.perp() * along
        });
        return impulse.sum::<DVec2>() / mass;
    }
    // Simpson's rule; the force begins and ends near 0.
    let step = (until - hit.from) / f64::from(INTERVALS);
    let weighted = (0..=INTERVALS).map(|i| {
        let weight = if i == 0 || i == INTERVALS { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
        force(history, hit.from + step * f64::from(i)) * weight
    });
    weighted.sum::<DVec2>() * (step / (3.0 * mass))
}

/// Contact force on the first girder at `t` \[N\].
fn force(history: &History, t: f64) -> DVec2 {
    let on_first = |contact: usize| history.model().sites[contact].node_body == Some(0);
    let all = history.contacts().at(t).into_iter();
    all.map(|now| now.force.truncate() * if on_first(now.contact) { 1.0 } else { -1.0 }).sum()
}
