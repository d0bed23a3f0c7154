//! Camera of the picture: orbiting about a target, in f64.

use glam::{DMat4, DVec3, DVec4, dcamera::rh::proj::directx};

use super::{Bounds, auto_force_scale};
use crate::scene::ViewPreset;
use crate::sim::{ContactNow, History};

/// Field of view that the framing of both projections is reckoned with \[rad\].
const FOV_Y: f64 = 0.5;
/// Pitch stays this far from straight up and down while orbiting, so that "up" stays up \[rad\].
const POLE_MARGIN: f64 = 1e-3;
/// Room around what is framed, as a factor.
const FRAME_MARGIN: f64 = 1.12;
/// Room about the cone and the arrow in the contact view, in radii of the box about them.
const CONTACT_ABOUT: f64 = 0.6;
/// The least room, in radii of the scene: a contact that has just closed has no cone yet.
const CONTACT_LEAST: f64 = 0.05;

/// Projection by distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Far things are smaller.
    Perspective {
        /// Vertical field of view \[rad\].
        fov_y: f64,
    },
    /// True to scale at every depth; as high as a perspective of 0.5 rad sees at the target.
    Orthographic,
}

/// A camera that looks at `target` from `distance`; z is up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Point that it looks at \[m\].
    pub target: DVec3,
    /// Direction from the target to the eye in plan, anticlockwise from world x \[rad\].
    pub yaw: f64,
    /// Height of the eye above the horizon, π/2 is straight from above \[rad\].
    pub pitch: f64,
    /// From the target to the eye \[m\].
    pub distance: f64,
    /// Projection by distance.
    pub projection: Projection,
}

/// Camera axes in the world.
#[derive(Clone, Copy, Debug)]
pub struct Basis {
    /// To the right of the picture.
    pub right: DVec3,
    /// To the top of the picture.
    pub up: DVec3,
    /// Towards the eye.
    pub back: DVec3,
}

impl Camera {
    /// A standing place that sees all of `bounds`.
    pub fn preset(preset: ViewPreset, bounds: Bounds, aspect: f64) -> Self {
        let quarter = std::f64::consts::FRAC_PI_2;
        let (yaw, pitch, projection) = match preset {
            ViewPreset::Iso => (-2.4, 0.6, Projection::Perspective { fov_y: FOV_Y }),
            ViewPreset::Contact => (-1.9, 0.85, Projection::Perspective { fov_y: FOV_Y }),
            ViewPreset::Top => (-quarter, quarter, Projection::Orthographic),
            ViewPreset::Side => (-quarter, 0.0, Projection::Orthographic),
        };
        let mut camera = Self { target: bounds.centre(), yaw, pitch, distance: 1.0, projection };
        camera.frame(bounds, aspect);
        camera
    }

    /// Frames the hardest contact that is closed at `t` with its force, or else that of the hardest touch at its peak.
    ///
    /// The whole scene where nothing ever touches.
    pub fn contact(history: &History, t: f64, aspect: f64) -> Self {
        let mut contacts = history.contacts().at(t);
        if contacts.is_empty() {
            contacts = history.hits().hardest().map(|touch| history.contacts().at(touch.peak_time)).unwrap_or_default();
        }
        match hardest(&contacts) {
            Some(hardest) => Self::square_to(history, hardest, aspect),
            None => Self::preset(ViewPreset::Contact, Bounds::of_scene(history.scene()), aspect),
        }
    }

    /// Frames a contact with its force, where it is closed at `t`.
    pub fn of_contact(history: &History, contact: usize, t: f64, aspect: f64) -> Option<Self> {
        history.contacts().contact_at(contact, t).map(|now| Self::square_to(history, &now, aspect))
    }

