//! Contact points and their Delassus terms: relative velocity per unit impulse \[1/kg\].
//!
//! With `n` the unit normal from the second side to the first (out of a wall, towards the girder), `s = ẑ × n` and levers
//! `ρ` from each G, the relative velocity at the point is `V = V₁ − V₂`, `v_n = V·n`, `v_s = V·s`; an impulse `(P_n, P_s)`
//! acts on the first side and its opposite on the second. `W_nn = Σ(1/m + ρ_n²/(m i²))`, `W_ns = Σ ρ_n ρ_s/(m i²)`, with
//! `ρ_n = ρ × n`, `ρ_s = ρ × s` (26), summed over the sides that can move
//! (`docs/physics.md#levers-and-mobilities`).

use glam::{DVec2, DVec3};

use crate::contact::{Frame, locate};
use crate::dynamics::impact2d::InlineVec;
use crate::dynamics::impact2d::constants::IMPACT_SPEED_ROUNDING;
use crate::dynamics::model::coordinates::planar::{self, PlanarState};
use crate::dynamics::{Body, Model};

/// A point where the two sides of a pair touch or may touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPoint {
    /// Places of the bodies of the first and the second side in the cluster; none for an abutment.
    pub bodies: [Option<usize>; 2],
    /// Normal, from the second side to the first.
    pub n: DVec2,
    /// Tangent, `ẑ × n`.
    pub s: DVec2,
    /// Levers from each G \[m\].
    pub arms: [DVec2; 2],
    /// `g` \[m\].
    pub gap: f64,
    /// Distance of its foot from the border of the face; negative outside \[m\].
    pub inset: f64,
    /// Coordinate along `s` \[m\].
    pub along: f64,
    /// Accelerations along `n` and `s` from velocities alone, centripetal and Coriolis \[m/s²\].
    pub bias: [f64; 2],
}

impl ContactPoint {
    /// The node of a declared contact against its face; `frames` are those of the first and the second side of its pair.
    pub fn of(model: &Model, site: usize, bodies: [Option<usize>; 2], frames: [&Frame; 2]) -> Self {
        let site = &model.sites[site];
        let fixed = Frame::fixed(site.fixed);
        let side = |side: usize| if bodies[side].is_some() { frames[side] } else { &fixed };
        // The node belongs to the first side unless the face does.
        let first_is_node = site.node_body == model.pairs[site.pair].bodies[0];
        let (node, face) = if first_is_node { (side(0), side(1)) } else { (side(1), side(0)) };
        let here = locate(&site.geometry, node, face);
        let outward = face.turn(site.geometry.axes.z_axis).truncate();
        let n = if first_is_node { outward } else { -outward };
        let node_arm = node.turn(site.geometry.arm).truncate();
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
            // Measured from the face; where the node is on the second side, n and V change sign together.
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

    /// Row of the contact Jacobian: velocities `(v_x, v_y, ω)` of each side to the relative velocity along `direction`; its
    /// transpose takes a force along it to force and moment on each side.
    pub fn row(&self, direction: DVec2) -> [(Option<usize>, DVec3); 2] {
        let along = |arm: DVec2| direction.extend(arm.perp_dot(direction));
        [(self.bodies[0], along(self.arms[0])), (self.bodies[1], -along(self.arms[1]))]
    }
}

/// Inverse masses and velocities of the bodies that an instant concerns.
#[derive(Clone, Debug, PartialEq)]
pub struct Cluster {
    /// Per body: `1/m, 1/m, 1/(m i²)`, 0 in held directions.
    pub inverse: InlineVec<DVec3>,
    /// Per body: `(v_x, v_y, ω)`.
    pub velocity: InlineVec<DVec3>,
}

/// `1/m, 1/m, 1/(m i²)` of a body, 0 in held directions.
pub fn inverse_mass(body: &Body) -> DVec3 {
    let free = |i: usize| if body.free[i] { 1.0 } else { 0.0 };
    DVec3::new(free(0) / body.mass, free(1) / body.mass, free(5) / (body.mass * body.gyration2))
}

/// The rates in a planar state.
pub fn rates(state: &PlanarState) -> DVec3 {
    planar::rates(state)
}

/// The corner, or the middle of the face.
pub fn centre(points: &[ContactPoint]) -> ContactPoint {
    match points {
        [first, second] => first.towards(second, 0.5),
        _ => points[0],
    }
}

impl Cluster {
    /// Relative velocity along `direction` at a point \[m/s\].
    pub fn speed(&self, point: &ContactPoint, direction: DVec2) -> f64 {
        let part = |(body, row): (Option<usize>, DVec3)| body.map_or(0.0, |b| row.dot(self.velocity[b]));
        point.row(direction).into_iter().map(part).sum()
    }

    /// `[v_n, v_s]` at a point \[m/s\].
    pub fn speeds(&self, point: &ContactPoint) -> [f64; 2] {
        [self.speed(point, point.n), self.speed(point, point.s)]
    }

