//! Measures that a sweep keeps of each run: numbers with names and units.

use crate::language::{Text, message};
use crate::scene::shown::shown;
use crate::scene::{SceneError, SceneErrors, format};
use crate::sim::{ErrorEstimate, History, readings, seats};

/// A number of a run.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    /// Its name: that of its column.
    pub name: &'static str,
    /// Its name in the language of the user.
    pub label: Text,
    /// Unit of its values.
    pub unit: &'static str,
    /// Meaning.
    pub meaning: &'static str,
    /// Unit on a picture, and how many of it are one of [`unit`](Self::unit).
    pub drawn: (&'static str, f64),
    /// Its value; none where the run has no such thing.
    of: fn(&History) -> Option<f64>,
}

const MILLIMETRES: (&str, f64) = ("mm", 1e3);
const DEGREES: (&str, f64) = ("°", 180.0 / std::f64::consts::PI);
const NEWTONS: (&str, f64) = ("N", 1.0);
const NEWTON_SECONDS: (&str, f64) = ("N s", 1.0);
const MEGAPASCALS: (&str, f64) = ("MPa", 1e-6);
const SECONDS: (&str, f64) = ("s", 1.0);
const NUMBER: (&str, f64) = ("", 1.0);

/// Every measure.
pub const MEASURES: &[Measure] = &[
    Measure {
        name: "max_rotation",
        label: Text::new("measured-max-rotation"),
        unit: "rad",
        meaning: "largest |θ| of any girder",
        drawn: DEGREES,
        of: |run| run.largest_motion().map(|motion| motion.rotation.extreme.value),
    },
    Measure {
        name: "max_displacement",
        label: Text::new("measured-max-displacement"),
        unit: "m",
        meaning: "largest displacement of any girder's G",
        drawn: MILLIMETRES,
        of: |run| run.largest_motion().map(|motion| motion.displacement.extreme.value),
    },
    Measure {
        name: "max_drift",
        label: Text::new("measured-max-drift"),
        unit: "m",
        meaning: "largest displacement in plan of any girder's corner",
        drawn: MILLIMETRES,
        of: |run| girders(run).flat_map(|reading| reading.drift).map(|drift| drift.value).reduce(f64::max),
    },
    Measure {
        name: "max_force",
        label: Text::new("measured-max-force"),
        unit: "N",
        meaning: "largest |R_k| of any contact",
        drawn: NEWTONS,
        of: |run| Some(run.hits().largest_force()),
    },
    Measure {
        name: "max_total_force",
        label: Text::new("measured-max-total-force"),
        unit: "N",
        meaning: "largest force between two bodies, all contacts between them together",
        drawn: NEWTONS,
        of: |run| Some(run.hits().largest_resultants().into_iter().map(|(_, most)| most.value).fold(0.0, f64::max)),
    },
    Measure {
        name: "max_impulse",
        label: Text::new("measured-max-impulse"),
        unit: "N s",
        meaning: "largest impulse of a hit; of the impact model",
        drawn: NEWTON_SECONDS,
        of: |run| run.hits().largest_impulse(),
    },
    Measure {
        name: "hits",
        label: Text::new("measured-hits"),
        unit: "1",
        meaning: "hits: touches of a pair, from its first contact closing to its last opening",
        drawn: NUMBER,
        of: |run| Some(run.hits().count() as f64),
    },
    Measure {
        name: "first_hit",
        label: Text::new("measured-first-hit"),
        unit: "s",
        meaning: "time of the first touch; none without one",
        drawn: SECONDS,
        of: |run| run.hits().touches().first().map(|touch| touch.start),
    },
    Measure {
        name: "stick_time",
        label: Text::new("measured-stick-time"),
        unit: "s",
        meaning: "contact time in stick, summed over contacts",
        drawn: SECONDS,
        of: |run| Some(run.hits().contact_times().stick),
    },
    Measure {
        name: "slip_time",
        label: Text::new("measured-slip-time"),
        unit: "s",
        meaning: "contact time in slip, summed over contacts",
        drawn: SECONDS,
        of: |run| Some(run.hits().contact_times().slip),
    },
    Measure {
        name: "least_gap",
        label: Text::new("measured-least-gap"),
        unit: "m",
        meaning: "least gap of any facing pair, square to its face, negative in contact; none without pairs",
        drawn: MILLIMETRES,
        of: |run| girders(run).filter_map(|reading| reading.gap).map(|gap| gap.value).reduce(f64::min),
    },
    Measure {
        name: "least_seat",
        label: Text::new("measured-least-seat"),
        unit: "m",
        meaning: "least that remains of any seat, square to its edge, negative off it; none without seats",
        drawn: MILLIMETRES,
        of: |run| seats(run).map(|seat| seat.least().value).reduce(f64::min),
    },
    Measure {
        name: "unseated",
        label: Text::new("measured-unseated"),
        unit: "s",
        meaning: "time when a corner first came off its seat; none where all stay",
        drawn: SECONDS,
        of: |run| seats(run).filter_map(|seat| seat.off_at()).reduce(f64::min),
    },
    Measure {
        name: "max_bearing_displacement",
        label: Text::new("measured-max-bearing-displacement"),
        unit: "m",
        meaning: "largest deformation in plan of any bearing; none without bearings",
        drawn: MILLIMETRES,
        of: |run| run.connections().bearing_readings().iter().map(|of| of.deformation.1.value).reduce(f64::max),
    },
    Measure {
        name: "max_bearing_force",
        label: Text::new("measured-max-bearing-force"),
        unit: "N",
        meaning: "largest resistance in plan of any bearing; none without bearings",
        drawn: NEWTONS,
        of: |run| run.connections().bearing_readings().iter().map(|of| of.force.1.value).reduce(f64::max),
    },
    Measure {
        name: "max_pier_drift",
        label: Text::new("measured-max-pier-drift"),
        unit: "m",
        meaning: "largest displacement of any pier's cap against its foot; none without piers",
        drawn: MILLIMETRES,
        of: |run| run.connections().piers().iter().map(|pier| pier.drift.value).reduce(f64::max),
    },
    Measure {
        name: "max_pier_shear",
        label: Text::new("measured-max-pier-shear"),
        unit: "N",
        meaning: "largest base shear of any pier; none without piers",
        drawn: NEWTONS,
        of: |run| run.connections().piers().iter().map(|pier| pier.shear.value).reduce(f64::max),
    },
    Measure {
        name: "max_device_force",
        label: Text::new("measured-max-device-force"),
        unit: "N",
        meaning: "largest force of any device; none without devices",
        drawn: NEWTONS,
        of: |run| run.connections().devices().iter().map(|device| device.force.value).reduce(f64::max),
    },
    Measure {
        name: "max_stress",
        label: Text::new("measured-max-stress"),
        unit: "Pa",
        meaning: "largest stress of the extreme fibre of any girder that bends, beyond the dead load's; none without one",
        drawn: MEGAPASCALS,
        of: |run| run.sections().readings().iter().map(|girder| girder.stress.value).reduce(f64::max),
    },
    Measure {
        name: "max_overlap",
        label: Text::new("measured-max-overlap"),
        unit: "m",
        meaning: "largest overlap of bodies that no contact carries",
        drawn: MILLIMETRES,
        of: |run| Some(run.overlaps().iter().map(|overlap| overlap.depth.value).fold(0.0, f64::max)),
    },
    Measure {
        name: "estimated_error",
        label: Text::new("measured-estimated-error"),
        unit: "m",
        meaning: "largest difference in displacement from a run at a hundredth of the tolerance, which is computed for it",
        drawn: MILLIMETRES,
        of: |run| ErrorEstimate::of(run).of_whole().map(|estimate| estimate.error),
    },
    Measure {
        name: "energy_residual",
        label: Text::new("measured-energy-residual"),
        unit: "1",
        meaning: "|residual| of the energy ledger in parts of the largest energy in play",
        drawn: NUMBER,
        of: |run| Some(run.energy().balance().residual),
    },
];

