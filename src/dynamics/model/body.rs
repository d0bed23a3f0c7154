//! A body as constant data: mass, inertia, bearings over `(x, y, θ)`, initial state; and what its degrees of freedom answer.
//!
//! The layout of a state is known to [`coordinates`](crate::dynamics::model::coordinates) alone: others ask [`Coordinates`] for poses,
//! rates, bounds and energies.

use std::fmt::Debug;
use std::ops::Range;
use std::sync::Arc;

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::contact::Frame;
use crate::dynamics::model::axial_motion::AxialMotion;
use crate::dynamics::model::bearing::{Bearing, BearingQuantities, PlanarBearings, UnbalancedWeight};
use crate::dynamics::model::closed_form::ClosedForm;
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::linear_block::part::LinearPart;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::rate_bounds::{ModalRates, RateBounds};
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::wrench::Wrench;
use crate::geometry::End;
use crate::geometry::Prism;
use crate::motion::Ground;
use crate::scene::facing::Flank;

/// A body of the model: a girder, a backwall that moves, a pier, or ground of given motion.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Its degrees of freedom.
    pub coordinates: BodyCoordinates,
    /// Its shape.
    pub prism: Prism,
    /// G as placed \[m\].
    pub home: DVec3,
    /// Its axes as placed, in the columns, in the world.
    pub axes: DMat3,
    /// `m` \[kg\].
    pub mass: f64,
    /// `i²`, squared radius of gyration about the vertical \[m²\].
    pub gyration2: f64,
    /// Tensor of inertia about G in the body frame \[kg·m²\].
    pub inertia: DMat3,
    /// Its inverse; 0 for a body that does not turn \[1/(kg·m²)\].
    pub inverse_inertia: DMat3,
    /// Largest distance of a corner from G \[m\].
    pub radius: f64,
    /// Upper bounds of its mobility and of its stiffness per inertia.
    pub rate_bounds: RateBounds,
    /// Bearings.
    pub bearings: Vec<Bearing>,
    /// Its weight on them; nothing in a planar scene.
    pub unbalanced: UnbalancedWeight,
    /// The bearings over `(x, y, θ)`.
    pub planar: PlanarBearings,
    /// World directions it may move in: x, y, z, roll, pitch, yaw.
    pub free: [bool; 6],
    /// Constant force at G \[N\].
    pub push: DVec3,
    /// Constant moment about the world's axes \[N·m\].
    pub moment: DVec3,
    /// For the world's x and y: whether nothing but a touch can drive it off that axis once it moves along it.
    pub keeps_to_axis: [bool; 2],
    /// Displacement at the start: x, y, z \[m\], roll, pitch, yaw \[rad\].
    pub start: [f64; 6],
    /// Velocity and angular velocity at the start, world axes \[m/s, rad/s\].
    pub start_rate: [f64; 6],
}

impl Body {
    /// A body of this shape that no force moves, at rest with G at `home` \[m\] and its axes those of the world: the ground, and what
    /// others begin from.
    pub(super) fn immovable(name: String, coordinates: BodyCoordinates, prism: Prism, home: DVec3) -> Self {
        Self {
            name,
            coordinates,
            home,
            axes: DMat3::IDENTITY,
            mass: f64::INFINITY,
            gyration2: 1.0,
            inertia: DMat3::IDENTITY,
            inverse_inertia: DMat3::ZERO,
            radius: prism.radius(),
            prism,
            rate_bounds: RateBounds { mobility: 0.0, stiffest: 0.0, modal: ModalRates::default() },
            bearings: Vec::new(),
            unbalanced: UnbalancedWeight::default(),
            planar: PlanarBearings::gather(&[], DMat3::IDENTITY),
            free: [false; 6],
            push: DVec3::ZERO,
            moment: DVec3::ZERO,
            keeps_to_axis: [false; 2],
            start: [0.0; 6],
            start_rate: [0.0; 6],
        }
    }

    /// (3), (4) of the girder in its own axes.
    pub fn quantities(&self) -> BearingQuantities {
        BearingQuantities::of(&self.bearings, self.mass, self.gyration2)
    }
}

