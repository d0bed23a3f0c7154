//! A scene compiled for computing: bodies, faces, facing pairs, contacts, ground.

use crate::dynamics::model::contact_sites;

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::contact::parameters::reduced_mass;
use crate::contact::{Frame, Home, dashpots};
use crate::dynamics::model::bearing::{Bearing, PlanarBearings, Quantities, Standing, carry};
use crate::dynamics::model::rate_bounds::Quickness;
use crate::dynamics::penalty3d::collinear_island;
use crate::geometry::{Face, Prism};
use crate::motion::Ground;
use crate::scene::facing::{Facing, PairContact, Side};
use crate::scene::{Direction, Girder, ImpactSettings, Kind, Motion, Scene, SceneErrors, facing, placed};

/// A girder, compiled.
#[derive(Clone, Debug)]
pub struct Body {
    /// The girder's name.
    pub name: String,
    /// Its shape.
    pub prism: Prism,
    /// Where G is placed \[m\].
    pub home: DVec3,
    /// Girder axes as placed, in the columns, in the world.
    pub axes: DMat3,
    /// `m` \[kg\].
    pub mass: f64,
    /// `i²`, squared radius of gyration about the vertical \[m²\].
    pub gyration2: f64,
    /// Inertia about G in the body frame \[kg·m²\], and its inverse.
    pub inertia: [DMat3; 2],
    /// Largest distance of a corner from G \[m\].
    pub radius: f64,
    /// How fast it can answer.
    pub quickness: Quickness,
    /// What it stands on.
    pub bearings: Vec<Bearing>,
    /// Its weight on them; nothing in a planar scene.
    pub standing: Standing,
    /// The bearings over `(x, y, θ)`.
    pub planar: PlanarBearings,
    /// World directions it may move in: x, y, z, roll, pitch, yaw.
    pub free: [bool; 6],
    /// Constant force at G \[N\].
    pub push: DVec3,
    /// Constant moment about the vertical \[N·m\].
    pub moment: f64,
    /// For the world's x and y: whether nothing but a touch can drive it off that axis once it moves along it.
    pub straight: [bool; 2],
    /// Displacement and rotation at the start: x, y, z \[m\], θ \[rad\].
    pub start: [f64; 4],
    /// Velocity and spin at the start: x, y, z \[m/s\], ω \[rad/s\].
    pub start_rate: [f64; 4],
}

impl Body {
    /// (3), (4) of the girder in its own axes.
    pub fn quantities(&self) -> Quantities {
        Quantities::of(&self.bearings, self.mass, self.gyration2)
    }

    /// Pose and twist of a planar state `(x, y, θ, ẋ, ẏ, θ̇)`.
    #[inline]
    pub fn planar_frame(&self, state: &[f64]) -> Frame {
        // Most girders of a row never turn. Of half the angle, for the cosine less 1 without loss.
        let turned = if state[2] == 0.0 {
            DMat3::ZERO
        } else {
            let (s, c) = (0.5 * state[2]).sin_cos();
            let (sine, less) = (2.0 * s * c, -2.0 * s * s);
            DMat3::from_cols(DVec3::new(less, sine, 0.0), DVec3::new(-sine, less, 0.0), DVec3::ZERO)
        };
        Frame {
            home: self.home,
            shift: DVec3::new(state[0], state[1], self.start[2]),
            turned,
            velocity: DVec3::new(state[3], state[4], 0.0),
            spin: DVec3::new(0.0, 0.0, state[5]),
            level: true,
        }
    }
}

/// A facing pair, compiled.
#[derive(Clone, Debug)]
pub struct Pair {
    /// `deck+x|wall`.
    pub name: String,
    /// A girder's end.
    pub first: Side,
    /// A girder's end or an abutment.
    pub second: Side,
    /// The girders on both sides; nothing for an abutment.
    pub bodies: [Option<usize>; 2],
    /// The numbers in force.
    pub contact: PairContact,
    /// `C_n` of the pair (65) \[N·s/m\].
    pub c_n: f64,
    /// `C_t` of the pair (65) \[N·s/m\].
    pub c_t: f64,
    /// Gap along the first girder's axis as placed \[m\].
    pub gap: f64,
    /// Its contacts, numbers in [`Model::contacts`].
    pub contacts: std::ops::Range<usize>,
    /// Whether sliding has one direction only: the faces are vertical and nobody can move vertically, roll or pitch.
    pub one_way: bool,
}

