//! Devices between two points: their centre lines, thick while their force acts.

use super::ViewInput;
use super::list::{Line, Rgba};
use super::moment::Moment;
use super::palette::{NORMAL, Palette};

/// Width of a device whose force acts, and of one that is idle \[points\].
const WIDTHS: [f32; 2] = [3.4, 1.4];

/// Width \[pixels\] and colour of a device's line: idle ones in faint ink, so that width and colour state the same.
pub(super) fn stroke(acts: bool, pixels_per_point: f32, palette: &Palette) -> (f32, Rgba) {
    let [acting, idle] = WIDTHS.map(|width| width * pixels_per_point);
    if acts { (acting, NORMAL) } else { (idle, palette.faint_ink) }
}

/// Lines of all devices of a moment.
pub(super) fn lines(input: &ViewInput<'_>, moment: &Moment, palette: &Palette) -> Vec<Line> {
    let devices = moment.devices.iter();
    let devices = devices.map(|device| (&device.line, stroke(device.acts, input.pixels_per_point, palette)));
    devices
        .flat_map(|(line, (width, color))| {
            line.windows(2).map(move |ends| Line {
                group: "device",
                from: ends[0].as_vec3(),
                to: ends[1].as_vec3(),
                width,
                color,
            })
        })
        .collect()
}
