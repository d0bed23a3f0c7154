//! Motion of bodies in lasting contact between two changes of contact mode, and the event that ends it.
//!
//! Bodies at rest on their faces stand still, and one face sliding along a wall is an oscillator ([`SlidingFace`]): closed forms.
//! Otherwise, where a girder turns about its contact or moves with another, Dormand–Prince 8(5,3) with the reactions solved
//! at every stage. An interval ends where the first of these falls to 0 in the dense output: a normal reaction, the distance
//! from a friction cone, a slip, the distance of a point from the border of the face.

use glam::DVec3;

use crate::dynamics::Model;
use crate::dynamics::free_flight::sliding_face::SlidingFace;
use crate::dynamics::impact2d::InlineVec;
use crate::dynamics::impact2d::constants::{
    FIRST_STEP, NOT_FINITE_FACTOR, REJECTED_FACTOR, REJECTED_STEPS, STRETCHED_STEP, SWITCHING_SAMPLES,
};
use crate::dynamics::impact2d::kinematics::{BodyKinematics, ground_acceleration};
use crate::dynamics::impact2d::lasting::constrained_motion::{
    ConstrainedMotion, ContactMode, FrictionMode, Reaction, least_reactions,
};
use crate::dynamics::impact2d::lasting::indeterminate::solve_reactions;
use crate::dynamics::impact2d::lasting::slide_on_wall::slide_on_wall;
use crate::dynamics::impact2d::lasting::switch::{Ending, SwitchingFunction};
use crate::dynamics::integrator::dense_output::{DENSE_TERMS, DenseOutput};
use crate::dynamics::integrator::dop853::{Dop853, next_factor};
use crate::dynamics::integrator::system::System;
use crate::dynamics::locate::first_rise::{EarliestEvent, Resolution, first_rise};
use crate::dynamics::model::coordinates::planar::{self, POSITIONS, PlanarState, WIDTH};
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::dynamics::trajectory::segment::SegmentMotion;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;
use crate::language::Text;
use crate::motion::{Ground, LinearPiece};

/// Motion of a planned step.
#[derive(Clone, Debug)]
enum PlannedMotion {
    /// With the bounds on its motion.
    Slide(Box<SlidingFace>, MotionBounds),
    Step(DenseOutput),
}

/// Bodies joined by lasting contact, with a planned step that is not committed yet.
#[derive(Clone, Debug)]
pub(in crate::dynamics::impact2d) struct LastingContact {
    /// Numbers in the model, rising.
    pub bodies: Vec<usize>,
    /// Contact modes.
    pub modes: Vec<ContactMode>,
    /// Start of the contact \[s\].
    pub since: f64,
    /// Start of the planned step \[s\].
    pub from: f64,
    /// End of the planned step \[s\].
    pub until: f64,
    /// Event that ends the contact at `until`.
    pub ending: Option<Ending>,
    planned: Option<PlannedMotion>,
    y: Vec<f64>,
    /// Length of the next step that the tolerance asks for \[s\]; `None` before the first.
    step: Option<f64>,
}

/// Right-hand side: states body by body, accelerations under the reactions of the contact modes.
struct ConstrainedOde<'a> {
    model: &'a Model,
    bodies: &'a [usize],
    modes: &'a [ContactMode],
    piece: LinearPiece,
    /// Allowed error of a place and of a speed \[m\], \[m/s\].
    allowed: [f64; 2],
}

impl ConstrainedOde<'_> {
    fn kinematics(&self, t: f64, y: &[f64]) -> BodyKinematics {
        let ground = ground_acceleration(&self.model.ground, &self.piece, t);
        BodyKinematics::new(self.model, self.bodies, &states(y), ground)
    }

    fn motion(&self, t: f64, y: &[f64]) -> (BodyKinematics, Option<ConstrainedMotion>) {
        let kinematics = self.kinematics(t, y);
        let points: Vec<_> = self.modes.iter().map(|mode| mode.points(self.model, &kinematics)).collect();
        let motion = solve_reactions(&kinematics, self.modes, &points, &self.model.impact);
        (kinematics, motion)
    }

    fn accelerations(&self, t: f64, y: &[f64]) -> Option<InlineVec<DVec3>> {
        let kinematics = self.kinematics(t, y);
        let points: Vec<_> = self.modes.iter().map(|mode| mode.points(self.model, &kinematics)).collect();
        Some(least_reactions(&kinematics, self.modes, &points, &self.model.impact)?.accelerations)
    }
}

