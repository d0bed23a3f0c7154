//! The motion of bodies from pictures of marks on them (paper, section 2(2)).
//!
//! A camera looks straight down. A picture becomes grey ([`grey`]); what is brighter than a threshold and hangs together is a
//! mark, its place the centroid of its brightness ([`marks`]); marks are followed from picture to picture ([`track`]); those of
//! one body give its place and rotation relative to those on the table ([`pose`]). What is where in the first picture stands
//! in a layout ([`layout`]).

pub mod exposure;
pub mod grey;
pub mod layout;
pub mod marks;
pub mod pose;
pub mod track;

pub use exposure::exposed;
pub use grey::Grey;
pub use layout::{LAYOUT, Layout, MOST_MARKS, MarkPlace, TABLE};
pub use marks::{Finder, Mark};
pub use pose::{Calibration, Pose, Poses};
pub use track::{Lost, Tracker};
