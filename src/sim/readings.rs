//! Readings of a run for design: rotation, drift of the corners, remaining seats, the least gap, the largest force, and the scene's limits
//! that were exceeded, with the time.
//!
//! Extremes are looked for at a rate that neither bearings nor ground can outrun, then refined; instants by bisection.

use glam::DVec3;

use super::hits::touches::looks_in_hit;
use super::peaks::largest;
pub use super::report::Extreme;
use super::{BearingsReading, History, Pounding, Touch, looks, seats};
use crate::contact::node_face::locate;
use crate::dynamics::model::edge_node::node_place::NodePlace;
use crate::geometry::{End, Prism};

/// A girder in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Largest rotation, with its sign \[rad\].
    pub rotation: Extreme,
    /// Largest distance of each corner in plan from where it was placed \[m\].
    pub drift: [Extreme; 4],
    /// Its seats, where it has any.
    pub seats: Vec<seats::Seat>,
    /// Least gap of its pairs; nothing where it faces nobody \[m\].
    pub gap: Option<Extreme>,
    /// Largest `|R_k|` of its pairs; nothing where it touched nobody \[N\].
    pub force: Option<Extreme>,
    /// Its bearings, where it has any.
    pub bearings: Option<BearingsReading>,
    /// Time at which it has tipped in space, and its largest tilt \[s, rad\]; `None` where it stays upright.
    pub tipped: Option<(f64, f64)>,
}

/// A limit of the scene's `[limits]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Rotation of a girder about the vertical \[°\].
    Rotation,
    /// Displacement of a girder's corner in plan \[m\].
    Drift,
    /// Least of what remains of a seat \[m\].
    RemainingSeat,
    /// Force of one contact \[N\].
    Force,
    /// Force between two bodies \[N\].
    TotalForce,
    /// Deformation of a bearing in plan \[m\].
    BearingDisplacement,
    /// Drift of a pier \[m\].
    PierDrift,
}

impl Limit {
    /// As the scene's file calls it.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Rotation => "rotation_deg",
            Self::Drift => "drift_m",
            Self::RemainingSeat => "remaining_seat_m",
            Self::Force => "force_n",
            Self::TotalForce => "total_force_n",
            Self::BearingDisplacement => "bearing_displacement_m",
            Self::PierDrift => "pier_drift_m",
        }
    }
}

impl serde::Serialize for Limit {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.key())
    }
}

/// A limit that was passed.
#[derive(Clone, Debug, PartialEq)]
pub struct Passed {
    /// Which.
    pub limit: Limit,
    /// By whom: a girder, a bearing (`deck.bearing1`), a pier, or a pair.
    pub whose: String,
    /// Of a seat, under which end.
    pub end: Option<End>,
    /// Time at which it was first exceeded \[s\].
    pub t: f64,
    /// Largest value, SI; degrees for the rotation.
    pub reached: f64,
}

impl Passed {
    /// Whose it is, with the end of its seat: `deck+x`.
    pub fn whose(&self) -> String {
        format!("{}{}", self.whose, self.end.map_or("", End::label))
    }
}

/// Displacement of a corner in plan, at mid-depth \[m\].
pub(super) fn corner_way(history: &History, girder: usize, corner: usize, t: f64) -> DVec3 {
    let body = &history.model().bodies[girder];
    let end = if Prism::end_corners(End::Plus).contains(&corner) { End::Plus } else { End::Minus };
    let motion = history.end_motion(girder, end, t);
    let here = body.prism.plan_corners()[corner].extend(0.0);
    // From the displacement, not from the place: far from the origin the difference would round away.
    motion.displacement + (motion.attitude * here - body.axes * here)
}

/// Gap of a contact's node \[m\], and coordinate of its projection along the face's horizontal \[m\], whether the contact is open or
/// closed; of an open edge node those of the middle of its edge.
pub fn before_face(history: &History, contact: usize, t: f64) -> [f64; 2] {
    let site = &history.model().sites[contact];
    let [node, face] = history.trajectories.sides(contact, t.clamp(0.0, history.end()));
    let place = history.trajectories.log(contact).at(t).closed().map_or_else(NodePlace::default, |closed| closed.place);
    let here = locate(&site.geometry_at(&place), &node, &face);
    let at = site.on_face(&place, &here);
    let level = DVec3::Z.cross(site.face.normal);
    let [u, v] = [site.face.tangent.dot(level), site.face.bitangent.dot(level)];
    [here.gap, at.x * u + at.y * v]
}

