//! The collinear kind of island: bodies that move along the axis and touch flush across it, without sliding and rotation.
//! The contacts of two faces act as one, and the motion of a body is that of one coordinate, of a girder that bends also that of its
//! modes along the axis.
//!
//! `m ẍ + c ẋ + k x = Σ ±N(δ, δ̇) − m Ẍ` with the sum of a face's normal forces (`docs/physics.md#plane-motion`,
//! `docs/physics.md#linear-spring-and-dashpot`). The reduction is exact under these conditions: bearings and ground
//! motion act along the axis, faces are square to it, the levers across it cancel, and the other components of the
//! state are 0, which they then remain to the last bit.

use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use crate::contact::{Frame, Measured, Mode, Normal, NormalLaw, measure};
use crate::dynamics::Model;
use crate::dynamics::model::axial_motion::{AxialModes, AxialMotion};
use crate::dynamics::model::coordinates::planar;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::constants::LEVEL_ROUNDING;
use crate::dynamics::penalty3d::coupled_system::CoupledSystem;

/// A section of a body of the island.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct BodySection {
    /// Index of the body in the island.
    body: usize,
    /// Number of the section among the body's own.
    section: usize,
}

/// Two sides in flush contact.
#[derive(Clone, Copy, Debug, PartialEq)]
struct FlushContact {
    /// The node's and the face's section of the first contact; `None` for an abutment.
    sides: [Option<BodySection>; 2],
    /// The face's normal along the axis, ±1.
    normal: f64,
    /// `g` as placed \[m\].
    placed_gap: f64,
    /// Normal law of its contacts in parallel; `None` where the normal force is held at 0.
    law: Option<Normal>,
}

/// A body of the island.
#[derive(Clone, Debug, PartialEq)]
struct AxialBody {
    /// Its components in the island's vector.
    range: Range<usize>,
    /// Of these, displacement and velocity of G along the axis, counted in the island's vector.
    components: [usize; 2],
    /// Modes along the axis, of a girder that bends.
    modes: Option<Arc<AxialModes>>,
}

/// An island in one line.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::dynamics) struct CollinearIsland {
    axis: usize,
    lines: Vec<AxialBody>,
    /// Whether a body bends.
    bends: bool,
    joints: Vec<FlushContact>,
    /// Index of the first contact of each contact's joint.
    first: Vec<usize>,
}

/// Quantities of a contact on the axis.
struct AxialContact {
    sides: [Option<BodySection>; 2],
    normal: f64,
    placed_gap: f64,
    law: Option<Normal>,
    /// Levers of its force across the axis from G of either side \[m\].
    levers: [f64; 2],
    reach: f64,
}

impl CollinearIsland {
    /// Collinear island of these bodies and closed contacts; `None` where a condition on bodies, bearings, ground or
    /// faces fails, or a device acts.
    pub(in crate::dynamics) fn of(model: &Model, system: &CoupledSystem) -> Option<Self> {
        let CoupledSystem { bodies, layout, bases, active, links, .. } = system;
        if active.is_empty() || !links.is_empty() {
            return None;
        }
        let lines = |axis: usize| -> Option<Vec<AxialBody>> {
            let along = |(i, (&b, base)): (usize, (&usize, &ReferencePose))| {
                let AxialMotion { components, modes } =
                    model.bodies[b].along(axis).filter(|_| planar::is_base_along(base, axis))?;
                let range = layout.range(i);
                Some(AxialBody { components: components.map(|component| range.start + component), range, modes })
            };
            bodies.iter().zip(bases).enumerate().map(along).collect()
        };
        (0..2).find_map(|axis| Self::across(model, bodies, lines(axis)?, active, axis))
    }

    fn across(
        model: &Model,
        bodies: &[usize],
        lines: Vec<AxialBody>,
        active: &[ActiveContact],
        axis: usize,
    ) -> Option<Self> {
        let touches: Option<Vec<AxialContact>> =
            active.iter().map(|a| AxialContact::of(model, bodies, a, axis)).collect();
        let touches = touches?;
        let first: Vec<usize> =
            touches.iter().map(|touch| touches.iter().position(|other| touch.joins(other)).unwrap_or(0)).collect();
        let mut joints = Vec::new();
        for number in (0..touches.len()).filter(|&number| first[number] == number) {
            let members = || (number..touches.len()).filter(|&n| first[n] == number).map(|n| &touches[n]);
            joints.push(AxialContact::together(&touches[number], members)?);
        }
        let bends = lines.iter().any(|line| line.modes.is_some());
        Some(Self { axis, lines, bends, joints, first })
    }

    /// Whether a state satisfies the conditions: all components off the axis are 0.
    #[inline]
    pub(in crate::dynamics) fn holds(&self, y: &[f64]) -> bool {
        let rigid = |y: &[f64]| planar::in_a_row(y).iter().all(|state| planar::is_along(state, self.axis));
        if !self.bends {
            return rigid(y);
        }
        self.lines.iter().all(|line| {
            let own = &y[line.range.clone()];
            line.modes.as_ref().map_or_else(|| rigid(own), |modes| modes.hold(own))
        })
    }

    /// Components of position and velocity of a body along the axis in the island's vector, where all its sections move by them.
    #[inline]
    pub(in crate::dynamics) fn components(&self, index: usize) -> Option<[usize; 2]> {
        let line = &self.lines[index];
        line.modes.is_none().then_some(line.components)
    }

