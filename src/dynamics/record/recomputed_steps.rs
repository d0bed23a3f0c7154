//! Steps of long runs that are stored by their initial states instead of polynomials, and recomputed when read.
//!
//! An explicit step of an island is a function of its initial state, its length and the states of its contacts, which
//! are in their logs; evaluated with equal inputs it is equal to the last bit. A step whose bodies come from flights
//! needs no initial state: it is the end of the flights, and the reference poses are the poses there. The slope at
//! the start of a spatial step is evaluated before quaternions are normalised, and the state before that is stored.

use crate::dynamics::Model;
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::integrator::dense_output::DenseOutput;
use crate::dynamics::integrator::dop853::Dop853;
use crate::dynamics::model::coordinates::planar::{PlanarState, WIDTH};
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::reference_pose::{self, ReferencePose};
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::coupled_system::{CoupledSystem, Members};
use crate::dynamics::penalty3d::equations_of_motion::{EquationsOfMotion, ErrorScale};
use crate::dynamics::penalty3d::island_kind::IslandKind;
use crate::dynamics::penalty3d::stepper::normalise;
use crate::dynamics::penalty3d::workspace::Workspace;
use crate::dynamics::record::contact_log::ContactLog;
use crate::dynamics::trajectory::packed_states::PackedStates;
use crate::dynamics::trajectory::segment_code::NUMBERS;
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;
use crate::dynamics::trajectory::stored_path::{StoredMotion, StoredPath};

/// In place of the number of an initial state: the state is the end of the members' flights.
const FLOWN: u32 = u32::MAX;
/// Bit of [`StepBody::base`] that marks the number of a stored reference pose.
const STORED_BIT: u32 = 1 << 31;

/// Steps of a group of bodies.
#[derive(Clone, Debug, Default)]
pub struct RecomputedSteps {
    sequences: Vec<StepSequence>,
    members: Vec<StepBody>,
    logged_states: Vec<LoggedState>,
    steps: Vec<Step>,
    starts: PackedStates,
}

/// Consecutive steps of one island with the same contact states: indices of the first member and the first contact
/// state.
#[derive(Clone, Copy, Debug)]
struct StepSequence {
    members: u32,
    logged_states: u32,
}

/// A body of a step and its reference pose.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct StepBody {
    /// Number of the body in the model.
    pub body: u32,
    /// Number of the flight that ends at the reference pose, or with [`STORED_BIT`] the number of the stored reference
    /// pose.
    base: u32,
}

impl StepBody {
    /// A body whose reference pose is the end of flight `number`, less than [`STORED_BIT`].
    pub(in crate::dynamics) fn flown(body: u32, number: u32) -> Self {
        Self { body, base: number & !STORED_BIT }
    }

    /// A body whose reference pose is stored under `number`.
    pub(in crate::dynamics) fn kept(body: u32, number: u32) -> Self {
        Self { body, base: number | STORED_BIT }
    }
}

/// A closed contact and the number of its state in its log.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct LoggedState {
    /// Number of the contact's site in the model.
    pub site: u32,
    /// Number of the state in the contact's log.
    pub entry: u32,
}

#[derive(Clone, Copy, Debug)]
struct Step {
    length: f64,
    sequence: u32,
    start: u32,
}

/// Data from which a step is recomputed.
#[derive(Clone, Copy, Debug)]
pub struct Past<'a> {
    /// Constant data of the scene.
    pub model: &'a Model,
    /// Paths of all bodies.
    pub paths: &'a [StoredPath],
    /// Free motions of all bodies; `None` for one without a closed form.
    pub free_motions: &'a [Option<BodyMotion>],
    /// State logs of all contacts.
    pub logs: &'a [ContactLog],
}

fn count(n: usize) -> Option<u32> {
    u32::try_from(n).ok()
}

