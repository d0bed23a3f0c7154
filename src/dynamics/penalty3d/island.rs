//! Bodies that are integrated together: everyone who touches, until they part.

use crate::contact::{Frame, Mode};
use crate::dynamics::Model;
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::integrator::radau_iia::Radau;
use crate::dynamics::integrator::step_control::{ControllerState, StepController, StepLimits};
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::reference_pose::ReferencePose;
use crate::dynamics::model::wrench::Wrench;
use crate::dynamics::penalty3d::active_contact::{ActiveContact, direction};
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::penalty3d::collinear_island::CollinearIsland;
use crate::dynamics::penalty3d::constants::{FIRST_PHASE, SMALLEST_PHASE};
use crate::dynamics::penalty3d::contact_rates::{fastest, quickest};
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::penalty3d::due::Due;
use crate::dynamics::penalty3d::due::LinkDue;
use crate::dynamics::penalty3d::equations_of_motion::{EquationsOfMotion, ErrorScale, Sliding};
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;
use crate::motion::LinearPiece;

/// Bodies in one integrator, with the step that is planned but not yet committed.
#[derive(Debug)]
pub(in crate::dynamics) struct Island {
    /// Slots of its bodies in the engine, rising.
    pub slots: Vec<usize>,
    /// Their numbers in the model.
    pub(in crate::dynamics) bodies: Vec<usize>,
    /// Where their states stand in `y`.
    pub(in crate::dynamics) layout: StateLayout,
    /// What their states in `y` are counted from.
    pub(in crate::dynamics) bases: Vec<ReferencePose>,
    /// Closed contacts between them.
    pub active: Vec<ActiveContact>,
    /// Numbers of those contacts in the engine.
    pub contacts: Vec<usize>,
    /// Devices whose force acts on them.
    pub links: Vec<ActiveLink>,
    /// Where the planned step begins \[s\].
    pub from: f64,
    /// Where it ends \[s\].
    pub until: f64,
    /// Its number among the stretches whose steps are taken again, once it has one.
    pub stretch: Option<u32>,
    /// Time and stretch of the ground motion that the slope at the start of the next step is of.
    pub(super) sloped: (f64, usize),
    /// Whether the planned step, taken again from its start alone, is the same.
    again: bool,
    /// Where bodies have parts of given length: the states that the slopes at the start of the planned step and of the next one are of, before these were
    /// restored to it.
    pub(super) raw: Vec<f64>,
    pub(super) next_raw: Vec<f64>,
    /// Events of contacts that end the planned step.
    pub due: Vec<Due>,
    /// End of a device's phase that ends it.
    pub link_due: Option<LinkDue>,
    pub(in crate::dynamics) dense: Option<DenseOutput>,
    pub(in crate::dynamics) y: Vec<f64>,
    /// Stretches in the longest of its bodies' paths, with the planned step.
    pub taken: usize,
    pub(super) explicit: bool,
    /// What the error of the planned step was measured against.
    pub(super) measure: ErrorScale,
    pub(in crate::dynamics) stepper: StepController,
    pub(in crate::dynamics) omega: f64,
    /// Rate that none of its contacts' dashpots decays by much faster than \[1/s\].
    pub(in crate::dynamics) quickest: f64,
    /// Rate that they decay by at most all together, once that was asked for \[1/s\].
    pub(in crate::dynamics) decay: Option<f64>,
    /// Largest distance of a corner from G, body by body \[m\].
    pub(in crate::dynamics) radii: Vec<f64>,
    /// How far any corner had come at most since it was placed where the step began, body by body \[m\].
    pub(in crate::dynamics) moved: Vec<f64>,
    /// How far it is from its bases.
    pub(in crate::dynamics) distance: Distance,
    pub(in crate::dynamics) frames: Vec<Frame>,
    wrenches: Vec<Wrench>,
    rates: Vec<f64>,
    pub(in crate::dynamics) angles: Vec<f64>,
    sliding: Sliding,
    line: Option<CollinearIsland>,
    /// Whether its bodies are in that line as it stands.
    in_line: bool,
}

