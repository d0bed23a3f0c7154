//! The two sides of a pair: ends of girders and abutments, by number and by name.

use glam::DVec3;

use crate::geometry::End;
use crate::scene::{Scene, placed};

/// One side of a facing pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// An end of a girder, by its number in the scene.
    Girder(usize, End),
    /// An abutment, by its number in the scene.
    Abutment(usize),
}

/// Centre and outward normal of a side's face; `None` where an abutment has no face yet.
pub(super) fn front(scene: &Scene, side: Side) -> Option<(DVec3, DVec3)> {
    let corners = match side {
        Side::Girder(n, end) => placed::end_face(&scene.girders[n], end),
        Side::Abutment(n) => placed::abutment_face(scene, &scene.abutments[n])?,
    };
    let [a, b, c, d] = corners;
    Some(((a + b + c + d) / 4.0, (c - a).cross(d - b).normalize_or_zero()))
}

pub(super) fn girder_named(scene: &Scene, name: &str) -> Option<usize> {
    scene.girders.iter().position(|g| g.name == name)
}

/// Who there is, for complaints.
pub(super) fn names(scene: &Scene) -> String {
    let list = |names: Vec<&str>| if names.is_empty() { "none".to_owned() } else { names.join(", ") };
    let girders = list(scene.girders.iter().map(|g| g.name.as_str()).collect());
    let abutments = list(scene.abutments.iter().map(|a| a.name.as_str()).collect());
    format!("girders: {girders}; abutments: {abutments}")
}
