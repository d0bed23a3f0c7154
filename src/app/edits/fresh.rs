//! What is there before anything has been placed.

use crate::scene::{
    Codes, ContactSettings, Girder, ImpactSettings, Kind, Limits, ModelSettings, Motion, STANDARD_GRAVITY, Scene,
    SolverSettings, ViewSettings,
};

/// A scene with nothing in it.
pub(in crate::app) fn empty() -> Scene {
    Scene {
        format: crate::scene::format::VERSION,
        name: crate::app::text::UNTITLED.into(),
        description: String::new(),
        kind: Kind::default(),
        duration: 5.0,
        gravity: STANDARD_GRAVITY,
        model: ModelSettings::default(),
        girders: Vec::new(),
        abutments: Vec::new(),
        contact: ContactSettings::default(),
        impact: ImpactSettings::default(),
        limits: Limits::default(),
        codes: Codes::default(),
        motion: Motion::default(),
        solver: SolverSettings::default(),
        view: ViewSettings::default(),
    }
}

/// The paper's straight girder, where nothing is placed that could be copied.
pub(super) fn first_girder() -> Girder {
    Girder::straight("girder", [0.190, 0.070, 0.020], 2.0)
}
