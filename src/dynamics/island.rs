//! Bodies that are integrated together: everyone who touches, until they part.

use super::body_state::{self, Wrench};
use super::dop853::{self, Dense, Dop853};
use super::fastest::fastest;
use super::field::{Active, Field, Scale};
use super::radau::{self, Radau};
use super::track::Closed;
use super::{Body, Model};
use crate::contact::{Frame, Mode, law::Friction};
use crate::motion::LinearPiece;

/// A step shorter than this part of the contact's period means that the equations cannot be followed.
const SMALLEST: f64 = 1e-9;
/// Rounding of a place over one step, in parts of its size.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Explicit steps that span more time constants of the fastest motion than this, though their error is less than
/// [`SPARE`], are held short by their stability.
const STIFF: f64 = 0.7;
/// See [`STIFF`].
const SPARE: f64 = 0.02;
/// Factor to the next try from the second refusal on.
const AGAIN: f64 = 0.2;
/// So many of them in a row change the method.
const CONVINCED: u32 = 4;
/// Explicit steps of one touch after which the other method is tried, and after twice as many again: noise, too, can hold
/// them short.
const TRIAL: u32 = 64;
/// An implicit step costs as much as explicit ones over so many time constants.
const WORTH: f64 = 12.0;
/// With a smaller error than this the next step will be longer.
const GROWING: f64 = 0.2;
/// Components beyond which elimination costs more than short steps.
const LARGEST: usize = 160;

/// How an island's integrator goes on after an event.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Pace {
    /// Length of the step to try first; 0 where nothing is known \[s\].
    pub step: f64,
    /// Whether explicit steps were too short.
    pub stiff: bool,
}

impl Pace {
    /// The more careful of two.
    pub(super) fn with(self, other: Self) -> Self {
        let step = if self.step == 0.0 { other.step } else { self.step.min(other.step) };
        Self { step, stiff: self.stiff || other.stiff }
    }
}

/// Bodies in one integrator, with the step that is planned but not yet committed.
#[derive(Debug)]
pub(super) struct Island {
    /// Slots of its bodies in the engine, rising.
    pub slots: Vec<usize>,
    /// Their numbers in the model.
    bodies: Vec<usize>,
    /// Closed contacts between them.
    pub active: Vec<Active>,
    /// Numbers of those contacts in the engine.
    pub contacts: Vec<usize>,
    /// Where the planned step begins \[s\].
    pub from: f64,
    /// Where it ends \[s\].
    pub until: f64,
    /// What is due at `until`, if anything but the next step.
    pub due: Vec<super::watch::Due>,
    dense: Option<Dense>,
    y: Vec<f64>,
    rk: Dop853,
    radau: Option<Box<Radau>>,
    pace: Pace,
    omega: f64,
    /// Largest distance of a corner from G, body by body \[m\].
    radii: Vec<f64>,
    /// Steps in a row that spoke against the method in use.
    doubts: u32,
    /// Steps with the method in use, and explicit ones after which the other is given a try.
    steps: u32,
    trial: u32,
    frames: Vec<Frame>,
    wrenches: Vec<Wrench>,
    rates: Vec<f64>,
}

/// Why a step could not be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StepTooSmall {
    /// Its length \[s\].
    pub step: f64,
}

impl Island {
    /// Gathers bodies at `t`.
    pub(super) fn new(
        model: &Model,
        slots: Vec<usize>,
        bodies: Vec<usize>,
        contacts: Vec<(usize, Active)>,
        mut y: Vec<f64>,
        t: f64,
        pace: Pace,
    ) -> Self {
        let mut active: Vec<Active> = contacts.iter().map(|(_, a)| *a).collect();
        for a in &mut active {
            if let Some(angle) = turning(&a.closed) {
                a.angle = Some(y.len());
                y.push(angle);
            }
        }
        // A slip's direction follows its velocity within the stretch of the spring: fast against everything else.
        let turns = active.iter().any(|a| a.angle.is_some());
        let pace = Pace { stiff: (pace.stiff && !active.is_empty() || turns) && y.len() <= LARGEST, ..pace };
        let radii: Vec<f64> = bodies.iter().map(|&b| model.bodies[b].radius).collect();
        let mut island = Self {
            omega: fastest(model, &bodies, &active),
            radii,
            slots,
            bodies,
            contacts: contacts.into_iter().map(|(c, _)| c).collect(),
            active,
            from: t,
            until: t,
            due: Vec::new(),
            dense: None,
            y,
            rk: Dop853::default(),
            radau: None,
            pace,
            doubts: 0,
            steps: 0,
            trial: TRIAL,
            frames: Vec::new(),
            wrenches: Vec::new(),
            rates: Vec::new(),
        };
        island.rk.resize(island.y.len());
        island.rewind(model, t);
        island
    }

    /// Evaluates the slope at the start of the next step anew: at a start, and after a kink of the ground motion.
    pub(super) fn rewind(&mut self, model: &Model, t: f64) {
        let piece = model.ground.piece(model.ground.piece_number(t));
        let (mut rk, y) = (std::mem::take(&mut self.rk), std::mem::take(&mut self.y));
        rk.start(&mut self.field(model, piece, Scale::default()), t, &y);
        (self.rk, self.y) = (rk, y);
        if let Some(radau) = &mut self.radau {
            radau.forget();
        }
    }

