//! Section forces of elastic girders as quantities: `deck.axial_mid`, `deck.moment_quarter+x`, `deck.stress_mid`.

use crate::scene::Kind;
use crate::sim::sections::view::Sections;

/// Quantity of a section of an elastic girder (`docs/physics.md#flexible-girders`).
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
    /// Vertical shear force, of spatial scenes.
    VerticalShear,
    /// Vertical bending moment, positive where it stretches the upper side; of spatial scenes.
    VerticalMoment,
    /// Torque about the axis, of spatial scenes.
    Torque,
}

impl OfSection {
    /// All, each with its word.
    pub const ALL: [(&'static str, Self); 7] = OF_SECTION;

    /// Those of a scene of this kind.
    pub fn of(kind: Kind) -> impl Iterator<Item = (&'static str, Self)> {
        OF_SECTION.into_iter().filter(move |(_, what)| kind == Kind::Spatial || !what.is_spatial())
    }

    /// Whether only girders in space have it.
    pub const fn is_spatial(self) -> bool {
        matches!(self, Self::VerticalShear | Self::VerticalMoment | Self::Torque)
    }

    /// Name with its sign, for titles and legends.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Axial => "normal force N, tension +",
            Self::Shear => "shear force Q",
            Self::Moment => "bending moment M, + compresses the +y edge",
            Self::Stress => "stress of the extreme fibre",
            Self::VerticalShear => "vertical shear force Q_z",
            Self::VerticalMoment => "vertical bending moment M_y, + stretches the upper side",
            Self::Torque => "torque T",
        }
    }

    /// The unit that it is shown in, and SI units in one of it.
    pub const fn unit(self) -> (&'static str, f64) {
        match self {
            Self::Axial | Self::Shear | Self::VerticalShear => ("MN", 1e6),
            Self::Moment | Self::VerticalMoment | Self::Torque => ("MN·m", 1e6),
            Self::Stress => ("MPa", 1e6),
        }
    }

    /// Whether it has a sign.
    pub const fn is_signed(self) -> bool {
        !matches!(self, Self::Stress)
    }
}

const OF_SECTION: [(&str, OfSection); 7] = [
    ("axial", OfSection::Axial),
    ("shear", OfSection::Shear),
    ("moment", OfSection::Moment),
    ("stress", OfSection::Stress),
    ("shear_z", OfSection::VerticalShear),
    ("moment_y", OfSection::VerticalMoment),
    ("torque", OfSection::Torque),
];
/// Stations with a name, in parts of half the length: the ends, the quarters, mid-span.
pub(in crate::sim) const STATIONS: [(&str, f64); 5] =
    [("-x", -1.0), ("quarter-x", -0.5), ("mid", 0.0), ("quarter+x", 0.5), ("+x", 1.0)];

impl Sections<'_> {
    /// Quantities of the sections of a girder, each with its name, the number of its station, and what it is; none of a rigid girder.
    pub(in crate::sim) fn quantities(self, girder: usize) -> Vec<(String, usize, OfSection)> {
        if self.flexible(girder).is_none() {
            return Vec::new();
        }
        let kind = self.history.model().kind;
        let at = |(station, (at, _)): (usize, (&'static str, f64))| {
            OfSection::of(kind).map(move |(of, what)| (format!("{of}_{at}"), station, what))
        };
        STATIONS.into_iter().enumerate().flat_map(at).collect()
    }

    /// Quantity of a section at `t`, SI, by the number of its station; 0 for what the run does not have.
    pub(in crate::sim) fn quantity(self, girder: usize, station: usize, what: OfSection, t: f64) -> f64 {
        let Some((flexible, (_, xi))) = self.flexible(girder).zip(STATIONS.get(station)) else { return 0.0 };
        let station = 0.5 * flexible.beam.length * xi;
        self.component(girder, &self.forces(girder, station, t), what)
    }
}