/// The numbers of every girder.
fn girders(run: &History) -> impl Iterator<Item = readings::Reading> {
    (0..run.model().girders().len()).map(|girder| readings::reading(run, girder))
}

/// Every seat of every girder.
fn seats(run: &History) -> impl Iterator<Item = seats::Seat> {
    (0..run.model().girders().len()).flat_map(|girder| run.seats().of_girder(girder))
}

impl Measure {
    /// The measure of this name.
    ///
    /// # Errors
    /// There is none.
    pub fn named(name: &str) -> Result<&'static Self, SceneErrors> {
        MEASURES.iter().find(|measure| measure.name == name).ok_or_else(|| unknown(name).into())
    }

    /// Its value of a run, in [`unit`](Self::unit); none where the run has no such thing, or no number for it.
    pub fn of(&self, run: &History) -> Option<f64> {
        (self.of)(run).filter(|value| value.is_finite()).map(|value| value + 0.0)
    }

    /// Its name on a picture, with its unit.
    pub fn title(&self) -> String {
        let name = self.label.as_str();
        if self.drawn.0.is_empty() { name.to_owned() } else { format!("{name} [{}]", self.drawn.0) }
    }
}

fn unknown(name: &str) -> SceneError {
    let names: Vec<&str> = MEASURES.iter().map(|measure| measure.name).collect();
    SceneError {
        file: "sweep".to_owned(),
        place: "--measure".into(),
        value: format!("\"{}\"", shown(name, 80)).into(),
        remedy: message!(
            "wrong-measure",
            "meant" => format::did_you_mean(name, &names),
            "names" => names.join(", ")
        ),
    }
}
