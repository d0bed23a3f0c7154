//! Two bodies that have met, between which every face can touch: as convex solids, whose faces' planes tell whether they
//! stand apart.

use glam::DVec3;
use smallvec::SmallVec;

use crate::contact::Frame;
use crate::scene::facing::SolidId;

/// Sine of the angle between two edges of a body that are parallel \[–\]: round-off of their directions.
const PARALLEL: f64 = 1e-9;

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

/// A convex body, about its G (an abutment's corner a) in the world's axes as placed. Corners, faces and edges are of sections, each
/// with a pose of its own: of a rigid body of one, of a girder that bends corners of the end sections, and faces along the girder of
/// sections that follow them.
#[derive(Clone, Debug)]
pub struct Solid {
    /// Origin of the body's frame as placed \[m\].
    home: DVec3,
    /// Numbers of its sections, in the order in which their poses are given.
    sections: SmallVec<[usize; 1]>,
    /// Corners \[m\], by their place in `sections`.
    corners: Vec<(usize, DVec3)>,
    /// Outward unit normal of each face, and its distance from the origin \[m\].
    faces: Vec<(usize, DVec3, f64)>,
    /// Unit vectors along its edges, of parallel ones of a section one; none in plan.
    edges: Vec<(usize, DVec3)>,
    /// Largest distance of a corner from the origin \[m\].
    pub radius: f64,
    /// Shortest side of a face \[m\]; in plan, of those along it.
    least_side: f64,
}

/// Poses of a body's sections.
pub type SectionPoses = SmallVec<[Frame; 1]>;

/// Geometry of a solid: corners \[m\], faces as outward unit normal and distance from the origin \[m\], unit vectors along the sides; each
/// with the number of its section.
#[derive(Clone, Debug, Default)]
pub(in crate::dynamics) struct SolidGeometry {
    pub corners: Vec<(usize, DVec3)>,
    pub faces: Vec<(usize, DVec3, f64)>,
    pub sides: Vec<(usize, DVec3)>,
}

impl Meeting {
    /// Of two bodies.
    pub(in crate::dynamics) fn of(ids: [SolidId; 2], solids: [Solid; 2]) -> Self {
        let least_side = solids[0].least_side.min(solids[1].least_side);
        Self { ids, solids, least_side }
    }

    /// Largest distance by which all of one body is before the plane of a face of the other \[m\]; negative where there is no such
    /// face. The bodies are at least as far apart.
    pub fn apart(&self, [here, there]: &[SectionPoses; 2]) -> f64 {
        let [one, other] = &self.solids;
        let behind = |face: &Solid, node: &Solid, [at, from]: [&SectionPoses; 2]| {
            let seen: SmallVec<[_; 1]> = from.iter().map(|from| node.seen_from(at, (face, from))).collect();
            let before = |&(section, normal, level): &(usize, DVec3, f64)| {
                seen[section].iter().map(|corner| corner.dot(normal)).fold(f64::INFINITY, f64::min) - level
            };
            face.faces.iter().map(before).fold(f64::NEG_INFINITY, f64::max)
        };
        behind(one, other, [there, here]).max(behind(other, one, [here, there]))
    }

    /// Overlap of the two along a unit vector that points out of body `out`; negative apart \[m\].
    pub fn overlap_along(&self, axis: DVec3, out: usize, poses: &[SectionPoses; 2]) -> f64 {
        let reach = |which: usize, sign: f64| {
            let (solid, poses) = (&self.solids[which], &poses[which]);
            let along = solid.corners.iter().map(|&(section, corner)| {
                let pose = &poses[section];
                sign * axis.dot(pose.turn(corner)) + sign * axis.dot(solid.home + pose.shift)
            });
            along.fold(f64::NEG_INFINITY, f64::max)
        };
        reach(out, 1.0) + reach(1 - out, -1.0)
    }

    /// Least overlap of the two over all directions, along the shortest way by which they part; negative apart \[m\]. Of convex polyhedra
    /// that direction is normal to a face of either or to an edge of each (separating axes).
    pub fn least_overlap(&self, poses: &[SectionPoses; 2]) -> f64 {
        let [one, other] = [0, 1].map(|which| self.solids[which].at(&poses[which]));
        let normals = [0, 1].map(|which| {
            let solid = &self.solids[which];
            solid.faces.iter().map(move |&(section, normal, _)| poses[which][section].turn(normal))
        });
        let reach = |corners: &[DVec3], axis: DVec3| {
            let along = corners.iter().map(|corner| axis.dot(*corner));
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], at| [least.min(at), most.max(at)])
        };
        let [of_one, of_other] = normals;
        let by_one = of_one.map(|axis| reach(&one, axis)[1] - reach(&other, axis)[0]);
        let by_other = of_other.map(|axis| reach(&other, axis)[1] - reach(&one, axis)[0]);
        let along = |which: usize| {
            let edges = self.solids[which].edges.iter();
            edges.map(move |&(section, edge)| poses[which][section].turn(edge))
        };
        let across = along(0).flat_map(|a| along(1).map(move |b| a.cross(b)));
        let by_edges = across.filter_map(DVec3::try_normalize).map(|axis| {
            let [[a, b], [c, d]] = [reach(&one, axis), reach(&other, axis)];
            (b - c).min(d - a)
        });
        by_one.chain(by_other).chain(by_edges).fold(f64::INFINITY, f64::min)
    }
}

