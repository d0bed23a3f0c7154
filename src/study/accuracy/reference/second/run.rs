//! The loop of the second formulation: short steps, each taken again to where something happens.

use super::bodies::{self, Load, Pose};
use super::contacts::{self, Kind, State};
use super::extrapolate::{Extrapolation, Rate};
use crate::dynamics::Model;
use crate::study::accuracy::answer::INTERVALS;
use crate::study::accuracy::{Answer, Instants};

/// Steps in flight and in contact, as parts of a radian of the fastest motion.
const RADIANS: (f64, f64) = (0.05, 0.05);
/// The first step after an event, in parts of the longest: what follows at once, and passes, is not stepped over.
const CAUTIOUS: f64 = 1.0 / 64.0;
/// Local error per step, in parts of a state that is counted as a hundredth at least.
const TOLERANCE: f64 = 1e-14;
/// Events closer than this part of a radian of the contact happen together.
const TOGETHER: f64 = 1e-9;
/// Shortest step, in parts of the whole: below, it is taken as it is.
const SHORTEST: f64 = 1e-13;

/// Bodies and contacts with the states that hold during a step.
struct Field<'a> {
    model: &'a Model,
    states: Vec<State>,
    size: usize,
    poses: Vec<Pose>,
    loads: Vec<Load>,
}

impl Field<'_> {
    fn pose(&mut self, y: &[f64]) {
        self.poses.clear();
        for (i, body) in self.model.bodies.iter().enumerate() {
            self.poses.push(bodies::pose(self.model.kind, body, &y[i * self.size..]));
        }
    }
}

impl Rate for Field<'_> {
    fn rate(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        self.pose(y);
        self.loads.clear();
        self.loads.resize(self.poses.len(), Load::default());
        let angles = self.size * self.poses.len();
        for (c, site) in self.model.sites.iter().enumerate() {
            out[angles + c] = contacts::load(site, &self.states[c], y[angles + c], &self.poses, &mut self.loads);
        }
        for link in &self.model.links {
            let [Some(a), Some(b)] = link.bodies else { continue };
            let part = |body: usize| &y[body * self.size..(body + 1) * self.size];
            if let Some((force, levers)) = bodies::between(link, [part(a), part(b)]) {
                self.loads[a].add(force, levers[0]);
                self.loads[b].add(-force, levers[1]);
            }
        }
        let ground = self.model.ground.acceleration(t);
        for (i, body) in self.model.bodies.iter().enumerate() {
            let part = i * self.size..(i + 1) * self.size;
            bodies::rate(self.model, body, &y[part.clone()], &self.loads[i], ground, &mut out[part]);
        }
    }
}

/// A run of the second formulation.
pub(super) struct Run<'a> {
    field: Field<'a>,
    y: Vec<f64>,
    t: f64,
    h: f64,
    sharers: Vec<usize>,
    /// Fastest circular frequency in flight and in contact.
    omega: (f64, f64),
    peak: f64,
    steps: usize,
    method: Extrapolation,
}

impl<'a> Run<'a> {
    pub(super) fn new(model: &'a Model) -> Self {
        let mut y: Vec<f64> = model.bodies.iter().flat_map(|body| bodies::start(model.kind, body)).collect();
        y.resize(y.len() + model.sites.len(), 0.0);
        let size = bodies::size(model.kind);
        let states = vec![State::Open { armed: true }; model.sites.len()];
        let mut field = Field { model, states, size, poses: Vec::new(), loads: Vec::new() };
        field.pose(&y);
        let mut sharers = vec![0; model.pairs.len()];
        for (c, site) in model.sites.iter().enumerate() {
            field.states[c] = contacts::overlapping(model, site, &field.poses, &mut sharers[site.pair]);
        }
        let omega = fastest(model);
        Self { field, y, t: 0.0, h: 0.0, sharers, omega, peak: 0.0, steps: 0, method: Extrapolation::default() }
    }

    /// Runs on to the last instant.
    pub(super) fn follow(mut self, instants: Instants) -> Answer {
        let mut places = self.places();
        for i in 1..=INTERVALS {
            while self.t < instants.at(i) {
                self.advance(instants.at(i), SHORTEST * instants.until);
            }
            places.extend(self.places());
        }
        let bodies = self.field.model.bodies.len();
        Answer { places, bodies, peak_force: self.peak, steps: self.steps, note: String::new() }
    }

    fn places(&self) -> Vec<[f64; 4]> {
        let (model, size) = (self.field.model, self.field.size);
        let place = |(i, body)| bodies::place(model.kind, body, &self.y[i * size..(i + 1) * size]);
        model.bodies.iter().enumerate().map(place).collect()
    }

