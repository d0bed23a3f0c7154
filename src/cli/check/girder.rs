//! Text of `check` on a girder: its shape, its place and initial state, its bearings.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use glam::DVec2;

use super::supports;
use crate::cli::digits::{list, six};
use crate::codes::RotationCondition;
use crate::dynamics::Body;
use crate::dynamics::model::bearing::{Bearing, BearingQuantities};
use crate::language::{Text, said};
use crate::scene::shown::escaped;
use crate::scene::{Direction, Girder, Initial, Kind, Push, Scene, Seat, StandsOn};
use crate::sim::connections::bearing_quantities::bearings_as_given;

/// All of it, a fact a line.
pub(super) fn text(scene: &Scene, girder: &Girder, body: &Body) -> String {
    let (kind, setting) = (scene.kind, scene.setting());
    let own = bearings_as_given(girder, body, setting);
    let shape = shape(girder, body);
    let place = format!(
        "  {}\n",
        said!("check-girder-place", "place" => list(&girder.position), "heading" => six(girder.heading_deg))
    );
    let rotation = rotation(girder);
    [shape, place, start(&girder.initial), push(&girder.push), held(&girder.held), seats(girder.seat)]
        .into_iter()
        .chain([
            plausible(girder),
            bearings(&BearingQuantities::of(&own, body.mass, body.gyration2), own.len()),
            on_supports(scene, girder),
            supports::text(girder, setting),
            vertical(body, &own, kind),
            in_dish(girder, body, scene),
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
        "{}\n",
        said!(
            "check-girder",
            "name" => girder.name.as_str(),
            "length" => length,
            "width" => width,
            "thickness" => thickness,
            "mass" => mass,
            "skew" => skew,
            "complement" => complement,
            "gyration" => gyration
        )
    )
}

/// Densities \[kg/m³\] beyond which a mass is not that of its girder's size: below a hollow box of steel, above solid steel with what
/// lies on it. Chosen.
const DENSITIES: [f64; 2] = [50.0, 2e4];

/// A word on a mass that does not fit the girder's size.
fn plausible(girder: &Girder) -> String {
    let density = girder.mass / (girder.length * girder.width * girder.thickness);
    if (DENSITIES[0]..=DENSITIES[1]).contains(&density) {
        return String::new();
    }
    let density = format!("{density:.3e}");
    format!("  {}\n", said!("check-density", "density" => density))
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
        said!("check-tilted", "pitch" => pitch, "pitchrate" => pitch_rate, "roll" => roll, "rollrate" => roll_rate)
    };
    format!(
        "  {}\n",
        said!(
            "check-starts",
            "place" => list(&initial.displacement),
            "turn" => six(initial.rotation_deg),
            "velocity" => list(&initial.velocity),
            "spin" => six(initial.spin_deg_s),
            "tilted" => tilted
        )
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
    format!("  {}\n", said!("check-pushed", "force" => list(&push.force), "moments" => moments))
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
    format!("  {}\n", said!("check-held", "ways" => directions.iter().map(name).collect::<Vec<_>>().join(", ")))
}

fn seats(seat: Seat) -> String {
    let ends = [("+x", seat.plus), ("-x", seat.minus)];
    let of_end = |(end, length): (&str, Option<f64>)| Some(said!("check-seat", "length" => six(length?), "end" => end));
    let given: Vec<_> = ends.into_iter().filter_map(of_end).collect();
    let wider = seat.side.map_or(String::new(), |side| said!("check-seat-wider", "side" => six(side)));
    if given.is_empty() {
        String::new()
    } else {
        format!("  {}\n", said!("check-seats", "given" => given.join(", "), "wider" => wider))
    }
}

/// (3), (4): what the bearings make of the girder, in its own axes.
fn bearings(q: &BearingQuantities, count: usize) -> String {
    if count == 0 {
        return format!("  {}\n", Text::new("check-no-bearings"));
    }
    let three = |[x, y, theta]: [f64; 3]| format!("{x:.5}, {y:.5}, {theta:.5}");
    let two = |[x, y]: [f64; 2]| format!("{}, {} mm", micrometres(x), micrometres(y));
    format!(
        "  {}\n  {}\n",
        said!(
            "check-bearings",
            "count" => count,
            "omega" => three(q.omega),
            "hertz" => three(q.omega.map(|omega| omega / TAU)),
            "damping" => three(q.damping_ratio)
        ),
        said!(
            "check-bearings-b",
            "stiffness" => two(q.stiffness_eccentricity),
            "dashpots" => two(q.damping_eccentricity)
        )
    )
}

/// How many of its bearings stand on piers and on abutments, and on which.
fn on_supports(scene: &Scene, girder: &Girder) -> String {
    let standing = scene.standing(girder);
    let (mut piers, mut abutments) = (Vec::new(), Vec::new());
    for on in standing {
        match on {
            StandsOn::Ground => {}
            StandsOn::Pier(number) => piers.push(scene.piers[number].name.as_str()),
            StandsOn::Abutment(number) => abutments.push(scene.abutments[number].name.as_str()),
        }
    }
    let listed = |mut names: Vec<&str>| {
        let mut seen = BTreeSet::new();
        names.retain(|name| seen.insert(*name));
        names.into_iter().map(|name| escaped(name).into_owned()).collect::<Vec<_>>().join(", ")
    };
    let [on_piers, on_abutments] = [piers.len(), abutments.len()];
    let piers = (on_piers > 0).then(|| said!("check-on-piers", "count" => on_piers, "piers" => listed(piers)));
    let abutments = (on_abutments > 0)
        .then(|| said!("check-on-abutments", "count" => on_abutments, "abutments" => listed(abutments)));
    let lines: Vec<String> = piers.into_iter().chain(abutments).map(|said| format!("  {said}\n")).collect();
    lines.concat()
}

/// Vertical frequency and damping ratio of a spatial girder on its bearings.
fn vertical(body: &Body, bearings: &[Bearing], kind: Kind) -> String {
    if kind == Kind::Planar || bearings.is_empty() {
        return String::new();
    }
    let sum = |of: fn(&Bearing) -> f64| bearings.iter().map(of).sum::<f64>();
    let (stiffness, damping) = (sum(|b| b.stiffness.z), sum(|b| b.damping.z));
    let omega = (stiffness / body.mass).sqrt();
    let ratio = if omega > 0.0 { damping / (2.0 * body.mass * omega) } else { 0.0 };
    let tips = body.unbalanced.first_moment.truncate().length() > 0.0 || is_unstable(bearings);
    let tips =
        if tips && (body.free[3] || body.free[4]) { format!("  {}\n", Text::new("check-tips")) } else { String::new() };
    let pulled = bearings.iter().enumerate().filter(|(_, bearing)| bearing.preload.z < 0.0).map(|(number, bearing)| {
        let pull = format!("{:.1}", -bearing.preload.z / 1e3);
        format!("  {}\n", said!("check-pulled", "number" => number + 1, "pull" => pull))
    });
    let warned: String = [tips].into_iter().chain(pulled).collect();
    format!(
        "  {}\n{warned}",
        said!(
            "check-vertical",
            "omega" => format!("{omega:.5}"),
            "hertz" => format!("{:.5}", omega / TAU),
            "ratio" => format!("{ratio:.5}")
        )
    )
}

/// Whether a girder tips over from rest: about some axis in plan the vertical springs of its bearings resist a turn by less than its
/// weight W drives it, `Σ k_z s² < W h`, with s from the middle of the springs and h the height of G over the bearings.
fn is_unstable(bearings: &[Bearing]) -> bool {
    let stiffness: f64 = bearings.iter().map(|b| b.stiffness.z).sum();
    let middle = bearings.iter().map(|b| b.place.truncate() * b.stiffness.z).sum::<DVec2>() / stiffness;
    let of = |part: fn(DVec2) -> f64| {
        bearings.iter().map(|b| b.stiffness.z * part(b.place.truncate() - middle)).sum::<f64>()
    };
    let [xx, yy, xy] = [of(|s| s.x * s.x), of(|s| s.y * s.y), of(|s| s.x * s.y)];
    let least = 0.5 * (xx + yy) - (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt();
    // W h: every bearing carries its share at its own height.
    least < -bearings.iter().map(|b| b.preload.z * b.place.z).sum::<f64>()
}

/// Part of the load at rest by which that at the start may differ without a word \[–\]. Chosen.
const DIFFERS: f64 = 0.5;

/// Sliders in a dish that a girder displaced in plan does not stand on: they rise by u²/2R.
fn in_dish(girder: &Girder, body: &Body, scene: &Scene) -> String {
    let [x, y, w] = girder.initial.displacement;
    if scene.kind == Kind::Planar || (x == 0.0 && y == 0.0) {
        return String::new();
    }
    let supports = girder.supports(scene.setting());
    let words = supports.iter().zip(&body.bearings).enumerate().filter_map(|(number, (support, bearing))| {
        let rise = 0.5 * support.sliding?.curvature * (x * x + y * y);
        let more = bearing.stiffness.z * (rise - w) / bearing.preload.z;
        let (rise, part) = (format!("{rise:.4}"), format!("{:.1}", 1.0 + more));
        let words = || said!("check-in-dish", "number" => number + 1, "rise" => rise, "part" => part);
        (more.abs() > DIFFERS).then(|| format!("  {}\n", words()))
    });
    words.collect()
}

/// A length in mm to the micrometre; adding 0 turns −0 into 0.
fn micrometres(length: f64) -> f64 {
    (length * 1e6).round() / 1e3 + 0.0
}

/// The rotation condition (6) of the paper.
fn rotation(girder: &Girder) -> String {
    let condition = RotationCondition::of(&girder.prism());
    let can = if condition.can_turn() { Text::new("check-can-rotate") } else { Text::new("check-cannot-rotate") };
    format!("  {}\n", said!("check-condition", "number" => format!("{:.3}", condition.number), "can" => can))
}
