//! Quantities of a girder that the domain limits: rates of its bearings, speeds and accelerations of its corners.

use glam::DVec3;

use crate::scene::device::{DeviceId, Ends, Part};
use crate::scene::facing::{Facing, Side};
use crate::scene::{Damper, Direction, Girder, Kind, Motion, ResolvedBearing, ResolvedPier, Scene, Setting, placed};

/// The fastest rate that bearings give a girder, `max(√(k/m), c/m)` over its translations and rotations each by itself; 0
/// without bearings \[rad/s\].
///
/// Each is a Rayleigh quotient of the girder's matrices, so the fastest mode of all is as fast or faster.
pub(super) fn bearing_rate(girder: &Girder, of: Setting) -> f64 {
    let bearings = girder.supports(of);
    let inertia = girder.prism().inertia_per_mass() * girder.mass;
    let held = |direction: Direction| girder.held.contains(&direction);
    let spatial = of.kind == Kind::Spatial;
    let translations = [(DVec3::X, true), (DVec3::Y, true), (DVec3::Z, spatial && !held(Direction::Z))];
    let tilts = spatial && !(held(Direction::Roll) && held(Direction::Pitch));
    let rotations = [(DVec3::X, tilts), (DVec3::Y, tilts), (DVec3::Z, !held(Direction::Yaw))];
    let along = translations.into_iter().filter(|(_, free)| *free);
    let along = along.map(|(axis, _)| rate(&bearings, |_| axis, girder.mass));
    let about = rotations.into_iter().filter(|(_, free)| *free);
    let about = about.map(|(axis, _)| rate(&bearings, |place| axis.cross(place), axis.dot(inertia * axis)));
    along.chain(about).fold(0.0, f64::max)
}

/// `max(√(k/m), c/m)` of the motion that moves every bearing by `motion` of its place.
fn rate(bearings: &[ResolvedBearing], motion: impl Fn(DVec3) -> DVec3, inertia: f64) -> f64 {
    let quotient = |of: fn(&ResolvedBearing) -> [f64; 3]| {
        let each = bearings.iter().map(|b| (DVec3::from(of(b)) * motion(b.place)).dot(motion(b.place)));
        each.sum::<f64>() / inertia
    };
    quotient(ResolvedBearing::initial_stiffness).sqrt().max(quotient(|b| b.damping))
}

/// Distance of the farthest bearing from G, in parts of that of the farthest corner; 0 without bearings.
pub(in crate::scene) fn bearing_place(girder: &Girder, of: Setting) -> f64 {
    let bearings = girder.supports(of);
    bearings.iter().map(|bearing| bearing.place.length()).fold(0.0, f64::max) / radius(girder)
}

/// Distance of the farthest bearing of each end from the top of the pier that it stands on, along the pier's first axis, in parts
/// of the girder's length, with the key of the girder's bearings.
pub(super) fn pier_places(scene: &Scene) -> Vec<(String, f64)> {
    let piers: Vec<_> = (0..scene.piers.len()).map(|number| scene.pier(number)).collect();
    let of_girder = |girder: &Girder| {
        let (home, axes) = (DVec3::from(girder.position), placed::axes(girder));
        let bearings = girder.supports(scene.setting()).into_iter().zip(scene.supports(girder));
        let apart = bearings.filter_map(|(bearing, pier)| {
            let pier = &piers[pier?];
            Some((home + axes * bearing.place - pier.top).dot(pier.axes.x_axis).abs() / girder.length)
        });
        Some((format!("girder.{}.bearings", girder.name), apart.reduce(f64::max)?))
    };
    if piers.is_empty() { Vec::new() } else { scene.girders.iter().filter_map(of_girder).collect() }
}

/// The fastest rate of a pier alone, `max(√(k/m), c/m)` along both axes and `√(k_θ/I)` \[rad/s\].
pub(super) fn pier_rate(pier: &ResolvedPier) -> f64 {
    let along = pier.stiffness.iter().zip(&pier.damping).map(|(k, c)| (k / pier.mass).sqrt().max(c / pier.mass));
    let turning = pier.turn_stiffness.map_or(0.0, |stiffness| (stiffness / pier.inertia).sqrt());
    along.fold(turning, f64::max)
}

