//! Readings of a run at one instant: motion, contacts, events, energy. Plain data, SI, world frame.

use glam::{DMat3, DQuat, DVec3};

use crate::dynamics::Model;
pub use crate::dynamics::record::event::{Cause, Event, EventKind, Stop};

/// A body's motion at one instant, relative to the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Position of G \[m\].
    pub place: DVec3,
    /// Displacement of G from where it was placed \[m\].
    pub displacement: DVec3,
    /// Rotation about the vertical since placed, anticlockwise, counted beyond ±π (`docs/physics.md#motion-in-space`) \[rad\].
    pub theta: f64,
    /// Attitude, body to world, heading included.
    pub attitude: DQuat,
    /// Velocity of G \[m/s\].
    pub velocity: DVec3,
    /// Angular velocity in the world frame; z is the planar ω \[rad/s\].
    pub spin: DVec3,
}

impl Motion {
    /// Of a section of an elastic girder in a state as its integrator holds it: what a rigid girder that moves as the section does
    /// would do.
    pub(super) fn of_section(model: &Model, girder: usize, section: usize, state: &[f64]) -> Self {
        let body = &model.bodies[girder];
        let here = body.frame(section, state);
        // The frame of a section in space has its rotation as a matrix alone.
        let (theta, turned) = if here.level {
            (here.heading, DQuat::from_rotation_z(here.heading))
        } else {
            let rotation = here.rotation(&DMat3::IDENTITY);
            (rotation.x_axis.y.atan2(rotation.x_axis.x), DQuat::from_mat3(&rotation).normalize())
        };
        Self {
            place: here.origin(),
            displacement: here.shift,
            theta,
            attitude: turned * DQuat::from_mat3(&body.axes),
            velocity: here.velocity,
            spin: here.spin,
        }
    }

    /// Of a girder in a state as its integrator holds it.
    pub(super) fn of(model: &Model, girder: usize, state: &[f64]) -> Self {
        let body = &model.bodies[girder];
        let (here, (theta, turned)) = (body.frame(0, state), body.attitude(state));
        Self {
            place: here.origin(),
            displacement: here.shift,
            theta,
            attitude: turned * DQuat::from_mat3(&body.axes),
            velocity: here.velocity,
            spin: here.spin,
        }
    }
}

/// State of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ContactState {
    /// Not touching.
    Open,
    /// The anchor stays where it is on the face.
    Stick,
    /// The node slides along the face.
    Slip,
}

impl ContactState {
    /// The word used in tables and legends.
    pub fn label(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Stick => "stick",
            Self::Slip => "slip",
        }
    }
}

/// A closed contact at one instant. Forces act on the body that owns the node; the face's body gets the opposite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactNow {
    /// Its number in [`Model::sites`](crate::dynamics::Model::sites).
    pub contact: usize,
    /// The facing pair, its number in [`Model::pairs`](crate::dynamics::Model::pairs).
    pub pair: usize,
    /// Stick or slip.
    pub state: ContactState,
    /// `X_k`, the node \[m\].
    pub point: DVec3,
    /// Point of action on the face's body \[m\]: the anchor `X_p` in stick, the projection (paper) or the dragged anchor (return mapping)
    /// in slip; the node `X_k` for laws whose normal and tangential spring differ.
    pub anchor: DVec3,
    /// Outward unit normal of the face, towards the node's body.
    pub normal: DVec3,
    /// `δ = −g` \[m\].
    pub penetration: f64,
    /// `V_n = (V_k − V_p)·n` \[m/s\].
    pub normal_velocity: f64,
    /// `V_t`, the sliding velocity \[m/s\].
    pub sliding: DVec3,
    /// Elastic normal force `N(δ)` without the dashpot, `K δ` of a linear law; the reaction in the impact model \[N\].
    pub normal_force: f64,
    /// Tangential force without the dashpot: the tangential spring in stick, friction in slip \[N\].
    pub tangential_force: DVec3,
    /// Dashpot force along the normal, signed along `normal` \[N\].
    pub normal_damping: f64,
    /// Tangential dashpot force \[N\].
    pub tangential_damping: DVec3,
    /// `R_k`, all of it, on the body that owns the node \[N\].
    pub force: DVec3,
    /// Couple on that body beside it, the opposite one on the other: two edges across each other press where they cross, beside the node
    /// \[N·m\].
    pub couple: DVec3,
    /// `μ_s` in force.
    pub mu_static: f64,
    /// `μ_k` in force.
    pub mu_kinetic: f64,
}

impl ContactNow {
    /// Force without dashpots, `N(δ) n` plus the tangential force: the arrow that lies in the friction cone \[N\].
    pub fn elastic_force(&self) -> DVec3 {
        self.normal * self.normal_force + self.tangential_force
    }

    /// Friction coefficient in force: `μ_s` in stick and `μ_k` in slip.
    pub fn mu(&self) -> f64 {
        if self.state == ContactState::Stick { self.mu_static } else { self.mu_kinetic }
    }

