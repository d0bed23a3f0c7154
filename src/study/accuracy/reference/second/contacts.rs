//! Contacts of the second formulation, with world vectors: (53), (54), (57)–(59) and the return mapping.

use glam::DVec3;

use super::bodies::{Load, Pose};
use crate::dynamics::{ContactSite, Model};
use crate::scene::{FrictionLaw, NormalName, Sharing};

/// A node this far over an edge, in parts of the face, is still inside.
const EDGE: f64 = 1e-9;
/// Sliding slower than this part of the approach has no direction of its own.
const STILL: f64 = 1e-12;

/// The numbers of a contact, its share taken.
#[derive(Clone, Copy)]
pub(super) struct Numbers {
    /// Stiffness of the tangential spring, and of the normal one where that is linear \[N/m\].
    pub(super) k: f64,
    /// `k_h` of a Hertz spring \[N/m^1.5\].
    hertz: Option<f64>,
    c_n: f64,
    c_t: f64,
    mu_s: f64,
    mu_k: f64,
    paper: bool,
    /// Regularisation length of a slip that turns, near opening, as the solver states it \[m\].
    ease: f64,
}

impl Numbers {
    /// Elastic normal force at a depth \[N\].
    fn elastic(&self, depth: f64) -> f64 {
        self.hertz.map_or(self.k * depth, |k_h| k_h * depth * depth.abs().sqrt())
    }

    /// Stretch of the tangential spring that carries it, per μ \[m\].
    fn length(&self, depth: f64) -> f64 {
        self.hertz.map_or(depth, |_| self.elastic(depth) / self.k)
    }

    /// Derivative of that by the depth.
    fn slope(&self, depth: f64) -> f64 {
        self.hertz.map_or(1.0, |k_h| 1.5 * k_h * depth.abs().sqrt() / self.k)
    }

    /// Point of action of the reaction: the point that holds the node, or, where the springs differ, the node.
    fn at(&self, held: DVec3, node: DVec3) -> DVec3 {
        if self.hertz.is_some() { node } else { held }
    }
}

/// A contact's state.
#[derive(Clone, Copy)]
pub(super) enum State {
    Open {
        armed: bool,
    },
    /// The anchor is a point of the face's body.
    Stick {
        numbers: Numbers,
        anchor: DVec3,
    },
    /// The direction is along an angle in the face's plane, kept in the vector.
    Slip {
        numbers: Numbers,
    },
}

/// Event of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Enter,
    Leave,
    Edge,
    Switch,
}

/// A node against a face.
pub(super) struct View {
    pub(super) gap: f64,
    /// Node from the face body's G.
    arm: DVec3,
    node_arm: DVec3,
    normal: DVec3,
    axes: [DVec3; 2],
    /// Velocity of the node against the face's body at the node.
    passing: DVec3,
    /// Twist of the face's body, to ask for V at another point.
    spin: DVec3,
}

impl View {
    pub(super) fn of(site: &ContactSite, node: &Pose, face: &Pose) -> Self {
        let node_arm = node.attitude * site.point;
        let arm = (node.home - face.home) + (node.shift - face.shift) + node_arm;
        let normal = face.attitude * site.face.normal;
        Self {
            gap: normal.dot(arm - face.attitude * site.face.corners[0]),
            arm,
            node_arm,
            normal,
            axes: [face.attitude * site.face.tangent, face.attitude * site.face.bitangent],
            passing: node.velocity_at(node_arm) - face.velocity_at(arm),
            spin: face.spin,
        }
    }

    /// `V = V_k − V_p` with p at `offset` from the node: the face's body moves differently there.
    fn velocity(&self, offset: DVec3) -> DVec3 {
        self.passing - self.spin.cross(offset)
    }

    fn along(&self, v: DVec3) -> DVec3 {
        v - self.normal * v.dot(self.normal)
    }

    fn direction(&self, angle: f64) -> DVec3 {
        let (sin, cos) = angle.sin_cos();
        self.axes[0] * cos + self.axes[1] * sin
    }

    fn angle(&self, v: DVec3) -> f64 {
        v.dot(self.axes[1]).atan2(v.dot(self.axes[0]))
    }

    /// Whether the projection is inside the polygon.
    fn inset(&self, site: &ContactSite, face: &Pose) -> f64 {
        let local = face.attitude.transpose() * self.arm;
        site.face.inset(local) + EDGE * site.face.size()
    }
}

/// A force on the node and where its opposite acts.
pub(super) struct Force {
    pub(super) on_node: DVec3,
    at: DVec3,
}

