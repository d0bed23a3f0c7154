//! Readings of elastic girders in `summary.json`.

use serde::Serialize;

use crate::dynamics::model::elastic_body::ElasticBody;
use crate::language::Text;
use crate::sim::{ElasticHit, FlexibleReading, History, NEGLIGIBLE, Neglected};

/// An elastic girder in short, SI.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FlexibleReport {
    /// Its name.
    pub girder: String,
    /// `κ = K a0/(E A)` of its stiffest contact.
    pub kappa: f64,
    /// `κ_e`: by what part the girder softens that contact.
    pub kappa_e: f64,
    /// Below which `κ_e` the girder is taken as rigid where the degree is not given.
    pub tol_flex: f64,
    /// Degree n of its polynomials; 0 where it was taken as rigid.
    pub degree: usize,
    /// Number of modes.
    pub modes: usize,
    /// Frequencies of the first of them \[Hz\].
    pub frequencies: Vec<f64>,
    /// Time of an axial wave from end to end \[s\].
    pub transit_time: f64,
    /// Readings of the run; `None` where the girder was computed as rigid.
    #[serde(flatten)]
    pub run: Option<FlexibleRun>,
}

/// Readings of an elastic girder.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FlexibleRun {
    /// Its hardest hit.
    pub hit: Option<ElasticHit>,
    /// Largest |N| at mid-span \[N\], and when \[s\].
    pub axial: [f64; 2],
    /// Largest |M| at mid-span \[N·m\], and when \[s\].
    pub moment: [f64; 2],
    /// Largest |`M_y`| at mid-span \[N·m\], and when \[s\]; of a girder in space.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertical_moment: Option<[f64; 2]>,
    /// Largest |T| at mid-span \[N·m\], and when \[s\]; of a girder in space.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque: Option<[f64; 2]>,
    /// Largest stress of the extreme fibre \[Pa\], when \[s\], and at which station \[m\].
    pub stress: [f64; 3],
    /// Its strength, where the scene gives one \[Pa\].
    pub strength: Option<f64>,
    /// Whether the stress passes it: the girder is no longer elastic.
    pub strength_passed: bool,
    /// Part by which N at mid-span differs at its peak from that by strain.
    pub local_error: f64,
    /// Relative bounds of what the model leaves out.
    pub neglected: Neglected,
    /// Those above 1e-2.
    pub not_negligible: Vec<Text>,
}

/// Of all girders that the scene calls elastic.
pub(super) fn of(history: &History) -> Vec<FlexibleReport> {
    let model = history.model();
    let readings = history.sections().readings();
    let one = |(number, flexible): (usize, &Option<crate::dynamics::model::flexible::Flexible>)| {
        let flexible = flexible.as_ref()?;
        let reading = readings.iter().find(|reading| reading.girder == number);
        let made = flexible.girder.as_ref();
        let hertz = |omega: &f64| omega / std::f64::consts::TAU;
        Some(FlexibleReport {
            girder: model.bodies[number].name.clone(),
            kappa: flexible.softness.kappa,
            kappa_e: flexible.softness.end,
            tol_flex: flexible.tolerance,
            degree: made.map_or(0, ElasticBody::degree),
            modes: made.map_or(0, ElasticBody::count),
            frequencies: reading.map_or(Vec::new(), |reading| reading.frequencies.iter().map(hertz).collect()),
            transit_time: flexible.beam.transit_time(),
            run: reading.map(|reading| run(history, reading)),
        })
    };
    model.flexible.iter().enumerate().filter_map(one).collect()
}

fn run(history: &History, reading: &FlexibleReading) -> FlexibleRun {
    let strength = history.scene().girders[reading.girder].elastic.and_then(|elastic| elastic.strength);
    let above = reading.neglected.named().into_iter().filter(|(_, bound)| *bound > NEGLIGIBLE);
    FlexibleRun {
        hit: reading.hit,
        axial: [reading.axial.value, reading.axial.t],
        moment: [reading.moment.value, reading.moment.t],
        vertical_moment: reading.in_space.map(|[moment, _]| [moment.value, moment.t]),
        torque: reading.in_space.map(|[_, torque]| [torque.value, torque.t]),
        stress: [reading.stress.value, reading.stress.t, reading.stressed_at],
        strength,
        strength_passed: strength.is_some_and(|strength| reading.stress.value > strength),
        local_error: reading.local_error,
        neglected: reading.neglected,
        not_negligible: above.map(|(name, _)| name).collect(),
    }
}