    fn field<'a>(&'a mut self, model: &'a Model, piece: LinearPiece, scale: Scale) -> Field<'a> {
        Field {
            model,
            bodies: &self.bodies,
            active: &self.active,
            piece,
            scale,
            frames: &mut self.frames,
            wrenches: &mut self.wrenches,
            rates: &mut self.rates,
        }
    }

    /// Poses of its bodies a moment after the start of the next step, by its slope alone.
    pub(crate) fn frames_after(&self, model: &Model, dt: f64) -> Vec<Frame> {
        let width = body_state::width(model.kind);
        let moved: Vec<f64> = self.y.iter().zip(self.rk.slope()).map(|(y, rate)| y + dt * rate).collect();
        let frame =
            |(i, &body): (usize, &usize)| body_state::frame(model.kind, &model.bodies[body], &moved[i * width..]);
        self.bodies.iter().enumerate().map(frame).collect()
    }

    /// Plans the next step from `from`, at most to `cap`.
    ///
    /// # Errors
    /// When the step that the tolerance asks for is too small to follow.
    pub(super) fn plan(&mut self, model: &Model, cap: f64) -> Result<(), StepTooSmall> {
        let t = self.until;
        self.from = t;
        let scale = self.scale(model);
        let piece = model.ground.piece(model.ground.piece_number(t));
        let first = 0.5 / scale.omega * (model.tolerance / 1e-10).powf(0.125);
        let mut h = if self.pace.step > 0.0 { self.pace.step } else { first };
        let mut refused = false;
        loop {
            // A last sliver would cost as much as a step: stretch to the cap.
            let end = if t + 1.05 * h >= cap { cap } else { t + h };
            let taken = end - t;
            let (error, factor) = self.attempt(model, piece, scale, taken);
            if error <= 1.0 {
                self.pace.step = if end == cap { h.max(taken * factor) } else { taken * factor };
                self.accept(model, piece, scale, taken, error);
                self.until = end;
                return Ok(());
            }
            // Refused twice, the estimate is no guide: something is over far sooner than the step.
            h = taken * factor.min(if refused { AGAIN } else { 0.9 });
            refused = true;
            if h < SMALLEST / scale.omega || t + h <= t {
                return Err(StepTooSmall { step: h });
            }
        }
    }

    /// Tries a step of length `h` from `from`; returns its error, 1 being the tolerance, and the factor to the next step.
    fn attempt(&mut self, model: &Model, piece: LinearPiece, scale: Scale, h: f64) -> (f64, f64) {
        let t = self.from;
        let (mut rk, y) = (std::mem::take(&mut self.rk), std::mem::take(&mut self.y));
        let outcome = if self.pace.stiff {
            let mut radau = self.radau.take().unwrap_or_else(|| Box::new(Radau::new(y.len())));
            let error = radau.attempt(&mut self.field(model, piece, scale), t, &y, rk.slope(), h);
            self.radau = Some(radau);
            (error, if error.is_finite() { radau::next_factor(error) } else { 0.25 })
        } else {
            let error = rk.attempt(&mut self.field(model, piece, scale), t, &y, h);
            (error, if error.is_finite() { dop853::next_factor(error) } else { 0.1 })
        };
        (self.rk, self.y) = (rk, y);
        outcome
    }

    /// Accepts the step just tried and considers whether the other method would have done it for less.
    fn accept(&mut self, model: &Model, piece: LinearPiece, scale: Scale, h: f64, error: f64) {
        let t = self.from;
        let (mut rk, mut y) = (std::mem::take(&mut self.rk), std::mem::take(&mut self.y));
        let mut radau = self.radau.take();
        let stiff = self.pace.stiff;
        let size = y.len();
        let mut field = self.field(model, piece, scale);
        let (dense, doubt) = match &mut radau {
            Some(radau) if stiff => {
                let dense = radau.accept(t, &mut y, h);
                rk.start(&mut field, t + h, &y);
                (dense, error > GROWING && h * radau.fastest(&field) < WORTH)
            }
            _ => {
                let dense = rk.accept(&mut field, t, &mut y, h);
                let spare = size <= LARGEST && error < SPARE;
                let doubt = spare && rk.stiffness(&field, &dense) > STIFF;
                (dense, doubt)
            }
        };
        normalise(model, &self.bodies, &mut y);
        (self.rk, self.y, self.radau, self.dense) = (rk, y, radau, Some(dense));
        self.doubts = if doubt { self.doubts + 1 } else { 0 };
        self.steps += 1;
        let try_it = !stiff && self.steps >= self.trial && size <= LARGEST && !self.active.is_empty();
        if try_it {
            self.trial *= 2;
        }
        if self.doubts >= CONVINCED || try_it {
            self.change_method();
        }
    }

