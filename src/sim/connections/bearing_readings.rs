//! Readings of the bearings of a girder.

use rayon::prelude::*;

use crate::sim::connections::view::Connections;
use crate::sim::report::Extreme;
use crate::sim::{Loop, looks, peaks};

/// The bearing of a girder that goes farthest, and the one that resists most, both in plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingsReading {
    /// Number of the girder.
    pub girder: usize,
    /// Number of the bearing that deforms most among the girder's, and its largest deformation \[m\].
    pub deformation: (usize, Extreme),
    /// Number of the bearing with the largest resistance, and that: of spring, dashpot and the parts that yield or slide \[N\].
    pub force: (usize, Extreme),
}

/// Deformation \[m\] and resistance \[N\] in plan.
fn sizes_of(now: Loop) -> [f64; 2] {
    [now.deformation, now.resistance].map(|axes| axes[0].hypot(axes[1]))
}

impl Connections<'_> {
    /// Readings of the bearings of every girder that has some, in the order of the girders.
    pub fn bearing_readings(self) -> Vec<BearingsReading> {
        (0..self.history.model().girders().len())
            .into_par_iter()
            .filter_map(|girder| self.bearings_reading(girder))
            .collect()
    }

    /// Largest deformation and resistance of the bearings of a girder over the run; `None` where it has none. A bearing without its support is none from then on.
    pub fn bearings_reading(self, girder: usize) -> Option<BearingsReading> {
        let count = self.history.model().girders().get(girder)?.bearings.len();
        if count == 0 {
            return None;
        }
        let until: Vec<f64> = (0..count).map(|number| self.history.seats().bearing_lost_at(girder, number)).collect();
        let times = looks::of_body(self.history, girder);
        let mut seen = vec![[0.0; 2]; times.len() * count];
        for (all, &t) in seen.chunks_exact_mut(count).zip(&times) {
            // Of all bearings together the girder's pose is computed once.
            let own = self.history.frame(girder, t);
            let frame = |body: usize, section: usize| {
                if (body, section) == (girder, 0) {
                    own
                } else {
                    self.history.trajectories.section_frame(body, section, t)
                }
            };
            for (number, sizes) in all.iter_mut().enumerate().filter(|(number, _)| t <= until[*number]) {
                *sizes = self.bearing_loop_in((girder, number), t, &frame).map_or([0.0; 2], sizes_of);
            }
        }
        let largest = |of: usize| {
            let at = |number: usize, t: f64| {
                let now = if t > until[number] { None } else { self.bearing_loop(girder, number, t) };
                now.map_or(0.0, |now| sizes_of(now)[of])
            };
            let of_bearing = |number: usize| {
                let values: Vec<f64> = seen.iter().skip(number).step_by(count).map(|sizes| sizes[of]).collect();
                (number, peaks::largest_seen(&times, &values, &|t| at(number, t)))
            };
            // Of equals the first.
            (0..count).map(of_bearing).reduce(|a, b| if peaks::exceeds(b.1.value, a.1.value) { b } else { a })
        };
        Some(BearingsReading { girder, deformation: largest(0)?, force: largest(1)? })
    }
}
