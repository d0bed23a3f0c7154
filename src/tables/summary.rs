//! `summary.json`, and the same facts for whoever prints them: headline numbers, ledger, error, versions.

use std::collections::BTreeMap;

use serde::Serialize;

use super::TableOptions;
use super::departures::{
    self, DroppedReport, LostReport, OutsideReport, OverlapReport, PassedReport, TooDeepReport, UpliftReport,
};
use super::devices::{self, DeviceReport};
use super::events::law_of;
use super::flexible::{self, FlexibleReport};
use super::seats::{self, SeatReport};
use super::supports::{self, BackfillReport, BearingsReport, PierReport};
use super::verdicts::{self, VerdictReport};
use crate::language::said;
use crate::scene::Kind;
use crate::sim::moving_ground::{MovedSupport, moved_supports};
use crate::sim::readings::Extreme;
use crate::sim::{DegreeCheck, History, Ledger, Stop, Summary};

/// Everything a summary says, SI.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The scene's name.
    pub scene: String,
    /// Planar or spatial.
    pub kind: Kind,
    /// Model that computed it, `contact` or `impact`.
    pub model: &'static str,
    /// Duration of the scene \[s\].
    pub duration: f64,
    /// Time that the answer reaches \[s\].
    pub end: f64,
    /// Reason of an end before `duration`.
    pub gave_up: Option<Stop>,
    /// The headline numbers.
    #[serde(flatten)]
    pub numbers: Summary,
    /// Largest angle of any girder's vertical axis from the vertical; nothing in a planar scene \[rad\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_tilt: Option<f64>,
    /// Facing pairs and the law each used.
    pub pairs: Vec<PairReport>,
    /// Whether each girder that has seats stays on them, in words.
    pub verdicts: Vec<VerdictReport>,
    /// Remaining lengths of the seats that the scene gives.
    pub seats: Vec<SeatReport>,
    /// Bearings that lost their support, the earliest first: every later sample is without them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub lost_supports: Vec<LostReport>,
    /// Bearings in space that stopped carrying: sliders that lifted, others that held their girder down; the earliest first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub uplifts: Vec<UpliftReport>,
    /// Supports whose ground moves otherwise than that of `[motion]`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub moved_supports: Vec<MovedSupport>,
    /// Readings of the bearings of every girder that has some.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub bearings: Vec<BearingsReport>,
    /// Readings of the soil behind backwalls that move.
    pub backfill: Vec<BackfillReport>,
    /// Readings of the piers.
    pub piers: Vec<PierReport>,
    /// Readings of the devices.
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
    /// In words, when and for how long lasting contacts went on without friction; impact model.
    pub without_friction: Option<String>,
    /// Overlaps of two bodies that no contact carries, the earliest first.
    pub overlaps: Vec<OverlapReport>,
    /// Contacts pressed deeper than a tenth of the shortest side of either girder, at most one a pair.
    pub too_deep: Vec<TooDeepReport>,
    /// Contacts that left a face over its edge while their springs held energy.
    pub dropped: Option<DroppedReport>,
    /// Quantities of the scene that lie outside the domain in which the program is checked.
    pub outside_domain: Vec<OutsideReport>,
    /// Numbers of the scene that were not given, by their paths in its file: those that it lists, and those that the program chose.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub assumed: Vec<String>,
    /// Local error per step that was asked for.
    pub tolerance: f64,
    /// Largest displacement difference of any G from a run at a hundredth of the tolerance, when asked for \[m\].
    pub estimated_error: Option<f64>,
    /// Largest difference in attitude of any body from that run \[rad\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub estimated_rotation_error: Option<f64>,
    /// Largest difference of the fibre stress of a girder that bends from that run, and of N, M and `M_y` at mid-span that make a tenth of it,
    /// where and when each is largest, in parts of it; looked at where the tolerance is coarser than 1e-9.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub estimated_stress_error: Option<f64>,
    /// Until when that is known, where the finer run gave up before the end of this one \[s\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub estimated_until: Option<f64>,
    /// Whether a corner errs by more than a thousandth of the largest motion of one, as far as that is known by both, or the fibre
    /// stress or a section force, as far as `estimated_stress_error` looks, by more than a hundredth of itself.
    pub error_is_large: bool,
    /// Estimated error over the largest motion of a corner \[–\].
    #[serde(skip)]
    pub error_share: f64,
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
    /// Factor of the run's speed over real time, when measured \[–\].
    pub times_real_time: Option<f64>,
    /// Versions of program and scene format.
    pub versions: Versions,
    /// Files of the answer, this one among them; a later answer in the same folder removes those that it does not have.
    pub files: Vec<String>,
}

