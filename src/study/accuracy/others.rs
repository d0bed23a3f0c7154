//! Cost of other programs for the same problems: figures measured elsewhere, kept as they were given.
//!
//! CPU seconds on one core of a like machine at the best setting found for each; the error is the largest displacement
//! error. "finite elements" is a general finite-element code with a gap element and Newmark steps, "robotics engine" a
//! time-stepping multibody engine, "game-physics engine" one for games, "LSODA" a general adaptive solver without events.

/// One figure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Other {
    /// The problem.
    pub(super) problem: &'static str,
    /// The kind of program.
    pub(super) program: &'static str,
    /// CPU seconds, where it got there.
    pub(super) seconds: Option<f64>,
    /// Displacement error, where it has a number \[m\].
    pub(super) error: Option<f64>,
    pub(super) note: &'static str,
}

const fn other(problem: &'static str, program: &'static str, seconds: f64, error: f64) -> Other {
    Other { problem, program, seconds: Some(seconds), error: Some(error), note: "" }
}

const fn never(problem: &'static str, program: &'static str, error: f64, note: &'static str) -> Other {
    Other { problem, program, seconds: None, error: Some(error), note }
}

/// All of them.
pub(super) const OTHERS: &[Other] = &[
    other("P1", "finite elements", 0.23, 1e-6),
    other("P1", "finite elements", 2.2, 1e-8),
    other("P1", "robotics engine", 0.21, 1e-6),
    never("P1", "robotics engine", 1.8e-7, "its best"),
    other("P1", "LSODA", 0.047, 1e-6),
    other("P1", "LSODA", 0.063, 1e-8),
    other("P1d", "finite elements", 23.0, 1e-6),
    other("P1d", "robotics engine", 10.0, 1e-6),
    other("P1d", "LSODA", 0.055, 1e-6),
    other("P3", "game-physics engine", 37.0, 6.5e-7),
    other("P2", "finite elements", 6.9, 1e-6),
    never("P2", "robotics engine", 5e-6, "its best"),
    other("P2", "LSODA", 0.082, 1e-6),
    other("P2", "LSODA", 0.14, 1e-8),
    never("P2k", "finite elements", 1.2e-6, "its best"),
    Other {
        problem: "P2k",
        program: "robotics engine",
        seconds: None,
        error: None,
        note: "wrong by 10 %: its stick is another law",
    },
];