/// Least gap of a pair's nodes before the faces they are declared with \[m\].
pub fn gap(history: &History, pair: usize, t: f64) -> f64 {
    let model = history.model();
    let of = |contact: usize| {
        let site = &model.sites[contact];
        let [node, face] = history.trajectories.sides(contact, t);
        let here = locate(&site.geometry, &node, &face);
        (here.gap, site.face.inset_at(here.at) >= 0.0)
    };
    let all: Vec<(f64, bool)> = model.pairs[pair].sites.clone().map(of).collect();
    let before = all.iter().filter(|(_, over)| *over).map(|(gap, _)| *gap).reduce(f64::min);
    // Faces that have slid past one another still have a distance along the normal.
    before.or_else(|| all.iter().map(|(gap, _)| *gap).reduce(f64::min)).unwrap_or(f64::NAN)
}

/// The numbers of a girder.
pub fn reading(history: &History, girder: usize) -> Reading {
    let times = looks::of_body(history, girder);
    let rotation = largest(&times, &|t| history.motion(girder, t).theta.abs());
    let rotation = Extreme { value: history.motion(girder, rotation.t).theta, ..rotation };
    let drift = |corner| largest(&times, &|t| corner_way(history, girder, corner, t).truncate().length());
    let pairs = history.model().pairs.iter().enumerate().filter(|(_, p)| p.bodies.contains(&Some(girder)));
    let pairs: Vec<usize> = pairs.map(|(i, _)| i).collect();
    let facing = pairs.iter().filter(|&&pair| !history.model().pairs[pair].met);
    let gaps = facing.map(|&pair| {
        let closest = largest(&times, &|t| -gap(history, pair, t));
        Extreme { value: -closest.value, ..closest }
    });
    let touches = history.hits().touches().iter().filter(|touch| pairs.contains(&touch.pair));
    let hardest = touches.max_by(|a, b| a.peak_force.total_cmp(&b.peak_force));
    Reading {
        rotation,
        drift: [0, 1, 2, 3].map(drift),
        seats: history.seats().of_girder(girder),
        gap: gaps.reduce(|a, b| if b.value < a.value { b } else { a }),
        force: hardest.map(|touch| Extreme { value: touch.peak_force, t: touch.peak_time }),
        bearings: history.connections().bearings_reading(girder),
        tipped: history.seats().tipped(girder),
    }
}

/// Time at which a function first rises above 0, at a sample or at its peak between two, to a part in a thousand million of the run \[s\].
pub(super) fn first(times: &[f64], end: f64, value: &dyn Fn(f64) -> f64) -> Option<f64> {
    let at_peak = || Some(largest(times, value)).filter(|peak| peak.value > 0.0).map(|peak| peak.t);
    let mut above = times.iter().copied().find(|&t| value(t) > 0.0).or_else(at_peak)?;
    let mut below = times[times.partition_point(|&t| t < above).saturating_sub(1)].min(above);
    while above - below > 1e-9 * end {
        let middle = f64::midpoint(below, above);
        if value(middle) > 0.0 {
            above = middle;
        } else {
            below = middle;
        }
    }
    Some(above)
}

/// Every limit of the scene that was passed, the earliest first.
pub fn passed(history: &History) -> Vec<Passed> {
    let limits = history.scene().limits;
    let mut all = Vec::new();
    for (girder, body) in history.model().girders().iter().enumerate() {
        let watched = [limits.rotation_deg.is_some(), limits.drift.is_some(), limits.remaining_seat.is_some()];
        if watched.contains(&true) {
            of_girder(history, girder, &body.name, &mut all);
        }
    }
    if let Some(limit) = limits.force {
        all.extend(of_forces(history, limit));
    }
    if let Some(limit) = limits.total_force {
        all.extend(of_resultants(history, limit));
    }
    if let Some(limit) = limits.bearing_displacement {
        all.extend((0..history.model().girders().len()).flat_map(|girder| of_bearings(history, girder, limit)));
    }
    if let Some(limit) = limits.pier_drift {
        all.extend((0..history.model().piers.len()).filter_map(|pier| of_pier(history, pier, limit)));
    }
    all.sort_by(|a, b| a.t.total_cmp(&b.t));
    all
}

