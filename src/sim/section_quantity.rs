//! Section forces of elastic girders as quantities: `deck.axial_mid`, `deck.moment_quarter+x`, `deck.stress_mid`.

use super::History;

/// What of a section of an elastic girder (`docs/physics.md#flexible-girders`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfSection {
    /// Normal force, tension positive.
    Axial,
    /// Shear force.
    Shear,
    /// Bending moment, positive where it compresses the +y edge.
    Moment,
    /// Stress of the extreme fibre, without sign.
    Stress,
}

const OF_SECTION: [(&str, OfSection); 4] = [
    ("axial", OfSection::Axial),
    ("shear", OfSection::Shear),
    ("moment", OfSection::Moment),
    ("stress", OfSection::Stress),
];
/// Stations with a name, in parts of half the length: the ends, the quarters, mid-span.
pub const STATIONS: [(&str, f64); 5] =
    [("-x", -1.0), ("quarter-x", -0.5), ("mid", 0.0), ("quarter+x", 0.5), ("+x", 1.0)];

/// Those of a girder, each with its name, the number of its station, and what it is; none of a rigid girder.
pub(super) fn named(history: &History, girder: usize) -> Vec<(String, usize, OfSection)> {
    if history.flexible(girder).is_none() {
        return Vec::new();
    }
    let at =
        |(station, (at, _)): (usize, (&str, f64))| OF_SECTION.map(|(of, what)| (format!("{of}_{at}"), station, what));
    STATIONS.into_iter().enumerate().flat_map(at).collect()
}

/// One of them at `t`, SI; 0 for what the run does not have.
pub(super) fn at(history: &History, girder: usize, station: usize, what: OfSection, t: f64) -> f64 {
    let Some((flexible, (_, xi))) = history.flexible(girder).zip(STATIONS.get(station)) else { return 0.0 };
    let station = 0.5 * flexible.beam.length * xi;
    let forces = || history.section_forces(girder, station, t);
    match what {
        OfSection::Axial => forces().axial,
        OfSection::Shear => forces().shear,
        OfSection::Moment => forces().moment,
        OfSection::Stress => history.stress(girder, station, t),
    }
}
