//! The workbench window: winit brings events and a surface, egui the panels, the renderer the 3D view.
//!
//! Everything but the thin `shell` is one function, [`show`], that a test can call without a window. Panels read the
//! parts of the workbench and return [`Command`]s; [`Workbench::apply`] takes each to its part. Changes of the scene go
//! through [`scene::edit`](crate::scene::edit), so that every one of them can be undone.
//!
//! # Rooms
//!
//! Each uses only rooms listed before it (`APP_ROOMS` in `tests/architecture.rs`).
//!
//! | room | what is in it |
//! |---|---|
//! | `host` | time on the wall, threads, the wake-up call |
//! | `style`, `unit` | colours, signs and sizes; units of numbers |
//! | `command` | what can be asked for, as plain data |
//! | `text` | every word that the window shows |
//! | `field` | one number of a scene: label, unit, range, reset |
//! | `edits` | the scene with its past and what is selected in it; edits |
//! | `learn` | lessons |
//! | `link` | what a link to the page opens |
//! | `run` | runs of the scene, their answers, runs kept to compare with |
//! | `time` | the answer played back: clock, window of time, timeline |
//! | `plot` | curves: sampled, drawn, written |
//! | `disk` | scene files, autosave; exports, films and the system's dialogs on threads |
//! | `viewport` | the 3D view: camera, picture, mouse, handles |
//! | `map` | a number of the run over two keys of the scene: runs on threads, the picture |
//! | `quake` | histories and response spectrum of the ground motion |
//! | `bench` | the parts put together, and commands that concern several of them |
//! | `panel` | panels, dialogs, keys, and where they stand |
//! | `shell` | the system's window |

mod bench;
mod command;
mod disk;
mod edits;
mod field;
mod host;
mod learn;
mod link;
mod map;
mod panel;
mod plot;
mod quake;
mod run;
mod shell;
mod style;
mod text;
mod time;
mod unit;
mod viewport;

pub use bench::Workbench;
pub use command::{
    AngleCommand, AppearanceCommand, BridgeDraft, Command, CompareCommand, EditCommand, Export, FileCommand,
    FilmCommand, FilmFormat, FilmPlan, Flank, Follow, Grip, HandCommand, HandKey, KeepCommand, LearnCommand,
    LeaveCommand, Look, MapAxis, MapCommand, MapDraft, Nudge, Pane, PathCommand, PlaceCommand, PlotCommand,
    QuakeCommand, RowDraft, RunCommand, SelectCommand, Sight, TimeCommand, Tool, ViewCommand, Way, WindowCommand, Wish,
};
pub use host::Wake;
pub use learn::lessons::{Lesson, Try, lessons};
pub use link::{Link, Target};
pub use map::{Angles, Maps};
pub use panel::layout::show;
pub use quake::Shaking;
pub use run::answer::{Answer, Span};
pub use shell::app_error::AppError;
#[cfg(target_arch = "wasm32")]
pub use shell::outside::{give_up, open_page};
pub use shell::window::run;
pub use time::clock::{Clock, HIT_SPEED, SPEEDS};
