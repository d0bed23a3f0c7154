//! Every normal law on one hit and on one run of ten seconds: what comes back, how deep, how long, how hard, and force against
//! penetration (`docs/laws/laws.md`).

mod page;

pub use page::{csv, page, pictures};

use rayon::prelude::*;

use crate::contact::NormalName;
use crate::scene::{Scene, SceneErrors, overrides, presets};
use crate::sim::History;

/// Impact speed of the hit, that of the laws' design \[m/s\].
const SPEED: f64 = 0.3;
/// Coefficient of restitution asked for.
const ASKED: f64 = 0.4;
/// Points of the touch of one hit, and of each of the ten seconds.
const POINTS: [u32; 2] = [400, 50];
/// Points of a history.
const INSTANTS: u32 = 1500;

/// A law with its options, as keys of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variant {
    /// The law.
    pub law: NormalName,
    /// Ending of its name after the law's.
    pub beyond: &'static str,
    /// Keys of `[contact]` beside `normal_law`.
    settings: &'static [&'static str],
}

impl Variant {
    /// Name in tables and plots.
    pub fn name(&self) -> String {
        format!("{}{}", self.law.label(), self.beyond)
    }
}

/// Every law calibrated exactly; the linear one also as in the paper, and held at 0 or above; the bilinear one also as published.
pub fn variants() -> Vec<Variant> {
    let exact: &[&str] = &["contact.calibration=\"exact\""];
    let mut all: Vec<Variant> =
        NormalName::ALL.iter().map(|&law| Variant { law, beyond: "", settings: exact }).collect();
    let linear = NormalName::DEFAULT;
    let clamped: &[&str] = &["contact.calibration=\"exact\"", "contact.tension=\"clamp\""];
    all.insert(1, Variant { law: linear, beyond: ", clamp", settings: clamped });
    all
}

/// Results of a law.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The law.
    pub variant: Variant,
    /// e' of the hit: speed after over speed before.
    pub returned: f64,
    /// Greatest penetration of the hit \[m\].
    pub depth: f64,
    /// Duration of its contact \[s\].
    pub lasting: f64,
    /// Its greatest force \[N\].
    pub force: f64,
    /// Force on the face against penetration \[m, N\], of the whole hit.
    pub hit: Vec<[f64; 2]>,
    /// Hits of the ten seconds.
    pub hits: usize,
    /// Their greatest force \[N\].
    pub greatest: f64,
    /// Largest displacement of the ten seconds \[m\].
    pub displacement: f64,
    /// Energy that contacts lost \[J\].
    pub lost: f64,
    /// Force against penetration of every touch of the ten seconds, a break between two \[m, N\].
    pub touches: Vec<[f64; 2]>,
    /// Displacement along x over time \[s, m\].
    pub motion: Vec<[f64; 2]>,
    /// Residual of the ledger of the ten seconds over the largest energy.
    pub residual: f64,
}

/// Both scenes under every law.
///
/// # Errors
/// A preset that does not take a law.
pub fn study() -> Result<Vec<Outcome>, SceneErrors> {
    variants().into_par_iter().map(outcome).collect()
}

fn outcome(variant: Variant) -> Result<Outcome, SceneErrors> {
    let hit = History::of(&scene(
        "flush-free-hit",
        &variant,
        &[&format!("girder.deck.initial.velocity_m_s=[{SPEED}, 0.0]")],
    )?)?;
    let run = History::of(&scene("straight-abutment", &variant, &[])?)?;
    let (touch, ledger, summary) =
        (hit.hits().touches().first().copied(), run.energy().ledger(run.end()), run.summary());
    let lasting = touch.map_or(0.0, |touch| touch.end - touch.start);
    let loops = |history: &History, points: u32| -> Vec<[f64; 2]> {
        let pairs = 0..history.model().pairs.len();
        pairs.flat_map(|pair| of_pair(history, pair, points)).collect()
    };
    let points = loops(&hit, POINTS[0]);
    let largest = |axis: usize| points.iter().map(|point| point[axis]).filter(|v| v.is_finite()).fold(0.0, f64::max);
    let end = run.end();
    let along = |i: u32| {
        let t = end * f64::from(i) / f64::from(INSTANTS);
        [t, run.motion(0, t).displacement.x]
    };
    Ok(Outcome {
        variant,
        returned: -hit.motion(0, hit.end()).velocity.x / SPEED,
        depth: largest(0),
        lasting,
        force: largest(1),
        hits: summary.hits,
        greatest: summary.peak_force * run.model().pairs[0].nodes().count() as f64,
        displacement: summary.max_displacement,
        lost: ledger.loss_normal + ledger.loss_tangential + ledger.loss_friction + ledger.jump_open,
        touches: loops(&run, POINTS[1]),
        motion: (0..=INSTANTS).map(along).collect(),
        residual: (ledger.residual / ledger.scale).abs(),
        hit: points,
    })
}

fn scene(preset: &str, variant: &Variant, more: &[&str]) -> Result<Scene, SceneErrors> {
    let law = format!("contact.normal_law=\"{}\"", variant.law.label());
    let asked = format!("contact.restitution_normal={ASKED}");
    let tolerance = "solver.tolerance=1e-12";
    let all: Vec<&str> =
        [law.as_str(), &asked, tolerance].iter().chain(variant.settings).chain(more).copied().collect();
    overrides::apply_all(&presets::load(preset)?, &all)
}

/// Penetration and force of a pair's flush touches, its nodes together; a break after each.
fn of_pair(history: &History, pair: usize, points: u32) -> Vec<[f64; 2]> {
    let nodes: Vec<usize> = history.model().pairs[pair].nodes().collect();
    let Some(&first) = nodes.first() else { return Vec::new() };
    let touches = history.hits().touches().iter().filter(|touch| touch.contact == first);
    let at = |t: f64| {
        let now: Vec<_> = nodes.iter().filter_map(|&node| history.contacts().contact_at(node, t)).collect();
        let depth = now.iter().map(|contact| contact.penetration).fold(0.0, f64::max);
        [depth, now.iter().map(|contact| contact.normal_force + contact.normal_damping).sum()]
    };
    let of_touch = |touch: &crate::sim::Touch| {
        let (start, length) = (touch.start, touch.end - touch.start);
        // Within the touch: at its very ends the contact is open.
        let times = (0..=points).map(move |i| start + length * (f64::from(i) + 0.001) / (f64::from(points) + 0.002));
        times.map(at).chain([[f64::NAN; 2]]).collect::<Vec<_>>()
    };
    touches.flat_map(of_touch).collect()
}
