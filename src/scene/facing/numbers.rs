//! The contact numbers in force for a pair: `[contact]`, overridden by every `[[contact.pair]]` between the two.

use super::side::{Side, SolidId};
use crate::contact::calibration::linear_stiffness;
use crate::contact::parameters::reduced_mass;
use crate::scene::concrete::CONCRETE_MODULUS;
use crate::scene::contact::PairContact;
use crate::scene::{ContactSettings, Girder, PairSettings, Scene};

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
        if pair.young_modulus.or(pair.area).or(pair.contact_length).is_some() {
            settings.stiffness = None;
        }
        settings.lay_over(pair);
    }
    settings.in_force(stiffness(scene, &settings, first, second))
}

/// A contact that is long against an elastic girder: its length, in parts of the girder's.
const ELASTIC_CONTACT: f64 = 0.1;

/// Mass that a dashpot of a pair of this stiffness \[N/m\] sees: the reduced one of the bodies, of an elastic girder `m min(1, 1/κ)`,
/// (F8) \[kg\].
pub(super) fn dashpot_mass(scene: &Scene, first: Side, second: Side, stiffness: f64) -> f64 {
    let mass = |side: Side| {
        let girder = side.girder().map(|n| &scene.girders[n]);
        let elastic = girder.and_then(|girder| Some((girder, girder.elastic?.resolve(girder))));
        elastic.map_or_else(
            || mass_of_side(scene, side),
            |(girder, elastic)| girder.mass * (elastic.axial / (stiffness * girder.length)).min(1.0),
        )
    };
    reduced_mass(mass(first), mass(second))
}

/// Reduced mass of the bodies of a pair \[kg\]; an abutment that stands has infinite mass.
fn mass_of(scene: &Scene, first: Side, second: Side) -> f64 {
    reduced_mass(mass_of_side(scene, first), mass_of_side(scene, second))
}

fn mass_of_side(scene: &Scene, side: Side) -> f64 {
    match side.solid() {
        SolidId::Girder(n) => scene.girders[n].mass,
        SolidId::Abutment(n) => scene.abutments[n].soil(scene).map_or(f64::INFINITY, |soil| soil.mass),
    }
}

/// L of (64) where none is given: the girder's length, of an elastic one a part of it \[m\].
pub fn contact_length(girder: &Girder) -> f64 {
    if girder.elastic.is_some() { ELASTIC_CONTACT * girder.length } else { girder.length }
}

/// `K` as given, or that of a given Hertz spring at the design speed, or `K = E A / L` (64): of two girders the smaller; of an elastic
/// girder with its own E and A.
fn stiffness(scene: &Scene, settings: &ContactSettings, first: Side, second: Side) -> f64 {
    if let Some(k) = settings.stiffness {
        return k;
    }
    let given = settings.young_modulus.or(settings.area).or(settings.contact_length);
    if let (Some(hertz), None, true) = (settings.hertz_stiffness, given, settings.normal_law.is_hertzian()) {
        return linear_stiffness(hertz, mass_of(scene, first, second), settings.design_speed);
    }
    let of = |side: Side| match side.girder() {
        Some(n) => {
            let girder = &scene.girders[n];
            let elastic = girder.elastic.map(|elastic| (elastic.young_modulus, elastic.resolve(girder).area));
            let (modulus, section) = elastic.unwrap_or((CONCRETE_MODULUS, girder.width * girder.thickness));
            let area = settings.area.unwrap_or(section);
            let length = settings.contact_length.unwrap_or_else(|| contact_length(girder));
            settings.young_modulus.unwrap_or(modulus) * area / length
        }
        None => f64::INFINITY,
    };
    of(first).min(of(second))
}