    fn touching(&self) -> bool {
        self.field.states.iter().any(|s| !matches!(s, State::Open { .. }))
    }

    /// One step, not beyond `until`, or to the first event in it.
    fn advance(&mut self, until: f64, shortest: f64) {
        let longest = if self.touching() { RADIANS.1 / self.omega.1 } else { RADIANS.0 / self.omega.0 };
        let cap = until.min(self.field.model.ground.next_kink(self.t));
        if self.h <= 0.0 {
            self.h = CAUTIOUS * longest;
        }
        self.h = self.h.min(longest);
        let (mut h, whole) = (self.h.min(cap - self.t), cap - self.t <= self.h);
        let mut next;
        loop {
            let (state, error) = self.take(h);
            next = state;
            if error <= 1.0 || h <= shortest {
                if error < 0.01 && !(whole && h < self.h) {
                    self.h *= 1.5;
                }
                break;
            }
            h *= 0.5;
            self.h = h;
        }
        self.steps += 1;
        match self.first_event(&next, h) {
            None => {
                self.measure(h, &next);
                let end = if h >= cap - self.t { cap } else { self.t + h };
                self.arrive(next, end);
            }
            Some((tau, events)) => {
                let (state, _) = self.take(tau);
                self.measure(tau, &state);
                self.arrive(state, self.t + tau);
                self.change(&events);
            }
        }
    }

    fn take(&mut self, h: f64) -> (Vec<f64>, f64) {
        let y = std::mem::take(&mut self.y);
        let answer = self.method.step(&mut self.field, self.t, &y, h, TOLERANCE);
        self.y = y;
        answer
    }

    fn arrive(&mut self, mut y: Vec<f64>, t: f64) {
        let (size, count) = (self.field.size, self.field.model.bodies.len());
        for state in y[..size * count].chunks_mut(size) {
            bodies::tidy(self.field.model.kind, state);
        }
        self.y = y;
        self.t = t;
        self.field.pose(&self.y);
        for (c, site) in self.field.model.sites.iter().enumerate() {
            if matches!(self.field.states[c], State::Open { armed: false }) {
                let [node, face] = contacts::sides(site, &self.field.poses);
                // In front again by more than rounding.
                if contacts::View::of(site, &node, &face).gap > 1e-14 {
                    self.field.states[c] = State::Open { armed: true };
                }
            }
        }
    }

    /// Switching functions of every contact in a state.
    fn watched(&mut self, y: &[f64]) -> Vec<(usize, Kind, f64)> {
        self.field.pose(y);
        let angles = self.field.size * self.field.model.bodies.len();
        let field = &self.field;
        let of = |(c, site)| {
            let all = contacts::watched(site, &field.states[c], y[angles + c], &field.poses);
            all.into_iter().map(move |(kind, f)| (c, kind, f))
        };
        field.model.sites.iter().enumerate().flat_map(of).collect()
    }

    /// The first events within a step that ends in `next`: how long after its start, and which.
    fn first_event(&mut self, next: &[f64], h: f64) -> Option<(f64, Vec<(usize, Kind)>)> {
        let due: Vec<(usize, Kind)> =
            self.watched(next).into_iter().filter(|(_, _, f)| *f > 0.0).map(|(c, kind, _)| (c, kind)).collect();
        if due.is_empty() {
            return None;
        }
        let times: Vec<f64> = due.iter().map(|&event| self.root(event, h)).collect();
        let first = times.iter().copied().fold(f64::INFINITY, f64::min);
        let limit = first + TOGETHER / self.omega.1;
        let together = due.into_iter().zip(&times).filter(|(_, t)| **t <= limit).map(|(event, _)| event).collect();
        let last = times.iter().copied().filter(|t| *t <= limit).fold(first, f64::max);
        Some((last, together))
    }

    /// An event's switching function after a step of `tau`.
    fn value(&mut self, (contact, kind): (usize, Kind), tau: f64) -> f64 {
        let y = if tau > 0.0 { self.take(tau).0 } else { self.y.clone() };
        let all = self.watched(&y);
        all.into_iter().find(|(c, k, _)| (*c, *k) == (contact, kind)).map_or(0.0, |(_, _, f)| f)
    }

