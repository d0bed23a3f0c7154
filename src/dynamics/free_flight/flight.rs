//! Free motion of a planar girder in closed form: no steps (`docs/physics.md#free-flight`).
//!
//! Without eccentricity the girder is three [`Oscillator`]s. Under a sine each splits into its steady response and a
//! free part; under a record each advances exactly from sample to sample. Eccentric bearings, undamped resonance
//! and sines far slower than the run go through [`CoupledPropagator`]. Whatever the form, a flight also bounds its own speed and acceleration, so that a search for
//! crossings misses none.

use glam::{DMat3, DVec3};

use crate::dynamics::free_flight::constants::CACHED_SAMPLES;
use crate::dynamics::free_flight::ground_springs::PlanarSprings;
use crate::dynamics::free_flight::matrix_exponential;
use crate::dynamics::free_flight::matrix_exponential::CoupledPropagator;
use crate::dynamics::free_flight::oscillator::Phasor;
use crate::dynamics::free_flight::oscillator::{FreeResponse, Oscillator};
use crate::dynamics::free_flight::uncoupled_axis::{SampleStep, UncoupledAxis, advance};
use crate::dynamics::model::bearing::is_diagonal;
use crate::dynamics::model::body::Body;
use crate::dynamics::model::coordinates::planar::{self, PlanarState, WIDTH};
use crate::motion::{Ground, Line, LinearPiece, Samples};

/// A planar girder's free equation of motion, prepared once.
#[derive(Clone, Debug)]
pub struct FreeMotion {
    pub(in crate::dynamics) form: FreeMotionForm,
    pub(in crate::dynamics) ground: Ground,
    /// `−1` on x and y where the girder is free: the factor of the ground's acceleration.
    driven: DVec3,
    /// Constant push per unit mass.
    pub(in crate::dynamics) push: [f64; 3],
    /// `√‖K/m‖` and `‖C/m‖`, for bounds.
    pub(in crate::dynamics) rates: [f64; 2],
    /// Radius of gyration, which turns θ into a length \[m\].
    pub(in crate::dynamics) gyration: f64,
    /// Its three directions where nothing couples them, whether or not a sine resonates.
    pub(in crate::dynamics) plain: Option<[UncoupledAxis; 3]>,
}

#[derive(Clone, Debug)]
pub(in crate::dynamics) enum FreeMotionForm {
    Split {
        dof: [UncoupledAxis; 3],
        step: Option<Box<[SampleStep; 3]>>,
    },
    /// The second propagator is driven along y, where a record has several components; the first then along x.
    Coupled(Box<CoupledPropagator>, Option<Box<CoupledPropagator>>),
}

/// One stretch of free motion.
#[derive(Clone, Debug)]
pub struct Flight {
    /// Beginning \[s\].
    pub start: f64,
    /// State at its beginning.
    pub state: PlanarState,
    form: FlightForm,
}

#[derive(Clone, Debug)]
enum FlightForm {
    /// Free parts `(q, v)` at the start.
    Split([[f64; 2]; 3]),
    Coupled(matrix_exponential::AugmentedState),
    /// States at every [`CACHED_SAMPLES`]-th kink after the start; `first` is the piece that holds the start.
    Record {
        first: usize,
        anchors: Vec<PlanarState>,
    },
}

impl Flight {
    /// Whether states at samples of a record beyond the start are stored.
    pub(in crate::dynamics) fn has_anchors(&self) -> bool {
        matches!(self.form, FlightForm::Record { .. })
    }

    /// Memory \[bytes\].
    pub fn bytes(&self) -> usize {
        let anchors = if let FlightForm::Record { anchors, .. } = &self.form { anchors.len() } else { 0 };
        size_of::<Self>() + anchors * size_of::<PlanarState>()
    }
}

/// State at a time of a flight.
pub(in crate::dynamics) struct StateInFlight {
    pub state: PlanarState,
    /// The state less the steady response to the ground, where the flight is split into the two.
    pub free: Option<PlanarState>,
}

impl FreeMotion {
    /// Prepares a girder's free motion under a ground motion that lasts `duration` \[s\].
    pub fn new(body: &Body, ground: &Ground, duration: f64) -> Self {
        Self::on_springs(body, &PlanarSprings::NONE, ground, duration)
    }

