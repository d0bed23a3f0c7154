//! A facing pair's own entry of `[[contact.pair]]`, and what its stiffness follows from.

use crate::geometry::End;
use crate::scene::facing::{self, Facing, Side, SolidId};
use crate::scene::{CONCRETE_MODULUS, PairSettings, Scene};

/// Names of the two bodies of a facing pair.
pub(in crate::app) fn names_of<'a>(scene: &'a Scene, pair: &Facing) -> [&'a str; 2] {
    [pair.first, pair.second].map(|side| match side.solid() {
        SolidId::Girder(i) => scene.girders.get(i).map_or("", |g| g.name.as_str()),
        SolidId::Abutment(i) => scene.abutments.get(i).map_or("", |a| a.name.as_str()),
    })
}

fn ends_of(pair: &Facing) -> Option<[End; 2]> {
    match (pair.first, pair.second) {
        (Side::Girder(_, a), Side::Girder(_, b)) => Some([a, b]),
        _ => None,
    }
}

fn four_digits(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

/// The last entry of `[[contact.pair]]` that is about this pair alone.
pub(in crate::app) fn pair_entry(scene: &Scene, pair: &Facing) -> Option<usize> {
    let [a, b] = names_of(scene, pair);
    scene.contact.pairs.iter().rposition(|entry| {
        let [x, y] = &entry.between;
        let straight = (x == a && y == b) && entry.ends.is_none_or(|e| Some(e) == ends_of(pair));
        let turned = (x == b && y == a) && entry.ends.is_none_or(|[e, f]| Some([f, e]) == ends_of(pair));
        straight || turned
    })
}

/// An entry of `[[contact.pair]]` for this pair that says nothing yet.
pub(in crate::app) fn new_pair(scene: &Scene, pair: &Facing) -> PairSettings {
    pair_between(names_of(scene, pair).map(str::to_owned), ends_of(pair))
}

/// An entry between two bodies that says nothing yet.
pub(in crate::app) fn pair_between(between: [String; 2], ends: Option<[End; 2]>) -> PairSettings {
    PairSettings { between, ends, ..PairSettings::default() }
}

/// K = E A / L, E, A and L of the first pair, by their keys, where the scene gives none \[N/m, Pa, m², m\].
pub(in crate::app) fn elastic(scene: &Scene, key: &str) -> f64 {
    let Some(girder) = scene.girders.first() else { return 0.0 };
    let area = girder.width * girder.thickness;
    let young_modulus = scene.contact.young_modulus.unwrap_or(CONCRETE_MODULUS);
    match key {
        "young_modulus_pa" => young_modulus,
        "area_m2" => area,
        "contact_length_m" => scene.contact.contact_length.unwrap_or_else(|| facing::contact_length(girder)),
        "stiffness_n_per_m" if scene.contact.stiffness.is_some() => {
            young_modulus * scene.contact.area.unwrap_or(area) / girder.length
        }
        _ => {
            let pairs = facing::find(scene).unwrap_or_default();
            pairs.first().and_then(|pair| optional(pair, key)).unwrap_or(young_modulus * area / girder.length)
        }
    }
}

/// Number of a pair behind an optional key, to begin with where the key is given: K, or to four digits `k_h` or the parameter
/// of its normal law.
pub(in crate::app) fn optional(pair: &Facing, key: &str) -> Option<f64> {
    match key {
        "stiffness_n_per_m" => Some(pair.contact.stiffness),
        "hertz_stiffness_n_per_m1_5" => Some(four_digits(pair.contact.hertz_stiffness_in_force(pair.mass))),
        "law_parameter" => Some(four_digits(pair.contact.law_parameter_in_force())),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    #[test]
    fn an_optional_number_of_a_pair_begins_with_what_is_in_force() {
        let scene = presets::load("straight-abutment").expect("a preset");
        let pairs = facing::find(&scene).expect("the preset is valid");
        // docs/physics.md: ζ of e_n = 0.4 by (65), and k_h of K = 155 kN/m with 2 kg at 0.3 m/s.
        assert_eq!(elastic(&scene, "law_parameter"), 0.28, "to four digits");
        assert_eq!(elastic(&scene, "contact_length_m"), 0.19, "the girder's length");
        assert_eq!(optional(&pairs[0], "hertz_stiffness_n_per_m1_5"), Some(5.902e6), "to four digits");
        assert_eq!(optional(&pairs[0], "stiffness_n_per_m"), Some(1.55e5), "as given");
        assert_eq!(optional(&pairs[0], "mu_static"), None, "not an optional one");
    }
}
