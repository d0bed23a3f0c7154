//! Limits of an answer's validity, and warnings to a designer: limits that were passed, supports that were lost, bearings that lift or
//! pull, overlaps, contacts beyond the sense of their law, quantities outside the domain.

use serde::Serialize;

use crate::language::{Text, six};
use crate::scene::{Scene, domain};
use crate::sim::readings::Limit;
use crate::sim::{History, LostSupport, Overlap, TooDeep, Uplift, Upright, readings};

/// A limit that was passed, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PassedReport {
    /// Which, by its key in the scene's `[limits]`.
    pub limit: Limit,
    /// The girder, bearing (`deck.bearing1`), pier or pair; of a seat the girder with its end: `deck+x`.
    pub whose: String,
    /// Time at which it was first exceeded \[s\].
    pub t: f64,
    /// Largest value, in the unit of the limit.
    pub reached: f64,
}

impl PassedReport {
    /// Largest value, with its unit.
    pub fn reached(&self) -> String {
        let unit = match self.limit {
            Limit::Rotation => "°",
            Limit::Force | Limit::TotalForce => " N",
            Limit::Drift | Limit::RemainingSeat | Limit::BearingDisplacement | Limit::PierDrift => " m",
        };
        format!("{}{unit}", six(self.reached))
    }
}

/// A bearing that lost its support.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LostReport {
    /// `deck.bearing1`.
    pub bearing: String,
    /// Time \[s\].
    pub t: f64,
    /// Place of its point of the girder then, world \[m\].
    pub place: [f64; 3],
}

/// A bearing that stopped carrying.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UpliftReport {
    /// `deck.bearing1`.
    pub bearing: String,
    /// Time at which it first carried nothing \[s\].
    pub t: f64,
    /// The most that it held the girder down with, of one that lifts by its dashpot before it did \[N\].
    pub pull: f64,
    /// Time of that pull \[s\].
    pub pull_t: f64,
    /// Whether it lifts.
    pub lifts: bool,
    /// Its load at rest \[N\].
    pub load: f64,
}

/// An overlap that no contact carries, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OverlapReport {
    /// Names of the two bodies.
    pub bodies: [String; 2],
    /// Time at which it was first seen \[s\].
    pub t: f64,
    /// From when to when it was there, in order of time \[s\].
    pub intervals: Vec<[f64; 2]>,
    /// Its greatest depth beyond what contacts carry, the shortest way out \[m\].
    pub depth: f64,
    /// Time of the greatest depth \[s\].
    pub deepest_at: f64,
    /// Place of the greatest depth, world \[m\].
    pub place: [f64; 3],
}

/// A contact pressed deeper than its law has a sense, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TooDeepReport {
    /// The node.
    pub node: String,
    /// The face.
    pub face: String,
    /// Its largest penetration \[m\].
    pub depth: f64,
    /// Time \[s\].
    pub t: f64,
    /// Allowed value: a tenth of the shortest side of either girder \[m\].
    pub allowed: f64,
}

/// Contacts that left a face while their springs held energy, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DroppedReport {
    /// Number of times.
    pub count: usize,
    /// Energy of all of them \[J\].
    pub energy: f64,
    /// That energy in parts of the largest energy in play \[–\].
    pub share: f64,
    /// The node that held most.
    pub node: String,
    /// The face that it left.
    pub face: String,
    /// Time \[s\].
    pub t: f64,
}

/// A quantity outside the domain, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OutsideReport {
    /// The key of the scene that it comes from.
    pub place: String,
    /// The facing pair that it belongs to, if to one.
    pub pair: Option<String>,
    /// Name.
    pub quantity: Text,
    /// Its unit.
    pub unit: &'static str,
    /// Value.
    pub value: f64,
    /// The end of the domain that it lies beyond.
    pub bound: f64,
    /// Expected consequence.
    pub consequence: Text,
}

/// Limits of the scene that were passed.
pub(super) fn passed(history: &History) -> Vec<PassedReport> {
    let passed = readings::passed(history).into_iter();
    passed.map(|p| PassedReport { limit: p.limit, whose: p.whose(), t: p.t, reached: p.reached }).collect()
}

pub(super) fn lost(history: &History) -> Vec<LostReport> {
    let report = |lost: LostSupport| LostReport { bearing: lost.name, t: lost.t, place: lost.place.to_array() };
    history.seats().lost_supports(history.end()).into_iter().map(report).collect()
}

/// Bearings that stopped carrying, the earliest first.
pub(super) fn uplifts(upright: &[Upright]) -> Vec<UpliftReport> {
    let report = |uplift: &Uplift| UpliftReport {
        bearing: uplift.name.clone(),
        t: uplift.t,
        pull: uplift.pull.value,
        pull_t: uplift.pull.t,
        lifts: uplift.lifts,
        load: uplift.load,
    };
    let mut all: Vec<UpliftReport> = upright.iter().flat_map(|girder| &girder.uplifts).map(report).collect();
    all.sort_by(|a, b| a.t.total_cmp(&b.t));
    all
}

/// Overlaps that no contact carries.
pub(super) fn overlaps(history: &History) -> Vec<OverlapReport> {
    let of = |o: &Overlap| OverlapReport {
        bodies: o.bodies.map(|body| body.name(history.scene()).to_owned()),
        t: o.first(),
        intervals: o.intervals.clone(),
        depth: o.depth.value,
        deepest_at: o.depth.t,
        place: o.place.to_array(),
    };
    history.overlaps().iter().map(of).collect()
}

/// Node and face of a contact.
fn names(history: &History, contact: usize) -> [String; 2] {
    let site = &history.model().sites[contact];
    [site.node.clone(), site.face_name.to_string()]
}

/// Contacts pressed deeper than their law has a sense.
pub(super) fn too_deep(history: &History) -> Vec<TooDeepReport> {
    let of = |deep: TooDeep| {
        let [node, face] = names(history, deep.contact);
        TooDeepReport { node, face, depth: deep.depth.value, t: deep.depth.t, allowed: deep.allowed }
    };
    history.contacts().too_deep().into_iter().map(of).collect()
}

/// Contacts that left a face while their springs held energy.
pub(super) fn dropped(history: &History) -> Option<DroppedReport> {
    let dropped = history.contacts().dropped()?;
    let [node, face] = names(history, dropped.contact);
    Some(DroppedReport { count: dropped.count, energy: dropped.energy, share: dropped.share, node, face, t: dropped.t })
}

/// Quantities of the scene that lie outside the domain.
pub(super) fn outside(scene: &Scene) -> Vec<OutsideReport> {
    let departures = domain::outside(scene).into_iter();
    let of = |d: domain::Departure| OutsideReport {
        quantity: d.limit.quantity,
        unit: d.limit.unit,
        value: d.value,
        bound: d.bound(),
        consequence: d.consequence(),
        place: d.place,
        pair: d.pair,
    };
    departures.map(of).collect()
}
