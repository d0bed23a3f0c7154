//! `girderbench check`: validates a scene and prints what was understood.

mod device;
mod flexible;
mod girder;
mod moving;
mod supports;

use super::args::SceneArgs;
use super::console::Console;
use super::digits::six;
use super::domain;
use super::failure::Failure;
use super::summary::name;
use crate::dynamics::{Model, Pair};
use crate::language::{Text, said};
use crate::report::in_force;
use crate::scene::keys::word_told;
use crate::scene::shown::escaped;
use crate::scene::{
    Between, Calibration, FrictionLaw, Heading, Kind, ModelKind, Motion, NamedGround, NormalName, RecordMotion,
    STANDARD_GRAVITY, Scene, Sharing, SolverMethod, SweepRate, Tension, ViewPreset, seating,
};
use crate::sim;
use crate::sim::moving_ground::{MovedSupport, moved_supports};

/// Difference of two coefficients of restitution that is round-off \[–\].
const RETURNED_ROUNDING: f64 = 1e-9;
/// So many pairs that can come near without contact are written out.
const MOST_UNJOINED: usize = 10;

/// Validate a scene and print what was understood
#[derive(Clone, Debug, clap::Args)]
pub(super) struct CheckArgs {
    #[command(flatten)]
    scene: SceneArgs,
}

/// Does it.
///
/// # Errors
/// Every complaint about the scene.
pub(super) fn run(args: &CheckArgs, console: &mut Console) -> Result<(), Failure> {
    let scene = args.scene.load()?;
    let model = args.scene.of_its_file(Model::compile(&scene))?;
    let moved = moved_supports(&scene, &model);
    console.print(&text(&scene, &model, &moved));
    domain::warn(&scene, console);
    domain::warn_of_drift(&moved, console);
    off_their_seats(&scene, console);
    // Elsewhere bodies are joined where they meet.
    if scene.contact.between == Between::Ends || scene.model.kind == ModelKind::Impact {
        unjoined(&scene, &model, console);
    }
    Ok(())
}

/// Warns of bearings that do not stand on the seats that the scene gives.
fn off_their_seats(scene: &Scene, console: &mut Console) {
    for girder in &scene.girders {
        let supports = girder.supports(scene.setting());
        let off: Vec<String> = (0..supports.len())
            .filter(|&n| seating::stands_off(girder, &supports[n]) == Some(true))
            .map(|n| (n + 1).to_string())
            .collect();
        if !off.is_empty() {
            console.note(&said!("warning-off-seats", "girder" => escaped(&girder.name), "bearings" => off.join(", ")));
        }
    }
}

/// Warns of bodies that can come near and that no contact joins.
fn unjoined(scene: &Scene, model: &Model, console: &mut Console) {
    let found = sim::unjoined(scene, model);
    for unjoined in found.iter().take(MOST_UNJOINED) {
        let [one, other] = unjoined.bodies.map(|body| escaped(body.name(scene)));
        console.note(&said!(
            "warning-unjoined",
            "one" => one,
            "other" => other,
            "apart" => six(unjoined.apart * 1e3),
            "reach" => six(unjoined.reach * 1e3)
        ));
    }
    if let Some(more) = found.len().checked_sub(MOST_UNJOINED).filter(|more| *more > 0) {
        console.note(&said!("warning-more-unjoined", "more" => more));
    }
}

fn text(scene: &Scene, model: &Model, moved: &[MovedSupport]) -> String {
    let girders = scene.girders.iter().zip(&model.bodies).map(|(g, body)| girder::text(scene, g, body));
    let pairs = model.pairs.iter().enumerate().map(|(number, pair)| pair_text(pair, &nodes(model, number)));
    let elsewhere = match scene.contact.between {
        Between::All => Text::new("check-touch-anywhere"),
        Between::Ends => Text::new("check-touch-nowhere"),
    };
    let none = model.pairs.is_empty().then(|| format!("{}\n", said!("check-no-pairs", "elsewhere" => elsewhere)));
    let soil = scene.abutments.iter().filter_map(|abutment| in_force::soil(scene, abutment)).map(|two| lines(&two));
    let piers = in_force::piers(scene).map(|all| lines(&all));
    std::iter::once(head(scene))
        .chain(girders)
        .chain(flexible::texts(model))
        .chain(moving::texts(moved))
        .chain(soil)
        .chain(piers)
        .chain(pairs)
        .chain(none)
        .chain(device::texts(scene))
        .chain(assumed(scene))
        .collect()
}