/// `c/m` of every damper that is linear, by the mass of its girder, with its key \[1/s\].
pub(super) fn damper_rates(scene: &Scene) -> Vec<(String, f64)> {
    let linear = scene.dampers.iter().filter(|damper| damper.exponent == 1.0);
    let rate = |damper: &Damper| {
        let girder = scene.girders.iter().find(|girder| girder.name == damper.girder)?;
        Some((format!("damper.{}.coefficient", damper.name), damper.coefficient / girder.mass))
    };
    linear.filter_map(rate).collect()
}

/// Factors of the motion of single supports, each with its key and that motion.
pub(super) fn factors(scene: &Scene) -> Vec<(String, f64, &Motion)> {
    let motion = |ground: &Option<String>| {
        let named = ground.as_ref().and_then(|name| scene.ground_named(name));
        named.map_or(&scene.motion, |number| &scene.grounds[number].motion)
    };
    let walls = scene.abutments.iter().map(|wall| ("abutment", &wall.name, wall.motion_factor, &wall.ground));
    let piers = scene.piers.iter().map(|pier| ("pier", &pier.name, pier.motion_factor, &pier.ground));
    let given = |(kind, name, factor, ground): (&str, &String, Option<f64>, &Option<String>)| {
        Some((format!("{kind}.{name}.motion_factor"), factor?, motion(ground)))
    };
    walls.chain(piers).filter_map(given).collect()
}

/// Peak acceleration of a motion \[m/s²\].
pub(super) fn peak(motion: &Motion) -> f64 {
    match motion {
        Motion::None => 0.0,
        Motion::Sine(sine) => sine.amplitude_si().abs().max(sine.vertical_si().abs()),
        Motion::Record(record) => record.extent().map_or(0.0, |(peak, ..)| peak),
        Motion::Sweep(sweep) => sweep.sweep().amplitude.abs(),
        Motion::Synthetic(synthetic) => synthetic.peak(),
    }
}

/// Distance of each point of a device that is on a girder from its G, in parts of that of the farthest corner, with its key.
pub(in crate::scene) fn device_places(scene: &Scene, ends: &Ends<'_>) -> Vec<(&'static str, f64)> {
    let place = |name: &str, at: [f64; 3]| {
        let girder = scene.girders.iter().find(|girder| girder.name == name)?;
        Some(DVec3::from(at).length() / radius(girder))
    };
    let first = place(ends.girder, ends.at).map(|place| ("at_m", place));
    let second = ends.to.zip(ends.to_at).and_then(|(name, at)| place(name, at)).map(|place| ("to_m", place));
    first.into_iter().chain(second).collect()
}

/// A point of a device that is beside the girder that it is on.
#[derive(Clone, Debug, PartialEq)]
pub struct BesideGirder {
    /// The key of the point, `restrainer.cable.at_m`.
    pub key: String,
    /// The girder.
    pub girder: String,
    /// Distance outside of it in plan \[m\].
    pub by: f64,
}

/// Points of devices that are farther outside of their girder than a bracket reaches, which is half the girder's width (chosen).
pub fn beside_girders(scene: &Scene) -> Vec<BesideGirder> {
    let outside = |name: &str, [x, y, _]: [f64; 3]| {
        let girder = scene.girders.iter().find(|girder| girder.name == name)?;
        let along = (x - y * girder.prism().shear()).abs() - 0.5 * girder.length;
        let by = along.max(0.0).hypot((y.abs() - 0.5 * girder.width).max(0.0));
        (by > 0.5 * girder.width).then_some(by)
    };
    let of_device = |(id, device): (DeviceId, &dyn Part)| {
        let ends = device.ends();
        let points = [("at_m", Some((ends.girder, ends.at))), ("to_m", ends.to.zip(ends.to_at))];
        let beside = points.into_iter().filter_map(|(key, point)| {
            let (girder, at) = point?;
            let key = format!("{}.{}.{key}", id.kind.label(), ends.name);
            Some(BesideGirder { key, girder: girder.to_owned(), by: outside(girder, at)? })
        });
        beside.collect::<Vec<_>>()
    };
    scene.devices().into_iter().flat_map(of_device).collect()
}

