//! A section force of an elastic girder over stations and time: where waves are seen to run and turn.

use crate::dynamics::model::coordinates::section_forces::SectionForces;
use crate::sim::sections::quantity::OfSection;
use crate::sim::sections::view::Sections;

/// Values over stations and times, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionField {
    /// Times \[s\].
    pub times: Vec<f64>,
    /// Stations from −a0/2 to a0/2 \[m\].
    pub stations: Vec<f64>,
    /// Values of the first station at every time, then those of the next.
    pub values: Vec<f64>,
}

impl SectionField {
    /// Greatest absolute value.
    pub fn largest(&self) -> f64 {
        self.values.iter().fold(0.0, |most, value| most.max(value.abs()))
    }
}

impl Sections<'_> {
    /// One of the section forces of an elastic girder, SI.
    pub fn component(self, girder: usize, forces: &SectionForces, what: OfSection) -> f64 {
        match what {
            OfSection::Axial => forces.axial,
            OfSection::Shear => forces.shear,
            OfSection::Moment => forces.moment,
            OfSection::Stress => self.fibre_stress(girder, forces),
            OfSection::VerticalShear => forces.vertical_shear,
            OfSection::VerticalMoment => forces.vertical_moment,
            OfSection::Torque => forces.torque,
        }
    }

    /// A section force of an elastic girder at `counts` even times from `from` to `until` and even stations from end to end; `None`
    /// of a girder that does not bend.
    pub fn field(
        self,
        girder: usize,
        what: OfSection,
        [from, until]: [f64; 2],
        [times, stations]: [usize; 2],
    ) -> Option<SectionField> {
        let half = 0.5 * self.flexible(girder)?.beam.length;
        let times = even([from, until], times);
        let stations = even([-half, half], stations);
        let mut values = vec![0.0; times.len() * stations.len()];
        for (column, &t) in times.iter().enumerate() {
            let equilibrium = self.equilibrium(girder, t)?;
            for (row, &station) in stations.iter().enumerate() {
                values[row * times.len() + column] = self.component(girder, &equilibrium.at(station), what);
            }
        }
        Some(SectionField { times, stations, values })
    }
}

/// So many numbers, evenly from one to the other.
fn even([from, until]: [f64; 2], count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| from + (until - from) * i as f64 / last).collect()
}