/// Lines of one body, those after the first set in.
fn lines(all: &[String]) -> String {
    let shown: Vec<String> = all.iter().map(|line| escaped(line).to_string()).collect();
    shown.join("\n  ") + "\n"
}

/// Values that were not given.
fn assumed(scene: &Scene) -> impl Iterator<Item = String> {
    scene.assumed_numbers().into_iter().map(|(path, value)| {
        format!("{}\n", said!("check-assumed", "path" => escaped(&path), "value" => escaped(&value)))
    })
}

/// What holds for the scene as a whole.
fn head(scene: &Scene) -> String {
    let kind = match scene.kind {
        Kind::Planar => Text::new("check-planar").into(),
        Kind::Spatial => said!("check-spatial", "gravity" => six(scene.gravity)),
    };
    let mut ground = said!("check-head-b", "motion" => motion_words(&scene.motion));
    for NamedGround { name: of, motion } in &scene.grounds {
        ground =
            format!("{ground}\n{}", said!("check-named-ground", "name" => name(of), "motion" => motion_words(motion)));
    }
    format!(
        "{}\n{ground}\n{}\n{}\n",
        said!("check-head", "name" => name(&scene.name), "kind" => kind, "duration" => six(scene.duration)),
        said!(
            "check-head-c",
            "method" => word_told(SolverMethod::WORDS, scene.solver.method.label()),
            "tolerance" => six(scene.solver.tolerance)
        ),
        said!("check-head-d", "camera" => word_told(ViewPreset::WORDS, scene.view.camera.label()))
    )
}

fn motion_words(motion: &Motion) -> String {
    match motion {
        Motion::None => Text::new("check-still").into(),
        Motion::Sine(sine) => {
            let amplitude = sine.amplitude_si();
            let [si, g] = [amplitude, amplitude / STANDARD_GRAVITY].map(six);
            let [frequency, phase, angle] = [sine.frequency_hz, sine.phase_deg, sine.angle_deg].map(six);
            let vertical = match sine.vertical_si() {
                0.0 => String::new(),
                a => {
                    let phase = sine.vertical_phase_deg.unwrap_or(sine.phase_deg);
                    said!("check-sine-vertical", "level" => six(a), "phase" => six(phase))
                }
            };
            said!(
                "check-sine",
                "si" => si,
                "g" => g,
                "frequency" => frequency,
                "phase" => phase,
                "angle" => angle,
                "vertical" => vertical
            )
        }
        Motion::Record(record) => recorded(record),
        Motion::Sweep(sweep) => {
            let [amplitude, from, to, length, angle] =
                [sweep.amplitude_g, sweep.from_hz, sweep.to_hz, sweep.length, sweep.angle_deg].map(six);
            let (rate, interval) = (word_told(SweepRate::WORDS, sweep.rate.label()), six(sweep.sweep().interval()));
            said!(
                "check-sweep",
                "rate" => rate,
                "amplitude" => amplitude,
                "from" => from,
                "to" => to,
                "length" => length,
                "angle" => angle,
                "interval" => interval
            )
        }
        Motion::Synthetic(quake) => {
            let largest = quake.samples(0).iter().fold(0.0, |most: f64, a| most.max(a.abs())) / STANDARD_GRAVITY;
            let [seed, peak, length, angle] = [quake.seed, largest, quake.duration, quake.angle_deg].map(six);
            let [_, across, vertical] = quake.factors().map(six);
            let target = quake.deviation(0).map(|off| {
                let pairs = quake.target.as_ref().map_or(0, Vec::len);
                said!("check-matched", "pairs" => pairs, "off" => format!("{:.1}", 100.0 * off))
            });
            said!(
                "check-synthetic",
                "seed" => seed,
                "peak" => peak,
                "length" => length,
                "angle" => angle,
                "across" => across,
                "vertical" => vertical,
                "target" => target.unwrap_or_default()
            )
        }
    }
}

