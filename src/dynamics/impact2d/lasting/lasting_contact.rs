//! Bodies in lasting contact, integrated together between two changes.
//!
//! Everything at rest on its faces stands still, and a face slides along a wall as an oscillator ([`Slide`]): closed forms.
//! Else, where a girder turns about what holds it, or moves with another, Dormand–Prince 8(5,3) with the reactions solved
//! for at every stage. What can end it is looked for in the continuous answer of each step: a push that falls to 0, a hold that
//! friction cannot give, a slide that stops, a point that comes to the edge of the face.

use glam::DVec3;

use crate::dynamics::Model;
use crate::dynamics::free_flight::flight::Planar;
use crate::dynamics::free_flight::sliding_face::Slide;
use crate::dynamics::impact2d::lasting::constrained_motion::{Answer, Scenery, Seat, Way, middle, react, shaking};
use crate::dynamics::integrator::dense_output::{DENSE, Dense};
use crate::dynamics::integrator::dop853::{Dop853, next_factor};
use crate::dynamics::integrator::system::System;
use crate::dynamics::locate::root::root;
use crate::dynamics::model::rigid_body;
use crate::dynamics::trajectory::segment::Path;
use crate::dynamics::trajectory::step_polynomial::Piece;
use crate::motion::{Ground, LinearPiece};
use crate::scene::ImpactSettings;

/// Looks at what can end the contact, per step.
const LOOKS: usize = 16;
/// A gauge lower than this part of its largest may dip below 0 between two looks.
const NEAR: f64 = 0.05;
/// Steps refused one after another before it is given up.
const REFUSED: usize = 60;
/// Components of a planar body.
const WIDTH: usize = rigid_body::PLANAR;

/// What ends a stretch of lasting contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics::impact2d) enum Ending {
    /// The declared contact is not pushed any more.
    Lets(usize),
    /// The declared contact comes to the edge of the face.
    Leaves(usize),
    /// Friction cannot hold the pair any more.
    Breaks(usize),
    /// The pair has stopped sliding.
    Stops(usize),
}

/// The answer of a step.
#[derive(Clone, Debug)]
enum Course {
    Slide(Box<Slide>),
    Step(Dense),
}

/// Bodies in lasting contact, with the step that is planned but not yet committed.
#[derive(Clone, Debug)]
pub(in crate::dynamics::impact2d) struct Grip {
    /// Their numbers in the model, rising.
    pub bodies: Vec<usize>,
    /// What touches, and how.
    pub seats: Vec<Seat>,
    /// Since when \[s\].
    pub since: f64,
    /// Where the planned step begins \[s\].
    pub from: f64,
    /// Where it ends \[s\].
    pub until: f64,
    /// What ends the contact at `until`.
    pub ending: Option<Ending>,
    course: Option<Course>,
    y: Vec<f64>,
    step: f64,
}

/// The right-hand side.
struct Held<'a> {
    model: &'a Model,
    bodies: &'a [usize],
    seats: &'a [Seat],
    piece: LinearPiece,
    numbers: &'a ImpactSettings,
    /// What the tolerance allows of a place, and of a speed \[m\], \[m/s\].
    allowed: [f64; 2],
}

impl Held<'_> {
    fn answer(&self, t: f64, y: &[f64]) -> (Scenery, Option<Answer>) {
        let ground = shaking(&self.model.ground, &self.piece, t);
        let scenery = Scenery::new(self.model, self.bodies, &states(y), ground);
        let points: Vec<_> = self.seats.iter().map(|seat| scenery.points(self.model, seat)).collect();
        let answer = react(&scenery, self.seats, &points, self.numbers);
        (scenery, answer)
    }
}

impl System for Held<'_> {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        let (_, answer) = self.answer(t, y);
        // Without an answer the step is refused.
        for (i, &body) in self.bodies.iter().enumerate() {
            let a = answer.as_ref().map_or(DVec3::NAN, |answer| answer.accelerations[i]);
            let free = self.model.bodies[body].free;
            for (j, direction) in [0, 1, 5].into_iter().enumerate() {
                out[WIDTH * i + j] = if free[direction] { y[WIDTH * i + 3 + j] } else { 0.0 };
                out[WIDTH * i + 3 + j] = a[j];
            }
        }
    }

    fn size2(&self, d: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (d, &body) in d.chunks_exact(WIDTH).zip(self.bodies) {
            let i2 = self.model.bodies[body].gyration2;
            let square = |d: &[f64]| d[0] * d[0] + d[1] * d[1] + i2 * d[2] * d[2];
            sum += square(&d[..3]) / (self.allowed[0] * self.allowed[0])
                + square(&d[3..]) / (self.allowed[1] * self.allowed[1]);
        }
        sum
    }
}

/// Body by body.
fn states(y: &[f64]) -> Vec<Planar> {
    y.chunks_exact(WIDTH).map(|c| [c[0], c[1], c[2], c[3], c[4], c[5]]).collect()
}

