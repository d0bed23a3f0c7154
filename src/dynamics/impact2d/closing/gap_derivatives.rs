//! Both sides of a pair at an instant, in plan, and what they can do from there.
//!
//! In flight without a record every direction is an oscillator's closed form: its acceleration comes with its place, and the
//! energy of each of its derivatives never grows, which bounds displacement, speed, acceleration and jerk for ever after.
//! Under a record, and where bearings couple the directions, the bounds of [`Bound`] hold for a while and nothing bounds
//! the jerk.

use glam::DVec2;

use crate::dynamics::Model;
use crate::dynamics::free_flight::flight::{Planar, System, SystemForm};
use crate::dynamics::free_flight::motion_bounds::Bound;
use crate::dynamics::free_flight::relative_bounds::{Apart, Flyer};
use crate::dynamics::free_flight::uncoupled_axis::Dof;
use crate::dynamics::impact2d::closing::cubic_advancement::Cubic;
use crate::dynamics::impact2d::engine::Engine;
use crate::dynamics::impact2d::tracks::Going;
use crate::dynamics::locate::advancement::Outlook;
use crate::dynamics::world::site_geometry::SiteGeometry;
use crate::motion::Ground;

/// Where a declared contact is as placed, in plan.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics::impact2d) struct Aim {
    /// From the face body's G to the node body's \[m\].
    home: DVec2,
    /// Node from its G \[m\].
    arm: DVec2,
    /// Outward normal of the face.
    normal: DVec2,
    /// Of the face along it, from its G \[m\].
    level: f64,
}

impl Aim {
    /// Whether both are seen from the same face.
    pub(in crate::dynamics::impact2d) fn shares_face(&self, other: &Self) -> bool {
        self.normal == other.normal && self.level == other.level
    }

    pub(in crate::dynamics::impact2d) fn of(model: &Model, site: usize) -> Self {
        let site = &model.contacts[site];
        let placed = |body: Option<usize>| match body {
            Some(body) => model.bodies[body].planar_frame(&[0.0; 6]),
            None => crate::contact::Frame::fixed(site.fixed),
        };
        let (node, face) = (placed(site.node_body), placed(site.face_body));
        Self {
            home: (node.home - face.home).truncate(),
            arm: site.home.arm.truncate(),
            normal: site.home.axes.z_axis.truncate(),
            level: site.face.corners[0].dot(site.face.normal),
        }
    }
}

/// One side at an instant.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics::impact2d) struct Pose {
    shift: DVec2,
    /// Cosine and sine of θ.
    turn: DVec2,
    velocity: DVec2,
    spin: f64,
}

impl Pose {
    /// What does not move.
    const STILL: Self = Self { shift: DVec2::ZERO, turn: DVec2::X, velocity: DVec2::ZERO, spin: 0.0 };

    fn of(state: &Planar) -> Self {
        Self {
            shift: DVec2::new(state[0], state[1]),
            turn: if state[2] == 0.0 { DVec2::X } else { DVec2::from_angle(state[2]) },
            velocity: DVec2::new(state[3], state[4]),
            spin: state[5],
        }
    }
}

/// The poses of a pair's sides at `t`.
pub(in crate::dynamics::impact2d) fn poses(engine: &Engine, slots: [Option<usize>; 2], t: f64) -> [Pose; 2] {
    slots.map(|slot| slot.map_or(Pose::STILL, |slot| Pose::of(&engine.state(slot, t))))
}

/// `[g, ġ]` of a contact, `sides` being those of its node and its face.
pub(in crate::dynamics::impact2d) fn gap(aim: &Aim, sides: [Option<usize>; 2], poses: &[Pose; 2]) -> [f64; 2] {
    let [gap, rate, ..] = Line::of(aim, sides, poses).gap(aim);
    [gap, rate]
}

/// A node seen from its face.
struct Line {
    arm: DVec2,
    normal: DVec2,
    /// From the face's G to the node, and its rate.
    apart: DVec2,
    rate: DVec2,
    /// Of node and face \[rad/s\].
    spins: [f64; 2],
}

impl Line {
    fn of(aim: &Aim, sides: [Option<usize>; 2], poses: &[Pose; 2]) -> Self {
        let pose = |which: usize| sides[which].map_or(Pose::STILL, |side| poses[side]);
        let (node, face) = (pose(0), pose(1));
        let arm = node.turn.rotate(aim.arm);
        Self {
            arm,
            normal: face.turn.rotate(aim.normal),
            apart: aim.home + (node.shift - face.shift) + arm,
            rate: node.velocity - face.velocity + arm.perp() * node.spin,
            spins: [node.spin, face.spin],
        }
    }

