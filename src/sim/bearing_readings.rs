//! What a run did to the bearings of a girder.

use rayon::prelude::*;

use super::report::Extreme;
use super::{History, Loop, touches};

/// The bearing of a girder that goes farthest, and the one that resists most, both in plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingsReading {
    /// Number of the girder.
    pub girder: usize,
    /// Number of the bearing that deforms most among the girder's, and its largest deformation \[m\].
    pub deformation: (usize, Extreme),
    /// The same of the largest resistance: spring, dashpot and what yields or slides \[N\].
    pub force: (usize, Extreme),
}

/// Size in plan.
fn size(axes: [f64; 2]) -> f64 {
    axes[0].hypot(axes[1])
}

impl History {
    /// What the run did to the bearings of every girder that has some, by the girder's number.
    pub fn bearing_readings(&self) -> Vec<BearingsReading> {
        (0..self.model().girders().len()).into_par_iter().filter_map(|girder| self.bearings_reading(girder)).collect()
    }

    /// What the run did to the bearings of this girder; `None` where it has none. A bearing without its support is none from then on.
    pub fn bearings_reading(&self, girder: usize) -> Option<BearingsReading> {
        let count = self.model().girders().get(girder)?.bearings.len();
        if count == 0 {
            return None;
        }
        let until: Vec<f64> = (0..count).map(|number| self.bearing_lost_at(girder, number)).collect();
        let at = |number: usize, t: f64| if t > until[number] { None } else { self.bearing_loop(girder, number, t) };
        let times = touches::looks(self, girder);
        let seen: Vec<Vec<Option<Loop>>> =
            times.iter().map(|&t| (0..count).map(|number| at(number, t)).collect()).collect();
        let largest = |of: fn(&Loop) -> f64| {
            let of_bearing = |number: usize| {
                let values: Vec<f64> = seen.iter().map(|all| all[number].as_ref().map_or(0.0, of)).collect();
                let (t, value) = touches::largest_seen(&times, &values, |t| at(number, t).as_ref().map_or(0.0, of));
                (number, Extreme { value, t })
            };
            // Of equals the first.
            (0..count).map(of_bearing).reduce(|a, b| if b.1.value > a.1.value { b } else { a })
        };
        Some(BearingsReading {
            girder,
            deformation: largest(|now| size(now.deformation))?,
            force: largest(|now| size(now.resistance))?,
        })
    }
}
