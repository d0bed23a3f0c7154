//! The general kind of island: bodies with all their coordinates under the forces of all their contacts and devices
//! (`docs/physics.md#rigid-body`).

use crate::contact::Mode;
use crate::dynamics::Model;
use crate::dynamics::model::body::Counted;
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::model::wrench::Wrench;
use crate::dynamics::penalty3d::active_contact::direction;
use crate::dynamics::penalty3d::contact_force;
use crate::dynamics::penalty3d::coupled_system::CoupledSystem;
use crate::dynamics::penalty3d::workspace::Workspace;

/// Derivative of a state `y`: of the bodies under the ground's motion, then of the slip angles and of the memories of devices.
pub(in crate::dynamics) fn rates(
    model: &Model,
    system: &CoupledSystem,
    ground: GroundNow,
    y: &[f64],
    workspace: &mut Workspace,
    out: &mut [f64],
) {
    for (i, &body) in system.bodies.iter().enumerate() {
        let acted_on = &system.acted_on[system.layout.sections(i)];
        model.bodies[body].push_frames_of(acted_on, &y[system.layout.range(i)], &mut workspace.frames);
    }
    workspace.wrenches.resize(workspace.frames.len(), Wrench::default());
    add_contacts(model, system, y, workspace, out);
    add_devices(model, system, y, workspace, out);
    for (i, &body) in system.bodies.iter().enumerate() {
        let (part, sections) = (system.layout.range(i), system.layout.sections(i));
        let frames = &workspace.frames[sections.clone()];
        let now = Counted { base: &system.bases[i], frames, state: &y[part.clone()] };
        model.bodies[body].slope(now, &workspace.wrenches[sections], ground, &mut out[part]);
    }
}

/// Adds the forces of devices to the wrenches on their bodies, and writes the rates of their memories.
fn add_devices(model: &Model, system: &CoupledSystem, y: &[f64], workspace: &mut Workspace, out: &mut [f64]) {
    let mut port = workspace.sliding.sliders.len();
    for link in &system.links {
        let placing = (model, &system.bases[..]);
        if let Some((at, evolution)) = link.push(placing, y, &workspace.frames, &mut workspace.wrenches) {
            out[at] = evolution.rate;
            workspace.rates.push(evolution.decay);
            workspace.sliding.add_memory_term([port, workspace.rates.len() - 1], &evolution);
            port += 1;
        }
    }
}

/// Adds the forces of closed contacts to the wrenches on both of their bodies, and enters the rates of slip angles.
fn add_contacts(model: &Model, system: &CoupledSystem, y: &[f64], workspace: &mut Workspace, out: &mut [f64]) {
    let mut slider = 0;
    for active in &system.active {
        let site = &model.sites[active.site];
        let node = active.ends[0].map_or(&site.stand, |_| &workspace.frames[active.sections[0]]);
        let face = active.ends[1].map_or(&site.stand, |_| &workspace.frames[active.sections[1]]);
        let held = workspace.sliding.frozen_contact(slider, active);
        let closed = held.as_ref().unwrap_or(&active.closed);
        let mode = active.angle.map_or(closed.mode, |at| Mode::Slip { direction: direction(y[at]) });
        let action = contact_force::act_in(&active.geometry, closed, &mode, node, face);
        if active.ends[0].is_some() {
            workspace.wrenches[active.sections[0]].push_with(action.force, action.node_arm, action.couple);
        }
        if active.ends[1].is_some() {
            workspace.wrenches[active.sections[1]].push_with(-action.force, action.face_arm, -action.couple);
        }
        if let (Some(at), Mode::Slip { direction }) = (active.angle, mode) {
            let length = closed.law.slip_stretch(&action.here) + closed.solver.regularisation;
            out[at] = direction.perp_dot(action.here.rate) / length;
            workspace.rates.push(-direction.dot(action.here.rate) / length);
            workspace.sliding.add_slip_angle_term(
                [slider, workspace.rates.len() - 1],
                closed,
                direction,
                &action,
                length,
            );
            slider += 1;
        } else if active.slides_along_velocity() {
            if held.is_none() {
                workspace.sliding.add_direction_terms(slider, closed, &action.forces);
            }
            slider += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::dynamics::Body;
    use crate::dynamics::model::coordinates::planar::WIDTH;
    use crate::dynamics::model::coordinates::state_layout::StateLayout;
    use crate::dynamics::penalty3d::active_contact::ActiveContact;
    use crate::dynamics::penalty3d::coupled_system::Members;
    use crate::dynamics::penalty3d::example::{MASS, closed, row, stick, wall};

    /// Rates of states relative to the placed poses.
    fn rates(model: &Model, active: &[ActiveContact], y: &[f64]) -> Vec<f64> {
        let bodies: Vec<usize> = (0..model.bodies.len()).collect();
        let bases = model.bodies.iter().map(Body::placed).collect();
        let layout = StateLayout::of(model.bodies.iter());
        let members = Members { bodies, bases, active: active.to_vec(), ..Members::default() };
        let system = CoupledSystem::without_rates(members, layout, Vec::new());
        let mut out = vec![0.0; y.len()];
        super::rates(model, &system, GroundNow::of(DVec3::ZERO), y, &mut Workspace::of(active), &mut out);
        out
    }

    #[test]
    fn the_force_of_a_contact_accelerates_its_body() {
        let (model, active) = closed(&wall(), stick);
        let y = [1e-3, 2e-4, 0.0, 0.3, 0.1, 0.0];
        let out = rates(&model, &active, &y);
        let frame = model.bodies[0].planar_frame(&y);
        let force = |a: &ActiveContact| {
            let site = &model.sites[a.site];
            contact_force::act(site, &a.closed, &frame, &site.stand).force
        };
        let total: DVec3 = active.iter().map(force).sum();
        assert!(total.x < -100.0 && total.y < -10.0, "spring and friction act: {total} N");
        for (axis, rate) in [out[3], out[4]].into_iter().enumerate() {
            assert!((rate * MASS - total[axis]).abs() <= 1e-13 * total.length(), "m a is {} N", rate * MASS);
        }
        assert_eq!([out[0], out[1]], [0.3, 0.1], "places move with the velocity");
    }

    #[test]
    fn contacts_between_two_bodies_keep_their_momentum() {
        let (model, active) = closed(&row(), stick);
        assert_eq!(active.len(), 4, "two corners of either girder");
        let y = [1e-3, 2e-4, 0.0, 0.3, 0.1, 0.0, -5e-4, -1e-4, 0.0, -0.2, 0.05, 0.0];
        let out = rates(&model, &active, &y);
        for axis in [3, 4] {
            let (one, two) = (MASS * out[axis], MASS * out[WIDTH + axis]);
            assert!(one.abs() > 1.0, "a force acts");
            assert!((one + two).abs() <= 1e-13 * one.abs(), "{one} N and {two} N");
        }
    }
}
