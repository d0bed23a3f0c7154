//! Where two sides of a pair touch, and what a push there does to them.
//!
//! With `n` the unit normal from the second side to the first (out of a wall, towards the girder), `s = ẑ × n` and
//! levers `ρ` from each G, the relative velocity at the point is `V = V₁ − V₂`, `v_n = V·n`, `v_s = V·s`; an impulse
//! `(P_n, P_s)` acts on the first side and its opposite on the second. Per unit mass and with a wall behind it these
//! are the quantities of `docs/physics.md#levers-and-mobilities`: `w_n = 1 + ρ_n²/i²`, `w_ns = ρ_n ρ_s/i²` with
//! `ρ_n = ρ × n`, `ρ_s = ρ × s` (26).

use glam::{DVec2, DVec3};

use crate::contact::{Frame, locate};
use crate::dynamics::free_flight::flight::Planar;
use crate::dynamics::impact2d::Few;
use crate::dynamics::{Body, Model};

/// A point where the two sides of a pair touch or may touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Places of the first and the second side's body among those looked at; nothing for an abutment.
    pub bodies: [Option<usize>; 2],
    /// Normal, from the second side to the first.
    pub n: DVec2,
    /// Tangent, `ẑ × n`.
    pub s: DVec2,
    /// Levers from each G \[m\].
    pub arms: [DVec2; 2],
    /// `g` \[m\].
    pub gap: f64,
    /// How far inside the face it projects; negative outside \[m\].
    pub inset: f64,
    /// Its place along `s` \[m\].
    pub along: f64,
    /// What turning alone makes of the accelerations along `n` and `s` \[m/s²\].
    pub bias: [f64; 2],
}

impl Point {
    /// The node of a declared contact against its face, `frames` being those of its pair's first and second side.
    pub fn of(model: &Model, site: usize, bodies: [Option<usize>; 2], frames: [&Frame; 2]) -> Self {
        let site = &model.contacts[site];
        let fixed = Frame::fixed(site.fixed);
        let side = |side: usize| if bodies[side].is_some() { frames[side] } else { &fixed };
        // The node belongs to the first side unless the face does.
        let first_is_node = site.node_body == model.pairs[site.pair].bodies[0];
        let (node, face) = if first_is_node { (side(0), side(1)) } else { (side(1), side(0)) };
        let here = locate(&site.home, node, face);
        let outward = face.turn(site.home.axes.z_axis).truncate();
        let n = if first_is_node { outward } else { -outward };
        let node_arm = node.turn(site.home.arm).truncate();
        let face_arm = ((node.home - face.home) + (node.shift - face.shift)).truncate() + node_arm;
        let arms = if first_is_node { [node_arm, face_arm] } else { [face_arm, node_arm] };
        let slide =
            (node.velocity - face.velocity).truncate() + node_arm.perp() * node.spin.z - face_arm.perp() * face.spin.z;
        let turning = -node.spin.z * node.spin.z * node_arm + face.spin.z * face.spin.z * face_arm
            - 2.0 * face.spin.z * slide.perp();
        Self {
            bodies,
            n,
            s: n.perp(),
            arms,
            gap: here.gap,
            inset: site.face.inset_at(here.at),
            along: (node.origin().truncate() + node_arm).dot(n.perp()),
            // Counted as seen from the face: where the node is on the second side, n and V change sign together.
            bias: [turning.dot(outward), turning.dot(outward.perp())],
        }
    }

    /// The point at the part `x` of the way to another of the same pair.
    #[must_use]
    pub fn towards(&self, other: &Self, x: f64) -> Self {
        let mix = |a: f64, b: f64| a + (b - a) * x;
        Self {
            arms: [0, 1].map(|i| self.arms[i].lerp(other.arms[i], x)),
            gap: mix(self.gap, other.gap),
            inset: mix(self.inset, other.inset),
            along: mix(self.along, other.along),
            bias: [0, 1].map(|i| mix(self.bias[i], other.bias[i])),
            ..*self
        }
    }

