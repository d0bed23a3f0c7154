//! Bearings: pads from what they stand on to the deck. One that lost its support or is lifted stands by itself as placed, and a word
//! at the deck says so.

use glam::DVec3;

use super::ViewInput;
use super::block::Block;
use super::input::pixel;
use super::labels::{BESIDE, Label, Placer};
use super::list::{Mark, Rgba};
use super::moment::{Moment, at_rest};
use super::palette::{OVERLAP, Palette};
use super::texts::TEXT;
use super::{piers, seats};
use crate::language::{Text, values};
use crate::scene::{Bearings, Girder};
use crate::sim::{Carrying, Motion};

/// Side of a bearing pad, as a share of the girder's thickness.
const PAD_SIDE: f64 = 0.6;

/// A girder's bearings with their colours: pads that stand where they were placed, or on the pier that moves, and follow the girder with
/// their top while they carry it.
pub(super) fn pads(
    input: &ViewInput<'_>,
    (number, girder): (usize, &Girder),
    (motion, moment): (&Motion, &Moment),
    (level, palette): (f64, &Palette),
) -> Vec<(Block, Rgba)> {
    let scene = input.scene;
    let on_seats = seats::are_shown(input);
    let supports = scene.supports(girder);
    let half = PAD_SIDE * girder.thickness / 2.0;
    let home = at_rest(girder);
    let below =
        |place: DVec3, (at, pier): ([f64; 2], Option<usize>)| match pier.and_then(|number| moment.piers.get(number)) {
            Some(pier) => pier.moved(place) - DVec3::Z * piers::pad(scene),
            None if seats::carries(scene, girder, on_seats, at) => place - DVec3::Z * piers::pad(scene),
            None => place.with_z(level),
        };
    let all = places(girder).into_iter().zip(supports).enumerate();
    all.map(|(k, ([x, y], pier))| {
        let at = DVec3::new(x, y, -girder.thickness / 2.0);
        let moved = moment.feet.get(number).and_then(|feet| feet.get(k)).copied().unwrap_or_default();
        let rest = home.place + home.attitude * at;
        let foot = below(rest, ([x, y], pier)) + moved;
        let carries = moment.carrying(number, k) == Carrying::Yes;
        let top = if carries { motion.place + motion.attitude * at } else { foot.with_z(rest.z) };
        let (u, v) = (home.attitude * DVec3::X * half, home.attitude * DVec3::Y * half);
        // Seen from below, against the clock seen from above.
        let pad = Block { face: [foot - u - v, foot - u + v, foot + u + v, foot + u - v], sweep: top - foot };
        (pad, if carries { palette.bearing } else { OVERLAP })
    })
    .collect()
}

/// Points of a girder at its bearings, in its own frame in plan \[m\].
fn places(girder: &Girder) -> Vec<[f64; 2]> {
    match &girder.bearings {
        None => Vec::new(),
        Some(Bearings::Each(each)) => each.iter().map(|b| b.at).collect(),
        Some(Bearings::Shared(shared)) => shared.places(girder),
        Some(Bearings::Deck(deck)) => deck.places(girder),
    }
}

/// Number of a girder's bearings that do not carry it, beside the first of them.
pub(super) fn labels(input: &ViewInput<'_>, moment: &Moment, palette: &Palette, placer: &mut Placer) -> Vec<Mark> {
    let ppp = input.pixels_per_point;
    let label = |(number, girder): (usize, &Girder)| {
        let carrying = moment.carrying.get(number)?;
        let first = carrying.iter().position(|carrying| *carrying != Carrying::Yes)?;
        let count = |of: Carrying| carrying.iter().filter(|carrying| **carrying == of).count();
        let [lost, lifted, all] = [count(Carrying::Lost), count(Carrying::Lifted), carrying.len()];
        let name = girder.name.as_str();
        let text = if lost == all {
            Text::new("view-fallen").with(&values!["girder" => name])
        } else if lost > 0 {
            Text::new("view-bearings-lost").with(&values!["girder" => name, "count" => lost, "all" => all])
        } else {
            Text::new("view-bearings-lifted").with(&values!["girder" => name, "count" => lifted, "all" => all])
        };
        let ([x, y], motion) = (*places(girder).get(first)?, moment.motions.get(number)?);
        let at = motion.place + motion.attitude * DVec3::new(x, y, girder.thickness / 2.0);
        Some(Label {
            at: pixel(input, at)?,
            clear: 10.0 * ppp,
            text,
            size: TEXT * ppp,
            color: palette.ink,
            plate: palette.plate,
            directions: BESIDE.to_vec(),
        })
    };
    let girders = input.scene.girders.iter().enumerate();
    girders.filter_map(label).flat_map(|label| placer.place(&label)).collect()
}
