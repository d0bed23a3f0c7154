//! Anything of a run that can be plotted: a number as a function of time, with its name and its unit.
//!
//! Names are made of the scene's own: `deck.x`, `deck.corner1.drift`, `deck+x.seat`, `deck.moment_mid`, `deck+x|wall.force`,
//! `deck.corner2|wall.penetration`, `energy.friction`, `ground.x`. They are kept in scene files, so they do not change.

use glam::DVec3;

pub use super::energy::quantity::OfEnergy;
pub use super::sections::quantity::OfSection;
use super::{ContactNow, ContactState, History, Unit, energy, readings};
use crate::geometry::End;
use crate::scene::Kind;

/// A quantity of a girder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfGirder {
    /// Displacement of G along x.
    X,
    /// Displacement of G along y.
    Y,
    /// Displacement of G along z.
    Z,
    /// Rotation about the vertical since placed.
    Theta,
    /// Velocity of G along x.
    Vx,
    /// Velocity of G along y.
    Vy,
    /// Angular velocity about the vertical.
    Omega,
}

/// A quantity of a pier.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfPier {
    /// Displacement of its cap against its foot, in plan.
    Drift,
    /// Base shear, in plan.
    Shear,
    /// The part of the drift along or across the pier: 0 or 1.
    DriftAlong(usize),
    /// The part of the base shear along or across: 0 or 1.
    ShearAlong(usize),
}

/// A quantity of a corner of a girder in plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfCorner {
    /// Displacement along x.
    X,
    /// Displacement along y.
    Y,
    /// Distance from where it was placed, in plan.
    Drift,
}

/// A quantity of a facing pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfPair {
    /// Largest `|R_k|` of its contacts.
    Force,
    /// |Σ `R_k`| of all contacts between its two bodies.
    Total,
    /// Least gap of its nodes; negative in contact.
    Gap,
}

/// A quantity of a contact; 0 while it is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfContact {
    /// Elastic normal force `N(δ)`, without the dashpot; the reaction in the impact model.
    Normal,
    /// Tangential force without the dashpot, along the face's horizontal.
    Tangential,
    /// `|R_k|`.
    Force,
    /// `δ`.
    Penetration,
    /// Sliding speed.
    Sliding,
    /// `|F_t| / (μ |F_n|)`, with `μ_s` in stick and `μ_k` in slip.
    Use,
    /// 0 open, 1 stick, 2 slip.
    State,
}

/// A quantity of a bearing, along the girder's axes as placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfBearing {
    /// Deformation along x or y: 0 or 1.
    Deformation(usize),
    /// Resistance along x or y: 0 or 1.
    Force(usize),
    /// Vertical force on the girder, upwards, of spatial scenes.
    Load,
}

/// A quantity of a device between two points, or of soil behind a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfLink {
    /// Deformation along its axis.
    Deformation,
    /// Resistance along its axis.
    Force,
}

/// A number of a run as a function of time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Of a girder, a pier or a backwall, by the number of its body.
    Girder(usize, OfGirder),
    /// Of a girder's corner in plan, by both numbers.
    Corner(usize, usize, OfCorner),
    /// Remaining seat length under the end of a girder, square to its edge; of a seat without length, the distance of the end off it,
    /// negative.
    Seat(usize, End),
    /// Of a pier, by its number.
    Pier(usize, OfPier),
    /// Of a section of an elastic girder: its number, the number of the station among the five that are drawn.
    Section(usize, usize, OfSection),
    /// Of a facing pair, by its number.
    Pair(usize, OfPair),
    /// Of a contact, by its number.
    Contact(usize, OfContact),
    /// Of a girder's bearing, by both numbers.
    Bearing(usize, usize, OfBearing),
    /// Of a device or of soil, by its number among the model's links.
    Link(usize, OfLink),
    /// Of the energy ledger.
    Energy(OfEnergy),
    /// Acceleration of the ground along world x, y or z: 0, 1 or 2.
    Ground(usize),
}