impl Grip {
    /// Bodies in lasting contact from `t` on.
    pub(in crate::dynamics::impact2d) fn new(bodies: Vec<usize>, seats: Vec<Seat>, states: &[Planar], t: f64) -> Self {
        let y = states.iter().flatten().copied().collect();
        Self { bodies, seats, since: t, from: t, until: t, ending: None, course: None, y, step: 0.0 }
    }

    /// Whether nobody moves: every seat is a face that stays put, and so are all bodies.
    fn rests(&self) -> bool {
        self.seats.iter().all(|seat| seat.is_flush() && seat.way == Way::Held)
            && self.y.chunks_exact(WIDTH).all(|c| c[3..] == [0.0; 3])
    }

    /// Whether friction is left out of it for want of a motion that agrees with it: it is decided anew at every step.
    pub(in crate::dynamics::impact2d) fn is_makeshift(&self) -> bool {
        self.seats.iter().any(|seat| seat.way == Way::Slides(0.0))
    }

    /// Plans the next step from `until`, at most to `cap`, that nothing ends within `least`; `allowed` is what the tolerance
    /// allows of places and speeds.
    ///
    /// # Errors
    /// When no step is short enough.
    pub(in crate::dynamics::impact2d) fn plan(
        &mut self,
        model: &Model,
        numbers: &ImpactSettings,
        allowed: [f64; 2],
        [least, cap]: [f64; 2],
    ) -> Result<(), String> {
        let t = self.until;
        self.from = t;
        let piece = model.ground.piece(model.ground.piece_number(t));
        let cap = cap.min(piece.until).min(t + quarter(&model.ground));
        if let Some(slide) = self.slides(model, numbers, &piece, cap) {
            self.until = cap.min(t + slide.sight);
            self.course = Some(Course::Slide(Box::new(slide)));
        } else {
            let dense =
                if self.rests() { self.rest(cap) } else { self.integrate(model, numbers, piece, allowed, cap)? };
            self.until = if dense.from + dense.step >= cap { cap } else { dense.from + dense.step };
            self.course = Some(Course::Step(dense));
        }
        self.look_for_an_end(model, numbers, piece, least);
        Ok(())
    }

    /// Everybody stays where they are.
    fn rest(&self, cap: f64) -> Dense {
        let constant = self.y.iter().map(|y| [*y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]).collect::<Vec<[f64; DENSE]>>();
        Dense::new(self.from, cap - self.from, constant)
    }

    /// A face alone on a wall, sliding.
    fn slides(&self, model: &Model, numbers: &ImpactSettings, piece: &LinearPiece, cap: f64) -> Option<Slide> {
        let ([body], [state]) = (&self.bodies[..], &states(&self.y)[..]) else { return None };
        let [seat] = &self.seats[..] else { return None };
        let (Way::Slides(sign), true) = (seat.way, seat.is_flush()) else { return None };
        let (sides, girder) = (model.pairs[seat.pair].bodies, &model.bodies[*body]);
        if !(sides.contains(&None) && girder.free[0] && girder.free[1]) {
            return None;
        }
        let scenery = Scenery::new(model, &[*body], std::slice::from_ref(state), DVec3::ZERO);
        let touching = middle(&scenery.points(model, seat));
        // The wall's normal towards the girder, whichever side of the pair it is.
        let n = if sides[0].is_none() { -touching.n } else { touching.n };
        let s = n.perp();
        let d = s + n * (seat.friction(numbers)[1] * sign);
        let longest = (cap - self.from).min(model.duration);
        Some(Slide::new((girder, &model.ground), [s, d], piece, (self.from, state), longest))
    }

    fn integrate(
        &mut self,
        model: &Model,
        numbers: &ImpactSettings,
        piece: LinearPiece,
        allowed: [f64; 2],
        cap: f64,
    ) -> Result<Dense, String> {
        let mut system = Held { model, bodies: &self.bodies, seats: &self.seats, piece, numbers, allowed };
        let (t, mut y) = (self.from, self.y.clone());
        let mut method = Dop853::default();
        method.resize(y.len());
        method.start(&mut system, t, &y);
        let mut h = if self.step > 0.0 { self.step } else { 1e-3 * (cap - t) };
        for _ in 0..REFUSED {
            h = if h >= 0.999 * (cap - t) { cap - t } else { h };
            let error = method.attempt(&mut system, t, &y, h);
            if error <= 1.0 {
                let dense = method.accept(&mut system, t, &mut y, h);
                self.step = h * next_factor(error);
                return Ok(dense);
            }
            h *= if error.is_finite() { next_factor(error).min(0.5) } else { 0.1 };
        }
        Err("no step is short enough to follow the contact: its reactions have no answer here".to_owned())
    }

    /// State of a body, by its place here.
    pub(in crate::dynamics::impact2d) fn state(&self, place: usize, t: f64) -> Planar {
        let mut state = [0.0; WIDTH];
        match &self.course {
            Some(Course::Slide(slide)) => state = slide.state(t),
            Some(Course::Step(dense)) => dense.read(place * WIDTH..(place + 1) * WIDTH, t, &mut state),
            None => state.copy_from_slice(&self.y[place * WIDTH..(place + 1) * WIDTH]),
        }
        state
    }