/// Distance of the farthest corner from G \[m\].
fn radius(girder: &Girder) -> f64 {
    girder.prism().radius()
}

/// Angular speed at the start \[rad/s\].
pub(super) fn spin(girder: &Girder) -> f64 {
    // With one rate alone its size; the angular velocity of several is at most their sum.
    girder.initial.angle_rates().into_iter().map(f64::abs).sum()
}

/// Speed of G at the start, and of the farthest corner about G \[m/s\].
pub(super) fn start_speeds(girder: &Girder) -> [f64; 2] {
    [DVec3::from(girder.initial.velocity).length(), spin(girder) * radius(girder)]
}

/// Displacement of G at the start, and of the farthest corner about G \[m\].
pub(super) fn start_displacements(girder: &Girder) -> [f64; 2] {
    let turn: f64 = girder.initial.angles().into_iter().map(f64::abs).sum();
    [DVec3::from(girder.initial.displacement).length(), turn * radius(girder)]
}

/// Depth to which the starts of two girders, or of one before an abutment, press their ends into each other along the first one's axis,
/// turns left out; 0 where they do not, as where one starts above the other \[m\].
pub(super) fn pressed_by(scene: &Scene, facing: &Facing) -> f64 {
    let Side::Girder(first, end) = facing.first else { return 0.0 };
    if scene.kind == Kind::Spatial
        && let [Some([bottom, top]), Some([other_bottom, other_top])] =
            [facing.first, facing.second].map(|side| heights(scene, side))
        && (bottom > other_top || other_bottom > top)
    {
        return 0.0;
    }
    let displacement =
        |side: Side| side.girder().map_or(DVec3::ZERO, |n| DVec3::from(scene.girders[n].initial.displacement));
    let outward = placed::axes(&scene.girders[first]).x_axis * end.sign();
    let closer = (displacement(facing.first) - displacement(facing.second)).dot(outward);
    (closer - facing.gap).max(0.0)
}

/// Lowest and highest place that a face reaches at the start, however its body is tilted by then \[m\]; `None` of a face along a body.
fn heights(scene: &Scene, side: Side) -> Option<[f64; 2]> {
    let (corners, start, more) = match side {
        Side::Girder(number, end) => {
            let girder = &scene.girders[number];
            let [roll, pitch, _] = girder.initial.angles().map(f64::abs);
            let lifted = radius(girder) * (roll + pitch).min(1.0);
            (placed::end_face(girder, end), girder.initial.displacement[2], lifted)
        }
        Side::Abutment(number) => (placed::abutment_face(scene, &scene.abutments[number])?, 0.0, 0.0),
        Side::Flank(..) | Side::Rear(..) => return None,
    };
    let reach = |pick: fn(f64, f64) -> f64| corners.iter().map(|corner| corner.z).reduce(pick);
    Some([reach(f64::min)? + start - more, reach(f64::max)? + start + more])
}

/// Acceleration of G by the constant force, and of the farthest corner about G by the constant moment \[m/s²\].
pub(super) fn push_accelerations(girder: &Girder) -> [f64; 2] {
    let per_mass = girder.prism().inertia_per_mass();
    let gyration2 = [per_mass.x_axis.x, per_mass.y_axis.y, per_mass.z_axis.z];
    let about = girder.push.moments().into_iter().zip(gyration2).map(|(moment, i2)| moment.abs() / (girder.mass * i2));
    let turn: f64 = about.sum();
    [DVec3::from(girder.push.force).length() / girder.mass, turn * radius(girder)]
}
