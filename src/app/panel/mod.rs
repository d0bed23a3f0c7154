//! Panels and dialogs of the window: they read the workbench and return commands.

pub(in crate::app) mod comparison;
mod components;
pub(in crate::app) mod file_questions;
pub(in crate::app) mod fold;
pub(in crate::app) mod ground_motion;
pub(in crate::app) mod help;
pub(in crate::app) mod inspector;
pub(in crate::app) mod layout;
pub(in crate::app) mod limits;
pub(in crate::app) mod menu;
pub(in crate::app) mod models;
pub(in crate::app) mod name_field;
pub(in crate::app) mod notices;
pub(in crate::app) mod outliner;
pub(in crate::app) mod overlays;
pub(in crate::app) mod record_of;
mod results;
pub(in crate::app) mod row_dialog;
mod samples;
mod seat_orbit;
pub(in crate::app) mod shortcuts;
pub(in crate::app) mod start;
pub(in crate::app) mod status;
mod target;
pub(in crate::app) mod view_menu;
mod wave;
pub(in crate::app) mod whatif;
