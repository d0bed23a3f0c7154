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
mod hand;
mod help;
mod icons;
mod input;
mod inspector;
mod keeping;
mod lesson_panel;
mod lessons;
mod look;
mod menu;
mod models;
mod name_field;
mod notices;
mod outliner;
mod overlays;
mod plots;
mod recent;
mod runner;
mod screen;
mod shell;
mod status;
mod surface;
mod text;
mod theme;
mod time_axis;
mod timeline;
mod traces;
mod transport;
mod viewport;
mod whatif;
mod workbench;

pub use answer::{Answer, Span};
pub use clock::{Clock, HIT_SPEED, SPEEDS};
pub use command::{Command, Export, Way};
pub use film::{FilmFormat, FilmPlan, Filming};
pub use keeping::Keep;
pub use lessons::{Learn, Lesson, Try, lessons};
pub use runner::Wake;
pub use shell::{AppError, run};
pub use workbench::Workbench;
