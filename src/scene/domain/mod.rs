//! The domain of the program: ranges of the quantities of a scene within which every check of the stability study holds
//! (`docs/stability.md#domain`).
//!
//! A scene outside is computed all the same. Its run ends, with an answer or with a reason; how exact the answer is has
//! not been checked.

pub(super) mod measures;

pub use measures::{BesideGirder, beside_girders};

use std::fmt;

use super::facing::{self, Facing, Side};
use super::{Girder, ModelKind, Motion, RecordMotion, Scene};
use crate::language::{Text, values};

/// A quantity of a scene, and the range that belongs to the domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// Name of the limited quantity.
    pub quantity: Text,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// From the first to the second number, both included.
    pub range: [f64; 2],
    /// Consequence of a value below the first number and above the second.
    pub beyond: [Option<Text>; 2],
    /// Remedy for a scene beyond it.
    pub remedy: Text,
}

/// No text: a range that begins at 0 has nothing below.
const NOTHING: Option<Text> = None;
/// Text of a range that is the one of the checks.
const UNCHECKED: Text = Text::new("domain-unchecked");

/// `solver.tolerance`. Below: from its 1000th step with contact on a body's steps may err by less, in proportion to their
/// number, but by no less than 1e-13, where errors are rounding; at 1e-12 that takes 10,000 steps. Above: an explicit step
/// spans 0.48 rad of a contact at 1e-10 and grows with the eighth root, to 2.7 rad at 1e-4 and past half a period (π) at
/// 3.4e-4.
pub const TOLERANCE: Limit = Limit {
    quantity: Text::new("domain-tolerance"),
    unit: "",
    range: [1e-12, 1e-4],
    beyond: [Some(Text::new("domain-below-tolerance")), Some(Text::new("domain-above-tolerance"))],
    remedy: Text::new("domain-mend-tolerance"),
};
/// Forces, energies and stiffnesses scale with the mass, so no number of the solver depends on it; the range is what seeds
/// cover: from grams to a viaduct.
pub const MASS: Limit = Limit {
    quantity: Text::new("domain-mass"),
    unit: "kg",
    range: [1e-3, 1e8],
    beyond: [Some(UNCHECKED), Some(UNCHECKED)],
    remedy: Text::new("domain-mend-mass"),
};
/// A place 1000 m from home rounds by 1.1e-13 m. Below: what seeds cover.
pub const SIZE: Limit = Limit {
    quantity: Text::new("domain-size"),
    unit: "m",
    range: [1e-3, 1e3],
    beyond: [Some(UNCHECKED), Some(Text::new("domain-above-size"))],
    remedy: Text::new("domain-mend-size"),
};
/// Each coordinate of a girder's G. Gaps are differences of places as placed: at 1e6 m these round by 1.2e-10 m, at 1e15 m by 0.1 m.
pub const PLACE: Limit = Limit {
    quantity: Text::new("domain-place"),
    unit: "m",
    range: [0.0, 1e6],
    beyond: [NOTHING, Some(Text::new("domain-above-place"))],
    remedy: Text::new("domain-mend-place"),
};
/// The ends of nearly parallel girders reach as far as the skew makes them, b / sin β: 11 widths at 5°.
pub const SKEW: Limit = Limit {
    quantity: Text::new("domain-skew"),
    unit: "°",
    range: [5.0, 175.0],
    beyond: [Some(UNCHECKED), Some(UNCHECKED)],
    remedy: Text::new("domain-mend-skew"),
};
/// Distance of a bearing from G over that of the farthest corner. Bearings stand under the girder, in seeds as in bridges; a cross
/// beam may carry one beyond its edge by as much again. Above: the rotation's rate grows with the distance.
pub const BEARING_PLACE: Limit = Limit {
    quantity: Text::new("domain-bearing-place"),
    unit: "",
    range: [0.0, 2.0],
    beyond: [NOTHING, Some(Text::new("domain-above-bearing-place"))],
    remedy: Text::new("domain-mend-bearing-place"),
};
/// Distance of a device's point on a girder from its G, over that of the farthest corner: as of a bearing.
pub const DEVICE_PLACE: Limit = Limit {
    quantity: Text::new("domain-device-place"),
    unit: "",
    range: [0.0, 2.0],
    beyond: [NOTHING, Some(Text::new("domain-above-device-place"))],
    remedy: Text::new("domain-mend-bearing-place"),
};
/// Distance of a bearing from the top of the pier that it stands on, along the pier's first axis, over the girder's length. Ends
/// on one cap are a seat and a gap apart, some hundredths of a span (chosen: a quarter).
pub const PIER_PLACE: Limit = Limit {
    quantity: Text::new("domain-pier-place"),
    unit: "",
    range: [0.0, 0.25],
    beyond: [NOTHING, Some(Text::new("domain-above-pier-place"))],
    remedy: Text::new("domain-mend-pier-place"),
};
/// `K/M`, with the reduced mass M of (65). Below: a blow at 1 m/s presses the faces by 1 m, `v/√(K/M)`. Above: an acceleration
/// of 1e-3 m/s² presses a face that rests by 1e-12 m, `a M/K`, where places of 1 m round by 2e-16 m.
pub const STIFFNESS: Limit = Limit {
    quantity: Text::new("domain-stiffness"),
    unit: "1/s²",
    range: [1.0, 1e9],
    beyond: [Some(Text::new("domain-below-stiffness")), Some(Text::new("domain-above-stiffness"))],
    remedy: Text::new("domain-mend-stiffness"),
};
/// `√(K/M) T`. Explicit steps of a closed contact span 0.5 to 2.7 rad, and the work of a run is bounded by 1e7 steps and searches a
/// body.
pub const CONTACT_PHASE: Limit = Limit {
    quantity: Text::new("domain-contact-phase"),
    unit: "rad",
    range: [0.0, 1e7],
    beyond: [NOTHING, Some(Text::new("domain-above-contact-phase"))],
    remedy: Text::new("domain-mend-contact-phase"),
};
/// `ω T` of the fastest bearing (or its decay c/m), the ground, a spin; a record counts its samples. The longest seed has 8.8e4,
/// an hour at 3 Hz 6.8e4.
pub const MOTION_PHASE: Limit = Limit {
    quantity: Text::new("domain-motion-phase"),
    unit: "rad",
    range: [0.0, 1e5],
    beyond: [NOTHING, Some(Text::new("domain-above-motion-phase"))],
    remedy: Text::new("domain-mend-motion-phase"),
};
/// Of pushes (at G, and of a corner by the moment), gravity and the ground: ten times that of gravity. Above: the checks failed
/// once where 3.6e4 m/s² had made a girder tumble at thousands of rad/s (seed 5735).
pub const ACCELERATION: Limit = Limit {
    quantity: Text::new("domain-acceleration"),
    unit: "m/s²",
    range: [0.0, 100.0],
    beyond: [NOTHING, Some(Text::new("domain-above-acceleration"))],
    remedy: Text::new("domain-mend-acceleration"),
};
/// Of G by the velocity, of the farthest corner by the spin; and the speeds that a displaced start leads to, `ω (|d| + |θ| r)` by the
/// fastest bearing and `√(K/M) δ` by a face that is pressed in: the range of the seeds.
pub const SPEED: Limit = Limit {
    quantity: Text::new("domain-speed"),
    unit: "m/s",
    range: [0.0, 100.0],
    beyond: [NOTHING, Some(UNCHECKED)],
    remedy: Text::new("domain-mend-speed"),
};
/// A whole turn more is the same place, but bearings in plan are wound up by it, and the angle rounds.
pub const TURN: Limit = Limit {
    quantity: Text::new("domain-turn"),
    unit: "°",
    range: [0.0, 180.0],
    beyond: [NOTHING, Some(UNCHECKED)],
    remedy: Text::new("domain-mend-turn"),
};
/// Friction coefficients of the seeds.
pub const FRICTION: Limit = Limit {
    quantity: Text::new("domain-friction"),
    unit: "",
    range: [0.0, 2.0],
    beyond: [NOTHING, Some(Text::new("domain-unchecked-friction"))],
    remedy: Text::new("domain-mend-friction"),
};

