//! Parts that random scenes are put together from, each over the whole range that it may have.

use super::random::{Random, three_digits};
use crate::geometry::End;
use crate::scene::{
    Abutment, Bearing, Bearings, Between, ContactSettings, FrictionLaw, Girder, Kind, Motion, PerDirection,
    RecordMotion, STANDARD_GRAVITY, Scene, Setting, SharedBearings, Sharing, SineMotion, Tension,
};

/// Contact stiffness \[N/m\].
pub(super) const STIFFNESS: [f64; 2] = [1e2, 1e12];
/// Masses \[kg\].
pub(super) const MASS: [f64; 2] = [1e-3, 1e8];
/// Gaps, where they are not exactly 0 \[m\].
pub(super) const GAP: [f64; 2] = [1e-6, 1.0];
/// Skew angles \[degrees\].
pub(super) const SKEW: [f64; 2] = [5.0, 175.0];
/// Frequencies of bearings and ground \[Hz\].
pub(super) const FREQUENCY: [f64; 2] = [0.01, 100.0];
/// Largest amplitude of the ground, 10 g \[m/s²\].
pub(super) const AMPLITUDE: f64 = 10.0 * STANDARD_GRAVITY;
/// Solver tolerances.
pub(super) const TOLERANCE: [f64; 2] = [1e-13, 1e-3];
/// Periods of the fastest bearing or ground that a scene may last, planar and spatial: a study has thousands of scenes.
const MOST_PERIODS: [f64; 2] = [2000.0, 150.0];

/// A scene without anything in it.
pub(super) fn blank(kind: Kind) -> Scene {
    Scene { kind, motion: Motion::None, ..Scene::empty("", 1.0) }
}

/// Planar more often than spatial.
pub(super) fn kind(random: &mut Random) -> Kind {
    if random.chance(0.3) { Kind::Spatial } else { Kind::Planar }
}

/// A girder of any shape and mass, at the origin.
pub(super) fn girder(random: &mut Random) -> Girder {
    let length = random.log(0.05, 50.0);
    let width = three_digits(length * random.log(0.05, 2.0));
    let skew = if random.chance(0.3) { 90.0 } else { three_digits(random.range(SKEW[0], SKEW[1])) };
    shaped(random, [length, width], skew)
}

/// A girder of a given plan and skew.
pub(super) fn shaped(random: &mut Random, [length, width]: [f64; 2], skew_deg: f64) -> Girder {
    let thickness = three_digits(length.min(width) * random.log(0.03, 1.0));
    let mass = random.log(MASS[0], MASS[1]);
    Girder { skew_deg, ..Girder::straight("g0", [length, width, thickness], mass) }
}

/// A gap: exactly 0 one time in ten.
pub(super) fn gap(random: &mut Random) -> f64 {
    if random.chance(0.1) { 0.0 } else { random.log(GAP[0], GAP[1]) }
}

/// Copies of a girder in a row along x, each with its own mass unless they are to be `equal`.
pub(super) fn row(random: &mut Random, first: &Girder, count: usize, gap: f64, equal: bool) -> Vec<Girder> {
    let place = |random: &mut Random, i: usize| {
        let mut girder = first.clone();
        girder.name = format!("g{i}");
        girder.position[0] = i as f64 * (first.length + gap);
        if !equal {
            girder.mass = three_digits(first.mass * random.log(0.1, 10.0)).clamp(MASS[0], MASS[1]);
        }
        girder
    };
    (0..count).map(|i| place(random, i)).collect()
}

/// Four equal bearings of these frequencies, undamped one time in four; one time in five eccentric and one by one.
pub(super) fn stand(random: &mut Random, scene: &mut Scene, frequency_hz: f64) {
    let damping = if random.chance(0.25) { 0.0 } else { random.log(1e-3, 1.0) };
    let (alike, eccentric) = (random.chance(0.5), random.chance(0.2));
    let across = if alike { frequency_hz } else { three_digits(frequency_hz * random.log(0.5, 2.0)) };
    let vertical = three_digits(frequency_hz * random.log(1.0, 20.0)).min(FREQUENCY[1]);
    let kind = scene.kind;
    for girder in &mut scene.girders {
        let (x, y) = (three_digits(girder.length * 0.35), three_digits(girder.width * 0.35));
        let shared = SharedBearings {
            frequency_hz: PerDirection::Each([frequency_hz, across]),
            damping_ratio: PerDirection::Both(damping),
            vertical_frequency_hz: (kind == Kind::Spatial).then_some(vertical),
            vertical_damping_ratio: None,
            on_minus_x: None,
            on_plus_x: None,
            at_skewed: Some(vec![[x, y], [x, -y], [-x, y], [-x, -y]]),
            travel: None,
            height: None,
            at: None,
        };
        girder.bearings = Some(Bearings::Shared(shared));
        if eccentric {
            uneven(random, girder, kind);
        }
    }
}

/// Makes a girder's bearings single ones, each stiffer or softer than the others.
fn uneven(random: &mut Random, girder: &mut Girder, kind: Kind) {
    let Some(bearings) = &girder.bearings else { return };
    let setting = Setting { kind, gravity: STANDARD_GRAVITY };
    let each = bearings.resolve(girder, setting).into_iter().map(|b| {
        let factor = random.log(0.3, 3.0);
        let scaled = |v: [f64; 3]| v.map(|x| three_digits(x * factor));
        let at = [b.place.x, b.place.y].map(three_digits);
        Bearing::linear(at, scaled(b.stiffness), scaled(b.damping))
    });
    girder.bearings = Some(Bearings::Each(each.collect()));
}

