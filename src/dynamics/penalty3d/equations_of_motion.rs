//! Equations of motion of an island (`docs/physics.md#rigid-body`) as a system for the integrators: the vector holds
//! the states of the bodies, then the slip angles.

use std::ops::Range;

use glam::{DVec2, DVec3};

use crate::contact::{Forces, Frame, Local, Mode};
use crate::dynamics::Model;
use crate::dynamics::integrator::system::{ImplicitSystem, PositionBlock, RankOneTerm, System};
use crate::dynamics::model::body::{Counted, Point};
use crate::dynamics::model::wrench::Wrench;
use crate::dynamics::penalty3d::active_contact::{ActiveContact, direction};
use crate::dynamics::penalty3d::collinear_island::CollinearIsland;
use crate::dynamics::penalty3d::constants::ANGLE_DIFFERENCE;
use crate::dynamics::penalty3d::contact_force;
use crate::dynamics::penalty3d::contact_force::Action;
use crate::dynamics::penalty3d::contact_rates::quickest;
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::penalty3d::coupled_system::CoupledSystem;
use crate::motion::{Ground, LinearPiece};
use crate::scene::Kind;

/// Error scale of a step, in speeds: displacements and angles enter times frequency and length.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::dynamics) struct ErrorScale {
    /// Allowed error of a speed \[m/s\].
    pub speed: f64,
    /// Largest circular frequency \[rad/s\].
    pub omega: f64,
    /// Size of the moving bodies \[m\].
    pub place: f64,
}

/// Right-hand side of an island.
#[derive(Debug)]
pub(in crate::dynamics) struct EquationsOfMotion<'a> {
    /// Constant data of the scene.
    pub model: &'a Model,
    /// Bodies and the connections that act on them.
    pub system: &'a CoupledSystem,
    /// Interval of the ground motion that contains the step.
    pub piece: LinearPiece,
    /// Error scale.
    pub scale: ErrorScale,
    /// Allowed error of each slip angle \[rad\].
    pub angles: &'a [f64],
    /// The collinear island, where the conditions on bodies and contacts hold.
    pub line: Option<&'a CollinearIsland>,
    /// Workspace.
    pub workspace: &'a mut Workspace,
}

/// Workspace of an evaluation of the equations of motion.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct Workspace {
    /// Poses of the sections of the bodies relative to their reference poses.
    pub frames: Vec<Frame>,
    /// Wrenches on the sections of the bodies.
    pub wrenches: Vec<Wrench>,
    /// Derivative of the rate of each slip angle by the angle \[1/s\], negative.
    pub rates: Vec<f64>,
    /// Contacts that slide in two directions.
    pub sliding: Sliding,
}

impl Workspace {
    /// For these closed contacts.
    pub(in crate::dynamics) fn of(active: &[ActiveContact]) -> Self {
        Self { sliding: Sliding::of(active), ..Self::default() }
    }

    /// Forgets the last evaluation.
    fn clear(&mut self) {
        self.frames.clear();
        self.wrenches.clear();
        self.rates.clear();
        self.sliding.channels.clear();
    }
}

/// Linearisation of contacts that slide in two directions, for implicit steps.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct Sliding {
    /// Indices of those contacts among the closed ones.
    pub sliders: Vec<usize>,
    /// Derivatives of their friction by `V_t`, as rank-one terms.
    channels: Vec<RankOneTerm>,
    /// Regularised directions of sliding at the linearisation, `V_t / max(|V_t|, v_stick)`.
    against: Vec<DVec2>,
    /// Whether each closed contact slid without friction at the linearisation, within round-off in front of its face.
    loose: Vec<bool>,
    /// Whether directions and absence of friction are held at those of the linearisation.
    held: bool,
}

impl Sliding {
    /// Contacts of `active` that slide in two directions.
    pub(in crate::dynamics) fn of(active: &[ActiveContact]) -> Self {
        let slides = |a: &ActiveContact| a.angle.is_some() || a.turns_at_once();
        let sliders: Vec<usize> = (0..active.len()).filter(|&i| slides(&active[i])).collect();
        Self { against: vec![DVec2::X; sliders.len()], loose: vec![false; active.len()], sliders, ..Self::default() }
    }
}

