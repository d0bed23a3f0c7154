//! One sun, fixed to the world, whose shadow map just holds the scene.

use glam::{DMat4, DVec3, dcamera::rh::proj::directx};

use super::Bounds;

/// Towards the light: high, from the left and the front of the standing views.
const TOWARDS_LIGHT: DVec3 = DVec3::new(-0.55, -0.26, 0.79);

/// Unit vector towards the light, and its clip space from the world.
pub(super) fn light(bounds: Bounds) -> (DVec3, DMat4) {
    let back = TOWARDS_LIGHT.normalize_or(DVec3::Z);
    let right = DVec3::Z.cross(back).normalize_or(DVec3::X);
    let up = back.cross(right);
    let centre = bounds.centre();
    let r = bounds.radius();
    let view = DMat4::from_cols(right.extend(0.0), up.extend(0.0), back.extend(0.0), centre.extend(1.0)).inverse();
    (back, directx::orthographic(-r, r, -r, r, -r, r) * view)
}
