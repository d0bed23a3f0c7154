//! A scene compiled for computing: bodies, faces, facing pairs, contacts, ground.

use glam::DVec3;

use crate::contact::law_of_pair;
use crate::dynamics::model::bearing::{Bearing, PlanarBearings, UnbalancedWeight, carry};
use crate::dynamics::model::body::{Body, BodyCoordinates};
use crate::dynamics::model::compiled_model::{Backwall, Model};
use crate::dynamics::model::edge_sites::EdgePair;
use crate::dynamics::model::ground::compiled;
use crate::dynamics::model::met_solids::meetings;
use crate::dynamics::model::moving_ground::MovingGround;
use crate::dynamics::model::pair::{ContactSite, Pair};
use crate::dynamics::model::rate_bounds::RateBounds;
use crate::dynamics::model::rotation;
use crate::dynamics::model::single_axis::keeps_to_axis;
use crate::dynamics::model::{backwall, contact_sites, edge_sites, flexible, pier, supports};
use crate::scene::facing::{Facing, SolidId};
use crate::scene::{Between, Direction, Girder, Kind, MovingSupports, Scene, SceneErrors, StandsOn, facing, placed};

/// Memory of a run for steps as polynomials \[bytes\]: the steps of an hour of shaking of a few girders.
const POLYNOMIALS: usize = 8 << 20;
/// Memory at which a run ends \[bytes\]: five times what the largest measured row of 1000 girders takes (`docs/cost.md`), within a
/// desktop computer.
const MEMORY: usize = 2 << 30;

impl Model {
    /// Compiles a scene that has been validated.
    ///
    /// # Errors
    ///
    /// Those of validation for pairs and faces.
    pub fn compile(scene: &Scene) -> Result<Self, SceneErrors> {
        Self::of(scene, facing::find(scene)?)
    }

    /// Compiles a scene whose facing pairs are known.
    ///
    /// # Errors
    ///
    /// Those of validation for faces.
    pub fn of(scene: &Scene, facings: Vec<Facing>) -> Result<Self, SceneErrors> {
        let ground = compiled(&scene.motion);
        let straight = |mut body: Body| {
            body.keeps_to_axis = [0, 1].map(|axis| keeps_to_axis(&body, &ground, axis));
            body
        };
        let moving = MovingGround::of(scene, &ground);
        let supports = moving.as_ref().map(|moving| &moving.supports);
        let mut bodies: Vec<Body> = scene.girders.iter().map(|g| straight(body(scene, g, supports))).collect();
        supports::pressed(scene, &bodies)?;
        let flexible = flexible::add(scene, &facings, &mut bodies);
        let mut links = Vec::new();
        let walls = backwall::add(scene, moving.as_ref(), &mut bodies, &mut links)?;
        bodies.extend(pier::bodies(scene, supports));
        let mut pairs = Vec::with_capacity(facings.len());
        let mut sites = Vec::with_capacity(facings.len() * if scene.kind == Kind::Planar { 4 } else { 8 });
        let met = facing::bodies_met(facings.iter().filter(|f| f.met).map(|f| (f.first, f.second)));
        for facing in facings {
            let from = sites.len();
            let number = pairs.len();
            let have_met = met.binary_search(&[facing.first.solid(), facing.second.solid()]).is_ok();
            let beside = contact_sites::contacts(scene, &bodies, &facing, (number, have_met), &mut sites)?;
            let vertical = sites[from..].iter().all(|site: &ContactSite| site.face.has_level_normal());
            let pair = pair(scene, vertical, (&bodies, &walls), facing, from..sites.len());
            pairs
                .push(Pair { beside: if scene.contact.between == Between::All { beside } else { Vec::new() }, ..pair });
        }
        for (number, pair) in pairs.iter_mut().enumerate() {
            let from = sites.len();
            let have_met = met.binary_search(&[pair.first.solid(), pair.second.solid()]).is_ok();
            let edges = EdgePair { number, sides: pair.sides(), met: have_met };
            edge_sites::edge_nodes(scene, &bodies, edges, &mut sites)?;
            pair.edges = from..sites.len();
        }
        let meetings = meetings(scene, &bodies, &met)?;
        let mut model = Self {
            kind: scene.kind,
            duration: scene.duration,
            tolerance: scene.solver.tolerance,
            impact: scene.impact,
            polynomial_bytes: POLYNOMIALS,
            halves_intervals: false,
            memory_bytes: MEMORY,
            gravity: if scene.kind == Kind::Spatial { scene.gravity } else { 0.0 },
            ground,
            moving,
            bodies,
            walls,
            piers: Vec::new(),
            foundations: Vec::new(),
            flexible,
            pairs,
            sites,
            meetings,
            links,
            supports: Vec::new(),
            devices: Vec::new(),
            groups: Vec::new(),
        };
        model.stand_walls_on_their_ground();
        model.add_piers(scene);
        for (number, girder) in scene.girders.iter().enumerate() {
            model.add_supports(number, girder, scene.setting(), &scene.standing(girder));
        }
        model.add_devices(scene);
        supports::known_to_impact(scene, &model)?;
        model.regroup();
        Ok(model)
    }
}

