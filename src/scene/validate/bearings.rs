//! Validation of a girder's bearings: equal ones by frequency or by kind, single ones, sliders with their loads, supports that can be lost.

use super::complaints::{At, numbers};
use crate::language::{Text, message};
use crate::scene::keys::{self, Keyed, Range};
use crate::scene::{Bearing, BearingKind, Bearings, DeckBearings, Girder, Kind, Setting, SharedBearings, seating};

/// Loads of sliders that add up to the weight, and leave no moment about G, within this part of the weight, and of it times the
/// farthest bearing's distance: numbers of a drawing have three to four digits.
const UNBALANCED: f64 = 1e-3;

pub(super) fn check(girder: &Girder, setting: Setting, needs_vertical: bool, at: &mut At<'_>) {
    match &girder.bearings {
        None => {}
        Some(Bearings::Shared(bearings)) => {
            let mut table = at.below("bearings", keys::BEARINGS);
            table.fits(bearings, setting.kind);
            shared(bearings, needs_vertical, &mut table);
        }
        Some(Bearings::Deck(bearings)) => {
            let mut table = at.below("bearings", keys::DECK_BEARINGS);
            table.fits(bearings, setting.kind);
            deck(bearings, setting, needs_vertical, &mut table);
        }
        Some(Bearings::Each(bearings)) => single(bearings, needs_vertical, setting, at),
    }
    loads(girder, setting, at);
    seats(girder, setting, at);
}

fn shared(bearings: &SharedBearings, needs_vertical: bool, at: &mut At<'_>) {
    vertical(bearings, bearings.vertical_frequency_hz, needs_vertical, at);
    places(bearings.at.as_deref(), bearings.at_skewed.as_deref(), at);
}

fn deck(bearings: &DeckBearings, setting: Setting, needs_vertical: bool, at: &mut At<'_>) {
    vertical(bearings, bearings.vertical_frequency_hz, needs_vertical, at);
    places(bearings.at.as_deref(), bearings.at_skewed.as_deref(), at);
    for key in bearings.foreign() {
        let remedy = message!("wrong-foreign", "kind" => format!("{:?}", bearings.kind.label()));
        at.add(key, Text::new("found-number"), remedy);
    }
    if let Some(ratio) = bearings.stiffness_ratio.filter(|ratio| *ratio <= 1.0) {
        at.add("stiffness_ratio", ratio, Text::new("wrong-ratio-below-one"));
    }
    if bearings.kind == BearingKind::Pendulum && bearings.radius.is_some() && bearings.period.is_some() {
        at.add(
            "radius_m",
            message!("found-both", "one" => "radius_m", "other" => "post_yield_period_s"),
            Text::new("wrong-radius-and-period"),
        );
    }
    weightless(setting, "kind", at);
}

/// Numbers from a weight need gravity.
fn weightless(setting: Setting, key: &str, at: &mut At<'_>) {
    if setting.gravity <= 0.0 {
        at.add(
            key,
            message!("found-gravity", "gravity" => format!("{:?}", setting.gravity)),
            Text::new("wrong-weightless"),
        );
    }
}

/// Every number of a table of equal bearings, and the vertical frequency where something must carry the weight.
fn vertical(bearings: &impl Keyed, frequency: Option<f64>, needs_vertical: bool, at: &mut At<'_>) {
    at.all_but("vertical_frequency_hz", bearings);
    match frequency {
        Some(f) if needs_vertical => at.number("vertical_frequency_hz", f),
        // Where it carries nothing it may say so.
        Some(f) => at.obeys("vertical_frequency_hz", f, Range::NotNegative),
        None if needs_vertical => {
            let remedy = Text::new("wrong-no-vertical-frequency");
            at.add("vertical_frequency_hz", Text::new("found-nothing"), remedy);
        }
        None => {}
    }
}

fn places(at_m: Option<&[[f64; 2]]>, at_skewed: Option<&[[f64; 2]]>, at: &mut At<'_>) {
    let (key, places) = match (at_m, at_skewed) {
        (Some(places), None) => ("at_m", places),
        (None, Some(places)) => ("at_skewed_m", places),
        (None, None) => {
            return at.add("at_m", Text::new("found-nothing"), Text::new("wrong-no-places"));
        }
        (Some(_), Some(_)) => {
            return at.add(
                "at_m",
                message!("found-both", "one" => "at_m", "other" => "at_skewed_m"),
                Text::new("wrong-both"),
            );
        }
    };
    if places.is_empty() {
        at.add(key, "[]", Text::new("wrong-empty-places"));
    }
}

fn single(bearings: &[Bearing], needs_vertical: bool, setting: Setting, at: &mut At<'_>) {
    if bearings.is_empty() {
        at.add("bearings", "[]", Text::new("wrong-no-bearing"));
    }
    for (n, bearing) in bearings.iter().enumerate() {
        let key = format!("bearings[{n}]");
        let mut table = at.below(&key, keys::BEARING);
        table.all(bearing);
        table.fits(bearing, setting.kind);
        yielding(bearing, &mut table);
        sliding(bearing, setting, &mut table);
    }
    if needs_vertical && !bearings.is_empty() && bearings.iter().all(|b| b.stiffness[2] == 0.0) {
        let remedy = Text::new("wrong-no-vertical-stiffness");
        at.add("bearings[0].stiffness_n_per_m", numbers(&bearings[0].stiffness[..2]), remedy);
    }
}

