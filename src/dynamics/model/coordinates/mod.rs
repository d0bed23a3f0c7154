//! Degrees of freedom: how the state of a body is laid out and what moves it, for the bodies that exist.
//!
//! Implementations of [`Coordinates`], and their dispatch by a [`Body`]. A rigid girder has those of [`planar`] or [`spatial`]; those of
//! another body are one file with an implementation of the trait.

pub mod elastic;
pub mod elastic_space;
pub(in crate::dynamics) mod given_motion;
pub(in crate::dynamics) mod guided;
mod guided_flight;
pub(in crate::dynamics) mod guided_on_ground;
mod modal_amplitudes;
pub mod modal_springs;
pub mod planar;
pub mod section_forces;
pub mod spatial;
pub(in crate::dynamics) mod state_layout;

use std::ops::Range;

use glam::{DQuat, DVec2, DVec3};
use smallvec::SmallVec;

use crate::contact::Frame;
use crate::dynamics::model::axial_motion::AxialMotion;
use crate::dynamics::model::body::{Body, BodyCoordinates, BodyEnergies, BodyPowers, Coordinates, Counted, Point};
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::linear_block::part::LinearPart;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::pair::Carrier;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::wrench::Wrench;
use crate::geometry::End;
use planar::Planar;
use spatial::Spatial;

/// The state of one body; that of a rigid body takes no memory of the heap.
pub type BodyState = SmallVec<[f64; spatial::WIDTH]>;

/// The value of an expression for whichever degrees of freedom a body has.
macro_rules! of_each {
    ($body:expr, $coordinates:ident => $value:expr) => {
        match &$body.coordinates {
            BodyCoordinates::Planar => {
                let $coordinates = &Planar;
                $value
            }
            BodyCoordinates::Spatial => {
                let $coordinates = &Spatial;
                $value
            }
            BodyCoordinates::Custom($coordinates) => $value,
        }
    };
}

/// [`Coordinates`] of the body's kind, dispatched.
impl Body {
    /// [`Coordinates::width`].
    #[inline]
    pub fn width(&self) -> usize {
        of_each!(self, c => c.width())
    }

    /// [`Coordinates::positions`].
    #[inline]
    pub fn positions(&self) -> usize {
        of_each!(self, c => c.positions())
    }

    /// [`Coordinates::sections`].
    #[inline]
    pub fn sections(&self) -> usize {
        of_each!(self, c => c.sections())
    }

    /// [`Coordinates::section`].
    pub fn section(&self, end: End) -> usize {
        of_each!(self, c => c.section(end))
    }

    /// The section of an end or of a face along the girder.
    pub fn section_of(&self, carrier: Carrier) -> usize {
        match carrier {
            Carrier::End(end) => self.section(end),
            Carrier::Flank(flank) => of_each!(self, c => c.flank(flank)),
            Carrier::Abutment => 0,
        }
    }

    /// [`Coordinates::displacements`].
    #[inline]
    pub fn displacements(&self) -> Option<Range<usize>> {
        of_each!(self, c => c.displacements())
    }

    /// [`Coordinates::initial`].
    pub fn initial(&self) -> Vec<f64> {
        of_each!(self, c => c.initial(self))
    }

    /// Evaluates on a state that `read` writes, which is on the stack for a rigid body.
    #[inline]
    pub fn with_state<T>(&self, read: impl FnOnce(&mut [f64]), take: impl FnOnce(&[f64]) -> T) -> T {
        let through = |state: &mut [f64]| {
            read(state);
            take(state)
        };
        match &self.coordinates {
            BodyCoordinates::Planar => through(&mut [0.0; planar::WIDTH]),
            BodyCoordinates::Spatial => through(&mut [0.0; spatial::WIDTH]),
            BodyCoordinates::Custom(coordinates) => through(&mut vec![0.0; coordinates.width()]),
        }
    }

    /// [`Coordinates::frame`].
    #[inline]
    pub fn frame(&self, section: usize, state: &[f64]) -> Frame {
        of_each!(self, c => c.frame(self, section, state))
    }

    /// [`Coordinates::frame_since`].
    #[inline]
    pub fn frame_since(&self, section: usize, state: &[f64]) -> Frame {
        of_each!(self, c => c.frame_since(self, section, state))
    }

    /// [`Coordinates::frame_since`] of every section.
    #[inline]
    pub fn push_frames(&self, state: &[f64], frames: &mut Vec<Frame>) {
        of_each!(self, c => (0..c.sections()).for_each(|section| frames.push(c.frame_since(self, section, state))));
    }

    /// Appends one frame per section: [`Coordinates::frame_since`] of the `asked` ones, the placed one of the others, so that sections keep
    /// their numbers.
    #[inline]
    pub(in crate::dynamics) fn push_frames_of(&self, asked: &[bool], state: &[f64], frames: &mut Vec<Frame>) {
        of_each!(self, c => frames.extend(asked.iter().enumerate().map(|(section, asked)| {
            if *asked { c.frame_since(self, section, state) } else { Frame::fixed(self.home) }
        })));
    }

