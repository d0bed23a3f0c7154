//! A scale bar at the foot of a picture without perspective: a round length, true everywhere in it.

use glam::Vec2;

use super::area::Area;
use super::camera::Projection;
use super::list::Mark;
use super::palette::Palette;
use super::texts::TEXT;
use super::{ViewInput, scale};

/// Longest bar \[points\].
const LONGEST_BAR: f64 = 130.0;

/// The bar; nothing under a perspective, where no length is true everywhere.
pub(super) fn scale_bar(input: &ViewInput<'_>, palette: &Palette) -> Option<(Vec<Mark>, Area)> {
    if !matches!(input.camera.projection, Projection::Orthographic) {
        return None;
    }
    let ppp = input.pixels_per_point;
    let per_pixel = input.camera.metres_per_pixel(input.camera.target, f64::from(input.size[1]));
    let length = scale::round_down(LONGEST_BAR * f64::from(ppp) * per_pixel);
    let pixels = (length / per_pixel) as f32;
    if !(pixels.is_finite() && pixels > 1.0) {
        return None;
    }
    let left = Vec2::new(126.0 * ppp, input.size[1] as f32 - 28.0 * ppp);
    let right = left + Vec2::new(pixels, 0.0);
    let tick = Vec2::new(0.0, 5.0 * ppp);
    let (width, color) = (1.8 * ppp, palette.ink);
    let stroke = |points| Mark::Stroke { points, width, color };
    let words = Mark::Text {
        at: left + Vec2::new(pixels / 2.0, -7.0 * ppp),
        align: Vec2::new(0.5, 1.0),
        size: TEXT * ppp,
        text: scale::round_length(length),
        color,
        plate: Some(palette.plate.with_alpha(0x90)),
    };
    let marks = vec![stroke(vec![left - tick, left, right, right - tick]), words];
    Some((marks, Area { min: left - Vec2::new(4.0, 26.0) * ppp, max: right + Vec2::splat(4.0 * ppp) }))
}
