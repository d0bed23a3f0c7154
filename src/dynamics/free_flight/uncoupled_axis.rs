//! One direction of a girder that nothing couples to the others: an oscillator, and its steady response to a sine.

use crate::dynamics::free_flight::oscillator::{ForcedResponse, FreeResponse, Oscillator, Phasor};
use crate::dynamics::model::coordinates::planar::{PlanarState, of_parts, part};

/// One direction of a girder without eccentricity.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct UncoupledAxis {
    pub(in crate::dynamics) oscillator: Oscillator,
    pub(in crate::dynamics) free: bool,
    /// Steady response to the sine \[m, rad\].
    pub(in crate::dynamics) steady: Phasor,
    /// Its amplitude \[m, rad\].
    pub(in crate::dynamics) amplitude: f64,
}

/// Factors that carry one direction across a whole interval of a record.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct SampleStep {
    free: FreeResponse,
    forced: ForcedResponse,
}

impl SampleStep {
    /// Of an oscillator, across `dt` \[s\].
    pub(in crate::dynamics) fn of(oscillator: &Oscillator, dt: f64) -> Self {
        let free = oscillator.free(dt);
        let forced = oscillator.forced(dt, &free);
        Self { free, forced }
    }
}

impl UncoupledAxis {
    /// Steady response and its rate by sine and cosine of the ground's phase.
    #[inline]
    pub(in crate::dynamics) fn steady(&self, phase: [f64; 2], drive: f64) -> [f64; 2] {
        self.steady.at(phase, drive)
    }

    /// `(q, v)` after τ under a force `c0 + c1 τ`.
    #[inline]
    pub(in crate::dynamics) fn advance(&self, part: [f64; 2], force: [f64; 2], tau: f64) -> [f64; 2] {
        if self.free { self.oscillator.advance(part, force, tau) } else { part }
    }

    /// Across the interval that `step` is of, under `c0 + c1 τ`.
    pub(in crate::dynamics) fn step(&self, step: &SampleStep, [q, v]: [f64; 2], [c0, c1]: [f64; 2]) -> [f64; 2] {
        if !self.free {
            return [q, v];
        }
        let (f, ForcedResponse { s1, s2 }) = (&step.free, step.forced);
        [q * f.c + v * f.s + c0 * s1 + c1 * s2, -self.oscillator.omega2 * f.s * q + f.s_rate * v + c0 * f.s + c1 * s1]
    }
}

/// State after τ of the three directions of a girder under forces `c0 + c1 τ` per unit mass. Directions with the same oscillator share its
/// factors.
pub(in crate::dynamics) fn advance(
    axes: &[UncoupledAxis; 3],
    state: &PlanarState,
    forces: [[f64; 2]; 3],
    tau: f64,
) -> PlanarState {
    let mut known: Option<(Oscillator, FreeResponse, ForcedResponse)> = None;
    of_parts(std::array::from_fn(|i| {
        let (UncoupledAxis { oscillator, free, .. }, start) = (&axes[i], part(state, i));
        if !free {
            return start;
        }
        if forces[i] == [0.0; 2] {
            return oscillator.advance(start, forces[i], tau);
        }
        let (_, response, forced) = known.filter(|(same, ..)| same == oscillator).unwrap_or_else(|| {
            let response = oscillator.free(tau);
            (*oscillator, response, oscillator.forced(tau, &response))
        });
        known = Some((*oscillator, response, forced));
        oscillator.carry_forced(&response, forced, start, forces[i])
    }))
}
