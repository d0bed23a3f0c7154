//! Numbers of an elastic girder, and what it cannot be yet.

use super::complaints::At;
use crate::scene::keys;
use crate::scene::{Bearing, Bearings, Girder, Kind};

const OF_A_KIND: [&str; 2] = [
    "an elastic girder on bearings of a kind",
    "bearings of an elastic girder are linear so far: give frequency_hz and damping_ratio in place of kind",
];
const YIELDING: [&str; 2] = [
    "an elastic girder on bearings that yield",
    "bearings of an elastic girder are linear so far: leave out yield_force_n",
];
const SLIDING: [&str; 2] =
    ["an elastic girder on sliders", "bearings of an elastic girder are linear so far: leave out friction"];
const WITH_TRAVEL: [&str; 2] = [
    "an elastic girder on bearings that can be lost",
    "bearings of an elastic girder keep their support so far: leave out travel_m",
];
const OVER_A_SEAT: [&str; 2] = [
    "an elastic girder whose bearings can be lost",
    "bearings of an elastic girder keep their support so far: leave out after_unseating",
];
const ON_A_PIER: [&str; 2] = [
    "an elastic girder on a pier",
    "bearings of an elastic girder stand on the ground so far: leave out the pier under them",
];

pub(super) fn check(girder: &Girder, kind: Kind, at: &mut At<'_>) {
    let Some(elastic) = &girder.elastic else { return };
    if kind == Kind::Spatial {
        let remedy = "elastic girders are known in planar scenes only so far: set kind = \"planar\", or leave it out";
        at.add("elastic", "an elastic girder in a spatial scene", remedy);
    }
    for [value, remedy] in refused_bearings(girder) {
        at.add("elastic", value, format!("{remedy}, or `elastic`"));
    }
    let mut at = at.below("elastic", keys::ELASTIC);
    at.all(elastic);
    for (key, value, remedy) in elastic.faults(girder) {
        at.add(key, value, remedy);
    }
    if let Some(rayleigh) = &elastic.rayleigh {
        at.below("rayleigh", keys::RAYLEIGH).all(rayleigh);
    }
}

/// Bearings that an elastic girder cannot have yet: what is there, and what to do about it.
fn refused_bearings(girder: &Girder) -> Vec<[&'static str; 2]> {
    let Some(bearings) = &girder.bearings else { return Vec::new() };
    let single = |has: fn(&Bearing) -> bool| matches!(bearings, Bearings::Each(each) if each.iter().any(has));
    let travel = match bearings {
        Bearings::Shared(shared) => shared.travel.is_some(),
        Bearings::Deck(deck) => deck.travel.is_some(),
        Bearings::Each(_) => single(|bearing| bearing.travel.is_some()),
    };
    let refused = [
        (matches!(bearings, Bearings::Deck(_)), OF_A_KIND),
        (single(|bearing| bearing.yield_force.is_some()), YIELDING),
        (single(|bearing| bearing.friction.is_some()), SLIDING),
        (travel, WITH_TRAVEL),
        (girder.after_unseating.is_some(), OVER_A_SEAT),
        (bearings.piers(girder).iter().any(Option::is_some), ON_A_PIER),
    ];
    refused.into_iter().filter(|(has, _)| *has).map(|(_, words)| words).collect()
}

#[cfg(test)]
mod tests {
    use crate::scene::format;

    /// What is said of an elastic deck with these lines in its table.
    fn said(lines: &str) -> String {
        let text = format!(
            "name = \"elastic\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\n\
             thickness_m = 1.5\nmass_kg = 6e5\nseat_m = {{ \"+x\" = 1.0, \"-x\" = 1.0 }}\n{lines}\n[girder.elastic]\narea_m2 = 8.0\n"
        );
        format::read(&text, "elastic").map_or_else(|errors| errors.to_string(), |_| String::new())
    }

    #[test]
    fn each_bearing_that_an_elastic_girder_cannot_have_is_refused_in_words() {
        let list = |more: &str| {
            let one = |x: f64| {
                format!(
                    "{{ at_m = [{x:?}, 0.0], stiffness_n_per_m = [1e6, 1e6], damping_n_s_per_m = [0.0, 0.0]{more} }}"
                )
            };
            format!("bearings = [{}, {}]", one(-14.5), one(14.5))
        };
        assert_eq!(said(&list("")), "", "linear ones stand");
        for (lines, left_out) in [
            (list(", yield_force_n = 1e4, yield_displacement_m = 0.01"), "yield_force_n"),
            (list(", friction = 0.05"), "friction"),
            (list(", travel_m = 0.3"), "travel_m"),
            (format!("after_unseating = \"continue\"\n{}", list("")), "after_unseating"),
            (
                "bearings = { kind = \"lead-rubber\", at_m = [[-14.5, 0.0], [14.5, 0.0]] }".to_owned(),
                "in place of kind",
            ),
            ("bearings = { kind = \"pendulum\", at_m = [[-14.5, 0.0], [14.5, 0.0]] }".to_owned(), "in place of kind"),
        ] {
            let words = said(&lines);
            assert!(words.contains("girder.deck.elastic") || words.contains("elastic girder"), "{lines}: {words}");
            assert!(words.contains(left_out), "{lines}: {words}");
        }
    }
}