impl Solid {
    /// A body that stands at `home` \[m\], by its faces and the shortest of their sides \[m\].
    pub(in crate::dynamics) fn of(home: DVec3, parts: SolidGeometry, least_side: f64) -> Self {
        let SolidGeometry { mut corners, mut faces, sides } = parts;
        let mut edges: Vec<(usize, DVec3)> = Vec::new();
        for (section, side) in sides {
            let is_other = |(own, edge): &(usize, DVec3)| *own != section || edge.cross(side).length() > PARALLEL;
            if edges.iter().all(is_other) {
                edges.push((section, side));
            }
        }
        // Each corner is one of three faces, in plan of two.
        corners.sort_by(|(_, a), (_, b)| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
        corners.dedup();
        let radius = corners.iter().map(|(_, corner)| corner.length()).fold(0.0, f64::max);
        let numbers = corners.iter().map(|corner| corner.0).chain(faces.iter().map(|face| face.0));
        let mut sections: SmallVec<[usize; 1]> = numbers.collect();
        sections.sort_unstable();
        sections.dedup();
        let corner_sections = corners.iter_mut().map(|corner| &mut corner.0);
        let face_sections = faces.iter_mut().map(|face| &mut face.0);
        for section in corner_sections.chain(face_sections).chain(edges.iter_mut().map(|edge| &mut edge.0)) {
            *section = sections.binary_search(section).unwrap_or(0);
        }
        Self { home, sections, corners, faces, edges, radius, least_side }
    }

    /// The poses of its sections by those of its body's.
    pub(in crate::dynamics) fn poses(&self, of_section: impl Fn(usize) -> Frame) -> SectionPoses {
        self.sections.iter().map(|&section| of_section(section)).collect()
    }

    /// Numbers of its sections.
    pub(in crate::dynamics) fn sections(&self) -> &[usize] {
        &self.sections
    }

    /// Its corners with these poses of its sections \[m\].
    fn at(&self, poses: &SectionPoses) -> Vec<DVec3> {
        let place = |&(section, corner): &(usize, DVec3)| {
            let pose = &poses[section];
            self.home + pose.shift + pose.turn(corner)
        };
        self.corners.iter().map(place).collect()
    }

    /// Corners about the origin of another body, in the axes that a section of this had as placed \[m\].
    fn seen_from(&self, own: &SectionPoses, (other, from): (&Self, &Frame)) -> Vec<DVec3> {
        let back = from.turned.transpose();
        self.corners
            .iter()
            .map(|&(section, corner)| {
                let own = &own[section];
                let apart = (self.home + own.shift) - (other.home + from.shift);
                let at = apart + own.turn(corner);
                at + back * at
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::turned_by;
    use glam::DQuat;
    use smallvec::smallvec;
    use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4, SQRT_2};

    /// A cube with sides of 1 m about the origin.
    fn cube() -> Solid {
        let corner = |i: u32| DVec3::from([0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -0.5 } else { 0.5 }));
        let parts = SolidGeometry {
            corners: (0..8).map(|i| (0, corner(i))).collect(),
            faces: DVec3::AXES.iter().flat_map(|&axis| [(0, axis, 0.5), (0, -axis, 0.5)]).collect(),
            sides: DVec3::AXES.map(|axis| (0, axis)).into(),
        };
        Solid::of(DVec3::ZERO, parts, 1.0)
    }

    fn overlap(shift: DVec3, turns: [DQuat; 2]) -> f64 {
        let meeting = Meeting::of([SolidId::Girder(0), SolidId::Girder(1)], [cube(), cube()]);
        let pose = |shift, turn| -> SectionPoses {
            smallvec![Frame { shift, turned: turned_by(turn), level: false, ..Frame::fixed(DVec3::ZERO) }]
        };
        let [one, other] = [pose(DVec3::ZERO, turns[0]), pose(shift, turns[1])];
        let there = meeting.least_overlap(&[one.clone(), other.clone()]);
        let back = meeting.least_overlap(&[other, one]);
        assert!((there - back).abs() < 1e-15, "whichever is the first: {there} and {back} m");
        there
    }

    #[test]
    fn bodies_part_along_a_face_s_normal_or_square_to_an_edge_of_each() {
        let near =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-14, "{found} m is not {expected} m");
        let still = [DQuat::IDENTITY; 2];
        near(overlap(DVec3::new(0.9, 0.3, -0.2), still), 0.1);
        near(overlap(DVec3::new(0.3, 0.2, 1.25), still), -0.25);
        // An upright edge against a face.
        let turned = [DQuat::IDENTITY, DQuat::from_rotation_z(FRAC_PI_4)];
        near(overlap(DVec3::X * 1.15, turned), 0.5 + FRAC_1_SQRT_2 - 1.15);
        // A level edge across an upright one: every face's normal is at 45° to the way out.
        let across = [DQuat::from_rotation_y(FRAC_PI_4), DQuat::from_rotation_z(FRAC_PI_4)];
        near(overlap(DVec3::X * 1.4, across), SQRT_2 - 1.4);
    }
}
