//! The methods that are compared: one file each, one interface.
//!
//! The event-driven solver is the product's own. The others are what a user of other tools would do with the same
//! equations: the same bearings, the same contact laws, a gap tested wherever forces are evaluated, and the states
//! {open, stick, slip} brought up to date at the end of every step.

mod contacts;
mod dormand_prince;
mod event_driven;
mod march;
mod newmark;
mod runge_kutta4;
mod semi_implicit_euler;
mod solve;
mod world;

use super::{Answer, Instants};
use crate::scene::{ModelKind, Scene};
use crate::sim::History;

/// What a method is turned by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    /// Steps to one interval of comparison, so that every instant ends a step.
    StepsPerInterval,
    /// A tolerance.
    Tolerance,
}

/// What a method was given to do.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// When it is asked.
    pub instants: Instants,
    /// The knob: steps to an interval, or a tolerance.
    pub setting: f64,
}

/// What a method leaves behind.
#[derive(Debug)]
pub enum Work {
    /// A history that can be asked for any time.
    History(Box<History>),
    /// Samples taken on the way.
    Sampled(Answer),
}

impl Work {
    /// The answer at the instants.
    pub fn answer(self, instants: Instants) -> Answer {
        match self {
            Self::History(history) => Answer::of(&history, instants),
            Self::Sampled(answer) => answer,
        }
    }
}

/// A way to answer a scene.
pub trait Method: Sync {
    /// What the command line and the tables call it.
    fn name(&self) -> &'static str;

    /// What it is turned by.
    fn knob(&self) -> Knob;

    /// Whether it computes a scene by this model.
    fn knows(&self, model: ModelKind) -> bool {
        model == ModelKind::Contact
    }

    /// The work that is timed: from the scene to what can be asked for its motion.
    ///
    /// # Errors
    /// Why there is no answer, in words for the table.
    fn work(&self, job: &Job<'_>) -> Result<Work, String>;
}

static METHODS: [&dyn Method; 5] = [
    &event_driven::EventDriven,
    &semi_implicit_euler::SemiImplicitEuler,
    &runge_kutta4::RungeKutta4,
    &newmark::Newmark,
    &dormand_prince::DormandPrince,
];

/// Every method, the product's own first.
pub fn all() -> &'static [&'static dyn Method] {
    &METHODS
}

/// The method of this name.
pub fn get(name: &str) -> Option<&'static dyn Method> {
    METHODS.iter().copied().find(|method| method.name() == name)
}