    /// Square to a contact, with parallel lines of sight: the contact's normal and friction force lie in the plane of the picture, so
    /// angles between force, normal and cone are true. Where that plane is horizontal, world x points right and y up. The view holds
    /// cone and arrow with a margin.
    fn square_to(history: &History, c: &ContactNow, aspect: f64) -> Self {
        let height = c.normal_force / auto_force_scale(history);
        let normal = c.normal;
        // Without friction, and where the contact parts, the horizontal of the face.
        let level = DVec3::Z.cross(normal).normalize_or(DVec3::X);
        let aside = (c.tangential_force - normal * c.tangential_force.dot(normal)).normalize_or(level);
        let square = normal.cross(aside);
        let back = if square.z < 0.0 { -square } else { square };
        let quarter = std::f64::consts::FRAC_PI_2;
        let in_plan = back.z > 1.0 - 1e-9;
        let (yaw, pitch) =
            if in_plan { (-quarter, quarter) } else { (back.y.atan2(back.x), back.z.clamp(-1.0, 1.0).asin()) };
        let rim = height * c.mu_static.max(c.mu_kinetic);
        let rims = [-1.0, 1.0].map(|side| c.point + normal * height + aside * (side * rim));
        let seen = Bounds::of_points([c.point].into_iter().chain(rims));
        let least = CONTACT_LEAST * Bounds::of_scene(history.scene()).radius();
        let bounds = seen.grown((CONTACT_ABOUT * seen.radius()).max(least));
        let mut camera =
            Self { target: bounds.centre(), yaw, pitch, distance: 1.0, projection: Projection::Orthographic };
        camera.frame(bounds, aspect);
        camera
    }

    /// Its axes in the world.
    pub fn basis(&self) -> Basis {
        let (sy, cy) = self.yaw.sin_cos();
        let (sp, cp) = self.pitch.sin_cos();
        let right = DVec3::new(-sy, cy, 0.0);
        let back = DVec3::new(cp * cy, cp * sy, sp);
        Basis { right, up: back.cross(right), back }
    }

    /// Position of the eye \[m\].
    pub fn eye(&self) -> DVec3 {
        self.target + self.basis().back * self.distance
    }

    /// The eye as a homogeneous point; a direction (w = 0) where lines of sight are parallel.
    pub fn homogeneous_eye(&self) -> DVec4 {
        match self.projection {
            Projection::Perspective { .. } => self.eye().extend(1.0),
            Projection::Orthographic => self.basis().back.extend(0.0),
        }
    }

    /// Turns about the target; `dx`, `dy` are the mouse's way in picture heights, down is positive.
    pub fn orbit(&mut self, dx: f64, dy: f64) {
        let quarter = std::f64::consts::FRAC_PI_2;
        self.yaw = (self.yaw - dx * std::f64::consts::PI).rem_euclid(std::f64::consts::TAU);
        self.pitch = (self.pitch + dy * std::f64::consts::PI).clamp(POLE_MARGIN - quarter, quarter - POLE_MARGIN);
    }

    /// Moves the target so that it follows the mouse; `dx`, `dy` in pixels, down is positive.
    pub fn pan(&mut self, dx: f64, dy: f64, viewport_height: f64) {
        let Basis { right, up, .. } = self.basis();
        let per_pixel = self.visible_height() / viewport_height.max(1.0);
        self.target += (up * dy - right * dx) * per_pixel;
    }

    /// Multiplies the distance: below 1 comes nearer.
    pub fn zoom(&mut self, factor: f64) {
        if factor.is_finite() && factor > 0.0 {
            self.distance = (self.distance * factor).clamp(1e-6, 1e7);
        }
    }

    /// Keeps its direction and sees all of `bounds`, with a margin.
    pub fn frame(&mut self, bounds: Bounds, aspect: f64) {
        self.target = bounds.centre();
        let Basis { right, up, back } = self.basis();
        let tan = self.half_angle().tan();
        let needed = bounds.corners().map(|corner| {
            let p = corner - self.target;
            let depth = if matches!(self.projection, Projection::Orthographic) { 0.0 } else { p.dot(back) };
            depth + FRAME_MARGIN * (p.dot(up).abs() / tan).max(p.dot(right).abs() / (tan * aspect.max(1e-3)))
        });
        self.distance = needed.into_iter().fold(1e-6, f64::max);
    }

