//! A gauge beside the arrow of a contact: how much of the friction cone is used, `|T|/(μ N)`, empty to full.
//!
//! In stick it is filled from below as far as the cone is used, up to its rim, with `μ_s`; in slip it is full and hatched, with
//! `μ_k`. State and share are read without colour: by fill, texture and height.

use glam::Vec2;

use super::area::Area;
use super::camera::hardest;
use super::input::pixel;
use super::list::{Mark, Rgba};
use super::moment::Moment;
use super::palette::{Palette, of_state};
use super::{Target, ViewInput};
use crate::sim::{ContactNow, ContactState};

/// Width and height \[points\].
const SIZE: Vec2 = Vec2::new(13.0, 62.0);
/// From the contact to the middle of the gauge, square to the arrow \[points\].
const ASIDE: f32 = 40.0;
/// Direction that counts as upwards: a little to the left, so that a contact with an upright normal has its gauge on its left.
const UPWARDS: Vec2 = Vec2::new(-0.2, -0.98);
/// Between the lines of the hatching \[points\].
const HATCH: f32 = 7.0;

/// Contacts with gauge and friction circle: the closed one of the largest force, and those selected.
pub(super) fn told<'a>(input: &ViewInput<'_>, moment: &'a Moment) -> Vec<&'a ContactNow> {
    let first = hardest(&moment.contacts).filter(|_| input.overlays.cones);
    let chosen = moment.contacts.iter().filter(|c| input.selected.contains(&Target::Contact(c.contact)));
    let others = chosen.filter(|c| first.is_none_or(|first| first.contact != c.contact));
    first.into_iter().chain(others).filter(|c| limit(c) > 0.0 && c.tangential_force.is_finite()).collect()
}

/// `μ N`, with `μ_s` in stick and `μ_k` in slip \[N\]; 0 where that is no number.
fn limit(c: &ContactNow) -> f64 {
    Some(c.mu() * c.normal_force).filter(|limit| limit.is_finite()).unwrap_or(0.0)
}

/// The inside of the gauge of a contact, top left and bottom right \[pixels\]; `None` where the contact is not in the picture.
pub fn place(input: &ViewInput<'_>, c: &ContactNow) -> Option<[Vec2; 2]> {
    beside(input, c, &[]).map(|Area { min, max }| [min, max])
}

/// The inside of the gauge at the first place beside the arrow that covers none of these areas; the nearest where all do.
fn beside(input: &ViewInput<'_>, c: &ContactNow, taken: &[Area]) -> Option<Area> {
    let ppp = input.pixels_per_point;
    let at = pixel(input, c.point)?;
    let tip = pixel(input, c.point + c.normal * input.point_length(c.point))?;
    // Square to the normal on the picture, on the side that looks upwards, and so on the same one in every picture of a film: the arrow
    // reaches neither up to μ = 0.8, where it passes a corner of the gauge beside an upright normal.
    let along = (tip - at).try_normalize().unwrap_or(Vec2::NEG_Y);
    let side = Vec2::new(-along.y, along.x);
    let side = if side.dot(UPWARDS) < 0.0 { -side } else { side };
    let half = SIZE * 0.5 * ppp;
    let room = Vec2::from(input.size.map(|s| s as f32));
    let margin = half + 4.0 * ppp;
    if room.cmplt(margin * 2.0).any() || at.cmplt(Vec2::ZERO).any() || at.cmpgt(room).any() {
        return None;
    }
    let places = [1.0, -1.0, 2.0, -2.0].map(|far| {
        let middle = at + (side * ASIDE * far - along * 10.0) * ppp;
        Area::about(middle.clamp(margin, room - margin), half)
    });
    let bare = |place: &Area| taken.iter().all(|other| other.overlap(&rimmed(place, ppp)) == 0.0);
    Some(places.into_iter().find(bare).unwrap_or(places[0]))
}

/// With its rim.
fn rimmed(inside: &Area, ppp: f32) -> Area {
    Area { min: inside.min - 3.0 * ppp, max: inside.max + 3.0 * ppp }
}

/// The gauge of a contact clear of these areas, and the area that it covers.
pub(super) fn gauge(
    input: &ViewInput<'_>,
    c: &ContactNow,
    taken: &[Area],
    palette: &Palette,
) -> Option<(Vec<Mark>, Area)> {
    let inside = beside(input, c, taken)?;
    let ppp = input.pixels_per_point;
    let border = rimmed(&inside, ppp);
    let Area { min, max } = inside;
    let slips = c.state == ContactState::Slip;
    #[expect(clippy::cast_possible_truncation, reason = "a share")]
    let share = if slips { 1.0 } else { c.cone_use().clamp(0.0, 1.0) as f32 };
    let color = of_state(c.state);
    let mut marks =
        vec![Mark::Panel { min: border.min, max: border.max, color: palette.halo.with_alpha(0xff), rim: palette.ink }];
    let level = max.y - (max.y - min.y) * share;
    marks.push(Mark::Fill { points: rectangle(Vec2::new(min.x, level), max), color });
    if slips {
        marks.extend(hatching([min, max], ppp, palette.halo.with_alpha(0xff)));
    } else {
        marks.extend(scale([min, max], ppp, palette.ink));
    }
    Some((marks, border))
}

fn rectangle(min: Vec2, max: Vec2) -> Vec<Vec2> {
    vec![min, Vec2::new(max.x, min.y), max, Vec2::new(min.x, max.y)]
}

/// Lines across a full gauge.
fn hatching([min, max]: [Vec2; 2], ppp: f32, color: Rgba) -> Vec<Mark> {
    let (width, step) = (max.x - min.x, HATCH * ppp);
    let starts = (0..64).map(|i| max.y - i as f32 * step).take_while(|y| *y - width > min.y);
    let line = |y: f32| Mark::Stroke {
        points: vec![Vec2::new(min.x, y), Vec2::new(max.x, y - width)],
        width: 2.2 * ppp,
        color,
    };
    starts.map(line).collect()
}

/// Ticks at a quarter, a half and three quarters.
fn scale([min, max]: [Vec2; 2], ppp: f32, color: Rgba) -> Vec<Mark> {
    let tick = |share: f32| {
        let y = max.y + (min.y - max.y) * share;
        let length = if share == 0.5 { 5.0 } else { 3.0 } * ppp;
        let points = vec![Vec2::new(max.x - length, y), Vec2::new(max.x, y)];
        Mark::Stroke { points, width: 1.2 * ppp, color }
    };
    [0.25, 0.5, 0.75].map(tick).into()
}