/// Force of a closed contact; `turning` is the rate of the slip's angle.
pub(super) fn force(state: &State, angle: f64, view: &View, face: &Pose) -> Option<(Force, f64)> {
    let depth = -view.gap;
    match *state {
        State::Open { .. } => None,
        State::Stick { numbers: n, anchor } => {
            let held = face.attitude * anchor;
            let stretch = view.arm - held;
            let v = view.velocity(-stretch);
            let v_n = v.dot(view.normal);
            let spring = view.normal * n.elastic(depth) - view.along(stretch) * n.k;
            let on_node = spring - view.normal * (n.c_n * v_n) - view.along(v) * n.c_t;
            Some((Force { on_node, at: n.at(held, view.arm) }, 0.0))
        }
        State::Slip { numbers: n } => {
            let d = view.direction(angle);
            let stretch = if n.paper { 0.0 } else { n.mu_k * n.length(depth) };
            let held = view.arm - view.normal * view.gap - d * stretch;
            let v = view.velocity(held - view.arm);
            let normal = view.normal * (n.elastic(depth) - n.c_n * v.dot(view.normal));
            let friction = d * (-n.mu_k * n.elastic(depth));
            let at = n.at(held, view.arm);
            if n.paper {
                return Some((Force { on_node: normal + friction, at }, 0.0));
            }
            // p moves along the face as the node does, less what the stretch grows and turns by.
            let rate = view.along(view.passing);
            let across = view.normal.cross(d);
            let turning = if n.ease > 0.0 { across.dot(rate) / (stretch.max(0.0) + n.ease) } else { 0.0 };
            let growth = d * (-n.mu_k * n.slope(depth) * view.passing.dot(view.normal));
            let moving = rate - growth - across * (turning * stretch.max(0.0));
            let dashpot = (view.along(v) - moving) * -n.c_t;
            Some((Force { on_node: normal + friction + dashpot, at }, turning))
        }
    }
}

/// Adds a contact's force to the loads of its bodies; the rate of its angle comes back.
pub(super) fn load(site: &ContactSite, state: &State, angle: f64, poses: &[Pose], loads: &mut [Load]) -> f64 {
    if matches!(state, State::Open { .. }) {
        return 0.0;
    }
    let [node, face] = sides(site, poses);
    let view = View::of(site, &node, &face);
    let Some((force, turning)) = force(state, angle, &view, &face) else { return 0.0 };
    if let Some(body) = site.node_body {
        loads[body].add(force.on_node, view.node_arm);
    }
    if let Some(body) = site.face_body {
        loads[body].add(-force.on_node, force.at);
    }
    turning
}

pub(super) fn sides(site: &ContactSite, poses: &[Pose]) -> [Pose; 2] {
    [site.node_body, site.face_body].map(|body| body.map_or_else(|| Pose::fixed(site.fixed), |b| poses[b]))
}

/// Possible next events, each with its switching function, which rises through 0 at the event.
pub(super) fn watched(site: &ContactSite, state: &State, angle: f64, poses: &[Pose]) -> Vec<(Kind, f64)> {
    let [node, face] = sides(site, poses);
    let view = View::of(site, &node, &face);
    let switching = match *state {
        State::Open { armed } => {
            return if armed { vec![(Kind::Enter, -view.gap)] } else { Vec::new() };
        }
        State::Stick { numbers: n, anchor } => {
            view.along(view.arm - face.attitude * anchor).length() - n.mu_s * n.length(-view.gap)
        }
        State::Slip { numbers: n } => {
            let d = view.direction(angle);
            if n.paper {
                -view.velocity(-view.normal * view.gap).dot(d)
            } else {
                -(view.passing.dot(d) + n.mu_k * n.slope(-view.gap) * view.passing.dot(view.normal))
            }
        }
    };
    vec![(Kind::Leave, view.gap), (Kind::Edge, -view.inset(site, &face)), (Kind::Switch, switching)]
}

