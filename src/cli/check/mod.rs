//! `girderbench check`: validates a scene and prints what was understood.

mod backfill;
mod device;
mod flexible;
mod girder;
mod pier;
mod supports;

use super::args::SceneArgs;
use super::console::Console;
use super::digits::six;
use super::domain;
use super::failure::Failure;
use super::summary::name;
use crate::dynamics::{Model, Pair};
use crate::scene::shown::escaped;
use crate::scene::{
    Between, Heading, Kind, ModelKind, Motion, NormalName, RecordMotion, STANDARD_GRAVITY, Scene, seating,
};
use crate::sim;

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
    let model = Model::compile(&scene)?;
    console.print(&text(&scene, &model));
    domain::warn(&scene, console);
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
            console.note(&format!(
                "warning: {}: bearings {} stand beyond the front edge of their seats as placed: make seat_m longer, or place them nearer \
                 to the ends",
                escaped(&girder.name),
                off.join(", ")
            ));
        }
    }
}

/// Warns of bodies that can come near and that no contact joins.
fn unjoined(scene: &Scene, model: &Model, console: &mut Console) {
    let found = sim::unjoined(scene, model);
    for unjoined in found.iter().take(MOST_UNJOINED) {
        let [one, other] = unjoined.bodies.map(|body| escaped(body.name(scene)));
        console.note(&format!(
            "warning: {one} and {other}: {} mm apart as placed, and they move by up to {} mm without contact: no contact is \
             defined between the two, so that they can pass through each other; give `between = \"all\"` in [contact] (contact \
             model), place them farther apart or hold them stiffer, or see `overlap` in the summary of `girderbench run`",
            six(unjoined.apart * 1e3),
            six(unjoined.reach * 1e3)
        ));
    }
    if let Some(more) = found.len().checked_sub(MOST_UNJOINED).filter(|more| *more > 0) {
        console.note(&format!("warning: {more} more such pairs"));
    }
}

fn text(scene: &Scene, model: &Model) -> String {
    let girders = scene.girders.iter().zip(&model.bodies).map(|(g, body)| girder::text(scene, g, body));
    let pairs = model.pairs.iter().enumerate().map(|(number, pair)| pair_text(pair, &nodes(model, number)));
    let elsewhere = match scene.contact.between {
        Between::All => "bodies touch where they meet",
        Between::Ends => "nothing can touch",
    };
    let none = model.pairs.is_empty().then(|| format!("no facing ends: {elsewhere}\n"));
    let soil = scene.abutments.iter().filter_map(|abutment| backfill::text(scene, abutment));
    std::iter::once(head(scene))
        .chain(girders)
        .chain(flexible::texts(model))
        .chain(soil)
        .chain(pier::texts(scene))
        .chain(pairs)
        .chain(none)
        .chain(device::texts(scene))
        .chain(assumed(scene))
        .collect()
}

/// Values that were not given.
fn assumed(scene: &Scene) -> impl Iterator<Item = String> {
    scene
        .assumed_numbers()
        .into_iter()
        .map(|(path, value)| format!("assumed: {} = {}\n", escaped(&path), escaped(&value)))
}

/// What holds for the scene as a whole.
fn head(scene: &Scene) -> String {
    let kind = match scene.kind {
        Kind::Planar => "planar".to_owned(),
        Kind::Spatial => format!("spatial, gravity {} m/s²", six(scene.gravity)),
    };
    format!(
        "{}: {kind}, {} s\nground: {}\nsolver: {}, tolerance {}\nview: {}\n",
        name(&scene.name),
        six(scene.duration),
        motion_words(&scene.motion),
        scene.solver.method.label(),
        six(scene.solver.tolerance),
        scene.view.camera.label()
    )
}