/// A declared node and face (Fig. 24).
#[derive(Clone, Debug)]
pub struct ContactSite {
    /// `deck.corner1`, as tables call the node.
    pub node: String,
    /// Name of the face, `wall` or `deck-x`.
    pub face_name: Arc<str>,
    /// Its pair.
    pub pair: usize,
    /// The body that owns the node; nothing for an abutment's corner.
    pub node_body: Option<usize>,
    /// The node in its body's frame (about `fixed`, for an abutment) \[m\].
    pub point: DVec3,
    /// The body that owns the face; nothing for an abutment.
    pub face_body: Option<usize>,
    /// The face in its body's frame (about `fixed`, for an abutment).
    pub face: Face,
    /// Both as placed.
    pub home: Home,
    /// Where the frame of the abutment in this contact stands, if there is one \[m\].
    pub fixed: DVec3,
    /// That frame.
    pub stand: Frame,
}

impl ContactSite {
    /// Size that the node's coordinates on the face round with: of the face, and of either lever from G \[m\].
    pub fn reach(&self) -> f64 {
        self.face.size().max(self.point.length()).max(self.face.corners[0].length())
    }
}

/// A scene, compiled.
#[derive(Clone, Debug)]
pub struct Model {
    /// Planar or spatial.
    pub kind: Kind,
    /// How long \[s\].
    pub duration: f64,
    /// Local error per step, relative; less per step in runs of many thousands, whose errors add up.
    pub tolerance: f64,
    /// Numbers of the impact model.
    pub impact: ImpactSettings,
    /// What a run may keep as polynomials before its steps are kept by their starts \[bytes\].
    pub polynomials: usize,
    /// Gravity; 0 in a planar scene \[m/s²\].
    pub gravity: f64,
    /// Ground motion.
    pub ground: Ground,
    /// Girders, as numbered in the scene.
    pub bodies: Vec<Body>,
    /// Facing pairs.
    pub pairs: Vec<Pair>,
    /// Declared nodes and faces.
    pub contacts: Vec<ContactSite>,
    /// Groups of bodies that a chain of pairs joins, each in rising order: they never feel one another.
    pub groups: Vec<Vec<usize>>,
    /// Pairs of each group, in rising order.
    pub group_pairs: Vec<Vec<usize>>,
}

/// What a run may keep as polynomials \[bytes\]: the steps of an hour of shaking of a few girders.
const POLYNOMIALS: usize = 8 << 20;

impl Model {
    /// Compiles a scene that has been validated.
    ///
    /// # Errors
    /// What validation would have said about pairs and faces.
    pub fn compile(scene: &Scene) -> Result<Self, SceneErrors> {
        Self::of(scene, facing::find(scene)?)
    }

    /// The same, where it is known who faces whom.
    ///
    /// # Errors
    /// What validation would have said about faces.
    pub fn of(scene: &Scene, facings: Vec<Facing>) -> Result<Self, SceneErrors> {
        let ground = ground(&scene.motion);
        let straight = |mut body: Body| {
            body.straight = [0, 1].map(|axis| collinear_island::keeps(&body, &ground, axis));
            body
        };
        let bodies: Vec<Body> = scene.girders.iter().map(|g| straight(body(scene, g))).collect();
        let mut pairs = Vec::with_capacity(facings.len());
        let mut contacts = Vec::with_capacity(facings.len() * if scene.kind == Kind::Planar { 4 } else { 8 });
        for facing in facings {
            let from = contacts.len();
            let number = pairs.len();
            contact_sites::contacts(scene, &bodies, &facing, number, &mut contacts)?;
            let vertical = contacts[from..].iter().all(|site: &ContactSite| site.face.normal.z.abs() <= 1e-9);
            pairs.push(pair(scene.kind, vertical, &bodies, facing, from..contacts.len()));
        }
        let groups = groups(bodies.len(), &pairs);
        let group_pairs = group_pairs(bodies.len(), &groups, &pairs);
        Ok(Self {
            kind: scene.kind,
            duration: scene.duration,
            tolerance: scene.solver.tolerance,
            impact: scene.impact,
            polynomials: POLYNOMIALS,
            gravity: if scene.kind == Kind::Spatial { scene.gravity } else { 0.0 },
            ground,
            bodies,
            pairs,
            contacts,
            groups,
            group_pairs,
        })
    }
}

/// The ground motion of a scene.
fn ground(motion: &Motion) -> Ground {
    let direction = Ground::direction(motion.angle_deg());
    match motion {
        Motion::None => Ground::Still,
        Motion::Sine(sine) => Ground::Sine {
            amplitude: direction * sine.amplitude_si(),
            omega: std::f64::consts::TAU * sine.frequency_hz,
            phase: sine.phase_deg.to_radians(),
        },
        Motion::Record(record) => match record.series() {
            Some((dt, samples)) => Ground::record(direction, dt, samples.iter().map(|a| a * record.scale)),
            None => Ground::Still,
        },
    }
}