/// The degrees of freedom of a body: one of those that exist.
#[derive(Clone, Debug)]
pub enum BodyCoordinates {
    /// A rigid girder in plan: `x, y, θ`.
    Planar,
    /// A rigid girder in space: displacement and quaternion.
    Spatial,
    /// Any others: a girder that bends, a backwall, moving ground, a body from outside this package. Not in the impact model.
    Custom(Arc<dyn Coordinates>),
}

/// Degrees of freedom of a body: the layout of its state, and its equation of motion.
///
/// A state has [`width`](Self::width) components: [`positions`](Self::positions), then velocities that carry them. It is counted
/// from where the body was placed, or, in contact, from a [`ReferencePose`].
///
/// Points belong to rigid *sections* of the body. The first one moves with G, those of the ends may be others; a rigid body has
/// one. The [`frame`](Self::frame) of a section is its rigid motion: a point that was at `l` from G as placed is at
/// `l + D l` from the frame's origin now, whichever section it belongs to. Forces act on sections.
pub trait Coordinates: Debug + Send + Sync {
    /// Components of the state.
    fn width(&self) -> usize;

    /// Number of positions; they come first.
    fn positions(&self) -> usize;

    /// Number of sections.
    fn sections(&self) -> usize {
        1
    }

    /// The section of the nodes and the face of an end.
    fn section(&self, _end: End) -> usize {
        0
    }

    /// The section of a face along the girder.
    fn flank(&self, _flank: Flank) -> usize {
        0
    }

    /// Components that are the displacement of every section along x, y and, in space, z; nothing where sections move apart.
    fn displacements(&self) -> Option<Range<usize>>;

    /// State at t = 0.
    fn initial(&self, body: &Body) -> Vec<f64>;

    /// Pose and twist of a section, of a state since the body was placed.
    fn frame(&self, body: &Body, section: usize, state: &[f64]) -> Frame;

    /// Pose and twist of a section counted from a reference pose, of a state that is.
    fn frame_since(&self, body: &Body, section: usize, state: &[f64]) -> Frame;

    /// Rotation about the vertical \[rad\], and attitude since the body was placed. Where the body has a
    /// [`heading`](Self::heading), the rotation is that of it, between −π and π.
    fn attitude(&self, body: &Body, state: &[f64]) -> (f64, DQuat);

    /// Whether the body has a [`heading`](Self::heading).
    fn has_heading(&self) -> bool {
        false
    }

    /// Horizontal part of the body's axis, along and across the axis as placed \[–\]; `None` where the state has the
    /// angle about the vertical as a component.
    fn heading(&self, _body: &Body, _state: &[f64]) -> Option<DVec2> {
        None
    }

    /// Reference pose by its [`numbers`](ReferencePose::numbers); by none, where the body was placed.
    fn reference(&self, body: &Body, numbers: &[f64]) -> ReferencePose;

    /// Converts a state relative to the placed pose into one relative to the present pose, which is returned.
    fn rebase(&self, body: &Body, state: &mut [f64]) -> ReferencePose;

    /// Converts a state relative to the reference pose of these numbers into one relative to the placed pose.
    fn restore(&self, numbers: &[f64], state: &mut [f64]);

