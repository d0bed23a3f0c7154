//! `summary.json`, and the same facts for whoever prints them: headline numbers, ledger, error, versions.

use serde::Serialize;

use super::TableOptions;
use super::devices::{self, DeviceReport};
use super::events::law_of;
use super::flexible::{self, FlexibleReport};
use super::seats::{self, SeatReport};
use super::verdicts::{self, VerdictReport};
use crate::language::Text;
use crate::scene::{Kind, Scene, domain};
use crate::sim::moving_ground::{MovedSupport, moved_supports};
use crate::sim::{
    BackfillReading, DegreeCheck, History, Ledger, LostSupport, Overlap, PierReading, Stop, Summary, TooDeep, readings,
};

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
    /// Whether each girder that has seats stays on them, in words.
    pub verdicts: Vec<VerdictReport>,
    /// What remains of the seats that the scene gives.
    pub seats: Vec<SeatReport>,
    /// Bearings that lost their support, the earliest first: every later sample is without them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub lost_supports: Vec<LostReport>,
    /// Supports whose ground moves otherwise than that of `[motion]`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub moved_supports: Vec<MovedSupport>,
    /// What the run did to the soil behind backwalls that move.
    pub backfill: Vec<BackfillReport>,
    /// What the run did to piers.
    pub piers: Vec<PierReport>,
    /// What the run did to devices.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub devices: Vec<DeviceReport>,
    /// Girders that the scene calls elastic.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub flexible: Vec<FlexibleReport>,
    /// Differences from a run with more polynomials, when asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degree_check: Option<DegreeCheck>,
    /// Limits of the scene that were passed, the earliest first.
    pub limits_passed: Vec<PassedReport>,
    /// Overlaps of two bodies that no contact carries, the earliest first.
    pub overlaps: Vec<OverlapReport>,
    /// Contacts pressed deeper than a tenth of the shortest side of either girder, at most one a pair.
    pub too_deep: Vec<TooDeepReport>,
    /// Contacts that left a face over its edge while their springs held energy.
    pub dropped: Option<DroppedReport>,
    /// Quantities of the scene that lie outside the domain in which the program is checked.
    pub outside_domain: Vec<OutsideReport>,
    /// Numbers of the scene that were not given, by their paths in its file.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub assumed: Vec<String>,
    /// Local error per step that was asked for.
    pub tolerance: f64,
    /// Largest displacement difference from a run at a hundredth of the tolerance, when asked for \[m\].
    pub estimated_error: Option<f64>,
    /// The energy ledger at the end \[J\].
    pub ledger: Ledger,
    /// Bound of the ledger's |residual| \[J\].
    pub residual_bound: f64,
    /// Whether the residual is within the bound.
    pub balances: bool,
    /// Hash of the whole answer, bit for bit.
    pub digest: String,
    /// Time to compute it, when timed \[s\].
    pub run_time: Option<f64>,
    /// How many times faster than real time, when timed.
    pub times_real_time: Option<f64>,
    /// What computed it.
    pub versions: Versions,
    /// Files of the answer, this one among them; a later answer in the same folder removes those that it does not have.
    pub files: Vec<String>,
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

/// A limit that was passed, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PassedReport {
    /// Its key in the scene's `[limits]`.
    pub limit: &'static str,
    /// The girder or pair.
    pub whose: String,
    /// When for the first time \[s\].
    pub t: f64,
    /// How far at the most, in the unit of the limit.
    pub reached: f64,
}

/// A bearing that lost its support.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LostReport {
    /// `deck.bearing1`.
    pub bearing: String,
    /// When \[s\].
    pub t: f64,
    /// Where its point of the girder was, world \[m\].
    pub place: [f64; 3],
}

/// Soil behind one backwall.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BackfillReport {
    /// The abutment's name.
    pub abutment: String,
    /// Greatest push of the wall into the soil \[m\].
    pub push: f64,
    /// When \[s\].
    pub t: f64,
    /// Greatest resistance of the soil \[N\].
    pub force: f64,
    /// Its ultimate force `F_ult` \[N\].
    pub ultimate: f64,
    /// Gap that stays between the wall as placed and the soil \[m\].
    pub remaining_gap: f64,
}

/// A pier.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PierReport {
    /// Its name.
    pub name: String,
    /// Undamped periods of the pier alone along and across \[s\].
    pub periods: [f64; 2],
    /// Largest displacement of its cap against its foot, in plan \[m\].
    pub drift: f64,
    /// When \[s\].
    pub drift_t: f64,
    /// Largest base shear \[N\].
    pub shear: f64,
    /// When \[s\].
    pub shear_t: f64,
    /// Largest base shear times the pier's height \[N·m\].
    pub moment: f64,
    /// Largest rotation of its cap in plan \[rad\].
    pub rotation: f64,
    /// When its base yielded for the first time \[s\].
    pub yielded_at: Option<f64>,
}

/// An overlap that no contact carries, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OverlapReport {
    /// Names of the two bodies.
    pub bodies: [String; 2],
    /// When it was seen first \[s\].
    pub t: f64,
    /// From when to when it was there, in order of time \[s\].
    pub intervals: Vec<[f64; 2]>,
    /// Its greatest depth beyond what contacts carry, the shortest way out \[m\].
    pub depth: f64,
    /// When it was deepest \[s\].
    pub deepest_at: f64,
    /// Where it was deepest, world \[m\].
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
    /// When \[s\].
    pub t: f64,
    /// What it may be: a tenth of the shortest side of either girder \[m\].
    pub allowed: f64,
}

