//! The program as a user calls it: files in, files out, exit status and messages.

mod bad_input;
mod domain;
mod earlier;
mod files;
mod grounds;
mod headless;
mod identify;
mod interrupted;
mod killed;
mod languages;
#[cfg(feature = "render")]
mod measure;
mod motion;
mod odd_files;
mod odd_output;
mod overlap;
mod plot;
mod program;
#[cfg(feature = "render")]
mod render;
mod report;
mod run;
mod study;
mod study_experiment;
mod sweep;
mod weight;