impl Sliding {
    /// Rank-one term of a slip whose angle is component `follower` of the auxiliary states: `V_t` turns the angle,
    /// the angle turns the force.
    fn follows(
        &mut self,
        [slider, follower]: [usize; 2],
        closed: &ClosedContact,
        direction: DVec2,
        action: &Action,
        length: f64,
    ) {
        let turned = Mode::Slip {
            direction: (direction + direction.perp() * ANGLE_DIFFERENCE)
                / (1.0 + ANGLE_DIFFERENCE * ANGLE_DIFFERENCE).sqrt(),
        };
        let turned = closed.forces_in(&turned, &action.here);
        let force = (turned.tangential_total() - action.forces.tangential_total()) / ANGLE_DIFFERENCE;
        self.channels.push(RankOneTerm {
            port: slider,
            input: force,
            output: direction.perp() / length,
            auxiliary: Some(follower),
        });
    }

    /// Rank-one terms of friction along `V_t` (law `paper`): its turning with the direction, and its decrease below
    /// `v_stick`.
    fn turns(&mut self, slider: usize, closed: &ClosedContact, here: &Local, forces: &Forces) {
        let (speed, least) = (forces.sliding.length(), closed.law.v_stick);
        let against = forces.sliding / speed.max(least);
        let along = forces.sliding.try_normalize().unwrap_or(DVec2::X);
        let across = along.perp();
        let friction = if closed.is_loose(here) { 0.0 } else { closed.law.mu_k * forces.normal };
        let slowing = if speed < least { -friction / least } else { 0.0 };
        self.against[slider] = against;
        self.channels.push(RankOneTerm {
            port: slider,
            input: across * (-friction / speed.max(least)),
            output: across,
            auxiliary: None,
        });
        self.channels.push(RankOneTerm { port: slider, input: along * slowing, output: along, auxiliary: None });
    }
}

impl EquationsOfMotion<'_> {
    fn ground(&self, t: f64) -> DVec3 {
        match &self.model.ground {
            Ground::Record { direction, .. } => {
                *direction * (self.piece.start + self.piece.slope * (t - self.piece.from))
            }
            other => other.acceleration(t),
        }
    }

    fn contacts(&mut self, y: &[f64], out: &mut [f64]) {
        let mut slider = 0;
        for (number, active) in self.system.active.iter().enumerate() {
            let site = &self.model.contacts[active.site];
            let node = active.node.map_or(&site.stand, |_| &self.workspace.frames[active.sections[0]]);
            let face = active.face.map_or(&site.stand, |_| &self.workspace.frames[active.sections[1]]);
            let at_once = active.turns_at_once();
            let mut mode = active.angle.map_or(active.closed.mode, |at| Mode::Slip { direction: direction(y[at]) });
            // A copy only where the sliding is frozen: a contact is evaluated some ten times a step.
            let mut held;
            let mut closed = &active.closed;
            if self.workspace.sliding.held {
                held = active.closed;
                if at_once {
                    mode = Mode::Slip { direction: self.workspace.sliding.against[slider] };
                    held.law.v_stick = 0.0;
                }
                // Friction in front of the face is held as it was: a difference quotient across the face would be
                // that of neither side.
                held.solver.at_face = false;
                if self.workspace.sliding.loose[number] {
                    held.law.mu_k = 0.0;
                }
                closed = &held;
            }
            let action = contact_force::act_in(&active.home, closed, &mode, node, face);
            if !self.workspace.sliding.held {
                self.workspace.sliding.loose[number] = closed.is_loose(&action.here);
            }
            if active.node.is_some() {
                self.workspace.wrenches[active.sections[0]].push(action.force, action.node_arm);
            }
            if active.face.is_some() {
                self.workspace.wrenches[active.sections[1]].push(-action.force, action.face_arm);
            }
            if let (Some(at), Mode::Slip { direction }) = (active.angle, mode) {
                let length = closed.law.slip_stretch(&action.here) + closed.solver.regularisation;
                out[at] = direction.perp_dot(action.here.rate) / length;
                self.workspace.rates.push(-direction.dot(action.here.rate) / length);
                self.workspace.sliding.follows(
                    [slider, self.workspace.rates.len() - 1],
                    closed,
                    direction,
                    &action,
                    length,
                );
                slider += 1;
            } else if at_once {
                if !self.workspace.sliding.held {
                    self.workspace.sliding.turns(slider, closed, &action.here, &action.forces);
                }
                slider += 1;
            }
        }
    }
}