    fn change_method(&mut self) {
        (self.doubts, self.steps) = (0, 0);
        self.pace.stiff = !self.pace.stiff;
        if let Some(radau) = &mut self.radau {
            radau.resize(self.y.len());
        }
    }

    /// Cuts the planned step short at `t` and makes that the state; the caller forms the island anew.
    pub(super) fn state_at(&self, model: &Model, index: usize, t: f64) -> Vec<f64> {
        let width = body_state::width(model.kind);
        let range = index * width..(index + 1) * width;
        match &self.dense {
            Some(dense) if t < self.until => {
                let mut out = vec![0.0; width];
                dense.read(range, t, &mut out);
                normalise(model, &self.bodies[index..=index], &mut out);
                out
            }
            _ => self.y[range].to_vec(),
        }
    }

    /// Pose of one of its bodies within the planned step.
    pub(super) fn frame(&self, model: &Model, index: usize, t: f64) -> Frame {
        let width = body_state::width(model.kind);
        let range = index * width..(index + 1) * width;
        let body: &Body = &model.bodies[self.bodies[index]];
        match &self.dense {
            Some(dense) => {
                let mut state = [0.0; body_state::SPATIAL];
                dense.read(range, t, &mut state[..width]);
                body_state::frame(model.kind, body, &state[..width])
            }
            None => body_state::frame(model.kind, body, &self.y[range]),
        }
    }

    /// A contact's state with its slip direction as it is at `t`.
    pub(super) fn closed_at(&self, number: usize, t: f64) -> Closed {
        let active = &self.active[number];
        let mut closed = active.closed;
        if let Some(at) = active.angle {
            let mut angle = [self.y[at]];
            if let Some(dense) = &self.dense {
                dense.read(at..at + 1, t, &mut angle);
            }
            closed.mode = Mode::Slip { direction: glam::DVec2::from_angle(angle[0]) };
        }
        closed
    }

    /// The planned step's continuous answer for one body.
    pub(super) fn path(&self, model: &Model, index: usize) -> Option<Dense> {
        let width = body_state::width(model.kind);
        self.dense.as_ref().map(|dense| dense.part(index * width..(index + 1) * width))
    }

    /// The planned step's continuous answer for the slip angle of one of its contacts.
    pub(super) fn angle_path(&self, number: usize) -> Option<Dense> {
        let at = self.active[number].angle?;
        self.dense.as_ref().map(|dense| dense.part(at..at + 1))
    }

    /// How its integrator would go on.
    pub(super) fn pace(&self) -> Pace {
        self.pace
    }

    /// Fastest circular frequency of its contacts and bearings \[rad/s\].
    pub(super) fn omega(&self) -> f64 {
        self.omega
    }

    /// What errors are measured against: the speeds of its bodies and of what their contacts hold.
    fn scale(&mut self, model: &Model) -> Scale {
        let (omega, width) = (self.omega, body_state::width(model.kind));
        let (mut speed2, mut place) = (0.0f64, 0.0f64);
        self.frames.clear();
        for (i, &b) in self.bodies.iter().enumerate() {
            let here = body_state::frame(model.kind, &model.bodies[b], &self.y[i * width..]);
            let spin = here.spin.length() * model.bodies[b].gyration2.sqrt();
            speed2 = speed2.max(here.velocity.length_squared() + spin * spin);
            // Attitudes are of order 1 where they are quaternions and axes: a corner's place rounds with its lever.
            place = place.max(here.shift.length() + self.radii[i]);
            self.frames.push(here);
        }
        let mut stretch = 0.0f64;
        for active in &self.active {
            let here = active.look(model, &self.frames);
            speed2 = speed2.max((omega * here.gap).powi(2));
            if active.angle.is_some() {
                stretch = stretch.max(active.closed.law.mu_k * (here.gap.abs() + here.gap_rate.abs() / omega));
            }
        }
        // From rest nothing is moving yet: what the ground does to it in one radian.
        let floor = (model.ground.peak() + model.gravity + 1e-9) / omega;
        let speed = speed2.sqrt().max(1e-3 * floor);
        // No step can be made smaller than its rounding: a place's last bit, as a speed at the contact's frequency.
        let speed = model.tolerance * speed + ROUNDING * omega * place;
        // A direction counts by the place that it puts p at.
        let angle = (speed / (omega * stretch)).min(model.tolerance.sqrt());
        Scale { speed, omega, angle, place }
    }
}

/// Angle of a slip whose direction turns on its own, which the integrator must carry.
fn turning(closed: &Closed) -> Option<f64> {
    match closed.mode {
        Mode::Slip { direction } if closed.ease > 0.0 && closed.law.friction == Friction::ReturnMapping => {
            Some(direction.to_angle())
        }
        _ => None,
    }
}

/// Keeps the quaternions of spatial bodies at length 1.
fn normalise(model: &Model, bodies: &[usize], y: &mut [f64]) {
    if model.kind == crate::scene::Kind::Planar {
        return;
    }
    for i in 0..bodies.len() {
        let q = &mut y[i * body_state::SPATIAL + 3..i * body_state::SPATIAL + 7];
        let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
        for x in q {
            *x /= length;
        }
    }
}