fn body(scene: &Scene, girder: &Girder) -> Body {
    let prism = girder.prism();
    let axes = placed::axes(girder);
    let resolved = girder.bearings.as_ref().map(|b| b.resolve(girder, scene.kind)).unwrap_or_default();
    let mut bearings: Vec<Bearing> = resolved
        .iter()
        .map(|b| Bearing {
            place: b.place,
            stiffness: b.stiffness.into(),
            damping: b.damping.into(),
            preload: DVec3::ZERO,
        })
        .collect();
    let standing = match scene.kind {
        Kind::Planar => Standing::default(),
        Kind::Spatial => carry(girder.mass * scene.gravity, &mut bearings, axes),
    };
    let gyration2 = prism.inertia_per_mass().z_axis.z;
    let inertia = prism.inertia_per_mass() * girder.mass;
    let initial = &girder.initial;
    let [x, y, z] = initial.displacement;
    let [vx, vy, vz] = initial.velocity;
    let free = free_directions(scene.kind, &girder.held);
    // A held direction keeps its place but has no speed.
    let rate = |direction: usize, v: f64| if free[direction] { v } else { 0.0 };
    let radius = prism.corners().iter().map(|c| c.length()).fold(0.0, f64::max);
    Body {
        quickness: Quickness::of(&prism, girder.mass, [radius, gyration2], free, &bearings),
        name: girder.name.clone(),
        home: girder.position.into(),
        mass: girder.mass,
        planar: PlanarBearings::gather(&bearings, axes),
        push: girder.push.force.into(),
        moment: girder.push.moment,
        start: [x, y, z, initial.rotation_deg.to_radians()],
        start_rate: [rate(0, vx), rate(1, vy), rate(2, vz), rate(5, initial.spin_deg_s.to_radians())],
        free,
        straight: [false; 2],
        inertia: [inertia, inertia.inverse()],
        radius,
        prism,
        axes,
        gyration2,
        bearings,
        standing,
    }
}

fn free_directions(kind: Kind, held: &[Direction]) -> [bool; 6] {
    let all = [Direction::X, Direction::Y, Direction::Z, Direction::Roll, Direction::Pitch, Direction::Yaw];
    all.map(|d| {
        let planar = matches!(d, Direction::X | Direction::Y | Direction::Yaw);
        !held.contains(&d) && (planar || kind == Kind::Spatial)
    })
}

fn pair(kind: Kind, vertical: bool, bodies: &[Body], facing: facing::Facing, contacts: std::ops::Range<usize>) -> Pair {
    let owner = |side: &Side| match side {
        Side::Girder(g, _) => Some(*g),
        Side::Abutment(_) => None,
    };
    let sides = [owner(&facing.first), owner(&facing.second)];
    let mass = |side: Option<usize>| side.map_or(f64::INFINITY, |b| bodies[b].mass);
    let numbers = &facing.contact;
    let dashpots = dashpots(
        numbers.stiffness,
        reduced_mass(mass(sides[0]), mass(sides[1])),
        numbers.restitution_normal,
        numbers.restitution_tangential,
    );
    let flat = |side: Option<usize>| side.is_none_or(|b| bodies[b].free[2..5] == [false; 3]);
    Pair {
        bodies: sides,
        c_n: dashpots.normal,
        c_t: dashpots.tangential,
        contacts,
        one_way: vertical && (kind == Kind::Planar || sides.into_iter().all(flat)),
        name: facing.name,
        first: facing.first,
        second: facing.second,
        contact: facing.contact,
        gap: facing.gap,
    }
}

/// Connected groups of bodies, by union of the pairs.
fn groups(count: usize, pairs: &[Pair]) -> Vec<Vec<usize>> {
    let mut root: Vec<usize> = (0..count).collect();
    for pair in pairs {
        if let [Some(a), Some(b)] = pair.bodies {
            let (a, b) = (root_of(&mut root, a), root_of(&mut root, b));
            root[a.max(b)] = a.min(b);
        }
    }
    let mut groups: Vec<Vec<usize>> = vec![Vec::new(); count];
    for body in 0..count {
        groups[root_of(&mut root, body)].push(body);
    }
    groups.retain(|group| !group.is_empty());
    groups
}

/// The pairs of each group: those of its bodies.
fn group_pairs(count: usize, groups: &[Vec<usize>], pairs: &[Pair]) -> Vec<Vec<usize>> {
    let mut home = vec![0; count];
    for (group, bodies) in groups.iter().enumerate() {
        for &body in bodies {
            home[body] = group;
        }
    }
    let mut found = vec![Vec::new(); groups.len()];
    for (number, pair) in pairs.iter().enumerate() {
        // Two bodies of one pair are in one group.
        if let Some(body) = pair.bodies.into_iter().flatten().next() {
            found[home[body]].push(number);
        }
    }
    found
}

fn root_of(root: &mut [usize], mut i: usize) -> usize {
    while root[i] != i {
        root[i] = root[root[i]];
        i = root[i];
    }
    i
}