/// All of them.
pub const LIMITS: &[Limit] = &[
    TOLERANCE,
    MASS,
    SIZE,
    PLACE,
    SKEW,
    BEARING_PLACE,
    DEVICE_PLACE,
    PIER_PLACE,
    STIFFNESS,
    CONTACT_PHASE,
    MOTION_PHASE,
    ACCELERATION,
    SPEED,
    TURN,
    FRICTION,
];

/// A quantity of a scene that lies outside the domain.
#[derive(Clone, Debug, PartialEq)]
pub struct Departure {
    /// The key that it comes from: `girder.deck.mass_kg`.
    pub place: String,
    /// The facing pair that it belongs to.
    pub pair: Option<String>,
    /// Value in the scene.
    pub value: f64,
    /// Limit that it exceeds.
    pub limit: Limit,
}

impl Departure {
    /// Whether it is too small, not too large.
    fn is_below(&self) -> bool {
        self.value < self.limit.range[0]
    }

    /// The end of the range that it lies beyond.
    pub fn bound(&self) -> f64 {
        self.limit.range[usize::from(!self.is_below())]
    }

    /// Expected consequence.
    pub fn consequence(&self) -> Text {
        self.limit.beyond[usize::from(!self.is_below())].unwrap_or(UNCHECKED)
    }
}