impl System for EquationsOfMotion<'_> {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        let (model, system) = (self.model, self.system);
        self.workspace.clear();
        if let Some(line) = self.line.filter(|line| line.holds(y)) {
            line.slope(model, &system.bodies, &system.bases, self.ground(t), y, out);
            return;
        }
        for (i, &body) in system.bodies.iter().enumerate() {
            model.bodies[body].push_frames(&y[system.layout.range(i)], &mut self.workspace.frames);
        }
        self.workspace.wrenches.resize(self.workspace.frames.len(), Wrench::default());
        self.contacts(y, out);
        for link in &system.links {
            link.push(model, &system.bases, &self.workspace.frames, &mut self.workspace.wrenches);
        }
        let ground = self.ground(t);
        for (i, &body) in system.bodies.iter().enumerate() {
            let (part, sections) = (system.layout.range(i), system.layout.sections(i));
            let frames = &self.workspace.frames[sections.clone()];
            let now = Counted { base: &system.bases[i], frames, state: &y[part.clone()] };
            model.bodies[body].slope(now, &self.workspace.wrenches[sections], ground, &mut out[part]);
        }
    }

    fn size2(&self, d: &[f64]) -> f64 {
        let omega2 = self.scale.omega * self.scale.omega;
        let mut sum = 0.0;
        for (i, &body) in self.system.bodies.iter().enumerate() {
            let [place, speed] = self.model.bodies[body].size2(&d[self.system.layout.range(i)]);
            // A sum, not a maximum: a NaN propagates and rejects the step.
            sum += (speed + omega2 * place) / (self.scale.speed * self.scale.speed);
        }
        let angles = d[self.system.layout.len()..].iter().zip(self.angles);
        sum + angles.map(|(d, allowed)| (d / allowed) * (d / allowed)).sum::<f64>()
    }
}

impl ImplicitSystem for EquationsOfMotion<'_> {
    fn hold(&self, difference: &mut [f64]) {
        for (i, &body) in self.system.bodies.iter().enumerate() {
            self.model.bodies[body].hold(&mut difference[self.system.layout.range(i)]);
        }
    }

    fn position_blocks(&self) -> impl Iterator<Item = PositionBlock> {
        self.system.bodies.iter().enumerate().map(|(i, &body)| {
            let Range { start: from, end: until } = self.system.layout.range(i);
            PositionBlock { from, velocities: from + self.model.bodies[body].positions(), until }
        })
    }

    fn rate_bound(&self) -> f64 {
        self.scale.omega.max(quickest(self.model, &self.system.active, &self.system.links))
    }

    fn relative_tolerance(&self) -> f64 {
        self.model.tolerance
    }

    fn auxiliary_count(&self) -> usize {
        self.system.active.iter().filter(|a| a.angle.is_some()).count()
    }

    fn auxiliary_rates(&self) -> &[f64] {
        &self.workspace.rates
    }

    fn port_count(&self) -> usize {
        self.workspace.sliding.sliders.len()
    }

    fn rank_one_terms(&self) -> &[RankOneTerm] {
        &self.workspace.sliding.channels
    }

    fn freeze(&mut self, held: bool) {
        self.workspace.sliding.held = held;
    }

    fn port(&self, slider: usize, y: &[f64], push: &mut [f64], view: &mut [f64]) {
        let Some(active) = self.workspace.sliding.sliders.get(slider).map(|&i| &self.system.active[i]) else { return };
        // Faces of planar scenes have one direction of sliding.
        if self.model.kind == Kind::Planar {
            return;
        }
        let n = push.len() / 2;
        let site = &self.model.contacts[active.site];
        let own = self.model.sections(active.site);
        let frames = [(active.node, own[0]), (active.face, own[1])].map(|(side, section)| {
            side.map_or(site.stand, |i| {
                self.model.bodies[self.system.bodies[i]].frame_since(section, &y[self.system.layout.range(i)])
            })
        });
        let turned = active.turned(y);
        let action = contact_force::act_in(&active.home, &turned, &turned.mode, &frames[0], &frames[1]);
        let sides = [(active.node, action.node_arm, 1.0), (active.face, action.face_arm, -1.0)];
        for (axis, along) in [active.home.axes.x_axis, active.home.axes.y_axis].into_iter().enumerate() {
            let along = frames[1].turn(along);
            for (which, (side, arm, sign)) in sides.into_iter().enumerate() {
                let Some(i) = side else { continue };
                let body = &self.model.bodies[self.system.bodies[i]];
                let here = self.system.bases[i].whole(&frames[which]);
                let columns = [&mut *push, &mut *view].map(|all| &mut all[axis * n..][self.system.layout.range(i)]);
                body.port(Point { section: own[which], frame: &here, arm }, along * sign, columns);
            }
        }
    }

    fn increment_scale(&self, i: usize, y: f64) -> f64 {
        let Some((index, component)) = self.system.layout.body_of(i) else { return 1.0 };
        let body = &self.model.bodies[self.system.bodies[index]];
        y.abs().max(body.increment_scale(component, self.scale.place, self.scale.omega))
    }
}

#[cfg(test)]
mod tests;
