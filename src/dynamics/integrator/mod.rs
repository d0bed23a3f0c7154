//! Integrators of ordinary differential equations: explicit and implicit methods, dense output, step-size control. No
//! physics.

pub(in crate::dynamics) mod constants;
pub(in crate::dynamics) mod dense_lu;
pub mod dense_output;
pub mod dop853;
pub(in crate::dynamics) mod dop853_tableau;
pub(in crate::dynamics) mod low_rank_correction;
pub(in crate::dynamics) mod newton_matrix;
pub(in crate::dynamics) mod radau_iia;
pub(in crate::dynamics) mod radau_tableau;
pub(in crate::dynamics) mod step_control;
pub mod system;
