//! The contact numbers in force for a pair: `[contact]`, overridden by every `[[contact.pair]]` between the two.

use super::side::{Side, SolidId};
use crate::contact::calibration::linear_stiffness;
use crate::contact::parameters::reduced_mass;
use crate::scene::contact::{DEFAULT_YOUNG_MODULUS, PairContact};
use crate::scene::{ContactSettings, PairSettings, Scene};

/// Whether an entry of `[[contact.pair]]` is about this pair.
pub(super) fn is_between(scene: &Scene, pair: &PairSettings, sides: &(Side, Side)) -> bool {
    let matches = |side: Side, n: usize| match side {
        Side::Girder(g, end) => scene.girders[g].name == pair.between[n] && pair.ends.is_none_or(|ends| ends[n] == end),
        Side::Flank(g, _) => scene.girders[g].name == pair.between[n] && pair.ends.is_none(),
        Side::Abutment(a) | Side::Rear(a, _) => scene.abutments[a].name == pair.between[n],
    };
    (matches(sides.0, 0) && matches(sides.1, 1)) || (matches(sides.0, 1) && matches(sides.1, 0))
}

/// The numbers in force; of several entries about one pair the last one wins, key by key.
pub(super) fn in_force(scene: &Scene, first: Side, second: Side) -> PairContact {
    let mut settings = scene.contact.alone();
    for pair in scene.contact.pairs.iter().filter(|pair| is_between(scene, pair, &(first, second))) {
        // A pair's E or A asks for E A / L there, whatever `[contact]` says about K.
        if pair.young_modulus.is_some() || pair.area.is_some() {
            settings.stiffness = None;
        }
        settings.lay_over(pair);
    }
    settings.in_force(stiffness(scene, &settings, first, second))
}

/// Reduced mass of the bodies of a pair \[kg\]; an abutment that stands has infinite mass.
pub(super) fn mass_of(scene: &Scene, first: Side, second: Side) -> f64 {
    let mass = |side: Side| match side.solid() {
        SolidId::Girder(n) => scene.girders[n].mass,
        SolidId::Abutment(n) => scene.abutments[n].soil(scene).map_or(f64::INFINITY, |soil| soil.mass),
    };
    reduced_mass(mass(first), mass(second))
}

/// `K` as given, or that of a given Hertz spring at the design speed, or `K = E A / L` (64): of two girders the smaller.
fn stiffness(scene: &Scene, settings: &ContactSettings, first: Side, second: Side) -> f64 {
    if let Some(k) = settings.stiffness {
        return k;
    }
    if let (Some(hertz), None, None, true) =
        (settings.hertz_stiffness, settings.young_modulus, settings.area, settings.normal_law.is_hertzian())
    {
        return linear_stiffness(hertz, mass_of(scene, first, second), settings.design_speed);
    }
    let of = |side: Side| match side.girder() {
        Some(n) => {
            let girder = &scene.girders[n];
            let area = settings.area.unwrap_or(girder.width * girder.thickness);
            settings.young_modulus.unwrap_or(DEFAULT_YOUNG_MODULUS) * area / girder.length
        }
        None => f64::INFINITY,
    };
    of(first).min(of(second))
}