    fn gap(&self, aim: &Aim) -> [f64; 2] {
        let rate = self.rate - self.apart.perp() * self.spins[1];
        [self.normal.dot(self.apart) - aim.level, self.normal.dot(rate)]
    }

    /// `g̈` under these accelerations of node and face.
    fn bend(&self, [node, face]: [[f64; 3]; 2]) -> f64 {
        let [w_n, w_f] = self.spins;
        let linear = DVec2::new(node[0] - face[0], node[1] - face[1]);
        let apart = linear + self.arm.perp() * node[2] - self.arm * (w_n * w_n);
        let turned = apart - self.apart.perp() * face[2] - self.rate.perp() * (2.0 * w_f) - self.apart * (w_f * w_f);
        self.normal.dot(turned)
    }
}

/// How far, fast, sharply and suddenly a side can move, and turn.
#[derive(Clone, Copy, Debug, Default)]
struct Swing {
    /// Displacement, speed, acceleration and jerk of G.
    plan: [f64; 4],
    /// Of the rotation.
    turn: [f64; 4],
}

impl Swing {
    fn of(bound: &Bound) -> Self {
        Self {
            plan: [bound.reach, bound.speed, bound.acceleration, f64::INFINITY],
            turn: [bound.turn, bound.spin, bound.spin_rate, f64::INFINITY],
        }
    }
}

/// A side in flight.
struct Flying<'a> {
    system: &'a System,
    state: Planar,
    free: Option<Planar>,
    horizon: f64,
}

impl<'a> Flying<'a> {
    fn of(engine: &'a Engine, slot: usize, t: f64, horizon: f64) -> Option<Self> {
        let track = &engine.bodies[slot];
        let Going::Flight(flight) = &track.now else { return None };
        let (state, free) = track.system.parts(flight, t);
        Some(Self { system: &track.system, state, free, horizon })
    }

    /// Its oscillators and its free part, where it has them.
    fn smooth(&self) -> Option<(&'a [Dof; 3], &Planar)> {
        match (&self.system.form, &self.free) {
            (SystemForm::Split { dof, .. }, Some(free)) => Some((dof, free)),
            _ => None,
        }
    }

    /// Whether bearings hold every direction in which it is free.
    fn is_bound(&self) -> bool {
        self.smooth().is_some_and(|(dof, _)| dof.iter().all(|dof| !dof.free || dof.oscillator.omega2 > 0.0))
    }

    fn drive(&self) -> f64 {
        if let Ground::Sine { omega, .. } = self.system.ground { omega } else { 0.0 }
    }

    /// Its acceleration, where it is known.
    fn acceleration(&self) -> Option<[f64; 3]> {
        let (dof, free) = self.smooth()?;
        let drive = self.drive();
        Some(std::array::from_fn(|i| {
            let steady = -drive * drive * (self.state[i] - free[i]);
            let o = &dof[i].oscillator;
            if dof[i].free {
                steady + self.system.push[i] - 2.0 * o.gamma * free[3 + i] - o.omega2 * free[i]
            } else {
                0.0
            }
        }))
    }

    fn bound(&self, t: f64) -> Bound {
        self.system.bound_from(t, &self.state, self.free.as_ref(), self.horizon)
    }

    fn swing(&self) -> Option<Swing> {
        let (dof, free) = self.smooth()?;
        let drive = self.drive();
        let limits = |i: usize| {
            limits(&dof[i], dof[i].amplitude, [free[i], free[3 + i]], drive, self.system.push[i], self.horizon)
        };
        let (x, y, turn) = (limits(0), limits(1), limits(2));
        Some(Swing { plan: std::array::from_fn(|k| length(x[k], y[k])), turn })
    }
}

