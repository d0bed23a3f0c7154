//! The problems: a fixed set with short names.

use super::scenes;
use crate::scene::{Scene, SceneErrors, presets};

/// Source of the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// A damped oscillator in closed form.
    FreeDecay,
    /// The damped oscillator under a sine, from rest.
    HarmonicResponse,
    /// One degree of freedom, piecewise linear: Taylor series in double-double arithmetic, events as roots.
    Bouncer {
        /// `e_n` of the dashpot; 1 is none.
        restitution: f64,
    },
    /// One degree of freedom with a rigid wall.
    Rigid {
        /// `e_n`.
        restitution: f64,
    },
    /// A damped oscillator in stick, a parabola plus a sine in slip, switched at roots.
    Block,
    /// Two equal elastic bars head on: the force in closed form (F11).
    StVenant,
    /// An elastic bar on springs before a wall: spectral elements, the exponential of their matrix.
    Bar,
    /// The second formulation: its own kinematics, forces, laws, integrator and event search.
    Second,
}

/// A problem of the set.
#[derive(Clone, Copy, Debug)]
pub struct Problem {
    /// Name in the command line.
    pub name: &'static str,
    /// One line on what it is.
    pub summary: &'static str,
    /// Source of its reference.
    pub source: Source,
    /// Whether anything touches in it.
    pub contact: bool,
    scene: fn() -> Result<Scene, SceneErrors>,
}

impl Problem {
    /// Its scene.
    ///
    /// # Errors
    ///
    /// Those of the format for a preset that it is made from.
    pub fn scene(&self) -> Result<Scene, SceneErrors> {
        (self.scene)()
    }
}

const fn problem(
    name: &'static str,
    summary: &'static str,
    source: Source,
    scene: fn() -> Result<Scene, SceneErrors>,
) -> Problem {
    let contact = !matches!(source, Source::FreeDecay | Source::HarmonicResponse);
    Problem { name, summary, source, contact, scene }
}

static PROBLEMS: [Problem; 17] = [
    problem("free-decay", "straight girder let go, nothing to touch, 4 s", Source::FreeDecay, scenes::free_decay),
    problem(
        "harmonic-response",
        "straight girder from rest under a 2 Hz sine at 30°, nothing to touch, 10 s",
        Source::HarmonicResponse,
        scenes::harmonic_response,
    ),
    problem(
        "P1",
        "straight girder head-on, gap 5 mm, 0.4 g at 2.4 Hz, elastic contact, 10 s",
        Source::Bouncer { restitution: 1.0 },
        || scenes::head_on(false),
    ),
    problem("P1d", "the same with the dashpot (e_n = 0.4)", Source::Bouncer { restitution: 0.4 }, || {
        scenes::head_on(true)
    }),
    problem(
        "P3",
        "P1 with an instantaneous restitution of 0.4 (impact model)",
        Source::Rigid { restitution: 0.4 },
        scenes::rigid,
    ),
    problem(
        "P2",
        "straight girder at 45°, return mapping, μ = 0.15, no dashpot: it slips only, 5 s",
        Source::Second,
        || scenes::oblique("P2", 45.0),
    ),
    problem("P2k", "the same shaken at 5°: it sticks at every touch, 5 s", Source::Second, || {
        scenes::oblique("P2k", 5.0)
    }),
    problem("P2h", "P2 with Hertz's spring in place of the linear one, 5 s", Source::Second, scenes::hertz),
    problem("skew45", "45° girder, law of the paper, 2.6 Hz, 0.40 g, 10 s", Source::Second, || {
        presets::load("skew45-abutment")
    }),
    problem("pair", "girder on girder at 22.5°, law of the paper, 10 s", Source::Second, || {
        presets::load("straight-straight")
    }),
    problem(
        "block",
        "a block pressed on a wall and shaken along it: it sticks and slips, 4 s",
        Source::Block,
        scenes::block,
    ),
    problem(
        "record",
        "45° girder under 40 s of a synthetic record of 4000 samples, 0.4 g",
        Source::Second,
        scenes::under_a_record,
    ),
    problem(
        "row-of-5",
        "five 30 m girders of different period, facing ends, return mapping, 10 s",
        Source::Second,
        || scenes::facing_ends("row-of-5"),
    ),
    problem(
        "viaduct",
        "five 30 m spans of 60° skew on four piers, facing ends, synthetic earthquake of 0.45 g, 10 s",
        Source::Second,
        scenes::viaduct,
    ),
    problem(
        "deck-3d",
        "30 m deck of 60° skew between two abutments, facing ends, six degrees of freedom, 20 s",
        Source::Second,
        || scenes::facing_ends("deck-30m"),
    ),
    problem(
        "F1",
        "two elastic bars of 30 m head on, κ = 1, degree 24, no damping, 50 ms",
        Source::StVenant,
        scenes::two_bars,
    ),
    problem(
        "F2",
        "30 m concrete deck on bearings against an abutment, κ = 0.25, degree 16, 0.4 g at 0.8 Hz, 10 s",
        Source::Bar,
        scenes::deck_that_rings,
    ),
];

/// Every problem.
pub fn all() -> &'static [Problem] {
    &PROBLEMS
}

/// The problem of this name.
pub fn get(name: &str) -> Option<&'static Problem> {
    PROBLEMS.iter().find(|problem| problem.name == name)
}