const OF_GIRDER: [(&str, OfGirder); 7] = [
    ("x", OfGirder::X),
    ("y", OfGirder::Y),
    ("z", OfGirder::Z),
    ("theta", OfGirder::Theta),
    ("vx", OfGirder::Vx),
    ("vy", OfGirder::Vy),
    ("omega", OfGirder::Omega),
];
const OF_PIER: [(&str, OfPier); 6] = [
    ("drift", OfPier::Drift),
    ("shear", OfPier::Shear),
    ("drift-along", OfPier::DriftAlong(0)),
    ("drift-across", OfPier::DriftAlong(1)),
    ("shear-along", OfPier::ShearAlong(0)),
    ("shear-across", OfPier::ShearAlong(1)),
];
const OF_CORNER: [(&str, OfCorner); 3] = [("x", OfCorner::X), ("y", OfCorner::Y), ("drift", OfCorner::Drift)];
const OF_PAIR: [(&str, OfPair); 3] = [("force", OfPair::Force), ("total", OfPair::Total), ("gap", OfPair::Gap)];
const OF_CONTACT: [(&str, OfContact); 7] = [
    ("normal", OfContact::Normal),
    ("tangential", OfContact::Tangential),
    ("force", OfContact::Force),
    ("penetration", OfContact::Penetration),
    ("sliding", OfContact::Sliding),
    ("use", OfContact::Use),
    ("state", OfContact::State),
];
const OF_BEARING: [(&str, OfBearing); 5] = [
    ("x", OfBearing::Deformation(0)),
    ("y", OfBearing::Deformation(1)),
    ("force-x", OfBearing::Force(0)),
    ("force-y", OfBearing::Force(1)),
    ("force-z", OfBearing::Load),
];
const OF_LINK: [(&str, OfLink); 2] = [("deformation", OfLink::Deformation), ("force", OfLink::Force)];

impl Quantity {
    /// Every quantity of a run with its name, girders first; of pairs those that face each other or touched.
    pub fn all(history: &History) -> Vec<(String, Self)> {
        let model = history.model();
        let mut all = Vec::new();
        let pier = |body: usize| model.piers.iter().position(|pier| pier.body == body);
        for (i, body) in model.bodies.iter().enumerate() {
            let name = &body.name;
            // Given ground under bearings and feet has no quantities; an abutment that moves with its ground has a displacement alone.
            if model.foundations.iter().any(|foundation| foundation.body == i) {
                continue;
            }
            if model.moves_as_given(i) {
                let of_body = OF_GIRDER.into_iter().filter(|(_, what)| matches!(what, OfGirder::X | OfGirder::Y));
                all.extend(of_body.map(|(of, what)| (format!("{name}.{of}"), Self::Girder(i, what))));
                continue;
            }
            if let Some(number) = pier(i) {
                // It moves in plan.
                let of_body = OF_GIRDER.into_iter().filter(|(_, what)| *what != OfGirder::Z);
                all.extend(of_body.map(|(of, what)| (format!("{name}.{of}"), Self::Girder(i, what))));
                all.extend(OF_PIER.map(|(of, what)| (format!("{name}.{of}"), Self::Pier(number, what))));
                continue;
            }
            let of_body = OF_GIRDER.into_iter().filter(|(_, what)| model.kind == Kind::Spatial || *what != OfGirder::Z);
            all.extend(of_body.map(|(of, what)| (format!("{name}.{of}"), Self::Girder(i, what))));
            for corner in 0..4 {
                let of_corner = OF_CORNER
                    .map(|(of, what)| (format!("{name}.corner{}.{of}", corner + 1), Self::Corner(i, corner, what)));
                all.extend(of_corner);
            }
            let seats = End::BOTH.into_iter().filter(|end| has_seat(history, i, *end));
            all.extend(seats.map(|end| (format!("{name}{}.seat", end.label()), Self::Seat(i, end))));
            let sections = history.sections().quantities(i).into_iter();
            all.extend(sections.map(|(of, station, what)| (format!("{name}.{of}"), Self::Section(i, station, what))));
        }
        let listed = history.hits().listed_pairs();
        for (i, pair) in listed.iter().map(|&number| (number, &model.pairs[number])) {
            // A gap is a quantity of facing or declared pairs, not of pairs that were added because bodies met.
            let of_pair = OF_PAIR.into_iter().filter(|(_, what)| !(pair.met && *what == OfPair::Gap));
            all.extend(of_pair.map(|(of, what)| (format!("{}.{of}", pair.name), Self::Pair(i, what))));
        }
        for (i, site) in listed.iter().flat_map(|&pair| model.pairs[pair].sites.clone()).map(|i| (i, &model.sites[i])) {
            // A node of bodies that met is in a pair for each of its own faces.
            let pair = &model.pairs[site.pair];
            let by = if pair.met { format!(" of {}", pair.name) } else { String::new() };
            let name = format!("{}|{}{by}", site.node, site.face_name);
            all.extend(OF_CONTACT.map(|(of, what)| (format!("{name}.{of}"), Self::Contact(i, what))));
        }
        for (i, body) in model.girders().iter().enumerate() {
            let bearings = (0..body.bearings.len()).flat_map(|n| OF_BEARING.map(|(of, what)| (n, of, what)));
            let known = bearings.filter(|(.., what)| model.kind == Kind::Spatial || *what != OfBearing::Load);
            let named =
                known.map(|(n, of, what)| (format!("{}.bearing{}.{of}", body.name, n + 1), Self::Bearing(i, n, what)));
            all.extend(named);
        }
        for (i, link) in model.links.iter().enumerate() {
            let of_bearing = |body: usize| {
                let own = |what: &str| link.name.starts_with(&format!("{}.{what}", model.bodies[body].name));
                own("bearing") || own("corner")
            };
            // The links of a bearing are in the bearing's quantities, those of a pier in its drift and shear; the drop watch of a corner has
            // no force.
            if !(link.bodies[0].is_some_and(of_bearing) || model.piers.iter().any(|pier| pier.has(i))) {
                all.extend(OF_LINK.map(|(of, what)| (format!("{}.{of}", link.name), Self::Link(i, what))));
            }
        }
        let energies = energy::quantity::named(history);
        all.extend(energies.map(|(of, what)| (format!("energy.{of}"), Self::Energy(what))));
        let axes = if model.kind == Kind::Spatial { 3 } else { 2 };
        let names = ["ground.x", "ground.y", "ground.z"].map(str::to_owned);
        all.extend(names.into_iter().take(axes).enumerate().map(|(axis, name)| (name, Self::Ground(axis))));
        all
    }

