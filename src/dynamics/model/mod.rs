//! A scene compiled to constant data: bodies, bearings, facing pairs, contact sites and groups.

pub mod assembly;
mod backwall;
pub mod bearing;
pub mod body;
pub mod closed_form;
pub mod compiled_model;
pub(in crate::dynamics) mod contact_sites;
pub mod coordinates;
pub mod edge_node;
mod edge_sites;
pub mod face_choice;
pub mod flexible;
pub mod groups;
pub mod meeting;
mod met_solids;
pub mod motion_bounds;
pub mod pair;
mod pier;
pub(in crate::dynamics) mod rate_bounds;
pub mod reference_pose;
pub mod rigid_body;
pub(in crate::dynamics) mod rotation;
pub(in crate::dynamics) mod single_axis;
mod supports;
pub mod wrench;