fn motion_words(motion: &Motion) -> String {
    match motion {
        Motion::None => "it stands still".to_owned(),
        Motion::Sine(sine) => {
            let amplitude = sine.amplitude_si();
            let [si, g] = [amplitude, amplitude / STANDARD_GRAVITY].map(six);
            let [frequency, phase, angle] = [sine.frequency_hz, sine.phase_deg, sine.angle_deg].map(six);
            let vertical = match sine.vertical_si() {
                0.0 => String::new(),
                a => {
                    let phase = sine.vertical_phase_deg.unwrap_or(sine.phase_deg);
                    format!(", vertical {} m/s² of phase {}°", six(a), six(phase))
                }
            };
            format!("sine {si} m/s² ({g} g) at {frequency} Hz, phase {phase}°, angle {angle}°{vertical}")
        }
        Motion::Record(record) => recorded(record),
        Motion::Sweep(sweep) => {
            let [amplitude, from, to, length, angle] =
                [sweep.amplitude_g, sweep.from_hz, sweep.to_hz, sweep.length, sweep.angle_deg].map(six);
            let (rate, interval) = (sweep.rate.label(), six(sweep.sweep().interval()));
            format!(
                "{rate} sweep {amplitude} g from {from} to {to} Hz in {length} s, angle {angle}°, samples {interval} s apart"
            )
        }
        Motion::Synthetic(quake) => {
            let largest = quake.samples(0).iter().fold(0.0, |most: f64, a| most.max(a.abs())) / STANDARD_GRAVITY;
            let [seed, peak, length, angle] = [quake.seed, largest, quake.duration, quake.angle_deg].map(six);
            let [_, across, vertical] = quake.factors().map(six);
            let target = quake.deviation(0).map(|off| {
                let pairs = quake.target.as_ref().map_or(0, Vec::len);
                format!(", matched to a spectrum of {pairs} periods, {:.1} % off in the mean", 100.0 * off)
            });
            format!(
                "synthetic earthquake of seed {seed}: {peak} g, {length} s, angle {angle}°, across × {across}, vertical × {vertical}{}",
                target.unwrap_or_default()
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
            scale => format!(", vertical scale {}", six(scale)),
        };
        format!("angle {}°{vertical}", six(record.angle_deg))
    } else {
        let each = |n: usize| match record.heading(n) {
            Some(Heading::Up) => "up".to_owned(),
            Some(Heading::InPlan(angle)) => format!("{}° from x", six(angle)),
            None => "nowhere".to_owned(),
        };
        let all: Vec<String> = (0..record.components.len()).map(each).collect();
        format!("{} components: {}", all.len(), all.join(", "))
    };
    let steps: Vec<String> = record.processing.in_words().into_iter().map(|step| format!(", {step}")).collect();
    format!("record of {count} samples × {dt} s ({length} s), {peak} g, scale {scale}, {direction}{}", steps.concat())
}

fn pair_text(pair: &Pair, nodes: &str) -> String {
    let c = &pair.contact;
    format!(
        "pair {}: gap {} mm along the axis, law {}, sharing {}, tension {}\n{}  \
         K = {} N/m, e_n = {}, e_t = {}, C_n = {} N·s/m, C_t = {} N·s/m (65), μ_s = {}, μ_k = {}\n  \
         nodes: {nodes}\n",
        pair.name,
        six(pair.gap * 1e3),
        c.law.label(),
        c.sharing.label(),
        c.tension.label(),
        normal_law(pair),
        short(c.stiffness),
        six(c.restitution_normal),
        six(c.restitution_tangential),
        short(pair.law.dashpots().normal),
        short(pair.law.dashpots().tangential),
        six(c.mu_static),
        six(c.mu_kinetic)
    )
}

/// Normal law and the restitution that comes back, where that is not `e_n` by (65).
fn normal_law(pair: &Pair) -> String {
    let (c, returned) = (&pair.contact, pair.returned_restitution());
    if c.normal_law == NormalName::DEFAULT && (returned - c.restitution_normal).abs() < RETURNED_ROUNDING {
        return String::new();
    }
    format!(
        "  normal law {}, calibration {}: a free head-on hit at {} m/s returns e = {}\n",
        c.normal_law.label(),
        c.calibration.label(),
        six(c.design_speed),
        six(returned)
    )
}

/// A number that may be very large, to seven digits.
fn short(value: f64) -> String {
    if value < 1e5 { format!("{value:.4}") } else { format!("{value:.6e}") }
}

/// `deck.corner1 on wall, …`
fn nodes(model: &Model, pair: usize) -> String {
    let sites = &model.contacts[model.pairs[pair].contacts.clone()];
    sites.iter().map(|site| format!("{} on {}", site.node, site.face_name)).collect::<Vec<_>>().join(", ")
}