    /// Part of the friction cone in use \[–\]: `|F_t| / (μ |F_n|)`; 1 at its rim.
    pub fn cone_use(&self) -> f64 {
        let limit = self.mu() * self.normal_force;
        if limit > 0.0 { self.tangential_force.length() / limit } else { 0.0 }
    }
}

/// One touch of one contact, from closing to opening.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// The facing pair.
    pub pair: usize,
    /// The contact.
    pub contact: usize,
    /// Closed at \[s\].
    pub start: f64,
    /// Opened at, or where the answer ends \[s\].
    pub end: f64,
    /// Time at which `|R_k|` is largest \[s\].
    pub peak_time: f64,
    /// Largest `|R_k|` \[N\].
    pub peak_force: f64,
    /// Impulse of a hit of the impact model; 0 where the touch takes its time \[N·s\].
    pub impulse: f64,
    /// Time spent in stick \[s\].
    pub stick: f64,
    /// Time spent in slip \[s\].
    pub slip: f64,
}

/// Difference of two runs, at an instant or the largest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RunDifference {
    /// In displacement of G \[m\].
    pub place: f64,
    /// In attitude \[rad\].
    pub turn: f64,
}

impl RunDifference {
    pub(super) fn larger(self, other: Self) -> Self {
        Self { place: self.place.max(other.place), turn: self.turn.max(other.turn) }
    }
}

/// An extreme and when it was reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// Its value, SI.
    pub value: f64,
    /// Time \[s\].
    pub t: f64,
}

/// Largest value of a girder over a run, of all girders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GirderExtreme {
    /// Number of the girder, the first one of equals.
    pub girder: usize,
    /// Value and its time.
    pub extreme: Extreme,
}

impl GirderExtreme {
    /// The larger of two values, the first one of equals.
    fn larger(self, other: Self) -> Self {
        if other.extreme.value > self.extreme.value { other } else { self }
    }
}

/// Largest motions of all girders over a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargestMotion {
    /// Displacement of G from where it was placed \[m\].
    pub displacement: GirderExtreme,
    /// Rotation |θ| \[rad\].
    pub rotation: GirderExtreme,
}

impl LargestMotion {
    /// The larger of two displacements and of two rotations, the first one of equals.
    pub(super) fn larger(self, other: Self) -> Self {
        Self {
            displacement: self.displacement.larger(other.displacement),
            rotation: self.rotation.larger(other.rotation),
        }
    }
}

/// The hits of two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Pounding {
    /// A pair between the two, the one of the least number.
    pub pair: usize,
    /// In order of time; never empty.
    pub hits: Vec<PoundingHit>,
}

/// A stretch of time in which a contact between two bodies is closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoundingHit {
    /// From \[s\].
    pub start: f64,
    /// To \[s\].
    pub end: f64,
    /// The largest |force| between the two, of all contacts together \[N\]; 0 of an impulse.
    pub peak: Extreme,
}

impl Pounding {
    /// The hardest hit's largest |force| \[N\].
    pub fn most(&self) -> Option<Extreme> {
        let peaks = self.hits.iter().map(|hit| hit.peak);
        peaks.reduce(|a, b| if b.value > a.value { b } else { a })
    }
}

pub use crate::scene::facing::SolidId;

/// Overlap of two bodies beyond what contacts between them carry.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlap {
    /// The two bodies.
    pub bodies: [SolidId; 2],
    /// From when to when, in order of time; never empty \[s\].
    pub intervals: Vec<[f64; 2]>,
    /// Its greatest depth, the shortest way out \[m\], and when.
    pub depth: Extreme,
    /// Place of the greatest depth: the centre of the intersection of the two bodies, world \[m\].
    pub place: DVec3,
}

impl Overlap {
    /// Time at which it was first seen \[s\].
    pub fn first(&self) -> f64 {
        self.intervals.first().map_or(self.depth.t, |interval| interval[0])
    }

    /// Whether it is there at `t` \[s\].
    pub fn lasts_at(&self, t: f64) -> bool {
        let begun = self.intervals.partition_point(|interval| interval[0] <= t);
        begun > 0 && t <= self.intervals[begun - 1][1]
    }
}

/// A bearing that stopped carrying.
#[derive(Clone, Debug, PartialEq)]
pub struct Uplift {
    /// The bearing, `deck.bearing1`.
    pub name: String,
    /// Time at which it first carried nothing \[s\].
    pub t: f64,
    /// The most that it held the girder down with: of one that lifts the pull of its dashpot while its spring is still pressed \[N\].
    pub pull: Extreme,
    /// Whether it lifts: linear bearings and lead rubber do not.
    pub lifts: bool,
    /// Its load at rest \[N\].
    pub load: f64,
}

/// Tilt and uplift of a girder in space.
#[derive(Clone, Debug, PartialEq)]
pub struct Upright {
    /// Largest angle of its vertical axis from the vertical \[rad\].
    pub tilt: Extreme,
    /// Its bearings that stopped carrying, the earliest first.
    pub uplifts: Vec<Uplift>,
}
