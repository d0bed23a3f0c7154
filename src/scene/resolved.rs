//! Bearings with everything filled in that the girder says.

use glam::DVec3;

use super::{BearingYield, Bearings, Girder, Kind, SharedBearings};

/// A bearing with everything filled in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResolvedBearing {
    /// Attachment point in the girder's frame; at the underside of a spatial girder unless a height is given, at the
    /// height of G in a planar scene \[m\].
    pub place: DVec3,
    /// `k_x, k_y, k_z` along the girder's axes as placed \[N/m\].
    pub stiffness: [f64; 3],
    /// `c_x, c_y, c_z` along the girder's axes as placed \[N·s/m\].
    pub damping: [f64; 3],
    /// Its yield; `stiffness` is then that after it.
    pub yielding: Option<BearingYield>,
}

impl ResolvedBearing {
    /// `k_x, k_y, k_z` before any yield \[N/m\].
    pub fn initial_stiffness(&self) -> [f64; 3] {
        let [x, y, z] = self.stiffness;
        let beside = self.yielding.map_or(0.0, |yielding| yielding.stiffness());
        [x + beside, y + beside, z]
    }
}

impl SharedBearings {
    /// True places in the frame of a girder: as given, or moved by `y cot β` with the skew \[m\].
    pub fn places(&self, girder: &Girder) -> Vec<[f64; 2]> {
        let shear = girder.prism().shear();
        let skewed = self.at_skewed.iter().flatten().map(|&[x, y]| [x + y * shear, y]);
        self.at.iter().flatten().copied().chain(skewed).collect()
    }

    /// `(f, h)` along x, y, z; the vertical is 0 in a planar scene, or where none is given.
    fn modes(&self, kind: Kind) -> [(f64, f64); 3] {
        let ([fx, fy], [hx, hy]) = (self.frequency_hz.xy(), self.damping_ratio.xy());
        let vertical = match kind {
            Kind::Planar => (0.0, 0.0),
            Kind::Spatial => (self.vertical_frequency_hz.unwrap_or(0.0), self.vertical_damping_ratio.unwrap_or(hx)),
        };
        [(fx, hx), (fy, hy), vertical]
    }
}

impl Bearings {
    /// The bearings of `girder` one by one: `k = m (2π f)²`, `c = 2 h m (2π f)` shared equally (paper equation (5)).
    pub fn resolve(&self, girder: &Girder, kind: Kind) -> Vec<ResolvedBearing> {
        let height = |given: Option<f64>| match kind {
            Kind::Planar => 0.0,
            Kind::Spatial => given.unwrap_or(-girder.thickness / 2.0),
        };
        let at = |[x, y]: [f64; 2], given| DVec3::new(x, y, height(given));
        match self {
            Self::Shared(shared) => {
                let places = shared.places(girder);
                let share = girder.mass / places.len() as f64;
                let modes = shared.modes(kind).map(|(f, h)| (std::f64::consts::TAU * f, h));
                let stiffness = modes.map(|(omega, _)| share * omega.powi(2));
                let damping = modes.map(|(omega, h)| 2.0 * h * share * omega);
                places
                    .into_iter()
                    .map(|p| ResolvedBearing { place: at(p, shared.height), stiffness, damping, yielding: None })
                    .collect()
            }
            Self::Each(bearings) => bearings
                .iter()
                .map(|b| ResolvedBearing {
                    place: at(b.at, b.height),
                    stiffness: b.stiffness,
                    damping: b.damping,
                    yielding: b.yielding(),
                })
                .collect(),
        }
    }
}
