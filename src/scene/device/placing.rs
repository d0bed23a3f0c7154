//! Points of a device as placed: in the frames of the bodies that they are on.

use glam::{DMat3, DVec3};

use super::joint::Joint;
use super::part::Ends;
use crate::scene::{Kind, Scene, placed};

impl Joint {
    /// Of a device in a scene; `None` where a body is not there. A planar scene puts both points at the height of the girder.
    pub fn of(scene: &Scene, ends: &Ends<'_>) -> Option<Self> {
        let girder = number(scene, ends.girder)?;
        let own = Stand::on_girder(scene, girder);
        let stand = Stand::of(scene, ends.to)?;
        let first = own.point(ends.at);
        let mut second = ends.to_at.map_or(first, |at| stand.point(at));
        if scene.kind == Kind::Planar {
            second.z = first.z;
        }
        Some(Self {
            girder,
            other: stand.girder,
            points: [first, second],
            axes: own.axes,
            abutment: stand.abutment,
            face: stand.face,
        })
    }
}

/// Coordinates of a point of the world on a body by its name, or on the ground without: along the axes of its frame as placed, as a
/// device's points are given \[m\]; `None` where no body has the name.
pub fn point_on(scene: &Scene, body: Option<&str>, world: DVec3) -> Option<[f64; 3]> {
    let stand = Stand::of(scene, body)?;
    Some((stand.axes.transpose() * (world - stand.origin)).to_array())
}

/// Body of a device's point, as placed.
struct Stand {
    girder: Option<usize>,
    abutment: Option<usize>,
    origin: DVec3,
    axes: DMat3,
    face: Option<DVec3>,
}

impl Stand {
    /// `None` where nobody has the name, or the face of the abutment is not known.
    fn of(scene: &Scene, name: Option<&str>) -> Option<Self> {
        let Some(name) = name else {
            return Some(Self { girder: None, abutment: None, origin: DVec3::ZERO, axes: DMat3::IDENTITY, face: None });
        };
        if let Some(girder) = number(scene, name) {
            return Some(Self::on_girder(scene, girder));
        }
        let number = scene.abutments.iter().position(|a| a.name == name)?;
        let abutment = &scene.abutments[number];
        let [a, b, c, d] = placed::abutment_face(scene, abutment)?;
        let (out, along) = ((c - a).cross(d - b).normalize_or_zero(), (b - a).normalize_or_zero());
        let axes = DMat3::from_cols(out, along, out.cross(along));
        Some(Self { girder: None, abutment: Some(number), origin: (a + b + c + d) / 4.0, axes, face: Some(out) })
    }

    fn on_girder(scene: &Scene, number: usize) -> Self {
        let girder = &scene.girders[number];
        Self {
            girder: Some(number),
            abutment: None,
            origin: girder.position.into(),
            axes: placed::axes(girder),
            face: None,
        }
    }

    fn point(&self, at: [f64; 3]) -> DVec3 {
        self.origin + self.axes * DVec3::from(at)
    }
}

/// Number of a girder by its name.
fn number(scene: &Scene, name: &str) -> Option<usize> {
    scene.girders.iter().position(|girder| girder.name == name)
}
