//! Laws of a scene's devices.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::{Bumper, Failure, MaxwellDamper, Restrainer, Stopper, ViscousDamper, Yielding};
use crate::dynamics::connection::{Device, Kinematics};
use crate::scene::device::Joint;
use crate::scene::{self, Device as Placed};

/// A law between the two points of a device.
#[derive(Clone, Debug)]
pub struct PlacedLaw {
    /// Ending of the connection's name, appended to the device's; empty for a single law.
    pub suffix: &'static str,
    /// Axes of its displacement and force, in the columns, world axes as placed.
    pub axes: DMat3,
    /// Measure of the relative motion of its points.
    pub kinematics: Kinematics,
    /// The law.
    pub device: Arc<dyn Device>,
}

/// The laws of a device between points as placed: a stopper has one a side. None where the scene was not checked and its numbers
/// make no law.
pub fn laws(device: &Placed, joint: &Joint) -> Vec<PlacedLaw> {
    match device {
        Placed::Restrainer(placed) => restrainer(placed, joint).into_iter().collect(),
        Placed::Bumper(placed) => bumper(placed, joint).into_iter().collect(),
        Placed::Damper(placed) => vec![damper(placed)],
        Placed::Stopper(placed) => stopper(placed, joint),
    }
}

/// Along the line between the points.
fn along_the_line(device: impl Device + 'static) -> PlacedLaw {
    PlacedLaw { suffix: "", axes: DMat3::IDENTITY, kinematics: Kinematics::Points, device: Arc::new(device) }
}

/// Along a direction that turns with the second body.
fn along(direction: DVec3, suffix: &'static str, device: impl Device + 'static) -> PlacedLaw {
    let level = DVec3::Z.cross(direction).try_normalize().unwrap_or(DVec3::X);
    let axes = DMat3::from_cols(direction, level, direction.cross(level));
    PlacedLaw { suffix, axes, kinematics: Kinematics::Carried, device: Arc::new(device) }
}

fn restrainer(placed: &scene::Restrainer, joint: &Joint) -> Option<PlacedLaw> {
    let stiffness = placed.stiffness(joint)?;
    let after = placed.post_yield_stiffness.unwrap_or(0.0);
    Some(along_the_line(Restrainer {
        length: joint.length(),
        slack: placed.slack,
        stiffness,
        yielding: placed.yield_force.map(|force| Yielding { force, stiffness: after }),
        break_elongation: placed.break_elongation.unwrap_or(f64::INFINITY),
    }))
}

fn bumper(placed: &scene::Bumper, joint: &Joint) -> Option<PlacedLaw> {
    let normal = placed.normal(joint)?;
    let [gap, distance] = placed.gaps(joint)?;
    let law = Bumper::new(gap - distance, &placed.depths_and_forces(), placed.damping)?;
    Some(along(normal, "", law))
}

fn damper(placed: &scene::Damper) -> PlacedLaw {
    let scene::Damper { coefficient, exponent, regularisation, .. } = *placed;
    match placed.brace_stiffness {
        Some(stiffness) => along_the_line(MaxwellDamper { coefficient, exponent, stiffness }),
        None => along_the_line(ViscousDamper { coefficient, exponent, regularisation }),
    }
}

fn stopper(placed: &scene::Stopper, joint: &Joint) -> Vec<PlacedLaw> {
    let Some(direction) = placed.direction(joint) else { return Vec::new() };
    let failure = match (placed.break_force, placed.yield_force) {
        (Some(force), _) => Failure::Brittle { force },
        (None, Some(force)) => {
            Failure::Ductile { force, displacement: placed.break_displacement.unwrap_or(f64::INFINITY) }
        }
        (None, None) => Failure::Never,
    };
    let from = joint.span().dot(direction);
    let side = |(sign, gap): (f64, f64)| {
        let law = Stopper { gap: gap + sign * from, stiffness: placed.stiffness, failure };
        along(direction * sign, if sign > 0.0 { "+" } else { "-" }, law)
    };
    placed.stops().into_iter().map(side).collect()
}