impl fmt::Display for Departure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, pair, value, limit } = self;
        let of = pair.as_ref().map_or(String::new(), |pair| format!(" ({pair})"));
        let unit = if limit.unit.is_empty() { String::new() } else { format!(" {}", limit.unit) };
        let value = format!("{value:.3e}").parse().unwrap_or(*value);
        let said = if self.is_below() { Text::new("domain-is-below") } else { Text::new("domain-is-above") };
        let values = values![
            "place" => place.as_str(),
            "of" => of,
            "quantity" => limit.quantity,
            "value" => format!("{value:e}{unit}"),
            "bound" => format!("{:e}{unit}", self.bound()),
            "consequence" => self.consequence(),
            "remedy" => limit.remedy
        ];
        f.write_str(&said.with(&values))
    }
}

/// Every quantity of a scene that lies outside the domain: solver, girders, piers, devices, facing pairs, ground; none where the scene is
/// inside. The scene is one that validation accepts; of another, what can be told.
pub fn outside(scene: &Scene) -> Vec<Departure> {
    let mut found = Departures(Vec::new());
    found.look("solver.tolerance", scene.solver.tolerance, TOLERANCE);
    if scene.kind == super::Kind::Spatial {
        found.look("gravity_m_s2", scene.gravity.abs(), ACCELERATION);
    }
    for girder in &scene.girders {
        look_at_girder(scene, girder, &mut found);
    }
    for (bearing, place) in measures::pier_places(scene) {
        found.look(bearing, place, PIER_PLACE);
    }
    for (id, device) in scene.devices() {
        let ends = device.ends();
        for (key, place) in measures::device_places(scene, &ends) {
            found.look(format!("{}.{}.{key}", id.kind.label(), ends.name), place, DEVICE_PLACE);
        }
    }
    for (key, rate) in measures::damper_rates(scene) {
        found.look(key, rate * scene.duration, MOTION_PHASE);
    }
    for (number, pier) in scene.piers.iter().enumerate() {
        let resolved = scene.pier(number);
        found.look(format!("pier.{}.mass_kg", pier.name), resolved.mass, MASS);
        found.look(
            format!("pier.{}.mass_kg", pier.name),
            measures::pier_rate(&resolved) * scene.duration,
            MOTION_PHASE,
        );
    }
    for (key, factor, motion) in measures::factors(scene) {
        found.look(key, factor.abs() * measures::peak(motion), ACCELERATION);
    }
    for facing in facing::find(scene).unwrap_or_default() {
        look_at_pair(scene, &facing, &mut found);
    }
    for (place, motion) in scene.motions() {
        look_at_ground(scene, (&place, motion), &mut found);
    }
    found.0
}

/// Whether a scene lies inside.
pub fn is_inside(scene: &Scene) -> bool {
    outside(scene).is_empty()
}

/// Departures found so far.
struct Departures(Vec<Departure>);

impl Departures {
    fn look(&mut self, place: impl Into<String>, value: f64, limit: Limit) {
        self.look_of(place, None, value, limit);
    }

    fn look_of(&mut self, place: impl Into<String>, pair: Option<&str>, value: f64, limit: Limit) {
        let [low, high] = limit.range;
        if !(low..=high).contains(&value) {
            self.0.push(Departure { place: place.into(), pair: pair.map(str::to_owned), value, limit });
        }
    }
}

