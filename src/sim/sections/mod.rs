//! Sections of elastic girders: forces and stress at any station, their largest values, and whether the degree suffices.

pub mod degree_check;
pub mod field;
mod largest;
pub mod quantity;
pub mod readings;
pub mod view;
