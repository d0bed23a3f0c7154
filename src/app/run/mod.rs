//! Runs of the scene: the runner, and a finished run prepared for the window.

pub(in crate::app) mod answer;
pub(in crate::app) mod runner;
