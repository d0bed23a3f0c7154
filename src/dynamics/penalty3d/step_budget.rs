//! What an island's next step may err by, and how long it may be.

use smallvec::SmallVec;

use crate::contact::{Frame, Local, Mode, NormalLaw};
use crate::dynamics::integrator::constants::{RESOLVED_CHANGE, RESOLVED_DECAY, RESOLVED_RELAXATION};
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::penalty3d::constants::{
    EXPLICIT_ROUNDING, FINEST_TOLERANCE_FREE, GROUND_PHASE_CONTACT, GROUND_PHASE_FREE, IMPLICIT_ROUNDING,
    LEAST_ACCELERATION, LONG_RUN_CONTACT, LONG_RUN_FREE, REST_SPEED, REVERSAL_SPEED, ROUNDING_FLOOR,
    ROUNDING_FLOOR_TURNING, SIZE_ROUNDING_SHARE, SLOPE_PHASE,
};
use crate::dynamics::penalty3d::contact_rates::mobility;
use crate::dynamics::penalty3d::coupled_system::CoupledSystem;
use crate::dynamics::penalty3d::equations_of_motion::ErrorScale;
use crate::dynamics::penalty3d::island_kind::IslandKind;
use crate::dynamics::{Body, Model};
use crate::motion::Ground;
use crate::scene::FINEST_TOLERANCE;

/// Bodies and connections of an island at the start of its next step.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct StepStart<'a> {
    /// Constant data of the scene.
    pub model: &'a Model,
    /// Bodies and the connections that act on them.
    pub system: &'a CoupledSystem,
    /// Kind of the island that they form.
    pub kind: &'a IslandKind,
    /// State, relative to the reference poses.
    pub y: &'a [f64],
    /// Its slope.
    pub slope: &'a [f64],
    /// Method and length of the step.
    pub pace: ControllerState,
    /// Number of segments in the longest path of the bodies, with this step.
    pub steps_taken: usize,
}

/// What an island's next step may err by, and how long it may be.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct StepBudget {
    /// Error scale.
    pub scale: ErrorScale,
    /// Length up to which the error estimate can judge the step \[s\].
    pub longest: f64,
    /// Bound of the displacement of a corner since placed at the start of the step, per body \[m\].
    pub moved: Vec<f64>,
    /// Allowed errors of the auxiliary states, in their order: slip angles \[rad\], memories of devices (units of the device).
    pub auxiliary_errors: Vec<f64>,
    /// Poses of all sections at the start of the step, relative to the reference poses.
    frames: Vec<Frame>,
}

impl StepBudget {
    /// Before the first step of an island of so many bodies, as placed.
    pub(in crate::dynamics) fn none_yet(bodies: usize) -> Self {
        Self { moved: vec![0.0; bodies], ..Self::default() }
    }

    /// Length to which round-off of a contact's positions is proportional \[m\]: displacement of both sides since
    /// placed, at least [`SIZE_ROUNDING_SHARE`] of their size.
    pub(in crate::dynamics) fn reach(&self, model: &Model, active: &ActiveContact) -> f64 {
        let moved: f64 = active.ends.into_iter().flatten().map(|body| self.moved[body]).sum();
        moved.max(SIZE_ROUNDING_SHARE * model.sites[active.site].reach())
    }
}

/// Bounds on the length of a step beside the error estimate.
#[derive(Clone, Copy, Debug)]
struct StepLengthBounds {
    /// Fastest relaxation of a device's memory \[1/s\].
    relaxation: f64,
    /// Least [`smooth_within`](crate::dynamics::connection::Device::smooth_within) of the devices \[m/s\].
    smooth_within: f64,
    /// Least time to the opening of a contact whose force is no power series there, of those whose forces change a speed by more than the
    /// allowed error until then \[s\].
    opening: f64,
}

/// Part of an island's error scale by its bodies.
#[derive(Default)]
struct BodyScale {
    /// Square of the largest speed, rotation included \[m²/s²\].
    speed2: f64,
    /// Largest distance of a point from its reference pose \[m\].
    size: f64,
    /// Speed whose relative rounding is that of the positions and velocities of the corners \[m/s\].
    roundoff: f64,
    /// Largest acceleration by what the bearings leave of the weight, and by constant pushes \[m/s²\].
    weight: f64,
    pushed: f64,
    /// Largest acceleration, of bodies without contact \[m/s²\].
    acceleration: f64,
}

