//! The two points of a device as placed, and directions that it is given.

use crate::language::{Text, message};
use glam::{DMat3, DVec3};

use super::fault::Fault;

/// Shortest line between the two points of a device \[m\].
const SHORTEST: f64 = 1e-6;

/// The two points of a device as placed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Number of the girder of the first point.
    pub girder: usize,
    /// Number of the girder of the second point; none on an abutment or the ground.
    pub other: Option<usize>,
    /// The points, world axes \[m\].
    pub points: [DVec3; 2],
    /// Axes of the first girder as placed, in the columns.
    pub axes: DMat3,
    /// Number of the abutment of the second point; none on a girder or the ground.
    pub abutment: Option<usize>,
    /// Outward normal of the abutment's face, where the second point is on one.
    pub face: Option<DVec3>,
}

impl Joint {
    /// Vector from the second point to the first as placed, world axes \[m\].
    pub fn span(&self) -> DVec3 {
        self.points[0] - self.points[1]
    }

    /// Distance of its points as placed \[m\].
    pub fn length(&self) -> f64 {
        self.span().length()
    }

    /// A direction given in the girder's frame as placed, as a unit vector in the world; `None` without length.
    pub fn direction(&self, given: [f64; 3]) -> Option<DVec3> {
        (self.axes * DVec3::from(given)).try_normalize()
    }

    /// Fault of the points of a device that acts along the line between them.
    pub(super) fn too_short(&self) -> Option<Fault> {
        let remedy = Text::new("wrong-points-too-near");
        (self.length() < SHORTEST).then(|| {
            ("to_m", message!("found-points-too-near", "length" => format!("{:e}", self.length())), remedy.into())
        })
    }
}

/// Fault of a given direction.
pub(super) fn no_direction(key: &'static str, given: Option<[f64; 3]>) -> Option<Fault> {
    let vector = given?;
    let short = DVec3::from(vector).try_normalize().is_none();
    short.then(|| (key, format!("{vector:?}").into(), Text::new("wrong-no-vector").into()))
}
