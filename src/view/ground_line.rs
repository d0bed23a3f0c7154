//! The ground in level views without perspective, where its plane is seen as a line: that line over the whole picture, hatched below.

use super::ViewInput;
use super::camera::Projection;
use super::list::{Line, Rgba};

/// Largest upward part of the direction of a view that counts as level: rounding.
const LEVEL: f64 = 1e-6;
/// Distance of the strokes of the hatching along the line, and their height \[points\].
const HATCH: [f64; 2] = [14.0, 7.0];
/// Width of the line, and of the hatching \[points\].
const WIDTHS: [f32; 2] = [1.6, 0.9];

/// The ground's line at this height \[m\]; nothing in other views.
pub(super) fn lines(input: &ViewInput<'_>, level: f64, color: Rgba) -> Vec<Line> {
    let (camera, basis) = (input.camera, input.camera.basis());
    if !(matches!(camera.projection, Projection::Orthographic) && basis.back.z.abs() < LEVEL) {
        return Vec::new();
    }
    let per_pixel = camera.metres_per_pixel(camera.target, f64::from(input.size[1]));
    let half = basis.right * (0.5 * f64::from(input.size[0]) * per_pixel);
    let middle = camera.target.with_z(level);
    let [step, height] = HATCH.map(|points| points * f64::from(input.pixels_per_point) * per_pixel);
    let [line, hatch] = WIDTHS.map(|width| width * input.pixels_per_point);
    let stroke = |[from, to]: [glam::DVec3; 2], width| Line {
        group: "ground",
        from: from.as_vec3(),
        to: to.as_vec3(),
        width,
        color,
    };
    let count = 2.0 * half.length() / step;
    let below = (basis.right + basis.up) * -height;
    let starts = (0..input.size[0]).map(f64::from).take_while(|k| *k < count);
    let starts = starts.map(|k| middle - half + basis.right * (k * step));
    let hatching = starts.map(|from| stroke([from, from + below], hatch));
    std::iter::once(stroke([middle - half, middle + half], line)).chain(hatching).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{ViewPreset, presets};
    use crate::view::{Background, Bounds, Camera};

    #[test]
    fn the_ground_is_a_line_from_edge_to_edge_where_it_is_seen_from_its_side_and_nothing_else() {
        let scene = presets::load("deck-30m").expect("ships");
        let count = |preset| {
            let camera = Camera::preset(preset, Bounds::of_scene(&scene), 1.5);
            let input = ViewInput {
                scene: &scene,
                history: None,
                t: 0.0,
                camera: &camera,
                overlays: scene.view.overlays,
                force_scale: None,
                selected: &[],
                exaggeration: 1.0,
                bent: None,
                kept: &[],
                clear: &[],
                size: [300, 200],
                pixels_per_point: 1.0,
                background: Background::Studio,
                title: None,
            };
            let lines = lines(&input, -2.0, Rgba::CLEAR);
            assert!(lines.iter().all(|line| line.from.z <= -2.0 && line.to.z <= -2.0), "none above the ground");
            lines.len()
        };
        assert_eq!(count(ViewPreset::Side), 1 + 22, "a stroke every 14 of 300 points");
        assert_eq!([ViewPreset::Top, ViewPreset::Iso].map(count), [0; 2], "its plane is seen there");
    }
}
