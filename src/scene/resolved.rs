//! Bearings with everything filled in that the girder says.

use glam::DVec3;

use super::{
    Bearing, BearingKind, BearingSlide, BearingYield, Bearings, DeckBearings, Girder, Kind, Scene, SharedBearings,
};

/// Properties of the scene that its bearings depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Planar or spatial.
    pub kind: Kind,
    /// Gravity, by which sliders have their loads \[m/s²\].
    pub gravity: f64,
}

impl Scene {
    /// Properties that the bearings of its girders depend on.
    pub fn setting(&self) -> Setting {
        Setting { kind: self.kind, gravity: self.gravity }
    }
}

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
    /// A slider in space, whose load follows its vertical force; in plan it is a yield, and its N/R part of `stiffness`.
    pub sliding: Option<BearingSlide>,
    /// Displacement square to the front edge of its seat, either way, at which it loses its support \[m\].
    pub travel: Option<f64>,
}

impl Girder {
    /// Its bearings with everything filled in; none where it has none.
    pub fn supports(&self, of: Setting) -> Vec<ResolvedBearing> {
        self.bearings.as_ref().map(|bearings| bearings.resolve(self, of)).unwrap_or_default()
    }
}

impl ResolvedBearing {
    fn linear(place: DVec3, stiffness: [f64; 3], damping: [f64; 3]) -> Self {
        Self { place, stiffness, damping, yielding: None, sliding: None, travel: None }
    }

    fn with_travel(self, travel: Option<f64>) -> Self {
        Self { travel, ..self }
    }

    /// With a slider: under its load at rest in plan, under that of the moment in space.
    fn on_slider(self, slide: BearingSlide, kind: Kind) -> Self {
        match kind {
            Kind::Spatial => Self { sliding: Some(slide), ..self },
            Kind::Planar => {
                let [x, y, z] = self.stiffness;
                let stiffness = [x + slide.restoring(), y + slide.restoring(), z];
                Self { stiffness, yielding: Some(slide.yielding()), ..self }
            }
        }
    }

    /// `k_x, k_y, k_z` before any yield, of a slider under its load at rest \[N/m\].
    pub fn initial_stiffness(&self) -> [f64; 3] {
        let [x, y, z] = self.stiffness;
        let slides = self.sliding.map_or(0.0, |slide| slide.restoring() + slide.yielding().stiffness());
        let beside = self.yielding.map_or(0.0, |yielding| yielding.stiffness()) + slides;
        [x + beside, y + beside, z]
    }
}

/// True places in the frame of a girder: as given, or moved by `y cot β` with the skew \[m\].
fn places(girder: &Girder, at: Option<&[[f64; 2]]>, skewed: Option<&[[f64; 2]]>) -> Vec<[f64; 2]> {
    let shear = girder.prism().shear();
    let skewed = skewed.into_iter().flatten().map(|&[x, y]| [x + y * shear, y]);
    at.into_iter().flatten().copied().chain(skewed).collect()
}

impl SharedBearings {
    /// True places in the frame of a girder \[m\].
    pub fn places(&self, girder: &Girder) -> Vec<[f64; 2]> {
        places(girder, self.at.as_deref(), self.at_skewed.as_deref())
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

    fn resolve(&self, girder: &Girder, kind: Kind, at: impl Fn([f64; 2]) -> DVec3) -> Vec<ResolvedBearing> {
        let places = self.places(girder);
        let share = girder.mass / places.len() as f64;
        let modes = self.modes(kind).map(|(f, h)| (std::f64::consts::TAU * f, h));
        let stiffness = modes.map(|(omega, _)| share * omega.powi(2));
        let damping = modes.map(|(omega, h)| 2.0 * h * share * omega);
        let one = |p| ResolvedBearing::linear(at(p), stiffness, damping).with_travel(self.travel);
        places.into_iter().map(one).collect()
    }
}

impl DeckBearings {
    /// True places in the frame of a girder \[m\].
    pub fn places(&self, girder: &Girder) -> Vec<[f64; 2]> {
        places(girder, self.at.as_deref(), self.at_skewed.as_deref())
    }

    fn resolve(&self, girder: &Girder, of: Setting, at: impl Fn([f64; 2]) -> DVec3) -> Vec<ResolvedBearing> {
        let places = self.places(girder);
        let count = places.len() as f64;
        let whole = self.whole(girder.mass, of.gravity);
        let (f, h) = self.vertical(of.kind);
        let (omega, share, c) = (std::f64::consts::TAU * f, girder.mass / count, self.damping(girder.mass) / count);
        let damping = [c, c, 2.0 * h * share * omega];
        let bearing = |horizontal: f64, place| {
            ResolvedBearing::linear(at(place), [horizontal, horizontal, share * omega.powi(2)], damping)
                .with_travel(self.travel)
        };
        let one = |place| match self.kind {
            BearingKind::LeadRubber => {
                let yielding = BearingYield { force: whole.yielding.force / count, ..whole.yielding };
                ResolvedBearing { yielding: Some(yielding), ..bearing(whole.stiffness / count, place) }
            }
            BearingKind::Pendulum => {
                let slide = self.slide(girder.mass * of.gravity / count, of.gravity);
                bearing(0.0, place).on_slider(slide, of.kind)
            }
        };
        places.into_iter().map(one).collect()
    }
}

impl Bearing {
    fn resolve(&self, share: f64, kind: Kind, at: impl Fn([f64; 2]) -> DVec3) -> ResolvedBearing {
        let linear = ResolvedBearing::linear(at(self.at), self.stiffness, self.damping).with_travel(self.travel);
        match self.sliding(share) {
            Some(slide) => linear.on_slider(slide, kind),
            None => ResolvedBearing { yielding: self.yielding(), ..linear },
        }
    }
}

impl Bearings {
    /// The bearings of `girder` one by one: equal ones by frequency have `k = m (2π f)²`, `c = 2 h m (2π f)` shared equally
    /// (paper equation (5)).
    pub fn resolve(&self, girder: &Girder, of: Setting) -> Vec<ResolvedBearing> {
        let height = |given: Option<f64>| match of.kind {
            Kind::Planar => 0.0,
            Kind::Spatial => given.unwrap_or(-girder.thickness / 2.0),
        };
        let at = |given: Option<f64>| move |[x, y]: [f64; 2]| DVec3::new(x, y, height(given));
        match self {
            Self::Shared(shared) => shared.resolve(girder, of.kind, at(shared.height)),
            Self::Deck(deck) => deck.resolve(girder, of, at(deck.height)),
            Self::Each(bearings) => {
                let share = girder.mass * of.gravity / bearings.len() as f64;
                bearings.iter().map(|b| b.resolve(share, of.kind, at(b.height))).collect()
            }
        }
    }
}
