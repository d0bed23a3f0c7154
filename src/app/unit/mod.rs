//! Numbers and their units: how a number of the scene is shown, and which units may be typed for it.

mod dimension;
mod keyed;
mod shown;

pub(in crate::app) use keyed::{Size, unit_of};
pub(in crate::app) use shown::*;
