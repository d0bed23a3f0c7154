//! Equations of motion of an island (`docs/physics.md#rigid-body`) as a system for the integrators: the vector holds
//! the states of the bodies, then the slip angles, then the memories of devices that change.

use std::ops::Range;

use crate::dynamics::Model;
use crate::dynamics::connection::Evolution;
use crate::dynamics::integrator::system::{ImplicitSystem, PositionBlock, RankOneTerm, System};
use crate::dynamics::model::body::Point;
use crate::dynamics::model::coordinates::state_layout::BodyComponent;
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::penalty3d::contact_force;
use crate::dynamics::penalty3d::coupled_system::CoupledSystem;
use crate::dynamics::penalty3d::implicit_cost;
use crate::dynamics::penalty3d::island_kind::IslandKind;
use crate::dynamics::penalty3d::workspace::Workspace;
use crate::motion::{Ground, LinearPiece};
use crate::scene::Kind;

/// Error scale of a step, in speeds: displacements and angles enter times frequency and length.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::dynamics) struct ErrorScale {
    /// Allowed error of a speed \[m/s\].
    pub speed: f64,
    /// Largest circular frequency \[rad/s\].
    pub omega: f64,
    /// Largest distance of a point of the moving bodies from their reference poses \[m\].
    pub size: f64,
}

/// Right-hand side of an island.
#[derive(Debug)]
pub(in crate::dynamics) struct EquationsOfMotion<'a> {
    /// Constant data of the scene.
    pub model: &'a Model,
    /// Bodies and the connections that act on them.
    pub system: &'a CoupledSystem,
    /// Kind of the island that they form.
    pub kind: &'a IslandKind,
    /// Interval of the ground motion that contains the step.
    pub piece: LinearPiece,
    /// Beginning of the step: up to its end no support's motion has a kink \[s\].
    pub since: f64,
    /// Error scale.
    pub scale: ErrorScale,
    /// Allowed error of each slip angle \[rad\], then of each memory of a device (its unit).
    pub auxiliary_errors: &'a [f64],
    /// Workspace.
    pub workspace: &'a mut Workspace,
}

impl EquationsOfMotion<'_> {
    fn ground(&self, t: f64) -> GroundNow {
        let acceleration = match &self.model.ground {
            Ground::Record { .. } => self.piece.acceleration(t),
            other => other.acceleration(t),
        };
        GroundNow { acceleration, t, since: self.since }
    }
}

impl EquationsOfMotion<'_> {
    /// The port of a device whose memory is a state: its first axis is that of the memory's force, its second that of the
    /// relative velocity which changes the memory.
    fn device_port(&self, number: usize, y: &[f64], input: &mut [f64], output: &mut [f64]) {
        let Some(link) = self.system.evolving().nth(number) else { return };
        let mut frames = Vec::with_capacity(self.system.layout.section_count());
        for (i, &body) in self.system.bodies.iter().enumerate() {
            self.model.bodies[body].push_frames(&y[self.system.layout.range(i)], &mut frames);
        }
        let (motion, arms) = link.motion(self.model, &self.system.bases, &frames);
        let Evolution { force, drive, .. } = link.link(self.model).device.evolution(&link.phase_in(y), &motion);
        let n = input.len() / 2;
        for (axis, along) in [force, drive].into_iter().enumerate() {
            let along = link.in_world(self.model, &self.system.bases, &frames, along.normalize_or_zero());
            for (end, sign) in [1.0, -1.0].into_iter().enumerate() {
                let Some(i) = link.ends[end] else { continue };
                let body = &self.model.bodies[self.system.bodies[i]];
                let section = link.sections[end];
                let here = self.system.bases[i].whole(&frames[section]);
                let columns = [&mut *input, &mut *output].map(|all| &mut all[axis * n..][self.system.layout.range(i)]);
                let own = section - self.system.layout.sections(i).start;
                body.port(Point { section: own, frame: &here, arm: arms[end] }, along * sign, columns);
            }
        }
    }
}