/// Part of the largest motion of a corner above which an estimated error is said to be large \[–\]. Chosen: a pixel of a curve that fills a
/// screen.
const LARGE_ERROR: f64 = 1e-3;
/// Part of the largest fibre stress, and of section forces, by which they may differ \[–\]. Chosen: what strengths are known to.
const LARGE_STRESS_ERROR: f64 = 1e-2;

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
    /// Largest force between its two bodies, of all their contacts together; with the pair of their hardest touch \[N\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_total: Option<f64>,
    /// Coefficient of restitution that is asked for, and the one that a flush free head-on hit returns at the design speed \[–\].
    pub restitution: [f64; 2],
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
    /// Collects the numbers of an answer.
    pub fn of(history: &History, options: &TableOptions) -> Self {
        let (scene, ledger, balance) =
            (history.scene(), history.energy().ledger(history.end()), history.energy().balance());
        let (upright, numbers) = (history.seats().uprights(), history.summary());
        let max_tilt = upright.iter().map(|girder| girder.tilt.value).reduce(f64::max);
        let radius = history.model().farthest_corner();
        let turned = numbers.max_rotation.max(max_tilt.unwrap_or(0.0));
        let of_corner = |displacement: f64, rotation: f64| displacement + radius * rotation;
        let error = options.estimated_error.map_or(0.0, |estimate| of_corner(estimate.error, estimate.rotation));
        let stress_error = options.estimated_error.and_then(|estimate| estimate.stress).unwrap_or(0.0);
        let error_share = if error > 0.0 { error / of_corner(numbers.max_displacement, turned) } else { 0.0 };
        Self {
            scene: scene.name.clone(),
            kind: scene.kind,
            model: if history.impact().is_some() { "impact" } else { "contact" },
            duration: scene.duration,
            end: history.end(),
            gave_up: history.stop().cloned(),
            numbers,
            max_tilt,
            pairs: pairs(history),
            verdicts: verdicts::of(history),
            seats: seats::of(history),
            lost_supports: departures::lost(history),
            uplifts: departures::uplifts(upright),
            moved_supports: moved_supports(scene, history.model()),
            bearings: supports::bearings(history),
            backfill: supports::backfill(history),
            piers: supports::piers(history),
            devices: devices::reports(history),
            flexible: flexible::of(history),
            degree_check: options.degree_check,
            limits_passed: departures::passed(history),
            without_friction: history.contacts().without_friction().map(|words| words.to_string()),
            overlaps: departures::overlaps(history),
            too_deep: departures::too_deep(history),
            dropped: departures::dropped(history),
            outside_domain: departures::outside(scene),
            assumed: scene.assumed_numbers().into_iter().map(|(path, _)| path).chain(scene.chosen_numbers()).collect(),
            tolerance: scene.solver.tolerance,
            estimated_error: options.estimated_error.map(|estimate| estimate.error),
            estimated_rotation_error: options.estimated_error.map(|estimate| estimate.rotation),
            estimated_stress_error: options.estimated_error.and_then(|estimate| estimate.stress),
            estimated_until: options.estimated_error.and_then(|estimate| estimate.until),
            error_is_large: error_share > LARGE_ERROR || stress_error > LARGE_STRESS_ERROR,
            error_share,
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

    /// In words, that a comparison with another run goes no further than `until` \[s\]; nothing where it goes to the end.
    pub fn as_far_as(until: Option<f64>) -> String {
        until.map_or_else(String::new, |t| said!("compared-until", "t" => format!("{t:.4}")))
    }

    /// In words, that the estimated error is large; none where it is not, or not known.
    pub fn uncertain(&self) -> Option<String> {
        let error = self.error_in_words().filter(|_| self.error_is_large)?;
        if self.error_share <= LARGE_ERROR {
            let part = format!("{:.1}", 100.0 * self.estimated_stress_error?);
            return Some(said!("uncertain-sections", "part" => part));
        }
        Some(said!("uncertain", "error" => error, "share" => format!("{:.2}", 100.0 * self.error_share)))
    }

    /// The estimated error with units; nothing where it is not known.
    pub fn error_in_words(&self) -> Option<String> {
        let stress = self
            .estimated_stress_error
            .map_or_else(String::new, |part| said!("estimated-stress", "part" => format!("{part:.1e}")));
        Some(format!("{:.2e} m, {:.2e} rad{stress}", self.estimated_error?, self.estimated_rotation_error?))
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
    let totals: BTreeMap<usize, Extreme> = history.hits().largest_resultants().into_iter().collect();
    let mut touched: BTreeMap<usize, (usize, f64)> = BTreeMap::new();
    for touch in history.hits().touches() {
        let (count, most) = touched.entry(touch.pair).or_default();
        (*count, *most) = (*count + 1, most.max(touch.peak_force));
    }
    let of_pair = |number: usize| {
        let (touches, peak_force) = touched.get(&number).copied().unwrap_or_default();
        let pair = &history.model().pairs[number];
        PairReport {
            name: pair.name.clone(),
            law: law_of(history, number),
            touches,
            peak_force,
            peak_total: totals.get(&number).map(|most| most.value),
            restitution: match history.impact() {
                Some(_) => [history.model().impact.restitution_normal; 2],
                None => [pair.contact.restitution_normal, pair.returned_restitution()],
            },
        }
    };
    history.hits().listed_pairs().into_iter().map(of_pair).collect()
}
