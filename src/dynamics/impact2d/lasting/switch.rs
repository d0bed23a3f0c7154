//! Events that end an interval of lasting contact, and their switching functions.

use crate::dynamics::Model;
use crate::dynamics::impact2d::constants::BORDER;
use crate::dynamics::impact2d::delassus::centre;
use crate::dynamics::impact2d::kinematics::BodyKinematics;
use crate::dynamics::impact2d::lasting::constrained_motion::{ContactMode, Reaction};

/// Event that ends an interval of lasting contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics::impact2d) enum Ending {
    /// The normal reaction of the declared contact falls to 0.
    Opens(usize),
    /// The declared contact reaches the border of the face.
    LeavesFace(usize),
    /// The tangential reaction of the pair reaches the friction cone.
    BreaksAway(usize),
    /// The slip of the pair reaches 0.
    SlipStops(usize),
    /// The friction that keeps a face pressed at one end on the other reaches the coefficient of the face or that of the corner.
    LeavesEnd(usize),
    /// Other modes agree with Coulomb's law, where those in force are for want of others, or wedged contacts hold no more.
    Superseded,
}

/// A switching function: its event, the contact mode by its place in the list, and which of the kept points.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics::impact2d) struct SwitchingFunction {
    pub mode: usize,
    pub end: usize,
    pub ending: Ending,
}

impl SwitchingFunction {
    /// Normal reaction \[N\], distance from the border of the face \[m\], distance from the friction cone \[N\], or slip \[m/s\].
    pub(in crate::dynamics::impact2d) fn value(
        &self,
        mode: &ContactMode,
        model: &Model,
        kinematics: &BodyKinematics,
        reaction: &Reaction,
    ) -> f64 {
        match self.ending {
            Ending::Opens(_) => reaction.normal[self.end],
            Ending::LeavesFace(site) => kinematics.point(model, site).inset + BORDER * radius(model, mode.pair),
            Ending::BreaksAway(_) => {
                let round_off = 2.0 * kinematics.force_round_off(&centre(&mode.points(model, kinematics)));
                let most = mode.friction_coefficients(&model.impact)[0] * reaction.total() + round_off;
                most - reaction.tangential.abs()
            }
            Ending::LeavesEnd(_) => {
                let round_off = 2.0 * kinematics.force_round_off(&centre(&mode.points(model, kinematics)));
                let (friction, pressure) = (reaction.tangential.abs(), reaction.total());
                let [least, most] = mode.friction_at_end(&model.impact);
                (most * pressure - friction).min(friction - least * pressure) + round_off
            }
            // Found by its own search.
            Ending::Superseded => f64::INFINITY,
            Ending::SlipStops(_) => {
                let centre = centre(&mode.points(model, kinematics));
                mode.friction.slip_sign().unwrap_or(0.0) * kinematics.cluster.speed(&centre, centre.s)
            }
        }
    }
}

/// Smaller radius of the two bodies of a pair \[m\].
fn radius(model: &Model, pair: usize) -> f64 {
    model.pairs[pair].bodies.into_iter().flatten().map(|body| model.bodies[body].radius).fold(f64::INFINITY, f64::min)
}
