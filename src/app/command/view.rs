//! Commands about the 3D view, and how it is looked at.

use crate::geometry::End;
use crate::scene::{Overlays, ViewPreset};
use crate::view::{Bending, Camera};

/// Tool of the mouse in the 3D view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Selects, and moves what is selected.
    #[default]
    Select,
    /// Puts a girder where it is clicked.
    Girder,
    /// Puts an abutment before the nearest free end.
    Abutment,
}

/// Point that the camera follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follow {
    /// The middle of a girder.
    Middle(usize),
    /// A corner of a girder in plan, 0 to 3.
    Corner(usize, usize),
}

/// How the view is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// How many times larger than they are displacements are shown.
    pub exaggeration: f64,
    /// How girders that bend are drawn; as rigid ones by none.
    pub bent: Option<Bending>,
    /// Point that the camera follows.
    pub follow: Option<Follow>,
    /// Whether the plan is shown beside the view.
    pub plan: bool,
    /// Whether the section of the gap is shown.
    pub section: bool,
    /// Whether only the view and the time are shown, large.
    pub lecture: bool,
}

impl Default for Sight {
    fn default() -> Self {
        Self { exaggeration: 1.0, bent: None, follow: None, plan: false, section: false, lecture: false }
    }
}

/// Object that the camera turns to, at the time shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// A girder from above, by its number.
    Girder(usize),
    /// A corner of a girder from above, by both numbers.
    Corner(usize, usize),
    /// Both corners of an end from above.
    End(usize, End),
    /// A contact and its force, by its number.
    Contact(usize),
}

/// Camera, layers, tool.
#[derive(Clone, Copy, Debug)]
pub enum ViewCommand {
    /// A standing place for the camera.
    Preset(ViewPreset),
    /// The camera as the mouse has moved it.
    Camera(Camera),
    /// Frame what is selected, or everything.
    Frame,
    /// Turn to a part of the scene.
    Look(Look),
    /// Back to the camera before the last of these four.
    Back,
    /// Which layers are shown.
    Overlays(Overlays),
    /// Force scale \[N per m\]; from the run's peak when none.
    ForceScale(Option<f64>),
    /// How the view is looked at.
    Sight(Sight),
    /// Tool of a click in the view.
    Tool(Tool),
}
