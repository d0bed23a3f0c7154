//! An elastic girder in space: displacement and rotation of its mean axes since it was placed, as of a rigid one, the coordinates `q`
//! of its modes, and their rates (`docs/physics.md#flexible-girders`).
//!
//! The frame of an end section is exactly rigid: it turns by `R exp [φ]×`.

mod bearings;
mod equilibrium;
mod girder;
mod section;
mod turn;

use std::ops::Range;

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::contact::{Frame, turned_by};
use crate::dynamics::connection::Connection;
use crate::dynamics::model::body::{Body, BodyEnergies, BodyPowers, Coordinates, Counted, Point};
use crate::dynamics::model::coordinates::elastic::girder::DEFORMED;
use crate::dynamics::model::coordinates::section_forces::Bearer;
use crate::dynamics::model::coordinates::spatial::{self, Spatial};
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::rigid_body::{self, RigidAcceleration};
use crate::dynamics::model::section_bounds::SectionBounds;
use crate::dynamics::model::wrench::Wrench;
use crate::geometry::End;
use crate::scene::facing::Flank;
pub use girder::SpatialElasticGirder;
use girder::{POSITIONS, RATES};
use section::{Section, Turns};

impl SpatialElasticGirder {
    /// Pose and twist of the mean axes.
    fn mean_axes(&self, state: &[f64]) -> Frame {
        let (_, rates) = self.halves(state);
        Frame {
            home: self.rigid.home,
            shift: DVec3::from_slice(&state[..3]),
            turned: turned_by(spatial::turn(state)),
            heading: 0.0,
            velocity: DVec3::from_slice(&rates[..3]),
            spin: DVec3::from_slice(&rates[3..RATES]),
            level: false,
        }
    }

    fn pose(&self, section: usize, state: &[f64]) -> Frame {
        let mut frame = self.mean_axes(state);
        if let Some(section) = self.deforming(section) {
            let [q, rates] = self.modal(state);
            let deformation = section.deformation(q, rates);
            let turns = Turns::of(frame.turned, deformation.of.turned);
            let offset = section.offset(&turns, &deformation);
            let [velocity, spin] = section.velocity(&turns, offset, frame.spin, deformation.rate);
            frame.turned = turns.whole();
            frame.shift += offset;
            frame.velocity += velocity;
            frame.spin = spin;
        }
        frame
    }

    /// Adds a wrench on a section about the origin of its frame to that on the mean axes and to the modal forces.
    fn gather(
        section: &Section,
        turned: DMat3,
        modal: [&[f64]; 2],
        on: &Wrench,
        (sum, out): (&mut Wrench, &mut [f64]),
    ) {
        let deformation = section.deformation(modal[0], modal[1]);
        let turns = Turns::of(turned, deformation.of.turned);
        section.push(&section.load(&turns, on.force, on.moment), out);
        sum.push(on.force, section.offset(&turns, &deformation));
        sum.moment += on.moment;
    }

    /// Wrench on the mean axes, and forces on the modes written to `out`, of wrenches on the sections, bearings, push and damping; in
    /// the pose `here` of the mean axes since the girder was placed.
    fn load(&self, here: &Frame, state: &[f64], wrenches: &[Wrench], out: &mut [f64]) -> Wrench {
        let [q, rates] = self.modal(state);
        let mut sum = Wrench::default();
        let springs = out.iter_mut().zip(self.springs.iter()).zip(q.iter().zip(rates));
        springs.for_each(|((out, [k, c]), (q, v))| *out = -(k * q + c * v));
        for (section, wrench) in wrenches.iter().enumerate() {
            if wrench.force == DVec3::ZERO && wrench.moment == DVec3::ZERO {
                continue;
            }
            if let Some(section) = self.deforming(section) {
                Self::gather(section, here.turned, [q, rates], wrench, (&mut sum, out));
            } else {
                sum.force += wrench.force;
                sum.moment += wrench.moment;
            }
        }
        if let Some((section, push)) = &self.pushed {
            Self::gather(section, here.turned, [q, rates], push, (&mut sum, out));
        }
        for point in &self.bearings {
            let now = point.now(&self.rigid.axes, here, q, rates);
            sum.push(now.force, now.arm);
            sum.moment += now.bent.cross(point.bearing.preload);
            point.push(point.back(&here.turned, now.force), out);
        }
        let standing = rigid_body::standing(&self.rigid, here);
        sum.force += standing.force;
        sum.moment += standing.moment;
        sum
    }
}

