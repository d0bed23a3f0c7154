//! The headline numbers of a run.

use rayon::prelude::*;

use super::report::{GirderExtreme, LargestMotion};
use super::{History, looks, peaks};

/// The headline numbers of a run.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Summary {
    /// Largest displacement of any girder's G from where it was placed \[m\].
    pub max_displacement: f64,
    /// Largest |θ| of any girder \[rad\].
    pub max_rotation: f64,
    /// Largest |`R_k`| of any contact \[N\].
    pub peak_force: f64,
    /// Largest force between two bodies, of all their contacts together \[N\].
    pub peak_total: f64,
    /// Time of it \[s\].
    pub peak_total_time: Option<f64>,
    /// Largest impulse of a hit; nothing under the contact model \[N·s\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_impulse: Option<f64>,
    /// Time of it \[s\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_impulse_time: Option<f64>,
    /// Time at which the force of a contact is largest \[s\].
    pub peak_time: Option<f64>,
    /// Touches of single contacts.
    pub touches: usize,
    /// Hits: touches of a pair, from its first contact closing to its last opening.
    pub hits: usize,
    /// Contact time in stick, summed over contacts \[s\].
    pub stick_time: f64,
    /// Contact time in slip, summed over contacts \[s\].
    pub slip_time: f64,
}

impl History {
    /// Headline numbers.
    pub fn summary(&self) -> Summary {
        let hits = self.hits();
        let (touches, times) = (hits.touches(), hits.contact_times());
        let hardest = hits.hardest();
        let total = hits.hardest_pounding().map(|(_, most)| most);
        let motion = self.largest_motion();
        Summary {
            max_displacement: motion.map_or(0.0, |motion| motion.displacement.extreme.value),
            max_rotation: motion.map_or(0.0, |motion| motion.rotation.extreme.value),
            peak_force: hits.largest_force(),
            peak_total: total.map_or(0.0, |most| most.value),
            peak_total_time: total.map(|most| most.t),
            peak_impulse: hits.largest_impulse(),
            peak_impulse_time: hardest.filter(|touch| touch.impulse > 0.0).map(|touch| touch.start),
            peak_time: hits.strongest().map(|touch| touch.peak_time),
            touches: touches.len(),
            hits: hits.count(),
            stick_time: times.stick,
            slip_time: times.slip,
        }
    }

    /// Largest motions of all girders over the run; `None` of a scene without girders.
    pub fn largest_motion(&self) -> Option<LargestMotion> {
        *self.found.largest_motion.get_or_init(|| {
            let of_girder = |girder: usize| {
                let values = |t| {
                    let motion = self.motion(girder, t);
                    [motion.displacement.length(), motion.theta.abs()]
                };
                let [displacement, rotation] = peaks::largest_of_each(&looks::of_body(self, girder), &values)
                    .map(|extreme| GirderExtreme { girder, extreme });
                LargestMotion { displacement, rotation }
            };
            let all: Vec<LargestMotion> = (0..self.model().girders().len()).into_par_iter().map(of_girder).collect();
            all.into_iter().reduce(LargestMotion::larger)
        })
    }
}
