//! The camera that goes out by itself: when an edit takes the scene out of view, and only then.

use crate::scene::Scene;
use crate::view::{Bounds, Camera, InView, in_view};

/// How long it takes \[s\].
const TIME: f64 = 0.25;

/// View before the last edit, and a camera on its way.
#[derive(Clone, Debug, Default)]
pub(super) struct Glide {
    /// Scene by its revision, camera, width over height, and how much was seen then.
    judged: Option<(u64, Camera, f64, InView)>,
    way: Option<Way>,
}

/// A camera on its way.
#[derive(Clone, Copy, Debug)]
struct Way {
    from: Camera,
    to: Camera,
    /// How much of the time has passed, 0 to 1.
    done: f64,
}

impl Glide {
    /// Stays where it is: a hand, or another wish, has taken the camera.
    pub(super) fn stop(&mut self) {
        self.way = None;
    }

    /// Whether the camera is on its way.
    pub(super) fn is_on_its_way(&self) -> bool {
        self.way.is_some()
    }

    /// The camera was put where it is by a wish: what an earlier scene showed says nothing.
    pub(super) fn begin_anew(&mut self) {
        *self = Self::default();
    }

    /// Where the camera goes when less of a scene is seen than before it was edited; a scene that is held is judged when
    /// it is let go.
    pub(super) fn judge(&mut self, camera: &Camera, (scene, revision): (&Scene, u64), aspect: f64) {
        let looked = self.way.map_or(*camera, |way| way.to);
        if self.judged.is_some_and(|(r, c, a, _)| (r, c, a) == (revision, looked, aspect)) {
            return;
        }
        let now = in_view(scene, &looked, aspect);
        let before = self.judged.replace((revision, looked, aspect, now));
        if before.is_some_and(|(of, _, _, before)| of != revision && now < before) {
            let mut to = looked;
            to.frame(Bounds::of_scene(scene), aspect);
            self.way = Some(Way { from: *camera, to, done: 0.0 });
            self.judged = Some((revision, to, aspect, in_view(scene, &to, aspect)));
        }
    }

    /// Where the camera is after `dt` \[s\] more.
    pub(super) fn advance(&mut self, dt: f64) -> Option<Camera> {
        let way = self.way.as_mut()?;
        way.done = (way.done + dt / TIME).min(1.0);
        let camera = between(&way.from, &way.to, way.done);
        if way.done >= 1.0 {
            self.way = None;
        }
        Some(camera)
    }
}

/// A camera between two that look the same way; slow at both ends, the distance by factors.
fn between(from: &Camera, to: &Camera, share: f64) -> Camera {
    if share >= 1.0 {
        return *to;
    }
    let s = share * share * (3.0 - 2.0 * share);
    let distance = from.distance * (to.distance / from.distance).powf(s);
    Camera { target: from.target.lerp(to.target, s), distance, ..*to }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{ViewPreset, presets};

    #[test]
    fn an_edit_that_leaves_the_scene_in_view_leaves_the_camera_and_a_large_one_takes_it_out() {
        let mut scene = presets::load(presets::OPENING).expect("ships");
        let camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(&scene), 1.5);
        let mut glide = Glide::default();
        glide.judge(&camera, (&scene, 1), 1.5);
        scene.girders[0].skew_deg += 5.0;
        glide.judge(&camera, (&scene, 2), 1.5);
        assert!(glide.advance(0.1).is_none(), "still all of it");
        scene.girders[0].length = 30.0;
        glide.judge(&camera, (&scene, 3), 1.5);
        let first = glide.advance(0.1).expect("on its way");
        assert!(first.distance > camera.distance && glide.is_on_its_way(), "out");
        let last = glide.advance(10.0).expect("there");
        assert_eq!(in_view(&scene, &last, 1.5), InView::Whole, "all of it again");
        assert!(!glide.is_on_its_way() && glide.advance(0.1).is_none(), "and there it stays");
    }

    #[test]
    fn where_the_user_has_moved_away_no_edit_brings_the_scene_back() {
        let mut scene = presets::load(presets::OPENING).expect("ships");
        let mut camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(&scene), 1.5);
        camera.target.y += 1e3;
        let mut glide = Glide::default();
        glide.judge(&camera, (&scene, 1), 1.5);
        scene.girders[0].length *= 2.0;
        glide.judge(&camera, (&scene, 2), 1.5);
        assert!(!glide.is_on_its_way(), "it was out of view before");
    }
}
