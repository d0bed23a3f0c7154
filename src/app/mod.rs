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
mod learn;
mod panel;
mod plot;
mod run;
mod shell;
mod style;
mod text;
mod time;
mod viewport;

pub use bench::Workbench;
pub use command::{Command, Export, Nudge, Way};
pub use disk::film::{FilmFormat, FilmPlan, Filming};
pub use disk::session_files::Keep;
pub use learn::lessons::{Learn, Lesson, Try, lessons};
pub use panel::row_dialog::RowDraft;
pub use run::answer::{Answer, Span};
pub use run::runner::Wake;
pub use shell::window::{AppError, run};
pub use time::clock::{Clock, HIT_SPEED, SPEEDS};
pub use viewport::gizmo::{Flank, Grip};
pub use viewport::mouse::HandKey;
pub use viewport::tool::Tool;
pub use viewport::view_options::{Follow, Sight};