fn yielding(bearing: &Bearing, at: &mut At<'_>) {
    match (bearing.yield_force, bearing.yield_displacement) {
        (Some(_), None) => {
            at.add("yield_displacement_m", Text::new("found-nothing"), Text::new("wrong-no-yield-displacement"));
        }
        (None, Some(_)) => at.add("yield_force_n", Text::new("found-nothing"), Text::new("wrong-no-yield-force")),
        _ => {}
    }
    if bearing.per_axis.is_some() && bearing.yield_force.is_none() {
        let slides = bearing.friction.is_some();
        let remedy = if slides { "wrong-per-axis-slider" } else { "wrong-per-axis-alone" };
        at.add("yields_per_axis", Text::new("found-switch"), Text::new(remedy));
    }
}

fn sliding(bearing: &Bearing, setting: Setting, at: &mut At<'_>) {
    if bearing.friction.is_none() {
        let beside = [
            ("radius_m", bearing.radius),
            ("slider_displacement_m", bearing.slider_displacement),
            ("load_n", bearing.load),
        ];
        for (key, value) in beside.into_iter().filter_map(|(key, value)| Some((key, value?))) {
            // A load without friction is a share of the weight that others do not carry.
            if key != "load_n" {
                at.add(key, value, Text::new("wrong-friction-missing"));
            }
        }
        return;
    }
    if bearing.yield_force.is_some() {
        at.add(
            "friction",
            message!("found-both", "one" => "friction", "other" => "yield_force_n"),
            Text::new("wrong-both"),
        );
    }
    weightless(setting, "friction", at);
    if setting.kind == Kind::Spatial && bearing.stiffness[2] == 0.0 {
        let remedy = Text::new("wrong-slider-in-space");
        at.add("stiffness_n_per_m", numbers(&bearing.stiffness), remedy);
    }
}

/// Loads of sliders: of all bearings or of none, in plan only; they carry the weight without a moment about G.
fn loads(girder: &Girder, setting: Setting, at: &mut At<'_>) {
    let Some(loads) = loads_in_plan(girder, setting, at) else { return };
    let weight = girder.mass * setting.gravity;
    let sum: f64 = loads.iter().map(|(_, load)| load).sum();
    if (sum - weight).abs() > UNBALANCED * weight {
        let remedy = message!("wrong-loads", "weight" => format!("{weight:.6e}"));
        return at.add("bearings[0].load_n", message!("found-loads", "sum" => format!("{sum:.6e}")), remedy);
    }
    let farthest = loads.iter().map(|([x, y], _)| x.hypot(*y)).fold(0.0, f64::max);
    let moment = [0, 1].map(|axis| loads.iter().map(|(place, load)| place[axis] * load).sum::<f64>());
    if moment[0].hypot(moment[1]) > UNBALANCED * weight * farthest {
        let value = message!(
            "found-loads-at",
            "x" => format!("{:.4}", moment[0] / sum),
            "y" => format!("{:.4}", moment[1] / sum)
        );
        let remedy = Text::new("wrong-loads-turn");
        at.add("bearings", value, remedy);
    }
}

/// Place of a bearing in the girder's frame \[m\], and its load at rest \[N\].
type Loaded = ([f64; 2], f64);

/// Places and loads of all bearings of a planar girder that has a slider among them.
fn loads_in_plan(girder: &Girder, setting: Setting, at: &mut At<'_>) -> Option<Vec<Loaded>> {
    let bearings = girder.bearings.as_ref()?;
    let given = match bearings {
        Bearings::Shared(_) => return None,
        Bearings::Deck(deck) if deck.kind != BearingKind::Pendulum => return None,
        Bearings::Deck(_) => vec![None],
        Bearings::Each(each) => each.iter().map(|bearing| bearing.load).collect(),
    };
    if setting.kind == Kind::Spatial {
        if given.iter().any(Option::is_some) {
            at.add("bearings[0].load_n", Text::new("found-all-loads"), Text::new("wrong-loads-in-space"));
        }
        return None;
    }
    let slides = match bearings {
        Bearings::Each(each) => each.iter().any(|bearing| bearing.friction.is_some()),
        _ => true,
    };
    if given.iter().any(Option::is_some) && (!slides || given.iter().any(Option::is_none)) {
        at.add("bearings[0].load_n", Text::new("found-some-loads"), Text::new("wrong-some-loads"));
        return None;
    }
    let places: Vec<[f64; 2]> = bearings.resolve(girder, setting).iter().map(|b| [b.place.x, b.place.y]).collect();
    let share = girder.mass * setting.gravity / places.len().max(1) as f64;
    let load = |n: usize| given.get(n).copied().flatten().unwrap_or(share);
    slides.then(|| places.into_iter().enumerate().map(|(n, place)| (place, load(n))).collect())
}

/// Bearings that stand on their seats as placed, where these can be lost.
fn seats(girder: &Girder, setting: Setting, at: &mut At<'_>) {
    for (n, bearing) in girder.supports(setting).iter().enumerate() {
        let Some(room) = seating::room(girder, bearing) else { continue };
        if room.excess(0.0) >= 0.0 {
            let value = message!("found-bearing-off-seat", "number" => n + 1);
            at.add("bearings", value, Text::new("wrong-bearing-off-seat"));
        }
    }
}
