//! Contact points of two facing ends in space: the vertices of the polygon in which the faces overlap, seen along the
//! normal (`docs/physics.md#edge-nodes`).

use glam::{DVec2, DVec3};

use crate::contact::parameters::edge_slack;
use crate::contact::{Frame, locate};
use crate::dynamics::model::edge_node::{Crossing, Edge};
use crate::dynamics::world::World;
use crate::dynamics::world::constants::ONE_VERTEX;

/// Poses of the node's and the face's body of a contact.
pub(in crate::dynamics) type Poses<'a> = &'a dyn Fn(usize) -> [Frame; 2];

/// The crossing of an edge node, unless it is beside the edges or at a corner that is over the facing polygon.
pub(in crate::dynamics) fn crossing(world: &World, contact: usize, poses: Poses<'_>) -> Option<Crossing> {
    let (crossing, at) = edge_vertex(world, contact, poses, slack(world, contact))?;
    is_free(world, contact, at, poses, 1.0).then_some(crossing)
}

/// The crossing of an edge node of bodies that have met, where the edges belong to the two faces; also of edges that bound a sliver.
pub(in crate::dynamics) fn crossing_of_met(world: &World, contact: usize, poses: Poses<'_>) -> Option<Crossing> {
    let edge = world.edge(contact).filter(|edge| edge.is_of_met())?;
    let [node, face] = poses(contact);
    edge.crossing([&node, &face], edge.tolerance).filter(|crossing| edge.is_between_faces(crossing, [&node, &face]))
}

/// Counts by which the contacts of a pair share its K and C.
pub(in crate::dynamics) struct Sharers {
    /// Nodes, in space vertices, of the pair.
    pub count: usize,
    /// For each contact the nodes at its vertex; 1 in plan.
    pub at_vertex: Vec<usize>,
}

/// Vertices of the polygon at which a pair touches, and nodes at them. A node that is at no vertex counts alone, one of two edge nodes
/// as that.
pub(in crate::dynamics) fn sharers(world: &World, pair: usize, poses: Poses<'_>) -> Sharers {
    let contacts = world.pairs[pair].contacts.clone();
    let near = one_vertex(world, pair);
    let corners = contacts.clone().filter_map(|c| Some((c, corner_vertex(world, c, poses, slack(world, c))?)));
    let mut vertices = gathered(corners, near);
    let crossings = contacts.clone().filter_map(|c| Some((c, edge_vertex(world, c, poses, slack(world, c))?.1)));
    let crossings: Vec<(usize, DVec2)> = crossings.collect();
    let seen = crossings.iter().map(|&crossing| (crossing.0, seen_once(world, &crossings, crossing)));
    let free = seen.filter(|(_, at)| vertices.iter().all(|vertex| (vertex.at - *at).length() > near));
    let free: Vec<(usize, DVec2)> = free.collect();
    vertices.extend(gathered(free.into_iter(), near));
    let nodes = |contact: usize| {
        let own = vertices.iter().find(|vertex| vertex.nodes.contains(&contact));
        own.map_or(if is_shared(world, contact) { 2 } else { 1 }, |vertex| vertex.nodes.len())
    };
    Sharers { count: vertices.len().max(1), at_vertex: contacts.map(nodes).collect() }
}

/// Place of a crossing; of two nodes at one crossing that of the first: of faces that are not parallel, two edges that are apart cross at
/// different places in each.
fn seen_once(world: &World, all: &[(usize, DVec2)], (node, at): (usize, DVec2)) -> DVec2 {
    let first = other_of_crossing(world, node).filter(|&other| other < node);
    first.and_then(|first| all.iter().find(|(other, _)| *other == first)).map_or(at, |(_, seen)| *seen)
}

/// The other of two nodes at one crossing, on the other edge: they are declared one after the other, that of the first side first.
pub(in crate::dynamics) fn other_of_crossing(world: &World, contact: usize) -> Option<usize> {
    is_shared(world, contact).then(|| if is_of_first(world, contact) { contact + 1 } else { contact - 1 })
}