impl RecomputedSteps {
    /// Begins a sequence of steps; its number, `None` where numbers are exhausted.
    pub(in crate::dynamics) fn open(&mut self, members: Vec<StepBody>, logged_states: Vec<LoggedState>) -> Option<u32> {
        let sequence =
            StepSequence { members: count(self.members.len())?, logged_states: count(self.logged_states.len())? };
        let number = count(self.sequences.len())?;
        self.members.extend(members);
        self.logged_states.extend(logged_states);
        self.sequences.push(sequence);
        Some(number)
    }

    /// Stores a reference pose; its number, `None` where numbers are exhausted.
    pub(in crate::dynamics) fn keep(&mut self, base: &ReferencePose) -> Option<u32> {
        self.starts.push(&base.numbers()).filter(|number| number & STORED_BIT == 0)
    }

    /// Adds a step of `length` \[s\] to a sequence, with its initial state, or `None` where that is the end of the
    /// members' flights; its number, `None` where numbers are exhausted.
    pub(in crate::dynamics) fn push<'a>(
        &mut self,
        sequence: u32,
        length: f64,
        start: Option<impl ExactSizeIterator<Item = &'a [f64]>>,
    ) -> Option<u32> {
        let number = count(self.steps.len()).filter(|n| *n < NUMBERS)?;
        let first = match start {
            None => FLOWN,
            Some(states) => {
                let first = count(self.starts.len() + states.len()).map(|_| self.starts.len())?;
                for state in states {
                    self.starts.push(state)?;
                }
                count(first)?
            }
        };
        self.steps.push(Step { length, sequence, start: first });
        Some(number)
    }

    /// Number of steps.
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    /// Whether there are no steps.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    fn of(&self, sequence: usize) -> (&[StepBody], &[LoggedState]) {
        let StepSequence { members, logged_states } = self.sequences[sequence];
        let next = self.sequences.get(sequence + 1);
        let (to, end) = next
            .map_or((self.members.len(), self.logged_states.len()), |n| (n.members as usize, n.logged_states as usize));
        (&self.members[members as usize..to], &self.logged_states[logged_states as usize..end])
    }

    /// Numbers in the model of the bodies of a step.
    pub fn bodies(&self, number: u32) -> impl Iterator<Item = usize> + '_ {
        self.of(self.steps[number as usize].sequence as usize).0.iter().map(|member| member.body as usize)
    }

    /// Recomputes step `number`, which begins at `from` \[s\]: the dense output of each of its bodies.
    pub fn step(&self, number: u32, from: f64, past: &Past<'_>) -> Vec<StepPolynomial> {
        let RecomputedStep { dense, layout, bases } = self.dense(number, from, past);
        let polynomial = |(place, base)| StepPolynomial::of(&dense, layout.range(place), Some(base));
        bases.iter().enumerate().map(polynomial).collect()
    }

    fn dense(&self, number: u32, from: f64, past: &Past<'_>) -> RecomputedStep {
        let Step { length, sequence, start } = self.steps[number as usize];
        let (members, logged_states) = self.of(sequence as usize);
        let bodies: Vec<usize> = members.iter().map(|member| member.body as usize).collect();
        let layout = StateLayout::of(bodies.iter().map(|&body| &past.model.bodies[body]));
        // Reference pose, and for a body that comes from a flight its state at the end of that flight.
        let pose_and_state = |member: &StepBody| {
            let body = &past.model.bodies[member.body as usize];
            if member.base & STORED_BIT == 0 {
                let mut state = state_at_landing(*member, past);
                return (body.rebase(&mut state), state);
            }
            let mut numbers = vec![0.0; body.placed().size()];
            self.starts.read(member.base & !STORED_BIT, &mut numbers);
            (body.reference(&numbers), [0.0; WIDTH])
        };
        let (bases, landed): (Vec<ReferencePose>, Vec<PlanarState>) = members.iter().map(pose_and_state).unzip();
        let active: Vec<ActiveContact> =
            logged_states.iter().filter_map(|logged| active(*logged, (&bodies, &layout), &bases, past)).collect();
        let mut y = vec![0.0; layout.len()];
        for ((i, place), landed) in (0..).zip(0..).zip(&landed) {
            let state = &mut y[layout.range(place)];
            if start == FLOWN {
                state.copy_from_slice(landed);
            } else {
                self.starts.read(start + i, state);
            }
        }
        let system =
            CoupledSystem::without_rates(Members { bodies, bases, active, links: Vec::new() }, layout, Vec::new());
        let piece = past.model.ground.piece(past.model.ground.piece_number(from));
        let mut equations = EquationsOfMotion {
            model: past.model,
            system: &system,
            kind: &IslandKind::of(past.model, &system, &y),
            piece,
            since: from,
            scale: ErrorScale::default(),
            auxiliary_errors: &[],
            workspace: &mut Workspace::of(&system.active),
        };
        let dense = recompute_step(&mut equations, from, &mut y, length);
        RecomputedStep { dense, layout: system.layout, bases: system.bases }
    }

    /// Memory of the steps \[bytes\].
    pub fn bytes(&self) -> usize {
        self.sequences.len() * size_of::<StepSequence>()
            + self.members.len() * size_of::<StepBody>()
            + self.logged_states.len() * size_of::<LoggedState>()
            + self.steps.len() * size_of::<Step>()
            + self.starts.bytes()
    }

    /// Releases reserved memory.
    pub fn shrink(&mut self) {
        self.sequences.shrink_to_fit();
        self.members.shrink_to_fit();
        self.logged_states.shrink_to_fit();
        self.steps.shrink_to_fit();
        self.starts.shrink();
    }
}

