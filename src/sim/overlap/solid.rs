//! Bodies as solids: girders as prisms that move, abutments as the blocks behind their faces; and how deep two overlap.

use std::collections::BTreeMap;

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::contact::node_face;
use crate::dynamics::Model;
use crate::geometry::shape::{
    AlignedBox, Convex, Hexahedron, Stand, block_behind, common_centre, plan_distance, plan_separation,
};
use crate::geometry::{End, Prism};
use crate::scene::facing::Side;
use crate::scene::{Kind, Scene, placed};
use crate::sim::History;
use crate::sim::report::{Motion, SolidId};

/// One body's shape.
#[derive(Debug)]
struct Solid {
    id: SolidId,
    /// Its number among the bodies of the run; `None` for an abutment that stands.
    body: Option<usize>,
    /// Corners, about the origin of its body in its axes, or in the world for an abutment that stands \[m\].
    corners: [DVec3; 8],
    /// The body as a convex one; only in space.
    convex: Option<Convex>,
    /// Largest distance of a corner from the origin of its body; 0 for what stands \[m\].
    radius: f64,
    /// Shortest edge \[m\].
    least_side: f64,
}

/// All bodies of a scene.
#[derive(Debug)]
pub(super) struct Solids {
    all: Vec<Solid>,
    kind: Kind,
}

/// The facing pairs of a model by the two bodies that each joins.
#[derive(Debug)]
pub(super) struct Joined(BTreeMap<[SolidId; 2], Vec<usize>>);

impl Joined {
    pub(super) fn of(model: &Model) -> Self {
        let mut joined: BTreeMap<[SolidId; 2], Vec<usize>> = BTreeMap::new();
        for (number, pair) in model.pairs.iter().enumerate() {
            let mut bodies = [pair.first, pair.second].map(Side::solid);
            bodies.sort();
            joined.entry(bodies).or_default().push(number);
        }
        Self(joined)
    }

    /// Numbers of the facing pairs that join two bodies, in the order of their numbers.
    pub(super) fn facing(&self, bodies: [SolidId; 2]) -> &[usize] {
        self.0.get(&bodies).map_or(&[], Vec::as_slice)
    }
}

/// Distances of a contact's node in plan \[m\].
#[derive(Clone, Copy, Debug)]
pub(super) struct NodeInPlan {
    /// From the body of its face, along the side that parts them most; negative inside.
    pub separation: f64,
    /// Before the plane of its face.
    pub gap: f64,
    /// Before the parallel plane through the farthest corner behind that; negative beyond the back of the body.
    pub before_back: f64,
}

/// Poses of two bodies.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    stands: [Stand; 2],
    /// Corners of what is not rigid, about G in girder axes \[m\].
    bent: [Option<[DVec3; 8]>; 2],
}

impl Solids {
    /// Of a scene: girders, then abutments.
    pub(super) fn of(scene: &Scene, model: &Model) -> Self {
        let girders = (0..model.girders().len()).map(SolidId::Girder);
        let ids = girders.chain((0..scene.abutments.len()).map(SolidId::Abutment));
        Self { all: ids.filter_map(|id| Solid::of(scene, model, id)).collect(), kind: scene.kind }
    }

    /// Two bodies alone.
    pub(super) fn pair(history: &History, ids: [SolidId; 2]) -> Self {
        let (scene, model) = (history.scene(), history.model());
        Self { all: ids.into_iter().filter_map(|id| Solid::of(scene, model, id)).collect(), kind: scene.kind }
    }

    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    pub(super) fn id(&self, number: usize) -> SolidId {
        self.all[number].id
    }

    /// Number among the bodies of the run, if it moves.
    pub(super) fn body(&self, number: usize) -> Option<usize> {
        self.all[number].body
    }

    pub(super) fn moves(&self, number: usize) -> bool {
        self.body(number).is_some()
    }

    /// Largest distance of a corner from G \[m\].
    pub(super) fn radius(&self, number: usize) -> f64 {
        self.all[number].radius
    }

