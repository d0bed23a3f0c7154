//! The friction circle of the hardest contact that is closed, and of those selected: its tangential force in the plane of the face, over
//! `μ N(δ)`.
//!
//! The outline is `μ_s N(δ)`, the filled circle `μ_k N(δ)`; the arrow ends inside the outline in stick, on the rim of
//! the filled circle in slip.

use glam::{DVec3, Vec2};

use super::ViewInput;
use super::area::Area;
use super::block::{Block, girder_block};
use super::gauge::told;
use super::input::pixel;
use super::list::Mark;
use super::moment::Moment;
use super::palette::{Palette, of_state};
use super::texts::TEXT;
use crate::language::{Text, values};
use crate::scene::shown::shown;
use crate::sim::{ContactNow, ContactState};

/// Radius of the `μ_s` circle, and the least of a small picture \[points\].
const RADII: [f32; 2] = [44.0, 24.0];

/// The radius in parts of the picture's shorter side.
const SHARE: f32 = 0.1;

/// Half the side of a panel in radii, for the circle and its caption.
const HALF: f32 = 1.6;

/// Most points of the path that the tip has taken.
const PATH: u32 = 120;

/// The radius of a picture's circles \[pixels\].
fn radius(input: &ViewInput<'_>) -> f32 {
    let ppp = input.pixels_per_point;
    let side = input.size[0].min(input.size[1]) as f32;
    (SHARE * side).clamp(RADII[1] * ppp, RADII[0] * ppp)
}

/// Characters of a node's name above its circle.
const LONGEST_NAME: usize = 24;

/// Girders that a circle keeps clear of: of a long row, which fills the picture's width, the first.
const MOST_GIRDERS: usize = 40;

/// Points along a side of the raster by which what a circle covers is counted.
const RASTER: u8 = 6;

/// Most circles in a picture, one below the other.
const MOST_CIRCLES: usize = 2;

/// The circles at the top right, clear of these areas: of the hardest contact that is closed, then of those selected.
pub(super) fn friction_circles(
    input: &ViewInput<'_>,
    moment: &Moment,
    taken: &[Area],
    palette: &Palette,
) -> Vec<(Vec<Mark>, Area)> {
    let mut all: Vec<(Vec<Mark>, Area)> = Vec::new();
    for contact in told(input, moment).into_iter().take(MOST_CIRCLES) {
        let taken: Vec<Area> = taken.iter().chain(all.iter().map(|(_, area)| area)).copied().collect();
        all.extend(friction_circle(input, contact, free_place(input, moment, &taken), palette));
    }
    all
}

/// The first of some places at the edge of the picture that covers no contact, no tip of a force and none of these areas (legends, gauges,
/// ends of a gap), and of which not more than half lies over girders, or else the one that covers least of them; the top right where all
/// cover what is to be seen.
fn free_place(input: &ViewInput<'_>, moment: &Moment, taken: &[Area]) -> Area {
    let ppp = input.pixels_per_point;
    let half = Vec2::splat(HALF * radius(input));
    let (room, margin) = (Vec2::from(input.size.map(|s| s as f32)), half + 14.0 * ppp);
    let (right, left, top, bottom) = (room.x - margin.x, margin.x, margin.y, room.y - margin.y);
    let below = top + 2.0 * half.y + 8.0 * ppp;
    let middles = [
        Vec2::new(right, top),
        Vec2::new(right, bottom),
        Vec2::new(right, below),
        Vec2::new(left, room.y / 2.0),
        Vec2::new(room.x / 2.0, bottom),
        Vec2::new(room.x / 2.0, below),
        Vec2::new(left, bottom),
    ];
    let scale = moment.force_scale.unwrap_or(f64::INFINITY);
    let ends = moment.contacts.iter().flat_map(|c| [c.point, c.point + c.elastic_force() / scale]);
    let kept: Vec<Area> =
        ends.filter_map(|at| pixel(input, at)).map(|at| Area::about(at, Vec2::splat(9.0 * ppp))).collect();
    let is_free = |area: &Area| kept.iter().chain(taken).all(|other| other.overlap(area) == 0.0);
    let areas = middles.map(|middle| Area::about(middle, half));
    // As placed, so that a circle does not change its place with the girders' motion.
    let girders: Vec<Block> = input.scene.girders.iter().take(MOST_GIRDERS).map(girder_block).collect();
    let over = |area: &Area| {
        let covered = covered(input, &girders, area);
        if 2 * covered > usize::from(RASTER * RASTER) { covered } else { 0 }
    };
    areas.into_iter().filter(is_free).min_by_key(over).unwrap_or(areas[0])
}

/// Number of points of a raster over an area that show a girder.
fn covered(input: &ViewInput<'_>, girders: &[Block], area: &Area) -> usize {
    let size = Vec2::from(input.size.map(|s| s.max(1) as f32));
    let seen = |at: Vec2| {
        let (from, along) =
            input.camera.ray([at.x * 2.0 / size.x - 1.0, 1.0 - at.y * 2.0 / size.y].map(f64::from), input.aspect());
        girders.iter().any(|girder| girder.entry(from, along).is_some())
    };
    let raster =
        (0..RASTER * RASTER).map(|i| Vec2::new(f32::from(i % RASTER), f32::from(i / RASTER)) / f32::from(RASTER - 1));
    raster.filter(|part| seen(area.min + *part * area.size())).count()
}

