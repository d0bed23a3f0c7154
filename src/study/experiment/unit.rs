//! The work of the study in units that are done in any order, each once: a case, the series over restitution, a scan.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use xxhash_rust::xxh3::Xxh3;

use super::cases::{Case, Shaking, Specimen};
use super::earthquake::Earthquake;
use super::observe::Observed;
use super::results::{CaseResult, MODELS, Results, SeriesResult};
use super::scan::Scan;
use crate::scene::{ModelKind, Scene, SceneErrors, format};
use crate::sim::History;

/// `e_n` of the series over restitution.
const RESTITUTION: [f64; 7] = [0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8];
/// Counts changes of the results that no scene shows: a file of another count is done again.
const FORM: u64 = 3;

/// Something to be done.
#[derive(Clone, Debug, PartialEq)]
pub enum Unit {
    /// A case of Table 2.
    Case(Case),
    /// Three cases over restitution.
    Series,
    /// A scan.
    Scan(Scan),
}

/// A result as it is kept, with what it is the result of.
#[derive(Debug, Serialize, Deserialize)]
struct Kept<T> {
    /// Fingerprint of the unit.
    of: String,
    result: T,
}

impl Unit {
    /// All of the study: cases in the order of Table 2, series, scans.
    pub fn all() -> Vec<Self> {
        let cases = Case::all().into_iter().map(Self::Case);
        cases.chain([Self::Series]).chain(Scan::all().map(Self::Scan)).collect()
    }

    /// Its name, of its file too.
    pub fn name(&self) -> String {
        match self {
            Self::Case(case) => case.name(),
            Self::Series => "restitution".to_owned(),
            Self::Scan(scan) => scan.name.to_owned(),
        }
    }

    /// Names that stand for it: its own and that of its kind.
    pub fn answers_to(&self, word: &str) -> bool {
        let kind = match self {
            Self::Case(case) => case.specimen.key(),
            Self::Series | Self::Scan(_) => "maps",
        };
        word == kind || word == self.name()
    }

    /// Words that stand for several units.
    pub const KINDS: [&'static str; 5] = ["straight", "skew60", "skew45", "pair", "maps"];

    /// Fingerprint of the inputs of its result: its scenes, its axes, the version of the program.
    ///
    /// # Errors
    /// None: the presets are part of the program.
    pub fn fingerprint(&self, earthquake: &Earthquake) -> Result<String, SceneErrors> {
        let mut hash = Xxh3::new();
        hash.update(&FORM.to_le_bytes());
        hash.update(env!("CARGO_PKG_VERSION").as_bytes());
        let scenes = match self {
            Self::Case(case) => vec![case.scene(earthquake)?],
            Self::Series => series_scenes(earthquake)?,
            Self::Scan(scan) => {
                hash.update(format!("{scan:?}").as_bytes());
                scan.scenes(earthquake)?
            }
        };
        for scene in &scenes {
            hash.update(format::write(scene).as_bytes());
        }
        Ok(format!("{:016x}", hash.digest()))
    }

    /// Does it: the text of its file.
    ///
    /// # Errors
    /// A scene that does not validate.
    pub fn run(&self, earthquake: &Earthquake) -> Result<String, SceneErrors> {
        let of = self.fingerprint(earthquake)?;
        Ok(match self {
            Self::Case(case) => text(&Kept { of, result: case_result(&case.scene(earthquake)?)? }),
            Self::Series => text(&Kept { of, result: series(&series_scenes(earthquake)?)? }),
            Self::Scan(scan) => text(&Kept { of, result: scan.run(earthquake)? }),
        })
    }

    /// Takes its result from the text of its file; `false` where it is of something else.
    pub fn take(&self, kept: &str, fingerprint: &str, results: &mut Results) -> bool {
        match self {
            Self::Case(case) => parse(kept, fingerprint).map(|own| results.cases.insert(case.name(), own)).is_some(),
            Self::Series => parse(kept, fingerprint).map(|own| results.series = Some(own)).is_some(),
            Self::Scan(scan) => {
                parse(kept, fingerprint).map(|own| results.scans.insert(scan.name.to_owned(), own)).is_some()
            }
        }
    }
}

fn text<T: Serialize>(kept: &Kept<T>) -> String {
    // Plain data with string keys: JSON has all of it.
    serde_json::to_string(kept).unwrap_or_default()
}

fn parse<T: DeserializeOwned>(kept: &str, fingerprint: &str) -> Option<T> {
    let kept: Kept<T> = serde_json::from_str(kept).ok()?;
    (kept.of == fingerprint).then_some(kept.result)
}

/// A scene under one model.
fn under(scene: &Scene, model: ModelKind) -> Result<History, SceneErrors> {
    let mut scene = scene.clone();
    scene.model.kind = model;
    History::of(&scene)
}

fn case_result(scene: &Scene) -> Result<CaseResult, SceneErrors> {
    let [contact, impact] = MODELS.map(|model| under(scene, model).map(|history| Observed::of(&history)));
    Ok(CaseResult { models: [contact?, impact?] })
}

/// The cases of the series: head-on and oblique hits of the straight girder, and the 45° girder.
fn series_scenes(earthquake: &Earthquake) -> Result<Vec<Scene>, SceneErrors> {
    let cases = [(Specimen::Straight, 0.0), (Specimen::Straight, 45.0), (Specimen::Skew45, 0.0)];
    cases.map(|(specimen, angle)| Case::new(specimen, angle, Shaking::Large).scene(earthquake)).into_iter().collect()
}

fn series(scenes: &[Scene]) -> Result<SeriesResult, SceneErrors> {
    let run = |scene: &Scene, model: ModelKind, e: f64| {
        let mut scene = scene.clone();
        (scene.contact.restitution_normal, scene.impact.restitution_normal) = (e, e);
        let seen = Observed::without_histories(&under(&scene, model)?);
        Ok(seen.girders[0].largest)
    };
    let of_case = |scene: &Scene, model| RESTITUTION.iter().map(|&e| run(scene, model, e)).collect();
    let of_model =
        |model| scenes.iter().map(|scene| of_case(scene, model)).collect::<Result<Vec<Vec<_>>, SceneErrors>>();
    let [contact, impact] = MODELS.map(of_model);
    Ok(SeriesResult { restitution: RESTITUTION.into(), models: [contact?, impact?] })
}