    /// Free motion on springs to the ground beside the girder's bearings.
    pub fn on_springs(body: &Body, springs: &PlanarSprings, ground: &Ground, duration: f64) -> Self {
        let [stiffness, damping] = springs.with_bearings(body);
        let inverse = DVec3::new(1.0 / body.mass, 1.0 / body.mass, 1.0 / (body.mass * body.gyration2));
        let free = planar::free(body);
        let mask = DVec3::from(free.map(|f| if f { 1.0 } else { 0.0 }));
        let scaled = |m: DMat3| DMat3::from_diagonal(inverse * mask) * m;
        let (k, c) = (scaled(stiffness), scaled(damping));
        let pushed = DVec3::new(body.push.x, body.push.y, body.moment.z) + springs.load;
        let push = (pushed * inverse * mask).to_array();
        let driven = -DVec3::new(1.0, 1.0, 0.0) * mask;
        let several = matches!(ground, Ground::Record { samples: Samples::Components { .. }, .. });
        let axis = if several { DVec3::X } else { ground.axis() };
        let forced = -DVec3::new(axis.x, axis.y, 0.0) * mask;
        let split = split(&stiffness, &damping, k, c, free, (ground, duration), forced);
        let form = split.unwrap_or_else(|| {
            let (drive, amplitude) = match ground {
                Ground::Sine { omega, amplitude, .. } => (*omega, amplitude.length()),
                _ => (0.0, 1.0),
            };
            let propagator = |push: DVec3, forced: DVec3| {
                Box::new(CoupledPropagator::new(k, c, push, forced * amplitude, drive, duration))
            };
            let across = several.then(|| propagator(DVec3::ZERO, -DVec3::Y * mask));
            FreeMotionForm::Coupled(propagator(push.into(), forced), across)
        });
        // In lengths: θ counts by the radius of gyration.
        let length = DVec3::new(1.0, 1.0, body.gyration2.sqrt());
        let symmetric = |m: DMat3| frobenius(DMat3::from_diagonal(length) * m * DMat3::from_diagonal(length.recip()));
        Self {
            form,
            ground: ground.clone(),
            driven,
            push,
            rates: [symmetric(k).sqrt(), symmetric(c)],
            gyration: body.gyration2.sqrt(),
            plain: plain(&stiffness, &damping, k, c, free),
        }
    }

    /// Whether flights under this system have kinks, at which a record changes its slope.
    pub(in crate::dynamics) fn has_kinks(&self) -> bool {
        matches!(self.ground, Ground::Record { .. })
    }

    /// Begins a flight.
    pub fn fly(&self, start: f64, state: PlanarState) -> Flight {
        let form = if self.has_kinks() {
            FlightForm::Record { first: self.ground.piece_number(start), anchors: Vec::new() }
        } else {
            match &self.form {
                FreeMotionForm::Split { dof, .. } => {
                    let steady = self.steady(dof, start);
                    let apart: PlanarState = std::array::from_fn(|i| state[i] - steady[i]);
                    FlightForm::Split([0, 1, 2].map(|i| planar::part(&apart, i)))
                }
                FreeMotionForm::Coupled(..) => FlightForm::Coupled(self.augmented(start, &state)),
            }
        };
        Flight { start, state, form }
    }

    /// Steady response to the sine at `t`.
    pub(in crate::dynamics) fn steady(&self, dof: &[UncoupledAxis; 3], t: f64) -> PlanarState {
        self.steady_in(dof, self.ground.phase(t))
    }

    /// Steady response from the ground's phase.
    fn steady_in(&self, dof: &[UncoupledAxis; 3], [s, c]: [f64; 2]) -> PlanarState {
        let Ground::Sine { omega, .. } = self.ground else { return [0.0; WIDTH] };
        planar::of_parts([0, 1, 2].map(|i| dof[i].steady([s, c], omega)))
    }

    /// One direction of a flight whose free motion and steady response are parted, and its free part at the start.
    pub(in crate::dynamics) fn along(&self, flight: &Flight, i: usize) -> Option<(&UncoupledAxis, [f64; 2])> {
        match (&flight.form, &self.form) {
            (FlightForm::Split(parts), FreeMotionForm::Split { dof, .. }) => Some((&dof[i], parts[i])),
            _ => None,
        }
    }

    fn augmented(&self, t: f64, state: &PlanarState) -> matrix_exponential::AugmentedState {
        let mut z = [0.0; matrix_exponential::SIZE];
        z[..WIDTH].copy_from_slice(state);
        z[matrix_exponential::ONE] = 1.0;
        if let Ground::Sine { omega, phase, .. } = self.ground {
            let (s, c) = (omega * t + phase).sin_cos();
            (z[matrix_exponential::SIN], z[matrix_exponential::SIN + 1]) = (s, c);
        }
        z
    }