fn body(scene: &Scene, girder: &Girder, moving: Option<&MovingSupports>) -> Body {
    let prism = girder.prism();
    let axes = placed::axes(girder);
    let resolved = girder.supports(scene.setting());
    let mut bearings: Vec<Bearing> = resolved
        .iter()
        .map(|b| Bearing {
            place: b.place,
            stiffness: b.stiffness.into(),
            damping: b.damping.into(),
            preload: DVec3::ZERO,
        })
        .collect();
    let unbalanced = match scene.kind {
        Kind::Planar => UnbalancedWeight::default(),
        Kind::Spatial => carry(girder.mass * scene.gravity, &mut bearings, axes),
    };
    // Bearings on piers, and on ground that moves otherwise, are links; here they carry the weight alone.
    let linked = |bearing: &Bearing, on: StandsOn| match on {
        StandsOn::Pier(_) => true,
        on => {
            let place = || DVec3::from(girder.position) + axes * bearing.place;
            moving.is_some_and(|moving| moving.under(on, place()).is_some())
        }
    };
    for (bearing, on) in bearings.iter_mut().zip(scene.standing(girder)) {
        if linked(bearing, on) {
            (bearing.stiffness, bearing.damping) = (DVec3::ZERO, DVec3::ZERO);
        }
    }
    let gyration2 = prism.inertia_per_mass().z_axis.z;
    let inertia = prism.inertia_per_mass() * girder.mass;
    let initial = &girder.initial;
    let [x, y, z] = initial.displacement;
    let [vx, vy, vz] = initial.velocity;
    let [roll, pitch, yaw] = initial.angles();
    let spin = rotation::angular_velocity(axes, [pitch, yaw], initial.angle_rates());
    let free = free_directions(scene.kind, &girder.held);
    // A held direction keeps its place but has no speed.
    let rate = |direction: usize, v: f64| if free[direction] { v } else { 0.0 };
    let coordinates = match scene.kind {
        Kind::Planar => BodyCoordinates::Planar,
        Kind::Spatial => BodyCoordinates::Spatial,
    };
    Body {
        rate_bounds: RateBounds::of(&prism, girder.mass, [prism.radius(), gyration2], free, &bearings),
        mass: girder.mass,
        planar: PlanarBearings::gather(&bearings, axes),
        push: girder.push.force.into(),
        moment: girder.push.moments().into(),
        start: [x, y, z, roll, pitch, yaw],
        start_rate: [rate(0, vx), rate(1, vy), rate(2, vz), rate(3, spin.x), rate(4, spin.y), rate(5, spin.z)],
        free,
        inertia,
        inverse_inertia: inertia.inverse(),
        axes,
        gyration2,
        bearings,
        unbalanced,
        ..Body::immovable(girder.name.clone(), coordinates, prism, girder.position.into())
    }
}

fn free_directions(kind: Kind, held: &[Direction]) -> [bool; 6] {
    let all = [Direction::X, Direction::Y, Direction::Z, Direction::Roll, Direction::Pitch, Direction::Yaw];
    all.map(|d| {
        let planar = matches!(d, Direction::X | Direction::Y | Direction::Yaw);
        !held.contains(&d) && (planar || kind == Kind::Spatial)
    })
}

fn pair(
    scene: &Scene,
    vertical: bool,
    (bodies, walls): (&[Body], &[Option<Backwall>]),
    facing: facing::Facing,
    sites: std::ops::Range<usize>,
) -> Pair {
    let sides = [facing.first, facing.second].map(|side| match side.solid() {
        SolidId::Girder(number) => Some(number),
        SolidId::Abutment(number) => walls[number].map(|wall| wall.body),
    });
    let numbers = &facing.contact;
    let flat = |side: Option<usize>| {
        // The ends of a girder that bends move and turn upwards although its mean axes are held flat.
        side.is_none_or(|b| {
            let body = &bodies[b];
            body.free[2..5] == [false; 3] && body.start[3..5] == [0.0; 2] && body.sections() == 1
        })
    };
    let planar = scene.kind == Kind::Planar;
    let one_way = vertical && (planar || sides.into_iter().all(flat));
    let law = law_of_pair(&numbers.law(facing.mass, one_way));
    Pair {
        bodies: sides,
        law,
        mass: facing.mass,
        sites,
        edges: 0..0,
        beside: Vec::new(),
        one_way,
        passes_on: !planar || scene.contact.between == Between::All,
        name: facing.name,
        first: facing.first,
        second: facing.second,
        contact: facing.contact,
        gap: facing.gap,
        met: facing.met,
    }
}