/// Nodes of a vertex of two faces that overlap.
pub(in crate::dynamics) struct NodesAtVertex {
    /// Nodes that are at the vertex: corners inside the facing polygon, or crossings of edges that are at no corner.
    pub present: Vec<usize>,
    /// Closed nodes that have left the vertex.
    pub gone: Vec<usize>,
}

/// Nodes at the vertex that the node of `contact` has left. With an `extra` distance \[m\] the nearest vertex within that counts; a node may be
/// `beyond` \[m\] beyond the ends of its edges or beside its face.
pub(in crate::dynamics) fn at_vertex_of(
    world: &World,
    contact: usize,
    [extra, beyond]: [f64; 2],
    poses: Poses<'_>,
) -> NodesAtVertex {
    let pair = world.contacts[contact].pair;
    let (left, other) = (point_on_second_face(world, contact, poses), other_of_crossing(world, contact));
    let near =
        one_vertex(world, pair) + extra + if world.edge(contact).is_some() { slide(world, contact) } else { 0.0 };
    let here = |c: usize| {
        let at = if world.edge(c).is_some() {
            edge_vertex(world, c, poses, beyond).map(|(_, at)| at).filter(|&at| is_free(world, c, at, poses, 0.0))
        } else {
            corner_vertex(world, c, poses, beyond)
        };
        let at = at?;
        // The other node of the same crossing is at the vertex, at whatever place its own face has the crossing.
        let distance = if other == Some(c) { 0.0 } else { (at - left).length() };
        (c != contact && distance <= near).then_some((c, distance))
    };
    let contacts = world.pairs[pair].contacts.clone();
    let all: Vec<(usize, f64)> = contacts.clone().filter_map(here).collect();
    let nearest = all.iter().map(|(_, distance)| *distance).fold(f64::INFINITY, f64::min);
    let counts = |&(c, distance): &(usize, f64)| (extra == 0.0 || distance == nearest).then_some(c);
    let present: Vec<usize> = all.iter().filter_map(counts).collect();
    let gone = |&c: &usize| {
        let near = near + if world.edge(c).is_some() { slide(world, c) } else { 0.0 };
        let is_closed = world.is_closed(c);
        is_closed
            && !present.contains(&c)
            && (other == Some(c) || (point_on_second_face(world, c, poses) - left).length() <= near)
    };
    let gone = contacts.filter(gone).collect();
    NodesAtVertex { present, gone }
}

/// Whether a node in contact is at the vertex of a corner that is inside the facing polygon, up to `apart` \[m\] from it; not so of an edge
/// node.
pub(in crate::dynamics) fn is_held(world: &World, contact: usize, apart: f64, poses: Poses<'_>) -> bool {
    let pair = world.contacts[contact].pair;
    let Some(at) = corner_vertex(world, contact, poses, slack(world, contact)) else { return false };
    let near = |c: usize| one_vertex(world, pair) + apart + if world.edge(c).is_some() { slide(world, c) } else { 0.0 };
    let mut contacts = world.pairs[pair].contacts.clone().filter(|&c| c != contact);
    contacts.any(|c| world.is_closed(c) && (point_on_second_face(world, c, poses) - at).length() <= near(c))
}

/// Whether no corner over the facing polygon is at a crossing.
fn is_free(world: &World, contact: usize, at: DVec2, poses: Poses<'_>, tolerance: f64) -> bool {
    let pair = world.contacts[contact].pair;
    let near = one_vertex(world, pair);
    let is_at = |c: usize| {
        corner_vertex(world, c, poses, tolerance * slack(world, c)).is_some_and(|corner| (corner - at).length() <= near)
    };
    !world.pairs[pair].contacts.clone().any(is_at)
}

/// Place of a node on the second side's face \[m\].
fn point_on_second_face(world: &World, contact: usize, poses: Poses<'_>) -> DVec2 {
    let track = &world.contacts[contact];
    let site = &world.model.sites[track.site];
    if !is_of_first(world, contact) {
        let corner = || on_second_face(world, contact, site.point);
        return site.edge.as_ref().map_or_else(corner, |edge| edge.own_place(&track.place));
    }
    let [node, face] = poses(contact);
    site.on_face(&track.place, &locate(&site.geometry_at(&track.place), &node, &face))
}

