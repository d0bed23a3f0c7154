//! Contacts at any time: their forces, and whether the law that gives these still held.

mod acting;
mod coulomb;
pub mod validity;
pub mod view;
