//! Answers stay as they are, bit for bit: digests of every preset, every lesson and 200 seeded scenes, contact and impact
//! model, planar and spatial.
//!
//! `tests/data/digests/ARCHITECTURE.txt` holds one line a scene: the digest of what the run stored ([`History::digest`])
//! and of what it answers (motions and contacts at fixed times, events). A change of how steps are stored moves the
//! first column alone; a change of the answer moves both, and its commit says which lines and by how many metres.
//! `GIRDERBENCH_BLESS=1` writes the file anew.
//!
//! Elementary functions come from the system's mathematical library, and libraries may round the last bit differently: the
//! first line is a digest of samples of these functions. Where it differs, the scenes cannot be compared and the test says so.

use std::fmt::Write as _;
use std::path::PathBuf;

use girderbench::scene::{Kind, ModelKind, Scene, format, overrides, presets};
use girderbench::sim::{History, Session};
use girderbench::study::stability::family;
use glam::DVec3;
use rayon::prelude::*;
use xxhash_rust::xxh3::Xxh3;

/// Seeded scenes under the contact model, and planar ones under the impact model.
const CONTACT_SEEDS: usize = 140;
const IMPACT_SEEDS: usize = 60;
/// Simulated time of a seeded scene at most, under the contact model and under the impact model, which counts no events and
/// takes minutes over some of these scenes otherwise \[s\].
const LONGEST: [f64; 2] = [2.0, 0.25];
/// A seeded scene is computed until it has had so many events.
const EVENTS: usize = 200;
/// Instants at which an answer is asked for its state.
const INSTANTS: u32 = 32;

/// A scene and the name that its line bears.
struct Case {
    name: String,
    scene: Scene,
}

fn lessons() -> Vec<Case> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/lessons");
    let mut cases = Vec::new();
    for entry in std::fs::read_dir(folder).expect("the lessons' folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        if name.ends_with(".lesson.toml") {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a lesson's scene");
        let scene = format::parse(&text, &name).unwrap_or_else(|errors| panic!("{errors}"));
        cases.push(Case { name: format!("lesson {name}"), scene });
    }
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    cases
}

fn preset_cases() -> Vec<Case> {
    let load = |name: &str| presets::load(name).unwrap_or_else(|errors| panic!("{errors}"));
    presets::all().iter().map(|p| Case { name: format!("preset {}", p.name), scene: load(p.name) }).collect()
}

/// The first seeds of a model, an hour's shaking apart.
fn seeds(model: ModelKind, count: usize) -> Vec<Case> {
    let of = |seed: u64| {
        let (family, mut scene) = family::scene(seed);
        let fits = family != family::HOURS && (model == ModelKind::Contact || scene.kind == Kind::Planar);
        scene.model.kind = model;
        scene.duration = scene.duration.min(LONGEST[usize::from(model == ModelKind::Impact)]);
        let (model, kind) = (format!("{model:?}").to_lowercase(), format!("{:?}", scene.kind).to_lowercase());
        fits.then(|| Case { name: format!("{model} {kind} {family} seed {seed}"), scene })
    };
    (0..).filter_map(of).take(count).collect()
}

fn cases() -> Vec<Case> {
    let mut all = preset_cases();
    all.extend(lessons());
    all.extend(seeds(ModelKind::Contact, CONTACT_SEEDS));
    all.extend(seeds(ModelKind::Impact, IMPACT_SEEDS));
    all
}

/// Samples of the elementary functions that the solver uses.
fn elementary_functions() -> u64 {
    let mut hash = Xxh3::new();
    for i in 1..=4000_u32 {
        let x = f64::from(i) * 0.013_7 - 20.0;
        let each = [x.sin(), x.cos(), x.tan(), x.exp(), x.sinh(), x.cosh(), x.atan(), x.atan2(1.3), x.exp_m1()];
        let positive = [x.abs().ln(), x.abs().powf(0.2), x.abs().powf(-0.125), x.abs().cbrt(), x.hypot(0.7)];
        for y in each.into_iter().chain(positive) {
            hash.update(&y.to_bits().to_le_bytes());
        }
    }
    hash.digest()
}