    /// Time at which an event's function crosses 0 within a step of `h` \[s\]: the Illinois rule on steps taken again.
    fn root(&mut self, event: (usize, Kind), h: f64) -> f64 {
        let (mut a, mut b) = (0.0, h);
        let (mut fa, mut fb) = (self.value(event, a), self.value(event, b));
        if fa >= 0.0 {
            // Rounding at a start on the border: either it is due at once, or it dips first.
            a = 1e-3 * h;
            fa = self.value(event, a);
            if fa >= 0.0 {
                return 0.0;
            }
        }
        let mut kept = 0_i8;
        for _ in 0..80 {
            if b - a <= 1e-15 * h {
                break;
            }
            let x = ((a * fb - b * fa) / (fb - fa)).clamp(a, b);
            let f = self.value(event, x);
            if f == 0.0 || x == a || x == b {
                return x;
            }
            if f > 0.0 {
                (b, fb) = (x, f);
                fa *= if kept == 1 { 0.5 } else { 1.0 };
                kept = 1;
            } else {
                (a, fa) = (x, f);
                fb *= if kept == -1 { 0.5 } else { 1.0 };
                kept = -1;
            }
        }
        b
    }

    fn change(&mut self, events: &[(usize, Kind)]) {
        let angles = self.field.size * self.field.model.bodies.len();
        let model = self.field.model;
        self.field.pose(&self.y);
        for &(c, kind) in events {
            let site = &model.sites[c];
            let before = (self.field.states[c], self.y[angles + c]);
            let sharers = &mut self.sharers[site.pair];
            let (state, angle) = contacts::after(model, site, before, kind, &self.field.poses, sharers);
            self.field.states[c] = state;
            self.y[angles + c] = angle;
        }
        for (number, pair) in model.pairs.iter().enumerate() {
            if pair.sites.clone().all(|c| matches!(self.field.states[c], State::Open { .. })) {
                self.sharers[number] = 0;
            }
        }
        self.h = 0.0;
    }

    /// Largest force within a step: at its ends, and inside where it comes near the largest so far.
    fn measure(&mut self, h: f64, next: &[f64]) {
        if !self.touching() {
            return;
        }
        let (y, end) = (self.y.clone(), next.to_vec());
        let ends = self.force(&y).max(self.force(&end));
        if ends < 0.95 * self.peak {
            return;
        }
        let (mut a, mut b) = (0.0, h);
        for _ in 0..28 {
            let third = (b - a) / 3.0;
            let (x, z) = (self.take(a + third).0, self.take(b - third).0);
            if self.force(&x) < self.force(&z) { a += third } else { b -= third }
        }
        let top = self.take(f64::midpoint(a, b)).0;
        self.peak = self.peak.max(ends).max(self.force(&top));
    }

    /// Largest force of a contact in a state.
    fn force(&mut self, y: &[f64]) -> f64 {
        self.field.pose(y);
        let angles = self.field.size * self.field.model.bodies.len();
        let of = |(c, site)| {
            let [node, face] = contacts::sides(site, &self.field.poses);
            let view = contacts::View::of(site, &node, &face);
            contacts::force(&self.field.states[c], y[angles + c], &view, &face).map_or(0.0, |(f, _)| f.on_node.length())
        };
        self.field.model.sites.iter().enumerate().map(of).fold(0.0, f64::max)
    }
}

/// Fastest circular frequency of the bearings and the ground, and with contacts closed.
fn fastest(model: &Model) -> (f64, f64) {
    let of_body = |b: &crate::dynamics::Body| b.quantities().omega.into_iter().fold(0.0, f64::max);
    // Bearings on piers: both ends swing, and turn, against each other.
    let linked = |link: &crate::dynamics::connection::Link| {
        let stiffness = link.device.linear().map_or(0.0, |[stiffness, _]| stiffness.max_element());
        let lightest = link.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
        2.0 * (stiffness * model.links.len() as f64 / lightest).sqrt()
    };
    let drive = match &model.ground {
        crate::motion::Ground::Sine { omega, .. } => *omega,
        _ => 1.0,
    };
    let vertical = |b: &crate::dynamics::Body| {
        let k: f64 = b.bearings.iter().map(|leg| leg.stiffness.z).sum();
        // Rolling on stiff bearings is faster than heaving.
        2.0 * (k / b.mass).sqrt()
    };
    let flight = model.bodies.iter().map(|b| of_body(b).max(vertical(b))).fold(drive.max(1.0), f64::max);
    let flight = model.links.iter().map(linked).fold(flight, f64::max);
    let contact = model.pairs.iter().map(|pair| {
        let lightest = pair.bodies.iter().flatten().map(|&b| model.bodies[b].mass).fold(f64::INFINITY, f64::min);
        // A hit off the centre turns the body as well.
        2.0 * (pair.contact.stiffness / lightest).sqrt()
    });
    (flight, contact.fold(flight, f64::max))
}
