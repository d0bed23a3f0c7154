//! Reactions in lasting contact: one constrained solve for all states c–f, whatever touches what.
//!
//! Unknown are the pushes `N ≥ 0` of every point that is kept and the hold `T` of every seat that stays put; asked is
//! that kept points have no acceleration along the normal, and those that stay put none along the tangent either. A
//! seat that slides carries `T = −μ_k N sgn(v_s)`. All bearing forces are in it ((7)–(25),
//! `docs/physics.md#lasting-contact`), so for a straight girder at a wall `N/m` is `R_x` of (15), (20), (23), (25),
//! counted positive in compression.

use glam::{DVec2, DVec3};

use crate::contact::Frame;
use crate::dynamics::free_flight::flight::Planar;
use crate::dynamics::impact2d::delassus::{Cluster, Point, inverse_mass, rates};
use crate::dynamics::impact2d::dense;
use crate::dynamics::impact2d::{Few, State};
use crate::dynamics::model::rigid_body;
use crate::dynamics::{Body, Model};
use crate::motion::{Ground, LinearPiece};
use crate::scene::ImpactSettings;

/// How a seat goes along the face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// It stays put.
    Held,
    /// It slides along `s` with this sign; 0 is without friction, where none agrees with any motion.
    Slides(f64),
}

/// A pair in lasting contact, at a corner or along a face.
#[derive(Clone, Debug, PartialEq)]
pub struct Seat {
    /// The pair, its number in the model.
    pub pair: usize,
    /// The declared contacts that are kept: one at a corner, the two outermost of a face, that further back along `s`
    /// first.
    pub sites: Vec<usize>,
    /// How it goes along the face.
    pub way: Way,
}

impl Seat {
    /// Whether a whole face lies on the other.
    pub fn is_flush(&self) -> bool {
        self.sites.len() > 1
    }

    /// The state c–f of a girder on this seat.
    pub fn state(&self) -> State {
        match (self.is_flush(), self.way) {
            (true, Way::Held) => State::Resting,
            (true, Way::Slides(_)) => State::Sliding,
            (false, Way::Held) => State::Turning,
            (false, Way::Slides(_)) => State::SlidingTurning,
        }
    }

    /// `[μ_s, μ_k]` of the face or, at one point, of a corner.
    pub fn friction(&self, numbers: &ImpactSettings) -> [f64; 2] {
        if self.is_flush() { [numbers.mu_static, numbers.mu_kinetic] } else { numbers.corner_friction() }
    }
}

/// Push and hold of a seat \[N\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reaction {
    /// `N` at each point, on the first side along `n`.
    pub normal: [f64; 2],
    /// `T`, on the first side along `s`.
    pub tangential: f64,
}

impl Reaction {
    /// `N` of the whole seat \[N\].
    pub fn total(&self) -> f64 {
        self.normal[0] + self.normal[1]
    }
}

/// Bodies at an instant, with what acts on them but the reactions.
#[derive(Clone, Debug)]
pub struct Scenery {
    /// Numbers in the model, rising.
    pub bodies: Few<usize>,
    /// Poses.
    pub frames: Few<Frame>,
    /// Inverse masses and velocities.
    pub cluster: Cluster,
    /// Accelerations without any reaction, rotation last.
    pub free: Few<DVec3>,
    /// Size of what they are the sum of, at the farthest corner: their rounding goes by it \[m/s²\].
    pub sizes: Few<f64>,
}

impl Scenery {
    /// Bodies in these states under this acceleration of the ground.
    pub fn new(model: &Model, bodies: &[usize], states: &[Planar], ground: DVec3) -> Self {
        let mut scenery = Self {
            bodies: bodies.into(),
            frames: Few::with_capacity(bodies.len()),
            cluster: Cluster {
                inverse: bodies.iter().map(|&b| inverse_mass(&model.bodies[b])).collect(),
                velocity: Few::with_capacity(bodies.len()),
            },
            free: Few::with_capacity(bodies.len()),
            sizes: Few::with_capacity(bodies.len()),
        };
        for (&number, state) in bodies.iter().zip(states) {
            let body = &model.bodies[number];
            let mut rate = [0.0; 6];
            rigid_body::planar_slope(body, state, &rigid_body::Wrench::default(), ground, &mut rate);
            scenery.frames.push(body.planar_frame(state));
            scenery.cluster.velocity.push(rates(state));
            scenery.free.push(DVec3::new(rate[3], rate[4], rate[5]));
            scenery.sizes.push(size(body, state, ground));
        }
        scenery
    }

    /// Places of a pair's bodies among these; nothing for an abutment, and for a body that is not here.
    pub fn places(&self, model: &Model, pair: usize) -> [Option<usize>; 2] {
        model.pairs[pair].bodies.map(|body| body.and_then(|b| self.bodies.binary_search(&b).ok()))
    }

    /// Where a declared contact is.
    pub fn point(&self, model: &Model, site: usize) -> Point {
        let pair = model.contacts[site].pair;
        let places = self.places(model, pair);
        let still = Frame::fixed(DVec3::ZERO);
        let frame = |side: usize| places[side].map_or(&still, |place| &self.frames[place]);
        Point::of(model, site, places, [frame(0), frame(1)])
    }