    /// The quantity of this name, where the run has it.
    pub fn find(history: &History, name: &str) -> Option<Self> {
        Self::all(history).into_iter().find(|(known, _)| known == name).map(|(_, quantity)| quantity)
    }

    /// Unit of its values.
    pub fn unit(self) -> Unit {
        use {OfContact as C, OfGirder as G, OfPair as P};
        match self {
            Self::Girder(_, G::X | G::Y | G::Z)
            | Self::Corner(..)
            | Self::Seat(..)
            | Self::Pier(_, OfPier::Drift | OfPier::DriftAlong(_))
            | Self::Pair(_, P::Gap)
            | Self::Contact(_, C::Penetration)
            | Self::Bearing(_, _, OfBearing::Deformation(_))
            | Self::Link(_, OfLink::Deformation) => Unit::Metre,
            Self::Girder(_, G::Theta) => Unit::Radian,
            Self::Girder(_, G::Vx | G::Vy) | Self::Contact(_, C::Sliding) => Unit::MetrePerSecond,
            Self::Girder(_, G::Omega) => Unit::RadianPerSecond,
            Self::Section(_, _, OfSection::Moment | OfSection::VerticalMoment | OfSection::Torque) => Unit::NewtonMetre,
            Self::Section(_, _, OfSection::Stress) => Unit::Pascal,
            Self::Section(_, _, OfSection::Axial | OfSection::Shear | OfSection::VerticalShear)
            | Self::Pair(_, P::Force | P::Total)
            | Self::Pier(_, OfPier::Shear | OfPier::ShearAlong(_))
            | Self::Contact(_, C::Normal | C::Tangential | C::Force)
            | Self::Bearing(_, _, OfBearing::Force(_) | OfBearing::Load)
            | Self::Link(_, OfLink::Force) => Unit::Newton,
            Self::Contact(_, C::Use | C::State) => Unit::One,
            Self::Energy(_) => Unit::Joule,
            Self::Ground(_) => Unit::MetrePerSecond2,
        }
    }