    /// State at `t` in `flight`.
    pub fn state(&self, flight: &Flight, t: f64) -> PlanarState {
        let tau = t - flight.start;
        match (&flight.form, &self.form) {
            (FlightForm::Split(parts), FreeMotionForm::Split { dof, .. }) => {
                let (mut out, free) = (self.steady(dof, t), self.free(dof, parts, tau));
                (0..WIDTH).for_each(|i| out[i] += free[i]);
                out
            }
            (FlightForm::Coupled(z), FreeMotionForm::Coupled(system, _)) => first_state(&system.advance(z, tau)),
            (FlightForm::Record { first, anchors }, _) => self.record_state(flight, *first, anchors, t),
            // A flight is begun by its own system.
            _ => flight.state,
        }
    }

    /// The free parts after τ. Directions with the same oscillator share its factors.
    fn free(&self, dof: &[UncoupledAxis; 3], parts: &[[f64; 2]; 3], tau: f64) -> PlanarState {
        let mut out = [[0.0; 2]; planar::POSITIONS];
        let mut known: Option<(Oscillator, FreeResponse)> = None;
        for (i, d) in dof.iter().enumerate() {
            let (part, force) = (parts[i], [self.push[i], 0.0]);
            out[i] = if !d.free || (part == [0.0; 2] && force == [0.0; 2]) {
                part
            } else {
                let factors = known.filter(|(same, _)| *same == d.oscillator).map(|(_, factors)| factors);
                let factors = factors.unwrap_or_else(|| d.oscillator.free(tau));
                known = Some((d.oscillator, factors));
                d.oscillator.carry(&factors, part, force, tau)
            };
        }
        planar::of_parts(out)
    }

    /// State at `t` in `flight`, with its free part.
    pub(in crate::dynamics) fn parts(&self, flight: &Flight, t: f64) -> StateInFlight {
        self.parts_in(flight, t, self.ground.phase(t))
    }

    /// [`parts`](Self::parts) from the ground's phase at `t`.
    pub(in crate::dynamics) fn parts_in(&self, flight: &Flight, t: f64, phase: [f64; 2]) -> StateInFlight {
        if let (FlightForm::Split(parts), FreeMotionForm::Split { dof, .. }) = (&flight.form, &self.form) {
            let (mut out, free) = (self.steady_in(dof, phase), self.free(dof, parts, t - flight.start));
            (0..WIDTH).for_each(|i| out[i] += free[i]);
            return StateInFlight { state: out, free: Some(free) };
        }
        StateInFlight { state: self.state(flight, t), free: None }
    }

    fn record_state(&self, flight: &Flight, first: usize, anchors: &[PlanarState], t: f64) -> PlanarState {
        let target = self.ground.piece_number(t);
        let (mut state, mut number, mut at) = (flight.state, first, flight.start);
        if target > first && !anchors.is_empty() {
            let k = ((target - first - 1) / CACHED_SAMPLES).min(anchors.len() - 1);
            (state, number) = (anchors[k], first + 1 + k * CACHED_SAMPLES);
            at = self.ground.piece_start(number);
        }
        while number < target {
            let piece = self.ground.piece(number);
            state = self.cross(&piece, &state, at);
            (number, at) = (number + 1, piece.until);
        }
        self.within(&self.ground.piece(target), &state, at, t - at)
    }

    /// From `at` in a piece to its end.
    fn cross(&self, piece: &LinearPiece, state: &PlanarState, at: f64) -> PlanarState {
        match &self.form {
            FreeMotionForm::Split { dof, step: Some(steps) } if at == piece.from => {
                let [start, slope] = [piece.start(), piece.rate()].map(|a| self.driven * a);
                planar::of_parts(std::array::from_fn(|i| {
                    let force = [start[i] + self.push[i], slope[i]];
                    dof[i].step(&steps[i], planar::part(state, i), force)
                }))
            }
            _ => self.within(piece, state, at, piece.until - at),
        }
    }

    /// From `at` in a piece on by τ within it.
    fn within(&self, piece: &LinearPiece, state: &PlanarState, at: f64, tau: f64) -> PlanarState {
        match &self.form {
            FreeMotionForm::Split { dof, .. } => {
                let [value, slope] = [piece.acceleration(at), piece.rate()].map(|a| self.driven * a);
                advance(dof, state, std::array::from_fn(|i| [value[i] + self.push[i], slope[i]]), tau)
            }
            FreeMotionForm::Coupled(system, across) => {
                let (along_x, along_y) = lines(piece, at);
                let mut state = driven_by(system, self.augmented(at, state), along_x, tau);
                if let Some(across) = across {
                    let from_y = driven_by(across, [0.0; matrix_exponential::SIZE], along_y, tau);
                    (0..WIDTH).for_each(|i| state[i] += from_y[i]);
                }
                state
            }
        }
    }