/// Part of an island's error scale by its closed contacts.
struct ContactScale {
    /// Square of the largest speed `√((ω g)² + ġ²)` of a normal or tangential spring \[m²/s²\].
    speed2: f64,
    /// Of contacts that open under a law that is no power series there: [`opening`].
    openings: SmallVec<[[f64; 2]; 4]>,
    /// Stretch of each contact whose slip angle is a state \[m\].
    stretches: SmallVec<[f64; 4]>,
}

/// Part of an island's error scale by its acting devices.
struct DeviceScale {
    /// Square of the largest speed of a device's points against each other \[m²/s²\].
    speed2: f64,
    /// Displacement that changes the force as much as a unit of the memory does, of each memory that is a state \[m per its unit\].
    memories: SmallVec<[f64; 8]>,
    relaxation: f64,
    smooth_within: f64,
}

impl StepStart<'_> {
    /// Budget of the step, in the memory of the one before. Its error scale is the tolerance times the largest speed
    /// `√((ω g)² + ġ²)` of normal and tangential springs, or, without contact, times the largest speed of a body; at least round-off.
    /// The speed of sliding bodies does not enter, since the force of a pressed contact is as exact as its penetration.
    pub(in crate::dynamics) fn budget(&self, memory: StepBudget) -> StepBudget {
        let (model, mut budget) = (self.model, memory);
        let free = self.system.is_free(model);
        let bodies = self.bodies_scale(&mut budget, free);
        let omega = if free { self.system.omega.max(largest_spin(&budget.frames)) } else { self.system.omega };
        let contacts = self.contacts_scale(&budget.frames, omega);
        let devices = self.devices_scale(&budget.frames, omega);
        let speed2 = if free { bodies.speed2 } else { 0.0 }.max(contacts.speed2).max(devices.speed2);
        // From rest: speed acceleration in one radian from ground motion, weight and constant push.
        let rest = (model.ground.peak() + bodies.weight + bodies.pushed + LEAST_ACCELERATION) / omega;
        let largest = speed2.sqrt().max(REST_SPEED * rest).max(REVERSAL_SPEED * bodies.acceleration / omega);
        // Round-off of a step: that of the displacement of a corner times the frequency, plus that of the speed of
        // the corner.
        let rounding = if self.pace.stiff { IMPLICIT_ROUNDING } else { EXPLICIT_ROUNDING };
        let speed = self.step_tolerance(free) * largest + rounding * (bodies.roundoff + rest);
        budget.auxiliary_errors.clear();
        // Error of a slip angle as displacement of the anchor: stretch times angle.
        let angle = |stretch: &f64| (speed / (omega * stretch)).min(model.tolerance.sqrt());
        budget.auxiliary_errors.extend(contacts.stretches.iter().map(angle));
        budget.auxiliary_errors.extend(devices.memories.iter().map(|length| speed / (omega * length)));
        let felt = contacts.openings.iter().filter(|[_, impulse]| *impulse > speed).map(|[time, _]| *time);
        let opening = felt.fold(f64::INFINITY, f64::min);
        let DeviceScale { relaxation, smooth_within, .. } = devices;
        budget.scale = ErrorScale { speed, omega, size: bodies.size };
        budget.longest = self.longest(&budget.frames, StepLengthBounds { relaxation, smooth_within, opening });
        budget
    }

    /// Tolerance of the next step \[–\]: that of the scene, less in a long run.
    fn step_tolerance(&self, free: bool) -> f64 {
        let tolerance = self.model.tolerance;
        let (long_run, finest) =
            if free { (LONG_RUN_FREE, FINEST_TOLERANCE_FREE) } else { (LONG_RUN_CONTACT, FINEST_TOLERANCE) };
        let demanded = tolerance * (long_run / self.steps_taken as f64).min(1.0);
        demanded.max(tolerance.min(finest))
    }

    /// Poses of all sections at the start of the step and the displacement of each body since it was placed in the budget, and what
    /// the bodies add to the error scale.
    fn bodies_scale(&self, budget: &mut StepBudget, free: bool) -> BodyScale {
        let turns = self.system.active.iter().any(|active| active.angle.is_some());
        let floor = if turns { ROUNDING_FLOOR_TURNING } else { ROUNDING_FLOOR };
        let mut scale = BodyScale::default();
        let StepBudget { frames, moved, .. } = budget;
        frames.clear();
        moved.clear();
        for (i, &b) in self.system.bodies.iter().enumerate() {
            let (body, radius) = (&self.model.bodies[b], self.system.radii[i]);
            body.push_frames(&self.y[self.system.layout.range(i)], frames);
            let here = &frames[self.system.layout.sections(i).start];
            let spin = here.spin.length() * body.gyration2.sqrt();
            scale.speed2 = scale.speed2.max(here.velocity.length_squared() + spin * spin);
            scale.size = scale.size.max(here.shift.length() + radius);
            let since = here.moved(radius);
            let in_all = self.system.bases[i].pose().moved(radius) + since;
            moved.push(in_all);
            let known = since.max(floor * in_all);
            // Round-off of a position acts through the frequency of the connections, however fast the body rotates.
            scale.roundoff = scale.roundoff.max(self.system.omega * known + here.speed(radius));
            scale.pushed = scale.pushed.max((body.push.length() + turning_push(body)) / body.mass);
            if body.free[2] {
                scale.weight = scale.weight.max(body.unbalanced.force.abs() / body.mass);
            }
            if free {
                scale.acceleration = scale.acceleration.max(self.acceleration(i));
            }
        }
        scale
    }

    /// [`ContactScale`] at these poses.
    fn contacts_scale(&self, frames: &[Frame], omega: f64) -> ContactScale {
        let mut scale = ContactScale { speed2: 0.0, openings: SmallVec::new(), stretches: SmallVec::new() };
        for number in self.kind.distinct(self.system.active.len()) {
            let active = &self.system.active[number];
            let here = active.look(self.model, frames);
            scale.speed2 = scale.speed2.max((omega * here.gap).powi(2) + here.gap_rate.powi(2));
            if let Mode::Stick { anchor } = active.closed.mode {
                let stretch2 = (omega * (here.way - anchor)).length_squared();
                scale.speed2 = scale.speed2.max(stretch2 + here.rate.length_squared());
            }
            scale.openings.extend(opening(self.model, active, &here));
            if active.angle.is_some() {
                // Stretch at the largest depth of the remaining touch: towards its end the direction acts on a
                // vanishing force.
                let inwards = (-here.gap_rate).max(0.0);
                scale.stretches.push(active.closed.law.slip_scale(here.gap.abs() + inwards / omega));
            }
        }
        scale
    }

    /// [`DeviceScale`] at these poses.
    fn devices_scale(&self, frames: &[Frame], omega: f64) -> DeviceScale {
        let mut scale =
            DeviceScale { speed2: 0.0, memories: SmallVec::new(), relaxation: 0.0, smooth_within: f64::INFINITY };
        let model = self.model;
        for link in self.system.acting(model) {
            let (motion, _) = link.motion(model, &self.system.bases, frames);
            let device = &link.link(model).device;
            let phase = link.phase_in(self.y);
            let [_, rate] = device.gap(&phase, &motion);
            // A device gives its bodies no more speed than by the energy that it has stored, however far its points have gone, and
            // swings them no faster than by its own stiffness, however fast the contacts beside it are.
            let stiffness = device.stiffness_bound(&phase);
            let mobility = link.mobility(model).min(omega * omega / stiffness);
            let stored = device.stored_energy(&phase, &motion).max(0.0);
            scale.speed2 = scale.speed2.max(2.0 * stored * mobility + rate * rate);
            if link.evolving.is_some() {
                let evolution = device.evolution(&phase, &motion);
                scale.memories.push(evolution.force.length() / stiffness);
                scale.relaxation = scale.relaxation.max(-evolution.decay);
            }
            scale.smooth_within = scale.smooth_within.min(device.smooth_within(&phase, &motion));
        }
        scale
    }

    /// Acceleration of a body at the start of the next step, rotation included by its radius of gyration \[m/s²\].
    fn acceleration(&self, index: usize) -> f64 {
        let slope = &self.slope[self.system.layout.range(index)];
        let [_, squared] = self.model.bodies[self.system.bodies[index]].size2(slope);
        squared.sqrt()
    }

    /// Latest end of the step from `from` under a sine \[s\]: an implicit one within [`GROUND_PHASE_CONTACT`], since a stiff
    /// contact follows the ground quasi-statically, which the error estimate does not show, and one without contact within
    /// [`GROUND_PHASE_FREE`].
    pub(in crate::dynamics) fn drive_cap(&self, from: f64, cap: f64) -> f64 {
        let Ground::Sine { omega, .. } = self.model.ground else { return cap };
        if self.system.is_free(self.model) {
            cap.min(from + GROUND_PHASE_FREE / omega)
        } else if self.pace.stiff {
            cap.min(from + GROUND_PHASE_CONTACT / omega)
        } else {
            cap
        }
    }

    /// Longest step within these bounds \[s\]: no longer than its error estimate can judge.
    fn longest(&self, frames: &[Frame], bounds: StepLengthBounds) -> f64 {
        let explicit = if self.pace.stiff {
            f64::INFINITY
        } else {
            self.decay_time().min(RESOLVED_RELAXATION / bounds.relaxation)
        };
        let explicit = explicit.min(RESOLVED_CHANGE * bounds.opening);
        if bounds.smooth_within < f64::INFINITY { explicit.min(self.smooth_time(frames)) } else { explicit }
    }

    /// Time within which relative velocities change by [`RESOLVED_CHANGE`] of what the series of devices' forces converge up to, with
    /// constant acceleration \[s\].
    fn smooth_time(&self, frames: &[Frame]) -> f64 {
        let model = self.model;
        let dt = SLOPE_PHASE / self.system.omega;
        let later = self.frames_after(dt);
        let time = |link: &ActiveLink| {
            let [now, then] = [frames, &later].map(|frames| link.motion(model, &self.system.bases, frames).0);
            let within = link.link(model).device.smooth_within(&link.phase_in(self.y), &now);
            RESOLVED_CHANGE * within * dt / (then.rate - now.rate).length()
        };
        self.system.acting(model).map(time).fold(f64::INFINITY, f64::min)
    }

    /// Time of [`RESOLVED_DECAY`] time constants of the dashpots \[s\]; infinite where the last step was far below it.
    fn decay_time(&self) -> f64 {
        let pace = self.pace;
        // A sum of the largest single rates bounds the decay rate; the sharper bound is computed only near the limit.
        let sum = self.system.modal.decay + self.system.largest_decay_rate * self.system.connection_count() as f64;
        if pace.step > 0.0 && pace.step * sum < RESOLVED_DECAY {
            return f64::INFINITY;
        }
        let decay = self.system.decay_bound(self.model);
        if decay > 0.0 { RESOLVED_DECAY / decay } else { f64::INFINITY }
    }

    /// Poses of the sections of the bodies relative to their reference poses, `dt` after the start of the step, with constant
    /// acceleration.
    pub(in crate::dynamics) fn frames_after(&self, dt: f64) -> Vec<Frame> {
        let mut moved: Vec<f64> = self.y.iter().zip(self.slope).map(|(y, rate)| y + dt * rate).collect();
        let mut frames = Vec::with_capacity(self.system.layout.section_count());
        for (index, &body) in self.system.bodies.iter().enumerate() {
            let (part, body) = (self.system.layout.range(index), &self.model.bodies[body]);
            body.add_accelerations(&mut moved[part.clone()], &self.slope[part.clone()], dt);
            body.push_frames(&moved[part], &mut frames);
        }
        frames
    }
}

