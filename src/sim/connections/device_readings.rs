//! Readings of the devices of a scene.

use crate::dynamics::connection::{Activity, Phase};
use crate::dynamics::model::compiled_model::ModelDevice;
use crate::sim::connections::view::Connections;
use crate::sim::peaks::largest_of_each;
use crate::sim::report::Extreme;
use crate::sim::{LinkNow, looks};

/// Largest force, deformation and changes of a device over a run.
#[derive(Clone, Debug, PartialEq)]
pub struct DeviceReading {
    /// Its number in the model.
    pub device: usize,
    /// Largest |force| \[N\].
    pub force: Extreme,
    /// Largest force in parts of the strength, where it has one.
    pub part_of_strength: Option<f64>,
    /// Least and greatest displacement of its points against each other along its axis since placed: elongation, or approach, at one side of
    /// a stopper the first one's \[m\].
    pub deformation: [Extreme; 2],
    /// Number of times that its force began.
    pub times: usize,
    /// Time of the first of them \[s\].
    pub first: Option<f64>,
    /// Time at which it first yielded \[s\].
    pub yielded_at: Option<f64>,
    /// Time at which it broke \[s\].
    pub broke_at: Option<f64>,
}

impl Connections<'_> {
    /// Readings of every device of the scene; empty under the impact model, which has no devices.
    pub fn devices(self) -> Vec<DeviceReading> {
        let numbers = 0..self.history.model().devices.len();
        numbers.filter_map(|number| self.device_reading(number)).collect()
    }

    /// Reading of the device of this number in the model; `None` where there is none, and under the impact model.
    pub fn device_reading(self, number: usize) -> Option<DeviceReading> {
        let ModelDevice { links, .. } = self.history.model().devices.get(number)?;
        self.history.trajectories.link_log(links.start)?;
        let strength = links.clone().filter_map(|link| self.link(link, 0.0)?.strength).reduce(f64::min);
        let times = self.device_looks(links.clone());
        let [force, greatest, least] = largest_of_each(&times, &|t| {
            let sides: Vec<LinkNow> = links.clone().filter_map(|link| self.link(link, t)).collect();
            let force = sides.iter().map(|side| side.force.length()).fold(0.0, f64::max);
            let along = sides.first().map_or(0.0, |side| side.along.deformation[0]);
            [force, along, -along]
        });
        let phases = || links.clone().flat_map(|link| self.link_phases(link).iter().map(move |change| (link, change)));
        let device = |link: usize| &self.history.model().links[link].device;
        let begins: Vec<f64> = links
            .clone()
            .flat_map(|link| {
                let acts: Vec<bool> =
                    self.link_phases(link).iter().map(|(_, phase)| device(link).acts(phase)).collect();
                let sets_in = (0..acts.len()).filter(move |&i| acts[i] && (i == 0 || !acts[i - 1]));
                sets_in.map(move |i| self.link_phases(link)[i].0)
            })
            .collect();
        let earliest = |times: &mut dyn Iterator<Item = f64>| times.reduce(f64::min);
        let when = |holds: &dyn Fn(usize, &(f64, Phase)) -> bool| {
            earliest(&mut phases().filter(|(link, change)| holds(*link, change)).map(|(_, (t, _))| *t))
        };
        Some(DeviceReading {
            device: number,
            force,
            part_of_strength: strength.map(|strength| force.value / strength),
            deformation: [Extreme { value: -least.value, t: least.t }, greatest],
            times: begins.len(),
            first: earliest(&mut begins.into_iter()),
            yielded_at: when(&|link, (_, phase)| device(link).yields(phase)),
            broke_at: when(&|link, (_, phase)| device(link).activity(phase) == Activity::Ended),
        })
    }

    /// Times at which extremes of a device are looked for: those of the bodies at its ends, and the changes of its phase.
    fn device_looks(self, links: std::ops::Range<usize>) -> Vec<f64> {
        let mut bodies: Vec<usize> =
            self.history.model().links[links.clone()].iter().flat_map(|link| link.bodies).flatten().collect();
        bodies.sort_unstable();
        bodies.dedup();
        let mut times: Vec<f64> = bodies.into_iter().flat_map(|body| looks::of_body(self.history, body)).collect();
        times.extend(links.flat_map(|link| self.link_phases(link).iter().map(|(t, _)| *t)));
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }
}
