//! The methods that are compared: one file each, one interface.
//!
//! The event-driven solver is the product's own. The others are what a user of other tools would do with the same
//! equations: the same bearings, the same contact laws, a gap tested wherever forces are evaluated, and the states
//! {open, stick, slip} brought up to date at the end of every step.

mod contacts;
mod dormand_prince;
mod event_driven;
mod interface;
mod march;
mod newmark;
mod newmark_elements;
mod runge_kutta4;
mod semi_implicit_euler;
mod solve;
mod world;

pub use interface::{Job, Method, SettingKind, Work};

static METHODS: [&dyn Method; 6] = [
    &event_driven::EventDriven,
    &semi_implicit_euler::SemiImplicitEuler,
    &runge_kutta4::RungeKutta4,
    &newmark::Newmark,
    &newmark_elements::NewmarkElements,
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