    /// Its value at `t`, SI; 0 for what the run does not have.
    pub fn at(self, history: &History, t: f64) -> f64 {
        let model = history.model();
        match self {
            Self::Girder(i, what) if i < model.bodies.len() => of_girder(history, i, what, t),
            Self::Corner(i, corner, what) if i < model.bodies.len() && corner < 4 => {
                let way = readings::corner_way(history, i, corner, t);
                match what {
                    OfCorner::X => way.x,
                    OfCorner::Y => way.y,
                    OfCorner::Drift => way.truncate().length(),
                }
            }
            Self::Seat(i, end) if i < model.bodies.len() => history.seats().remaining(i, end, t),
            Self::Pier(i, what) => history.connections().pier(i, t).map_or(0.0, |now| {
                let along = |vector: DVec3, axis: usize| vector.dot(history.scene().pier(i).axes.col(axis.min(1)));
                match what {
                    OfPier::Drift => now.displacement.truncate().length(),
                    OfPier::Shear => now.shear.truncate().length(),
                    OfPier::DriftAlong(axis) => along(now.displacement, axis),
                    OfPier::ShearAlong(axis) => along(now.shear, axis),
                }
            }),
            Self::Section(i, station, what) => history.sections().quantity(i, station, what, t),
            Self::Pair(i, what) if i < model.pairs.len() => match what {
                OfPair::Gap => readings::gap(history, i, t),
                OfPair::Total => history.hits().resultant(i, t).length(),
                OfPair::Force => model.pairs[i]
                    .nodes()
                    .filter_map(|c| history.contacts().contact_at(c, t))
                    .map(|c| c.force.length())
                    .fold(0.0, f64::max),
            },
            Self::Contact(i, what) if i < model.sites.len() => {
                history.contacts().contact_at(i, t).map_or(0.0, |now| of_contact(&now, what))
            }
            Self::Bearing(girder, number, what) => {
                let along = || history.connections().bearing_loop(girder, number, t);
                match what {
                    OfBearing::Deformation(axis) => along().map_or(0.0, |now| now.deformation[axis.min(1)]),
                    OfBearing::Force(axis) => along().map_or(0.0, |now| now.resistance[axis.min(1)]),
                    OfBearing::Load => history.seats().bearing_load(girder, number, t),
                }
            }
            Self::Link(number, what) => history.connections().link(number, t).map_or(0.0, |now| match what {
                OfLink::Deformation => now.along.deformation[0],
                OfLink::Force => now.along.resistance[0],
            }),
            Self::Energy(what) => energy::quantity::at(history, what, t),
            Self::Ground(axis) => model.ground.acceleration(t)[axis.min(2)],
            Self::Girder(..) | Self::Corner(..) | Self::Seat(..) | Self::Pair(..) | Self::Contact(..) => 0.0,
        }
    }
}

fn of_girder(history: &History, i: usize, what: OfGirder, t: f64) -> f64 {
    let motion = history.motion(i, t);
    match what {
        OfGirder::X => motion.displacement.x,
        OfGirder::Y => motion.displacement.y,
        OfGirder::Z => motion.displacement.z,
        OfGirder::Theta => motion.theta,
        OfGirder::Vx => motion.velocity.x,
        OfGirder::Vy => motion.velocity.y,
        OfGirder::Omega => motion.spin.z,
    }
}

/// Whether a body is a girder with a seat under this end.
fn has_seat(history: &History, body: usize, end: End) -> bool {
    let seat = history.scene().girders.get(body).map(|girder| &girder.seat);
    seat.is_some_and(|seat| match end {
        End::Plus => seat.plus.is_some(),
        End::Minus => seat.minus.is_some(),
    })
}

fn of_contact(now: &ContactNow, what: OfContact) -> f64 {
    match what {
        OfContact::Normal => now.normal_force,
        OfContact::Tangential => now.tangential_force.dot(DVec3::Z.cross(now.normal)),
        OfContact::Force => now.force.length(),
        OfContact::Penetration => now.penetration,
        OfContact::Sliding => now.sliding.length(),
        OfContact::Use => now.cone_use(),
        OfContact::State => match now.state {
            ContactState::Open => 0.0,
            ContactState::Stick => 1.0,
            ContactState::Slip => 2.0,
        },
    }
}
