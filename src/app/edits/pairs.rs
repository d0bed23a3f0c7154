//! A facing pair's own entry of `[[contact.pair]]`, and what its stiffness follows from.

use crate::geometry::End;
use crate::scene::facing::{self, DEFAULT_YOUNG_MODULUS, Facing, Side, SolidId};
use crate::scene::{PairSettings, Scene};

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

/// K = E A / L, E and A of the first pair, by their keys, where the scene gives none \[N/m, Pa, m²\].
pub(in crate::app) fn elastic(scene: &Scene, key: &str) -> f64 {
    let Some(girder) = scene.girders.first() else { return 0.0 };
    let area = girder.width * girder.thickness;
    let young_modulus = scene.contact.young_modulus.unwrap_or(DEFAULT_YOUNG_MODULUS);
    match key {
        "young_modulus_pa" => young_modulus,
        "area_m2" => area,
        _ => {
            let pair = facing::find(scene).ok().and_then(|pairs| pairs.first().map(|pair| pair.contact.stiffness));
            let reckoned = young_modulus * scene.contact.area.unwrap_or(area) / girder.length;
            pair.filter(|_| scene.contact.stiffness.is_none()).unwrap_or(reckoned)
        }
    }
}