    /// Stores the states from which evaluations up to `t` start.
    pub fn remember(&self, flight: &mut Flight, t: f64) {
        let FlightForm::Record { first, anchors } = &mut flight.form else { return };
        let first = *first;
        loop {
            let next = first + 1 + anchors.len() * CACHED_SAMPLES;
            let at = self.ground.piece(next).from;
            if at > t || !at.is_finite() || self.ground.piece(next - 1).until.is_infinite() {
                return;
            }
            let state = self.record_state_at_kink(flight.start, &flight.state, first, anchors, next);
            anchors.push(state);
        }
    }

    fn record_state_at_kink(
        &self,
        start: f64,
        from: &PlanarState,
        first: usize,
        anchors: &[PlanarState],
        next: usize,
    ) -> PlanarState {
        let (mut state, mut number, mut at) = match anchors.last() {
            Some(last) => {
                let number = first + 1 + (anchors.len() - 1) * CACHED_SAMPLES;
                (*last, number, self.ground.piece_start(number))
            }
            None => (*from, first, start),
        };
        while number < next {
            let piece = self.ground.piece(number);
            state = self.cross(&piece, &state, at);
            (number, at) = (number + 1, piece.until);
        }
        state
    }
}

/// Value at `at` and rate of the two lines that drive the propagators: of one direction its own and none, of several
/// components those along x and y.
fn lines(piece: &LinearPiece, at: f64) -> ([f64; 2], [f64; 2]) {
    match piece.line {
        Line::Along { start, slope, .. } => ([start + slope * (at - piece.from), slope], [0.0; 2]),
        Line::Components { slope, .. } => {
            let value = piece.acceleration(at);
            ([value.x, slope.x], [value.y, slope.y])
        }
    }
}

/// State after τ under a line, value and rate, of the ground's acceleration.
fn driven_by(
    system: &CoupledPropagator,
    mut z: matrix_exponential::AugmentedState,
    [value, rate]: [f64; 2],
    tau: f64,
) -> PlanarState {
    (z[matrix_exponential::VALUE], z[matrix_exponential::VALUE + 1]) = (value, rate);
    first_state(&system.advance(&z, tau))
}

fn first_state(z: &matrix_exponential::AugmentedState) -> PlanarState {
    std::array::from_fn(|i| z[i])
}

fn frobenius(m: DMat3) -> f64 {
    m.to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Three oscillators without a steady response, when nothing couples them.
fn plain(stiffness: &DMat3, damping: &DMat3, k: DMat3, c: DMat3, free: [bool; 3]) -> Option<[UncoupledAxis; 3]> {
    let dof = |i: usize| UncoupledAxis {
        oscillator: Oscillator { gamma: c.col(i)[i] / 2.0, omega2: k.col(i)[i] },
        free: free[i],
        steady: Phasor::default(),
        amplitude: 0.0,
    };
    (is_diagonal(stiffness) && is_diagonal(damping)).then(|| std::array::from_fn(dof))
}

/// Three oscillators, when nothing couples them and no sine resonates or is too slow for a steady response.
fn split(
    stiffness: &DMat3,
    damping: &DMat3,
    k: DMat3,
    c: DMat3,
    free: [bool; 3],
    (ground, duration): (&Ground, f64),
    forced: DVec3,
) -> Option<FreeMotionForm> {
    let mut dof = plain(stiffness, damping, k, c, free)?;
    let mut step = None;
    match ground {
        Ground::Still => {}
        Ground::Sine { omega, amplitude, .. } => {
            for (d, f) in dof.iter_mut().zip((forced * amplitude.length()).to_array()) {
                if d.free && f != 0.0 {
                    let Phasor { re, im } = d.oscillator.gain(*omega, duration)?;
                    d.steady = Phasor { re: f * re, im: f * im };
                    d.amplitude = d.steady.re.hypot(d.steady.im);
                }
            }
        }
        Ground::Record { dt, .. } => {
            step = Some(Box::new(dof.map(|d| SampleStep::of(&d.oscillator, *dt))));
        }
    }
    Some(FreeMotionForm::Split { dof, step })
}