    /// What turns velocities `(v_x, v_y, ω)` of both sides into one along `direction`; likewise a force along it into
    /// force and moment on each.
    pub fn row(&self, direction: DVec2) -> [(Option<usize>, DVec3); 2] {
        let along = |arm: DVec2| direction.extend(arm.perp_dot(direction));
        [(self.bodies[0], along(self.arms[0])), (self.bodies[1], -along(self.arms[1]))]
    }
}

/// Bodies that an instant concerns, as far as pushes go.
#[derive(Clone, Debug, PartialEq)]
pub struct Cluster {
    /// Per body: `1/m, 1/m, 1/(m i²)`, 0 in held directions.
    pub inverse: Few<DVec3>,
    /// Per body: `(v_x, v_y, ω)`.
    pub velocity: Few<DVec3>,
}

/// `1/m, 1/m, 1/(m i²)` of a body, 0 in held directions.
pub fn inverse_mass(body: &Body) -> DVec3 {
    let free = |i: usize| if body.free[i] { 1.0 } else { 0.0 };
    DVec3::new(free(0) / body.mass, free(1) / body.mass, free(5) / (body.mass * body.gyration2))
}

/// The rates in a planar state.
pub fn rates(state: &Planar) -> DVec3 {
    DVec3::new(state[3], state[4], state[5])
}

impl Cluster {
    /// Relative velocity along `direction` at a point \[m/s\].
    pub fn speed(&self, point: &Point, direction: DVec2) -> f64 {
        let part = |(body, row): (Option<usize>, DVec3)| body.map_or(0.0, |b| row.dot(self.velocity[b]));
        point.row(direction).into_iter().map(part).sum()
    }

    /// `[v_n, v_s]` at a point \[m/s\].
    pub fn speeds(&self, point: &Point) -> [f64; 2] {
        [self.speed(point, point.n), self.speed(point, point.s)]
    }

    /// Velocity along `d` at `p` per impulse along `e` at `q` \[1/kg\].
    pub fn mobility(&self, p: &Point, d: DVec2, q: &Point, e: DVec2) -> f64 {
        let mut sum = 0.0;
        for (body, row) in p.row(d) {
            for (other, push) in q.row(e) {
                if let (Some(b), true) = (body, body == other) {
                    sum += row.dot(self.inverse[b] * push);
                }
            }
        }
        sum
    }

    /// `[W_nn, W_ss, W_ns]` at a point \[1/kg\].
    pub fn mobilities(&self, p: &Point) -> [f64; 3] {
        [self.mobility(p, p.n, p, p.n), self.mobility(p, p.s, p, p.s), self.mobility(p, p.n, p, p.s)]
    }

    /// Applies an impulse `[P_n, P_s]` \[N·s\]; returns the energy that it adds \[J\].
    pub fn push(&mut self, point: &Point, [normal, tangential]: [f64; 2]) -> f64 {
        let before = self.speeds(point);
        for (body, row) in point.row(point.n * normal + point.s * tangential) {
            if let Some(b) = body {
                self.velocity[b] += self.inverse[b] * row;
            }
        }
        let after = self.speeds(point);
        0.5 * (normal * (before[0] + after[0]) + tangential * (before[1] + after[1]))
    }

    /// A speed of which differences are rounding \[m/s\].
    pub fn rounding<'a>(&self, points: impl IntoIterator<Item = &'a Point>) -> f64 {
        let reach = points.into_iter().flat_map(|p| p.arms).map(DVec2::length).fold(0.0, f64::max);
        let fast = |v: &DVec3| v.truncate().length() + v.z.abs() * reach;
        ROUNDING * self.velocity.iter().map(fast).fold(0.0, f64::max)
    }
}

/// Velocities that differ by less than this part of the fastest are the same.
const ROUNDING: f64 = 1e-12;
