//! The equations of motion of bodies in contact, as an integrator sees them: one vector of body states, then the angles
//! of slips that turn.

use glam::{DVec2, DVec3};

use super::body_state::{self, Wrench};
use super::dop853::System;
use super::track::Closed;
use super::{Model, penalty3d};
use crate::contact::{Frame, Local, Mode, locate};
use crate::motion::{Ground, LinearPiece};
use crate::scene::Kind;

/// A closed contact between bodies of one island.
#[derive(Clone, Copy, Debug)]
pub(super) struct Active {
    /// Its number in the model.
    pub site: usize,
    /// Which of the island's bodies owns the node; nothing for an abutment.
    pub node: Option<usize>,
    /// Which owns the face.
    pub face: Option<usize>,
    /// Its state.
    pub closed: Closed,
    /// Where its slip angle stands in the vector, if it is a state.
    pub angle: Option<usize>,
}

impl Active {
    /// The node against the face, with the island's bodies in `frames`.
    pub(super) fn look(&self, model: &Model, frames: &[Frame]) -> Local {
        let site = &model.contacts[self.site];
        let fixed = Frame::fixed(site.fixed);
        let frame = |index: Option<usize>| index.map_or(&fixed, |i| &frames[i]);
        locate(site.point, frame(self.node), &site.face, frame(self.face))
    }

    /// The contact with its slip direction as the vector has it.
    #[inline]
    pub(super) fn turned(&self, y: &[f64]) -> Closed {
        let mut closed = self.closed;
        if let Some(at) = self.angle {
            closed.mode = Mode::Slip { direction: direction(y[at]) };
        }
        closed
    }
}

/// The unit vector at an angle.
pub(super) fn direction(angle: f64) -> DVec2 {
    let (sin, cos) = angle.sin_cos();
    DVec2::new(cos, sin)
}

/// What the error of a step is measured against: speeds, with displacements and angles turned into speeds.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Scale {
    /// What the tolerance allows \[m/s\].
    pub speed: f64,
    /// Fastest circular frequency in play \[rad/s\].
    pub omega: f64,
    /// What the tolerance allows of a slip angle \[rad\].
    pub angle: f64,
    /// Size of what moves \[m\].
    pub place: f64,
}

/// The right-hand side for one island.
#[derive(Debug)]
pub(super) struct Field<'a> {
    /// The scene.
    pub model: &'a Model,
    /// Its bodies, numbers in the model.
    pub bodies: &'a [usize],
    /// Its closed contacts.
    pub active: &'a [Active],
    /// The stretch of ground motion that the step stays in.
    pub piece: LinearPiece,
    /// Error scale.
    pub scale: Scale,
    /// Scratch.
    pub frames: &'a mut Vec<Frame>,
    /// Scratch.
    pub wrenches: &'a mut Vec<Wrench>,
    /// How fast each slip angle returns to the direction of its velocity, with the sign of a rate \[1/s\].
    pub rates: &'a mut Vec<f64>,
}

impl Field<'_> {
    fn ground(&self, t: f64) -> DVec3 {
        match &self.model.ground {
            Ground::Record { direction, .. } => {
                *direction * (self.piece.start + self.piece.slope * (t - self.piece.from))
            }
            other => other.acceleration(t),
        }
    }

    fn contacts(&mut self, y: &[f64], out: &mut [f64]) {
        for active in self.active {
            let site = &self.model.contacts[active.site];
            let fixed = Frame::fixed(site.fixed);
            let node = active.node.map_or(&fixed, |i| &self.frames[i]);
            let face = active.face.map_or(&fixed, |i| &self.frames[i]);
            let closed = active.turned(y);
            let action = penalty3d::act(site, &closed, node, face);
            if let Some(i) = active.node {
                self.wrenches[i].push(action.force, action.node_arm);
            }
            if let Some(i) = active.face {
                self.wrenches[i].push(-action.force, action.face_arm);
            }
            if let (Some(at), Mode::Slip { direction }) = (active.angle, closed.mode) {
                let length = (closed.law.mu_k * action.here.penetration()).max(0.0) + closed.ease;
                out[at] = direction.perp_dot(action.here.rate) / length;
                self.rates.push(-direction.dot(action.here.rate) / length);
            }
        }
    }
}

impl System for Field<'_> {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        let (model, width) = (self.model, body_state::width(self.model.kind));
        self.frames.clear();
        self.wrenches.clear();
        self.rates.clear();
        for (i, &body) in self.bodies.iter().enumerate() {
            self.frames.push(body_state::frame(model.kind, &model.bodies[body], &y[i * width..]));
            self.wrenches.push(Wrench::default());
        }
        self.contacts(y, out);
        let ground = self.ground(t);
        for (i, &body) in self.bodies.iter().enumerate() {
            let (state, rate) = (&y[i * width..(i + 1) * width], &mut out[i * width..(i + 1) * width]);
            let (body, wrench) = (&model.bodies[body], &self.wrenches[i]);
            match model.kind {
                Kind::Planar => body_state::planar_slope(body, state, wrench, ground, rate),
                Kind::Spatial => {
                    let here = &self.frames[i];
                    body_state::spatial_slope(body, here, state, wrench, ground, model.gravity, rate);
                }
            }
        }
    }

    fn size2(&self, d: &[f64]) -> f64 {
        let width = body_state::width(self.model.kind);
        let omega2 = self.scale.omega * self.scale.omega;
        let mut sum = 0.0;
        for (i, &body) in self.bodies.iter().enumerate() {
            let d = &d[i * width..(i + 1) * width];
            let arm2 = self.model.bodies[body].gyration2;
            let (place, speed) = match self.model.kind {
                Kind::Planar => (square(&d[..2]) + arm2 * d[2] * d[2], square(&d[3..5]) + arm2 * d[5] * d[5]),
                // A quaternion turns half the angle.
                Kind::Spatial => {
                    (square(&d[..3]) + 4.0 * arm2 * square(&d[3..7]), square(&d[7..10]) + arm2 * square(&d[10..13]))
                }
            };
            // Summed, not the largest: a NaN must come through and refuse the step.
            sum += (speed + omega2 * place) / (self.scale.speed * self.scale.speed);
        }
        let angles = square(&d[self.bodies.len() * width..]) / (self.scale.angle * self.scale.angle);
        sum + angles
    }

    fn is_held(&self, i: usize) -> bool {
        let width = body_state::width(self.model.kind);
        let Some(&body) = self.bodies.get(i / width) else { return false };
        let free = &self.model.bodies[body].free;
        match (self.model.kind, i % width) {
            (Kind::Planar, i) => !free[[0, 1, 5][i % 3]],
            (Kind::Spatial, 3..7) => false,
            (Kind::Spatial, i @ 0..3) => !free[i],
            (Kind::Spatial, i) => !free[i - 7],
        }
    }

    fn followers(&self) -> usize {
        self.active.iter().filter(|a| a.angle.is_some()).count()
    }

    fn rates(&self) -> &[f64] {
        self.rates
    }

    fn extent(&self, i: usize, y: f64) -> f64 {
        let width = body_state::width(self.model.kind);
        let (places, turns) = match self.model.kind {
            Kind::Planar => (2, 3),
            Kind::Spatial => (3, 7),
        };
        let rate = if i % width < turns { 1.0 } else { self.scale.omega };
        let length = |component: usize| if component < places { self.scale.place } else { 1.0 };
        if i >= self.bodies.len() * width {
            return 1.0;
        }
        y.abs().max(rate * length(i % width % turns))
    }
}

fn square(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum()
}
