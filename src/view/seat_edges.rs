//! Front edges of seats: those that a corner is off, with the part of the end beyond it and by how much in words; and those of girders
//! that are selected, with what remains.

use glam::DVec3;

use super::input::pixel;
use super::labels::{BESIDE, Label, Placer};
use super::list::{Line, Mark};
use super::moment::{Moment, SeatNow};
use super::palette::{OVERLAP, Palette};
use super::scale;
use super::texts::TEXT;
use super::{Target, ViewInput};
use crate::geometry::Prism;
use crate::language::{Text, values};
use crate::scene::Scene;
use crate::sim::seats::seated_share;

/// Width of the front edge, and of the part of the end that is off \[points\].
const WIDTHS: [f32; 2] = [1.6, 4.0];

/// Whether any seat is shown, and the width \[points\] of its front edge.
pub(super) fn shown(input: &ViewInput<'_>, moment: &Moment) -> Option<f32> {
    moment.seats.iter().any(|seat| is_shown(input, seat)).then_some(WIDTHS[0])
}

/// Whether a seat is shown: a corner is off it, or its girder is selected.
fn is_shown(input: &ViewInput<'_>, seat: &SeatNow) -> bool {
    seat.is_left() || input.selected.contains(&Target::Girder(seat.girder))
}

/// Corners of the end at the underside, as drawn \[m\].
fn corners(scene: &Scene, moment: &Moment, seat: &SeatNow) -> Option<[DVec3; 2]> {
    let (girder, motion) = (scene.girders.get(seat.girder)?, moment.motions.get(seat.girder)?);
    let own = girder.prism().corners();
    Some(Prism::end_corners(seat.end).map(|corner| motion.place + motion.attitude * own[corner]))
}

/// The front edge of each seat that is shown, and the part of the end beyond it.
pub(super) fn lines(input: &ViewInput<'_>, moment: &Moment) -> Vec<Line> {
    let line = |[from, to]: [DVec3; 2], width: f32| Line {
        group: "seat edge",
        from: from.as_vec3(),
        to: to.as_vec3(),
        width: width * input.pixels_per_point,
        color: OVERLAP,
    };
    let of = |seat: &SeatNow| {
        let [one, other] = corners(input.scene, moment, seat)?;
        let seated = seated_share(seat.remaining);
        let beyond = if seat.remaining[0] > seat.remaining[1] {
            [one.lerp(other, seated), other]
        } else {
            [other.lerp(one, seated), one]
        };
        let beyond = seat.is_left().then(|| line(beyond, WIDTHS[1]));
        Some([Some(line(seat.edge, WIDTHS[0])), beyond].into_iter().flatten())
    };
    moment.seats.iter().filter(|seat| is_shown(input, seat)).filter_map(of).flatten().collect()
}

/// By how much each corner is off, beside it; of a seat that no corner is off what remains of it, at the corner with less.
pub(super) fn labels(input: &ViewInput<'_>, moment: &Moment, palette: &Palette, placer: &mut Placer) -> Vec<Mark> {
    let ppp = input.pixels_per_point;
    let shown = moment.seats.iter().filter(|seat| is_shown(input, seat));
    let all = shown.filter_map(|seat| Some((seat, corners(input.scene, moment, seat)?)));
    let told = all.flat_map(|(seat, corners)| {
        let less = usize::from(seat.remaining[1] < seat.remaining[0]);
        let tells = move |which: usize| if seat.is_left() { seat.remaining[which] < 0.0 } else { which == less };
        let numbers = Prism::end_corners(seat.end).map(|corner| corner + 1);
        let of = move |which: usize| (numbers[which], seat.remaining[which], corners[which]);
        (0..2).filter(move |which| tells(*which)).map(of)
    });
    let label = |(number, remaining, place): (usize, f64, DVec3)| {
        let length = scale::length(remaining.abs());
        let text = if remaining < 0.0 {
            Text::new("view-off-seat").with(&values!["corner" => number, "length" => length])
        } else {
            Text::new("view-seat-left").with(&values!["length" => length])
        };
        Some(Label {
            at: pixel(input, place)?,
            clear: 10.0 * ppp,
            text,
            size: TEXT * ppp,
            color: palette.ink,
            plate: palette.plate,
            directions: BESIDE.to_vec(),
        })
    };
    told.filter_map(label).flat_map(|label| placer.place(&label)).collect()
}