    /// What a history keeps of a body in the planned step.
    pub(in crate::dynamics::impact2d) fn path(&self, place: usize) -> Option<Path> {
        self.course.as_ref().map(|course| match course {
            Course::Slide(slide) => Path::Slide(slide.clone()),
            Course::Step(dense) => Path::Step(Piece::of(dense, place * WIDTH..(place + 1) * WIDTH, None)),
        })
    }

    /// Commits the planned step: its end becomes the next start.
    pub(in crate::dynamics::impact2d) fn commit(&mut self) {
        let t = self.until;
        self.y = (0..self.bodies.len()).flat_map(|place| self.state(place, t)).collect();
        self.course = None;
    }

    /// What can end the contact, as numbers that are positive while it lasts.
    fn gauges(&self, model: &Model, numbers: &ImpactSettings, piece: LinearPiece, t: f64) -> Vec<(f64, Ending)> {
        let y: Vec<f64> = (0..self.bodies.len()).flat_map(|place| self.state(place, t)).collect();
        let allowed = [1.0; 2];
        let held = Held { model, bodies: &self.bodies, seats: &self.seats, piece, numbers, allowed };
        let (scenery, Some(answer)) = held.answer(t, &y) else { return Vec::new() };
        let mut all = Vec::new();
        for (seat, reaction) in self.seats.iter().zip(&answer.reactions) {
            let points = scenery.points(model, seat);
            for ((&site, point), push) in seat.sites.iter().zip(&points).zip(reaction.normal) {
                all.push((push, Ending::Lets(site)));
                all.push((point.inset, Ending::Leaves(site)));
            }
            match seat.way {
                Way::Held => {
                    let rounding = 2.0 * scenery.rounding(&middle(&points));
                    let most = seat.friction(numbers)[0] * reaction.total() + rounding;
                    all.push((most - reaction.tangential.abs(), Ending::Breaks(seat.pair)));
                }
                Way::Slides(sign) => {
                    let middle = middle(&points);
                    all.push((sign * scenery.cluster.speed(&middle, middle.s), Ending::Stops(seat.pair)));
                }
            }
        }
        all
    }

    /// Ends the planned step where the first gauge falls through 0.
    fn look_for_an_end(&mut self, model: &Model, numbers: &ImpactSettings, piece: LinearPiece, least: f64) {
        self.ending = None;
        let (from, until) = ((self.from + least).min(self.until), self.until);
        let gauges = |t: f64| self.gauges(model, numbers, piece, t);
        let times: Vec<f64> = (0..=LOOKS)
            .map(|look| if look == LOOKS { until } else { from + (until - from) * look as f64 / LOOKS as f64 })
            .collect();
        let seen: Vec<Vec<(f64, Ending)>> = times.iter().map(|&t| gauges(t)).collect();
        let count = seen.iter().map(Vec::len).min().unwrap_or(0);
        let mut first: Option<(f64, Ending)> = None;
        for i in 0..count {
            let gauge = |t: f64| gauges(t).get(i).map_or(0.0, |g| g.0);
            let values: Vec<f64> = seen.iter().map(|at| at[i].0).collect();
            if let Some(t) = falls(&gauge, &times, &values)
                && first.is_none_or(|(earliest, _)| t < earliest)
            {
                first = Some((t, seen[0][i].1));
            }
        }
        if let Some((t, ending)) = first {
            (self.until, self.ending) = (t, Some(ending));
        }
    }
}

/// Where a gauge, seen at some times, first falls through 0: between two looks, or in a dip between them that comes near 0.
fn falls(gauge: &dyn Fn(f64) -> f64, times: &[f64], values: &[f64]) -> Option<f64> {
    let largest = values.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    for (k, (t, v)) in times.windows(2).zip(values.windows(2)).enumerate() {
        if v[1] < 0.0 && (v[0] > 0.0 || k == 0) {
            return Some(root(|t| -gauge(t), t[0], t[1]));
        }
        if v[0] > 0.0
            && v[0].min(v[1]) < NEAR * largest
            && let Some(low) = dip(gauge, [t[0], t[1]])
        {
            return Some(root(|t| -gauge(t), t[0], low));
        }
    }
    None
}

/// Where a gauge is below 0 between two looks that see it above; nothing where it turns round above, or not at all.
fn dip(gauge: &dyn Fn(f64) -> f64, [a, b]: [f64; 2]) -> Option<f64> {
    let hair = 1e-4 * (b - a);
    let slope = |t: f64| gauge(t + hair) - gauge(t);
    if slope(a) >= 0.0 || slope(b - hair) <= 0.0 {
        return None;
    }
    let low = root(slope, a, b - hair) + 0.5 * hair;
    (gauge(low) < 0.0).then_some(low)
}

/// A quarter of the period of the shaking \[s\].
fn quarter(ground: &Ground) -> f64 {
    match ground {
        Ground::Sine { omega, .. } if *omega > 0.0 => 0.25 * std::f64::consts::TAU / omega,
        _ => f64::INFINITY,
    }
}

#[cfg(test)]
mod tests;