    /// The axis: 0 is x, 1 is y.
    pub(in crate::dynamics) fn axis(&self) -> usize {
        self.axis
    }

    /// Index of the first contact with the penetration of this one while the conditions hold.
    pub(in crate::dynamics) fn first(&self, contact: usize) -> usize {
        self.first[contact]
    }

    /// Derivative of a state that satisfies the conditions.
    #[inline]
    pub(in crate::dynamics) fn rates(
        &self,
        model: &Model,
        system: &CoupledSystem,
        ground: DVec3,
        y: &[f64],
        out: &mut [f64],
    ) {
        let axis = self.axis;
        out.fill(0.0);
        for joint in &self.joints {
            let [node, face] = joint.sides.map(|side| side.map_or([0.0; 2], |side| self.moved(side, y)));
            let gap = joint.placed_gap + joint.normal * (node[0] - face[0]);
            let rate = joint.normal * (node[1] - face[1]);
            let force = joint.law.map_or(0.0, |law| joint.normal * (law.elastic(-gap) + law.damping(-gap, rate)));
            for (side, force) in joint.sides.into_iter().zip([force, -force]) {
                let Some(BodySection { body, section }) = side else { continue };
                let line = &self.lines[body];
                out[line.components[1]] += force;
                if let Some(modes) = &line.modes {
                    modes.push(section, force, &mut out[line.range.clone()]);
                }
            }
        }
        for (i, &body) in system.bodies.iter().enumerate() {
            let (body, line) = (&model.bodies[body], &self.lines[i]);
            let [at, rate] = line.components;
            let (place, speed) = (system.bases[i].planar()[axis] + y[at], y[rate]);
            let bearings = match &line.modes {
                None => body.planar.stiffness.col(axis)[axis] * place + body.planar.damping.col(axis)[axis] * speed,
                Some(modes) => -modes.resist([place, speed], &y[line.range.clone()], &mut out[line.range.clone()]),
            };
            let force = out[rate] + body.push[axis] - bearings;
            let rates = [speed, force / body.mass - ground[axis]];
            [out[at], out[rate]] = if body.free[axis] { rates } else { [0.0; 2] };
        }
    }

    /// Displacement of a section along the axis and its rate, counted from the reference pose of its body.
    #[inline]
    fn moved(&self, BodySection { body, section }: BodySection, y: &[f64]) -> [f64; 2] {
        let line = &self.lines[body];
        let [place, speed] = line.components.map(|component| y[component]);
        line.modes.as_ref().map_or([place, speed], |modes| {
            let [moved, moving] = modes.displaced(section, &y[line.range.clone()]);
            [place + moved, speed + moving]
        })
    }
}

impl AxialContact {
    fn of(model: &Model, bodies: &[usize], active: &ActiveContact, axis: usize) -> Option<Self> {
        let site = &model.sites[active.site];
        let frame = |side: Option<usize>| side.map_or(site.stand, |i| Frame::fixed(model.bodies[bodies[i]].home));
        let (node, face): (Frame, Frame) = (frame(active.ends[0]), frame(active.ends[1]));
        let normal = active.geometry.axes.z_axis;
        let square = normal[axis].abs() == 1.0 && normal[1 - axis] == 0.0 && site.face.is_upright();
        let Measured { here, arm, lever, .. } = measure(&active.geometry, &node, &face);
        let (closed, law) = (&active.closed, &active.closed.law);
        let still = match closed.mode {
            Mode::Stick { anchor } => anchor == here.way,
            Mode::Slip { .. } => law.is_forceless_at_rest(),
        };
        let sections = model.sections(active.site);
        let side = |i: usize, body: Option<usize>| body.map(|body| BodySection { body, section: sections[i] });
        (square && still && active.angle.is_none()).then(|| Self {
            sides: [side(0, active.ends[0]), side(1, active.ends[1])],
            normal: normal[axis],
            placed_gap: here.gap,
            law: (!closed.held_at_zero).then_some(law.normal),
            levers: [arm[1 - axis], lever[1 - axis]],
            reach: site.reach(),
        })
    }

    /// Whether both contacts are between the same two sides, in either order.
    fn joins(&self, other: &Self) -> bool {
        let [a, b] = other.sides;
        (self.sides == [a, b] && self.normal == other.normal) || (self.sides == [b, a] && self.normal == -other.normal)
    }

    /// The joint of contacts between the same sides; `None` where their penetrations differ or their moments do not
    /// cancel.
    fn together<'a, I: Iterator<Item = &'a Self>>(first: &Self, members: impl Fn() -> I) -> Option<FlushContact> {
        let level = members()
            .all(|m| m.law == first.law && (m.placed_gap - first.placed_gap).abs() <= LEVEL_ROUNDING * m.reach);
        let lever = |side: Option<BodySection>, m: &Self| if m.sides[0] == side { m.levers[0] } else { m.levers[1] };
        let balanced = first.sides.into_iter().all(|side| {
            let (sum, size) = members().fold((0.0, 0.0f64), |(sum, size), m| {
                let lever = lever(side, m);
                (sum + lever, size.max(lever.abs()))
            });
            side.is_none() || f64::abs(sum) <= LEVEL_ROUNDING * size
        });
        let count = members().count() as f64;
        let placed_gap = members().map(|m| m.placed_gap).sum::<f64>() / count;
        let law = first.law.map(|of_one| of_one.times(count));
        (level && balanced).then_some(FlushContact { sides: first.sides, normal: first.normal, placed_gap, law })
    }
}

#[cfg(test)]
mod tests;
