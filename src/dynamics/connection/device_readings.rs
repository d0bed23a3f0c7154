//! Readings of a device: its state as a text, its force, strength and travel, and its line in a drawing. They do not enter the computation.

use glam::DVec3;

use crate::dynamics::connection::{Connection, Phase, Separation};
use crate::language::Text;

/// The word for a phase of a device that has no other words.
pub fn acts_or_open(acts: bool) -> Text {
    Text::new(if acts { "state-acts" } else { "state-open" })
}

/// Readings of a device.
pub trait DeviceReadings: Connection<State = Phase, Motion = Separation> {
    /// The phase in a word.
    fn state(&self, phase: &Phase) -> Text;

    /// Distance to the beginning of the force as a length to read; of a bearing its remaining travel, NaN without a limit \[m\].
    fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64;

    /// Force of the whole bearing that the device is a part of, on its first point \[N\]; of a device by itself its own force.
    fn reaction(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        self.force(phase, motion)
    }

    /// Force at which it first yields, or breaks where it does not yield \[N\]; none where it does neither.
    fn strength(&self) -> Option<f64> {
        None
    }

    /// Whether it lets go of the first point where it would hold it down.
    fn lifts(&self) -> bool {
        false
    }

    /// Whether it yields in this phase.
    fn yields(&self, _phase: &Phase) -> bool {
        false
    }

    /// Centre line for a drawing between its points, world axes \[m\]: a straight line unless the device hangs or bends.
    fn centre_line(&self, _phase: &Phase, ends: [DVec3; 2]) -> Vec<DVec3> {
        ends.to_vec()
    }
}
