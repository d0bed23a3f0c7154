//! Devices between two points: their centre lines, thick while their force acts.

use super::ViewInput;
use super::list::Line;
use super::moment::Moment;
use super::palette::{NORMAL, Palette};

/// Width of a device whose force acts, and of one that is idle \[points\].
const WIDTHS: [f32; 2] = [3.4, 1.4];

/// Lines of all devices of a moment; idle ones in faint ink, so that width and colour say the same.
pub(super) fn lines(input: &ViewInput<'_>, moment: &Moment, palette: &Palette) -> Vec<Line> {
    let [acting, idle] = WIDTHS.map(|width| width * input.pixels_per_point);
    let stroke = |acts: bool| if acts { (acting, NORMAL) } else { (idle, palette.faint_ink) };
    let devices = moment.devices.iter().map(|device| (&device.line, stroke(device.acts)));
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
