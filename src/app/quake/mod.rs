//! The ground motion of the run: its histories and its response spectrum, with the girders' own periods.

mod shaking;
mod show;

pub use shaking::Shaking;
pub(in crate::app) use show::show;
