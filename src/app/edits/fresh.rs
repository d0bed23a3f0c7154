//! What is there before anything has been placed.

use crate::scene::{
    ContactSettings, Girder, ImpactSettings, Initial, Kind, Limits, ModelSettings, Motion, Push, STANDARD_GRAVITY,
    Scene, Seat, SolverSettings, ViewSettings,
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
        motion: Motion::default(),
        solver: SolverSettings::default(),
        view: ViewSettings::default(),
    }
}

/// The paper's straight girder, where nothing is placed that could be copied.
pub(super) fn first_girder() -> Girder {
    Girder {
        name: "girder".into(),
        length: 0.190,
        width: 0.070,
        thickness: 0.020,
        skew_deg: 90.0,
        mass: 2.0,
        position: [0.0; 3],
        heading_deg: 0.0,
        bearings: None,
        initial: Initial::default(),
        push: Push::default(),
        held: Vec::new(),
        seat: Seat::default(),
    }
}
