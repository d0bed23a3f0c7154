//! Where the camera stands to see a part of the scene at the time shown: a girder, a corner, an end, a contact.

use glam::DVec3;

use crate::app::command::Look;
use crate::app::viewport::picture::{Viewport, bounds_of};
use crate::app::viewport::seen::Seen;
use crate::geometry::Prism;
use crate::scene::ViewPreset;
use crate::sim::History;
use crate::view::{Bounds, Camera, Target};

/// Half the side of the box about a corner that is looked at, in radii of the scene.
const ABOUT_A_CORNER: f64 = 0.15;

impl Viewport {
    /// Turns to a part of the scene; stays where there is no such thing.
    pub(in crate::app) fn look(&mut self, seen: &Seen<'_>, look: Look) {
        let (scene, history) = seen.shown();
        let aspect = self.aspect();
        let margin = ABOUT_A_CORNER * Bounds::of_scene(scene).radius();
        let corners = |girder: usize, which: &[usize]| {
            let places: Vec<DVec3> = which.iter().filter_map(|c| corner(history?, girder, *c, seen.t())).collect();
            (!places.is_empty()).then(|| Bounds::of_points(places).grown(margin))
        };
        let bounds = match look {
            Look::Girder(girder) => Some(bounds_of(seen, &[Target::Girder(girder)])),
            Look::Corner(girder, which) => corners(girder, &[which]),
            Look::End(girder, end) => corners(girder, &Prism::end_corners(end)),
            Look::Contact(number) => {
                let there = history.and_then(|history| Camera::of_contact(history, number, seen.t(), aspect));
                if let Some(camera) = there {
                    self.set_camera(camera);
                }
                None
            }
        };
        if let Some(bounds) = bounds {
            self.set_camera(Camera::preset(ViewPreset::Top, bounds, aspect));
        }
    }
}

/// Where a corner of a girder is at mid-depth \[m\].
fn corner(history: &History, girder: usize, which: usize, t: f64) -> Option<DVec3> {
    let body = history.model().bodies.get(girder)?;
    let motion = history.motion(girder, t);
    Some(motion.place + motion.attitude * body.prism.plan_corners().get(which)?.extend(0.0))
}