impl System for ConstrainedOde<'_> {
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        let accelerations = self.accelerations(t, y);
        // Without a solution the slope is not finite, and the step is rejected.
        for (i, &body) in self.bodies.iter().enumerate() {
            let a = accelerations.as_ref().map_or(DVec3::NAN, |all| all[i]);
            let (state, rate) = (&y[component(i)], &mut out[component(i)]);
            for (j, free) in planar::free(&self.model.bodies[body]).into_iter().enumerate() {
                rate[j] = if free { state[POSITIONS + j] } else { 0.0 };
                rate[POSITIONS + j] = a[j];
            }
        }
    }

    fn size2(&self, d: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (d, &body) in planar::in_a_row(d).iter().zip(self.bodies) {
            let i2 = self.model.bodies[body].gyration2;
            let square = |d: &[f64]| d[0] * d[0] + d[1] * d[1] + i2 * d[2] * d[2];
            sum += square(&d[..POSITIONS]) / (self.allowed[0] * self.allowed[0])
                + square(&d[POSITIONS..]) / (self.allowed[1] * self.allowed[1]);
        }
        sum
    }
}

/// Components of a body, by its place.
fn component(place: usize) -> std::ops::Range<usize> {
    place * WIDTH..(place + 1) * WIDTH
}

/// States body by body.
fn states(y: &[f64]) -> Vec<PlanarState> {
    planar::in_a_row(y).to_vec()
}

impl LastingContact {
    /// Bodies in lasting contact from `t` on.
    pub(in crate::dynamics::impact2d) fn new(
        bodies: Vec<usize>,
        modes: Vec<ContactMode>,
        states: &[PlanarState],
        t: f64,
    ) -> Self {
        let y = states.iter().flatten().copied().collect();
        Self { bodies, modes, since: t, from: t, until: t, ending: None, planned: None, y, step: None }
    }

    /// The contact with this length of its first step \[s\], where one is known.
    pub(in crate::dynamics::impact2d) fn with_first_step(self, step: Option<f64>) -> Self {
        Self { step, ..self }
    }

    /// Length of the next step that the tolerance asks for \[s\]; `None` before the first.
    pub(in crate::dynamics::impact2d) fn next_step(&self) -> Option<f64> {
        self.step
    }

    /// Whether all bodies are at rest and stay so: every contact is a face that sticks, one of them on a wall, and all bodies are at rest.
    fn is_at_rest(&self, model: &Model) -> bool {
        self.modes.iter().all(|mode| mode.is_flush() && mode.friction.sticks())
            && self.modes.iter().any(|mode| model.pairs[mode.pair].bodies.contains(&None))
            && planar::in_a_row(&self.y).iter().all(|state| state[POSITIONS..] == [0.0; POSITIONS])
    }

    /// Whether any contact has its mode for want of another: it ends once others agree with Coulomb's law.
    pub(in crate::dynamics::impact2d) fn is_for_want_of_another(&self) -> bool {
        self.modes.iter().any(|mode| mode.friction.is_for_want_of_another())
    }

    /// Plans the next step from `until`, at most to `cap`; no event ends it within `least` \[s\]. `allowed` are the errors of a
    /// place and of a speed that the tolerance allows \[m\], \[m/s\].
    ///
    /// # Errors
    ///
    /// No step is short enough.
    pub(in crate::dynamics::impact2d) fn plan(
        &mut self,
        model: &Model,
        allowed: [f64; 2],
        [least, cap]: [f64; 2],
    ) -> Result<(), Text> {
        let t = self.until;
        self.from = t;
        let piece = model.ground.piece(model.ground.piece_number(t));
        let cap = cap.min(model.latest_end(t, [piece.from, piece.until])).min(t + quarter_period(&model.ground));
        if let Some((slide, bounds)) = self.slide(model, &piece, cap) {
            self.until = cap.min(t + slide.sight);
            self.planned = Some(PlannedMotion::Slide(Box::new(slide), bounds));
        } else {
            let dense =
                if self.is_at_rest(model) { self.rest(cap) } else { self.integrate(model, piece, allowed, cap)? };
            self.until = if dense.from + dense.step >= cap { cap } else { dense.from + dense.step };
            self.planned = Some(PlannedMotion::Step(dense));
        }
        self.find_ending(model, piece, least);
        Ok(())
    }

