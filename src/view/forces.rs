//! Contacts and their forces: state glyphs, arrows, friction cones (design: "Drawing honestly").
//!
//! Every arrow is the force on the body that owns the node, in one fixed scale. The cone stands on the contact with
//! its axis along the face's normal and is `K δ` high in the arrows' scale; the resultant is the force without
//! dashpots, so its tip lies inside the outline (`μ_s`) in stick and on the rim of the filled cone (`μ_k`) in slip.

use glam::{DVec3, Vec2};

use super::ViewInput;
use super::list::{Arrow, ArrowKind, Cone, Line, Mark};
use super::moment::{Impulse, Moment};
use super::palette::{DAMPING, IMPULSE, NORMAL, OPENED, Palette, SELECTED, TANGENTIAL, of_state};
use super::{Basis, Target};
use crate::sim::{ContactNow, ContactState};

/// Arrows and cones lower than this are not drawn \[points\].
const LEAST: f64 = 1.5;
/// Radius of an arrow's shaft \[points\].
const SHAFT: f64 = 1.9;
/// Segments of a cone's rim.
const RIM: usize = 48;

/// What the contacts add to a picture.
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
                out.add_cone(input, contact, scale, palette);
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

/// World length of a point at a place \[m\].
fn point_length(input: &ViewInput<'_>, at: DVec3) -> f64 {
    input.camera.metres_per_pixel(at, f64::from(input.size[1])) * f64::from(input.pixels_per_point)
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
    let point = point_length(input, c.point);
    wanted
        .into_iter()
        .filter(|(on, _, force, _)| *on && force.is_finite() && force.length() / scale > LEAST * point)
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
    let point = point_length(input, i.point);
    let seen = input.overlays.resultant && i.impulse.is_finite() && i.impulse.length() / scale > LEAST * point;
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

impl Forces {
    fn add_cone(&mut self, input: &ViewInput<'_>, c: &ContactNow, scale: f64, palette: &Palette) {
        let height = c.normal_force / scale;
        if !(height.is_finite() && height > LEAST * point_length(input, c.point)) {
            return;
        }
        self.cones.push(Cone {
            contact: c.contact,
            apex: c.point.as_vec3(),
            axis: c.normal.as_vec3(),
            height: height as f32,
            mu_static: c.mu_static as f32,
            mu_kinetic: c.mu_kinetic as f32,
            color: of_state(c.state),
        });
        let thin = input.pixels_per_point;
        let line = |group, color, width: f32| {
            move |[a, b]: [DVec3; 2]| Line { group, from: a.as_vec3(), to: b.as_vec3(), width: width * thin, color }
        };
        let outer = outline(input, c, height, c.mu_static);
        self.lines.extend(outer.into_iter().map(line("outline cone", palette.faint_ink, 1.1)));
        let inner = rim(c, height, c.mu_kinetic);
        self.lines.extend(inner.into_iter().map(line("filled cone's rim", of_state(c.state), 1.1)));
    }
}

/// The rim of a cone, as strokes.
fn rim(c: &ContactNow, height: f64, mu: f64) -> Vec<[DVec3; 2]> {
    let (u, v) = c.normal.any_orthonormal_pair();
    let top = c.point + c.normal * height;
    let at = |i: usize| {
        let (s, co) = (std::f64::consts::TAU * i as f64 / RIM as f64).sin_cos();
        top + (u * co + v * s) * (height * mu)
    };
    (0..RIM).map(|i| [at(i), at(i + 1)]).collect()
}

/// The outline of a cone as seen: its rim and the two generators where the line of sight grazes it.
fn outline(input: &ViewInput<'_>, c: &ContactNow, height: f64, mu: f64) -> Vec<[DVec3; 2]> {
    let mut strokes = rim(c, height, mu);
    let Basis { back, .. } = input.camera.basis();
    let sight = match input.camera.projection {
        super::Projection::Perspective { .. } => (input.camera.eye() - c.point).normalize_or_zero(),
        super::Projection::Orthographic => back,
    };
    let (u, v) = c.normal.any_orthonormal_pair();
    let (along, side_u, side_v) = (sight.dot(c.normal), sight.dot(u), sight.dot(v));
    let across = side_u.hypot(side_v);
    // A generator n + μ(u cos φ + v sin φ) is grazed where the surface's normal is square to the line of sight.
    let graze = mu * along / across;
    if across > 0.0 && graze.abs() < 1.0 {
        let middle = side_v.atan2(side_u);
        for turn in [graze.acos(), -graze.acos()] {
            let (s, co) = (middle + turn).sin_cos();
            strokes.push([c.point, c.point + (c.normal + (u * co + v * s) * mu) * height]);
        }
    }
    strokes
}

fn pixels(input: &ViewInput<'_>, at: DVec3) -> Option<Vec2> {
    let [x, y] = input.camera.project(at, input.size.map(f64::from))?;
    (x.is_finite() && y.is_finite()).then(|| Vec2::new(x as f32, y as f32))
}

/// State glyphs: a filled disk in stick, a ring in slip, a cross where a contact has just opened.
fn glyphs(input: &ViewInput<'_>, moment: &Moment, palette: &Palette) -> Vec<Mark> {
    let ppp = input.pixels_per_point;
    let halo = palette.halo;
    let opened = moment.opened.iter().filter_map(|o| {
        Some(Mark::Cross { at: pixels(input, o.point)?, radius: 4.5 * ppp, width: 2.2 * ppp, color: OPENED, halo })
    });
    let closed = moment.contacts.iter().filter_map(|c| Some(glyph(pixels(input, c.point)?, c.state, ppp, palette)));
    let chosen = moment.contacts.iter().filter(|c| input.selected.contains(&Target::Contact(c.contact)));
    let chosen = chosen.filter_map(|c| {
        Some(Mark::Ring { at: pixels(input, c.point)?, radius: 10.0 * ppp, width: 2.2 * ppp, color: SELECTED, halo })
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