/// `[displacement, speed, acceleration, jerk]` that a free part `(q, v)`, a steady response and a push never exceed.
fn limits(dof: &Dof, amplitude: f64, [q, v]: [f64; 2], drive: f64, push: f64, horizon: f64) -> [f64; 4] {
    if !dof.free {
        return [q.abs(), 0.0, 0.0, 0.0];
    }
    let mut all = [amplitude, drive * amplitude, drive * drive * amplitude, drive * drive * drive * amplitude];
    if q == 0.0 && v == 0.0 && push == 0.0 {
        return all;
    }
    let (omega2, damping) = (dof.oscillator.omega2, 2.0 * dof.oscillator.gamma);
    let omega = dof.oscillator.omega();
    // Each derivative is a free motion itself: ½(q̇² + ω²q²) of it never grows.
    let rest = if omega > 0.0 { push / omega2 } else { 0.0 };
    let a = push - damping * v - omega2 * q;
    let j = -damping * a - omega2 * v;
    let loose = if omega > 0.0 { 0.0 } else { push.abs() * horizon };
    let speed = length(v, omega * (q - rest)) + loose;
    all[0] += if omega > 0.0 { rest.abs() + speed / omega } else { q.abs() + speed * horizon };
    all[1] += speed;
    all[2] += length(a, omega * v);
    all[3] += length(j, omega * a);
    all
}

/// What the sides of a pair can do, each and against the other.
#[derive(Clone, Copy, Debug)]
struct Scope {
    swings: [Swing; 2],
    /// What G of one can do against the other's.
    between: [f64; 4],
    /// Looks for which it holds without being computed anew.
    looks: u32,
}

/// Looks that share a scope: the energies that bound a motion never grow, and damping takes little of them in a few leaps.
const SHARED: u32 = 4;

/// Both sides of a pair at an instant, with what they can do.
pub(in crate::dynamics::impact2d) struct View {
    pub poses: [Pose; 2],
    scope: Scope,
    accelerations: Option<[[f64; 3]; 2]>,
    /// How long that holds \[s\].
    pub window: f64,
}

impl Scope {
    /// Of sides in closed form.
    fn smooth(flying: &[Option<Flying<'_>>; 2]) -> Self {
        let swings = [0, 1].map(|side| flying[side].as_ref().and_then(Flying::swing).unwrap_or_default());
        let between = match flying {
            [Some(a), Some(b)] => apart(a, b).unwrap_or_default(),
            _ => std::array::from_fn(|k| swings[0].plan[k] + swings[1].plan[k]),
        };
        let lasts = flying.iter().flatten().all(Flying::is_bound);
        Self { swings, between, looks: if lasts { SHARED } else { 0 } }
    }
}

impl View {
    /// Of two sides that fly or stand.
    pub(in crate::dynamics::impact2d) fn of(engine: &Engine, slots: [Option<usize>; 2], t: f64, until: f64) -> Self {
        Self::with(engine, slots, [t, until], None)
    }

    /// The next look, later in the same flights.
    pub(in crate::dynamics::impact2d) fn then(
        &self,
        engine: &Engine,
        slots: [Option<usize>; 2],
        t: f64,
        until: f64,
    ) -> Self {
        let scope = Scope { looks: self.scope.looks.saturating_sub(1), ..self.scope };
        Self::with(engine, slots, [t, until], (scope.looks > 0).then_some(scope))
    }

    fn with(engine: &Engine, slots: [Option<usize>; 2], [t, until]: [f64; 2], known: Option<Scope>) -> Self {
        let horizon = (until - t).max(f64::MIN_POSITIVE);
        let flying = slots.map(|slot| slot.and_then(|slot| Flying::of(engine, slot, t, horizon)));
        let pose = |side: usize| match (&flying[side], slots[side]) {
            (Some(flying), _) => Pose::of(&flying.state),
            (None, Some(slot)) => Pose::of(&engine.state(slot, t)),
            (None, None) => Pose::STILL,
        };
        let poses = [pose(0), pose(1)];
        let smooth = flying.iter().flatten().all(|side| side.smooth().is_some());
        if !smooth {
            return Self::rough(poses, &flying, t, horizon);
        }
        let scope = known.unwrap_or_else(|| Scope::smooth(&flying));
        let acceleration = |side: usize| flying[side].as_ref().and_then(Flying::acceleration).unwrap_or_default();
        Self { poses, scope, accelerations: Some([acceleration(0), acceleration(1)]), window: horizon }
    }

    /// How far both have come: places round with it \[m\].
    pub(in crate::dynamics::impact2d) fn moved(&self) -> f64 {
        self.poses[0].shift.length() + self.poses[1].shift.length()
    }

