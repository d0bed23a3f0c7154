//! Runs of the scene: the runner, a finished run prepared for the window, and runs kept to compare with.

pub(in crate::app) mod answer;
pub(in crate::app) mod comparison;
mod job;
pub(in crate::app) mod runner;
pub(in crate::app) mod spot;
