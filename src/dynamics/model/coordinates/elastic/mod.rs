//! An elastic girder in plan: `x, y, θ` of its mean axes since it was placed, the coordinates `q` of its modes, and their rates
//! (`docs/physics.md#flexible-girders`).
//!
//! The frame of an end section is exactly rigid: it turns by θ + φ, and forces on it do virtual work by that motion, so that energy
//! balances to rounding. Against displacements linear in φ it differs by φ²/2 of an offset.

mod bearings;
mod equilibrium;
pub(super) mod girder;
mod part;
pub(super) mod section;
mod turn;

use std::ops::Range;
use std::sync::Arc;

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::contact::Frame;
use crate::dynamics::model::axial_motion::AxialMotion;
use crate::dynamics::model::body::{Body, BodyEnergies, BodyPowers, Coordinates, Counted, Point};
use crate::dynamics::model::closed_form::ClosedForm;
use crate::dynamics::model::coordinates::planar;
use crate::dynamics::model::coordinates::section_forces::Bearer;
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::linear_block::part::{LinearPart, RIGID};
use crate::dynamics::model::linear_block::{BlockMember, LinearBlock};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::rigid_body;
use crate::dynamics::model::section_bounds::SectionBounds;
use crate::dynamics::model::wrench::Wrench;
use crate::geometry::End;
use crate::motion::Ground;
use crate::scene::facing::Flank;
pub(in crate::dynamics) use bearings::BearingAxis;
use girder::DEFORMED;
pub use girder::ElasticGirder;
use section::{SectionFrame, Turns};
use turn::{in_space, planar_turn};

/// Motion of a girder's section along an axis of a bearing.
pub(in crate::dynamics) struct AxisMotion<'a> {
    pub axis: &'a BearingAxis,
    /// Displacement \[m\].
    pub w: f64,
    /// Its rate \[m/s\].
    pub v: f64,
}

impl ElasticGirder {
    /// Places and rates of a state.
    pub(in crate::dynamics) fn halves<'a>(&self, state: &'a [f64]) -> (&'a [f64], &'a [f64]) {
        state.split_at(self.places())
    }

    fn pose(&self, height: f64, section: usize, state: &[f64]) -> Frame {
        let (place, rate) = self.halves(state);
        let (angle, spin) = (place[2], rate[2]);
        let mut frame = Frame {
            home: self.rigid.home,
            shift: DVec3::new(place[0], place[1], height),
            turned: DMat3::ZERO,
            heading: angle,
            velocity: DVec3::new(rate[0], rate[1], 0.0),
            spin: DVec3::Z * spin,
            level: true,
        };
        if let Some(end) = self.deforming(section) {
            let deformation = end.deformation(&place[RIGID..], &rate[RIGID..]);
            let turns = Turns::of(angle, deformation.of.z);
            let offset = end.offset(&turns, &deformation);
            frame.heading = angle + deformation.of.z;
            frame.turned = in_space(turns.whole);
            frame.shift += offset.extend(0.0);
            frame.velocity += end.velocity(&turns, offset, spin, deformation.rate).extend(0.0);
            frame.spin.z += deformation.rate.z;
        } else {
            frame.turned = in_space(planar_turn(angle));
        }
        frame
    }

    /// Generalised forces of wrenches on the sections, each about the origin of its frame.
    fn gather(&self, state: &[f64], wrenches: &[Wrench], out: &mut [f64]) {
        let (place, rate) = self.halves(state);
        for (section, wrench) in wrenches.iter().enumerate() {
            let (force, mut moment) = (wrench.force.truncate(), wrench.moment.z);
            if force == DVec2::ZERO && moment == 0.0 {
                continue;
            }
            if let Some(end) = self.deforming(section) {
                let load = match end.frame {
                    SectionFrame::Linear => end.load_unrotated(force, moment),
                    SectionFrame::Rigid => {
                        let deformation = end.deformation(&place[RIGID..], &rate[RIGID..]);
                        let turns = Turns::of(place[2], deformation.of.z);
                        let load = end.load(&turns, force, moment);
                        moment += end.offset(&turns, &deformation).perp_dot(force);
                        load
                    }
                };
                end.push(&load, &mut out[RIGID..]);
            }
            out[0] += force.x;
            out[1] += force.y;
            out[2] += moment;
        }
    }

    /// Adds what bearings, springs, dashpots and the given push do, of places since the girder was placed.
    fn resist(&self, place: &[f64], rate: &[f64], out: &mut [f64]) {
        self.rows.resist(place, rate, out);
        let modal = out[RIGID..].iter_mut().zip(self.springs.iter()).zip(place[RIGID..].iter().zip(&rate[RIGID..]));
        modal.for_each(|((out, [k, c]), (q, v))| *out -= k * q + c * v);
        let Body { push, moment, .. } = &self.rigid;
        out[0] += push.x;
        out[1] += push.y;
        out[2] += moment.z;
        out[RIGID..].iter_mut().zip(&self.pushed).for_each(|(out, push)| *out += push);
    }

    /// Accelerations by generalised forces and the ground; 0 where the girder is held.
    fn accelerate(&self, ground: DVec3, out: &mut [f64]) {
        // Of the modes the mass is 1.
        out.iter_mut().zip(self.masses()).take(RIGID).for_each(|(out, mass)| *out /= mass);
        out[0] -= ground.x;
        out[1] -= ground.y;
        for (i, free) in planar::free(&self.rigid).into_iter().enumerate() {
            if !free {
                out[i] = 0.0;
            }
        }
    }

    /// Accelerations of all coordinates in a state since the girder was placed, under wrenches on its sections and the ground.
    pub fn accelerations(&self, state: &[f64], wrenches: &[Wrench], ground: DVec3) -> Vec<f64> {
        let mut out = vec![0.0; self.places()];
        let (place, rate) = self.halves(state);
        self.gather(state, wrenches, &mut out);
        self.resist(place, rate, &mut out);
        self.accelerate(ground, &mut out);
        out
    }

    /// Motion along each axis of the bearings.
    pub(in crate::dynamics) fn on_bearings<'a>(
        &'a self,
        state: &'a [f64],
    ) -> impl Iterator<Item = AxisMotion<'a>> + 'a {
        let (place, rate) = self.halves(state);
        self.bearings.iter().map(move |axis| AxisMotion { axis, w: axis.along(place), v: axis.along(rate) })
    }
}

