//! Scans: a finding's number over two of the values that the paper leaves open or that its models depend on.

use super::cases::{Case, Shaking, Specimen};
use super::earthquake::Earthquake;
use super::findings::rules;
use super::observe::Observed;
use super::results::ScanResult;
use crate::contact::parameters::damping_ratio;
use crate::scene::{Bearings, ModelKind, Motion, Scene, SceneErrors, Sharing};
use crate::sim::History;

/// A value of the scene that is scanned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    /// Gap (assumed) \[mm\].
    Gap,
    /// Places of the legs along the girder, ± (assumed) \[mm\].
    LegsAlong,
    /// Places of the legs across the girder, ± (assumed) \[mm\].
    LegsAcross,
    /// Static friction; kinetic friction is 0.75 of it, as in Table 3.
    Friction,
    /// `e_n`.
    Restitution,
    /// Power of ten of K in N/m; contact model.
    Stiffness,
    /// Scale of the earthquake.
    Scale,
    /// Skew angle β \[degrees\].
    Skew,
    /// Excitation angle \[degrees\].
    Angle,
}

impl Knob {
    /// With its unit.
    pub fn label(self) -> &'static str {
        match self {
            Self::Gap => "gap [mm]",
            Self::LegsAlong => "legs at ±x [mm]",
            Self::LegsAcross => "legs at ±y [mm]",
            Self::Friction => "friction μ_s (μ_k = 0.75 μ_s)",
            Self::Restitution => "restitution e_n",
            Self::Stiffness => "log10 of K [N/m]",
            Self::Scale => "scale of the record",
            Self::Skew => "skew angle β [°]",
            Self::Angle => "excitation angle [°]",
        }
    }

    /// Its value in the presets.
    pub fn preset(self) -> f64 {
        match self {
            Self::Gap => 3.0,
            Self::LegsAlong => 70.0,
            Self::LegsAcross => 25.0,
            Self::Friction => 0.2,
            Self::Restitution => 0.4,
            Self::Stiffness => 1.55e5_f64.log10(),
            Self::Scale => 1.0,
            Self::Skew => 45.0,
            Self::Angle => 0.0,
        }
    }

    /// Sets it in a scene of the paper's.
    fn set(self, scene: &mut Scene, value: f64) {
        match self {
            Self::Gap => set_gap(scene, value / 1e3),
            Self::LegsAlong => set_legs(scene, 0, value / 1e3),
            Self::LegsAcross => set_legs(scene, 1, value / 1e3),
            Self::Friction => {
                (scene.contact.mu_static, scene.impact.mu_static) = (value, value);
                (scene.contact.mu_kinetic, scene.impact.mu_kinetic) = (0.75 * value, 0.75 * value);
            }
            Self::Restitution => {
                (scene.contact.restitution_normal, scene.impact.restitution_normal) = (value, value);
            }
            Self::Stiffness => scene.contact.stiffness = Some(10f64.powf(value)),
            Self::Scale => {
                if let Motion::Record(record) = &mut scene.motion {
                    record.scale *= value;
                }
            }
            Self::Skew => scene.girders.iter_mut().for_each(|girder| girder.skew_deg = value),
            Self::Angle => match &mut scene.motion {
                Motion::Sine(sine) => sine.angle_deg = value,
                Motion::Record(record) => record.angle_deg = value,
                Motion::None | Motion::Synthetic(_) => {}
            },
        }
    }
}

/// Sets the gap before an abutment, or between two girders in a row \[m\].
fn set_gap(scene: &mut Scene, gap: f64) {
    scene.abutments.iter_mut().for_each(|abutment| abutment.gap = Some(gap));
    if let [first, second] = scene.girders.as_mut_slice() {
        second.position[0] = first.position[0] + 0.5 * (first.length + second.length) + gap;
    }
}

/// Sets the distance of the legs from the middle along one axis \[m\].
fn set_legs(scene: &mut Scene, axis: usize, distance: f64) {
    for girder in &mut scene.girders {
        if let Some(Bearings::Shared(shared)) = &mut girder.bearings {
            let places = shared.at_skewed.iter_mut().flatten();
            places.for_each(|place| place[axis] = distance.copysign(place[axis]));
        }
    }
}

/// A number of one or several cases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// Hits a cycle of the straight girder driven along its axis.
    Hits(Shaking),
    /// Movement of the straight girder's ends by rotation over its transverse displacement, at 22.5°.
    EndMovement,
    /// Rotation of the 45° girder over that of the 60° one, along the axis.
    Skews,
    /// Rotation of the 60° girder driven at −60° over that on the axis; at +60° the motion runs along the wall.
    OffAxis,
    /// Largest rotation of the 45° girder \[degrees\].
    Rotation,
    /// Part of the successions of hits under the earthquake that have two hits or more, straight girder head-on.
    Successions,
    /// Rotation under the earthquake over that under the sine of 0.40 g, straight girder at 45°.
    RecordRotation,
    /// Larger end movement of the two girders over their transverse displacement.
    PairMovement,
}

