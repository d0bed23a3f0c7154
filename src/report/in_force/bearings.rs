//! Equal bearings of a whole deck: their loop, and its effective stiffness and equivalent damping at amplitudes.

use crate::language::{said, six};
use crate::scene::keys::word_told;
use crate::scene::{BearingKind, DeckBearings, Girder, Setting};

/// Two lines: the loop of all bearings together; stiffness, period and damping at those of these amplitudes \[m\] that are beyond yield,
/// empty where none is.
pub fn deck_bearings(deck: &DeckBearings, girder: &Girder, setting: Setting, amplitudes: &[f64]) -> [String; 2] {
    let whole = deck.whole(girder.mass, setting.gravity);
    let at = |amplitude: f64| {
        let [stiffness, period, damping] = [
            whole.effective_stiffness(amplitude),
            whole.effective_period(amplitude, girder.mass),
            whole.equivalent_damping(amplitude),
        ]
        .map(six);
        said!(
            "check-effective",
            "amplitude" => six(amplitude),
            "stiffness" => stiffness,
            "period" => period,
            "damping" => damping
        )
    };
    let beyond = amplitudes.iter().copied().filter(|amplitude| *amplitude > whole.yielding.displacement);
    let effective: Vec<String> = beyond.map(at).collect();
    let together = said!(
        "check-together",
        "kind" => word_told(BearingKind::WORDS, deck.kind.label()),
        "first" => six(whole.first_stiffness()),
        "second" => six(whole.stiffness),
        "force" => six(whole.yielding.force),
        "yields" => six(whole.yielding.displacement)
    );
    [together, effective.join("; ")]
}
