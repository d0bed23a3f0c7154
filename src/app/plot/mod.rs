//! Curves against time or against each other: sampling, drawing, files.

mod chart_view;
mod charts;
mod dashes;
mod legend;
pub(in crate::app) mod plot_files;
pub(in crate::app) mod plots;
pub(in crate::app) mod resolution;
pub(in crate::app) mod sampled;
pub(in crate::app) mod source;
pub(in crate::app) mod traces;
pub(in crate::app) mod user_plots;
pub(in crate::app) mod value_axis;
pub(in crate::app) mod views;
mod wave_chart;
mod wave_picture;
mod windows;