    /// All bodies at rest until `cap`.
    fn rest(&self, cap: f64) -> DenseOutput {
        let constant =
            self.y.iter().map(|y| [*y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]).collect::<Vec<[f64; DENSE_TERMS]>>();
        DenseOutput::new(self.from, cap - self.from, constant)
    }

    /// Closed form of one face sliding on a wall, and bounds on it.
    fn slide(&self, model: &Model, piece: &LinearPiece, cap: f64) -> Option<(SlidingFace, MotionBounds)> {
        let ([body], [state]) = (&self.bodies[..], &states(&self.y)[..]) else { return None };
        let longest = (cap - self.from).min(model.duration);
        slide_on_wall(model, (*body, &self.modes), piece, (self.from, state), longest)
    }

    fn integrate(
        &mut self,
        model: &Model,
        piece: LinearPiece,
        allowed: [f64; 2],
        cap: f64,
    ) -> Result<DenseOutput, Text> {
        let mut system = ConstrainedOde { model, bodies: &self.bodies, modes: &self.modes, piece, allowed };
        let (t, mut y) = (self.from, self.y.clone());
        let mut method = Dop853::default();
        method.resize(y.len());
        method.start(&mut system, t, &y);
        let mut h = self.step.unwrap_or(FIRST_STEP * (cap - t));
        for _ in 0..REJECTED_STEPS {
            h = if h >= STRETCHED_STEP * (cap - t) { cap - t } else { h };
            let error = method.attempt(&mut system, t, &y, h);
            if error <= 1.0 {
                let dense = method.accept(&mut system, t, &mut y, h);
                self.step = Some(h * next_factor(error));
                return Ok(dense);
            }
            h *= if error.is_finite() { next_factor(error).min(REJECTED_FACTOR) } else { NOT_FINITE_FACTOR };
        }
        Err(Text::new("stop-no-motion"))
    }

    /// State of a body, by its place here, in the planned step.
    pub(in crate::dynamics::impact2d) fn state(&self, place: usize, t: f64) -> PlanarState {
        let mut state = [0.0; WIDTH];
        match &self.planned {
            Some(PlannedMotion::Slide(slide, _)) => state = slide.state(t),
            Some(PlannedMotion::Step(dense)) => dense.read(component(place), t, &mut state),
            None => state.copy_from_slice(&self.y[component(place)]),
        }
        state
    }

    /// Bounds on the motion of a body, by its place here, in the planned step.
    pub(in crate::dynamics::impact2d) fn bounds(&self, place: usize) -> MotionBounds {
        let dense = match &self.planned {
            Some(PlannedMotion::Slide(_, bounds)) => return *bounds,
            Some(PlannedMotion::Step(dense)) => dense,
            None => return MotionBounds::still(f64::INFINITY),
        };
        let start = component(place).start;
        let (translation, rotation) = (start..start + 2, start + 2..start + POSITIONS);
        let at = |i: usize| dense.component(i, dense.from);
        let [speed, acceleration] = dense.derivative_bounds(translation.clone());
        let [spin, spin_rate] = dense.derivative_bounds(rotation.clone());
        MotionBounds {
            window: f64::INFINITY,
            reach: at(start).hypot(at(start + 1)) + dense.displacement_bound(translation),
            turn: at(start + 2).abs() + dense.displacement_bound(rotation),
            speed,
            spin,
            acceleration,
            spin_rate,
        }
    }

    /// Path of a body in the planned step.
    pub(in crate::dynamics::impact2d) fn path(&self, place: usize) -> Option<SegmentMotion> {
        self.planned.as_ref().map(|planned| match planned {
            PlannedMotion::Slide(slide, _) => SegmentMotion::Slide(slide.clone()),
            PlannedMotion::Step(dense) => SegmentMotion::Step(StepPolynomial::of(dense, component(place), None)),
        })
    }

    /// Commits the planned step: its end becomes the next start.
    pub(in crate::dynamics::impact2d) fn commit(&mut self) {
        let t = self.until;
        self.y = (0..self.bodies.len()).flat_map(|place| self.state(place, t)).collect();
        self.planned = None;
    }

