//! A scene compiled to constant data: bodies, bearings, facing pairs, contact sites and groups.

pub mod assembly;
pub mod bearing;
pub(in crate::dynamics) mod contact_sites;
pub(in crate::dynamics) mod rate_bounds;
pub(crate) mod reference_pose;
pub mod rigid_body;
