//! What the panels, the mouse and the keys ask for.
//!
//! A panel reads the workbench and returns commands; [`Workbench::apply`](super::Workbench::apply) is the one place
//! where they change anything.

use std::path::PathBuf;

use glam::DVec3;

use crate::app::disk::film::Filming;
use crate::app::disk::session_files::Keep;
use crate::app::learn::lessons::Learn;
use crate::app::panel::row_dialog::RowDraft;
use crate::app::viewport::gizmo::Grip;
use crate::app::viewport::mouse::HandKey;
use crate::app::viewport::tool::Tool;
use crate::app::viewport::view_options::Sight;
use crate::scene::edit::Edit;
use crate::scene::{Overlays, ViewPreset};
use crate::view::{Camera, Target};

/// Which way to go in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Later.
    Forward,
    /// Earlier.
    Back,
}

impl Way {
    /// +1 or −1.
    pub fn sign(self) -> f64 {
        match self {
            Self::Forward => 1.0,
            Self::Back => -1.0,
        }
    }
}

/// A little way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nudge {
    /// Along the world's x and y \[m\].
    pub way: [f64; 2],
    /// Against the clock seen from above \[degrees\].
    pub turn_deg: f64,
}

/// Something to be written to a folder or file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Export {
    /// The picture in view, as PNG.
    Picture,
    /// Trajectory, contacts, events and summary.
    Tables,
}

/// One wish.
#[derive(Clone, Debug)]
pub enum Command {
    /// Change the scene. Edits with the same gesture, one after the other, are undone together.
    Edit {
        /// What is changed.
        edit: Edit,
        /// What the hand is on: a slider, a drag; none for a click.
        gesture: Option<u64>,
    },
    /// Take hold of a handle without the mouse, at its place \[m\].
    Take(Grip, DVec3),
    /// A key for the number of the handle that is held.
    Type(HandKey),
    /// Take the last change back.
    Undo,
    /// Make it again.
    Redo,
    /// Select something, or nothing.
    Select(Option<Target>),
    /// Select something beside what is selected, or let go of it.
    SelectAlso(Target),
    /// Select every girder and abutment.
    SelectAll,
    /// What a click in the view does.
    Tool(Tool),
    /// Put something new where the mouse is.
    Place(Edit),
    /// Put a new girder after the last one.
    AddGirder,
    /// Put an abutment before a free end.
    AddAbutment,
    /// Put a copy of what is selected beside it.
    Duplicate,
    /// Make a row of so many spans of the girder that is selected, with a gap between neighbours \[m\].
    Array {
        /// Girders in the row, the selected one among them.
        spans: usize,
        /// Gap between neighbours \[m\].
        gap: f64,
    },
    /// Ask for the numbers of a row, or stop asking.
    AskRow(Option<RowDraft>),
    /// Move and turn what is selected by a little.
    Nudge(Nudge),
    /// Remove what is selected.
    Remove,
    /// Give something another name.
    Rename(Target, String),
    /// Play or pause.
    TogglePlay,
    /// Keep the run that is shown, to compare with.
    Pin,
    /// Let a kept run go, by its number from 0.
    Unpin(usize),
    /// Let every kept run go.
    UnpinAll,
    /// Move the playhead by so many steps.
    Step(f64),
    /// To the next event, or the one before.
    StepEvent(Way),
    /// To a time \[s\].
    Seek(f64),
    /// Playing speed.
    Speed(f64),
    /// The next faster (+1) or slower (−1) playing speed.
    StepSpeed(i32),
    /// Begin again at the end, or not.
    Loop(bool),
    /// Play only a stretch, or everything \[s\].
    PlaySpan(Option<[f64; 2]>),
    /// Begin the stretch that is played at the time shown.
    SpanFrom,
    /// End it there.
    SpanTo,
    /// Slow down around hits, or not.
    SlowAtHits(bool),
    /// Show a stretch of time in the timeline and the plots \[s\].
    TimeWindow(Option<[f64; 2]>),
    /// A standing place for the camera.
    View(ViewPreset),
    /// The camera as the mouse has moved it.
    Camera(Camera),
    /// Frame what is selected, or everything.
    Frame,
    /// Which layers are shown.
    Overlays(Overlays),
    /// Force scale \[N per m\]; from the run's peak when none.
    ForceScale(Option<f64>),
    /// How the view is looked at.
    Sight(Sight),
    /// Size of everything, as a share of the usual one.
    Scale(f32),
    /// Light or dark.
    Theme(egui::Theme),
    /// Show the help, or not.
    Help(bool),
    /// Open a preset.
    OpenPreset(String),
    /// Begin an empty scene.
    New,
    /// Recent files, unsaved work, a file changed by others.
    Keep(Keep),
    /// Guided scenes.
    Learn(Learn),
    /// A film of the run.
    Film(Filming),
    /// Ask which file to open.
    OpenDialog,
    /// Open a file.
    OpenFile(PathBuf),
    /// Ask which record shakes the ground.
    AskRecord,
    /// Shake the ground by the record in a file, given from the scene's own folder on.
    Record(PathBuf),
    /// Save where it came from, or ask.
    Save,
    /// Ask where to save.
    SaveAs,
    /// Save into a file.
    SaveFile(PathBuf),
    /// Ask where to, and export.
    Export(Export),
    /// Ask where to, and write the plots as `svg`, `png` or `csv`.
    AskPlots(&'static str),
    /// Write the plots into a file, in the format that its name ends in.
    Plots(PathBuf),
    /// Export to a file (picture) or folder (tables).
    ExportTo(Export, PathBuf),
    /// Stop computing.
    CancelRun,
    /// Close the window; asks first when something is not saved.
    Close,
    /// Close the window and lose what is not saved.
    CloseAnyway,
    /// Do not close.
    KeepOpen,
    /// The notice at the bottom has been read.
    Dismiss,
}
