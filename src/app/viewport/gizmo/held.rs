//! Held handle, and the result of a pull on it.

use egui::{Id, Pos2};
use glam::DVec3;

use super::pull::{self, Pull, Pulled};
use super::snap;
use crate::app::command::Grip;
use crate::app::viewport::eye::Eye;
use crate::scene::{Girder, Scene};
use crate::view::Target;

/// Snaps to lines nearer than this \[points\].
const SNAP: f64 = 8.0;

/// Held handle.
#[derive(Clone, Debug)]
pub(in crate::app) struct Held {
    /// Of what.
    pub(in crate::app) grip: Grip,
    /// Where the mouse took it, on its plane \[m\].
    pub(in crate::app) from: DVec3,
    /// The scene then: the way is counted from there, so that nothing drifts.
    pub(in crate::app) scene: Box<Scene>,
    /// Selection at the start of the pull.
    pub(in crate::app) selected: Vec<Target>,
    /// The same for all edits of this pull.
    pub(in crate::app) gesture: u64,
    /// Whether it is held by keys alone.
    pub(in crate::app) by_keys: bool,
}

/// How a mouse pulls.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::app) struct Manner {
    /// Without snapping.
    pub(in crate::app) free: bool,
    /// A [`FINE`]th of the mouse's way, without snapping: gaps of a bridge seen as a whole are less than a point wide.
    pub(in crate::app) fine: bool,
}

/// The mouse's way over that of a fine pull \[–\]. Chosen: 10 m of a whole bridge are then a gap with its movement.
const FINE: f64 = 50.0;

/// Result of a pull, with the mouse at `at`.
pub(in crate::app) fn pull(held: &Held, eye: &Eye, at: Pos2, manner: Manner) -> Option<Pulled> {
    let to = on_way(held.grip, eye, at, held.from)?;
    let (to, point) = if manner.fine {
        (held.from + (to - held.from) / FINE, eye.metres_per_point(to) / FINE)
    } else {
        (to, eye.metres_per_point(to))
    };
    let reach = if manner.free || manner.fine { 0.0 } else { SNAP * point };
    let (scene, selected) = (&*held.scene, &held.selected[..]);
    let step = snap::round_step(point);
    pull::pulled(held.grip, &Pull { scene, selected, from: held.from, to, step, reach, typed: None })
}

/// Where a place on the screen is on the way that a handle goes, which is at `from` \[m\].
pub(in crate::app) fn on_way(grip: Grip, eye: &Eye, at: Pos2, from: DVec3) -> Option<DVec3> {
    if grip.is_upright() { eye.on_upright(at, from) } else { eye.on_level(at, from.z) }
}

/// How far a new girder snaps from where it stands, and to what; a `point` of the screen is so many metres.
pub(in crate::app) fn snapped(scene: &Scene, new: &Girder, point: f64, free: bool) -> (DVec3, Vec<String>) {
    if free {
        return (DVec3::ZERO, Vec::new());
    }
    // Its own gap means nothing yet: only those that there were count.
    let (reach, gaps) = (SNAP * point, snap::usual_gaps(scene));
    let (mut with, number) = (scene.clone(), scene.girders.len());
    with.girders.push(new.clone());
    let found = snap::moved(&with, &[Target::Girder(number)], number, glam::DVec2::ZERO, (reach, &gaps));
    (found.way.extend(0.0), found.words)
}

/// Widget id of a handle.
pub(in crate::app) fn handle_id(grip: Grip) -> Id {
    Id::unique(("handle", grip))
}
