//! A bridge to begin with: spans between two abutments, and values that fit its size, each said to be assumed.
//!
//! It is written as a scene file, so that what is saved lists every assumed value.

use std::fmt::Write as _;

use crate::app::command::BridgeDraft;
use crate::app::edits::change::micrometres;
use crate::codes::least_seat;
use crate::files::SceneSource;
use crate::scene::{Scene, SceneErrors, format};

/// Ranges of the numbers that are asked for: span and width \[m\], skew \[degrees\].
pub(in crate::app) const RANGES: [[f64; 2]; 3] = [[5.0, 200.0], [3.0, 60.0], [20.0, 160.0]];
/// Most spans of a new bridge (chosen); a row of spans can be longer.
pub(in crate::app) const MOST_BRIDGE_SPANS: usize = 200;

/// Mass of a deck over its area, as that of the preset `deck-30m` \[kg/m²\].
const MASS_PER_AREA: f64 = 2000.0;
/// `K L/A` of a contact, with K = 1e9 N/m of the preset `deck-30m`, its length L = 30 m and its section A = 15 m² \[N/m²\].
const STIFFNESS: f64 = 1e9 * 30.0 / 15.0;

/// Frequency of a girder on its bearings where the user gives none \[Hz\] (chosen).
pub(super) const BEARING_FREQUENCY: f64 = 0.8;

/// Assumed sizes of a bridge of these numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::app) struct Assumed {
    /// Depth of the deck, a twentieth of the span \[m\].
    pub(in crate::app) thickness: f64,
    /// Mass of a span \[kg\].
    pub(in crate::app) mass: f64,
    /// Every gap \[m\].
    pub(in crate::app) gap: f64,
    /// Length of every seat along the axis: at least what codes ask for square to its edge whatever a run gives \[m\].
    pub(in crate::app) seat: f64,
    /// Of a contact \[N/m\].
    pub(in crate::app) stiffness: f64,
    /// Of a span on its bearings \[Hz\].
    pub(in crate::app) frequency: f64,
}

/// Numbers that a bridge can have.
pub(in crate::app) fn sound(draft: BridgeDraft) -> BridgeDraft {
    let default = BridgeDraft::default();
    let [span, width, skew_deg] =
        [(draft.span, default.span), (draft.width, default.width), (draft.skew_deg, default.skew_deg)]
            .map(|(number, default)| if number.is_finite() { number } else { default });
    let within = |number: f64, [least, most]: [f64; 2]| number.clamp(least, most);
    BridgeDraft {
        span: within(span, RANGES[0]),
        width: within(width, RANGES[1]),
        skew_deg: within(skew_deg, RANGES[2]),
        spans: draft.spans.clamp(1, MOST_BRIDGE_SPANS),
    }
}

/// Assumed sizes of a bridge of these numbers.
pub(in crate::app) fn assumed(draft: BridgeDraft) -> Assumed {
    let BridgeDraft { span, width, skew_deg, .. } = sound(draft);
    let to = |value: f64, step: f64| (value / step).round().max(1.0) * step;
    let thickness = tidy(to(span / 20.0, 0.05));
    Assumed {
        thickness,
        mass: to(MASS_PER_AREA * span * width, 1000.0),
        gap: tidy(to(span / 600.0, 0.005)),
        seat: seat(span, skew_deg),
        stiffness: to(STIFFNESS * width * thickness / span, 1e7),
        frequency: BEARING_FREQUENCY,
    }
}

/// Largest part of a span that a seat takes under one end \[–\] (chosen).
const MOST_SEAT: f64 = 0.2;

/// Length of a seat along the axis that has the least lengths of codes square to its edge \[m\].
fn seat(span: f64, skew_deg: f64) -> f64 {
    let along = least_seat(span, skew_deg) / skew_deg.to_radians().sin();
    tidy((100.0 * along.min(MOST_SEAT * span)).ceil() / 100.0)
}

/// To whole millimetres \[m\].
fn tidy(metres: f64) -> f64 {
    (metres * 1e3).round() / 1e3
}

/// A bridge, and the text that it is read from.
///
/// # Errors
/// As [`format::read`]: none for [`sound`] numbers.
pub(in crate::app) fn bridge(draft: BridgeDraft) -> Result<(Scene, SceneSource), SceneErrors> {
    let text = text(sound(draft));
    Ok((format::read(&text, "bridge")?, SceneSource::Text(text.into())))
}