impl Coordinates for SpatialElasticGirder {
    fn width(&self) -> usize {
        POSITIONS + RATES + 2 * self.count()
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
        let rigid = Spatial.initial(body);
        let mut state = vec![0.0; self.width()];
        state[..POSITIONS].copy_from_slice(&rigid[..POSITIONS]);
        state[self.places()..][..RATES].copy_from_slice(&rigid[POSITIONS..]);
        state
    }

    fn frame(&self, _: &Body, section: usize, state: &[f64]) -> Frame {
        self.pose(section, state)
    }

    fn frame_since(&self, _: &Body, section: usize, state: &[f64]) -> Frame {
        self.pose(section, state)
    }

    fn attitude(&self, body: &Body, state: &[f64]) -> (f64, DQuat) {
        Spatial.attitude(body, state)
    }

    fn has_heading(&self) -> bool {
        true
    }

    fn heading(&self, body: &Body, state: &[f64]) -> Option<DVec2> {
        Spatial.heading(body, state)
    }

    // Counted from the place alone: the rotation stays in the state, since deformations are seen in axes that turn by it.
    fn reference(&self, _: &Body, numbers: &[f64]) -> ReferencePose {
        let shift = numbers.first_chunk().map_or(DVec3::ZERO, |place: &[f64; 3]| DVec3::from_array(*place));
        ReferencePose::spatial(shift, DQuat::IDENTITY)
    }

    fn rebase(&self, body: &Body, state: &mut [f64]) -> ReferencePose {
        let base = self.reference(body, &state[..3]);
        state[..3].fill(0.0);
        base
    }

    fn restore(&self, numbers: &[f64], state: &mut [f64]) {
        state[..3].iter_mut().zip(numbers).for_each(|(component, base)| *component += base);
    }

    fn slope(&self, _: &Body, now: Counted<'_>, contact: &[Wrench], ground: GroundNow, out: &mut [f64]) {
        let here = now.base.whole(&now.frames[0]);
        let (places, gains) = out.split_at_mut(self.places());
        let (rigid, modal) = gains.split_at_mut(RATES);
        let wrench = self.load(&here, now.state, contact, modal);
        let [acceleration, spin_rate] = rigid_body::newton_euler(&self.rigid, &here, &wrench, ground.acceleration);
        for i in 0..3 {
            let free = self.rigid.free[i];
            places[i] = if free { here.velocity[i] } else { 0.0 };
            rigid[i] = if free { acceleration[i] } else { 0.0 };
            rigid[3 + i] = spin_rate[i];
        }
        spatial::set_quaternion(places, spatial::turn_rate(now.state, here.spin));
        places[POSITIONS..].copy_from_slice(self.modal(now.state)[1]);
    }

    fn has_unit_parts(&self) -> bool {
        true
    }

    fn normalise(&self, state: &mut [f64]) {
        spatial::normalise_turn(state);
    }

    fn add_accelerations(&self, state: &mut [f64], slope: &[f64], dt: f64) {
        let (_, gains) = self.halves(slope);
        (0..3).for_each(|i| state[i] += 0.5 * dt * dt * gains[i]);
        spatial::bend_turn(state, DVec3::from_slice(&gains[3..RATES]), dt);
        let modal = state[POSITIONS..self.places()].iter_mut().zip(&gains[RATES..]);
        modal.for_each(|(place, gain)| *place += 0.5 * dt * dt * gain);
    }

    // A modal coordinate counts by √m: the mean square of the displacement that it is.
    fn size2(&self, body: &Body, difference: &[f64]) -> [f64; 2] {
        let (places, rates) = self.halves(difference);
        let square = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
        let arm2 = body.gyration2;
        // A quaternion turns half the angle.
        let place = square(&places[..3]) + 4.0 * arm2 * square(&places[3..POSITIONS]);
        let speed = square(&rates[..3]) + arm2 * square(&rates[3..RATES]);
        [place + square(&places[POSITIONS..]) / body.mass, speed + square(&rates[RATES..]) / body.mass]
    }

    fn hold(&self, body: &Body, difference: &mut [f64]) {
        let (positions, velocities) = difference.split_at_mut(self.places());
        for (i, free) in body.free.into_iter().enumerate() {
            if !free {
                velocities[i] = 0.0;
                if i < 3 {
                    positions[i] = 0.0;
                }
            }
        }
    }