    /// Size of the accelerations in play \[m/s²\].
    pub fn scale(&self) -> f64 {
        self.sizes.iter().copied().fold(f64::MIN_POSITIVE, f64::max)
    }

    /// A push or a hold at a point that is rounding \[N\].
    pub fn rounding(&self, point: &Point) -> f64 {
        let w_n = self.cluster.mobilities(point)[0];
        if w_n > 0.0 { crate::dynamics::impact2d::lasting::mode_selection::ROUNDING * self.scale() / w_n } else { 0.0 }
    }

    /// The kept points of a seat.
    pub fn points(&self, model: &Model, seat: &Seat) -> Vec<Point> {
        seat.sites.iter().map(|&site| self.point(model, site)).collect()
    }
}

/// Size of the accelerations that act on a body, before they cancel \[m/s²\].
fn size(body: &Body, state: &Planar, ground: DVec3) -> f64 {
    let (q, v) = (DVec3::new(state[0], state[1], state[2]), DVec3::new(state[3], state[4], state[5]));
    let push = DVec3::new(body.push.x, body.push.y, body.moment);
    let at_corner = |force: DVec3| {
        let a = inverse_mass(body) * force;
        a.truncate().length() + a.z.abs() * body.radius
    };
    at_corner(body.planar.stiffness * q) + at_corner(body.planar.damping * v) + at_corner(push) + ground.length()
}

/// Reactions of all seats, and the accelerations with them.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Seat by seat.
    pub reactions: Vec<Reaction>,
    /// Body by body.
    pub accelerations: Few<DVec3>,
}

impl Answer {
    /// Acceleration along a direction at a point, turning included \[m/s²\].
    pub fn along(&self, point: &Point, direction: DVec2, bias: f64) -> f64 {
        let part = |(body, row): (Option<usize>, DVec3)| body.map_or(0.0, |b| row.dot(self.accelerations[b]));
        point.row(direction).into_iter().map(part).sum::<f64>() + bias
    }
}

/// An unknown: who pushes where and how, per unit of it, and the acceleration that it is to bring to 0.
struct Unknown {
    seat: usize,
    /// Which point of the seat, or the hold of the whole.
    at: Option<usize>,
    asked: Point,
    direction: DVec2,
    bias: f64,
    /// Force per unit.
    force: DVec2,
}

/// Solves for the reactions of all seats, `points` being theirs; nothing where the numbers are not finite.
pub fn react(scenery: &Scenery, seats: &[Seat], points: &[Vec<Point>], numbers: &ImpactSettings) -> Option<Answer> {
    let unknowns = unknowns(seats, points, numbers);
    let mut accelerations = scenery.free.clone();
    let without = Answer { reactions: Vec::new(), accelerations: scenery.free.clone() };
    let entry = |r: usize, c: usize| {
        let (asked, push) = (&unknowns[r], &unknowns[c]);
        scenery.cluster.mobility(&asked.asked, asked.direction, &push.asked, push.force)
    };
    let right = |r: usize| -without.along(&unknowns[r].asked, unknowns[r].direction, unknowns[r].bias);
    let solution = dense::solve(unknowns.len(), entry, right)?;
    let mut reactions = vec![Reaction::default(); seats.len()];
    for (unknown, &size) in unknowns.iter().zip(&solution) {
        for (body, row) in unknown.asked.row(unknown.force * size) {
            if let Some(b) = body {
                accelerations[b] += scenery.cluster.inverse[b] * row;
            }
        }
        let reaction = &mut reactions[unknown.seat];
        match unknown.at {
            Some(i) => {
                reaction.normal[i] = size;
                reaction.tangential += size * unknown.force.dot(unknown.asked.s);
            }
            None => reaction.tangential += size,
        }
    }
    Some(Answer { reactions, accelerations })
}

fn unknowns(seats: &[Seat], points: &[Vec<Point>], numbers: &ImpactSettings) -> Vec<Unknown> {
    let mut all = Vec::new();
    for (number, (seat, points)) in seats.iter().zip(points).enumerate() {
        let drag = match seat.way {
            Way::Held => 0.0,
            Way::Slides(sign) => -seat.friction(numbers)[1] * sign,
        };
        for (i, point) in points.iter().enumerate() {
            all.push(Unknown {
                seat: number,
                at: Some(i),
                asked: *point,
                direction: point.n,
                bias: point.bias[0],
                force: point.n + point.s * drag,
            });
        }
        if seat.way == Way::Held {
            let middle = middle(points);
            all.push(Unknown {
                seat: number,
                at: None,
                asked: middle,
                direction: middle.s,
                bias: middle.bias[1],
                force: middle.s,
            });
        }
    }
    all
}

/// The corner, or the middle of the face.
pub fn middle(points: &[Point]) -> Point {
    match points {
        [first, second] => first.towards(second, 0.5),
        _ => points[0],
    }
}

/// The ground's acceleration within a stretch without a kink \[m/s²\].
pub fn shaking(ground: &Ground, piece: &LinearPiece, t: f64) -> DVec3 {
    match ground {
        Ground::Record { direction, .. } => *direction * (piece.start + piece.slope * (t - piece.from)),
        other => other.acceleration(t),
    }
}