/// How far bodies are from their bases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::dynamics) enum Distance {
    /// What that rounds with is less than what an error may be.
    Near,
    /// So far that it is more: it would be better to count from somewhere nearer.
    Strayed,
}

/// Why a step could not be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::dynamics) struct StepTooSmall {
    /// Its length \[s\].
    pub step: f64,
}

impl Island {
    /// Gathers bodies at `t`, with what their states in `y` are counted from.
    pub(in crate::dynamics) fn new(
        model: &Model,
        slots: Vec<usize>,
        (bodies, bases): (Vec<usize>, Vec<ReferencePose>),
        (contacts, mut links): (Vec<(usize, ActiveContact)>, Vec<ActiveLink>),
        mut y: Vec<f64>,
        t: f64,
        pace: ControllerState,
    ) -> Self {
        let mut active: Vec<ActiveContact> = contacts.iter().map(|(_, a)| *a).collect();
        for a in &mut active {
            if let Some(angle) = a.closed.turning() {
                a.angle = Some(y.len());
                y.push(angle);
            }
        }
        let layout = StateLayout::of(bodies.iter().map(|&b| &model.bodies[b]));
        let states = bodies.iter().zip(layout.states(&y));
        let mut frames = Vec::with_capacity(layout.section_count());
        states.for_each(|(&b, state)| model.bodies[b].push_frames(state, &mut frames));
        for link in &mut links {
            link.find_sections(&layout);
        }
        for a in &mut active {
            a.find_sections(model, &layout);
            a.depth = a.expected_depth(model, &frames);
        }
        // A slip's direction follows its velocity within the stretch of the spring: fast against everything else.
        let turns = active.iter().any(|a| a.angle.is_some());
        let joined = !active.is_empty() || !links.is_empty();
        let pace = ControllerState { stiff: pace.stiff && joined || turns, ..pace };
        let radii: Vec<f64> = bodies.iter().map(|&b| model.bodies[b].radius).collect();
        let mut island = Self {
            omega: fastest(model, &bodies, &active, &links),
            quickest: quickest(model, &active, &links),
            decay: None,
            moved: vec![0.0; radii.len()],
            radii,
            slots,
            bodies,
            layout,
            bases,
            contacts: contacts.into_iter().map(|(c, _)| c).collect(),
            active,
            links,
            from: t,
            until: t,
            due: Vec::new(),
            link_due: None,
            stretch: None,
            sloped: (t, 0),
            again: false,
            raw: Vec::new(),
            next_raw: Vec::new(),
            dense: None,
            taken: 0,
            explicit: false,
            measure: ErrorScale::default(),
            stepper: StepController::new(y.len(), pace),
            y,
            distance: Distance::Near,
            frames: Vec::new(),
            wrenches: Vec::new(),
            rates: Vec::new(),
            angles: Vec::new(),
            sliding: Sliding::default(),
            line: None,
            in_line: false,
        };
        if island.is_free() {
            island.stepper.expect_no_noise();
        }
        island.sliding = Sliding::of(&island.active);
        island.find_line(model);
        island.rewind(model, t);
        island
    }

    /// Evaluates the slope at the start of the next step anew: at a start, and after a kink of the ground motion.
    pub(in crate::dynamics) fn rewind(&mut self, model: &Model, t: f64) {
        self.sloped = (t, model.ground.piece_number(t));
        let piece = model.ground.piece(self.sloped.1);
        let (mut stepper, y) = (std::mem::take(&mut self.stepper), std::mem::take(&mut self.y));
        stepper.start(&mut self.field(model, piece, ErrorScale::default()), t, &y);
        self.note_raw(&y);
        (self.stepper, self.y) = (stepper, y);
    }

    /// Notes what the slope at the start of the next step is of.
    pub(super) fn note_raw(&mut self, y: &[f64]) {
        if self.layout.has_unit_parts() {
            self.next_raw.clear();
            self.next_raw.extend_from_slice(y);
        }
    }