/// A record: samples, interval, scale, directions, what is done to it.
fn recorded(record: &RecordMotion) -> String {
    let (peak, dt, count) = record.extent().unwrap_or((0.0, 0.0, 0));
    let length = dt * count.saturating_sub(1) as f64;
    let [dt, scale, length, peak] = [dt, record.scale, length, peak / STANDARD_GRAVITY].map(six);
    let direction = if record.components.is_empty() {
        let vertical = match record.vertical_scale {
            0.0 => String::new(),
            scale => said!("check-vertical-scale", "scale" => six(scale)),
        };
        said!("check-angle", "angle" => six(record.angle_deg), "vertical" => vertical)
    } else {
        let each = |n: usize| match record.heading(n) {
            Some(Heading::Up) => Text::new("check-up").into(),
            Some(Heading::InPlan(angle)) => said!("check-from-x", "angle" => six(angle)),
            None => Text::new("check-nowhere").into(),
        };
        let all: Vec<String> = (0..record.components.len()).map(each).collect();
        said!("check-components", "count" => all.len(), "all" => all.join(", "))
    };
    let steps: Vec<String> = record.processing.in_words().into_iter().map(|step| format!(", {step}")).collect();
    said!(
        "check-record",
        "count" => count,
        "dt" => dt,
        "length" => length,
        "peak" => peak,
        "scale" => scale,
        "direction" => direction,
        "steps" => steps.concat()
    )
}

fn pair_text(pair: &Pair, nodes: &str) -> String {
    let c = &pair.contact;
    let rules = said!(
        "check-pair",
        "pair" => pair.name.as_str(),
        "gap" => six(pair.gap * 1e3),
        "law" => word_told(FrictionLaw::WORDS, c.law.label()),
        "sharing" => word_told(Sharing::WORDS, c.sharing.label()),
        "tension" => word_told(Tension::WORDS, c.tension.label())
    );
    let dashpots = pair.law.dashpots();
    let numbers = format!(
        "K = {} N/m, e_n = {}, e_t = {}, C_n = {} N·s/m, C_t = {} N·s/m (65), μ_s = {}, μ_k = {}",
        short(c.stiffness),
        six(c.restitution_normal),
        six(c.restitution_tangential),
        short(dashpots.normal + 0.0),
        short(dashpots.tangential + 0.0),
        six(c.mu_static),
        six(c.mu_kinetic)
    );
    format!("{rules}\n{}  {numbers}\n  {}\n", normal_law(pair), said!("check-nodes", "nodes" => nodes))
}

/// Normal law and the restitution that comes back, where that is not `e_n` by (65).
fn normal_law(pair: &Pair) -> String {
    let (c, returned) = (&pair.contact, pair.returned_restitution());
    if c.normal_law == NormalName::DEFAULT && (returned - c.restitution_normal).abs() < RETURNED_ROUNDING {
        return String::new();
    }
    format!(
        "  {}\n",
        said!(
            "check-normal-law",
            "law" => word_told(NormalName::WORDS, c.normal_law.label()),
            "calibration" => word_told(Calibration::WORDS, c.calibration.label()),
            "speed" => six(c.design_speed),
            "e" => six(returned)
        )
    )
}

/// A number that may be very large, to seven digits.
fn short(value: f64) -> String {
    if value < 1e5 { format!("{value:.4}") } else { format!("{value:.6e}") }
}

/// `deck.corner1 on wall, …`
fn nodes(model: &Model, pair: usize) -> String {
    let sites = &model.contacts[model.pairs[pair].contacts.clone()];
    sites
        .iter()
        .map(|site| said!("check-node", "node" => site.node.as_str(), "face" => site.face_name.to_string()))
        .collect::<Vec<_>>()
        .join(", ")
}