impl Coordinates for ElasticGirder {
    fn width(&self) -> usize {
        2 * self.places()
    }

    fn positions(&self) -> usize {
        self.places()
    }

    fn sections(&self) -> usize {
        1 + self.deforming.len()
    }

    fn section(&self, end: End) -> usize {
        match end {
            End::Minus => 1,
            End::Plus => 2,
        }
    }

    fn flank(&self, flank: Flank) -> usize {
        Bearer::section_of(flank, self.deforming.iter().map(|section| section.bearer))
    }

    fn displacements(&self) -> Option<Range<usize>> {
        None
    }

    fn initial(&self, body: &Body) -> Vec<f64> {
        let ([x, y, .., turn], [vx, vy, .., spin]) = (body.start, body.start_rate);
        let mut state = vec![0.0; self.width()];
        state[..RIGID].copy_from_slice(&[x, y, turn]);
        state[self.places()..][..RIGID].copy_from_slice(&[vx, vy, spin]);
        state
    }

    fn frame(&self, body: &Body, section: usize, state: &[f64]) -> Frame {
        self.pose(body.start[2], section, state)
    }

    fn frame_since(&self, _: &Body, section: usize, state: &[f64]) -> Frame {
        self.pose(0.0, section, state)
    }

    fn attitude(&self, _: &Body, state: &[f64]) -> (f64, DQuat) {
        (state[2], DQuat::from_rotation_z(state[2]))
    }

    // Counted from the place alone: the angle stays in the state, since deformations are seen in axes that turn by it.
    fn reference(&self, body: &Body, numbers: &[f64]) -> ReferencePose {
        let [x, y] = if let [x, y, ..] = *numbers { [x, y] } else { [0.0; 2] };
        ReferencePose::level(DVec3::new(x, y, body.start[2]), 0.0, DMat3::ZERO)
    }

    fn rebase(&self, body: &Body, state: &mut [f64]) -> ReferencePose {
        let base = self.reference(body, &[state[0], state[1]]);
        state[..2].fill(0.0);
        base
    }

    fn restore(&self, numbers: &[f64], state: &mut [f64]) {
        state[..2].iter_mut().zip(numbers).for_each(|(component, base)| *component += base);
    }