/// A step of the bodies of an island, recomputed.
struct RecomputedStep {
    dense: DenseOutput,
    /// Layout of its components.
    layout: StateLayout,
    /// Reference poses of the bodies.
    bases: Vec<ReferencePose>,
}

/// The explicit step of this length from `y` at `from`.
fn recompute_step(equations: &mut EquationsOfMotion<'_>, from: f64, y: &mut [f64], length: f64) -> DenseOutput {
    let mut rk = Dop853::default();
    rk.resize(y.len());
    rk.start(equations, from, y);
    normalise(equations.model, &equations.system.bodies, &equations.system.layout, y);
    // Its error was accepted when it was computed first.
    let _ = rk.attempt(equations, from, y, length);
    rk.accept(equations, from, y, length)
}

/// State at the end of a body's flight, which is the beginning of the next sequence of its path.
fn state_at_landing(member: StepBody, past: &Past<'_>) -> PlanarState {
    let (body, flown) = (member.body as usize, member.base as usize);
    match (past.paths[body].motion_of(flown), past.paths[body].next(flown), &past.free_motions[body]) {
        ((from, StoredMotion::Start(state)), Some(until), Some(free_motion)) => {
            free_motion.girder_state(from, state, until).unwrap_or(state)
        }
        // Only flights stored by their initial state are referred to, and each is followed by a sequence: another would be no number.
        _ => [f64::NAN; WIDTH],
    }
}

/// The closed contact as it was in the island.
fn active(
    logged: LoggedState,
    (bodies, layout): (&[usize], &StateLayout),
    bases: &[ReferencePose],
    past: &Past<'_>,
) -> Option<ActiveContact> {
    let site = &past.model.sites[logged.site as usize];
    let index = |body: Option<usize>| body.and_then(|body| bodies.iter().position(|&b| b == body));
    let ends = [site.node_body, site.face_body].map(index);
    let sides = ends.map(|i| bases.get(i?));
    let closed = past.logs[logged.site as usize].closed(logged.entry)?;
    let home = reference_pose::seen_from(site, &closed.place, sides);
    let mut active = ActiveContact::new(logged.site as usize, ends, closed, home);
    active.find_sections(past.model, layout);
    Some(active)
}