/// Coordinates on the second side's face of a point of its body \[m\].
fn on_second_face(world: &World, contact: usize, point: DVec3) -> DVec2 {
    // The first contacts of a pair are the corners of its first side, against the face of the second.
    let first = world.model_pair(world.contacts[contact].pair).sites.start;
    world.model.sites[first].face.coordinates(point)
}

/// Largest distance of an edge node from its crossing \[m\].
fn slide(world: &World, contact: usize) -> f64 {
    world.edge(contact).map_or(0.0, |edge| edge.slide)
}

/// A vertex with its nodes.
struct Vertex {
    /// Place on the second side's face \[m\].
    at: DVec2,
    nodes: Vec<usize>,
}

/// Vertices of nodes at these places; places nearer than `near` \[m\] are one.
fn gathered(nodes: impl Iterator<Item = (usize, DVec2)>, near: f64) -> Vec<Vertex> {
    let mut vertices: Vec<Vertex> = Vec::new();
    for (node, at) in nodes {
        match vertices.iter_mut().find(|vertex| (vertex.at - at).length() <= near) {
            Some(vertex) => vertex.nodes.push(node),
            None => vertices.push(Vertex { at, nodes: vec![node] }),
        }
    }
    vertices
}

fn one_vertex(world: &World, pair: usize) -> f64 {
    let sites = &world.model.sites[world.model_pair(pair).sites.clone()];
    ONE_VERTEX * sites.iter().map(|site| site.face.size()).fold(f64::INFINITY, f64::min)
}

/// Distance beyond the ends of edges and beside faces that is round-off \[m\].
fn slack(world: &World, contact: usize) -> f64 {
    edge_slack(&world.site(contact).face)
}

/// Whether an edge node is one of two at its crossing.
fn is_shared(world: &World, contact: usize) -> bool {
    world.edge(contact).is_some_and(Edge::is_shared)
}

/// Whether a node is of the pair's first side, against the face of the second.
fn is_of_first(world: &World, contact: usize) -> bool {
    let track = &world.contacts[contact];
    track.slots[0] == world.pairs[track.pair].slots[0]
}

/// Place on the second side's face of a corner that is inside the facing polygon or up to `beyond` beside it \[m\];
/// `None` for an edge node and for a corner farther beside it.
fn corner_vertex(world: &World, contact: usize, poses: Poses<'_>, beyond: f64) -> Option<DVec2> {
    let site = world.site(contact);
    if site.edge.is_some() {
        return None;
    }
    let [node, face] = poses(contact);
    let at = locate(&site.geometry, &node, &face).at;
    if site.face.inset_at(at) < -beyond {
        return None;
    }
    Some(if is_of_first(world, contact) { at } else { on_second_face(world, contact, site.point) })
}

/// The crossing of an edge node up to `beyond` beyond the ends of the edges \[m\], and its place on the second side's face \[m\]; `None`
/// for a corner and for a crossing beside the edges.
fn edge_vertex(world: &World, contact: usize, poses: Poses<'_>, beyond: f64) -> Option<(Crossing, DVec2)> {
    let site = world.site(contact);
    let edge = site.edge.as_deref()?;
    let [node, face] = poses(contact);
    let crossing = edge.crossing([&node, &face], beyond)?;
    if edge.is_sliver(&crossing, [&node, &face]) || !edge.is_between_faces(&crossing, [&node, &face]) {
        return None;
    }
    Some((crossing, edge.on_face(&crossing, !is_of_first(world, contact))))
}

/// Poses of both bodies of a contact at `t` on the present trajectories.
pub(in crate::dynamics) fn poses_at(world: &World, contact: usize, t: f64) -> [Frame; 2] {
    [0, 1].map(|side| world.side(contact, side, t))
}