    fn slope(&self, _: &Body, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        let (places, gains) = out.split_at_mut(self.places());
        let (place, rate) = self.halves(now.state);
        gains.fill(0.0);
        self.gather(now.state, contact, gains);
        places.copy_from_slice(place);
        let base = now.base.planar();
        places[0] += base.x;
        places[1] += base.y;
        self.resist(places, rate, gains);
        self.accelerate(ground.acceleration, gains);
        places.copy_from_slice(rate);
        for (place, free) in places.iter_mut().zip(planar::free(&self.rigid)) {
            if !free {
                *place = 0.0;
            }
        }
    }

    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        let gains = &slope[self.places()..];
        state.iter_mut().zip(gains).for_each(|(place, gain)| *place += 0.5 * dt * dt * gain);
    }

    // A modal coordinate counts by √m: the mean square of the displacement that it is.
    fn size2(&self, body: &Body, difference: &[f64]) -> [f64; 2] {
        let (places, rates) = self.halves(difference);
        [places, rates].map(|half| {
            let (rigid, modal) = half.split_at(RIGID);
            let rigid: f64 = rigid.iter().zip(self.masses()).map(|(d, mass)| mass * d * d).sum();
            (rigid + modal.iter().map(|d| d * d).sum::<f64>()) / body.mass
        })
    }

    fn hold(&self, body: &Body, difference: &mut [f64]) {
        for (i, free) in planar::free(body).into_iter().enumerate() {
            if !free {
                (difference[i], difference[self.places() + i]) = (0.0, 0.0);
            }
        }
    }

    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        let length = match i % self.places() {
            0 | 1 => place,
            2 => 1.0,
            _ => place * self.rigid.mass.sqrt(),
        };
        (if i < self.places() { 1.0 } else { omega }) * length
    }

    fn excursion(&self, arm: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        let lever = self.lever();
        way(0..2) + (arm + DEFORMED * lever) * way(2..3) + self.most.excursion(RIGID, lever + arm, way)
    }

    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        let ([speed, acceleration], [spin, spin_rate]) = (rates(0..2), rates(2..3));
        let mut section = SectionBounds { speed, acceleration, spin, spin_rate, ..SectionBounds::default() };
        self.most.add_to(&mut section, RIGID, rates);
        let lever = self.lever();
        section.of_frame(lever, DEFORMED * lever, f64::INFINITY)
    }

    fn acceleration(&self, body: &Body, point: Point<'_>, force: DVec3) -> DVec3 {
        let rigid = rigid_body::acceleration(body, &point, force);
        let heading = point.frame.heading;
        let modal =
            self.deforming(point.section).map(|end| end.compliance(heading, point.arm.truncate(), force.truncate()));
        rigid + modal.unwrap_or_default().extend(0.0)
    }

    fn port(&self, _: &Body, point: Point<'_>, force: DVec3, [response, load]: [&mut [f64]; 2]) {
        let places = self.places();
        let load = &mut load[places..];
        load[..RIGID].copy_from_slice(&[force.x, force.y, point.arm.cross(force).z]);
        load[RIGID..].fill(0.0);
        if let Some(end) = self.deforming(point.section) {
            // φ is small beside the angle of the frame.
            let turns = Turns::of(point.frame.heading, 0.0);
            let moment = point.arm.cross(force).z;
            end.push(&end.load(&turns, force.truncate(), moment), &mut load[RIGID..]);
        }
        let free = planar::free(&self.rigid).into_iter().chain(std::iter::repeat(true));
        for (((response, load), mass), free) in response[places..].iter_mut().zip(&*load).zip(self.masses()).zip(free) {
            *response = if free { load / mass } else { 0.0 };
        }
    }

    fn along(&self, body: &Body, axis: usize) -> Option<AxialMotion> {
        let modes = self.axial[axis].clone().filter(|_| body.keeps_to_axis[axis])?;
        Some(AxialMotion { components: [axis, self.places() + axis], modes: Some(modes) })
    }

    fn free_motion(&self, ground: &Ground, duration: f64) -> Option<Arc<dyn ClosedForm>> {
        let block = Arc::new(LinearBlock::of(&[self.part()], &[], (ground, duration))?);
        Some(Arc::new(BlockMember { block, member: 0 }))
    }

    fn linear_part(&self, _: &Body) -> Option<LinearPart> {
        Some(self.part())
    }

    fn fastest(&self, body: &Body) -> f64 {
        rigid_body::fastest(body)
    }

    fn energies(&self, body: &Body, state: &[f64], gravity: f64) -> BodyEnergies {
        let (_, rate) = self.halves(state);
        let kinetic: f64 = rate.iter().zip(self.masses()).map(|(v, mass)| 0.5 * mass * v * v).sum();
        let strain = self.on_bearings(state).map(|AxisMotion { axis, w, .. }| 0.5 * axis.stiffness * w * w).sum();
        BodyEnergies { kinetic, bearings: strain, gravity: body.mass * gravity * body.start[2] }
    }

    fn powers(&self, body: &Body, state: &[f64], ground: GroundNow) -> BodyPowers {
        let (_, rate) = self.halves(state);
        let inertia = -body.mass * (ground.acceleration.x * rate[0] + ground.acceleration.y * rate[1]);
        let modal: f64 = self.pushed.iter().zip(&rate[RIGID..]).map(|(push, v)| push * v).sum();
        let push = body.push.x * rate[0] + body.push.y * rate[1] + body.moment.z * rate[2] + modal;
        BodyPowers {
            ground: inertia,
            push,
            bearings: self.on_bearings(state).map(|AxisMotion { axis, v, .. }| axis.damping * v * v).sum(),
        }
    }

    fn own_strain(&self, state: &[f64]) -> f64 {
        self.strain(&self.halves(state).0[RIGID..])
    }

    fn own_loss(&self, state: &[f64]) -> f64 {
        self.loss(&self.halves(state).1[RIGID..])
    }
}