/// Hash of what a history answers, whatever it is stored as.
fn answer(history: &History) -> u64 {
    let mut hash = Xxh3::new();
    let mut add = |x: f64| hash.update(&x.to_bits().to_le_bytes());
    for i in 0..=INSTANTS {
        let t = history.end() * f64::from(i) / f64::from(INSTANTS);
        for girder in 0..history.scene().girders.len() {
            let motion = history.motion(girder, t);
            let rates = [motion.displacement, motion.velocity, motion.spin];
            rates.iter().flat_map(DVec3::to_array).chain(motion.attitude.to_array()).for_each(&mut add);
            add(motion.theta);
        }
        for contact in history.contacts().at(t) {
            [contact.contact as f64, contact.penetration].into_iter().for_each(&mut add);
            [contact.point, contact.anchor, contact.force].iter().flat_map(DVec3::to_array).for_each(&mut add);
        }
    }
    for event in history.events() {
        [event.t, event.released].into_iter().for_each(&mut add);
        event.kind.label().bytes().map(f64::from).for_each(&mut add);
    }
    hash.digest()
}

fn line(case: &Case) -> String {
    let mut session = Session::new(&case.scene).unwrap_or_else(|errors| panic!("{}: {errors}", case.name));
    // Of a seeded scene the beginning is enough: what is computed in portions is the same as in one go.
    let most = if case.name.contains("seed") { EVENTS } else { usize::MAX };
    session.advance(case.scene.duration, &mut |reached| reached.events < most);
    let history = session.finish();
    format!("{}: {:016x} {:016x} until {}", case.name, history.digest(), answer(&history), history.end())
}

/// A girder that flies from the first instant to the last is kept by its start, which these scenes share.
#[test]
fn another_motion_in_closed_form_has_another_digest() {
    let digest = |set: &str| {
        let text = "name = \"deck\"\nduration_s = 5.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\nmass_kg = 6e5\n\
                    bearings = { frequency_hz = 1.0, damping_ratio = 0.05, at_m = [[14, 4], [14, -4], [-14, 4], [-14, -4]] }\n\
                    [motion]\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 0.8\n";
        let scene = format::parse(text, "deck").and_then(|scene| overrides::apply(&scene, set));
        let history = History::of(&scene.unwrap_or_else(|errors| panic!("{errors}"))).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(history.effort().steps, 0, "{set}: it flies");
        history.digest()
    };
    let sets = ["motion.angle_deg=0", "motion.angle_deg=1", "motion.amplitude_g=0.2", "motion.frequency_hz=1.3"];
    let sets =
        sets.into_iter().chain(["girder.deck.bearings.frequency_hz=2", "girder.deck.bearings.damping_ratio=0.2"]);
    let digests: std::collections::BTreeSet<u64> = sets.map(digest).collect();
    assert_eq!(digests.len(), 6, "one each");
}

#[test]
#[expect(clippy::print_stderr, reason = "a skip is said")]
fn answers_are_the_committed_ones_bit_for_bit() {
    let file = format!("tests/data/digests/{}.txt", std::env::consts::ARCH);
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(&file);
    let mut now = format!("elementary functions: {:016x}\n", elementary_functions());
    let lines: Vec<String> = cases().par_iter().map(line).collect();
    for line in &lines {
        writeln!(now, "{line}").expect("a string takes a line");
    }
    if std::env::var_os("GIRDERBENCH_BLESS").is_some() {
        std::fs::write(&path, &now).expect("the file of digests");
        return;
    }
    let Ok(committed) = std::fs::read_to_string(&path) else {
        eprintln!(
            "skipped: no digests of this processor; GIRDERBENCH_BLESS=1 on a commit whose answers are known to be right writes {file}"
        );
        return;
    };
    if committed.lines().next() != now.lines().next() {
        eprintln!("skipped: the mathematical library here rounds differently from that of {file}");
        return;
    }
    let changed: Vec<String> = (committed.lines().zip(now.lines()))
        .filter(|(before, after)| before != after)
        .map(|(before, after)| format!("- {before}\n+ {after}"))
        .collect();
    assert!(changed.is_empty(), "{} of {} changed:\n{}", changed.len(), lines.len(), changed.join("\n"));
    assert_eq!(committed.lines().count(), now.lines().count(), "as many scenes as before");
}