fn look_at_girder(scene: &Scene, girder: &Girder, found: &mut Departures) {
    let at = |key: &str| format!("girder.{}.{key}", girder.name);
    for (key, size) in [("length_m", girder.length), ("width_m", girder.width), ("thickness_m", girder.thickness)] {
        found.look(at(key), size, SIZE);
    }
    let farthest = girder.position.into_iter().map(f64::abs).fold(0.0, f64::max);
    found.look(at("position_m"), farthest, PLACE);
    found.look(at("skew_deg"), girder.skew_deg, SKEW);
    found.look(at("mass_kg"), girder.mass, MASS);
    found.look(at("bearings"), measures::bearing_place(girder, scene.setting()), BEARING_PLACE);
    found.look(at("bearings"), measures::bearing_rate(girder, scene.setting()) * scene.duration, MOTION_PHASE);
    let [speed, corner_speed] = measures::start_speeds(girder);
    found.look(at("initial.velocity_m_s"), speed, SPEED);
    found.look(at("initial.spin_deg_s"), corner_speed, SPEED);
    found.look(at("initial.spin_deg_s"), measures::spin(girder) * scene.duration, MOTION_PHASE);
    found.look(at("initial.rotation_deg"), girder.initial.rotation_deg.abs(), TURN);
    let [shifted, turned] = measures::start_displacements(girder);
    let rate = measures::bearing_rate(girder, scene.setting());
    found.look(at("initial.displacement_m"), rate * shifted, SPEED);
    found.look(at("initial.rotation_deg"), rate * turned, SPEED);
    let [force, moment] = measures::push_accelerations(girder);
    found.look(at("push.force_n"), force, ACCELERATION);
    found.look(at("push.moment_n_m"), moment, ACCELERATION);
}

fn look_at_pair(scene: &Scene, facing: &Facing, found: &mut Departures) {
    let name = Some(facing.name.as_str());
    found.look_of("contact.mu_static", name, facing.contact.mu_static, FRICTION);
    // The impact model has no stiffness.
    if scene.model.kind == ModelKind::Impact {
        return;
    }
    let stiffness = facing.contact.stiffness_per_mass(facing.mass);
    let given = facing.contact.normal_law.is_hertzian() && facing.contact.hertz_stiffness.is_some();
    let place = if given { "contact.hertz_stiffness_n_per_m1_5" } else { "contact.stiffness_n_per_m" };
    found.look_of(place, name, stiffness, STIFFNESS);
    found.look_of(place, name, stiffness.sqrt() * scene.duration, CONTACT_PHASE);
    if let Side::Girder(n, _) = facing.first {
        let pressed = measures::pressed_by(scene, facing);
        let place = format!("girder.{}.initial.displacement_m", scene.girders[n].name);
        found.look_of(place, name, stiffness.sqrt() * pressed, SPEED);
    }
}

fn look_at_ground(scene: &Scene, (place, motion): (&str, &Motion), found: &mut Departures) {
    let at = |key: &str| format!("{place}.{key}");
    match motion {
        Motion::None => {}
        Motion::Sine(sine) => {
            let key = if sine.amplitude_g.is_some() { "amplitude_g" } else { "amplitude_m_s2" };
            found.look(at(key), measures::peak(motion), ACCELERATION);
            let phase = std::f64::consts::TAU * sine.frequency_hz * scene.duration;
            found.look(at("frequency_hz"), phase, MOTION_PHASE);
        }
        Motion::Record(record) => look_at_record(scene, (place, record), found),
        Motion::Sweep(sweep) => {
            found.look(at("amplitude_g"), measures::peak(motion), ACCELERATION);
            let shaken = scene.duration.min(sweep.length);
            found.look(at("length_s"), shaken / sweep.sweep().interval(), MOTION_PHASE);
        }
        Motion::Synthetic(synthetic) => {
            found.look(at("peak_g"), measures::peak(motion), ACCELERATION);
            found.look(at("dt_s"), scene.duration.min(synthetic.duration) / synthetic.dt, MOTION_PHASE);
        }
    }
}

fn look_at_record(scene: &Scene, (place, record): (&str, &RecordMotion), found: &mut Departures) {
    let Some((peak, dt, count)) = record.extent() else { return };
    let several = !record.components.is_empty();
    let [peak_key, step_key] = match record.file {
        _ if several => ["component"; 2],
        Some(_) => ["file"; 2],
        None => ["samples_m_s2", "dt_s"],
    };
    found.look(format!("{place}.{peak_key}"), peak, ACCELERATION);
    found.look(format!("{place}.{step_key}"), (scene.duration / dt).min(count as f64), MOTION_PHASE);
}

#[cfg(test)]
mod tests;
