//! The meetings of a model: bodies that have met as convex solids, from the faces that they have as sides of pairs.

use glam::{DMat3, DVec3};

use crate::dynamics::model::body::Body;
use crate::dynamics::model::contact_sites::{pair_side, placed_at};
use crate::dynamics::model::meeting::{Meeting, Solid, SolidGeometry};
use crate::dynamics::model::pair::Carrier;
use crate::scene::facing::{Side, SolidId};
use crate::scene::{Kind, Scene, SceneErrors};

/// The meetings of bodies that have met. In space none of a girder that bends: twisted, its sides are no planes, and corners and edges
/// do not lie in the faces that they bound.
///
/// # Errors
///
/// An abutment's four corners are no face.
pub(super) fn meetings(scene: &Scene, bodies: &[Body], met: &[[SolidId; 2]]) -> Result<Vec<Meeting>, SceneErrors> {
    let is_solid = |id: &SolidId| match id {
        SolidId::Girder(number) => scene.kind == Kind::Planar || bodies[*number].sections() == 1,
        SolidId::Abutment(_) => true,
    };
    let meeting = |&ids: &[SolidId; 2]| {
        let [one, other] = ids.map(|id| solid(scene, bodies, id));
        Ok(Meeting::of(ids, [one?, other?]))
    };
    met.iter().filter(|ids| ids.iter().all(is_solid)).map(meeting).collect()
}

/// A body by its faces, in plan by those that stand upright.
fn solid(scene: &Scene, bodies: &[Body], id: SolidId) -> Result<Solid, SceneErrors> {
    let (mut parts, mut home, mut least_side) = (SolidGeometry::default(), DVec3::ZERO, f64::INFINITY);
    for face in Side::of(scene.kind, id) {
        let side = pair_side(scene, bodies, face)?;
        let section = |carrier| side.body.map_or(0, |body| bodies[body].section_of(carrier));
        let of_face = section(side.carrier());
        let (stands, axes): (DVec3, DMat3) = placed_at(bodies, &side);
        home = stands;
        let normal = axes * side.face.normal;
        parts.faces.push((of_face, normal, normal.dot(axes * side.face.corners[0])));
        let of_corner = |number: usize| section(Carrier::of_corner(id, number));
        let corners = face.corners().into_iter().zip(side.face.corners);
        parts.corners.extend(corners.map(|(number, corner)| (of_corner(number), axes * corner)));
        let [a, b, _, d] = side.face.corners;
        let upright = if scene.kind == Kind::Planar { f64::INFINITY } else { (d - a).length() };
        if scene.kind == Kind::Spatial {
            let ends = side.face.corners.iter().zip(side.face.corners.iter().cycle().skip(1));
            parts.sides.extend(ends.map(|(from, to)| (of_face, axes * (to - from).normalize_or_zero())));
        }
        least_side = least_side.min((b - a).length()).min(upright);
    }
    Ok(Solid::of(home, parts, least_side))
}
