//! `devices.csv`: changes of the phases of devices, bearings that yield, slide or are lost, and soil; and what a run did to devices.

use std::collections::BTreeMap;
use std::io::Write;

use serde::Serialize;

use super::{number, to_csv, xyz};
use crate::language::Language;
use crate::sim::{DeviceReading, History};

const HEADER: [&str; 9] = ["t", "device", "state", "deformation", "across", "gap", "fx", "fy", "fz"];

/// Readings of a device.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DeviceReport {
    /// Its name.
    pub name: String,
    /// `restrainer`, `bumper`, `damper` or `stopper`.
    pub kind: &'static str,
    /// Largest |force| \[N\].
    pub force: f64,
    /// Time of it \[s\].
    pub t: f64,
    /// Largest force in parts of the force at which it yields or breaks, where it does.
    pub part_of_strength: Option<f64>,
    /// Least and greatest displacement of its points against each other along its axis since placed \[m\].
    pub deformation: [f64; 2],
    /// Number of times that its force began.
    pub times: usize,
    /// Time of the first of them \[s\].
    pub first: Option<f64>,
    /// Time at which it first yielded \[s\].
    pub yielded_at: Option<f64>,
    /// Time at which it broke \[s\].
    pub broke_at: Option<f64>,
}

/// Readings of every device of the scene.
pub(super) fn reports(history: &History) -> Vec<DeviceReport> {
    let report = |reading: DeviceReading| {
        let DeviceReading { device, force, part_of_strength, deformation, times, first, yielded_at, broke_at } =
            reading;
        let device = &history.model().devices[device];
        DeviceReport {
            name: device.name.clone(),
            kind: device.id.kind.label(),
            force: force.value,
            t: force.t,
            part_of_strength,
            deformation: deformation.map(|extreme| extreme.value),
            times,
            first,
            yielded_at,
            broke_at,
        }
    };
    history.connections().devices().into_iter().map(report).collect()
}

/// The table: one row a change of phase, in order of time, the first phase of each link among them; nothing of the springs of a column,
/// which have one phase and are in the pier's drift and shear. Deformation along the first axis, which is the line between points apart, and
/// across it in plan. Force on the first point in the new
/// phase, of a slider that of the whole bearing; deformation and gap as in that phase \[N, m\].
///
/// # Errors
///
/// Those of the writer.
pub fn devices(history: &History, out: &mut dyn Write) -> std::io::Result<()> {
    let (model, connections) = (history.model(), history.connections());
    // A bearing on a pier that yields has two links of one name, a linear one beside its hysteresis: its changes are those of the other.
    let mut named: BTreeMap<&str, usize> = BTreeMap::new();
    model.links.iter().for_each(|link| *named.entry(&link.name).or_default() += 1);
    let is_part = |link: &usize| model.links[*link].device.is_linear() && named[model.links[*link].name.as_str()] > 1;
    let links = (0..model.links.len()).filter(|link| !model.piers.iter().any(|pier| pier.column.contains(link)));
    let links = links.filter(|link| !is_part(link));
    let mut changes: Vec<(f64, usize, usize)> = links
        .flat_map(|link| connections.link_phases(link).iter().enumerate().map(move |(n, (t, _))| (*t, link, n)))
        .collect();
    changes.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
    let row = |(t, link, change): (f64, usize, usize)| {
        let now = connections.link_in(link, connections.link_phases(link)[change].1, t)?;
        let [fx, fy, fz] = xyz(now.reaction);
        let (name, state) = (model.links[link].name.clone(), Language::English.within(|| now.state.to_string()));
        // A bearing whose travel has no end has no distance to it.
        let [along, across] = now.along.deformation;
        let [along, across, gap] = [along, across, now.gap].map(|v| if v.is_nan() { String::new() } else { number(v) });
        Some(vec![number(t), name, state, along, across, gap, fx, fy, fz])
    };
    to_csv(&HEADER.map(str::to_owned), changes.into_iter().filter_map(row), out)
}