    /// The smallest side of either body \[m\].
    pub(super) fn least_side(&self, pair: [usize; 2]) -> f64 {
        pair.map(|number| self.all[number].least_side).into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Box around a body that does not move.
    pub(super) fn fixed_box(&self, number: usize) -> AlignedBox {
        self.flat(AlignedBox::around(&self.all[number].corners))
    }

    /// In plan heights have no meaning.
    pub(super) fn flat(&self, hull: AlignedBox) -> AlignedBox {
        match self.kind {
            Kind::Planar => AlignedBox { min: hull.min.with_z(0.0), max: hull.max.with_z(0.0) },
            Kind::Spatial => hull,
        }
    }

    /// Two bodies as placed.
    pub(super) fn as_placed(&self, model: &Model, pair: [usize; 2]) -> Placed {
        Placed { stands: pair.map(|number| self.home(model, number)), bent: [None; 2] }
    }

    /// Box around a body as placed.
    pub(super) fn placed_box(&self, model: &Model, number: usize) -> AlignedBox {
        let home = self.home(model, number);
        self.flat(AlignedBox::around(&self.all[number].corners.map(|corner| home.place + home.attitude * corner)))
    }

    fn home(&self, model: &Model, number: usize) -> Stand {
        self.body(number).map_or(Stand::WORLD, |body| {
            let body = &model.bodies[body];
            Stand { place: body.home, attitude: DQuat::from_mat3(&body.axes) }
        })
    }

    /// Two bodies at `t`.
    pub(super) fn placed(&self, history: &History, pair: [usize; 2], t: f64) -> Placed {
        let stands = pair.map(|number| self.stand(history, number, t));
        let bent = [0, 1].map(|i| self.bent(history, (pair[i], stands[i]), t));
        Placed { stands, bent }
    }

    /// Corners of a body whose ends move on their own, about its G in its axes \[m\].
    fn bent(&self, history: &History, (number, stand): (usize, Stand), t: f64) -> Option<[DVec3; 8]> {
        let body = self.body(number).filter(|&body| history.model().bodies[body].sections() > 1)?;
        let mut corners = self.all[number].corners;
        let back = stand.attitude.inverse();
        for end in End::BOTH {
            let motion = history.end_motion(body, end, t);
            for corner in Prism::end_corners(end).into_iter().flat_map(|corner| [corner, corner + 4]) {
                corners[corner] = back * (motion.place - stand.place + motion.attitude * corners[corner]);
            }
        }
        Some(corners)
    }

    /// Corners of a rigid body at `t`, in the world \[m\].
    #[cfg(test)]
    pub(super) fn corners(&self, history: &History, number: usize, t: f64) -> [DVec3; 8] {
        let stand = self.stand(history, number, t);
        self.all[number].corners.map(|corner| stand.place + stand.attitude * corner)
    }

    fn stand(&self, history: &History, number: usize, t: f64) -> Stand {
        self.body(number).map_or(Stand::WORLD, |body| {
            // Without the half turns that its angle counts.
            let motion = Motion::of(history.model(), body, &history.state(body, t));
            Stand { place: motion.place, attitude: motion.attitude }
        })
    }

    /// Distance of two bodies along the axis that parts them most; negative when they overlap, and then the shortest way out \[m\].
    pub(super) fn separation(&self, pair: [usize; 2], placed: &Placed) -> f64 {
        let [one, other] = pair.map(|number| &self.all[number]);
        let [here, there] = placed.stands;
        let [a, b] = &placed.bent;
        if let (Kind::Spatial, Some(own), Some(others)) = (self.kind, &one.convex, &other.convex) {
            let [a, b] = [a, b].map(|bent| bent.map(Hexahedron::between));
            return a.as_ref().unwrap_or(own.prism()).separation(here, b.as_ref().unwrap_or(others.prism()), there);
        }
        plan_separation(&one.plan(here, a.as_ref()), &other.plan(there, b.as_ref()))
    }

    /// A contact's node in plan at `t`; infinitely far from a face of neither body.
    pub(super) fn node(&self, history: &History, pair: [usize; 2], contact: usize, t: f64) -> NodeInPlan {
        let model = history.model();
        let site = &model.sites[contact];
        let [node, face] = history.trajectories.sides(contact, t);
        let axes = |body: Option<usize>| body.map_or(DMat3::IDENTITY, |body| model.bodies[body].axes);
        let (own, others) = (axes(site.node_body), axes(site.face_body));
        let owner = |&number: &usize| self.body(number) == site.face_body;
        let Some(other) = pair.into_iter().find(owner).map(|number| &self.all[number]) else {
            return NodeInPlan { separation: f64::INFINITY, gap: f64::INFINITY, before_back: f64::INFINITY };
        };
        let polygon = match site.face_body {
            Some(_) => other.outline(None).map(|corner| (face.origin() + face.turn(others * corner)).truncate()),
            None => other.outline(None).map(DVec3::truncate),
        };
        let point = (node.origin() + node.turn(own * site.point)).truncate();
        let gap = node_face::gap(&site.geometry, &node, &face)[0];
        let normal = face.turn(site.geometry.axes.z_axis).truncate();
        let before_back = polygon.iter().map(|corner| normal.dot(point - *corner)).fold(f64::NEG_INFINITY, f64::max);
        NodeInPlan { separation: plan_distance(&polygon, point), gap, before_back }
    }

    /// Centre of what two bodies share: of the polygon in plan, of the common box of both in height \[m\].
    pub(super) fn shared(&self, pair: [usize; 2], placed: &Placed) -> DVec3 {
        let corners: [[DVec3; 8]; 2] =
            [0, 1].map(|i| self.all[pair[i]].corners.map(|c| placed.stands[i].place + placed.stands[i].attitude * c));
        let [a, b] = corners.map(|corners| self.flat(AlignedBox::around(&corners)));
        let middle = 0.5 * (a.min.max(b.min) + a.max.min(b.max));
        let [one, other] = [0, 1].map(|i| self.all[pair[i]].plan(placed.stands[i], placed.bent[i].as_ref()));
        common_centre(&one, &other).map_or(middle, |plan| plan.extend(middle.z))
    }
}

impl Solid {
    /// A body of a run; `None` for an abutment that faces no girder.
    fn of(scene: &Scene, model: &Model, id: SolidId) -> Option<Self> {
        match id {
            SolidId::Girder(number) => {
                let body = &model.bodies[number];
                Some(Self::new((id, Some(number)), body.prism.corners(), body.radius, model.kind))
            }
            SolidId::Abutment(number) => {
                let abutment = &scene.abutments[number];
                let block =
                    block_behind(placed::abutment_face(scene, abutment)?, placed::abutment_depth(scene, abutment));
                let Some(wall) = model.body_of_solid(id) else {
                    return Some(Self::new((id, None), block, 0.0, model.kind));
                };
                let corners = block.map(|corner| corner - model.bodies[wall].home);
                let radius = corners.iter().map(|corner| corner.length()).fold(0.0, f64::max);
                Some(Self::new((id, Some(wall)), corners, radius, model.kind))
            }
        }
    }

