//! Devices between two points, each drawn as what it is: a cable that hangs and goes taut, a bumper as a spring between plates, a
//! damper as a piston in its cylinder, a stopper as a block before its peg. Thick and coloured while their force acts, broken ones
//! in two. Signs are as large as the line between the points allows, and of one size on the screen else.

use glam::DVec3;

use super::ViewInput;
use super::input::Target;
use super::list::{Line, Rgba};
use super::moment::Moment;
use super::palette::{NORMAL, Palette, SELECTED};
use crate::dynamics::connection::IS_BROKEN;
use crate::scene::DeviceKind;
use crate::sim::{History, LinkNow};

/// Width of a device whose force acts, and of one that is idle \[points\].
const WIDTHS: [f32; 2] = [3.6, 1.7];
/// Half the side of the square at either point of a cable, its anchors \[points\].
const ANCHOR: f64 = 3.5;
/// Half the height of a plate, a block or a cylinder \[points\].
const HALF: f64 = 7.0;
/// Turns of a bumper's spring.
const TURNS: u32 = 5;
/// Pieces that a hanging cable is drawn in.
const PIECES: u32 = 16;

/// Width \[pixels\] and colour of a device's line: idle ones in ink, so that width and colour state the same.
pub(super) fn stroke(acts: bool, pixels_per_point: f32, palette: &Palette) -> (f32, Rgba) {
    let [acting, idle] = WIDTHS.map(|width| width * pixels_per_point);
    if acts { (acting, NORMAL) } else { (idle, palette.ink) }
}

/// Lines of all devices of a moment.
pub(super) fn lines(input: &ViewInput<'_>, moment: &Moment, palette: &Palette) -> Vec<Line> {
    let mut all = Vec::new();
    for device in moment.devices.iter().filter(|device| !device.line.is_empty()) {
        let known = input.history.and_then(|history| kind_of(history, device));
        let (width, mut color) = stroke(device.acts, input.pixels_per_point, palette);
        if known.is_some_and(|(target, _)| input.selected.contains(&target)) {
            color = SELECTED;
        }
        for stretch in drawn(input, device, known.map(|(_, kind)| kind)) {
            all.extend(stretch.windows(2).map(|two| Line {
                group: "device",
                from: two[0].as_vec3(),
                to: two[1].as_vec3(),
                width,
                color,
            }));
        }
    }
    all
}

/// Device of the scene that a link belongs to, and its kind.
fn kind_of(history: &History, device: &LinkNow) -> Option<(Target, DeviceKind)> {
    let known = history.model().devices.iter().find(|known| known.links.contains(&device.link))?;
    Some((Target::Device(known.id), known.id.kind))
}

/// The strokes of a device.
fn drawn(input: &ViewInput<'_>, device: &LinkNow, kind: Option<DeviceKind>) -> Vec<Vec<DVec3>> {
    let [first, second] = device.ends;
    let middle = first.midpoint(second);
    // No sign is longer than the line that it stands on.
    let half = (HALF * input.point_length(middle)).min(0.3 * first.distance(second).max(1e-9));
    match kind {
        Some(DeviceKind::Restrainer) => [cable(device), device.ends.map(|end| anchor(input, end)).into()].concat(),
        Some(DeviceKind::Bumper) => spring([first, second], half),
        Some(DeviceKind::Damper) => piston([first, second], half),
        Some(DeviceKind::Stopper) => block(input, device),
        None => vec![device.line.clone()],
    }
}

/// Level and square to a direction.
fn across(direction: DVec3) -> DVec3 {
    DVec3::Z.cross(direction).try_normalize().unwrap_or(DVec3::X)
}

/// The square about a point of a cable, level, of one size on the screen.
fn anchor(input: &ViewInput<'_>, at: DVec3) -> Vec<DVec3> {
    let half = ANCHOR * input.point_length(at);
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]]
        .map(|[x, y]| at + DVec3::new(x, y, 0.0) * half)
        .into()
}