    /// World height of the picture at the target \[m\].
    pub fn visible_height(&self) -> f64 {
        2.0 * self.distance * self.half_angle().tan()
    }

    fn half_angle(&self) -> f64 {
        match self.projection {
            Projection::Perspective { fov_y } => fov_y.clamp(0.01, 3.0) / 2.0,
            Projection::Orthographic => FOV_Y / 2.0,
        }
    }

    /// The line of sight through a point of the picture (`[-1, 1]`, y up): a start and a unit direction.
    pub fn ray(&self, ndc: [f64; 2], aspect: f64) -> (DVec3, DVec3) {
        let Basis { right, up, back } = self.basis();
        let half = self.half_angle().tan();
        let aside = right * (ndc[0] * half * aspect) + up * (ndc[1] * half);
        match self.projection {
            Projection::Perspective { .. } => (self.eye(), (aside - back).normalize_or_zero()),
            // From far enough behind the eye that nothing in view lies behind the start.
            Projection::Orthographic => (self.eye() + aside * self.distance + back * self.distance * 1e3, -back),
        }
    }

    /// Pixels from the top left of a picture of `size`; `None` behind the eye.
    pub fn project(&self, world: DVec3, size: [f64; 2]) -> Option<[f64; 2]> {
        let Basis { right, up, back } = self.basis();
        let from_eye = world - self.eye();
        let depth = match self.projection {
            Projection::Perspective { .. } => -from_eye.dot(back),
            Projection::Orthographic => self.distance,
        };
        if depth.is_nan() || depth <= 1e-9 * self.distance {
            return None;
        }
        let scale = size[1] / (2.0 * depth * self.half_angle().tan());
        Some([size[0] / 2.0 + from_eye.dot(right) * scale, size[1] / 2.0 - from_eye.dot(up) * scale])
    }

    /// World length of a pixel at a point \[m\].
    pub fn metres_per_pixel(&self, world: DVec3, viewport_height: f64) -> f64 {
        let depth = match self.projection {
            Projection::Perspective { .. } => (self.eye() - world).dot(self.basis().back).max(1e-3 * self.distance),
            Projection::Orthographic => self.distance,
        };
        2.0 * depth * self.half_angle().tan() / viewport_height.max(1.0)
    }

    /// Clip space (wgpu's: z in `[0, 1]`, y up) from the world, with the depth range that just holds `bounds`.
    pub fn clip_from_world(&self, aspect: f64, bounds: Bounds) -> DMat4 {
        let Basis { right, up, back } = self.basis();
        let eye = self.eye();
        let depths = bounds.corners().map(|p| (eye - p).dot(back));
        let far = depths.iter().copied().fold(f64::NEG_INFINITY, f64::max) + 0.01 * self.distance;
        let near = depths.iter().copied().fold(f64::INFINITY, f64::min) - 0.01 * self.distance;
        let projection = match self.projection {
            Projection::Perspective { .. } => {
                let near = near.max(0.01 * self.distance);
                directx::perspective(2.0 * self.half_angle(), aspect, near, far.max(near * 1.01))
            }
            Projection::Orthographic => {
                let h = self.visible_height() / 2.0;
                directx::orthographic(-h * aspect, h * aspect, -h, h, near, far)
            }
        };
        let view = DMat4::from_cols(right.extend(0.0), up.extend(0.0), back.extend(0.0), eye.extend(1.0));
        projection * view.inverse()
    }
}

/// The hardest of some contacts.
pub(super) fn hardest(contacts: &[ContactNow]) -> Option<&ContactNow> {
    contacts.iter().max_by(|a, b| a.force.length().total_cmp(&b.force.length()))
}
