//! Scans: a finding's number over two of the values that the paper leaves open or that its models depend on.

mod measure;
mod parameter;

pub(super) use measure::Measure;
pub(super) use parameter::Parameter;

use super::cases::Shaking;
use super::earthquake::Earthquake;
use super::observe::Observed;
use super::results::ScanResult;
use crate::scene::{ModelKind, Scene, SceneErrors, Sharing};
use crate::sim::History;

/// Model of a map.
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

/// Axis of a scan: a parameter and the values that it takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Parameter that is varied.
    pub parameter: Parameter,
    /// First and last value, in the unit of the parameter.
    pub range: [f64; 2],
    /// Number of values.
    pub count: usize,
}

impl Axis {
    const fn new(parameter: Parameter, range: [f64; 2], count: usize) -> Self {
        Self { parameter, range, count }
    }

    /// Values, evenly spaced.
    pub(super) fn steps(self) -> Vec<f64> {
        let [from, to] = self.range;
        let last = self.count.saturating_sub(1).max(1) as f64;
        let value = |i: usize| from + (to - from) * (i as f64 / last);
        // Steps are decimal numbers.
        (0..self.count).map(value).map(|v| (v * 1e6).round() / 1e6).collect()
    }
}

/// A measure over two knobs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scan {
    /// Its name, of its file too.
    pub name: &'static str,
    /// Title, in a line.
    pub title: &'static str,
    /// Level axis.
    pub x: Axis,
    /// Upright axis.
    pub y: Axis,
    /// Measured value.
    pub measure: Measure,
    /// The maps, from left to right.
    pub variants: &'static [Variant],
}

const BOTH: &[Variant] = &[CONTACT, IMPACT];
const GAP: Axis = Axis::new(Parameter::Gap, [2.0, 5.0], 7);
const ALONG: Axis = Axis::new(Parameter::LegsAlong, [40.0, 90.0], 6);
const ACROSS: Axis = Axis::new(Parameter::LegsAcross, [10.0, 35.0], 6);
const FRICTION: Axis = Axis::new(Parameter::Friction, [0.0, 0.5], 6);
const RESTITUTION: Axis = Axis::new(Parameter::Restitution, [0.1, 0.8], 8);
const TANGENTIAL: Axis = Axis::new(Parameter::Tangential, [-1.0, 0.0], 11);
const STIFFNESS: Axis = Axis::new(Parameter::Stiffness, [4.0, 7.0], 7);
const SCALE: Axis = Axis::new(Parameter::Scale, [0.5, 3.0], 6);

/// Every scan.
pub(super) const SCANS: [Scan; 15] = [
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
    Scan {
        variants: &[IMPACT],
        ..scan(
            "end-movement-tangential",
            "Straight girder at 22.5°: end movement by rotation",
            TANGENTIAL,
            RESTITUTION,
            Measure::EndMovement,
        )
    },
    Scan {
        variants: &[IMPACT],
        ..scan(
            "pair-tangential",
            "Two girders: end movement by rotation",
            TANGENTIAL,
            RESTITUTION,
            Measure::PairMovement,
        )
    },
];

/// The paper's map: skew and excitation angle.
pub(super) const SKEW_ANGLE: Scan = scan(
    "skew-angle",
    "Largest rotation over skew and excitation angle, 0.40 g at 2.6 Hz",
    Axis::new(Parameter::Skew, [30.0, 90.0], 13),
    Axis::new(Parameter::Angle, [-90.0, 90.0], 13),
    Measure::Rotation,
);

const fn scan(name: &'static str, title: &'static str, x: Axis, y: Axis, measure: Measure) -> Scan {
    Scan { name, title, x, y, measure, variants: BOTH }
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
            let cells = self.y.steps().into_iter().flat_map(|y| self.x.steps().into_iter().map(move |x| [x, y]));
            cells.map(|cell| self.cell(&scenes, cell, variant)).collect::<Result<Vec<_>, SceneErrors>>()
        };
        Ok(ScanResult { maps: self.variants.iter().map(map).collect::<Result<_, _>>()? })
    }

    fn cell(&self, scenes: &[Scene], [x, y]: [f64; 2], variant: &Variant) -> Result<Option<f64>, SceneErrors> {
        let run = |scene: &Scene| {
            let mut scene = scene.clone();
            self.x.parameter.set(&mut scene, x);
            self.y.parameter.set(&mut scene, y);
            (scene.model.kind, scene.contact.sharing) = (variant.kind, variant.sharing);
            let history = History::of(&scene)?;
            Ok(history.stop().is_none().then(|| Observed::without_histories(&history)))
        };
        let seen: Option<Vec<Observed>> = scenes.iter().map(run).collect::<Result<_, SceneErrors>>()?;
        Ok(seen.and_then(|seen| self.measure.value(&seen)))
    }
}
