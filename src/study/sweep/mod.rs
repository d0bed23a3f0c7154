//! One scene at many values of its keys: what is kept of each run, its journal, the dataset, pictures (`docs/sweep.md`).
//!
//! A [`Plan`] numbers the runs. Each [`Row`] depends on the number of its run alone, so a sweep may be computed in any order,
//! in several processes and on several machines, and comes out the same.

mod axis;
mod check;
mod dataset;
pub mod journal;
mod measure;
mod nested;
#[cfg(feature = "parquet")]
mod parquet;
mod picture;
mod plan;
mod row;
mod workers;

pub use axis::Axis;
pub use check::{Changed, changed};
pub use dataset::{Column, Dataset, about, columns, identity};
pub use measure::{MEASURES, Measure};
pub use nested::Nested;
pub use plan::{Plan, ReadRecords, own_value};
pub use row::{Row, Status};
pub use workers::compute;