/// Largest angular speed of a body \[rad/s\]. A body that rotates without contact and bearings has no other frequency, and
/// an error of its attitude is one of its position a radian later.
fn largest_spin(frames: &[Frame]) -> f64 {
    frames.iter().map(|frame| frame.spin.length()).fold(0.0, f64::max)
}

/// Time `δ/V_n` to the opening \[s\] and change of a speed by the contact's force until then \[m/s\], of a contact that opens under a law whose
/// force is no power series in δ at δ = 0, as `δ^{3/2}`; `None` of others. Its series in time converges up to the opening alone, so that the
/// error estimate holds for shorter steps only.
fn opening(model: &Model, active: &ActiveContact, here: &Local) -> Option<[f64; 2]> {
    let normal = &active.closed.law.normal;
    if normal.is_power_series() || here.gap >= 0.0 || here.gap_rate <= 0.0 {
        return None;
    }
    let time = -here.gap / here.gap_rate;
    let force = normal.elastic(-here.gap) + normal.damping_coefficient(-here.gap) * here.gap_rate;
    Some([time, mobility(model, active) * force * time])
}

/// Bound of the force at the radii of gyration that given moments amount to \[N\].
fn turning_push(body: &Body) -> f64 {
    let inertia = &body.inertia;
    let gyration2 = [inertia.x_axis.x / body.mass, inertia.y_axis.y / body.mass, body.gyration2];
    body.moment.to_array().into_iter().zip(gyration2).map(|(moment, i2)| moment.abs() / i2.sqrt()).sum()
}

#[cfg(test)]
mod tests;
