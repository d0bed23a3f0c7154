//! Scenes with all that a bridge is built with: bearings that yield, slide and come off, devices, backfill, every normal law.

use std::f64::consts::TAU;

use crate::contact::{Calibration, FrictionLaw, NormalName};
use crate::scene::{
    Abutment, CONCRETE_DENSITY, ContactSettings, Girder, Kind, Motion, STANDARD_GRAVITY, Scene, SineMotion, Wave,
    overrides, validate,
};
use crate::study::stability::parts;
use crate::study::stability::random::{Random, three_digits};

/// Sizes that everything else of a scene is in proportion to.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    /// Frequency of a girder on its bearings, after yield where they do \[Hz\].
    hertz: f64,
    /// Mass of the first girder \[kg\].
    mass: f64,
    /// Displacement on those by a constant force as large as the ground's amplitude \[m\].
    way: f64,
}

impl Sizes {
    /// Stiffness that swings the girder so many times as fast as its bearings \[N/m\].
    fn stiffness(&self, times: f64) -> f64 {
        three_digits(self.mass * (TAU * self.hertz * times).powi(2))
    }

    fn length(&self, times: f64) -> f64 {
        three_digits(self.way * times)
    }

    /// Force of the girder's weight \[N\].
    fn weight(&self, times: f64) -> f64 {
        three_digits(self.mass * STANDARD_GRAVITY * times)
    }
}

/// One or two girders between no, one or two abutments.
pub(super) fn devices(random: &mut Random) -> Scene {
    let kind = if random.chance(0.25) { Kind::Spatial } else { Kind::Planar };
    let mut scene = parts::blank(kind);
    let girder = girder(random);
    let (hertz, amplitude) = (random.log(0.3, 5.0), three_digits(random.range(0.05, 0.8)));
    let way = amplitude * STANDARD_GRAVITY / (TAU * hertz).powi(2);
    let sizes = Sizes { hertz, mass: girder.mass, way };
    let gap = sizes.length(random.log(0.1, 3.0));
    let count = 1 + random.below(2);
    scene.girders = parts::row(random, &girder, count, gap, true);
    parts::walls(random, &mut scene, gap);
    scene.contact = contact(random, &sizes);
    scene.motion = motion(random, &sizes, amplitude, kind);
    scene.duration = three_digits(random.range(4.0, 15.0) / hertz);
    scene.solver.tolerance = random.log(1e-11, 1e-6);
    let mut settings = bearings(random, &scene, &sizes);
    settings.extend(backfill(random, &scene));
    settings.extend(parts_of_a_bridge(random, &scene, &sizes));
    // A setting that does not fit is left out.
    settings.iter().fold(scene, |scene, setting| overrides::apply(&scene, setting).unwrap_or(scene))
}

/// Those scenes under a wave that crosses a girder in up to half a period, or with supports of their own motion.
pub(super) fn waves(random: &mut Random) -> Scene {
    let mut scene = devices(random);
    let Some(girder) = scene.girders.first() else { return scene };
    // From the way of the girder's bearings: the frequency is that of the ground where it is a sine.
    let hertz = if let Motion::Sine(sine) = &scene.motion { sine.frequency_hz } else { 1.0 };
    let crossing = random.range(0.01, 0.5) / hertz;
    let wave =
        Wave { speed: three_digits(girder.length / crossing), angle_deg: three_digits(random.range(-180.0, 180.0)) };
    if random.chance(0.7) {
        scene.wave = Some(wave);
    }
    for abutment in &mut scene.abutments {
        abutment.delay = random.chance(0.3).then(|| three_digits(random.range(0.0, 1.0) * crossing));
        abutment.motion_factor = random.chance(0.3).then(|| three_digits(random.range(0.5, 1.5)));
    }
    let on = |end: &str| scene.abutments.iter().find(|a| a.end.label() == end).map(|a| a.name.clone());
    let (minus, plus) = (on("-x"), on("+x"));
    let (first, last) = (scene.girders[0].name.clone(), scene.girders[scene.girders.len() - 1].name.clone());
    let named = [(first, "on_minus_x", minus), (last, "on_plus_x", plus)];
    let settings =
        named.into_iter().filter_map(|(girder, key, name)| Some(format!("girder.{girder}.bearings.{key}={}", name?)));
    let settings: Vec<String> = settings.filter(|_| random.chance(0.5)).collect();
    let plain = Scene { wave: None, ..scene.clone() };
    let scene = settings.iter().fold(scene, |scene, setting| overrides::apply(&scene, setting).unwrap_or(scene));
    // What does not go with a wave, such as a slider in space, is shaken as one.
    if validate::validate(&scene).is_ok() {
        return scene;
    }
    let as_one = |abutment: &Abutment| Abutment { delay: None, motion_factor: None, ..abutment.clone() };
    Scene { abutments: plain.abutments.iter().map(as_one).collect(), ..plain }
}

