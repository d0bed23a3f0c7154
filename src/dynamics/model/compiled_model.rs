//! A scene as constant data: what [`assembly`](crate::dynamics::model::assembly) compiles and every solver reads.

use std::ops::Range;

use glam::DVec3;

use crate::dynamics::connection::Link;
use crate::dynamics::model::body::Body;
use crate::dynamics::model::flexible::Flexible;
use crate::dynamics::model::meeting::Meeting;
use crate::dynamics::model::moving_ground::{Foundation, MovingGround};
use crate::dynamics::model::pair::{ContactSite, Pair};
use crate::motion::Ground;
use crate::scene::facing::{self, Side, SolidId};
use crate::scene::{DeviceId, ImpactSettings, Kind};

/// A backwall that moves: against the soil behind it, or with its ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Backwall {
    /// Its number among the bodies.
    pub body: usize,
    /// Number of the link that is the soil behind it; `None` where it moves with its ground.
    pub soil: Option<usize>,
    /// Unit vector into the soil, world axes.
    pub inward: DVec3,
}

/// A pier.
#[derive(Clone, Debug, PartialEq)]
pub struct Pier {
    /// Its number among the bodies.
    pub body: usize,
    /// Number of the link that is what yields of its base.
    pub yielding: Option<usize>,
    /// Numbers of the links that are the elastic part of its column, on a foot that moves; none where the column is the body's own.
    pub column: Range<usize>,
}

impl Pier {
    /// Whether a link is a part of this pier.
    pub fn has(&self, link: usize) -> bool {
        self.yielding == Some(link) || self.column.contains(&link)
    }
}

/// A scene, compiled.
#[derive(Clone, Debug)]
pub struct Model {
    /// Planar or spatial.
    pub kind: Kind,
    /// Duration \[s\].
    pub duration: f64,
    /// Local error per step, relative; less per step in runs of many thousands, whose errors add up.
    pub tolerance: f64,
    /// Whether steps end midway between two kinks of the ground's motion, too: of a run that another one is compared with, whose steps
    /// may be as long as the intervals of a record at every tolerance.
    pub halves_intervals: bool,
    /// Numbers of the impact model.
    pub impact: ImpactSettings,
    /// Memory of a run for steps as polynomials, beyond which steps are kept by their initial states \[bytes\].
    pub polynomial_bytes: usize,
    /// Memory of stored steps and events, of the contact model, at which a run ends \[bytes\].
    pub memory_bytes: usize,
    /// Gravity; 0 in a planar scene \[m/s²\].
    pub gravity: f64,
    /// Ground motion.
    pub ground: Ground,
    /// Motion of the supports relative to that ground, where they have one.
    pub moving: Option<MovingGround>,
    /// Girders, as numbered in the scene; then backwalls that move; then piers; then ground that moves otherwise.
    pub bodies: Vec<Body>,
    /// For each abutment of the scene its backwall; `None` for one that stands.
    pub walls: Vec<Option<Backwall>>,
    /// Piers, as numbered in the scene.
    pub piers: Vec<Pier>,
    /// Ground that moves otherwise than the ground of reference, but that of abutments, which is their backwall.
    pub foundations: Vec<Foundation>,
    /// For each girder how it bends; `None` for one that the scene has rigid.
    pub flexible: Vec<Option<Flexible>>,
    /// Facing pairs.
    pub pairs: Vec<Pair>,
    /// Declared nodes and faces: corners in the order of the pairs, then edge nodes.
    pub sites: Vec<ContactSite>,
    /// Bodies that have met; between them every face has a pair.
    pub meetings: Vec<Meeting>,
    /// Links: devices between two points.
    pub links: Vec<Link>,
    /// For each girder and bearing its links; none for one that is linear, stands on the ground and stays there.
    pub supports: Vec<Vec<Vec<usize>>>,
    /// Devices of the scene, in the order of [`Scene::devices`](crate::scene::Scene::devices).
    pub devices: Vec<ModelDevice>,
    /// Groups of bodies that a chain of pairs and links joins.
    pub groups: Vec<Group>,
}

/// Bodies that a chain of pairs and links joins, with these; no force acts between two groups.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Group {
    /// Numbers of its bodies, in rising order.
    pub bodies: Vec<usize>,
    /// Numbers of its facing pairs, in rising order.
    pub pairs: Vec<usize>,
    /// Numbers of its links, in rising order.
    pub links: Vec<usize>,
}

/// A device of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelDevice {
    /// Which.
    pub id: DeviceId,
    /// Its name.
    pub name: String,
    /// Its links: one, or one a side.
    pub links: Range<usize>,
}

impl Model {
    /// The girders, as numbered in the scene.
    pub fn girders(&self) -> &[Body] {
        let others = self.foundations.len() + self.piers.len() + self.walls.iter().flatten().count();
        &self.bodies[..self.bodies.len() - others]
    }

    /// Largest distance of a corner of a girder from its G, by which rotations move it \[m\].
    pub fn farthest_corner(&self) -> f64 {
        self.girders().iter().map(|body| body.radius).fold(0.0, f64::max)
    }

    /// The body that a side belongs to; `None` for an abutment that stands.
    pub fn body_of(&self, side: Side) -> Option<usize> {
        self.body_of_solid(side.solid())
    }

    /// The body that a solid is; `None` for an abutment that stands.
    pub fn body_of_solid(&self, solid: SolidId) -> Option<usize> {
        match solid {
            SolidId::Girder(number) => Some(number),
            SolidId::Abutment(number) => self.walls.get(number)?.map(|wall| wall.body),
        }
    }

    /// The model with corners alone as contact points, without edge nodes: for a method that has none of its own.
    #[must_use]
    pub fn of_corners(mut self) -> Self {
        // Edge nodes are behind the contacts of all pairs.
        self.sites.truncate(self.pairs.iter().map(|pair| pair.sites.end).max().unwrap_or(0));
        self.pairs.iter_mut().for_each(|pair| pair.edges = 0..0);
        self
    }

    /// Bodies that met without facing each other as placed, each two once, in order: between them every face can touch.
    pub fn bodies_met(&self) -> Vec<[SolidId; 2]> {
        facing::bodies_met(self.pairs.iter().filter(|pair| pair.met).map(|pair| (pair.first, pair.second)))
    }

    /// Number of the meeting of a pair's two bodies; `None` where they have not met.
    pub fn meeting_of(&self, pair: &Pair) -> Option<usize> {
        self.meetings.iter().position(|meeting| pair.is_between(meeting.ids))
    }

    /// The sections of their bodies that carry a contact's node and face.
    pub fn sections(&self, site: usize) -> [usize; 2] {
        let ContactSite { node_body, face_body, carriers, .. } = &self.sites[site];
        let section = |body: &Option<usize>, carrier| body.map_or(0, |b| self.bodies[b].section_of(carrier));
        [section(node_body, carriers[0]), section(face_body, carriers[1])]
    }
}