/// A wall before the `+x` end of the last girder, or the `-x` end of the first.
pub(super) fn wall(scene: &mut Scene, end: End, gap: f64) {
    let girder = if end == End::Plus { scene.girders.last() } else { scene.girders.first() };
    let Some(girder) = girder else { return };
    scene.abutments.push(Abutment {
        ground: None,
        delay: None,
        motion_factor: None,
        backfill: None,
        name: if end == End::Plus { "east".to_owned() } else { "west".to_owned() },
        faces: girder.name.clone(),
        end,
        gap: Some(gap),
        width: None,
        height: None,
        offset: None,
        polygon: None,
        depth: None,
    });
}

/// No wall, one, or two; a girder alone has at least one.
pub(super) fn walls(random: &mut Random, scene: &mut Scene, gap: f64) {
    let fewest = usize::from(scene.girders.len() == 1);
    let count = fewest + random.below(3 - fewest);
    if count > 0 {
        wall(scene, End::Plus, gap);
    }
    if count > 1 {
        wall(scene, End::Minus, gap);
    }
}

/// Contact numbers over their whole ranges; every law, sharing and tension.
pub(super) fn contact(random: &mut Random) -> ContactSettings {
    let mu_kinetic = if random.chance(0.15) { 0.0 } else { three_digits(random.range(0.0, 2.0)) };
    let mu_static = if random.chance(0.3) { mu_kinetic } else { three_digits(random.range(mu_kinetic, 2.0)) };
    ContactSettings {
        between: Between::Ends,
        stiffness: Some(random.log(STIFFNESS[0], STIFFNESS[1])),
        restitution_normal: restitution(random),
        restitution_tangential: restitution(random),
        mu_static: mu_static.max(mu_kinetic),
        mu_kinetic,
        law: random.pick(FrictionLaw::ALL),
        sharing: random.pick(&[Sharing::Tributary, Sharing::PerNode]),
        tension: random.pick(&[Tension::Keep, Tension::Clamp]),
        ..ContactSettings::default()
    }
}

/// 0.01 and 1 exactly, and everything between.
fn restitution(random: &mut Random) -> f64 {
    match random.below(6) {
        0 => 0.01,
        1 => 1.0,
        _ => three_digits(random.range(0.01, 1.0)),
    }
}

/// A sine that moves a girder of bearing frequency `bearing_hz` by a few times `reach`, at 10 g at the most.
pub(super) fn sine(random: &mut Random, ground_hz: f64, bearing_hz: f64, reach: f64) -> Motion {
    let omega = std::f64::consts::TAU * ground_hz.max(bearing_hz);
    let wanted = three_digits(reach * omega * omega * random.log(0.3, 30.0));
    let amplitude = if random.chance(0.1) { AMPLITUDE } else { wanted.clamp(1e-9, AMPLITUDE) };
    Motion::Sine(SineMotion {
        amplitude_g: None,
        amplitude: Some(amplitude),
        frequency_hz: ground_hz,
        phase_deg: random.pick(&[0.0, 90.0, 37.0]),
        angle_deg: if random.chance(0.3) { 0.0 } else { three_digits(random.range(-180.0, 180.0)) },
        vertical_amplitude_g: None,
        vertical_amplitude: None,
        vertical_phase_deg: None,
    })
}

/// A record of noise with the same reach as [`sine`].
pub(super) fn record(random: &mut Random, ground_hz: f64, bearing_hz: f64, reach: f64) -> Motion {
    let omega = std::f64::consts::TAU * ground_hz.max(bearing_hz);
    let peak = three_digits(reach * omega * omega * random.log(0.3, 30.0)).clamp(1e-9, AMPLITUDE);
    let samples = 32 + random.below(400);
    Motion::Record(RecordMotion {
        samples: Some((0..samples).map(|_| three_digits(peak * random.range(-1.0, 1.0))).collect()),
        dt: Some(three_digits(1.0 / (random.range(4.0, 40.0) * ground_hz))),
        angle_deg: three_digits(random.range(-180.0, 180.0)),
        ..RecordMotion::default()
    })
}

/// Starts every girder with a speed that crosses `reach` within a period, and turning.
pub(super) fn kick(random: &mut Random, scene: &mut Scene, frequency_hz: f64, reach: f64) {
    let speed = std::f64::consts::TAU * frequency_hz * reach;
    for girder in &mut scene.girders {
        let velocity =
            [three_digits(speed * random.range(-3.0, 3.0)), three_digits(speed * random.range(-1.0, 1.0)), 0.0];
        let turning = random.chance(0.6);
        let spin = three_digits((speed / girder.length).to_degrees() * random.range(-2.0, 2.0));
        girder.initial.velocity = velocity;
        girder.initial.spin_deg_s = if turning { spin } else { 0.0 };
    }
}

/// 3 to 20 periods of the bearings or the ground, chosen at random; the tolerance anywhere in its range.
pub(super) fn last(random: &mut Random, scene: &mut Scene, frequencies_hz: &[f64]) {
    let slowest = frequencies_hz.iter().copied().fold(f64::INFINITY, f64::min);
    let fastest = frequencies_hz.iter().copied().fold(0.0, f64::max);
    let of = if random.chance(0.5) { slowest } else { fastest };
    let most = MOST_PERIODS[usize::from(scene.kind == Kind::Spatial)] / fastest;
    scene.duration = three_digits((random.log(3.0, 20.0) / of).min(most));
    scene.solver.tolerance = random.log(TOLERANCE[0], TOLERANCE[1]);
}