    /// Velocity along `d` at `p` per impulse along `e` at `q` \[1/kg\].
    pub fn mobility(&self, p: &ContactPoint, d: DVec2, q: &ContactPoint, e: DVec2) -> f64 {
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

    /// Kinetic energy of the directions that are free \[J\].
    pub fn kinetic_energy(&self) -> f64 {
        let part = |v: f64, inverse: f64| if inverse > 0.0 { 0.5 * v * v / inverse } else { 0.0 };
        let body = |(v, inverse): (&DVec3, &DVec3)| (0..3).map(|i| part(v[i], inverse[i])).sum::<f64>();
        self.velocity.iter().zip(&self.inverse).map(body).sum()
    }

    /// `[W_nn, W_ss, W_ns]` at a point \[1/kg\].
    pub fn mobilities(&self, p: &ContactPoint) -> [f64; 3] {
        [self.mobility(p, p.n, p, p.n), self.mobility(p, p.s, p, p.s), self.mobility(p, p.n, p, p.s)]
    }

    /// Applies an impulse `[P_n, P_s]` \[N·s\]; returns its work \[J\].
    pub fn push(&mut self, point: &ContactPoint, [normal, tangential]: [f64; 2]) -> f64 {
        let before = self.speeds(point);
        for (body, row) in point.row(point.n * normal + point.s * tangential) {
            if let Some(b) = body {
                self.velocity[b] += self.inverse[b] * row;
            }
        }
        let after = self.speeds(point);
        0.5 * (normal * (before[0] + after[0]) + tangential * (before[1] + after[1]))
    }

    /// Speed that is round-off at these points \[m/s\].
    pub fn speed_round_off<'a>(&self, points: impl IntoIterator<Item = &'a ContactPoint>) -> f64 {
        let reach = points.into_iter().flat_map(|p| p.arms).map(DVec2::length).fold(0.0, f64::max);
        let fast = |v: &DVec3| v.truncate().length() + v.z.abs() * reach;
        IMPACT_SPEED_ROUNDING * self.velocity.iter().map(fast).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example::{cluster, touch};

    /// Two girders of 2 kg and 3 kg that touch at a point with unlike levers.
    fn touching() -> (Cluster, ContactPoint) {
        let inverse = |mass: f64, i2: f64| DVec3::new(1.0 / mass, 1.0 / mass, 1.0 / (mass * i2));
        let n = DVec2::from_angle(0.4);
        let bodies = cluster([inverse(2.0, 0.01), inverse(3.0, 0.02)], [[-0.3, 0.2, 4.0], [0.1, -0.5, -2.0]]);
        let arms = [DVec2::new(0.1, 0.03), DVec2::new(-0.08, 0.05)];
        (bodies, touch([Some(0), Some(1)], n, arms, 0.0))
    }

    #[test]
    fn mobilities_are_velocities_per_unit_impulse() {
        let (cluster, point) = touching();
        let change = |impulse: [f64; 2]| {
            let mut pushed = cluster.clone();
            pushed.push(&point, impulse);
            let (before, after) = (cluster.speeds(&point), pushed.speeds(&point));
            [after[0] - before[0], after[1] - before[1]]
        };
        let [w_n, w_s, w_ns] = cluster.mobilities(&point);
        let [by_n, by_s] = [change([1.0, 0.0]), change([0.0, 1.0])];
        for (w, by) in [(w_n, by_n[0]), (w_ns, by_n[1]), (w_ns, by_s[0]), (w_s, by_s[1])] {
            assert!((w - by).abs() < 1e-13 * w_n, "{w} per unit, {by} by an impulse");
        }
        // (26), summed over both sides.
        let side = |k: usize, d: DVec2, e: DVec2| {
            let (i, arm) = (cluster.inverse[k], point.arms[k]);
            i.x * d.dot(e) + i.z * arm.perp_dot(d) * arm.perp_dot(e)
        };
        let sum = |d, e| side(0, d, e) + side(1, d, e);
        let (n, s) = (point.n, point.s);
        for (w, formula) in [(w_n, sum(n, n)), (w_s, sum(s, s)), (w_ns, sum(n, s))] {
            assert!((w - formula).abs() < 1e-13 * w_n, "{w} against {formula}");
        }
    }

    #[test]
    fn an_impulse_keeps_momentum_and_its_work_is_the_change_of_kinetic_energy() {
        let (cluster, point) = touching();
        let mut pushed = cluster.clone();
        let work = pushed.push(&point, [0.7, -0.2]);
        let momentum = |c: &Cluster| (0..2).map(|k| c.velocity[k].truncate() / c.inverse[k].x).sum::<DVec2>();
        assert!((momentum(&pushed) - momentum(&cluster)).length() < 1e-15, "opposite on the other side");
        let gained = pushed.kinetic_energy() - cluster.kinetic_energy();
        assert!((gained - work).abs() < 1e-14, "{gained} J gained by a work of {work} J");
    }

    #[test]
    fn held_directions_and_walls_have_no_mobility() {
        let (mut cluster, mut point) = touching();
        point.bodies[1] = None;
        cluster.inverse[0] = DVec3::new(0.5, 0.5, 0.0);
        let [w_n, w_s, w_ns] = cluster.mobilities(&point);
        assert!((w_n - 0.5).abs() < 1e-15 && (w_s - 0.5).abs() < 1e-15 && w_ns.abs() < 1e-15, "translation alone");
        cluster.inverse[0] = DVec3::ZERO;
        assert_eq!(cluster.mobilities(&point), [0.0; 3], "a girder that is held");
        assert_eq!(cluster.kinetic_energy(), 0.5 * (0.01 + 0.25) * 3.0 + 0.5 * 4.0 * 0.06, "of the other alone");
    }

    #[test]
    fn the_centre_of_a_face_is_midway_between_its_ends() {
        let (_, point) = touching();
        let mut other = point;
        other.arms = point.arms.map(|arm| arm + 0.2 * point.s);
        let centre_arm = centre(&[point, other]).arms[0];
        assert!((centre_arm - (point.arms[0] + 0.1 * point.s)).length() < 1e-16, "half of the way");
        assert_eq!(centre(&[point]), point, "a corner is its own");
    }
}
