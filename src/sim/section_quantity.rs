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

impl OfSection {
    /// All, each with its word.
    pub const ALL: [(&'static str, Self); 4] = OF_SECTION;

    /// What it is, with its sign, for titles and legends.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Axial => "normal force N, tension +",
            Self::Shear => "shear force Q",
            Self::Moment => "bending moment M, + compresses the +y edge",
            Self::Stress => "stress of the extreme fibre",
        }
    }

    /// The unit that it is shown in, and SI units in one of it.
    pub const fn unit(self) -> (&'static str, f64) {
        match self {
            Self::Axial | Self::Shear => ("MN", 1e6),
            Self::Moment => ("MN·m", 1e6),
            Self::Stress => ("MPa", 1e6),
        }
    }

    /// Whether it has a sign.
    pub const fn is_signed(self) -> bool {
        !matches!(self, Self::Stress)
    }
}

const OF_SECTION: [(&str, OfSection); 4] = [
    ("axial", OfSection::Axial),
    ("shear", OfSection::Shear),
    ("moment", OfSection::Moment),
    ("stress", OfSection::Stress),
];
/// Stations with a name, in parts of half the length: the ends, the quarters, mid-span.
pub(super) const STATIONS: [(&str, f64); 5] =
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
    history.of_section(girder, &history.section_forces(girder, station, t), what)
}
