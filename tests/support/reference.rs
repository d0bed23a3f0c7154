//! Trajectories computed by an independent program (see `tests/data/README.md`), and the same cases as scenes.

use std::io::Read;
use std::path::PathBuf;

use girderbench::geometry::End;
use girderbench::scene::{
    Abutment, Bearings, ContactSettings, Direction, FrictionLaw, Girder, ImpactSettings, Initial, ModelKind,
    ModelSettings, Motion, PairSettings, PerDirection, Push, RecordMotion, Scene, SharedBearings, Sharing, SineMotion,
    SolverSettings, Tension,
};
use serde_json::Value;

/// A reference case: its scene, its samples and its events.
pub(crate) struct Case {
    /// `c05_skew45_+0_040`.
    pub name: String,
    /// The case as a scene.
    pub scene: Scene,
    /// Rows of `t`, then `x y theta vx vy omega` per girder.
    pub rows: Vec<Vec<f64>>,
    /// `(t, node, kind)`, the misses left out.
    pub events: Vec<(f64, String, String)>,
    /// Hits of the impact model.
    pub hits: Vec<ReferenceHit>,
}

/// A hit of the impact model.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReferenceHit {
    /// When.
    pub t: f64,
    /// Whether a whole face was hit.
    pub flush: bool,
    /// First impulse per unit mass along normal and tangent.
    pub impulse: [f64; 2],
}

fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().map(|a| a.iter().map(number).collect()).unwrap_or_default()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number in the reference case")
}

fn text(value: &Value) -> &str {
    value.as_str().expect("a word in the reference case")
}

/// What is written of a case.
pub(crate) fn value(name: &str) -> Value {
    let json = std::fs::read_to_string(data(&format!("{name}.json"))).expect("the reference case is in tests/data");
    serde_json::from_str(&json).expect("the reference case is JSON")
}

/// Reads a case.
pub(crate) fn load(name: &str) -> Case {
    let value = value(name);
    let events = value["result"]["events"]
        .as_array()
        .expect("events")
        .iter()
        .filter(|e| text(&e["kind"]) != "miss" && e["node"].is_string())
        .map(|e| (number(&e["t"]), text(&e["node"]).to_owned(), text(&e["kind"]).to_owned()))
        .collect();
    let hits = value["result"]["events"].as_array().expect("events").iter().filter_map(hit).collect();
    Case { name: name.to_owned(), scene: scene(&value["case"]), rows: rows(name), events, hits }
}

fn hit(event: &Value) -> Option<ReferenceHit> {
    let flush = match text(&event["kind"]) {
        "flush hit" => true,
        "corner hit" => false,
        _ => return None,
    };
    Some(ReferenceHit { t: number(&event["t"]), flush, impulse: [number(&event["Q_n"]), number(&event["Q_s"])] })
}

/// The samples of a case, row by row.
pub(crate) fn rows(name: &str) -> Vec<Vec<f64>> {
    let file = std::fs::File::open(data(&format!("{name}.csv.gz"))).expect("the reference samples are in tests/data");
    let mut csv = String::new();
    flate2::read::GzDecoder::new(file).read_to_string(&mut csv).expect("gzip");
    csv.lines().skip(1).map(|l| l.split(',').map(|x| x.parse().expect("a number")).collect()).collect()
}

fn scene(case: &Value) -> Scene {
    let girders: Vec<Girder> =
        case["bodies"].as_array().expect("bodies").iter().enumerate().map(|(i, b)| girder(i, b)).collect();
    let abutments = case["walls"].as_array().expect("walls").iter().map(|w| wall(w, &girders)).collect();
    let pairs = case["pairs"].as_array().expect("pairs").iter().map(pair).collect();
    Scene {
        contact: if case["K"].is_null() { ContactSettings::default() } else { contact(case, pairs) },
        model: model(case),
        impact: impact(case),
        motion: motion(&case["excitation"]),
        solver: SolverSettings { tolerance: 1e-12, ..SolverSettings::default() },
        girders,
        abutments,
        ..Scene::empty(text(&case["name"]), number(&case["T"]))
    }
}

