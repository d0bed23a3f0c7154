//! Corners that are off their seats: the front edge of the seat, the part of the end beyond it, and by how much in words.

use glam::DVec3;

use super::ViewInput;
use super::input::pixel;
use super::labels::{BESIDE, Label, Placer};
use super::list::{Line, Mark};
use super::moment::{Moment, OffSeat};
use super::palette::{OVERLAP, Palette};
use super::scale;
use super::texts::TEXT;
use crate::geometry::Prism;
use crate::language::{Text, values};
use crate::scene::Scene;
use crate::sim::seats::seated_share;

/// Width of the front edge, and of the part of the end that is off \[points\].
const WIDTHS: [f32; 2] = [1.6, 4.0];

/// Corners of the end at the underside, as drawn \[m\].
fn corners(scene: &Scene, moment: &Moment, off: &OffSeat) -> Option<[DVec3; 2]> {
    let (girder, motion) = (scene.girders.get(off.girder)?, moment.motions.get(off.girder)?);
    let own = girder.prism().corners();
    Some(Prism::end_corners(off.end).map(|corner| motion.place + motion.attitude * own[corner]))
}

/// The front edge of each seat that a corner is off, and the part of the end beyond it.
pub(super) fn lines(input: &ViewInput<'_>, moment: &Moment) -> Vec<Line> {
    let line = |[from, to]: [DVec3; 2], width: f32| Line {
        group: "off seat",
        from: from.as_vec3(),
        to: to.as_vec3(),
        width: width * input.pixels_per_point,
        color: OVERLAP,
    };
    let of = |off: &OffSeat| {
        let [one, other] = corners(input.scene, moment, off)?;
        let seated = seated_share(off.remaining);
        let beyond = if off.remaining[0] > off.remaining[1] {
            [one.lerp(other, seated), other]
        } else {
            [other.lerp(one, seated), one]
        };
        Some([line(off.edge, WIDTHS[0]), line(beyond, WIDTHS[1])])
    };
    moment.off_seat.iter().filter_map(of).flatten().collect()
}

/// By how much each corner is off, beside it.
pub(super) fn labels(input: &ViewInput<'_>, moment: &Moment, palette: &Palette, placer: &mut Placer) -> Vec<Mark> {
    let ppp = input.pixels_per_point;
    let all = moment.off_seat.iter().filter_map(|off| Some((off, corners(input.scene, moment, off)?)));
    let corners = all.flat_map(|(off, corners)| (0..2).map(move |which| (off.remaining[which], corners[which])));
    let label = |(remaining, place): (f64, DVec3)| {
        Some(Label {
            at: pixel(input, place)?,
            clear: 10.0 * ppp,
            text: Text::new("view-off-seat").with(&values!["length" => scale::length(-remaining)]),
            size: TEXT * ppp,
            color: palette.ink,
            plate: palette.plate,
            directions: BESIDE.to_vec(),
        })
    };
    corners.filter(|(remaining, _)| *remaining < 0.0).filter_map(label).flat_map(|label| placer.place(&label)).collect()
}
