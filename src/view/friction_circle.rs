//! The friction circle of the selected contact: its tangential force in the plane of the face, over `μ K δ`.
//!
//! The outline is `μ_s K δ`, the filled circle `μ_k K δ`; the arrow ends inside the outline in stick, on the rim of
//! the filled circle in slip.

use glam::{DVec3, Vec2};

use super::area::Area;
use super::list::Mark;
use super::moment::Moment;
use super::palette::{Palette, of_state};
use super::texts::TEXT;
use super::{Target, ViewInput};
use crate::sim::ContactNow;

/// Radius of the `μ_s` circle \[points\].
const RADIUS: f32 = 44.0;

/// Most points of the path that the tip has taken.
const PATH: u32 = 120;

/// The circle at the top right, where a closed contact is selected.
pub(super) fn friction_circle(input: &ViewInput<'_>, moment: &Moment, palette: &Palette) -> Option<(Vec<Mark>, Area)> {
    let Some(&Target::Contact(number)) = input.selected.last() else { return None };
    let contact = moment.contacts.iter().find(|c| c.contact == number)?;
    let limit = contact.mu_static * contact.normal_force;
    if !(limit.is_finite() && limit > 0.0) {
        return None;
    }
    let ppp = input.pixels_per_point;
    let middle = Vec2::new(input.size[0] as f32 - 84.0 * ppp, 84.0 * ppp);
    let half = Vec2::splat(70.0 * ppp);
    let area = Area::about(middle, half);
    let rim = palette.faint_ink.with_alpha(0x50);
    let mut marks = vec![Mark::Panel { min: area.min, max: area.max, color: palette.plate, rim }];
    marks.extend(circles(contact, middle, ppp, palette));
    marks.extend(path(input, number, middle, palette));
    marks.extend(arrow(tangential(contact) / limit as f32, contact, middle, ppp));
    marks.push(caption(contact, middle, ppp, palette));
    Some((marks, area))
}

/// The tangential force in the face's plane, as seen by the node's body: horizontal to the right, up is up \[N\].
fn tangential(contact: &ContactNow) -> Vec2 {
    let right = DVec3::Z.cross(contact.normal).normalize_or(DVec3::X);
    let up = contact.normal.cross(right);
    let force = contact.tangential_force;
    Vec2::new(force.dot(right) as f32, -force.dot(up) as f32)
}

/// Where the tip has been since the touch began, at most [`PATH`] points of it.
fn path(input: &ViewInput<'_>, number: usize, middle: Vec2, palette: &Palette) -> Vec<Mark> {
    let Some(history) = input.history else { return Vec::new() };
    let mut touches = history.touches().iter();
    let Some(touch) = touches.find(|t| t.contact == number && (t.start..=t.end).contains(&input.t)) else {
        return Vec::new();
    };
    let ppp = input.pixels_per_point;
    let at = |i: u32| touch.start + (input.t - touch.start) * f64::from(i) / f64::from(PATH);
    let tip = |i: u32| {
        let now = history.contact_at(number, at(i))?;
        let limit = now.mu_static * now.normal_force;
        // At the very ends of a touch both forces vanish and their ratio says nothing.
        let share = tangential(&now) / limit as f32;
        (limit > 0.0 && share.is_finite()).then(|| middle + share.clamp_length_max(1.25) * RADIUS * ppp)
    };
    let points: Vec<Vec2> = (0..=PATH).filter_map(tip).collect();
    let color = palette.faint_ink.with_alpha(0xb0);
    if points.len() > 1 { vec![Mark::Stroke { points, width: 1.2 * ppp, color }] } else { Vec::new() }
}

fn circles(contact: &ContactNow, middle: Vec2, ppp: f32, palette: &Palette) -> [Mark; 2] {
    let share = if contact.mu_static > 0.0 { contact.mu_kinetic / contact.mu_static } else { 0.0 };
    let color = of_state(contact.state).with_alpha(0x40);
    let clear = super::list::Rgba::CLEAR;
    [
        Mark::Disk { at: middle, radius: RADIUS * share as f32 * ppp, color, halo: clear },
        Mark::Ring { at: middle, radius: RADIUS * ppp, width: 1.4 * ppp, color: palette.faint_ink, halo: clear },
    ]
}

fn arrow(share: Vec2, contact: &ContactNow, middle: Vec2, ppp: f32) -> Vec<Mark> {
    let color = of_state(contact.state);
    let tip = middle + share * RADIUS * ppp;
    let along = share.normalize_or_zero();
    let head = along * (9.0 * ppp).min(share.length() * RADIUS * ppp);
    let aside = Vec2::new(-head.y, head.x) * 0.45;
    vec![
        Mark::Stroke { points: vec![middle, tip - head], width: 2.4 * ppp, color },
        Mark::Fill { points: vec![tip - head + aside, tip, tip - head - aside], color },
    ]
}

fn caption(contact: &ContactNow, middle: Vec2, ppp: f32, palette: &Palette) -> Mark {
    let ratio = contact.tangential_force.length() / contact.normal_force;
    Mark::Text {
        at: middle + Vec2::new(0.0, 58.0 * ppp),
        align: Vec2::splat(0.5),
        size: (TEXT - 1.0) * ppp,
        text: format!("T/N {ratio:.3} of {:.2}", contact.mu_static),
        color: palette.ink,
        plate: None,
    }
}