fn of_girder(history: &History, girder: usize, name: &str, all: &mut Vec<Passed>) {
    let limits = history.scene().limits;
    let times = looks::of_body(history, girder);
    let mut watch = |limit: Limit, end: Option<End>, (most, sign): (f64, f64), value: &dyn Fn(f64) -> f64| {
        if let Some(t) = first(&times, history.end(), &|t| sign * (value(t) - most)) {
            let reached = sign * largest(&times, &|t| sign * value(t)).value;
            all.push(Passed { limit, whose: name.to_owned(), end, t, reached });
        }
    };
    if let Some(most) = limits.rotation_deg {
        watch(Limit::Rotation, None, (most, 1.0), &|t| history.motion(girder, t).theta.abs().to_degrees());
    }
    if let Some(most) = limits.drift {
        let farthest = |t| {
            let way = |corner| corner_way(history, girder, corner, t).truncate().length();
            (0..4).map(way).fold(0.0, f64::max)
        };
        watch(Limit::Drift, None, (most, 1.0), &farthest);
    }
    for end in End::BOTH {
        if let Some(least) = limits.remaining_seat.filter(|_| history.seats().length(girder, end).is_some()) {
            watch(Limit::RemainingSeat, Some(end), (least, -1.0), &|t| history.seats().remaining(girder, end, t));
        }
    }
}

/// Every bearing of a girder whose deformation in plan passes a limit while it is one.
fn of_bearings(history: &History, girder: usize, limit: f64) -> Vec<Passed> {
    let body = &history.model().girders()[girder];
    let times = looks::of_body(history, girder);
    let passed = |number: usize| {
        let times: Vec<f64> =
            times.iter().copied().filter(|&t| t <= history.seats().bearing_lost_at(girder, number)).collect();
        let size = |t: f64| {
            let [along, across] = history.connections().bearing_loop(girder, number, t)?.deformation;
            Some(along.hypot(across))
        };
        let size = |t: f64| size(t).unwrap_or(0.0);
        let t = first(&times, history.end(), &|t| size(t) - limit)?;
        let whose = format!("{}.bearing{}", body.name, number + 1);
        Some(Passed { limit: Limit::BearingDisplacement, whose, end: None, t, reached: largest(&times, &size).value })
    };
    (0..body.bearings.len()).filter_map(passed).collect()
}

/// A pier whose drift passes a limit.
fn of_pier(history: &History, pier: usize, limit: f64) -> Option<Passed> {
    let times = looks::of_body(history, history.model().piers[pier].body);
    let drift = |t: f64| history.connections().pier(pier, t).map_or(0.0, |now| now.displacement.truncate().length());
    let t = first(&times, history.end(), &|t| drift(t) - limit)?;
    let whose = history.scene().piers[pier].name.clone();
    Some(Passed { limit: Limit::PierDrift, whose, end: None, t, reached: largest(&times, &drift).value })
}

/// Those of some times in rising order that are before `last`, and that one.
fn up_to(mut times: Vec<f64>, last: f64) -> Vec<f64> {
    times.retain(|t| *t < last);
    times.push(last);
    times
}

/// Every two bodies whose force passes a limit, all contacts between them together: when it first does so.
fn of_resultants(history: &History, limit: f64) -> Vec<Passed> {
    let passed = |of: &Pounding| {
        let hit = of.hits.iter().find(|hit| hit.peak.value > limit)?;
        let solids = history.model().pairs[of.pair].solids();
        let between = |touch: &&Touch| history.model().pairs[touch.pair].solids() == solids;
        let touches = history.hits().touches().iter().filter(between);
        let touches: Vec<&Touch> = touches.filter(|touch| touch.start <= hit.end && touch.end >= hit.start).collect();
        let times = up_to(looks_in_hit(history, &touches), hit.peak.t);
        let force = |t: f64| history.hits().resultant(of.pair, t).length() - limit;
        let t = first(&times, history.end(), &force).unwrap_or(hit.peak.t);
        let whose = history.model().pairs[of.pair].name.clone();
        Some(Passed { limit: Limit::TotalForce, whose, end: None, t, reached: of.most()?.value })
    };
    history.hits().poundings().iter().filter_map(passed).collect()
}

/// Each pair of which a contact's force passes a limit, when one first does so.
fn of_forces(history: &History, limit: f64) -> Vec<Passed> {
    let mut all: Vec<Passed> = Vec::new();
    for (number, pair) in history.model().pairs.iter().enumerate() {
        let touches = history.hits().touches().iter().filter(|touch| touch.pair == number);
        let over: Vec<_> = touches.filter(|touch| touch.peak_force > limit).collect();
        let passes = |touch: &&Touch| {
            let force =
                |t: f64| history.contacts().contact_at(touch.contact, t).map_or(0.0, |c| c.force.length()) - limit;
            let times = up_to(looks_in_hit(history, &[*touch]), touch.peak_time);
            first(&times, history.end(), &force).unwrap_or(touch.peak_time)
        };
        let Some(t) = over.iter().map(passes).min_by(f64::total_cmp) else { continue };
        let reached = over.iter().map(|touch| touch.peak_force).fold(0.0, f64::max);
        all.push(Passed { limit: Limit::Force, whose: pair.name.clone(), end: None, t, reached });
    }
    all
}