fn girder(random: &mut Random) -> Girder {
    let length = random.log(0.15, 50.0);
    let width = three_digits(length * random.log(0.2, 0.6));
    let thickness = three_digits(length * random.log(0.04, 0.15));
    let skew_deg = if random.chance(0.25) { 90.0 } else { three_digits(random.range(35.0, 145.0)) };
    let mass = three_digits(CONCRETE_DENSITY * length * width * thickness * random.log(0.2, 2.0));
    Girder { skew_deg, ..Girder::straight("g0", [length, width, thickness], mass) }
}

fn contact(random: &mut Random, sizes: &Sizes) -> ContactSettings {
    let mu_kinetic = three_digits(random.range(0.0, 0.8));
    ContactSettings {
        stiffness: Some(sizes.stiffness(random.log(10.0, 300.0))),
        normal_law: random.pick(NormalName::ALL),
        calibration: random.pick(Calibration::ALL),
        law: random.pick(FrictionLaw::ALL),
        restitution_normal: three_digits(random.range(0.35, 1.0)),
        restitution_tangential: three_digits(random.range(0.35, 1.0)),
        mu_kinetic,
        mu_static: three_digits(mu_kinetic + random.range(0.0, 0.3)),
        ..ContactSettings::default()
    }
}

/// A sine, or a record of as great a peak.
fn motion(random: &mut Random, sizes: &Sizes, amplitude: f64, kind: Kind) -> Motion {
    if random.chance(0.4) {
        return parts::record(random, sizes.hertz * 2.0, sizes.hertz, sizes.way);
    }
    let vertical = if random.chance(0.3) { Some(three_digits(random.range(0.0, 1.5) * amplitude)) } else { None };
    Motion::Sine(SineMotion {
        amplitude_g: Some(amplitude),
        amplitude: None,
        frequency_hz: three_digits(sizes.hertz * random.log(0.5, 3.0)),
        phase_deg: 0.0,
        angle_deg: three_digits(random.range(0.0, 90.0)),
        vertical_amplitude_g: vertical.filter(|_| kind == Kind::Spatial),
        vertical_amplitude: None,
        vertical_phase_deg: None,
    })
}

/// Bearings of every girder, as settings.
fn bearings(random: &mut Random, scene: &Scene, sizes: &Sizes) -> Vec<String> {
    let spatial = scene.kind == Kind::Spatial;
    let up = three_digits(sizes.hertz * random.log(4.0, 15.0));
    let mut settings = Vec::new();
    for girder in &scene.girders {
        let (x, y) = (three_digits(0.45 * girder.length), three_digits(0.35 * girder.width));
        let places = [[x, y], [x, -y], [-x, y], [-x, -y]];
        let travel = if random.chance(0.15) {
            settings.push(format!("girder.{}.after_unseating=\"continue\"", girder.name));
            format!(", travel_m = {:?}", sizes.length(random.log(0.3, 3.0)))
        } else {
            String::new()
        };
        let vertical = if spatial {
            format!(", vertical_frequency_hz = {up:?}, vertical_damping_ratio = 0.05")
        } else {
            String::new()
        };
        let at = format!("at_skewed_m = {places:?}{vertical}{travel}");
        let value = match random.below(6) {
            0 => format!("{{ frequency_hz = {:?}, damping_ratio = {:?}, {at} }}", sizes.hertz, random.log(1e-3, 0.3)),
            1 => {
                let (period, force) = (three_digits(1.0 / sizes.hertz), random.log(0.02, 0.2));
                let ratio = random.log(2.0, 20.0);
                format!(
                    "{{ kind = \"lead-rubber\", post_yield_period_s = {period:?}, yield_force_per_weight = {force:?}, \
                     stiffness_ratio = {ratio:?}, {at} }}"
                )
            }
            2 => {
                let radius = if random.chance(0.3) { 0.0 } else { STANDARD_GRAVITY / (TAU * sizes.hertz).powi(2) };
                let (friction, slides) = (random.log(0.02, 0.3), sizes.length(random.log(1e-3, 1e-1)));
                format!(
                    "{{ kind = \"pendulum\", radius_m = {:?}, friction = {friction:?}, slider_displacement_m = {slides:?}, {at} }}",
                    three_digits(radius)
                )
            }
            _ => singles(random, sizes, places, (spatial, up), &travel),
        };
        settings.push(format!("girder.{}.bearings={value}", girder.name));
    }
    settings
}

