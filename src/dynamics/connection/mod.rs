//! Connections: forces between two points, of two bodies or of a body and the ground.
//!
//! A closed contact, a bearing and a device (cable, bumper, damper, shear key) are connections. What the solver asks of any of
//! them is the trait [`Connection`]: the force on the first point (the opposite acts on the second), the stored energy, the
//! dissipated power, and upper bounds of stiffness and damping for its time scales. What it asks of a device, whose force may
//! set in and end, is the trait [`Device`]: phases, switching functions, and the gap until the force sets in; what is read of a device is
//! the trait [`DeviceReadings`]. A [`Link`] puts a device between two points of a model.

pub mod device;
pub mod device_readings;
pub mod link;
pub mod phase;
pub mod separation;

use glam::DVec3;

pub use device::{Activity, Device, Evolution, Linearity, Switch, SwitchUnit};
pub use device_readings::{DeviceReadings, acts_or_open};
pub use link::{Anchor, Link};
pub use phase::{IS_BROKEN, Phase};
pub use separation::{Excursion, Kinematics, Separation, SeparationBounds};

/// A force between two points.
pub trait Connection {
    /// State that the force depends on beside the motion of its points.
    type State;
    /// Motion of the first point against the second.
    type Motion;

    /// Force on the first point, in the axes of its motion \[N\].
    fn force(&self, state: &Self::State, motion: &Self::Motion) -> DVec3;

    /// Stored energy \[J\].
    fn stored_energy(&self, state: &Self::State, motion: &Self::Motion) -> f64;

    /// Power that the connection dissipates \[W\].
    fn dissipated_power(&self, state: &Self::State, motion: &Self::Motion) -> f64;

    /// Upper bound of the stiffness in any direction \[N/m\].
    fn stiffness_bound(&self, state: &Self::State) -> f64;

    /// Upper bound of the damping coefficient in any direction \[N·s/m\].
    fn damping_bound(&self, state: &Self::State) -> f64;
}
