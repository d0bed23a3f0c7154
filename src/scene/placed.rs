//! Bodies of a scene as placed: corners and faces in the world.

use glam::{DMat3, DVec2, DVec3};

use super::angle::sin_cos_deg;
use super::{Abutment, Girder, Scene};
use crate::geometry::End;

/// World axes of a girder's frame as placed, in the columns: x along its axis, z up.
///
/// Multiples of 90° are exact, so that a bridge along world y is the same bridge to the last bit.
pub fn axes(girder: &Girder) -> DMat3 {
    let (s, c) = sin_cos_deg(girder.heading_deg);
    DMat3::from_cols(DVec3::new(c, s, 0.0), DVec3::new(-s, c, 0.0), DVec3::Z)
}

/// Corners of a girder in plan in the world as placed, in the order of their numbers \[m\].
pub fn plan(girder: &Girder) -> [DVec2; 4] {
    let axes = axes(girder);
    let place = DVec3::from(girder.position);
    girder.prism().plan_corners().map(|corner| (place + axes * corner.extend(0.0)).truncate())
}

/// Corners of a girder's end face in the world as placed, anticlockwise seen from outside \[m\].
pub fn end_face(girder: &Girder, end: End) -> [DVec3; 4] {
    let axes = axes(girder);
    let place = DVec3::from(girder.position);
    girder.prism().end_face(end).map(|corner| place + axes * corner)
}

/// Corners of an abutment's face in the world, anticlockwise seen from the girder that it faces \[m\].
///
/// `None` when the girder it names is not there, or when neither a gap nor four corners are given; validation says so
/// in words.
pub fn abutment_face(scene: &Scene, abutment: &Abutment) -> Option<[DVec3; 4]> {
    if let Some(corners) = &abutment.polygon {
        let corners: &[[f64; 3]; 4] = corners.as_slice().try_into().ok()?;
        return Some(corners.map(DVec3::from));
    }
    let girder = scene.girders.iter().find(|g| g.name == abutment.faces)?;
    let prism = girder.prism();
    let axes = axes(girder);
    let along = axes.x_axis * abutment.end.sign();
    let [a, b, ..] = end_face(girder, abutment.end);
    // From the face's first corner to its second, seen from outside the girder: the wall looks back, so reversed.
    let side = -(b - a) / prism.end_length();
    let end_centre = DVec3::from(girder.position) + along * (prism.length / 2.0);
    let centre = end_centre + along * abutment.gap? + side * abutment.offset.unwrap_or(0.0);
    let half_width = abutment.width.unwrap_or(3.0 * prism.end_length()) / 2.0;
    let half_height = abutment.height.unwrap_or(3.0 * girder.thickness) / 2.0;
    let (w, h) = (side * half_width, DVec3::Z * half_height);
    Some([centre - w - h, centre + w - h, centre + w + h, centre - w + h])
}

/// Depth of an abutment behind its face \[m\].
pub fn abutment_depth(scene: &Scene, abutment: &Abutment) -> f64 {
    let girder = scene.girders.iter().find(|g| g.name == abutment.faces);
    abutment.depth.or(girder.map(|g| g.length)).unwrap_or(1.0)
}