    fn increment_scale(&self, i: usize, place: f64, omega: f64) -> f64 {
        let (own, per, rigid) = match i.checked_sub(self.places()) {
            None => (i, 1.0, POSITIONS),
            Some(rate) => (rate, omega, RATES),
        };
        let length = match own {
            0..3 => place,
            own if own < rigid => 1.0,
            _ => place * self.rigid.mass.sqrt(),
        };
        per * length
    }

    fn excursion(&self, arm: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        let lever = self.lever();
        Spatial.excursion(arm + DEFORMED * lever, way) + self.most.excursion(POSITIONS, lever + arm, way)
    }

    fn bounds(&self, rates: &dyn Fn(Range<usize>) -> [f64; 2]) -> MotionBounds {
        let MotionBounds { speed, acceleration, spin, spin_rate, .. } = Spatial.bounds(rates);
        let mut section = SectionBounds { speed, acceleration, spin, spin_rate, ..SectionBounds::default() };
        self.most.add_to(&mut section, POSITIONS, rates);
        let lever = self.lever();
        section.of_frame_in_space(lever, DEFORMED * lever, f64::INFINITY)
    }

    fn acceleration(&self, body: &Body, point: Point<'_>, force: DVec3) -> DVec3 {
        let rigid = rigid_body::acceleration(body, &point, force);
        let modal = self.deforming(point.section).map(|s| s.compliance(&point.frame.turned, point.arm, force));
        rigid + modal.unwrap_or_default()
    }

    fn port(&self, body: &Body, point: Point<'_>, force: DVec3, [response, load]: [&mut [f64]; 2]) {
        let (response, load) = (&mut response[self.places()..], &mut load[self.places()..]);
        let moment = point.arm.cross(force);
        let RigidAcceleration { linear, angular } =
            rigid_body::response(body, &point.frame.rotation(&body.axes), force, point.arm);
        response[..3].copy_from_slice(&linear.to_array());
        response[3..RATES].copy_from_slice(&angular.to_array());
        load[..3].copy_from_slice(&force.to_array());
        load[3..RATES].copy_from_slice(&moment.to_array());
        load[RATES..].fill(0.0);
        if let Some(section) = self.deforming(point.section) {
            // φ is small beside the rotation of the frame.
            let turns = Turns::of(point.frame.turned, DVec3::ZERO);
            section.push(&section.load(&turns, force, moment), &mut load[RATES..]);
        }
        response[RATES..].copy_from_slice(&load[RATES..]);
    }

    fn fastest(&self, body: &Body) -> f64 {
        rigid_body::fastest(body)
    }

    fn energies(&self, body: &Body, state: &[f64], gravity: f64) -> BodyEnergies {
        let (here, [q, rates]) = (self.mean_axes(state), self.modal(state));
        let weight = body.mass * gravity;
        let modal: f64 = rates.iter().map(|v| 0.5 * v * v).sum();
        let strain: f64 = (self.bearings.iter())
            .map(|point| {
                let now = point.now(&body.axes, &here, q, rates);
                point.bearing.stored_energy(&(), &now.motion) - point.preload_work(&here.turned, now.bent)
            })
            .sum();
        let kinetic = rigid_body::kinetic_energy(body, &here) + modal;
        BodyEnergies {
            kinetic,
            bearings: strain - rigid_body::preload_work(body, &here, weight),
            gravity: weight * here.shift.z,
        }
    }

    fn powers(&self, body: &Body, state: &[f64], ground: GroundNow) -> BodyPowers {
        let (here, [q, rates]) = (self.mean_axes(state), self.modal(state));
        let push = self.pushed.as_ref().map_or(0.0, |(section, push)| {
            let deformation = section.deformation(q, rates);
            let turns = Turns::of(here.turned, deformation.of.turned);
            let offset = section.offset(&turns, &deformation);
            let [velocity, spin] = section.velocity(&turns, offset, here.spin, deformation.rate);
            push.force.dot(here.velocity + velocity) + push.moment.dot(spin)
        });
        let lost = self.bearings.iter().map(|point| {
            let now = point.now(&body.axes, &here, q, rates);
            point.bearing.dissipated_power(&(), &now.motion)
        });
        BodyPowers { ground: -body.mass * ground.acceleration.dot(here.velocity), push, bearings: lost.sum() }
    }

    fn own_strain(&self, state: &[f64]) -> f64 {
        self.strain(self.modal(state)[0])
    }

    fn own_loss(&self, state: &[f64]) -> f64 {
        self.loss(self.modal(state)[1])
    }
}

#[cfg(test)]
mod tests;