fn text(draft: BridgeDraft) -> String {
    let BridgeDraft { span, width, skew_deg, spans } = draft;
    let Assumed { thickness, mass, gap, seat, stiffness, frequency } = assumed(draft);
    let mut assumed: Vec<String> = ["contact", "motion"].map(str::to_owned).to_vec();
    for number in 1..=spans {
        let own = ["thickness_m", "mass_kg", "seat_m", "bearings"];
        assumed.extend(own.map(|key| format!("girder.span-{number}.{key}")));
    }
    for name in ["east", "west"] {
        assumed.extend(["gap_m", "width_m", "height_m"].map(|key| format!("abutment.{name}.{key}")));
    }
    let mut text = format!(
        "# What is listed as assumed was not given: it fits the size of the bridge, and is to be replaced.\n\
         format = 1\nname = \"bridge\"\nkind = \"planar\"\nduration_s = 10.0\nassumed = {assumed:?}\n"
    );
    // In the middle of their seats.
    let (end, side) = (tidy(0.5 * (span - seat)), tidy(0.4 * width));
    for number in 0..spans {
        // To the micrometre: half a millimetre would make one gap another than the rest.
        let x = micrometres((number as f64 - (spans as f64 - 1.0) / 2.0) * (span + gap));
        // Writing into memory cannot fail.
        let _ = write!(
            text,
            "\n[[girder]]\nname = \"span-{}\"\nlength_m = {span:?}\nwidth_m = {width:?}\nthickness_m = {thickness:?}\n\
             skew_deg = {skew_deg:?}\nmass_kg = {mass:?}\nposition_m = [{x:?}, 0.0, 0.0]\n\
             seat_m = {{ \"+x\" = {seat:?}, \"-x\" = {seat:?} }}\n\
             [girder.bearings]\nfrequency_hz = {frequency:?}\ndamping_ratio = 0.1\n\
             at_skewed_m = [[{end:?}, {side:?}], [{end:?}, -{side:?}], [-{end:?}, {side:?}], [-{end:?}, -{side:?}]]\n",
            number + 1
        );
    }
    for (name, faces, at) in [("east", spans, "+x"), ("west", 1, "-x")] {
        let wall = tidy(2.4 * width);
        let _ = write!(
            text,
            "\n[[abutment]]\nname = \"{name}\"\nfaces = \"span-{faces}\"\nend = \"{at}\"\ngap_m = {gap:?}\n\
             width_m = {wall:?}\nheight_m = {:?}\n",
            tidy(3.0 * thickness)
        );
    }
    let _ = write!(
        text,
        "\n[contact]\nstiffness_n_per_m = {stiffness:?}\nmu_static = 0.2\nmu_kinetic = 0.15\n\
         \n[motion]\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 0.8\n"
    );
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{facing, presets};
    use crate::sim::History;

    #[test]
    fn a_bridge_of_the_presets_size_has_the_presets_numbers() {
        let preset = presets::load("deck-30m").expect("ships");
        let deck = &preset.girders[0];
        let got = assumed(BridgeDraft { span: deck.length, width: deck.width, skew_deg: deck.skew_deg, spans: 1 });
        assert_eq!((got.thickness, got.mass), (deck.thickness, deck.mass), "depth and mass");
        assert_eq!(
            (Some(got.gap), Some(got.stiffness)),
            (preset.abutments[0].gap, preset.contact.stiffness),
            "gap and stiffness"
        );
    }

    #[test]
    fn every_bridge_that_can_be_asked_for_stands_free_and_runs() {
        for (span, width, skew_deg, spans) in
            [(30.0, 10.0, 60.0, 2), (5.0, 60.0, 20.0, 1), (200.0, 3.0, 160.0, 3), (f64::NAN, -1.0, 900.0, 0)]
        {
            let draft = BridgeDraft { span, width, skew_deg, spans };
            let (mut scene, _) = bridge(draft).expect("a scene");
            assert_eq!(scene.girders.len(), spans.max(1), "spans");
            let pairs = facing::find(&scene).expect("pairs");
            assert_eq!(pairs.len(), scene.girders.len() + 1, "a gap at every end: {draft:?}");
            let gap = assumed(draft).gap;
            assert!(pairs.iter().all(|pair| (pair.gap - gap).abs() < 2e-3), "as assumed: {pairs:?}");
            let Assumed { seat, .. } = assumed(draft);
            let BridgeDraft { span, skew_deg, .. } = sound(draft);
            let square = seat * skew_deg.to_radians().sin();
            assert!(square >= least_seat(span, skew_deg) - 1e-12 || seat >= 0.2 * span, "as codes ask: {draft:?}");
            assert!(seat < 0.25 * span, "and not the whole span: {draft:?}");
            scene.duration = 0.1;
            assert!(History::of(&scene).is_ok(), "runs: {draft:?}");
            assert!(scene.assumed.len() > 8, "each is said to be assumed");
        }
    }
}