    /// Rate of a state under the contact forces on each section and the ground's motion; bearings and given pushes are the body's own.
    fn slope(&self, body: &Body, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]);

    /// Whether a state has parts of given length, which [`normalise`](Self::normalise) restores.
    fn has_unit_parts(&self) -> bool {
        false
    }

    /// Restores the length of parts that have length 1.
    fn normalise(&self, _state: &mut [f64]) {}

    /// Adds `½ a dt²` to the positions of a state that moved on by `dt` \[s\] along `slope`, with its accelerations a.
    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64);

    /// Squared size of a difference of states: of its positions as lengths \[m²\], of its velocities \[m²/s²\]. NaN where a
    /// component is.
    fn size2(&self, body: &Body, difference: &[f64]) -> [f64; 2];

    /// Sets components of a difference to 0 that never change.
    fn hold(&self, _body: &Body, _difference: &mut [f64]) {}

    /// Size of component `i` of bodies of size `place` \[m\] with circular frequency `omega` \[rad/s\], for difference quotients.
    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64;

    /// Bound on the displacement of a point of any section at `arm` from G, where components `range` together are displaced by at most
    /// `way(range)` \[m\].
    fn excursion(&self, arm: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64;

    /// Bounds on the motion of any section, where rate and second derivative of components `range` together are at most `rates(range)`.
    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds;

    /// Acceleration of a point by a force that acts there \[m/s²\].
    fn acceleration(&self, body: &Body, point: Point<'_>, force: DVec3) -> DVec3;

    /// Response, which a force at a point adds to the rate of a state, and load, its generalised force: both as wide as a state, written over
    /// the velocities.
    fn port(&self, body: &Body, point: Point<'_>, force: DVec3, response_and_load: [&mut [f64]; 2]);

    /// The motion along a world axis, 0 or 1, of a body that bearings, pushes and ground never drive off that axis, nor turn.
    fn along(&self, _body: &Body, _axis: usize) -> Option<AxialMotion> {
        None
    }

    /// The free motion under a ground motion of a duration \[s\], where it has a closed form; a body without one is integrated alone.
    fn free_motion(&self, _ground: &Ground, _duration: f64) -> Option<Arc<dyn ClosedForm>> {
        None
    }

    /// The body as a part of a linear block; `None` where its motion is not linear.
    fn linear_part(&self, _body: &Body) -> Option<LinearPart> {
        None
    }

    /// The next time after `t` at which the rate of a state has a kink that the ground of reference has not \[s\].
    fn next_kink(&self, _t: f64) -> f64 {
        f64::INFINITY
    }

    /// Part of the velocity that is given as a function of time, whatever forces there are \[m/s\].
    fn given_velocity(&self, _state: &[f64]) -> DVec3 {
        DVec3::ZERO
    }

    /// Fastest circular frequency or decay rate of the free motion \[rad/s\].
    fn fastest(&self, body: &Body) -> f64;

    /// Energies of a state since the body was placed, under this `gravity` \[m/s²\].
    fn energies(&self, body: &Body, state: &[f64], gravity: f64) -> BodyEnergies;

    /// Powers on a body in this state and lost in its bearings.
    fn powers(&self, body: &Body, state: &[f64], ground: GroundNow) -> BodyPowers;

    /// Strain energy of the body itself \[J\].
    fn own_strain(&self, _state: &[f64]) -> f64 {
        0.0
    }

    /// Power lost in the body itself \[W\].
    fn own_loss(&self, _state: &[f64]) -> f64 {
        0.0
    }
}

/// Energies of a body, but that of its own strain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyEnergies {
    /// Kinetic energy \[J\].
    pub kinetic: f64,
    /// Strain energy of the bearings \[J\].
    pub bearings: f64,
    /// Potential of gravity \[J\].
    pub gravity: f64,
}

/// Powers on a body, but that lost in the body itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyPowers {
    /// Of the inertia force by the ground's acceleration \[W\].
    pub ground: f64,
    /// Of given pushes and moments \[W\].
    pub push: f64,
    /// Lost in the bearings \[W\].
    pub bearings: f64,
}

/// A point of a body.
#[derive(Clone, Copy, Debug)]
pub struct Point<'a> {
    /// Its section.
    pub section: usize,
    /// Pose of the section since the body was placed.
    pub frame: &'a Frame,
    /// From the frame's origin, world axes \[m\].
    pub arm: DVec3,
}

/// A state, what it is counted from, and the frames of its sections counted from there.
#[derive(Clone, Copy, Debug)]
pub struct Counted<'a> {
    /// Reference pose.
    pub base: &'a ReferencePose,
    /// [`frame_since`](Coordinates::frame_since) of each section.
    pub frames: &'a [Frame],
    /// State.
    pub state: &'a [f64],
}