    /// [`Coordinates::attitude`].
    pub fn attitude(&self, state: &[f64]) -> (f64, DQuat) {
        of_each!(self, c => c.attitude(self, state))
    }

    /// [`Coordinates::has_heading`].
    #[inline]
    pub fn has_heading(&self) -> bool {
        of_each!(self, c => c.has_heading())
    }

    /// [`Coordinates::heading`].
    pub fn heading(&self, state: &[f64]) -> Option<DVec2> {
        of_each!(self, c => c.heading(self, state))
    }

    /// [`Coordinates::reference`] by no numbers.
    pub fn placed(&self) -> ReferencePose {
        self.reference(&[])
    }

    /// [`Coordinates::reference`].
    pub fn reference(&self, numbers: &[f64]) -> ReferencePose {
        of_each!(self, c => c.reference(self, numbers))
    }

    /// [`Coordinates::rebase`].
    pub fn rebase(&self, state: &mut [f64]) -> ReferencePose {
        of_each!(self, c => c.rebase(self, state))
    }

    /// [`Coordinates::restore`].
    pub fn restore(&self, numbers: &[f64], state: &mut [f64]) {
        of_each!(self, c => c.restore(numbers, state));
    }

    /// [`Coordinates::slope`].
    #[inline]
    pub fn slope(&self, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        of_each!(self, c => c.slope(self, now, contact, ground, out));
    }

    /// [`Coordinates::has_unit_parts`].
    #[inline]
    pub fn has_unit_parts(&self) -> bool {
        of_each!(self, c => c.has_unit_parts())
    }

    /// [`Coordinates::normalise`].
    #[inline]
    pub fn normalise(&self, state: &mut [f64]) {
        of_each!(self, c => c.normalise(state));
    }

    /// [`Coordinates::add_accelerations`].
    pub fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        of_each!(self, c => c.add_accelerations(state, slope, dt));
    }

    /// [`Coordinates::size2`].
    #[inline]
    pub fn size2(&self, difference: &[f64]) -> [f64; 2] {
        of_each!(self, c => c.size2(self, difference))
    }

    /// [`Coordinates::hold`].
    #[inline]
    pub fn hold(&self, difference: &mut [f64]) {
        of_each!(self, c => c.hold(self, difference));
    }

    /// [`Coordinates::increment_scale`].
    #[inline]
    pub fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        of_each!(self, c => c.increment_scale(i, place, omega))
    }

    /// [`Coordinates::excursion`].
    #[inline]
    pub fn excursion(&self, arm: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        of_each!(self, c => c.excursion(arm, way))
    }

    /// [`Coordinates::bounds`].
    #[inline]
    pub fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        of_each!(self, c => c.bounds(rates))
    }

    /// [`Coordinates::acceleration`].
    pub fn acceleration(&self, point: Point<'_>, force: DVec3) -> DVec3 {
        of_each!(self, c => c.acceleration(self, point, force))
    }

    /// [`Coordinates::port`].
    pub fn port(&self, point: Point<'_>, force: DVec3, response_and_load: [&mut [f64]; 2]) {
        of_each!(self, c => c.port(self, point, force, response_and_load));
    }

    /// [`Coordinates::along`].
    pub fn along(&self, axis: usize) -> Option<AxialMotion> {
        of_each!(self, c => c.along(self, axis))
    }

    /// [`Coordinates::fastest`].
    pub fn fastest(&self) -> f64 {
        of_each!(self, c => c.fastest(self))
    }

    /// [`Coordinates::energies`].
    pub fn energies(&self, state: &[f64], gravity: f64) -> BodyEnergies {
        of_each!(self, c => c.energies(self, state, gravity))
    }

    /// [`Coordinates::given_velocity`].
    pub fn given_velocity(&self, state: &[f64]) -> DVec3 {
        of_each!(self, c => c.given_velocity(state))
    }

    /// [`Coordinates::powers`].
    pub fn powers(&self, state: &[f64], ground: GroundNow) -> BodyPowers {
        of_each!(self, c => c.powers(self, state, ground))
    }

    /// [`Coordinates::own_strain`].
    pub fn own_strain(&self, state: &[f64]) -> f64 {
        of_each!(self, c => c.own_strain(state))
    }

    /// [`Coordinates::linear_part`].
    pub fn linear_part(&self) -> Option<LinearPart> {
        of_each!(self, c => c.linear_part(self))
    }

    /// [`Coordinates::own_loss`].
    pub fn own_loss(&self, state: &[f64]) -> f64 {
        of_each!(self, c => c.own_loss(state))
    }
}
