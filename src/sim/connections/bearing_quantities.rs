//! Frequencies, damping ratios and eccentricities of a girder on its bearings, as on ground at rest, wherever they stand
//! (`docs/physics.md#bearings`).

use crate::dynamics::Body;
use crate::dynamics::model::bearing::{Bearing, BearingQuantities};
use crate::scene::{Girder, ResolvedBearing, Setting};
use crate::sim::connections::view::Connections;

/// The bearings of a girder with the stiffness and damping that they are given: those on piers and on supports that move are links
/// of the model, and have none of their own.
pub fn bearings_as_given(girder: &Girder, body: &Body, setting: Setting) -> Vec<Bearing> {
    let as_given = |(own, given): (&Bearing, ResolvedBearing)| Bearing {
        stiffness: given.stiffness.into(),
        damping: given.damping.into(),
        ..*own
    };
    body.bearings.iter().zip(girder.supports(setting)).map(as_given).collect()
}

impl Connections<'_> {
    /// (3), (4) of the girder of this number in its own axes.
    pub fn bearing_quantities(self, girder: usize) -> BearingQuantities {
        let (scene, body) = (self.history.scene(), &self.history.model().bodies[girder]);
        let bearings = bearings_as_given(&scene.girders[girder], body, scene.setting());
        BearingQuantities::of(&bearings, body.mass, body.gyration2)
    }
}
