//! What `check` says of a girder: its shape, where and how it starts, what it stands on.

use std::f64::consts::TAU;

use super::supports;
use crate::cli::digits::{list, six};
use crate::dynamics::Body;
use crate::dynamics::model::bearing::{Bearing, BearingQuantities};
use crate::scene::shown::escaped;
use crate::scene::{Direction, Girder, Initial, Kind, Push, ResolvedBearing, Scene, Seat, Setting};

/// All of it, a fact a line.
pub(super) fn text(scene: &Scene, girder: &Girder, body: &Body) -> String {
    let (kind, setting) = (scene.kind, scene.setting());
    let own = bearings_of(girder, body, setting);
    let shape = shape(girder, body);
    let place = format!("  at {} m, heading {}°\n", list(&girder.position), six(girder.heading_deg));
    let rotation = rotation(girder);
    [shape, place, start(&girder.initial), push(&girder.push), held(&girder.held), seats(girder.seat)]
        .into_iter()
        .chain([
            bearings(&BearingQuantities::of(&own, body.mass, body.gyration2), own.len()),
            on_piers(scene, girder),
            supports::text(girder, setting),
            vertical(body, &own, kind),
            rotation,
        ])
        .collect()
}

fn shape(girder: &Girder, body: &Body) -> String {
    let [length, width, thickness, mass, skew, complement, gyration] = [
        girder.length,
        girder.width,
        girder.thickness,
        girder.mass,
        girder.skew_deg,
        90.0 - girder.skew_deg,
        body.quantities().gyration,
    ]
    .map(six);
    format!(
        "girder {}: {length} × {width} × {thickness} m, {mass} kg, β = {skew}° (skew_US {complement}°), \
         i = {gyration} m\n",
        girder.name
    )
}

fn start(initial: &Initial) -> String {
    if *initial == Initial::default() {
        return String::new();
    }
    let [pitch, roll, pitch_rate, roll_rate] =
        [initial.pitch_deg, initial.roll_deg, initial.pitch_deg_s, initial.roll_deg_s].map(|v| v.unwrap_or(0.0));
    let tilted = if [pitch, roll, pitch_rate, roll_rate] == [0.0; 4] {
        String::new()
    } else {
        let [pitch, roll, pitch_rate, roll_rate] = [pitch, roll, pitch_rate, roll_rate].map(six);
        format!(", pitched by {pitch}° at {pitch_rate}°/s, rolled by {roll}° at {roll_rate}°/s")
    };
    format!(
        "  starts displaced by {} m, turned by {}°, at {} m/s, {}°/s{tilted}\n",
        list(&initial.displacement),
        six(initial.rotation_deg),
        list(&initial.velocity),
        six(initial.spin_deg_s)
    )
}

fn push(push: &Push) -> String {
    if *push == Push::default() {
        return String::new();
    }
    let moments = match push.moments() {
        [0.0, 0.0, z] => six(z),
        all => list(&all),
    };
    format!("  pushed by {} N and {moments} N·m\n", list(&push.force))
}

fn held(directions: &[Direction]) -> String {
    if directions.is_empty() {
        return String::new();
    }
    let name = |direction: &Direction| match direction {
        Direction::X => "x",
        Direction::Y => "y",
        Direction::Z => "z",
        Direction::Roll => "roll",
        Direction::Pitch => "pitch",
        Direction::Yaw => "yaw",
    };
    format!("  held in {}\n", directions.iter().map(name).collect::<Vec<_>>().join(", "))
}

fn seats(seat: Seat) -> String {
    let ends = [("+x", seat.plus), ("-x", seat.minus)];
    let of_end = |(end, length): (&str, Option<f64>)| Some(format!("{} m under {end}", six(length?)));
    let given: Vec<_> = ends.into_iter().filter_map(of_end).collect();
    let wider = seat.side.map_or(String::new(), |side| format!(", {} m wider than the deck at either side", six(side)));
    if given.is_empty() { String::new() } else { format!("  seats: {}{wider}\n", given.join(", ")) }
}

/// (3), (4): what the bearings make of the girder, in its own axes.
fn bearings(q: &BearingQuantities, count: usize) -> String {
    if count == 0 {
        return "  no bearings\n".to_owned();
    }
    let three = |[x, y, theta]: [f64; 3]| format!("{x:.5}, {y:.5}, {theta:.5}");
    let two = |[x, y]: [f64; 2]| format!("{}, {} mm", micrometres(x), micrometres(y));
    format!(
        "  {count} bearings: ω_x, ω_y, ω_θ = {} rad/s ({} Hz); h_x, h_y, h_θ = {}\n  \
         eccentricities of stiffness ε_x, ε_y = {}, of dashpots η_x, η_y = {}\n",
        three(q.omega),
        three(q.omega.map(|omega| omega / TAU)),
        three(q.damping_ratio),
        two(q.stiffness_eccentricity),
        two(q.damping_eccentricity)
    )
}

/// Its bearings as on ground, wherever they stand.
fn bearings_of(girder: &Girder, body: &Body, setting: Setting) -> Vec<Bearing> {
    let as_given = |(own, given): (&Bearing, ResolvedBearing)| Bearing {
        stiffness: given.stiffness.into(),
        damping: given.damping.into(),
        ..*own
    };
    body.bearings.iter().zip(girder.supports(setting)).map(as_given).collect()
}

/// How many of its bearings stand on piers, and on which.
fn on_piers(scene: &Scene, girder: &Girder) -> String {
    let mut piers: Vec<usize> = scene.supports(girder).into_iter().flatten().collect();
    if piers.is_empty() {
        return String::new();
    }
    let count = piers.len();
    piers.sort_unstable();
    piers.dedup();
    let names: Vec<String> = piers.iter().map(|&number| escaped(&scene.piers[number].name).into_owned()).collect();
    format!("  {count} of them on {}; frequencies are those on piers that stand still\n", names.join(", "))
}

/// What the bearings make of a spatial girder that moves straight up and down.
fn vertical(body: &Body, bearings: &[Bearing], kind: Kind) -> String {
    if kind == Kind::Planar || bearings.is_empty() {
        return String::new();
    }
    let sum = |of: fn(&Bearing) -> f64| bearings.iter().map(of).sum::<f64>();
    let (stiffness, damping) = (sum(|b| b.stiffness.z), sum(|b| b.damping.z));
    let omega = (stiffness / body.mass).sqrt();
    let ratio = if omega > 0.0 { damping / (2.0 * body.mass * omega) } else { 0.0 };
    format!("  vertical: ω_z = {omega:.5} rad/s ({:.5} Hz), h_z = {ratio:.5}\n", omega / TAU)
}

/// A length in mm to the micrometre; adding 0 turns −0 into 0.
fn micrometres(length: f64) -> f64 {
    (length * 1e6).round() / 1e3 + 0.0
}

/// Condition (6), written for β < 90°; the mirrored girder turns as easily, a straight one never.
fn rotation(girder: &Girder) -> String {
    let number = girder.prism().rotation_number().abs();
    let can = if number >= 1.0 { "it can rotate" } else { "it cannot rotate by itself" };
    format!("  condition (6): a0 sin 2β / (2 b0) = {number:.3}: {can}\n")
}
