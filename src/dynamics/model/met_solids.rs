//! The meetings of a model: bodies that have met as convex solids, from the faces that they have as sides of pairs.

use glam::{DMat3, DVec3};

use crate::dynamics::model::body::Body;
use crate::dynamics::model::contact_sites::{facade, placed_at};
use crate::dynamics::model::meeting::{Meeting, Solid};
use crate::scene::facing::{Side, SolidId};
use crate::scene::{Kind, Scene, SceneErrors};

/// The meetings of bodies that have met, but of flexible girders, which are no convex solids of one pose.
///
/// # Errors
/// When an abutment's four corners are no face.
pub(super) fn meetings(scene: &Scene, bodies: &[Body], met: &[[SolidId; 2]]) -> Result<Vec<Meeting>, SceneErrors> {
    let is_rigid = |id: &SolidId| !matches!(id, SolidId::Girder(number) if bodies[*number].sections() > 1);
    let rigid = met.iter().filter(|ids| ids.iter().all(is_rigid));
    let meeting = |&ids: &[SolidId; 2]| {
        let [one, other] = ids.map(|id| solid(scene, bodies, id));
        Ok(Meeting::of(ids, [one?, other?]))
    };
    rigid.map(meeting).collect()
}

/// A body by its faces, in plan by those that stand upright.
fn solid(scene: &Scene, bodies: &[Body], id: SolidId) -> Result<Solid, SceneErrors> {
    let (mut corners, mut faces, mut home) = (Vec::new(), Vec::new(), DVec3::ZERO);
    let (mut least_side, mut sides) = (f64::INFINITY, Vec::new());
    for side in Side::of(scene.kind, id) {
        let side = facade(scene, bodies, side)?;
        let (stands, axes): (DVec3, DMat3) = placed_at(bodies, &side);
        home = stands;
        let normal = axes * side.face.normal;
        faces.push((normal, normal.dot(axes * side.face.corners[0])));
        corners.extend(side.face.corners.map(|corner| axes * corner));
        let [a, b, _, d] = side.face.corners;
        let upright = if scene.kind == Kind::Planar { f64::INFINITY } else { (d - a).length() };
        if scene.kind == Kind::Spatial {
            let ends = side.face.corners.iter().zip(side.face.corners.iter().cycle().skip(1));
            sides.extend(ends.map(|(from, to)| axes * (to - from).normalize_or_zero()));
        }
        least_side = least_side.min((b - a).length()).min(upright);
    }
    Ok(Solid::of(home, corners, faces, &sides, least_side))
}