/// Single bearings that yield on a circle or per axis, each its own force.
fn singles(
    random: &mut Random,
    sizes: &Sizes,
    places: [[f64; 2]; 4],
    (spatial, up): (bool, f64),
    travel: &str,
) -> String {
    let per_axis = random.chance(0.5);
    let upright = if spatial { three_digits(sizes.mass / 4.0 * (TAU * up).powi(2)) } else { 0.0 };
    let mut leg = |place: [f64; 2]| {
        let stiffness = three_digits(sizes.stiffness(1.0) / 4.0 * random.log(0.7, 1.4));
        let (force, yields) = (sizes.weight(random.log(0.005, 0.05)), sizes.length(random.log(0.01, 0.3)));
        format!(
            "{{ at_m = {place:?}, stiffness_n_per_m = [{stiffness:?}, {stiffness:?}, {upright:?}], \
             damping_n_s_per_m = [0, 0, {:?}], yield_force_n = {force:?}, yield_displacement_m = {yields:?}, \
             yields_per_axis = {per_axis}{travel} }}",
            three_digits(0.05 * upright / (TAU * up))
        )
    };
    format!("[{}]", places.map(&mut leg).join(", "))
}

/// Soil behind abutments of planar scenes.
fn backfill(random: &mut Random, scene: &Scene) -> Vec<String> {
    let planar = scene.kind == Kind::Planar;
    let mut behind = |name: &str| {
        let law = random.pick(&["hyperbolic", "mean-stiffness", "bilinear"]);
        (planar && random.chance(0.4)).then(|| format!("abutment.{name}.backfill={{ law = \"{law}\" }}"))
    };
    scene.abutments.iter().filter_map(|abutment| behind(&abutment.name)).collect()
}

