//! Text of `check` on bearings that yield, slide or can lose their support: the numbers in force, and which of them are assumed.

use crate::cli::digits::six;
use crate::language::{Text, said};
use crate::report::in_force;
use crate::scene::{Bearings, DeckBearings, Girder, Kind, ResolvedBearing, Setting, seating};

/// Amplitudes at which the effective numbers of a deck's bearings are given, full scale \[m\].
const AMPLITUDES: [f64; 2] = [0.1, 0.2];

/// All of it, a fact a line; nothing of linear bearings that stay on their supports.
pub(super) fn text(girder: &Girder, setting: Setting) -> String {
    let supports = girder.supports(setting);
    let deck = match &girder.bearings {
        Some(Bearings::Deck(deck)) => self::deck(deck, girder, setting),
        _ => String::new(),
    };
    [yields(&supports), slides(&supports), deck, rooms(girder, &supports, setting)].concat()
}

/// Bearings that yield: the sum of Q, and their stiffness before, which the frequencies are without.
fn yields(supports: &[ResolvedBearing]) -> String {
    let yielding: Vec<_> = supports.iter().filter_map(|b| b.yielding.map(|y| (y, b.initial_stiffness()))).collect();
    if yielding.is_empty() {
        return String::new();
    }
    let force: f64 = yielding.iter().map(|(y, _)| y.force).sum();
    let stiffness = |axis: usize| six(yielding.iter().map(|(_, k)| k[axis]).sum::<f64>());
    format!(
        "  {}\n",
        said!("check-yield", "count" => yielding.len(), "force" => six(force), "x" => stiffness(0), "y" => stiffness(1))
    )
}

/// Sliders in space, whose friction follows their vertical force.
fn slides(supports: &[ResolvedBearing]) -> String {
    let sliding: Vec<_> = supports.iter().filter_map(|b| b.sliding).collect();
    let Some(first) = sliding.first() else { return String::new() };
    let radius = if first.curvature > 0.0 {
        format!("R = {} m", six(first.curvature.recip()))
    } else {
        Text::new("check-flat").into()
    };
    format!(
        "  {}\n",
        said!(
            "check-slide",
            "count" => sliding.len(),
            "friction" => six(first.friction),
            "radius" => radius,
            "displacement" => six(first.displacement)
        )
    )
}

/// Bearings of a whole deck: the numbers in force together, and what of them is assumed.
fn deck(deck: &DeckBearings, girder: &Girder, setting: Setting) -> String {
    let [together, effective] = in_force::deck_bearings(deck, girder, setting, &AMPLITUDES);
    let assumed: Vec<String> =
        deck.assumed().into_iter().map(|(key, number)| format!("{key} = {}", six(number))).collect();
    let assumed =
        if assumed.is_empty() { String::new() } else { said!("check-assumed-of", "numbers" => assumed.join(", ")) };
    let effective = if effective.is_empty() { effective } else { format!("  {effective}\n") };
    format!("  {together}{assumed}\n{effective}")
}

/// Bearings that can lose their support, and what then happens.
fn rooms(girder: &Girder, supports: &[ResolvedBearing], setting: Setting) -> String {
    let rooms: Vec<_> = supports.iter().filter_map(|bearing| seating::room(girder, bearing)).collect();
    if rooms.is_empty() {
        return String::new();
    }
    let least = rooms.iter().flat_map(|room| [-room.from, room.to]).fold(f64::INFINITY, f64::min);
    let then = match setting.kind {
        Kind::Spatial => said!("check-then-drops", "drop" => six(girder.drop())),
        Kind::Planar => match girder.after_unseating.unwrap_or_default() {
            crate::scene::AfterUnseating::Stop => Text::new("check-then-stops").into(),
            crate::scene::AfterUnseating::Continue => Text::new("check-then-goes-on").into(),
        },
    };
    format!("  {}\n", said!("check-rooms", "count" => rooms.len(), "least" => six(least), "then" => then))
}
