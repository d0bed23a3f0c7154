//! Visible part of a scene, by which a view that has lost it is noticed.

use glam::DVec3;

use super::Camera;
use super::block::{Block, girder_block};
use super::camera::Projection;
use crate::scene::Scene;

/// Girders that are smaller than this share of the picture's side, all of them together, are a dot.
const DOT: f64 = 0.06;

/// Part of the girders of a scene, as placed, that is in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum InView {
    /// Nothing, or a dot, or the eye is inside of one.
    Nothing,
    /// A part.
    Part,
    /// Everything, and everything there is where there is none.
    Whole,
}

/// Part of a scene's girders that is in a picture of this width over height.
pub fn in_view(scene: &Scene, camera: &Camera, aspect: f64) -> InView {
    let lens = Lens::of(camera, aspect);
    let (mut low, mut high, mut whole) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2], true);
    for block in scene.girders.iter().map(girder_block) {
        if lens.is_inside(&block) {
            return InView::Nothing;
        }
        let faces = faces(&block).map(|face| face.map(|corner| lens.clip(corner)));
        whole &= faces.iter().flatten().all(|corner| INSIDE.iter().all(|side| side(*corner) >= 0.0));
        for corner in faces.iter().flat_map(clipped).filter(|corner| corner.z > 0.0) {
            let at = [corner.x / corner.z, corner.y / corner.z];
            low = [0, 1].map(|i| low[i].min(at[i]));
            high = [0, 1].map(|i| high[i].max(at[i]));
        }
    }
    let side = [0, 1].map(|i| (high[i] - low[i]) / 2.0).into_iter().fold(0.0, f64::max);
    match whole {
        _ if scene.girders.is_empty() => InView::Whole,
        _ if side < DOT => InView::Nothing,
        true => InView::Whole,
        false => InView::Part,
    }
}

/// From the world to the picture: x and y over z are the place in it, each `[-1, 1]`.
struct Lens {
    eye: Option<DVec3>,
    target: DVec3,
    axes: [DVec3; 3],
    half: [f64; 2],
    distance: f64,
}

impl Lens {
    fn of(camera: &Camera, aspect: f64) -> Self {
        let basis = camera.basis();
        let half = camera.visible_height() / (2.0 * camera.distance);
        Self {
            eye: matches!(camera.projection, Projection::Perspective { .. }).then(|| camera.eye()),
            target: camera.target,
            axes: [basis.right, basis.up, -basis.back],
            half: [half * aspect.max(1e-3), half],
            distance: camera.distance,
        }
    }

    fn clip(&self, world: DVec3) -> DVec3 {
        let [right, up, ahead] = self.axes.map(|axis| axis.dot(world - self.eye.unwrap_or(self.target)));
        let depth = if self.eye.is_some() { ahead } else { self.distance };
        DVec3::new(right / self.half[0], up / self.half[1], depth)
    }

    /// Whether the eye is inside of a block: then there is nothing of it to be seen.
    fn is_inside(&self, block: &Block) -> bool {
        self.eye.is_some_and(|eye| block.sides().iter().all(|(normal, point)| normal.dot(eye - *point) < 0.0))
    }
}

/// Functions of a place that are 0 or more inside of the picture, one for each side.
const INSIDE: [fn(DVec3) -> f64; 4] = [|p| p.z - p.x, |p| p.z + p.x, |p| p.z - p.y, |p| p.z + p.y];

/// The six faces of a block \[m\].
fn faces(block: &Block) -> [[DVec3; 4]; 6] {
    let [a, b, c, d] = block.face;
    let s = block.sweep;
    let side = |from: DVec3, to: DVec3| [from, to, to + s, from + s];
    [block.face, block.face.map(|p| p + s), side(a, b), side(b, c), side(c, d), side(d, a)]
}

/// Part of a face inside of the picture, after Sutherland and Hodgman.
fn clipped(face: &[DVec3; 4]) -> Vec<DVec3> {
    let mut polygon = face.to_vec();
    for side in INSIDE {
        let mut kept = Vec::with_capacity(polygon.len() + 1);
        for (i, &here) in polygon.iter().enumerate() {
            let next = polygon[(i + 1) % polygon.len()];
            let (a, b) = (side(here), side(next));
            if a >= 0.0 {
                kept.push(here);
            }
            if (a >= 0.0) != (b >= 0.0) {
                kept.push(here + (next - here) * (a / (a - b)));
            }
        }
        polygon = kept;
    }
    polygon
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{ViewPreset, presets};
    use crate::view::Bounds;

    const ASPECT: f64 = 1.6;

    #[test]
    fn a_framed_scene_is_seen_whole_and_another_size_is_not() {
        let (small, large) = (presets::load("skew45-abutment"), presets::load("deck-30m"));
        let (small, large) = (small.expect("ships"), large.expect("ships"));
        for preset in [ViewPreset::Iso, ViewPreset::Top, ViewPreset::Side] {
            let at = |scene| Camera::preset(preset, Bounds::of_scene(scene), ASPECT);
            for scene in [&small, &large] {
                assert_eq!(in_view(scene, &at(scene), ASPECT), InView::Whole, "{preset:?}: {}", scene.name);
            }
            assert_eq!(in_view(&small, &at(&large), ASPECT), InView::Nothing, "{preset:?}: a dot");
            assert_ne!(in_view(&large, &at(&small), ASPECT), InView::Whole, "{preset:?}: too near");
        }
        let inside = Camera::preset(ViewPreset::Iso, Bounds::of_scene(&small), ASPECT);
        assert_eq!(in_view(&large, &inside, ASPECT), InView::Nothing, "inside of the deck");
    }

    #[test]
    fn a_face_larger_than_the_picture_is_a_part_and_a_camera_turned_away_sees_nothing() {
        let scene = presets::load("deck-30m").expect("ships");
        let mut camera = Camera::preset(ViewPreset::Top, Bounds::of_scene(&scene), ASPECT);
        camera.zoom(0.01);
        assert_eq!(in_view(&scene, &camera, ASPECT), InView::Part, "no corner is seen, the deck is");
        camera.target.x += 100.0;
        assert_eq!(in_view(&scene, &camera, ASPECT), InView::Nothing, "beside it");
        let mut behind = Camera::preset(ViewPreset::Iso, Bounds::of_scene(&scene), ASPECT);
        behind.target = behind.eye() + behind.basis().back * behind.distance;
        behind.yaw += std::f64::consts::PI;
        behind.pitch = -behind.pitch;
        assert_eq!(in_view(&scene, &behind, ASPECT), InView::Nothing, "it looks the other way");
        let empty = Scene { girders: Vec::new(), abutments: Vec::new(), ..scene };
        assert_eq!(in_view(&empty, &camera, ASPECT), InView::Whole, "nothing to lose");
    }
}
