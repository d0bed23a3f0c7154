//! The friction cone of a contact: which cone is drawn, how large, and its rims and outline.
//!
//! The cone stands on the contact with its axis along the face's normal and is `N(δ)` high in the arrows' scale; the
//! resultant is the force without dashpots, so its tip lies inside the outline (`μ_s`) in stick and on the rim of the
//! filled cone (`μ_k`) in slip. In stick the outline is a full line, in slip a dashed one. Pixels: `render/pass/cone.rs`, `shaders/cone.wgsl`; the same cone cut across its axis:
//! `friction_circle.rs`.

use glam::DVec3;

use super::input::LEAST_FORCE;
use super::list::{Cone, Line};
use super::palette::{Palette, of_state};
use super::{Basis, Projection, ViewInput};
use crate::sim::{ContactNow, ContactState};

/// Dashes of a generator in slip.
const DASHES: u32 = 9;

/// Segments of a cone's rim.
const RIM: usize = 48;

/// The cone of a contact and its strokes at `scale` newtons a metre of the scene; nothing where it is too low to be seen.
pub(super) fn friction_cone(
    input: &ViewInput<'_>,
    c: &ContactNow,
    scale: f64,
    palette: &Palette,
) -> Option<(Cone, Vec<Line>)> {
    let height = c.normal_force / scale;
    if !(height.is_finite() && height > LEAST_FORCE * input.point_length(c.point)) {
        return None;
    }
    let color = of_state(c.state);
    let cone = Cone {
        contact: c.contact,
        apex: c.point.as_vec3(),
        axis: c.normal.as_vec3(),
        height: height as f32,
        mu_static: c.mu_static as f32,
        mu_kinetic: c.mu_kinetic as f32,
        color,
    };
    let width = 1.1 * input.pixels_per_point;
    let line =
        |group, color| move |[a, b]: [DVec3; 2]| Line { group, from: a.as_vec3(), to: b.as_vec3(), width, color };
    let outer = outline(input, c, height, c.mu_static).into_iter().map(line("outline cone", palette.faint_ink));
    let inner = rim(c, height, c.mu_kinetic).into_iter().map(line("filled cone's rim", color));
    Some((cone, outer.chain(inner).collect()))
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
    let slips = c.state == ContactState::Slip;
    // Dashed in slip: every other stroke of the rim, and parts of the generators.
    let mut strokes: Vec<_> = rim(c, height, mu).into_iter().step_by(if slips { 2 } else { 1 }).collect();
    let Basis { back, .. } = input.camera.basis();
    let sight = match input.camera.projection {
        Projection::Perspective { .. } => (input.camera.eye() - c.point).normalize_or_zero(),
        Projection::Orthographic => back,
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
            let to = c.point + (c.normal + (u * co + v * s) * mu) * height;
            if slips {
                let part = |n: u32| c.point.lerp(to, f64::from(n) / f64::from(2 * DASHES));
                strokes.extend((0..DASHES).map(|n| [part(2 * n), part(2 * n + 1)]));
            } else {
                strokes.push([c.point, to]);
            }
        }
    }
    strokes
}
