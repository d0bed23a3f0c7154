//! Bearings that a girder is put on: equal ones near its corners, of one kind for a whole deck, the same one by one.

use crate::geometry::End;
use crate::scene::{
    Bearing, BearingKind, Bearings, DeckBearings, Girder, Kind, PerDirection, STANDARD_GRAVITY, Setting, SharedBearings,
};

/// Bearings of a whole deck near its corners, with every number proposed.
pub(in crate::app) fn of_deck(kind: BearingKind, g: &Girder) -> Bearings {
    Bearings::Deck(DeckBearings::proposed(kind, corners(g)))
}

/// Four places near the corners, before skewing: in the middle of the seats where there are any \[m\].
fn corners(g: &Girder) -> Vec<[f64; 2]> {
    let round = |v: f64| (v * 1e4).round() / 1e4;
    let from_middle = |end: End| {
        let seat = g.seat.length(end).filter(|seat| *seat < g.length);
        round(seat.map_or(0.37 * g.length, |seat| 0.5 * (g.length - seat)))
    };
    let (plus, minus, b) = (from_middle(End::Plus), from_middle(End::Minus), round(0.36 * g.width));
    vec![[-minus, -b], [plus, -b], [plus, b], [-minus, b]]
}

/// Four equal bearings near the corners, at the paper's frequency and damping (Table 1).
pub(in crate::app) fn four_below(g: &Girder) -> SharedBearings {
    SharedBearings {
        frequency_hz: PerDirection::Both(2.6),
        damping_ratio: PerDirection::Both(0.28),
        vertical_frequency_hz: None,
        vertical_damping_ratio: None,
        on_minus_x: None,
        on_plus_x: None,
        at_skewed: Some(corners(g)),
        at: None,
        travel: None,
        height: None,
    }
}

/// The same bearings, each with its own numbers.
pub(in crate::app) fn one_by_one(g: &Girder, kind: Kind) -> Bearings {
    let resolved = g.supports(Setting { kind, gravity: STANDARD_GRAVITY });
    let height = match &g.bearings {
        Some(Bearings::Shared(shared)) => shared.height,
        Some(Bearings::Deck(deck)) => deck.height,
        _ => None,
    };
    let piers = g.bearings.as_ref().map(|b| b.named_supports(g)).unwrap_or_default();
    let pendulum = match &g.bearings {
        Some(Bearings::Deck(deck)) if deck.kind == BearingKind::Pendulum => Some(deck),
        _ => None,
    };
    let single = |(b, on): (&crate::scene::ResolvedBearing, Option<&str>)| {
        let linear = Bearing::linear([b.place.x, b.place.y], b.stiffness, b.damping);
        let linear = Bearing { height, travel: b.travel, on: on.map(str::to_owned), ..linear };
        match pendulum {
            // N/R is of the pendulum, beside no spring of its own.
            Some(deck) => Bearing {
                stiffness: [0.0, 0.0, b.stiffness[2]],
                friction: Some(deck.whole(g.mass, STANDARD_GRAVITY).yielding.force / (g.mass * STANDARD_GRAVITY)),
                radius: Some(deck.radius(STANDARD_GRAVITY)),
                slider_displacement: deck.slider_displacement,
                ..linear
            },
            None => Bearing {
                yield_force: b.yielding.map(|yielding| yielding.force),
                yield_displacement: b.yielding.map(|yielding| yielding.displacement),
                ..linear
            },
        }
    };
    Bearings::Each(resolved.iter().zip(piers).map(single).collect())
}