    fn new((id, body): (SolidId, Option<usize>), corners: [DVec3; 8], radius: f64, kind: Kind) -> Self {
        let edges = [corners[1] - corners[0], corners[3] - corners[0], corners[4] - corners[0]].map(DVec3::length);
        // Heights have no meaning in plan: of a girder the third edge, of an abutment the second.
        let counts = |&(i, _): &(usize, f64)| match (kind, id) {
            (Kind::Spatial, _) => true,
            (Kind::Planar, SolidId::Girder(_)) => i != 2,
            (Kind::Planar, SolidId::Abutment(_)) => i != 1,
        };
        let least_side =
            edges.into_iter().enumerate().filter(counts).map(|(_, edge)| edge).fold(f64::INFINITY, f64::min);
        let convex = (kind == Kind::Spatial).then(|| Convex::between(corners)).flatten();
        Self { id, body, corners, convex, radius, least_side }
    }

    /// Corners in plan, in the world, one after another along the outline \[m\]; of a `bent` body its own.
    fn plan(&self, stand: Stand, bent: Option<&[DVec3; 8]>) -> [DVec2; 4] {
        let turn = |corner: DVec3| if stand.attitude == DQuat::IDENTITY { corner } else { stand.attitude * corner };
        self.outline(bent).map(|corner| (stand.place + turn(corner)).truncate())
    }

    /// Corners one after another along the outline in plan, in the axes of its body, or the world for an abutment that stands \[m\].
    fn outline(&self, bent: Option<&[DVec3; 8]>) -> [DVec3; 4] {
        let outline = match self.id {
            SolidId::Girder(_) => [0, 1, 2, 3],
            // The lower edge of the face and, behind it, that of the back.
            SolidId::Abutment(_) => [4, 5, 1, 0],
        };
        outline.map(|i| bent.unwrap_or(&self.corners)[i])
    }
}