/// Contacts that left a face while their springs held energy, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DroppedReport {
    /// How many times.
    pub count: usize,
    /// Energy of all of them \[J\].
    pub energy: f64,
    /// The same in parts of the largest energy in play.
    pub share: f64,
    /// The node that held most.
    pub node: String,
    /// The face that it left.
    pub face: String,
    /// When \[s\].
    pub t: f64,
}

/// A quantity outside the domain, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OutsideReport {
    /// The key of the scene that it comes from.
    pub place: String,
    /// The facing pair that it belongs to, if to one.
    pub pair: Option<String>,
    /// What it is called.
    pub quantity: Text,
    /// Its unit.
    pub unit: &'static str,
    /// What it is.
    pub value: f64,
    /// The end of the domain that it lies beyond.
    pub bound: f64,
    /// What is to be expected.
    pub consequence: Text,
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
        let (scene, ledger, balance) = (history.scene(), history.ledger(history.end()), history.balance());
        Self {
            scene: scene.name.clone(),
            kind: scene.kind,
            model: if history.impact().is_some() { "impact" } else { "contact" },
            duration: scene.duration,
            end: history.end(),
            gave_up: history.stop().cloned(),
            numbers: history.summary(),
            pairs: pairs(history),
            verdicts: verdicts::of(history),
            seats: seats::of(history),
            lost_supports: lost(history),
            moved_supports: moved_supports(scene, history.model()),
            backfill: backfill(history),
            piers: piers(history),
            devices: devices::reports(history),
            flexible: flexible::of(history),
            degree_check: options.degree_check,
            limits_passed: passed(history),
            overlaps: overlaps(history),
            too_deep: too_deep(history),
            dropped: dropped(history),
            outside_domain: outside(scene),
            assumed: scene.assumed_numbers().into_iter().map(|(path, _)| path).collect(),
            tolerance: scene.solver.tolerance,
            estimated_error: options.estimated_error,
            ledger,
            residual_bound: balance.bound * ledger.scale,
            balances: balance.holds(),
            digest: format!("{:016x}", history.digest()),
            run_time: options.run_time,
            times_real_time: options.run_time.filter(|&s| s > 0.0).map(|s| history.end() / s),
            versions: Versions { girderbench: env!("CARGO_PKG_VERSION"), scene_format: scene.format },
            files: Vec::new(),
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
    let of_pair = |number: usize| {
        let touches: Vec<_> = history.touches().iter().filter(|touch| touch.pair == number).collect();
        PairReport {
            name: history.model().pairs[number].name.clone(),
            law: law_of(history, number),
            touches: touches.len(),
            peak_force: touches.iter().map(|touch| touch.peak_force).fold(0.0, f64::max),
        }
    };
    history.listed_pairs().into_iter().map(of_pair).collect()
}

fn lost(history: &History) -> Vec<LostReport> {
    let report = |lost: LostSupport| LostReport { bearing: lost.name, t: lost.t, place: lost.place.to_array() };
    history.lost_supports(history.end()).into_iter().map(report).collect()
}

fn backfill(history: &History) -> Vec<BackfillReport> {
    let report = |BackfillReading { abutment, push, t, force, ultimate, remaining_gap }: BackfillReading| {
        let abutment = history.scene().abutments[abutment].name.clone();
        BackfillReport { abutment, push, t, force, ultimate, remaining_gap }
    };
    history.backfill().into_iter().map(report).collect()
}

fn piers(history: &History) -> Vec<PierReport> {
    let report = |PierReading { pier, periods, drift, shear, moment, turn, yielded_at }: PierReading| PierReport {
        name: history.scene().piers[pier].name.clone(),
        periods,
        drift: drift.value,
        drift_t: drift.t,
        shear: shear.value,
        shear_t: shear.t,
        moment,
        rotation: turn,
        yielded_at,
    };
    history.piers().into_iter().map(report).collect()
}

/// Limits of the scene that were passed.
fn passed(history: &History) -> Vec<PassedReport> {
    let passed = readings::passed(history).into_iter();
    passed.map(|p| PassedReport { limit: p.limit, whose: p.whose, t: p.t, reached: p.reached }).collect()
}

/// Overlaps that no contact carries.
fn overlaps(history: &History) -> Vec<OverlapReport> {
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
    let site = &history.model().contacts[contact];
    [site.node.clone(), site.face_name.to_string()]
}

/// Contacts pressed deeper than their law has a sense.
fn too_deep(history: &History) -> Vec<TooDeepReport> {
    let of = |deep: TooDeep| {
        let [node, face] = names(history, deep.contact);
        TooDeepReport { node, face, depth: deep.depth.value, t: deep.depth.t, allowed: deep.allowed }
    };
    history.too_deep().into_iter().map(of).collect()
}

/// Contacts that left a face while their springs held energy.
fn dropped(history: &History) -> Option<DroppedReport> {
    let dropped = history.dropped()?;
    let [node, face] = names(history, dropped.contact);
    Some(DroppedReport { count: dropped.count, energy: dropped.energy, share: dropped.share, node, face, t: dropped.t })
}

/// Quantities of the scene that lie outside the domain.
fn outside(scene: &Scene) -> Vec<OutsideReport> {
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
