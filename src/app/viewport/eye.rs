//! Between the screen and the world: where a point is seen, and which point is meant by a place on the screen.

use egui::{Pos2, Rect, Vec2};
use glam::DVec3;

use crate::view::Camera;

/// sin² of the angle between the line of sight and an upright line below which a point of that line is not told: 2°, where a point of the
/// screen is 30 times as far along the line as beside it.
const LEAST_BESIDE: f64 = 1e-3;

/// The camera of the view, and the view's place on the screen.
#[derive(Clone, Copy)]
pub(in crate::app) struct Eye {
    /// From where.
    pub(in crate::app) camera: Camera,
    /// Where on the screen.
    pub(in crate::app) rect: Rect,
}

impl Eye {
    /// Where a point of the world is on the screen.
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    pub(in crate::app) fn at(&self, world: DVec3) -> Option<Pos2> {
        let size = [f64::from(self.rect.width()), f64::from(self.rect.height())];
        let [x, y] = self.camera.project(world, size)?;
        // Far outside a place is only ever clipped: keep it finite.
        Some(self.rect.min + Vec2::new(x.clamp(-1e5, 1e5) as f32, y.clamp(-1e5, 1e5) as f32))
    }

    /// Which way on the screen a direction goes at a point, with a length of 1; zero when it goes into the eye.
    pub(in crate::app) fn way(&self, from: DVec3, along: DVec3) -> Vec2 {
        let little = self.metres_per_point(from);
        let ends = self.at(from).zip(self.at(from + along * little * 10.0));
        ends.map_or(Vec2::ZERO, |(a, b)| b - a).normalized()
    }

    /// Metres to a point of the screen.
    pub(in crate::app) fn metres_per_point(&self, at: DVec3) -> f64 {
        self.camera.metres_per_pixel(at, f64::from(self.rect.height()))
    }

    /// The point of the upright line through a point that is nearest to the line of sight; `None` where that goes down the line.
    pub(in crate::app) fn on_upright(&self, at: Pos2, through: DVec3) -> Option<DVec3> {
        let aspect = f64::from(self.rect.width() / self.rect.height().max(1.0));
        let (start, along) = self.camera.ray(ndc(self.rect, at), aspect);
        // Square to both lines: of `through + s z − start`, the part beside the ray is least.
        let beside = DVec3::Z - along * along.z;
        let s = (start - through).dot(beside) / beside.z;
        (beside.z > LEAST_BESIDE && s.is_finite()).then(|| through + DVec3::Z * s)
    }

    /// Where the line of sight meets the level plane; seen edge-on, the upright plane through the camera's target.
    pub(in crate::app) fn on_level(&self, at: Pos2, height: f64) -> Option<DVec3> {
        let aspect = f64::from(self.rect.width() / self.rect.height().max(1.0));
        let (start, along) = self.camera.ray(ndc(self.rect, at), aspect);
        let (through, normal) = if along.z.abs() > 0.05 {
            (DVec3::new(self.camera.target.x, self.camera.target.y, height), DVec3::Z)
        } else {
            (self.camera.target, self.camera.basis().back)
        };
        let s = (through - start).dot(normal) / along.dot(normal);
        (s.is_finite() && s > 0.0).then(|| start + along * s)
    }
}

/// `[-1, 1]` across a rectangle, y up.
pub(in crate::app) fn ndc(rect: Rect, at: egui::Pos2) -> [f64; 2] {
    let from_centre = (at - rect.center()) / (rect.size() / 2.0);
    [f64::from(from_centre.x), -f64::from(from_centre.y)]
}
