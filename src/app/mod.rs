//! The workbench window: winit brings events and a surface, egui the panels, the renderer the 3D view.
//!
//! Everything but the thin `shell` is one function, [`Workbench::ui`], that a test can call without a window. Panels
//! read the workbench and return [`Command`]s; [`Workbench::apply`] is where they are done. Changes of the scene go
//! through [`scene::edit`](crate::scene::edit), so that every one of them can be undone.

mod bench;
mod command;
mod disk;
mod edits;
mod field;
mod host;
mod learn;
mod panel;
mod plot;
mod run;
mod shell;
mod style;
mod text;
mod time;
mod unit;
mod viewport;

pub use bench::Workbench;
pub use command::{
    Command, CompareCommand, EditCommand, Export, FileCommand, FilmFormat, FilmPlan, Filming, Flank, Follow, Grip,
    HandCommand, HandKey, Keep, Learn, Nudge, PlaceCommand, RowDraft, SelectCommand, Sight, TimeCommand, Tool,
    ViewCommand, Way, WindowCommand,
};
pub use host::Wake;
pub use learn::lessons::{Lesson, Try, lessons};
pub use run::answer::{Answer, Span};
pub use shell::window::{AppError, run};
pub use time::clock::{Clock, HIT_SPEED, SPEEDS};