    pub(super) fn field<'a>(
        &'a mut self,
        model: &'a Model,
        piece: LinearPiece,
        scale: ErrorScale,
    ) -> EquationsOfMotion<'a> {
        EquationsOfMotion {
            model,
            bodies: &self.bodies,
            layout: &self.layout,
            bases: &self.bases,
            active: &self.active,
            links: &self.links,
            piece,
            scale,
            angles: &self.angles,
            line: self.line.as_ref(),
            frames: &mut self.frames,
            wrenches: &mut self.wrenches,
            rates: &mut self.rates,
            sliding: &mut self.sliding,
        }
    }

    /// Plans the next step from `from`, at most to `cap`; something is likely to change after `soon` \[s\].
    ///
    /// # Errors
    /// When the step that the tolerance asks for is too small to follow.
    pub(in crate::dynamics) fn plan(&mut self, model: &Model, cap: f64, soon: f64) -> Result<(), StepTooSmall> {
        let t = self.until;
        self.from = t;
        self.taken += 1;
        let scale = self.scale(model);
        self.measure = scale;
        if self.note_faces(model) {
            self.rewind(model, t);
        }
        let number = model.ground.piece_number(t);
        let piece = model.ground.piece(number);
        let known = self.sliding.sliders.is_empty() && self.sloped == (t, number);
        let loose = self.active.iter().any(|active| active.closed.solver.at_face);
        self.explicit = !self.stepper.state().stiff;
        self.again = known && !loose && self.explicit && self.links.is_empty();
        // Contacts of one face push together, faster than the stiffest of them alone. The very first step has only its own
        // estimate to be judged by, which tells little far beyond stability.
        let together = (2.0 / (self.active.len() + self.links.len()).clamp(2, 4) as f64).sqrt();
        let quickest = if self.stepper.state().step > 0.0 { 0.0 } else { self.quickest };
        let first = FIRST_PHASE * together / scale.omega.max(quickest) * (model.tolerance / 1e-10).powf(0.125);
        let longest = self.longest(model);
        let cap = self.drive_cap(model, cap);
        let limits = StepLimits { cap, first, longest, soon, smallest: SMALLEST_PHASE / scale.omega };
        let (mut stepper, mut y) = (std::mem::take(&mut self.stepper), std::mem::take(&mut self.y));
        let outcome = stepper.step(&mut self.field(model, piece, scale), t, &mut y, limits);
        std::mem::swap(&mut self.raw, &mut self.next_raw);
        self.note_raw(&y);
        normalise(model, &self.bodies, &self.layout, &mut y);
        (self.stepper, self.y) = (stepper, y);
        let (dense, end) = outcome.map_err(|step| StepTooSmall { step })?;
        // The slope is asked for at the sum, which may be the end but for its last bit.
        self.sloped = (t + dense.step, number);
        (self.dense, self.until) = (Some(dense), end);
        Ok(())
    }

    /// After everything is counted from elsewhere: the next step begins anew.
    pub(in crate::dynamics) fn counted_anew(&mut self, model: &Model) {
        (self.distance, self.stretch, self.dense) = (Distance::Near, None, None);
        self.find_line(model);
        self.stepper.forget();
        self.rewind(model, self.until);
    }

    /// Whether no force acts between its bodies, or on them from the ground, but those of their bearings.
    pub(in crate::dynamics) fn is_free(&self) -> bool {
        self.active.is_empty() && self.links.is_empty()
    }

    /// Finds the axis along which its bodies move, if they do.
    fn find_line(&mut self, model: &Model) {
        let contacts_alone = self.links.is_empty();
        let line =
            contacts_alone.then(|| CollinearIsland::of(model, &self.bodies, &self.layout, &self.bases, &self.active));
        self.line = line.flatten();
        self.in_line = self.line.as_ref().is_some_and(|line| line.holds(&self.y));
    }

    /// Whether its bodies move along one axis: nothing slides and nothing turns.
    pub(in crate::dynamics) fn is_in_line(&self) -> bool {
        self.in_line
    }

    /// The first of the contacts that are as deep as this one all along.
    pub(in crate::dynamics) fn first_like(&self, contact: usize) -> usize {
        self.line.as_ref().filter(|_| self.in_line).map_or(contact, |line| line.first(contact))
    }

    /// The planned step's answer where its bodies are in line with an axis, where the place of one of them along it and its
    /// rate stand in it, and from where that place is counted \[m\].
    pub(in crate::dynamics) fn along(&self, index: usize, axis: usize) -> Option<(&DenseOutput, [usize; 2], f64)> {
        let line = self.line.as_ref().filter(|line| self.in_line && line.axis() == axis)?;
        let base = self.bases[index].planar()[axis];
        self.dense.as_ref().map(|dense| (dense, line.components(index), base))
    }

    /// A contact's state with its slip direction as it is at `t`.
    pub(in crate::dynamics) fn closed_at(&self, number: usize, t: f64) -> ClosedContact {
        let active = &self.active[number];
        let mut closed = active.closed;
        if let Some(at) = active.angle {
            let mut angle = [self.y[at]];
            if let Some(dense) = &self.dense {
                dense.read(at..at + 1, t, &mut angle);
            }
            closed.mode = Mode::Slip { direction: direction(angle[0]) };
        }
        closed
    }

    /// The planned step's continuous answer for one body.
    pub(in crate::dynamics) fn path(&self, index: usize) -> Option<StepPolynomial> {
        let (part, base) = (self.layout.range(index), Some(&self.bases[index]));
        self.dense.as_ref().map(|dense| StepPolynomial::of(dense, part, base))
    }

    /// Length of the planned step and its bodies' initial states from their bases, where these alone may be kept.
    pub(in crate::dynamics) fn again(&self, model: &Model) -> Option<(f64, Vec<f64>)> {
        let dense = self.dense.as_ref().filter(|dense| self.again && dense.from == self.from)?;
        let mut start = dense.coefficients().iter().map(|c| c[0]);
        if !self.layout.has_unit_parts() {
            return Some((dense.step, start.collect()));
        }
        // What has its length already may get another by its last bit.
        let mut normal = self.raw.clone();
        normalise(model, &self.bodies, &self.layout, &mut normal);
        let same = normal.iter().all(|x| start.next().is_some_and(|y| x.to_bits() == y.to_bits()));
        same.then(|| (dense.step, self.raw.clone()))
    }

    /// The planned step's continuous answer for the slip angle of one of its contacts.
    pub(in crate::dynamics) fn angle_path(&self, number: usize) -> Option<DenseOutput> {
        let at = self.active[number].angle?;
        self.dense.as_ref().map(|dense| dense.slice(at..at + 1))
    }

    /// How its integrator would go on.
    pub(in crate::dynamics) fn pace(&self) -> ControllerState {
        self.stepper.state()
    }

    /// Takes over the memory of an integrator that is no longer in use.
    pub(in crate::dynamics) fn borrow(&mut self, spare: Option<Box<Radau>>) {
        self.stepper.borrow(spare);
    }

    /// Gives its own away at its end.
    pub(in crate::dynamics) fn give_back(&mut self) -> Option<Box<Radau>> {
        self.stepper.give_back()
    }

    /// Fastest circular frequency of its contacts and bearings \[rad/s\].
    pub(in crate::dynamics) fn omega(&self) -> f64 {
        self.omega
    }
}

/// Restores the parts of given length of states in a row.
pub(in crate::dynamics) fn normalise(model: &Model, bodies: &[usize], layout: &StateLayout, y: &mut [f64]) {
    if layout.has_unit_parts() {
        (bodies.iter().enumerate()).for_each(|(i, &body)| model.bodies[body].normalise(&mut y[layout.range(i)]));
    }
}

#[cfg(test)]
mod tests;
