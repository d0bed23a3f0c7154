//! Bodies that are integrated together: everyone who touches, until they part.

use super::body_state::{self, Wrench};
use super::dop853::{Dense, Dop853, next_factor};
use super::field::{Active, Field, Scale};
use super::track::Closed;
use super::{Body, Model};
use crate::contact::{Forces, Frame, Mode, law::Friction};
use crate::motion::LinearPiece;

/// A step shorter than this part of the contact's period means that the equations cannot be followed.
const SMALLEST: f64 = 1e-9;
/// Rounding of a place over one step, in parts of its size.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

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
    step: f64,
    frames: Vec<Frame>,
    wrenches: Vec<Wrench>,
}

/// Why a step could not be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StepTooSmall {
    /// Its length \[s\].
    pub step: f64,
}

impl Island {
    /// Gathers bodies at `t`; `step` is the length to try first, or 0 \[s\].
    pub(super) fn new(
        model: &Model,
        slots: Vec<usize>,
        bodies: Vec<usize>,
        contacts: Vec<(usize, Active)>,
        mut y: Vec<f64>,
        t: f64,
        step: f64,
    ) -> Self {
        let mut active: Vec<Active> = contacts.iter().map(|(_, a)| *a).collect();
        for a in &mut active {
            if let Some(angle) = turning(&a.closed) {
                a.angle = Some(y.len());
                y.push(angle);
            }
        }
        let mut island = Self {
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
            step,
            frames: Vec::new(),
            wrenches: Vec::new(),
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
        let scale = self.scale(model, t);
        let piece = model.ground.piece(model.ground.piece_number(t));
        let first = 0.5 / scale.omega * (model.tolerance / 1e-10).powf(0.125);
        let mut h = if self.step > 0.0 { self.step } else { first };
        let (mut rk, mut y) = (std::mem::take(&mut self.rk), std::mem::take(&mut self.y));
        let outcome = loop {
            // A last sliver would cost as much as a step: stretch to the cap.
            let end = if t + 1.05 * h >= cap { cap } else { t + h };
            let taken = end - t;
            let error = rk.attempt(&mut self.field(model, piece, scale), t, &y, taken);
            if error <= 1.0 {
                self.step = if end == cap { h.max(taken * next_factor(error)) } else { taken * next_factor(error) };
                self.dense = Some(rk.accept(&mut self.field(model, piece, scale), t, &mut y, taken));
                self.until = end;
                break Ok(());
            }
            h = taken * if error.is_finite() { next_factor(error).min(0.9) } else { 0.1 };
            if h < SMALLEST / scale.omega || t + h <= t {
                break Err(StepTooSmall { step: h });
            }
        };
        normalise(model, &self.bodies, &mut y);
        (self.rk, self.y) = (rk, y);
        outcome
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

    /// Length that the next step should have \[s\].
    pub(super) fn next_step(&self) -> f64 {
        self.step
    }

    /// Fastest circular frequency of its contacts and bearings \[rad/s\].
    pub(super) fn omega(&self, model: &Model) -> f64 {
        let contacts = self.active.iter().map(|a| {
            let pair = &model.pairs[model.contacts[a.site].pair];
            a.closed.law.k * pair.bodies.iter().flatten().map(|&b| mobility(&model.bodies[b])).sum::<f64>()
        });
        let bearings = self.bodies.iter().map(|&b| stiffest(&model.bodies[b]));
        contacts.chain(bearings).fold(1e-6, f64::max).sqrt()
    }

    fn scale(&self, model: &Model, t: f64) -> Scale {
        let omega = self.omega(model);
        let width = body_state::width(model.kind);
        let (mut speed2, mut place) = (0.0f64, 0.0f64);
        for (i, &b) in self.bodies.iter().enumerate() {
            let here = body_state::frame(model.kind, &model.bodies[b], &self.y[i * width..]);
            let spin = here.spin.length() * model.bodies[b].gyration2.sqrt();
            speed2 = speed2.max(here.velocity.length_squared() + spin * spin);
            // Attitudes are of order 1 where they are quaternions and axes: a corner's place rounds with its lever.
            place = place.max(here.shift.length() + model.bodies[b].radius());
        }
        for (number, active) in self.active.iter().enumerate() {
            let forces = self.forces(model, number, t);
            speed2 = speed2.max((omega * forces.normal / active.closed.law.k).powi(2));
        }
        // From rest nothing is moving yet: what the ground does to it in one radian.
        let floor = (model.ground.peak() + model.gravity + 1e-9) / omega;
        let speed = speed2.sqrt().max(1e-3 * floor);
        // No step can be made smaller than its rounding: a place's last bit, as a speed at the contact's frequency.
        let rounding = ROUNDING * omega * place;
        Scale { speed: model.tolerance * speed + rounding, omega, angle: 10.0 * model.tolerance }
    }

    fn forces(&self, model: &Model, number: usize, t: f64) -> Forces {
        let active = &self.active[number];
        let site = &model.contacts[active.site];
        let frame = |index: Option<usize>| match index {
            Some(i) => {
                let width = body_state::width(model.kind);
                body_state::frame(model.kind, &model.bodies[self.bodies[i]], &self.y[i * width..])
            }
            None => Frame::fixed(site.fixed),
        };
        let closed = self.closed_at(number, t);
        super::penalty3d::act(site, &closed, &frame(active.node), &frame(active.face)).forces
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

/// Upper bound on acceleration at a corner per unit force \[1/kg\].
fn mobility(body: &Body) -> f64 {
    let arm = body.radius();
    let smallest = (body.prism.width.powi(2) + body.prism.thickness.powi(2)) / 12.0;
    let turn = if body.free[3] || body.free[4] { arm * arm / smallest } else { arm * arm / body.gyration2 };
    (1.0 + turn) / body.mass
}

/// Largest stiffness per inertia of a body on its bearings \[1/s²\].
fn stiffest(body: &Body) -> f64 {
    let sum = body.bearings.iter().map(|b| b.stiffness.max_element()).sum::<f64>();
    let damping = body.bearings.iter().map(|b| b.damping.max_element()).sum::<f64>() / body.mass;
    if body.free[3] || body.free[4] {
        let arm2 = body.radius().powi(2);
        let smallest = (body.prism.width.powi(2) + body.prism.thickness.powi(2)) / 12.0;
        (sum / body.mass * (1.0 + arm2 / smallest)).max(damping * damping)
    } else {
        (3.0 * sum / body.mass).max(damping * damping)
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