fn friction_circle(
    input: &ViewInput<'_>,
    contact: &ContactNow,
    area: Area,
    palette: &Palette,
) -> Option<(Vec<Mark>, Area)> {
    let limit = contact.mu_static * contact.normal_force;
    if !(limit.is_finite() && limit > 0.0) {
        return None;
    }
    let (ppp, radius) = (input.pixels_per_point, radius(input));
    let middle = (area.min + area.max) / 2.0 - Vec2::new(0.0, 0.22 * radius);
    let round = Round { middle, radius, ppp };
    let rim = palette.faint_ink.with_alpha(0x50);
    let mut marks = vec![Mark::Panel { min: area.min, max: area.max, color: palette.plate, rim }];
    marks.extend(circles(contact, round, palette));
    marks.extend(path(input, contact.contact, round, palette));
    marks.extend(arrow(tangential(contact) / limit as f32, contact, round));
    marks.push(caption(contact, round, palette));
    marks.extend(name(input, contact, (round, area.min.y), palette));
    Some((marks, area))
}

/// Centre of a circle \[pixels\], and pixels per point.
#[derive(Clone, Copy)]
struct Round {
    middle: Vec2,
    radius: f32,
    ppp: f32,
}

/// The tangential force in the face's plane, as seen by the node's body: horizontal to the right, up is up \[N\].
fn tangential(contact: &ContactNow) -> Vec2 {
    let right = DVec3::Z.cross(contact.normal).normalize_or(DVec3::X);
    let up = contact.normal.cross(right);
    let force = contact.tangential_force;
    Vec2::new(force.dot(right) as f32, -force.dot(up) as f32)
}

/// Path of the tip since the touch began, at most [`PATH`] points of it.
fn path(input: &ViewInput<'_>, number: usize, round: Round, palette: &Palette) -> Vec<Mark> {
    let Some(history) = input.history else { return Vec::new() };
    let mut touches = history.hits().touches().iter();
    let Some(touch) = touches.find(|t| t.contact == number && (t.start..=t.end).contains(&input.t)) else {
        return Vec::new();
    };
    let at = |i: u32| touch.start + (input.t - touch.start) * f64::from(i) / f64::from(PATH);
    let tip = |i: u32| {
        let now = history.contacts().contact_at(number, at(i))?;
        let limit = now.mu_static * now.normal_force;
        // At the very ends of a touch both forces vanish and their ratio says nothing.
        let share = tangential(&now) / limit as f32;
        (limit > 0.0 && share.is_finite()).then(|| round.middle + share.clamp_length_max(1.25) * round.radius)
    };
    let points: Vec<Vec2> = (0..=PATH).filter_map(tip).collect();
    let color = palette.faint_ink.with_alpha(0xb0);
    if points.len() > 1 { vec![Mark::Stroke { points, width: 1.2 * round.ppp, color }] } else { Vec::new() }
}

/// The rim dashed in slip, as that of the cone.
fn circles(contact: &ContactNow, round: Round, palette: &Palette) -> Vec<Mark> {
    let Round { middle, radius, ppp } = round;
    let share = if contact.mu_static > 0.0 { contact.mu_kinetic / contact.mu_static } else { 0.0 };
    let color = of_state(contact.state).with_alpha(0x40);
    let clear = super::list::Rgba::CLEAR;
    let rim = |i: u16| Vec2::from_angle(f32::from(i) * std::f32::consts::TAU / 48.0);
    // No disk: that is the glyph of stick.
    let inner = Mark::Fill { points: (0..48).map(|i| middle + rim(i) * radius * share as f32).collect(), color };
    let (width, color) = (1.4 * ppp, palette.faint_ink);
    if contact.state != ContactState::Slip {
        return vec![inner, Mark::Ring { at: middle, radius, width, color, halo: clear }];
    }
    let at = |i: u16| middle + Vec2::from_angle(f32::from(i) * std::f32::consts::TAU / 36.0) * radius;
    let dash = |i: u16| Mark::Stroke { points: vec![at(2 * i), at(2 * i + 1)], width, color };
    std::iter::once(inner).chain((0..18).map(dash)).collect()
}

fn arrow(share: Vec2, contact: &ContactNow, Round { middle, radius, ppp }: Round) -> Vec<Mark> {
    let color = of_state(contact.state);
    let tip = middle + share * radius;
    let along = share.normalize_or_zero();
    let head = along * (9.0 * ppp).min(share.length() * radius);
    let aside = Vec2::new(-head.y, head.x) * 0.45;
    vec![
        Mark::Stroke { points: vec![middle, tip - head], width: 2.4 * ppp, color },
        Mark::Fill { points: vec![tip - head + aside, tip, tip - head - aside], color },
    ]
}

/// Name of its contact: the node, above the circle.
fn name(
    input: &ViewInput<'_>,
    contact: &ContactNow,
    (Round { middle, radius, ppp }, top): (Round, f32),
    palette: &Palette,
) -> Option<Mark> {
    let node = input.history?.model().sites.get(contact.contact)?.node_in_words();
    let size = (0.25 * radius).min((TEXT - 2.0) * ppp);
    Some(Mark::Text {
        at: Vec2::new(middle.x, 0.4 * top + 0.6 * (middle.y - radius)),
        align: Vec2::splat(0.5),
        size,
        text: shown(&node, LONGEST_NAME),
        color: palette.faint_ink,
        plate: None,
    })
}

fn caption(contact: &ContactNow, Round { middle, radius, ppp }: Round, palette: &Palette) -> Mark {
    let ratio = contact.tangential_force.length() / contact.normal_force;
    Mark::Text {
        at: middle + Vec2::new(0.0, 1.42 * radius),
        align: Vec2::splat(0.5),
        size: (0.29 * radius).min((TEXT - 1.0) * ppp),
        text: Text::new("view-cone-use")
            .with(&values!["ratio" => format!("{ratio:.3}"), "most" => format!("{:.2}", contact.mu())]),
        color: palette.ink,
        plate: None,
    }
}
