//! Commands: what panels, mouse and keys ask for, as plain data.
//!
//! A panel reads the state of the window and returns commands; [`Workbench::apply`](super::Workbench::apply) is the one
//! place where they change anything. Each group is an enum of its own, so that every match over it is exhaustive.

mod angles;
mod compare;
mod edit;
mod file;
mod film;
mod hand;
mod learn;
mod map;
mod plot;
mod quake;
mod select;
mod time;
mod view;
mod window;

pub use angles::AngleCommand;
pub use compare::CompareCommand;
pub use edit::{BridgeDraft, EditCommand, Nudge, PlaceCommand, RowDraft};
pub use file::{Export, FileCommand, KeepCommand, PathCommand, Wish};
pub use film::{FilmCommand, FilmFormat, FilmPlan};
pub use hand::{Flank, Grip, HandCommand, HandKey};
pub use learn::LearnCommand;
pub use map::{MapAxis, MapCommand, MapDraft};
pub use plot::PlotCommand;
pub use quake::QuakeCommand;
pub use select::SelectCommand;
pub use time::{TimeCommand, Way};
pub use view::{Follow, Look, Sight, Tool, ViewCommand};
pub use window::{AppearanceCommand, LeaveCommand, Pane, RunCommand, WindowCommand};

/// Declares the groups of [`Command`], each with the conversion of its own commands.
macro_rules! groups {
    ($($(#[$doc:meta])* $group:ident($command:ty)),* $(,)?) => {
        /// One command, by its group.
        #[derive(Clone, Debug)]
        pub enum Command {
            $($(#[$doc])* $group($command),)*
        }

        $(impl From<$command> for Command {
            fn from(command: $command) -> Self {
                Self::$group(command)
            }
        })*
    };
}

groups! {
    /// Playing, seeking, the stretch of time shown.
    Time(TimeCommand),
    /// A change of the scene, undo, redo.
    Edit(EditCommand),
    /// Adding, copying, moving and removing bodies.
    Place(PlaceCommand),
    /// A handle that is held by keys.
    Hand(HandCommand),
    /// Selection.
    Select(SelectCommand),
    /// Camera, layers, tool.
    View(ViewCommand),
    /// Runs kept to compare with.
    Compare(CompareCommand),
    /// Scene files, records, exports.
    File(FileCommand),
    /// Recent files, unsaved work, a file changed by another program.
    Keep(KeepCommand),
    /// A film of the run.
    Film(FilmCommand),
    /// Lessons.
    Learn(LearnCommand),
    /// The map of a run's number over two keys.
    Map(MapCommand),
    /// The run's numbers over the angle of the shaking.
    Angles(AngleCommand),
    /// Histories and response spectrum of the ground motion.
    Quake(QuakeCommand),
    /// How the plots are looked at.
    Plot(PlotCommand),
    /// The run that is computed.
    Run(RunCommand),
    /// Language, theme and size.
    Appearance(AppearanceCommand),
    /// Leaving the scene.
    Leave(LeaveCommand),
    /// The window itself.
    Window(WindowCommand),
}