    fn rough(poses: [Pose; 2], flying: &[Option<Flying<'_>>; 2], t: f64, horizon: f64) -> Self {
        let flyer = |side: &Option<Flying<'_>>| side.as_ref().map(|s| s.bound(t));
        let bounds = [flyer(&flying[0]), flyer(&flying[1])];
        let flyers = [0, 1].map(|i| match (&flying[i], bounds[i]) {
            (Some(s), Some(bound)) => Some(Flyer { system: s.system, state: s.state, free: s.free, bound }),
            _ => None,
        });
        let apart = Apart::of(&flyers, horizon);
        let swings = bounds.map(|bound| bound.map_or(Swing::default(), |bound| Swing::of(&bound)));
        let between = [apart.reach, apart.speed, apart.acceleration, f64::INFINITY];
        Self { poses, scope: Scope { swings, between, looks: 0 }, accelerations: None, window: apart.window }
    }

    /// Whether neither side ever turns while this holds, as it stands: points of one face keep their distances.
    pub(in crate::dynamics::impact2d) fn is_straight(&self) -> bool {
        self.accelerations.is_some() && self.poses.iter().all(|pose| pose.spin == 0.0) && {
            let turns = |swing: &Swing| swing.turn[1] != 0.0 || swing.turn[2] != 0.0;
            !self.scope.swings.iter().any(turns)
        }
    }

    /// What the gap of a contact can do at most, and the leap that its third derivative allows; `depth` is added to it.
    pub(in crate::dynamics::impact2d) fn outlook(
        &self,
        aim: &Aim,
        spot: &SiteGeometry,
        sides: [Option<usize>; 2],
        depth: f64,
    ) -> (Outlook, Option<Cubic>) {
        let line = Line::of(aim, sides, &self.poses);
        let [gap, rate] = line.gap(aim);
        let swing = |which: usize| sides[which].map_or([0.0; 4], |side| self.scope.swings[side].turn);
        let (node, face, between) = (swing(0), swing(1), &self.scope.between);
        // r from the face's G to the node: its length, and what its derivatives do.
        let r = spot.apart + between[0] + node[0] * spot.arm;
        let r1 = between[1] + node[1] * spot.arm;
        let r2 = between[2] + (node[2] + node[1] * node[1]) * spot.arm;
        // g = n·r, and n turns with the face.
        let bend2 = face[2] + face[1] * face[1];
        let curvature = r2 + bend2 * r + 2.0 * face[1] * r1;
        let moved = between[0] + node[0] * spot.arm + face[0] * r;
        let outlook =
            Outlook { gap: gap + depth, rate, curvature, window: self.window, out_of_reach: spot.home_gap > moved };
        let Some(accelerations) = self.accelerations else { return (outlook, None) };
        let third = |turn: [f64; 4]| turn[3] + turn[1] * (3.0 * turn[2] + turn[1] * turn[1]);
        let jerk = between[3] + third(node) * spot.arm + third(face) * r + 3.0 * (bend2 * r1 + face[1] * r2);
        let of = |which: usize| sides[which].map_or([0.0; 3], |side| accelerations[side]);
        let cubic = Cubic { gap: gap + depth, rate, bend: line.bend([of(0), of(1)]), jerk };
        (outlook, Some(cubic))
    }
}

/// What G of one flight can do against another's: under one ground motion the steady responses of like girders cancel.
fn apart(a: &Flying<'_>, b: &Flying<'_>) -> Option<[f64; 4]> {
    let ((first, p), (second, q)) = (a.smooth()?, b.smooth()?);
    let drive = a.drive();
    let mut all = [[0.0; 4]; 2];
    for (i, limit) in all.iter_mut().enumerate() {
        let (one, other) = (&first[i], &second[i]);
        let steady = length(one.steady.0 - other.steady.0, one.steady.1 - other.steady.1);
        let [push, pull] = [a.system.push[i], b.system.push[i]];
        if one.oscillator == other.oscillator && one.free && other.free {
            let difference = [p[i] - q[i], p[3 + i] - q[3 + i]];
            *limit = limits(one, steady, difference, drive, push - pull, a.horizon);
        } else {
            let x = limits(one, 0.0, [p[i], p[3 + i]], drive, push, a.horizon);
            let y = limits(other, 0.0, [q[i], q[3 + i]], drive, pull, a.horizon);
            let driven = [steady, drive * steady, drive * drive * steady, drive * drive * drive * steady];
            *limit = std::array::from_fn(|k| x[k] + y[k] + driven[k]);
        }
    }
    Some(std::array::from_fn(|k| length(all[0][k], all[1][k])))
}

/// `√(a² + b²)` of numbers far from the ends of the scale.
fn length(a: f64, b: f64) -> f64 {
    if b == 0.0 { a.abs() } else { (a * a + b * b).sqrt() }
}
