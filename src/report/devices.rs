//! Table of what a run did to devices.

use super::sections::{at, head, row};
use super::units::force;
use crate::language::Text;
use crate::tables::Report;

/// Largest force, part of the strength, movement, when it acts, yields and breaks; nothing of a scene without devices.
pub(super) fn table(report: &Report) -> String {
    if report.devices.is_empty() {
        return String::new();
    }
    let mut html = head(&[
        Text::new("report-device").as_str(),
        &Text::new("report-largest-force"),
        &Text::new("report-of-strength"),
        &Text::new("report-moves"),
        &Text::new("report-acts"),
        &Text::new("report-yields-breaks"),
    ]);
    for device in &report.devices {
        let when = |t: Option<f64>| t.map_or("–".to_owned(), |t| format!("{t:.3}"));
        let largest = device.first.map_or("–".to_owned(), |_| at(force(device.force), device.t));
        let part = device.part_of_strength.map_or("–".to_owned(), |part| format!("{:.0} %", 100.0 * part));
        let [least, greatest] = device.deformation.map(|length| format!("{:.1}", 1e3 * length));
        let (moves, ends) =
            (format!("{least} … {greatest}"), format!("{}, {}", when(device.yielded_at), when(device.broke_at)));
        html.push_str(&row(&device.name, &[largest, part, moves, device.times.to_string(), ends]));
    }
    html + "</table>\n"
}