fn girder(index: usize, body: &Value) -> Girder {
    let (home, x0, mut push) = (numbers(&body["home"]), numbers(&body["x0"]), numbers(&body["push"]));
    // Some cases have none.
    push.resize(3, 0.0);
    let legs: Vec<[f64; 2]> =
        body["legs"].as_array().expect("legs").iter().map(|l| [number(&l[0]), number(&l[1])]).collect();
    let frequency = number(&body["fx"]);
    let bearings = (frequency > 0.0).then(|| {
        Bearings::Shared(SharedBearings {
            frequency_hz: PerDirection::Both(frequency),
            damping_ratio: PerDirection::Both(number(&body["hx"])),
            vertical_frequency_hz: None,
            vertical_damping_ratio: None,
            on_minus_x: None,
            on_plus_x: None,
            at_skewed: None,
            height: None,
            travel: None,
            at: Some(legs),
        })
    });
    let held = numbers(&body["lock"])
        .into_iter()
        .zip([Direction::X, Direction::Y, Direction::Yaw])
        .filter_map(|(lock, direction)| (lock != 0.0).then_some(direction))
        .collect();
    let shape = [number(&body["a0"]), number(&body["b0"]), 0.02];
    Girder {
        skew_deg: number(&body["beta_deg"]),
        position: [home[0], home[1], 0.0],
        bearings,
        initial: Initial {
            displacement: [x0[0], x0[1], 0.0],
            rotation_deg: x0[2].to_degrees(),
            velocity: [x0[3], x0[4], 0.0],
            spin_deg_s: x0[5].to_degrees(),
            ..Initial::default()
        },
        push: Push { force: [push[0], push[1], 0.0], moment: push[2], ..Push::default() },
        held,
        ..Girder::straight(format!("body{index}"), shape, number(&body["m"]))
    }
}

fn end(label: &str) -> End {
    if label == "+x" { End::Plus } else { End::Minus }
}

fn wall(wall: &Value, girders: &[Girder]) -> Abutment {
    let body = usize::try_from(wall["body"].as_u64().expect("body")).expect("small");
    let label = text(&wall["end"]);
    Abutment {
        delay: None,
        motion_factor: None,
        ground: None,
        backfill: None,
        name: format!("wall{label}"),
        faces: girders[body].name.clone(),
        end: end(label),
        gap: Some(number(&wall["gap"])),
        // "Wide": nobody comes near its edges.
        width: Some(wall["half_width"].as_f64().map_or(40.0 * girders[body].length, |w| 2.0 * w)),
        height: Some(0.06),
        offset: None,
        polygon: None,
        depth: None,
    }
}

fn pair(pair: &Value) -> PairSettings {
    let side = |s: &Value| (format!("body{}", s[0]), end(text(&s[1])));
    let (a, b) = (side(&pair["a"]), side(&pair["b"]));
    PairSettings { between: [a.0, b.0], ends: Some([a.1, b.1]), ..PairSettings::default() }
}

fn contact(case: &Value, pairs: Vec<PairSettings>) -> ContactSettings {
    ContactSettings {
        stiffness: Some(number(&case["K"])),
        // No dashpot is a restitution of 1.
        restitution_normal: case["en"].as_f64().unwrap_or(1.0),
        restitution_tangential: case["et"].as_f64().unwrap_or(1.0),
        mu_static: number(&case["mus"]),
        mu_kinetic: number(&case["muk"]),
        law: if text(&case["law"]) == "paper" { FrictionLaw::Paper } else { FrictionLaw::ReturnMapping },
        sharing: if case["sharing"] == "tributary" { Sharing::Tributary } else { Sharing::PerNode },
        tension: if case["tension"] == true { Tension::Keep } else { Tension::Clamp },
        pairs,
        ..ContactSettings::default()
    }
}

fn model(case: &Value) -> ModelSettings {
    let kind = if case["model"].as_str() == Some("impact") { ModelKind::Impact } else { ModelKind::Contact };
    ModelSettings { kind }
}

fn impact(case: &Value) -> ImpactSettings {
    let number = |key: &str| case[key].as_f64();
    let standard = ImpactSettings::default();
    ImpactSettings {
        restitution_normal: number("en2d").unwrap_or(standard.restitution_normal),
        restitution_tangential: number("et2d").unwrap_or(standard.restitution_tangential),
        mu_static: number("mus").unwrap_or(standard.mu_static),
        mu_kinetic: number("muk").unwrap_or(standard.mu_kinetic),
        stop_speed: number("vstop").unwrap_or(standard.stop_speed),
        ..standard
    }
}

fn motion(excitation: &Value) -> Motion {
    match text(&excitation["kind"]) {
        "harmonic" => Motion::Sine(SineMotion {
            amplitude_g: None,
            amplitude: Some(number(&excitation["amp"])),
            frequency_hz: number(&excitation["f"]),
            phase_deg: number(&excitation["phi0"]).to_degrees(),
            angle_deg: number(&excitation["angle_deg"]),
            vertical_amplitude_g: None,
            vertical_amplitude: None,
            vertical_phase_deg: None,
        }),
        "record" => Motion::Record(record(excitation)),
        _ => Motion::None,
    }
}

fn record(excitation: &Value) -> RecordMotion {
    RecordMotion {
        samples: Some(numbers(&excitation["samples"])),
        dt: Some(number(&excitation["dt"])),
        scale: number(&excitation["scale"]),
        angle_deg: number(&excitation["angle_deg"]),
        ..RecordMotion::default()
    }
}