    /// Events that can end the contact.
    fn endings(&self) -> Vec<SwitchingFunction> {
        let mut all = Vec::new();
        for (number, mode) in self.modes.iter().enumerate() {
            for (end, &site) in mode.sites.iter().enumerate() {
                // The end without pressure has no reaction that could fall, and those of wedged contacts are not unique.
                let pressed = match mode.friction {
                    FrictionMode::SlipAtEnd { end: pressed, .. } => pressed == end,
                    FrictionMode::Wedged => false,
                    _ => true,
                };
                if pressed {
                    all.push(SwitchingFunction { mode: number, end, ending: Ending::Opens(site) });
                }
                all.push(SwitchingFunction { mode: number, end, ending: Ending::LeavesFace(site) });
            }
            let along: &[Ending] = match mode.friction {
                FrictionMode::Stick => &[Ending::BreaksAway(mode.pair)],
                FrictionMode::Slip(_) => &[Ending::SlipStops(mode.pair)],
                FrictionMode::SlipAtEnd { .. } => &[Ending::SlipStops(mode.pair), Ending::LeavesEnd(mode.pair)],
                FrictionMode::Frictionless | FrictionMode::Wedged => &[],
            };
            all.extend(along.iter().copied().map(|ending| SwitchingFunction { mode: number, end: 0, ending }));
        }
        all
    }

    /// Switching functions at `t`: positive while their event has not happened; none without a solution.
    fn switching_functions(
        &self,
        model: &Model,
        piece: LinearPiece,
        switches: &[SwitchingFunction],
        t: f64,
    ) -> Option<Vec<f64>> {
        let y: Vec<f64> = (0..self.bodies.len()).flat_map(|place| self.state(place, t)).collect();
        let ode = ConstrainedOde { model, bodies: &self.bodies, modes: &self.modes, piece, allowed: [1.0; 2] };
        let (kinematics, motion) = ode.motion(t, &y);
        let reactions = motion?.reactions;
        Some(switches.iter().map(|s| s.value(&self.modes[s.mode], model, &kinematics, &reactions[s.mode])).collect())
    }

    /// One switching function at `t`, 0 without a solution. Where it depends on no reaction, none is solved for.
    fn switching_function(&self, model: &Model, piece: LinearPiece, switch: SwitchingFunction, t: f64) -> f64 {
        if matches!(switch.ending, Ending::Opens(_) | Ending::BreaksAway(_) | Ending::LeavesEnd(_)) {
            return self.switching_functions(model, piece, &[switch], t).map_or(0.0, |values| values[0]);
        }
        let y: Vec<f64> = (0..self.bodies.len()).flat_map(|place| self.state(place, t)).collect();
        let ode = ConstrainedOde { model, bodies: &self.bodies, modes: &self.modes, piece, allowed: [1.0; 2] };
        switch.value(&self.modes[switch.mode], model, &ode.kinematics(t, &y), &Reaction::default())
    }

    /// Ends the planned step at the first zero of a switching function.
    fn find_ending(&mut self, model: &Model, piece: LinearPiece, least: f64) {
        self.ending = None;
        let switches = self.endings();
        let (from, until) = ((self.from + least).min(self.until), self.until);
        let sample = |k: usize| from + (until - from) * k as f64 / SWITCHING_SAMPLES as f64;
        let times: Vec<f64> =
            (0..=SWITCHING_SAMPLES).map(|k| if k == SWITCHING_SAMPLES { until } else { sample(k) }).collect();
        let samples: Option<Vec<Vec<f64>>> =
            times.iter().map(|&t| self.switching_functions(model, piece, &switches, t)).collect();
        let Some(samples) = samples else { return };
        // Falls are rises of the negated function. A start below 0 that returns above it is round-off of the contact mode.
        let mut first = EarliestEvent::UNKNOWN;
        for (i, &switch) in switches.iter().enumerate() {
            let negated: Vec<f64> = samples.iter().map(|at| -at[i]).collect();
            let function = |t: f64| -self.switching_function(model, piece, switch, t);
            if let Some(t) = first_rise([&times, &negated], Resolution::at_start(f64::INFINITY), false, first, function)
                && t < first.at
            {
                (first.at, self.until, self.ending) = (t, t, Some(switch.ending));
            }
        }
    }
}

/// A quarter of the period of a sine of the ground \[s\]: a step over more of it could miss a turning point.
fn quarter_period(ground: &Ground) -> f64 {
    match ground {
        Ground::Sine { omega, .. } if *omega > 0.0 => 0.25 * std::f64::consts::TAU / omega,
        _ => f64::INFINITY,
    }
}

#[cfg(test)]
mod tests;
