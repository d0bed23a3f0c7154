//! Two bodies that have met, between which every face can touch: as convex solids, whose faces' planes tell whether they
//! stand apart.

use glam::DVec3;

use crate::contact::Frame;
use crate::scene::facing::SolidId;

/// Two bodies between which every face can touch.
#[derive(Clone, Debug)]
pub struct Meeting {
    /// The two, as their pairs have them.
    pub ids: [SolidId; 2],
    /// Their shapes.
    pub solids: [Solid; 2],
    /// The smallest side of either \[m\].
    pub least_side: f64,
}

/// A convex body, about its G (an abutment's corner a) in the world's axes as placed.
#[derive(Clone, Debug)]
pub struct Solid {
    /// Where that stands as placed \[m\].
    home: DVec3,
    /// Corners \[m\].
    corners: Vec<DVec3>,
    /// Outward unit normal of each face, and its distance from the origin \[m\].
    faces: Vec<(DVec3, f64)>,
    /// Largest distance of a corner from the origin \[m\].
    pub radius: f64,
    /// Shortest side of a face \[m\]; in plan, of those along it.
    least_side: f64,
}

impl Meeting {
    /// Of two bodies.
    pub(in crate::dynamics) fn of(ids: [SolidId; 2], solids: [Solid; 2]) -> Self {
        let least_side = solids[0].least_side.min(solids[1].least_side);
        Self { ids, solids, least_side }
    }

    /// Largest distance by which all of one body is before the plane of a face of the other \[m\]; negative where there is no such
    /// face. The bodies are at least as far apart.
    pub fn apart(&self, poses: [&Frame; 2]) -> f64 {
        let [one, other] = &self.solids;
        let behind = |face: &Solid, node: &Solid, [at, from]: [&Frame; 2]| {
            let seen = node.seen_from(at, (face, from));
            let before = |&(normal, level): &(DVec3, f64)| {
                seen.iter().map(|corner| corner.dot(normal)).fold(f64::INFINITY, f64::min) - level
            };
            face.faces.iter().map(before).fold(f64::NEG_INFINITY, f64::max)
        };
        let [here, there] = poses;
        behind(one, other, [there, here]).max(behind(other, one, [here, there]))
    }

    /// How far the two overlap along a unit vector that points out of body `out`; negative apart \[m\].
    pub fn overlap_along(&self, axis: DVec3, out: usize, poses: [&Frame; 2]) -> f64 {
        let reach = |which: usize, sign: f64| {
            let (solid, pose) = (&self.solids[which], poses[which]);
            let along = solid.corners.iter().map(|&corner| sign * axis.dot(pose.turn(corner)));
            along.fold(f64::NEG_INFINITY, f64::max) + sign * axis.dot(solid.home + pose.shift)
        };
        reach(out, 1.0) + reach(1 - out, -1.0)
    }
}

impl Solid {
    /// A body that stands at `home` \[m\], by its faces' corners \[m\] and planes, and the shortest side of one \[m\].
    pub(in crate::dynamics) fn of(
        home: DVec3,
        mut corners: Vec<DVec3>,
        faces: Vec<(DVec3, f64)>,
        least_side: f64,
    ) -> Self {
        // Each corner is one of three faces, in plan of two.
        corners.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
        corners.dedup();
        let radius = corners.iter().map(|corner| corner.length()).fold(0.0, f64::max);
        Self { home, corners, faces, radius, least_side }
    }

    /// Corners about the origin of another body, in the axes that this one had as placed \[m\].
    fn seen_from(&self, own: &Frame, (other, from): (&Self, &Frame)) -> Vec<DVec3> {
        let apart = (self.home + own.shift) - (other.home + from.shift);
        let back = from.turned.transpose();
        self.corners
            .iter()
            .map(|&corner| {
                let at = apart + own.turn(corner);
                at + back * at
            })
            .collect()
    }
}
