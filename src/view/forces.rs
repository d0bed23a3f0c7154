//! Contacts and their forces: state glyphs, arrows, friction cones.
//!
//! Every arrow is the force on the body that owns the node, in one fixed scale.

use glam::Vec2;

use super::friction_cone::friction_cone;
use super::input::{LEAST_FORCE, pixel};
use super::list::{Arrow, ArrowKind, Cone, Line, Mark};
use super::moment::{Impulse, Moment};
use super::palette::{DAMPING, IMPULSE, NORMAL, OPENED, Palette, SELECTED, TANGENTIAL, of_state};
use super::{Target, ViewInput};
use crate::sim::{ContactNow, ContactState};

/// Radius of an arrow's shaft \[points\].
const SHAFT: f64 = 1.9;

/// Marks of the contacts in a picture.
#[derive(Debug, Default)]
pub(super) struct Forces {
    pub(super) cones: Vec<Cone>,
    pub(super) lines: Vec<Line>,
    pub(super) arrows: Vec<Arrow>,
    pub(super) marks: Vec<Mark>,
}

/// Everything that the contacts of a moment add to the picture.
pub(super) fn forces(input: &ViewInput<'_>, moment: &Moment, palette: &Palette) -> Forces {
    let mut out = Forces::default();
    for contact in &moment.contacts {
        if let Some(scale) = moment.force_scale {
            if input.overlays.cones {
                let (cone, strokes) = friction_cone(input, contact, scale, palette).unzip();
                out.cones.extend(cone);
                out.lines.extend(strokes.into_iter().flatten());
            }
            out.arrows.extend(arrows(input, contact, scale, palette));
        }
    }
    out.arrows.extend(moment.impulses.iter().filter_map(|impulse| impulse_arrow(input, moment, impulse, palette)));
    if input.overlays.contacts {
        out.marks = glyphs(input, moment, palette);
    }
    out
}

/// The arrows of a contact that are asked for.
fn arrows(input: &ViewInput<'_>, c: &ContactNow, scale: f64, palette: &Palette) -> Vec<Arrow> {
    let o = input.overlays;
    let damping = c.normal * c.normal_damping + c.tangential_damping;
    let wanted = [
        (o.normal, ArrowKind::Normal, c.normal * c.normal_force, NORMAL),
        (o.tangential, ArrowKind::Tangential, c.tangential_force, TANGENTIAL),
        (o.damping, ArrowKind::Damping, damping, DAMPING),
        (o.resultant, ArrowKind::Resultant, c.elastic_force(), palette.resultant),
    ];
    let point = input.point_length(c.point);
    wanted
        .into_iter()
        .filter(|(on, _, force, _)| *on && force.is_finite() && force.length() / scale > LEAST_FORCE * point)
        .map(|(_, kind, force, color)| Arrow {
            contact: c.contact,
            kind,
            from: c.point.as_vec3(),
            to: (c.point + force / scale).as_vec3(),
            // The resultant a little stouter: where it lies on another arrow, both are seen.
            radius: (point * if kind == ArrowKind::Resultant { SHAFT } else { 0.8 * SHAFT }) as f32,
            color,
            halo: palette.halo,
        })
        .collect()
}

/// An impulse: as long as it was large, fainter as it lies back.
fn impulse_arrow(input: &ViewInput<'_>, moment: &Moment, i: &Impulse, palette: &Palette) -> Option<Arrow> {
    let scale = moment.impulse_scale?;
    let point = input.point_length(i.point);
    let seen = input.overlays.resultant && i.impulse.is_finite() && i.impulse.length() / scale > LEAST_FORCE * point;
    seen.then(|| Arrow {
        contact: i.contact,
        kind: ArrowKind::Impulse,
        from: i.point.as_vec3(),
        to: (i.point + i.impulse / scale).as_vec3(),
        radius: (1.2 * point * SHAFT) as f32,
        color: IMPULSE.fainter(i.left),
        halo: palette.halo.fainter(i.left),
    })
}

/// State glyphs: a filled disk in stick, a ring in slip, a cross where a contact has just opened.
fn glyphs(input: &ViewInput<'_>, moment: &Moment, palette: &Palette) -> Vec<Mark> {
    let ppp = input.pixels_per_point;
    let halo = palette.halo;
    let opened = moment.opened.iter().filter_map(|o| {
        Some(Mark::Cross { at: pixel(input, o.point)?, radius: 4.5 * ppp, width: 2.2 * ppp, color: OPENED, halo })
    });
    let closed = moment.contacts.iter().filter_map(|c| Some(glyph(pixel(input, c.point)?, c.state, ppp, palette)));
    let chosen = moment.contacts.iter().filter(|c| input.selected.contains(&Target::Contact(c.contact)));
    let chosen = chosen.filter_map(|c| {
        Some(Mark::Ring { at: pixel(input, c.point)?, radius: 10.0 * ppp, width: 2.2 * ppp, color: SELECTED, halo })
    });
    opened.chain(chosen).chain(closed).collect()
}

/// The glyph of a state.
pub(super) fn glyph(at: Vec2, state: ContactState, ppp: f32, palette: &Palette) -> Mark {
    let (color, halo) = (of_state(state), palette.halo);
    match state {
        ContactState::Stick => Mark::Disk { at, radius: 5.2 * ppp, color, halo },
        ContactState::Slip => Mark::Ring { at, radius: 4.6 * ppp, width: 2.6 * ppp, color, halo },
        ContactState::Open => Mark::Cross { at, radius: 4.5 * ppp, width: 2.2 * ppp, color, halo },
    }
}