impl Measure {
    /// With its unit.
    pub fn label(self) -> &'static str {
        match self {
            Self::Hits(_) => "hits a cycle",
            Self::EndMovement | Self::PairMovement => "end movement / y",
            Self::Skews => "θ(45°) / θ(60°)",
            Self::OffAxis => "θ(−60°) / θ(0°)",
            Self::Rotation => "largest θ [°]",
            Self::Successions => "part in succession",
            Self::RecordRotation => "θ record / θ sine",
        }
    }

    /// The cases that it needs.
    fn cases(self) -> Vec<Case> {
        use Shaking::{Large, Record};
        use Specimen::{Pair, Skew45, Skew60, Straight};
        match self {
            Self::Hits(shaking) => vec![Case::new(Straight, 0.0, shaking)],
            Self::EndMovement => vec![Case::new(Straight, 22.5, Large)],
            Self::Skews => vec![Case::new(Skew60, 0.0, Large), Case::new(Skew45, 0.0, Large)],
            Self::OffAxis => [0.0, -60.0].map(|angle| Case::new(Skew60, angle, Large)).into(),
            Self::Rotation => vec![Case::new(Skew45, 0.0, Large)],
            Self::Successions => vec![Case::new(Straight, 0.0, Record)],
            Self::RecordRotation => vec![Case::new(Straight, 45.0, Record), Case::new(Straight, 45.0, Large)],
            Self::PairMovement => vec![Case::new(Pair, 22.5, Large)],
        }
    }

    /// Its value, from what was seen of its cases.
    fn value(self, seen: &[Observed]) -> Option<f64> {
        const HALF_LENGTH: f64 = 0.095;
        let period = 1.0 / Specimen::Straight.sine_hz();
        let turned = |i: usize| seen.get(i).map(Observed::rotation);
        let value = match self {
            Self::Hits(_) => rules::hits_a_cycle(seen.first()?, period)?,
            Self::EndMovement | Self::PairMovement => {
                let girders = seen.first()?.girders.iter();
                girders.map(|girder| rules::end_movement(girder, HALF_LENGTH)).fold(0.0, f64::max)
            }
            Self::Skews | Self::OffAxis => turned(1)? / turned(0)?,
            Self::Rotation => turned(0)?.to_degrees(),
            Self::Successions => {
                let all = rules::successions(&seen.first()?.hits, period);
                all.iter().filter(|hits| hits.len() > 1).count() as f64 / all.len() as f64
            }
            Self::RecordRotation => turned(0)? / turned(1)?,
        };
        value.is_finite().then_some(value)
    }
}

/// Which model makes a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// Above the map.
    pub name: &'static str,
    kind: ModelKind,
    sharing: Sharing,
}

const CONTACT: Variant = Variant { name: "contact model", kind: ModelKind::Contact, sharing: Sharing::Tributary };
const IMPACT: Variant = Variant { name: "impact model", kind: ModelKind::Impact, sharing: Sharing::Tributary };
const PER_NODE: Variant =
    Variant { name: "contact model, K per node", kind: ModelKind::Contact, sharing: Sharing::PerNode };

/// A measure over two knobs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scan {
    /// Its name, of its file too.
    pub name: &'static str,
    /// What is seen, in a line.
    pub title: &'static str,
    /// The level axis: first and last value, number of steps.
    pub x: (Knob, [f64; 2], usize),
    /// The upright axis.
    pub y: (Knob, [f64; 2], usize),
    /// What is measured.
    pub measure: Measure,
    /// The maps, from left to right.
    pub variants: &'static [Variant],
}

const BOTH: &[Variant] = &[CONTACT, IMPACT];
const GAP: (Knob, [f64; 2], usize) = (Knob::Gap, [2.0, 5.0], 7);
const ALONG: (Knob, [f64; 2], usize) = (Knob::LegsAlong, [40.0, 90.0], 6);
const ACROSS: (Knob, [f64; 2], usize) = (Knob::LegsAcross, [10.0, 35.0], 6);
const FRICTION: (Knob, [f64; 2], usize) = (Knob::Friction, [0.0, 0.5], 6);
const RESTITUTION: (Knob, [f64; 2], usize) = (Knob::Restitution, [0.1, 0.8], 8);
const STIFFNESS: (Knob, [f64; 2], usize) = (Knob::Stiffness, [4.0, 7.0], 7);
const SCALE: (Knob, [f64; 2], usize) = (Knob::Scale, [0.5, 3.0], 6);