impl System for EquationsOfMotion<'_> {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        self.workspace.clear();
        let ground = self.ground(t);
        self.kind.rates(self.model, self.system, ground, y, self.workspace, out);
    }

    fn size2(&self, d: &[f64]) -> f64 {
        let omega2 = self.scale.omega * self.scale.omega;
        let mut sum = 0.0;
        for (i, &body) in self.system.bodies.iter().enumerate() {
            let [place, speed] = self.model.bodies[body].size2(&d[self.system.layout.range(i)]);
            // A sum, not a maximum: a NaN propagates and rejects the step.
            sum += (speed + omega2 * place) / (self.scale.speed * self.scale.speed);
        }
        let auxiliary = d[self.system.layout.len()..].iter().zip(self.auxiliary_errors);
        sum + auxiliary.map(|(d, allowed)| (d / allowed) * (d / allowed)).sum::<f64>()
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
        self.scale.omega.max(self.system.largest_decay_rate).max(self.system.modal.change)
    }

    fn relative_tolerance(&self) -> f64 {
        self.model.tolerance
    }

    fn implicit_cost(&self) -> f64 {
        implicit_cost::over_rigid(self.system.layout.len(), self.system.bodies.len())
    }

    fn auxiliary_count(&self) -> usize {
        let angles = self.system.active.iter().filter(|a| a.angle.is_some()).count();
        angles + self.system.evolving().count()
    }

    fn auxiliary_rates(&self) -> &[f64] {
        &self.workspace.rates
    }

    fn port_count(&self) -> usize {
        self.workspace.sliding.sliders.len() + self.system.evolving().count()
    }

    fn rank_one_terms(&self) -> &[RankOneTerm] {
        self.workspace.sliding.terms()
    }

    fn freeze(&mut self, held: bool) {
        self.workspace.sliding.freeze(held);
    }

    fn port(&self, port: usize, y: &[f64], input: &mut [f64], output: &mut [f64]) {
        let sliders = &self.workspace.sliding.sliders;
        if let Some(number) = port.checked_sub(sliders.len()) {
            return self.device_port(number, y, input, output);
        }
        let active = &self.system.active[sliders[port]];
        // Faces of planar scenes have one direction of sliding.
        if self.model.kind == Kind::Planar {
            return;
        }
        let n = input.len() / 2;
        let site = &self.model.sites[active.site];
        let own = self.model.sections(active.site);
        let frames = [(active.ends[0], own[0]), (active.ends[1], own[1])].map(|(side, section)| {
            side.map_or(site.stand, |i| {
                self.model.bodies[self.system.bodies[i]].frame_since(section, &y[self.system.layout.range(i)])
            })
        });
        let turned = active.state_in(y);
        let action = contact_force::act_in(&active.geometry, &turned, &turned.mode, &frames[0], &frames[1]);
        let sides = [(active.ends[0], action.node_arm, 1.0), (active.ends[1], action.face_arm, -1.0)];
        for (axis, along) in action.tangents(&active.geometry, &frames[1]).into_iter().enumerate() {
            for (which, (side, arm, sign)) in sides.into_iter().enumerate() {
                let Some(i) = side else { continue };
                let body = &self.model.bodies[self.system.bodies[i]];
                let here = self.system.bases[i].whole(&frames[which]);
                let columns = [&mut *input, &mut *output].map(|all| &mut all[axis * n..][self.system.layout.range(i)]);
                body.port(Point { section: own[which], frame: &here, arm }, along * sign, columns);
            }
        }
    }

    fn increment_scale(&self, i: usize, y: f64) -> f64 {
        let Some(BodyComponent { body, component }) = self.system.layout.component(i) else { return 1.0 };
        let body = &self.model.bodies[self.system.bodies[body]];
        y.abs().max(body.increment_scale(component, self.scale.size, self.scale.omega))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Body;
    use crate::dynamics::model::coordinates::planar::WIDTH;
    use crate::dynamics::model::coordinates::state_layout::StateLayout;
    use crate::dynamics::model::reference_pose::ReferencePose;
    use crate::dynamics::penalty3d::active_contact::ActiveContact;
    use crate::dynamics::penalty3d::coupled_system::Members;
    use crate::dynamics::penalty3d::example::{closed, stick, wall};

    /// Squared norm of an error.
    fn size2(model: &Model, active: &[ActiveContact], error: &[f64], scale: ErrorScale) -> f64 {
        let bodies: Vec<usize> = (0..model.bodies.len()).collect();
        let bases: Vec<ReferencePose> = model.bodies.iter().map(Body::placed).collect();
        let layout = StateLayout::of(model.bodies.iter());
        let members = Members { bodies, bases, active: active.to_vec(), ..Members::default() };
        let system = CoupledSystem::without_rates(members, layout, Vec::new());
        let equations = EquationsOfMotion {
            kind: &IslandKind::General,
            model,
            system: &system,
            piece: model.ground.piece(model.ground.piece_number(0.0)),
            since: 0.0,
            scale,
            auxiliary_errors: &[],
            workspace: &mut Workspace::of(active),
        };
        equations.size2(error)
    }

    #[test]
    fn an_error_of_the_allowed_speed_has_norm_one() {
        let (model, active) = closed(&wall(), stick);
        let scale = ErrorScale { speed: 1e-6, omega: 500.0, size: 1.0 };
        let norm = |y: [f64; WIDTH]| size2(&model, &active, &y, scale);
        assert!((norm([0.0, 0.0, 0.0, 1e-6, 0.0, 0.0]) - 1.0).abs() < 1e-14, "of velocity");
        assert!((norm([0.0, 1e-6 / 500.0, 0.0, 0.0, 0.0, 0.0]) - 1.0).abs() < 1e-14, "of position, by ω");
        assert!(norm([f64::NAN; WIDTH]).is_nan(), "NaN is not hidden");
    }
}
