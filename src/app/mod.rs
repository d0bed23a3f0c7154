//! The workbench window: winit brings events and a surface, egui the panels, the renderer the 3D view.
//!
//! Everything but the thin `shell` is one function, [`Workbench::ui`], that a test can call without a window. Panels
//! read the workbench and return [`Command`]s; [`Workbench::apply`] is where they are done. Changes of the scene go
//! through [`scene::edit`](crate::scene::edit), so that every one of them can be undone.

mod answer;
mod apply;
mod ask;
mod autosave;
mod blit;
mod clock;
mod command;
mod computed;
mod dialogs;
mod document;
mod edits;
mod export;
mod field;
mod film;
mod film_dialog;
mod gizmo;
mod hand;
mod help;
mod icons;
mod input;
mod inspector;
mod keeping;
mod last_will;
mod lesson_panel;
mod lessons;
mod limits;
mod look;
mod menu;
mod models;
mod name_field;
mod notices;
mod outliner;
mod overlays;
mod painter;
mod panels;
mod pins;
mod placing;
mod plot_files;
mod plots;
mod recent;
mod row_dialog;
mod runner;
mod screen;
mod selection;
mod shell;
mod status;
mod surface;
mod text;
mod textures;
mod theme;
mod time_axis;
mod timeline;
mod tool;
mod traces;
mod transport;
mod units;
mod viewport;
mod views;
mod whatif;
mod workbench;

pub use answer::{Answer, Span};
pub use clock::{Clock, HIT_SPEED, SPEEDS};
pub use command::{Command, Export, Nudge, Way};
pub use film::{FilmFormat, FilmPlan, Filming};
pub use keeping::Keep;
pub use lessons::{Learn, Lesson, Try, lessons};
pub use row_dialog::RowDraft;
pub use runner::Wake;
pub use shell::{AppError, run};
pub use tool::Tool;
pub use views::{Follow, Sight};
pub use workbench::Workbench;
