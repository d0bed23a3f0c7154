//! The changes that there are, and why one cannot be done.

use crate::scene::{
    Abutment, Codes, ContactSettings, Device, DeviceId, Girder, ImpactSettings, Kind, Limits, ModelSettings, Motion,
    NamedGround, Pier, Scene, SceneErrors, SolverSettings, ViewSettings, Wave,
};

/// The single values at the top of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct General {
    /// Name of the scene.
    pub name: String,
    /// A line or two on it.
    pub description: String,
    /// Planar or spatial.
    pub kind: Kind,
    /// Duration of the ground motion \[s\].
    pub duration: f64,
    /// Gravity \[m/s²\].
    pub gravity: f64,
}

/// A change to a scene. Bodies are called by their number in the scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Puts a girder in at this number.
    AddGirder(usize, Box<Girder>),
    /// Takes a girder out, and with it the abutments that face it and the contact pairs and devices that name any of them.
    RemoveGirder(usize),
    /// Makes the girder at this number another one, of the same name.
    ReplaceGirder(usize, Box<Girder>),
    /// Places a girder: position \[m\] and heading \[degrees\].
    MoveGirder(usize, [f64; 3], f64),
    /// Puts an abutment in at this number.
    AddAbutment(usize, Box<Abutment>),
    /// Takes an abutment out, and with it the contact pairs and devices that name it.
    RemoveAbutment(usize),
    /// Makes the abutment at this number another one, of the same name.
    ReplaceAbutment(usize, Box<Abutment>),
    /// Puts a pier in at this number.
    AddPier(usize, Box<Pier>),
    /// Takes a pier out; what stood on it stands on the ground.
    RemovePier(usize),
    /// Makes the pier at this number another one, of the same name.
    ReplacePier(usize, Box<Pier>),
    /// Puts a device in at this number of its kind.
    AddDevice(usize, Box<Device>),
    /// Takes a device out.
    RemoveDevice(DeviceId),
    /// Makes the device of this number another one, of the same kind and name.
    ReplaceDevice(DeviceId, Box<Device>),
    /// Gives the girder, abutment, pier or device of the first name the second name, wherever it is named.
    Rename(String, String),
    /// Name, kind, duration, gravity.
    General(Box<General>),
    /// Sets which values are assumed.
    Assumed(Vec<String>),
    /// Contact numbers and pairs.
    Contact(Box<ContactSettings>),
    /// Models that compute it.
    Model(ModelSettings),
    /// Numbers of the impact model.
    Impact(ImpactSettings),
    /// Ground motion.
    Motion(Box<Motion>),
    /// Motions that supports have of their own.
    Grounds(Vec<NamedGround>),
    /// Propagation of that motion.
    Wave(Option<Wave>),
    /// Limits that are watched.
    Limits(Limits),
    /// Inputs of design codes for seat lengths.
    Codes(Codes),
    /// Solver settings.
    Solver(SolverSettings),
    /// View settings.
    View(ViewSettings),
    /// One value by its path, as in `--set`.
    Set(String),
    /// Another scene altogether.
    Scene(Box<Scene>),
    /// Several edits, done in this order and undone as one.
    Batch(Vec<Edit>),
}

/// Reasons of an edit that cannot be done; the scene is then as it was.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EditError {
    /// There is no such number.
    #[error("there is no {what} {index}: the scene has {count}")]
    Missing {
        /// "girder", "abutment", "pier" or a kind of device.
        what: &'static str,
        /// The number asked for, from 0.
        index: usize,
        /// Number of all.
        count: usize,
    },
    /// Nobody has this name.
    #[error("nobody is called \"{0}\"")]
    Nobody(String),
    /// The name is in use.
    #[error("\"{0}\" is the name of another body or device: choose another")]
    NameTaken(String),
    /// A replacement comes with another name.
    #[error("\"{0}\" cannot become \"{1}\" by replacing it: rename it first")]
    OtherName(String, String),
    /// A value that the scene's file could not have.
    #[error(transparent)]
    Setting(#[from] SceneErrors),
}

impl Edit {
    /// Whether doing this edit after `later` makes `later` needless: it sets every place that `later` sets.
    pub(super) fn covers(&self, later: &Self) -> bool {
        let (own, later) = (self.parts(), later.parts());
        own.iter().all(Self::is_setting) && later.iter().all(|part| own.iter().any(|own| own.sets_place_of(part)))
    }

    /// The edits of a batch, or the edit alone.
    fn parts(&self) -> &[Self] {
        if let Self::Batch(edits) = self { edits } else { std::slice::from_ref(self) }
    }

    /// Whether it sets a place, whatever was there, and renumbers or renames nothing.
    fn is_setting(&self) -> bool {
        let moves_things = matches!(
            self,
            Self::AddGirder(..)
                | Self::RemoveGirder(_)
                | Self::AddAbutment(..)
                | Self::RemoveAbutment(_)
                | Self::AddPier(..)
                | Self::RemovePier(_)
                | Self::AddDevice(..)
                | Self::RemoveDevice(_)
                | Self::Rename(..)
                | Self::Set(_)
                | Self::Batch(_)
        );
        !moves_things
    }

    fn sets_place_of(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Scene(_), _)
            | (Self::General(_), Self::General(_))
            | (Self::Assumed(_), Self::Assumed(_))
            | (Self::Contact(_), Self::Contact(_))
            | (Self::Model(_), Self::Model(_))
            | (Self::Impact(_), Self::Impact(_))
            | (Self::Motion(_), Self::Motion(_))
            | (Self::Grounds(_), Self::Grounds(_))
            | (Self::Wave(_), Self::Wave(_))
            | (Self::Limits(_), Self::Limits(_))
            | (Self::Codes(_), Self::Codes(_))
            | (Self::Solver(_), Self::Solver(_))
            | (Self::View(_), Self::View(_)) => true,
            (Self::ReplaceGirder(a, _), Self::ReplaceGirder(b, _) | Self::MoveGirder(b, ..))
            | (Self::MoveGirder(a, ..), Self::MoveGirder(b, ..))
            | (Self::ReplaceAbutment(a, _), Self::ReplaceAbutment(b, _))
            | (Self::ReplacePier(a, _), Self::ReplacePier(b, _)) => a == b,
            (Self::ReplaceDevice(a, _), Self::ReplaceDevice(b, _)) => a == b,
            _ => false,
        }
    }
}

impl General {
    /// As they are in a scene.
    pub fn of(scene: &Scene) -> Self {
        Self {
            name: scene.name.clone(),
            description: scene.description.clone(),
            kind: scene.kind,
            duration: scene.duration,
            gravity: scene.gravity,
        }
    }
}