/// Every scan.
pub(super) const SCANS: [Scan; 13] = [
    scan("hits-0.23g", "Hits a cycle, head-on at 0.23 g", GAP, RESTITUTION, Measure::Hits(Shaking::Small)),
    scan("hits-0.40g", "Hits a cycle, head-on at 0.40 g", GAP, RESTITUTION, Measure::Hits(Shaking::Large)),
    scan(
        "end-movement-friction",
        "Straight girder at 22.5°: how much of its transverse movement is rotation",
        FRICTION,
        RESTITUTION,
        Measure::EndMovement,
    ),
    scan(
        "end-movement-legs",
        "Straight girder at 22.5°: how much of its transverse movement is rotation",
        ALONG,
        ACROSS,
        Measure::EndMovement,
    ),
    scan("skew-friction", "Rotation of the 45° girder over that of the 60° one", FRICTION, RESTITUTION, Measure::Skews),
    scan("skew-gap", "Rotation of the 45° girder over that of the 60° one", GAP, FRICTION, Measure::Skews),
    scan("skew-legs", "Rotation of the 45° girder over that of the 60° one", ALONG, ACROSS, Measure::Skews),
    Scan {
        variants: &[CONTACT, PER_NODE],
        ..scan(
            "skew-stiffness",
            "Rotation of the 45° girder over that of the 60° one",
            STIFFNESS,
            RESTITUTION,
            Measure::Skews,
        )
    },
    scan("axis-gap", "60° girder: rotation driven at −60° over that on the axis", GAP, FRICTION, Measure::OffAxis),
    scan("axis-legs", "60° girder: rotation driven at −60° over that on the axis", ALONG, ACROSS, Measure::OffAxis),
    scan(
        "record-hits",
        "Record, head-on: part of the successions with two hits or more",
        GAP,
        SCALE,
        Measure::Successions,
    ),
    scan(
        "record-rotation",
        "Record at 45°: rotation over that under the sine of 0.40 g",
        GAP,
        SCALE,
        Measure::RecordRotation,
    ),
    scan(
        "pair-rotation",
        "Two girders: how much of their transverse movement is rotation",
        FRICTION,
        ALONG,
        Measure::PairMovement,
    ),
];

/// The paper's map: skew and excitation angle.
pub(super) const SKEW_ANGLE: Scan = scan(
    "skew-angle",
    "Largest rotation over skew and excitation angle, 0.40 g at 2.6 Hz",
    (Knob::Skew, [30.0, 90.0], 13),
    (Knob::Angle, [-90.0, 90.0], 13),
    Measure::Rotation,
);

const fn scan(
    name: &'static str,
    title: &'static str,
    x: (Knob, [f64; 2], usize),
    y: (Knob, [f64; 2], usize),
    measure: Measure,
) -> Scan {
    Scan { name, title, x, y, measure, variants: BOTH }
}

/// Values of an axis, evenly spaced.
pub(super) fn steps((_, [from, to], count): (Knob, [f64; 2], usize)) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    let value = |i: usize| from + (to - from) * (i as f64 / last);
    // Steps are decimal numbers.
    (0..count).map(value).map(|v| (v * 1e6).round() / 1e6).collect()
}

impl Scan {
    /// Every scan, the paper's map last.
    pub fn all() -> impl Iterator<Item = Self> {
        SCANS.into_iter().chain([SKEW_ANGLE])
    }

    /// The scenes that it starts from.
    ///
    /// # Errors
    /// None: the presets are part of the program.
    pub(super) fn scenes(&self, earthquake: &Earthquake) -> Result<Vec<Scene>, SceneErrors> {
        self.measure.cases().iter().map(|case| case.scene(earthquake)).collect()
    }

    /// Runs it, cell by cell.
    ///
    /// # Errors
    /// A scene that does not validate.
    pub(super) fn run(&self, earthquake: &Earthquake) -> Result<ScanResult, SceneErrors> {
        let scenes = self.scenes(earthquake)?;
        let map = |variant: &Variant| {
            let cells = steps(self.y).into_iter().flat_map(|y| steps(self.x).into_iter().map(move |x| [x, y]));
            cells.map(|cell| self.cell(&scenes, cell, variant)).collect::<Result<Vec<_>, SceneErrors>>()
        };
        Ok(ScanResult { maps: self.variants.iter().map(map).collect::<Result<_, _>>()? })
    }

    fn cell(&self, scenes: &[Scene], [x, y]: [f64; 2], variant: &Variant) -> Result<Option<f64>, SceneErrors> {
        let run = |scene: &Scene| {
            let mut scene = scene.clone();
            self.x.0.set(&mut scene, x);
            self.y.0.set(&mut scene, y);
            (scene.model.kind, scene.contact.sharing) = (variant.kind, variant.sharing);
            let history = History::of(&scene)?;
            Ok(history.stop().is_none().then(|| Observed::without_histories(&history)))
        };
        let seen: Option<Vec<Observed>> = scenes.iter().map(run).collect::<Result<_, SceneErrors>>()?;
        Ok(seen.and_then(|seen| self.measure.value(&seen)))
    }
}

/// Half a period of the model girder on the spring of the contact, K = 1.55e5 N/m with `e_n` = 0.4: how long a head-on hit
/// lasts \[s\].
pub(super) fn hit_time() -> f64 {
    let (stiffness, mass, restitution) = (1.55e5_f64, 2.0, 0.4);
    let damping = damping_ratio(restitution);
    std::f64::consts::PI / ((stiffness / mass).sqrt() * (1.0 - damping * damping).sqrt())
}