/// The state after an event, and the angle of its slip.
pub(super) fn after(
    model: &Model,
    site: &ContactSite,
    (state, angle): (State, f64),
    kind: Kind,
    poses: &[Pose],
    sharers: &mut usize,
) -> (State, f64) {
    let [node, face] = sides(site, poses);
    let view = View::of(site, &node, &face);
    let inside = view.inset(site, &face) >= 0.0;
    match (kind, state) {
        (Kind::Enter, _) if !inside => (State::Open { armed: false }, 0.0),
        (Kind::Enter, _) => {
            let v = view.velocity(-view.normal * view.gap);
            let v_n = v.dot(view.normal).abs();
            let n = numbers(model, site, poses, sharers, v_n);
            enter(n, &view, &face, v_n)
        }
        (Kind::Leave, _) => (State::Open { armed: true }, 0.0),
        (Kind::Edge, _) => (State::Open { armed: false }, 0.0),
        (Kind::Switch, State::Stick { numbers, anchor }) => {
            let stretch = view.along(view.arm - face.attitude * anchor);
            let v = view.velocity(-view.normal * view.gap);
            let sliding = view.along(v);
            let still = STILL * (sliding.length() + v.dot(view.normal).abs());
            let by_speed = numbers.paper && sliding.length() > still;
            (State::Slip { numbers }, view.angle(if by_speed { sliding } else { stretch }))
        }
        (Kind::Switch, State::Slip { numbers }) => {
            let stretch = if numbers.paper { 0.0 } else { numbers.mu_k * numbers.length(-view.gap) };
            let held = view.arm - view.normal * view.gap - view.direction(angle) * stretch;
            (State::Stick { numbers, anchor: face.attitude.transpose() * held }, 0.0)
        }
        (Kind::Switch, open) => (open, angle),
    }
}

fn enter(numbers: Numbers, view: &View, face: &Pose, v_n: f64) -> (State, f64) {
    let sliding = view.along(view.velocity(-view.normal * view.gap));
    // A Hertz spring has no stiffness at the closing: what moves along the face slips.
    let limit = if numbers.hertz.is_some() { STILL } else { numbers.mu_s };
    if sliding.length() < limit * v_n {
        let anchor = face.attitude.transpose() * (view.arm - view.normal * view.gap);
        (State::Stick { numbers, anchor }, 0.0)
    } else {
        (State::Slip { numbers }, view.angle(sliding))
    }
}

/// A node behind a face at the start sticks where it is.
pub(super) fn overlapping(model: &Model, site: &ContactSite, poses: &[Pose], sharers: &mut usize) -> State {
    let [node, face] = sides(site, poses);
    let view = View::of(site, &node, &face);
    if view.gap >= 0.0 {
        return State::Open { armed: true };
    }
    if view.inset(site, &face) < 0.0 {
        return State::Open { armed: false };
    }
    let mut numbers = numbers(model, site, poses, sharers, 0.0);
    numbers.ease = numbers.ease.max(0.0);
    State::Stick { numbers, anchor: face.attitude.transpose() * (view.arm - view.normal * view.gap) }
}

/// (65) with the share that the pair has since it closed.
fn numbers(model: &Model, site: &ContactSite, poses: &[Pose], sharers: &mut usize, v_n: f64) -> Numbers {
    let pair = &model.pairs[site.pair];
    let given = &pair.contact;
    if *sharers == 0 {
        let is_inside = |&c: &usize| {
            let other = &model.sites[c];
            let [node, face] = sides(other, poses);
            View::of(other, &node, &face).inset(other, &face) >= 0.0
        };
        let count = pair.sites.clone().filter(is_inside).count().max(1);
        *sharers = if given.sharing == Sharing::PerNode { 1 } else { count };
    }
    let masses = pair.bodies.map(|b| b.map(|b| model.bodies[b].mass));
    let (reduced, least) = match masses {
        [Some(a), Some(b)] => (a * b / (a + b), a.min(b)),
        [Some(a), None] | [None, Some(a)] => (a, a),
        [None, None] => (1.0, 1.0),
    };
    let dashpot = |e: f64| {
        let log = e.ln();
        -2.0 * log / std::f64::consts::PI.hypot(log) * (given.stiffness * reduced).sqrt()
    };
    let share = *sharers as f64;
    // Of the same greatest elastic depth as K at the design speed, unless it is given.
    let deep = given.design_speed * (reduced / given.stiffness).sqrt();
    let by_speed = 1.25 * given.stiffness / deep.sqrt();
    let elastic = given.normal_law == NormalName::Hertz;
    let k_h = given.hertz_stiffness.unwrap_or(by_speed);
    let turns = !pair.one_way && given.law == FrictionLaw::ReturnMapping;
    Numbers {
        k: given.stiffness / share,
        hertz: elastic.then(|| k_h / share),
        c_n: if elastic { 0.0 } else { dashpot(given.restitution_normal) / share },
        c_t: dashpot(given.restitution_tangential) / share,
        mu_s: given.mu_static,
        mu_k: given.mu_kinetic,
        paper: given.law == FrictionLaw::Paper,
        ease: if turns { 1e-3 * given.mu_kinetic.max(0.05) * v_n / (given.stiffness / least).sqrt() } else { 0.0 },
    }
}