/// Cable, rubber, dashpot and key, each or not, between the first girder and the ground or its neighbour.
fn parts_of_a_bridge(random: &mut Random, scene: &Scene, sizes: &Sizes) -> Vec<String> {
    let girder = &scene.girders[0];
    let [a, b] = [girder.length, girder.width].map(|size| three_digits(0.4 * size));
    // The first girder of a row of two has its neighbour beyond its +x end.
    let to = scene.girders.get(1).filter(|_| random.chance(0.7)).map(|other| other.name.clone());
    let second = match &to {
        Some(name) => format!("to = \"{name}\", to_m = [{:?}, {:?}]", -a, 0.5 * b),
        None => format!("to_m = [{:?}, {:?}]", three_digits(girder.position[0] + 2.0 * a), 0.5 * b),
    };
    let head = format!("girder = \"{}\", at_m = [{a:?}, {:?}]", girder.name, 0.3 * b);
    let stiff = |random: &mut Random| sizes.stiffness(random.log(2.0, 20.0));
    let mut all = Vec::new();
    if random.chance(0.5) {
        let (stiffness, slack) = (stiff(random), sizes.length(random.log(0.05, 1.0)));
        let yields = match random.below(3) {
            0 => String::new(),
            1 => format!(", yield_force_n = {:?}", sizes.weight(random.log(0.05, 1.0))),
            _ => format!(", break_elongation_m = {:?}", sizes.length(random.log(0.05, 1.0))),
        };
        all.push(format!(
            "restrainer=[{{ name = \"cable\", {head}, {second}, slack_m = {slack:?}, stiffness_n_per_m = {stiffness:?}{yields} }}]"
        ));
    }
    if random.chance(0.4) {
        let (stiffness, gap) = (stiff(random), sizes.length(random.log(0.1, 1.0)));
        let damping = three_digits(0.05 * stiffness / (TAU * sizes.hertz));
        all.push(format!(
            "bumper=[{{ name = \"rubber\", girder = \"{}\", at_m = [{:?}, 0], to_m = [{:?}, 0], normal = [1, 0], gap_m = {gap:?}, \
             stiffness_n_per_m = {stiffness:?}, damping_n_s_per_m = {damping:?} }}]",
            girder.name,
            -a,
            three_digits(girder.position[0] - 2.0 * a)
        ));
    }
    if random.chance(0.5) {
        let exponent = random.pick(&[0.3, 0.5, 1.0]);
        // As much force at the speed of the motion as a part of the weight.
        let speed = TAU * sizes.hertz * sizes.way;
        let coefficient = three_digits(sizes.weight(random.log(0.01, 0.1)) / speed.powf(exponent));
        let brace =
            if random.chance(0.3) { format!(", brace_stiffness_n_per_m = {:?}", stiff(random)) } else { String::new() };
        all.push(format!(
            "damper=[{{ name = \"dashpot\", {head}, {second}, coefficient = {coefficient:?}, exponent = {exponent:?}{brace} }}]"
        ));
    }
    if random.chance(0.4) {
        let (stiffness, gap) = (stiff(random), sizes.length(random.log(0.05, 0.8)));
        let force = sizes.weight(random.log(0.05, 1.0));
        let fails = match random.below(3) {
            0 => String::new(),
            1 => format!(", break_force_n = {force:?}"),
            _ => {
                format!(", yield_force_n = {force:?}, break_displacement_m = {:?}", sizes.length(random.log(0.1, 1.0)))
            }
        };
        all.push(format!(
            "stopper=[{{ name = \"key\", girder = \"{}\", at_m = [{a:?}, 0], direction = [0, 1], gap_m = {gap:?}, \
             stiffness_n_per_m = {stiffness:?}{fails} }}]",
            girder.name
        ));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::validate::validate;
    use crate::scene::{Bearings, domain};

    fn scenes() -> impl Iterator<Item = Scene> {
        (0..200).map(|seed| Scene {
            name: format!("seed-{seed}"),
            ..devices(&mut Random::new(super::super::FIRST_DEVICES + seed))
        })
    }

    #[test]
    fn every_kind_of_bearing_device_and_law_comes_up_and_the_scenes_are_sound() {
        let mut seen = [0; 9];
        let mut laws = std::collections::BTreeSet::new();
        let mut inside = 0;
        for scene in scenes() {
            assert_eq!(validate(&scene), Ok(()), "{}", scene.name);
            inside += usize::from(domain::is_inside(&scene));
            laws.insert(scene.contact.normal_law.label());
            let bearings = scene.girders.iter().filter_map(|girder| girder.bearings.as_ref());
            for bearings in bearings {
                match bearings {
                    Bearings::Shared(_) => seen[0] += 1,
                    Bearings::Deck(_) => seen[1] += 1,
                    Bearings::Each(_) => seen[2] += 1,
                }
            }
            seen[3] += scene.restrainers.len();
            seen[4] += scene.bumpers.len();
            seen[5] += scene.dampers.len();
            seen[6] += scene.stoppers.len();
            seen[7] += scene.abutments.iter().filter(|abutment| abutment.backfill.is_some()).count();
            seen[8] += scene.girders.iter().filter(|girder| girder.after_unseating.is_some()).count();
        }
        assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
        assert_eq!(laws.len(), NormalName::ALL.len(), "{laws:?}");
        assert!(inside > 150, "{inside} of 200 inside the domain");
    }
}
