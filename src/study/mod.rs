//! Many runs, for the accuracy and cost of an answer: work against error, cost against size, random scenes, one scene at many values of its
//! keys, every normal law on one scene, the paper's experiment.
//!
//! A study measures the program, so it may read clocks; it opens no file and prints nothing. Its tables and pages come
//! back as text, its plots as [`Plot`](crate::plot::Plot)s that draw themselves as SVG and, with feature `study`, as PNG.

pub mod accuracy;
pub mod calibration;
pub mod camera;
pub mod clock;
pub mod experiment;
pub mod ground;
pub mod identified;
pub mod laws;
pub mod measured;
pub mod page;
pub mod size;
pub mod stability;
pub mod sweep;
pub mod waves;

/// Circumstances of a page: date, machine, command.
#[derive(Clone, Debug, Default)]
pub struct Occasion {
    /// The day.
    pub date: String,
    /// The machine.
    pub machine: String,
    /// The command.
    pub command: String,
}