/// A cable: straight while taut; slack by e it hangs, as a parabola whose length is e longer than the chord ℓ, `√(3 ℓ e/8)` deep; broken,
/// two ends.
fn cable(device: &LinkNow) -> Vec<Vec<DVec3>> {
    let [first, second] = device.ends;
    if device.state == IS_BROKEN {
        let droop = |from: DVec3, to: DVec3| {
            let end = from.lerp(to, 0.4) - DVec3::Z * (0.15 * from.distance(to));
            vec![from, from.lerp(end, 0.6) + DVec3::Z * (0.03 * from.distance(to)), end]
        };
        return vec![droop(first, second), droop(second, first)];
    }
    let depth = if device.acts { 0.0 } else { (0.375 * first.distance(second) * device.gap.max(0.0)).sqrt() };
    let at = |i: u32| {
        let part = f64::from(i) / f64::from(PIECES);
        first.lerp(second, part) - DVec3::Z * (4.0 * depth * part * (1.0 - part))
    };
    vec![(0..=PIECES).map(at).collect()]
}

/// A bumper: a plate at either point, a spring between them.
fn spring([first, second]: [DVec3; 2], half: f64) -> Vec<Vec<DVec3>> {
    let side = across(first - second) * half;
    let plate = |at: DVec3| vec![at - side, at + side];
    let turn = |i: u32| {
        let part = f64::from(i) / f64::from(2 * TURNS);
        let out = if i == 0 || i == 2 * TURNS { 0.0 } else { 0.7 * if i.is_multiple_of(2) { 1.0 } else { -1.0 } };
        second.lerp(first, part) + side * out
    };
    vec![plate(first), plate(second), (0..=2 * TURNS).map(turn).collect()]
}

/// A damper: a rod with its piston from the first point, in a cylinder that hangs on the second.
fn piston([first, second]: [DVec3; 2], half: f64) -> Vec<Vec<DVec3>> {
    let side = across(first - second) * half;
    let at = |part: f64| second.lerp(first, part);
    let (foot, mouth, head) = (at(0.25), at(0.7), at(0.5));
    vec![
        vec![second, foot],
        vec![mouth - side, foot - side, foot + side, mouth + side],
        vec![head - side * 0.75, head + side * 0.75],
        vec![head, first],
    ]
}

/// A stopper's side: a peg at its first point, and the block where that touches it, to scale.
fn block(input: &ViewInput<'_>, device: &LinkNow) -> Vec<Vec<DVec3>> {
    let peg = device.ends[0];
    let size = HALF * input.point_length(peg);
    let direction =
        input.history.and_then(|history| history.model().links.get(device.link)).map(|link| link.axes.x_axis);
    let way = direction.unwrap_or(DVec3::Y);
    let side = across(way) * size;
    let foot = peg + way * device.gap;
    let plate = vec![foot - side, foot + side];
    let posts = [-0.6, 0.6].map(|part| vec![foot + side * part, foot + side * part + way * (0.8 * size)]);
    let mark = across(way) * (0.35 * size);
    let cross = [mark + way * (0.35 * size), mark - way * (0.35 * size)].map(|arm| vec![peg - arm, peg + arm]);
    if device.state == IS_BROKEN {
        return cross.into();
    }
    [vec![plate], posts.into(), cross.into()].concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::connection::Phase;
    use crate::sim::Loop;

    fn slack(gap: f64) -> LinkNow {
        LinkNow {
            link: 0,
            phase: Phase::default(),
            acts: gap <= 0.0,
            state: crate::language::Text::new("state-slack"),
            strength: None,
            along: Loop::default(),
            ends: [DVec3::ZERO, DVec3::X * 2.0],
            line: Vec::new(),
            force: DVec3::ZERO,
            reaction: DVec3::ZERO,
            gap,
            stored: 0.0,
            dissipated: 0.0,
        }
    }

    #[test]
    fn a_slack_cable_hangs_by_the_length_that_it_has_too_much() {
        let length = |device: &LinkNow| -> f64 {
            cable(device)
                .iter()
                .flat_map(|stroke| stroke.windows(2).map(|two| two[0].distance(two[1])).collect::<Vec<_>>())
                .sum()
        };
        for gap in [1e-4, 1e-3, 0.01] {
            let longer = length(&slack(gap)) - 2.0;
            assert!((longer - gap).abs() < 0.02 * gap, "{longer} m of {gap} m");
        }
        assert_eq!(length(&slack(0.0)), 2.0, "taut it is straight");
    }
}
