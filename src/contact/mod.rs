//! Contact laws at one point of contact, independent of bodies (`docs/physics.md#contact-kinematics`; paper section 4).
//!
//! [`node_face`] measures a node against a face; a [`Law`] (a [`Normal`] law and a [`Friction`] law) gives forces and
//! switching functions of the state {open, stick, slip}; [`parameters`] derives a law's numbers from a scene's. All
//! vectors are in the face's axes: first tangent, second tangent, outward normal.

pub mod calibration;
mod constants;
pub mod crossed_edges;
pub mod friction;
pub mod law;
pub mod node_face;
pub mod normal;
pub mod parameters;
mod scales;

pub use calibration::{Calibration, NormalName, damping_ratio};
pub use crossed_edges::Crossed;
pub use law::{Breakaway, Forces, Friction, FrictionLaw, FrictionRule, Law, Mode, SlidingDerivative, SlipDirection};
pub use node_face::{ContactGeometry, Frame, Local, Measured, gap, locate, measure, turned_by};
pub use normal::{Normal, NormalLaw};
pub use parameters::{Dashpots, PairNumbers, is_damped_by_65, law_of_pair, returned_restitution};
