//! Contact laws at one point, knowing no bodies (`docs/physics.md#contact-kinematics`; paper section 4).
//!
//! [`node_face`] measures where a node is relative to a face; a [`Law`] turns that into forces and says when the state
//! {open, stick, slip} changes. Everything is in the face's own axes: first tangent, second tangent, outward normal.

pub mod law;
pub mod node_face;
mod paper;
pub mod parameters;
mod return_mapping;

pub use law::{Breakaway, Forces, Law, Mode};
pub use node_face::{Frame, Home, Local, Measured, gap, locate, measure, turned_by};
pub use parameters::{Dashpots, damping_ratio, dashpots};
