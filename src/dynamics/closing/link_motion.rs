//! Relative motion of a link's points on the present trajectories of the bodies at its ends.

use crate::contact::Frame;
use crate::dynamics::connection::Separation;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::LinkTrack;

/// Poses of a link's ends at `t`.
pub(super) fn frames(world: &World, number: usize, t: f64) -> [Frame; 2] {
    let LinkTrack { link, slots, .. } = &world.links[number];
    world.model.links[*link].frames(|end, section| slots[end].map(|slot| world.frame(slot, section, t)))
}

/// Relative motion of a link's points at `t`.
pub(super) fn motion(world: &World, number: usize, t: f64) -> Separation {
    let frames = frames(world, number, t);
    world.model_link(number).motion([&frames[0], &frames[1]]).0
}
